"""Snow on a map of heights (variant heightmap) against snow in cells: the same mass, but only where the sky sees it."""

import pytest

import scenes
from reports import let_it_snow


@pytest.fixture
def snow(programs, tmp_path):
    """Half a minute or more of it in a variant: what has become of the flakes, and where the snow lies."""
    def snow(variant, scene, *arguments):
        path = tmp_path / "scene.obj"
        path.write_text(scene)
        where = ["--scene", path if scene else "none"]
        entries, cover, _ = let_it_snow(programs, *where, "--variant", variant, "--voxels", 64, "--particles", 3000,
                                        "--timelapse", 60, *arguments, environment={"LP_NUM_THREADS": "1"})
        return entries, cover
    return snow


def test_on_an_open_plain_both_lay_down_the_same_mass_to_the_unit(snow):
    """As long as no cell is full: that is as high as 0.26 m of snow, and half a minute brings 0.05 m."""
    (flakes, cells), (map_flakes, heights) = (snow(variant, "", "--frames", 30) for variant in ("cells", "heightmap"))
    assert flakes == map_flakes
    assert cells.mass.sum() == heights.mass.sum() > 0


def test_on_the_courtyard_both_lay_down_as_much(programs):
    """In calm air. A twig or a gap may be a cell in one and air in the other: 2 %."""
    sums = [let_it_snow(programs, "--variant", variant, "--voxels", 128, "--particles", 6000, "--timelapse", 120,
                        "--frames", 20)[2][2] for variant in ("cells", "heightmap")]
    assert sums[1] == pytest.approx(sums[0], rel=0.02)


def test_under_a_table_only_cells_hold_snow(snow):
    """Wind blows it in. In the map the table reaches down to the ground."""
    wind = ["--set", "wind_x=2", "--set", "wind_z=1", "--frames", 60]
    _, cells = snow("cells", scenes.TABLE, *wind)
    _, heights = snow("heightmap", scenes.TABLE, *wind)
    def under(cover):
        x, _, z = cover.place.T
        return (abs(x) < 2.5) & (abs(z) < 2.5) & (abs(z) > 0.5)  # the gap between its planks is in the middle
    on_ground = cells.place[:, 1] < 1
    assert cells.mass[under(cells) & on_ground].sum() > 0.1 * cells.mass[under(cells)].sum()
    # What lies in the same columns of the map lies on the table: as much as on the cells' table.
    on_top = cells.mass[under(cells) & ~on_ground].sum()
    assert heights.mass[under(heights)].sum() == pytest.approx(on_top, rel=0.1)
