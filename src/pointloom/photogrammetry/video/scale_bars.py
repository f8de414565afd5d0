"""Known lengths between marked points: residuals, outliers, and the scale of the model."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ...core.reports import failed
from ...registration.rigid import scale_of
from .control_blunders import OUTLIER_DEVIATIONS
from .control_report import CHECK, CONTROL, UNUSED, BarResidual
from .ground_control import GroundControl, ScaleBar
from .marked_points import MarkedPoint

Array = NDArray[np.float64]

MAX_INLIER_ERROR = 0.01  # relative error that is never an outlier
MIN_TO_IDENTIFY = 3  # minimum bars to identify a wrong one


@dataclass(frozen=True, eq=False)
class Bars:
    """Scale bars with triangulated ends (None if missing), and masks of check bars and outliers."""

    bars: tuple[ScaleBar, ...]
    ends: tuple[tuple[MarkedPoint, MarkedPoint] | None, ...]
    checks: tuple[bool, ...]
    wrong: tuple[bool, ...]
    reasons: tuple[str, ...]

    @classmethod
    def of(cls, control: GroundControl, located: dict[str, MarkedPoint]) -> Bars:
        pairs = [(located[bar.a], located[bar.b]) for bar in control.bars]
        reasons = ["; ".join(f"{p.name}: {p.reason}" for p in pair if p.position is None) for pair in pairs]
        ends = tuple(None if reason else pair for pair, reason in zip(pairs, reasons, strict=True))
        checks = tuple(bar.a in control.checks or bar.b in control.checks for bar in control.bars)
        return cls(control.bars, ends, checks, (False,) * len(ends), tuple(reasons))

    @property
    def used(self) -> list[int]:
        rows = zip(self.ends, self.checks, self.wrong, strict=True)
        return [k for k, (ends, check, wrong) in enumerate(rows) if ends is not None and not check and not wrong]

    @property
    def any(self) -> bool:
        return bool(self.used)

    def length(self, k: int) -> float:
        pair = self.ends[k]
        if pair is None or pair[0].position is None or pair[1].position is None:
            return math.nan
        return float(np.linalg.norm(pair[1].position - pair[0].position))

    def sigma(self, k: int, T: Array) -> float:
        pair = self.ends[k]
        if pair is None or pair[0].position is None or pair[1].position is None:
            return math.nan
        along = (pair[1].position - pair[0].position) / self.length(k)
        scale = scale_of(T)
        of_marks = scale**2 * float(along @ (pair[0].covariance + pair[1].covariance) @ along)
        return math.sqrt(self.bars[k].sigma ** 2 + of_marks)

    def rows(self, T: Array) -> Array:
        return np.array([[self.length(k), self.bars[k].meters, self.sigma(k, T)] for k in self.used]).reshape(-1, 3)

    def agreeing(self, T: Array) -> Bars:
        far = tuple(k in self.used and self._is_far(k, T) for k in range(len(self.bars)))
        return replace(self, wrong=tuple(a or b for a, b in zip(self.wrong, far, strict=True)))

    def residuals(self, T: Array) -> tuple[BarResidual, ...]:
        scale = scale_of(T)
        rows = []
        for k, bar in enumerate(self.bars):
            use = CHECK if self.checks[k] else UNUSED if self.wrong[k] else CONTROL
            warning = self.reasons[k] or "contradicts the others" * self.wrong[k]
            use = UNUSED if self.reasons[k] else use
            if use == CHECK and self._is_far(k, T):
                warning = "contradicts the model"
            rows.append(BarResidual(bar, scale * self.length(k), self.sigma(k, T), use, failed(warning)))
        return tuple(rows)

    def problem(self, T: Array) -> str:
        if wrong := [k for k, is_wrong in enumerate(self.wrong) if is_wrong]:
            what = self._details(wrong, T)
            return f"scale bars contradict the others and were excluded, {what}: check their lengths and marks"
        if off := [k for k in self.used if self._is_far(k, T)]:
            return f"scale bars contradict each other, {self._details(off, T)}: check their lengths and marks"
        return ""

    def problem_of_checks(self, T: Array) -> str:
        """Warning about bars of check points, which the fit does not use."""
        checks = [k for k, ends in enumerate(self.ends) if ends is not None and self.checks[k]]
        if off := [k for k in checks if self._is_far(k, T)]:
            return f"scale bars of check points contradict the model, {self._details(off, T)}: check lengths and marks"
        return ""

    def _details(self, rows: list[int], T: Array) -> str:
        scale = scale_of(T)
        return ", ".join(
            f"{self.bars[k]} is {scale * self.length(k):.4g} m, given as {self.bars[k].meters:g} m" for k in rows
        )

    def _is_far(self, k: int, T: Array) -> bool:
        scale = scale_of(T)
        gap = abs(scale * self.length(k) - self.bars[k].meters)
        return gap > max(OUTLIER_DEVIATIONS * self.sigma(k, T), MAX_INLIER_ERROR * self.bars[k].meters)


def fit_bars(bars: Bars) -> tuple[Array, float, Bars]:
    """The scale as a similarity, its relative standard deviation, and the inlier bars."""
    scales = [bars.bars[k].meters / bars.length(k) for k in bars.used]
    T = _scaled(float(np.median(scales)))
    if len(scales) >= MIN_TO_IDENTIFY:
        agree = bars.agreeing(T)
        bars = agree if 2 * len(agree.used) > len(scales) else bars
    lengths, meters, sigma = bars.rows(T).T
    T = _scaled(float((lengths * meters / sigma**2).sum() / (lengths**2 / sigma**2).sum()))
    lengths, meters, sigma = bars.rows(T).T
    return T, 1 / math.sqrt(float(((T[0, 0] * lengths / sigma) ** 2).sum())), bars


def _scaled(scale: float) -> Array:
    return np.diag([scale, scale, scale, 1.0])
