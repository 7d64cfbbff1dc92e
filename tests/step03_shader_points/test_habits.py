"""Which crystals it snows at which temperature (step 3, and the winter's billboards)."""

import functools

import pytest

STEPS = {"step03_shader_points": ["--variant", "texture"],
         "step06_accumulation": ["--scene", "none", "--voxels", 32, "--set", "fog=0"]}


@pytest.fixture(scope="module")
def draw(programs):
    """Large flakes that have not landed yet."""
    @functools.lru_cache(maxsize=None)
    def draw(step, *settings):
        return programs.picture(step, *STEPS[step], "--size", "240x135", "--particles", 60, "--timelapse", 100,
                                "--frames", 5, "--set", "diameter_0=0.7", "--set", "diameter_1=1",
                                *(word for setting in settings for word in ("--set", setting)))
    return draw


def changed(one, other):
    """The share of the pixels that differ; in the winter's grey sky by few of 255 levels."""
    return (abs(one - other).max(axis=2) > 8).mean()


# Two temperatures of each habit, in the order of the table in habit.glsl.
HABITS = [(-1, -3.9), (-4.1, -5.9), (-6.1, -9.9), (-10.1, -11.9), (-12.1, -15.9), (-16.1, -21.9),
          (-22.1, -29.9), (-30, -40)]


@pytest.mark.parametrize("step, habits", [("step03_shader_points", HABITS), ("step06_accumulation", HABITS[1:3])])
def test_temperature_picks_the_habit(draw, step, habits):
    """Within a range all flakes keep their picture; at its end they change it."""
    pictures = [[draw(step, f"temperature={degrees}") for degrees in habit] for habit in habits]
    for (warm, cold), (next_warm, _) in zip(pictures, pictures[1:]):
        assert changed(warm, cold) == 0
        assert changed(cold, next_warm) > 0.002
