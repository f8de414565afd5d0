"""Signed distances of a cloud from a mesh: `loom.meshing.compare_cloud_to_mesh`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.array_libraries import hand_out_host
from ...core.checks import check_positive
from ...core.devices import check_same_device
from ...core.exchange import asnumpy, hand_back
from ...core.matched_counts import why_few_matched
from ...core.reports import AssessedRecord, failed
from ...kernels.lang import float64
from ...kernels.memory import download, upload
from ...kernels.rays.facing_sides import face_distances
from ...kernels.rays.triangle_tree import TriangleTree
from ...kernels.surface.cylinder_change import TWO_SIDED
from ...kernels.surface.value_spreads import spread_values
from ...pcd.change import MIN_POINTS, why_shifted
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from ...pcd.units import common_reference
from ..mesh.mesh import TriangleMesh
from ..mesh.mesh_arrays import check_mesh
from ..mesh.mesh_checks import check_finite_corners

ALIGN = "align the cloud with the mesh"


@dataclass(frozen=True, eq=False)
class CloudToMeshResult(AssessedRecord):
    """Distances of n points from a mesh.

    Attributes:
        distances: To the nearest surface point [m], positive on the triangles' front, float64 (n,). With a radius the
            mean of the neighbors. NaN beyond `max_distance`, for non-finite points, and without triangles.
        level_of_detection: Significant change at 95% confidence [m], float64 (n,).
        spreads: Standard deviations of the neighbors' distances [m], float64 (n,). NaN without a radius, or of one.
        counts: Neighbors with a distance, including the point, int32 (n,). 1 without a radius.
        beside: True if the nearest surface point is on the border of an open mesh, bool (n,).
    """

    distances: NDArray[np.float64]
    level_of_detection: NDArray[np.float64]
    spreads: NDArray[np.float64]
    counts: NDArray[np.int32]
    beside: NDArray[np.bool_]

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks. Empty if the result is reliable."""
        distances, beside = asnumpy(self.distances), asnumpy(self.beside)
        count, measured = len(distances), int(np.isfinite(distances).sum())
        remedy = f"use a larger max_distance, and {ALIGN}"
        above = measured - int((np.isfinite(distances) & beside).sum())
        inside, crop = "distances are not from the border of the mesh", f"crop both, and {ALIGN}"
        few = why_few_matched(measured, count, "points have a distance", remedy)
        shifted = why_shifted(distances, asnumpy(self.is_significant))
        return failed(few, why_few_matched(above, measured, inside, crop), shifted)

    @property
    def is_significant(self) -> NDArray[np.bool_]:
        """True where the distance exceeds the level of detection, not beside a border, with 4 points if averaged."""
        enough = np.isnan(asnumpy(self.spreads)).all() | (asnumpy(self.counts) >= MIN_POINTS)
        with np.errstate(invalid="ignore"):
            changed = np.abs(asnumpy(self.distances)) > asnumpy(self.level_of_detection)
        return hand_back(changed & ~asnumpy(self.beside) & enough, self.distances)

    def __repr__(self) -> str:
        measured, changed = int(np.isfinite(asnumpy(self.distances)).sum()), int(asnumpy(self.is_significant).sum())
        return f"CloudToMeshResult({len(self.distances)} points, {measured} with a distance, {changed} significant)"


@explain_argument_errors
def compare_cloud_to_mesh(
    cloud: PointCloud,
    mesh: TriangleMesh,
    *,
    radius: float | None = None,
    registration_error: float = 0.0,
    max_distance: float | None = None,
) -> CloudToMeshResult:
    """Signed distance of each point from a mesh: a scan against a design or an earlier model.

    Float64 about the mesh's origin. Bitwise reproducible. The sign uses angle-weighted pseudonormals (Baerentzen and
    Aanaes 2005). The level of detection is 1.96 (s / sqrt(n) + registration_error), as M3C2 without reference noise.

    Args:
        cloud: The later epoch.
        mesh: The reference surface, open or closed, on the same device. Triangles face outward or up.
        radius: Exclusive radius of neighbors whose distances are averaged [m]. If None: single points, with the
            registration error as the only uncertainty.
        registration_error: Standard deviation of the registration [m].
        max_distance: Maximum distance [m]. None for no limit.

    Raises:
        TypeError: If `cloud` is not a cloud, or `mesh` is not a mesh.
        ValueError: If a length is not positive, or the mesh has a corner that is not finite.
        DeviceError: If they are on different devices.

    Warns:
        UnitWarning: If they have different units.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> floor = loom.TriangleMesh([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], [[0, 1, 2], [0, 2, 3]])
        >>> cloud = loom.PointCloud([[1, 1, 0.5], [2, 3, -0.25], [6, 1, 0]])
        >>> found = loom.meshing.compare_cloud_to_mesh(cloud, floor, registration_error=0.2)
        >>> found.distances.tolist(), found.is_significant.tolist(), found.beside.tolist()
        ([0.5, -0.25, 2.0], [True, False, False], [False, False, True])
    """
    check_cloud("cloud", cloud)
    check_mesh("mesh", mesh)
    check_same_device("mesh", cloud.device, mesh.device)
    check_finite_corners("mesh", mesh)
    common_reference("cloud, mesh", (cloud, mesh))
    error = check_positive("registration_error", registration_error, allow_zero=True)
    within = None if radius is None else check_positive("radius", radius)
    limit = np.inf if max_distance is None else check_positive("max_distance", max_distance)
    vertices, triangles = mesh.arrays["vertices"], mesh.arrays["triangles"]
    tree, queries = TriangleTree(vertices, triangles), cloud.arrays.about(mesh.origin)
    signed, beside = (download(values) for values in face_distances(tree, vertices, triangles, queries))  # sync
    distances, is_beside = signed.astype(np.float64), beside != 0
    with np.errstate(invalid="ignore"):
        distances[np.abs(distances) > limit] = np.nan

    def made(*results: NDArray[Any]) -> CloudToMeshResult:
        return CloudToMeshResult(*(hand_out_host(each, cloud.array_library, cloud.device) for each in results))

    if within is None:
        count, limits = len(distances), np.where(np.isnan(distances), np.nan, TWO_SIDED * error)
        return made(distances, limits, np.full(count, np.nan), np.ones(count, np.int32), is_beside)
    spreads = spread_values(cloud.search_tree(), upload(distances, float64, cloud.device), within)
    means, deviations, counts = (
        download(values) for values in (spreads.means, spreads.deviations, spreads.counts)
    )  # sync
    with np.errstate(invalid="ignore", over="ignore"):
        limits = TWO_SIDED * (deviations / np.sqrt(np.maximum(counts, 1)) + error)
    return made(means, limits, deviations, counts, is_beside)
