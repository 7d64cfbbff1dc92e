"""Small scenes for the tests, as OBJ text. All are 16 m wide, so that they are not scaled."""

from math import cos, pi, sin


def quad(*corners):
    """A face with the given corners."""
    lines = [f"v {x} {y} {z}" for x, y, z in corners]
    return lines + ["f " + " ".join(str(-n) for n in range(len(corners), 0, -1))]


def box(low, high):
    (x0, y0, z0), (x1, y1, z1) = low, high
    return (quad((x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1))
            + quad((x0, y1, z0), (x0, y1, z1), (x1, y1, z1), (x1, y1, z0))
            + quad((x0, y0, z0), (x0, y1, z0), (x1, y1, z0), (x1, y0, z0))
            + quad((x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1))
            + quad((x0, y0, z0), (x0, y0, z1), (x0, y1, z1), (x0, y1, z0))
            + quad((x1, y0, z0), (x1, y1, z0), (x1, y1, z1), (x1, y0, z1)))


def ellipsoid(centre, radii, lean=0):
    """Smooth: with normals. lean: turned about the z axis, degrees."""
    rings, around, lean = 16, 24, lean * pi / 180

    def turned(x, y, z):
        return x * cos(lean) - y * sin(lean), x * sin(lean) + y * cos(lean), z

    points, normals, faces = [], [], []
    for ring in range(rings + 1):
        for turn in range(around):
            down, along = pi * ring / rings, 2 * pi * turn / around
            unit = sin(down) * sin(along), cos(down), sin(down) * cos(along)
            place = turned(*(r * u for r, u in zip(radii, unit)))
            points.append("v {:.4f} {:.4f} {:.4f}".format(*(c + p for c, p in zip(centre, place))))
            normal = turned(*(u / r for r, u in zip(radii, unit)))
            normals.append("vn {:.4f} {:.4f} {:.4f}".format(*normal))
            if ring < rings:
                corners = [(ring, turn), (ring + 1, turn), (ring + 1, turn + 1), (ring, turn + 1)]
                indices = [r * around + t % around - (rings + 1) * around for r, t in corners]
                faces.append("f " + " ".join(f"{i}//{i}" for i in indices))
    return points + normals + faces


def text(*parts):
    return "\n".join(sum(parts, [])) + "\n"


FLOOR = quad((-8, 0, -8), (-8, 0, 8), (8, 0, 8), (8, 0, -8))

# Two planks of 2.5 m, 2 m above the floor, with a gap of 1 m between them.
TABLE = text(FLOOR, box((-3, 2, -3), (3, 2.2, -0.5)), box((-3, 2, 0.5), (3, 2.2, 3)))

# A wall across the wind.
WALL = text(FLOOR, box((-0.2, 0, -4), (0.2, 3, 4)))

# A roof that leans down to the floor, as wide as it, and the same roof over bare ground.
LEAN_TO = text(FLOOR, quad((-8, 0, 0), (8, 0, 0), (8, 4, 2.7), (-8, 4, 2.7)))
LEAN_TO_ON_BARE_GROUND = text(quad((-8, 0, 0), (8, 0, 0), (8, 4, 2.7), (-8, 4, 2.7)))

# Pairs of upright walls without thickness, each an acute corner open towards +x.
CORNERS = text(FLOOR, *(quad((-6, 0, z), (6, 0, z + 1), (6, 5, z + 1), (-6, 5, z))
                        + quad((-6, 0, z), (-6, 5, z), (6, 5, z - 1), (6, 0, z - 1))
                        for z in range(-6, 7, 2)))

# A lamp above the floor, and its lamp.mtl.
LAMP = "mtllib lamp.mtl\n" + text(FLOOR) + "usemtl glass\n" + text(box((-0.2, 1.5, -0.2), (0.2, 2, 0.2)))
GLASS = "newmtl glass\nKd 0.9 0.9 0.9\nKe 1 0.7 0.4\n"

# A sitting rabbit: round, so that snow lies thinner towards its sides, and none below its belly and its chin.
RABBIT = text(FLOOR, ellipsoid((0, 1.3, 0), (1.7, 1.3, 1.1), 12),        # its body,
              ellipsoid((1.7, 2.5, 0), (0.8, 0.65, 0.6)),                # head,
              ellipsoid((1.15, 3.6, 0.3), (0.2, 0.9, 0.28), 20),         # ears,
              ellipsoid((1.15, 3.6, -0.3), (0.2, 0.9, 0.28), 20),
              ellipsoid((-1.75, 1.2, 0), (0.4, 0.4, 0.4)),               # tail,
              ellipsoid((-0.5, 0.3, 0.9), (0.9, 0.3, 0.35)),             # and paws
              ellipsoid((-0.5, 0.3, -0.9), (0.9, 0.3, 0.35)),
              ellipsoid((1.5, 0.5, 0.35), (0.3, 0.6, 0.25), 20),
              ellipsoid((1.5, 0.5, -0.35), (0.3, 0.6, 0.25), 20))
