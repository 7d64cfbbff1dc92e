"""The chart of compare.py: frame times against flakes, and the stages of a frame beside them.

Made to be projected: 1920 x 1080, large type, and no line or stage known by its colour alone.
"""

import math
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator  # noqa: E402

SMOOTH = 1000 / 60  # ms, the longest frame of a display that shows 60 a second

# Okabe and Ito's colours, which the colour-blind can tell apart; each line has a marker of its own
# as well.
LINE_COLOURS = "#D55E00 #E69F00 #009E73 #56B4E9 #0072B2 #CC79A7 #000000".split()
LINE_STYLES = ("-", "--", ":", "-.")
MARKERS = "os^DvPX"
# A stage has the same colour in every chart, light enough for black text. What cannot be told
# apart by colour is by place: the legend has the order of the bars.
STAGE_COLOURS = {
    "update": "#77AADD", "upload": "#EEDD88", "settle": "#FFAABB", "melt": "#99DDFF",
    "depth": "#DDDDDD", "shadow": "#AAAAAA", "sky": "#D6ECFA", "scene": "#BBCC33",
    "lamp": "#EE8866", "arrows": "#C8A27A", "draw": "#44BB99", "smooth": "#E8E8B0",
    "halo": "#F4C7A0", "sort": "#8FD0B0", "bloom": "#E0A0A0", "tone": "#D0B0E8"}
LEGEND = {"frameon": False, "fontsize": 13, "handlelength": 1.6, "columnspacing": 1.0}
OTHER_STAGE_COLOURS = ("#F4C7A0", "#AAAA00", "#8FD0B0", "#E0A0A0", "#B0B8F0")


def draw_chart(file, experiment, lines, machine):
    """Writes the chart as PNG. `lines` is {line: {x: Point}}; `machine` says what was measured."""
    pyplot.rcParams.update({"font.size": 17, "axes.spines.top": False, "axes.spines.right": False,
                            "axes.titlelocation": "left", "axes.titlesize": 19})
    panels = {"times": [draw_frame_times], "parts": [draw_parts], "stages": [],
              "lines": [draw_frame_times]}[experiment.chart]
    if experiment.chart != "lines" and any(point.stages for points in lines.values() for point in points.values()):
        panels.append(draw_stages)
    figure, axes = pyplot.subplots(1, len(panels) or 1, squeeze=False, figsize=(16, 9),
                                   constrained_layout={"w_pad": 0.15, "h_pad": 0.1})
    figure.suptitle(experiment.title, fontsize=28, fontweight="bold", x=0.01, ha="left")
    figure.supxlabel(machine, fontsize=14, color="#444444", x=0.01, ha="left")
    for draw, panel in zip(panels, axes[0]):
        draw(panel, experiment, lines)
    figure.savefig(file, format="png", dpi=120)
    pyplot.close(figure)


def draw_frame_times(axes, experiment, lines):
    """Frame time against x, both logarithmic: median with a whisker up to the 95th percentile."""
    styles_used = defaultdict(int)
    for number, (name, points) in enumerate(lines.items()):
        xs = sorted(points)
        medians = [points[x].median for x in xs]
        whiskers = [max(0, points[x].p95 - points[x].median) for x in xs]
        if not experiment.source:  # a step keeps its colour, whatever it is compared with
            number = int(points[xs[0]].run.step[4:6]) - 1
        colour = LINE_COLOURS[number % len(LINE_COLOURS)]
        style = LINE_STYLES[styles_used[colour] % len(LINE_STYLES)]
        styles_used[colour] += 1
        axes.errorbar(xs, medians, yerr=[[0] * len(xs), whiskers], label=name, color=colour,
                      linestyle=style, marker=MARKERS[number % len(MARKERS)], linewidth=3,
                      markersize=11, elinewidth=1.2, capsize=4)
    reference, curve = experiment.reference
    if curve:
        axes.plot(*zip(*curve), label=reference, color="#888888", linewidth=2, marker=".",
                  linestyle=(0, (1, 1)))
    what = experiment.measured
    axes.set_title(f"{what[0].upper()}{what[1:]}: median, and up to the 95th percentile")
    axes.set(xscale="log", yscale="log", xlabel=experiment.x_label, ylabel=f"{what} (ms)")
    if what == "frame time":
        axes.axhline(SMOOTH, color="#555555", linewidth=1.5, linestyle=(0, (6, 3)))
        axes.annotate("16.7 ms\n= 60 fps", (1, SMOOTH), xycoords=axes.get_yaxis_transform(),
                      xytext=(6, 0), textcoords="offset points", va="center", fontsize=14)
    label_ticks(axes.xaxis, {x for points in lines.values() for x in points}.union(
        x for x, _ in curve))
    low, high = axes.get_ylim()
    label_ticks(axes.yaxis, [digit * 10.0 ** power for power in range(-4, 7)
                             for digit in ((1, 2, 5) if high / low < 300 else (1,))
                             if low <= digit * 10.0 ** power <= high])
    axes.grid(True, color="#DDDDDD")
    axes.set_axisbelow(True)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncol=2, **LEGEND)


