"""The exercises of the winter: each solution does what the chapter says it will."""

import numpy
import pytest

from conftest import SMALL
from pictures import read
from reports import Cover

STEP = "step06_accumulation"
WINTER = f"{STEP}/winter"
VIEW = ["--size", "320x180", "--voxels", 64]


@pytest.fixture
def draw(tmp_path):
    """A picture of the courtyard."""
    def draw(there, *arguments):
        there.run_well(STEP, *arguments, "--screenshot", tmp_path / "picture.png")
        return read(tmp_path / "picture.png")
    return draw


def test_exercise_1_snow_under_the_roof(programs, tmp_path):
    def under_the_roof(*arguments):
        """The part of the snow that lies there, in wind towards the closed side."""
        programs.run_well(STEP, *SMALL, "--timelapse", 120, "--frames", 30, "--voxels", 128, "--set", "wind_x=-3",
                          *arguments, "--dump-cover", tmp_path / "cover.csv")
        cover = Cover(tmp_path / "cover.csv")
        x, y, z = cover.place.T
        wing = (x > -7.6) & (x < -5.7) & (z > -5) & (z < 7) & (y < 2.5)
        return cover.mass[wing].sum() / cover.mass.sum()

    even = under_the_roof("--set", "wind_field=0")
    assert 0.08 < even < 0.1
    assert under_the_roof() < even / 4


def test_exercise_2_colours_by_height(edited, draw):
    with edited(f"{WINTER}/solutions/2.patch", build=STEP) as there:
        picture = draw(there, *VIEW, "--timelapse", 60, "--frames", 15, "--set", "scene=0", "--set", "sun_height=-14",
                       "--set", "colours=4")
    red, _, blue = numpy.moveaxis(picture, 2, 0)
    above, below = numpy.nonzero(red > blue + 60)[0], numpy.nonzero(blue > red + 90)[0]
    assert len(above) > 300 and len(below) > 300
    assert numpy.median(above) < numpy.median(below) - 50  # of 180 rows


def test_exercise_3_ring_around_the_sun(programs, edited, draw):
    azimuth, elevation, height = numpy.radians([41, 0, 12])
    view = [*VIEW, "--particles", 0, "--scene", "none", "--camera", "41,0,10", "--set", "sun_direction=221",
            "--set", "sun_height=12"]
    with edited(f"{WINTER}/solutions/3.patch") as there:
        change = draw(there, *view) - draw(programs, *view)
    # Where each pixel looks: the field of view is 0.82 rad high.
    rows, columns, _ = change.shape
    y, x = numpy.mgrid[0:rows, 0:columns] + 0.5
    scale = numpy.tan(0.82 / 2) / (rows / 2)
    ahead = -numpy.array([numpy.cos(elevation) * numpy.sin(azimuth), numpy.sin(elevation),
                          numpy.cos(elevation) * numpy.cos(azimuth)])
    right = numpy.cross(ahead, (0, 1, 0))
    sight = ahead + scale * ((x - columns / 2)[..., None] * right - (y - rows / 2)[..., None] * numpy.array([0, 1, 0]))
    sight /= numpy.linalg.norm(sight, axis=2, keepdims=True)
    to_sun = -numpy.cos(height) * numpy.array([numpy.sin(azimuth), 0, numpy.cos(azimuth)]) + (0, numpy.sin(height), 0)
    angle = numpy.degrees(numpy.arccos(sight @ to_sun))
    high = numpy.degrees(numpy.arcsin(sight[..., 1])) > 8  # below that hazy air hides it
    ring = high & (angle > 22) & (angle < 24)
    assert ring.sum() > 500 and (change[ring].sum(axis=1) > 6).all()
    assert (change[(angle < 21) | (angle > 27)] == 0).all()


def test_exercise_4_the_triangles_are_seen(edited, draw):
    view = ["--size", "640x360", "--particles", 1000, "--set", "tessellation=1", "--set", "sky=0", "--set", "fog=0",
            "--camera", "60,18,7"]
    with edited(f"{WINTER}/solutions/4.patch", build=STEP) as there:
        before, after = [draw(there, *view, "--timelapse", timelapse, "--frames", 12) for timelapse in (1, 300)]
    # Where nothing is drawn the frame has the colour that is seen in the middle of its upper edge, before it snows.
    ground = numpy.s_[250:360, 170:330]
    lines = [(abs(picture - before[0, 320]).max(axis=2) > 8)[ground].mean() for picture in (before, after)]
    assert lines[1] > 1.2 * lines[0] > 0.1


def test_exercise_5_shadows_of_clouds(edited, draw):
    view = [*VIEW, "--particles", 0, "--set", "wind_x=3", "--set", "snowfall=0", "--set", "gusts=0", "--set", "fog=0"]
    with edited(f"{WINTER}/solutions/5.patch", build=STEP) as there:
        now, then = [draw(there, *view, "--timelapse", timelapse, "--frames", 4) for timelapse in (1, 60)]
        shaded = [draw(there, *view, "--set", "sun_height=-1", "--timelapse", timelapse, "--frames", 4)
                  for timelapse in (1, 60)]
    change = (then - now).sum(axis=2)[90:]  # below the roofs
    assert (change > 60).sum() > 300 and (change < -60).sum() > 300
    assert (change == 0).sum() > 300  # in the shadow of the house
    assert (shaded[0] == shaded[1]).all()
