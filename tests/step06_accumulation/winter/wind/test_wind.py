"""Wind moves the snow about, but does not take it away: the air above the scene is full of flakes in any."""

import pytest

from reports import let_it_snow


def snow(programs, wind, frames, *arguments):
    """The mass of snow in the cells of a run, and where they are along x and z, m."""
    _, cover, _ = let_it_snow(programs, "--voxels", 64, "--timelapse", 300, "--frames", frames, *arguments,
                              "--set", f"wind_x={wind}")
    return cover.mass, cover.place[:, [0, 2]]


@pytest.mark.parametrize("emitter", [0, 1])
def test_an_open_plain_gets_its_due_in_any_wind(programs, emitter):
    """Of either emitter: the flakes of the other are too small to count. In the second minute, as in wind the first
    flakes come sooner. Some 15,000 come down, so chance is 1 %."""
    arguments = ["--variant", "cells", "--scene", "none", "--particles", 6000, "--set", f"diameter_{1 - emitter}=0.001"]
    def fallen(wind):
        return snow(programs, wind, 24, *arguments)[0].sum() - snow(programs, wind, 12, *arguments)[0].sum()
    due = fallen(0)
    for wind in (1, 7):
        assert fallen(wind) == pytest.approx(due, rel=0.05), wind


def test_the_court_gets_its_due_from_any_side(programs):
    """All of it, also the half behind the wing that stands against the wind. Where flakes were born so that the
    undisturbed wind took them to the court, that half got nothing. (A wake lets some of it down
    elsewhere.)"""
    arguments = ["--variant", "winter", "--particles", 10000]
    due, place = snow(programs, 0, 8, *arguments)
    for wind in (-5, 3, 5):
        mass, windy_place = snow(programs, wind, 8, *arguments)
        for axis in (0, 1):
            for side in (-1, 1):
                half = mass[windy_place[:, axis] * side > 0].sum()
                assert half > 0.75 * due[place[:, axis] * side > 0].sum(), (wind, axis, side)
