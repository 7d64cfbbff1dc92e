"""The exercises of step 5: each solution does what the chapter says it will."""

import re

import numpy
import pytest

from conftest import SMALL, Flakes
from pictures import read

STEP = "step05_collision"
LANDED = ["--timelapse", 100, "--frames", 9]
FINE = [*LANDED, "--voxels", 256]


def lying(flakes):
    return flakes.position[flakes.rest > 0].T


@pytest.mark.parametrize("voxels, least, most", [(32, 0.31, 0.33), (256, 0, 0.01)])
def test_exercise_1_flakes_lie_in_the_air(programs, voxels, least, most):
    x, y, z = lying(programs.flakes(STEP, *LANDED, "--voxels", voxels))
    above = y[(abs(x - 0.2) < 0.7) & (abs(z - 3.9) < 0.35) & (y > 0.4)] - 0.75
    assert len(above) > 10
    assert (above >= least).all() and (above <= most).all()


@pytest.mark.only_software("on a card the CPU does not wait for the flakes")
def test_exercise_2_voxels_take_a_fraction_of_the_time(programs):
    def update(variant):
        """CPU time, ms: in software all of it."""
        output = programs.run_well(STEP, "--benchmark", "--particles", 1000, "--size", "64x64", "--voxels", 32,
                                   "--variant", variant, "--warmup", 300, "--frames", 5).stdout
        return float(re.search(r"^ +update +cpu +([\d.]+)", output, re.MULTILINE)[1])
    assert update("triangles") > 10 * update("voxels")


def test_exercise_3_few_under_the_roof(programs):
    def count(*arguments):
        x, y, z = lying(programs.flakes(STEP, *FINE, *arguments))
        under = (y < 3) & ((x < -5) | (z < -5)) & (numpy.maximum(abs(x), abs(z)) < 7.9)
        return under.sum(), len(x)
    under, all_of_them = count()
    assert 10 <= under <= 24 and 6200 < all_of_them < 6400
    assert count("--set", "turbulence=0")[0] == 0


def test_exercise_4_snow_sticks_to_walls(programs, edited, tmp_path):
    windy = [*FINE, "--set", "wind_x=-3", "--set", "wind_z=-1"]

    def on_walls(flakes):
        _, y, _ = lying(flakes)
        return ((y > 1.2) & (y < 3)).sum()

    path = tmp_path / "flakes.csv"
    with edited(f"{STEP}/solutions/4.patch") as there:
        there.run_well(STEP, *SMALL, *windy, "--dump", path)
    assert 700 < on_walls(Flakes(path)) < 800
    assert 80 <= on_walls(programs.flakes(STEP, *windy)) <= 120


def test_exercise_5_a_byte_a_voxel(programs, edited, tmp_path):
    path = tmp_path / "flakes.csv"
    with edited(f"{STEP}/solutions/5.patch", build=STEP) as there:
        there.run_well(STEP, *SMALL, *FINE, "--debug", "--dump", path)
    assert path.read_bytes() == programs.dump(STEP, *FINE)


def test_exercise_6_the_voxels_are_seen(programs, edited, tmp_path):
    def hides(there):
        """Which pixels are not sky, before the first flake falls there."""
        path = tmp_path / "picture.png"
        result = there.run_well(STEP, "--voxels", 64, "--size", "640x360", "--frames", 2, "--screenshot", path)
        return abs(read(path) - numpy.array([0.30, 0.34, 0.42]) * 255).max(axis=2) > 3, result.stdout

    with edited(f"{STEP}/solutions/6.patch", build=STEP) as there:
        cubes, output = hides(there)
    scene, _ = hides(programs)
    assert "filled: 13634\n" in output
    assert 0.4 < scene.mean() < cubes.mean() < 1.05 * scene.mean()
    assert (scene & ~cubes).sum() <= 0.001 * scene.sum()  # but for a pixel here and there along an edge
