"""Draws wind.svg: what wind_field.cpp does, in two dimensions, past a house.

usage: python3 wind.py
"""

import pathlib

import numpy

WIDE, HIGH = 46, 15       # cells
HOUSE = (13, 19, 6)       # from, to, height
SIZE = 15.6               # of a cell, in the picture's units

# Speeds on the faces of cells: u[y, x] from cell x - 1 to x, v[y, x] from cell y - 1 to y. Free: 1, blocked: 0.
solid = numpy.zeros((HIGH, WIDE), dtype=bool)
solid[:HOUSE[2], HOUSE[0]:HOUSE[1]] = True
open_u, open_v = numpy.ones((HIGH, WIDE + 1)), numpy.ones((HIGH + 1, WIDE))
open_u[:, 1:][solid] = open_u[:, :-1][solid] = 0
open_v[1:][solid] = open_v[:-1][solid] = 0
open_v[0] = 0  # the ground
u, v = numpy.ones_like(open_u), numpy.zeros_like(open_v)


def add_wake():
    """From column to column what finds a way through, mixed with the air above and below."""
    left = numpy.ones(HIGH)
    for x in range(WIDE + 1):
        around = numpy.concatenate([left[:1], left, [1]])
        mean = 0.6 * left + 0.2 * (around[:-2] + around[2:])  # 3D: a fifth each, the two beside it are the same
        u[:, x] *= mean
        left = mean * open_u[:, x]


def project():
    """Subtracts the gradient of the pressure for which as much flows out of each cell as into it."""
    number = numpy.arange(HIGH * WIDE).reshape(HIGH, WIDE)
    matrix, divergence = numpy.zeros((HIGH * WIDE,) * 2), numpy.zeros(HIGH * WIDE)
    for y, x in numpy.ndindex(HIGH, WIDE):
        here = number[y, x]
        for face, is_free, sign, (row, column) in (
                (u[y, x], open_u[y, x], -1, (y, x - 1)), (u[y, x + 1], open_u[y, x + 1], 1, (y, x + 1)),
                (v[y, x], open_v[y, x], -1, (y - 1, x)), (v[y + 1, x], open_v[y + 1, x], 1, (y + 1, x))):
            divergence[here] += sign * is_free * face
            matrix[here, here] += is_free
            if 0 <= row < HIGH and 0 <= column < WIDE:
                matrix[here, number[row, column]] -= is_free
        if matrix[here, here] == 0:
            matrix[here, here] = 1  # within the house
    pressure = numpy.pad(numpy.linalg.solve(matrix, -divergence).reshape(HIGH, WIDE), 1)
    u[:] -= pressure[1:-1, 1:] - pressure[1:-1, :-1]
    v[:] -= pressure[1:, 1:-1] - pressure[:-1, 1:-1]


def panel(top, text):
    """The air in every other cell as an arrow, and the house."""
    flow = numpy.stack([open_u * u, open_u * u]), numpy.stack([open_v * v, open_v * v])
    along = 0.5 * (flow[0][0][:, :-1] + flow[0][1][:, 1:])
    up = 0.5 * (flow[1][0][:-1] + flow[1][1][1:])
    slow, fast = [], []
    for y in range(0, HIGH, 2):
        for x in range(0, WIDE, 2):
            way = numpy.array([along[y, x], -up[y, x]]) * SIZE * 1.4
            if solid[y, x] or numpy.hypot(*way) < 1.5:
                continue
            middle = numpy.array([20 + SIZE * (x + 1), top + SIZE * (HIGH - y - 0.5)])
            tail, tip, side = middle - way / 2, middle + way / 2, numpy.array([-way[1], way[0]])
            head = [tip - 0.3 * way + 0.2 * side, tip - 0.3 * way - 0.2 * side]
            points = "M{:.0f} {:.0f}L{:.0f} {:.0f}M{:.0f} {:.0f}L{:.0f} {:.0f} {:.0f} {:.0f}".format(
                *tail, *tip, *head[0], *tip, *head[1])
            (fast if numpy.hypot(*way) > 1.1 * SIZE * 1.4 else slow).append(points)
    left, ground = 20 + SIZE * HOUSE[0], top + SIZE * HIGH
    return f"""<text x="380" y="{top - 8:.0f}" text-anchor="middle" font-weight="bold">{text}</text>
<rect x="{left:.1f}" y="{ground - SIZE * HOUSE[2]:.1f}" width="{SIZE * (HOUSE[1] - HOUSE[0]):.1f}" \
height="{SIZE * HOUSE[2]:.1f}" fill="#d0d7de" stroke="#6e7781"/>
<line x1="20" y1="{ground:.1f}" x2="740" y2="{ground:.1f}" stroke="#6e7781" stroke-width="2"/>
<path d="{''.join(slow)}" fill="none" stroke="#0969da" stroke-width="1.5"/>
<path d="{''.join(fast)}" fill="none" stroke="#cf222e" stroke-width="1.5"/>
"""


add_wake()
first = panel(40, "1. slowed in the lee")
project()
second = panel(320, "2. what flows into a cell flows out of it: around the house")
pathlib.Path(__file__).with_suffix(".svg").write_text(f"""\
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 760 572" role="img" font-family="sans-serif" \
font-size="14" fill="#24292f">
<title>The wind past a house</title>
<desc>Arrows of the wind in the cells of a vertical section. Above: an even wind from the left, slower behind a house, \
more so near the ground. Below: after the projection it rises before the house, is fast above it, and \
comes down behind it, where it stays slow.</desc>
<rect width="100%" height="100%" rx="8" fill="#f6f8fa"/>
{first}{second}</svg>
""")
