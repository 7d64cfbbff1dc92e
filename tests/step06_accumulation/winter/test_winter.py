"""Step 6 with all its parts at once: winters of minutes, as they look and as they add up."""

import re

import pytest

import scenes
from conftest import SMALL
from pictures import check_picture, read
from reports import cover_sums, let_it_snow

STEP = "step06_accumulation"
WINTER = ["--size", "320x180", "--voxels", 64, "--particles", 1000, "--seed", 7]
CAMERAS = {"courtyard": "41,15,17.5", "table": "60,18,7", "roof": "200,35,14", "tree": "225,12,7.5",
           "rabbit": "30,15,9"}


@pytest.mark.parametrize("camera", CAMERAS)
def test_picture_after_0_60_and_300_seconds(request, programs, tmp_path, camera):
    """A frame is 5 s: the 12th comes after 60 s, the 60th after 300 s."""
    view = [*WINTER, "--camera", CAMERAS[camera]]
    if camera == "rabbit":
        (tmp_path / "rabbit.obj").write_text(scenes.RABBIT)
        view += ["--scene", tmp_path / "rabbit.obj"]
    check_picture(request, f"winter_{camera}_0s", programs.picture(STEP, *view, "--frames", 1))
    programs.run_well(STEP, *view, "--timelapse", 300, "--frames", 60, "--record", tmp_path)
    check_picture(request, f"winter_{camera}_60s", read(tmp_path / "000012.png"))
    check_picture(request, f"winter_{camera}_300s", read(tmp_path / "000060.png"))


SIGHTS = {
    "dusk": ["--set", "sun_height=-3"],
    "night": ["--set", "sun_height=-12"],
    "hail": ["--weather", "hail"],
    "rain": ["--weather", "rain"],
    "wind": ["--set", "wind_x=2"],
    "mountains": ["--scene", "mountains"],
    "flakes": ["--camera", "41,8,3"],
    "crystals": ["--camera", "41,8,17", "--set", "diameter_0=0.5", "--set", "diameter_1=1"],
    "costly": ["--set", "tessellation=1", "--set", "soft_shadows=1", "--set", "multisample=1",
               "--set", "bloom=0.06"],
}


@pytest.mark.parametrize("sight", SIGHTS)
def test_picture_after_60_seconds(request, programs, sight):
    actual = programs.picture(STEP, *WINTER, "--timelapse", 300, "--frames", 12, *SIGHTS[sight])
    check_picture(request, f"winter_{sight}_60s", actual)


def test_same_winter_whatever_the_number_of_threads(programs, tmp_path):
    """What one column does in its turn depends on no other that has its turn at the same time: no mass is lost.
    But with many threads flakes land in another order, so that now and then another one fills a cell."""
    pictures = []
    for threads in 1, 8:
        path = tmp_path / f"{threads}.png"
        result = programs.run_well(STEP, "--size", "160x90", "--voxels", 128, "--particles", 4000,
                                   "--timelapse", 100, "--frames", 12, "--set", "snowfall=3",
                                   "--set", "melt_time=1", "--screenshot", path,
                                   environment={"LP_NUM_THREADS": str(threads)})
        assert cover_sums(result.stdout)[2] > 0
        pictures.append(read(path))
    # As in check_against: a flake that is elsewhere changes a handful of pixels.
    assert (abs(pictures[0] - pictures[1]).max(axis=2) > 24).mean() <= 0.01


@pytest.mark.parametrize("weather, wind", [
    (["snow"], ["wind_x=4"]),
    (["snow", "--set", "temperature=3"], ["wind_z=4"]),
    (["hail"], ["wind_x=-6"]),
    (["rain"], ["wind_z=-8"]),
])
def test_sums_after_10000_steps(programs, weather, wind):
    """With all parts on: not a flake, not a unit of mass is lost."""
    entries, _, (_, melted, deposited) = let_it_snow(programs, "--voxels", 32, "--particles", 1000, "--timelapse", 500,
                                                     "--frames", 20, "--weather", *weather, "--set", *wind)
    assert entries["released"] > 1000
    assert (deposited > 0) == (weather[0] != "rain")
    assert (melted > 0) == (len(weather) > 1)


def test_no_complaint_from_opengl_whatever_is_switched(programs):
    """--debug prints every error and message of OpenGL on stderr; run_well wants that empty."""
    parts = re.findall(r"(\w+) +([01]) on/off", programs.run(STEP, "--help").stdout)
    assert len(parts) > 10
    other = [f"{name}={1 - int(on)}" for name, on in parts]
    for changed in other, other[::2], other[1::2]:
        settings = [word for change in changed for word in ("--set", change)]
        programs.run_well(STEP, *SMALL, "--voxels", 32, "--debug", "--timelapse", 60,
                          "--frames", 5, "--set", "sun_height=-1", *settings)


def test_a_part_that_is_off_has_no_stage(programs, tmp_path):
    """Not even a column among the times."""
    stages = {"settling": "settle", "melting": "melt", "shadow": "shadow", "scene": "scene", "sky": "sky",
              "arrows": "arrows", "bloom": "bloom"}
    header = {}
    for on in (0, 1):
        settings = [word for part in stages for word in ("--set", f"{part}={0.5 * on if part == 'bloom' else on}")]
        programs.run_well(STEP, *SMALL, "--voxels", 32, "--frames", 2, *settings,
                          "--csv", tmp_path / "times.csv")
        header[on] = (tmp_path / "times.csv").read_text().split("\n")[0]
    for stage in stages.values():
        assert f",{stage}_gpu_ms" in header[1] and f",{stage}_" not in header[0]
