"""How far two surfaces lie apart, and whether they are one thing at all: `compare_meshes`."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from ...core.checks import check_count, check_numeric, check_positive, check_seed
from ...core.reports import Assessed, Fields, Report, quality
from ...core.units import LengthUnit, symbol_of
from ...core.wording import format_share, plain
from .finite_corners import check_finite_corners
from .mesh import TriangleMesh
from .mesh_arrays import check_mesh
from .mesh_metrics import SurfaceMetrics

THRESHOLD = 0.01  # of the second mesh's diagonal: the distance of the F-score where none is given
APART = 0.1  # of the diagonal: a mean distance above this is another unit or frame


@dataclass(frozen=True, eq=False)
class MeshComparison(Report, Assessed):
    """How far two surfaces lie apart; `print` tells it.

    Attributes:
        metrics: The distances, as of `TriangleMesh.compute_metrics`.
        thresholds: The distances [m] of its F-scores.
        triangles: How many either mesh has.
        diagonal: Of the second mesh's box [m].
        samples: Points drawn from each.
        seed: What chose them.
        limit: The Hausdorff distance [m] that was allowed, or None.
        device: Where it was computed.
        unit: Of the lengths, where it is known.
        reliable, warnings: Whether all checks passed, and those that failed, such as that units differ.

    Example:
        >>> import pointloom as loom
        >>> ball = loom.TriangleMesh.create_sphere()
        >>> found = loom.compare_meshes(ball, ball.scale(1000, [0, 0, 0]), samples=1000)
        >>> found.warnings[0].split(": ")[1]
        'other units, or other frames? Register them first'
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
        """Failed quality checks, each with its remedy; empty if the result is reliable."""
        mean, m = max(self.metrics.mean), symbol_of(self.unit)
        if mean > APART * self.diagonal:
            share = format_share(mean / self.diagonal)
            return (f"the surfaces lie {share} of their size apart: other units, or other frames? Register them first",)
        if self.limit is not None and self.metrics.hausdorff > self.limit:
            return (f"the surfaces lie up to {self.metrics.hausdorff:.4g} {m} apart, more than {self.limit:g} {m}",)
        return ()

    def to_dict(self) -> dict[str, Any]:
        """All of it in JSON's types; F-scores by their distances."""
        found = self.metrics
        scores = dict(zip(map(str, self.thresholds), found.fscore.tolist(), strict=True))
        head = {"triangles": self.triangles, "diagonal": self.diagonal, "chamfer": found.chamfer}
        farthest = {"hausdorff": found.hausdorff, "hausdorff_bound": found.hausdorff_bound, "fscore": scores}
        both_ways = {"mean": found.mean, "rms": found.rms, "max": found.max}
        tail = {"samples": self.samples, "seed": self.seed, "device": self.device, **quality(self)}
        unit = {} if self.unit is None else {"unit": self.unit}
        return plain(head | farthest | both_ways | tail | unit)

    def fields(self) -> Fields:
        """The figures as labels and values."""
        found, m = self.metrics, symbol_of(self.unit)
        scores = zip(self.thresholds, found.fscore.tolist(), strict=True)
        return [
            ("triangles", " and ".join(f"{count:,}" for count in self.triangles)),
            ("chamfer", f"{found.chamfer:.4g} {m}"),
            ("mean", _there_and_back(found.mean, m)),
            ("rms", _there_and_back(found.rms, m)),
            ("Hausdorff", f"{found.hausdorff:.4g} {m}, at most {found.hausdorff_bound:.4g}"),
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
    """Measure how far two surfaces lie apart, both ways, and say whether they are one thing at all.

    What `pointloom compare-meshes` does: `TriangleMesh.compute_metrics` with a distance for the F-score that suits the
    mesh, and checks of reliability.

    Args:
        first: A mesh.
        second: The mesh that it is held against, on the same device.
        thresholds: Distances [m] of the F-scores; None or none for a hundredth of the second mesh's diagonal.
        samples: Points drawn from each.
        limit: A Hausdorff distance [m] above this is reported as a warning; None for no limit.
        seed: Chooses the points, 0..2^31 - 1.

    Returns:
        A MeshComparison: figures, `reliable` and `warnings`.

    Raises:
        TypeError: No mesh, or no numbers.
        ValueError: A mesh without area or with a triangle that has a corner which is not finite, or a number out of
            range.
        DeviceError: The meshes are on different devices.

    Notes:
        Same bits from run to run; memory as of `compute_metrics`.

    Example:
        >>> import pointloom as loom
        >>> ball, larger = loom.TriangleMesh.create_sphere(1.0), loom.TriangleMesh.create_sphere(1.01)
        >>> found = loom.compare_meshes(ball, larger, thresholds=[0.02], samples=1000, limit=0.005)
        >>> round(found.metrics.hausdorff, 3), found.metrics.fscore.tolist(), found.warnings
        (0.01, [100.0], ('the surfaces lie up to 0.01 m apart, more than 0.005 m',))
    """
    for name, mesh in (("first", first), ("second", second)):
        check_mesh(name, mesh)
        check_finite_corners(name, mesh)
        if not mesh.get_surface_area() > 0:
            raise ValueError(f"{name}: holds no triangle with an area, so no distance can be taken")
    given = [] if thresholds is None else check_numeric("thresholds", thresholds).reshape(-1).tolist()
    most = None if limit is None else check_positive("limit", limit, allow_infinite=True)
    count, chosen = check_count("samples", samples), check_seed(seed)
    low, high = second.get_axis_aligned_bounding_box()
    diagonal = math.dist(low, high)
    radii = [check_positive("thresholds", radius) for radius in given] or [THRESHOLD * diagonal]
    return MeshComparison(
        metrics=first.compute_metrics(second, radii, count, seed=chosen),
        thresholds=tuple(radii),
        triangles=(len(first), len(second)),
        diagonal=diagonal,
        samples=count,
        seed=chosen,
        limit=most,
        device=str(first.device),
        unit=first.unit or second.unit,
    )


def _there_and_back(values: tuple[float, float], m: str) -> str:
    return f"{values[0]:.4g} {m} from A to B, {values[1]:.4g} {m} back"
