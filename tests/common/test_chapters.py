"""The chapters, each step's README.md: what they quote is what the sources and the measurements say."""

import difflib
import re
import shutil
import subprocess
import urllib.parse

import pytest

from chapters import CHAPTERS, blocks, chapter, section, without_listings
from conftest import ROOT, STEPS, files_in

COMPARISON = ROOT / "common" / "compare" / "example" / "compare.md"
SOURCES = (".cpp", ".hpp", ".glsl", ".vert", ".frag", ".geom", ".comp", ".tesc", ".tese")
WINTER = "step06_accumulation/winter"


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


def words(text):
    """Without the white space, in which a quotation may differ."""
    return " ".join(text.split())


def sources(folder):
    """The winter has winter.cpp, and step 6 the rest."""
    if folder == WINTER:
        return [ROOT / "step06_accumulation/winter.cpp", *(path for path in files_in(folder) if path.suffix in SOURCES)]
    return [path for path in files_in(folder) if path.suffix in SOURCES and "winter" not in str(path.relative_to(ROOT))]


def so_far(folder):
    """The chapters up to this one."""
    return CHAPTERS[:CHAPTERS.index(folder) + 1]


# ---- Listings.

@pytest.mark.parametrize("folder", [*CHAPTERS, "."])
def test_listings_fit_the_page(folder):
    """GitHub shows 112 characters in a row; what is longer must be pulled to the side to be read."""
    commands = re.findall(r"^ {4}(\S.*)", chapter(folder), re.MULTILINE)
    for line in [*"".join(blocks(folder, "cpp", "glsl", "text", "sh")).splitlines(), *commands]:
        assert len(line) <= 112, line


@pytest.mark.parametrize("folder", CHAPTERS)
def test_quoted_code_is_in_the_sources(folder):
    """In one file of the step, of an earlier one, or of what they share."""
    files = {path for one in so_far(folder) for path in sources(one)} | set(files_in("common"))
    texts = [words(read(path)) for path in files if path.suffix in SOURCES]
    for quotation in blocks(folder, "cpp", "glsl"):
        assert any(words(quotation) in text for text in texts), quotation


def lines_of_code(text):
    """Without comments, and what is common to all files: #includes from common, and lone brackets."""
    lines = [words(line.partition("//")[0]) for line in text.splitlines()]
    return [line for line in lines
            if re.search(r"\w", line) and not re.match(r'#include "common/|#pragma once', line)]


def added(before, after):
    """The lines of code that the second file has and the first has not."""
    return [line[2:] for line in difflib.ndiff(lines_of_code(read(before)), lines_of_code(read(after)))
            if line[0] == "+"]


def assert_listed(folder, new):
    """new: for names of files the lines that the chapter has to list."""
    listed = {line for block in blocks(folder, "cpp", "glsl") for line in lines_of_code(block)}
    missing = [f"{name}: {line}" for name, lines in new.items() for line in lines if line not in listed]
    assert not missing, "\n".join(missing)


def used_by(step, name="main.cpp", found=()):
    """The sources in the step's folder that this one needs: headers, their modules, and shaders."""
    found = {*found, name}
    for other in re.findall(rf'"{step}/([\w/]+\.\w+)"', read(f"{step}/{name}")):
        for file in (other, re.sub("hpp$", "cpp", other)):
            if file.endswith(SOURCES) and file not in found and (ROOT / step / file).exists():
                found |= used_by(step, file, found)
    return found


def copied(step):
    """The sources that the chapter hands over, as they teach nothing new."""
    paragraphs = re.findall(r"^\*\*Copy as they are:\*\*.*?\n\n", chapter(step), re.DOTALL | re.MULTILINE)
    return re.findall(r"\]\(([\w/]+\.\w+)\)", " ".join(paragraphs))


@pytest.mark.parametrize("step", STEPS)
def test_all_that_is_new_is_listed(step):
    """Each line that main.cpp has and the step before has not, and the files that it uses."""
    new = {name: lines_of_code(read(f"{step}/{name}")) for name in used_by(step) - set(copied(step))}
    if step != STEPS[0]:
        new["main.cpp"] = added(f"{STEPS[STEPS.index(step) - 1]}/main.cpp", f"{step}/main.cpp")
    assert_listed(step, new)


@pytest.mark.parametrize("step", [step for step in STEPS if step < "step06"])
def test_all_that_is_other_in_a_variant_is_listed(step):
    """Step 6 has one, the winter, with a chapter of its own."""
    for name in [path.name for path in files_in(step, f"{step}/*.cpp") if not path.with_suffix(".hpp").exists()]:
        new = {file: lines_of_code(read(f"{step}/{file}"))
               for file in used_by(step, name) - {"main.cpp", *copied(step)}}
        if name in new:  # its function is declared in main.cpp; of headers the text tells
            new[name] = [line for line in added(f"{step}/main.cpp", f"{step}/{name}")
                         if not re.match(r"void run_|#include <", line)]
        assert_listed(step, new)


def test_what_the_winter_adds_is_listed():
    """What winter.cpp has and main.cpp has not. Shaders: see below."""
    new = added("step06_accumulation/main.cpp", "step06_accumulation/winter.cpp")
    assert_listed(WINTER, {"winter.cpp": [line for line in new if not line.startswith("#include")]})


