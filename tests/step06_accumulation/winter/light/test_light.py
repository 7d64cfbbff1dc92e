"""The light of step 6: shadows lie where the sun says, snow in the air hides what is far, a lamp
lights what is near, and no exposure turns the picture black or white."""

import functools
from math import cos, radians, sin, tan

import numpy
import PIL.Image
import pytest

import scenes

STEP = "step06_accumulation"
SIZE = 320, 180  # pixels

COLUMN = scenes.text(scenes.FLOOR, scenes.box((-0.4, 0, -0.4), (0.4, 3, 0.4)))
ROOF = scenes.text(scenes.FLOOR, scenes.box((-4, 3, -4), (4, 3.2, 4)))
LAMP = ("mtllib lamp.mtl\n" + scenes.text(scenes.FLOOR) + "usemtl glass\n"
        + scenes.text(scenes.box((-0.2, 1.5, -0.2), (0.2, 2, 0.2))))
# Across the sun's way; one half of it is cut out.
FENCE = ("mtllib fence.mtl\n" + scenes.text(scenes.FLOOR) + "usemtl fence\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
         "v 0 0 -3\nv 0 0 3\nv 0 3 3\nv 0 3 -3\nf -4/1 -3/2 -2/3 -1/4\n")
GLASS = "newmtl glass\nKd 0.9 0.9 0.9\nKe 1 0.7 0.4\n"


def pixel(point):
    """Where the camera of common/camera.hpp, as it stands at the start, sees a point: column, row."""
    azimuth, elevation, distance, field_of_view = 0.72, 0.27, 17.5, 0.82
    target = numpy.array([0, 1.6, 0])
    back = numpy.array([cos(elevation) * sin(azimuth), sin(elevation), cos(elevation) * cos(azimuth)])
    right = numpy.array([cos(azimuth), 0, -sin(azimuth)])
    sight = numpy.array(point) - (target + distance * back)
    scale = SIZE[1] / 2 / tan(field_of_view / 2) / -(sight @ back)
    return (round(SIZE[0] / 2 + scale * (sight @ right)),
            round(SIZE[1] / 2 - scale * (sight @ numpy.cross(back, right))))


class Picture:
    def __init__(self, path):
        self.pixels = numpy.asarray(PIL.Image.open(path).convert("RGB")).astype(float)  # of 255

    def colour(self, *point):
        """Around the place where this point of the scene is seen, red, green, blue."""
        column, row = pixel(point)
        return self.pixels[row - 1:row + 2, column - 1:column + 2].mean(axis=(0, 1))

    def brightness(self, *point):
        return self.colour(*point).mean()


@pytest.fixture(scope="module")
def draw(programs, tmp_path_factory):
    """Draws a scene without flakes, in this light; each picture only once."""
    folder = tmp_path_factory.mktemp("light")
    (folder / "lamp.mtl").write_text(GLASS)
    (folder / "fence.mtl").write_text("newmtl fence\nKd 0.5 0.5 0.5\nmap_d fence.png\n")
    PIL.Image.fromarray(numpy.uint8([[255] * 32 + [0] * 32] * 64)).save(folder / "fence.png")

    @functools.lru_cache(maxsize=None)
    def draw(text, frames=1, timelapse=1, camera="41.2529612,15.4698602,17.5", **settings):
        (folder / "scene.obj").write_text(text)
        programs.run_well(STEP, "--size", "%dx%d" % SIZE, "--particles", 0, "--voxels", 64,
                          "--scene", folder / "scene.obj", "--frames", frames,
                          "--timelapse", timelapse, "--camera", camera,
                          "--screenshot", folder / "picture.png",
                          *[word for name, value in settings.items()
                            for word in ("--set", f"{name}={value}")])
        return Picture(folder / "picture.png")
    return draw


def on_ground(direction):
    """The point 2 m from the column in this direction, degrees."""
    return 2 * sin(radians(direction)), 0, 2 * cos(radians(direction))


# Not those in which the column would hide one of the points from the camera.
@pytest.mark.parametrize("direction", [100, 180, 280])
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


def test_shadow_is_as_long_as_the_sun_is_low(draw):
    for height in (30, 55):
        picture = draw(COLUMN, sun_height=height, sun_direction=100)
        end = 3 / tan(radians(height))  # m; the column is 3 m high
        away = -sin(radians(100)), -cos(radians(100))
        inside, outside = ([part * end * a for a in away] for part in (0.85, 1.4))
        shaded = picture.brightness(inside[0], 0, inside[1])
        assert shaded < 0.8 * picture.brightness(outside[0], 0, outside[1])


