"""What all tests share: starting the programs as a user would, and reading what they leave."""

import ctypes
import functools
import os
import pathlib
import subprocess
import time

import numpy
import pytest

import driver

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Every program with its variants, the default first.
VARIANTS = {
    "step01_cpu_points": ["one-loop", "plain", "three-loops", "threads", "hexagons"],
    "step02_vbo": ["subdata", "orphan", "persistent", "arrays", "soa"],
    "step03_shader_points": ["disc", "texture"],
    "step04_transform_feedback": ["feedback", "texture", "compute", "geometry"],
    "step05_collision": ["voxels", "triangles", "boxes"],
    "step06_accumulation": ["winter", "cells", "heightmap"],
}
STEPS = list(VARIANTS)
STEP_VARIANTS = [(step, variant) for step in STEPS for variant in VARIANTS[step]]
WITH_SCENE = [step for step in STEPS if step >= "step05"]

# A hung program must fail its test, not stop the suite. Nothing here takes a tenth of this.
PATIENCE = float(os.environ.get("TEST_PATIENCE", 300))  # s


@functools.cache
def project_files():
    """All files of the project, as git lists them: not what a user has made or left beside them.

    What was downloaded as an archive has no list: there all files in the project's own folders count.
    """
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], text=True, check=False,
                            capture_output=True).stdout.split("\0")
    if "README.md" in listed:
        return sorted(ROOT / name for name in listed if name and (ROOT / name).exists())
    return sorted(path for top in ("common", "tests", *STEPS) for path in (ROOT / top).rglob("*")
                  if path.is_file())


def files_in(folder, pattern="*"):
    """Those below a folder, given relative to the project, whose name or end of the path fits the pattern."""
    return [path for path in project_files()
            if path.is_relative_to(ROOT / folder) and path.match(pattern)]


# A window this small costs nothing to draw, and the physics does not depend on it.
SMALL = ["--size", "64x64"]


def small(step):
    """The same, with a grid so coarse that it takes no time to make: the scene does not matter."""
    return [*SMALL, *(["--voxels", 32] if step in WITH_SCENE else [])]


def pytest_addoption(parser):
    parser.addoption("--build", default=os.environ.get("SNOWFALL_BUILD", ROOT / "build"),
                     type=pathlib.Path, help="folder that holds the programs")
    parser.addoption("--new-references", action="store_true",
                     help="make what is drawn now the reference pictures")
    parser.addoption("--driver", action="store_true",
                     help="test the OpenGL that is there, not Mesa's in software")


def pytest_configure(config):
    if not os.environ.get("DISPLAY"):
        pytest.exit("these tests open windows and DISPLAY is not set: use tests/run.sh", 1)
    config.addinivalue_line("markers", "only_software(reason): of Mesa's llvmpipe, no other driver")
    # The reference pictures are Mesa's.
    if not driver.is_asked_for(config):
        os.environ["LIBGL_ALWAYS_SOFTWARE"] = "1"
    # Nothing may be written outside the build folder; and hundreds of programs need not compile the
    # same shaders again.
    os.environ["XDG_CACHE_HOME"] = str(config.getoption("build").resolve() / "tests" / "cache")
    os.environ.pop("SNOWFALL_DIR", None)
    # An X server starts afresh when its last client leaves, in the face of the next program if that
    # is just coming in: so one client stays.
    ctypes.CDLL("libX11.so.6").XOpenDisplay(None)


def pytest_collection_modifyitems(config, items):
    driver.skip_what_only_software_promises(config, items)


def pytest_runtest_logreport(report):
    driver.note_outcome(report)


def pytest_terminal_summary(terminalreporter, config):
    if driver.is_asked_for(config):
        terminalreporter.section("to paste into an issue")
        for line in driver.table(Programs(config, None).driver()):
            terminalreporter.write_line(line)


class Flakes:
    """The flakes of a --dump, each quantity an array with a row for every flake."""

    def __init__(self, path):
        with open(path) as file:
            assert file.readline() == "index,x,y,z,age,vx,vy,vz,rest\n"
            rows = [line.split(",") for line in file]
        rows = numpy.array(rows, dtype=float).reshape(-1, 9)
        assert (rows[:, 0] == range(len(rows))).all()
        self.position = rows[:, 1:4]  # m
        self.age = rows[:, 4]         # s
        self.velocity = rows[:, 5:8]  # m/s
        self.rest = rows[:, 8]        # s
        self.airborne = (self.age >= 0) & (self.rest == 0)


