"""Files that the programs read at start: missing, broken, empty, too large. SNOWFALL_DIR points to a copy."""

import random
import shutil
import struct
import zlib

import pytest

from conftest import ROOT, STEPS, fails_with_one_line, small

# A shader or picture of each kind, with a program (and variant) that reads it.
SHADERS = [
    ("common/snow.glsl", "step03_shader_points", "disc"),
    ("step03_shader_points/flake.frag", "step03_shader_points", "disc"),
    ("step04_transform_feedback/update.geom", "step04_transform_feedback", "geometry"),
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


def test_shaders_that_do_not_fit_together(run, copy):
    path = copy / "step03_shader_points/flake.frag"
    path.write_text(path.read_text().replace("in float coverage", "in vec3 coverage")
                    .replace("coverage *", "coverage.x *"))
    assert fails(run("step03_shader_points", "disc"), "link", "flake.frag")


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


@pytest.fixture
def show(run, copy):
    """Runs step 3 with these bytes in place of the picture of its crystals."""
    def show(picture):
        (copy / CRYSTALS).write_bytes(picture)
        return run("step03_shader_points", "texture")
    return show


def png(width, height, rows):
    """A grey picture of rows of bytes, each with a filter in front."""
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


@pytest.mark.parametrize("width, height", [(20000, 4), (30000, 30000)])
def test_a_picture_larger_than_a_texture(show, width, height):
    picture = png(width, height, bytes((width + 1) * height) if height == 4 else b"")
    assert fails_with_one_line(show(picture), 1, CRYSTALS, "larger than 8192 x 8192")


def test_a_picture_with_too_few_rows(show):
    assert fails_with_one_line(show(png(64, 64, bytes(65))), 1, CRYSTALS)


def test_altered_bytes(show):
    """Each either leaves a picture, if an odd one, or is told in one line."""
    original = (ROOT / CRYSTALS).read_bytes()
    random.seed(1)
    changes = [(43, 2)]  # a type of block that deflate has not: stb says only that it failed, not why
    changes += [(random.randrange(len(original)), random.randrange(1, 256)) for _ in range(10)]
    for place, change in changes:
        picture = bytearray(original)
        picture[place] = (picture[place] + change) % 256
        result = show(bytes(picture))
        assert ((result.returncode, result.stderr) == (0, "")
                or fails_with_one_line(result, 1, CRYSTALS)), f"byte {place}"
