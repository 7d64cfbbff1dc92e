"""The chapters, each step's README.md: what they quote is what the sources and the measurements say."""

import difflib
import re
import shutil
import subprocess
import urllib.parse
import xml.etree.ElementTree as xml

import pytest

from chapters import CHAPTERS, blocks, chapter, prose, section
from conftest import ROOT, STEPS, files_in

COMPARISON = ROOT / "common" / "compare" / "example" / "compare.md"
SOURCES = (".cpp", ".hpp", ".glsl", ".vert", ".frag", ".geom", ".comp", ".tesc", ".tese")


def words(text):
    """Without the white space, in which a quotation may differ."""
    return " ".join(text.split())


def sources(folder):
    """Of a chapter: what is the winter's is not step 6's."""
    inside = [other for other in CHAPTERS if other.startswith(f"{folder}/")]
    beside = (ROOT / folder).with_suffix(".cpp")  # the winter's winter.cpp
    return [path for path in [beside, *files_in(folder)]
            if path.suffix in SOURCES and path.exists()
            and not any(path.is_relative_to(ROOT / other) or path == (ROOT / other).with_suffix(".cpp")
                        for other in inside)]


def so_far(folder):
    """The chapters up to this one."""
    return CHAPTERS[:CHAPTERS.index(folder) + 1]


# ---- The text.

@pytest.mark.parametrize("folder", CHAPTERS)
def test_sections_are_those_of_every_chapter(folder):
    number = CHAPTERS.index(folder) + 1
    before = "What a particle system is" if number == 1 else f"What is wrong with step {number - 1}"
    if folder not in STEPS:
        before = "What is wrong with step 6"
    headings = re.findall(r"^## (.*)", chapter(folder), re.MULTILINE)
    assert headings == [before, "Build it", "Under the hood", "Variants", "When it is wrong", "Measured",
                        "Exercises", "Further reading"]
    if folder in STEPS:
        assert chapter(folder).startswith(f"# Step {number}: ")
        last = chapter(folder).rstrip().splitlines()[-1]
        assert last.startswith("Next: ") and (number == len(STEPS) or f"{STEPS[number]}/main.cpp" in last)


@pytest.mark.parametrize("folder", CHAPTERS)
def test_length(folder):
    """Long enough to explain, short enough to be read: code and tables are not counted."""
    assert 1500 <= len(prose(folder).split()) <= 3500


@pytest.mark.parametrize("folder", CHAPTERS)
def test_every_stage_ends_in_a_checkpoint(folder):
    stages = re.split(r"^### ", section(folder, "Build it"), flags=re.MULTILINE)[1:]
    assert 4 <= len(stages) <= 8
    for number, stage in enumerate(stages, start=1):
        assert stage.startswith(f"{number}. ") and "**Checkpoint:**" in stage, stage.partition("\n")[0]


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
    texts = [words(path.read_text(encoding="utf-8")) for path in files if path.suffix in SOURCES]
    for quotation in blocks(folder, "cpp", "glsl"):
        assert any(words(quotation) in text for text in texts), quotation


def lines_of_code(text):
    """Without comments, and what is common to all files: #includes from common, and lone brackets."""
    lines = [words(line.partition("//")[0]) for line in text.splitlines()]
    return [line for line in lines
            if re.search(r"\w", line) and not re.match(r'#include "common/|#pragma once', line)]


def used_by(step, name="main.cpp", found=()):
    """The sources in the step's folder that this one needs: headers, their modules, and shaders."""
    found = {*found, name}
    text = (ROOT / step / name).read_text(encoding="utf-8")
    for other in re.findall(rf'"{step}/([\w/]+\.\w+)"', text):
        for part in (other, re.sub("hpp$", "cpp", other)):
            if part.endswith(SOURCES) and part not in found and (ROOT / step / part).exists():
                found |= used_by(step, part, found)
    return found


def copied(step):
    """The sources that the chapter hands over, as they teach nothing new."""
    paragraphs = re.findall(r"^\*\*Copy as they are:\*\*.*?\n\n", chapter(step), re.DOTALL | re.MULTILINE)
    return re.findall(r"\]\(([\w/]+\.\w+)\)", " ".join(paragraphs))


@pytest.mark.parametrize("step", STEPS)
def test_all_that_is_new_is_listed(step):
    """Each line that main.cpp has and the step before has not, and the files that it uses."""
    new = {name: lines_of_code((ROOT / step / name).read_text(encoding="utf-8")) for name in used_by(step)}
    if step != STEPS[0]:
        before = ROOT / STEPS[STEPS.index(step) - 1] / "main.cpp"
        known = lines_of_code(before.read_text(encoding="utf-8"))
        new["main.cpp"] = [line[2:] for line in difflib.ndiff(known, new["main.cpp"]) if line[0] == "+"]
    for name in copied(step):
        del new[name]
    listed = {line for block in blocks(step, "cpp", "glsl") for line in lines_of_code(block)}
    missing = [f"{name}: {line}" for name, lines in new.items() for line in lines if line not in listed]
    assert not missing, "\n".join(missing)


