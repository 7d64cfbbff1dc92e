#!/usr/bin/env python3
"""Make mountains.obj: a valley among snowy mountains, to be snowed on and flown through.

Run:    python3 make_mountains.py        (writes the file beside this script)
Units:  metres; y is up, right-handed; x and z span [-200, 200], and at the edges y = 0.

Peaks stand around a valley that opens towards +x, where in the afternoon the sun stands; where it is flat,
in the middle, are huts, and on the slopes above it firs. Ground that can hold snow is white with that of the
last months, what is steeper is rock; colours belong to vertices, so that one fades into the other.
"""
import random
from math import atan2, cos, floor, hypot, pi, sin
from pathlib import Path

HALF, STEP = 200.0, 4.0         # half the side; the ground's squares
VALLEY, FOOT = 22.0, 120.0      # m from the middle: flat up to here, as high as they get from here on
MOUTH = 1.75                    # rad from +z towards +x
PEAK = 105.0                    # m, about the height of the highest
SNOW, ROCK = (0.74, 0.78, 0.84), (0.19, 0.18, 0.18)
GRASS = (0.36, 0.36, 0.29)      # with snow between its blades
NEEDLES, BARK = (0.05, 0.10, 0.07), (0.17, 0.12, 0.09)
WOOD, ROOF = (0.26, 0.16, 0.09), (0.17, 0.14, 0.13)


def smoothstep(low, high, x):
    t = min(max((x - low) / (high - low), 0.0), 1.0)
    return t * t * (3 - 2 * t)


def knot(i, j):
    """Uniform in [0, 1), a number for each knot of a net."""
    return random.Random(i * 7919 + j).random()


def noise(x, z):
    """Smooth between the knots, -1 to 1."""
    i, j = floor(x), floor(z)
    u, v = smoothstep(0, 1, x - i), smoothstep(0, 1, z - j)
    near = knot(i, j) * (1 - u) + knot(i + 1, j) * u
    far = knot(i, j + 1) * (1 - u) + knot(i + 1, j + 1) * u
    return 2 * (near * (1 - v) + far * v) - 1


def from_mouth(x, z):
    """Angle between there and the valley's mouth, as seen from the middle, 0 to pi."""
    return abs((atan2(x, z) - MOUTH + pi) % (2 * pi) - pi)


def height(x, z):
    """Ridges where noise changes its sign (Musgrave's ridged multifractal), as high as their place allows."""
    ridges, size, weight = 0.0, 95.0, 0.62
    for octave in range(4):
        ridge = 1 - abs(noise(x / size + 17.3 * octave, z / size - 9.1 * octave))
        ridges += weight * ridge * ridge
        size, weight = 0.47 * size, 0.42 * weight
    rise = smoothstep(VALLEY, FOOT, hypot(x, z))
    fall = 1 - smoothstep(0.62 * HALF, 0.99 * HALF, max(abs(x), abs(z)))
    return PEAK * ridges * rise * fall * (0.12 + 0.88 * smoothstep(0.5, 1.3, from_mouth(x, z)))


def slope(x, z):
    """Of the ground, m for each m."""
    return hypot(height(x + 2, z) - height(x - 2, z), height(x, z + 2) - height(x, z - 2)) / 4


class Obj:
    """Vertices with colours, numbered from 1, and the faces between them."""

    def __init__(self):
        self.lines, self.count = [], 0

    def vertex(self, place, colour):
        numbers = [f"{p:.2f}".rstrip("0").rstrip(".") for p in (*place, *colour)]
        self.lines.append("v " + " ".join(numbers))
        self.count += 1
        return self.count

    def face(self, *corners):
        self.lines.append("f " + " ".join(map(str, corners)))

    def polygon(self, colour, *places):
        self.face(*(self.vertex(place, colour) for place in places))


def ground(obj):
    n = round(2 * HALF / STEP) + 1
    obj.lines += ["o ground", "s 1"]
    for k in range(n):
        for i in range(n):
            x, z = i * STEP - HALF, k * STEP - HALF
            rock = smoothstep(0.75, 1.1, slope(x, z) + 0.15 * noise(x / 9, z / 9))    # 37 to 48 degrees
            grass = (1 - smoothstep(1, 14, height(x, z))) * smoothstep(-0.2, 0.5, noise(x / 14, z / 14))
            white = [s + 0.35 * grass * (g - s) for s, g in zip(SNOW, GRASS)]
            obj.vertex((x, height(x, z), z), [w + rock * (r - w) for w, r in zip(white, ROCK)])
    for k in range(n - 1):
        for i in range(n - 1):
            a = k * n + i + 1
            obj.face(a, a + n, a + n + 1, a + 1)


