"""Reads tables that compare.py has written, on one computer or on many, to be put side by side."""

import csv
import math

COLUMNS = ("experiment,line,x,step,variant,options,particles,width,height,renderer,processor,"
           "repeat,stage,clock,frames,median_ms,p95_ms").split(",")


class Refused(Exception):
    """A table that cannot stand beside the others; says which and why."""


def read_table(path):
    """The rows of one, as dictionaries, with numbers where they belong."""
    rows, reader = [], None
    try:
        with open(path, newline="", encoding="utf-8") as file:
            reader = csv.DictReader(file, strict=True)
            missing = [name for name in COLUMNS if name not in (reader.fieldnames or ())]
            if missing:
                raise Refused(f"{path} is no table of this compare.py: it has no column "
                              f"'{missing[0]}' (measure again)")
            for row in reader:
                if None in row or None in row.values():
                    raise ValueError(f"there should be {len(reader.fieldnames)} columns")
                for name in ("x", "particles", "width", "height", "repeat", "frames"):
                    row[name] = int(row[name])
                for name in ("median_ms", "p95_ms"):
                    row[name] = float(row[name])
                    if not 0 <= row[name] < math.inf:
                        raise ValueError(f"{name} cannot be {row[name]}")
                rows.append(row)
    except (ValueError, csv.Error) as error:  # of which a file that is no text is one
        line = getattr(reader, "line_num", 0)
        raise Refused(f"{path}, line {line}: malformed CSV: {error}") from error
    except OSError as error:
        raise Refused(f"cannot read {path}: {error.strerror}") from error
    if not any(row["stage"] == "frame" and row["median_ms"] > 0 for row in rows):
        raise Refused(f"{path} holds no frame times")
    return rows


def read_tables(paths):
    """The experiment they are of, and [(computer, row)]; a computer is (number, renderer, processor)."""
    experiment, sizes, computers, rows = None, {}, {}, []
    for path in {path.resolve(): path for path in paths}.values():  # each once
        for row in read_table(path):
            experiment = experiment or row["experiment"]
            if row["experiment"] != experiment:
                raise Refused(f"{path} is of the experiment '{row['experiment']}', "
                              f"{paths[0]} of '{experiment}'")
            size = f"{row['width']}x{row['height']}"
            expected = sizes.setdefault((row["line"], row["x"]), size)
            if size != expected:
                raise Refused(f"{path} was measured in a window of {size}, "
                              f"{paths[0]} in one of {expected}")
            known = (path, row["renderer"], row["processor"])
            number = computers.setdefault(known, len(computers) + 1)
            rows.append(((number, *known[1:]), row))
    return experiment, rows
