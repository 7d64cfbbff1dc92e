"""Small scenes for the tests, as OBJ text. All are 16 m wide, so that they are not scaled."""


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
