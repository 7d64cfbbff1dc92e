"""How step 6 draws and weighs its flakes: where they are, as bright as they should be, as heavy as large."""

import numpy
import pytest

import scenes
from conftest import Flakes
from pictures import Camera
from reports import let_it_snow

STEP = "step06_accumulation"
SIZE = WIDTH, HEIGHT = 480, 270
CAMERA = Camera(40, 5, 30, SIZE)  # all flakes are in the picture


def steps(count):
    """So many steps, 20 a frame, as drawing takes the time."""
    assert count % 20 == 0
    return ["--timelapse", 20, "--frames", count // 20]


@pytest.fixture
def draw(programs, tmp_path):
    """The picture of an empty plain in the snow, as numbers from 0 to 255, and the flakes in it."""
    def draw(*arguments):
        picture = programs.picture(STEP, "--size", f"{WIDTH}x{HEIGHT}", "--scene", "none", "--voxels", 32,
                                   "--camera", "40,5,30", "--set", "bloom=0", *arguments,
                                   "--dump", tmp_path / "flakes.csv")
        return picture, Flakes(tmp_path / "flakes.csv")
    return draw


def near(places, radius):
    """The pixels whose middle is no further than so many pixels from one of these places."""
    y, x = numpy.mgrid[0:HEIGHT, 0:WIDTH] + 0.5
    mask = numpy.zeros((HEIGHT, WIDTH), dtype=bool)
    for place_x, place_y in places:
        mask |= (x - place_x) ** 2 + (y - place_y) ** 2 <= radius ** 2
    return mask


def radiance(picture):
    """The light of which tone.glsl has made this picture, by the inverse of its curve."""
    shown = picture / 255
    answer = numpy.where(shown < 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)
    return 0.65 * (answer / (1 - answer)) ** 0.8


def test_billboards_are_where_the_flakes_are(draw):
    """Every flake is seen where it is, and nowhere else is anything to be seen."""
    shared = [*steps(400), "--set", "diameter_0=0.4", "--set", "diameter_1=0.4"]
    picture, flakes = draw("--particles", 12, *shared)
    empty, _ = draw("--particles", 0, *shared)
    changed = abs(picture - empty).max(axis=2)
    places = CAMERA.pixels(flakes.position[flakes.airborne])
    assert len(places) >= 4
    for place in places:
        assert changed[near([place], 1)].max() > 8
    places = CAMERA.pixels(flakes.position[flakes.age >= 0])
    assert changed[~near(places, 5)].max() <= 1


def test_brightness_does_not_depend_on_speed(draw):
    """What falls some pixels in a frame is a streak, fainter than what hardly moves, but in sum it sends
    as much light here, for its size. So the picture does not flash where a frame takes long."""
    shared = ["--particles", 100, "--set", "melt_time=0", "--set", "diameter_0=0.25",
              "--set", "diameter_1=0.25", "--set", "sky=0", "--set", "fog=0", "--set", "scene=0", "--set", "around=0",
              "--set", "snowfall=0"]  # white ground would light them more the longer it snows
    light, area = [], []
    for count, speed in ((500, []), (40, ["--set", "gravity=-30", "--set", "speed_0=200",
                                          "--set", "speed_1=300"])):
        picture, flakes = draw(*steps(count), *speed, *shared)
        brightness = (radiance(picture) - radiance(picture[0, 0])).sum(axis=2)
        scale = CAMERA.scale(flakes.position[flakes.airborne])
        light.append(brightness.sum() / (scale ** 2).sum())
        area.append((abs(picture - picture[0, 0]).sum(axis=2) > 6).sum() / flakes.airborne.sum())
    assert area[1] > 1.5 * area[0]
    # 0.05: a hundred flakes of some pixels scatter by 3 %, and fast ones hide each other a little more.
    assert light[1] == pytest.approx(light[0], rel=0.05)


def test_hail_bounces(programs):
    """Also where a floor lies on the ground, as in the courtyard."""
    for step in ("step05_collision", STEP):
        hail = programs.flakes(step, "--weather", "hail", "--particles", 1000, *steps(200),
                               "--voxels", 64, "--seed", 7)
        rising = hail.velocity[:, 1] > 0.5
        assert rising.sum() > 30
        # 0.3 of at most 18 m/s + 15 %: up to 2 m above the roof's ridge, at 4.6 m.
        assert hail.position[rising, 1].max() < 7
        assert (hail.position[rising, 1] < 0.5).sum() > 10


@pytest.fixture
def deposit(programs, tmp_path):
    """Mass that has come to lie on open ground after so many steps of hail, of how many stones, and where."""
    (tmp_path / "floor.obj").write_text(scenes.text(scenes.FLOOR))

    def deposit(count, *arguments):
        entries, cover, (_, _, mass) = let_it_snow(
            programs, "--scene", tmp_path / "floor.obj", "--voxels", 64, "--weather", "hail", *steps(count),
            "--set", "melt_time=0.3", "--set", "settling=0", *arguments)
        return mass, entries["deposited"], cover
    return deposit


def test_mass_of_a_flake_is_that_of_its_size(deposit):
    """Two stones, one of each cloud, leave two heaps: their masses are as the cubes of diameters."""
    _, count, cover = deposit(320, "--particles", 2, "--set", "variation=0", "--set", "snowfall=0.01")
    assert count == 2
    away = abs(cover.place - cover.place[0])[:, [0, 2]].max(axis=1)
    heaps = sorted(cover.mass[near_first].sum() for near_first in (away < 5 * cover.cell,
                                                                   away >= 5 * cover.cell))
    assert heaps[1] / heaps[0] == pytest.approx((0.05 / 0.035) ** 3, rel=0.001)
    assert len(cover.mass) == 50  # 25 columns each


@pytest.mark.parametrize("lifetime", [40, 4])
def test_depth_in_a_minute_is_as_stated(deposit, lifetime):
    """With stones that differ and bounce, over 50 seconds: 18 times around the pool.

    Whether all come down, or a seventh is lost in the air on the way, of over a second with bounces.
    """
    more = ["--particles", 1000, "--set", "snowfall=0.2", "--set", f"lifetime={lifetime}"]
    before, _, cover = deposit(200, *more)
    after, _, _ = deposit(3200, *more)
    depth = (after - before) / cover.full * cover.cell ** 3 / 16 ** 2  # m: the clouds are 16 m wide
    assert depth == pytest.approx(0.2 * 50 / 60, rel=0.05)


def test_flakes_lighter_than_a_unit_weigh_as_much_together(deposit):
    """As those of a pool of ten million do in large cells: a hundred thousandth of the snow, from as many stones."""
    shared = [800, "--particles", 1000]
    heavy, _, _ = deposit(*shared, "--set", "snowfall=1")
    light, _, _ = deposit(*shared, "--set", "snowfall=1e-5")
    # 5 %: of 4000 stones half a unit each, one or none, three standard deviations.
    assert light == pytest.approx(1e-5 * heavy, rel=0.05)
