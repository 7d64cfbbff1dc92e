"""The experiments of the documents that the series follows, to be run again on any machine.

Each says which programs it starts (`runs`), what its source found and, from the times measured,
what was found here (`found`). compare.py starts the programs and writes the files.
"""

import math
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, NamedTuple, Tuple

FRAMES = 120  # that count in each run, unless an experiment needs fewer
# Flakes of the preset snow fall for 8 s and lie for 4 s, and their first births are spread over
# those 12 s and the 4 s in which the snowfall thickens. Only then is it as dense as it will be, and
# its frames as slow.
CYCLE = 60 * 12            # frames of 1/60 s
STEADY = CYCLE + 60 * 4    # frames


@dataclass(frozen=True)
class Run:
    """One start of a program, and where its frame time belongs on the chart."""

    step: str             # folder and program, "step02_vbo"
    particles: int
    line: str             # name of the line on the chart
    x: float              # where on that line
    variant: str = ""     # the program's default unless given
    options: Tuple[str, ...] = ()  # more of the program's command line
    size: str = ""        # WxH of the window; the experiment's unless given


class Here(NamedTuple):
    """What an experiment is to make its runs of."""

    build: Path           # folder that holds the programs
    software: bool        # that is what renders
    counts: tuple         # of flakes
    folder: Path          # where files that the runs need may go


@dataclass(frozen=True)
class Experiment:
    """What to run, what it was like for those who did it first, and what it shows here."""

    name: str             # of --experiment and of the files
    title: str
    x_label: str          # what x counts
    runs: Callable        # Here -> [Run]
    source: str = ""      # one sentence
    found: Callable = None  # lines -> one sentence, that of `growth` unless given
    # Each on a graphics card, and in software.
    counts: Tuple[tuple, tuple] = ()  # of flakes, where they are what is varied
    warmup: Tuple[int, int] = (STEADY, STEADY)  # frames
    frames: Tuple[int, int] = (FRAMES, FRAMES)
    size: str = "1280x720"
    baseline: str = ""    # the line that the table compares all others with
    reference: Tuple[str, tuple] = ("", ())  # the source's own curve: its name, (x, ms) pairs
    # "times": against x, and the stages beside them; "lines": without those; "stages": those alone;
    # "parts": what each costs.
    chart: str = "times"

    def conclusion(self, lines):
        """What was found here, as one sentence."""
        try:
            found = self.found(lines) if self.found else growth(lines, self.x_label)
        except LookupError:  # a line or a point on it is missing
            found = "too little was measured to say"
        return f"{found[0].upper()}{found[1:]}."


# ---- Sentences. `lines` is {line: {x: Point}}; a Point has median, low, high and stages.

def common_x(lines, *names):
    """The x, in order, at which each of the lines called `names` has a point; at least one."""
    common = sorted(set.intersection(*(set(lines[name]) for name in names)))
    if not common:
        raise LookupError(f"{names} have no x in common")
    return common


def difference(after, before):
    """How much more `after` is than `before`, in words."""
    factor = after / before
    if factor >= 2 or factor <= 0.5:
        return f"{factor:,.0f} times as much" if factor >= 100 else f"{factor:.3g} times as much"
    return f"{100 * (factor - 1):+.0f} %"


def differ(a, b):
    """Whether two points lie further apart than the repeats of each."""
    return a.low > b.high or b.low > a.high


def compared(after, before):
    """How much longer the frames of one point are than another's, and whether that means much."""
    return difference(after.median, before.median) + (
        "" if differ(after, before) else ", no more than from repeat to repeat")


def growth(lines, what, upto=math.inf):
    """How the frame time of each line changes from its first x to its last that counts."""
    clauses = []
    for name, points in lines.items():
        xs = sorted(x for x in points if x <= upto)
        first, last = xs[0], xs[1:][-1]
        clauses.append(f"{name}: from {first:,} to {last:,} {what} a frame goes from "
                       f"{points[first].median:.2f} to {points[last].median:.2f} ms "
                       f"({compared(points[last], points[first])})")
    return "; ".join(clauses)


def busiest(point):
    """{stage: ms} of the clock that ran longest: CPU, GPU, or both together where synchronised."""
    return max(point.stages.values(), key=lambda times: sum(times.values()), default={})


def updates(before, after):
    """A clause on the stage update alone, if it was timed."""
    times = [busiest(point).get("update", 0) for point in (before, after)]
    return (f"; the update alone goes from {times[0]:.2f} to {times[1]:.2f} ms "
            f"({difference(times[1], times[0])})") if all(times) else ""


# ---- Jorgensen: loops and crystals.

JORGENSEN = 'Jorgensen ("Particles System: Snow")'


def variants_of_step_1(*variants):
    return lambda here: [Run("step01_cpu_points", count, variant, count, variant)
                         for count in here.counts for variant in variants]


