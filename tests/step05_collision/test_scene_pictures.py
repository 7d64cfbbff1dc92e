"""Pictures on the surfaces of a scene: shown, cut out, or told in a line that they are not."""

import numpy
import PIL.Image
import pytest

from pictures import read

# The floor, seen from above: its corners are those of the picture.
FLOOR = ("mtllib m.mtl\nv -8 0 -8\nv -8 0 8\nv 8 0 8\nv 8 0 -8\n"
         "vt 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl m\n")
FACE = "f 1/1 2/2 3/3 4/4\n"
FROM_ABOVE = ["--camera", "0,85,14"]
RED, GREEN, BLUE, WHITE = (255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 255)


@pytest.fixture
def draw(programs, tmp_path):
    def draw(step="step05_collision", variant="voxels", face=FACE):
        (tmp_path / "scene.obj").write_text(FLOOR + face)
        path = tmp_path / "drawn.png"
        result = programs.run(step, "--variant", variant, "--size", "160x90", "--particles", 0,
                              "--voxels", 32, "--frames", 1, *FROM_ABOVE, "--scene",
                              tmp_path / "scene.obj", "--screenshot", path)
        assert result.returncode == 0, result.stderr
        return read(path), result.stderr
    return draw


def quarters(picture):
    """A pixel from the back left, back right, front left and front right of the floor."""
    height, width, _ = picture.shape
    return [picture[height // 2 + dy * height // 6, width // 2 + dx * width // 10]
            for dy in (-1, 1) for dx in (-1, 1)]


def hues(picture):
    return ["RGB"[pixel.argmax()] if pixel.max() > pixel.min() + 60 else "-"
            for pixel in quarters(picture)]


def save(path, alpha=255, **options):
    pixels = numpy.zeros((64, 64, 4), numpy.uint8)
    pixels[:32, :32], pixels[:32, 32:] = (*RED, 255), (*GREEN, 255)
    pixels[32:, :32], pixels[32:, 32:] = (*BLUE, 255), (*WHITE, alpha)
    mode = "RGB" if path.suffix == ".jpg" else "RGBA"
    PIL.Image.fromarray(pixels).convert(mode).save(path, **options)


@pytest.mark.parametrize("name, step, variant", [("a.png", "step05_collision", "triangles"),
                                                 ("parts/a.tga", "step06_accumulation", "cells"),
                                                 ("a b.jpg", "step06_accumulation", "winter")])
def test_a_picture_is_shown_the_right_way_up(draw, tmp_path, name, step, variant):
    path = tmp_path / name
    path.parent.mkdir(exist_ok=True)
    save(path, **({"quality": 95} if path.suffix == ".jpg" else {}))
    (tmp_path / "m.mtl").write_text(f"newmtl m\nKd 0 0 0\nmap_Kd {name}\n".replace("/", "\\"))
    picture, errors = draw(step, variant)
    assert errors == "" and hues(picture) == ["R", "G", "B", "-"]
    (tmp_path / "m.mtl").write_text(f"newmtl m\nKd 1 0 0\nmap_Kd {name}\n")
    assert hues(draw(step, variant)[0])[::3] == ["R", "R"]  # Kd multiplies it


@pytest.mark.parametrize("mask", ["own alpha", "itself", "grey"])
def test_what_is_cut_out_is_not_drawn(draw, tmp_path, mask):
    save(tmp_path / "a.png", alpha=0 if mask in ("own alpha", "itself") else 255)
    half = numpy.full((16, 32), 255, numpy.uint8)  # of another size than the picture
    half[8:, 16:] = 0
    PIL.Image.fromarray(half).save(tmp_path / "mask.png")
    (tmp_path / "m.mtl").write_text("newmtl m\nKd 1 1 1\nmap_Kd a.png\n" +
                                    {"own alpha": "", "itself": "map_d a.png\n"}.get(mask, "map_d mask.png\n"))
    picture, errors = draw()
    assert errors == "" and hues(picture)[:3] == ["R", "G", "B"]
    background = picture[0, 0]
    assert abs(quarters(picture)[3] - background).max() <= 2
    assert abs(quarters(picture)[0] - background).max() > 20


@pytest.mark.parametrize("kind", ["truncated", "too large", "missing"])
def test_a_bad_picture_costs_a_line_and_its_material_the_picture(draw, tmp_path, kind):
    path = tmp_path / ("bad.png" if kind == "too large" else "bad.jpg")
    if kind == "truncated":
        save(path)
        path.write_bytes(path.read_bytes()[:300])
    elif kind == "too large":
        PIL.Image.new("L", (8193, 1)).save(path)
    (tmp_path / "m.mtl").write_text(f"newmtl m\nKd 1 0 0\nmap_Kd {path.name}\n"
                                    f"newmtl n\nKd 0 0 1\nmap_Kd {path.name}\n")
    picture, errors = draw(face="f 1/1 2/2 3/3\nusemtl n\nf 1/1 3/3 4/4\n")
    assert errors.count("\n") == 1 and path.name in errors and "one colour takes its place" in errors
    assert "larger than 8192 x 8192" in errors
    assert hues(picture)[1:3] == ["B", "R"]