class Programs:
    """Starts the programs of one build, always in `folder`, which is not theirs.

    `build`: another folder than that of --build. `environment`: variables to set for each run.
    """

    def __init__(self, config, folder, build=None, environment=None):
        self.config = config
        self.build = build or config.getoption("build").resolve()
        self.folder = folder
        self.environment = environment or {}

    def driver(self):
        """What the first line of a program says of it: renderer and OpenGL."""
        line = subprocess.run(self.command(STEPS[0], *SMALL, "--frames", 0), text=True, check=False,
                              stdout=subprocess.PIPE).stdout.partition("\n")[0]
        return ", ".join(line.partition(": ")[2].split(", ")[:-3])

    def preloaded(self, library):
        """The variables that load one of the tests' libraries into a program, after those loaded: by its bare name, as
        LD_PRELOAD is split at spaces, of which the build folder's path may have some."""
        names = [*os.environ.get("LD_PRELOAD", "").split(), f"lib{library}.so"]
        tests = self.config.getoption("build").resolve() / "tests"
        folders = [str(tests), *os.environ.get("LD_LIBRARY_PATH", "").split(":")]
        return {"LD_PRELOAD": " ".join(names), "LD_LIBRARY_PATH": ":".join(filter(None, folders))}

    def command(self, step, *arguments):
        return [str(self.build / step), *map(str, arguments)]

    def run(self, step, *arguments, environment=None, **more):
        """Runs `step` to its end. `environment`: variables to set, or with None to unset."""
        variables = {**os.environ, **self.environment, **(environment or {})}
        variables = {name: value for name, value in variables.items() if value is not None}
        result = subprocess.run(self.command(step, *arguments), env=variables, text=True,
                                capture_output=True, timeout=PATIENCE,
                                **{"cwd": self.folder, **more})
        driver.skip_if_refused(self.config, result.returncode, result.stderr)
        return result

    def run_well(self, step, *arguments, **more):
        """The same, and it must succeed without a word on stderr."""
        result = self.run(step, *arguments, **more)
        assert (result.returncode, result.stderr) == (0, "")
        return result

    def picture(self, step, *arguments, **more):
        """Red, green and blue of every pixel, 0 to 255, of the picture that a run with these arguments leaves."""
        from pictures import read  # which imports this file
        path = self.folder / "picture.png"
        self.run_well(step, *arguments, "--screenshot", path, **more)
        return read(path)

    def calls(self, step, *arguments):
        """What record_calls.cpp sees of a run with these arguments: a name and numbers for each call."""
        path = self.folder / "calls"
        path.write_text("")  # there may be none
        self.run_well(step, *small(step), *arguments,
                      environment={**self.preloaded("record_calls"), "CALLS_FILE": str(path)})
        for name, *numbers in map(str.split, path.read_text().splitlines()):
            yield name, *map(int, numbers)

    @functools.lru_cache(maxsize=None)
    def dump(self, step, *arguments):
        """The bytes of the dump after a run with these arguments; each is run only once."""
        path = self.folder / "flakes.csv"
        window = SMALL if "--voxels" in arguments else small(step)
        self.run_well(step, *window, *arguments, "--dump", path)
        content = path.read_bytes()
        path.unlink()
        return content

    @functools.lru_cache(maxsize=None)
    def flakes(self, step, *arguments):
        path = self.folder / "read.csv"
        path.write_bytes(self.dump(step, *arguments))
        return Flakes(path)


@pytest.fixture(scope="session")
def programs(request, tmp_path_factory):
    programs = Programs(request.config, tmp_path_factory.mktemp("runs"))
    missing = [step for step in STEPS if not (programs.build / step).is_file()]
    if missing:
        pytest.exit(f"{programs.build} holds no {', '.join(missing)}: build first (tests/run.sh does)", 1)
    return programs


@pytest.fixture(scope="session")
def edited(programs):
    """For `with edited("stepNN_name/solutions/1.patch", build="stepNN_name") as programs:`."""
    from edited_copy import EditedCopy  # which imports this file
    return EditedCopy(programs.config, programs.folder)


def fails_with_one_line(result, status, *words):
    """Did the program end with this status and one line on stderr that has all these words?"""
    print(result.stderr)  # pytest shows it if the test fails
    line = result.stderr
    return (result.returncode == status and line.endswith("\n") and line.count("\n") == 1
            and all(str(word) in line for word in words))


def wait_until(condition, what):
    """Polls until `condition()` is true and returns what it returned."""
    patience_ends = time.monotonic() + PATIENCE
    while not (result := condition()):
        assert time.monotonic() < patience_ends, f"waited {PATIENCE} s for {what}"
        time.sleep(0.01)
    return result
