"""Check of given camera poses against the images.

Features are matched by appearance only, between overlapping images and neighbors by name. If they contradict the poses,
common errors are tested: inverted poses, camera axes, image order, focal length.
"""

from __future__ import annotations

import dataclasses
import itertools
import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.wording import few_of
from ...io.models.sfm_model import SfmModel
from ...io.points.scan_files import natural_key
from .feature_rays import FeatureRays, focal_of
from .guided_matches import MAX_DISTANCE_RATIO, MAX_SQDIST, PairMatches, Pairs, essential_of

MAX_PAIRS = 40  # overlapping pairs, and as many neighbors by name
MAX_FEATURES = 1000  # features per image
MAX_MATCHES = 200  # matches per pair, for equal influence
MIN_MATCHES = 12  # minimum per pair
MIN_TOTAL = 60  # minimum in total
MAX_EPIPOLAR_DISTANCE = 0.004  # epipolar distance relative to the longer side, for rough poses
MIN_MATCH_FRACTION = 0.4  # minimum fraction for correct poses: 0.6 in a room, a fountain, a temple
MIN_CORRECTION_RATIO = 2.0  # ratio of fitting matches with a corrected error

AXIS_CONVENTIONS = {
    "": (1, 1, 1),
    "the cameras' axes are x right, y up, z back (OpenGL, ARKit), not x right, y down, z forward": (1, -1, -1),
    "the images are rotated by 180 degrees": (-1, -1, 1),
    "the cameras' axes are x left, y down, z back": (-1, 1, -1),
}
QUARTER_ROTATIONS = {
    "the images are rotated by 90 degrees to the left": np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]]),
    "the images are rotated by 90 degrees to the right": np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]),
}
FOCAL_RANGE, FOCAL_STEPS = math.log(2.0), 41
FOCAL_OFF = 0.02  # relative difference of calibrations of one lens
FOCAL_BETTER = 0.8  # cost ratio of a clearly better focal length

Array = NDArray[np.float64]


