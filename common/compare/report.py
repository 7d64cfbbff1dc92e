"""The .md of compare.py: what was measured on which machine, the table, and what it shows."""

from points import digits, is_software, ratio

NOTES = """
Median and 95th percentile are those of the frames of a run, from swap to swap; of several repeats the
geometric mean counts. *Repeats*: half of what lies between the least and the greatest median of one.
*Ratio*: the median divided by that of the first line with as many flakes, with its 96 % interval by
Student's t, where repeats are compared one by one: it misses the true ratio in 1 of 25 cases. "Cannot
tell": it holds 1; more repeats narrow it.
"""
SYNCHRONISED = """
Stages were timed between calls of glFinish in frames of their own, which lets nothing overlap: they
show where the time goes, and may add up to more than a frame, or leave some for showing the window.
"""


def report(experiment, lines, facts):
    """The whole page, as text."""
    text = [f"# {experiment.title}", "", *(f"- {fact}" for fact in facts)]
    if experiment.source:
        text += ["", f"**The source:** {experiment.source}", "",
                 f"**Here:** {experiment.conclusion(lines)}"]
    text += ["", f"![{experiment.title}]({experiment.name}.png)", "", *rows(experiment, lines), NOTES]
    clocks = {clock for points in lines.values() for point in points.values() for clock in point.stages}
    return "\n".join(text) + SYNCHRONISED * ("finish" in clocks)


def computers(table):
    """A line for each computer that the table is of."""
    table = table.assign(size=table.width.astype(str) + "x" + table.height.astype(str))
    return [f"{renderer}{' (software rendering)' * is_software(renderer)}; {processor}; window "
            f"{', '.join(sizes.unique())}, vsync off" for (renderer, processor), sizes in
            table.groupby(["renderer", "processor"], sort=False)["size"]]


def rows(experiment, lines):
    """The lines of the table, a row for each point."""
    base = lines.get(experiment.baseline, {})
    fps = ["fps"] * (experiment.measured == "frame")
    numbers = [experiment.x_label, "median, ms", "p95, ms", *fps, "repeats"] + ["ratio"] * bool(base)
    table = [["step", "variant", "line", *numbers, "stages, ms"],
             ["---"] * 3 + ["--:"] * len(numbers) + ["---"]]
    for line, points in lines.items():
        for x, point in sorted(points.items()):
            medians = point.medians.values()
            row = [point.step, point.variant, line, f"{x:,}", f"{point.median:.2f}",
                   f"{point.p95:.2f}"] + [digits(1000 / point.median)] * len(fps)
            row.append(f"±{50 * (max(medians) - min(medians)) / point.median:.0f} %")
            to_base = ratio(point, base[x]) if x in base else None
            row += [digits(to_base.middle) + to_base.interval if to_base else ""] * bool(base)
            # One group of stages for each clock.
            stages = [clock.upper().replace("FINISH", "") + ": " * (clock != "finish")
                      + ", ".join(f"{stage} {ms:.2f}" for stage, ms in times.items())
                      for clock, times in point.stages.items()]
            table.append([*row, "; ".join(stages)])
    return ["| " + " | ".join(row) + " |" for row in table]
