"""Change of a surface against a model of it: `loom.change.cloud_to_mesh`."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_positive
from ...core.devices import check_same_device
from ...core.told_arguments import told_arguments
from ...core.units import common_unit
from ...kernels.lang import float64
from ...kernels.memory import download, upload
from ...kernels.rays.facing_sides import face_distances
from ...kernels.rays.triangle_tree import TriangleTree
from ...kernels.surface.cylinder_change import TWO_SIDED
from ...kernels.surface.value_spreads import spread_values
from ...pcd.change import LEAST_POINTS
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ..mesh.finite_corners import check_finite_corners
from ..mesh.mesh import TriangleMesh
from ..mesh.mesh_intersections import check_mesh


@dataclass(frozen=True, eq=False)
class CloudToMeshResult:
    """How far each of n points lies from a mesh.

    Attributes:
        distances: Along the nearest way to the surface [m], positive on the side that its triangles face, float64 [n];
            with a radius the mean over the neighbours. NaN beyond `max_distance`, for points that are not finite, and
            without triangles.
        level_of_detection: What the distance must exceed to be a change with 95 % confidence [m], float64 [n].
        spreads: Standard deviations of the neighbours' distances [m], float64 [n]; NaN without a radius, or of one.
        counts: Neighbours that have a distance, the point among them, int32 [n]; 1 without a radius.
        beside: Where the nearest place is on the rim of an open mesh: the surface ends there, and the point may lie
            beside it. bool [n].
    """

    distances: NDArray[np.float64]
    level_of_detection: NDArray[np.float64]
    spreads: NDArray[np.float64]
    counts: NDArray[np.int32]
    beside: NDArray[np.bool_]

    @property
    def is_significant(self) -> NDArray[np.bool_]:
        """Where the distance exceeds the level of detection, beside no rim, and by 4 points where there is a radius."""
        enough = np.isnan(self.spreads).all() | (self.counts >= LEAST_POINTS)
        with np.errstate(invalid="ignore"):
            return (np.abs(self.distances) > self.level_of_detection) & ~self.beside & enough

    def __repr__(self) -> str:
        """Its size, and how much has changed."""
        found, changed = int(np.isfinite(self.distances).sum()), int(self.is_significant.sum())
        return f"CloudToMeshResult({len(self.distances)} points, {found} with a distance, {changed} significant)"


@told_arguments
def cloud_to_mesh(
    cloud: PointCloud,
    mesh: TriangleMesh,
    *,
    radius: float | None = None,
    registration_error: float = 0.0,
    max_distance: float | None = None,
) -> CloudToMeshResult:
    """The signed distance of each point from a mesh: a scan against a design, or against a model of an earlier epoch.

    Args:
        cloud: The later epoch.
        mesh: The surface that it is compared with, open or closed, on the same device. Its triangles face outwards, or
            up.
        radius: Of neighbours whose distances are averaged [m], the boundary excluded: their spread and number then say
            what is noise. None takes each point by itself, and leaves the registration error as all that is known.
        registration_error: Of cloud and mesh against each other [m], as a standard deviation.
        max_distance: Points farther away have no distance [m]; None takes all.

    Raises:
        TypeError: No cloud, or no mesh.
        ValueError: Lengths that are not above 0, or a triangle of the mesh has a corner that is not finite.
        DeviceError: They are on different devices.

    Warns:
        UnitWarning: They have different units.

    Notes:
        Exact in float64 about the mesh's origin, to which positions are rounded to float32; the same bits from run to
        run. The sign is that of the angle-weighted pseudonormal (Baerentzen and Aanaes 2005), so that points over
        edges and corners have the side that they lie on; `RaycastingScene.compute_signed_distance` asks in place of
        that whether a point is inside. The level of detection is 1.96 (s / sqrt(n) + registration_error), as of M3C2
        whose second epoch has no noise.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> floor = loom.TriangleMesh([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> cloud = loom.PointCloud([[1, 1, 0.5], [2, 3, -0.25], [6, 1, 0]])
        >>> found = loom.change.cloud_to_mesh(cloud, floor, registration_error=0.2)
        >>> found.distances.tolist(), found.is_significant.tolist(), found.beside.tolist()
        ([0.5, -0.25, 2.0], [True, False, False], [False, False, True])
    """
    check_cloud("cloud", cloud)
    check_mesh("mesh", mesh)
    check_same_device("mesh", cloud.device, mesh.device)
    check_finite_corners("mesh", mesh)
    common_unit("cloud, mesh", (cloud.unit, mesh.unit))
    error = check_positive("registration_error", registration_error, allow_zero=True)
    within = None if radius is None else check_positive("radius", radius)
    most = np.inf if max_distance is None else check_positive("max_distance", max_distance)
    vertices, triangles = mesh.array("vertices"), mesh.array("triangles")
    tree, queries = TriangleTree(vertices, triangles), cloud._points_about(mesh.origin)
    found, beside = (download(values) for values in face_distances(tree, vertices, triangles, queries))  # sync
    distances, is_beside = found.astype(np.float64), beside != 0
    with np.errstate(invalid="ignore"):
        distances[np.abs(distances) > most] = np.nan
    if within is None:
        count, limits = len(distances), np.where(np.isnan(distances), np.nan, TWO_SIDED * error)
        return CloudToMeshResult(distances, limits, np.full(count, np.nan), np.ones(count, np.int32), is_beside)
    spreads = spread_values(cloud.search_tree(), upload(distances, float64, cloud.device), within)
    means, deviations, counts = (
        download(values) for values in (spreads.means, spreads.deviations, spreads.counts)
    )  # sync
    with np.errstate(invalid="ignore", over="ignore"):
        limits = TWO_SIDED * (deviations / np.sqrt(np.maximum(counts, 1)) + error)
    return CloudToMeshResult(means, limits, deviations, counts, is_beside)
