#!/usr/bin/env python3
"""Makes film.webp, beside this file: ten seconds of the tour while it snows for four minutes.

    step06_accumulation/winter/make_film.py build/step06_accumulation

In software it takes some minutes. Needs Pillow.
"""

import pathlib
import subprocess
import sys
import tempfile

import PIL.Image

SECONDS, RECORDED, SHOWN = 10, 60, 12  # of frames a second; the rest is left out

if len(sys.argv) != 2:
    sys.exit(__doc__.strip())
with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.argv[1], "--size", "640x360", "--particles", "15000", "--timelapse", "24", "--tour",
                    "--set", "tessellation=1", "--set", "multisample=1", "--set", "bloom=0.06",
                    "--set", "soft_shadows=1",
                    "--frames", str(SECONDS * RECORDED), "--record", folder], check=True)
    frames = [PIL.Image.open(path).convert("RGB")
              for path in sorted(pathlib.Path(folder).glob("*.png"))[::RECORDED // SHOWN]]
frames[0].save(pathlib.Path(__file__).parent / "film.webp", save_all=True, append_images=frames[1:],
               duration=1000 // SHOWN, loop=0, quality=55, method=6)
