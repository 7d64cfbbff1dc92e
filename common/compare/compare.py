#!/usr/bin/env python3
"""Runs the six programs against each other and writes their frame times as a table and a chart.

    common/compare/compare.py                               all six, at 1,000 to 100,000 flakes
    common/compare/compare.py --steps 2 --variants 2:orphan,2:persistent
    common/compare/compare.py --experiment point-size       one of --list
    common/compare/compare.py --merge lab1/compare.csv lab2/compare.csv    many computers in one chart

Writes three files into --out, named compare or after the experiment:

  .csv   one row for each run and stage: median and 95th percentile of the frames of that run, ms.
         Stage "frame" is the whole frame, from swap to swap. A stage's clock is "cpu", "gpu", or
         "finish": both, between calls of glFinish in frames of their own (software renderers).
  .md    what was measured on which machine, and the table, over all repeats
  .png   the chart: frame time against flakes, and beside it the stages at the most flakes

Repeats are interleaved: everything runs once, then everything again, backwards, so that a machine
that slows down as it warms up slows all alike. A program that fails or hangs is reported and the
rest go on; Ctrl-C ends the measuring, and what was measured is written.

Exit status: 0 done, 1 nothing measured or written, 2 wrong command line, 130 after Ctrl-C.
"""

import argparse
import datetime
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import pandas
from tqdm import tqdm

sys.dont_write_bytecode = True  # the source folder stays as it is
from chart import draw_chart  # noqa: E402
from experiments import EXPERIMENTS, FRAMES, STEADY, STEPS, Run, steps  # noqa: E402
from points import COLUMNS, is_software, points_of  # noqa: E402
from report import computers, report  # noqa: E402


class Failed(Exception):
    """A run that gave nothing to compare, or a table that cannot be; says why."""


def measure(run, size, settings):
    """Starts a program once and returns what it timed, as [row of the table]."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "frames.csv"
        command = [settings.build / STEPS[run.step], "--benchmark", "--csv", path, "--size", size,
                   "--particles", str(run.particles), "--frames", str(settings.frames),
                   "--warmup", str(settings.warmup), *run.options,
                   *(["--variant", run.variant] if run.variant else [])]
        try:
            result = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True,
                                    text=True, timeout=settings.timeout, check=False)
            if result.returncode:
                said = result.stderr.strip() or f"exit status {result.returncode}"
                raise Failed(said.splitlines()[0])
            return rows_of(pandas.read_csv(path), run, result.stdout)
        except subprocess.TimeoutExpired as error:
            raise Failed(f"stopped after {settings.timeout} s (--timeout)") from error
        except (OSError, ValueError, LookupError) as error:
            raise Failed(f"no times: {error} (common/run.sh builds the programs)") from error


def rows_of(frames, run, said):
    """The rows of one run: `frames` is the program's own table, `said` what it printed."""
    counted, synchronised = (frames[frames["timing"] == timing] for timing in ("query", "finish"))
    first = counted.iloc[0]
    times = {("frame", "swap"): counted["frame_ms"]}
    build = re.search(r"made in ([\d.]+) ms", said)
    if build:
        times["build", "program"] = pandas.Series([float(build[1])])
    for column in frames.filter(regex="_(cpu|gpu)_ms$"):
        stage, clock, _ = column.rsplit("_", 2)
        if clock == "gpu" and not synchronised.empty:  # the CPU's share of it included
            # Its last frames are most like those that count: the snowfall becomes denser.
            times[stage, "finish"] = synchronised[column].tail(len(counted)).dropna()
        elif not is_software(first["renderer"]):  # whose queries mislead
            times[stage, clock] = counted[column].dropna()
    # A scene's folder is gone by then: its name is enough.
    known = {"line": run.line, "x": run.x, "particles": run.particles,
             "options": " ".join(os.path.basename(option) for option in run.options),
             "processor": processor(), **first[["step", "variant", "width", "height", "renderer"]]}
    return [{**known, "stage": stage, "clock": clock, "frames": len(values),
             "median_ms": values.median(), "p95_ms": values.quantile(0.95)}
            for (stage, clock), values in times.items() if len(values)]


def processor():
    linux = Path("/proc/cpuinfo")
    name = linux.exists() and re.search(r"model name\s*: (.*)", linux.read_text("utf-8"))
    return f"{name[1] if name else platform.processor()}, {os.cpu_count()} cores, {platform.system()}"


def measure_all(runs, experiment, settings):
    """The table of all that could be measured, what went wrong as [text], and the exit status."""
    todo = [(repeat, run) for repeat in range(settings.repeats)
            for run in (reversed(runs) if repeat % 2 else runs)]
    rows, notes, failed, status = [], [], set(), 0
    try:
        for repeat, run in tqdm(todo, unit="run", dynamic_ncols=True):
            if run in failed:  # what failed once is not tried again
                continue
            try:
                size = settings.size or run.size or experiment.size
                rows += [{"experiment": experiment.name, "repeat": repeat, **row}
                         for row in measure(run, size, settings)]
            except Failed as error:
                failed.add(run)
                notes.append(f"{run.line} at {run.particles:,} flakes failed: {error}")
                tqdm.write(notes[-1], file=sys.stderr)
    except KeyboardInterrupt:
        notes.append(f"ended by Ctrl-C in repeat {repeat + 1} of {settings.repeats}")
        status = 130
    return pandas.DataFrame(rows, columns=COLUMNS), notes, status