def test_the_winter_can_be_written_from_its_chapter(tmp_path):
    """Each stage takes out its shaders; then each listing goes into the file named last before it: all is as it was."""
    shutil.copytree(ROOT / WINTER, tmp_path / WINTER)
    files = {path: read(path) for path in (tmp_path / WINTER).rglob("*") if path.suffix in SOURCES}
    named = None
    for stage in re.split(r"^### ", section(WINTER, "Build it"), flags=re.MULTILINE)[1:]:
        for command in re.findall(r"^    (rm .*)", stage, re.MULTILINE):
            subprocess.run(["sh", "-c", command], cwd=tmp_path, check=True)
        to_write = {path for path in files if not path.exists()}
        for text, language, listing in re.findall(r"(.*?)^```(\w+)\n(.*?)^```", stage, re.DOTALL | re.MULTILINE):
            text = re.sub(r"^    .*", "", text, flags=re.MULTILINE)
            named = next((path for name in reversed(re.findall(r"\w+\.\w+", text)) for path in to_write
                          if path.name == name), named)
            if language == "glsl" and named in to_write:
                named.write_text(listing, encoding="utf-8")
                to_write.remove(named)
        assert not to_write
    for path, text in files.items():
        assert words(read(path)) == words(text), path.name


@pytest.mark.parametrize("folder", CHAPTERS)
def test_new_calls_are_explained(folder):
    """Each call of OpenGL that the series makes here for the first time, with its arguments."""
    def calls(one):
        return set(re.findall(r"\b(gl[A-Z]\w+)\(", re.sub("//.*", "", " ".join(map(read, sources(one))))))
    new = calls(folder).difference(*map(calls, so_far(folder)[:-1]))
    explained = set(re.findall(r"`(gl[A-Z]\w+)\(", chapter(folder)))
    assert new <= explained, sorted(new - explained)


def changes(diff):
    """The lines that a diff adds and removes."""
    return [line for line in diff.splitlines() if re.match(r"[+-](?![+-]{2} )", line)]


@pytest.mark.parametrize("folder", CHAPTERS)
def test_edits_quoted_are_those_in_the_folder(folder):
    """Each diff in the chapter is a patch beside it, and the patch of each wrong picture is quoted."""
    def patches(names):
        return [changes(read(path)) for path in files_in(folder, f"{folder}/{names}")]
    quoted = [changes(block) for block in blocks(folder, "diff")]
    assert all(one in patches("*.patch") + patches("solutions/*.patch") for one in quoted)
    assert all(one in quoted for one in patches("*.patch"))


@pytest.mark.parametrize("folder", CHAPTERS)
def test_options_named_are_options(programs, folder):
    """Those of the step, or of git, cmake, common/compare/compare.py and common/run.sh."""
    text = re.sub(r"`(git|cmake|common/)[^`]*`|^ *(git|cmake|common/).*", "", without_listings(folder), flags=re.M)
    known = programs.run_well(folder.partition("/")[0], "--help").stdout
    for option in re.findall(r"--[a-z]\w*(?:-\w+)*", text):
        assert option in known, option
    for name in re.findall(r"--set (\w+)=", text):
        assert re.search(rf"\b{name} +-?\d", known), name


# ---- Links.

def anchors(page):
    """What GitHub makes of the headings."""
    headings = re.findall(r"^#+ (.*)", without_listings(page), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


@pytest.mark.parametrize("folder", [*CHAPTERS, "common", "."])
def test_links_lead_somewhere(folder):
    """Within the project."""
    for link in re.findall(r"\]\(([^)]+)\)", without_listings(folder)):
        url = urllib.parse.urlsplit(link)
        if url.scheme:
            continue
        path = ROOT / folder / url.path
        assert path.exists(), link
        if url.fragment:
            page = path.parent if path.is_file() else path
            assert url.fragment in anchors(page.resolve().relative_to(ROOT)), link


# ---- Measurements and exercises.

@pytest.mark.parametrize("folder", CHAPTERS)
def test_measured_times_are_those_of_the_comparison(folder):
    rows = re.findall(r"^\| step.*", chapter(folder), re.MULTILINE)
    assert any(row.startswith(f"| {folder.partition('/')[0]} ") for row in rows)
    assert set(rows) <= set(COMPARISON.read_text(encoding="utf-8").splitlines())


@pytest.mark.parametrize("folder", CHAPTERS)
def test_every_exercise_is_tested(folder):
    """It says what to expect; a test in test_solutions_step01.py, say, does it, with its patch if it is an edit."""
    exercises = re.split(r"^(\d+)\. ", section(folder, "Exercises"), flags=re.MULTILINE)[1:]
    file = f"test_solutions_{folder.rpartition('/')[2].partition('_')[0]}.py"  # pytest wants no name twice
    tests = dict(re.findall(r"^def test_exercise_(\d+)\w*\((.*?)(?=^\S|\Z)", read(f"tests/{folder}/{file}"),
                            re.DOTALL | re.MULTILINE))
    assert sorted(tests) == exercises[::2]
    patches = {path.stem for path in files_in(folder, f"{folder}/solutions/*.patch")}
    for number, text in zip(exercises[::2], exercises[1::2]):
        assert "*Expect" in text
        assert (number in patches) == (f"solutions/{number}.patch" in tests[number]), number
        assert (number in patches) == (f"(solutions/{number}.patch)" in text), number
