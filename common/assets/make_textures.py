#!/usr/bin/env python3
"""Make stone.png, wood.png, plaster.png and tiles.png, the surfaces of the courtyard.

Run:    python3 make_textures.py        (writes the pictures beside this script)
Units:  a picture is 256 x 256 pixels and stands for 1 x 1 m; its right side goes on at its left,
        its top at its bottom, so that it can be repeated.
Format: grey, 8 bits. A material's Kd, which it multiplies, is the colour: so three stones of
        different shades share a picture. Each picture is nearly white on average.

All is made of one kind of noise: random numbers on a coarse grid, blended in between, and the same
again at twice the fineness and half the strength.
"""
import random
import struct
import zlib
from math import floor, pi, sin
from pathlib import Path

SIZE = 256


class Noise:
    """Smooth noise, 0 to 1, that repeats after 1 x 1; `across` and `up` blotches in that."""

    def __init__(self, seed, across, up, octaves=4):
        rng = random.Random(seed)
        self.layers = []
        for octave in range(octaves):
            nx, ny = across << octave, up << octave
            self.layers.append((nx, ny, [rng.random() for _ in range(nx * ny)]))

    def __call__(self, x, y):
        total = weight = 0.0
        for octave, (nx, ny, grid) in enumerate(self.layers):
            i, j = floor(x * nx), floor(y * ny)
            s, t = x * nx - i, y * ny - j
            s, t = s * s * (3 - 2 * s), t * t * (3 - 2 * t)

            def at(a, b):
                return grid[(j + b) % ny * nx + (i + a) % nx]
            value = ((at(0, 0) * (1 - s) + at(1, 0) * s) * (1 - t) +
                     (at(0, 1) * (1 - s) + at(1, 1) * s) * t)
            total += value / 2 ** octave
            weight += 1 / 2 ** octave
        return total / weight


def step(low, high, x):
    t = min(max((x - low) / (high - low), 0.0), 1.0)
    return t * t * (3 - 2 * t)


def joint(position, width, noise):
    """0 in the joint between two stones, which lies at the whole numbers; 1 beside it."""
    return step(0.3 * width, width, min(position % 1, -position % 1) + 0.3 * width * (noise - 0.5))


def stone():
    """Two courses of slabs, 1.0 x 0.5 m, in running bond, with chisel marks and pits."""
    coarse, fine, pits = Noise(1, 4, 4), Noise(2, 64, 64, 2), Noise(3, 40, 40, 1)

    def shade(x, y):
        rough = coarse(x, y)
        value = 0.78 + 0.30 * (rough - 0.5) + 0.22 * (fine(x, y) - 0.5)
        value -= 0.22 * step(0.80, 0.95, pits(x, y))
        course = floor(2 * y)
        edge = joint(2 * y, 0.035, rough) * joint(x + 0.5 * course, 0.018, rough)
        return value * (0.45 + 0.55 * edge)
    return shade


def wood():
    """Boards along x: grain, year rings that a few knots push aside."""
    rings, fibres, warp = Noise(4, 1, 6), Noise(5, 4, 96, 2), Noise(6, 2, 3)
    knots = ((0.22, 0.31), (0.71, 0.77))

    def shade(x, y):
        bend = 0.10 * (warp(x, y) - 0.5)
        dark = 0.0
        for kx, ky in knots:
            dx, dy = (x - kx + 0.5) % 1 - 0.5, (y - ky + 0.5) % 1 - 0.5
            near = 1 / (1 + (7 * dx) ** 2 + (30 * dy) ** 2)
            bend += 0.05 * near * (1 if dy > 0 else -1)
            dark += near ** 4
        year = 0.5 + 0.5 * sin(2 * pi * (14 * (y + bend) + 2 * rings(x, y)))
        return 0.88 - 0.24 * year ** 3 - 0.35 * (fibres(x, y) - 0.45) - 0.4 * dark
    return shade


def plaster():
    """A trowelled wall: broad strokes, stains and a few fine cracks."""
    stains, strokes, grain, crack = Noise(7, 2, 2), Noise(8, 12, 5), Noise(9, 96, 96, 1), Noise(10, 3, 3)

    def shade(x, y):
        value = 0.90 + 0.16 * (stains(x, y) - 0.5) + 0.22 * (strokes(x, y) - 0.5)
        value += 0.10 * (grain(x, y) - 0.5)
        line = abs(crack(x, y) - 0.5)
        return value - 0.22 * (1 - step(0.0, 0.006, line)) * step(0.5, 0.6, stains(y, x))
    return shade


def tiles():
    """Pantiles: four waves across, three courses up the slope, each in the shadow of the next."""
    fire, fine = Noise(11, 8, 6), Noise(12, 64, 64, 2)
    rng = random.Random(13)
    burnt = [rng.uniform(-0.12, 0.10) for _ in range(12)]

    def shade(x, y):
        wave = 0.5 - 0.5 * abs(sin(pi * 4 * x)) ** 0.7     # dark in the hollow between two
        course = 3 * y + 0.10 * abs(sin(pi * 4 * x))
        below = course % 1                                  # 0 at the lower edge of a tile
        tile = burnt[floor(course) % 3 * 4 + floor(4 * x) % 4]
        value = 0.92 + tile - 0.62 * wave * wave + 0.24 * (fire(x, y) - 0.5)
        value += 0.14 * (fine(x, y) - 0.5)
        return value * (1 - 0.60 * step(0.80, 0.97, below)) * (1 - 0.25 * (1 - step(0, 0.06, below)))
    return shade


def chunk(kind, data):
    """A part of a PNG file: its length, its name, what it holds, and a check sum."""
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write(path, shade):
    rows = bytearray()
    for row in range(SIZE):
        rows.append(0)          # each row says first how it is filtered: not at all
        y = 1 - (row + 0.5) / SIZE
        # In steps of 4 of 255: nobody sees them, and the file is half as large.
        rows += bytes(4 * round(255 / 4 * min(max(shade((column + 0.5) / SIZE, y), 0.0), 0.99))
                      for column in range(SIZE))
    header = struct.pack(">IIBBBBB", SIZE, SIZE, 8, 0, 0, 0, 0)     # 8 bits, type 0: grey
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                     + chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))


def main():
    folder = Path(__file__).resolve().parent
    for make in (stone, wood, plaster, tiles):
        write(folder / f"{make.__name__}.png", make())


if __name__ == "__main__":
    main()
