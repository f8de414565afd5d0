"""Checks of sampled correspondences and their pose. Thresholds are assignable, as in Open3D."""

from __future__ import annotations

from typing import Any

from numpy.typing import ArrayLike

from ....registration.globally import checkers
from ...argument_types import CloudLike, VectorLike
from ...settings import Settings
from ...wrapper import as_array, column
from .estimation import clouds_of


class CorrespondenceChecker(Settings, of=checkers):
    """Base class of the checks."""

    require_pointcloud_alignment_ = True  # the check uses the pose

    def Check(self, source: CloudLike, target: CloudLike, corres: VectorLike, transformation: ArrayLike) -> bool:
        """True if correspondences and pose pass."""
        return self.native.Check(*clouds_of(source, target), as_array(corres), transformation)

    def __repr__(self) -> str:
        name, value = next(iter(self.native_keywords().items()))
        return f"{type(self).__name__} with {name.replace('normal_angle', 'normal')}={value:f}"


class CorrespondenceCheckerBasedOnEdgeLength(CorrespondenceChecker, of=checkers):
    """Distances between the sampled points are similar in both clouds."""

    require_pointcloud_alignment_ = False
    similarity_threshold: Any = 0.9


class CorrespondenceCheckerBasedOnDistance(CorrespondenceChecker, of=checkers):
    """The sampled points are close under the pose."""

    distance_threshold: Any


class CorrespondenceCheckerBasedOnNormal(CorrespondenceChecker, of=checkers):
    """Normals at the sampled points agree under the pose."""

    normal_angle_threshold: Any


class CorrespondenceCheckerBasedOnSourceRotation(CorrespondenceChecker, of=checkers):
    """The rotation angles of the pose are limited."""

    rotation_threshold: Any

    def __setattr__(self, name: str, value: Any) -> None:
        is_angles = name == "rotation_threshold" and not isinstance(value, CorrespondenceChecker)
        super().__setattr__(name, column(name, value) if is_angles else value)

    def __repr__(self) -> str:
        angles = ", ".join(f"{angle:f}" for angle in self.rotation_threshold)
        return f"CorrespondenceCheckerBasedOnSourceRotation with rotation_threshold={angles} radians."
