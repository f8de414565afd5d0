"""Comparison of two surfaces: `compare_meshes`."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from ...core.checks import check_count, check_numeric, check_positive, check_seed
from ...core.reports import Assessed, Fields, Report, quality
from ...core.units import LengthUnit, symbol_of
from ...core.wording import format_fraction, plain
from .mesh import TriangleMesh
from .mesh_arrays import check_mesh
from .mesh_checks import check_finite_corners
from .metrics import SurfaceMetrics

F_SCORE_DISTANCE = 0.01  # of the second mesh's diagonal: default distance of the F-score
MAX_MEAN_DISTANCE = 0.05  # of the diagonal: a larger mean distance suggests another unit or frame


@dataclass(frozen=True, eq=False)
class MeshComparison(Report, Assessed):
    """Distances between two surfaces.

    Attributes:
        metrics: As of `TriangleMesh.compute_metrics`.
        thresholds: Distances of its F-scores [m].
        triangles: Counts of both meshes.
        diagonal: Of the second mesh's box [m].
        samples, seed: Points sampled from each mesh, and their seed.
        limit: Allowed Hausdorff distance [m], or None.
        device: Of the computation.
        unit: Unit of lengths if known.
        reliable, warnings: True if all checks passed, and those that failed.
    """

    metrics: SurfaceMetrics
    thresholds: tuple[float, ...]
    triangles: tuple[int, int]
    diagonal: float
    samples: int
    seed: int
    limit: float | None
    device: str
    unit: LengthUnit | None = None

    @property
    def warnings(self) -> tuple[str, ...]:
        mean, m = max(self.metrics.mean), symbol_of(self.unit)
        if mean > MAX_MEAN_DISTANCE * self.diagonal:
            fraction = format_fraction(mean / self.diagonal)
            return (
                f"the surfaces are {fraction} of their size apart. Check units and frames, and register them first",
            )
        if self.limit is not None and self.metrics.hausdorff > self.limit:
            return (f"the surfaces are up to {self.metrics.hausdorff:.4g} {m} apart, more than {self.limit:g} {m}",)
        return ()

    def to_dict(self) -> dict[str, Any]:
        """All fields in JSON's types. F-scores by their distances."""
        metrics = self.metrics
        scores = dict(zip(map(str, self.thresholds), metrics.fscore.tolist(), strict=True))
        head = {"triangles": self.triangles, "diagonal": self.diagonal, "chamfer": metrics.chamfer}
        farthest = {"hausdorff": metrics.hausdorff, "hausdorff_bound": metrics.hausdorff_bound, "fscore": scores}
        both_ways = {"mean": metrics.mean, "rms": metrics.rms, "max": metrics.max}
        tail = {"samples": self.samples, "seed": self.seed, "device": self.device, **quality(self)}
        unit = {} if self.unit is None else {"unit": self.unit}
        return plain(head | farthest | both_ways | tail | unit)

    def fields(self) -> Fields:
        metrics, m = self.metrics, symbol_of(self.unit)
        scores = zip(self.thresholds, metrics.fscore.tolist(), strict=True)
        return [
            ("triangles", " and ".join(f"{count:,}" for count in self.triangles)),
            ("chamfer", f"{metrics.chamfer:.4g} {m}"),
            ("mean", _there_and_back(metrics.mean, m)),
            ("rms", _there_and_back(metrics.rms, m)),
            ("Hausdorff", f"{metrics.hausdorff:.4g} {m}, at most {metrics.hausdorff_bound:.4g}"),
            ("F-score", ", ".join(f"{score:.1f} % within {radius:.3g} {m}" for radius, score in scores)),
        ]


def compare_meshes(
    first: TriangleMesh,
    second: TriangleMesh,
    *,
    thresholds: Sequence[float] | None = None,
    samples: int = 100_000,
    limit: float | None = None,
    seed: int = 0,
) -> MeshComparison:
    """Compare two surfaces in both directions and check whether they match, as `pointloom compare-meshes`.

    Uses `TriangleMesh.compute_metrics`. Bitwise reproducible.

    Args:
        first, second: The meshes, on one device.
        thresholds: Distances of the F-scores [m]. If None: a hundredth of the second mesh's diagonal.
        samples: Points sampled from each.
        limit: Warn above this Hausdorff distance [m]. None for no limit.
        seed: Random seed, 0..2^31 - 1.

    Raises:
        TypeError: If an argument is not a mesh or not a number.
        ValueError: If a mesh has no area or a corner that is not finite, or a number is out of range.
        DeviceError: If the meshes are on different devices.

    Example:
        >>> import pointloom as loom
        >>> ball, larger = loom.TriangleMesh.create_sphere(1.0), loom.TriangleMesh.create_sphere(1.01)
        >>> found = loom.meshing.compare_meshes(ball, larger, thresholds=[0.02], samples=1000, limit=0.005)
        >>> round(found.metrics.hausdorff, 3), found.metrics.fscore.tolist(), found.warnings
        (0.01, [100.0], ('the surfaces are up to 0.01 m apart, more than 0.005 m',))
    """
    for name, mesh in (("first", first), ("second", second)):
        check_mesh(name, mesh)
        check_finite_corners(name, mesh)
        if not mesh.get_surface_area() > 0:
            raise ValueError(f"{name}: expected at least one triangle with an area, got none")
    given = [] if thresholds is None else check_numeric("thresholds", thresholds).reshape(-1).tolist()
    max_deviation = None if limit is None else check_positive("limit", limit, allow_infinite=True)
    count, chosen = check_count("samples", samples), check_seed(seed)
    low, high = second.get_axis_aligned_bounding_box()
    diagonal = math.dist(low, high)
    radii = [check_positive("thresholds", radius) for radius in given] or [F_SCORE_DISTANCE * diagonal]
    return MeshComparison(
        metrics=first.compute_metrics(second, radii, count, seed=chosen),
        thresholds=tuple(radii),
        triangles=(len(first), len(second)),
        diagonal=diagonal,
        samples=count,
        seed=chosen,
        limit=max_deviation,
        device=str(first.device),
        unit=first.unit or second.unit,
    )


def _there_and_back(values: tuple[float, float], m: str) -> str:
    return f"{values[0]:.4g} {m} from A to B, {values[1]:.4g} {m} back"
