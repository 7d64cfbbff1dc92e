"""Bad input, bad surroundings: one clear line on stderr, and a status that says whose fault."""

import random
import re
import resource
import signal
import subprocess

import pytest

from conftest import SMALL, STEPS, WITH_SCENE, fails_with_one_line, small

CANNOT_RUN, BAD_USAGE = 1, 2

BAD_ARGUMENTS = [
    "--particles -1", "--particles abc", "--particles 1000000000000", "--particles", "--particles=",
    "--particles 1e3", "--particles 50000001", "--particles 1 --particles 2",
    "--size 0x0", "--size 10", "--size 10x", "--size x10", "--size 10x10x10", "--size -5x5",
    "--size 10x99999", "--size 10x99999999999", "--frames -1", "--frames 1.5", "--frames abc",
    "--frames 99999999999", "--warmup -1", "--seed -1", "--seed x", "--variant none",
    "--weather sun", "--set gravity", "--set gravity=", "--set gravity=abc", "--set gravity=nan",
    "--set gravity=inf", "--set wind_x=1e9", "--set nonsense=1", "--set =1", "--nonsense",
    "nonsense", "--dump", "--screenshot", "--record", "--timelapse 0", "--timelapse 1001",
    "--timelapse 1.5", "--camera", "--camera 1,2", "--camera 1,2,3,4", "--camera 1,2,x",
    "--camera 1;2;3", "--camera 0,89,10", "--camera 0,10,0", "--camera nan,10,10",
    "--camera 0,inf,10",
]
BAD_SCENE_ARGUMENTS = ["--voxels 0", "--voxels 7", "--voxels 100000", "--voxels -64", "--voxels 48",
                       "--voxels abc", "--up x", "--scene"]


@pytest.mark.parametrize("step", STEPS)
@pytest.mark.parametrize("arguments", BAD_ARGUMENTS)
def test_bad_usage(programs, step, arguments):
    """Found without opening a window: on a machine with no display as well."""
    result = programs.run(step, *arguments.split(), environment={"DISPLAY": None})
    assert fails_with_one_line(result, BAD_USAGE, "--help")


OPTIONS = ["--particles", "--variant", "--weather", "--set", "--scene", "--up", "--metres", "--voxels",
           "--follow", "--groups", "--point-size", "--hold-fps", "--seed", "--size", "--camera", "--tour",
           "--vsync", "--frames", "--warmup", "--timelapse", "--benchmark", "--csv", "--realtime",
           "--record", "--screenshot", "--dump", "--dump-cover", "--debug", "-x", "--", "-"]
VALUES = ["", "0", "1", "-1", "64", "1e9", "nan", "inf", "4294967296", "99999999999999999999", "0x10",
          "64x64", "1x", "41,15,17", ",,", "wind_x=3", "wind_x", "=", "gravity=-0", "snow", "none",
          "two words", "\u00e4\u2603", "%s%n", "--frames", "y", "'", "a.png", "no/such/folder/file",
          "\x01", "x" * 5000]


