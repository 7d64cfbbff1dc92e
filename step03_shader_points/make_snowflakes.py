#!/usr/bin/env python3
"""Make snowflakes.png: an atlas of sixteen snow crystals, 4 x 4 tiles of 128 x 128 pixels.

Run:    python3 make_snowflakes.py       (writes the picture beside this script)
Units:  within a crystal, 1.0 is the length of a long arm, 55 pixels.
Format: grey and alpha, 8 bits each. The colour is white everywhere, the alpha is the shape.

A crystal is described by half of one arm, a wedge of 30 degrees. Each pixel is folded into
that wedge, and its signed distance to the nearest shape there says how much of it is covered.
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


CRYSTALS = [
    # stellar dendrites
    arm() + twigs((0.35, 0.30), (0.58, 0.30), (0.78, 0.17)) + [plate(0.0, 0.16)],
    arm() + twigs((0.26, 0.22), (0.42, 0.34), (0.58, 0.30), (0.73, 0.21), (0.86, 0.11), width=0.03),
    arm() + twigs((0.50, 0.40), (0.74, 0.20)) + [rim(0.0, 0.30, 0.035)],
    arm(0.9) + twigs((0.30, 0.18), (0.62, 0.34)) + [plate(0.92, 0.1), plate(0.0, 0.12)],
    # simple stars
    arm(1.0, 0.11, 0.02) + [plate(0.0, 0.22)],
    arm(0.98, 0.055, 0.055) + twigs((0.66, 0.30), width=0.05),
    arm(0.8, 0.06, 0.06) + twigs((0.46, 0.2), width=0.05) + [plate(0.8, 0.2), plate(0.0, 0.3)],
    arm(1.0, 0.07, 0.03) + [line(0.0, 0.0, 0.55, 30.0, 0.06, 0.03), plate(0.0, 0.22)],
    # plates
    sector(0.88, 0.035) + [rim(0.0, 0.50, 0.03)],
    sector(0.86) + twigs((0.38, 0.26), (0.60, 0.18), width=0.03) + [plate(0.0, 0.18)],
    sector(0.46, 0.035) + arm(0.9) + [plate(0.78, 0.24, 0.55), rim(0.78, 0.24, 0.03)],
    sector(0.62, 0.035) + arm() + twigs((0.76, 0.16)) + [plate(0.0, 0.2)],
    # broad branches, many needles
    arm(0.9, 0.06, 0.06) + twigs((0.40, 0.26), (0.64, 0.26), width=0.055) + [plate(0.9, 0.11)],
    sector(0.36, 0.04) + arm(1.0, 0.04) + twigs((0.52, 0.2), (0.68, 0.2), (0.84, 0.14)),
    arm() + twigs((0.30, 0.55), width=0.035, angle=30.0) + twigs((0.72, 0.22)) + [plate(0.0, 0.2)],
    arm(1.0, 0.04) + twigs((0.45, 0.42), (0.72, 0.15), (0.86, 0.1)) + [plate(0.0, 0.16)],
]


def coverage(px, py):
    """Alpha of a pixel: full inside a shape, none outside, smooth over about one pixel."""
    crystal = CRYSTALS[py // TILE * 4 + px // TILE]
    x, y = ((p % TILE + 0.5 - TILE / 2) / UNIT for p in (px, py))
    r, a = fold(y, x)           # x and y swapped: one arm points up
    alpha = 0.0
    for distance, shade in crystal:
        t = min(max(0.5 - distance(r * cos(a), r * sin(a)) * UNIT / 1.5, 0.0), 1.0)
        alpha = max(alpha, shade * t * t * (3.0 - 2.0 * t))
    return round(255 * alpha)


def chunk(kind, data):
    """A part of a PNG file: its length, its name, what it holds, and a check sum."""
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def main():
    size = 4 * TILE
    rows = bytearray()
    for y in range(size):
        rows.append(0)          # each row says first how it is filtered: not at all
        for x in range(size):
            rows += bytes((255, coverage(x, y)))
    header = struct.pack(">IIBBBBB", size, size, 8, 4, 0, 0, 0)     # 8 bits, type 4: grey, alpha
    path = Path(__file__).resolve().parent / "snowflakes.png"
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                     + chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))


if __name__ == "__main__":
    main()
