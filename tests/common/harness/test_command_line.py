"""Bad input, bad surroundings: one clear line on stderr, and a status that says whose fault."""

import re
import subprocess

import pytest

from conftest import STEPS, WITH_SCENE, fails_with_one_line, small

CANNOT_RUN, BAD_USAGE = 1, 2


@pytest.mark.parametrize("arguments", ["--nonsense", "--variant none", "--particles 1 --particles 2", "--scene none",
                                       "--benchmark --vsync"])
def test_bad_usage(programs, arguments):
    """Found without opening a window: on a machine with no display as well."""
    result = programs.run(STEPS[0], *arguments.split(), environment={"DISPLAY": None})
    assert fails_with_one_line(result, BAD_USAGE, arguments.split()[0])


def test_a_scene_that_is_not_there(programs):
    """It may be a name misspelt, so the line has them all."""
    result = programs.run("step05_collision", "--scene", "moutains", environment={"DISPLAY": None})
    assert fails_with_one_line(result, CANNOT_RUN, "moutains", "courtyard", "mountains", "none")


@pytest.mark.parametrize("step", STEPS)
def test_help(programs, step):
    result = programs.run(step, "--help", environment={"DISPLAY": None})
    assert (result.returncode, result.stderr) == (0, "")
    for option in ("--particles", "--variant", "--weather", "--frames", "--dump", "(41.25,15.47,17.5)", "Escape"):
        assert option in result.stdout
    assert re.search(r"^  gravity +-9.81 m/s2, .*\n  turbulence ", result.stdout, re.MULTILINE)  # a table
    assert ("--scene" in result.stdout) == ("--voxels" in result.stdout) == (step in WITH_SCENE)


@pytest.mark.only_software("its name, and a warning that it is none of a graphics card")
@pytest.mark.parametrize("step", STEPS)
def test_first_line_says_what_runs_where(programs, step):
    first, warning, *_ = programs.run_well(step, *small(step), "--frames", 1).stdout.splitlines()
    for word in step, "llvmpipe", "OpenGL 4", "20000 flakes of 0.6 MiB", "64x64", "vsync off":
        assert word in first
    assert warning.startswith("warning") and "software" in warning


def test_no_display(programs):
    result = programs.run(STEPS[0], "--frames", 1, environment={"DISPLAY": None})
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
    ("step03_shader_points", "3.3", "2.1"),
    ("step06_accumulation", "4.3", "4.2"),
])
def test_opengl_too_old(programs, step, needed, offered):
    result = programs.run(step, "--frames", 1,
                          environment={"MESA_GL_VERSION_OVERRIDE": offered + "COMPAT"})
    assert fails_with_one_line(result, CANNOT_RUN, f"needs OpenGL {needed}", offered)


@pytest.mark.only_software("it can be told to be another OpenGL")
@pytest.mark.parametrize("step", STEPS)
def test_a_core_profile_is_refused(programs, step):
    """In which steps 1 to 3 would draw nothing, and the panel in none."""
    result = programs.run(step, *small(step), "--frames", 1, environment={"MESA_GL_VERSION_OVERRIDE": "4.5FC"})
    assert fails_with_one_line(result, CANNOT_RUN, "compatibility profile")
