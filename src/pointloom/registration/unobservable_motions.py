"""Detection of motions along which points match equally well."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_positive
from ..core.reports import AssessedRecord
from ..kernels.linear_algebra import eigh, matmul
from ..kernels.poses.pair_probes import compare_pair, find_pose_constraint
from ..kernels.surface.hollow_side import Surface
from . import assessment_constants as constants
from .rigid import make_pose, nearest_rotation, rotation_of, symmetric_matrices

Matrix = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Localizability(AssessedRecord):
    """Motions that two clouds determine at a pose, the least determined first.

    Attributes:
        middle: Center of rotations [m] in the target's world: the center of the overlap.
        lever: Length [m] that scales rotations: the spread of the overlap.
        motions: Of the free motions, float64 [6, 6] rows (rotation times lever, translation) along the target's axes.
        fractions: Constraint of each motion, 0..1: the mean squared component of the normals (rotations: of their
            levers).
        kinds: "full" if determined, "partial" if weak (share below 0.03), "none" if the clouds match as well along it.
    """

    middle: Matrix
    lever: float
    motions: Matrix
    fractions: Matrix
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
        return (describe_open(self.open_motions),) if len(self.open_motions) else ()

    def information(self, sigma: float) -> Matrix:
        """Information [6, 6] of a `Prior` on the open motions alone, with `pivot=middle` and deviation `sigma` [m]."""
        if not len(self.open_motions):
            raise ValueError("information: all motions are determined, so registration_icp needs no prior")
        rows = self.open_motions * ([self.lever] * 3 + [1.0] * 3) / check_positive("sigma", sigma)
        return matmul(rows.T, rows)


def judge_motions(
    source: Surface,
    target: Surface,
    pose: Matrix,
    distance: float,
    free: Sequence[int] = range(6),
    *,
    max_fraction: float = constants.SUSPECT_FRACTION,
) -> Localizability | None:
    """The motions that two surfaces in voxels of `distance` / VOXELS determine. None if they hardly match.

    `pose`: T_target_source about the origins; so is `middle` of the result. `free`: the motions that are not fixed.
    Motions constrained below `max_fraction` are verified: undetermined if the source matches as well when moved both
    ways.
    """
    if not (len(source) and len(target)):
        return None
    constraint = find_pose_constraint(
        source, target, pose, distance, constants.SURFACE_DISTANCE * distance, constants.MIN_NORMAL_COSINE
    )
    if constraint.matches < constants.MIN_MATCHES:
        return None
    size = distance / constants.MATCH_VOXELS
    (matrix,) = symmetric_matrices(constraint.triangle[None])
    axes = list(free)
    fractions, free_vectors = eigh(matrix[np.ix_(axes, axes)] / constraint.matches)
    vectors = np.zeros((6, len(axes)))
    vectors[axes] = free_vectors
    scale = np.array([constraint.lever] * 3 + [1.0] * 3)
    suspects = vectors.T[fractions < max_fraction]
    kinds = ["full"] * len(axes)
    if len(suspects):
        steps = [sign * constants.STEP_VOXELS * size * motion / scale for motion in suspects for sign in (-1, 1)]
        poses = np.array([pose, *(moved(pose, step, about=constraint.middle) for step in steps)])
        limits = constants.RADIUS_VOXELS * size, constants.MIN_NORMAL_COSINE, size
        rises = compare_pair(source, target, constants.JUDGING_POINTS, poses, *limits)
        is_constrained: NDArray[np.bool_] = np.logical_and(*rises_clearly(rises[1:]).reshape(-1, 2).T)
        kinds[: len(suspects)] = ["partial" if constrained else "none" for constrained in is_constrained.tolist()]
    return Localizability(
        constraint.middle, constraint.lever, vectors.T.copy(), np.maximum(fractions, 0.0), tuple(kinds)
    )


def rises_clearly(rises: Matrix) -> NDArray[np.bool_]:
    """True where points match clearly worse at other poses, [k], by `compare_costs`."""
    total, square, pairs, _ = rises.T
    is_much = total >= constants.MIN_RISE * np.maximum(pairs, 1)
    return is_much & (total >= constants.MIN_DEVIATIONS * np.sqrt(np.maximum(square, 1)))


def moved(pose: Matrix, motion: Matrix, about: Matrix | None = None) -> Matrix:
    """A pose rotated about a point (default: the sensor), then translated: (rotation [rad], translation [m])."""
    rotation, position = rotation_of(motion[:3]), pose[:3, 3]
    middle = position if about is None else about
    return make_pose(
        nearest_rotation(matmul(rotation, pose[:3, :3])), matmul(rotation, position - middle) + middle + motion[3:]
    )


def spanned(rows: Matrix) -> tuple[tuple[float, float, float], ...]:
    """Significant directions of the column span of a matrix [3, k], the largest component positive."""
    squares, vectors = eigh(matmul(rows, rows.T))
    directions = vectors.T[::-1][squares[::-1] > 0.5]
    signs = [math.copysign(1.0, row[np.abs(row).argmax()]) for row in directions]
    return tuple(tuple(float(v) for v in row * sign) for row, sign in zip(directions, signs, strict=True))  # type: ignore[misc]


def describe_open(motions: Matrix) -> str:
    """The warning of motions that the clouds do not determine."""
    if len(motions) == 6:
        return "the clouds share no surface that determines the pose. Register them with register_globally"
    return (
        f"the clouds do not determine the pose: the source may {describe_motions(motions)}. Fix this motion, add a "
        "prior, or use clouds with surfaces that prevent it"
    )


def describe_motions(motions: Matrix) -> str:
    """Motions (rotation times a length, translation) [k, 6] in words: "slide along x and rotate about z"."""
    slides, turns = spanned(motions[:, 3:].T), spanned(motions[:, :3].T)
    ways = [f"slide {_directions(slides, 'along')}"] if slides else []
    ways += [f"rotate {_directions(turns, 'about')}"] if turns else []
    return " and ".join(ways) or "slide and rotate together"


def _directions(directions: Sequence[tuple[float, float, float]], preposition: str) -> str:
    """The span of one to three orthonormal directions in words. Two are any in their plane, so its normal is named."""
    if len(directions) == 1:
        return f"{preposition} {_format_direction(directions[0])}"
    if len(directions) == 2:
        first, second = directions
        (upward,) = spanned(np.cross(first, second)[:, None])
        return f"{preposition} any direction perpendicular to {_format_direction(upward)}"
    return f"{preposition} any direction"


def _format_direction(direction: tuple[float, float, float]) -> str:
    largest = int(np.abs(direction).argmax())
    if abs(direction[largest]) > 0.998:
        return "xyz"[largest]
    return f"({', '.join(f'{v:.2f}' for v in direction)})"
