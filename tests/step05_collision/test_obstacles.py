"""Other triangles to land on than to draw (--collision), and voxels made on the GPU."""

import pytest

import scenes
from conftest import SMALL, WITH_SCENE, Flakes, fails_with_one_line, small
from reports import ledger

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


def moved(text, factor, offset):
    """The same in other coordinates."""
    lines = (line.split() for line in text.splitlines())
    return "\n".join(" ".join([words[0], *(str(factor * float(x) + offset) for x in words[1:])]
                              if words and words[0] == "v" else words) for words in lines) + "\n"


@pytest.mark.parametrize("step, variant", [(STEP, "voxels"), (STEP, "triangles"),
                                           ("step06_accumulation", "cells")])
@pytest.mark.parametrize("factor, offset", [(1, 0), (100, 5000)])
def test_flakes_land_on_what_is_given_where_it_lies(programs, obj, step, variant, factor, offset):
    floor = obj("floor.obj", moved(scenes.text(scenes.FLOOR), factor, offset))
    stage = obj("stage.obj", moved(STAGE, factor, offset))
    flakes = programs.flakes(step, *FAST, "--variant", variant, "--scene", floor,
                             "--collision", stage)
    x, y, z = flakes.position[flakes.rest > 0].T
    over_it = (abs(x) < 3) & (abs(z) < 3)  # turbulence takes none a metre in below it
    assert over_it.sum() > 50
    # As high as a voxel at most; it is scaled as the floor is, which lies at y = 0.
    assert ((y[over_it] > 1.99) & (y[over_it] < 2.2)).all()


def test_what_is_drawn_stays(programs, obj, tmp_path):
    """Seen from so near that the bare ground, which is where no obstacle is, does not come into view."""
    stage = obj("stage.obj", STAGE)
    for name, more in ("with", ["--collision", stage]), ("without", []):
        programs.run_well(STEP, *small(STEP), "--frames", 1, "--particles", 0, *more,
                          "--camera", "41,40,4",
                          "--screenshot", tmp_path / f"{name}.png")
    assert (tmp_path / "with.png").read_bytes() == (tmp_path / "without.png").read_bytes()


def test_it_may_be_the_only_scene(programs, obj):
    flakes = programs.flakes(STEP, *FAST, "--scene", "none", "--collision",
                             obj("stage.obj", moved(STAGE, 1000, 0)))
    assert (flakes.rest > 0).sum() > 100


@pytest.mark.parametrize("step", WITH_SCENE)
@pytest.mark.parametrize("text, reason", [
    ("v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no faces"), ("", "no faces"), ("f 1 2 3\n", "unknown vertex"),
    ("v 1e4 0 0\nv 1e4 0 1\nv 1e4 1 1\nf 1 2 3\n", "same coordinates"),
    ("v 1e300 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n", "same coordinates"), (None, "cannot read")])
def test_a_bad_one_is_refused(programs, obj, tmp_path, step, text, reason):
    path = tmp_path / "bad.obj" if text is None else obj("bad.obj", text)
    result = programs.run(step, *small(step), "--frames", 1, "--collision", path)
    assert fails_with_one_line(result, 1, path, reason)


@pytest.mark.parametrize("step", WITH_SCENE)
def test_voxels_of_the_gpu_catch_the_same_flakes(programs, tmp_path, step):
    dumps = []
    variant = "voxels" if step == STEP else "cells"
    for voxeliser in "cpu", "gpu":
        dumps.append(tmp_path / f"{voxeliser}.csv")
        result = programs.run_well(step, *SMALL, *FAST, "--voxeliser", voxeliser, "--dump", dumps[-1],
                                   "--variant", variant)
        assert f"--voxeliser {voxeliser}" in result.stdout and ledger(result.stdout)["released"] > 0
    cpu, gpu = map(Flakes, dumps)
    assert (cpu.rest > 0).sum() > 200
    # A voxel in a thousand may differ (voxeliser_test.cpp), and with it the flakes on it.
    assert (abs(cpu.position - gpu.position).max(axis=1) <= 0.001).mean() >= 0.998


def test_voxels_of_the_gpu_need_opengl_4_2(programs):
    """A driver that says it has less, but what step 5 needs."""
    result = programs.run(STEP, *small(STEP), "--frames", 1, "--voxeliser", "gpu",
                          environment={"MESA_GL_VERSION_OVERRIDE": "3.3COMPAT"})
    assert fails_with_one_line(result, 1, "--voxeliser gpu", "OpenGL 4.2", "--voxeliser cpu")


def test_an_unknown_voxeliser_is_refused(programs):
    result = programs.run(STEP, *small(STEP), "--voxeliser", "nonsense")
    assert fails_with_one_line(result, 2, "--voxeliser", "nonsense")