def test_what_is_cut_out_throws_no_shadow(draw):
    picture = draw(FENCE, sun_height=40, sun_direction=270)
    whole, cut_out, beside = (picture.brightness(1.5, 0, z) for z in (-1.5, 1.5, 5))
    assert whole < 0.8 * beside and cut_out > 0.9 * beside


def test_without_shadow_map_no_shadow(draw):
    picture = draw(COLUMN, sun_height=40, sun_direction=100, shadow=0)
    assert picture.brightness(*on_ground(280)) == pytest.approx(picture.brightness(*on_ground(100)), rel=0.03)


def test_exposure(draw):
    """From a tenth to ten times: brighter, but neither black nor white."""
    pictures = [draw(COLUMN, sun_height=40, sun_direction=100, exposure=exposure)
                for exposure in (0.1, 1, 2, 10)]
    for dark, bright in zip(pictures, pictures[1:]):
        assert (bright.pixels >= dark.pixels).all() and bright.pixels.mean() > dark.pixels.mean() + 3
    darkest, brightest = pictures[0], pictures[-1]
    assert darkest.brightness(*on_ground(100)) > 20
    assert brightest.pixels.max() < 255
    for picture in pictures:
        assert picture.brightness(*on_ground(280)) < picture.brightness(*on_ground(100)) - 6


def test_more_snow_hides_more(draw):
    """The contrast of what is far fades, and hardly that of what is near."""
    def contrast(**settings):
        picture = draw(COLUMN, frames=60, sun_height=40, sun_direction=100, **settings)
        return picture.brightness(*on_ground(100)) - picture.brightness(*on_ground(280))

    clear, light, heavy = contrast(fog=0), contrast(snowfall=0.1), contrast(snowfall=10)
    assert 0.8 * clear < light < clear
    assert heavy < 0.7 * light


def test_lamp_lights_its_surroundings_at_dusk(draw):
    near, far = (0.7, 0, 0.7), (-7, 0, 7)
    night, without = draw(LAMP, sun_height=-6), draw(LAMP, sun_height=-6, lamp=0)
    assert night.brightness(*near) > 1.5 * without.brightness(*near)
    assert night.brightness(*near) - without.brightness(*near) \
        > 5 * (night.brightness(*far) - without.brightness(*far))
    red, green, blue = night.colour(*near)
    assert red > green > blue  # as the lamp
    assert night.brightness(0.2, 1.75, 0.2) > 200 > without.brightness(0.2, 1.75, 0.2)  # its glass
    assert (draw(LAMP, sun_height=20).pixels == draw(LAMP, sun_height=20, lamp=0).pixels).all()


def test_an_eye_below_the_snow_sees_no_black(draw):
    """Snow on open ground as high as the eye, and higher: no way to it, and so no direction."""
    picture = draw(COLUMN, frames=2, timelapse=1000, camera="41,-2,17", snowfall=10)
    assert picture.pixels.max(axis=2).min() > 0


def test_a_low_sun_is_warm_and_the_night_dark_and_blue(draw):
    ground = -5, 0, 5
    heights = [draw(COLUMN, sun_height=height, sun_direction=100).brightness(*ground)
               for height in (40, 8, -8)]
    assert heights == sorted(heights, reverse=True)
    red, _, blue = draw(COLUMN, sun_height=-8, sun_direction=100).colour(*ground)
    assert blue > 1.2 * red
    wall = 0.4, 1.5, 0
    low, high = (draw(COLUMN, sun_height=height, sun_direction=100).colour(*wall) for height in (8, 40))
    assert low[0] / low[2] > 1.2 * high[0] / high[2]


def test_under_a_roof_it_is_darker_without_any_sun(draw):
    below, open_sky = (2, 0, 2), (6.5, 0, 0)
    with_occlusion = draw(ROOF, sun_height=-1)
    without = draw(ROOF, sun_height=-1, occlusion=0)
    assert with_occlusion.brightness(*below) < 0.75 * without.brightness(*below)
    assert with_occlusion.brightness(*open_sky) > 0.9 * without.brightness(*open_sky)
