"""Reading pictures, and comparing them with those in reference/."""

import numpy
import PIL.Image
import pytest

import driver
from conftest import ROOT

REFERENCES = ROOT / "tests" / "reference"


def read(path):
    """Red, green and blue of every pixel, 0 to 255."""
    return numpy.asarray(PIL.Image.open(path).convert("RGB")).astype(int)


def check_picture(request, programs, name, actual):
    """Compares with the reference picture of that name, or makes a new one if that is asked for."""
    check_against(request, programs, REFERENCES / f"{name}.png", actual)


def check_against(request, programs, reference, actual):
    """Compares with the picture in that file, or makes a new one if that is asked for.

    At most 1 % of the pixels may differ by more than 24 of 255 levels in a channel.
    Mesa's rasterizer differs from release to release in the last bits: along the edges of triangles
    and sprites a pixel more or less is covered, by some levels. One flake that is elsewhere (see
    test_one_snowfall.py) changes 10 pixels, a fiftieth of 1 %. Flakes a tenth too large change
    16 %, a light a fifth too weak 47 %.
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
