"""common/run.sh where it cannot work: one line that says what to do, and no long work before it."""

import os
import shutil
import subprocess

import pytest

from conftest import ROOT, STEPS, fails_with_one_line


class Copy:
    """The script with folders of steps to choose from, on a system that has only these commands."""

    def __init__(self, folder):
        self.root = folder / "Schöne Flocken"
        self.commands = folder / "commands"
        self.commands.mkdir()
        for name in ("awk", "bash", "basename", "cat", "df", "dirname", "grep", "readlink", "tail", "tee"):
            (self.commands / name).symlink_to(shutil.which(name))
        for step in STEPS:
            (self.root / step).mkdir(parents=True)
        for script in ("common/run.sh", "common/install.sh", "common/build.sh", "tests/run.sh"):
            (self.root / script).parent.mkdir(exist_ok=True)
            shutil.copy(ROOT / script, self.root / script)

    def add(self, name, does):
        script = self.commands / name
        script.write_text(f"#!{shutil.which('bash')}\n{does}\n")
        script.chmod(0o755)

    def run(self, *arguments, cwd=None, script="common/run.sh", **environment):
        command = [self.root / script, *arguments]
        if os.geteuid() == 0:  # who may write everywhere, but for this
            command = [shutil.which("setpriv"), "--bounding-set=-dac_override", *command]
        return subprocess.run(command, cwd=cwd or self.root, env={"PATH": str(self.commands), **environment},
                              text=True, capture_output=True)


@pytest.fixture
def copy(tmp_path):
    return Copy(tmp_path)


@pytest.fixture
def everything_installed(copy):
    copy.add("apt-get", "exit 99")
    copy.add("dpkg-query", "echo installed")
    copy.add("nproc", "echo 1")


def test_without_apt_it_says_what_to_install(copy):
    assert fails_with_one_line(copy.run("1"), 1, "no apt-get", "libglew-dev", "cmake --build build")


def test_on_macos_it_says_that_it_cannot(copy):
    assert fails_with_one_line(copy.run("1", OSTYPE="darwin23"), 1, "macOS", "README")


def test_no_such_step(copy):
    assert fails_with_one_line(copy.run("7"), 2, "'7'", "1 to 6")


@pytest.mark.parametrize("what, script", [("picture", "common/run.sh"), ("build", "common/run.sh"), ("build", "tests/run.sh")])
def test_a_folder_that_cannot_be_written_is_noticed_at_once(copy, tmp_path, what, script):
    """Though nothing is installed yet, and nothing built."""
    folder = tmp_path / "shut"
    folder.mkdir()
    if what == "build":
        folder = copy.root / "build"
        folder.mkdir()
    folder.chmod(0o555)
    result = copy.run("3", cwd=folder if what == "picture" else tmp_path, script=script)
    assert fails_with_one_line(result, 1, folder, "cannot be written")


@pytest.mark.parametrize("script", ["common/run.sh", "tests/run.sh"])
@pytest.mark.parametrize("fails, left, remedy", [("-S", 9999999, "remove its folder"), ("--build", 9999999, "compiler"),
                                                 ("-S", 12, "disk")])
def test_a_build_that_fails_ends_with_a_line_of_ours(copy, everything_installed, script, fails, left, remedy):
    copy.add("cmake", f'if [[ $1 == {fails} ]]; then echo "its own words"; exit 3; fi')
    (copy.commands / "df").unlink()
    copy.add("df", f"echo Filesystem; echo /dev/a 1 2 {left} 4% /")
    (copy.root / "build").mkdir()
    result = copy.run(script=script)
    assert result.returncode == 1
    _, words, line = result.stderr.splitlines()
    assert words == "its own words" and str(copy.root) in line and remedy in line


def test_a_crash_is_told(copy, everything_installed):
    copy.add("cmake", "")
    (copy.root / "build").mkdir()
    copy.add("xvfb-run", "exit 139")
    result = copy.run("1")
    assert result.returncode == 139
    assert "ended by a signal" in result.stderr.splitlines()[-1]
