"""--benchmark and --csv: what they report is what happened, and measuring changes nothing."""

import csv
import re

import pytest

from conftest import ROOT, STEPS, STEP_VARIANTS, small

BENCHMARK = ["--benchmark", "--frames", 12, "--warmup", 6, "--particles", 500]


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


@pytest.mark.only_software("a synchronised pass, as its queries can read 0")
@pytest.mark.parametrize("step, variant", STEP_VARIANTS)
def test_csv_has_a_row_for_every_frame(programs, tmp_path, step, variant):
    path, dump = tmp_path / "times.csv", tmp_path / "flakes.csv"
    result = programs.run_well(step, *small(step), *BENCHMARK, "--variant", variant, "--csv", path, "--dump", dump)
    # And measuring changes nothing.
    assert dump.read_bytes() == programs.dump(step, "--variant", variant, *BENCHMARK[1:])
    rows = read(path)
    stages = [column.removesuffix("_cpu_ms") for column in rows[0] if column.endswith("_cpu_ms")]
    assert (stages[0], stages[-1]) == ("update", "tone" if variant == "winter" else "draw")
    assert list(rows[0]) == ["step", "variant", "particles", "width", "height", "renderer", "frame", "frame_ms",
                             "timing", *(f"{stage}_{which}_ms" for stage in stages for which in ("cpu", "gpu"))]
    counted = [row for row in rows if row["timing"] == "query"]
    assert [int(row["frame"]) for row in counted] == list(range(12))
    # Mesa's software renderer: the second half of the warm-up is the synchronised pass.
    assert len(rows) - len(counted) == 3
    for row in rows:
        assert (row["step"], row["variant"]) == (step, variant)
        assert (row["particles"], row["width"], row["height"]) == ("500", "64", "64")
        times = [float(row[f"{stage}_cpu_ms"]) for stage in stages]
        assert min(times) >= 0 and sum(times) <= float(row["frame_ms"])  # what is timed lies within the frame
    assert "benchmark: 12 frames" in result.stdout


@pytest.mark.parametrize("step", [STEPS[0], STEPS[3], STEPS[-1]])
def test_a_warm_up_ends_where_as_many_frames_would(programs, tmp_path, step):
    """All but its last frames are time lapse; what counts is the same snow."""
    run = [step, "--particles", 500]
    frames = tmp_path / "times.csv"
    warmed_up = programs.dump(*run, "--warmup", 300, "--frames", 2, "--csv", frames)
    assert len(read(frames)) == 2
    assert warmed_up == programs.dump(*run, "--frames", 302)


def test_programs_and_comparison_know_the_same_software_renderers():
    """The list in each begins with Mesa's first, and ends with Windows' own."""
    files = [(ROOT / "common" / path).read_text() for path in ("harness/driver.cpp", "compare/points.py")]
    lists = [re.search(r"llvmpipe.*?basic render", text, re.DOTALL)[0] for text in files]
    first, second = [set(re.findall(r"[a-z][a-z ]*", names)) for names in lists]
    assert first == second and len(first) > 5
