#!/usr/bin/env python3
"""Make snowflakes.png: an atlas of snow crystals, 4 x 8 tiles of 128 x 128 pixels, a row a habit.

Run:    python3 make_snowflakes.py       (writes the picture beside this script)
Units:  within a crystal, 1.0 is the length of a long arm, 55 pixels.
Format: grey and alpha, 8 bits each. The colour is white everywhere, the alpha is the shape.

A crystal that grew as a star or a plate is described by half of one arm, a wedge of 30 degrees. Each
pixel is folded into that wedge, and its signed distance to the nearest shape there says how much of it
is covered. Columns, needles and what broke or stuck together are described as a whole.

Habits, and what a snowfall of which temperature has: habit.glsl, which counts the rows as here.
"""
import struct
import zlib
from math import atan2, cos, hypot, pi, radians, sin
from pathlib import Path

TILE, UNIT = 128, 55.0          # 6 pixels at the edge stay empty, for the mip levels


def fold(x, y):
    """Distance from the centre, and the angle to the nearest of the six arms (0 to 30 degrees)."""
    return hypot(x, y), abs((atan2(y, x) + pi / 6) % (pi / 3) - pi / 6)


def line(x0, y0, length, degrees, width, tip):
    """A straight needle that starts at x0, y0 and tapers from half-width `width` to `tip`."""
    dx, dy = cos(radians(degrees)), sin(radians(degrees))

    def distance(x, y):
        t = min(max((x - x0) * dx + (y - y0) * dy, 0.0), length)
        return hypot(x - x0 - t * dx, y - y0 - t * dy) - (width + (tip - width) * t / length)
    return distance, 1.0


def plate(centre, radius, shade=1.0):
    """A hexagon on the arm, its corners towards the arms; a thin one lets light through."""
    def distance(x, y):
        r, a = fold(x - centre, y)
        return r * cos(pi / 6 - a) - radius * cos(pi / 6)
    return distance, shade


def rim(centre, radius, width):
    """The outline of such a plate, inside of its edge."""
    inside, _ = plate(centre, radius)
    return lambda x, y: abs(inside(x, y) + width) - width, 1.0


def arm(length=1.0, width=0.05, tip=0.025):
    return [line(0.0, 0.0, length, 0.0, width, tip)]


def twigs(*places, width=0.04, angle=60.0):
    """Side branches: pairs of (where on the arm, how long)."""
    return [line(at, 0.0, length, angle, width, 0.6 * width) for at, length in places]


def sector(radius, width=0.03):
    """A thin plate with a bright edge, and ribs from its centre to its corners."""
    return [plate(0.0, radius, 0.5), rim(0.0, radius, width)] + arm(radius - width, width, width)


def prism(width, length, degrees=0.0, x=0.0, y=0.0, shade=0.7):
    """A column seen from its side: a rectangle with a bright outline, its middle at x, y."""
    c, s = cos(radians(degrees)), sin(radians(degrees))

    def outside(px, py):
        u, v = (px - x) * c + (py - y) * s, (py - y) * c - (px - x) * s
        return max(abs(u) - length, abs(v) - width)
    return [(outside, shade), (lambda px, py: abs(outside(px, py) + 0.03) - 0.03, 1.0),
            line(x - length * c, y - length * s, 2.0 * length, degrees, 0.02, 0.02)]


def hollow(width, length, middle):
    """A column whose ends are funnels, which begin so far from its middle."""
    deep = length - middle
    walls = [line(end * length, side * width, hypot(deep, width),
                  atan2(-side * width, -end * deep) * 180.0 / pi, 0.03, 0.03)
             for end in (-1, 1) for side in (-1, 1)]
    return prism(width, length, shade=0.45) + walls


def moved(crystal, size, turn, x, y):
    """A six-fold crystal, smaller, turned and moved: a part of what is described as a whole."""
    def placed(distance):
        def there(px, py):
            r, a = fold((px - x) / size * cos(turn) + (py - y) / size * sin(turn),
                        (py - y) / size * cos(turn) - (px - x) / size * sin(turn))
            return size * distance(r * cos(a), r * sin(a))
        return there
    return [(placed(distance), shade) for distance, shade in crystal]


def broken(crystal, degrees, at=0.0):
    """What is left of a six-fold crystal on one side of a break."""
    c, s = cos(radians(degrees)), sin(radians(degrees))

    def part(distance):
        return lambda x, y: max(distance(x, y), x * c + y * s - at)
    return [(part(distance), shade) for distance, shade in moved(crystal, 1.0, 0.0, 0.0, 0.0)]


# Stars with many branches.
DENDRITES = [
    arm() + twigs((0.35, 0.30), (0.58, 0.30), (0.78, 0.17)) + [plate(0.0, 0.16)],
    arm() + twigs((0.26, 0.22), (0.42, 0.34), (0.58, 0.30), (0.73, 0.21), (0.86, 0.11), width=0.03),
    arm() + twigs((0.50, 0.40), (0.74, 0.20)) + [rim(0.0, 0.30, 0.035)],
    arm(0.9) + twigs((0.30, 0.18), (0.62, 0.34)) + [plate(0.92, 0.1), plate(0.0, 0.12)],
]

# Stars with few branches, or broad ones.
STARS = [
    arm(1.0, 0.11, 0.02) + [plate(0.0, 0.22)],
    arm(0.8, 0.06, 0.06) + twigs((0.46, 0.2), width=0.05) + [plate(0.8, 0.2), plate(0.0, 0.3)],
    arm(0.9, 0.06, 0.06) + twigs((0.40, 0.26), (0.64, 0.26), width=0.055) + [plate(0.9, 0.11)],
    arm() + twigs((0.30, 0.55), width=0.035, angle=30.0) + twigs((0.72, 0.22)) + [plate(0.0, 0.2)],
]

