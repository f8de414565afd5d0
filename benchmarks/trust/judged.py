"""Compare the reliability of results with the ground truth: counts, and rates with an interval."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

Z = 1.959963984540054  # of a normal distribution: 95 % are within
NO_CONSTANT = ", scenes that chose no constant"


@dataclass(frozen=True)
class Judged:
    """One case.

    Attributes:
        area: The kind of result, a row of docs/trust.md: "focal length", "LiDAR odometry", "RGB-D tracking", ...
        case: A short description of the input.
        count: Number of results: 1, or the frames or scans of a run.
        wrong: Number of wrong results according to the ground truth.
        wrong_believed: Number of wrong results that were accepted.
        right_refused: Number of correct results that were rejected.
        said: The warnings, joined; empty if there are none.
        error: The decisive error with its unit, such as "0.03 % of the centers".
        peer: The same for the best baseline on the same input, such as "KISS-ICP: 39.0 m"; empty if none was run.
        held_out: True if no constant was chosen on the case.
    """

    area: str
    case: str
    count: int
    wrong: int
    wrong_believed: int
    right_refused: int
    said: str = ""
    error: str = ""
    peer: str = ""
    held_out: bool = True


@dataclass(frozen=True)
class Case:
    """A case that has not run: its name, unique in its area, and the function that judges it."""

    name: str
    judge: Callable[[], Iterable[Judged]]


def interval(hits: int, count: int) -> tuple[float, float]:
    """The 95 % confidence interval of a rate (Wilson 1927); 0 to 1 for a count of zero."""
    if count == 0:
        return 0.0, 1.0
    fraction, spread = hits / count, Z * Z / count
    middle = (fraction + spread / 2) / (1 + spread)
    half = Z / (1 + spread) * math.sqrt(fraction * (1 - fraction) / count + spread / (4 * count))
    return max(middle - half, 0.0), min(middle + half, 1.0)


def share_in_words(hits: int, count: int) -> str:
    """Hits of a count with their confidence interval: `3 of 120 (0.9 to 7.1 %)`.

    Example:
        >>> share_in_words(3, 120)
        '3 of 120 (0.9 to 7.1 %)'
    """
    if not count:
        return "-"
    low, high = interval(hits, count)
    return f"{hits:,} of {count:,} ({100 * low:.1f} to {100 * high:.1f} %)"


def rates(cases: Iterable[Judged]) -> list[str]:
    """Rows of Markdown: for each area, the rates of unreliable results accepted and reliable results rejected."""
    chosen = list(cases)
    lines = ["| result | unreliable results accepted | reliable results rejected |", "|---|---|---|"]
    for area in dict.fromkeys(case.area for case in chosen):
        lines.append(_rate(area, [case for case in chosen if case.area == area]))
        held_out = [case for case in chosen if case.area == area and case.held_out]
        if held_out and len(held_out) < len([case for case in chosen if case.area == area]):
            lines.append(_rate(area + NO_CONSTANT, held_out))
    return lines


def _rate(name: str, cases: Sequence[Judged]) -> str:
    wrong = sum(case.wrong for case in cases)
    right = sum(case.count - case.wrong for case in cases)
    accepted = share_in_words(sum(case.wrong_believed for case in cases), wrong)
    rejected = share_in_words(sum(case.right_refused for case in cases), right)
    return f"| {name} | {accepted} | {rejected} |"


MAX_CHARACTERS = 120  # characters of the warnings in a table


def table(cases: Iterable[Judged]) -> list[str]:
    """Rows of Markdown: case by case."""
    lines = [
        "| result | case | count | unreliable | of these accepted | reliable, rejected | error | baseline | warnings |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for c in cases:
        counts = (int(c.count), int(c.wrong), int(c.wrong_believed), int(c.right_refused))
        cells = (c.area, c.case, *counts, c.error, c.peer, c.said[:MAX_CHARACTERS].replace("|", "/"))
        lines.append("| " + " | ".join(str(cell) for cell in cells) + " |")
    return lines
