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

    def run(self, *arguments, script="common/run.sh", **environment):
        command = [self.root / script, *arguments]
        if os.geteuid() == 0:  # who may write everywhere, but for this
            command = [shutil.which("setpriv"), "--bounding-set=-dac_override", *command]
        return subprocess.run(command, cwd=self.root, env={"PATH": str(self.commands), **environment},
                              text=True, capture_output=True)


@pytest.fixture
def copy(tmp_path):
    return Copy(tmp_path)


def test_without_apt_it_says_what_to_install(copy):
    assert fails_with_one_line(copy.run("1"), 1, "no apt-get", "libglew-dev", "cmake --build build")


def test_on_macos_it_says_that_it_cannot(copy):
    assert fails_with_one_line(copy.run("1", OSTYPE="darwin23"), 1, "macOS", "README")


@pytest.mark.parametrize("script", ["common/run.sh", "tests/run.sh"])
def test_a_folder_that_cannot_be_written_is_noticed_at_once(copy, script):
    """Though nothing is installed yet, and nothing built."""
    folder = copy.root / "build"
    folder.mkdir()
    folder.chmod(0o555)
    assert fails_with_one_line(copy.run("3", script=script), 1, folder, "cannot be written")


@pytest.mark.parametrize("script", ["common/run.sh", "tests/run.sh"])
@pytest.mark.parametrize("fails, left, remedy", [("-S", 9999999, "remove its folder"), ("--build", 9999999, "compiler"),
                                                 ("-S", 12, "disk")])
def test_a_build_that_fails_ends_with_a_line_of_ours(copy, script, fails, left, remedy):
    (copy.commands / "df").unlink()
    for name, does in {"apt-get": "exit 99", "dpkg-query": "echo installed", "nproc": "echo 1",
                       "df": f"echo Filesystem; echo /dev/a 1 2 {left} 4% /",
                       "cmake": f'if [[ $1 == {fails} ]]; then echo "its own words"; exit 3; fi'}.items():
        copy.add(name, does)
    (copy.root / "build").mkdir()
    result = copy.run(script=script)
    assert result.returncode == 1
    _, words, line = result.stderr.splitlines()
    assert words == "its own words" and str(copy.root) in line and remedy in line