def compare(settings, experiment):
    """Measures and writes what the settings ask for; returns the exit status."""
    quick = argparse.Namespace(**{**vars(settings), "frames": 1, "warmup": 0})
    try:
        settings.software = is_software(measure(Run("1", 1, "", 1), "64x64", quick)[0]["renderer"])
    except Failed:
        settings.software = True
    settings.frames = settings.frames or experiment.frames[settings.software]
    settings.counts = settings.counts or experiment.counts[settings.software]
    if settings.warmup is None:
        settings.warmup = experiment.warmup[settings.software]
    with tempfile.TemporaryDirectory() as folder:
        settings.folder = Path(folder)
        table, notes, status = measure_all(experiment.runs(settings), experiment, settings)
    if table.empty:
        raise Failed("nothing was measured, so nothing is written")
    facts = [f"Measured: {settings.frames} frames a run, of one time step each, after "
             f"{settings.warmup} of warm-up, repeats: {settings.repeats}; {datetime.date.today()}",
             *(f"Not as planned: {note}" for note in notes)]
    if experiment.measured != "build" and settings.warmup + settings.frames / 2 < STEADY:
        facts.append(f"Not all flakes had been released: they are after {STEADY} frames")
    table.to_csv(settings.out / f"{experiment.name}.csv", index=False, float_format="%.4f")
    write(settings.out / experiment.name, experiment, table, facts)
    return status


def write(path, experiment, table, facts):
    """The page and the chart of a table."""
    lines = points_of(table, experiment.measured)
    text = report(experiment, lines, [*computers(table), *facts])
    Path(f"{path}.md").write_text(text, encoding="utf-8")
    draw_chart(f"{path}.png", experiment, lines, "\n".join(computers(table)))
    print(f"{path}.md", f"{path}.png", sep="\n")
    if experiment.source:
        print(f"The source: {experiment.source}\nHere: {experiment.conclusion(lines)}")


def merge(settings):
    """Puts the tables of several computers into one page and one chart; returns the exit status."""
    tables = []
    for number, path in enumerate(settings.merge, 1):
        try:
            table = pandas.read_csv(path, usecols=COLUMNS)
        except ValueError as error:
            raise Failed(f"{path} is no table of this compare.py (measure again): {error}") from error
        tables.append(table.assign(line=table.line + f", computer {number}",
                                   renderer=f"computer {number}: " + table.renderer))
    merged = pandas.concat(tables)
    name, *others = merged.experiment.unique()
    if others or name not in EXPERIMENTS:
        raise Failed(f"the tables have to be of one experiment, not of {', '.join([name, *others])}")
    experiment = replace(EXPERIMENTS[name], name=f"{name}-merged", source="", baseline="", chart="lines",
                         title=f"{EXPERIMENTS[name].title}: {len(tables)} computers")
    write(settings.out / experiment.name, experiment, merged, [])
    return 0


def parse_arguments():
    as_it_is = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=as_it_is)
    add = parser.add_argument
    add("--steps", type=steps, metavar="N,N", default=steps("1,2,3,4,5,6:cells,6:heightmap,6:winter"),
        help="steps to compare (all, and step 6 in all variants)")
    add("--variants", type=steps, metavar="N:NAME,N:NAME", default=[], help="variants besides")
    add("--counts", metavar="N,N", help="numbers of flakes (1000,10000,100000)",
        type=lambda text: [int(count) for count in text.split(",")])
    add("--experiment", choices=EXPERIMENTS, default="compare", metavar="NAME", help="one of --list")
    add("--list", action="store_true", help="list the experiments, and what their sources found")
    add("--merge", type=Path, nargs="+", metavar="CSV", help="tables of many computers to put into one")
    add("--frames", type=int, metavar="N", help=f"frames that count in each run ({FRAMES})")
    add("--warmup", type=int, metavar="N", help=f"frames before those ({STEADY}), in time lapse")
    add("--repeats", type=int, default=3, metavar="N", help="how often to run everything (3)")
    add("--size", metavar="WxH", help="window (1280x720; some experiments have their own)")
    add("--timeout", type=float, default=600, metavar="S", help="a run's most seconds (600)")
    add("--out", type=Path, default=Path("comparison"), metavar="DIR", help="of results (comparison)")
    add("--build", type=Path, default=Path(__file__).parents[2] / "build", metavar="DIR",
        help="folder of the programs")
    settings = parser.parse_args()
    settings.build = settings.build.resolve()
    if settings.counts and not EXPERIMENTS[settings.experiment].counts[0]:
        parser.error(f"{settings.experiment} has its own numbers of flakes")
    return settings


def main():
    settings = parse_arguments()
    if settings.list:
        for experiment in list(EXPERIMENTS.values())[1:]:  # without the comparison of the steps
            print(f"{experiment.name:20} {experiment.title}\n{'':20} {experiment.source}")
        return 0
    if not settings.merge and not os.environ.get("DISPLAY") and shutil.which("xvfb-run"):
        # A display in memory, as large as the largest window.
        os.execvp("xvfb-run", ["xvfb-run", "-a", "-s", "-screen 0 2560x1440x24 +extension GLX "
                               "-noreset", sys.executable, *sys.argv])
    try:
        settings.out.mkdir(parents=True, exist_ok=True)
        if settings.merge:
            return merge(settings)
        return compare(settings, EXPERIMENTS[settings.experiment])
    except (Failed, OSError) as error:
        sys.exit(f"compare.py: {error}")


if __name__ == "__main__":
    sys.exit(main())
