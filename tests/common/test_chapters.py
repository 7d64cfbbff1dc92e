"""The chapters, each step's README.md: what they quote is what the sources and the measurements say."""

import re

import pytest

from conftest import ROOT, STEPS

COMPARISON = ROOT / "common" / "compare" / "example" / "compare.md"


CHAPTERS = [*STEPS, "step06_accumulation/winter"]


def chapter(folder):
    return (ROOT / folder / "README.md").read_text(encoding="utf-8")


def words(text):
    """Without the white space, in which a quotation may differ."""
    return " ".join(text.split())


@pytest.mark.parametrize("step", STEPS)
def test_quoted_code_is_in_the_sources(step):
    quotations = re.findall(r"```\w+\n(.*?)```", chapter(step), re.DOTALL)
    sources = [words(path.read_text(encoding="utf-8")) for path in (ROOT / step).rglob("*")
               if path.suffix in (".cpp", ".hpp", ".glsl", ".vert", ".frag", ".comp")]
    for quotation in quotations:
        assert any(words(quotation) in source for source in sources), quotation


@pytest.mark.parametrize("folder", [*CHAPTERS, "common", "."])
def test_links_lead_somewhere(folder):
    links = re.findall(r"\]\(([^)]+)\)", chapter(folder))
    assert links
    for link in links:
        assert (ROOT / folder / link).exists(), link


@pytest.mark.parametrize("folder", CHAPTERS)
def test_measured_times_are_those_of_the_comparison(folder):
    rows = re.findall(r"^\| step.*", chapter(folder), re.MULTILINE)
    assert any(row.startswith(f"| {folder.partition('/')[0]} ") for row in rows)
    assert set(rows) <= set(COMPARISON.read_text(encoding="utf-8").splitlines())


@pytest.mark.parametrize("folder", CHAPTERS)
def test_options_named_are_options(programs, folder):
    """Those of the step, or of git, common/compare/compare.py and common/run.sh."""
    text = re.sub(r"`(git|common/)[^`]*`", "", chapter(folder))
    known = programs.run_well(folder.partition("/")[0], "--help").stdout
    for option in re.findall(r"--[a-z]\w*(?:-\w+)*", text):
        assert option in known, option
    for name in re.findall(r"--set (\w+)=", text):
        assert re.search(rf"\b{name} +-?\d", known), name
