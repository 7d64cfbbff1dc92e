"""Scenes as other programs write them and as users name them: read well, or refused in one line.
The code that reads them has its own tests, in unit/."""

import os
import subprocess
import threading

import numpy
import PIL.Image
import pytest

import scenes
from conftest import SMALL, WITH_SCENE, fails_with_one_line

STEP = "step05_collision"
SQUARE = "v -8 0 -8\nv -8 0 8\nv 8 0 8\nv 8 0 -8\n"
BRICK = "newmtl brick\nKd 0.8 0.1 0.1\n"


@pytest.fixture
def draw(programs, tmp_path):
    """What a step draws of a scene, without snow, and what it says on stderr."""
    def draw(path, *arguments, step=STEP, particles=0, frames=1, **more):
        picture = tmp_path / "picture.png"
        result = programs.run(step, "--size", "160x90", "--particles", particles,
                              "--voxels", 32, "--frames", frames, "--scene", path, "--screenshot", picture, *arguments,
                              **more)
        assert result.returncode == 0, result.stderr
        return numpy.asarray(PIL.Image.open(picture).convert("RGB")).astype(int), result.stderr
    return draw


def is_red(picture):
    red, green, _ = picture[picture.shape[0] // 2, picture.shape[1] // 2]
    return red > green + 40


def test_a_bare_name_has_its_materials(draw, tmp_path):
    (tmp_path / "scene.obj").write_text("mtllib scene.mtl\n" + SQUARE + "usemtl brick\nf 1 2 3 4\n")
    (tmp_path / "scene.mtl").write_text(BRICK)
    for name in "scene.obj", "./scene.obj", tmp_path / "scene.obj":
        picture, errors = draw(name, cwd=tmp_path)
        assert is_red(picture) and errors == ""


@pytest.mark.parametrize("step", WITH_SCENE)
def test_lost_materials_are_told_in_a_line_each_kind(draw, tmp_path, step):
    path = tmp_path / "scene.obj"
    path.write_text("mtllib none.mtl\n" + SQUARE + "usemtl brick\nf 1 2 3\nusemtl wood\nf 1 3 4\n")
    _, errors = draw(path, step=step)
    lines = errors.splitlines()
    assert len(lines) == 2
    assert all(line.startswith(f"warning: {path}: line ") for line in lines)
    assert "none.mtl" in lines[0] and "brick" in lines[1]


SHEET = scenes.text(scenes.quad((-8, 5, -8), (-8, 5, 8), (8, 5, 8), (8, 5, -8)),
                    scenes.quad((0, 0, 0), (0, 0, 0.1), (0.1, 0, 0.1)))


@pytest.mark.parametrize("step, variant", [("step05_collision", "voxels"),
                                           ("step06_accumulation", "cells"),
                                           ("step06_accumulation", "winter")])
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


@pytest.mark.parametrize("step, variant", [("step05_collision", "voxels"),
                                           ("step06_accumulation", "cells"),
                                           ("step06_accumulation", "winter")])
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
    snowed = ground("--weather", "hail", "--set", "melt_time=1", "--set", "snowfall=5",
                    "--timelapse", 120, particles=2000, frames=10)  # 20 s
    if step == "step06_accumulation":
        assert snowed.mean() > bare.mean() + 30
    else:
        assert abs(snowed - bare).max() < 5


def test_a_light_too_bright_leaves_the_night_its_colours(draw, tmp_path):
    path = tmp_path / "scene.obj"
    path.write_text("mtllib scene.mtl\n" + SQUARE + "v 0 3 0\nv 1 3 0\nv 0 4 0\n"
                    "f 1 2 3 4\nusemtl lamp\nf 5 6 7\n")
    (tmp_path / "scene.mtl").write_text("newmtl lamp\nKd 1 1 1\nKe 1e39 1e39 1e39\n")
    picture, errors = draw(path, "--set", "sun_height=-15", step="step06_accumulation")
    assert errors.count("\n") == 1 and "scene.mtl: line 3: 'Ke 1e39" in errors
    on_the_floor = picture[55:, 40:120]
    assert on_the_floor.min() > 50  # not a number would be black


def test_a_scene_far_from_its_origin_looks_the_same(draw, tmp_path):
    """Coordinates of a survey: metres from the equator, whose centimetres no float holds."""
    def stair(x, y, z):
        steps = ([scenes.quad((x + 0.4 * n, y + 0.3 * n, z), (x + 0.4 * n, y + 0.3 * n, z + 6),
                              (x + 0.4 * n + 0.4, y + 0.3 * n, z + 6),
                              (x + 0.4 * n + 0.4, y + 0.3 * n, z)) for n in range(5)])
        path = tmp_path / "stair.obj"
        path.write_text(scenes.text(*steps))
        return draw(path)[0]
    near, far = stair(0, 0, 0), stair(691500, 300, 5336200)
    assert (abs(near - far).max(axis=2) > 8).sum() <= 3  # pixels, along edges
    assert len(numpy.unique(near.reshape(-1, 3), axis=0)) > 10


def test_faces_that_run_around_the_wrong_way_or_both_look_the_same(draw, tmp_path):
    faces = [scenes.FLOOR, scenes.quad((-3, 2, -3), (-3, 2, 3), (3, 2, 3), (3, 2, -3)),
             scenes.quad((-3, 1, 4), (-3, 2, 6), (3, 2, 6), (3, 1, 4))]

    def over(face):
        return [*face[:-1], "f -1 -2 -3 -4"]

    def picture(*parts):
        path = tmp_path / "scene.obj"
        path.write_text(scenes.text(*parts))
        return draw(path)[0]

    expected = picture(*faces[:2], over(faces[2]))
    # The triangles may be cut the other way: the same plane, but for the last bit.
    for parts in ([over(face) for face in faces], [*faces, *map(over, faces)],
                  [*map(over, faces), *faces]):
        assert (abs(picture(*parts) - expected).max(axis=2) > 8).sum() <= 3


def test_a_pipe_that_ends_is_a_scene(draw, tmp_path):
    path = tmp_path / "pipe"
    os.mkfifo(path)
    writer = threading.Thread(target=path.write_text, args=(SQUARE + "f 1 2 3 4\n",))
    writer.start()
    picture, _ = draw(path)
    writer.join()
    (tmp_path / "scene.obj").write_text(SQUARE + "f 1 2 3 4\n")
    assert (picture == draw(tmp_path / "scene.obj")[0]).all()


@pytest.mark.parametrize("path", ["/dev/zero", "/dev/null", "/dev/random"])
def test_a_device_is_refused(programs, path):
    result = programs.run(STEP, *SMALL, "--frames", 1, "--scene", path)
    assert fails_with_one_line(result, 1, path)


@pytest.mark.parametrize("content", ["v 0 0 0", "\\0"])
def test_a_pipe_without_end_is_refused(programs, content):
    with subprocess.Popen(["sh", "-c", f"yes '{content}' | tr 'n' '\\n'"], stdout=subprocess.PIPE) as endless:
        result = programs.run(STEP, *SMALL, "--frames", 1, "--scene", "/dev/stdin",
                              stdin=endless.stdout)
        endless.stdout.close()
        endless.terminate()
    assert fails_with_one_line(result, 1, "/dev/stdin", "without end")


def test_materials_without_end_are_lost(draw, tmp_path):
    path = tmp_path / "scene.obj"
    path.write_text("mtllib /dev/zero\n" + SQUARE + "f 1 2 3 4\n")
    _, errors = draw(path)
    assert errors.count("\n") == 1 and "/dev/zero" in errors


BAD = {  # and the line that is at fault
    "too large": (None, "v -3e38 0 -3e38\nv -3e38 0 3e38\nv 3e38 0 3e38\nf 1 2 3\n"),
    "too small": (None, "v 0 0 0\nv 1e-38 0 0\nv 0 1e-38 0\nf 1 2 3\n"),
    "no number": (2, "v 0 0 0\nv 0x10 0 0\nv 0 1 0\nf 1 2 3\n"),
    "old Mac": (3, "v 0 0 0\rv 1 0 0\rv 0 y 0\rf 1 2 3\r"),
    "joined lines": (5, "v 0 0 \\\n0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n 4\n"),
    "byte order mark": (1, "\ufefff 1 2\n"),
    "UTF-16": (None, "\ufeffv 0 0 0\n".encode("utf-16")),
    "escape": (1, "v \x1b[31m 0 0\n"),
    "long word": (1, f"v {'x' * 10000} 0 0\n"),
}


@pytest.mark.parametrize("kind", BAD)
def test_bad_scene(programs, tmp_path, kind):
    line, content = BAD[kind]
    path = tmp_path / "bad.obj"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    result = programs.run(STEP, *SMALL, "--frames", 1, "--scene", path)
    assert fails_with_one_line(result, 1, path, f"line {line}: " if line else "")
    assert len(result.stderr) < 300 and "\x1b" not in result.stderr
