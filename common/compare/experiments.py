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
# its frames as slow. The programs make all but the last of these frames in time lapse.
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
    says: str = ""        # a pattern: the program says a time, ms, that counts in place of its frames'


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
    measured: str = "frame time"

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


# ---- And beyond: arrays, cores and what of the physics can be left out.

def arrays(here):
    return [Run(step, count, line, count, variant) for count in here.counts for step, line, variant in (
        ("step01_cpu_points", "glBegin", "one-loop"), ("step02_vbo", "client-side arrays", "arrays"),
        ("step02_vbo", "buffer", "subdata"), ("step02_vbo", "buffer, structure of arrays", "soa"))]


def arrays_found(lines):
    x = common_x(lines, *lines)[-1]
    clauses = []
    for name, points in lines.items():
        upload = busiest(points[x]).get("upload")
        clauses.append(f"{points[x].median:.2f} ms with {name}"
                       + (f" (upload {upload:.2f})" if upload is not None else ""))
    return f"at {x:,} flakes a frame takes " + ", ".join(clauses)


ALL_PARTS = "all parts"


def physics(here):
    without = {"turbulence": "turbulence=0", "wind": "wind_x=0", "variation": "variation=0",
               "melting": "melt_time=0", "sublimation": "lifetime=600"}
    return [Run("step01_cpu_points", count, line, count, "one-loop", ("--set", "wind_x=2", *options))
            for count in here.counts for line, options in [(ALL_PARTS, ())] + [
                (f"without {part}", ("--set", setting)) for part, setting in without.items()]]


def physics_found(lines):
    x = common_x(lines, *lines)[-1]
    times = [busiest(points[x]).get("update", 0) for points in lines.values()]
    return (parts_found(lines) + f"; the update alone takes {min(times):.2f} to {max(times):.2f} ms (a "
            "part that is left out is a number that is 0 or out of reach: it is worked with all the same)")


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


# Two flakes a frame, as in her final snowfall, and more.
YARDSTICK = (2 * CYCLE, 10000, 100000)


def yardstick(here):
    # The scene of step 5, with shading and depth: the programs draw polygons nowhere more simply.
    path = here.folder / "cube.obj"
    corners = [(x, y, z) for y in (0, 4) for z in (-2, 2) for x in (-2, 2)]
    faces = ("1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4")
    path.write_text("".join(f"v {x} {y} {z}\n" for x, y, z in corners)
                    + "".join(f"f {face}\n" for face in faces), encoding="ascii")
    cube = ("--scene", str(path), "--voxels", "32", "--camera", "41,15,30")
    return [run for count in YARDSTICK for run in (
        Run("step05_collision", 0, "cube", count, options=cube),
        Run("step02_vbo", count, "snowfall", count))]


def yardstick_found(lines):
    clauses = []
    for x in common_x(lines, "cube", "snowfall"):
        cube, snow = lines["cube"][x], lines["snowfall"][x]
        clauses.append(f"with {x:,} flakes {snow.median:.2f} ms ({compared(snow, cube)})")
    cube = lines["cube"][common_x(lines, "cube")[0]]
    return (f"a frame of the cube, which stands still, takes {cube.median:.2f} ms; one "
            "of the snowfall " + ", ".join(clauses))


def timing_methods(_here):
    return [Run("step02_vbo", particles, line, 500 * 500)
            for particles, line in ((0, "empty window"), (SWEEP_FLAKES, "20,000 flakes"))]


def timing_found(lines):
    clauses = []
    for name, points in lines.items():
        point = points[max(points)]
        clauses.append(f"{name}: {busiest(point)['draw']:.2f} ms for drawing alone, "
                       f"{point.median:.2f} from swap to swap")
    return ("; ".join(clauses) + "; what lies between is the rest of the program, and clearing and "
            "showing the window, which drawing alone leaves out here")


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


