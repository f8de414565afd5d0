"""Detected planes, spheres, cylinders, cones and tori: parameters, uncertainty, meshes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_count, check_rows, shown
from ..core.reports import Assessed, quality
from ..kernels.linear_algebra import matmul

KINDS = ("plane", "sphere", "cylinder", "cone", "torus")
UNKNOWNS = {  # in the order of the covariance
    "plane": ("shift_axis", "tilt_u", "tilt_v"),
    "sphere": ("shift_u", "shift_v", "shift_axis", "radius"),
    "cylinder": ("shift_u", "shift_v", "tilt_u", "tilt_v", "radius"),
    "cone": ("shift_u", "shift_v", "shift_axis", "tilt_u", "tilt_v", "half_angle"),
    "torus": ("shift_u", "shift_v", "shift_axis", "tilt_u", "tilt_v", "radius", "minor_radius"),
}
MESH_STEPS_AROUND = 64  # steps around an axis of a mesh


def check_kind(kind: object, kinds: Sequence[str] = KINDS) -> int:
    """The number of a kind of shape."""
    if not isinstance(kind, str):
        raise TypeError(f"kind: expected one of {', '.join(kinds)}, got {shown(kind)}")
    if kind not in kinds:
        raise ValueError(f"kind: expected one of {', '.join(kinds)}, got {shown(kind)}")
    return KINDS.index(kind)


class ShapeSurface(NamedTuple):
    """Surface of a shape: `vertices` [m], float64 (m, 3), `triangles`, int32 (t, 3); `loom.TriangleMesh(*surface)`."""

    vertices: NDArray[np.float64]
    triangles: NDArray[np.int32]


@dataclass(frozen=True, eq=False)
class Shape(Assessed):
    """A geometric shape fitted to points of a cloud.

    Attributes:
        kind: "plane", "sphere", "cylinder", "cone" or "torus".
        center: World coordinates [m], float64 (3,): center of the points (plane), of the shape, or of the part of a
            cylinder's axis with points; apex of a cone.
        axis: Unit direction, float64 (3,): normal of a plane, axis of others. A cone's from its apex.
        radius, minor_radius: Of a sphere, cylinder or torus ring, and of a torus tube [m]. Else NaN.
        half_angle: Between a cone's axis and surface [rad]. Else NaN.
        extent: (low, high) of the points in `frame` about `center`, float64 (2, 3).
        support, rms: Number of points, and root mean squared distance [m].
        coverage: Fraction of the surface near points, 0..1: of sectors (cylinder, cone) or cells (sphere, torus).
        covariance: Of `unknowns`, [m] and [rad], infinite if undetermined.
        frame: Rows u, v, axis, the directions of `unknowns`, float64 (3, 3).
        warnings: Failed quality checks. Empty if the shape is reliable.
    """

    kind: str
    center: NDArray[np.float64]
    axis: NDArray[np.float64]
    radius: float
    minor_radius: float
    half_angle: float
    extent: NDArray[np.float64]
    support: int
    rms: float
    coverage: float
    covariance: NDArray[np.float64]
    frame: NDArray[np.float64]
    warnings: tuple[str, ...]

    @property
    def unknowns(self) -> tuple[str, ...]:
        """Names of the covariance's parameters: shifts of the center, tilts of the axis, sizes."""
        return UNKNOWNS[self.kind]

    @property
    def sigma(self) -> dict[str, float]:
        """Standard deviation of each unknown [m], [rad]."""
        return dict(zip(self.unknowns, np.sqrt(np.diag(self.covariance)).tolist(), strict=True))

    def compute_distances(self, points: ArrayLike) -> NDArray[np.float64]:
        """Signed distances of points (n, 3) from the surface [m], positive outside."""
        y = check_rows("points", points, 3, dtype=np.float64) - self.center
        h = matmul(y, self.axis)
        q = np.linalg.norm(y - h[:, None] * self.axis, axis=1)
        if self.kind == "plane":
            return h
        if self.kind == "sphere":
            return np.linalg.norm(y, axis=1) - self.radius
        if self.kind == "cylinder":
            return q - self.radius
        if self.kind == "torus":
            return np.hypot(q - self.radius, h) - self.minor_radius
        c, s = np.cos(self.half_angle), np.sin(self.half_angle)
        return np.where(q * s + h * c < 0, np.linalg.norm(y, axis=1), q * c - h * s)

    def to_mesh(self, resolution: int = MESH_STEPS_AROUND) -> ShapeSurface:
        """Surface as triangles: the rectangle of a plane, the part with points of a cylinder or cone. `resolution` is
        the number of steps around, 3 to 2,048. `loom.TriangleMesh(*shape.to_mesh())` is the mesh."""
        steps = check_count("resolution", resolution, minimum=3, maximum=2048, because="more are finer than any scan")
        low, high = self.extent
        if self.kind == "plane":
            corners = np.array([[low[0], low[1], 0], [high[0], low[1], 0], [high[0], high[1], 0], [low[0], high[1], 0]])
            return ShapeSurface(self.center + matmul(corners, self.frame), np.array([[0, 1, 2], [0, 2, 3]], np.int32))
        around = 2 * np.pi * np.arange(steps + 1) / steps
        if self.kind == "sphere":
            t = np.pi * np.arange(steps // 2 + 2) / (steps // 2 + 1)
            profile = self.radius * np.stack([np.sin(t), -np.cos(t)], 1)
        elif self.kind == "torus":
            profile = np.array([self.radius, 0]) + self.minor_radius * np.stack([np.cos(around), np.sin(around)], 1)
        elif self.kind == "cylinder":
            profile = np.array([[self.radius, low[2]], [self.radius, high[2]]])
        else:
            ends = np.maximum([low[2], high[2]], 0.0)
            profile = np.stack([ends * math.tan(self.half_angle), ends], 1)
        ring = np.stack([np.cos(around), np.sin(around)], 1)
        rows = np.concatenate(
            [profile[:, None, :1] * ring[None], np.broadcast_to(profile[:, None, 1:], (len(profile), steps + 1, 1))], 2
        )
        return ShapeSurface(self.center + matmul(rows.reshape(-1, 3), self.frame), _strips(len(profile), steps + 1))

    def to_dict(self) -> dict[str, Any]:
        """All fields in JSON's types. Numbers that are not finite are None."""
        numbers = {name: getattr(self, name) for name in ("radius", "minor_radius", "half_angle", "rms", "coverage")}
        values = {name: float(value) if np.isfinite(value) else None for name, value in numbers.items()}
        sigma = {name: value if np.isfinite(value) else None for name, value in self.sigma.items()}
        arrays = {name: getattr(self, name).tolist() for name in ("center", "axis", "extent")}
        return {"kind": self.kind, **arrays, **values, "support": self.support, "sigma": sigma, **quality(self)}

    def __str__(self) -> str:
        sizes = {"radius": "m", "minor_radius": "m", "half_angle": "rad"}
        sigma = self.sigma
        parts = [
            f"{name} {getattr(self, name):.6g} ± {sigma[name]:.2g} {sizes[name]}" for name in sizes if name in sigma
        ]
        parts += [f"{self.support:,} points", f"rms {self.rms:.3g} m", f"{100 * self.coverage:.0f} % covered"]
        return f"{self.kind}: " + ", ".join(parts) + "".join(f"; {warning}" for warning in self.warnings)

    def __repr__(self) -> str:
        return f"Shape({self})"


def _strips(rings: int, steps: int) -> NDArray[np.int32]:
    """Triangles between rings of vertices. Degenerate ones at poles are not removed."""
    at = (np.arange(rings - 1)[:, None] * steps + np.arange(steps - 1)).ravel()
    right, above = at + 1, at + steps
    return np.concatenate([np.stack([at, right, above], 1), np.stack([right, above + 1, above], 1)]).astype(np.int32)