@pytest.mark.parametrize("step", STEPS)
def test_any_command_line_is_understood_or_refused(programs, step, tmp_path):
    """A thousand for all the programs together. Without a display none gets further than to a
    window, and none may crash, hang, or say more than one line."""
    choose = random.Random(step)
    for _ in range(1000 // len(STEPS) + 1):
        arguments = []
        for _ in range(choose.randrange(5)):
            arguments.append(choose.choice(OPTIONS))
            arguments += choose.choices(VALUES, k=choose.choice([0, 1, 1, 1, 2]))
        result = programs.run(step, *arguments, environment={"DISPLAY": None}, cwd=tmp_path)
        assert result.returncode in (CANNOT_RUN, BAD_USAGE), arguments
        assert fails_with_one_line(result, result.returncode), arguments


@pytest.mark.parametrize("step", WITH_SCENE)
@pytest.mark.parametrize("arguments", BAD_SCENE_ARGUMENTS)
def test_bad_usage_of_scene_options(programs, step, arguments):
    result = programs.run(step, *arguments.split(), environment={"DISPLAY": None})
    assert fails_with_one_line(result, BAD_USAGE, arguments.split()[0])


@pytest.mark.parametrize("step", WITH_SCENE)
def test_a_scene_that_is_not_there(programs, step):
    """It may be a name misspelt, so the line has them all."""
    result = programs.run(step, "--scene", "moutains", environment={"DISPLAY": None})
    assert fails_with_one_line(result, CANNOT_RUN, "moutains", "courtyard", "mountains", "none")


@pytest.mark.parametrize("step", [step for step in STEPS if step not in WITH_SCENE])
@pytest.mark.parametrize("arguments", ["--scene none", "--voxels 64", "--up z", "--metres", "--follow"])
def test_an_option_a_step_cannot_honour_is_an_error(programs, step, arguments):
    result = programs.run(step, *arguments.split(), environment={"DISPLAY": None})
    assert fails_with_one_line(result, BAD_USAGE, arguments.split()[0])


@pytest.mark.parametrize("step, arguments", [
    ("step02_vbo", "nonsense"), ("step02_vbo", "stream --hint static"),
    ("step02_vbo", "static --variant arrays"), ("step02_vbo", "static --variant persistent"),
    ("step01_cpu_points", "static"), ("step03_shader_points", "static"),
])
def test_a_hint_that_nobody_takes_is_an_error(programs, step, arguments):
    """Only step 2 calls glBufferData as it is told, and not in all its variants."""
    result = programs.run(step, "--hint", *arguments.split(), environment={"DISPLAY": None})
    assert fails_with_one_line(result, BAD_USAGE, "--hint")


@pytest.mark.parametrize("variant", ["subdata", "orphan", "soa"])
@pytest.mark.parametrize("hint", ["stream", "dynamic", "static"])
def test_a_hint_changes_no_flake(programs, variant, hint):
    run = ["step02_vbo", "--particles", 500, "--frames", 30, "--variant", variant]
    assert programs.dump(*run, "--hint", hint) == programs.dump("step01_cpu_points", *run[1:5])


@pytest.mark.parametrize("variant", ["subdata", "orphan", "soa"])
@pytest.mark.parametrize("hint, usage", [("stream", 0x88E0), ("dynamic", 0x88E8), ("static", 0x88E4)])
def test_a_hint_is_what_opengl_is_told(programs, variant, hint, usage):
    """GL_STREAM_DRAW and so on, each time that the buffer gets storage: with "orphan" in each frame, too."""
    flakes, frames = 500, 3
    told = [numbers for name, *numbers in programs.calls(
        "step02_vbo", "--variant", variant, "--hint", hint, "--particles", flakes, "--frames", frames)
        if name == "glBufferData"]
    array_buffer, size = 0x8892, flakes * (12 if variant == "soa" else 32)
    assert told == [[array_buffer, size, usage]] * (1 + frames if variant == "orphan" else 1)


@pytest.mark.parametrize("step", STEPS)
def test_help(programs, step):
    result = programs.run(step, "--help", environment={"DISPLAY": None})
    assert (result.returncode, result.stderr) == (0, "")
    for option in ("--particles", "--variant", "--weather", "--seed", "--size", "--vsync",
                   "--frames", "--warmup", "--screenshot", "--dump", "--debug", "Escape"):
        assert option in result.stdout
    assert re.search(r"^  gravity +-9.81 m/s2, .*\n  turbulence ", result.stdout, re.MULTILINE)  # a table
    assert ("--scene" in result.stdout) == ("--voxels" in result.stdout) == (step in WITH_SCENE)


@pytest.mark.only_software("its name, and a warning that it is none of a graphics card")
@pytest.mark.parametrize("step", STEPS)
def test_first_line_says_what_runs_where(programs, step):
    first, warning, *_ = programs.run_well(step, *small(step), "--frames", 1).stdout.splitlines()
    for word in (step, "llvmpipe", "OpenGL 4", "20000 flakes", "64x64", "vsync off"):
        assert word in first
    assert warning.startswith("warning") and "software" in warning


@pytest.mark.parametrize("step", STEPS)
@pytest.mark.parametrize("display", [None, ":987"])
def test_no_display(programs, step, display):
    result = programs.run(step, "--frames", 1, environment={"DISPLAY": display})
    assert fails_with_one_line(result, CANNOT_RUN, "DISPLAY")


def test_a_display_without_opengl(programs):
    with subprocess.Popen(["Xvfb", "-displayfd", "1", "-extension", "GLX"], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as server:
        display = ":" + server.stdout.readline().strip()
        result = programs.run(STEPS[0], "--frames", 1, environment={"DISPLAY": display})
        server.terminate()
    assert fails_with_one_line(result, CANNOT_RUN, "glxinfo")


@pytest.mark.only_software("it can be told to be an older OpenGL")
@pytest.mark.parametrize("step, needed, offered", [
    ("step01_cpu_points", "1.5", "1.4"),
    ("step02_vbo", "1.5", "1.4"),
    ("step03_shader_points", "3.3", "2.1"),
    ("step04_transform_feedback", "3.3", "3.2"),
    ("step05_collision", "3.3", "3.0"),
    ("step06_accumulation", "4.3", "4.2"),
])
def test_opengl_too_old(programs, step, needed, offered):
    result = programs.run(step, "--frames", 1,
                          environment={"MESA_GL_VERSION_OVERRIDE": offered + "COMPAT"})
    assert fails_with_one_line(result, CANNOT_RUN, f"needs OpenGL {needed}", f"this is {offered}")


@pytest.mark.parametrize("option", ["--dump", "--screenshot"])
@pytest.mark.parametrize("step", STEPS)
def test_output_in_a_folder_that_does_not_exist(programs, step, option, tmp_path):
    path = tmp_path / "no" / "such" / "file"
    result = programs.run(step, *small(step), "--frames", 1, option, path)
    assert fails_with_one_line(result, CANNOT_RUN, path)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("option", ["--dump", "--screenshot"])
def test_output_that_is_a_folder(programs, option, tmp_path):
    result = programs.run("step01_cpu_points", *SMALL, "--frames", 1, option, tmp_path)
    assert fails_with_one_line(result, CANNOT_RUN, tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_record_into_what_is_no_folder(programs, tmp_path):
    (tmp_path / "file").write_text("old")
    result = programs.run("step01_cpu_points", *SMALL, "--frames", 1, "--record", tmp_path / "file")
    assert fails_with_one_line(result, CANNOT_RUN, tmp_path / "file")


@pytest.mark.parametrize("step", STEPS)
@pytest.mark.parametrize("option", ["--dump", "--screenshot"])
def test_write_that_fails_midway_leaves_nothing(programs, step, option, tmp_path):
    """As on a full disk: a limit on the size of files breaks off the write."""
    def limit_file_size():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)  # the write then fails instead of the process
        resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))

    # An old file of that name must survive, whole.
    path = tmp_path / "file"
    path.write_text("old")
    result = programs.run(step, "--size", "300x200", "--frames", 30, option, path,
                          preexec_fn=limit_file_size)
    assert fails_with_one_line(result, CANNOT_RUN, path)
    assert [file.name for file in tmp_path.iterdir()] == ["file"]
    assert path.read_text() == "old"


@pytest.mark.parametrize("option", ["--dump", "--screenshot"])
def test_outputs_may_be_links(programs, option, tmp_path):
    """What a link points to is replaced, never the link: it may be /dev/null."""
    (tmp_path / "link").symlink_to(tmp_path / "target")
    programs.run_well("step01_cpu_points", *SMALL, "--frames", 1, option, tmp_path / "link")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "target").stat().st_size > 100


@pytest.mark.parametrize("step", STEPS)
def test_runs_from_any_folder_and_writes_only_what_was_asked_for(programs, step, tmp_path):
    programs.run_well(step, *small(step), "--frames", 1, "--dump", "flakes.csv", cwd=tmp_path)
    assert [file.name for file in tmp_path.iterdir()] == ["flakes.csv"]
    programs.run_well(step, *small(step), "--frames", 1, cwd="/")
