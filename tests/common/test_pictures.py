"""What is drawn: compared with a reference picture per program and variant, and without complaints
from OpenGL. After a change that is meant to be seen: pytest test_pictures.py --new-references."""

import functools

import numpy
import pytest

from conftest import STEP_VARIANTS, STEPS, WITH_SCENE, small
from pictures import check_picture, read


@functools.lru_cache(maxsize=None)
def draw(programs, step, *arguments):
    """What is drawn last with these arguments; each is run only once."""
    path = programs.folder / "picture.png"
    programs.run_well(step, "--size", "320x180", "--seed", 7, *arguments, "--screenshot", path)
    return read(path)


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
    check_picture(request, programs, f"{step}_{variant}", actual)


@pytest.mark.parametrize("step, variant", STEP_VARIANTS)
def test_opengl_has_no_complaint(programs, step, variant):
    """--debug prints every error and message of OpenGL on stderr; run_well wants that empty."""
    particles = 100 if variant == "triangles" else 2000
    programs.run_well(step, *small(step), "--debug", "--variant", variant,
                      "--particles", particles, "--frames", 60)


@pytest.mark.parametrize("step, variant", STEP_VARIANTS)
def test_no_draw_lacks_attribute_0(programs, tmp_path, step, variant):
    """Mesa draws all the same; not every driver does, in a compatibility context."""
    counts = tmp_path / "draws"
    programs.run_well(step, *small(step), "--variant", variant, "--frames", 2,
                      environment={**programs.preloaded("check_draws"), "DRAWS_FILE": str(counts)})
    unfed, draws = map(int, counts.read_text().split())
    assert unfed == 0 and (draws > 0 or step == "step01_cpu_points")


@pytest.mark.parametrize("step, variant", STEP_VARIANTS)
def test_flakes_are_drawn(programs, step, variant):
    """With and without flakes the pictures differ: they come from the snow, not the background."""
    shown = ["--variant", variant, *setting(step, variant)]
    with_snow = draw(programs, step, *shown)
    shown[shown.index("--particles") + 1] = 0
    without = draw(programs, step, *shown)
    assert (with_snow != without).any(axis=2).sum() > 20
    if step not in WITH_SCENE:  # nothing but the background and the lines of the ground
        lines = (without != without[0, 0]).any(axis=2)
        assert 0.01 < lines.mean() < 0.1 and len(numpy.unique(without[lines], axis=0)) == 1


def test_backgrounds_tell_the_windows_apart(programs):
    """Each step has a colour of its own, so that two windows side by side are not confused."""
    colours = {tuple(draw(programs, step, "--particles", 0, "--frames", 1,
                          *(["--scene", "none"] if step in WITH_SCENE else []))[0, 0])
               for step in STEPS}
    assert len(colours) == len(STEPS)


def test_nearer_flakes_are_larger(programs, tmp_path):
    """The size of a sprite falls with distance and grows with the window (step 3)."""
    def picture(size, diameter, particles):
        path = tmp_path / "sprites.png"
        programs.run_well("step03_shader_points", "--size", size, "--particles", particles,
                          "--frames", 600, "--set", f"diameter_0={diameter}",
                          "--set", f"diameter_1={diameter}", "--screenshot", path)
        return read(path)

    def share_covered(size, diameter):
        change = picture(size, diameter, 500) - picture(size, diameter, 0)
        return (abs(change).max(axis=2) > 8).mean()

    small, large = share_covered("320x180", 0.2), share_covered("320x180", 0.4)
    assert 2 < large / small < 4.5  # area grows with the square; overlaps take some of it
    # The same picture with more pixels: the same share is covered, save for the edges.
    assert share_covered("640x360", 0.4) == pytest.approx(large, rel=0.15)
