"""Every shader, as the programs put it together, in the eyes of the Khronos reference compiler."""

import re
import shutil
import subprocess

import pytest

from conftest import ROOT, STEPS, files_in

KINDS = (".vert", ".frag", ".comp", ".geom", ".tesc", ".tese")
SHADERS = sorted(str(path.relative_to(ROOT)) for step in STEPS for path in files_in(step)
                 if path.suffix in KINDS)


def assemble(name, seen):
    """The source with its includes in place, each once, as common/program.cpp does it."""
    seen.add(name)
    lines = []
    for line in (ROOT / name).read_text().splitlines():
        include = re.match(r'\s*#include\s+"([^"]+)"', line)
        if not include:
            lines.append(line)
        elif include[1] not in seen:
            lines += assemble(include[1], seen)
    return lines


@pytest.mark.parametrize("shader", SHADERS)
def test_no_smoothstep_runs_backwards(shader):
    """It is undefined unless its first edge is less than the second (GLSL 4.30, 8.3), whatever a driver makes of it.
    No compiler tells: only edges that are numbers are seen here."""
    source = "\n".join(assemble(shader, set()))
    edges = re.findall(r"smoothstep\(\s*(-?[\d.]+)f?\s*,\s*(-?[\d.]+)f?\s*,", source)
    assert all(float(first) < float(second) for first, second in edges), edges


@pytest.mark.parametrize("shader", SHADERS)
def test_reference_compiler_accepts_it(shader, tmp_path):
    validator = shutil.which("glslangValidator")
    if validator is None:
        pytest.skip("there is no glslangValidator (glslang-tools)")
    version, *lines = assemble(shader, set())
    path = tmp_path / shader.rpartition("/")[2]
    # With nothing that lines may depend on, and with all of it.
    parts = set(re.findall(r"#ifdef ([A-Z]\w+)", "\n".join(lines)))
    for defines in [], [f"#define {part}" for part in parts]:
        path.write_text("\n".join([version, *defines, *lines]) + "\n")
        result = subprocess.run([validator, path], capture_output=True, text=True, check=False)
        assert result.returncode == 0, result.stdout
