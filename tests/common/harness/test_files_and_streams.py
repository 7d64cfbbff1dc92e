"""Where the programs write: to files, whole or not at all, to pipes and devices, and to streams that are
closed or full. And what is left when they are interrupted."""

import os
import resource
import signal
import subprocess
import threading

import pytest

from conftest import PATIENCE, SMALL, STEPS, VARIANTS, Flakes, fails_with_one_line, small

STEP = "step01_cpu_points"
FEW = [*SMALL, "--particles", 100, "--frames", 3]


def test_dump_to_a_pipe(programs):
    result = programs.run_well(STEP, *FEW, "--dump", "/dev/stdout")
    assert result.stdout.count("\n") == 2 + 101  # what the program says, and the flakes


def test_dump_to_a_log_goes_on_behind_what_is_there(programs, tmp_path):
    log = tmp_path / "log"
    log.write_text("old\n")
    with open(log, "a") as file:
        subprocess.run(programs.command(STEP, *FEW, "--dump", "/dev/stdout"), check=True, stdout=file)
    lines = log.read_text().splitlines()
    assert lines[0] == "old" and len(lines) == 1 + 2 + 101


def test_dump_to_a_fifo(programs, tmp_path):
    fifo = tmp_path / "fifo"
    os.mkfifo(fifo)
    read = []
    reader = threading.Thread(target=lambda: read.append(fifo.read_text()), daemon=True)
    reader.start()
    programs.run_well(STEP, *FEW, "--dump", fifo)
    reader.join(PATIENCE)
    assert read[0].count("\n") == 101


@pytest.mark.parametrize("step", [STEP, "step05_collision"])
def test_closed_standard_output(programs, step, tmp_path):
    """The next file opened must not become descriptor 1: that would be the connection to the display."""
    command = programs.command(step, *small(step), "--frames", 3, "--dump", tmp_path / "flakes.csv")
    result = subprocess.run(["sh", "-c", 'exec "$@" >&-', "sh", *command], timeout=PATIENCE,
                            check=False, stderr=subprocess.PIPE)
    assert (result.returncode, result.stderr) == (0, b"")
    assert (tmp_path / "flakes.csv").exists()


def test_full_standard_output_is_an_error(programs):
    with open("/dev/full", "w") as full:
        result = subprocess.run(programs.command(STEP, *FEW, "--benchmark", "--warmup", 0), stdout=full,
                                stderr=subprocess.PIPE, text=True, check=False)
    assert fails_with_one_line(result, 1, "standard output")


def test_a_file_of_the_users_is_not_taken_for_one_of_ours(programs, tmp_path):
    (tmp_path / "flakes.csv.part").write_text("mine")
    programs.run_well(STEP, *FEW, "--dump", tmp_path / "flakes.csv")
    assert (tmp_path / "flakes.csv.part").read_text() == "mine"
    assert len(list(tmp_path.iterdir())) == 2


def test_one_output_that_fails_takes_no_other_with_it(programs, tmp_path):
    """The pictures are larger than a file may be, the other outputs are not."""
    def limit_file_size():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)  # the write then fails instead of the process
        resource.setrlimit(resource.RLIMIT_FSIZE, (4000, 4000))

    result = programs.run("step05_collision", "--size", "300x200", "--voxels", 32, "--frames", 3,
                          "--particles", 5, "--screenshot", tmp_path / "last.png",
                          "--dump", tmp_path / "flakes.csv", preexec_fn=limit_file_size)
    assert fails_with_one_line(result, 1, tmp_path / "last.png")
    assert len(Flakes(tmp_path / "flakes.csv").age) == 5
    assert "ledger: " in result.stdout
    assert [file.name for file in tmp_path.iterdir()] == ["flakes.csv"]


@pytest.mark.parametrize("arguments", [["--dump", "a", "--csv", "a"], ["--dump", "a", "--csv", "./a"],
                                       ["--screenshot", "a", "--dump", "b/../a"]])
