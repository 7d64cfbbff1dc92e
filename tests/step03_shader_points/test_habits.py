"""Which crystals it snows at which temperature (step 3, and the winter's billboards)."""

import functools

import pytest

from pictures import read

STEPS = {"step03_shader_points": ["--variant", "texture"],
         "step06_accumulation": ["--scene", "none", "--voxels", 32, "--set", "fog=0"]}


@pytest.fixture(scope="module")
def draw(programs):
    """Large flakes that have not landed yet."""
    @functools.lru_cache(maxsize=None)
    def draw(step, *settings):
        path = programs.folder / "crystals.png"
        programs.run_well(step, *STEPS[step], "--size", "240x135", "--particles", 60, "--timelapse", 100,
                          "--frames", 5, "--set", "diameter_0=0.7", "--set", "diameter_1=1",
                          *(word for setting in settings for word in ("--set", setting)),
                          "--screenshot", path)
        return read(path)
    return draw


def changed(one, other):
    """The share of the pixels that differ; in the winter's grey sky by few of 255 levels."""
    return (abs(one - other).max(axis=2) > 8).mean()


# Two temperatures of each habit, in the order of the table in habit.glsl.
HABITS = [(-1, -3.9), (-4.1, -5.9), (-6.1, -9.9), (-10.1, -11.9), (-12.1, -15.9), (-16.1, -21.9),
          (-22.1, -29.9), (-30, -40)]


@pytest.mark.parametrize("step, habits", [("step03_shader_points", HABITS),
                                          ("step06_accumulation", HABITS[1:3])])
def test_temperature_picks_the_habit(draw, step, habits):
    """Within a range all flakes keep their picture; at its end they change it."""
    pictures = [[draw(step, f"temperature={degrees}") for degrees in habit] for habit in habits]
    for (warm, cold), (next_warm, _) in zip(pictures, pictures[1:]):
        assert changed(warm, cold) == 0
        assert changed(cold, next_warm) > 0.002


def test_plates_with_sectors_and_columns_grow_in_two_ranges(draw):
    warm, cold = ([draw("step03_shader_points", f"temperature={HABITS[row][0]}") for row in rows]
                  for rows in ((2, 3), (6, 5)))
    assert [changed(*pair) for pair in zip(warm, cold)] == [0, 0]


def test_the_heaviest_flakes_are_aggregates_at_any_temperature(draw):
    """One cloud's flakes, and next to nothing of the other's: a hundred times as wide, or as wide."""
    def change(*settings):
        warm, cold = (draw("step03_shader_points", f"temperature={degrees}", "variation=0", *settings)
                      for degrees in (-2, -5))
        return changed(warm, cold)
    assert change("diameter_0=1", "diameter_1=0.01") == 0
    assert change("diameter_0=0.01", "diameter_1=1") > 0.01
