"""Wind moves the snow about, but does not take it away: the air above the scene is full of flakes in any."""

import functools

import pytest

from conftest import SMALL
from reports import Cover

STEP = "step06_accumulation"


@pytest.fixture
def snow(programs, tmp_path):
    """The mass of snow in the columns of a run, and where they are along x, m."""
    @functools.cache
    def snow(wind, *arguments):
        path = tmp_path / "cover.csv"
        programs.run_well(STEP, *SMALL, "--voxels", 64, "--timelapse", 300, "--frames", 8, *arguments,
                          "--set", f"wind_x={wind}", "--dump-cover", path)
        cover = Cover(path)
        return cover.mass, cover.place[:, 0]
    return snow


@pytest.mark.parametrize("emitter", [0, 1])
def test_an_open_plain_gets_its_due_in_any_wind(snow, emitter):
    """Of either emitter: the flakes of the other are too small to count. Some 5,000 come down, so chance is 2 %."""
    arguments = ["--variant", "cells", "--scene", "none", "--particles", 6000, "--set", f"diameter_{1 - emitter}=0.001"]
    due = snow(0, *arguments)[0].sum()
    for wind in (1, 3, 5, 7):
        assert snow(wind, *arguments)[0].sum() == pytest.approx(due, rel=0.1), wind


def test_behind_the_wing_it_snows_on(snow):
    """The wing against the wind takes some, and what blows against it is born again. Where flakes were born so
    that only the undisturbed wind took them to the court, its far half got nothing."""
    arguments = ["--variant", "winter", "--particles", 10000]
    due, x = snow(0, *arguments)
    for wind in (3, 5):
        mass, windy_x = snow(wind, *arguments)
        assert mass.sum() > 0.8 * due.sum(), wind
        assert mass[windy_x > 0].sum() > 0.8 * due[x > 0].sum(), wind
