"""What the programs write, and what is left when they are interrupted or short of memory."""

import os
import pathlib
import resource
import signal
import subprocess

import pytest

from conftest import PATIENCE, SMALL, STEPS, Flakes, fails_with_one_line, small, wait_until

STEP = "step01_cpu_points"
FEW = [*SMALL, "--particles", 100, "--frames", 3]


def limit_file_size():
    """As on a full disk."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)  # the write then fails instead of the process
    resource.setrlimit(resource.RLIMIT_FSIZE, (4000, 4000))


@pytest.mark.parametrize("option", ["--dump", "--screenshot", "--csv", "--record"])
def test_what_cannot_be_written_is_refused_at_once(programs, option, tmp_path):
    (tmp_path / "file").write_text("old")
    result = programs.run(STEP, *FEW, option, tmp_path / "file/file", environment={"DISPLAY": None})
    assert fails_with_one_line(result, 1, "cannot write", tmp_path / "file/file")


def test_dump_to_a_pipe(programs):
    result = programs.run_well(STEP, *FEW, "--dump", "/dev/stdout")
    assert result.stdout.count("\n") == 2 + 101  # what the program says, and the flakes


def test_one_output_that_fails_takes_no_other_with_it(programs, tmp_path):
    """The picture is larger than a file may be, the other outputs are not."""
    result = programs.run("step05_collision", "--size", "300x200", "--voxels", 32, "--frames", 3,
                          "--particles", 5, "--screenshot", tmp_path / "last.png",
                          "--dump", tmp_path / "flakes.csv", preexec_fn=limit_file_size)
    assert fails_with_one_line(result, 1, tmp_path / "last.png")
    assert len(Flakes(tmp_path / "flakes.csv").age) == 5
    assert "ledger: " in result.stdout


def start(programs, folder, *arguments):
    process = subprocess.Popen(programs.command(*arguments), cwd=folder, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    process.stdout.readline()  # it says what runs where once its window is open
    return process


def takes(process, number):
    """Does the process handle this signal itself?"""
    status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
    caught = int(status.partition("SigCgt:")[2].split()[0], 16)
    return caught >> (number - 1) & 1


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGHUP])
def test_interrupted_it_leaves_what_was_computed(programs, tmp_path, number):
    """As closing the window does, and says that it was cut short."""
    process = start(programs, tmp_path, STEP, *SMALL, "--particles", 100, "--benchmark", "--warmup", 0,
                    "--frames", 1000000000, "--csv", "times.csv", "--dump", "flakes.csv")
    wait_until(lambda: takes(process, number), "the frames to begin")
    process.send_signal(number)
    out, err = process.communicate(timeout=PATIENCE)
    assert (process.returncode, err) == (0, "")
    assert "cut short" in out
    assert len(Flakes(tmp_path / "flakes.csv").age) == 100
    assert (tmp_path / "times.csv").exists()


@pytest.mark.parametrize("step", [STEPS[0], STEPS[3], STEPS[-1]])
def test_escape_is_answered_however_many_steps_a_frame_makes(programs, tmp_path, step):
    """A thousand steps of 200,000 flakes take minutes in one frame. (Sent as a signal: it is seen where
    keys are.)"""
    process = start(programs, tmp_path, step, *small(step), "--particles", 200000, "--timelapse", 1000,
                    "--frames", 1000)
    wait_until(lambda: takes(process, signal.SIGTERM), "the frames to begin")
    process.send_signal(signal.SIGTERM)
    # A tenth of the time that the frame would take.
    process.communicate(timeout=PATIENCE / 10)
    assert process.returncode == 0


@pytest.mark.only_software("memory that is the process's own, and so can be kept short")
@pytest.mark.parametrize("step", ["step03_shader_points", "step04_transform_feedback", "step05_collision"])
def test_memory_that_is_short(programs, step):
    """Nothing is computed with what is not there."""
    def limit_memory():
        resource.setrlimit(resource.RLIMIT_AS, (1_200_000_000, 1_200_000_000))

    result = programs.run(step, *small(step), "--particles", 12_000_000, "--frames", 2, preexec_fn=limit_memory)
    assert fails_with_one_line(result, 1, "not enough memory", "--particles", "--voxels")


def test_a_display_that_goes_is_told(programs, tmp_path):
    """X ends all its programs: then the dump is lost, and the user should know."""
    reader, writer = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", "640x480x24"],
                              pass_fds=[writer], stderr=subprocess.DEVNULL)
    os.close(writer)
    with os.fdopen(reader) as numbers:
        display = f":{numbers.readline().strip()}"
    program = subprocess.Popen(programs.command(STEP, *SMALL, "--dump", tmp_path / "flakes.csv", "--frames", 10**8),
                               env={**os.environ, "DISPLAY": display}, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
    program.stdout.readline()
    server.kill()
    server.wait()
    _, said = program.communicate(timeout=PATIENCE)
    assert program.returncode == 1 and said.count("\n") == 1 and "display has gone" in said
