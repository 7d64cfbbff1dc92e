"""How large a flake is drawn (step 3): as it looks from there, in inverse proportion to its distance."""

import numpy
import pytest

from pictures import Camera

SIZE = 960, 540


@pytest.mark.parametrize("distance", [10, 20, 40])  # m, of the camera from the middle
def test_a_sprite_is_as_wide_as_its_flake_looks(programs, tmp_path, distance):
    """A disc of 1 m around the one flake there is; at its edge it is too faint to be seen."""
    def draw(particles):
        return programs.picture("step03_shader_points", "--size", "%dx%d" % SIZE, "--particles", particles,
                                "--timelapse", 100, "--frames", 9, "--set", "diameter_1=1", "--set", "variation=0",
                                "--camera", f"40,10,{distance}", "--dump", tmp_path / "flake.csv")
    change = abs(draw(0) - draw(1)).max(axis=2) > 0
    place = numpy.loadtxt(tmp_path / "flake.csv", delimiter=",", skiprows=1)[1:4]
    width, = numpy.ptp(numpy.nonzero(change.any(axis=0)), axis=1) + 1
    # 1 pixel either way: which pixels a disc covers depends on where in a pixel its middle is; and
    # of its opacity, 1 - radius^2, the last 255th is lost: 0.2 % of the width.
    assert width == pytest.approx(Camera(40, 10, distance, SIZE).scale(place), abs=1.5)
