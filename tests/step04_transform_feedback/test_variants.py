"""Step 4: the variants that ask more of OpenGL than the step does, where there is less."""

import pytest

from conftest import SMALL, fails_with_one_line, small

STEP = "step04_transform_feedback"


@pytest.mark.only_software("it can be told to be an older OpenGL")
def test_compute_needs_opengl_4_3(programs):
    older = {"MESA_GL_VERSION_OVERRIDE": "4.2COMPAT"}
    result = programs.run(STEP, *SMALL, "--frames", 1, "--variant", "compute", environment=older)
    assert fails_with_one_line(result, 1, "compute needs OpenGL 4.3", "feedback")
    programs.run_well(STEP, *SMALL, "--frames", 1, "--variant", "feedback", environment=older)


# GL_..._BARRIER_BIT
VERTEX_ATTRIB_ARRAY, BUFFER_UPDATE, SHADER_STORAGE = 0x1, 0x200, 0x2000


def test_compute_has_its_barriers(programs, tmp_path):
    """Software keeps the order of all calls anyway, a card only as barriers say: what reads flakes after a dispatch has
    one of its own kind before it, and a dispatch has one after the draw whose vertices it overwrites."""
    flakes, steps, frames = 500, 3, 2
    awaited = 0  # bits of the barriers since the last dispatch or draw
    readers = []
    for name, *numbers in programs.calls(
            STEP, "--variant", "compute", "--particles", flakes, "--timelapse", steps, "--frames", frames,
            "--dump", tmp_path / "flakes.csv"):
        if name == "glMemoryBarrier":
            awaited |= numbers[0]
        elif name == "glDispatchCompute":
            assert not readers or awaited & SHADER_STORAGE
            readers.append("update")
            awaited = 0
        elif name == "glDrawArrays":
            assert awaited & VERTEX_ATTRIB_ARRAY
            readers.append("draw")
            awaited &= ~SHADER_STORAGE
        elif name == "glGetBufferSubData":
            assert awaited & BUFFER_UPDATE
            readers.append("dump")
    assert readers == [*["update"] * steps, "draw"] * frames + ["dump"]


@pytest.mark.only_software("it can be told to lack an extension")
def test_geometry_needs_feedback_objects(programs):
    without = {"MESA_EXTENSION_OVERRIDE": "-GL_ARB_transform_feedback2"}
    result = programs.run(STEP, *SMALL, "--frames", 1, "--variant", "geometry", environment=without)
    assert fails_with_one_line(result, 1, "geometry needs OpenGL 4.0", "feedback")


def test_a_card_that_cannot_draw_to_such_textures(programs):
    result = programs.run(STEP, *SMALL, "--frames", 1, "--variant", "texture",
                          environment=programs.preloaded("refuse_framebuffer"))
    assert fails_with_one_line(result, 1, "cannot draw", "RGBA32F", "feedback")


@pytest.mark.only_software("a card's shaders may reach more than 128 MiB of a buffer")
def test_more_flakes_than_a_compute_shader_can_reach(programs):
    result = programs.run(STEP, *SMALL, "--particles", 5_000_000, "--frames", 1, "--variant", "compute")
    assert fails_with_one_line(result, 1, "compute: too many flakes", "feedback")


@pytest.mark.only_software("a card may have less memory")
@pytest.mark.parametrize("step, variant", [(STEP, "texture"), ("step05_collision", "voxels"),
                                           ("step06_accumulation", "winter")])
def test_ten_million_flakes(programs, step, variant):
    """320 MB, which the first line tells, and up to four times as much in buffers."""
    result = programs.run_well(step, *small(step), "--particles", 10_000_000, "--frames", 1, "--variant", variant)
    assert "10000000 flakes of 305 MiB" in result.stdout.splitlines()[0]
