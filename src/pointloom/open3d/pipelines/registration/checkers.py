"""Checks of sampled correspondences and their pose. Thresholds are assignable, as in Open3D."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from numpy.typing import ArrayLike

from ....registration.globally import checkers
from ...argument_types import CloudLike, VectorLike
from ...settings import Settings
from ...wrapper import as_array, column
from .estimation import clouds_of


class CorrespondenceChecker(Settings):
    _kind = checkers.CorrespondenceChecker
    require_pointcloud_alignment_ = True  # the check uses the pose

    def Check(self, source: CloudLike, target: CloudLike, corres: VectorLike, transformation: ArrayLike) -> bool:
        """True if correspondences and pose pass."""
        return self.native.Check(*clouds_of(source, target), as_array(corres), transformation)

    def __repr__(self) -> str:
        name, value = next(iter(self.native_keywords().items()))
        return f"{type(self).__name__} with {name.replace('normal_angle', 'normal')}={value:f}"


@dataclass(eq=False, repr=False)
class CorrespondenceCheckerBasedOnEdgeLength(CorrespondenceChecker):
    """Distances between the sampled points are similar in both clouds."""

    _kind = checkers.CorrespondenceCheckerBasedOnEdgeLength
    require_pointcloud_alignment_ = False
    similarity_threshold: Any = 0.9


@dataclass(eq=False, repr=False)
class CorrespondenceCheckerBasedOnDistance(CorrespondenceChecker):
    """The sampled points are close under the pose."""

    _kind = checkers.CorrespondenceCheckerBasedOnDistance
    distance_threshold: Any


@dataclass(eq=False, repr=False)
class CorrespondenceCheckerBasedOnNormal(CorrespondenceChecker):
    """Normals at the sampled points agree under the pose."""

    _kind = checkers.CorrespondenceCheckerBasedOnNormal
    normal_angle_threshold: Any


@dataclass(eq=False, repr=False)
class CorrespondenceCheckerBasedOnSourceRotation(CorrespondenceChecker):
    """The rotation angles of the pose are limited."""

    _kind = checkers.CorrespondenceCheckerBasedOnSourceRotation
    rotation_threshold: Any

    def __setattr__(self, name: str, value: Any) -> None:
        is_angles = name == "rotation_threshold" and not isinstance(value, CorrespondenceChecker)
        super().__setattr__(name, column(name, value) if is_angles else value)

    def __repr__(self) -> str:
        angles = ", ".join(f"{angle:f}" for angle in self.rotation_threshold)
        return f"CorrespondenceCheckerBasedOnSourceRotation with rotation_threshold={angles} radians."