@dataclasses.dataclass(frozen=True)
class PoseCheck:
    """Agreement of given poses with the images.

    Args:
        match_count: Number of matches by appearance.
        fraction: Fraction that fits.
        distance: Median epipolar distance of those that fit [px].
        cause: Likely error; "" if unknown.
        cause_fraction: Fraction of matches that fits after its correction.
        focal: Preferred factor of the focal length. NaN if not tested.
        strays: Images whose matches do not fit although most others do.
    """

    match_count: int
    fraction: float
    distance: float
    cause: str = ""
    cause_fraction: float = math.nan
    focal: float = math.nan
    strays: tuple[str, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        fields = dataclasses.asdict(self) | {"strays": list(self.strays)}
        return {key: None if value != value else value for key, value in fields.items()}

    @classmethod
    def from_json(cls, record: Mapping[str, Any]) -> PoseCheck:
        fields: dict[str, Any] = {key: math.nan if value is None else value for key, value in record.items()}
        fields["strays"] = tuple(record["strays"])
        return cls(**fields)

    @property
    def are_wrong(self) -> bool:
        return self.match_count < MIN_TOTAL or not self.fraction >= MIN_MATCH_FRACTION

    @property
    def is_focal_wrong(self) -> bool:
        return abs(math.log(self.focal)) > FOCAL_OFF if self.focal == self.focal else False

    def reasons(self, image_count: int) -> list[str]:
        if self.match_count < MIN_TOTAL:
            return [
                f"no images that overlap by their poses, or are consecutive, have matches ({self.match_count} "
                "matches): the poses belong to other images, or the images are too few, blurred or without texture"
            ]
        fits = f"{100 * self.fraction:.0f}% of the matches between images fit the poses"
        if self.are_wrong or (self.cause and self.cause_fraction > MIN_CORRECTION_RATIO * self.fraction):
            if self.cause:
                return [f"only {fits}, {100 * self.cause_fraction:.0f}% would fit if {self.cause}: correct the poses"]
            if self.is_focal_wrong:
                return [f"only {fits}, more would fit with {self.focal:.3g} times the focal length: check the cameras"]
            why = "they belong to other images, have another order or convention, or are too inaccurate"
            return [f"only {fits}: {why}; give the poses of these images, each by its name"]
        reasons = []
        if self.is_focal_wrong:
            reasons.append(
                f"with the given poses, {self.focal:.4g} times the given focal length fits the images better: "
                "check the cameras and the size of the images"
            )
        if len(self.strays) > max(1, 0.1 * image_count):
            reasons.append(
                f"the poses of {len(self.strays)} of {image_count} images do not fit the others "
                f"({few_of(self.strays, 4)}): they may belong to other images"
            )
        return reasons

    def notes(self) -> list[str]:
        if self.strays and not self.are_wrong:
            return [f"poses that do not fit the others: {', '.join(self.strays[:8])}"]
        return []


def check_poses(features: FeatureRays, model: SfmModel, pairs: Pairs) -> PoseCheck:
    pair_matches = match_by_looks(features, _sample(pairs, model))
    matches = _Matches.of(features, model, pair_matches)
    if len(matches.first) < MIN_TOTAL:
        return PoseCheck(len(matches.first), 0.0, math.nan)
    poses = model.T_camera_world
    fits, off = matches.fits(poses)
    fraction, inlier_distances = matches.fraction(fits), off[fits]
    distance = float(np.median(inlier_distances)) if len(inlier_distances) else math.nan
    cause, cause_fraction = _likely_cause(matches, model, fraction)
    focal = matches.focal(poses) if not cause else math.nan
    strays = () if fraction < MIN_MATCH_FRACTION else tuple(model.names[i] for i in matches.strays(fits, len(model)))
    return PoseCheck(len(matches.first), fraction, distance, cause, cause_fraction, focal, strays)


def _sample(pairs: Pairs, model: SfmModel) -> Pairs:
    some = pairs[np.unique(np.linspace(0, len(pairs) - 1, MAX_PAIRS).round().astype(int))] if len(pairs) else pairs
    order = _natural_order(model)
    near = [(order[k], order[k + step]) for step in (1, 2) for k in range(len(order) - step)]
    near = [near[k] for k in np.unique(np.linspace(0, len(near) - 1, MAX_PAIRS).round().astype(int))] if near else []
    chosen = {(min(pair), max(pair)) for pair in near} | {tuple(pair) for pair in some.tolist()}
    return np.array(sorted(chosen), np.int64).reshape(-1, 2)


def _natural_order(model: SfmModel) -> list[int]:
    return sorted(range(len(model)), key=lambda i: natural_key(Path(model.names[i])))


def match_by_looks(features: FeatureRays, pairs: Pairs) -> PairMatches:
    """Mutual nearest descriptors with a ratio test. Products are integers below 2^24, exact in float32."""
    tables: dict[int, tuple[NDArray[np.int64], NDArray[np.float32]]] = {}

    def table(image: int) -> tuple[NDArray[np.int64], NDArray[np.float32]]:
        if image not in tables:
            rows = np.flatnonzero(np.isfinite(features.rays[features.of(image), 0]))
            tables[image] = rows, features.descriptors[features.of(image)][rows].astype(np.float32)
        return tables[image]

    matches = []
    for a, b in pairs.tolist():
        (mine, p), (theirs, q) = table(a), table(b)
        chosen = np.unique(np.linspace(0, len(mine) - 1, MAX_FEATURES).round().astype(int)) if len(mine) else []
        matches.append(_nearest_mutual(p, q, np.asarray(chosen, np.int64), mine, theirs))
    return PairMatches.of_lists(pairs, matches)


def _nearest_mutual(p: Any, q: Any, chosen: Any, mine: Any, theirs: Any) -> NDArray[np.int64]:
    if not len(chosen) or len(q) < 2:
        return np.zeros((0, 2), np.int64)
    sqdists = (p[chosen] ** 2).sum(axis=1)[:, None] + (q**2).sum(axis=1) - 2 * (p[chosen] @ q.T)
    best = sqdists.argmin(axis=1)
    rows = np.arange(len(chosen))
    min_sqdist = sqdists[rows, best]
    sqdists[rows, best] = np.inf
    clear = (min_sqdist < MAX_DISTANCE_RATIO**2 * sqdists.min(axis=1)) & (min_sqdist <= MAX_SQDIST)
    rows, best = rows[clear], best[clear]
    back = ((p**2).sum(axis=1)[:, None] - 2 * (p @ q[best].T)).argmin(axis=0)
    mutual = back == chosen[rows]
    return np.stack([mine[chosen[rows[mutual]]], theirs[best[mutual]]], axis=1)


@dataclasses.dataclass(frozen=True, eq=False)
class _Matches:
    """Matches as normalized rays [k, 2] of image pairs, with pixels per unit."""

    pair: NDArray[np.int64]
    pairs: Pairs
    first: Array
    second: Array
    focals: Array
    near: float

    @classmethod
    def of(cls, features: FeatureRays, model: SfmModel, pair_matches: PairMatches) -> _Matches:
        selected = [k for k in range(len(pair_matches.pairs)) if len(pair_matches.of(k)) >= MIN_MATCHES]
        rays: list[list[Array]] = [[np.zeros((0, 2))], [np.zeros((0, 2))]]
        pair = [np.zeros(0, np.int64)]
        for number, k in enumerate(selected):
            matches = pair_matches.of(k)
            some = matches[np.unique(np.linspace(0, len(matches) - 1, MAX_MATCHES).round().astype(int))]
            for side in (0, 1):
                rays[side].append(features.rays[features.of(int(pair_matches.pairs[k, side]))][some[:, side]])
            pair.append(np.full(len(some), number))
        focals = np.array([focal_of(camera) for camera in model.cameras])
        longer = max(max(camera.width, camera.height) for camera in model.cameras)
        first, second = (np.concatenate(each) for each in rays)
        return cls(
            np.concatenate(pair), pair_matches.pairs[selected], first, second, focals, MAX_EPIPOLAR_DISTANCE * longer
        )

    def off(self, poses: Array, factor: float = 1.0) -> tuple[Array, NDArray[np.bool_]]:
        """Epipolar distances [px], the larger of both, and the mask of matches before both cameras."""
        x, y = (np.concatenate([rays / factor, np.ones((len(rays), 1))], axis=1) for rays in (self.first, self.second))
        E = essential_of(poses, self.pairs)[self.pair]
        there, back = np.einsum("kij,kj->ki", E, x), np.einsum("kji,kj->ki", E, y)
        apart = np.abs((there * y).sum(axis=1))
        f = self.focals[self.pairs[self.pair]] * factor
        with np.errstate(divide="ignore", invalid="ignore"):
            off = np.maximum(
                apart / np.linalg.norm(there[:, :2], axis=1) * f[:, 1],
                apart / np.linalg.norm(back[:, :2], axis=1) * f[:, 0],
            )
        return np.nan_to_num(off, nan=np.inf), _before_both(poses[self.pairs[self.pair]], x, y)

    def fits(self, poses: Array) -> tuple[NDArray[np.bool_], Array]:
        """Mask of the matches that fit, and all epipolar distances [px]."""
        off, before = self.off(poses)
        return (off <= self.near) & before, off

    def fraction(self, fits: NDArray[np.bool_]) -> float:
        return float(np.mean(fits))

    def by_pair(self, fits: NDArray[np.bool_]) -> Array:
        return np.bincount(self.pair, fits, len(self.pairs)) / np.maximum(
            np.bincount(self.pair, minlength=len(self.pairs)), 1
        )

    def strays(self, fits: NDArray[np.bool_], count: int) -> list[int]:
        fractions = self.by_pair(fits)
        best, tried = np.zeros(count), np.zeros(count, int)
        for (a, b), fraction in zip(self.pairs.tolist(), fractions.tolist(), strict=True):
            for i in (a, b):
                best[i], tried[i] = max(best[i], fraction), tried[i] + 1
        return [i for i in range(count) if tried[i] >= 2 and best[i] < MIN_MATCH_FRACTION / 2]

    def focal(self, poses: Array) -> float:
        cost = lambda log: float(np.minimum(self.off(poses, math.exp(log))[0] / self.near, 1.0).mean())  # noqa: E731
        logs = np.linspace(-FOCAL_RANGE, FOCAL_RANGE, FOCAL_STEPS)
        costs = [cost(log) for log in logs]
        middle, step = float(logs[int(np.argmin(costs))]), float(logs[1] - logs[0])
        for _ in range(4):
            around = np.linspace(middle - step, middle + step, 7)
            middle, step = float(around[int(np.argmin([cost(log) for log in around]))]), step / 3
        return math.exp(middle) if cost(middle) < FOCAL_BETTER * cost(0.0) else 1.0


def _before_both(poses: Array, x: Array, y: Array) -> NDArray[np.bool_]:
    """True if rays intersect before both cameras. Nearly parallel ones do, far away."""
    first, second = poses[:, 0], poses[:, 1]
    a = np.einsum("kji,kj->ki", first[:, :3, :3], x)
    b = np.einsum("kji,kj->ki", second[:, :3, :3], y)
    step = -np.einsum("kji,kj->ki", second[:, :3, :3], second[:, :3, 3])
    step += np.einsum("kji,kj->ki", first[:, :3, :3], first[:, :3, 3])
    a /= np.linalg.norm(a, axis=1, keepdims=True)
    b /= np.linalg.norm(b, axis=1, keepdims=True)
    ab, a_step, b_step = (a * b).sum(axis=1), (a * step).sum(axis=1), (b * step).sum(axis=1)
    along_a, along_b = a_step - ab * b_step, ab * a_step - b_step  # times 1 - ab^2 >= 0
    length = np.linalg.norm(step, axis=1)
    slack = 0.01 * length * np.sqrt(np.maximum(1 - ab * ab, 0.0))
    return (ab > 0) & (along_a > -slack) & (along_b > -slack)


def _likely_cause(matches: _Matches, model: SfmModel, fraction: float) -> tuple[str, float]:
    best, best_fraction = "", max(MIN_CORRECTION_RATIO * fraction, MIN_MATCH_FRACTION)
    for name, poses in itertools.chain(_other_conventions(model), _other_orders(model)):
        explained = matches.fraction(matches.fits(poses)[0])
        if explained > best_fraction:
            best, best_fraction = name, explained
    return best, best_fraction if best else math.nan


def _other_conventions(model: SfmModel) -> Iterator[tuple[str, Array]]:
    """The poses under common misreadings, with their names."""
    T = model.T_world_camera
    R, t = T[:, :3, :3], T[:, :3, 3]
    inverse, back = R.transpose(0, 2, 1), -np.einsum("nji,nj->ni", R, t)
    forms: dict[str, tuple[Array, Array]] = {
        "": (R, t),
        "each pose is inverted (world to camera instead of camera to world, or the reverse)": (inverse, back),
        "each rotation is inverted, and the position is correct": (inverse, t),
        "each position is that of the world in the camera frame, and the rotation is correct": (R, back),
    }
    axes = {name: np.diag(signs).astype(float) for name, signs in AXIS_CONVENTIONS.items()} | QUARTER_ROTATIONS
    for (form, (rotation, center)), (name, flip) in itertools.product(forms.items(), axes.items()):
        if form or name:
            yield " and ".join(filter(None, (form, name))), _posed(rotation @ flip, center)


def _other_orders(model: SfmModel) -> Iterator[tuple[str, Array]]:
    natural = _natural_order(model)
    T, count = model.T_camera_world, len(model)
    rank = np.empty(count, int)
    rank[natural] = np.arange(count)
    in_order = T[natural]
    yield "the images are in reverse order", in_order[::-1][rank]
    yield "the images were sorted as text instead of by number", T[rank]
    yield "the images were sorted by number instead of as text", T[np.argsort(rank)]
    for step in (1, -1, 2, -2, 3, -3):
        if count > 2 * abs(step):
            who = f"each image has the pose of the one {abs(step)} {'before' if step > 0 else 'after'} it"
            yield who, np.roll(in_order, -step, axis=0)[rank]


def _posed(R: Array, center: Array) -> Array:
    T = np.tile(np.eye(4), (len(R), 1, 1))
    T[:, :3, :3] = R.transpose(0, 2, 1)
    T[:, :3, 3] = -np.einsum("nji,nj->ni", R, center)
    return T
