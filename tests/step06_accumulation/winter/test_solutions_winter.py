"""The exercises of the winter: each solution does what the chapter says it will."""

import numpy

from pictures import Camera
from reports import let_it_snow

STEP = "step06_accumulation"
WINTER = f"{STEP}/winter"
VIEW = ["--size", "320x180", "--voxels", 64]


def test_exercise_1_snow_under_the_roof(programs):
    def under_the_roof(*arguments):
        """The part of the snow that lies there, in wind towards the closed side."""
        _, cover, _ = let_it_snow(programs, "--timelapse", 120, "--frames", 30, "--voxels", 128,
                                  "--set", "wind_x=-3", *arguments)
        x, y, z = cover.place.T
        wing = (x > -7.6) & (x < -5.7) & (z > -5) & (z < 7) & (y < 2.5)
        return cover.mass[wing].sum() / cover.mass.sum()

    even = under_the_roof("--set", "wind_field=0")
    assert 0.13 < even < 0.15
    assert under_the_roof() < even / 4


def test_exercise_2_colours_by_height(edited):
    with edited(f"{WINTER}/solutions/2.patch", build=STEP) as there:
        picture = there.picture(STEP, *VIEW, "--timelapse", 60, "--frames", 15, "--set", "scene=0",
                                "--set", "sun_height=-14", "--set", "colours=4")
    red, _, blue = numpy.moveaxis(picture, 2, 0)
    above, below = numpy.nonzero(red > blue + 60)[0], numpy.nonzero(blue > red + 90)[0]
    assert len(above) > 300 and len(below) > 300
    assert numpy.median(above) < numpy.median(below) - 50  # of 180 rows


def test_exercise_3_ring_around_the_sun(programs, edited):
    view = [*VIEW, "--particles", 0, "--scene", "none", "--camera", "41,0,10", "--set", "sun_direction=221",
            "--set", "sun_height=12"]
    with edited(f"{WINTER}/solutions/3.patch") as there:
        change = there.picture(STEP, *view) - programs.picture(STEP, *view)
    # Where each pixel looks.
    camera = Camera(41, 0, 10, (320, 180))
    y, x = numpy.mgrid[0:180, 0:320] + 0.5
    scale = numpy.tan(camera.HALF_VIEW) / 90
    sight = scale * ((x - 160)[..., None] * camera.right - (y - 90)[..., None] * numpy.array([0, 1, 0])) - camera.back
    sight /= numpy.linalg.norm(sight, axis=2, keepdims=True)
    height = numpy.radians(12)
    to_sun = numpy.array([0, numpy.sin(height), 0]) - numpy.cos(height) * camera.back
    angle = numpy.degrees(numpy.arccos(sight @ to_sun))
    high = numpy.degrees(numpy.arcsin(sight[..., 1])) > 8  # below that hazy air hides it
    ring = high & (angle > 22) & (angle < 24)
    assert ring.sum() > 500 and (change[ring].sum(axis=1) > 6).all()
    assert (change[(angle < 21) | (angle > 27)] == 0).all()


def test_exercise_4_the_triangles_are_seen(edited):
    view = ["--size", "640x360", "--particles", 1000, "--set", "tessellation=1", "--set", "sky=0", "--set", "fog=0",
            "--camera", "60,18,7"]
    with edited(f"{WINTER}/solutions/4.patch", build=STEP) as there:
        before, after = [there.picture(STEP, *view, "--timelapse", timelapse, "--frames", 12) for timelapse in (1, 300)]
    # Where nothing is drawn the frame has the colour that is seen in the middle of its upper edge, before it snows.
    ground = numpy.s_[250:360, 170:330]
    lines = [(abs(picture - before[0, 320]).max(axis=2) > 8)[ground].mean() for picture in (before, after)]
    assert lines[1] > 1.2 * lines[0] > 0.1


def test_exercise_5_shadows_of_clouds(edited):
    view = [*VIEW, "--particles", 0, "--set", "wind_x=3", "--set", "snowfall=0", "--set", "gusts=0", "--set", "fog=0"]
    with edited(f"{WINTER}/solutions/5.patch", build=STEP) as there:
        now, then = [there.picture(STEP, *view, "--timelapse", timelapse, "--frames", 4) for timelapse in (1, 60)]
        shaded = [there.picture(STEP, *view, "--set", "sun_height=-1", "--timelapse", timelapse, "--frames", 4)
                  for timelapse in (1, 60)]
    change = (then - now).sum(axis=2)[90:]  # below the roofs
    assert (change > 60).sum() > 300 and (change < -60).sum() > 300
    assert (change == 0).sum() > 300  # in the shadow of the house
    assert (shaded[0] == shaded[1]).all()