def test_one_file_for_two_outputs(programs, arguments, tmp_path):
    result = programs.run(STEP, *FEW, *arguments, cwd=tmp_path)
    assert fails_with_one_line(result, 2, "two outputs")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("option", ["--frames", "--seed", "--particles", "--dump", "--csv", "--weather"])
def test_an_empty_value(programs, option):
    """As of a variable in a script that was never set."""
    assert fails_with_one_line(programs.run(STEP, *SMALL, option, "", environment={"DISPLAY": None}),
                               2, option)


def test_a_picture_of_another_kind(programs):
    result = programs.run(STEP, *FEW, "--screenshot", "a.jpg", environment={"DISPLAY": None})
    assert fails_with_one_line(result, 2, ".jpg", "PNG")


def test_no_film_is_mixed_with_an_older_one(programs, tmp_path):
    programs.run_well(STEP, *FEW, "--record", tmp_path)
    before = {file.name: file.read_bytes() for file in tmp_path.iterdir()}
    result = programs.run(STEP, *SMALL, "--frames", 1, "--record", tmp_path)
    assert fails_with_one_line(result, 1, tmp_path, "film")
    assert {file.name: file.read_bytes() for file in tmp_path.iterdir()} == before


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted_it_leaves_what_was_computed(programs, tmp_path, number):
    """As closing the window does, and says that it was cut short."""
    process = subprocess.Popen(
        programs.command(STEP, *SMALL, "--particles", 100, "--benchmark", "--warmup", 0, "--frames",
                         1000000000, "--csv", "times.csv", "--dump", "flakes.csv"),
        cwd=tmp_path, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    process.stdout.readline()  # it says what runs where once its window is open
    process.send_signal(number)
    out, err = process.communicate(timeout=PATIENCE)
    assert (process.returncode, err) == (0, "")
    assert "cut short" in out
    assert len(Flakes(tmp_path / "flakes.csv").age) == 100
    assert (tmp_path / "times.csv").exists()


@pytest.mark.parametrize("step", STEPS)
def test_escape_is_answered_however_many_steps_a_frame_makes(programs, step):
    """A thousand steps of 200,000 flakes take minutes in one frame. (Sent as a signal: it is seen where
    keys are.)"""
    process = subprocess.Popen(
        programs.command(step, *small(step), "--particles", 200000, "--timelapse", 1000, "--frames", 1000),
        text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    process.stdout.readline()
    process.send_signal(signal.SIGTERM)
    # A tenth of the time that the frame would take here; the machine may be busy.
    process.communicate(timeout=PATIENCE / 10)
    assert process.returncode == 0


@pytest.mark.only_software("memory that is the process's own, and so can be kept short")
@pytest.mark.parametrize("step", ["step03_shader_points", "step04_transform_feedback", "step05_collision"])
def test_memory_that_is_short(programs, step):
    """What is missing is said, and how much of it was needed; nothing is computed with what is not there."""
    def limit_memory():
        resource.setrlimit(resource.RLIMIT_AS, (1_200_000_000, 1_200_000_000))

    result = programs.run(step, *small(step), "--particles", 12_000_000, "--frames", 2,
                          preexec_fn=limit_memory)
    assert fails_with_one_line(result, 1, "memory", "--particles")


@pytest.mark.only_software("memory that is the process's own, and so can be kept short")
@pytest.mark.parametrize("variant", VARIANTS["step06_accumulation"])
def test_a_snow_cover_without_memory_is_refused_at_once(programs, variant):
    """Before the scene is read and voxelised, of which a line each would tell."""
    def limit_memory():
        resource.setrlimit(resource.RLIMIT_AS, (3_000_000_000, 3_000_000_000))

    result = programs.run("step06_accumulation", *SMALL, "--voxels", 1024, "--frames", 1, "--variant",
                          variant, preexec_fn=limit_memory)
    assert fails_with_one_line(result, 1, "--voxels", "snow")
    assert "scene" not in result.stdout and "voxels:" not in result.stdout
