"""Scenes as users name them and as they are seen. What files may hold, scene_test.cpp tests."""

import numpy
import pytest

import scenes
from pictures import read

STEP = "step05_collision"
DRAWN = [(STEP, "voxels"), ("step06_accumulation", "cells"), ("step06_accumulation", "winter")]
HAIL = ["--weather", "hail", "--set", "melt_time=1", "--set", "snowfall=5", "--timelapse", 120]


@pytest.fixture
def draw(programs, tmp_path):
    """What a step draws of a scene, without snow unless there are particles, and what it says on stderr."""
    def draw(path, *arguments, step=STEP, particles=0, frames=1, **more):
        picture = tmp_path / "picture.png"
        result = programs.run(step, "--size", "160x90", "--particles", particles, "--voxels", 32, "--frames", frames,
                              "--scene", path, "--screenshot", picture, *arguments, **more)
        assert result.returncode == 0, result.stderr
        return read(picture), result.stderr
    return draw


def test_a_bare_name_has_its_materials(draw, tmp_path):
    (tmp_path / "scene.obj").write_text("mtllib scene.mtl\nusemtl brick\n" + scenes.text(scenes.FLOOR))
    (tmp_path / "scene.mtl").write_text("newmtl brick\nKd 0.8 0.1 0.1\n")
    picture, errors = draw("scene.obj", cwd=tmp_path)
    red, green, _ = picture[45, 80]
    assert red > green + 40 and errors == ""


SHEET = scenes.text(scenes.quad((-8, 5, -8), (-8, 5, 8), (8, 5, 8), (8, 5, -8)),
                    scenes.quad((0, 0, 0), (0, 0, 0.1), (0.1, 0, 0.1)))


@pytest.mark.parametrize("step, variant", DRAWN)
def test_a_sheet_is_dark_from_below(draw, tmp_path, step, variant):
    """Open to both sides, and lit from above: its normals point up, also where one sees it from below."""
    path = tmp_path / "sheet.obj"
    path.write_text(SHEET)
    def middle(camera, row):
        picture, _ = draw(path, "--camera", camera, "--variant", variant, step=step)
        return picture[row, 80].mean()
    above, below = middle("41,80,20", 45), middle("41,-2,9", 5)
    # From below falls less than a fifth of the light that comes from the sun and the whole sky; on
    # the screen, with its gamma of 2.2, that is less than half.
    assert below < 0.5 * above


@pytest.mark.parametrize("step, variant", DRAWN)
def test_the_ground_beside_a_scene_is_drawn_and_whitens(draw, tmp_path, step, variant):
    """A slab over bare ground. Snow lies on the ground around it, from step 6 on for good."""
    path = tmp_path / "slab.obj"
    path.write_text(scenes.text(scenes.quad((-2, 2, -2), (-2, 2, 2), (2, 2, 2), (2, 2, -2)),
                                scenes.quad((-8, 0, -8), (-8, 0, -7.9), (-7.9, 0, -8)),
                                scenes.quad((8, 0, 8), (8, 0, 7.9), (7.9, 0, 8))))
    look = ["--camera", "0,80,25", "--variant", variant]

    def ground(*arguments, **more):
        """The colour some metres before the slab, where flakes cover the least part of it."""
        picture, _ = draw(path, *look, *arguments, step=step, **more)
        colour = numpy.median(picture[65:75, 40:120], axis=(0, 1))
        if variant != "winter":  # which draws a field all around
            assert abs(colour - picture[0, 0]).max() > 10
        return colour

    bare = ground()
    snowed = ground(*HAIL, particles=2000, frames=10)  # 20 s
    if step == "step06_accumulation":
        assert snowed.mean() > bare.mean() + 30
    else:
        assert abs(snowed - bare).max() < 5


def test_snow_lies_on_whatever_faces_the_wrong_way(draw, tmp_path):
    path, pictures = tmp_path / "scene.obj", []
    lines = (scenes.FLOOR + scenes.quad((-6, 2, -3), (-6, 2, 3), (-1, 2, 3), (-1, 2, -3))
             + scenes.box((1, 1, -3), (6, 2, 3)))
    turned = [" ".join(["f", *line.split()[:0:-1]]) if line[0] == "f" else line for line in lines]
    for faces in lines, turned:
        path.write_text(scenes.text(faces))
        pictures.append(draw(path, "--camera", "0,60,20", *HAIL, step="step06_accumulation",
                             particles=2000, frames=10)[0])
    assert pictures[0][40:50, 40:120].mean() > 120
    assert (abs(pictures[0] - pictures[1]).max(axis=2) > 8).sum() <= 3  # pixels, along edges
