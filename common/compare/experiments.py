"""The experiments of the documents that the series follows, to be run again on any machine.

Each says which programs compare.py starts, what its source found, and what was found here.
"""

import math
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Tuple

from points import ratio

FRAMES = 120  # that count in each run, unless an experiment needs fewer
# Flakes of the preset snow fall for 8 s and lie for 4 s, and their first births are spread over
# those 12 s and the 4 s in which the snowfall thickens. Only then are its frames as slow as they get.
CYCLE = 60 * 12            # frames of 1/60 s
STEADY = CYCLE + 60 * 4    # frames

STEPS = {folder.name[5]: folder.name
         for folder in sorted(Path(__file__).parents[2].glob("step[0-9][0-9]_*"))}


@dataclass(frozen=True)
class Run:
    """One start of a program, and where its frame time belongs on the chart."""

    step: str             # "1" to "6"
    particles: int
    line: str             # name of the line on the chart
    x: int                # where on that line
    variant: str = ""     # the program's default unless given
    options: Tuple[str, ...] = ()  # more of the program's command line
    size: str = ""        # WxH of the window; the experiment's unless given


@dataclass(frozen=True)
class Experiment:
    """What to run, what it was like for those who did it first, and what it shows here."""

    name: str             # of --experiment and of the files
    title: str
    x_label: str          # what x counts
    runs: Callable        # settings, with build, counts, folder (for scenes), software -> [Run]
    source: str = ""      # one sentence
    found: Callable = None  # (this, lines) -> one sentence; `growth` unless given
    # Each on a graphics card, and in software.
    counts: Tuple[tuple, tuple] = ((), ())  # of flakes, where they are what is varied
    warmup: Tuple[int, int] = (STEADY, STEADY)  # frames
    frames: Tuple[int, int] = (FRAMES, FRAMES)
    size: str = "1280x720"
    baseline: str = ""    # the line that all others are compared with
    reference: Tuple[str, tuple] = ("", ())  # the source's own curve: its name, (x, ms) pairs
    chart: str = "times"  # against x; see draw_chart for others
    measured: str = "frame"  # or the stage whose time counts; "build": of the voxels

    def conclusion(self, lines):
        """What was found here, as one sentence. `lines` is {line: {x: Point}}."""
        try:
            return (self.found or growth)(self, lines)
        except (LookupError, ValueError):  # a line or a point on it is missing
            return "Too little was measured to say."


def steps(text):
    """1,2:orphan as [("1", ""), ("2", "orphan")]; raises ValueError if there is no such step."""
    pairs = [item.partition(":")[::2] for item in text.split(",")]
    if not {step for step, _ in pairs} <= set(STEPS):
        raise ValueError
    return pairs


def at_each_count(pairs, n=0):
    """Programs, as steps() gives them, at each number of flakes, on hills(n) if need be."""
    return lambda settings: [
        Run(step, count, f"{step} {variant or STEPS[step][7:]}", count, variant,
            hills(settings, n) if n else ())
        for count in settings.counts for step, variant in pairs]


def with_and_without(step, on, off):
    """A program with all of `on` set, and without each of the features that `off` turns off."""
    settings_of = {"everything": on, **{f"without {name}": {**on, **off[name]} for name in off}}
    return lambda settings: [
        Run(step, count, line, count, options=tuple(
            text for name, value in values.items() for text in ("--set", f"{name}={value}")))
        for count in settings.counts for line, values in settings_of.items()]


def features(settings):
    """Every switch that step 6 lists, and the bloom. In software some are off unless asked for."""
    said = subprocess.check_output([settings.build / STEPS["6"], "--help"], text=True)
    on = {name: 1 for name in re.findall(r"^ +(\w+) +[01] on/off", said, re.MULTILINE)}
    on["bloom"] = 0.06
    return with_and_without("6", on, {name: {name: 0} for name in on})(settings)


def scene(settings, name, corners, faces):
    """Options for a scene of these polygons, which count their corners from 1."""
    path = settings.folder / f"{name}.obj"
    path.write_text("".join("v {:.5f} {:.5f} {:.5f}\n".format(*corner) for corner in corners)
                    + "".join("f {} {} {} {}\n".format(*face) for face in faces), encoding="ascii")
    return "--scene", str(path)


def hills(settings, n):
    """Options for a scene of gentle hills, shown by n x n squares of two triangles."""
    grid = [(16 * column / n, 16 * row / n) for row in range(n + 1) for column in range(n + 1)]
    first = [row * (n + 1) + column + 1 for row in range(n) for column in range(n)]
    return scene(settings, f"hills_{n}", [(x, 1 + math.sin(x) * math.cos(z), z) for x, z in grid],
                 [(a, a + n + 1, a + n + 2, a + 1) for a in first])


def scene_triangles(settings):
    return [Run("5", count, variant, 2 * n * n, variant, hills(settings, n))
            for count in settings.counts for n in (2, 7, 20, 70, 190)
            for variant in ("voxels", "triangles", "boxes")]


def voxelisers(settings):
    return [Run("5", 0, f"on the {where.upper()}", voxels, "voxels", (
        *hills(settings, 70), "--voxels", str(voxels), "--voxeliser", where))
            for voxels in (64, 128, 256) for where in ("cpu", "gpu")]


