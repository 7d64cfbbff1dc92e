#!/usr/bin/env python3
"""Makes strip.png, beside this file: the courtyard after 0, 1, 3, 6 and 10 minutes of snow.

    step06_accumulation/winter/make_strip.py build/step06_accumulation

In software it takes some minutes. Needs Pillow.
"""

import pathlib
import subprocess
import sys
import tempfile

import PIL.Image

SIZE = WIDTH, HEIGHT = 240, 200
MINUTES = [0, 1, 3, 6, 10]
FRAME = 5  # s of snow, as 300 time steps are

if len(sys.argv) != 2:
    sys.exit(__doc__.strip())
with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.argv[1], "--size", "%dx%d" % SIZE, "--particles", "10000", "--camera", "55,16,15",
                    "--set", "tessellation=1", "--set", "multisample=1", "--set", "bloom=0.06",
                    "--set", "soft_shadows=1",
                    "--timelapse", str(60 * FRAME), "--frames", str(60 * MINUTES[-1] // FRAME),
                    "--record", folder], check=True)
    frames = sorted(pathlib.Path(folder).glob("*.png"))
    strip = PIL.Image.new("RGB", (len(MINUTES) * WIDTH, HEIGHT))
    for index, minutes in enumerate(MINUTES):
        frame = frames[max(60 * minutes // FRAME - 1, 0)]
        strip.paste(PIL.Image.open(frame), (index * WIDTH, 0))
strip.quantize().save(pathlib.Path(__file__).parent / "strip.png", optimize=True)
