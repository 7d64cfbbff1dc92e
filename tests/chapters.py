"""Reading the chapters: each is the README.md of a step, or of the winter."""

import re

from conftest import ROOT, STEPS

CHAPTERS = [*STEPS, "step06_accumulation/winter"]


def chapter(folder):
    return (ROOT / folder / "README.md").read_text(encoding="utf-8")


def blocks(folder, *languages):
    """What stands between ```language and ```."""
    return re.findall(rf"^```(?:{'|'.join(languages)})\n(.*?)^```", chapter(folder), re.DOTALL | re.MULTILINE)


def without_listings(folder):
    return re.sub(r"^```.*?^```", "", chapter(folder), flags=re.DOTALL | re.MULTILINE)


def section(folder, heading):
    found = re.search(rf"^## {heading}\n(.*?)(?=^## |\Z)", chapter(folder), re.DOTALL | re.MULTILINE)
    return found[1] if found else ""