def test_what_the_winter_adds_is_listed():
    """What winter.cpp has and main.cpp has not, and the shaders that the stages take out, to be written again."""
    folder = "step06_accumulation/winter"
    command = " ".join(re.findall(r"^    rm (.*)", section(folder, "Build it"), re.MULTILINE))
    names = subprocess.run(["bash", "-c", f"ls {command}"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    new = {name: lines_of_code((ROOT / name).read_text(encoding="utf-8")) for name in names.split()}
    main, winter = (lines_of_code((ROOT / "step06_accumulation" / name).read_text(encoding="utf-8"))
                    for name in ("main.cpp", "winter.cpp"))
    new["winter.cpp"] = [line[2:] for line in difflib.ndiff(main, winter) if line[0] == "+"
                         and not line.startswith("+ #include")]
    listed = {line for block in blocks(folder, "cpp", "glsl") for line in lines_of_code(block)}
    missing = [f"{name}: {line}" for name, lines in new.items() for line in lines if line not in listed]
    assert not missing, "\n".join(missing)


def test_the_winter_can_be_written_from_its_chapter(tmp_path):
    """Each stage takes out its shaders; then each listing goes into the file named last before it, and all is as it was."""
    folder = "step06_accumulation/winter"
    shutil.copytree(ROOT / folder, tmp_path / folder)
    files = {path: path.read_text(encoding="utf-8") for path in (tmp_path / folder).rglob("*") if path.suffix in SOURCES}
    named = None
    for stage in re.split(r"^### ", section(folder, "Build it"), flags=re.MULTILINE)[1:]:
        for command in re.findall(r"^    ((?:rm|sed) .*)", stage, re.MULTILINE):
            subprocess.run(["bash", "-c", command], cwd=tmp_path, check=True)
        to_write = {path for path, text in files.items() if not path.exists() or path.read_text(encoding="utf-8") != text}
        for text, language, listing in re.findall(r"(.*?)^```(\w+)\n(.*?)^```", stage, re.DOTALL | re.MULTILINE):
            text = re.sub(r"^    .*", "", text, flags=re.MULTILINE)
            named = next((path for name in reversed(re.findall(r"\w+\.\w+", text)) for path in to_write
                          if path.name == name), named)
            if language == "glsl" and named in to_write:
                with named.open("a", encoding="utf-8") as file:
                    file.write(listing)
        for path in to_write:
            assert path.exists(), path.name
            assert words(path.read_text(encoding="utf-8")) == words(files[path]), path.name


@pytest.mark.parametrize("step", [step for step in STEPS if step < "step06"])
def test_all_that_is_other_in_a_variant_is_listed(step):
    """Step 6 has one, the winter, with a chapter of its own."""
    own = [path.name for path in files_in(step, f"{step}/*.cpp") if not path.with_suffix(".hpp").exists()]
    main = lines_of_code((ROOT / step / "main.cpp").read_text(encoding="utf-8"))
    listed = {line for block in blocks(step, "cpp", "glsl") for line in lines_of_code(block)}
    for name in own:
        for file in used_by(step, name) - {"main.cpp", *copied(step)}:
            lines = lines_of_code((ROOT / step / file).read_text(encoding="utf-8"))
            if file == name:  # the function is declared in main.cpp; of headers the text tells
                lines = [line[2:] for line in difflib.ndiff(main, lines) if line[0] == "+"
                         and not re.match(r"void run_|#include <", line[2:])]
            missing = [line for line in lines if line not in listed]
            assert not missing, f"{file}: " + "\n".join(missing)


@pytest.mark.parametrize("folder", CHAPTERS)
def test_new_calls_are_explained(folder):
    """Each call of OpenGL that the series makes here for the first time, with its arguments."""
    def calls(one):
        text = " ".join(path.read_text(encoding="utf-8") for path in sources(one))
        return set(re.findall(r"\b(gl[A-Z]\w+)\(", re.sub("//.*", "", text)))
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
        return [changes(path.read_text(encoding="utf-8")) for path in files_in(folder, f"{folder}/{names}")]
    quoted = [changes(block) for block in blocks(folder, "diff")]
    for one in quoted:
        assert one in patches("*.patch") + patches("solutions/*.patch"), "\n".join(one)
    for one in patches("*.patch"):
        assert one in quoted, "\n".join(one)


@pytest.mark.parametrize("folder", CHAPTERS)
def test_options_named_are_options(programs, folder):
    """Those of the step, or of git, cmake, common/compare/compare.py and common/run.sh."""
    text = re.sub(r"^```(cpp|glsl|diff).*?^```", "", chapter(folder), flags=re.DOTALL | re.MULTILINE)
    text = re.sub(r"`(git|cmake|common/)[^`]*`|^ *(git|cmake|common/).*", "", text, flags=re.MULTILINE)
    known = programs.run_well(folder.partition("/")[0], "--help").stdout
    for option in re.findall(r"--[a-z]\w*(?:-\w+)*", text):
        assert option in known, option
    for name in re.findall(r"--set (\w+)=", text):
        assert re.search(rf"\b{name} +-?\d", known), name


# ---- Pictures, figures and links.

def anchors(text):
    """What GitHub makes of the headings."""
    headings = re.findall(r"^#+ (.*)", re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE),
                          re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


@pytest.mark.parametrize("folder", [*CHAPTERS, "common", "."])
def test_links_lead_somewhere(folder):
    """Those to the network are only looked at: whether they are well formed."""
    links = re.findall(r"\]\(([^)]+)\)", re.sub(r"^```.*?^```", "", chapter(folder), flags=re.DOTALL | re.MULTILINE))
    assert links
    for link in links:
        url = urllib.parse.urlsplit(link)
        if url.scheme:
            assert url.scheme == "https" and re.fullmatch(r"[\w-]+(\.[\w-]+)+", url.netloc) and " " not in link
            continue
        path = ROOT / folder / url.path
        assert path.exists(), link
        if url.fragment:
            page = path / "README.md" if path.is_dir() and url.path else path
            page = ROOT / folder / "README.md" if not url.path else page
            assert url.fragment in anchors(page.read_text(encoding="utf-8")), link


@pytest.mark.parametrize("folder", [*CHAPTERS, "."])
def test_pictures_are_described(folder):
    """Each has a text for those who do not see it."""
    shown = dict(re.findall(r"!\[([^\]]*)\]\(([^)]+)\)", chapter(folder)))
    assert shown and all(len(text.split()) > 3 for text in shown)


@pytest.mark.parametrize("folder", CHAPTERS)
def test_pictures_are_shown(folder):
    """All in the chapter's folder, but for those that a program reads."""
    shown = dict(re.findall(r"!\[([^\]]*)\]\(([^)]+)\)", chapter(folder)))
    present = {str(path.relative_to(ROOT / folder)) for names in ("*.png", "figures/*.svg")
               for path in files_in(folder, f"{folder}/{names}")}
    code = " ".join(path.read_text(encoding="utf-8") for path in sources(folder))
    assert {name for name in present if f"{folder}/{name}" not in code} <= set(shown.values())


FIGURES = [str(path.relative_to(ROOT)) for top in ["common", *STEPS]
           for path in files_in(top, "figures/*.svg")]


@pytest.mark.parametrize("figure", FIGURES)
def test_figure_is_drawn_like_the_others(figure):
    """Small, with its own pale ground, text as text, a title and a description, and nothing from elsewhere."""
    path = ROOT / figure
    assert path.stat().st_size < 30_000
    root = xml.fromstring(path.read_text(encoding="utf-8"))
    svg = "{http://www.w3.org/2000/svg}"
    assert root.tag == f"{svg}svg" and "viewBox" in root.attrib
    for name in ("title", "desc"):
        assert root.find(f"{svg}{name}").text.strip()
    ground = root.find(f"{svg}rect")
    assert (ground.get("width"), ground.get("height"), ground.get("fill")) == ("100%", "100%", "#f6f8fa")
    assert root.iter(f"{svg}text")
    for element in root.iter():
        assert element.tag.removeprefix(svg) not in ("script", "image", "foreignObject"), element.tag
        assert float(element.get("font-size", "14").removesuffix("px")) >= 14
        assert not any("href" in name and not value.startswith("#") for name, value in element.items())


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
    numbers = exercises[::2]
    assert numbers == [str(number + 1) for number in range(len(numbers))] and 4 <= len(numbers) <= 6
    file = f"test_solutions_{folder.rpartition('/')[2].partition('_')[0]}.py"  # pytest wants no name twice
    tests = (ROOT / "tests" / folder / file).read_text(encoding="utf-8")
    tests = dict(re.findall(r"^def test_exercise_(\d+)\w*\((.*?)(?=^\S|\Z)", tests, re.DOTALL | re.MULTILINE))
    assert sorted(tests) == numbers
    patches = {path.stem for path in files_in(folder, f"{folder}/solutions/*.patch")}
    assert patches <= set(numbers)
    for number, text in zip(numbers, exercises[1::2]):
        assert "*Expect" in text
        assert (number in patches) == (f"solutions/{number}.patch" in tests[number]), number
        assert (number in patches) == (f"(solutions/{number}.patch)" in text), number
