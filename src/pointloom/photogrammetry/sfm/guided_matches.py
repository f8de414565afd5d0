"""Feature matching along epipolar lines of cameras with known poses and overlapping frusta."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera_models import CameraModel
from ...core.progress import ReportProgress
from ...io.models.sfm_model import SfmModel
from ...kernels.array_types import Device
from ...kernels.features.epipolar_matching import LineFeatures, LineSearches, match_along_lines
from ..frusta import fractions_in_view
from .feature_rays import FeatureRays, focal_of, pinhole_of

MAX_PARTNERS = 20  # maximum partners per image, those with most in common
MIN_FRACTION = 0.05  # minimum fraction of common view of a partner
MAX_DISTANCE_RATIO = 0.8  # ratio of nearest to second nearest distance (Lowe 2004)
MAX_SQDIST = 123_000  # descriptors of norm 512 are 0.7 rad apart, as in COLMAP
PAIRS_AT_ONCE = 32

Pairs = NDArray[np.int64]


@dataclasses.dataclass(frozen=True, eq=False)
class PairMatches:
    """Matches int64 [k, 2] of image pairs [p, 2] (lower index first), with offsets `firsts` [p + 1]."""

    pairs: Pairs
    firsts: NDArray[np.int64]
    matches: NDArray[np.int64]

    def of(self, pair: int) -> NDArray[np.int64]:
        return self.matches[self.firsts[pair] : self.firsts[pair + 1]]

    @classmethod
    def of_lists(cls, pairs: Pairs, lists: Sequence[NDArray[np.int64]]) -> PairMatches:
        firsts = np.concatenate([[0], np.cumsum([len(each) for each in lists])]).astype(np.int64)
        return cls(pairs, firsts, np.concatenate([np.zeros((0, 2), np.int64), *lists]))


def pairs_in_view(cameras: Sequence[CameraModel], poses: NDArray[np.float64]) -> Pairs:
    """Image pairs with common view: each with up to 20 others, [p, 2], ascending."""
    fractions = fractions_in_view([pinhole_of(camera) for camera in cameras], poses)
    pairs = set()
    for i, row in enumerate(fractions):
        best = np.argsort(-row, kind="stable")[:MAX_PARTNERS]
        pairs |= {(min(i, j), max(i, j)) for j in best.tolist() if row[j] >= MIN_FRACTION}
    return np.array(sorted(pairs), np.int64).reshape(-1, 2)


def match_guided(
    features: FeatureRays, model: SfmModel, pairs: Pairs, *, distance: float, device: Device, progress: ReportProgress
) -> PairMatches:
    """Mutual nearest features within `distance` [px] of the epipolar lines in both images, with a ratio test."""
    on_device = LineFeatures(features.firsts, features.rays, features.descriptors, device)
    limits = np.array([(distance / focal_of(camera)) ** 2 for camera in model.cameras])
    matches: list[NDArray[np.int64]] = []
    for start in range(0, len(pairs), PAIRS_AT_ONCE):
        progress("matches", start, len(pairs))
        some = pairs[start : start + PAIRS_AT_ONCE]
        both = np.concatenate([some, some[:, ::-1]])
        counts = np.diff(features.firsts)[both[:, 0]]
        starts = np.concatenate([[0], np.cumsum(counts)])
        essential = essential_of(model.T_camera_world, both)
        searches = LineSearches(starts, both, essential.reshape(-1, 9), limits[both], device)
        nearest = match_along_lines(searches, on_device, int(starts[-1]))
        matches += _mutual(nearest, starts, len(some))
    progress("matches", len(pairs), len(pairs))
    return PairMatches.of_lists(pairs, matches)


def essential_of(poses: NDArray[np.float64], pairs: Pairs) -> NDArray[np.float64]:
    """Essential matrices [p, 3, 3]: y E x = 0 for rays x of the first and y of the second camera."""
    first, second = poses[pairs[:, 0]], poses[pairs[:, 1]]
    R = second[:, :3, :3] @ first[:, :3, :3].transpose(0, 2, 1)
    t = second[:, :3, 3] - np.einsum("pij,pj->pi", R, first[:, :3, 3])
    t /= np.maximum(np.linalg.norm(t, axis=1, keepdims=True), np.finfo(float).tiny)
    cross = np.zeros((len(pairs), 3, 3))
    cross[:, [2, 0, 1], [1, 2, 0]], cross[:, [1, 2, 0], [2, 0, 1]] = t[:, [0, 1, 2]], -t[:, [0, 1, 2]]
    return cross @ R


def _mutual(nearest: NDArray[np.int32], starts: NDArray[np.int64], count: int) -> Iterator[NDArray[np.int64]]:
    """The mutual matches of each pair, from searches forward and, `count` further on, backward."""
    with np.errstate(invalid="ignore"):
        clear = (nearest[:, 0] >= 0) & (nearest[:, 1] <= MAX_SQDIST)
        clear &= nearest[:, 1] < MAX_DISTANCE_RATIO**2 * nearest[:, 2].astype(np.float64)
    chosen = np.where(clear, nearest[:, 0], -1)
    for k in range(count):
        there = chosen[starts[k] : starts[k + 1]]
        back = nearest[starts[count + k] : starts[count + k + 1], 0]
        mine = np.flatnonzero(there >= 0)
        mine = mine[back[there[mine]] == mine]
        yield np.stack([mine, there[mine]], axis=1).astype(np.int64)


def write_matches(path: Path, matches: PairMatches) -> None:
    with path.open("wb") as file:
        np.savez(file, pairs=matches.pairs, firsts=matches.firsts, matches=matches.matches)


def read_matches(path: Path) -> PairMatches:
    with np.load(path) as read:
        return PairMatches(read["pairs"], read["firsts"], read["matches"])
