"""A copy of the sources in which a test may try an edit: a chapter's wrong picture, a solution.

One copy for all tests of a build folder, in tests/edited of it. It is brought up to date when a
session first uses it, has one edit at a time (so ctest runs one of these files of tests after the other),
and builds no more than a test asks for.
"""

import contextlib
import os
import re
import subprocess

from conftest import PATIENCE, ROOT, STEPS, Programs

# What the copy is built like: as the build folder that is tested.
SETTINGS = ["CMAKE_BUILD_TYPE", "CMAKE_CXX_COMPILER", "CMAKE_CXX_COMPILER_LAUNCHER",
            "CMAKE_TOOLCHAIN_FILE", "SNOWFALL_NATIVE", "SNOWFALL_SANITIZE"]


class EditedCopy:
    """Called with a patch, of the source tree, it is for a `with`: inside, the edit is made.

    `build`: the program to build with it. An edit of shaders alone needs none.
    """

    def __init__(self, config, folder):
        self.config = config
        self.folder = folder  # where programs run
        self.build = config.getoption("build").resolve()
        self.home = self.build / "tests" / "edited"
        self.sources = self.home / "sources"
        self.is_current = False

    @contextlib.contextmanager
    def __call__(self, patch, build=None):
        changed = changed_files(patch)
        compiled = [name for name in changed if is_compiled(name)]
        assert build or not compiled, f"{patch} changes {compiled[0]}: build a program with it"
        if not self.is_current:
            self.bring_up_to_date()
        try:
            self.apply(patch)
            built = self.build_there(build) if build else self.build
            yield Programs(self.config, self.folder, built, {"SNOWFALL_DIR": str(self.sources)})
        finally:
            for name in changed:
                self.restore(name)

    def bring_up_to_date(self):
        """Whatever differs is copied; what does not keeps its time, and is not built again."""
        wanted, present = names_under(ROOT), names_under(self.sources)
        for name in wanted | present:
            self.restore(name)
        self.is_current = True

    def restore(self, name):
        """Makes the file in the copy what it is in the source tree, or gone."""
        original, copy = ROOT / name, self.sources / name
        if not original.exists():
            copy.unlink(missing_ok=True)
        elif not copy.exists() or copy.read_bytes() != original.read_bytes():
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_bytes(original.read_bytes())
            copy.chmod(original.stat().st_mode)

    def apply(self, patch):
        # As if the copy were in no repository: git would take the paths for those of one around it.
        alone = {**os.environ, "GIT_CEILING_DIRECTORIES": str(self.home)}
        run(["git", "apply", str(ROOT / patch)], cwd=self.sources, env=alone)

    def build_there(self, step):
        there = self.home / "build"
        cache = (self.build / "CMakeCache.txt").read_text()
        settings = [f"-D{name}={value}" for name, value in re.findall(r"^(\w+):\w+=(.+)$", cache, re.M)
                    if name in SETTINGS]
        generator = re.search(r"^CMAKE_GENERATOR:INTERNAL=(.+)$", cache, re.M)[1]
        run(["cmake", "-S", self.sources, "-B", there, "-G", generator, "-DSNOWFALL_TESTS=OFF", *settings])
        run(["cmake", "--build", there, "--parallel", str(os.cpu_count()), "--target", step])
        return there


def changed_files(patch):
    return sorted(set(re.findall(r"^(?:--- a|\+\+\+ b)/(.+)$", (ROOT / patch).read_text(), re.M)))


def is_compiled(name):
    """Is it read when the program is built, and not when it starts? The physics is both."""
    return name.endswith((".cpp", ".hpp", ".txt", "snow.glsl", "bindings.glsl"))


def names_under(folder):
    """Of all files that a build or a run needs."""
    tops = [folder / name for name in ["CMakeLists.txt", "common", *STEPS]]
    files = [path for top in tops for path in ([top] if top.is_file() else top.rglob("*"))]
    return {str(path.relative_to(folder)) for path in files if path.is_file()}


def run(command, **more):
    result = subprocess.run(command, capture_output=True, text=True, check=False,
                            timeout=5 * PATIENCE, **more)
    assert result.returncode == 0, f"{' '.join(map(str, command))}:\n{result.stdout}{result.stderr}"
