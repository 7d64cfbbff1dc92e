#!/usr/bin/env python3
"""Runs the six programs against each other and writes their frame times as a table and a chart.

    common/compare/compare.py                               all six, at 1,000 to 100,000 flakes
    common/compare/compare.py --steps 1,2,4 --counts 10000,1000000
    common/compare/compare.py --steps 2 --variants 2:orphan,2:persistent
    common/compare/compare.py --experiment point-size       one of --list
    common/compare/compare.py --merge lab1/compare.csv lab2/compare.csv    many computers in one chart

Writes three files into --out, named compare or after the experiment:

  .csv   one row for each run and stage: median and 95th percentile of the frames of that run, ms.
         Stage "frame" is the whole frame, from swap to swap (clock "swap"). A stage's clock is
         "cpu", "gpu", or "finish" where both were timed together, between calls of glFinish in
         frames of their own (software renderers). "line" and "x" are its place on the chart.
  .md    what was measured on which machine, and the table, over all repeats
  .png   the chart: frame time against flakes, and beside it the stages at the most flakes

With --merge nothing is measured: from the .csv of one experiment on several computers it writes a
.md and a .png, named after the experiment and "-merged", with a line for each computer.

Repeats are interleaved: everything runs once, then everything again, so that a machine that slows
down as it warms up slows all alike. A program that fails or hangs is reported and the rest go on;
Ctrl-C, SIGTERM and SIGHUP end the measuring, and what was measured is written. A second one ends
it at once.

Exit status: 0 if anything was measured (what failed is listed), 1 if nothing was or the files
cannot be written, 2 for a wrong command line, 128 and the signal's number after a signal.
"""

import argparse
import contextlib
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
from dataclasses import dataclass, replace
from pathlib import Path

sys.dont_write_bytecode = True  # the source folder stays as it is
from experiments import EXPERIMENTS, FRAMES, STEADY, Experiment, Here, Run  # noqa: E402
from merge import COLUMNS, Refused, read_tables  # noqa: E402

try:
    from tqdm import tqdm
except ImportError:
    tqdm = None

ROOT = Path(__file__).resolve().parent.parent.parent
STEPS = {int(folder.name[4:6]): folder.name for folder in sorted(ROOT.glob("step[0-9][0-9]_*"))}
ENDING = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)]
UMASK = os.umask(0)  # there is no other way to ask for it
os.umask(UMASK)
REMEDY = "build with common/run.sh, or: cmake -B build && cmake --build build"


class Failed(Exception):
    """A run that gave nothing to compare; says why."""


class Ended(BaseException):
    """A signal that asks for an end. subprocess kills what it is running when this passes it."""

    def __init__(self, number):
        super().__init__(number)
        self.status = 128 + number
        self.name = "Ctrl-C" if number == signal.SIGINT else signal.Signals(number).name


@dataclass
class Measured:
    """What one run measured."""

    run: Run
    repeat: int
    variant: str
    size: str
    renderer: str
    frames: list  # ms, swap to swap, one a frame
    stages: dict  # clock -> stage -> ms, one a frame


@dataclass
class Point:
    """What all repeats of one run have in common: a point on the chart, a row of the table."""

    run: Run
    variant: str
    median: float  # ms, of all frames of all repeats
    p95: float     # ms, likewise
    low: float     # ms, the least median of a repeat
    high: float    # ms, the greatest
    stages: dict   # clock -> stage -> median ms


def percentile_95(times):
    return sorted(times)[math.ceil(0.95 * len(times)) - 1]


def is_software(renderer):
    names = ("llvmpipe", "softpipe", "swrast", "swr", "software", "gdi generic", "basic render")
    return any(name in renderer.lower() for name in names)


# ---- Measuring.

