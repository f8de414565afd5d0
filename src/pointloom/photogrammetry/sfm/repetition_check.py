"""Check whether repeating structure, such as the windows of a facade, leaves the poses of a model undetermined.

Images of a structure with a period look the same after a shift of the camera by one period. Their matches then fit two
poses equally well. The period is found from features that are similar to others of the same image at one common shift,
with the same size and orientation. Similar objects at two positions are no repetition: a shift needs more votes than
the positions of the features explain. If fewer than two periods fit into the image, it needs those of a large fraction
of the features, or many times those by chance.
A match is explained by the repetition if the copy of its feature in the same image is about as similar as the match.
The other matches decide between the poses.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import KDTree

from ...core.errors import FileError
from ...io.models.sfm_model import SfmModel
from .colmap_jobs import names_by_number, open_database
from .feature_rays import DESCRIPTOR_LENGTH, focal_of, table_of
from .matches import PAIR_ID_FACTOR

Array = NDArray[np.float64]

MAX_FEATURES = 2048  # features per image, those of the largest scale
MAX_VOTES = 1000  # similar features per image that vote for a shift
MIN_VOTES = 10  # for a shift, in addition to those by chance: if each feature votes for the partner of another
# The next four were chosen on photographs of Sceaux, a fountain, a kitchen and skimage.data, and on the facades 0 to 47
# of benchmarks/trust, 2026-11-29. If fewer than two periods fit, the last two are alternatives.
MAX_ROTATION = math.radians(20)  # [rad] between copies, with 1.5: facades keep 99 % of the votes, text 44 %
MAX_SIZE_RATIO = 1.5  # of the scales of copies
MIN_COVERAGE = 0.2  # votes per feature with a copy in the image: wings of a castle 0.1, windows 0.4, stained ones 0.02
MIN_OF_CHANCE = 3.0  # times the votes by chance, in addition to MIN_VOTES: wings 2.4, stained windows 3 to 6
MAX_SHIFT_DIFFERENCE = 0.1  # of a shift: votes and copies within this fraction agree
MIN_SHIFT = 0.05  # relative to the longer side
MIN_OF_BEST = 0.3  # fraction of the votes of the best shift
MAX_SHIFTS = 8
AT_ONCE = 512  # features per distance block
MAX_DESCRIPTOR_DISTANCE = 150.0  # distance of descriptors of norm 512: nine tenths of correct matches are below it
AS_SIMILAR = 200.0  # distance of descriptors below which a copy explains any match
MAX_DISTANCE_RATIO = 0.8  # distance of a match to that of a copy (Lowe 2004)
SAME_PIXEL = 1e-3  # [px] from a feature to the observation made from it
MIN_SHARED = 15  # points that connect two images, as in COLMAP
MIN_DECISIVE = 0.6  # fraction of the matches that the repetition must not explain
MIN_CONNECTED = 0.95  # fraction of the images that such pairs must connect
MIN_VIEWS = 3  # images of a track: two always fit a wrong pose along their epipolar lines
MIN_TRACKS = 10  # in an image
MAX_TRACK_ERROR = 0.01  # error of a track that does not fit, relative to the longer side
MAX_CONTRADICTION = 0.4  # fraction of the tracks of an image: 0.27 in correct models, 0.5 to 1 in wrong ones


@dataclasses.dataclass(frozen=True)
class RepetitionCheck:
    """Repeating structure in the images of a model.

    Args:
        image_count: Images of the model.
        repeating_count: Images with a repeating structure.
        connected_count: Images in the largest group that matches connect without the repetition.
        contradiction: Largest fraction of an image's other matches in three images or more that do not fit the model.
        period: Median shift between copies in an image [px]. NaN without repetition.
        baselines: Shift of a camera to the next pose that fits as well, relative to the distance of the nearest camera.
            NaN if unknown.
    """

    image_count: int
    repeating_count: int
    connected_count: int
    contradiction: float = 0.0
    period: float = math.nan
    baselines: float = math.nan

    @classmethod
    def from_json(cls, record: Mapping[str, Any]) -> RepetitionCheck:
        known: dict[str, Any] = {key: math.nan if value is None else value for key, value in record.items()}
        return cls(**known)

    def to_dict(self) -> dict[str, Any]:
        return {key: None if value != value else value for key, value in dataclasses.asdict(self).items()}

    def reasons(self) -> list[str]:
        if not self.repeating_count:
            return []
        if self.connected_count < MIN_CONNECTED * self.image_count:
            others = f"the other matches connect only {self.connected_count} of {self.image_count} images"
        elif self.contradiction > MAX_CONTRADICTION:
            others = f"up to {100 * self.contradiction:.0f}% of the other matches of an image do not fit the model"
        else:
            return []
        shift = "" if math.isnan(self.baselines) else f" ({self.baselines:.2g} times the distance of two cameras)"
        return [
            f"the structure repeats every {self.period:.0f} px in {self.repeating_count} of {self.image_count} "
            f"images, and {others}: cameras may be off by a multiple of this shift{shift}. Take images that overlap "
            "more and show a unique part, such as a door or a sign"
        ]


@dataclasses.dataclass(frozen=True, eq=False)
class _Image:
    """Features of an image: pixels, descriptors, points of the model (-1: none), distances of the most similar copy
    (NaN: none is visible), and the shift between copies [px] (NaN: nothing repeats)."""

    pixels: Array
    descriptors: NDArray[np.uint8]
    points: NDArray[np.int64]
    copies: Array
    shift: float


def check_repetition(model: SfmModel, database: Path) -> RepetitionCheck | None:
    """Check a model with the matches that it was made from. None for features other than SIFT."""
    with open_database(database) as connection:
        numbers = {name: number for number, name in names_by_number(connection, database).items()}
        images = []
        for k, name in enumerate(model.names):
            keypoints = table_of(connection, "keypoints", numbers[name], np.float32, database)
            try:
                descriptors = table_of(connection, "descriptors", numbers[name], np.uint8, database)
            except FileError:  # imported descriptors of another type
                return None
            if len(keypoints) != len(descriptors) or (len(keypoints) and descriptors.shape[1] != DESCRIPTOR_LENGTH):
                return None
            images.append(_image(model, k, keypoints, descriptors))
        repeating = [k for k, each in enumerate(images) if not math.isnan(each.shift)]
        if not repeating:
            return RepetitionCheck(len(model), 0, len(model))
        indices, pairs = {numbers[name]: k for k, name in enumerate(model.names)}, {}
        query = "SELECT pair_id FROM two_view_geometries WHERE rows >= ? ORDER BY pair_id"
        for (key,) in connection.execute(query, (MIN_SHARED,)).fetchall():
            first, second = divmod(key, PAIR_ID_FACTOR)
            if first in indices and second in indices:
                i, j = indices[first], indices[second]
                found = table_of(connection, "two_view_geometries", key, np.uint32, database, column="pair_id")
                pairs[i, j] = _checked_matches(found, images[i], images[j], database)
    links, tracks = np.zeros((len(model), len(model)), bool), [np.zeros((0, 2), np.int64)]
    firsts = np.concatenate([[0], np.cumsum([len(each.pixels) for each in images])])
    for (i, j), matches in pairs.items():
        known, decisive = _decisive(images[i], images[j], matches)
        points = images[i].points[matches[:, 0]]
        same = (points == images[j].points[matches[:, 1]]) & (points >= 0)
        fraction = (decisive & same).sum() / max((known & same).sum(), MIN_VOTES)
        repeats = i in repeating or j in repeating
        links[i, j] = same.sum() >= MIN_SHARED and (not repeats or fraction >= MIN_DECISIVE)
        tracks.append(matches[decisive] + firsts[[i, j]])
    return RepetitionCheck(
        len(model),
        len(repeating),
        int(np.bincount(connected_components(links)[1]).max()),
        _contradiction(model, images, firsts, np.concatenate(tracks)),
        float(np.median([images[k].shift for k in repeating])),
        _baselines(model, images, repeating),
    )


def _checked_matches(found: Any, first: _Image, second: _Image, database: Path) -> NDArray[np.int64]:
    counts = len(first.pixels), len(second.pixels)
    if found.shape[1] != 2 or not (found < counts).all():
        raise FileError(
            database,
            "is damaged: matches of features that it does not contain",
            remedy="Run photogrammetry.match_features again",
        )
    return found.astype(np.int64)


def _image(model: SfmModel, number: int, keypoints: Array, descriptors: NDArray[np.uint8]) -> _Image:
    """Read an image. Features of several orientations have one position and one point."""
    camera, rows = model.cameras[number], np.flatnonzero(model.observations[:, 0] == number)
    pixels = keypoints[:, :2].astype(np.float64) - 0.5  # COLMAP's first pixel center is at 0.5
    points = np.full(len(pixels), -1)
    if len(rows) and len(pixels):
        off, nearest = KDTree(model.pixels[rows]).query(pixels)
        points = np.where(off < SAME_PIXEL, model.observations[rows[nearest], 1], -1)
    copies, shift = _copies_in(keypoints, descriptors, (camera.width, camera.height))
    return _Image(pixels, descriptors, points, copies, shift)


def _decisive(first: _Image, second: _Image, matches: NDArray[np.int64]) -> tuple[Any, Any]:
    """Matches whose copy would be visible, and those that no copy explains, by the distances of both."""
    copies = np.fmin(first.copies[matches[:, 0]], second.copies[matches[:, 1]])
    distances = _distances(first.descriptors[matches[:, 0]], second.descriptors[matches[:, 1]])
    return ~np.isnan(copies), copies >= np.maximum(AS_SIMILAR, distances / MAX_DISTANCE_RATIO)


def _contradiction(model: SfmModel, images: Sequence[_Image], firsts: Any, matches: NDArray[np.int64]) -> float:
    """The largest fraction over images of tracks in three images or more that the poses do not explain."""
    count, labels = connected_components(coo_matrix((np.ones(len(matches)), matches.T), (firsts[-1], firsts[-1])))
    owners = np.repeat(np.arange(len(model)), np.diff(firsts))
    at, repeated = np.unique(labels * len(model) + owners, return_counts=True)
    good = np.bincount(labels, minlength=count) >= MIN_VIEWS
    good[at[repeated > 1] // len(model)] = False
    rows = np.flatnonzero(good[labels])
    if not len(rows):
        return 0.0
    owners, labels = owners[rows], np.unique(labels[rows], return_inverse=True)[1]
    pixels = np.concatenate([each.pixels for each in images])[rows]
    errors = np.zeros(labels.max() + 1)
    np.maximum.at(errors, labels, _track_errors(model, owners, labels, pixels))
    bad = errors[labels] > MAX_TRACK_ERROR
    fractions = [bad[owners == k].mean() for k in range(len(model)) if (owners == k).sum() >= MIN_TRACKS]
    return float(max(fractions, default=0.0))


def _track_errors(model: SfmModel, images: NDArray, labels: NDArray, pixels: Array) -> Array:
    """Reprojection errors of the points nearest to the rays of tracks, relative to the longer side of the image."""
    rays, projected, sides = np.zeros((len(images), 3)), np.zeros((len(images), 2)), np.zeros(len(images))
    for k, camera in enumerate(model.cameras):
        of = images == k
        rays[of] = camera.unproject(pixels[of]) @ model.T_camera_world[k, :3, :3]
        sides[of] = max(camera.width, camera.height)
    rays /= np.linalg.norm(rays, axis=1, keepdims=True)
    across = np.eye(3) - rays[:, :, None] * rays[:, None]
    centers = model.centers[images]
    normal, right = np.zeros((labels.max() + 1, 3, 3)), np.zeros((labels.max() + 1, 3))
    np.add.at(normal, labels, across)
    np.add.at(right, labels, np.einsum("nij,nj->ni", across, centers))
    points = np.einsum("nij,nj->ni", np.linalg.pinv(normal, hermitian=True), right)[labels]
    local = np.einsum("nij,nj->ni", model.T_camera_world[images, :3, :3], points) + model.T_camera_world[images, :3, 3]
    for k, camera in enumerate(model.cameras):
        of = images == k
        projected[of] = camera.project(local[of])
    errors = np.linalg.norm(projected - pixels, axis=1) / sides
    return np.where(np.isfinite(errors) & (local[:, 2] > 0), errors, np.inf)


def _copies_in(keypoints: Array, descriptors: NDArray[np.uint8], size: tuple[int, int]) -> tuple[Array, float]:
    """Distances of the most similar copy of each feature at the common shifts, and the most common shift [px]."""
    distances, (scales, angles) = np.full(len(keypoints), np.nan), _scales_and_angles(keypoints[:, 2:])
    chosen = np.sort(np.argsort(-scales, kind="stable")[:MAX_FEATURES])
    at, seen = keypoints[chosen, :2].astype(np.float64), descriptors[chosen].astype(np.float32)
    scales, angles = scales[chosen], angles[chosen]

    def shifted(first: NDArray, second: NDArray) -> NDArray:
        turn = np.abs((angles[first] - angles[second] + math.pi) % (2 * math.pi) - math.pi)
        larger, smaller = np.maximum(scales[first], scales[second]), np.minimum(scales[first], scales[second])
        return (turn <= MAX_ROTATION) & (larger <= MAX_SIZE_RATIO * smaller)

    first, second = _similar_features(at, seen, MIN_SHIFT * max(size))
    voting = shifted(first, second)
    shifts = _common_shifts(at[first[voting]], at[second[voting]], at, size)
    if not len(shifts):
        return distances, math.nan
    tree = KDTree(at)
    for shift in shifts:
        near = tree.query_ball_point(at + shift, MAX_SHIFT_DIFFERENCE * float(np.linalg.norm(shift)))
        features = np.repeat(np.arange(len(at)), [len(each) for each in near])
        others = np.concatenate([np.zeros(0), *near]).astype(np.int64)
        copies = shifted(features, others)
        off = np.where(copies, _distances(seen[features], seen[others]), np.inf)  # seen, and no copy of it
        np.fmin.at(distances, chosen[features], off)
    return distances, float(np.linalg.norm(shifts[0]))


def _scales_and_angles(shapes: Array) -> tuple[Array, Array]:
    """Sizes and orientations of features with an affine shape, a scale and an orientation, or nothing (equal ones)."""
    shapes = shapes.astype(np.float64)
    if shapes.shape[1] == 4:
        return np.sqrt(np.abs(np.linalg.det(shapes.reshape(-1, 2, 2)))), np.arctan2(shapes[:, 2], shapes[:, 0])
    padded = np.column_stack([shapes[:, :2], np.zeros((len(shapes), 2))])
    return padded[:, 0], padded[:, 1]


def _similar_features(at: Array, seen: NDArray[np.float32], min_shift: float) -> tuple[NDArray, NDArray]:
    """Features, and for each the most similar one elsewhere in the image."""
    lengths, pairs = (seen**2).sum(axis=1), [np.zeros((0, 2), np.int64)]
    for start in range(0, len(at), AT_ONCE):
        rows = slice(start, start + AT_ONCE)
        off = lengths[rows, None] + lengths - 2 * seen[rows] @ seen.T  # integers below 2^24, hence exact
        off[((at[rows, None] - at) ** 2).sum(axis=2) < min_shift**2] = np.inf
        nearest = off.argmin(axis=1)
        similar = np.flatnonzero(off[np.arange(len(off)), nearest] < MAX_DESCRIPTOR_DISTANCE**2)
        pairs.append(np.column_stack([similar + start, nearest[similar]]))
    first, second = np.concatenate(pairs).T
    return first, second


def _common_shifts(first: Array, second: Array, at: Array, size: tuple[int, int]) -> Array:
    """Shifts between similar features with enough votes, in both directions, that with the most votes first."""
    chosen = np.unique(np.linspace(0, len(first) - 1, MAX_VOTES).astype(int)) if len(first) else []
    first, second = first[chosen], second[chosen]
    votes = np.concatenate([second - first, first - second])
    agree = (
        np.linalg.norm(votes[:, None] - votes, axis=2) < MAX_SHIFT_DIFFERENCE * np.linalg.norm(votes, axis=1)[:, None]
    )
    free, shifts, most, tree = np.ones(len(votes), bool), [], 0, KDTree(second.reshape(-1, 2))
    for _ in range(MAX_SHIFTS if len(votes) else 0):
        counts = (agree & free).sum(axis=1) * free
        best = int(counts.argmax())
        most = max(most, counts[best])
        if counts[best] < max(MIN_VOTES, MIN_OF_BEST * most):
            break
        members = agree[best] & free
        shift = np.median(votes[members], axis=0)
        free &= ~members
        radius = MAX_SHIFT_DIFFERENCE * float(np.linalg.norm(shift))
        near = tree.query_ball_point(np.concatenate([first + shift, first - shift]), radius, return_length=True)
        chance = near.sum() / len(first)
        inside = ((at + shift >= 0) & (at + shift <= size)).all(axis=1)
        fits_twice = bool((2 * np.abs(shift) <= size).all())
        is_wide = fits_twice or counts[best] >= MIN_COVERAGE * inside.sum()
        if counts[best] >= MIN_VOTES + (1.0 if is_wide else MIN_OF_CHANCE) * chance:
            shifts.append(shift)
    return np.array(shifts).reshape(-1, 2)


def _distances(first: NDArray, second: NDArray) -> Array:
    """Distances of descriptors."""
    return np.linalg.norm(first.astype(np.float64) - second.astype(np.float64), axis=1)


def _baselines(model: SfmModel, images: Sequence[_Image], repeating: Sequence[int]) -> float:
    """The period relative to the distance of the nearest camera."""
    shifts = []
    for k in repeating:
        rows = model.observations[:, 0] == k
        points = model.points[model.observations[rows, 1]]
        depth = float(np.median(points @ model.T_camera_world[k, 2, :3] + model.T_camera_world[k, 2, 3]))
        distances = np.linalg.norm(model.centers - model.centers[k], axis=1)
        nearest = float(np.min(distances[np.arange(len(model)) != k], initial=np.inf))
        if len(points) and depth > 0 and nearest > 0:
            shifts.append(images[k].shift * depth / focal_of(model.cameras[k]) / nearest)
    return float(np.median(shifts)) if shifts else math.nan
