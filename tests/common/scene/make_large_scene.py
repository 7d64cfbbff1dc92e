#!/usr/bin/env python3
"""Make a large scene, for measuring how long it takes to load: 260,000 triangles in 25 materials
with pictures, normals and texture coordinates, as modelling programs write them.

Run:    python3 make_large_scene.py FOLDER       (writes large.obj, large.mtl and 25 pictures)
"""
import pathlib
import random
import sys
from math import cos, pi, sin

import numpy
import PIL.Image

MATERIALS, CELLS = 25, 72       # a ball of 72 x 72 quads each


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    rng = random.Random(1)
    with open(folder / "large.mtl", "w") as out:
        for k in range(MATERIALS):
            noise = numpy.random.default_rng(k).integers(0, 255, (16, 16, 3), numpy.uint8)
            picture = PIL.Image.fromarray(noise).resize((512, 512), PIL.Image.BICUBIC)
            suffix = ("png", "jpg", "tga")[k % 3]
            picture.save(folder / f"picture {k}.{suffix}")
            out.write(f"newmtl m{k}\nKd 1 1 1\nmap_Kd picture {k}.{suffix}\n\n")
    with open(folder / "large.obj", "w") as out:
        out.write("mtllib large.mtl\n")
        for k in range(MATERIALS):
            x, z, radius = 4 * (k % 5), 4 * (k // 5), rng.uniform(1.0, 1.9)
            for i in range(CELLS + 1):
                for j in range(CELLS + 1):
                    a, b = 2 * pi * j / CELLS, pi * i / CELLS
                    n = sin(b) * cos(a), cos(b), sin(b) * sin(a)
                    out.write("v %.6f %.6f %.6f\n" % (x + radius * n[0], radius * (n[1] + 1), z + radius * n[2]))
                    out.write("vn %.6f %.6f %.6f\nvt %.6f %.6f\n" % (*n, 4 * j / CELLS, 2 * i / CELLS))
            out.write(f"o ball_{k}\nusemtl m{k}\ns 1\n")
            first, width = 1 + k * (CELLS + 1) ** 2, CELLS + 1
            for i in range(CELLS):
                for j in range(CELLS):
                    corner = first + i * width + j
                    out.write("f %s\n" % " ".join(f"{n}/{n}/{n}" for n in
                              (corner, corner + 1, corner + width + 1, corner + width)))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
