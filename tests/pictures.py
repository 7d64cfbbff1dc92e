"""Reading pictures, and comparing them with those in reference/."""

import numpy
import PIL.Image
import pytest

import driver
from conftest import ROOT

REFERENCES = ROOT / "tests" / "reference"


class Camera:
    """One as --camera has it, in a window of that size: where it sees a point."""

    HALF_VIEW = 0.82 / 2  # radians, from the middle of the window to its upper edge

    def __init__(self, azimuth, elevation, distance, size):
        azimuth, elevation = numpy.radians([azimuth, elevation])
        self.back = numpy.array([numpy.cos(elevation) * numpy.sin(azimuth), numpy.sin(elevation),
                                 numpy.cos(elevation) * numpy.cos(azimuth)])
        self.right = numpy.array([numpy.cos(azimuth), 0, -numpy.sin(azimuth)])
        self.eye = (0, 1.6, 0) + distance * self.back
        self.width, self.height = size

    def scale(self, points):
        """How many pixels a metre is there."""
        return self.height / 2 / numpy.tan(self.HALF_VIEW) / ((self.eye - points) @ self.back)

    def pixels(self, points):
        """From the left and from above."""
        sight, scale = points - self.eye, self.scale(points)
        return numpy.stack([self.width / 2 + scale * (sight @ self.right),
                            self.height / 2 - scale * (sight @ numpy.cross(self.back, self.right))], axis=-1)


def read(path):
    """Red, green and blue of every pixel, 0 to 255."""
    return numpy.asarray(PIL.Image.open(path).convert("RGB")).astype(int)


def check_picture(request, name, actual):
    """Compares with the reference picture of that name, or makes a new one if that is asked for."""
    check_against(request, REFERENCES / f"{name}.png", actual)


def check_against(request, reference, actual):
    """Compares with the picture in that file, or makes a new one if that is asked for.

    At most 1 % of the pixels may differ by more than 24 of 255 levels in a channel.
    Mesa's rasterizer differs from release to release in the last bits, along the edges of triangles and sprites. One
    flake that is elsewhere (see test_one_snowfall.py) changes 10 pixels, a fiftieth of 1 %. Flakes a tenth too large
    change 16 %, a light a fifth too weak 47 %.
    """
    if request.config.getoption("new_references"):
        PIL.Image.fromarray(actual.astype(numpy.uint8)).save(reference, optimize=True)
    expected = read(reference)
    assert actual.shape == expected.shape
    difference = abs(actual - expected)
    share = (difference.max(axis=2) > 24).mean()
    if share > 0.01 and driver.is_asked_for(request.config):
        pytest.skip(f"only llvmpipe promises the reference picture: {100 * share:.1f} % of the pixels differ")
    if share > 0.01:
        saved = request.config.getoption("build").resolve() / "pictures"
        name = "_".join(reference.relative_to(ROOT).with_suffix("").parts[-2:])
        saved.mkdir(exist_ok=True)
        for kind, picture in (("actual", actual), ("expected", expected),
                              ("difference", difference)):
            PIL.Image.fromarray(picture.astype(numpy.uint8)).save(saved / f"{name}_{kind}.png")
        pytest.fail(f"{100 * share:.1f} % of the pixels differ: see the pictures "
                    f"{saved}/{name}_actual.png, ..._expected.png and ..._difference.png")
