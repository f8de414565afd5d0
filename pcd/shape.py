"""Planes, spheres, cylinders, cones and tori that were found in a cloud: sizes, how well they are known, meshes."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_count, check_rows
from ..kernels.linear_algebra import matmul

KINDS = ("plane", "sphere", "cylinder", "cone", "torus")
UNKNOWNS = {  # in the order of the covariance
    "plane": ("shift_axis", "tilt_u", "tilt_v"),
    "sphere": ("shift_u", "shift_v", "shift_axis", "radius"),
    "cylinder": ("shift_u", "shift_v", "tilt_u", "tilt_v", "radius"),
    "cone": ("shift_u", "shift_v", "shift_axis", "tilt_u", "tilt_v", "half_angle"),
    "torus": ("shift_u", "shift_v", "shift_axis", "tilt_u", "tilt_v", "radius", "minor_radius"),
}
ROUND = 64  # steps about an axis of a mesh


class ShapeSurface(NamedTuple):
    """The surface of a shape as triangles: `loom.TriangleMesh(*surface)` makes a mesh of it.

    Attributes:
        vertices: World coordinates [m], float64 [m, 3].
        triangles: int32 [t, 3], counter-clockwise seen from outside; a plane's from where its axis points.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.pcd.shape import ShapeSurface
        >>> surface = ShapeSurface([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        >>> loom.TriangleMesh(*surface).triangles.shape
        (1, 3)
    """

    vertices: NDArray[np.float64]
    triangles: NDArray[np.int32]


@dataclass(frozen=True, eq=False)
class Shape:
    """A simple surface, fitted to points of a cloud.

    Attributes:
        kind: "plane", "sphere", "cylinder", "cone" or "torus".
        center: A place of it in world coordinates [m], float64 [3]: the middle of a plane's points, of a sphere or of a
            torus, of the part of a cylinder's axis that has points, the apex of a cone.
        axis: Unit direction, float64 [3]: a plane's normal, a cylinder's and a torus's axis, a cone's from its apex.
        radius: Of a sphere, a cylinder, a torus's ring [m]; NaN of others.
        minor_radius: Of a torus's tube [m]; NaN of others.
        half_angle: Between a cone's axis and its surface [rad]; NaN of others.
        extent: Where the points lie in `frame` about `center`, (low, high), float64 [2, 3].
        support: Points on it.
        rms: Root of their mean squared distance to it [m].
        coverage: Share of its surface near which there are points, 0..1: of sectors about a cylinder's or a cone's
            axis, of cells of a sphere or a torus; 1 of a plane.
        covariance: Of `unknowns`, [m] and [rad]; infinite where the points leave something open.
        frame: Rows u, v, axis: what the shifts and tilts of `unknowns` are along, float64 [3, 3].
        reasons: What speaks against it, in words; empty where nothing does.
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
    reasons: tuple[str, ...]

    @property
    def is_sure(self) -> bool:
        """Whether nothing speaks against it."""
        return not self.reasons

    @property
    def unknowns(self) -> tuple[str, ...]:
        """Names of what the covariance is of: shifts of the center, tilts of the axis, sizes."""
        return UNKNOWNS[self.kind]

    @property
    def sigma(self) -> dict[str, float]:
        """Standard deviation of each unknown [m], [rad]."""
        return dict(zip(self.unknowns, np.sqrt(np.diag(self.covariance)).tolist(), strict=True))

    def compute_distances(self, points: ArrayLike) -> NDArray[np.float64]:
        """The signed distance [m] of some places from the surface, outside above zero.

        Args:
            points: World coordinates [m], shape [n, 3].

        Raises:
            ValueError: Another shape.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> ball = loom.PointCloud(loom.TriangleMesh.create_sphere(2.0).vertices).estimate_normals()
            >>> shape, _ = ball.segment_sphere(0.01)
            >>> shape.compute_distances([[0, 0, 5]]).round(3).tolist()
            [3.0]
        """
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

    def to_mesh(self, resolution: int = ROUND) -> ShapeSurface:
        """Its surface as triangles: of a plane the rectangle, of a cylinder and a cone the part along its points.

        Args:
            resolution: Steps around, at least 3.

        Returns:
            The surface; `loom.TriangleMesh(*shape.to_mesh())` makes a mesh of it.

        Raises:
            ValueError: Too few steps, or more than 2,048.

        Example:
            >>> import pointloom as loom
            >>> tube = loom.TriangleMesh.create_cylinder(0.5, 2.0, 60, 40).vertices
            >>> shape, _ = loom.PointCloud(tube).estimate_normals(max_nn=12).segment_cylinder(0.01)
            >>> loom.TriangleMesh(*shape.to_mesh())
            TriangleMesh(130 vertices, 128 triangles, cpu)
        """
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
        """All of it in JSON's types; numbers that are not finite are None."""
        numbers = {name: getattr(self, name) for name in ("radius", "minor_radius", "half_angle", "rms", "coverage")}
        told = {name: float(value) if np.isfinite(value) else None for name, value in numbers.items()}
        sigma = {name: value if np.isfinite(value) else None for name, value in self.sigma.items()}
        arrays = {name: getattr(self, name).tolist() for name in ("center", "axis", "extent")}
        return {
            "kind": self.kind,
            **arrays,
            **told,
            "support": self.support,
            "sigma": sigma,
            "reasons": list(self.reasons),
        }

    def __str__(self) -> str:
        sizes = {"radius": "m", "minor_radius": "m", "half_angle": "rad"}
        sigma = self.sigma
        said = [
            f"{name} {getattr(self, name):.6g} ± {sigma[name]:.2g} {sizes[name]}" for name in sizes if name in sigma
        ]
        said += [f"{self.support:,} points", f"rms {self.rms:.3g} m", f"{100 * self.coverage:.0f} % covered"]
        return f"{self.kind}: " + ", ".join(said) + "".join(f"; {reason}" for reason in self.reasons)

    def __repr__(self) -> str:
        return f"Shape({self})"


def _strips(rings: int, steps: int) -> NDArray[np.int32]:
    """Triangles between rings of vertices, each as many; those of no area at poles left out is the caller's."""
    at = (np.arange(rings - 1)[:, None] * steps + np.arange(steps - 1)).ravel()
    right, above = at + 1, at + steps
    return np.concatenate([np.stack([at, right, above], 1), np.stack([right, above + 1, above], 1)]).astype(np.int32)
