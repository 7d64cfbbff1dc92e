"""Fewer flakes where frames take too long (step 6), each the heavier."""

import re

import pytest

from conftest import SMALL
from reports import ledger, let_it_snow

STEP = "step06_accumulation"


def test_fewer_flakes_make_as_deep_a_cover(programs):
    masses = []
    for live in (1, 0.3):
        _, _, (_, _, deposited) = let_it_snow(
            programs, "--particles", 6000, "--weather", "hail", "--voxels", 64, "--timelapse", 100, "--frames", 8,
            "--set", "melt_time=0.5", "--set", "settling=0", "--set", f"live={live}")
        masses.append(deposited)
    assert masses[1] == pytest.approx(masses[0], rel=0.05)


def test_a_part_of_next_to_nothing(programs):
    """Of three flakes one of either cloud lives."""
    programs.run_well(STEP, *SMALL, "--particles", 3, "--voxels", 64, "--frames", 30,
                      "--set", "live=0.01", "--debug")


def test_it_gives_way_to_a_load_and_recovers(programs):
    """At 6 frames a second: 20 that take twice too long, then enough fast ones. No flake is lost."""
    result = programs.run_well(STEP, *SMALL, "--particles", 3000, "--voxels", 64, "--weather", "hail",
                               "--set", "melt_time=0.3", "--set", "tessellation=0",
                               "--hold-fps", 6, "--frames", 250,
                               environment={**programs.preloaded("count_swaps"),
                                            "SWAPS_LOAD": "20 39 350 25"})
    said = re.findall(r"^holding 6 fps: (\d+) % of the flakes live$", result.stdout, re.MULTILINE)
    shares = [100, *map(int, said)]
    assert min(shares) <= 60 and shares[-1] >= 70
    turns = sum((b - a) * (c - b) < 0 for a, b, c in zip(shares, shares[1:], shares[2:]))
    assert turns <= 3  # one of them is the load's end
    ledger(result.stdout)