def versus(other, at=None):
    """A `found` that compares a variant with one-loop, at so many flakes or the most there are."""
    def found(lines):
        common = common_x(lines, "one-loop", other)
        x = at if at in common else common[-1]
        points = lines["one-loop"][x], lines[other][x]
        frames = [f"{point.median:.2f} ms ({1000 / point.median:.0f} fps)" for point in points]
        return (f"at {x:,} flakes a frame takes {frames[0]} with one-loop and {frames[1]} with "
                f"{other} ({compared(*reversed(points))}){updates(*points)}")
    return found


# ---- Patrick: four sweeps, one at a time, in a window of 500 by 500.

PATRICK = 'Patrick ("An Investigation of Snow Effects", 2000'
SWEEP_FLAKES = 20000  # the programs' default


def window_sizes(_here):
    return [Run("step02_vbo", particles, line, edge * edge, size=f"{edge}x{edge}")
            for edge in (250, 500, 750, 1000)
            for particles, line in ((0, "empty window"), (SWEEP_FLAKES, "20,000 flakes"))]


def point_sizes(_here):
    return [Run("step02_vbo", SWEEP_FLAKES, "20,000 flakes", pixels,
                options=("--point-size", str(pixels)))
            for pixels in (1, 2, 3, 4, 8)]


def release_rates(_here):
    # As many a frame as she released, and then some for a machine of today.
    return [Run("step02_vbo", rate * CYCLE, "step 2", rate) for rate in (1, 2, 5, 10, 20, 100)]


def groups(_here):
    return [Run(step, SWEEP_FLAKES, line, count, options=("--groups", str(count)))
            for count in (1, 2, 4, 16, 64, 256)
            for step, line in (("step01_cpu_points", "step 1"), ("step02_vbo", "step 2"))]


# ---- Hitchen: flakes against triangles.

HITCHEN = 'Hitchen ("Simulating Snowfall and Accumulation Through the GPU", 2019'
HITCHEN_FRAMES = tuple((flakes, 1000 / fps) for flakes, fps in (  # appendix A, a tenth of its rows
    (10000, 686.487), (20000, 637.819), (50000, 455.919), (100000, 301.247), (200000, 181.103),
    (300000, 134.194), (500000, 87.0325), (700000, 64.0603), (1000000, 46.0061)))


def hills(folder, triangles):
    """Options for a scene of gentle hills, the same however many `triangles` (even) show them."""
    path = folder / f"hills_{triangles}.obj"
    quads = triangles // 2
    rows = max(n for n in range(1, math.isqrt(quads) + 1) if quads % n == 0)
    columns = quads // rows
    with open(path, "w", encoding="ascii") as file:
        for row in range(rows + 1):
            for column in range(columns + 1):
                x, z = 16 * column / columns, 16 * row / rows
                file.write(f"v {x:.5f} {1 + math.sin(x) * math.cos(z):.5f} {z:.5f}\n")
        for row in range(rows):
            for column in range(columns):
                a = row * (columns + 1) + column + 1  # OBJ counts from 1
                b = a + columns + 1
                file.write(f"f {a} {b} {b + 1}\nf {a} {b + 1} {a + 1}\n")
    return "--scene", str(path)


def flakes_fixed_scene(here):
    return [Run("step05_collision", count, variant, count, variant, hills(here.folder, 800))
            for count in here.counts for variant in ("voxels", "triangles")]


def scene_triangles(here):
    flakes = 1000 if here.software else 10000
    scenes = {triangles: hills(here.folder, triangles)
              for triangles in (12, 100, 1000, 10000, 70000)}
    return [Run("step05_collision", flakes, variant, triangles, variant, scene)
            for triangles, scene in scenes.items() for variant in ("voxels", "triangles")]


def stage_share(here):
    return [Run(step, count, line, count, variant, hills(here.folder, 800))
            for count in here.counts for step, line, variant in (
                ("step05_collision", "step 5 triangles", "triangles"),
                ("step05_collision", "step 5 voxels", "voxels"),
                ("step06_accumulation", "step 6", ""))]


def triangles_found(lines):
    xs = common_x(lines, "triangles")
    first, last = lines["triangles"][xs[0]], lines["triangles"][xs[-1]]
    return growth(lines, "triangles") + "; with triangles" + updates(first, last)[1:]


def share_found(lines):
    shares = []
    for name, points in lines.items():
        times = busiest(points[max(points)])
        shares.append(f"{100 * times['update'] / sum(times.values()):.1f} % in {name}")
    return "of the stages' time the update takes " + ", ".join(shares)


# ---- Pettersson and Jin: spawn rates.

def spawn_rates(here):
    rates = (100, 1000, 10000) if here.software else (1000, 10000, 100000, 300000)
    return [Run("step04_transform_feedback", rate * CYCLE, "step 4", rate) for rate in rates]


# ---- What each part of step 6 costs.

ALL_PARTS = "all parts"


