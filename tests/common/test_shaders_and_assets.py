"""Files that the programs read at start: missing, broken, empty. SNOWFALL_DIR points to a copy."""

import shutil

import pytest

from conftest import ROOT, STEPS, fails_with_one_line, small

# A shader or picture of each kind, with a program (and variant) that reads it.
SHADERS = [
    ("common/snow.glsl", "step03_shader_points", "disc"),
    ("step03_shader_points/flake.vert", "step03_shader_points", "disc"),
    ("step03_shader_points/flake.frag", "step03_shader_points", "disc"),
    ("step03_shader_points/sprite.glsl", "step04_transform_feedback", "feedback"),
    ("step04_transform_feedback/update.comp", "step04_transform_feedback", "compute"),
    ("step04_transform_feedback/update.geom", "step04_transform_feedback", "geometry"),
    ("step05_collision/voxel_walk.glsl", "step05_collision", "voxels"),
    ("step05_collision/scene.frag", "step05_collision", "voxels"),
    ("step06_accumulation/winter/surface/surface.tesc", "step06_accumulation", "winter"),
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


def fails(result, *words):
    """A line of ours, and below it what the driver says."""
    print(result.stderr)
    return (result.returncode == 1 and result.stderr.startswith("error: shader")
            and all(word in result.stderr for word in words))


def test_copy_works(run):
    """What follows fails because of what it breaks, not because of the copy."""
    result = run("step06_accumulation", "winter")
    assert (result.returncode, result.stderr) == (0, "")


@pytest.mark.parametrize("mistake", [
    "nonsense nonsense;",
    # Mesa finds this only once the whole expression is read, and forgets then which file it was in.
    "float broken(float x) { return x + no_such_name; }",
])
@pytest.mark.parametrize("shader, step, variant", SHADERS)
def test_mistakes_are_named_with_their_lines(run, copy, shader, step, variant, mistake):
    """At the end of the file, past all includes: their lines must not be counted."""
    path = copy / shader
    source = f"{path.read_text()}\n{mistake}\n"
    path.write_text(source)
    line = source.count("\n")
    assert fails(run(step, variant), f"{shader}:{line}", "error")


def test_missing_shader_is_named_with_the_path_tried(run, copy):
    shader = copy / "step03_shader_points/sprite.glsl"
    shader.unlink()
    assert fails_with_one_line(run("step03_shader_points", "disc"), 1, shader, "SNOWFALL_DIR")


def test_empty_shader(run, copy):
    (copy / SHADERS[1][0]).write_text("")
    assert fails(run("step03_shader_points", "disc"), SHADERS[1][0])


def test_shaders_that_do_not_fit_together(run, copy):
    path = copy / "step03_shader_points/flake.frag"
    path.write_text(path.read_text().replace("in float coverage", "in vec3 coverage")
                    .replace("coverage *", "coverage.x *"))
    assert fails(run("step03_shader_points", "disc"), "link", "flake.frag")


def test_feedback_varying_that_no_shader_writes(run, copy):
    path = copy / "step04_transform_feedback/flake_output.glsl"
    path.write_text(path.read_text().replace("out float rest", "float rest"))
    assert fails(run("step04_transform_feedback", "feedback"), "link", "update.vert")


def test_misspelt_uniform_is_reported_once(run, copy):
    path = copy / "step03_shader_points/sprite.glsl"
    path.write_text(path.read_text().replace("window_height", "widow_height"))
    result = run("step03_shader_points", "disc")
    assert result.returncode == 0
    assert result.stderr.count("window_height") == 1 == result.stderr.count("\n")


def test_physics_of_another_build(run, copy):
    path = copy / "common/snow.glsl"
    path.write_text(path.read_text().replace("struct Weather {", "struct Weather {\n    vec4 more;"))
    assert fails_with_one_line(run("step03_shader_points", "disc"), 1, "build again")


@pytest.mark.parametrize("content", ["not a picture", "missing"])
def test_bad_png(run, copy, content):
    path = copy / CRYSTALS
    path.unlink() if content == "missing" else path.write_text(content)
    assert fails_with_one_line(run("step03_shader_points", "texture"), 1, path)
