"""--benchmark and --csv: what they report is what happened, and measuring changes nothing."""

import csv
import re

import pytest

from conftest import ROOT, STEPS, STEP_VARIANTS, small

BENCHMARK = ["--benchmark", "--frames", 12, "--warmup", 6, "--particles", 500]


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


SWITCHED_OFF = ["arrows", "sort", "bloom"]  # until a key or --set turns them on


def stages_of(step, variant):
    """As its source names them, from top to bottom: a file of its own, if it has one, and then what
    belongs to it in a folder of that name."""
    folder = ROOT / step
    page = folder / f"{variant}.cpp"
    pages = [page if page.exists() else folder / "main.cpp", folder / variant / f"{variant}.cpp"]
    text = "".join(page.read_text() for page in pages if page.exists())
    names = re.findall(r'window\.stage\("(\w+)"\)', text)
    if variant == "arrays":  # which has no buffer to upload to
        names.remove("upload")
    return [name for name in names if name not in SWITCHED_OFF]


@pytest.mark.only_software("a synchronised pass, as its queries can read 0")
@pytest.mark.parametrize("step, variant", STEP_VARIANTS)
def test_csv_has_a_row_for_every_frame(programs, tmp_path, step, variant):
    path = tmp_path / "times.csv"
    result = programs.run_well(step, *small(step), *BENCHMARK, "--variant", variant, "--csv", path)
    rows = read(path)
    columns = ["step", "variant", "particles", "width", "height", "renderer", "frame", "frame_ms",
               "timing"]
    assert stages_of(step, variant)[0] == "update"
    assert stages_of(step, variant)[-1] == ("tone" if variant == "winter" else "draw")
    for stage in stages_of(step, variant):
        columns += [f"{stage}_cpu_ms", f"{stage}_gpu_ms"]
    assert list(rows[0]) == columns
    counted = [row for row in rows if row["timing"] == "query"]
    assert [int(row["frame"]) for row in counted] == list(range(12))
    # Mesa's software renderer: the second half of the warm-up is the synchronised pass.
    assert len(rows) - len(counted) == 3
    for row in rows:
        assert (row["step"], row["variant"]) == (step, variant)
        assert (row["particles"], row["width"], row["height"]) == ("500", "64", "64")
        assert "llvmpipe" in row["renderer"]
        stages = [float(row[f"{stage}_cpu_ms"]) for stage in stages_of(step, variant)]
        assert all(time >= 0 for time in stages)
        assert sum(stages) <= float(row["frame_ms"])  # what is timed lies within the frame
    assert "benchmark: 12 frames" in result.stdout
    assert "vsync off" in result.stdout


@pytest.mark.parametrize("step,variant", STEP_VARIANTS)
def test_measuring_changes_nothing(programs, tmp_path, step, variant):
    plain = programs.dump(step, "--variant", variant, "--frames", 12, "--warmup", 6,
                          "--particles", 500)
    path = tmp_path / "flakes.csv"
    programs.run_well(step, *small(step), *BENCHMARK, "--variant", variant,
                      "--csv", tmp_path / "times.csv", "--dump", path)
    assert path.read_bytes() == plain


@pytest.mark.parametrize("step", STEPS)
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


def test_a_benchmark_does_not_wait_for_the_display(programs):
    result = programs.run("step01_cpu_points", "--benchmark", "--vsync")
    assert result.returncode == 2 and "--vsync" in result.stderr
