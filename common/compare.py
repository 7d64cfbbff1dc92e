#!/usr/bin/env python3
"""Runs the six programs against each other and writes their frame times as a table and a chart.

    common/compare.py                                      all six, at 1,000 to 100,000 flakes
    common/compare.py --steps 1,2,4 --counts 10000,1000000
    common/compare.py --steps 2 --variants 2:orphan,2:persistent
    common/compare.py --experiment point-size              one of --list

Writes three files into --out, named compare or after the experiment:

  .csv   one row for each run and stage: median and 95th percentile of the frames of that run, ms.
         Stage "frame" is the whole frame, from swap to swap (clock "swap"). A stage's clock is
         "cpu", "gpu", or "finish" where both were timed together, between calls of glFinish in
         frames of their own (software renderers). "line" and "x" are its place on the chart.
  .md    what was measured on which machine, and the table, over all repeats
  .png   the chart: frame time against flakes, and below it the stages at the most flakes

Repeats are interleaved: everything runs once, then everything again, so that a machine that slows
down as it warms up slows all alike. A program that fails or hangs is reported and the rest go on;
Ctrl-C ends the measuring, and what was measured is written.

Exit status: 0 if anything was measured (what failed is listed), 1 if nothing was or the files
cannot be written, 2 for a wrong command line, 130 after Ctrl-C.
"""

import argparse
import csv
import datetime
import io
import math
import os
import platform
import re
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path

sys.dont_write_bytecode = True  # the source folder stays as it is
from experiments import EXPERIMENTS, FRAMES, STEADY, Experiment, Run  # noqa: E402

try:
    from tqdm import tqdm
except ImportError:
    tqdm = None

ROOT = Path(__file__).resolve().parent.parent
STEPS = {int(folder.name[4:6]): folder.name for folder in sorted(ROOT.glob("step[0-9][0-9]_*"))}
COLUMNS = "step,variant,particles,width,height,renderer,frame,frame_ms,timing".split(",")
STAGE = re.compile(r"(\w+)_(cpu|gpu)_ms").fullmatch
REMEDY = "build with common/run.sh, or: cmake -B build && cmake --build build"
SMOOTH = 1000 / 60  # ms, the longest frame of a display that shows 60 a second


class Failed(Exception):
    """A run that gave nothing to compare; says why."""


@dataclass
class Measured:
    """What one run measured."""

    run: Run
    repeat: int
    variant: str
    size: str
    renderer: str
    frames: list                                # ms, swap to swap, one a frame
    stages: dict = field(default_factory=dict)  # (stage, clock) -> ms, one a frame


@dataclass
class Point:
    """What all repeats of one run have in common: a point on the chart, a row of the table."""

    run: Run
    variant: str
    median: float  # ms, of all frames of all repeats
    p95: float     # ms, likewise
    low: float     # ms, the least median of a repeat
    high: float    # ms, the greatest
    stages: dict   # (stage, clock) -> median ms


def percentile_95(times):
    return sorted(times)[math.ceil(0.95 * len(times)) - 1]


def is_software(renderer):
    names = ("llvmpipe", "softpipe", "swrast", "swr", "software", "gdi generic", "basic render")
    return any(name in renderer.lower() for name in names)


# ---- Measuring.

