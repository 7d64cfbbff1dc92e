"""Points on a chart, from the table of what was measured, and when two of them differ.

The table is that of the .csv: a row for each run and stage. Several repeats of a run are one point,
with the geometric mean of their medians, so that the ratio of two points is the mean of theirs.
"""

import math
import statistics
from dataclasses import dataclass
from typing import NamedTuple

COLUMNS = ("experiment,line,x,step,variant,options,particles,width,height,renderer,processor,"
           "repeat,stage,clock,frames,median_ms,p95_ms").split(",")
# What timed a stage: frames from swap to swap, the program itself, both processors until glFinish, or
# one of them. The first counts.
CLOCKS = ("swap", "program", "finish", "gpu", "cpu")
# Student's t: as many standard errors to both sides of the mean of 2, 3, ... repeats hold the true
# mean in 96 of 100 cases, so that fewer than 1 in 20 claims of a difference are wrong.
STUDENT_T = (15.89, 4.85, 3.48, 3.00, 2.76, 2.61, 2.52, 2.45, 2.40)


@dataclass
class Point:
    """All repeats of one run."""

    step: str
    variant: str
    medians: dict  # repeat -> ms
    p95: float     # ms
    stages: dict   # clock -> stage -> ms

    @property
    def median(self):
        return statistics.geometric_mean(self.medians.values())

    @property
    def busiest(self):
        """{stage: ms} of the clock that ran longest."""
        return max(self.stages.values(), key=lambda times: sum(times.values()), default={})


class Ratio(NamedTuple):
    """How many times as long one point takes as another, with its 96 % interval."""

    middle: float
    low: float
    high: float

    @property
    def is_sure(self):
        return self.low > 1 or self.high < 1

    @property
    def interval(self):
        says_nothing = self.high > 100 * self.low
        return "" if says_nothing else f" ({digits(self.low)} to {digits(self.high)})"

    def __str__(self):
        what = f"{digits(self.middle)} times as much" if self.is_sure else "cannot tell"
        return what + self.interval


def ratio(after, before):
    """The Ratio of two points. Repeats are compared one by one, as a machine changes between them."""
    logarithms = [math.log(after.medians[repeat] / before.medians[repeat])
                  for repeat in after.medians if repeat in before.medians]
    mean, margin = statistics.fmean(logarithms), math.inf
    if len(logarithms) > 1:
        t = STUDENT_T[min(len(logarithms) - 2, len(STUDENT_T) - 1)]
        margin = t * statistics.stdev(logarithms) / math.sqrt(len(logarithms))
    return Ratio(math.exp(mean), math.exp(mean - margin), math.exp(mean + margin))


def digits(value):
    """Three of them that count, and no exponent."""
    return f"{float(f'{value:.3g}'):,.12g}"


def points_of(table, measured):
    """{line: {x: Point}} of the stage `measured`, with what else was timed as the points' stages."""
    lines = {}
    table = table.assign(median_ms=table.median_ms.clip(1e-4))  # ms, the last decimal of the .csv
    for (line, x), rows in table.groupby(["line", "x"], sort=False):
        whole = rows[rows.stage == measured]
        whole = whole[whole.clock == min(whole.clock, key=CLOCKS.index, default="")]
        if whole.empty:
            continue
        stages = {clock: times.groupby("stage", sort=False).median_ms.apply(
            statistics.geometric_mean).to_dict() for clock, times in rows.groupby("clock")
            if clock in CLOCKS[2:]}
        lines.setdefault(line, {})[x] = Point(
            whole.step.iloc[0], whole.variant.iloc[0], dict(zip(whole.repeat, whole.median_ms)),
            statistics.geometric_mean(whole.p95_ms), stages)
    return lines


def is_software(renderer):
    names = "llvmpipe,lavapipe,softpipe,swrast,software,swr,gdi generic,basic render".split(",")
    return any(name in renderer.lower() for name in names)
