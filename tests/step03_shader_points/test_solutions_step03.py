"""The exercises of chapter 3: what each is promised to show, and its solution."""

import numpy
import pytest

STEP = "step03_shader_points"
SNOW = ["--size", "640x360", "--timelapse", 30, "--frames", 40]
FAR = [*SNOW, "--camera", "41,15,60"]
LARGE = [*SNOW, "--particles", 300, "--set", "diameter_0=0.7", "--set", "diameter_1=1"]


def draw(there, *arguments):
    return there.picture(STEP, *arguments)


def test_exercise_1_the_corners_are_empty_anyway(edited, programs):
    expected = draw(programs, *SNOW)
    with edited(f"{STEP}/solutions/1.patch") as changed:
        assert (draw(changed, *SNOW) == expected).all()


def test_exercise_2_far_flakes_are_sharp_pixels(edited, programs):
    def white(picture):
        return (picture.min(axis=2) > 200).sum()
    assert white(draw(programs, *FAR)) == 0
    with edited(f"{STEP}/solutions/2.patch") as changed:
        assert white(draw(changed, *FAR)) > 1000


def test_exercise_3_hexagons_cover_less_than_discs(edited, programs):
    """In theory by 17 %; but of discs and hexagons alike the last pixels are too faint to be counted."""
    empty = draw(programs, *SNOW, "--particles", 0)

    def covered(there):
        return (draw(there, *LARGE) != empty).any(axis=2).sum()
    discs = covered(programs)
    with edited(f"{STEP}/solutions/3.patch") as changed:
        assert covered(changed) / discs == pytest.approx(7 / 8, abs=0.02)


def test_exercise_4_flakes_warm_up_on_their_way(edited):
    with edited(f"{STEP}/solutions/4.patch") as changed:
        red, _, blue = numpy.moveaxis(draw(changed, *SNOW), 2, 0)
    warmth = red - blue
    assert warmth[:60].mean() < -10  # the upper edge of the picture is right below the higher cloud
    assert warmth[200:260, 200:400].mean() > 5  # the middle of the ground


@pytest.mark.parametrize("distance, times", [(5, 3.9), (60, 1.2)])
def test_exercise_5_a_window_twice_as_large(programs, distance, times):
    def touched(size):
        shown = ["--timelapse", 30, "--frames", 40, "--size", size, "--camera", f"41,15,{distance}"]
        return (draw(programs, *shown, "--particles", 1000)
                != draw(programs, *shown, "--particles", 0)).any(axis=2).sum()
    assert touched("1280x720") / touched("640x360") == pytest.approx(times, abs=0.1)


def test_exercise_6_depth_of_field(edited, programs):
    """As much light on three times the pixels."""
    empty = draw(programs, *SNOW, "--particles", 0)

    def look(there):
        light = draw(there, *SNOW, "--particles", 2000) - empty
        return light.sum(), light.any(axis=2).sum()
    light, touched = look(programs)
    with edited(f"{STEP}/solutions/6.patch") as changed:
        blurred_light, blurred = look(changed)
    assert blurred_light == pytest.approx(light, rel=0.01)
    assert blurred / touched == pytest.approx(3, abs=0.15)
