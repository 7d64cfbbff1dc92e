"""The exercises of chapter 1: what each is promised to show, and its solution."""

import re

import numpy
import pytest

from conftest import SMALL

STEP = "step01_cpu_points"


def fall_speeds(flakes):
    """Of the flakes in the air and older than a second, m/s: of emitter 0's, and of emitter 1's."""
    fast = flakes.airborne & (flakes.age > 1)
    half = len(fast) // 2
    return [-flakes.velocity[which, 1][fast[which]].mean() for which in (slice(half), slice(half, None))]


def test_checkpoints(programs):
    """The counts that the chapter gives on the way."""
    def flakes(frames):
        return programs.flakes(STEP, "--frames", frames)
    assert (flakes(0).position[:, 1] == 1013).all() and -17.53 < flakes(0).age.min() < flakes(0).age.max() < -0.05
    assert [(flakes(frames).age >= 0).sum() for frames in (60, 120, 180, 240)] == [242, 941, 2052, 3619]
    last = flakes(900)
    assert [(last.age < 0).sum(), (last.rest > 0).sum(), last.airborne.sum()] == [387, 5840, 13773]


def test_exercise_1_how_fast_it_snows(programs):
    """To the two digits that the chapter gives."""
    assert fall_speeds(programs.flakes(STEP, "--frames", 900)) == pytest.approx([0.98, 1.47], abs=0.005)


def test_exercise_2_without_turbulence_flakes_fall_straight_down(programs):
    flakes = programs.flakes(STEP, "--frames", 900, "--set", "turbulence=0")
    assert (flakes.velocity[:, [0, 2]] == 0).all()
    # A hundredth: the mean of some 7,000 flakes whose speeds differ by up to 15 %.
    assert fall_speeds(flakes) == pytest.approx([1, 1.5], abs=0.01)


def test_exercise_3_flakes_that_lie_have_another_colour(edited):
    with edited(f"{STEP}/solutions/3.patch", build=STEP) as programs:
        red, _, blue = numpy.moveaxis(programs.picture(STEP, "--timelapse", 30, "--frames", 30), 2, 0)
    orange = (red == 255) & (blue < 100)
    rows, _ = numpy.nonzero(orange)
    assert orange.sum() > 5000  # of 5,800 flakes that lie, half 2 x 2 pixels large
    assert rows.min() > 300  # the ground begins 310 pixels below the upper edge


def test_exercise_4_the_other_order_is_another_snowfall(edited, programs):
    explicit = programs.flakes(STEP, "--frames", 900)
    with edited(f"{STEP}/solutions/4.patch", build=STEP) as changed:
        semi_implicit = changed.flakes(STEP, "--frames", 900)
        assert changed.dump(STEP, "--frames", 900, "--variant", "three-loops") == \
            programs.dump(STEP, "--frames", 900)
    same_life = explicit.airborne & semi_implicit.airborne & (abs(explicit.age - semi_implicit.age) < 0.01)
    shift = numpy.linalg.norm(explicit.position - semi_implicit.position, axis=1)[same_life]
    assert numpy.median(shift) == pytest.approx(0.02, abs=0.002)


@pytest.mark.parametrize("variant", ["one-loop", "three-loops"])
def test_exercise_5_loops_are_measured(programs, variant):
    """Which takes how long is the machine's; that there is an answer is ours."""
    result = programs.run_well(STEP, *SMALL, "--variant", variant, "--timelapse", 60, "--benchmark",
                               "--warmup", 15, "--frames", 20)
    assert re.search(r"^ +update +cpu +\d", result.stdout, re.MULTILINE)


def test_exercise_6_a_whirlwind_turns_the_snow(edited, programs):
    def turning(flakes):
        """Velocity of flakes in the air around the axis, m/s; by their distance from it, m."""
        x, _, z = flakes.position[flakes.airborne].T
        vx, _, vz = flakes.velocity[flakes.airborne].T
        distance = numpy.hypot(x, z)
        around = (vx * z - vz * x) / distance
        return [around[(distance > near) & (distance < far)].mean() for near, far in ((1.8, 2.2), (6, 8))]
    assert turning(programs.flakes(STEP, "--frames", 900)) == pytest.approx([0, 0], abs=0.05)
    with edited(f"{STEP}/solutions/6.patch", build=STEP) as changed:
        near, far = turning(changed.flakes(STEP, "--frames", 900))
    assert 2.8 < near < 3 and far == pytest.approx(1.6, abs=0.05)
