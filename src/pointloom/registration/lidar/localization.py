"""Localization of a cloud in a map of submaps, without an initial pose."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.reports import Assessed, Fields, Report, as_json, failed, with_warnings
from ...kernels.linear_algebra import matmul
from ..pose_errors import PoseCovariance
from .lidar_graph import in_axes
from .lidar_loops import Place, initial_poses
from .place_descriptor import PlaceDescriptor, PlaceQuery
from .submap_pairs import MIN_PLACE_SCORE, SubmapSurfaces, are_equal, register_submaps

Matrix = NDArray[np.float64]

MAX_PLACES = 6  # submaps to register: each place is in up to four that overlap


@dataclass(frozen=True, eq=False)
class Localization(Report, Assessed):
    """Pose of a cloud in a map.

    Attributes:
        transformation: T_world_cloud, float64 [4, 4]. The best one found, also if it is not reliable.
        submap: Number of the submap that it was registered to. -1 if the map has none.
        similarity: Correlation of the images of the cloud and the submap from above, 0..1.
        score: Confidence that the surfaces agree, 0..1.
        covariance: Covariance of the error of the pose in the submap, along the axes of the world.
        problem: What rejects the pose. Empty if nothing does.
        alternatives: Other poses T_world_cloud at which the cloud fits the map as well, float64 [4, 4] each.
    """

    transformation: Matrix
    submap: int
    similarity: float
    score: float
    covariance: PoseCovariance
    problem: str
    alternatives: tuple[Matrix, ...]

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed checks. Empty if the pose is reliable."""
        others = f"the cloud fits the map at {len(self.alternatives) + 1} poses: see `alternatives`"
        return failed(self.problem, others if self.alternatives else None)

    def fields(self) -> Fields:
        x, y, z = self.transformation[:3, 3]
        sigmas = " ".join(f"{s:.2g}" for s in self.covariance.sigmas[3:])
        rows = [
            ("position", f"{x:.2f} {y:.2f} {z:.2f} m in submap {self.submap}"),
            ("score", f"{self.score:.2f}, similarity {self.similarity:.2f}"),
            ("sigma", f"{sigmas} m"),
        ]
        return with_warnings(rows, self)

    def to_dict(self) -> dict[str, Any]:
        """All attributes in JSON types, with `reliable` and `warnings`."""
        return as_json(self)


def localize_cloud(
    surfaces: SubmapSurfaces,
    descriptor: PlaceDescriptor,
    places: Sequence[Place],
    poses: Sequence[Matrix],
    surfaces_of: Callable[[int], SubmapSurfaces],
    voxel_size: float,
) -> Localization:
    """Register a cloud to the submaps that are most similar from above, and compare all poses in the world."""
    query, level = PlaceQuery(descriptor), np.eye(3)
    similarity = query.similarities([place.descriptor for place in places])
    ranked = sorted(range(len(places)), key=lambda k: (-similarity[k], k))[:MAX_PLACES]
    found: list[Localization] = []
    for k in ranked:
        starts = initial_poses(query, level, places[k])
        for rated in register_submaps(surfaces, surfaces_of(k), starts, voxel_size):
            R, T = poses[k][:3, :3], matmul(poses[k], rated.transformation)
            known = np.isfinite(rated.covariance.matrix).all()
            matrix = in_axes(rated.covariance.about(rated.transformation[:3, 3]).matrix, R) if known else None
            covariance = PoseCovariance(np.full((6, 6), np.inf) if matrix is None else matrix, T[:3, 3].copy())
            found.append(Localization(T, k, similarity[k], rated.score, covariance, rated.problem, ()))
    if not found:
        unknown = PoseCovariance(np.full((6, 6), np.inf), np.zeros(3))
        return Localization(np.eye(4), -1, 0.0, 0.0, unknown, "no submap has a similar place", ())
    best = max(found, key=lambda each: (not each.problem, each.score))
    others: list[Matrix] = []
    for each in found:
        is_known = any(are_equal(each.transformation, T, voxel_size) for T in (best.transformation, *others))
        if each.score > MIN_PLACE_SCORE and not best.problem and not is_known:
            others.append(each.transformation)
    return Localization(
        best.transformation, best.submap, best.similarity, best.score, best.covariance, best.problem, tuple(others)
    )
