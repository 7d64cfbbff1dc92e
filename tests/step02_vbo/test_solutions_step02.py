"""The exercises of chapter 2: what each is promised to show, and its solution."""

import numpy
import pytest

from conftest import VARIANTS

STEP = "step02_vbo"
TEN_SECONDS = ["--size", "640x360", "--timelapse", 30, "--frames", 20]


def draw(there, *arguments):
    return there.picture(STEP, *arguments)


@pytest.mark.parametrize("variant", VARIANTS[STEP])
def test_exercise_1_all_variants_leave_the_flakes_of_step_1(programs, variant):
    assert (programs.dump(STEP, "--frames", 300, "--variant", variant)
            == programs.dump("step01_cpu_points", "--frames", 300))


def test_exercise_2_a_call_for_each_flake_draws_the_same(programs):
    assert (draw(programs, *TEN_SECONDS, "--groups", 20000)
            == draw(programs, *TEN_SECONDS)).all()


def test_exercise_3_velocities_are_colours(edited, programs):
    without = draw(programs, *TEN_SECONDS, "--particles", 0)
    with edited(f"{STEP}/solutions/3.patch", build=STEP) as changed:
        red, green, blue = numpy.moveaxis(draw(changed, *TEN_SECONDS), 2, 0)
    assert (green <= without[:, :, 1]).all()  # nothing moves up
    assert (red > 40).sum() > 1000 and (blue > 50).sum() > 1000


def test_exercise_4_one_region_draws_the_same(edited, programs):
    shown = [*TEN_SECONDS, "--variant", "persistent"]
    expected = draw(programs, *shown)
    with edited(f"{STEP}/solutions/4.patch", build=STEP) as changed:
        assert (draw(changed, *shown) == expected).all()


def test_exercise_5_positions_are_enough(edited, programs):
    expected = draw(programs, *TEN_SECONDS)
    with edited(f"{STEP}/solutions/5.patch", build=STEP) as changed:
        assert (draw(changed, *TEN_SECONDS) == expected).all()


def test_exercise_6_each_flake_draws_a_tail(edited, programs):
    shown = ["--size", "640x360", "--frames", 300, "--particles", 400, "--set", "turbulence=0"]

    def lit(there):
        """Pixels brighter than the lines of the ground are."""
        return (draw(there, *shown).min(axis=2) > 100).sum()
    with edited(f"{STEP}/solutions/6.patch", build=STEP) as changed:
        assert lit(changed) > 2 * lit(programs)