def spawn_rates(settings):
    rates = (100, 1000, 10000) if settings.software else (1000, 10000, 100000, 300000)
    return [Run("4", rate * CYCLE // 60, "step 4", rate) for rate in rates]


def windows(*edges):  # square, with flakes and without
    return lambda settings: [
        Run("2", particles, line, edge * edge, size=f"{edge}x{edge}") for edge in edges
        for particles, line in ((0, "empty window"), (20000, "20,000 flakes"))]


def sweep(option, values, at_steps):
    return lambda settings: [
        Run(step, 20000, f"step {step}", value, options=(option, str(value)))
        for value in values for step in at_steps]


def yardstick(settings):
    # The scene of step 5, with shading and depth: the programs draw polygons nowhere more simply.
    cube = scene(settings, "cube", [(x, y, z) for y in (0, 4) for z in (-2, 2) for x in (-2, 2)],
                 ("1243", "5786", "1562", "3487", "1375", "2684"))
    return [run for count in (2 * CYCLE, 10000) for run in (  # two flakes a frame, as hers, and more
        Run("5", 0, "cube", count, options=(*cube, "--voxels", "32", "--camera", "41,15,30")),
        Run("2", count, "snowfall", count))]


def growth(experiment, lines):
    """How the time of each line changes from its first x to its last."""
    clauses = []
    for name, points in lines.items():
        (first, before), *_, (last, after) = sorted(points.items())
        clauses.append(f"{name} {before.median:.2f} ms at {first:,} and {after.median:.2f} at "
                       f"{last:,} {experiment.x_label}, {ratio(after, before)}")
    return f"The {experiment.measured} time is: {'; '.join(clauses)}."


def versus(stage):
    """A `found` that compares each line with the first, and says its stage, too, at the last x."""
    def found(experiment, lines):
        x = max(set.intersection(*map(set, lines.values())))
        clauses, (first, *_) = [], lines.values()
        for name, points in lines.items():
            stages = points[x].busiest
            clauses.append(f"{name} {points[x].median:.2f} ms"
                           + (f", {stage} {stages[stage]:.2f}" if stage in stages else "")
                           + (f", {ratio(points[x], first[x])}" if points is not first else ""))
        return f"The {experiment.measured} time at {x:,} {experiment.x_label} is: {'; '.join(clauses)}."
    return found


JORGENSEN = 'Jorgensen ("Particles System: Snow")'
PATRICK = 'Patrick ("An Investigation of Snow Effects", 2000'
HITCHEN = 'Hitchen ("Simulating Snowfall and Accumulation Through the GPU", 2019'
PETTERSSON = 'Pettersson and Jin ("EDAN35: A Snow Particle System"'
UP_TO_100_000 = 2 * ((1000, 10000, 100000),)
FIXED_SCENE = {"runs": at_each_count(steps("5:voxels,5:triangles,5:boxes"), n=20),
               "counts": ((10000, 30000, 100000, 300000, 1000000), (1000, 3000, 10000))}

EXPERIMENTS = {experiment.name: experiment for experiment in (
    Experiment(
        "compare", "The same snowfall, step by step", "flakes",
        lambda settings: at_each_count(sorted({*settings.steps, *settings.variants}))(settings),
        counts=UP_TO_100_000, baseline="1 cpu_points"),
    Experiment(
        "loops", "One loop over the flakes against three", "flakes",
        at_each_count(steps("1:one-loop,1:plain,1:three-loops")),
        f"{JORGENSEN} saw little change from three loops to one: the drawing was slow.",
        versus("update"), counts=UP_TO_100_000),
    Experiment(
        "hexagons", "Hexagons against points", "flakes", at_each_count(steps("1:one-loop,1:hexagons")),
        f"{JORGENSEN} had 120 fps below 6,000 hexagons, 12 at 10,000, and found points lighter.",
        versus("update"), counts=2 * ((1000, 3000, 6000, 10000),)),
    Experiment(
        "threads", "One loop on one core against all of them", "flakes",
        at_each_count(steps("1:one-loop,1:threads")),
        f"{HITCHEN}, 2.5) tells of Saltvik's snowfall, on several threads, slow beyond 40,000 flakes.",
        versus("update"), counts=2 * ((10000, 100000, 1000000),), size="64x64", frames=(FRAMES, 20)),
    Experiment(
        "arrays", "Flake by flake, from arrays, from buffers", "flakes",
        at_each_count(steps("1:one-loop,2:arrays,2:subdata,2:soa")),
        f"{JORGENSEN} expected much of vertex arrays, more of buffers and most of a structure of "
        "arrays, and measured none.",
        versus("upload"), counts=UP_TO_100_000),
    Experiment(
        "physics", "What each feature of the physics costs", "flakes",
        with_and_without("1", {"wind_x": 2}, {
            "turbulence": {"turbulence": 0}, "wind": {"wind_x": 0}, "variation": {"variation": 0},
            "melting": {"melt_time": 0}, "sublimation": {"lifetime": 600}}),
        f"{JORGENSEN} switched some of the physics off and saw no effect. (What is left out here is "
        "a number that is 0 or out of reach: it is computed with all the same.)",
        versus("update"), counts=2 * ((100000,),), baseline="everything", chart="features"),
    Experiment(
        "window-size", "Size of the window", "pixels", windows(250, 500, 750, 1000),
        f"{PATRICK}, 5.1.2) found that the size of the window affects the frame rate greatly: a "
        "processor that draws everything itself had 9.86 fps with an empty window of 500x500."),
    Experiment(
        "point-size", "Size of the points", "pixels across a point",
        sweep("--point-size", (1, 2, 3, 4, 8), "2"),
        f"{PATRICK}, 5.2.1) lost 0.4 of some 9.6 fps (4 %) from points 1 pixel wide to points of 8.",
        size="500x500"),
    Experiment(
        "release-rate", "Flakes released per frame", "flakes per frame",
        lambda settings: [Run("2", rate * CYCLE, "step 2", rate) for rate in (1, 2, 5, 10, 20)],
        f"{PATRICK}, 5.2.2) lost almost one of some 9.6 fps (10 %) from 1 flake per frame to 20.",
        size="500x500"),
    Experiment(
        "groups", "Number of groups in which the flakes are drawn", "groups",
        sweep("--groups", (1, 2, 4, 16, 64, 256), "12"),
        f"{PATRICK}, 5.2.3) found one group much faster than several that release as many.",
        size="500x500"),
    Experiment(
        "timing-methods", "Drawing alone against the whole frame", "pixels", windows(500),
        f"{PATRICK}, table 2) timed an empty window at 9.857 fps by its drawing alone and at 9.862 by "
        "the whole frame, and falling snow at 9.561 and 9.578: no significant difference.",
        versus("draw"), size="500x500", chart="bars"),
    Experiment(
        "yardstick", "A cube of six polygons against the snowfall", "flakes", yardstick,
        f"{PATRICK}, 5.2.4) had 9.42 fps with a cube and 9.58 with snow of two new flakes a frame.",
        versus("draw"), size="500x500"),
    Experiment(
        "flakes-fixed-scene", "Flakes over a scene of 800 triangles", "flakes",
        source=f"{HITCHEN}, appendix A), with 794 triangles on a GTX 970, took 1.5 ms at 10,000 "
        "flakes, 3.3 ms at 100,000 and 21.7 ms at 1,000,000, each against every triangle.",
        **FIXED_SCENE,
        reference=("Hitchen, triangles, GTX 970", ((10000, 1.5), (100000, 3.3), (1000000, 21.7)))),
    Experiment(
        "update-alone", "The update over a scene of 800 triangles", "flakes",
        source=f"{HITCHEN}, chart 3) found a time of the update proportional to the flakes.",
        **FIXED_SCENE, chart="lines", measured="update"),
    Experiment(
        "scene-triangles", "Triangles in the scene", "triangles", scene_triangles,
        f"{HITCHEN}, chart 4) found a proportional time: 100,000 flakes lost 60 fps at some 3,500.",
        counts=((100000,), (1000,)), warmup=(STEADY, 120), frames=(FRAMES, 10)),
    Experiment(
        "stage-share", "What a frame is spent on", "flakes",
        at_each_count(steps("5:voxels,5:triangles,6:winter"), n=20),
        f"{HITCHEN}, chart 2) spent over 98 % of a frame on moving and colliding the flakes.",
        versus("update"), chart="stages", counts=((100000,), (3000,))),
    Experiment(
        "spawn-rate", "Flakes released per second", "flakes per second", spawn_rates,
        f"{PETTERSSON}), at 2560x1440 on a GTX 1080 Ti, took 0.8 ms a frame at 1,000 and 10,000 "
        "flakes per second, 1.1 at 100,000 and 2.4 at 300,000.",
        size="2560x1440", frames=(FRAMES, 20),
        reference=("Pettersson and Jin, GTX 1080 Ti", (
            (1000, 0.8), (10000, 0.8), (100000, 1.1), (300000, 2.4)))),
    Experiment(
        "feedback-or-compute", "Transform feedback against a compute shader", "flakes",
        at_each_count(steps("4:feedback,4:compute")),
        f"{HITCHEN}, 2.4) has it from Rice (2016) that compute shaders are only slightly faster but "
        "need significantly less memory (here 32 bytes a flake in one buffer against 64 in two).",
        versus("update"), counts=((10000, 100000, 1000000), (1000, 10000, 100000))),
    Experiment(
        "voxeliser", "The voxel grid, built on the CPU and on the GPU", "voxels along an edge",
        voxelisers,
        f"{PETTERSSON}, 4.1) built theirs on the CPU and named the GPU as the faster option.",
        versus("update"), warmup=(0, 0), frames=(1, 1), size="64x64", chart="lines", measured="build"),
    Experiment(
        "parts", "What each feature of step 6 costs", "flakes", features,
        f"{JORGENSEN} switched some of the physics off and saw no effect.", versus(""),
        counts=((100000,), (10000,)), frames=(FRAMES, 20), baseline="everything", chart="features"),
)}
