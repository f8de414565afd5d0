"""Tests of a sample of correspondences and its pose; their thresholds are assigned, as in Open3D."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ....registration.globally import checkers
from ...geometry import PointCloud
from ...held import as_array, column, ours
from ...settings import Settings


class CorrespondenceChecker(Settings):
    """What all checkers have."""

    _kind = checkers.CorrespondenceChecker
    require_pointcloud_alignment_ = True  # whether the pose is looked at

    def Check(self, source: Any, target: Any, corres: Any, transformation: Any) -> bool:
        """Whether a few correspondences and a pose pass."""
        clouds = ours(source, PointCloud, "source"), ours(target, PointCloud, "target")
        return self._ours.Check(*clouds, as_array(corres), transformation)


@dataclass(eq=False, repr=False)
class CorrespondenceCheckerBasedOnEdgeLength(CorrespondenceChecker):
    """Lengths between the sampled points are similar in both clouds."""

    _kind = checkers.CorrespondenceCheckerBasedOnEdgeLength
    require_pointcloud_alignment_ = False
    similarity_threshold: Any = 0.9

    def __repr__(self) -> str:
        return f"CorrespondenceCheckerBasedOnEdgeLength with similarity_threshold={self.similarity_threshold:f}"


@dataclass(eq=False, repr=False)
class CorrespondenceCheckerBasedOnDistance(CorrespondenceChecker):
    """The sampled points lie close together under the pose."""

    _kind = checkers.CorrespondenceCheckerBasedOnDistance
    distance_threshold: Any

    def __repr__(self) -> str:
        return f"CorrespondenceCheckerBasedOnDistance with distance_threshold={self.distance_threshold:f}"


@dataclass(eq=False, repr=False)
class CorrespondenceCheckerBasedOnNormal(CorrespondenceChecker):
    """The normals at the sampled points agree under the pose."""

    _kind = checkers.CorrespondenceCheckerBasedOnNormal
    normal_angle_threshold: Any

    def __repr__(self) -> str:
        return f"CorrespondenceCheckerBasedOnNormal with normal_threshold={self.normal_angle_threshold:f}"


@dataclass(eq=False, repr=False)
class CorrespondenceCheckerBasedOnSourceRotation(CorrespondenceChecker):
    """The pose does not turn the source too far about its axes."""

    _kind = checkers.CorrespondenceCheckerBasedOnSourceRotation
    rotation_threshold: Any

    def __setattr__(self, name: str, value: Any) -> None:
        is_angles = name == "rotation_threshold" and not isinstance(value, CorrespondenceChecker)
        super().__setattr__(name, column(name, value) if is_angles else value)

    def __repr__(self) -> str:
        angles = ", ".join(f"{angle:f}" for angle in self.rotation_threshold)
        return f"CorrespondenceCheckerBasedOnSourceRotation with rotation_threshold={angles} radians."
