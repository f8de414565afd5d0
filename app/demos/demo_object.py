"""An object of the made-up room as a scanner measures it from all sides: points with noise, and the surface they make.

The object is the sofa: 2 m long, of rounded cushions. Its true surface is known by the distance of any point from its
solids, so the points lie on it to the noise, and the surface made of them is held against it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.timing import Clock
from ...data.scenes.furniture import sofa
from ...kernels.lang import vec3d
from ...kernels.memory import download, upload
from ...kernels.scenes.primitives import Solids, distance_to_solids
from ...meshing.mesh.isosurface import marching_cubes
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.mesh_summary import SurfaceSummary, describe_surface
from ...pcd.cloud import PointCloud

POINTS = 60_000  # 1 cm apart
NOISE = 0.003  # [m] standard deviation in each direction: of structured light at 1.5 m
CELL = 0.03  # [m] of the grid that finds where the surface is; the points are then moved onto it
MARGIN = 3  # cells of air around it
NEIGHBORS = 30  # of a normal: averages the noise
DEPTH = 7  # 2 cm: finer cells would show the noise
LARGEST_RMSE = 0.005  # [m] of a surface that is right; those of several seeds are below 2 mm


def scan_sofa(*, seed: int = 0, noise: bool = True, device: Any = "cpu") -> PointCloud:
    """Points of the sofa's surface with normals that look out of it, as a scanner knows them that walked around it.

    Args:
        seed: Chooses the points and the noise.
        noise: Points off the surface by 3 mm; False takes exact ones.
        device: Where to compute.
    """
    solids = sofa().solids(device)
    reach = np.linalg.norm(download(solids.extents)[:, :3], axis=1) + download(solids.extents)[:, 3]
    centers = download(solids.centers)
    low = (centers - reach[:, None]).min(axis=0) - MARGIN * CELL
    high = (centers + reach[:, None]).max(axis=0) + MARGIN * CELL
    axes = [np.arange(a, b, CELL) for a, b in zip(low, high, strict=True)]
    nodes = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    field = _distances(nodes.reshape(-1, 3), solids).reshape(nodes.shape[:3])
    outline = marching_cubes(field.astype(np.float32), spacing=[CELL] * 3, origin=low, device=device)
    cloud = outline.sample_points_uniformly(POINTS, use_triangle_normal=True, seed=seed)
    points = cloud.points - _distances(cloud.points, solids)[:, None] * cloud.normals
    if noise:
        points += np.random.default_rng(seed).normal(0, NOISE, points.shape)
    cloud.points = points
    return cloud.estimate_normals(max_nn=NEIGHBORS)  # on the side of those that it has


@dataclass(frozen=True)
class SofaFigures:
    """The surface that was made of the sofa's points.

    Attributes:
        surface: Its size and form.
        point_count: Points that it was made of.
        median, rmse, error_max: Distances of its vertices from the true surface [m].
    """

    surface: SurfaceSummary
    point_count: int
    median: float
    rmse: float
    error_max: float

    def to_json(self) -> dict[str, Any]:
        """The same in JSON's types."""
        errors = {"median": self.median, "rmse": self.rmse, "error_max": self.error_max}
        return self.surface.to_json() | {"points": self.point_count} | errors

    def __str__(self) -> str:
        form = "closed" if self.surface.watertight else "not closed"
        return (
            f"{self.point_count:,} points, {self.surface.triangles:,} triangles, {form}; off the true surface by "
            f"{self.median * 1000:.2f} mm in the median, {self.rmse * 1000:.2f} mm root mean square"
        )

    def why_poor(self) -> str | None:
        """Whether the surface is not the sofa's."""
        if self.rmse <= LARGEST_RMSE:
            return None
        return f"the sofa's surface is off by {self.rmse * 1000:.1f} mm, more than {LARGEST_RMSE * 1000:g}"


def make_sofa(*, seed: int, noise: bool, device: Any, clock: Clock) -> tuple[TriangleMesh, SofaFigures]:
    """Scan the sofa and make a surface of the points; the clock counts both."""
    cloud = scan_sofa(seed=seed, noise=noise, device=device)
    clock.stop("scan")
    mesh, _ = TriangleMesh.from_point_cloud_poisson(cloud, depth=DEPTH)
    clock.stop("poisson")
    errors = np.abs(_distances(mesh.vertices, sofa().solids(device)))
    figures = float(np.median(errors)), float(np.sqrt(np.mean(errors**2))), float(errors.max())
    return mesh, SofaFigures(describe_surface(mesh), len(cloud), *figures)


def _distances(points: NDArray[np.float64], solids: Solids) -> NDArray[np.float64]:
    """Distances of points [m] from the solids, negative inside."""
    return download(distance_to_solids(upload(points, vec3d, solids.device), solids)).copy()  # sync
