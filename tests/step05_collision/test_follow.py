"""--follow (steps 5, 6): it snows around the camera, wherever that is, but under no roof."""

import numpy
import pytest

import scenes
from conftest import SMALL, VARIANTS, WITH_SCENE, Flakes
from pictures import Camera
from reports import ledger

# Without boxes, whose flakes are those of triangles (test_collision.py).
SNOWING = [(step, variant) for step in WITH_SCENE for variant in VARIANTS[step] if variant != "boxes"]
HALF = 8  # m, half the width of a cloud

# Covers the half of the ground that is towards -x. (The floor is that of the other scenes: 16 m wide.)
ROOF = scenes.text(scenes.FLOOR, scenes.box((-8, 3, -8), (0, 3.2, 8)))


@pytest.fixture
def follow(programs, tmp_path):
    """Runs a step with --follow: its ledger and its flakes."""
    def follow(step, variant, scene, *arguments):
        path = tmp_path / "scene.obj"
        path.write_text(scene)
        shared = ["--variant", variant, "--scene", path, "--voxels", 64, "--particles", 3000, "--follow",
                  *arguments]
        entries = ledger(programs.run_well(step, *SMALL, *shared, "--dump", tmp_path / "flakes.csv").stdout)
        return entries, Flakes(tmp_path / "flakes.csv")
    return follow


@pytest.mark.parametrize("step, variant", SNOWING)
def test_flakes_surround_a_camera_far_off(follow, step, variant):
    """On all four sides alike, though the wind would long have blown them away: their standard deviation is
    that of an even spread, 2 HALF / sqrt(12), within 5 %, and their mean within three of its errors."""
    entries, flakes = follow(step, variant, scenes.TABLE, "--camera", "41,15,80", "--timelapse", 300,
                             "--frames", 4, "--set", "wind_x=25")
    from_eye = flakes.position[flakes.airborne][:, [0, 2]] - Camera(41, 15, 80, (64, 64)).eye[[0, 2]]
    assert len(from_eye) > 1000
    assert (abs(from_eye) <= HALF + 0.001).all()
    even = 2 * HALF / numpy.sqrt(12)
    assert (abs(from_eye.mean(axis=0)) < 3 * even / numpy.sqrt(len(from_eye))).all()
    assert (abs(from_eye.std(axis=0) - even) < 0.05 * even).all()
    # A flake that changes sides is the same flake: it has not left, it is not released again. One in ten
    # sublimates on its way. (In step 6 what comes down where the grid does not reach has left, too.)
    assert step == "step06_accumulation" or entries["left"] < 0.2 * entries["released"]


@pytest.mark.parametrize("step, variant", SNOWING)
def test_none_enters_under_a_roof(follow, step, variant):
    """Wind blows all that falls beside the roof out at x = 8, and it may not come in again at x = -8, where
    the roof hangs above the floor. Not next to the roof's edges: flutter carries a flake in there."""
    _, flakes = follow(step, variant, ROOF, "--camera", "0,85,0.5", "--timelapse", 300, "--frames", 4,
                       "--set", "wind_x=3")
    x, y, z = flakes.position[flakes.age >= 0].T
    under = (y < 3) & (abs(z) < HALF - 1)
    assert (under & (x > 0.5)).sum() > 100
    assert (under & (x < -0.5)).sum() == 0
    assert ((y > 3) & (x < -0.5)).sum() > 100  # above it they may


@pytest.mark.parametrize("step, variant", SNOWING)
def test_flakes_keep_up_with_a_flight(follow, step, variant):
    """Three of its seconds, in which the camera covers some metres. What lies stays where it fell."""
    _, flakes = follow(step, variant, scenes.TABLE, "--tour", "--frames", 180, "--timelapse", 8)
    airborne = flakes.position[flakes.airborne][:, [0, 2]]
    assert (numpy.ptp(airborne, axis=0) > 0.9 * 2 * HALF).all()
    assert (numpy.ptp(airborne, axis=0) <= 2 * HALF + 0.001).all()
    lying = flakes.position[flakes.rest > 0][:, [0, 2]]
    assert len(lying) > 100
    outside = (lying < airborne.min(axis=0)) | (lying > airborne.max(axis=0))
    assert outside.any()


# A plateau 400 m wide, 50 m above a plain that is 500 m wide.
PLATEAU = scenes.text(scenes.quad((-250, 0, -250), (-250, 0, 250), (250, 0, 250), (250, 0, -250)),
                      scenes.box((-200, 0, -200), (200, 50, 200)))


@pytest.mark.parametrize("step, variant", SNOWING)
def test_in_metres_it_snows_on_top_of_what_is_under_the_clouds(follow, step, variant):
    _, flakes = follow(step, variant, PLATEAU, "--metres", "--camera", "90,0,60", "--timelapse", 300, "--frames", 4)
    cell = 500 / 62  # m; one voxel of air on each side
    lying = flakes.position[flakes.rest > 0]
    assert len(lying) > 200
    assert (lying[:, 1] >= 50).all() and (lying[:, 1] < 50 + 2 * cell).all()
    from_eye = flakes.position[flakes.age >= 0][:, [0, 2]] - [60, 0]
    assert (abs(from_eye) <= 20.1).all()  # of clouds 40 m wide; one may land in the step that takes it out
    assert (numpy.ptp(from_eye, axis=0) > 36).all()


# It rises from 0 to 60 m over 120 m.
SLOPE = scenes.text(scenes.quad((-60, 0, -60), (-60, 0, 60), (60, 60, 60), (60, 60, -60)))


@pytest.mark.parametrize("step, variant", SNOWING)
def test_it_snows_along_a_slope(follow, step, variant):
    """Everywhere as high above it, and half of the flakes on either side of the camera; also those that the wind,
    uphill, has taken out and in again. Clouds end 12.75 m up; the highest in a square of the terrain is half a
    metre above its middle, and by a metre a flake may be swept up or be in the ground."""
    entries, flakes = follow(step, variant, SLOPE, "--metres", "--camera", "0,85,30", "--timelapse", 300,
                             "--frames", 4, "--set", "wind_x=12",
                             *(["--set", "gusts=0"] if variant == "winter" else []))
    assert entries["left"] < 0.3 * entries["released"]  # one in ten sublimates
    x, y, _ = flakes.position[flakes.airborne].T
    height = y - 0.5 * (x + 60)
    assert (height > -1).all() and (height < 12.75 + 0.5 + 1).all()
    assert len(x) > 500 and 0.4 < (x > 0).mean() < 0.6


@pytest.mark.parametrize("step", WITH_SCENE)
def test_clouds_that_stay_hang_above_a_scene_in_metres_too(programs, tmp_path, step):
    """And in wind it snows on all of the 16 m below them: the mean of 200 is within 1 m of the middle."""
    path = tmp_path / "plateau.obj"
    path.write_text(PLATEAU)
    flakes = programs.flakes(step, "--scene", path, "--metres", "--voxels", 64, "--particles", 1000,
                             "--timelapse", 300, "--frames", 4, "--set", "wind_x=2",
                             *(["--set", "gusts=0"] if step == "step06_accumulation" else []))
    lying = flakes.position[flakes.rest > 0]
    assert len(lying) > 200
    assert (lying[:, 1] >= 50).all()
    assert abs(lying[:, 0].mean()) < 1 and abs(lying[:, 0]).max() < 9