def read_csv(path, run, repeat):
    """What a program wrote with --csv, as a Measured."""
    frames, times = [], {timing: {"cpu": defaultdict(list), "gpu": defaultdict(list)}
                         for timing in ("query", "finish")}
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = csv.DictReader(file, strict=True)
            for row in rows:
                if None in row or None in row.values():
                    raise ValueError(f"there should be {len(rows.fieldnames)} columns")
                if row["timing"] == "query":  # a synchronised frame takes longer than it need
                    frames.append(float(row["frame_ms"]))
                for name, value in row.items():
                    match = re.fullmatch(r"(\w+)_(cpu|gpu)_ms", name)
                    if match and value:
                        times[row["timing"]][match[2]][match[1]].append(float(value))
        if not frames or not min(frames) > 0:
            raise Failed("its CSV holds no frame times")
        variant, renderer, size = row["variant"], row["renderer"], f"{row['width']}x{row['height']}"
    except KeyError as error:
        raise Failed(f"malformed CSV: no column or timing {error}") from error
    except (ValueError, csv.Error) as error:
        raise Failed(f"malformed CSV, line {rows.line_num}: {error}") from error
    except OSError as error:
        raise Failed(f"no CSV: {error.strerror}") from error
    stages = {clock: times for clock, times in times["query"].items() if times}
    if times["finish"]["gpu"]:  # from one glFinish to the next, the CPU's part of it included
        # That pass is part of the warm-up: its last frames are most like those that count.
        stages = {"finish": {stage: values[-len(frames):]
                             for stage, values in times["finish"]["gpu"].items()}}
    elif is_software(renderer):
        stages = {}  # such a renderer's queries mislead
    return Measured(run, repeat, variant, size, renderer, frames, stages)


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
            raise Failed(f"stopped after {settings.timeout} s (--timeout)") from error
        except OSError as error:
            raise Failed(f"cannot be started: {error.strerror}") from error
        if result.returncode:
            code = result.returncode
            said = [f"killed: {signal.strsignal(-code)}" if code < 0 else f"exit status {code}"]
            raise Failed((result.stderr.strip().splitlines() or said)[0])
        measured = read_csv(path, run, repeat)
        if run.says:
            said = re.search(run.says, result.stdout)
            if not said:
                raise Failed(f"does not say '{run.says}'")
            measured.frames, measured.stages = [float(said[1])], {}
        return measured


def options_text(run):
    """A run's own options; of a scene only the file's name, for the file is gone by then."""
    return " ".join(os.path.basename(option) for option in run.options)


def progress(todo):
    """Yields what is to do, and shows which it is, how many are done and the time left."""
    if not tqdm:
        for number, (repeat, run) in enumerate(todo, 1):
            print(f"run {number} of {len(todo)}: {run.line} {run.x:,}", file=sys.stderr)
            yield repeat, run
        return
    with tqdm(todo, unit="run", dynamic_ncols=True) as bar:
        for repeat, run in bar:
            bar.set_description(f"{run.line} {run.x:,}")
            yield repeat, run


def measure_all(runs, experiment, settings):
    """All that could be measured, what went wrong as [text], and the exit status so far."""
    todo = [(repeat, run) for repeat in range(settings.repeats) for run in runs]
    results, notes, failed, status = [], [], set(), 0
    try:
        for repeat, run in progress(todo):
            if run in failed:  # what failed once is not tried again
                continue
            size = run.size or settings.size or experiment.size
            try:
                results.append(measure(run, repeat, size, settings))
                frames, actual_size = len(results[-1].frames), results[-1].size
                problem = (f"was cut short: {frames} of {settings.frames} frames"
                           if frames < settings.frames and not run.says else
                           f"had a window of {actual_size} instead of {size}"
                           if actual_size != size else "")
            except Failed as error:
                failed.add(run)
                problem = f"failed: {error}"
            if problem:
                words = (run.step, run.variant, options_text(run), f"at {run.particles:,} flakes")
                notes.append(" ".join(filter(None, words)) + f" {problem}")
                (tqdm.write if tqdm else print)(notes[-1], file=sys.stderr)
    except Ended as end:
        status = end.status
        notes.append(f"ended by {end.name} after {len(results)} of {len(todo)} runs")
    return results, list(dict.fromkeys(notes)), status


def gather(results):
    """{line: {x: Point}} over all repeats."""
    groups = defaultdict(list)
    for result in results:
        groups[result.run].append(result)
    lines = defaultdict(dict)
    for run, repeats in groups.items():
        medians = [statistics.median(result.frames) for result in repeats]
        frames = sum((result.frames for result in repeats), [])
        stages = defaultdict(lambda: defaultdict(list))
        for result in repeats:
            for clock, parts in result.stages.items():
                for stage, times in parts.items():
                    stages[clock][stage] += times
        stages = {clock: {stage: statistics.median(times) for stage, times in parts.items()}
                  for clock, parts in stages.items()}
        lines[run.line][run.x] = Point(run, repeats[0].variant, statistics.median(frames),
                                       percentile_95(frames), min(medians), max(medians), stages)
    return dict(lines)


