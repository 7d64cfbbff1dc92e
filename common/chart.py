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
    "update": "#77AADD", "upload": "#EEDD88", "collide": "#EE8866", "accumulate": "#FFAABB",
    "settle": "#FFAABB", "melt": "#99DDFF", "shadow": "#AAAAAA", "sky": "#D6ECFA",
    "scene": "#BBCC33", "arrows": "#C8A27A", "draw": "#44BB99", "splash": "#D0B0E8"}
OTHER_STAGE_COLOURS = ("#F4C7A0", "#AAAA00", "#DDDDDD", "#8FD0B0", "#E0A0A0", "#B0B8F0")



def draw_chart(path, experiment, lines, machine):
    """Writes the chart as PNG. `lines` is {line: {x: Point}}; `machine` says what was measured."""
    pyplot.rcParams.update({"font.size": 17, "axes.spines.top": False, "axes.spines.right": False,
                            "axes.titlelocation": "left", "axes.titlesize": 19})
    x, bars = stage_bars(lines)
    panels = 1 if experiment.stages_only or not bars else 2
    figure, axes = pyplot.subplots(1, panels, squeeze=False, figsize=(16, 9),
                                   constrained_layout={"w_pad": 0.15, "h_pad": 0.1})
    figure.suptitle(experiment.title, fontsize=28, fontweight="bold", x=0.01, ha="left")
    figure.supxlabel(machine, fontsize=14, color="#444444", x=0.01, ha="left")
    if not experiment.stages_only:
        draw_frame_times(axes[0, 0], experiment, lines)
    if bars:
        axes[0, -1].set_title(f"Stages of a frame at {x:,} {experiment.x_label}")
        draw_stages(axes[0, -1], bars)
    figure.savefig(path, dpi=120)
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
    axes.set_title("Frame time: median, and up to the 95th percentile")
    axes.set(xscale="log", yscale="log", xlabel=experiment.x_label, ylabel="frame time (ms)")
    axes.axhline(SMOOTH, color="#555555", linewidth=1.5, linestyle=(0, (6, 3)))
    axes.annotate("16.7 ms\n= 60 fps", (1, SMOOTH), xycoords=axes.get_yaxis_transform(),
                  xytext=(6, 0), textcoords="offset points", va="center", fontsize=14)
    label_ticks(axes.xaxis, {x for points in lines.values() for x in points}
                | {x for x, _ in curve})
    low, high = axes.get_ylim()
    label_ticks(axes.yaxis, [digit * 10.0 ** power for power in range(-4, 7)
                             for digit in ((1, 2, 5) if high / low < 300 else (1,))
                             if low <= digit * 10.0 ** power <= high])
    axes.grid(True, color="#DDDDDD")
    axes.set_axisbelow(True)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncol=2, frameon=False)


def label_ticks(axis, values):
    """Marks these values on a logarithmic axis, less those that would stand too close."""
    values = sorted(values)
    kept = values[:1]
    for value in values:
        if math.log(value / kept[-1]) > 0.15 * math.log(values[-1] / values[0]):
            kept.append(value)
    axis.set_major_locator(FixedLocator(kept))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.10g}"))


def stage_bars(lines):
    """The largest x that all lines reach, and [(label, {stage: ms})] there."""
    x = max(set.intersection(*(set(points) for points in lines.values())), default=0)
    bars = []
    for name, points in lines.items():
        clocks = defaultdict(dict)
        for (stage, clock), time in points[x].stages.items() if x in points else ():
            clocks[clock][stage] = time
        for clock, times in clocks.items():
            bars.append((name + ("" if clock == "finish" else f", {clock.upper()}"), times))
    return x, bars


def draw_stages(axes, bars):
    """Each bar all stages of a frame, as parts of the time they take together."""
    spare = iter(OTHER_STAGE_COLOURS * 9)
    colours, keys = dict(STAGE_COLOURS), {}
    for row, (_, times) in enumerate(bars):
        total, left = sum(times.values()), 0
        for stage, time in times.items():
            part = 100 * time / (total or 1)
            if part > 0.4:  # it can be seen
                colour = colours.get(stage) or colours.setdefault(stage, next(spare))
                keys[stage] = axes.barh(row, part, left=left, color=colour, height=0.75,
                                        edgecolor="white")
            if part > 8:  # its number has room
                axes.text(left + part / 2, row, f"{part:.0f} %", ha="center", va="center",
                          fontsize=14)
            left += part
        axes.text(101, row, f"{total:.3g} ms", va="center", fontsize=14)
    axes.set(xlabel="part of the stages' time (%)", xlim=(0, 100), ylim=(len(bars) - 0.4, -0.6))
    axes.set_yticks(range(len(bars)), [label for label, _ in bars])
    axes.tick_params(axis="y", length=0)
    order = [stage for _, times in reversed(bars) for stage in times if stage in keys]
    axes.legend([keys[stage] for stage in dict.fromkeys(order)], dict.fromkeys(order),
                loc="upper center", bbox_to_anchor=(0.4, -0.12), ncol=4, frameon=False)
