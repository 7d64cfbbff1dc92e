"""Reading the chapters: each is the README.md of a step, or of the winter."""

import re

from conftest import ROOT, STEPS

CHAPTERS = [*STEPS, "step06_accumulation/winter"]

# Those that a student can build the step from. The others are still guided tours of the code.
REWRITTEN = ["step01_cpu_points", "step02_vbo", "step03_shader_points", "step04_transform_feedback", "step05_collision", "step06_accumulation"]


def chapter(folder):
    return (ROOT / folder / "README.md").read_text(encoding="utf-8")


def blocks(folder, *languages):
    """What stands between ```language and ```."""
    return re.findall(rf"^```(?:{'|'.join(languages)})\n(.*?)^```", chapter(folder), re.DOTALL | re.MULTILINE)


def prose(folder):
    """Without blocks and tables."""
    text = re.sub(r"^```.*?^```", "", chapter(folder), flags=re.DOTALL | re.MULTILINE)
    return re.sub(r"^(?:\|.*| {4}\S.*)$", "", text, flags=re.MULTILINE)


def section(folder, heading):
    found = re.search(rf"^## {heading}\n(.*?)(?=^## |\Z)", chapter(folder), re.DOTALL | re.MULTILINE)
    return found[1] if found else ""