def fir(obj, x, z, size):
    y, sides = height(x, z) - 0.3, 6
    for low, high, radius in ((0.1, 0.55, 0.26), (0.36, 0.8, 0.19), (0.62, 1.0, 0.12)):
        tip = obj.vertex((x, y + high * size, z), NEEDLES)
        rim = [obj.vertex((x + radius * size * sin(2 * pi * i / sides), y + low * size,
                           z + radius * size * cos(2 * pi * i / sides)), NEEDLES) for i in range(sides)]
        for i in range(sides):
            obj.face(rim[i], rim[(i + 1) % sides], tip)
        obj.face(*reversed(rim))
    trunk = 0.03 * size
    corners = [(x - trunk, z - trunk), (x - trunk, z + trunk), (x + trunk, z + trunk), (x + trunk, z - trunk)]
    for (ax, az), (bx, bz) in zip(corners, corners[1:] + corners[:1]):
        obj.polygon(BARK, (ax, y - 0.5, az), (bx, y - 0.5, bz), (bx, y + 0.15 * size, bz), (ax, y + 0.15 * size, az))


def hut(obj, x, z, turn, width, depth):
    """Walls of logs, gables, and a roof that stands out over them."""
    y, eaves, ridge, out = height(x, z) - 0.3, 2.6, 2.6 + 0.42 * width, 0.6

    def place(across, up, along):
        return (x + across * cos(turn) + along * sin(turn), y + up, z - across * sin(turn) + along * cos(turn))

    w, d = 0.5 * width, 0.5 * depth
    for side in (1, -1):    # each half is the other one, turned by half a circle
        obj.polygon(WOOD, place(side * w, 0, side * d), place(side * w, 0, -side * d),
                    place(side * w, eaves, -side * d), place(side * w, eaves, side * d))
        obj.polygon(WOOD, place(-side * w, 0, side * d), place(side * w, 0, side * d), place(side * w, eaves, side * d),
                    place(0, ridge, side * d), place(-side * w, eaves, side * d))
        low = eaves - 0.84 * out + 0.12     # of the eaves' outer edge: the roof's slope is 0.84
        over, top = side * (w + out), ridge + 0.12
        obj.polygon(ROOF, place(over, low, side * (d + out)), place(over, low, -side * (d + out)),
                    place(0, top, -side * (d + out)), place(0, top, side * (d + out)))


def firs(obj):
    """On slopes that are not too steep nor too high, thicker where noise says so, away from the huts."""
    obj.lines += ["o firs", "s off"]
    choose, placed = random.Random(4), []
    while len(placed) < 190:
        x, z = choose.uniform(-150, 150), choose.uniform(-150, 150)
        clear = all(hypot(x - a, z - b) > 3.5 for a, b in placed)
        wood = smoothstep(-0.3, 0.4, noise(x / 30 + 5, z / 30))
        in_view = from_mouth(x, z) < 0.7 and hypot(x, z) < 75    # of who looks in by the mouth
        if (in_view or hypot(x, z) < 20 or slope(x, z) > 0.8 or not clear or choose.random() > wood
                or height(x, z) > choose.uniform(15, 50)):
            continue
        placed.append((x, z))
        fir(obj, x, z, choose.uniform(5, 10))


def main():
    obj = Obj()
    ground(obj)
    obj.lines += ["o huts", "s off"]
    hut(obj, -3.0, -2.0, 0.5, 6.0, 8.0)
    hut(obj, 6.5, -7.5, -0.4, 5.0, 6.0)
    hut(obj, -12.0, 4.5, 1.4, 4.5, 5.5)
    firs(obj)
    header = "# A valley among mountains, made by make_mountains.py. Units are metres; y is up.\n"
    (Path(__file__).resolve().parent / "mountains.obj").write_text(header + "\n".join(obj.lines) + "\n",
                                                                   encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