def read_frames(path):
    """The rows of a program's --csv as (renderer, variant, size, frame times, stages)."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = csv.DictReader(file, strict=True)
            names = rows.fieldnames or []
            if names[:len(COLUMNS)] != COLUMNS or not all(map(STAGE, names[len(COLUMNS):])):
                raise Failed("malformed CSV: its first line is not " + ",".join(COLUMNS)
                             + " and then STAGE_cpu_ms,STAGE_gpu_ms for each stage")
            frames, stages = [], {"query": defaultdict(list), "finish": defaultdict(list)}
            for row in rows:
                if None in row or None in row.values():
                    raise ValueError(f"there should be {len(names)} columns")
                found = stages[row["timing"]]
                if row["timing"] == "query":  # a synchronised frame takes longer than it need
                    frames.append(milliseconds(row["frame_ms"]))
                for name in names[len(COLUMNS):]:
                    if row[name]:
                        found[name].append(milliseconds(row[name]))
    except (ValueError, KeyError, csv.Error) as error:
        raise Failed(f"malformed CSV, line {rows.line_num}: {error}") from error
    except OSError as error:
        raise Failed(f"no CSV: {error.strerror}") from error
    if not frames or not min(frames):
        raise Failed("its CSV holds no frame times")
    size = f"{row['width']}x{row['height']}"
    split = split_stages(stages, len(frames), is_software(row["renderer"]))
    return row["renderer"], row["variant"], size, frames, split


def milliseconds(text):
    value = float(text)
    if not 0 <= value < math.inf:
        raise ValueError(f"{text} is no time")
    return value


def split_stages(stages, count, software):
    """{(stage, clock): times} from {timing: {"STAGE_cpu_ms": times}}."""
    if software and not stages["finish"]:
        return {}  # such a renderer's queries mislead
    split = {}
    for name, times in (stages["finish"] or stages["query"]).items():
        stage, clock = STAGE(name).groups()
        if not stages["finish"]:
            split[stage, clock] = times
        elif clock == "gpu":  # from one glFinish to the next, the CPU's part of it included
            # That pass is part of the warm-up: its last frames are most like those that count.
            split[stage, "finish"] = times[-count:]
    return split


def measure(run, repeat, size, settings):
    """Starts a program once and returns what it measured; raises Failed if it did not."""
    program = shutil.which(run.step, path=str(settings.build))
    if not program:
        raise Failed(f"{settings.build} holds no such program: {REMEDY}")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "frames.csv"
        command = [program, "--benchmark", "--csv", str(path), "--particles", str(run.particles),
                   "--size", size, "--frames", str(settings.frames),
                   "--warmup", str(settings.warmup), *run.options]
        if run.variant:
            command += ["--variant", run.variant]
        try:
            result = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True,
                                    text=True, errors="replace", timeout=settings.timeout,
                                    check=False)
        except subprocess.TimeoutExpired as error:
            raise Failed(f"stopped after {settings.timeout:g} s (--timeout)") from error
        except OSError as error:
            raise Failed(f"cannot be started: {error.strerror}") from error
        if result.returncode:
            said = result.stderr.strip().splitlines()
            raise Failed(said[0] if said else ended_by(result.returncode))
        renderer, variant, actual_size, frames, stages = read_frames(path)
    return Measured(run, repeat, variant, actual_size, renderer, frames, stages)


def ended_by(status):
    if status >= 0:
        return f"exit status {status}, without a word"
    try:
        return f"killed by {signal.Signals(-status).name}"
    except ValueError:
        return f"killed by signal {-status}"


def name_of(run):
    """A run in a few words, for messages."""
    words = f"{run.step} {run.variant} {options_text(run)} at {run.particles:,} flakes"
    return " ".join(words.split())


def options_text(run):
    """A run's own options; of a scene only the file's name, for the file is gone by then."""
    return " ".join(os.path.basename(option) for option in run.options)


def measure_all(runs, experiment, settings):
    """All that could be measured, what went wrong as [text], and whether Ctrl-C ended it early."""
    todo = [(repeat, run) for repeat in range(settings.repeats) for run in runs]
    results, notes, failed = [], [], set()
    bar = tqdm(total=len(todo), unit="run", dynamic_ncols=True) if tqdm else None
    interrupted = False
    try:
        for number, (repeat, run) in enumerate(todo, 1):
            if bar is not None:
                bar.set_description(f"{run.line} {run.x:,}")
            else:
                print(f"run {number} of {len(todo)}: {run.line} {run.x:,}", file=sys.stderr)
            if run not in failed:  # what failed once is not tried again
                try:
                    size = run.size or settings.size or experiment.size
                    result = measure(run, repeat, size, settings)
                    results.append(result)
                    problem = shortfall(result, size, settings)
                except Failed as error:
                    failed.add(run)
                    problem = f"failed: {error}"
                if problem:
                    notes.append(f"{name_of(run)} {problem}")
                    (bar.write if bar is not None else print)(notes[-1], file=sys.stderr)
            if bar is not None:
                bar.update()
    except KeyboardInterrupt:
        interrupted = True
        notes.append(f"ended by Ctrl-C after {len(results)} of {len(todo)} runs")
    if bar is not None:
        bar.close()
    return results, list(dict.fromkeys(notes)), interrupted


def shortfall(result, size, settings):
    """What a run that succeeded did otherwise than it was told, or nothing."""
    if len(result.frames) < settings.frames:
        return f"was cut short: {len(result.frames)} of {settings.frames} frames"
    if result.size != size:
        return f"had a window of {result.size} instead of {size}"
    return ""


def gather(results):
    """{line: {x: Point}} over all repeats."""
    groups = defaultdict(list)
    for result in results:
        groups[result.run].append(result)
    lines = {}
    for run, repeats in groups.items():
        frames = [time for result in repeats for time in result.frames]
        stages = defaultdict(list)
        for result in repeats:
            for key, times in result.stages.items():
                stages[key] += times
        medians = [statistics.median(result.frames) for result in repeats]
        lines.setdefault(run.line, {})[run.x] = Point(
            run, repeats[0].variant, statistics.median(frames), percentile_95(frames),
            min(medians), max(medians),
            {key: statistics.median(times) for key, times in stages.items()})
    return lines


# ---- Writing.

def write_whole(path, data):
    """Writes `data` to `path`, or leaves what is there as it is."""
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with open(handle, "wb") as file:
            file.write(data)
        os.chmod(temporary, 0o644)  # mkstemp lets nobody else read
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def csv_bytes(experiment, results):
    """The tidy table, see the top of this file."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow("experiment,line,x,step,variant,options,particles,width,height,renderer,repeat,"
                    "stage,clock,frames,median_ms,p95_ms".split(","))
    for result in results:
        run = result.run
        for (stage, clock), times in {("frame", "swap"): result.frames, **result.stages}.items():
            writer.writerow([experiment.name, run.line, run.x, run.step, result.variant,
                             options_text(run), run.particles, *result.size.split("x"),
                             result.renderer, result.repeat, stage, clock, len(times),
                             f"{statistics.median(times):.4f}", f"{percentile_95(times):.4f}"])
    return text.getvalue().encode()


