#!/usr/bin/env python3
"""Make courtyard.obj and courtyard.mtl: a winter courtyard for the snow to fall on.

Run:    python3 make_courtyard.py        (writes both files beside this script)
Units:  metres; y is up, right-handed; the ground is y = 0 and spans x, z in [-8, 8].

An arcade runs along the back (z = -8) and the left (x = -8); the other two sides are open.
So there are places under the open sky, places half sheltered, and places snow cannot reach.
Faces wind counter-clockwise seen from outside. Snow is shown by moving vertices, so whatever
it can lie on is cut into small cells, and equal positions within an object are one vertex.
The pictures on it are made by make_textures.py. Texture coordinates are metres, too.
"""
import random
from math import cos, hypot, pi, radians, sin, sqrt
from pathlib import Path

HALF, WALL = 8.0, 0.3           # half the side of the courtyard; thickness of the outer walls
EAVES, RIDGE = 3.4, 4.6         # height of the lower and of the upper edge of the roofs
ROOF_DEPTH, ROOF_THICK = 3.1, 0.14
AXIS, LAST = -5.5, 7.75         # the lines on which the columns stand, and the last column
SPRING = 2.0                    # height at which an arch leaves its columns
LEG = 0.17                      # half the thickness of the arches; the width of their stones
UP = (0.0, 1.0, 0.0)

# Colour from afar; the lamp's glass also has its own light (Ke). In the order in which they are drawn:
# what hides much comes early, what is hidden late.
MATERIALS = {
    "tile_a": (0.58, 0.31, 0.23), "tile_b": (0.52, 0.27, 0.20), "tile_c": (0.63, 0.36, 0.26),
    "wood": (0.49, 0.39, 0.29), "wood_dark": (0.31, 0.23, 0.17), "iron": (0.13, 0.14, 0.16),
    "bark": (0.25, 0.20, 0.16), "soil": (0.22, 0.17, 0.13), "leaf": (0.20, 0.31, 0.18),
    "pot": (0.60, 0.37, 0.27), "lamp_glass": (0.95, 0.85, 0.62, 1.00, 0.72, 0.36),
    "stone_a": (0.69, 0.62, 0.52), "stone_b": (0.79, 0.74, 0.65), "ice": (0.55, 0.66, 0.72),
    "plaster": (0.80, 0.69, 0.54), "floor_a": (0.60, 0.54, 0.46), "floor_b": (0.47, 0.40, 0.34),
    "paving_a": (0.47, 0.47, 0.48), "paving_b": (0.43, 0.43, 0.45), "paving_c": (0.51, 0.50, 0.49),
}
PICTURES = {                    # of the materials whose names begin so; how often it fits in 1 m
    "paving": ("stone", 1), "floor": ("plaster", 1), "plaster": ("plaster", 0.5),
    "stone": ("plaster", 2), "tile": ("tiles", 1), "wood": ("wood", 2),
}
BRIGHTNESS = {"stone": 0.55, "wood": 0.61, "plaster": 0.77, "tiles": 0.65}      # mean, linear


def picture(material):
    return PICTURES.get(material.split("_")[0])


