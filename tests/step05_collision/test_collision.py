"""Snow lands on a scene (step 5): never inside it, never below it, where the CPU says it lands."""

import re
import subprocess

import numpy
import pytest

import scenes
from conftest import SMALL, WITH_SCENE, Flakes, fails_with_one_line, small
from reports import ledger

STEP = "step05_collision"


class Voxels:
    """What tests/reference_walk.cpp leaves of a scene's voxel grid."""

    def __init__(self, path):
        numbers = numpy.fromfile(path, dtype=numpy.float32, count=4)
        self.origin, self.cell = numbers[:3].astype(float), float(numbers[3])
        self.resolution = int(numpy.fromfile(path, dtype=numpy.int32, count=1, offset=16)[0])
        words = numpy.fromfile(path, dtype=numpy.uint8, offset=20)
        n = self.resolution
        self.filled = numpy.unpackbits(words, bitorder="little").reshape(n, n, n).astype(bool)

    def cell_of(self, positions):
        return numpy.floor((positions - self.origin) / self.cell).astype(int)

    def solid(self, cells):
        inside = ((cells >= 0) & (cells < self.resolution)).all(axis=1)
        x, y, z = numpy.where(inside[:, None], cells, 0).T
        return inside & self.filled[z, y, x]


@pytest.fixture
def walk(programs, tmp_path):
    """Runs step 5 on the CPU: its flakes, and the voxels."""
    def walk(*arguments):
        path = tmp_path / "walk.csv"
        subprocess.run(programs.command("tests/reference_walk", *arguments, "--dump", path),
                       check=True, stdout=subprocess.DEVNULL)
        return Flakes(path), Voxels(f"{path}.voxels")
    return walk


@pytest.fixture
def scene(programs):
    """The path of one of the scenes of scenes.py: the same each time, so that runs are shared."""
    def scene(name):
        path = programs.folder / f"{name}.obj"
        path.write_text(getattr(scenes, name))
        return path
    return scene


# In the courtyard: soft snow, a storm that blows sleet into every corner, and hail as hard as the
# settings allow (27 m/s down).
COURTYARD = ["--particles", 8000, "--seed", 7]
WEATHERS = {
    "snow": ["--voxels", 256, "--frames", 800],
    "storm": ["--voxels", 64, "--frames", 400, "--set", "wind_x=3", "--set", "wind_z=-2",
              "--set", "turbulence=20", "--set", "speed_0=3", "--set", "speed_1=4.5"],
    "hail": ["--voxels", 256, "--frames", 300, "--weather", "hail", "--set", "wind_x=10",
             "--set", "speed_0=300", "--set", "speed_1=200", "--set", "gravity=-30",
             "--set", "melt_time=1"],
}


@pytest.mark.parametrize("weather", WEATHERS)
def test_gpu_agrees_with_the_cpu_and_with_the_grid(programs, walk, weather):
    shared = [*COURTYARD, *WEATHERS[weather]]
    expected, grid = walk(*shared)
    flakes = programs.flakes(STEP, *shared)

    # No flake is below the ground or inside what is solid: not one.
    assert numpy.isfinite(flakes.position).all()
    assert (flakes.position[:, 1] >= 0).all()
    cells = grid.cell_of(flakes.position)
    inside = grid.solid(cells) & (flakes.age >= 0)
    assert inside.sum() == 0

    # What lies, lies on something: on a solid voxel, or on the ground.
    lying = flakes.rest > 0
    assert lying.sum() > 500
    supported = grid.solid(cells - [0, 1, 0]) | (flakes.position[:, 1] == 0)
    assert supported[lying].all()

    # It landed where the CPU's landed. 0.1 % may differ: rounding sends a flake that passes
    # within a micrometre of a voxel's edge to this side of it or to the other.
    apart = numpy.linalg.norm(flakes.position - expected.position, axis=1)
    assert (apart[lying] <= 0.001).mean() >= 0.999
    assert (apart <= 0.001).mean() >= 0.999
    assert ((flakes.rest > 0) == (expected.rest > 0)).mean() >= 0.999


def snow_on(scene, variant, *arguments):
    return [STEP, "--scene", scene, "--variant", variant, "--voxels", 256, "--particles", 6000,
            "--frames", 960, *arguments]


@pytest.mark.parametrize("name", ["TABLE", "WALL"])
def test_triangles_and_voxels_land_flakes_in_the_same_place(programs, walk, scene, name):
    """Within a voxel's diagonal, for flakes that lie in both variants and were born together.

    2 % may differ: a voxel reaches up to its diagonal beyond the edge of what it stands for, so a
    flake that comes down within 6 cm outside an edge lands on the voxel there, but misses the
    triangle and lands below. The edges of these scenes are 30 m long and the world is 256 m2: that
    is 0.7 % of the flakes.
    """
    voxels = programs.flakes(*snow_on(scene(name), "voxels"))
    triangles = programs.flakes(*snow_on(scene(name), "triangles"))
    both = (voxels.rest > 0) & (triangles.rest > 0) & (abs(voxels.age - triangles.age) < 0.001)
    assert both.sum() > 500
    diagonal = numpy.sqrt(3) * 16 / 254  # m; one voxel of air on each side of 256
    apart = numpy.linalg.norm(voxels.position - triangles.position, axis=1)
    assert (apart[both] <= diagonal).mean() >= 0.98


