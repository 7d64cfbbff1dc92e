"""common/compare/compare.py, on the real programs and on made-up ones that fail as a run can."""

import csv
import os
import random
import re
import signal
import stat
import subprocess
import sys
import time

import pytest

from conftest import PATIENCE, ROOT, STEPS

COMPARE = ROOT / "common" / "compare" / "compare.py"
sys.path.insert(0, str(COMPARE.parent))
from experiments import EXPERIMENTS  # noqa: E402
from points import Point, ratio  # noqa: E402

# Stands in for a program. Its frame times follow from its arguments, what it does from the file
# NAME.does beside it; it writes down each start in the file "starts".
FAKE = f"#!{sys.executable}\n" + r'''
import argparse, pathlib, sys, time
me = pathlib.Path(sys.argv[0])
parser = argparse.ArgumentParser(formatter_class=argparse.RawDescriptionHelpFormatter, epilog="""
  wind_x        0 m/s, wind towards +x
  fog           1 on/off, thicker with the snowfall
  arrows        0 on/off, which way the wind blows""")
parser.add_argument("--benchmark", action="store_true", required=True)
parser.add_argument("--set", action="append", default=[])
for name in "csv particles size frames warmup variant".split():
    parser.add_argument("--" + name)
options = parser.parse_args()
with open(me.with_name("starts"), "a") as file:
    file.write(f"{me.name} {options.particles}\n")
does_file = me.with_name(me.name + ".does")
does = does_file.read_text() if does_file.exists() else ""
if does == "refuse":
    sys.exit(f"{me.name}: no such luck\nand more of it")
if does == "hang":
    me.with_name("hanging").touch()
    time.sleep(600)
width, height = options.size.split("x")
step = int(me.name[4:6])
frame_ms = step * (1 + int(options.particles)) / 1000 - 4 * ("fog=0" in options.set)
known = f'{me.name},{options.variant or "plain"},{options.particles},{width},{height},"llvmpipe (LLVM 15, 256 bits)"'
with open(options.csv, "w") as file:
    file.write("step,variant,particles,width,height,renderer,frame,frame_ms,timing,"
               "update_cpu_ms,update_gpu_ms,draw_cpu_ms,draw_gpu_ms\n")
    if does == "empty":
        sys.exit()
    for frame in range(3):  # slow frames, and not to be counted
        file.write(f"{known},{frame},{100 * frame_ms},finish,0.01,0.25,0.02,0.75\n")
    for frame in range(int(options.frames)):
        file.write(f"{known},{frame},{frame_ms + frame},query,0.126,,0.376,\n")
'''


@pytest.fixture
def fakes(tmp_path):
    """A folder with a made-up program for every step."""
    build = tmp_path / "build"
    build.mkdir()
    for step in STEPS:
        program = build / step
        program.write_text(FAKE)
        program.chmod(program.stat().st_mode | stat.S_IXUSR)
    return build


def command(build, *arguments):
    """How compare.py is started: in the folder above `build`, so that it writes to comparison/ there."""
    return {"args": [sys.executable, COMPARE, "--build", build, *map(str, arguments)],
            "env": {"DISPLAY": ":0", **os.environ},  # or it would make one for the made-up programs
            "cwd": build.parent, "text": True}


def compare(build, *arguments):
    return subprocess.run(**command(build, *arguments), capture_output=True, timeout=PATIENCE, check=False)


def frames_of(build, name="compare"):
    with open(build.parent / "comparison" / f"{name}.csv", newline="") as file:
        return [row for row in csv.DictReader(file) if row["stage"] == "frame"]


def page(build, name="compare"):
    return (build.parent / "comparison" / f"{name}.md").read_text()


def written(build):
    return sorted(path.name for path in (build.parent / "comparison").glob("*"))


def drifting(generator, programs, repeats):
    """Points of programs with these times, on a machine that from one start to the next becomes some
    3 % faster or slower, for good, and 2 % for that start alone."""
    medians, speed = [{} for _ in programs], 1
    for repeat in range(repeats):
        order = range(len(programs))
        for index in reversed(order) if repeat % 2 else order:
            speed *= generator.gauss(1.003, 0.03)
            medians[index][repeat] = programs[index] * speed * generator.gauss(1, 0.02)
    return [Point("", "", times, 0, {}) for times in medians]


@pytest.mark.parametrize("repeats", [2, 3, 10])
def test_one_program_does_not_differ_from_itself(repeats):
    """In 19 of 20 trials, that is."""
    generator = random.Random(1)
    trials = [ratio(*drifting(generator, (7, 7), repeats)).is_sure for _ in range(4000)]
    assert 0 < sum(trials) / len(trials) <= 0.05


def test_programs_that_differ_do():
    generator = random.Random(1)
    trials = [ratio(*drifting(generator, (7, 14), 3)) for _ in range(1000)]
    assert sum(trial.low <= 0.5 <= trial.high for trial in trials) >= 940
    assert sum(trial.is_sure for trial in trials) > 950
    assert re.fullmatch(r"0\.\d+ times as much \(0\.\d+ to 0\.\d+\)", str(trials[0]))
    assert str(ratio(*drifting(generator, (7, 14), 1))) == "cannot tell"


