"""common/compare/compare.py, on the real programs and on made-up ones that break in every way a run can."""

import csv
import os
import pathlib
import re
import signal
import stat
import subprocess
import sys
import time

import pytest

from conftest import PATIENCE, ROOT, STEPS

COMPARE = ROOT / "common" / "compare" / "compare.py"
EXPERIMENTS = ("loops hexagons threads arrays physics window-size point-size release-rate groups "
               "timing-methods yardstick flakes-fixed-scene scene-triangles stage-share spawn-rate "
               "feedback-or-compute voxeliser parts").split()

# Stands in for a program. Its frame times follow from its arguments, what it does from the file
# NAME.does beside it; it writes down each start in the file "starts".
FAKE = f"#!{sys.executable}\n" + r'''
import argparse, os, pathlib, signal, sys, time
me = pathlib.Path(sys.argv[0])
parser = argparse.ArgumentParser(formatter_class=argparse.RawDescriptionHelpFormatter, epilog="""
  wind_x        0 m/s, wind towards +x
  fog           1 on/off, thicker with the snowfall
  arrows        0 on/off, which way the wind blows
  sparkle       1 on/off, now and then""")
parser.add_argument("--benchmark", action="store_true", required=True)
for name in ("csv particles size frames warmup variant scene groups point-size set voxels "
             "voxeliser").split():
    parser.add_argument("--" + name)
options = parser.parse_args()
with open(me.with_name("starts"), "a") as file:
    file.write(f"{me.name} {options.particles}\n")
does_file = me.with_name(me.name + ".does")
does = does_file.read_text() if does_file.exists() else ""
if does == "refuse":
    sys.exit(f"{me.name}: no such luck\nand more of it")
if does == "crash":
    os.kill(os.getpid(), signal.SIGSEGV)
if does == "hang":
    me.with_name("hanging").touch()
    time.sleep(600)
renderer = "llvmpipe (LLVM 15, 256 bits)" if does != "hardware" else "Card, fast/PCIe"
width, height = options.size.split("x")
step = int(me.name[4:6])
frame_ms = step * (1 + int(options.particles)) / 1000 - 4 * (options.set == "fog=0")
known = (f"{me.name},{options.variant or 'plain'},{options.particles},{width},{height},"
         f'"{renderer}"')
with open(options.csv, "w") as file:
    if does == "no renderer":
        file.write("timing,frame_ms\nquery,1\n")
        sys.exit()
    file.write("step,variant,particles,width,height,renderer,frame,frame_ms,timing,"
               "update_cpu_ms,update_gpu_ms,draw_cpu_ms,draw_gpu_ms\n")
    if does == "empty":
        sys.exit()
    if does == "columns":
        file.write(f"{known},0,{frame_ms},clock,1,,,\n")
    if does != "hardware":
        for frame in range(3):  # slow frames, and not to be counted
            file.write(f"{known},{frame},{100 * frame_ms},finish,0.01,0.25,0.02,0.75\n")
    for frame in range(int(options.frames)):
        if does == "malformed" and frame == 1:
            file.write("step,what?\n")
        if does == "words" and frame == 1:
            file.write(f"{known},{frame},soon,query,,,,\n")
        if does == "short" and frame == 2:
            break
        gpu = "0.5" if does == "hardware" else ""
        file.write(f"{known},{frame},{frame_ms + frame},query,0.125,{gpu},0.375,{gpu}\n")
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


@pytest.fixture(scope="session")
def real_build(request):
    given = request.config.getoption("build", default=None)
    return pathlib.Path(given or os.environ.get("SNOWFALL_BUILD", ROOT / "build")).resolve()


@pytest.fixture(scope="session")
def without(tmp_path_factory):
    """without(module): what sets an environment in which Python does not find that module."""
    def block(module):
        folder = tmp_path_factory.mktemp("without")
        (folder / f"{module}.py").write_text("raise ImportError('not installed')\n")
        return {"PYTHONPATH": str(folder)}
    return block


@pytest.fixture(scope="session")
def no_chart(without):
    """The same for matplotlib, which takes a second that most tests need not wait for."""
    return without("matplotlib")


def start(build, arguments, environment=None):
    """Starts compare.py in the folder above `build`, so that it writes to comparison/ there."""
    variables = {**os.environ, **(environment or {})}
    variables.setdefault("DISPLAY", ":0")  # or it would look for one for the made-up programs
    return subprocess.Popen(
        [sys.executable, str(COMPARE), "--build", str(build), *map(str, arguments)],
        cwd=build.parent, env=variables, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        # A shell that runs the tests in the background has them, and all they start, ignore Ctrl-C.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))


def compare(build, *arguments, environment=None):
    """Runs it to its end."""
    with start(build, arguments, environment) as process:
        try:
            said, complained = process.communicate(timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            raise
    return subprocess.CompletedProcess(process.args, process.returncode, said, complained)


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def frames_of(path):
    return [row for row in rows(path) if row["stage"] == "frame"]


def is_png(path):
    return path.read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"


def written(build):
    return sorted(path.name for path in (build.parent / "comparison").glob("*"))


# ---- Made-up programs.

def test_numbers(fakes):
    result = compare(fakes, "--counts", "999,9999", "--frames", 21, "--repeats", 2)
    assert result.returncode == 0, result.stderr
    assert written(fakes) == ["compare.csv", "compare.md", "compare.png"]
    folder = fakes.parent / "comparison"
    assert is_png(folder / "compare.png")

    frames = frames_of(folder / "compare.csv")
    assert len(frames) == (6 + 1) * 2 * 2  # step 6 in both variants
    for row in frames:
        first = int(row["step"][4:6]) * (1 + int(row["particles"])) / 1000
        assert float(row["median_ms"]) == pytest.approx(first + 10)
        assert float(row["p95_ms"]) == pytest.approx(first + 19)  # 20th of 21
        assert (row["frames"], row["clock"], row["x"]) == ("21", "swap", row["particles"])
    stages = [row for row in rows(folder / "compare.csv") if row["stage"] != "frame"]
    assert {(row["stage"], row["clock"], row["median_ms"]) for row in stages} == {
        ("update", "finish", "0.2500"), ("draw", "finish", "0.7500")}

    text = (folder / "compare.md").read_text()
    assert "software rendering" in text and "llvmpipe" in text and "](compare.png)" in text
    # Pooled over the repeats: median 12, p95 the 40th of 42; 12 ms are 83 fps, and 12/11 of step 1.
    assert ("| step02_vbo | plain | 999 | 12.00 | 21.00 | 83 | ±0 % | 1.09 | +1.00 "
            "| update 0.25, draw 0.75 |") in text


def test_repeats_are_interleaved(fakes, no_chart):
    compare(fakes, "--steps", "2,1", "--counts", "10,20", "--repeats", 2, "--frames", 3,
            environment=no_chart)
    once = [f"{step} {count}" for count in (10, 20) for step in STEPS[:2]]
    assert (fakes / "starts").read_text().splitlines() == once * 2


def test_processors_apart_on_a_graphics_card(fakes):
    (fakes / f"{STEPS[0]}.does").write_text("hardware")
    assert compare(fakes, "--steps", 1, "--counts", 10, "--frames", 3).returncode == 0
    text = (fakes.parent / "comparison" / "compare.md").read_text()
    assert "- Renderer: Card, fast/PCIe\n" in text
    assert "CPU: update 0.12, draw 0.38; GPU: update 0.50, draw 0.50" in text


def test_variants_come_on_top(fakes, no_chart):
    compare(fakes, "--steps", 2, "--variants", "2:orphan,5:triangles", "--counts", 10,
            environment=no_chart)
    frames = frames_of(fakes.parent / "comparison" / "compare.csv")
    assert {(row["step"], row["variant"]) for row in frames} == {
        (STEPS[1], "plain"), (STEPS[1], "orphan"), (STEPS[4], "triangles")}


@pytest.mark.parametrize("does, says", [
    ("refuse", "failed: step02_vbo: no such luck"),
    ("crash", "failed: killed: Segmentation fault"),
    ("malformed", "failed: malformed CSV, line 6"),
    ("words", "failed: malformed CSV, line 6"),
    ("columns", "failed: malformed CSV: no column or timing 'clock'"),
    ("no renderer", "failed: malformed CSV: no column or timing 'variant'"),
    ("empty", "failed: its CSV holds no frame times"),
    ("hang", "failed: stopped after 5 s"),
])
def test_the_rest_go_on(fakes, no_chart, does, says):
    (fakes / "step02_vbo.does").write_text(does)
    result = compare(fakes, "--steps", "1,2,3", "--counts", 10, "--repeats", 2, "--frames", 3,
                     "--timeout", 5 if does == "hang" else 60, environment=no_chart)
    assert result.returncode == 0
    assert f"step02_vbo at 10 flakes {says}" in result.stderr
    assert says in (fakes.parent / "comparison" / "compare.md").read_text()
    frames = frames_of(fakes.parent / "comparison" / "compare.csv")
    assert [row["step"] for row in frames] == [STEPS[0], STEPS[2]] * 2
    # What failed once is not tried again.
    assert (fakes / "starts").read_text().count("step02_vbo") == 1


def test_a_run_cut_short_counts_and_is_named(fakes, no_chart):
    (fakes / "step02_vbo.does").write_text("short")
    assert compare(fakes, "--steps", 2, "--counts", 10, "--frames", 5,
                   environment=no_chart).returncode == 0
    text = (fakes.parent / "comparison" / "compare.md").read_text()
    assert "step02_vbo at 10 flakes was cut short: 2 of 5 frames" in text


def test_one_program_is_missing(fakes, no_chart):
    (fakes / "step02_vbo").unlink()
    result = compare(fakes, "--steps", "1,2", "--counts", 10, environment=no_chart)
    assert result.returncode == 0
    assert "step02_vbo at 10 flakes failed" in result.stderr
    assert "common/run.sh" in result.stderr and "cmake -B build" in result.stderr


def test_nothing_is_built(tmp_path):
    result = compare(tmp_path / "no such build")
    assert result.returncode == 1
    assert result.stderr.count("\n") == 1 and "cmake -B build" in result.stderr
    assert not (tmp_path / "comparison").exists()


def test_nothing_can_be_measured(fakes):
    (fakes / "step02_vbo.does").write_text("refuse")
    result = compare(fakes, "--steps", 2, "--counts", 10)
    assert result.returncode == 1
    assert result.stderr.splitlines()[-1].endswith("nothing is written")
    assert written(fakes) == []


def test_nowhere_to_write(fakes):
    (fakes.parent / "file").touch()
    result = compare(fakes, "--out", fakes.parent / "file")
    assert result.returncode == 1 and result.stderr.count("\n") == 1
    assert not (fakes / "starts").exists()  # said before an hour of measuring, not after


@pytest.mark.parametrize("module, left, says", [
    ("matplotlib", ["compare.csv", "compare.md"], "without matplotlib there is no chart"),
    ("tqdm", ["compare.csv", "compare.md", "compare.png"], "run 1 of 1: 1 cpu_points 10"),
])
def test_without_a_module(fakes, without, module, left, says):
    result = compare(fakes, "--steps", 1, "--counts", 10, "--repeats", 1,
                     environment=without(module))
    assert result.returncode == 0
    assert says in result.stderr
    assert written(fakes) == left
    text = (fakes.parent / "comparison" / "compare.md").read_text()
    assert ("compare.png" in text) == ("compare.png" in left)


@pytest.mark.parametrize("number, name", [(signal.SIGINT, "Ctrl-C"), (signal.SIGTERM, "SIGTERM"),
                                          (signal.SIGHUP, "SIGHUP")])
def test_a_signal_keeps_what_was_measured(fakes, number, name):
    """And leaves nothing running: neither the program that is being measured nor a display."""
    (fakes / "step02_vbo.does").write_text("hang")
    process = start(fakes, ["--steps", "1,2,3", "--counts", 10], environment={"DISPLAY": ""})
    patience_ends = time.monotonic() + PATIENCE
    while not (fakes / "hanging").exists():  # the first is done, the second will never be
        assert process.poll() is None and time.monotonic() < patience_ends
        time.sleep(0.01)
    children = descendants(process.pid)
    assert len(children) == 2  # the program, and Xvfb
    process.send_signal(number)
    _, said = process.communicate(timeout=PATIENCE)
    assert process.returncode == 128 + number
    assert "Traceback" not in said
    assert not any(pathlib.Path(f"/proc/{child}").exists() for child in children)
    assert written(fakes) == ["compare.csv", "compare.md", "compare.png"]
    folder = fakes.parent / "comparison"
    assert [row["step"] for row in frames_of(folder / "compare.csv")] == [STEPS[0]]
    assert f"ended by {name} after 1 of 9 runs" in (folder / "compare.md").read_text()


def descendants(parent):
    found = []
    for child in pathlib.Path(f"/proc/{parent}/task/{parent}/children").read_text().split():
        found += [int(child), *descendants(child)]
    return found


def test_a_full_disk_leaves_what_was_there(fakes, no_chart):
    """A limit on the size of files breaks off the write."""
    folder = fakes.parent / "comparison"
    folder.mkdir()
    (folder / "compare.csv").write_text("old")
    code = (f"import resource, signal, sys\n"
            f"signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
            f"sys.path.insert(0, {str(COMPARE.parent)!r})\n"
            f"import compare\n"
            f"whole = compare.write_whole\n"
            f"def limited(path, content):\n"
            f"    resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))\n"
            f"    whole(path, content)\n"
            f"compare.write_whole = limited\n"
            f"sys.exit(compare.main())\n")
    result = subprocess.run([sys.executable, "-c", code, "--build", fakes, "--steps", "1",
                             "--counts", "10", "--frames", "3"], cwd=fakes.parent, text=True,
                            env={**os.environ, **no_chart}, capture_output=True, timeout=PATIENCE)
    assert result.returncode == 1
    assert result.stderr.splitlines()[-1] == (
        "compare.py: cannot write comparison/compare.csv: File too large")
    assert written(fakes) == ["compare.csv"] and (folder / "compare.csv").read_text() == "old"


@pytest.mark.parametrize("arguments", [
    ["--steps", "9"], ["--steps", "two"], ["--counts", "0"], ["--counts", "many"],
    ["--variants", "orphan"], ["--size", "wide"], ["--experiment", "luck"], ["--timeout", "nan"],
    ["--frames", "0"], ["nonsense"],
    ["--experiment", "groups", "--counts", "10"],
    ["--merge"], ["--merge", "a.csv", "--experiment", "groups"],
])
def test_a_wrong_command_line(fakes, arguments):
    assert compare(fakes, *arguments).returncode == 2
    assert not (fakes / "starts").exists()


def test_list(fakes):
    listed = compare(fakes, "--list").stdout
    assert [line.split()[0] for line in listed.splitlines()[::2]] == EXPERIMENTS


def test_experiments_say_what_was_found(fakes, no_chart):
    """Step 2's frames of 1 + flakes of the made-up program take 2/1000 ms a flake."""
    assert compare(fakes, "--experiment", "release-rate", "--frames", 1, "--repeats", 1,
                   environment=no_chart).returncode == 0
    assert written(fakes) == ["release-rate.csv", "release-rate.md"]
    text = (fakes.parent / "comparison" / "release-rate.md").read_text()
    assert "**The source:** Patrick" in text
    assert ("**Here:** Step 2: from 1 to 20 flakes per frame a frame goes from 1.44 to 28.80 ms "
            "(20 times as much).") in text


def test_repeats_that_differ_as_much_as_what_they_measure(fakes, no_chart):
    (fakes / f"{STEPS[0]}.does").write_text("hardware")
    assert compare(fakes, "--experiment", "hexagons", "--frames", 1, "--repeats", 1,
                   environment=no_chart).returncode == 0
    text = (fakes.parent / "comparison" / "hexagons.md").read_text()
    assert "with hexagons (+0 %, no more than from repeat to repeat); the update" in text


def test_a_program_that_does_not_say_what_is_measured(fakes, no_chart):
    result = compare(fakes, "--experiment", "voxeliser", environment=no_chart)
    assert result.returncode == 1 and "does not say 'made in" in result.stderr


def test_what_a_program_says_counts_in_place_of_its_frames(fakes, no_chart):
    for step in STEPS:
        program = fakes / step
        program.write_text(program.read_text() + 'print("made in 12.5 ms")\n')
    assert compare(fakes, "--experiment", "voxeliser", environment=no_chart).returncode == 0
    text = (fakes.parent / "comparison" / "voxeliser.md").read_text()
    assert "| step05_collision | voxels | on the GPU | 256 | 12.50 | 12.50 | ±0 % |  |" in text
    assert "in 12.5 ms on the CPU and in 12.5 ms on the GPU (+0 %, no more than" in text
    assert "fps" not in text and "snowfall was still" not in text


def test_parts_are_those_that_the_program_lists_as_on(fakes):
    assert compare(fakes, "--experiment", "parts", "--counts", 999, "--frames", 1).returncode == 0
    frames = frames_of(fakes.parent / "comparison" / "parts.csv")
    assert [(row["line"], row["options"], row["median_ms"]) for row in frames] == 3 * [
        ("all parts", "", "6.0000"), ("without fog", "--set fog=0", "2.0000"),
        ("without sparkle", "--set sparkle=0", "6.0000")]
    text = (fakes.parent / "comparison" / "parts.md").read_text()
    assert ("with all parts; without fog -4.00 ms; no more than from repeat to repeat: "
            "without sparkle +0.00 ms.") in text
    assert ("| step06_accumulation | plain | without fog | 999 | 2.00 | 2.00 | 500 | ±0 % | 0.33 "
            "| -4.00 |") in text
    assert is_png(fakes.parent / "comparison" / "parts.png")


# ---- Tables of many computers, merged.

def table(renderer="llvmpipe", processor="Chip, 2 cores", experiment="compare", size="64,48", factor=1):
    """What one of them might have written: two steps, two numbers of flakes, two repeats."""
    header = ("experiment,line,x,step,variant,options,particles,width,height,renderer,processor,"
              "repeat,stage,clock,frames,median_ms,p95_ms\n")
    return header + "".join(
        f'{experiment},{number} {step[7:]},{x},{step},plain,,{x},{size},"{renderer}","{processor}",'
        f"{repeat},{stage},{clock},9,{factor * (number * x / 100 + repeat)},{factor * x}\n"
        for number, step in enumerate(STEPS[:2], 1) for x in (100, 1000) for repeat in (0, 1)
        for stage, clock in (("frame", "swap"), ("draw", "cpu")))


def merge(folder, *tables, environment=None):
    paths = []
    for number, content in enumerate(tables):
        paths.append(folder / f"{number}.csv")
        if content is not None:
            paths[-1].write_bytes(content if isinstance(content, bytes) else content.encode())
    (folder / "build").mkdir(exist_ok=True)
    return compare(folder / "build", "--merge", *paths, environment=environment)


def test_merge(tmp_path):
    result = merge(tmp_path, table("Card, fast"), table("Card, slow", factor=3),
                   table("Card, slow", factor=4))
    assert result.returncode == 0, result.stderr
    folder = tmp_path / "comparison"
    assert sorted(path.name for path in folder.iterdir()) == ["compare-merged.md", "compare-merged.png"]
    assert is_png(folder / "compare-merged.png")
    text = (folder / "compare-merged.md").read_text()
    assert "- Computer 1: Card, fast; Chip, 2 cores\n- Computer 2: Card, slow; Chip" in text
    assert "- Computer 3: Card, slow; Chip" in text  # another of the same make
    # Two repeats of 10 and 11 ms, thrice as long on the second computer.
    assert ("| step01_cpu_points | plain | 1 cpu_points, computer 1 | 1,000 | 10.50 | 1000.00 | 95 "
            "| ±5 % | CPU: draw 10.50 |") in text
    assert "| 1 cpu_points, computer 2 | 1,000 | 31.50 | 3000.00 |" in text
    assert "| 2 vbo, computer 3 | 100 | 10.00 |" in text


def test_what_was_measured_can_be_merged(fakes, no_chart):
    for name in ("a", "b"):
        assert compare(fakes, "--steps", 1, "--counts", 10, "--out", fakes.parent / name,
                       environment=no_chart).returncode == 0
    result = compare(fakes, "--merge", fakes.parent / "a" / "compare.csv",
                     fakes.parent / "b" / "compare.csv", environment=no_chart)
    assert result.returncode == 0, result.stderr
    assert written(fakes) == ["compare-merged.md"]
    text = (fakes.parent / "comparison" / "compare-merged.md").read_text()
    processor, = re.findall(r"- Processor: (.*)", (fakes.parent / "a" / "compare.md").read_text())
    assert f"Computer 2: llvmpipe (LLVM 15, 256 bits) (software rendering); {processor}\n" in text


@pytest.mark.parametrize("other, says", [
    (None, "1.csv: No such file"),
    ("", "1.csv is no table of this compare.py: it has no column 'experiment'"),
    (table().replace("processor", "cpu"), "1.csv is no table of this compare.py: it has no column 'proc"),
    (table().partition("\n")[0] + "\n", "1.csv holds no frame times"),
    (table().replace("frame,", "scene,"), "1.csv holds no frame times"),
    (table() + "compare,what?\n", "1.csv, line 18: malformed CSV"),
    (table().replace(",1000,", ",many,", 1), "1.csv, line 6: malformed CSV"),
    (table().replace(",1000\n", ",nan\n", 1), "1.csv, line 6: malformed CSV"),
    (table() + "\"compare", "1.csv, line 17: malformed CSV"),
    (b"\x89PNG\r\n\x1a\n\0\xff", "1.csv"),
    (table(experiment="loops"), "1.csv is of the experiment 'loops', "),
    (table(size="640,480"), "1.csv was measured in a window of 640x480, "),
], ids=range(12))
def test_tables_that_cannot_be_merged(tmp_path, no_chart, other, says):
    result = merge(tmp_path, table(), other, environment=no_chart)
    assert result.returncode == 1 and result.stderr.count("\n") == 1
    assert says in result.stderr
    assert not (tmp_path / "comparison").exists()


def test_merging_what_nobody_knows(tmp_path, no_chart):
    result = merge(tmp_path, table(experiment="luck"), environment=no_chart)
    assert result.returncode == 1 and result.stderr.count("\n") == 1 and "'luck'" in result.stderr


@pytest.mark.parametrize("triangles", [12, 100, 800, 1000, 10000, 70000])
def test_height_fields_have_as_many_triangles_as_they_should(tmp_path, triangles):
    code = f"import pathlib, experiments as e; e.hills(pathlib.Path('{tmp_path}'), {triangles})"
    subprocess.run([sys.executable, "-B", "-c", code], cwd=COMPARE.parent, check=True)
    path, = tmp_path.iterdir()
    lines = [line.split() for line in path.read_text().splitlines()]
    points = [line for line in lines if line[0] == "v"]
    faces = [line for line in lines if line[0] == "f"]
    assert len(faces) == triangles
    corners = {int(corner) for face in faces for corner in face[1:]}
    assert corners == set(range(1, len(points) + 1))


# ---- The real programs.

def test_the_programs(real_build, tmp_path):
    result = compare(real_build, "--frames", 2, "--warmup", 2, "--counts", "10,50", "--repeats", 1,
                     "--size", "64x64", "--variants", "1:hexagons,2:orphan", "--out", tmp_path)
    assert result.returncode == 0, result.stderr
    assert "failed" not in result.stderr
    frames = frames_of(tmp_path / "compare.csv")
    assert len(frames) == (6 + 1 + 2) * 2
    for row in frames:
        assert (row["frames"], row["width"], row["height"]) == ("2", "64", "64")
        assert 0 < float(row["median_ms"]) <= float(row["p95_ms"])
    stages = {(row["step"], row["stage"]) for row in rows(tmp_path / "compare.csv")}
    assert {(STEPS[0], "draw"), (STEPS[1], "upload"), (STEPS[4], "scene")} < stages
    assert is_png(tmp_path / "compare.png")


@pytest.mark.parametrize("experiment", EXPERIMENTS)
def test_the_experiments(real_build, tmp_path, experiment):
    # Or they take the longest by far.
    few = ["--counts", 50] if experiment in ("parts", "threads", "feedback-or-compute") else []
    result = compare(real_build, "--experiment", experiment, "--frames", 1, "--warmup", 1,
                     "--repeats", 1, "--size", "320x240", "--out", tmp_path, *few)
    assert result.returncode == 0, result.stderr
    assert "failed" not in result.stderr
    text = (tmp_path / f"{experiment}.md").read_text()
    assert "**The source:** " in text
    assert "**Here:** " in text and "too little" not in text
    assert is_png(tmp_path / f"{experiment}.png")
