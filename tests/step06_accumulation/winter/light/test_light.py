"""The light of step 6: shadows lie where the sun says, a lamp lights
what is near, and under a roof it is darker."""

import functools
from math import cos, radians, sin

import numpy
import PIL.Image
import pytest

import scenes
from pictures import Camera

STEP = "step06_accumulation"
SIZE = 320, 180  # pixels

COLUMN = scenes.text(scenes.FLOOR, scenes.box((-0.4, 0, -0.4), (0.4, 3, 0.4)))
ROOF = scenes.text(scenes.FLOOR, scenes.box((-4, 3, -4), (4, 3.2, 4)))
# Across the sun's way; one half of it is cut out.
FENCE = ("mtllib fence.mtl\n" + scenes.text(scenes.FLOOR) + "usemtl fence\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
         "v 0 0 -3\nv 0 0 3\nv 0 3 3\nv 0 3 -3\nf -4/1 -3/2 -2/3 -1/4\n")


CAMERA = Camera(41.2529612, 15.4698602, 17.5, SIZE)


class Picture:
    def __init__(self, pixels):
        self.pixels = pixels

    def colour(self, *point):
        """Around the place where this point of the scene is seen, red, green, blue."""
        column, row = CAMERA.pixels(numpy.array(point)).round().astype(int)
        return self.pixels[row - 1:row + 2, column - 1:column + 2].mean(axis=(0, 1))

    def brightness(self, *point):
        return self.colour(*point).mean()


@pytest.fixture(scope="module")
def draw(programs, tmp_path_factory):
    """Draws a scene without flakes, in this light; each picture only once."""
    folder = tmp_path_factory.mktemp("light")
    (folder / "lamp.mtl").write_text(scenes.GLASS)
    (folder / "fence.mtl").write_text("newmtl fence\nKd 0.5 0.5 0.5\nmap_d fence.png\n")
    PIL.Image.fromarray(numpy.uint8([[255] * 32 + [0] * 32] * 64)).save(folder / "fence.png")

    @functools.lru_cache(maxsize=None)
    def draw(text, frames=1, timelapse=1, camera="41.2529612,15.4698602,17.5", **settings):
        (folder / "scene.obj").write_text(text)
        return Picture(programs.picture(
            STEP, "--size", "%dx%d" % SIZE, "--particles", 0, "--voxels", 64, "--scene", folder / "scene.obj",
            "--frames", frames, "--timelapse", timelapse, "--camera", camera,
            *[word for name, value in settings.items() for word in ("--set", f"{name}={value}")]))
    return draw


def on_ground(direction):
    """The point 2 m from the column in this direction, degrees."""
    return 2 * sin(radians(direction)), 0, 2 * cos(radians(direction))


# Not those in which the column would hide one of the points from the camera.
@pytest.mark.parametrize("direction", [100, 280])
def test_shadow_lies_opposite_the_sun_and_turns_with_it(draw, direction):
    picture = draw(COLUMN, sun_height=40, sun_direction=direction)
    lit, shaded = picture.colour(*on_ground(direction)), picture.colour(*on_ground(direction + 180))
    assert shaded.mean() < 0.75 * lit.mean()
    assert shaded[2] / shaded[0] > 1.1 * lit[2] / lit[0]  # what lights it is the sky, which is blue
    # All the ground but the shadow is lit: none of it shadows itself. (Seen on this side of the column.)
    x, z = numpy.meshgrid(range(-6, 7, 2), range(-6, 7, 2))
    aside = [picture.brightness(x, 0, z) for x, z in zip(x.flat, z.flat) if x + z >= 0
             and abs(x * cos(radians(direction)) - z * sin(radians(direction))) > 1.5]
    assert min(aside) > 0.9 * lit.mean()


def test_what_is_cut_out_throws_no_shadow(draw):
    picture = draw(FENCE, sun_height=40, sun_direction=270)
    whole, cut_out, beside = (picture.brightness(1.5, 0, z) for z in (-1.5, 1.5, 5))
    assert whole < 0.8 * beside and cut_out > 0.9 * beside


def test_lamp_lights_its_surroundings_at_dusk(draw):
    near, far = (0.7, 0, 0.7), (-7, 0, 7)
    night, without = draw(scenes.LAMP, sun_height=-6), draw(scenes.LAMP, sun_height=-6, lamp=0)
    assert night.brightness(*near) > 1.5 * without.brightness(*near)
    assert night.brightness(*near) - without.brightness(*near) \
        > 5 * (night.brightness(*far) - without.brightness(*far))
    red, green, blue = night.colour(*near)
    assert red > green > blue  # as the lamp
    assert night.brightness(0.2, 1.75, 0.2) > 200 > without.brightness(0.2, 1.75, 0.2)  # its glass
    assert (draw(scenes.LAMP, sun_height=20).pixels == draw(scenes.LAMP, sun_height=20, lamp=0).pixels).all()


def test_an_eye_below_the_snow_sees_no_black(draw):
    """Snow on open ground as high as the eye, and higher: no way to it, and so no direction."""
    picture = draw(COLUMN, frames=2, timelapse=1000, camera="41,-2,17", snowfall=10)
    assert picture.pixels.max(axis=2).min() > 0


def test_under_a_roof_it_is_darker_without_any_sun(draw):
    below, open_sky = (2, 0, 2), (6.5, 0, 0)
    with_occlusion = draw(ROOF, sun_height=-1)
    without = draw(ROOF, sun_height=-1, occlusion=0)
    assert with_occlusion.brightness(*below) < 0.75 * without.brightness(*below)
    assert with_occlusion.brightness(*open_sky) > 0.9 * without.brightness(*open_sky)
