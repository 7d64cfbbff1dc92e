"""What is drawn: compared with a reference picture per program and variant, and without complaints
from OpenGL. After a change that is meant to be seen: pytest test_pictures.py --new-references."""

import pytest

from conftest import STEP_VARIANTS, STEPS, WITH_SCENE
from pictures import check_picture


def draw(programs, step, *arguments):
    return programs.picture(step, "--size", "320x180", "--seed", 7, *arguments)


def setting(step, variant):
    """Enough snow to see each flake's shape, and time enough for some to land."""
    if variant == "triangles":
        return [*steps(100), "--particles", 100, "--weather", "hail"]
    if step == "step06_accumulation":
        return [*steps(150), "--particles", 5000, "--weather", "hail", "--voxels", 128,
                "--set", "melt_time=0.3", "--set", "snowfall=3"]
    if step == "step05_collision":
        return [*steps(150), "--particles", 8000, "--set", "speed_0=4", "--set", "speed_1=6"]
    if step in ("step03_shader_points", "step04_transform_feedback"):  # large, to see their shape
        return [*steps(500), "--particles", 800, "--set", "diameter_0=0.5", "--set", "diameter_1=1"]
    return [*steps(500), "--particles", 5000]


def steps(count):
    """So many steps of physics in five frames: only the last of them is looked at."""
    return ["--timelapse", count // 5, "--frames", 5]


@pytest.mark.parametrize("step, variant", STEP_VARIANTS)
def test_picture(request, programs, step, variant):
    actual = draw(programs, step, "--variant", variant, *setting(step, variant))
    check_picture(request, f"{step}_{variant}", actual)


@pytest.mark.parametrize("step, variant", STEP_VARIANTS)
def test_opengl_has_no_complaint(programs, step, variant):
    """--debug prints every error and message of OpenGL on stderr; run_well wants that empty. And no draw lacks
    attribute 0: Mesa draws all the same; not every driver does, in a compatibility context."""
    fed = [numbers[3] for name, *numbers in programs.calls(step, "--debug", "--variant", variant, "--particles", 100,
                                                           "--frames", 9) if name == "glDrawArrays"]
    assert all(fed) and (fed or step == "step01_cpu_points")


def test_backgrounds_tell_the_windows_apart(programs):
    """Each step has a colour of its own, so that two windows side by side are not confused."""
    colours = {tuple(draw(programs, step, "--particles", 0, "--frames", 1,
                          *(["--scene", "none"] if step in WITH_SCENE else []))[0, 0])
               for step in STEPS}
    assert len(colours) == len(STEPS)
