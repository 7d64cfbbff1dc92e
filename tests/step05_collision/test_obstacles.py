"""Other triangles to land on than to draw (--collision), and voxels made on the GPU."""

import pytest

import scenes
from conftest import fails_with_one_line, small

STEP = "step05_collision"
# A stage in the middle of the floor, 2 m high.
STAGE = scenes.text(scenes.quad((-4, 2, -4), (-4, 2, 4), (4, 2, 4), (4, 2, -4)))
FAST = ["--voxels", 64, "--particles", 2000, "--timelapse", 60, "--frames", 8,
        "--set", "speed_0=4", "--set", "speed_1=6"]


@pytest.fixture
def obj(tmp_path):
    def obj(name, text):
        path = tmp_path / name
        path.write_text(text)
        return path
    return obj


def moved(text):
    """The same in centimetres, and far from its origin."""
    lines = (line.split() for line in text.splitlines())
    return "\n".join(" ".join([words[0], *(str(100 * float(x) + 5000) for x in words[1:])]
                              if words and words[0] == "v" else words) for words in lines) + "\n"


@pytest.mark.parametrize("step, variant", [(STEP, "voxels"), (STEP, "triangles"),
                                           ("step06_accumulation", "cells"), ("step06_accumulation", "heightmap")])
def test_flakes_land_on_what_is_given_where_it_lies(programs, obj, step, variant):
    floor = obj("floor.obj", moved(scenes.text(scenes.FLOOR)))
    stage = obj("stage.obj", moved(STAGE))
    flakes = programs.flakes(step, *FAST, "--variant", variant, "--scene", floor,
                             "--collision", stage)
    x, y, z = flakes.position[flakes.rest > 0].T
    over_it = (abs(x) < 3) & (abs(z) < 3)  # turbulence takes none a metre in below it
    assert over_it.sum() > 50
    # As high as a voxel at most; it is scaled as the floor is, which lies at y = 0.
    assert ((y[over_it] > 1.99) & (y[over_it] < 2.2)).all()


def test_what_is_drawn_stays(programs, obj):
    """Seen from so near that the bare ground, which is where no obstacle is, does not come into view."""
    with_stage, without = (programs.picture(STEP, *small(STEP), "--frames", 1, "--particles", 0, *more,
                                            "--camera", "41,40,4")
                           for more in (["--collision", obj("stage.obj", STAGE)], []))
    assert (with_stage == without).all()


@pytest.mark.parametrize("text, reason", [
    ("", "no faces"), ("v 1e4 0 0\nv 1e4 0 1\nv 1e4 1 1\nf 1 2 3\n", "same coordinates"), (None, "cannot read")])
def test_a_bad_one_is_refused(programs, obj, tmp_path, text, reason):
    path = tmp_path / "bad.obj" if text is None else obj("bad.obj", text)
    result = programs.run(STEP, *small(STEP), "--frames", 1, "--collision", path)
    assert fails_with_one_line(result, 1, path, reason)


@pytest.mark.parametrize("step, variant", [(STEP, "voxels"), ("step06_accumulation", "cells"), ("step06_accumulation", "heightmap")])
def test_voxels_of_the_gpu_catch_the_same_flakes(programs, step, variant):
    cpu, gpu = (programs.flakes(step, *FAST, "--voxeliser", voxeliser, "--variant", variant)
                for voxeliser in ("cpu", "gpu"))
    assert (cpu.rest > 0).sum() > 200
    # A voxel in a thousand may differ (voxeliser_test.cpp), and with it the flakes on it.
    assert (abs(cpu.position - gpu.position).max(axis=1) <= 0.001).mean() >= 0.998


def test_voxels_of_the_gpu_need_opengl_4_2(programs):
    """A driver that says it has less, but what step 5 needs."""
    result = programs.run(STEP, *small(STEP), "--frames", 1, "--voxeliser", "gpu",
                          environment={"MESA_GL_VERSION_OVERRIDE": "3.3COMPAT"})
    assert fails_with_one_line(result, 1, "--voxeliser gpu", "OpenGL 4.2", "--voxeliser cpu")
