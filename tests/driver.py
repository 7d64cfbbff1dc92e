"""pytest --driver: the programs on the OpenGL and the display that are there, and a table of how they did."""

import collections
import re

import pytest

KINDS = {"dumps": r"test_one_snowfall", "ledgers": r"ledger|sums", "pictures": r"test_picture"}

outcomes = collections.defaultdict(collections.Counter)  # of (step, kind): how many passed, failed ...
refusals = {}  # what this OpenGL cannot run, as the program says: an ordered set
REFUSED = re.compile(r"try an earlier step|--\w+ \w+ needs OpenGL")
reasons = collections.Counter()  # for skipping


def is_asked_for(config):
    return config.getoption("driver")


def skip_what_only_software_promises(config, items):
    for item in items:
        mark = item.get_closest_marker("only_software")
        if mark and is_asked_for(config):
            item.add_marker(pytest.mark.skip(reason=f"only of Mesa's llvmpipe: {mark.args[0]}"))


def skip_if_refused(config, status, errors):
    """A program that says that this OpenGL is not enough for what was asked has done what it should."""
    if is_asked_for(config) and status == 1 and REFUSED.search(errors):
        pytest.skip(errors.strip())


def note_outcome(report):
    if report.when != "call" and report.passed:
        return
    step = re.search(r"step0\d_[a-z_]*[a-z]", report.nodeid)
    kind = next((kind for kind, tests in KINDS.items() if re.search(tests, report.nodeid)), "all else")
    row = step[0] if step else "any step"
    if not report.skipped:
        outcomes[row, kind][report.outcome] += 1
        return
    reason = report.longrepr[2].removeprefix("Skipped: ")
    if REFUSED.search(reason):
        refusals[row, reason] = None
    else:
        outcomes[row, kind]["differ" if "of the pixels differ" in reason else "skipped"] += 1
        reasons[re.sub(r"\d.*", "...", reason)] += 1


def cell(counts):
    told = counts["passed"] + counts["failed"] + counts["differ"]
    if told == 0:
        return "-"
    words = f"{counts['passed']} of {told}"
    for outcome, word in ("differ", "differ"), ("failed", "FAILED"):
        words += f", {counts[outcome]} {word}" if counts[outcome] else ""
    return words


def table(driver):
    """To be pasted into an issue."""
    columns = [*KINDS, "all else"]
    lines = [driver, "", f"| step | {' | '.join(columns)} |", "|---" * (len(columns) + 1) + "|"]
    for row in sorted({row for row, _ in outcomes} | {row for row, _ in refusals}):
        cells = [cell(outcomes[row, kind]) for kind in columns]
        lines.append(f"| {row} | {' | '.join(cells)} |")
    lines += ["", *[f"- {refusal}" for _, refusal in refusals]]
    return lines + [f"- {count} skipped: {reason}" for reason, count in reasons.most_common()]