def label_ticks(axis, values):
    """Marks these values on a logarithmic axis, less those that would stand too close."""
    values = sorted(values)
    kept = values[:1]
    for value in values:
        if math.log(value / kept[-1]) > 0.13 * math.log(values[-1] / values[0]):
            kept.append(value)
    axis.set_major_locator(FixedLocator(kept))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(lambda value, _: short(value)))


def short(value):
    """10000 as 10k, 1500000 as 1.5M."""
    for size, suffix in ((1e6, "M"), (1e3, "k")):
        if value >= size:
            return f"{value / size:.4g}{suffix}"
    return f"{value:.4g}"


def draw_parts(axes, experiment, lines):
    """What each part costs: how much longer a frame is than without it, with the repeats' range."""
    whole = lines.get(experiment.baseline, {})
    x = max(whole, default=0)
    points = {name: points[x] for name, points in lines.items()
              if x in points and name != experiment.baseline}
    names = sorted(points, key=lambda name: points[name].median)
    for row, name in enumerate(names):
        cost = whole[x].median - points[name].median
        low, high = whole[x].low - points[name].high, whole[x].high - points[name].low
        axes.barh(row, cost, height=0.6, color="#56B4E9" if low > 0 or high < 0 else "#CCCCCC")
        axes.plot((low, high), (row, row), color="black", marker="|", markersize=10)
        axes.annotate(f"{cost:.2f}", (max(high, 0), row), xytext=(8, 0), va="center", fontsize=14,
                      textcoords="offset points", annotation_clip=False)
    axes.axvline(0, color="black", linewidth=1)
    if names:
        axes.set_title(f"What a frame of {whole[x].median:.1f} ms saves without it")
    axes.set(xlabel="time saved (ms); grey: within the repeats", ylim=(len(names) - 0.4, -0.6))
    axes.set_yticks(range(len(names)), [name.replace("without ", "") for name in names])
    axes.tick_params(axis="y", length=0)


def draw_stages(axes, experiment, lines):
    """Each bar all stages of a frame, as parts of the time that they take together."""
    if experiment.chart == "parts" and experiment.baseline in lines:
        lines = {experiment.baseline: lines[experiment.baseline]}
    x = max(set.intersection(*(set(points) for points in lines.values())), default=0)
    bars = {}
    for name, points in lines.items():
        for clock, times in points[x].stages.items() if x in points else ():
            bars[name + ("" if clock == "finish" else f", {clock.upper()}")] = times
    colours, spare, keys = dict(STAGE_COLOURS), list(OTHER_STAGE_COLOURS), {}
    for row, times in enumerate(bars.values()):
        total, left = sum(times.values()), 0
        for stage, time in times.items():
            part = 100 * time / (total or 1)
            if stage not in colours:
                colours[stage] = spare[(len(colours) - len(STAGE_COLOURS)) % len(spare)]
            if part > 0.4:  # it can be seen
                keys[stage] = axes.barh(row, part, left=left, color=colours[stage],
                                        edgecolor="white", height=min(0.75, 0.25 * len(bars)))
            if part > 8:  # its number has room
                axes.text(left + part / 2, row, f"{part:.0f} %", ha="center", va="center",
                          fontsize=14)
            left += part
        axes.text(101, row, f"{total:.3g} ms", va="center", fontsize=14)
    axes.set_title(f"Stages of a frame at {x:,} {experiment.x_label}")
    axes.set(xlabel="part of the stages' time (%)", xlim=(0, 100), ylim=(len(bars) - 0.4, -0.6))
    axes.set_yticks(range(len(bars)), bars)
    axes.tick_params(axis="y", length=0)
    order = dict.fromkeys(stage for times in reversed(bars.values()) for stage in times
                          if stage in keys)
    axes.legend([keys[stage] for stage in order], order, loc="upper center", ncol=4,
                bbox_to_anchor=(0.4, -0.12), **LEGEND)
