"""What the programs say and leave of the flakes and of the snow that lies, as numbers."""

import re

import numpy

from conftest import SMALL


def ledger(output):
    """The numbers of the ledger's line by name, which balance; its shape is part of the programs' contract."""
    lines = [line for line in output.splitlines() if line.startswith("ledger: ")]
    assert len(lines) == 1
    words = lines[0].replace("=", "+").removeprefix("ledger: ").split(" + ")
    entries = {name: int(number) for name, number in (word.split() for word in words)}
    assert list(entries) == ["released", "airborne", "lying", "deposited", "melted", "left"]
    assert entries["released"] == sum(entries.values()) - entries["released"]
    return entries


def cover_sums(output):
    """The masses of the cover's line: lying, melted, deposited, which add up."""
    line = re.search(r"^cover: lying (\d+) \+ melted (\d+) = deposited (\d+)$", output, re.MULTILINE)
    lying, melted, deposited = map(int, line.groups())
    assert lying + melted == deposited
    return lying, melted, deposited


class Cover:
    """What --dump-cover leaves: the mass of snow in each cell, and where the cells are."""

    def __init__(self, path):
        with open(path) as file:
            numbers = re.fullmatch(r"# origin (\S+) (\S+) (\S+) cell (\S+) full (\S+)\n",
                                   file.readline())
            *origin, cell, full = map(float, numbers.groups())
            assert file.readline() == "i,j,k,mass\n"
            rows = numpy.array([line.split(",") for line in file], dtype=numpy.int64).reshape(-1, 4)
        self.mass = rows[:, 3]                              # units
        self.place = origin + cell * (rows[:, :3] + 0.5)    # m, middle of the cell
        self.depth = self.mass / full * cell                # m
        self.full, self.cell = full, cell


def let_it_snow(programs, *arguments, **more):
    """The ledger, the cover and its sums after a run of step 6 with these arguments: to the flake, and to the unit
    of mass: atomicAdd on whole numbers loses nothing."""
    path = programs.folder / "cover.csv"
    output = programs.run_well("step06_accumulation", *SMALL, *arguments, "--dump-cover", path, **more).stdout
    entries, cover, sums = ledger(output), Cover(path), cover_sums(output)
    assert cover.mass.sum() == sums[0]
    assert (sums[2] > 0) == (entries["deposited"] > 0)
    return entries, cover, sums
