"""--follow (steps 5, 6): it snows around the camera, wherever that is, but under no roof."""

import numpy
import pytest

import scenes
from conftest import SMALL, VARIANTS, WITH_SCENE
from reports import Cover, check_sums, cover_sums, ledger

SNOWING = [(step, variant) for step in WITH_SCENE for variant in VARIANTS[step]]
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
        entries = ledger(programs.run_well(step, *SMALL, *shared).stdout)
        assert entries["released"] == sum(entries.values()) - entries["released"]
        return entries, programs.flakes(step, *shared)
    return follow


def eye(azimuth, elevation, distance):
    """Where --camera puts it, m: x and z."""
    azimuth, elevation = numpy.radians([azimuth, elevation])
    return distance * numpy.cos(elevation) * numpy.array([numpy.sin(azimuth), numpy.cos(azimuth)])


@pytest.mark.parametrize("step, variant", SNOWING)
@pytest.mark.parametrize("wind", [0, 25])
def test_flakes_surround_a_camera_far_off(follow, step, variant, wind):
    """On all four sides alike, though the wind would long have blown them away: their standard deviation is
    that of an even spread, 2 HALF / sqrt(12), within 5 %, and their mean within three of its errors."""
    entries, flakes = follow(step, variant, scenes.TABLE, "--camera", "41,15,80", "--timelapse", 300,
                             "--frames", 4, "--set", f"wind_x={wind}")
    from_eye = flakes.position[flakes.airborne][:, [0, 2]] - eye(41, 15, 80)
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


@pytest.mark.parametrize("variant", VARIANTS["step06_accumulation"])
def test_snow_lies_where_it_fell(programs, tmp_path, variant):
    """Not where the scene's middle is. Snow spreads over two cells, and slides over a few more."""
    result = programs.run_well(
        "step06_accumulation", *SMALL, "--variant", variant, "--scene", "none", "--voxels", 64, "--follow",
        "--camera", "0,10,8", "--particles", 3000, "--timelapse", 500, "--frames", 6,
        "--dump-cover", tmp_path / "cover.csv")
    cover = Cover(tmp_path / "cover.csv")
    check_sums(ledger(result.stdout), cover, cover_sums(result.stdout))
    assert len(cover.place) > 500
    assert (cover.place[:, 2] > eye(0, 10, 8)[1] - HALF - 6 * cover.cell).all()


# A plateau 400 m wide, 50 m above a plain that is 500 m wide.
PLATEAU = scenes.text(scenes.quad((-250, 0, -250), (-250, 0, 250), (250, 0, 250), (250, 0, -250)),
                      scenes.box((-200, 0, -200), (200, 50, 200)))


@pytest.mark.parametrize("step, variant", SNOWING)
def test_in_metres_it_snows_on_top_of_what_is_under_the_clouds(programs, tmp_path, step, variant):
    path = tmp_path / "plateau.obj"
    path.write_text(PLATEAU)
    arguments = ["--variant", variant, "--scene", path, "--metres", "--follow", "--voxels", 64, "--particles", 3000,
                 "--camera", "90,0,60", "--timelapse", 300, "--frames", 4]
    said = programs.run_well(step, *SMALL, *arguments).stdout
    cell = 500 / 62  # m; one voxel of air on each side
    entries = ledger(said)
    assert entries["released"] == sum(entries.values()) - entries["released"]

    flakes = programs.flakes(step, *arguments)
    lying = flakes.position[flakes.rest > 0]
    assert len(lying) > 200
    assert (lying[:, 1] >= 50).all() and (lying[:, 1] < 50 + 2 * cell).all()
    from_eye = flakes.position[flakes.age >= 0][:, [0, 2]] - [60, 0]
    assert (abs(from_eye) <= 20.1).all()  # of clouds 40 m wide; one may land in the step that takes it out
    assert (numpy.ptp(from_eye, axis=0) > 36).all()


# It rises from 0 to 60 m over 120 m.
SLOPE = scenes.text(scenes.quad((-60, 0, -60), (-60, 0, 60), (60, 60, 60), (60, 60, -60)))


@pytest.mark.parametrize("step, variant", SNOWING)
@pytest.mark.parametrize("wind", [0, 12])
def test_it_snows_along_a_slope(programs, tmp_path, step, variant, wind):
    """Everywhere as high above it, and half of the flakes on either side of the camera; also those that the wind,
    uphill, has taken out and in again. Clouds end 12.75 m up; the highest in a square of the terrain is half a
    metre above its middle, and by a metre a flake may be swept up or be in the ground."""
    path = tmp_path / "slope.obj"
    path.write_text(SLOPE)
    arguments = ["--variant", variant, "--scene", path, "--metres", "--follow", "--voxels", 64, "--particles", 3000,
                 "--camera", "0,85,30", "--timelapse", 300, "--frames", 4, "--set", f"wind_x={wind}",
                 *(["--set", "gusts=0"] if variant == "winter" else [])]
    entries = ledger(programs.run_well(step, *SMALL, *arguments).stdout)
    assert entries["left"] < 0.3 * entries["released"]  # one in ten sublimates
    flakes = programs.flakes(step, *arguments)
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
