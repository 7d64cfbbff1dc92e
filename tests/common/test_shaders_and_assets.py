"""Files that the programs read at start: missing, broken, empty. SNOWFALL_DIR points to a copy."""

import random
import re
import shutil

import pytest

from conftest import ROOT, STEPS, fails_with_one_line, small

# A shader or picture of each kind, with a program (and variant) that reads it.
SHADERS = [
    ("common/snow.glsl", "step03_shader_points", "disc"),
    ("step03_shader_points/flake.vert", "step03_shader_points", "disc"),
    ("step03_shader_points/flake.frag", "step03_shader_points", "disc"),
    ("step03_shader_points/crystal.frag", "step03_shader_points", "texture"),
    ("step03_shader_points/sprite.glsl", "step04_transform_feedback", "feedback"),
    ("step04_transform_feedback/update.vert", "step04_transform_feedback", "feedback"),
    ("step04_transform_feedback/update.frag", "step04_transform_feedback", "texture"),
    ("step04_transform_feedback/flake_texture.vert", "step04_transform_feedback", "texture"),
    ("step04_transform_feedback/flake_geometry.vert", "step04_transform_feedback", "geometry"),
    ("step04_transform_feedback/update.comp", "step04_transform_feedback", "compute"),
    ("step04_transform_feedback/update_geometry.vert", "step04_transform_feedback", "geometry"),
    ("step04_transform_feedback/update.geom", "step04_transform_feedback", "geometry"),
    ("step04_transform_feedback/flake_output.glsl", "step04_transform_feedback", "feedback"),
    ("step04_transform_feedback/flake_state.glsl", "step05_collision", "voxels"),
    ("step05_collision/voxel_walk.glsl", "step05_collision", "voxels"),
    ("step05_collision/collide_triangles.glsl", "step05_collision", "triangles"),
    ("step05_collision/scene.frag", "step05_collision", "voxels"),
    ("step05_collision/voxels.glsl", "step06_accumulation", "cells"),
    ("step06_accumulation/cover/snow_cover.glsl", "step06_accumulation", "cells"),
    ("step06_accumulation/scene.frag", "step06_accumulation", "cells"),
    ("step06_accumulation/cover/update.glsl", "step06_accumulation", "cells"),
    ("step06_accumulation/winter/surface/surface.tesc", "step06_accumulation", "winter"),
    ("step06_accumulation/cover/settle.comp", "step06_accumulation", "cells"),
]
CRYSTALS = "step03_shader_points/snowflakes.png"


@pytest.fixture
def copy(tmp_path):
    """A folder with copies of the files that the programs read."""
    for folder in ["common", *STEPS]:
        shutil.copytree(ROOT / folder, tmp_path / folder,
                        ignore=shutil.ignore_patterns("*.cpp", "*.hpp", "*.md", "*.py", "*.pyc"))
    return tmp_path


@pytest.fixture
def run(programs, copy):
    def run(step, variant):
        # Or software leaves its shaders off, which are compiled when they are wanted.
        more = ["--set", "tessellation=1"] if variant == "winter" else []
        return programs.run(step, *small(step), "--frames", 2, "--variant", variant, *more,
                            environment={"SNOWFALL_DIR": str(copy)})
    return run


def test_copy_works(run):
    """What follows fails because of what it breaks, not because of the copy."""
    for _, step, variant in SHADERS:
        result = run(step, variant)
        assert (result.returncode, result.stderr) == (0, "")


@pytest.mark.parametrize("shader, step, variant", SHADERS)
def test_broken_shader_is_named_with_its_line(run, copy, shader, step, variant):
    """A mistake at the end of the file, past all includes: their lines must not be counted."""
    path = copy / shader
    source = path.read_text() + "\nnonsense nonsense;\n"
    path.write_text(source)
    result = run(step, variant)
    assert fails_with_one_line(result, 1, f"{shader}:{source.count(chr(10))}")


