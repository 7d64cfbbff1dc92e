"""What tests/soak.sh runs: see there."""

import os
import random
import re
import sys
import time

import pytest

from conftest import PATIENCE, STEPS, WITH_SCENE, Flakes, small

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "common"))
from test_window import OpenProgram  # noqa: E402

MINUTES = float(os.environ["SOAK_MINUTES"])
# All but Escape, and S, which would leave a picture each time.
KEYS = ["c", "t", "h", "space", "r", "w", "Tab", "Return", "ctrl+space", "F1", "1", "minus", "Left"]


def sums_hold(out):
    """The ledgers of steps 5 and 6: what came in is what is there and what has gone."""
    for line in re.findall(r"^(?:ledger|cover): .*", out, re.MULTILINE):
        whole, parts = ([sum(map(int, re.findall(r" (\d+)", side))) for side in line.split("=")])
        assert whole == parts, line


@pytest.mark.parametrize("step", STEPS)
def test_a_hand_that_does_not_rest(programs, tmp_path, step):
    """The same hand each time: its seed is the step's name."""
    program = OpenProgram(programs, tmp_path, step, "--size", "640x480", "--particles", 5000,
                          *(["--voxels", 64] if step in WITH_SCENE else []))
    hand = random.Random(step)
    window, done, end = program.window, 0, time.monotonic() + 60 * MINUTES
    point = lambda: (hand.randrange(640), hand.randrange(480))
    in_panel = lambda: (hand.randrange(20, 330), hand.randrange(20, 320))

    def drag(place):
        program.xdotool("mousemove", "--window", window, *place(), "mousedown", 1)
        for _ in range(hand.randrange(1, 6)):
            program.xdotool("mousemove", "--window", window, *place())
        program.xdotool("mouseup", 1)

    def hide_and_show():
        program.xdotool("windowunmap", window)
        program.xdotool("windowmap", window)

    deeds = 6 * [lambda: drag(in_panel)] + 2 * [lambda: drag(point)] + [
        lambda: program.press(hand.choice(KEYS)),
        lambda: program.xdotool("mousemove", "--window", window, *in_panel(),
                                "click", hand.choice([4, 5])),
        lambda: program.xdotool("windowsize", window, hand.randrange(1, 1200),
                                hand.randrange(1, 1000)),
        lambda: program.xdotool("windowsize", window, 640, 480),
        hide_and_show,
        lambda: program.hold_up(hand.choice([0.01, 0.3, 2]))]
    try:
        while time.monotonic() < end:
            hand.choice(deeds)()
            done += 1
            assert program.process.poll() is None, program.process.communicate()
        program.wait_for_frames()
        program.press("Tab")  # away from a number that is being typed, which would take Escape
        program.xdotool("mousemove", "--window", window, 600, 470, "click", 1)
        program.press("Escape")
        out, errors = program.process.communicate(timeout=PATIENCE)
    finally:
        program.process.kill()
    print(f"{step}: {done} deeds, {out.count(' flakes, ')} runs")
    assert (program.process.returncode, errors) == (0, "")
    sums_hold(out)


@pytest.mark.parametrize("step", STEPS)
def test_many_frames(programs, tmp_path, step):
    """1,000 steps in a frame, so many frames that they are a million, or 100,000 where there is a
    scene: a day, or half an hour, of snow. Numbers stay finite, and nothing is lost."""
    ticks = 100_000 if step in WITH_SCENE else 1_000_000
    out = programs.run_well(step, *small(step), "--particles", 200, "--timelapse", 1000, "--frames",
                            ticks // 1000, "--dump", tmp_path / "flakes.csv").stdout
    flakes = Flakes(tmp_path / "flakes.csv")
    assert abs(flakes.velocity).max() < 100 and (flakes.position[flakes.age >= 0] > -1000).all()
    sums_hold(out)