@pytest.mark.parametrize("name", ["TABLE", "CORNERS"])
def test_boxes_around_triangles_change_nothing(programs, scene, name):
    """What they spare a flake it would not have met."""
    assert programs.dump(*snow_on(scene(name), "boxes")) == programs.dump(*snow_on(scene(name), "triangles"))


@pytest.mark.parametrize("variant", ["voxels", "triangles"])
def test_no_snow_under_a_table_but_below_its_gap(programs, scene, variant):
    """Without wind. Turbulence shakes a flake sideways by some 10 cm over the last 2 m
    (standard deviation), so 0.5 m from the edges of a plank nothing may lie."""
    flakes = programs.flakes(*snow_on(scene("TABLE"), variant))
    x, y, z = flakes.position[flakes.rest > 0].T
    on_floor = y < 0.2
    assert (on_floor & (abs(x) < 2.5) & (abs(z) > 1.0) & (abs(z) < 2.5)).sum() == 0
    assert (on_floor & (abs(x) < 2.5) & (abs(z) < 0.3)).sum() > 5
    assert (~on_floor & (abs(x) < 3) & (abs(z) < 3)).sum() > 100  # it lies on top instead


@pytest.mark.parametrize("variant", ["voxels", "triangles"])
@pytest.mark.parametrize("name", ["LEAN_TO", "LEAN_TO_ON_BARE_GROUND"])
def test_no_flake_slides_below_the_ground(programs, scene, name, variant):
    """In wind that blows under the roof, down along which flakes slide."""
    flakes = programs.flakes(STEP, "--scene", scene(name), "--variant", variant, "--voxels", 64,
                             "--particles", 4000, "--timelapse", 1000, "--frames", 1,
                             "--set", "wind_z=-6", "--set", "turbulence=20")
    assert (flakes.rest > 0).sum() > 100
    assert (flakes.position[:, 1] >= 0).all()


def test_no_flake_rests_in_the_air_in_a_corner(programs, scene):
    """There is nothing to lie on but the floor: walls without thickness have no upper side."""
    flakes = programs.flakes(STEP, "--scene", scene("CORNERS"), "--variant", "triangles",
                             "--voxels", 64, "--particles", 4000, "--timelapse", 300, "--frames", 1,
                             "--set", "wind_x=-15", "--set", "turbulence=50",
                             "--set", "speed_0=12", "--set", "speed_1=18")
    lying = flakes.rest > 0
    assert lying.sum() > 500
    assert (flakes.position[lying, 1] <= 0.01).all()  # nearly_down in collide_triangles.glsl


def test_lee_side_of_a_wall_gets_less(programs, scene):
    flakes = programs.flakes(*snow_on(scene("WALL"), "voxels", "--set", "wind_x=2"))
    x, y, z = flakes.position[flakes.rest > 0].T
    near = (y < 0.2) & (abs(z) < 3)
    windward, lee = (near & (x > -2) & (x < -0.3)).sum(), (near & (x > 0.3) & (x < 2)).sum()
    # The fastest flakes (1.7 m/s) come over the wall, 3 m high, and down 3.5 m behind it: the strip
    # of 1.7 m gets only what turbulence carries there.
    assert windward > 30
    assert lee < 0.1 * windward


def test_courtyard_has_dry_places(programs):
    """The arcade, 0.8 m and more inside the edge of its roof."""
    flakes = programs.flakes(STEP, *COURTYARD, *WEATHERS["snow"])
    x, y, z = flakes.position[flakes.rest > 0].T
    open_court = (x > -4) & (z > -4) & (x < 7.5) & (z < 7.5) & (y < 5)
    arcade = (numpy.minimum(x, z) > -7.6) & (numpy.minimum(x, z) < -5.7) & (numpy.maximum(x, z) < 7)
    assert open_court.sum() > 400
    assert (arcade & (y < 2.5)).sum() == 0
    assert (arcade & (y > 3.2)).sum() > 200  # on its roof


@pytest.mark.parametrize("variant", ["voxels", "triangles"])
@pytest.mark.parametrize("weather", ["snow", "rain", "hail"])
def test_ledger_balances(programs, scene, weather, variant):
    result = programs.run_well(STEP, *small(STEP), "--scene", scene("TABLE"), "--frames", 1100,
                               "--particles", 2000, "--weather", weather, "--variant", variant)
    entries = ledger(result.stdout)
    assert entries["released"] == sum(entries.values()) - entries["released"]
    assert entries["melted"] > 300 and entries["deposited"] == 0