def test_numbers(fakes):
    result = compare(fakes, "--counts", "999,9999", "--frames", 21, "--repeats", 2)
    assert result.returncode == 0, result.stderr
    assert written(fakes) == ["compare.csv", "compare.md", "compare.png"]
    frames = frames_of(fakes)
    assert len(frames) == (6 + 2) * 2 * 2  # step 6 in three variants
    for row in frames:
        first = int(row["step"][4:6]) * (1 + int(row["particles"])) / 1000
        assert (float(row["median_ms"]), float(row["p95_ms"])) == pytest.approx((first + 10, first + 19))
        assert (row["frames"], row["clock"], row["x"]) == ("21", "swap", row["particles"])
    assert "llvmpipe (LLVM 15, 256 bits) (software rendering)" in page(fakes)
    # 12 ms are 83 fps, and 12/11 of step 1; what was timed until glFinish is what its stages take.
    assert ("| step02_vbo | plain | 2 vbo | 999 | 12.00 | 21.00 | 83.3 | ±0 % | 1.09 (1.09 to 1.09) "
            "| update 0.25, draw 0.75 |") in page(fakes)
    # Every second repeat runs backwards; the first start asks what renders.
    starts = (fakes / "starts").read_text().splitlines()[1:]
    assert starts[16:] == starts[15::-1] and starts[0] == "step01_cpu_points 999"


@pytest.mark.parametrize("does, says", [
    ("refuse", "failed: step02_vbo: no such luck"), ("empty", "failed: no times: "),
    ("hang", "failed: stopped after 5.0 s")])
def test_the_rest_go_on(fakes, does, says):
    (fakes / "step02_vbo.does").write_text(does)
    result = compare(fakes, "--steps", "1,2", "--variants", "5:triangles", "--counts", 10, "--repeats", 2,
                     "--frames", 3, "--timeout", 5 if does == "hang" else 60)
    assert result.returncode == 0
    assert f"2 vbo at 10 flakes {says}" in result.stderr and says in page(fakes)
    assert [row["line"] for row in frames_of(fakes)] == ["1 cpu_points", *2 * ["5 triangles"],
                                                         "1 cpu_points"]
    # What failed once is not tried again.
    assert (fakes / "starts").read_text().count("step02_vbo") == 1


def test_ctrl_c_keeps_what_was_measured(fakes):
    (fakes / "step02_vbo.does").write_text("hang")
    process = subprocess.Popen(
        **command(fakes, "--steps", "1,2,3", "--counts", 10), stderr=subprocess.PIPE,
        # What a shell runs in the background ignores Ctrl-C, and so would all that it starts.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
    while not (fakes / "hanging").exists():  # the first is done, the second will never be
        assert process.poll() is None
        time.sleep(0.01)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=PATIENCE)
    assert process.returncode == 130 and "Traceback" not in said
    assert written(fakes) == ["compare.csv", "compare.md", "compare.png"]
    assert [row["step"] for row in frames_of(fakes)] == [STEPS[0]]
    assert "ended by Ctrl-C in repeat 1 of 3" in page(fakes)


def test_parts_turns_on_all_that_it_measures(fakes):
    assert compare(fakes, "--experiment", "parts", "--counts", 999, "--frames", 1).returncode == 0
    rows = {row["line"]: row for row in frames_of(fakes, "parts")}
    assert {line: (row["options"], float(row["median_ms"])) for line, row in rows.items()} == {
        "everything": ("--set fog=1 --set arrows=1 --set bloom=0.06", 6),
        "without fog": ("--set fog=0 --set arrows=1 --set bloom=0.06", 2),
        "without arrows": ("--set fog=1 --set arrows=0 --set bloom=0.06", 6),
        "without bloom": ("--set fog=1 --set arrows=1 --set bloom=0", 6)}
    assert "without fog 2.00 ms, 0.333 times as much (0.333 to 0.333); without" in page(fakes, "parts")


def test_merge_has_the_same_numbers(fakes):
    """One median: of what one computer measured, and of the same beside another's."""
    for name, repeats in (("a", 1), ("b", 2)):
        assert compare(fakes, "--steps", "1,2", "--counts", "10,1000", "--repeats", repeats, "--frames", 4,
                       "--out", name).returncode == 0
    tables = [fakes.parent / name / "compare.csv" for name in "ab"]
    tables[1].write_text(tables[1].read_text().replace(",1,frame,swap,4,", ",1,frame,swap,4,1"))
    result = compare(fakes, "--merge", *tables)
    assert result.returncode == 0, result.stderr
    assert written(fakes) == ["compare-merged.md", "compare-merged.png"]
    text = page(fakes, "compare-merged")
    assert "- computer 2: llvmpipe (LLVM 15, 256 bits) (software rendering); " in text
    # 1.511 ms in the first repeat, 11.511 in the second.
    assert "| 1 cpu_points, computer 1 | 10 | 1.51 |" in text
    assert "| 1 cpu_points, computer 2 | 10 | 4.17 |" in text

    tables[1].write_text(tables[1].read_text().replace("compare,", "loops,"))
    result = compare(fakes, "--merge", *tables)
    assert result.returncode == 1 and "of one experiment, not of compare, loops" in result.stderr


# Without the one above, which would start step 6 for each of its features.
@pytest.mark.parametrize("experiment", [name for name in EXPERIMENTS if name != "parts"])
def test_the_experiments(request, tmp_path, experiment):
    # Or they take the longest by far.
    few = ["--counts", 50] if experiment in ("compare", "threads", "feedback-or-compute") else []
    build = request.config.getoption("build").resolve()
    result = compare(build, "--experiment", experiment, "--frames", 1, "--warmup", 2, "--repeats", 1,
                     "--size", "64x64", "--out", tmp_path, *few)
    assert result.returncode == 0 and "failed" not in result.stderr, result.stderr
    assert (tmp_path / f"{experiment}.png").read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"
    text = (tmp_path / f"{experiment}.md").read_text()
    assert experiment == "compare" or "**Here:** The " in text