def gather_merged(rows):
    """The same of the rows of read_tables, whose computers each have lines of their own."""
    groups = defaultdict(list)
    for (number, _, _), row in rows:
        run = Run(row["step"], row["particles"], f"{row['line']}, computer {number}", row["x"],
                  row["variant"])
        groups[run].append(row)
    lines = defaultdict(dict)
    for run, parts in groups.items():
        stages = defaultdict(lambda: defaultdict(list))
        for row in parts:
            stages[row["clock"]][row["stage"]].append(row["median_ms"])
        medians = stages.pop("swap", {}).get("frame")
        if not medians:
            continue
        p95s = [row["p95_ms"] for row in parts if row["stage"] == "frame"]
        stages = {clock: {stage: statistics.median(times) for stage, times in parts.items()}
                  for clock, parts in stages.items()}
        lines[run.line][run.x] = Point(run, run.variant, statistics.median(medians),
                                       statistics.median(p95s), min(medians), max(medians), stages)
    return dict(lines)


# ---- Writing.

def write_whole(path, content):
    """Writes the bytes `content` to the file, or leaves what was there as it was."""
    part = None
    try:
        with tempfile.NamedTemporaryFile(dir=path.parent, prefix=path.name, delete=False) as file:
            part = Path(file.name)
            file.write(content)
        part.chmod(0o666 & ~UMASK)  # as any new file; a temporary one is its owner's alone
        part.replace(path)
    except OSError as error:
        if part:
            part.unlink(missing_ok=True)
        raise OSError(error.errno, error.strerror, str(path)) from error  # a full disk names no file


def as_csv(experiment, results):
    """The tidy table, see the top of this file."""
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for result in results:
        run = result.run
        whole = {"program": {experiment.measured: result.frames}} if run.says else {
            "swap": {"frame": result.frames}}
        for clock, stages in {**whole, **result.stages}.items():
            for stage, times in stages.items():
                writer.writerow([
                    experiment.name, run.line, run.x, run.step, result.variant,
                    options_text(run), run.particles, *result.size.split("x"),
                    result.renderer, processor(), result.repeat, stage, clock, len(times),
                    f"{statistics.median(times):.4f}", f"{percentile_95(times):.4f}"])
    return text.getvalue()


def processor():
    linux = Path("/proc/cpuinfo")
    model = linux.exists() and re.search(r"model name\s*: (.*)", linux.read_text("utf-8"))
    name = model[1] if model else platform.processor() or platform.machine()
    return f"{name}, {os.cpu_count()} cores, {platform.system()}"


def machine(results):
    """For the chart: what was measured on."""
    renderer, sizes = results[0].renderer, {result.size for result in results}
    return (renderer + " (software rendering)" * is_software(renderer) + f"\n{processor()}, "
            + (sizes.pop() if len(sizes) == 1 else "several sizes of window"))


def stages_text(point):
    """A point's stages in a few words, one group for each clock."""
    names = {"cpu": "CPU: ", "gpu": "GPU: ", "finish": ""}
    return "; ".join(names[clock] + ", ".join(f"{stage} {ms:.2f}" for stage, ms in times.items())
                     for clock, times in point.stages.items())


