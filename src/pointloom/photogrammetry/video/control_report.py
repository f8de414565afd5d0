"""Residuals of ground control and scale bars, and the uncertainty of the similarity."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.escaped_text import escaped
from ...core.reports import Assessed, quality
from ...pcd.geodesy import WorldFrame
from .georeference import frame_to_dict
from .ground_control import ScaleBar

Array = NDArray[np.float64]

CONTROL, CHECK, UNUSED = "control", "check", "unused"


@dataclass(frozen=True, eq=False)
class ControlResidual(Assessed):
    """Residual of a ground control point.

    Attributes:
        name: Point name.
        use: "control", "check", or "unused".
        residual: Estimated minus known position, shape [3] [m], east, north and up. None if not triangulated.
        sigma: Its expected standard deviation, shape [3] [m].
        pixels: Root mean square reprojection error of its marks [px]. NaN if not triangulated.
        views: Images whose marks are used.
        warnings: Why it or some marks are unused, or how far a check point is off.
        contradicts: True if it is off by more than 5 standard deviations, so that the fit is unreliable.
    """

    name: str
    use: str
    residual: Array | None
    sigma: Array | None
    pixels: float
    views: int
    warnings: tuple[str, ...] = ()
    contradicts: bool = False

    def to_dict(self) -> dict[str, Any]:
        return {
            "name": self.name,
            "use": self.use,
            "residual_m": None if self.residual is None else self.residual.round(6).tolist(),
            "sigma_m": None if self.sigma is None else self.sigma.round(6).tolist(),
            "rms_px": number_or_none(self.pixels),
            "views": self.views,
            **quality(self),
        }

    def __str__(self) -> str:
        if self.residual is None:
            return escaped(f"{self.name}: {self.use}, {'; '.join(self.warnings)}")
        gap = " ".join(f"{value:+.3f}" for value in self.residual)
        more = "".join(f"; {warning}" for warning in self.warnings)
        return escaped(f"{self.name}: {self.use}, {gap} m, {self.pixels:.2f} px in {self.views} images{more}")


@dataclass(frozen=True, eq=False)
class BarResidual(Assessed):
    """Residual of a scale bar.

    Attributes:
        bar: The bar.
        estimated: Estimated length [m]. NaN if an end is not triangulated.
        sigma: Standard deviation of estimated minus known length [m].
        use: "control", "check", or "unused".
        warnings: Why it is unused, or how it contradicts the model.
    """

    bar: ScaleBar
    estimated: float
    sigma: float
    use: str
    warnings: tuple[str, ...] = ()

    @property
    def error(self) -> float:
        return self.estimated - self.bar.meters

    def to_dict(self) -> dict[str, Any]:
        return {
            "a": self.bar.a,
            "b": self.bar.b,
            "meters": self.bar.meters,
            "found_m": number_or_none(self.estimated),
            "error_m": number_or_none(self.error),
            "sigma_m": number_or_none(self.sigma),
            "use": self.use,
            **quality(self),
        }

    def __str__(self) -> str:
        more = "".join(f"; {warning}" for warning in self.warnings)
        off = f", {1000 * self.error:+.1f} mm" if math.isfinite(self.estimated) else ""
        return escaped(f"{self.bar}: {self.use}, {self.bar.meters:g} m{off}{more}")


@dataclass(frozen=True, eq=False)
class GpsGaps:
    """Residuals of image positions (GPS) against ground control: east, north, up, [n, 3] [m]. NaN without altitude."""

    names: tuple[str, ...]
    residuals: Array

    @property
    def shift(self) -> Array:
        """Median along each axis [m]. NaN for height without altitudes."""
        columns = self.residuals.T
        return np.array([np.nanmedian(each) if np.isfinite(each).any() else np.nan for each in columns])

    @property
    def horizontal_rms(self) -> float:
        return math.sqrt(float((self.residuals[:, :2] ** 2).sum(axis=1).mean()))

    def to_dict(self) -> dict[str, Any]:
        rows = [[number_or_none(round(value, 4)) for value in row] for row in self.residuals.tolist()]
        return {
            "places": len(self.names),
            "horizontal_rms_m": self.horizontal_rms,
            "shift_m": [number_or_none(round(value, 4)) for value in self.shift.tolist()],
            "residuals_m": dict(zip(self.names, rows, strict=True)),
        }

    def __str__(self) -> str:
        shift = " ".join("?" if math.isnan(value) else f"{value:+.2f}" for value in self.shift)
        plan = f"{self.horizontal_rms:.3g} m off in plan (rms), {shift} m (median)"
        return f"GPS of {len(self.names)} images, not used: {plan}"


@dataclass(frozen=True, eq=False)
class ControlFit(Assessed):
    """Agreement with ground control.

    Attributes:
        frame: Geographic frame, meters about the median point. None without a coordinate system.
        crs: Coordinate system of the points as given, or "".
        origin: Offset of coordinates without a system, shape [3] [m], or zeros if small.
        T_world_model: Similarity, float64 [4, 4].
        scale: Meters per model unit.
        scale_sigma: Relative standard deviation of the scale.
        tilt_sigma, yaw_sigma: Standard deviations of up and north [degrees]. NaN with lengths only.
        residual_ratio: Ratio of actual to expected control residuals. NaN with lengths only.
        points, bars: The residuals.
        is_georeferenced: True if the frame is that of the points. With lengths only it is the model's.
        gps: Residuals of the unused image positions.
        warnings: Failed quality checks, each with its remedy. Empty if the fit is reliable.
        notes: Remarks.
    """

    frame: WorldFrame | None
    crs: str
    origin: Array
    T_world_model: Array
    scale: float
    scale_sigma: float
    tilt_sigma: float
    yaw_sigma: float
    residual_ratio: float
    points: tuple[ControlResidual, ...]
    bars: tuple[BarResidual, ...]
    is_georeferenced: bool
    gps: GpsGaps | None = None
    warnings: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()

    def rms(self, use: str) -> float:
        """Root mean square residual of "control" or "check" points [m]. NaN without any."""
        return rms_of([point.residual for point in self.points if point.use == use])

    def to_dict(self) -> dict[str, Any]:
        where = {} if self.frame is None else frame_to_dict(self.frame)
        return where | {
            "crs": self.crs,
            "local_origin_m": self.origin.tolist(),
            "control_rms_m": number_or_none(self.rms(CONTROL)),
            "check_rms_m": number_or_none(self.rms(CHECK)),
            "misfit": number_or_none(self.residual_ratio),
            "scale_sigma": self.scale_sigma,
            "tilt_sigma_degrees": number_or_none(self.tilt_sigma),
            "yaw_sigma_degrees": number_or_none(self.yaw_sigma),
            "points": [point.to_dict() for point in self.points],
            "bars": [bar.to_dict() for bar in self.bars],
            "gps": None if self.gps is None else self.gps.to_dict(),
            **quality(self),
        }

    def __str__(self) -> str:
        return escaped("\n".join(self._lines()), lines=True)

    def _lines(self) -> list[str]:
        counts = [
            f"{count} {what} point{'s' * (count != 1)}, {self.rms(use):.3g} m off (rms)"
            for use, what in ((CONTROL, "control"), (CHECK, "check"))
            if (count := sum(point.use == use for point in self.points))
        ]
        if bars := sum(bar.use == CONTROL for bar in self.bars):
            counts.append(f"{bars} scale bar{'s' * (bars != 1)}")
        sure = f"size to {100 * self.scale_sigma:.2g} %"
        sure += f", up to {self.tilt_sigma:.2g} degrees, north to {self.yaw_sigma:.2g}" if self.is_georeferenced else ""
        lines = [f"meters by {', '.join(counts)}; {sure}"]
        lines += [f"  {row}" for row in (*self.points, *self.bars)]
        if self.gps is not None:
            lines.append(str(self.gps))
        lines += self.notes
        if self.frame is not None:
            lines.append(f"{self.frame}" + (f"; points in {self.crs}" if self.crs != f"EPSG:{self.frame.epsg}" else ""))
        elif self.is_georeferenced:
            lines.append(
                "in the points' own coordinates" + (f" less {self.origin.tolist()}" if self.origin.any() else "")
            )
        return lines


def rms_of(gaps: Sequence[Array | None]) -> float:
    known = [gap for gap in gaps if gap is not None]
    return math.sqrt(float(np.mean([gap @ gap for gap in known]))) if known else math.nan


def number_or_none(value: float) -> float | None:
    return value if math.isfinite(value) else None
