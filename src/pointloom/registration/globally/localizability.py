"""Localizability: which motions two registered clouds determine."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_positive, check_rigid
from ...core.reports import AssessedRecord
from ...kernels.linear_algebra import matmul
from ...pcd.cloud import PointCloud
from ..correspondence_input import check_clouds
from ..icp.constraint import Prior
from ..rigid import nearest_rotation, to_local
from ..surfaces import FINER, VOXELS, surface_for
from ..unobservable_motions import describe_motions, judge_motions, spanned

Matrix = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Localizability(AssessedRecord):
    """Motions that two clouds determine at a pose, the least determined first.

    Attributes:
        transformation: The pose, T_target_source.
        middle: Center of rotations [m] in the target's world: the center of the overlap.
        lever: Length [m] that scales rotations: the spread of the overlap.
        motions: float64 [6, 6], orthonormal rows (rotation times lever, translation) along the target's axes.
        shares: Constraint of each motion, 0..1: the mean squared component of the normals (rotations: of their levers).
        kinds: "full" if determined, "partial" if weak (share below 0.03), "none" if the clouds match as well along it.
    """

    transformation: Matrix
    middle: NDArray[np.float64]
    lever: float
    motions: Matrix
    shares: NDArray[np.float64]
    kinds: tuple[str, ...]

    @property
    def open_motions(self) -> Matrix:
        """The motions of kind "none", [k, 6]."""
        return self.motions[[kind == "none" for kind in self.kinds]]

    @property
    def translations(self) -> tuple[tuple[float, float, float], ...]:
        """Unit directions of undetermined translations."""
        return spanned(self.open_motions[:, 3:].T) if len(self.open_motions) else ()

    @property
    def turns(self) -> tuple[tuple[float, float, float], ...]:
        """Unit axes of undetermined rotations, through the middle."""
        return spanned(self.open_motions[:, :3].T) if len(self.open_motions) else ()

    @property
    def warnings(self) -> tuple[str, ...]:
        if not len(self.open_motions):
            return ()
        if len(self.open_motions) == 6:
            return ("the clouds share no surface that determines the pose",)
        return (f"the source may {describe_motions(self.open_motions)}: the clouds match equally well there",)

    def prior(self, transformation: ArrayLike, sigma: float) -> Prior:
        """Prior for `Constraint(prior=..., pivot=localizability.middle)` that fixes only the undetermined motions."""
        if not len(self.open_motions):
            raise ValueError("prior: all motions are determined, so registration_icp needs none")
        check_positive("sigma", sigma)
        rows = self.open_motions * ([self.lever] * 3 + [1.0] * 3) / sigma
        return Prior(transformation, information=matmul(rows.T, rows))

    def __str__(self) -> str:
        lines = ["motion (turn by lever, translation)                   share   held"]
        for motion, share, kind in zip(self.motions, self.shares, self.kinds, strict=True):
            lines.append(f"{' '.join(f'{v:7.3f}' for v in motion)}  {share:8.5f}   {kind}")
        return "\n".join(lines)


def localizability(
    source: PointCloud, target: PointCloud, transformation: ArrayLike, max_correspondence_distance: float
) -> Localizability:
    """Determine which motions two clouds constrain at their registered pose.

    In a corridor, a tunnel, a field, or on a sphere or tube, ICP finds one of many poses with fitness 1. Motions that
    normals constrain weakly are verified: undetermined if the source matches as well when moved both ways.

    Args:
        source: The moved cloud.
        target: The fixed cloud, on the same device.
        transformation: T_target_source, 4x4, from ICP.
        max_correspondence_distance: Match distance [m] of the registration. The clouds are compared in voxels of two
            thirds of it, and moved by half of it.

    Returns:
        The motions and their constraints. All "none" if almost nothing matches.

    Raises:
        ValueError: A distance that is not positive or too small, or a pose that is not rigid.
        TypeError, DeviceError: Not a PointCloud, or clouds on different devices.

    Notes:
        Memory O(n). Bitwise reproducible. Details below a voxel do not count. Tuna et al., "X-ICP: Localizability-Aware
        LiDAR Registration for Robust Localization in Extreme Environments", 2023 (kinds). Zhang, Kaess and Singh 2016
        (eigenvectors). Unlike there, the error is measured with new pairs.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y, z = np.random.default_rng(0).uniform(-1, 1, (3, 30000)) * [[6], [1], [1]]
        >>> side = np.arange(30000) % 3
        >>> walls = np.column_stack([x, np.where(side < 2, 2.0 * side - 1, y), np.where(side < 2, z, -1)])
        >>> scans = loom.PointCloud(walls[:15000]), loom.PointCloud(walls[15000:])
        >>> found = loom.registration.localizability(*scans, np.eye(4), 0.3)
        >>> found.kinds[0], found.kinds[-1]
        ('none', 'full')
        >>> found.warnings
        ('the source may slide along x: the clouds match equally well there',)
    """
    check_clouds(source, target)
    distance = check_positive("max_correspondence_distance", max_correspondence_distance)
    T = np.array(check_rigid("transformation", transformation))
    T[:3, :3] = nearest_rotation(T[:3, :3])
    size = distance / VOXELS
    left, right = surface_for(source, FINER * size, distance), surface_for(target, size, distance)
    judged = judge_motions(left, right, to_local(T, source.origin, target.origin), distance)
    if judged is None:
        return Localizability(T, target.origin.copy(), distance, np.eye(6), np.zeros(6), ("none",) * 6)
    middle = judged.middle + target.origin
    return Localizability(T, middle, judged.lever, judged.motions, judged.shares, judged.kinds)
