"""Step 4: the variants that ask more of OpenGL than the step does, where there is less."""

import pytest

from conftest import SMALL, fails_with_one_line

STEP = "step04_transform_feedback"


@pytest.mark.only_software("it can be told to be an older OpenGL")
def test_compute_needs_opengl_4_3(programs):
    older = {"MESA_GL_VERSION_OVERRIDE": "4.2COMPAT"}
    result = programs.run(STEP, *SMALL, "--frames", 1, "--variant", "compute", environment=older)
    assert fails_with_one_line(result, 1, "compute needs OpenGL 4.3", "feedback")
    programs.run_well(STEP, *SMALL, "--frames", 1, "--variant", "feedback", environment=older)


@pytest.mark.only_software("a card may take more")
def test_more_flakes_than_a_storage_buffer_holds(programs):
    """Mesa's software renderer takes 128 MiB, other than a vertex buffer of any size."""
    too_many = ["--particles", 128 * 2**20 // 32 + 1, "--frames", 1]
    result = programs.run(STEP, *SMALL, *too_many, "--variant", "compute")
    assert fails_with_one_line(result, 1, f"hold {128 * 2**20 // 32} flakes", "feedback")
