"""Snow that stays (step 6): not a flake, not a unit of mass is lost, and it lies where it can."""

import numpy
import pytest

import scenes
from reports import let_it_snow

STEP = "step06_accumulation"

# Hail comes down in a second, and a short rest lets every flake take many turns.
HAIL = ["--weather", "hail", "--set", "melt_time=0.3"]


@pytest.fixture
def accumulate(programs, tmp_path):
    """Lets it snow, on a scene if there is the text of one. Nobody looks at the pictures, so their surface need not be
    fine."""
    def accumulate(text, *arguments, **more):
        (tmp_path / "scene.obj").write_text(text)
        scene = ["--scene", tmp_path / "scene.obj"] if text else []
        return let_it_snow(programs, *scene, "--set", "tessellation=0", *arguments, **more)
    return accumulate


def test_ledger_balances_in_a_storm(accumulate):
    """Flakes leave the world on the wind, land on edges, slide down walls and are snowed in."""
    accumulate("", "--particles", 8000, "--timelapse", 30, "--frames", 10, "--voxels", 64, *HAIL,
               "--set", "wind_x=20", "--set", "turbulence=40", "--set", "snowfall=10")


DOWNPOURS = {
    "snow": ["--set", "speed_0=8", "--set", "speed_1=12", "--set", "repose=15"],
    "thaw": ["--weather", "hail", "--set", "temperature=10"],
    "rain": ["--weather", "rain"],
}


@pytest.mark.parametrize("weather", DOWNPOURS)
def test_many_threads_at_once_lose_nothing_and_overfill_no_cell(accumulate, weather):
    """More threads than cores, so that each is stopped in the midst of what it does; 10 m a minute."""
    entries, cover, _ = accumulate("", "--particles", 4000, "--voxels", 256, "--timelapse", 100,
                                   "--frames", 4, *DOWNPOURS[weather], "--set", "snowfall=10",
                                   "--set", "melt_time=0.3", environment={"LP_NUM_THREADS": "8"})
    assert entries["deposited"] > 1000
    assert cover.mass.max() <= cover.full


def test_a_full_cell_is_solid_and_snow_piles_into_the_next(accumulate):
    """A metre of snow in ten seconds: layer upon layer of cells, none holding more than it can."""
    _, cover, _ = accumulate(scenes.TABLE, "--particles", 8000, "--timelapse", 60, "--frames", 10, "--voxels", 64,
                             *HAIL, "--set", "restitution=0", "--set", "snowfall=6")
    assert cover.mass.max() <= cover.full
    in_the_open = (abs(cover.place[:, 0]) > 4) & (abs(cover.place) < 7)[:, [0, 2]].all(axis=1)
    layers = numpy.unique(cover.place[in_the_open, 1].round(3))
    assert len(layers) >= 3
    # Cells are filled from below: any snow rests on a cell that is full, or on the floor.
    full = {tuple(place) for place in cover.place[cover.mass >= cover.full].round(3)}
    for x, y, z in cover.place[in_the_open & (cover.place[:, 1] > cover.cell)]:
        assert tuple(numpy.round((x, y - cover.cell, z), 3)) in full


def test_as_much_melts_whatever_the_size_of_the_cells(accumulate):
    """In a round each column has one turn, also where a turn has fewer columns than invocations."""
    melted = {}
    for voxels in (32, 64):
        _, _, sums = accumulate("", "--particles", 4000, "--timelapse", 100, "--frames", 18,
                                "--voxels", voxels, "--set", "melt_time=1", "--set", "speed_0=4",
                                "--set", "speed_1=6", "--set", "temperature=1")
        melted[voxels] = sums[1] / sums[2]
    assert melted[32] > 0.05
    assert melted[32] == pytest.approx(melted[64], rel=0.15)


def test_wind_clears_the_foot_of_a_wall_and_drifts_snow_behind_it(accumulate):
    """It carries flakes over the foot, until they come down in the calm: against no wall, in m."""
    def snow(scene, *ranges):
        _, cover, _ = accumulate(scene, "--particles", 8000, "--frames", 18, "--timelapse", 100,
                                 "--voxels", 64, "--set", "melt_time=1", "--set", "wind_x=-4")
        x, y, z = cover.place.T
        return [cover.mass[(y < 1) & (abs(z) < 3) & (-x > begin) & (-x < end)].sum()
                for begin, end in ranges]

    foot, drift = (numpy.array(snow(scenes.WALL, (0.4, 1.4), (2.5, 4)))
                   / snow(scenes.text(scenes.FLOOR), (0.4, 1.4), (2.5, 4)))
    assert foot < 0.2 and drift > 1.1


def test_no_flake_accelerates_without_bound(programs):
    """In wind of 30 m/s, gusts of three times that, and the courtyard in its way."""
    flakes = programs.flakes(STEP, "--particles", 5000, "--voxels", 64, "--frames", 6,
                             "--timelapse", 100, "--set", "wind_x=-30", "--set", "wind_z=-30",
                             "--set", "gusts=2")
    speed = numpy.linalg.norm(flakes.velocity, axis=1)
    assert numpy.isfinite(flakes.position).all() and numpy.isfinite(speed).all()
    # Over edges the air is up to twice as fast as in the open; nothing else drives a flake.
    assert 20 < speed.max() < 2 * 3 * 30 * 2 ** 0.5 + 10


def test_both_variants_lay_down_the_same_snow(programs):
    """In calm air, to the unit and cell by cell: what the winter adds is how it looks.

    Before any cell is full: what a flake finds solid then depends on which flake came before it.
    """
    def covers(variant):
        entries, cover, sums = let_it_snow(programs, "--variant", variant, "--voxels", 64, *HAIL, "--particles", 3000,
                                           "--timelapse", 30, "--frames", 12, "--set", "snowfall=0.05")
        return entries, sums, cover.place.tolist(), cover.mass.tolist()
    assert covers("cells") == covers("winter")


def test_snow_lies_on_bare_ground_too(accumulate):
    """Where no triangle lies on the ground the ground itself does: beside a table without a floor."""
    bare = scenes.text(scenes.box((-4, 0, -8), (-3.8, 2, -7.8)), scenes.box((-4, 2, -8), (4, 2.2, 8)))
    entries, cover, _ = accumulate(bare, "--particles", 3000, "--timelapse", 60, "--frames", 12,
                                      "--voxels", 64, *HAIL, "--set", "snowfall=1",
                                      "--set", "restitution=0")
    # It freezes. Some come down outside of the grid, which is as wide as the table is long: they have left.
    assert entries["melted"] == 0 < entries["left"] < 0.05 * entries["deposited"]
    x, y, z = cover.place.T
    on_table, on_ground = cover.mass[y > 2].sum(), cover.mass[y < 1].sum()
    # The cloud is as wide as the grid: half of it over the table. 0.1: at the edge snow slides down.
    assert on_ground == pytest.approx(on_table, rel=0.1)
    # The table shelters the ground, but for 0.75 m along its edges, where a heap beside it slides in.
    assert cover.mass[(y < 1) & (abs(x) < 3.25) & (abs(z) < 7.25)].sum() == 0
