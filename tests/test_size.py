"""How large the series may be: it is read more than run. The table is printed by

    pytest-3 tests/test_size.py -rP
"""

from conftest import ROOT, files_in

CODE = (".cpp", ".hpp", ".glsl", ".vert", ".frag", ".geom", ".comp", ".tesc", ".tese")


def is_winter(path):
    return "/winter" in str(path.relative_to(ROOT))


def count(paths, suffixes=CODE):
    """Files, lines and characters."""
    texts = [path.read_text(encoding="utf-8") for path in paths if path.suffix in suffixes]
    return len(texts), sum(text.count("\n") for text in texts), sum(map(len, texts))


def test_nothing_creeps_back():
    common, step_6 = files_in("common"), files_in("step06_accumulation")
    steps = [files_in(step) for step in ("step01_cpu_points", "step02_vbo", "step03_shader_points",
                                         "step04_transform_feedback", "step05_collision")]
    # Lines that there should be at most, lines and files that there may be at most: a part that is still larger
    # than it should be does not grow.
    table = [("common, at its top", 950, 1140, 20, count(path for path in common if path.parent == ROOT / "common")),
             ("common/harness", 1350, 1675, 16, count(files_in("common/harness"))),
             ("common/scene", 420, 420, 6, count(files_in("common/scene"))),
             ("steps 1 to 4", 1450, 1580, 40, count(sum(steps[:4], []))),
             ("step 5", 1100, 1320, 40, count(steps[4])),
             ("step 6 without the winter", 800, 1205, 28, count(path for path in step_6 if not is_winter(path))),
             ("the winter", 2700, 2770, 60, count(path for path in step_6 if is_winter(path))),
             ("all of that", 8700, 10090, 200, count([*common, *sum(steps, []), *step_6])),
             ("common/compare, Python", 800, 800, 6, count(files_in("common/compare"), (".py",))),
             ("tests", 6500, 6500, 100, count(files_in("tests"), (*CODE, ".py", ".sh")))]
    print(f"{'':28}{'lines':>8}{'aim':>8}{'at most':>9}{'files':>7}{'characters':>12}")
    for name, aim, most, _, (files, lines, characters) in table:
        print(f"{name:28}{lines:8,}{aim:8,}{most:9,}{files:7}{characters:12,}")
    for name, _, most, most_files, (files, lines, _) in table:
        assert lines <= most and files <= most_files, name
