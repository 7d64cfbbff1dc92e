"""The pictures in the chapters, right and wrong: each is what its command draws.

Beside a wrong picture lies the edit that makes it: wrong.patch beside wrong.png. The command stands in
the chapter, and ends with --screenshot and the picture's name. After a change that is meant to be
seen: pytest test_wrong_pictures.py --new-references.
"""

import re

import pytest

from chapters import CHAPTERS, chapter
from conftest import ROOT, files_in
from edited_copy import changed_files, is_compiled
from pictures import check_against, read

COMMAND = r"build/(step\w+) ([^\n`]*--screenshot ([\w-]+)\.png)"


def commands(folder):
    """Name of the picture: program and arguments."""
    lines = re.sub(r" *\\\n *", " ", chapter(folder))
    return {name: (step, arguments.split()) for step, arguments, name in re.findall(COMMAND, lines)
            if (ROOT / folder / f"{name}.png").exists()}


def patches(folder):
    return {path.stem for path in files_in(folder, f"{folder}/*.patch")}


@pytest.mark.parametrize("folder", CHAPTERS)
def test_every_edit_has_its_picture_and_command(folder):
    assert patches(folder) <= set(commands(folder))


@pytest.mark.parametrize("folder, name", [(folder, name) for folder in CHAPTERS
                                          for name in sorted(commands(folder))])
def test_picture_is_what_its_command_draws(request, programs, edited, tmp_path, folder, name):
    step, arguments = commands(folder)[name]

    def draw(there):
        there.run_well(step, *arguments, cwd=tmp_path)
        check_against(request, ROOT / folder / f"{name}.png", read(tmp_path / f"{name}.png"))
    if name not in patches(folder):
        return draw(programs)
    patch = f"{folder}/{name}.patch"
    build = step if any(map(is_compiled, changed_files(patch))) else None
    with edited(patch, build=build) as changed:
        draw(changed)