PLATES = [
    [plate(0.0, 0.9, 0.55), rim(0.0, 0.9, 0.04)],
    [plate(0.0, 0.88, 0.45), rim(0.0, 0.88, 0.035), rim(0.0, 0.6, 0.025)],
    [plate(0.0, 0.8, 0.5), rim(0.0, 0.8, 0.06), plate(0.0, 0.2, 0.8)],
    [plate(0.0, 0.9, 0.5), rim(0.0, 0.9, 0.035), rim(0.0, 0.45, 0.03), rim(0.0, 0.2, 0.025)],
]

SECTORED_PLATES = [
    sector(0.88, 0.035) + [rim(0.0, 0.50, 0.03)],
    sector(0.86) + twigs((0.38, 0.26), (0.60, 0.18), width=0.03) + [plate(0.0, 0.18)],
    sector(0.46, 0.035) + arm(0.9) + [plate(0.78, 0.24, 0.55), rim(0.78, 0.24, 0.03)],
    sector(0.62, 0.035) + arm() + twigs((0.76, 0.16)) + [plate(0.0, 0.2)],
]

COLUMNS = [
    prism(0.32, 0.75),
    hollow(0.3, 0.85, 0.2),
    hollow(0.38, 0.7, 0.1),
    prism(0.22, 0.7) + prism(0.42, 0.06, x=-0.72) + prism(0.42, 0.06, x=0.72),  # capped
]

NEEDLES = [
    [line(-0.98, 0.0, 0.98, 0.0, 0.02, 0.07), line(0.0, 0.0, 0.98, 0.0, 0.07, 0.02)],
    [line(-0.95, -0.06, 1.9, 0.0, 0.04, 0.03), line(-0.7, 0.07, 1.6, 0.0, 0.035, 0.035)],
    prism(0.08, 0.92, shade=0.6),
    [line(-0.9, -0.25, 1.85, 15.0, 0.04, 0.04), line(-0.9, 0.22, 1.85, -13.0, 0.04, 0.04)],
]

IRREGULAR = [
    broken(DENDRITES[0], 30.0, 0.2),
    broken(SECTORED_PLATES[1], 200.0, 0.25) + prism(0.1, 0.4, 110.0, 0.5, 0.1),
    moved(PLATES[0], 0.55, 0.2, -0.3, 0.15) + prism(0.15, 0.5, 60.0, 0.3, 0.1)
    + prism(0.13, 0.45, -35.0, 0.25, -0.35),                      # side planes
    broken(STARS[1], 30.0, 0.25) + prism(0.12, 0.5, 80.0, 0.2, 0.0),
]

AGGREGATES = [
    moved(DENDRITES[0], 0.55, 0.1, -0.35, 0.25) + moved(DENDRITES[2], 0.5, 0.5, 0.35, 0.3)
    + moved(STARS[2], 0.5, 0.3, 0.0, -0.4) + moved(DENDRITES[3], 0.4, 0.0, 0.0, 0.05),
    moved(SECTORED_PLATES[0], 0.5, 0.3, -0.4, -0.2) + moved(DENDRITES[1], 0.6, 0.0, 0.25, 0.3)
    + moved(PLATES[1], 0.4, 0.7, 0.3, -0.4) + moved(STARS[0], 0.4, 0.4, -0.3, 0.5),
    moved(STARS[0], 0.55, 0.2, 0.4, -0.2) + moved(STARS[3], 0.55, 0.6, -0.35, -0.3)
    + moved(DENDRITES[1], 0.5, 0.9, -0.15, 0.45) + prism(0.07, 0.5, 40.0, 0.1, 0.0),
    moved(DENDRITES[2], 0.6, 0.8, 0.0, 0.35) + moved(DENDRITES[0], 0.5, 0.3, -0.4, -0.3)
    + moved(SECTORED_PLATES[2], 0.5, 0.1, 0.4, -0.3) + moved(PLATES[0], 0.3, 0.5, 0.0, 0.0),
]

SIX_FOLD = PLATES, SECTORED_PLATES, STARS, DENDRITES
ROWS = [PLATES, NEEDLES, COLUMNS, SECTORED_PLATES, STARS, DENDRITES, IRREGULAR, AGGREGATES]


def coverage(px, py):
    """Alpha of a pixel: full inside a shape, none outside, smooth over about one pixel."""
    habit = ROWS[py // TILE]
    y, x = ((p % TILE + 0.5 - TILE / 2) / UNIT for p in (px, py))  # swapped: one arm points up
    if any(habit is one for one in SIX_FOLD):
        r, a = fold(x, y)
        x, y = r * cos(a), r * sin(a)
    alpha = 0.0
    for distance, shade in habit[px // TILE]:
        t = min(max(0.5 - distance(x, y) * UNIT / 1.5, 0.0), 1.0)
        alpha = max(alpha, shade * t * t * (3.0 - 2.0 * t))
    return round(255 * alpha)


def chunk(kind, data):
    """A part of a PNG file: its length, its name, what it holds, and a check sum."""
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def main():
    width, height = 4 * TILE, len(ROWS) * TILE
    rows = bytearray()
    for y in range(height):
        rows.append(0)          # each row says first how it is filtered: not at all
        for x in range(width):
            rows += bytes((255, coverage(x, y)))
    header = struct.pack(">IIBBBBB", width, height, 8, 4, 0, 0, 0)  # 8 bits, type 4: grey, alpha
    path = Path(__file__).resolve().parent / "snowflakes.png"
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                     + chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))


if __name__ == "__main__":
    main()
