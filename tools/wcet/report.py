# SPDX-License-Identifier: MIT
"""Tables of bounds, and what is wrong with them."""
import csv
import collections

from . import study, timing
from .ipet import MODELS

Limit = collections.namedtuple("Limit", "figure held")
"""How far a bound may be over the worst observed, in instructions: the figure that was
set, and what is held where that is not reached."""


def read_limits(path):
    """function -> Limit."""
    with open(path, encoding="utf-8", newline="") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return {row["function"]: Limit(float(row["figure"]), float(row["held"] or row["figure"]))
                for row in rows}


def title(config):
    return (f"cortex-{config.core} {config.level}, {config.width}x{config.height}, "
            f"{config.cracks} cells")


def faults(config, rows, limits):
    """Everything that makes a run fail."""
    found = []
    for row in rows:
        found += [f"{title(config)}: {fault}" for fault in study.faults(row)]
        limit, ratio = limits.get(row.function), study.ratio(row)
        if limit and ratio is None and not row.refused:
            found.append(f"{title(config)}: {row.function} was never called")
        if limit and ratio is not None and ratio > limit.held:
            found.append(f"{title(config)}: the bound of {row.function} is {ratio:.3f} times the "
                         f"worst observed, over {limit.held:g}; see tools/wcet.py --explain, and "
                         "tests/wcet/worst_*.c")
    return found


def _ratio_text(row, model, limit):
    ratio = study.ratio(row, model)
    if ratio is None:
        return ""
    mark = " (!)" if model == 0 and limit and ratio > limit.figure else ""
    return f"{ratio:.2f}{mark}"


def table(config, rows, limits):
    """Markdown."""
    core = timing.CORES[timing.OF_COMPILER[config.core]].title
    observed = any(row.observed for row in rows)
    lines = [f"At most, {title(config)}; cycles are modelled for {core}, zero wait states:", "",
             "| function | instructions | cycles typ | cycles max |" +
             (" worst observed | ratio | typ | max |" if observed else ""),
             "|---|--:|--:|--:|" + ("--:|--:|--:|--:|" if observed else "")]
    for row in rows:
        cells = [f"`{row.function}`", *(map(str, row.bound) if row.bound else ("refused", "", ""))]
        if observed:
            limit = limits.get(row.function)
            cells += [str(row.observed[0]) if row.observed else "not called",
                      *(_ratio_text(row, model, limit) for model in range(len(MODELS)))]
        lines.append("| " + " | ".join(cells) + " |")
    if any(study.ratio(row) and limits.get(row.function) and
           study.ratio(row) > limits[row.function].figure for row in rows):
        lines += ["", "(!) over the figure that was set for it (tests/wcet/limits.csv)."]
    return "\n".join(lines) + "\n"


CSV_COLUMNS = ["core", "level", "width", "height", "function", "calls",
               *(f"{kind}_{model}" for kind in ("bound", "observed") for model in MODELS), "ratio"]


def csv_rows(tables):
    yield CSV_COLUMNS
    for config, rows, _ in tables:
        for row in rows:
            ratio = study.ratio(row)
            yield [config.core, config.level, config.width, config.height, row.function, row.calls,
                   *(row.bound or ("", "", "")), *(row.observed or ("", "", "")),
                   f"{ratio:.4f}" if ratio else ""]


def readme(sizes, rows):
    """The table of lib/COSTS.md.  sizes: (width, height) of the large and the small image; rows:
    those of M4 with what was observed, of M4 for the small image, and of M0."""
    large, small, tiny = rows
    (width, height), (small_width, small_height) = sizes
    lines = [f"Instructions at most, whatever the input, for {width}x{height} at -O2; observed is the "
             "most that the corpus", "and the adversarial inputs took (`tools/wcet.py`):", "",
             "| function | M4 | observed | M4 / observed | M4 cycles, typ - max | "
             f"M4, {small_width}x{small_height} | M0+ |", "|---|--:|--:|--:|--:|--:|--:|"]
    for row, less, other in zip(large, small, tiny):
        ratio = study.ratio(row)
        lines.append(f"| `{row.function}` | {row.bound[0]} | {row.observed[0]} | {ratio:.2f} | "
                     f"{row.bound[1]} - {row.bound[2]} | {less.bound[0]} | {other.bound[0]} |")
    return "\n".join(lines) + "\n"
