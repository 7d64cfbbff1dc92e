"""The exercises of step 4: each solution does what the chapter says it will."""

import numpy
import pytest

from conftest import SMALL, STEPS, VARIANTS, Flakes

STEP = "step04_transform_feedback"
LANDED = ["--timelapse", 100, "--frames", 9]  # 15 s: flakes have landed, melted and been born again
FIELDS = ["position", "age", "velocity", "rest"]


def dumped(there, tmp_path, *arguments):
    path = tmp_path / "flakes.csv"
    there.run_well(STEP, *SMALL, *LANDED, "--dump", path, *arguments)
    return path


def test_exercise_1_dumps_of_cpu_and_gpu(programs):
    first, *others = [programs.dump(step, *LANDED) for step in STEPS[:3]]
    assert all(other == first for other in others)
    feedback, *others = [programs.dump(STEP, *LANDED, "--variant", name) for name in VARIANTS[STEP]]
    assert all(other == feedback for other in others)
    on_cpu, on_gpu = programs.flakes(STEPS[2], *LANDED), programs.flakes(STEP, *LANDED, "--variant", "feedback")
    assert (on_cpu.rest > 0).sum() > 1000  # some do lie
    for field in FIELDS:
        assert abs(getattr(on_cpu, field) - getattr(on_gpu, field)).max() < 1e-4


@pytest.mark.only_software("gl_Position is undefined there: only vertices that are captured must agree")
def test_exercise_2_without_rasterizer_discard(programs, edited, tmp_path):
    with edited(f"{STEP}/solutions/2.patch", build=STEP) as there:
        assert dumped(there, tmp_path).read_bytes() == programs.dump(STEP, *LANDED)


def test_exercise_3_whirlwind(programs, edited, tmp_path):
    def around(flakes):
        """Speed around the y axis, m/s, and distance from it, m, of those 1 s in the air; of which emitter."""
        x, _, z = flakes.position.T
        vx, _, vz = flakes.velocity.T
        is_old = flakes.airborne & (flakes.age > 1)
        radius = numpy.hypot(x, z)[is_old]
        is_first = (numpy.arange(len(x)) < len(x) // 2)[is_old]
        return (z * vx - x * vz)[is_old] / radius, radius, is_first

    with edited(f"{STEP}/solutions/3.patch") as there:
        speed, radius, is_first = around(Flakes(dumped(there, tmp_path)))
    assert (speed > 0).mean() > 0.99
    for emitter, expected in ((is_first, 1.6), (~is_first, 2.5)):
        assert speed[emitter & (radius > 4)].mean() == pytest.approx(expected, abs=0.1)
    still, _, _ = around(programs.flakes(STEP, *LANDED))
    assert abs((still > 0).mean() - 0.5) < 0.05  # without the edit as many turn this way as that


def test_exercise_4_half_a_buffer(programs, edited, tmp_path):
    path = tmp_path / "flakes.csv"
    with edited(f"{STEP}/solutions/4.patch", build=STEP) as there:
        result = there.run_well(STEP, *SMALL, *LANDED, "--debug", "--dump", path)
    assert "written: 10000 of 20000" in result.stdout
    half, all_of_it = Flakes(path), programs.flakes(STEP, *LANDED)
    for field in FIELDS:
        assert (getattr(half, field)[:10000] == getattr(all_of_it, field)[:10000]).all()
    assert (half.age[10000:] < 0).all()


def test_exercise_5_streaks(programs, edited, tmp_path):
    def size_of_dots(there):
        """Of what is bright, which the ground is not: mean length of a run of pixels, downwards and across."""
        bright = there.picture(STEP, "--weather", "rain", "--size", "640x360", *LANDED).min(axis=2) > 100
        starts = [bright[1:] & ~bright[:-1], bright[:, 1:] & ~bright[:, :-1]]
        return [bright.sum() / start.sum() for start in starts]

    with edited(f"{STEP}/solutions/5.patch", build=STEP) as there:
        height, width = size_of_dots(there)
        assert dumped(there, tmp_path).read_bytes() == programs.dump(STEP, *LANDED)
    assert height > 2.5 and width < 1.5
    assert max(size_of_dots(programs)) < 1.5  # points