@pytest.mark.parametrize("shader, step, variant", SHADERS)
def test_a_name_without_a_meaning_is_named_with_its_line(run, copy, shader, step, variant):
    """No mistake in the grammar: Mesa finds those only once a whole expression is read."""
    path = copy / shader
    source = path.read_text() + "\nfloat broken(float x) { return x + no_such_name; }\n"
    path.write_text(source)
    assert fails_with_one_line(run(step, variant), 1, f"{shader}:{source.count(chr(10))}",
                               "no_such_name")


@pytest.mark.parametrize("shader, step, variant", SHADERS)
def test_a_line_is_lost(run, copy, shader, step, variant):
    """Any line: either it does no harm, or one line says where the compiler misses it."""
    path = copy / shader
    source = path.read_text()
    lines = source.splitlines(keepends=True)
    code = [i for i, line in enumerate(lines) if line.strip() and not line.startswith("//")]
    choose = random.Random(shader)
    for lost in choose.sample(code, 3):
        path.write_text("".join(lines[:lost] + lines[lost + 1:]))
        result = run(step, variant)
        if result.returncode:
            assert fails_with_one_line(result, 1, "error: shader")
            assert (re.search(r"(common|step\d\d_\w+)/\S+\.\w+:\d+\b", result.stderr)
                    or "link" in result.stderr), f"without line {lost + 1}"


@pytest.mark.parametrize("shader, step, variant", SHADERS)
def test_missing_shader_is_named_with_the_path_tried(run, copy, shader, step, variant):
    (copy / shader).unlink()
    assert fails_with_one_line(run(step, variant), 1, copy / shader, "SNOWFALL_DIR")


def test_missing_include_is_named_with_the_line_that_includes_it(run, copy):
    (copy / "step03_shader_points/sprite.glsl").unlink()
    lines = (copy / "step03_shader_points/flake.vert").read_text().splitlines()
    line = lines.index('#include "step03_shader_points/sprite.glsl"') + 1
    assert fails_with_one_line(run("step03_shader_points", "disc"), 1,
                               f"step03_shader_points/flake.vert:{line}: ", "sprite.glsl")


def test_empty_shader(run, copy):
    (copy / SHADERS[1][0]).write_text("")
    assert fails_with_one_line(run("step03_shader_points", "disc"), 1, SHADERS[1][0])


def test_shaders_that_do_not_fit_together(run, copy):
    path = copy / "step03_shader_points/flake.frag"
    path.write_text(path.read_text().replace("in float coverage", "in vec3 coverage")
                    .replace("coverage *", "coverage.x *"))
    assert fails_with_one_line(run("step03_shader_points", "disc"), 1, "link", "flake.frag")


def test_feedback_varying_that_no_shader_writes(run, copy):
    path = copy / "step04_transform_feedback/flake_output.glsl"
    path.write_text(path.read_text().replace("out float rest", "float rest"))
    result = run("step04_transform_feedback", "feedback")
    assert fails_with_one_line(result, 1, "link", "update.vert")


def test_misspelt_uniform_is_reported_once(run, copy):
    path = copy / "step03_shader_points/sprite.glsl"
    path.write_text(path.read_text().replace("window_height", "widow_height"))
    result = run("step03_shader_points", "disc")
    assert result.returncode == 0
    assert result.stderr.count("window_height") == 1 == result.stderr.count("\n")


@pytest.mark.parametrize("content", ["", "not a picture", "truncated", "missing"])
def test_bad_png(run, copy, content):
    path = copy / CRYSTALS
    if content == "missing":
        path.unlink()
    elif content == "truncated":
        path.write_bytes(path.read_bytes()[:2000])
    else:
        path.write_text(content)
    assert fails_with_one_line(run("step03_shader_points", "texture"), 1, path)


def test_missing_courtyard(run, copy):
    (copy / "common/assets/courtyard.obj").unlink()
    assert fails_with_one_line(run("step05_collision", "voxels"), 1, copy / "common/assets")