@pytest.mark.only_software("it can be told to lack an extension")
def test_shaders_need_bindings(programs):
    without = {"MESA_EXTENSION_OVERRIDE": "-GL_ARB_shading_language_420pack"}
    result = programs.run(STEP, *SMALL, "--frames", 1, environment=without)
    assert fails_with_one_line(result, 1, "needs GL_ARB_shading_language_420pack", "earlier step")


@pytest.mark.parametrize("step", WITH_SCENE)
@pytest.mark.parametrize("voxels", [32, 64, 256])
def test_voxels_take_a_bit_each(programs, step, voxels):
    result = programs.run_well(step, *SMALL, "--frames", 1, "--voxels", voxels)
    assert f"{voxels}^3" in result.stdout and f"{voxels ** 3 // 8} bytes" in result.stdout


BAD_SCENES = {
    "empty": b"",
    "binary": bytes(range(256)) * 20,
    "picture": b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR",
    "prose": b"Once upon a time it snowed.\n",
    "no faces": b"v 0 0 0\nv 1 0 0\nv 0 1 0\n",
    "faces only": b"f 1 2 3\n",
    "NaN": b"v 0 nan 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    "infinite": b"v 0 inf 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    "words for numbers": b"v 0 x 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    "index too large": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n",
    "index zero": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n",
    "index too negative": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n",
    "index huge": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999\n",
    "index no number": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n",
    "truncated vertex": b"v 0 0 0\nv 1 0 0\nv 0 1",
    "truncated face": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2",
    "all one point": b"v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n",
}


@pytest.mark.parametrize("step", WITH_SCENE)
@pytest.mark.parametrize("kind", BAD_SCENES)
def test_bad_scene(programs, tmp_path, step, kind):
    path = tmp_path / "bad.obj"
    path.write_bytes(BAD_SCENES[kind])
    result = programs.run(step, *SMALL, "--frames", 1, "--scene", path)
    assert fails_with_one_line(result, 1, path)


@pytest.mark.parametrize("step", WITH_SCENE)
@pytest.mark.parametrize("path", ["no/such.obj", "."])
def test_missing_scene(programs, step, path):
    assert fails_with_one_line(programs.run(step, *SMALL, "--frames", 1, "--scene", path), 1, path)


def test_scene_is_fitted_and_says_by_what_factor(programs, tmp_path):
    path = tmp_path / "scene.obj"
    path.write_text("v 0 0 0\nv 320 0 0\nv 0 0 320\nv 0 100 0\nf 1 2 3\nf 1 2 4\n")
    result = programs.run_well(STEP, *small(STEP), "--frames", 1, "--scene", path)
    assert "2 triangles" in result.stdout and "0.05" in result.stdout


@pytest.mark.parametrize("step, variant", [(STEP, "voxels"), (STEP, "triangles"),
                                           ("step06_accumulation", "cells"),
                                           ("step06_accumulation", "winter")])
def test_metres_are_kept(programs, tmp_path, step, variant):
    """Those of a scene smaller than the room, too: a floor, and in its middle a block 1.5 m high."""
    path = tmp_path / "scene.obj"
    floor = scenes.quad((-2, 0, -2), (-2, 0, 2), (2, 0, 2), (2, 0, -2))
    path.write_text(scenes.text(floor, scenes.box((-1, 0, -1), (1, 1.5, 1))))
    run = ["--scene", path, "--metres", "--variant", variant, "--voxels", 64, "--camera", "0,80,2",
           "--timelapse", 60, "--frames", 15, "--set", "turbulence=0", "--set", "snowfall=0"]
    cell = 4 / 62
    assert "scaled by 1;" in (said := programs.run_well(step, *SMALL, *run).stdout)
    assert float(re.search(r"64\^3 of (\S+) m", said)[1]) == pytest.approx(cell, rel=1e-4)
    flakes = programs.flakes(step, *run)
    lying = flakes.position[flakes.rest > 0]
    beside = abs(lying[:, [0, 2]]).max(axis=1) - 1  # m from the sides of the block
    block, ground = lying[beside < 0], lying[beside > cell]
    assert len(block) > 5 and len(ground) > 100
    assert (block[:, 1] > 1.49).all() and (block[:, 1] < 1.51 + cell).all()
    assert (ground[:, 1] < (0.01 if step == STEP else 1.01) * cell).all()


@pytest.mark.parametrize("step", WITH_SCENE)
def test_a_scene_too_large_for_metres_is_refused(programs, tmp_path, step):
    path = tmp_path / "scene.obj"
    path.write_text("v 0 0 0\nv 3000 0 0\nv 0 0 3000\nf 1 2 3\n")
    assert fails_with_one_line(programs.run(step, *SMALL, "--scene", path, "--metres"), 1, path, "--metres")
