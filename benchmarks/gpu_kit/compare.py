"""Where the model of benchmarks/gpu_machine.py was wrong by more than two: by operation, and by kernel."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from gpu_prediction import Predicted, predict
from gpu_results import newest

from gpu_kit.documents import newest_runs

WRONG = 2.0
SHORT = 5.0  # us; kernels shorter than this are mostly their launch


class Compared(NamedTuple):
    """A figure beside the model's."""

    what: str
    measured: float  # us
    predicted: float

    @property
    def factor(self) -> float:
        """How many times as long as predicted; below 1 where it was quicker."""
        return self.measured / self.predicted if self.predicted else float("inf")

    @property
    def is_wrong(self) -> bool:
        return not 1 / WRONG <= self.factor <= WRONG


def predictions(chip: str) -> dict[str, Predicted]:
    """By "operation size", for a chip."""
    from gpu_chips import chip_named

    return {f"{c['operation']} {c['size']}": predict(c, chip_named(chip)) for c in newest()}


def compared(run: dict[str, Any], predicted: dict[str, Predicted]) -> Iterator[Compared]:
    """Each figure of a run that the model has one for."""
    for key, found in run.get("operations", {}).items():
        model = predicted.get(key)
        if model is None or "error" in found:
            continue
        yield Compared(f"{key}: caller", 1e3 * found["caller_ms"], 1e6 * model.timeline.call)
        if "device_ms" not in found:
            continue
        yield Compared(f"{key}: device", 1e3 * found["device_ms"], 1e6 * model.timeline.device)
        for row in found["kernels"]:
            theirs = model.rows.get(row["kernel"])
            if theirs and max(row["us"], 1e6 * theirs.seconds) > SHORT:
                yield Compared(f"{key}: {row['kernel']}", row["us"], 1e6 * theirs.seconds)


def report() -> str:
    """The table, of the newest run of each chip."""
    lines = []
    for chip, run in newest_runs().items():
        rows = list(compared(run, predictions(chip)))
        wrong = sorted((row for row in rows if row.is_wrong), key=lambda row: -abs(row.measured - row.predicted))
        lines.append(f"{run['device']['name']}: {len(wrong)} of {len(rows)} figures are off by more than {WRONG:g}")
        if wrong:
            lines.append(f"  {'what':58}{'measured us':>12}{'model us':>12}{'factor':>8}")
        lines += [f"  {r.what[:57]:58}{r.measured:12.1f}{r.predicted:12.1f}{r.factor:8.2f}" for r in wrong]
    return "\n".join(lines) or "no run of a GPU is kept"
