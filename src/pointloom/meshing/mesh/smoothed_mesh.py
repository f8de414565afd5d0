"""Mesh smoothing with a quality check: `smooth_mesh`."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...core.checks import check_count, check_name, check_number
from ...core.reports import Fields, quality
from ...core.units import symbol_of
from ...core.wording import format_fraction, plain
from .changed_mesh import MAX_CHANGED, SHAPE_TOLERANCE, ChangedMesh, fractions_changed, sizes_before
from .measures import finite_area
from .mesh import TriangleMesh
from .mesh_arrays import check_mesh
from .smoothing import MAX_PASSES

METHODS = ("taubin", "laplacian", "simple", "sharpen")
MAX_AREA_LOSS = 0.1  # of the area: a larger loss is reported

_DEFAULT_FACTORS = {"lambda_filter": 0.5, "mu": -0.53, "strength": 1.0}
_OWNERS = {"lambda_filter": ("taubin", "laplacian"), "mu": ("taubin",), "strength": ("sharpen",)}


@dataclass(frozen=True)
class Movement:
    """Displacement of vertices, `mean` and `max` [m]."""

    mean: float
    max: float


@dataclass(frozen=True, kw_only=True, eq=False)
class SmoothedMesh(ChangedMesh):
    """A smoothed mesh and its change of shape.

    Attributes:
        mesh: The result.
        method, iterations: As given.
        moved: Displacement of the finite vertices. None if there are none.
        area_in, area: Area of triangles with finite corners, before and after [m^2].
        changed: Fraction of the surface, before or after, that is farther than 2% of the box's diagonal from the other
            one, the larger. None without an area or with a corner that is not finite.
        vertices_in, triangles_in: Counts of the input.
        reliable, warnings: True if all quality checks passed, and those that failed.
    """

    method: str
    iterations: int
    moved: Movement | None
    area_in: float
    area: float
    changed: float | None = None

    @property
    def warnings(self) -> tuple[str, ...]:
        if not len(self.mesh):
            return ("the mesh has no triangles",)
        change = self.area / self.area_in - 1 if self.area_in > 0 else 0.0
        if not math.isfinite(change) or (self.method == "sharpen" and change > 1):
            return (f"the area grew {self.area / self.area_in:.3g} times: use fewer iterations or a smaller strength",)
        if self.method == "sharpen":
            return ()
        fewer = "use fewer iterations" + ("" if self.method == "taubin" else ", or method='taubin', which shrinks less")
        if change < -MAX_AREA_LOSS:
            return (f"{format_fraction(-change)} of the area was lost: {fewer}",)
        if self.changed is not None and self.changed > MAX_CHANGED:
            part = format_fraction(self.changed)
            return (f"{part} of the surface moved by more than {SHAPE_TOLERANCE:.0%} of its size: {fewer}",)
        return ()

    def to_dict(self) -> dict[str, Any]:
        moved = None if self.moved is None else {"mean": self.moved.mean, "max": self.moved.max}
        how = {"method": self.method, "iterations": self.iterations, "moved": moved}
        return plain(
            self.sizes_to_dict()
            | how
            | {"area_in": self.area_in, "area": self.area, "changed": self.changed, **quality(self)}
        )

    def fields(self) -> Fields:
        moved, m = "no vertex is finite", symbol_of(self.mesh.unit)
        if self.moved is not None:
            moved = f"{self.moved.mean:.3g} {m} mean, {self.moved.max:.3g} {m} at most"
        return [
            ("method", f"{self.method}, {self.iterations:,} times"),
            *self.size_fields()[1:],
            ("moved", moved),
            ("area", f"{self.area:.4g} of {self.area_in:.4g} {m}^2"),
        ]


def smooth_mesh(
    mesh: TriangleMesh,
    method: str = "taubin",
    iterations: int = 10,
    *,
    lambda_filter: float | None = None,
    mu: float | None = None,
    strength: float | None = None,
) -> SmoothedMesh:
    """Smooth or sharpen a mesh and measure displacement and shrinkage, as `pointloom smooth-mesh`.

    Uses the `filter_smooth_*` and `filter_sharpen` methods. Colors are clipped to 0..1. Bitwise identical on every
    device.

    Args:
        mesh: The mesh.
        method: "taubin" (little shrinkage), "laplacian" (distance weights), "simple" (mean) or "sharpen".
        iterations: Number of passes, up to 10,000.
        lambda_filter: Of taubin and laplacian, default 0.5.
        mu: Of taubin, default -0.53.
        strength: Of sharpen, default 1.

    Raises:
        TypeError: If `mesh` is not a mesh, or an argument is not a number.
        ValueError: If the method is unknown, or an argument is out of range or of another method.

    Example:
        >>> import pointloom as loom
        >>> found = loom.meshing.smooth_mesh(loom.TriangleMesh.create_sphere())
        >>> found.moved.max < 0.01, round(found.area / found.area_in, 1), found.reliable
        (True, 1.0, True)
    """
    check_mesh("mesh", mesh)
    factors = _factors_of(method, {"lambda_filter": lambda_filter, "mu": mu, "strength": strength})
    reason = "more iterations shrink the mesh to the mean of its vertices"
    count = check_count("iterations", iterations, minimum=0, maximum=MAX_PASSES, because=reason)
    filters: dict[str, Callable[..., TriangleMesh]] = {
        name: getattr(mesh, f"filter_smooth_{name}") for name in METHODS[:3]
    }
    filters["sharpen"] = mesh.filter_sharpen
    smooth = filters[method](count, *factors)
    colors = smooth.vertex_colors
    if colors is not None:
        smooth.vertex_colors = colors.clip(0, 1)
    moved = np.linalg.norm(smooth.vertices - mesh.vertices, axis=1)
    moved, changed = moved[np.isfinite(moved)], fractions_changed(mesh, smooth)
    return SmoothedMesh(
        mesh=smooth,
        **sizes_before(mesh),
        method=method,
        iterations=count,
        moved=Movement(float(moved.mean()), float(moved.max())) if len(moved) else None,
        area_in=finite_area(mesh),
        area=finite_area(smooth),
        changed=None if changed is None else max(changed),
    )


def _factors_of(method: str, given: dict[str, Any]) -> list[float]:
    """Factors of the method in the order of its filter."""
    if check_name("method", method) not in METHODS:
        raise ValueError(f"method: expected one of {', '.join(METHODS)}, got {method!r}")
    for name, value in given.items():
        if value is not None and method not in _OWNERS[name]:
            owners = " or ".join(repr(owner) for owner in _OWNERS[name])
            raise ValueError(f"{name}: applies to method {owners}, not to {method!r}")
    applicable = {name: value for name, value in given.items() if method in _OWNERS[name]}
    return [
        _DEFAULT_FACTORS[name] if value is None else check_number(name, value) for name, value in applicable.items()
    ]