def processor():
    try:
        linux = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        linux = ""
    model = re.search(r"model name\s*: (.*)", linux)
    name = model[1] if model else platform.processor() or platform.machine()
    return f"{name}, {os.cpu_count()} cores"


def stages_text(point):
    """A point's stages in a few words, one group for each clock."""
    clocks = defaultdict(list)
    for (stage, clock), time in point.stages.items():
        clocks[clock].append(f"{stage} {time:.2f}")
    names = {"cpu": "CPU: ", "gpu": "GPU: ", "finish": ""}
    return "; ".join(names[clock] + ", ".join(parts) for clock, parts in clocks.items())


def report(experiment, lines, results, notes, settings, chart):
    """The whole .md as text."""
    is_comparison = not experiment.source
    renderers = list(dict.fromkeys(result.renderer for result in results))
    sizes = list(dict.fromkeys(result.size for result in results))
    synchronised = any(clock == "finish" for result in results for _, clock in result.stages)
    text = [f"# {experiment.title}", ""]
    for renderer in renderers:
        text.append(f"- Renderer: {renderer}" + (
            ". **This is software rendering:** no graphics card took part, and these times say "
            "nothing about one." if is_software(renderer) else ""))
    text += [f"- Processor: {processor()}, {platform.system()}",
             f"- Window: {', '.join(sizes)} pixels, vsync off",
             f"- Measured: {settings.frames} frames a run after {settings.warmup} of warm-up, "
             f"repeats: {settings.repeats}, interleaved; "
             f"{datetime.date.today():%d %B %Y}"]
    density = min(1, (settings.warmup + settings.frames / 2) / STEADY)
    if density < 1:
        text.append(f"- The snowfall was still building up: {100 * density:.0f} % of the flakes "
                    f"had been released (all are after {STEADY} frames).")
    text += [f"- Not as planned: {note}" for note in notes]
    if not is_comparison:
        text += ["", f"**The source:** {experiment.source}", "", conclusion(experiment, lines)]
    if chart:
        text += ["", f"![{experiment.title}]({experiment.name}.png)"]
    step_1 = {x: point.median for points in lines.values() for x, point in points.items()
              if point.run.step == STEPS[1] and not point.run.variant}
    text += ["", f"| step | variant | {experiment.x_label} | median, ms | p95, ms | fps | repeats |"
             + (" against step 1 |" if is_comparison else "") + " stages, ms |",
             "|---|---|--:|--:|--:|--:|--:|" + ("--:|" if is_comparison else "") + "---|"]
    for points in lines.values():
        for x, point in sorted(points.items()):
            row = [point.run.step, point.variant, f"{x:,}", f"{point.median:.2f}",
                   f"{point.p95:.2f}", f"{1000 / point.median:,.0f}",
                   f"±{50 * (point.high - point.low) / point.median:.0f} %"
                   if settings.repeats > 1 else ""]
            if is_comparison:
                row.append(f"{point.median / step_1[x]:.2f}" if step_1.get(x) else "")
            text.append("| " + " | ".join(row + [stages_text(point)]) + " |")
    text += ["", "Frame times run from swap to swap; median and 95th percentile are those of all "
             "frames of all repeats. *Repeats*: half of what lies between the least and the "
             "greatest median of a repeat; smaller differences mean nothing."
             + (" *Against step 1*: the frame time divided by that of step 1 with as many flakes; "
                "less than 1 is faster." if is_comparison else "")
             + (" Stages were timed between calls of glFinish in frames of their own, which lets "
                "nothing overlap: they show where the time goes, and may add up to more than a "
                "frame. What they leave of it is clearing and showing the window."
                if synchronised else
                " CPU and GPU work at the same time, so their stages do not add up to a frame."),
             ""]
    return "\n".join(text)


