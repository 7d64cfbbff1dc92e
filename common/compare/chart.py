"""The chart of compare.py, made to be projected: large type, and no line known by its colour alone."""

import matplotlib
import pandas
from cycler import cycler
from matplotlib.figure import Figure
from matplotlib.ticker import EngFormatter, FuncFormatter, LogLocator

from points import digits, ratio

SMOOTH = 1000 / 60  # ms, the longest frame of a display that shows 60 a second

# Okabe and Ito's colours, which the colour-blind can tell apart, each with a marker; then dashed.
LINES = cycler(linestyle=["-", "--", ":"]) * (
    cycler(color="#D55E00 #E69F00 #009E73 #56B4E9 #0072B2 #CC79A7 #000000".split())
    + cycler(marker=list("os^DvPX")))
# A stage has the same colour and the same position in the order in every chart and legend.
STAGE_COLOURS = {
    "update": "#77AADD", "upload": "#EEDD88", "accumulate": "#EE8866", "settle": "#FFAABB",
    "melt": "#99DDFF", "depth": "#DDDDDD", "smooth": "#E8E8B0", "shadow": "#AAAAAA",
    "scene": "#BBCC33", "sky": "#D6ECFA", "arrows": "#C8A27A", "sort": "#8FD0B0",
    "draw": "#44BB99", "bloom": "#E0A0A0", "tone": "#D0B0E8"}
LEGEND = {"frameon": False, "fontsize": 13, "handlelength": 2.6, "loc": "upper center"}


def draw_chart(file, experiment, lines, machine):
    """Writes the chart as PNG. `lines` is {line: {x: Point}}; `machine` says what was measured."""
    matplotlib.rcParams.update({"font.size": 17, "axes.spines.top": False, "axes.spines.right": False,
                                "axes.titlelocation": "left", "axes.titlesize": 19,
                                "axes.prop_cycle": LINES})
    panels = {"times": [draw_times, draw_stages], "lines": [draw_times], "stages": [draw_stages],
              "bars": [draw_bars], "features": [draw_features, draw_stages]}[experiment.chart]
    if not any(point.stages for points in lines.values() for point in points.values()):
        panels = panels[:1]
    figure = Figure(figsize=(16, 9), constrained_layout={"w_pad": 0.15, "h_pad": 0.1})
    axes = figure.subplots(1, len(panels), squeeze=False)
    figure.suptitle(experiment.title, fontsize=28, fontweight="bold", x=0.01, ha="left")
    figure.supxlabel(machine, fontsize=14, color="#444444", x=0.01, ha="left")
    for draw, panel in zip(panels, axes[0]):
        draw(panel, experiment, lines)
    figure.savefig(file, format="png", dpi=120)


def draw_times(axes, experiment, lines):
    """Time against x, both logarithmic: median with a whisker up to the 95th percentile."""
    for name, points in lines.items():
        medians = [point.median for point in points.values()]
        whiskers = [max(0, point.p95 - point.median) for point in points.values()]
        axes.errorbar(points.keys(), medians, yerr=[[0] * len(medians), whiskers], label=name,
                      linewidth=3, markersize=11, elinewidth=1.2, capsize=4)
    reference, curve = experiment.reference
    if curve:
        axes.plot(*zip(*curve), label=reference, color="#888888", marker=".", linestyle=":")
    what = f"{experiment.measured} time"
    axes.set_title(f"{what.capitalize()}: median to 95th percentile")
    axes.set(xscale="log", yscale="log", xlabel=experiment.x_label, ylabel=f"{what} (ms)")
    if experiment.measured == "frame":
        axes.axhline(SMOOTH, color="#555555", linewidth=1.5, linestyle="--")
        low, high = axes.get_ylim()
        axes.set_ylim(low, max(high, 1.7 * SMOOTH))  # the words have room below the title
        axes.annotate("16.7 ms = 60 fps", (1, SMOOTH), xycoords=axes.get_yaxis_transform(),
                      xytext=(0, 4), textcoords="offset points", ha="right", fontsize=14)
    axes.set_xticks(sorted({x for points in (*lines.values(), dict(curve)) for x in points}))
    axes.xaxis.set_major_formatter(EngFormatter(sep=""))  # 10k, 1M
    axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5), numticks=20))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda ms, _: digits(ms)))
    axes.minorticks_off()
    axes.grid(True, color="#DDDDDD")
    axes.legend(bbox_to_anchor=(0.5, -0.12), ncol=2, **LEGEND)


