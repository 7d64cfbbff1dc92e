"""Snow lands on a scene (step 5): never inside it, never below it, where the CPU says it lands."""

import re
import subprocess

import numpy
import pytest

import scenes
from conftest import SMALL, Flakes, fails_with_one_line, small
from reports import ledger

STEP = "step05_collision"


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
def test_gpu_agrees_with_the_cpu(programs, tmp_path, weather):
    """What lands, lands where the CPU's landed. (That this is outside what is solid, and on it, walk_test.cpp tests.)
    0.1 % may differ: rounding sends a flake that passes within a micrometre of a voxel's edge to this side of it or to
    the other."""
    shared = [*COURTYARD, *WEATHERS[weather]]
    subprocess.run(programs.command("tests/reference_walk", *shared, "--dump", tmp_path / "walk.csv"),
                   check=True, stdout=subprocess.DEVNULL)
    expected, flakes = Flakes(tmp_path / "walk.csv"), programs.flakes(STEP, *shared)
    assert (flakes.rest > 0).sum() > 500
    assert (flakes.position[:, 1] >= 0).all()
    apart = numpy.linalg.norm(flakes.position - expected.position, axis=1)
    assert (apart <= 0.001).mean() >= 0.999
    assert ((flakes.rest > 0) == (expected.rest > 0)).mean() >= 0.999


def snow_on(scene, variant):
    return [STEP, "--scene", scene, "--variant", variant, "--voxels", 256, "--particles", 6000, "--timelapse", 96,
            "--frames", 10]


def test_triangles_and_voxels_land_flakes_in_the_same_place(programs, scene):
    """Within a voxel's diagonal, for flakes that lie in both variants and were born together. 2 % may differ: one that
    comes down within 6 cm outside an edge lands on the voxel there, but misses the triangle and lands below. Edges are
    30 m long and the world is 256 m2: that is 0.7 % of the flakes."""
    voxels, triangles = (programs.flakes(*snow_on(scene("TABLE"), variant)) for variant in ("voxels", "triangles"))
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


@pytest.mark.parametrize("name, variant", [("LEAN_TO", "triangles"), ("LEAN_TO_ON_BARE_GROUND", "voxels"),
                                           ("LEAN_TO_ON_BARE_GROUND", "triangles")])
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


@pytest.mark.parametrize("weather, variant", [("snow", "voxels"), ("rain", "voxels"), ("hail", "triangles")])
def test_ledger_balances(programs, scene, weather, variant):
    result = programs.run_well(STEP, *small(STEP), "--scene", scene("TABLE"), "--timelapse", 100, "--frames", 11,
                               "--particles", 2000, "--weather", weather, "--variant", variant)
    entries = ledger(result.stdout)
    assert entries["melted"] > 300 and entries["deposited"] == 0


@pytest.mark.only_software("it can be told to lack an extension")
def test_shaders_need_bindings(programs):
    without = {"MESA_EXTENSION_OVERRIDE": "-GL_ARB_shading_language_420pack"}
    result = programs.run(STEP, *SMALL, "--frames", 1, environment=without)
    assert fails_with_one_line(result, 1, "needs GL_ARB_shading_language_420pack", "earlier step")


@pytest.mark.parametrize("step, variant", [(STEP, "voxels"), (STEP, "triangles"),
                                           ("step06_accumulation", "cells"),
                                           ("step06_accumulation", "winter")])
def test_metres_are_kept(programs, tmp_path, step, variant):
    """Those of a scene smaller than the room, too: a floor, and in its middle a block 1.5 m high."""
    path = tmp_path / "scene.obj"
    floor = scenes.quad((-2, 0, -2), (-2, 0, 2), (2, 0, 2), (2, 0, -2))
    path.write_text(scenes.text(floor, scenes.box((-1, 0, -1), (1, 1.5, 1))))
    run = ["--scene", path, "--metres", "--variant", variant, "--voxels", 64, "--camera", "0,80,2",
           "--timelapse", 300, "--frames", 3, "--set", "turbulence=0", "--set", "snowfall=0"]
    cell = 4 / 62
    said = programs.run_well(step, *SMALL, *run, "--dump", tmp_path / "flakes.csv").stdout
    assert "scaled by 1;" in said
    assert float(re.search(r"64\^3 of (\S+) m", said)[1]) == pytest.approx(cell, rel=1e-4)
    flakes = Flakes(tmp_path / "flakes.csv")
    lying = flakes.position[flakes.rest > 0]
    beside = abs(lying[:, [0, 2]]).max(axis=1) - 1  # m from the sides of the block
    block, ground = lying[beside < 0], lying[beside > cell]
    assert len(block) > 5 and len(ground) > 100
    assert (block[:, 1] > 1.49).all() and (block[:, 1] < 1.51 + cell).all()
    assert (ground[:, 1] < (0.01 if step == STEP else 1.01) * cell).all()


def test_a_scene_too_large_for_metres_is_refused(programs, tmp_path):
    path = tmp_path / "scene.obj"
    path.write_text("v 0 0 0\nv 3000 0 0\nv 0 0 3000\nf 1 2 3\n")
    assert fails_with_one_line(programs.run(STEP, *SMALL, "--scene", path, "--metres"), 1, path, "--metres")
