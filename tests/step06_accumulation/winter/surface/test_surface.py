"""What snow makes of surfaces: walls against the wind are dusted, and the field is as white as the ground."""

import numpy
import pytest

import scenes

STEP = "step06_accumulation"
# Flakes, and what glitters.
UNSEEN = ["--set", "billboards=0", "--set", "diameter_0=0.001", "--set", "diameter_1=0.001", "--set", "sparkle=0"]


@pytest.fixture
def draw(programs, tmp_path):
    def draw(text, *words, voxels=64):
        (tmp_path / "dark.mtl").write_text("newmtl dark\nKd 0.05 0.05 0.05\n")
        (tmp_path / "scene.obj").write_text(text)
        return programs.picture(STEP, "--size", "320x180", "--voxels", voxels, *words,
                                "--scene", tmp_path / "scene.obj")
    return draw


def test_snow_clings_to_the_weather_side(draw):
    """Of a block that is seen from +x: wind against that side dusts it, and wind from behind does not."""
    block = ("mtllib dark.mtl\nusemtl dark\n"
             + scenes.text(scenes.FLOOR, scenes.box((-1.5, 0, -1.5), (1.5, 4, 1.5))))

    def change(wind):
        words = ["--particles", 0, "--timelapse", 1000, "--frames", 8, "--camera", "90,5,12", "--set", "sparkle=0",
                 "--set", f"wind_x={wind}"]
        on, off = (draw(block, *words, "--set", f"dusting={on}") for on in (1, 0))
        return (abs(on - off).max(axis=2) > 8).sum()
    assert change(-4) > 500  # of some 6,000 pixels that show it
    assert change(4) == 0


def test_no_line_where_the_scene_ends(draw):
    """Snow goes on from the floor of the scene over bare ground to the field, without a step in brightness."""
    picture = draw(scenes.text(scenes.FLOOR), "--particles", 5000, "--timelapse", 800, "--frames", 5,
                   "--camera", "0,45,20", *UNSEEN)
    across = picture[60:120].mean(axis=(0, 2))  # columns of pixels: from field over floor to field
    assert abs(numpy.diff(across)).max() < 6
    assert across.max() - across.min() < 25


def test_deep_snow_shows_no_ridges(draw):
    """Neither those of the surface below it nor, as it lies deeper between them, their like upside down."""
    ridges = [side for x in numpy.arange(-8, 8, 0.5)
              for side in (scenes.quad((x, 1, -8), (x, 1, 8), (x + 0.25, 1.12, 8), (x + 0.25, 1.12, -8)),
                           scenes.quad((x + 0.25, 1.12, -8), (x + 0.25, 1.12, 8), (x + 0.5, 1, 8), (x + 0.5, 1, -8)))]
    picture = draw(scenes.text(scenes.FLOOR, *ridges), "--particles", 8000, "--timelapse", 600, "--frames", 4,
                   "--set", "snowfall=1.2", "--camera", "0,40,12", *UNSEEN, "--set", "sun_height=15", voxels=256)
    along = picture[80:120, 80:240].mean(axis=(0, 2))  # each ridge
    assert along.std() < 2  # seen: 0.6; and 4.9 where hollows are not filled
