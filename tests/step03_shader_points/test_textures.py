"""Pictures that cannot become textures: broken in ways that the decoder has no words for, or too
large. SNOWFALL_DIR points to a copy."""

import random
import shutil
import struct
import zlib

import pytest

from conftest import ROOT, STEPS, fails_with_one_line, small

CRYSTALS = "step03_shader_points/snowflakes.png"


@pytest.fixture
def run(programs, tmp_path):
    for folder in ["common", *STEPS]:
        shutil.copytree(ROOT / folder, tmp_path / folder,
                        ignore=shutil.ignore_patterns("*.cpp", "*.hpp", "*.md", "*.py", "*.pyc"))

    def run(picture):
        (tmp_path / CRYSTALS).write_bytes(picture)
        return programs.run("step03_shader_points", *small("step03_shader_points"), "--frames", 1,
                            "--variant", "texture", environment={"SNOWFALL_DIR": str(tmp_path)})
    return run


def png(width, height, rows=None):
    """A grey picture; `rows`: of its bytes, each with a filter in front, instead."""
    def chunk(kind, content):
        return (struct.pack(">I", len(content)) + kind + content
                + struct.pack(">I", zlib.crc32(kind + content)))
    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    rows = bytes((width + 1) * height) if rows is None else rows
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows))
            + chunk(b"IEND", b""))


def test_a_small_picture_will_do(run):
    result = run(png(4, 4))
    assert (result.returncode, result.stderr) == (0, "")


@pytest.mark.parametrize("size", [(20000, 4), (4, 20000), (30000, 30000)])
def test_a_picture_larger_than_a_texture(run, size):
    picture = png(*size, None if min(size) == 4 else b"")
    assert fails_with_one_line(run(picture), 1, CRYSTALS, "larger than 8192 x 8192")


def test_a_picture_with_too_few_rows(run):
    assert fails_with_one_line(run(png(64, 64, bytes(65))), 1, CRYSTALS)


def test_altered_bytes(run):
    """Each either leaves a picture, if an odd one, or is told in one line."""
    original = (ROOT / CRYSTALS).read_bytes()
    random.seed(1)
    changes = [(43, 2)]  # a type of block that deflate has not: stb says only that it failed, not why
    changes += [(random.randrange(len(original)), random.randrange(1, 256)) for _ in range(30)]
    for place, change in changes:
        picture = bytearray(original)
        picture[place] = (picture[place] + change) % 256
        result = run(bytes(picture))
        assert ((result.returncode, result.stderr) == (0, "")
                or fails_with_one_line(result, 1, CRYSTALS)), f"byte {place}"