def parts(here):
    program = "step06_accumulation"
    try:
        said = subprocess.run([here.build / program, "--help"], capture_output=True, text=True,
                              timeout=60, check=False).stdout
    except (OSError, subprocess.SubprocessError):
        said = ""  # it will not measure anything either, and then that is reported
    switches = re.findall(r"^ +(\w+) +1 on/off", said, re.MULTILINE)
    return [Run(program, count, line, count, options=options)
            for count in here.counts for line, options in [(ALL_PARTS, ())] + [
                (f"without {part}", ("--set", f"{part}=0")) for part in switches]]


def parts_found(lines):
    x = common_x(lines, *lines)[-1]
    whole = lines[ALL_PARTS][x]
    clauses = {True: [], False: []}
    for name in sorted(set(lines) - {ALL_PARTS}, key=lambda name: lines[name][x].median):
        point = lines[name][x]
        clauses[differ(whole, point)].append(f"{name} {point.median - whole.median:+.2f} ms")
    sentence = f"at {x:,} flakes a frame takes {whole.median:.2f} ms with all parts"
    if clauses[True]:
        sentence += "; " + ", ".join(clauses[True])
    if clauses[False]:
        sentence += "; no more than from repeat to repeat: " + ", ".join(clauses[False])
    return sentence


EXPERIMENTS = {experiment.name: experiment for experiment in (
    Experiment(
        "loops", "One loop over the flakes against three", "flakes",
        variants_of_step_1("one-loop", "three-loops"),
        f"{JORGENSEN} saw little change from three loops to one and put the slowness down to the "
        "drawing.",
        versus("three-loops"), counts=2 * ((1000, 10000, 100000),)),
    Experiment(
        "hexagons", "Hexagons against points", "flakes",
        variants_of_step_1("one-loop", "hexagons"),
        f"{JORGENSEN} had 120 fps below 6,000 hexagons and 12 fps (83 ms) at 10,000, and found "
        "points very much lighter.",
        versus("hexagons", 10000), counts=2 * ((1000, 3000, 6000, 10000, 30000),)),
    Experiment(
        "window-size", "Size of the window", "pixels", window_sizes,
        f"{PATRICK}, 5.1.2) found that the size of the window affects the frame rate greatly: a "
        "processor that draws everything itself had 9.86 fps with an empty window of 500x500."),
    Experiment(
        "point-size", "Size of the points", "pixels across a point", point_sizes,
        f"{PATRICK}, 5.2.1) lost only 0.4 of some 9.6 fps (about 4 %) from points 1 pixel wide to "
        "points of 8.",
        size="500x500"),
    Experiment(
        "release-rate", "Flakes released per frame", "flakes per frame", release_rates,
        f"{PATRICK}, 5.2.2) lost almost one of some 9.6 fps (about 10 %) from 1 flake released per "
        "frame to 20.",
        lambda lines: growth(lines, "flakes per frame", upto=20), size="500x500"),
    Experiment(
        "groups", "Number of groups in which the flakes are drawn", "groups", groups,
        f"{PATRICK}, 5.2.3) found one group of particles much faster than several that together "
        "release as many.",
        size="500x500"),
    Experiment(
        "flakes-fixed-scene", "Flakes over a scene of 800 triangles", "flakes",
        flakes_fixed_scene,
        f"{HITCHEN}, appendix A), with 794 triangles on a GTX 970, took 1.5 ms at 10,000 flakes, "
        "3.3 ms at 100,000 and 21.7 ms at 1,000,000, each against every triangle.",
        reference=("Hitchen 2019,\ntriangles, GTX 970", HITCHEN_FRAMES),
        counts=((10000, 30000, 100000, 300000, 1000000), (1000, 3000, 10000))),
    Experiment(
        "scene-triangles", "Triangles in the scene", "triangles", scene_triangles,
        f"{HITCHEN}, chart 4) found a time proportional to the triangles; with 100,000 flakes "
        "60 fps were lost at some 3,500.",
        triangles_found, warmup=(STEADY, 120), frames=(FRAMES, 10)),
    Experiment(
        "stage-share", "What a frame is spent on", "flakes", stage_share,
        f"{HITCHEN}, chart 2) spent over 98 % of a frame on moving and colliding the flakes.",
        share_found, chart="stages", counts=((100000,), (3000,))),
    Experiment(
        "spawn-rate", "Flakes released per second", "flakes per second", spawn_rates,
        'Pettersson and Jin ("EDAN35: A Snow Particle System"), at 2560x1440 on a GTX 1080 Ti, '
        "took 0.8 ms a frame at 1,000 and 10,000 flakes per second, 1.1 at 100,000 and 2.4 at "
        "300,000.",
        size="2560x1440",
        reference=("Pettersson and Jin,\nGTX 1080 Ti",
                   ((1000, 0.8), (10000, 0.8), (100000, 1.1), (300000, 2.4)))),
    Experiment(
        "parts", "What each part of step 6 costs", "flakes", parts,
        f"{JORGENSEN} switched some of the physics off and saw no effect on the performance.",
        parts_found, counts=2 * ((100000,),), warmup=(STEADY, 240), frames=(FRAMES, 20),
        baseline=ALL_PARTS, chart="parts"),
)}