def report(experiment, lines, results, notes, settings, chart):
    """The whole .md as text."""
    of_frames = experiment.measured == "frame time"
    text = [f"# {experiment.title}", ""]
    for renderer in dict.fromkeys(result.renderer for result in results):
        text.append(f"- Renderer: {renderer}" + (
            ". **This is software rendering:** no graphics card took part, and these times say "
            "nothing about one." if is_software(renderer) else ""))
    sizes = dict.fromkeys(result.size for result in results)
    text += [f"- Processor: {processor()}",
             f"- Window: {', '.join(sizes)} pixels, vsync off",
             "- Measured: " + (f"{settings.frames} frames a run, of one time step each, after "
                               f"{settings.warmup} of warm-up"
                               if of_frames else f"{experiment.measured}, as the program says it")
             + f", repeats: {settings.repeats}"
             + (", interleaved" if settings.repeats > 1 else " (which may differ by chance)")
             + f"; {datetime.date.today():%d %B %Y}"]
    if of_frames and settings.warmup + settings.frames / 2 < STEADY:
        text.append(f"- The snowfall was still building up: not all flakes had been released (they "
                    f"are after {STEADY} frames).")
    text += [f"- Not as planned: {note}" for note in notes]
    if experiment.source:
        text += ["", f"**The source:** {experiment.source}", "",
                 f"**Here:** {experiment.conclusion(lines)}"]
    if chart:
        text += ["", f"![{experiment.title}]({experiment.name}.png)"]
    text += ["", *table(experiment, lines, settings.repeats), "",
             ("Frame times run from swap to swap; median and 95th percentile are those of all "
              "frames of all repeats." if of_frames else "Median and 95th percentile of all repeats.")
             + " *Repeats*: half of what lies between the least and the "
             "greatest median of a repeat; smaller differences mean nothing."]
    if experiment.baseline:
        text[-1] += (f" *Ratio*: the frame time divided by that of \"{experiment.baseline}\" with "
                     "as many flakes; less than 1 is faster. *Change*: that much longer.")
    if any("finish" in result.stages for result in results):
        text[-1] += (" Stages were timed between calls of glFinish in frames of their own, which "
                     "lets nothing overlap: they show where the time goes, and may add up to more "
                     "than a frame. What they leave of it is clearing and showing the window.")
    elif of_frames:
        text[-1] += (" CPU and GPU work at the same time, so their stages do not add up to a "
                     "frame.")
    return "\n".join(text) + "\n"


def merged_report(experiment, lines, computers, chart):
    """The whole .md of --merge as text."""
    text = [f"# {experiment.title}", ""]
    for number, renderer, cpu in computers:
        text.append(f"- Computer {number}: {renderer}"
                    + " (software rendering)" * is_software(renderer) + f"; {cpu}")
    if chart:
        text += ["", f"![{experiment.title}]({experiment.name}.png)"]
    text += ["", *table(experiment, lines, 2), "",
             "Frame times run from swap to swap. Median and 95th percentile are the medians of those "
             "of the repeats on that computer. *Repeats*: half of what lies between the least and the "
             "greatest median of a repeat; smaller differences mean nothing."]
    return "\n".join(text) + "\n"


def table(experiment, lines, repeats):
    """The lines of the table, a row for each point."""
    base = lines.get(experiment.baseline, {})
    against = ["ratio", "change, ms"] if experiment.baseline else []
    words = ["step", "variant"] + ["line"] * bool(experiment.source)
    fps = ["fps"] if experiment.measured == "frame time" else []
    numbers = [experiment.x_label, "median, ms", "p95, ms", *fps, "repeats", *against]
    rows = [words + numbers + ["stages, ms"],
            ["---"] * len(words) + ["--:"] * len(numbers) + ["---"]]
    for line, points in lines.items():
        for x, point in sorted(points.items()):
            spread = f"±{50 * (point.high - point.low) / point.median:.0f} %"
            row = [point.run.step, point.variant, line][:len(words)]
            row += [f"{x:,}", f"{point.median:.2f}", f"{point.p95:.2f}"]
            row += [f"{1000 / point.median:,.0f}"] * len(fps) + [spread * (repeats > 1)]
            if against:
                row += ([f"{point.median / base[x].median:.2f}",
                         f"{point.median - base[x].median:+.2f}"] if x in base else ["", ""])
            rows.append(row + [stages_text(point)])
    return ["| " + " | ".join(row) + " |" for row in rows]


# ---- The command line.

def like(pattern, what, convert):
    """A converter for argparse: of a text that matches `pattern`, which is `what` in words."""
    def converted(text):
        if not re.fullmatch(pattern, text):
            raise argparse.ArgumentTypeError(f"'{text}' is not {what}")
        return convert(text)
    return converted