def bars(axes, times, colours, xlabel):
    """A bar for each of {name: ms}, from top to bottom, with its number."""
    drawn = axes.barh(range(len(times)), times.values(), height=0.6, color=colours)
    axes.bar_label(drawn, [f"{time:.2f}" for time in times.values()], padding=8, fontsize=14)
    axes.set_yticks(range(len(times)), times.keys())
    axes.set(xlabel=xlabel, xmargin=0.25, ylim=(len(times) - 0.4, -0.6))


def draw_bars(axes, _experiment, lines):
    """For each line a bar for the whole frame and one for its stage draw."""
    times = {}
    for name, points in lines.items():
        point = points[max(points)]
        times[f"{name}:\nwhole frame"] = point.median
        times[f"{name}:\ndrawing alone"] = point.busiest.get("draw", 0)
    bars(axes, times, ["#56B4E9", "#CCCCCC"] * len(lines), "median (ms)")


def draw_features(axes, experiment, lines):
    """What each feature costs: how much longer a frame is with it, with the 96 % interval."""
    x, whole = max(lines[experiment.baseline].items())
    ratios = {name.replace("without ", ""): ratio(points[x], whole) for name, points in lines.items()
              if x in points and name != experiment.baseline}
    ratios = dict(sorted(ratios.items(), key=lambda item: item[1].middle))
    bars(axes, {name: whole.median * (1 - less.middle) for name, less in ratios.items()},
         ["#56B4E9" if less.is_sure else "#CCCCCC" for less in ratios.values()],
         "time saved (ms), with its 96 % interval; grey: cannot tell from 0")
    limits = axes.get_xlim()  # of the bars: few repeats make wide intervals
    axes.hlines([row + 0.3 for row in range(len(ratios))], color="black", linewidth=1,
                xmin=[whole.median * (1 - min(less.high, 10)) for less in ratios.values()],
                xmax=[whole.median * (1 - less.low) for less in ratios.values()])
    axes.set_xlim(limits)
    axes.set_title(f"What a frame of {whole.median:.1f} ms saves without it")


def draw_stages(axes, experiment, lines):
    """Each bar all stages of a frame, as fractions of the time that they take together."""
    if experiment.chart == "features":
        lines = {experiment.baseline: lines[experiment.baseline]}
    x = max(set.intersection(*map(set, lines.values())))
    times = pandas.DataFrame({
        name + f", {clock.upper()}" * (clock != "finish"): stages
        for name, points in lines.items() for clock, stages in points[x].stages.items()}).T.fillna(0)
    shares = 100 * times.div(times.sum(axis=1), axis=0)
    left = 0
    for stage in sorted(shares, key=list(STAGE_COLOURS).index):
        drawn = axes.barh(range(len(shares)), shares[stage], left=left, label=stage,
                          color=STAGE_COLOURS[stage], height=min(0.75, 0.25 * len(shares)))
        axes.bar_label(drawn, [f"{share:.0f} %" if share > 8 else "" for share in shares[stage]],
                       label_type="center", fontsize=14)  # where it has room
        left = left + shares[stage]
    for row, total in enumerate(times.sum(axis=1)):
        axes.text(101, row, f"{digits(total)} ms", va="center", fontsize=14)
    axes.set_title(f"Stages of a frame at {x:,} {experiment.x_label}")
    axes.set_yticks(range(len(shares)), shares.index)
    axes.set(xlabel="fraction of the stages' time (%)", xlim=(0, 100), ylim=(len(shares) - 0.4, -0.6))
    axes.legend(bbox_to_anchor=(0.4, -0.12), ncol=4, **LEGEND)
