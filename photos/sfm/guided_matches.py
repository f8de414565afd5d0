"""Features matched along the epipolar lines of cameras with known poses, between pictures whose frusta overlap."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera_models import CameraModel
from ...core.progress import ReportProgress
from ...files.models.sfm_model import SfmModel
from ...kernels.features.epipolar_matching import LineFeatures, LineSearches, match_along_lines
from ..frusta import shares_in_view
from .feature_rays import FeatureRays, focal_of, pinhole_of

MOST_PARTNERS = 20  # pictures that each is matched with: those that see most of the same
LEAST_SHARE = 0.05  # of what a picture may see, below which another one is no partner
RATIO = 0.8  # of the distances of the nearest and the second feature (Lowe 2004)
MOST_SQDIST = 123_000  # of two descriptors of length 512: they are 0.7 rad apart, as COLMAP has it
PAIRS_AT_ONCE = 32

Pairs = NDArray[np.int64]


@dataclasses.dataclass(frozen=True, eq=False)
class PairMatches:
    """Matches of pairs of pictures.

    Args:
        pairs: First and second picture of each pair, int64 [p, 2], the first being the lower.
        firsts: The first match of each pair, and the number of all, int64 [p + 1].
        matches: Numbers of the feature in the first and the second picture, int64 [k, 2].
    """

    pairs: Pairs
    firsts: NDArray[np.int64]
    matches: NDArray[np.int64]

    def of(self, pair: int) -> NDArray[np.int64]:
        """The matches of a pair, [k, 2]."""
        return self.matches[self.firsts[pair] : self.firsts[pair + 1]]

    @classmethod
    def of_lists(cls, pairs: Pairs, lists: Sequence[NDArray[np.int64]]) -> PairMatches:
        """Those of each pair, one after the other."""
        firsts = np.concatenate([[0], np.cumsum([len(each) for each in lists])]).astype(np.int64)
        return cls(pairs, firsts, np.concatenate([np.zeros((0, 2), np.int64), *lists]))


def pairs_in_view(cameras: Sequence[CameraModel], poses: NDArray[np.float64]) -> Pairs:
    """Pairs of pictures that may see the same: each with up to 20 others, [p, 2] in ascending order."""
    shares = shares_in_view([pinhole_of(camera) for camera in cameras], poses)
    pairs = set()
    for i, row in enumerate(shares):
        best = np.argsort(-row, kind="stable")[:MOST_PARTNERS]
        pairs |= {(min(i, j), max(i, j)) for j in best.tolist() if row[j] >= LEAST_SHARE}
    return np.array(sorted(pairs), np.int64).reshape(-1, 2)


def match_guided(
    features: FeatureRays, model: SfmModel, pairs: Pairs, *, distance: float, device: Any, progress: ReportProgress
) -> PairMatches:
    """Match the features of pairs, each with those on its line that are no farther from it than `distance`.

    Args:
        features: Of the model's pictures.
        model: The cameras and their poses.
        pairs: Which pictures.
        distance: From the lines, in both pictures [px].
        device: Where to compute.
        progress: Called with "matches", how many pairs are done, and how many there are.

    Returns:
        Pairs of features that are each other's nearest on their lines, clearly nearer than the next.
    """
    on_device = LineFeatures(features.firsts, features.rays, features.descriptors, device)
    limits = np.array([(distance / focal_of(camera)) ** 2 for camera in model.cameras])
    found: list[NDArray[np.int64]] = []
    for start in range(0, len(pairs), PAIRS_AT_ONCE):
        progress("matches", start, len(pairs))
        some = pairs[start : start + PAIRS_AT_ONCE]
        both = np.concatenate([some, some[:, ::-1]])
        counts = np.diff(features.firsts)[both[:, 0]]
        starts = np.concatenate([[0], np.cumsum(counts)])
        essential = essential_of(model.T_camera_world, both)
        searches = LineSearches(starts, both, essential.reshape(-1, 9), limits[both], device)
        nearest = match_along_lines(searches, on_device, int(starts[-1]))
        found += _mutual(nearest, starts, len(some))
    progress("matches", len(pairs), len(pairs))
    return PairMatches.of_lists(pairs, found)


def essential_of(poses: NDArray[np.float64], pairs: Pairs) -> NDArray[np.float64]:
    """E of pairs of cameras, [p, 3, 3]: rays x of the first and y of the second have y E x = 0."""
    first, second = poses[pairs[:, 0]], poses[pairs[:, 1]]
    R = second[:, :3, :3] @ first[:, :3, :3].transpose(0, 2, 1)
    t = second[:, :3, 3] - np.einsum("pij,pj->pi", R, first[:, :3, 3])
    t /= np.maximum(np.linalg.norm(t, axis=1, keepdims=True), np.finfo(float).tiny)
    cross = np.zeros((len(pairs), 3, 3))
    cross[:, [2, 0, 1], [1, 2, 0]], cross[:, [1, 2, 0], [2, 0, 1]] = t[:, [0, 1, 2]], -t[:, [0, 1, 2]]
    return cross @ R


def _mutual(nearest: NDArray[np.int32], starts: NDArray[np.int64], count: int) -> Iterator[NDArray[np.int64]]:
    """Of searches there and, `count` further on, back: the matches that both ways agree on, pair by pair."""
    with np.errstate(invalid="ignore"):
        clear = (nearest[:, 0] >= 0) & (nearest[:, 1] <= MOST_SQDIST)
        clear &= nearest[:, 1] < RATIO**2 * nearest[:, 2].astype(np.float64)
    chosen = np.where(clear, nearest[:, 0], -1)
    for k in range(count):
        there = chosen[starts[k] : starts[k + 1]]
        back = nearest[starts[count + k] : starts[count + k + 1], 0]
        mine = np.flatnonzero(there >= 0)
        mine = mine[back[there[mine]] == mine]
        yield np.stack([mine, there[mine]], axis=1).astype(np.int64)


def write_matches(path: Path, matches: PairMatches) -> None:
    """Keep matches as a file."""
    with path.open("wb") as file:
        np.savez(file, pairs=matches.pairs, firsts=matches.firsts, matches=matches.matches)


def read_matches(path: Path) -> PairMatches:
    """What `write_matches` kept."""
    with np.load(path) as read:
        return PairMatches(read["pairs"], read["firsts"], read["matches"])
