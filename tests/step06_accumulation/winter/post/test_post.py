"""From light to the screen: edges, the glow around what is bright, what software leaves off."""

import functools

import numpy
import pytest

import scenes

STEP = "step06_accumulation"


@pytest.fixture(scope="module")
def draw(programs, tmp_path_factory):
    """Draws a lamp at night, without flakes; each picture only once."""
    folder = tmp_path_factory.mktemp("post")
    (folder / "lamp.mtl").write_text(scenes.GLASS)
    (folder / "lamp.obj").write_text(scenes.LAMP)

    @functools.lru_cache(maxsize=None)
    def draw(*words, size="320x180", height=-6):
        return programs.picture(STEP, "--size", size, "--particles", 0, "--voxels", 64, "--frames", 1, "--scene",
                                folder / "lamp.obj", "--set", "fog=0", "--set", f"sun_height={height}", *words)
    return draw


def test_bright_things_glow(draw):
    """Around the lamp it is brighter, the more the closer to it, and what is far is as it was."""
    without, glowing = draw("--set", "bloom=0"), draw("--set", "bloom=0.2")
    gain = (glowing - without).mean(axis=2)
    lamp = numpy.argwhere(without.mean(axis=2) > 200)
    middle = lamp.mean(axis=0)
    y, x = numpy.mgrid[0:180, 0:320]
    away = numpy.hypot(y - middle[0], x - middle[1])
    dark = without.mean(axis=2) < 100
    rings = [gain[dark & (away > near) & (away <= near + 6)].mean() for near in (8, 20, 40)]
    assert rings[0] > rings[1] > rings[2] and rings[0] > 10
    assert abs(gain[away > 120].mean()) < 3


@pytest.mark.parametrize("exposure", [0.1, 1, 10])
def test_the_screen_shows_what_an_eye_answers(draw, exposure):
    """The curve and the screen's numbers, as exact as tone.glsl says, and half a level for rounding."""
    shown = draw("--set", "scene=0", "--set", "sky=0", "--set", "bloom=0", "--set", f"exposure={exposure}")
    light = exposure * numpy.array([0.10, 0.13, 0.20])  # where there is no sky; see winter.cpp
    answer = (light / 0.65) ** 1.25 / (1 + (light / 0.65) ** 1.25)
    expected = 255 * numpy.where(answer < 0.0031308, 12.92 * answer, 1.055 * answer ** (1 / 2.4) - 0.055)
    assert (abs(shown - expected) <= 3.3 + 0.5).all()


@pytest.mark.parametrize("size", ["1x1", "3x200", "321x181"])
def test_glow_at_any_size(draw, size):
    """Also where half of a size is no whole number, or nothing."""
    assert (draw("--set", "bloom=0.2", size=size) > 0).any()


def test_edges_are_smooth(draw):
    """The column of the lamp before the sky: with samples there are colours between the two."""
    rough, smooth = (draw("--set", f"multisample={on}", "--set", "bloom=0", height=40) for on in (0, 1))
    few, many = (len(numpy.unique(picture.reshape(-1, 3), axis=0)) for picture in (rough, smooth))
    changed = abs(rough - smooth).max(axis=2) > 8
    assert 20 < changed.sum() < 0.05 * changed.size  # along edges, and nowhere else
    assert many > few


@pytest.mark.only_software(reason="a card draws all that is on")
def test_software_leaves_off_what_is_costly(programs):
    """And says so; but what --set asks for it draws."""
    def left_off(*words):
        output = programs.run_well(STEP, "--size", "64x64", "--voxels", 32, "--frames", 1, *words).stdout
        lines = [line for line in output.splitlines() if line.startswith("left off")]
        return lines[0].partition(": ")[2].split(", ") if lines else []
    assert left_off() == ["tessellation", "soft_shadows", "multisample", "bloom"]
    assert left_off("--set", "multisample=1", "--set", "bloom=0") == ["tessellation", "soft_shadows"]
    assert left_off("--set", "tessellation=1", "--set", "soft_shadows=1", "--set", "multisample=1",
                    "--set", "bloom=0.1") == []
    assert left_off("--variant", "cells") == []