def parse_arguments():
    step, above_0 = f"[1-{max(STEPS)}](:[^:,]+)?", r"0*[1-9]\d*"
    number = like(above_0, "a whole number above 0", int)
    counts = like(f"{above_0}(,{above_0})*", "a list of whole numbers above 0",
                  lambda text: [int(count) for count in text.split(",")])
    steps = like(f"{step}(,{step})*", f"a list of steps from 1 to {max(STEPS)}, such as 1,2:orphan",
                 lambda text: [(int(item[0]), item[2:]) for item in text.split(",")])
    what, _, how = __doc__.partition("\n\n")
    parser = argparse.ArgumentParser(description=what, epilog=how,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add("--steps", type=steps, metavar="N,N", help="steps to compare (all, and step 6 in both variants)",
        default=[(number, "") for number in STEPS if number < 6] + [(6, "cells"), (6, "winter")])
    add("--variants", type=steps, metavar="N:NAME,N:NAME", help="variants to compare besides",
        default=[])
    add("--counts", type=counts, metavar="N,N",
        help="numbers of flakes (1000,10000,100000; some experiments have their own)")
    add("--experiment", choices=EXPERIMENTS, metavar="NAME",
        help="run one of --list, which has its own steps and variants")
    add("--list", action="store_true", help="list the experiments")
    add("--merge", type=Path, nargs="+", metavar="CSV",
        help="put tables that were written before, on several computers, into one")
    add("--frames", type=number, metavar="N", help=f"frames that count in each run ({FRAMES})")
    add("--warmup", type=like(r"\d+", "a whole number", int), metavar="N",
        help=f"frames before those, most of them in time lapse ({STEADY}: until the snowfall is as "
             "dense as it gets)")
    add("--repeats", type=number, default=3, metavar="N", help="how often to run everything (3)")
    add("--size", type=like(r"[1-9]\d*x[1-9]\d*", "WxH, such as 1280x720", str), metavar="WxH",
        help="window (1280x720; some experiments have their own)")
    add("--timeout", type=number, default=600, metavar="S",
        help="seconds after which a run has failed (600)")
    add("--out", type=Path, default=Path("comparison"), metavar="DIR",
        help="folder for what is written (./comparison)")
    add("--build", type=Path, default=ROOT / "build", metavar="DIR",
        help="folder that holds the programs (build, beside common)")
    settings = parser.parse_args()
    if settings.merge and (settings.experiment or settings.counts or settings.list):
        parser.error("--merge measures nothing: it takes files, and --out")
    if settings.experiment and settings.counts and not EXPERIMENTS[settings.experiment].counts:
        parser.error(f"{settings.experiment} has its own numbers of flakes")
    return settings


def comparison(settings):
    """The comparison of the steps, as an experiment that has no source."""
    pairs = sorted({*settings.steps, *settings.variants})
    return Experiment(
        "compare", "The same snowfall, step by step", "flakes",
        lambda here: [Run(STEPS[number], count, f"{number} {STEPS[number][7:]} {variant}".strip(),
                          count, variant) for count in here.counts for number, variant in pairs],
        counts=2 * ((1000, 10000, 100000),), baseline=f"1 {STEPS[1][7:]}")


def renderer_here(settings):
    """What OpenGL renders with, asked of the first program that can say; '' if none can."""
    quick = argparse.Namespace(**{**vars(settings), "frames": 1, "warmup": 0})
    for name in STEPS.values():
        try:
            return measure(Run(name, 1, "", 1), 0, "64x64", quick).renderer
        except Failed:
            continue
    return ""


def on_signal(number, _):
    """The first asks for an end, the next one ends it at once."""
    for name in ENDING:
        signal.signal(name, signal.SIG_DFL)
    raise Ended(number)


@contextlib.contextmanager
def display():
    """Sees to it that there is a display: one in memory, as large as the largest window, if need be."""
    if sys.platform != "linux" or os.environ.get("DISPLAY") or not shutil.which("Xvfb"):
        yield
        return
    # Xvfb chooses a number that is free, and writes it once it can be connected to. In a session of
    # its own it does not hear the terminal's Ctrl-C: it is needed to the end.
    with subprocess.Popen(["Xvfb", "-displayfd", "1", "-screen", "0", "2560x1440x24", "+extension",
                           "GLX", "-noreset", "-nolisten", "tcp"], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, start_new_session=True, text=True) as server:
        try:
            os.environ["DISPLAY"] = ":" + server.stdout.readline().strip()
            yield
        finally:
            server.terminate()


def main():
    for name in ENDING:
        if signal.getsignal(name) != signal.SIG_IGN:  # as nohup has it
            signal.signal(name, on_signal)
    settings = parse_arguments()
    if settings.list:
        for experiment in EXPERIMENTS.values():
            print(f"{experiment.name:20} {experiment.title}\n{'':20} {experiment.source}")
        return 0
    if settings.merge:
        try:
            return merge(settings)
        except Refused as error:
            sys.exit(f"compare.py: {error}")
        except OSError as error:
            sys.exit(f"compare.py: cannot write {error.filename}: {error.strerror}")
    settings.build = settings.build.resolve()
    if not any(shutil.which(name, path=str(settings.build)) for name in STEPS.values()):
        sys.exit(f"compare.py: {settings.build} holds none of the programs: {REMEDY}")
    try:
        settings.out.mkdir(parents=True, exist_ok=True)
        with display():
            return compare(settings)
    except Ended as end:  # before the first measurement or after the last
        return end.status
    except OSError as error:
        sys.exit(f"compare.py: cannot write {error.filename}: {error.strerror}")


def merge(settings):
    """Writes what --merge asks for; returns the exit status."""
    name, rows = read_tables(settings.merge)
    if name != "compare" and name not in EXPERIMENTS:
        raise Refused(f"{settings.merge[0]} is of no experiment that this compare.py knows: '{name}'")
    measured = comparison(settings) if name == "compare" else EXPERIMENTS[name]
    computers = list(dict.fromkeys(computer for computer, _ in rows))
    # Each line has a colour of its own, as where a source is followed.
    experiment = replace(measured, name=f"{name}-merged", source="the files", baseline="",
                         chart="lines", title=f"{measured.title}: {len(computers)} computers")
    lines = gather_merged(rows)
    settings.out.mkdir(parents=True, exist_ok=True)
    caption = "\n".join(f"computer {number}: {renderer}; {cpu}"
                        for number, renderer, cpu in computers)
    picture = settings.out / f"{experiment.name}.png"
    has_chart = write_chart(picture, experiment, lines, caption)
    text = settings.out / f"{experiment.name}.md"
    write_whole(text, merged_report(experiment, lines, computers, has_chart).encode())
    print(*[picture] * has_chart, text, sep="\n")
    return 0


def write_chart(path, experiment, lines, caption):
    """Writes the .png. False: it cannot, for there is no matplotlib."""
    try:
        from chart import draw_chart  # which takes a second, too long for --list
    except ImportError:
        print("compare.py: without matplotlib there is no chart (python3-matplotlib)",
              file=sys.stderr)
        return False
    picture = io.BytesIO()
    draw_chart(picture, experiment, lines, caption)
    write_whole(path, picture.getvalue())
    return True


def compare(settings):
    """Measures and writes what the settings ask for; returns the exit status."""
    experiment, software = comparison(settings), False
    if settings.experiment:
        experiment = EXPERIMENTS[settings.experiment]
        software = is_software(renderer_here(settings))
    settings.frames = settings.frames or experiment.frames[software]
    if settings.warmup is None:
        settings.warmup = experiment.warmup[software]
    with tempfile.TemporaryDirectory() as folder:
        counts = settings.counts or (experiment.counts and experiment.counts[software])
        runs = experiment.runs(Here(settings.build, software, counts, Path(folder)))
        results, notes, status = measure_all(runs, experiment, settings)
    if not results:
        print("compare.py: nothing was measured, so nothing is written", file=sys.stderr)
        return status or 1

    lines = gather(results)
    paths = [settings.out / (experiment.name + suffix) for suffix in (".csv", ".png", ".md")]
    write_whole(paths[0], as_csv(experiment, results).encode())
    has_chart = write_chart(paths[1], experiment, lines, machine(results))
    if not has_chart:
        del paths[1]
    write_whole(paths[-1],
                report(experiment, lines, results, notes, settings, has_chart).encode())
    print(*paths, sep="\n")
    if experiment.source:
        print(f"The source: {experiment.source}\nHere: {experiment.conclusion(lines)}")
    return status


if __name__ == "__main__":
    sys.exit(main())