def add(a, b, scale=1.0):
    return tuple(p + scale * q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = sqrt(sum(p * p for p in a))
    return tuple(p / length for p in a)


def ring(centre, direction, radius, sides, hint=(1.0, 0.0, 0.0)):
    """Points around a direction, counter-clockwise seen from its tip."""
    v = unit(cross(direction, hint))
    u = cross(v, direction)
    angles = [2.0 * pi * (k + 0.5) / sides for k in range(sides)]
    return [add(add(centre, u, radius * cos(a)), v, radius * sin(a)) for a in angles]


class Mesh:
    """Objects made of polygons, each polygon with the name of its material."""

    def __init__(self):
        self.vertices, self.objects = [], {}
        self.places, self.place_index = [], {}      # texture coordinates, and their numbers

    def begin(self, name, x=0.0, z=0.0, turn=0.0):
        """Start an object; its points are turned about y by `turn` degrees, then moved to x, z."""
        self.place = (x, z, cos(radians(turn)), sin(radians(turn)))
        self.index = {}         # position -> vertex: this is what welds the object together
        self.faces = self.objects[name] = []

    def face(self, material, *points):
        """Add a polygon, except where it would coincide with the paving it stands on."""
        if all(y == 0.0 for _, y, _ in points) and self.faces is not self.objects["ground"]:
            return
        x0, z0, c, s = self.place
        corners, places = [], self.on_picture(material, points)
        for (x, y, z), place in zip(points, places):
            key = tuple(round(v, 4) + 0.0 for v in (x0 + c * x + s * z, y, z0 - s * x + c * z))
            if key not in self.index:
                self.vertices.append(key)
                self.index[key] = len(self.vertices)
            if self.index[key] not in [vertex for vertex, _ in corners]:
                corners.append((self.index[key], place))    # a quad that touches an axis is a triangle
        self.faces.append((material, corners))

    def on_picture(self, material, points):
        """The number of the place on the material's picture, if it has one, for each point: seen
        along the axis that the face looks to most nearly. Courses run level, grain lengthwise."""
        if not picture(material):
            return [None] * len(points)
        n = cross(add(points[1], points[0], -1.0), add(points[2], points[0], -1.0))
        if abs(n[1]) < max(abs(n[0]), abs(n[2])):   # a wall
            places = [(x if abs(n[2]) > abs(n[0]) else z, y) for x, y, z in points]
        elif abs(n[0]) > max(abs(n[2]), 0.1 * n[1]):    # a slope along x
            places = [(z, x if n[0] < 0 else -x) for x, y, z in points]
        else:
            places = [(x, z if n[2] < 0.1 * n[1] else -z) for x, y, z in points]
        wide, high = (max(p[k] for p in places) - min(p[k] for p in places) for k in (0, 1))
        if picture(material)[0] == "wood" and high > wide:
            places = [(v, u) for u, v in places]
        keys = [tuple(round(v, 3) + 0.0 for v in place) for place in places]
        for key in keys:
            if key not in self.place_index:
                self.places.append(key)
                self.place_index[key] = len(self.places)
        return [self.place_index[key] for key in keys]

    def skin(self, materials, rings):
        """Join each ring of points to the next one; the materials take turns around the ring."""
        for low, high in zip(rings, rings[1:]):
            for k in range(len(low)):
                n = (k + 1) % len(low)
                self.face(materials[k % len(materials)], low[k], low[n], high[n], high[k])

    def lathe(self, materials, sides, profile, x=0.0, z=0.0):
        """Turn a profile of (radius, height) about the upright through x, z."""
        self.skin(materials, [ring((x, y, z), UP, r, sides) for r, y in profile])

    def box(self, material, low, high, cells=1):
        """A box, cut into cells along its longest side."""
        size = add(high, low, -1.0)
        k = size.index(max(size))

        def corner(n, a, b):
            share = {k: n / cells, (k + 1) % 3: a, (k + 2) % 3: b}
            return tuple(low[d] + share[d] * size[d] for d in range(3))

        square = ((0, 0), (1, 0), (1, 1), (0, 1))
        rings = [[corner(n, a, b) for a, b in square] for n in range(cells + 1)]
        self.skin([material], rings)
        self.face(material, *reversed(rings[0]))
        self.face(material, *rings[-1])


def ground(mesh, rng):
    """32 x 32 cells of 0.5 m: slabs of 1.0 x 0.5 m in running bond, checkers in the arcade."""
    mesh.begin("ground")
    shades = {}
    for i in range(32):
        for j in range(32):
            slab = (i + j % 2) // 2
            shade = (slab + 2 * j + rng.randrange(2)) % 3
            material = "paving_" + "abc"[shades.setdefault((j, slab), shade)]
            if min(i, j) < 6:
                material = "floor_" + "ab"[(i + j) % 2]
            square = ((i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j))
            mesh.face(material, *((p / 2 - HALF, 0.0, q / 2 - HALF) for p, q in square))


def roof_height(x, z):
    """Top of the roof. Both wings fall towards the court and meet in a valley, at x = z."""
    return RIDGE - (RIDGE - EAVES) * min(x + HALF, z + HALF) / ROOF_DEPTH


def roof(mesh, rng):
    """One L of cells over both wings; every second line of vertices is lifted, as tiles are."""
    mesh.begin("roof")
    rows, columns = 10, 52      # cells up the slope, cells along the whole ridge
    step = (2.0 * HALF - ROOF_DEPTH) / (columns - rows)
    lines = [k * ROOF_DEPTH / rows - HALF for k in range(rows)]
    lines += [HALF - k * step for k in range(columns - rows, -1, -1)]

    def top(p, lift=0.04):      # a corner of the grid, and below it the underside
        x, z = lines[p[0]], lines[p[1]]
        return (x, roof_height(x, z) + lift * (max(p) % 2), z)

    def under(p):
        x, y, z = top(p, 0.0)
        return (x, y - ROOF_THICK, z)

    cells = [(i, j) for i in range(columns) for j in range(columns) if min(i, j) < rows]
    for i, j in cells:
        a, b, c, d = (i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)
        shades = rng.choices("abc", k=2) if i == j else 2 * rng.choice("abc")
        mesh.face("tile_" + shades[0], top(a), top(b), top(c))      # split as the valley runs
        mesh.face("tile_" + shades[1], top(a), top(c), top(d))
        sides = (a, b, (i - 1, j)), (b, c, (i, j + 1)), (c, d, (i + 1, j)), (d, a, (i, j - 1))
        for p, q, neighbour in sides:
            if neighbour not in cells:
                mesh.face("tile_b", top(q), top(p), under(p), under(q))
                if min(neighbour) >= 0:     # the corner by the walls sees all edges but its own
                    mesh.face("wood_dark", under((0, 0)), under(q), under(p))


def arch(mesh, x0, z0, x1, z1, segments=8):
    """A wall up to the roof with a round arch in it, from the axis of one column to the next."""
    half = hypot(x1 - x0, z1 - z0) / 2
    ux, uz = (x1 - x0) / half / 2, (z1 - z0) / half / 2

    def at(angle, radius, side, to_roof=False):
        along = half - radius * cos(angle)
        x, z = x0 + ux * along - uz * side, z0 + uz * along + ux * side
        y = roof_height(x, z) - ROOF_THICK / 2 if to_roof else SPRING + radius * sin(angle)
        return (x, y, z)

    def cut(angle):             # across the wall: up on its left, down on its right
        return [at(angle, half - LEG, -LEG), at(angle, half, -LEG), at(angle, half, -LEG, True),
                at(angle, half, LEG, True), at(angle, half, LEG), at(angle, half - LEG, LEG)]

    for k in range(segments):   # the stones around the opening alternate
        stone, wall = "stone_" + "ab"[k % 2], "plaster"
        cuts = [cut(pi * n / segments) for n in (k, k + 1)]
        mesh.skin([stone, wall, wall, wall, stone, stone], cuts)


def arcade(mesh):
    inner = WALL - HALF
    spots = [AXIS + (LAST - AXIS) * k / 5 for k in range(6)]
    line = [(AXIS, z) for z in reversed(spots[1:])] + [(x, AXIS) for x in spots]
    mesh.begin("columns")
    for x, z in line:
        mesh.box("stone_a", (x - 0.25, 0, z - 0.25), (x + 0.25, 0.16, z + 0.25), 2)
        mesh.lathe(["stone_b"], 8, [(0.24, 0.16), (0.24, 0.23), (0.17, 0.29), (0.15, 1.72),
                                    (0.24, 1.88)], x, z)
        mesh.box("stone_a", (x - 0.24, 1.88, z - 0.24), (x + 0.24, SPRING + 0.03, z + 0.24))
    mesh.begin("arches")
    ends = [(inner - LEG, LAST)] + line + [(LAST, inner - LEG)]     # the last arches meet the walls
    for start, end in zip(ends, ends[1:]):
        arch(mesh, *start, *end)
    for x, z in (line[0], line[5], line[-1]):       # piers where the line of arches turns
        top = roof_height(x, z) - 0.08
        mesh.box("plaster", (x - 0.19, SPRING, z - 0.19), (x + 0.19, top, z + 0.19))
    mesh.begin("walls")
    edge, top = HALF - 0.02, RIDGE - ROOF_THICK + 0.01      # inside the edge of the roof above
    mesh.box("plaster", (-edge, 0, -edge), (edge, top, inner), 8)
    mesh.box("plaster", (-edge, 0, inner), (inner, top, edge), 8)
    mesh.box("stone_a", (inner, 0, inner), (edge, 0.4, inner + 0.06), 8)
    mesh.box("stone_a", (inner, 0, inner + 0.06), (inner + 0.06, 0.4, edge), 8)


def table(mesh, name, x, z, turn):
    """A picnic table; the planks lie 0.10 m apart, so that snow falls between them too."""
    mesh.begin(name, x, z, turn)
    for k in range(-2, 3):
        mesh.box("wood", (-0.9, 0.70, 0.22 * k - 0.06), (0.9, 0.75, 0.22 * k + 0.06), 8)
    for seat in (-0.91, -0.69, 0.69, 0.91):
        mesh.box("wood", (-0.9, 0.41, seat - 0.06), (0.9, 0.45, seat + 0.06), 8)
    for end in (-0.6, 0.6):     # two trestles
        mesh.box("wood_dark", (end - 0.03, 0.62, -0.46), (end + 0.03, 0.70, 0.46))
        mesh.box("wood_dark", (end - 0.03, 0.33, -0.93), (end + 0.03, 0.41, 0.93))
        for s in (-1, 1):
            leg = [ring((end, y, s * (0.72 - 0.6 * y)), UP, 0.055, 4) for y in (0.0, 0.66)]
            mesh.skin(["wood_dark"], leg)


def bench(mesh, name, x, z, turn):
    mesh.begin(name, x, z, turn)
    for k in (-1, 0, 1):
        mesh.box("wood", (-0.9, 0.40, 0.17 * k - 0.06), (0.9, 0.45, 0.17 * k + 0.06), 6)
    for end in (-0.6, 0.6):
        mesh.box("stone_a", (end - 0.1, 0, -0.2), (end + 0.1, 0.40, 0.2))


def branch(mesh, rng, start, direction, length, radius, level=0):
    """A tapered, slightly crooked limb; from its upper joints grow the limbs of the next level."""
    steps, children = ((7, 5), (5, 4), (3, 4), (2, 0))[level]
    hint = (1.0, 0.0, 0.0) if abs(direction[1]) > 0.7 else UP
    point, joints, rings = start, [], []
    for k in range(steps + 1):
        thick = radius * (1.0 - (0.5 if children else 1.0) * k / steps)
        joints.append((point, direction, thick))
        rings.append(ring(point, direction, thick, 6 if level == 0 else 5, hint))
        bend = [rng.uniform(-0.15, 0.15) for _ in range(3)]
        direction = unit(add(add(direction, bend), UP, 0.07))
        point = add(point, direction, length / steps)
    mesh.skin(["bark"], rings)
    bud = rng.randrange(8)
    for k, (point, direction, thick) in enumerate(joints[:-children - 1:-1]):
        bud += 3                # each 3/8 of a turn further, as on a real twig
        tilt = radians(rng.uniform(38.0, 58.0) if k else 15.0)      # the first prolongs its parent
        heading = add(ring((0, 0, 0), direction, sin(tilt), 8, hint)[bud % 8], direction, cos(tilt))
        size = length * rng.uniform(0.64, 0.84) * (1.0 if k else 0.75)
        branch(mesh, rng, point, heading, size, thick * (0.7 if k else 0.95), level + 1)


def tree(mesh, rng, x, z):
    mesh.begin("planter", x, z)
    mesh.lathe(["stone_a", "stone_b"], 16, [(0.95, 0), (0.95, 0.34), (1.0, 0.34), (1.0, 0.42),
                                            (0.78, 0.42), (0.78, 0.34)])
    mesh.lathe(["soil"], 16, [(0.78, 0.34), (0.5, 0.38), (0.0, 0.41)])
    mesh.begin("tree", x, z)
    mesh.lathe(["bark"], 6, [(0.27, 0.36), (0.17, 0.6)])
    branch(mesh, rng, (0.0, 0.6, 0.0), UP, 2.1, 0.17)


def fountain(mesh, x, z):
    """A round basin, frozen over, and a bowl on a stem in its middle."""
    mesh.begin("fountain", x, z)
    mesh.lathe(["stone_a", "stone_b"], 20, [(1.1, 0), (1.1, 0.36), (1.2, 0.4), (1.2, 0.48),
                                            (0.96, 0.48), (0.94, 0.34)])
    mesh.lathe(["ice"], 20, [(0.94, 0.34), (0.68, 0.34), (0.42, 0.34), (0.18, 0.34)])
    mesh.lathe(["stone_b"], 20, [(0.18, 0.34), (0.1, 0.45), (0.1, 0.9), (0.5, 1.08), (0.52, 1.15),
                                 (0.45, 1.15), (0.3, 1.09)])
    mesh.lathe(["ice"], 20, [(0.3, 1.09), (0.06, 1.09)])
    mesh.lathe(["stone_b"], 20, [(0.06, 1.09), (0.09, 1.3), (0.0, 1.42)])


def small_things(mesh):
    mesh.begin("bin", -3.9, 5.9)
    mesh.lathe(["wood_dark", "iron"], 16, [(0.27, 0), (0.30, 0.70)])
    mesh.lathe(["iron"], 16, [(0.30, 0.70), (0.345, 0.70), (0.345, 0.76), (0.29, 0.81),
                              (0.2, 0.86), (0.1, 0.89), (0, 0.90)])
    mesh.begin("lamp", 4.2, -4.0)
    mesh.lathe(["iron"], 8, [(0.2, 0), (0.2, 0.12), (0.13, 0.18), (0.1, 0.55), (0.055, 0.65),
                             (0.045, 2.85), (0.09, 2.9), (0.09, 2.93), (0.12, 2.95)])
    mesh.lathe(["lamp_glass"], 8, [(0.12, 2.95), (0.19, 3.28)])
    mesh.lathe(["iron"], 8, [(0.19, 3.28), (0.27, 3.28), (0.25, 3.32), (0.1, 3.43), (0.03, 3.47),
                             (0.04, 3.52), (0, 3.56)])
    for name, z in (("pot_1", 0.3), ("pot_2", 3.7)):
        mesh.begin(name, -4.6, z)
        mesh.lathe(["pot"], 10, [(0.2, 0), (0.28, 0.36), (0.32, 0.36), (0.32, 0.44), (0.27, 0.44)])
        mesh.lathe(["soil"], 10, [(0.27, 0.44), (0.06, 0.46)])
        ball = [(0.36 * sin(pi * k / 7), 0.85 - 0.36 * cos(pi * k / 7)) for k in range(1, 8)]
        mesh.lathe(["leaf"], 10, [(0.06, 0.46), (0.06, 0.52)] + ball)


def write(mesh, folder):
    note = "# Made by make_courtyard.py. MIT licence, as the rest of the project.\n"
    with open(folder / "courtyard.mtl", "w", newline="\n") as out:
        out.write(note)
        for name, colour in MATERIALS.items():
            share = BRIGHTNESS[picture(name)[0]] if picture(name) else 1.0
            kd = tuple(min(c / share, 1.0) for c in colour[:3])
            out.write("\nnewmtl %s\nKd %.2f %.2f %.2f\n" % ((name,) + kd))
            if picture(name):
                file, scale = picture(name)
                out.write("map_Kd -s %g %g 1 %s.png\n" % (scale, scale, file))
            if len(colour) > 3:
                out.write("Ke %.2f %.2f %.2f\n" % colour[3:])
    with open(folder / "courtyard.obj", "w", newline="\n") as out:
        out.write(note + "# Metres, y up. The ground is y = 0.\nmtllib courtyard.mtl\n")
        out.writelines("v %.4f %.4f %.4f\n" % vertex for vertex in mesh.vertices)
        out.writelines("vt %g %g\n" % place for place in mesh.places)
        for name, faces in mesh.objects.items():
            out.write("o %s\n" % name)
            for material in sorted({material for material, _ in faces}):
                out.write("usemtl %s\n" % material)
                for corners in (f for m, f in faces if m == material):
                    out.write("f %s\n" % " ".join(f"{v}/{vt}" if vt else str(v) for v, vt in corners))


def main():
    mesh = Mesh()
    ground(mesh, random.Random(1))
    arcade(mesh)
    roof(mesh, random.Random(2))
    tree(mesh, random.Random(12), -2.3, -2.3)
    fountain(mesh, 1.6, -1.0)
    table(mesh, "table_1", 0.2, 3.9, 0)
    table(mesh, "table_2", 5.1, 1.8, -25)
    bench(mesh, "bench_1", -4.7, 2.0, 90)
    bench(mesh, "bench_2", -0.2, -7.3, 0)
    small_things(mesh)
    write(mesh, Path(__file__).resolve().parent)
    triangles = sum(len(corners) - 2 for faces in mesh.objects.values() for _, corners in faces)
    print(len(mesh.objects), "objects,", len(mesh.vertices), "vertices,", triangles, "triangles")


if __name__ == "__main__":
    main()
