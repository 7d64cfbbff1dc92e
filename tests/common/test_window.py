"""The window as its user handles it: frames counted, resized, hidden, closed, held up."""

import csv
import ctypes
import os
import re
import signal
import subprocess
import time

import numpy
import PIL.Image
import pytest

import driver
from conftest import (PATIENCE, SMALL, STEPS, STEP_VARIANTS, Flakes, fails_with_one_line, small,
                      wait_until)

# Runs until it is closed, then leaves a dump: more frames than anyone waits for.
FOREVER = ["--realtime", "--frames", 1000000000]


class OpenProgram:
    """A program that is running, and the hand on its window."""

    def __init__(self, programs, folder, step, *arguments, environment=None):
        self.step = step
        self.config = programs.config
        self.process = subprocess.Popen(programs.command(step, *arguments), cwd=folder, text=True,
                                        env={**os.environ, **(environment or {})},
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.window = wait_until(self.search, "a window")
        self.wait_for_frames()

    def search(self):
        if self.process.poll() is not None:
            output = self.process.communicate()
            driver.skip_if_refused(self.config, self.process.returncode, output[1])
            pytest.fail(str(output))
        return self.xdotool("search", "--name", f"^{self.step}")

    def xdotool(self, *arguments):
        # Not checked: a search finds nothing at first, and a window may close before its key is up.
        return subprocess.run(["xdotool", *map(str, arguments)], text=True, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout.strip()

    def title(self):
        assert self.process.poll() is None, self.process.communicate()
        return self.xdotool("getwindowname", self.window)

    def wait_for_frames(self):
        """Until the title, which shows the frame time twice a second, has changed: frames go on."""
        before = self.title()
        wait_until(lambda: self.title() not in (before, ""), "the title to change")

    def press(self, key):
        self.xdotool("key", "--window", self.window, key)

    def picture(self, folder):
        """What S saves in the folder that the program runs in: a frame after all pressed before."""
        path = folder / f"{self.step}.png"
        path.unlink(missing_ok=True)
        self.press("s")
        wait_until(path.exists, "a picture")
        return path.read_bytes()

    def press_close_button(self):
        """Sends the message that a window manager sends; none runs here, and xdotool cannot."""
        x11 = ctypes.CDLL("libX11.so.6")
        x11.XOpenDisplay.restype = ctypes.c_void_p
        display, window = ctypes.c_void_p(x11.XOpenDisplay(None)), ctypes.c_ulong(int(self.window))
        protocols, close = (x11.XInternAtom(display, name, 0) for name in (b"WM_PROTOCOLS", b"WM_DELETE_WINDOW"))
        # XClientMessageEvent of Xlib.h: type, serial, send_event, display, window, message_type, format, data.
        event = (ctypes.c_long * 24)(33, 0, 0, 0, window.value, protocols, 32, close)
        x11.XSendEvent(display, window, 0, ctypes.c_long(0), event)
        x11.XCloseDisplay(display)

    def hold_up(self, seconds):
        """Stops the program as a debugger or a busy machine would, and lets it go on."""
        self.process.send_signal(signal.SIGSTOP)
        wait_until(lambda: ") T " in open(f"/proc/{self.process.pid}/stat").read(), "the program to stop")
        time.sleep(seconds)  # not to wait for anything: this is the hitch
        self.process.send_signal(signal.SIGCONT)

    def ends_well(self):
        """And what it has said."""
        said, errors = self.process.communicate(timeout=PATIENCE)
        assert (self.process.returncode, errors) == (0, "")
        return said


@pytest.fixture
def open_program(programs, tmp_path):
    running = []

    def open_program(step, *arguments, **more):
        running.append(OpenProgram(programs, tmp_path, step, *arguments, **more))
        return running[-1]

    yield open_program
    for program in running:
        if program.process.poll() is None:
            program.process.kill()
            program.process.wait()


@pytest.mark.parametrize("step", STEPS)
def test_frames_asked_for_are_frames_shown(programs, tmp_path, step):
    count = tmp_path / "count"
    programs.run_well(step, *small(step), "--frames", 37, "--warmup", 5,
                      environment={**programs.preloaded("count_swaps"), "SWAPS_FILE": str(count)})
    assert int(count.read_text()) == 37 + 5


@pytest.mark.parametrize("step", [STEPS[3], STEPS[-1]])
def test_timelapse_makes_the_same_steps_in_fewer_frames(programs, step):
    assert programs.dump(step, "--frames", 30, "--timelapse", 3) == programs.dump(step, "--frames", 90)


@pytest.mark.parametrize("step", [STEPS[0], STEPS[-1]])
def test_record_leaves_a_picture_of_every_frame_that_counts(programs, tmp_path, step):
    """Of the warm-up none. The folder is made, and the last picture is that of --screenshot."""
    folder = tmp_path / "new" / "film"
    programs.run_well(step, *SMALL, "--frames", 3, "--warmup", 2, "--tour", "--record", folder,
                      "--screenshot", tmp_path / "last.png")
    names = sorted(file.name for file in folder.iterdir())
    assert names == ["000001.png", "000002.png", "000003.png"]
    assert (folder / "000003.png").read_bytes() == (tmp_path / "last.png").read_bytes()


def test_camera_stands_where_it_is_told_and_flies_the_same_way_twice(programs, tmp_path):
    """Seen in pictures of the scene alone."""
    def picture(*arguments):
        programs.run_well("step05_collision", *SMALL, "--particles", 0, "--voxels", 32, *arguments,
                          "--screenshot", tmp_path / "picture.png")
        return (tmp_path / "picture.png").read_bytes()

    assert (picture("--frames", 1) == picture("--frames", 1, "--camera", "41.2529612,15.4698602,17.5")
            != picture("--frames", 1, "--camera", "221.25,15.47,17.5"))
    flight = picture("--frames", 60, "--tour")
    assert flight == picture("--frames", 60, "--tour", "--warmup", 5)
    assert flight != picture("--frames", 30, "--tour")


@pytest.mark.parametrize("step", STEPS)
def test_where_its_window_is_closed_the_files_asked_for_are_there(open_program, tmp_path, step):
    """OpenGL must not be gone with it before the flakes and the picture are read back. (After Escape: see below.)"""
    program = open_program(step, *small(step), *FOREVER, "--dump", "flakes.csv", "--screenshot", "last.png")
    program.press_close_button()
    program.ends_well()
    assert Flakes(tmp_path / "flakes.csv").airborne.any()
    picture = numpy.asarray(PIL.Image.open(tmp_path / "last.png").convert("RGB"))
    assert picture.shape == (64, 64, 3) and (picture != picture[0, 0]).any()  # not the empty background


@pytest.mark.parametrize("step, variant", [pair for pair in STEP_VARIANTS if pair[0] >= "step04"])
def test_a_context_that_is_lost_leaves_no_old_flakes(programs, tmp_path, step, variant):
    """They were the GPU's, and it no longer answers: an error, and no file that looks like a result."""
    result = programs.run(step, *small(step), "--variant", variant, "--particles", 100, "--frames", 9,
                          "--dump", tmp_path / "flakes.csv",
                          environment={**programs.preloaded("count_swaps"), "SWAPS_LOSE": "1"})
    assert fails_with_one_line(result, 1, "cannot read back the flakes")
    assert "ledger" not in result.stdout
    assert list(tmp_path.iterdir()) == []


def test_the_title_shows_the_frame_time_without_glut(programs, open_program):
    """Whose way to change it ends the program where no window manager runs (freeglut 3.8)."""
    program = open_program("step01_cpu_points", *SMALL, environment=programs.preloaded("no_title"))
    program.wait_for_frames()
    assert "ms a frame" in program.title()
    program.press("Escape")
    program.ends_well()


@pytest.mark.parametrize("step", [STEPS[0], STEPS[2], STEPS[-1]])
def test_resizing(open_program, tmp_path, step):
    """To a new size, seen in what the S key saves; to a single pixel and back; and to none."""
    program = open_program(step, *small(step))
    picture = tmp_path / f"{step}.png"

    def saved_size():
        program.press("s")
        return picture.exists() and PIL.Image.open(picture).size

    for size in ((300, 200), (1, 1), (120, 150)):
        program.xdotool("windowsize", program.window, *size)
        wait_until(lambda: saved_size() == size, f"a picture of {size}")
    program.xdotool("windowunmap", program.window)  # as a window manager minimises it
    program.wait_for_frames()
    program.press("Escape")
    program.ends_well()


def test_mouse_turns_the_camera_and_c_turns_it_back(open_program, tmp_path):
    """Seen in two pictures without snow: only the scene can change."""
    step = "step05_collision"
    program = open_program(step, *small(step), "--particles", 0)
    program.press("h")  # the panel, which would catch the mouse, is as large as this window
    view = lambda: program.picture(tmp_path)

    def changes_view(action, back):
        before = view()
        action()
        wait_until(lambda: view() != before, "another view")
        back()
        wait_until(lambda: view() == before, "the first view")

    mouse = lambda *arguments: program.xdotool("mousemove", "--window", program.window, 20, 20,
                                               *arguments)
    drag = lambda: mouse("mousedown", 1, "mousemove_relative", 10, 5, "mouseup", 1)
    changes_view(drag, lambda: program.press("c"))
    changes_view(lambda: mouse("click", 4), lambda: mouse("click", 5))
    changes_view(lambda: program.press("t"), lambda: program.press("c"))  # off on the tour
    program.press("Escape")
    program.ends_well()


def test_tab_is_not_held_for_ever(open_program):
    """It leads into a slider, if a frame sees it, which Escape then leaves before it quits."""
    program = open_program("step05_collision", "--size", "500x400", "--voxels", 32, "--particles", 0)
    program.press("Tab")
    wait_until(lambda: program.press("Escape") or program.process.poll() is not None, "the end")
    program.ends_well()


def test_keys(open_program, tmp_path):
    """H hides the panel and all it costs, space pauses, R begins anew."""
    program = open_program("step01_cpu_points", *small("step01_cpu_points"), "--csv", "times.csv")
    picture = lambda: program.picture(tmp_path)
    wait_until(lambda: len({picture() for _ in range(2)}) == 2, "snow that moves")
    program.press("space")
    wait_until(lambda: len({picture() for _ in range(5)}) == 1, "a pause")
    program.press("space")
    wait_until(lambda: len({picture() for _ in range(2)}) == 2, "snow that moves again")
    program.press("h")
    picture()
    program.press("r")  # what was measured before is forgotten
    picture()
    program.press("h")
    picture()
    program.press("Escape")
    assert program.ends_well().count("step01_cpu_points one-loop: ") == 2
    with open(tmp_path / "times.csv", newline="") as file:
        drawn = [row["panel_cpu_ms"] != "" for row in csv.DictReader(file)]
    first = drawn.index(True)
    assert not any(drawn[:first]) and all(drawn[first:]) and 0 < first


def test_panel_changes_flakes_and_variant(open_program, tmp_path):
    """Clicks down a column that crosses the slider of the flakes and the second variant's button."""
    program = open_program("step02_vbo", "--size", "1100x700", "--dump", "flakes.csv", *FOREVER)
    for y in range(100, 400, 12):
        program.xdotool("mousemove", "--window", program.window, 130, y)
        for button in ("mousedown", "mouseup"):
            program.picture(tmp_path)  # a frame in between, or the panel sees no click
            program.xdotool(button, 1)
    program.picture(tmp_path)
    program.press("Escape")
    out = program.ends_well()
    runs = re.findall(r"^step02_vbo (\w+): .*, (\d+) flakes of ", out, re.MULTILINE)
    assert runs[0] == ("subdata", "20000")
    variants, counts = zip(*runs)
    assert variants[-1] == "orphan" and counts[-1] != "20000"
    assert len(Flakes(tmp_path / "flakes.csv").age) == int(counts[-1])


@pytest.mark.parametrize("step", STEPS)
def test_a_hitch_loses_nothing(programs, open_program, tmp_path, step):
    """Frames that take 0.1 and 1 s: the snow only slows down. After K steps, made in however large bunches, the flakes
    are those of a run that made K steps one by one, to the byte. It hails, so that thousands of flakes land."""
    hail = ["--weather", "hail", "--set", "melt_time=20"]
    start = time.monotonic()
    program = open_program(step, *small(step), *hail, *FOREVER, "--dump", "flakes.csv")
    hitches = [0.1, 1]
    for seconds in hitches:
        program.hold_up(seconds)
        program.wait_for_frames()
    program.press("Escape")
    program.ends_well()
    run_time = time.monotonic() - start - sum(hitches)

    # The steps made, from the age of the flake that waits longest.
    flakes, unborn = Flakes(tmp_path / "flakes.csv"), programs.flakes(step, *hail, "--frames", 0)
    last = unborn.age.argmin()
    assert flakes.age[last] < 0
    steps = round((flakes.age[last] - unborn.age[last]) * 60)
    # The clock asks for 60 a second; of each hitch at most 8 steps are caught up.
    assert 0 < steps <= 60 * run_time + 8 * len(hitches) + 1
    one_by_one = programs.dump(step, *hail, "--frames", steps)
    assert (tmp_path / "flakes.csv").read_bytes() == one_by_one
