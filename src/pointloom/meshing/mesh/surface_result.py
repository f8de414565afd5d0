"""Result of surface reconstruction: `SurfaceResult`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ...core.reports import Assessed, Fields, Report, failed, in_columns, quality, with_warnings
from ...core.units import LengthUnit, symbol_of
from ...core.wording import format_bounds, format_fraction, plain
from .mesh import TriangleMesh
from .mesh_summary import SurfaceSummary
from .reconstruction import FLAT_REMEDY, MAX_OPPOSED_FRACTION

# Thresholds of the quality checks.
MAX_BOUNDARY_FRACTION = 0.1  # fraction of boundary edges: 4% for 30 x 30 squares, 30% if the ball falls through gaps
MAX_NON_MANIFOLD_FRACTION = 0.01  # fraction of non-manifold edges, except of alpha shapes, which are often two-sided
MAX_SMALL_PART_AREA = 0.1  # fraction of the area in small parts. Alpha shapes have cavities, which are parts
MADE_UP = 0.05  # fraction of a Poisson surface far from all points
# Chosen on benchmarks/trust/surface_shapes.py, `CHOOSING`, for surfaces within 2% of the points' extent.
NEAR_DISTANCE = 0.02  # of the points' extent
MAX_MEDIAN_DISTANCE = 0.006  # of the points' extent: limit of their median distance from ball pivoting's surface
# The same of the distance that a tenth of the points exceed. With noise of 1, 1.5, 2, 2.5 and 3% of the extent it is
# 0.014, 0.022, 0.028, 0.034 and 0.04, and 0 of 14, 0 of 12, 1 of 10, 3 of 8 and 10 of 12 surfaces of 800 points and
# more are wrong. Chosen on 594 surfaces of seed 7, 2026-11-29.
MAX_TENTH_DISTANCE = 0.0298
MAX_BOUNDARY_LENGTH = 8.0  # times the points' extent: limit of the boundary length
# Limit of the weighted sum of quantities of `Support`, which predicts the wrong and the missing fraction of the area.
# Alpha shapes: these weights made the smallest number of wrong decisions on 244 wrong and 76 correct ones of seed 7,
# 2026-11-29. Poisson: 2026-11-30, chosen on 432 clouds of `CHOOSING`, 357 scans of `CHOOSING_SCANS` and 150 of other
# draws of `POCKETS`, seed 7. 32 of 419 wrong ones are accepted and 27 of 520 correct ones rejected, with a limit for
# each quantity 54 and 41. Scans of `SCANNED`: 8 of 188 and 3 of 112 (26 and 13), clouds: 24 of 660 and 26 of 340 (14
# and 31). These counts were seen while the rule was chosen. Scans of a new seed: 3 of 38 and 3 of 28 (6 and 3).
MAX_STRAY_AREA = 0.08
STRAY_WEIGHTS = {
    "poisson": {"outer": 1.0, "bent": 0.7, "lost": 1.0, "missed": 0.4},
    "alpha": {"sparse": 1.0, "bent": 0.35, "turned": 0.1, "noise": 0.2},
}
# Fraction of the area of Poisson surfaces. On the same surfaces, 22 wrong ones exceed it, and no correct one. Held out:
# 18 of 188 and 1 of 112.
MAX_ROUGH_AREA = 0.185
MAX_MISSED_POINTS = {"ball": 0.07, "alpha": 0.05}  # fraction of the points that are not near the surface
MAX_TURNED_AREA = 0.05  # fraction of the area of ball pivoting's surface

_LARGER = {"poisson": "a smaller density_quantile or depth", "ball": "larger radii", "alpha": "a larger alpha"}
_REMEDIES = {
    "outer": "use a larger density_quantile",
    "lost": "check the orientation of the normals, or use more points",
}


@dataclass(frozen=True)
class NormalsUsed:
    """Source of the normals in words, True if `given`, and the fraction of disagreeing neighbors (None if unused)."""

    origin: str
    given: bool
    disagreement: float | None

    @property
    def problem(self) -> str | None:
        """Warning about these normals with its remedy, or None."""
        fraction = self.disagreement
        if fraction is None or fraction <= MAX_OPPOSED_FRACTION:
            return None
        statement = f"{format_fraction(fraction)} of neighboring normals point to opposite sides"
        if self.given:
            return f"{statement}; use new_normals, or orient the normals of the input"
        return (
            f"{statement} although they were oriented: the points may not sample a surface; clean or smooth them first"
        )


@dataclass(frozen=True)
class MadeUp:
    """Fraction of the area farther than `far` [m] from all points; `density_quantile` that removes it, or None."""

    fraction: float | None = None
    far: float | None = None
    better_quantile: float | None = None

    def to_dict(self) -> dict[str, float | None]:
        return {"made_up": self.fraction, "far": self.far, "better_quantile": self.better_quantile}


@dataclass(frozen=True)
class PointsOff:
    """Distances of the points from the surface [m] (None without one), diagonal of their box [m], and unit.

    Half of the points are farther than `median`, a tenth than `tenth`.
    """

    median: float | None = None
    size: float = 0.0
    unit: LengthUnit | None = None
    tenth: float = 0.0

    def problem(self, method: str) -> str | None:
        """Warning if the surface does not fit the points, or None."""
        if self.median is None or method == "alpha":  # `Support.missed` and `noise` decide for alpha shapes
            return None
        part, distance, limit = "half", self.median, MAX_MEDIAN_DISTANCE
        if method == "poisson":
            part, distance, limit = "a tenth", self.tenth, MAX_TENTH_DISTANCE
        if distance <= limit * self.size:
            return None
        fraction, shown = format_fraction(distance / self.size), f"{distance:.3g} {symbol_of(self.unit)}"
        return (
            f"{part} of the points are farther than {shown} from the surface ({fraction} of their extent): the points "
            "are noisy, or the surface misses many of them; clean or smooth them first, or choose other settings"
        )


@dataclass(frozen=True)
class Support:
    """Agreement of a surface with the points near it. "Near" is a distance of 2% of the points' extent.

    Attributes:
        near: This distance [m].
        sparse: Fraction of the area that is neither near a point nor within 0.6 of the local point spacing.
        bent: Fraction of the area that is not near the tangent plane of the nearest point.
        turned: Fraction of the area that is inclined by more than 53 degrees to this plane.
        missed: Fraction of the points that are not near the surface, nor within the noise of a Poisson surface or an
            alpha shape. A point of an alpha shape has the weight of its squared distance to the 10th neighbor.
        outer: Fraction of the area that is not near a point, and whose nearest points are all on one side of it.
        noise: Median distance of the points from the planes through their 10 neighbors, relative to the farthest.
        lost: Fraction of the points that are not near the surface, and whose 10 neighbors have a mean that is neither
            near it nor within the noise of a Poisson surface. They have the weights of `missed` of an alpha shape, and
            isolated points do not count.
        rough: Fraction of the area that is inclined by more than 53 degrees to the plane through the 100 nearest
            points. 0 for less than 2,000 points.
    """

    near: float = 0.0
    sparse: float = 0.0
    bent: float = 0.0
    turned: float = 0.0
    missed: float = 0.0
    outer: float = 0.0
    noise: float = 0.0
    lost: float = 0.0
    rough: float = 0.0

    def stray(self, method: str) -> float:
        """Predictor of the wrong and missing fraction of the area of a Poisson surface or an alpha shape."""
        return sum(weight * getattr(self, name) for name, weight in STRAY_WEIGHTS[method].items())

    @property
    def largest_stray(self) -> str:
        """Name of the quantity that contributes most to `stray` of a Poisson surface."""
        weights = STRAY_WEIGHTS["poisson"]
        return max(weights, key=lambda name: weights[name] * getattr(self, name))

    def problem(self, method: str, unit: LengthUnit | None, better_quantile: float | None) -> str | None:
        """Warning if the points are too sparse for their shape, or None."""
        near = f"{self.near:.3g} {symbol_of(unit)}"
        remedy = "the points are too sparse or too noisy for the shape; use more points, or smooth them first"
        sparse, bent, turned, missed, outer, lost, rough = (
            format_fraction(getattr(self, name))
            for name in ("sparse", "bent", "turned", "missed", "outer", "lost", "rough")
        )
        if method == "ball" and self.turned > MAX_TURNED_AREA:
            return f"{turned} of the area is inclined by more than 53 degrees to the points near it: {remedy}"
        if method == "alpha" and self.stray(method) > MAX_STRAY_AREA:
            return (
                f"{sparse} of the area has no point within {near}, and {bent} is farther than that from the planes of "
                f"the points near it: {remedy}"
            )
        if method == "poisson" and self.stray(method) > MAX_STRAY_AREA:
            remedy = _REMEDIES.get(self.largest_stray, remedy)
            remedy = f"use density_quantile {better_quantile:g}" if better_quantile else remedy
            return (
                f"{outer} of the area continues beyond the border of the points, {bent} is farther than {near} from "
                f"the planes of the points near it, {missed} of the points are farther than that from the surface, "
                f"and {lost} of the points are in parts without a surface: {remedy}"
            )
        if method == "poisson" and self.rough > MAX_ROUGH_AREA:
            return (
                f"{rough} of the area is inclined by more than 53 degrees to the planes of the points around it: the "
                "surface follows the noise; use a smaller depth, or smooth the points first"
            )
        if method != "poisson" and self.missed > MAX_MISSED_POINTS[method]:
            remedy = f"use {_LARGER[method]}, or more points"
            return f"{missed} of the points are farther than {near} from the surface; {remedy}"
        return None


@dataclass(frozen=True, eq=False)
class SurfaceResult(Report, Assessed):
    """A reconstructed surface with statistics.

    Attributes:
        mesh: The surface. Empty if there is none.
        method, settings: "poisson", "ball" or "alpha", and its settings.
        normals: Normals used, and their disagreement.
        points_in, points: Points of the cloud, and finite ones.
        not_carried: Attributes of the cloud that the mesh lacks.
        summary: Statistics of the surface.
        made_up: Fraction of a Poisson surface far from all points.
        off: Distance of the points from the surface.
        support: Agreement of the surface with the points near it.
        flat: Reason why no alpha shape exists. None if one does.
        reliable, warnings: True if all quality checks passed, and those that failed.
    """

    mesh: TriangleMesh
    method: str
    settings: dict[str, Any]
    normals: NormalsUsed
    points_in: int
    points: int
    not_carried: tuple[str, ...]
    summary: SurfaceSummary
    made_up: MadeUp
    off: PointsOff = PointsOff()
    support: Support = Support()
    flat: str | None = None

    def __str__(self) -> str:
        return in_columns(with_warnings(self.fields(), self))

    @property
    def warnings(self) -> tuple[str, ...]:
        empty = self._why_empty()
        surface = [empty] if empty else self._surface_problems()
        support = self.support.problem(self.method, self.mesh.unit, self.made_up.better_quantile)
        return failed(self.normals.problem, *surface, self.off.problem(self.method), support)

    def to_dict(self) -> dict[str, Any]:
        normals = {"normals": self.normals.origin, "disagreement": self.normals.disagreement}
        counts = {"points_in": self.points_in, "points": self.points, "not_carried": [*self.not_carried]}
        head = {"device": str(self.mesh.device), "method": self.method, **self.settings}
        figures = self.summary.to_dict() | self.made_up.to_dict() | {"points_off": self.off.median}
        figures |= vars(self.support)
        return plain(head | normals | counts | figures | quality(self))

    def fields(self) -> Fields:
        settings = ", ".join(f"{name.replace('_', ' ')} {_shown(value)}" for name, value in self.settings.items())
        lost, normals, summary = self.points_in - self.points, self.normals.origin, self.summary
        if self.normals.disagreement is not None:
            normals += f"; {format_fraction(self.normals.disagreement)} of neighbors opposite"
        edges = f"{summary.boundary_edges:,} of {summary.edges:,} at the boundary"
        if summary.crowded_edges:
            edges += f", {summary.crowded_edges:,} with three or more triangles"
        parts = f"{summary.parts:,}"
        if summary.parts > 1:
            parts += f", the largest {format_fraction(summary.largest_fraction)} of the area"
        made_up, lacking = self.made_up.fraction, ", ".join(self.not_carried)
        area = f"{summary.area:.4g} {symbol_of(self.mesh.unit)}^2"
        return [
            ("method", f"{self.method}, {settings}"),
            ("points", f"{self.points:,}" + (f", {lost:,} non-finite ignored" if lost else "")),
            ("normals", normals),
            ("mesh", f"{summary.vertices:,} vertices, {summary.triangles:,} triangles, {area}"),
            ("parts", parts),
            ("edges", edges),
            *([("extrapolated", f"{format_fraction(made_up)} of the area")] if made_up else []),
            ("closed", "yes" if summary.watertight else "no"),
            ("bounds", format_bounds(summary.to_dict()["bounds"])),
            *([("not carried", f"{lacking} of the points")] if lacking else []),
        ]

    def _why_empty(self) -> str | None:
        if not self.points:
            return "no point is finite, so there is no surface"
        if self.flat is not None and not self.summary.triangles:
            return f"the mesh is empty: {self.flat}, so no alpha gives a surface; {FLAT_REMEDY} (method='ball')"
        if not self.summary.triangles:
            return f"the mesh is empty; use {_LARGER[self.method]}"
        return None

    def _surface_problems(self) -> list[str]:
        """Warnings if the mesh is torn, far from the points or fragmented."""
        summary, larger = self.summary, _LARGER[self.method]
        reasons: list[str] = []
        if summary.boundary_edges > MAX_BOUNDARY_FRACTION * summary.edges:
            fraction = format_fraction(summary.boundary_edges / summary.edges)
            reasons.append(f"the mesh has many holes: {fraction} of its edges are boundary edges; use {larger}")
        elif summary.boundary_length > MAX_BOUNDARY_LENGTH * self.off.size > 0:
            times = summary.boundary_length / self.off.size
            reasons.append(
                f"the mesh has many holes: its boundary is {times:.1f} times as long as its size; use {larger}"
            )
        if self.method != "alpha" and summary.crowded_edges > MAX_NON_MANIFOLD_FRACTION * summary.edges:
            fraction = format_fraction(summary.crowded_edges / summary.edges)
            reasons.append(f"{fraction} of its edges have three or more triangles, so it is not a single surface")
        made_up, far, better = self.made_up.fraction, self.made_up.far, self.made_up.better_quantile
        if made_up is not None and made_up > MADE_UP:
            remedy = f"density_quantile {better:g}" if better else "a larger density_quantile"
            away = f"{far:.3g} {symbol_of(self.mesh.unit)}"
            reasons.append(
                f"{format_fraction(made_up)} of the area is farther than {away} from all points "
                f"and was extrapolated to close the surface; use {remedy}"
            )
        if self.method != "alpha" and summary.islands_fraction > MAX_SMALL_PART_AREA:
            fraction = format_fraction(summary.islands_fraction)
            reasons.append(f"{fraction} of the area is in small islands: clean the cloud first, or use {larger}")
        return reasons


def _shown(value: object) -> str:
    if value is None:
        return "derived from the point spacing"
    return " ".join(f"{part:g}" for part in value) if isinstance(value, list | tuple) else str(value)
