"""The exercises of step 6: each solution does what the chapter says it will."""

import pytest

from reports import let_it_snow

STEP = "step06_accumulation"
HOUR = ["--variant", "cells", "--timelapse", 120, "--frames", 30, "--voxels", 128]  # a minute, in fact
NEAR = ["--variant", "cells", "--timelapse", 60, "--frames", 30, "--size", "640x360", "--camera", "41,15,8"]


def accumulate(there, *arguments):
    """Lets it snow for a minute: the cover, and the masses that lie, have melted, were deposited."""
    _, cover, sums = let_it_snow(there, *HOUR, *arguments)
    return cover, sums


def test_exercise_1_ten_times_the_flakes(programs):
    few, many = [accumulate(programs, "--particles", number)[1][2] for number in (2000, 20000)]
    assert few == pytest.approx(many, rel=0.02)


def test_exercise_2_mounds(programs):
    def depths(repose):
        """Mean depth over the first table, of the columns with snow there, and on open ground, m."""
        cover, _ = accumulate(programs, "--set", "snowfall=0.6", "--set", f"repose={repose}")
        x, y, z = cover.place.T
        table = (abs(x - 0.2) < 0.9) & (abs(z - 3.9) < 0.5) & (y > 0.7)
        ground = (abs(x) < 3) & (abs(z + 2) < 1.5) & (y < 2)
        columns = [len({tuple(place) for place in cover.place[where][:, [0, 2]].round(3)})
                   for where in (table, ground)]
        return [cover.depth[where].sum() / count for where, count in zip((table, ground), columns)]

    low, ground_then = depths(15)
    high, ground_now = depths(60)
    assert low == pytest.approx(0.25, abs=0.02) and high == pytest.approx(0.46, abs=0.03)
    assert ground_then == pytest.approx(ground_now, rel=0.1)


def test_exercise_3_thaw(programs):
    _, (_, melted, deposited) = accumulate(programs, "--set", "temperature=5")
    assert 0.4 < melted / deposited < 0.6


def test_exercise_4_contour_lines(programs, edited):
    with edited(f"{STEP}/solutions/4.patch") as there:
        lines = there.picture(STEP, *NEAR)
    change = (lines - programs.picture(STEP, *NEAR)).sum(axis=2)
    assert 0.03 < (change < -60).mean() < 0.3
    # A flake may land elsewhere from run to run, and with it what is bright: but for these, no pixel is brighter.
    assert (change > 60).mean() < 0.005


def test_exercise_5_snow_line(programs, edited):
    def high_and_low(there, temperature):
        cover, _ = accumulate(there, "--set", f"temperature={temperature}")
        y = cover.place[:, 1]
        return cover.mass[y > 2.6].sum(), cover.mass[y < 0.5].sum()

    with edited(f"{STEP}/solutions/5.patch") as there:
        high, low = high_and_low(there, 5)
    high_in_frost, low_in_frost = high_and_low(programs, -14)
    assert high == pytest.approx(high_in_frost, rel=0.001)
    assert 0.4 < low / low_in_frost < 0.6


def test_exercise_6_a_path_is_kept_clear(edited):
    with edited(f"{STEP}/solutions/6.patch", build=STEP) as there:
        cover, (_, melted, _) = accumulate(there)
    assert melted == 0
    x, _, z = cover.place.T
    along = (z > -4) & (z < 7.5)

    def depth(where, width):
        return cover.depth[where & along].sum() * cover.cell ** 2 / (width * 11.5)

    path = abs(x - 4) < 0.7
    edges = (abs(abs(x - 4) - 0.9) < 0.3)
    in_the_open = depth(abs(x) < 3, 6)
    assert depth(path, 1.4) < 0.01
    assert in_the_open > 0.05 and depth(edges, 1.2) > 1.5 * in_the_open