def feedback_found(lines):
    x = common_x(lines, "feedback", "compute")[-1]
    feedback, compute = lines["feedback"][x], lines["compute"][x]
    return (f"at {x:,} flakes a frame takes {feedback.median:.2f} ms with feedback and "
            f"{compute.median:.2f} ms with compute ({compared(compute, feedback)})"
            f"{updates(feedback, compute)}; the flakes take {64e-6 * x:,.2f} MB in two buffers and "
            f"{32e-6 * x:,.2f} MB in one")


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


def voxelisers(here):
    scene = hills(here.folder, 10000)
    return [Run("step05_collision", 0, f"on the {where.upper()}", voxels, "voxels",
                (*scene, "--voxels", str(voxels), "--voxeliser", where), says=r"made in ([\d.]+) ms")
            for voxels in (64, 128, 256) for where in ("cpu", "gpu")]


def voxelisers_found(lines):
    x = common_x(lines, "on the CPU", "on the GPU")[-1]
    cpu, gpu = lines["on the CPU"][x], lines["on the GPU"][x]
    return (f"10,000 triangles become a grid of {x}^3 voxels in {cpu.median:.1f} ms on the CPU and in "
            f"{gpu.median:.1f} ms on the GPU ({compared(gpu, cpu)})")


# ---- What each part of step 6 costs.

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
        "threads", "One loop on one core against all of them", "flakes",
        variants_of_step_1("one-loop", "threads"),
        f"{HITCHEN}, 2.5) tells of Saltvik's snowfall of 2006, which ran on several threads of the "
        "processor and slowed down beyond 40,000 flakes.",
        versus("threads"), counts=2 * ((10000, 100000, 1000000),), size="64x64",
        frames=(FRAMES, 20)),
    Experiment(
        "arrays", "Flake by flake, from arrays, from buffers", "flakes", arrays,
        f"{JORGENSEN} expected much of vertex arrays, more of buffers and most of a structure of "
        "arrays, and measured none of them.",
        arrays_found, counts=2 * ((1000, 10000, 100000),)),
    Experiment(
        "physics", "What each part of the physics costs", "flakes", physics,
        f"{JORGENSEN} switched some of the physics off and saw no effect on the performance.",
        physics_found, counts=2 * ((100000,),), baseline=ALL_PARTS, chart="parts"),
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
        "timing-methods", "Drawing alone against the whole frame", "pixels", timing_methods,
        f"{PATRICK}, table 2) timed an empty window at 9.857 fps by its drawing alone and at 9.862 by "
        "the whole frame, and falling snow at 9.561 and 9.578: no significant difference.",
        timing_found, size="500x500"),
    Experiment(
        "yardstick", "A cube of six polygons against the snowfall", "flakes", yardstick,
        f"{PATRICK}, 5.2.4) had 9.42 fps with a cube and 9.58 with snow of two new flakes a frame, and "
        "concluded that a game has room for snow.",
        yardstick_found, size="500x500"),
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
        "feedback-or-compute", "Transform feedback against a compute shader", "flakes",
        lambda here: [Run("step04_transform_feedback", count, variant, count, variant)
                      for count in here.counts for variant in ("feedback", "compute")],
        f"{HITCHEN}, 2.4) has it from Rice (2016) that compute shaders are only slightly faster but "
        "need significantly less memory.",
        feedback_found, counts=((10000, 100000, 1000000), (1000, 10000, 100000))),
    Experiment(
        "voxeliser", "The voxel grid, built on the CPU and on the GPU", "voxels along an edge",
        voxelisers,
        'Pettersson and Jin ("EDAN35: A Snow Particle System", 4.1) built theirs on the CPU and named '
        "the GPU as an option, to spend less time at the start.",
        voxelisers_found, warmup=(0, 0), frames=(1, 1), size="64x64", chart="lines",
        measured="time to build"),
    Experiment(
        "parts", "What each part of step 6 costs", "flakes", parts,
        f"{JORGENSEN} switched some of the physics off and saw no effect on the performance.",
        parts_found, counts=2 * ((100000,),), frames=(FRAMES, 20),
        baseline=ALL_PARTS, chart="parts"),
)}