def conclusion(experiment, lines):
    """What was found here, as one sentence."""
    try:
        found = experiment.found(lines)
    except LookupError:
        found = "too little was measured to say"
    return f"**Here:** {found[0].upper()}{found[1:]}."


# ---- Drawing.

# Okabe and Ito's colours, which the colour-blind can tell apart; each line has a marker of its own
# as well. The stages have Tol's "light" colours, on which black text can be read.
LINE_COLOURS = "#D55E00 #E69F00 #009E73 #56B4E9 #0072B2 #CC79A7 #000000".split()
LINE_STYLES = ("-", "--", ":", "-.")
MARKERS = "os^DvPX"
STAGE_COLOURS = {"update": "#77AADD", "upload": "#EEDD88", "collide": "#EE8866",
                 "accumulate": "#FFAABB", "scene": "#BBCC33", "draw": "#44BB99"}
OTHER_STAGE_COLOURS = ("#99DDFF", "#AAAA00", "#DDDDDD", "#D0B0E8", "#C8A27A", "#F4C7A0")


def draw_chart(experiment, lines, machine):
    """The chart as the bytes of a PNG. Raises ImportError without matplotlib."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    pyplot.rcParams.update({"font.size": 15, "axes.spines.top": False, "axes.spines.right": False})
    x, bars = stage_bars(lines)
    if experiment.stages_only:
        machine += f", {x:,} {experiment.x_label}"
    heights = ([] if experiment.stages_only else [6.2]) + ([1.2 + 0.45 * len(bars)] if bars else [])
    figure, panels = pyplot.subplots(len(heights) or 1, 1, squeeze=False, constrained_layout=True,
                                     figsize=(13.3, sum(heights) + 1.4),
                                     gridspec_kw={"height_ratios": heights or [1]})
    panels[0, 0].set_title(experiment.title, fontsize=22, fontweight="bold", loc="left", pad=48)
    panels[0, 0].annotate(machine, (0, 1), xycoords="axes fraction", xytext=(0, 8),
                          textcoords="offset points", va="bottom", fontsize=13, color="#444444")
    if not experiment.stages_only:
        draw_frame_times(panels[0, 0], experiment, lines)
    if bars:
        draw_stages(panels[-1, 0], bars, as_shares=experiment.stages_only)
    if bars and not experiment.stages_only:
        panels[-1, 0].set_title(f"Stages of a frame at {x:,} {experiment.x_label}", fontsize=16,
                                loc="left")
    png = io.BytesIO()
    figure.savefig(png, format="png", dpi=110, bbox_inches="tight", pad_inches=0.25)
    pyplot.close(figure)
    return png.getvalue()


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
                      linestyle=style, marker=MARKERS[number % len(MARKERS)], linewidth=2.5,
                      markersize=9, elinewidth=1.2, capsize=4)
    reference, curve = experiment.reference
    if curve:
        axes.plot(*zip(*curve), label=reference, color="#888888", linewidth=2, marker=".",
                  linestyle=(0, (1, 1)))
    axes.set(xscale="log", yscale="log", xlabel=experiment.x_label, ylabel="frame time (ms)")
    axes.axhline(SMOOTH, color="#555555", linewidth=1.5, linestyle=(0, (6, 3)))
    axes.annotate("16.7 ms\n= 60 fps", (1, SMOOTH), xycoords=axes.get_yaxis_transform(),
                  xytext=(8, 0), textcoords="offset points", va="center", fontsize=13)
    label_ticks(axes.xaxis, {x for points in lines.values() for x in points}
                | {x for x, _ in curve})
    low, high = axes.get_ylim()
    label_ticks(axes.yaxis, [digit * 10.0 ** power for power in range(-4, 7)
                             for digit in ((1, 2, 5) if high / low < 300 else (1,))
                             if low <= digit * 10.0 ** power <= high])
    axes.grid(True, which="major", color="#DDDDDD")
    axes.set_axisbelow(True)
    axes.legend(loc="upper left", bbox_to_anchor=(1.13, 1), frameon=False)


def label_ticks(axis, values):
    """Marks these values on a logarithmic axis, less those that would stand too close."""
    from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

    values = sorted(values)
    kept = values[:1]
    for value in values:
        if math.log(value / kept[-1]) > 0.12 * math.log(values[-1] / values[0]):
            kept.append(value)
    axis.set_major_locator(FixedLocator(kept))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.10g}"))


def stage_bars(lines):
    """The largest x that all lines reach, and [(label, frame ms, {stage: ms})] there."""
    common = set.intersection(*(set(points) for points in lines.values()))
    bars = []
    for name, points in lines.items():
        clocks = defaultdict(dict)
        for (stage, clock), time in points[max(common)].stages.items() if common else ():
            clocks[clock][stage] = time
        for clock, times in clocks.items():
            suffix = "" if clock == "finish" else f", {clock.upper()}"
            bars.append((name + suffix, points[max(common)].median, times))
    return max(common, default=0), bars


def draw_stages(axes, bars, as_shares):
    """Each bar a frame, divided into its stages: ms, or parts of their sum in per cent."""
    spare = iter(OTHER_STAGE_COLOURS * 3)
    colours = dict(STAGE_COLOURS)
    widest = 100 if as_shares else max(max(sum(times.values()), frame) for _, frame, times in bars)
    for row, (_, frame, times) in enumerate(bars):
        scale = 100 / (sum(times.values()) or 1) if as_shares else 1
        left = 0
        for stage, time in times.items():
            if stage not in colours:
                colours[stage] = next(spare)
            width = time * scale
            axes.barh(row, width, left=left, color=colours[stage], height=0.75, edgecolor="white")
            if width > 0.06 * widest:
                axes.text(left + width / 2, row, f"{width:.0f} %" if as_shares else f"{width:.3g}",
                          ha="center", va="center", fontsize=13)
            left += width
        if not as_shares:
            mark, = axes.plot(frame, row, marker="|", markersize=26, markeredgewidth=3,
                              color="black", linestyle="none")
    axes.set_yticks(range(len(bars)), [label for label, _, _ in bars])
    axes.set_xlabel("part of the stages' time (%)" if as_shares else "time (ms)")
    axes.set_xlim(0, widest * (1 if as_shares else 1.02))
    axes.invert_yaxis()
    axes.tick_params(axis="y", length=0)
    from matplotlib.patches import Patch

    seen = dict.fromkeys(stage for _, _, times in bars for stage in times)
    keys = {stage: Patch(color=colours[stage]) for stage in colours if stage in seen}
    if not as_shares:
        keys["whole frame"] = mark
    axes.legend(keys.values(), keys.keys(), loc="upper left", bbox_to_anchor=(1.01, 1),
                frameon=False)


# ---- The command line.

def list_of(convert):
    """A converter for argparse: items between commas, each through `convert`."""
    return lambda text: [convert(item.strip()) for item in text.split(",")]


def number_from(least):
    def whole_number(text):
        value = int(text)
        if value < least:
            raise argparse.ArgumentTypeError(f"{value} is less than {least}")
        return value
    return whole_number


def step(text):
    if not text.isdigit() or int(text) not in STEPS:
        raise argparse.ArgumentTypeError(f"there is no step '{text}', only 1 to {max(STEPS)}")
    return int(text)


def step_and_variant(text):
    number, colon, variant = text.partition(":")
    if not colon or not variant:
        raise argparse.ArgumentTypeError(f"'{text}' is not STEP:VARIANT, such as 2:orphan")
    return step(number), variant


def size_of_window(text):
    if not re.fullmatch(r"[1-9]\d*x[1-9]\d*", text):
        raise argparse.ArgumentTypeError(f"'{text}' is not WxH, such as 1280x720")
    return text


def seconds(text):
    value = float(text)
    if not 0 < value < math.inf:
        raise argparse.ArgumentTypeError(f"{text} is no time to wait")
    return value


def parse_arguments():
    what, _, how = __doc__.partition("\n\n")
    parser = argparse.ArgumentParser(description=what, epilog=how,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--steps", type=list_of(step), default=list(STEPS), metavar="N,N",
                        help="steps to compare (all)")
    parser.add_argument("--variants", type=list_of(step_and_variant), default=[],
                        metavar="N:NAME,N:NAME", help="variants to compare besides")
    parser.add_argument("--counts", type=list_of(number_from(1)), default=[1000, 10000, 100000],
                        metavar="N,N", help="numbers of flakes (1000,10000,100000)")
    parser.add_argument("--experiment", choices=EXPERIMENTS, metavar="NAME",
                        help="run one of --list instead of comparing the steps")
    parser.add_argument("--list", action="store_true", help="list the experiments")
    parser.add_argument("--frames", type=number_from(1), metavar="N",
                        help=f"frames that count in each run ({FRAMES})")
    parser.add_argument("--warmup", type=number_from(0), metavar="N",
                        help=f"frames before those ({STEADY}: after {STEADY // 60} s the snowfall "
                             "is as dense as it gets)")
    parser.add_argument("--repeats", type=number_from(1), default=3, metavar="N",
                        help="how often to run everything (3)")
    parser.add_argument("--size", type=size_of_window, metavar="WxH",
                        help="window (1280x720, some experiments their own)")
    parser.add_argument("--timeout", type=seconds, default=600, metavar="S",
                        help="seconds after which a run has failed (600)")
    parser.add_argument("--out", type=Path, default=Path("comparison"), metavar="DIR",
                        help="folder for what is written (./comparison)")
    parser.add_argument("--build", type=Path, default=ROOT / "build", metavar="DIR",
                        help="folder that holds the programs (build, beside common)")
    return parser.parse_args()


def comparison(settings):
    """The comparison of the steps, as an experiment that has no source."""
    pairs = [(number, "") for number in settings.steps] + settings.variants
    runs = [Run(STEPS[number], count, f"{number} {STEPS[number][7:]} {variant}".strip(), count,
                variant)
            for count in settings.counts for number, variant in sorted(set(pairs))]
    return Experiment("compare", "The same snowfall, step by step", "flakes", lambda *_: runs)


def fail(message):
    sys.exit(f"compare.py: {message}")  # status 1


def renderer_here(settings):
    """What OpenGL renders with, asked of the first program that can say; '' if none can."""
    quick = argparse.Namespace(**{**vars(settings), "frames": 1, "warmup": 0})
    for name in STEPS.values():
        try:
            return measure(Run(name, 1, "", 1), 0, "64x64", quick).renderer
        except Failed:
            continue
    return ""


def main():
    settings = parse_arguments()
    if settings.list:
        for experiment in EXPERIMENTS.values():
            print(f"{experiment.name:20} {experiment.title}\n{'':20} {experiment.source}")
        return 0
    settings.build = settings.build.resolve()
    if not any(shutil.which(name, path=str(settings.build)) for name in STEPS.values()):
        fail(f"{settings.build} holds none of the programs: {REMEDY}")
    try:
        settings.out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        fail(f"cannot write to {settings.out}: {error.strerror}")
    if sys.platform.startswith("linux") and not os.environ.get("DISPLAY") \
            and shutil.which("xvfb-run"):
        # The same once more, with a display in memory as large as the largest window.
        os.execvp("xvfb-run", ["xvfb-run", "-a", "-s", "-screen 0 2560x1440x24 +extension GLX",
                               sys.executable, *sys.argv])
    try:
        return compare(settings)
    except KeyboardInterrupt:  # before the first measurement or after the last
        return 130
    except OSError as error:
        fail(f"cannot write {error.filename}: {error.strerror}")


def compare(settings):
    """Measures and writes what the settings ask for; returns the exit status."""
    experiment = comparison(settings)
    software = False
    if settings.experiment:
        experiment = EXPERIMENTS[settings.experiment]
        software = is_software(renderer_here(settings))
    if settings.frames is None:
        settings.frames = experiment.frames[software]
    if settings.warmup is None:
        settings.warmup = experiment.warmup[software]
    with tempfile.TemporaryDirectory() as folder:
        runs = experiment.runs(software, Path(folder))
        results, notes, interrupted = measure_all(runs, experiment, settings)
    if not results:
        fail("nothing was measured, so nothing is written")

    lines = gather(results)
    renderer = results[0].renderer
    sizes = {result.size for result in results}
    window = sizes.pop() if len(sizes) == 1 else "several sizes of window"
    machine = (renderer + (" (software rendering)" if is_software(renderer) else "")
               + f"\n{processor()}, {window}")
    files = {".csv": csv_bytes(experiment, results)}
    try:
        files[".png"] = draw_chart(experiment, lines, machine)
    except ImportError:
        print("compare.py: without matplotlib there is no chart (python3-matplotlib)",
              file=sys.stderr)
    files[".md"] = report(experiment, lines, results, notes, settings, ".png" in files).encode()
    for suffix, data in files.items():
        path = settings.out / (experiment.name + suffix)
        write_whole(path, data)
        print(path)
    if experiment.source:
        print(f"The source: {experiment.source}\n" + conclusion(experiment, lines).replace("*", ""))
    if interrupted:
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
