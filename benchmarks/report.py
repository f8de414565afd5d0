"""Results of a run: rounds of all laps joined, ratios to baselines, targets, one table and one JSON document."""

from __future__ import annotations

import statistics
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from contest import POINTLOOM
from targets import TARGETS


@dataclass
class Timing:
    """Times of one contestant at one operation and size.

    Attributes:
        seconds: Of each round, per unit; without the first call, unless it is the only one.
        units: Units per call.
        first_call: [s] of the first call with all its units; pointloom compiles or loads its kernels in it.
        memory: Peak [B]; None if not measured.
    """

    seconds: list[float] = field(default_factory=list)
    units: int = 1
    first_call: float = 0.0
    memory: int | None = None

    @property
    def best(self) -> float:
        """The fastest round, since other load only adds time."""
        return min(self.seconds)

    @property
    def median(self) -> float:
        """The median round."""
        return statistics.median(self.seconds)

    @property
    def compile(self) -> float:
        """Excess of the first call over a usual one [s]: compiling or loading kernels, starting threads."""
        return max(0.0, self.first_call - self.units * self.median)


@dataclass
class Row:
    """One operation at one size."""

    operation: str
    size: str
    timings: dict[str, Timing] = field(default_factory=dict)

    @property
    def best_peer(self) -> str | None:
        """The fastest baseline."""
        peers = [label for label in self.timings if label != POINTLOOM]
        return min(peers, key=lambda label: self.timings[label].best, default=None)

    def ratio(self, peers: Iterable[str]) -> float | None:
        """The best time of these baselines divided by pointloom's."""
        times = [self.timings[peer].best for peer in peers if peer in self.timings]
        return min(times) / self.timings[POINTLOOM].best if times and POINTLOOM in self.timings else None

    @property
    def target(self) -> float | None:
        """The required ratio to the best baseline; None if there is none."""
        return TARGETS.get((self.operation, self.size))

    def target_text(self) -> str:
        """The target and whether it was reached."""
        if self.target is None:
            return ""
        ratio = self.ratio([self.best_peer]) if self.best_peer else None
        result = "not run" if ratio is None else "met" if ratio >= self.target else "MISSED"
        return f"{self.target:g}x: {result}"


def collect(documents: Iterable[dict[str, Any]]) -> dict[tuple[str, str], Row]:
    """Rows from the JSON of pytest-benchmark, with the rounds of all laps of a contestant joined."""
    rows: dict[tuple[str, str], Row] = {}
    for document in documents:
        for entry in document["benchmarks"]:
            info = entry["extra_info"]
            if not info:  # the result disagreed
                continue
            key = (info["operation"], info["size"])
            row = rows.setdefault(key, Row(*key))
            timing = row.timings.setdefault(info["label"], Timing(units=info["units"]))
            seconds = entry["stats"]["data"]
            if info["lap"] == 0:
                timing.first_call = seconds[0]
            else:
                timing.seconds += [value / timing.units for value in seconds]
    for timing in (timing for row in rows.values() for timing in row.timings.values()):
        timing.seconds = timing.seconds or [timing.first_call / timing.units]
    return {key: row for key, row in rows.items() if "pointloom" in row.timings}  # it may lack a package, such as torch


HEADINGS = ("operation", "size", "contestant", "min ms", "median ms", "compile ms", "peak MB", "ratio", "target")


def table(rows: Iterable[Row], *, with_targets: bool) -> str:
    """The table as text: pointloom first in each block, then the baselines; the ratio is a baseline's minimum over
    pointloom's.
    """
    lines: list[tuple[str, ...]] = [HEADINGS]
    for row in rows:
        for k, (label, timing) in enumerate(row.timings.items()):
            name, size = (row.operation, row.size) if k == 0 else ("", "")
            memory = "-" if timing.memory is None else f"{timing.memory / 1e6:.0f}"
            ratio = "" if label == POINTLOOM else row.ratio([label])
            cells = [f"{1000 * timing.best:.2f}", f"{1000 * timing.median:.2f}"]
            cells.append(f"{1000 * timing.compile:.0f}" if label == POINTLOOM else "")
            mark = " best" if label == row.best_peer and len(row.timings) > 2 else ""
            shown = f"{ratio:.2f}{mark}" if isinstance(ratio, float) else "-"
            lines.append(
                (name, size, label, *cells, memory, shown, row.target_text() if with_targets and k == 0 else "")
            )
    widths = [max(len(line[k]) for line in lines) for k in range(len(HEADINGS))]
    numbers = range(3, 7)
    texts_of_lines = []
    for line in lines:
        cells = [c.rjust(w) if k in numbers else c.ljust(w) for k, (c, w) in enumerate(zip(line, widths, strict=True))]
        texts_of_lines.append("  ".join(cells).rstrip())
    texts_of_lines.insert(1, "  ".join("-" * width for width in widths))
    return "\n".join(texts_of_lines)


def document(rows: Iterable[Row], about: dict[str, Any], problems: dict[str, list[str]], *, with_targets: bool) -> dict:
    """The JSON document of a run."""
    rows = list(rows)
    return {"schema": 1, **about, "results": [_result(row, with_targets) for row in rows], "problems": problems}


def _result(row: Row, with_targets: bool) -> dict[str, Any]:
    contestants = {}
    for label, timing in row.timings.items():
        contestants[label] = {
            "min_s": timing.best,
            "median_s": timing.median,
            "rounds": len(timing.seconds),
            "peak_memory_bytes": timing.memory,
        }
    result: dict[str, Any] = {"operation": row.operation, "size": row.size, "contestants": contestants}
    if POINTLOOM in row.timings:
        result["compile_s"] = row.timings[POINTLOOM].compile
    if row.best_peer is not None:
        result |= {"best_peer": row.best_peer, "ratio": row.ratio([row.best_peer])}
    if with_targets:
        result["target"] = row.target
    return result
