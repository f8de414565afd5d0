"""Records of COLMAP files and their conversion to and from a model.

Observations are stored twice, in image keypoints and point tracks. Both are checked against each other.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera_models import PIXEL_OFFSET, CameraModel
from ...core.errors import FileError
from ...core.quaternions import nearest_rotations, quaternions_to_rotations, rotations_to_quaternions
from .sfm_model import SfmModel

NO_POINT = -1  # point id of a keypoint without a point
MAX_COORDINATE = 1e100  # larger values overflow in products of three
MAX_NORM_ERROR = 1e-2  # maximum deviation of a quaternion's length from 1: text with four decimals leaves 1e-4

MAX_TABLE_IDS = 1 << 20  # ids that a lookup table may cover in any case

CUT = "The file may be cut off or damaged; write the model again"
MIXED = "The files may be of different models"


@dataclasses.dataclass
class Image:
    """A record of images.bin or images.txt, with quaternion w, x, y, z and translation world to camera.
    `keypoints` are their pixels (k, 2), `points` their point ids (k,), -1 for none; `where` is the location in
    the file."""

    number: int
    name: str
    quaternion: tuple[float, ...]
    translation: tuple[float, ...]
    camera: int
    keypoints: NDArray[np.float64]
    points: NDArray[np.int64]
    where: str


@dataclasses.dataclass
class Points:
    """All records of points3D.bin or points3D.txt as columns: point ids `numbers` (m,), track `lengths` (m,).
    `tracks` (sum, 2) are concatenated: image id, keypoint index."""

    numbers: NDArray[np.int64]
    positions: NDArray[np.float64]
    colors: NDArray[np.uint8]
    errors: NDArray[np.float64]
    lengths: NDArray[np.int64]
    tracks: NDArray[np.int64]
    where: Any


def camera_of(path: Path, where: str, model: str, width: int, height: int, params: Any) -> CameraModel:
    try:
        return CameraModel(model, width, height, tuple(params))
    except (TypeError, ValueError) as error:
        raise FileError(path, str(error), where=where) from error


def assemble(
    paths: dict[str, Path],
    cameras: dict[int, CameraModel],
    images: list[Image],
    points: Points,
    poses: NDArray[np.float64] | None = None,
) -> SfmModel:
    """Build the model from records; `paths` by "cameras", "images" and "points3D" are for errors.
    `poses` (n, 4, 4) replace those of the image records."""
    source, sparse = paths["images"], paths["points3D"]
    if not images:
        raise FileError(
            source, "contains no image", remedy="Mapping registered none, or the model was written before it finished"
        )
    _check_images(source, paths["cameras"], cameras, images)
    order, rows = _check_points(sparse, points)
    numbers = points.numbers[order]
    counts = np.array([len(p.points) for p in images])
    starts = np.concatenate([[0], np.cumsum(counts)])
    owners, keypoints = np.concatenate([p.points for p in images]), np.concatenate([p.keypoints for p in images])
    observed = np.flatnonzero(owners != NO_POINT)
    observers = np.repeat(np.arange(len(images)), counts)[observed]
    seen = _find_numbers(numbers, owners[observed])
    lost = np.flatnonzero(seen < 0)
    if len(lost):
        image, number = images[observers[lost[0]]], owners[observed][lost[0]]
        reason = f"image {image.name!r} observes point {number}, which is missing in {sparse.name}"
        raise FileError(source, reason, where=image.where, remedy=MIXED)
    _check_tracks(sparse, points, rows, images, starts, owners)
    if len(observed) != len(points.tracks):
        reason = f"{len(observed)} keypoints belong to points, but the tracks have {len(points.tracks)}"
        raise FileError(sparse, reason, remedy=MIXED)
    pixels = keypoints[observed] - PIXEL_OFFSET
    wrong = np.flatnonzero(~(np.abs(pixels) <= MAX_COORDINATE).all(axis=1))
    if len(wrong):
        image = images[observers[wrong[0]]]
        raise FileError(source, f"a keypoint of {image.name!r} is not finite", where=image.where, remedy=CUT)
    return SfmModel(
        tuple(p.name for p in images),
        tuple(cameras[p.camera] for p in images),
        _poses(source, images) if poses is None else poses,
        points.positions[order],
        points.colors[order],
        np.where(points.errors[order] >= 0, points.errors[order], np.nan),  # COLMAP writes -1 if unknown
        np.stack([observers, seen], axis=1),
        pixels,
    )


def _check_images(source: Path, path: Path, cameras: dict[int, CameraModel], images: list[Image]) -> None:
    names: dict[str, Image] = {}
    numbers: set[int] = set()
    for image in images:
        if image.number in numbers:
            raise FileError(source, f"the image number {image.number} is duplicated", where=image.where)
        if image.name in names:
            raise FileError(source, f"the image {image.name!r} is duplicated", where=image.where)
        if not image.name:
            raise FileError(source, "an image has no name", where=image.where, remedy=CUT)
        if image.camera not in cameras:
            reason = f"image {image.name!r} refers to camera {image.camera}, which is missing in {path.name}"
            raise FileError(source, reason, where=image.where, remedy=MIXED)
        numbers.add(image.number)
        names[image.name] = image


def _poses(path: Path, images: list[Image]) -> NDArray[np.float64]:
    quaternions = np.array([p.quaternion for p in images])
    translations = np.array([p.translation for p in images])
    return poses_of(path, quaternions, translations, lambda i: (f"image {images[i].name!r}", images[i].where))


def poses_of(
    path: Path,
    quaternions: NDArray[np.float64],
    translations: NDArray[np.float64],
    title: Callable[[int], tuple[str, str]],
) -> NDArray[np.float64]:
    """Poses (n, 4, 4) of quaternions w, x, y, z; `title` returns the name of a row and where it is, for errors."""
    with np.errstate(all="ignore"):
        lengths = np.sqrt((quaternions * quaternions).sum(axis=1))
        good = (np.abs(lengths - 1) <= MAX_NORM_ERROR) & (np.abs(translations) <= MAX_COORDINATE).all(axis=1)
    for i in np.flatnonzero(~good):
        what, where = title(int(i))
        pose = f"quaternion {tuple(quaternions[i].tolist())}, translation {tuple(translations[i].tolist())}"
        raise FileError(path, f"{what} has no pose: {pose}", where=where, remedy="Quaternions are w x y z of length 1")
    poses = np.tile(np.eye(4), (len(quaternions), 1, 1))
    poses[:, :3, :3] = quaternions_to_rotations((quaternions / lengths[:, None])[:, [1, 2, 3, 0]])
    poses[:, :3, 3] = translations
    return poses


def _check_points(path: Path, points: Points) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Rows of points sorted by id, and the rank of each row."""
    for what, values in (("a position", points.positions), ("an error", points.errors[:, None])):
        wrong = np.flatnonzero(~(np.abs(values) <= MAX_COORDINATE).all(axis=1))
        if len(wrong):
            row = int(wrong[0])
            raise FileError(path, f"{what} is not finite: {values[row].tolist()}", where=points.where(row), remedy=CUT)
    order = np.argsort(points.numbers, kind="stable")
    ascending = points.numbers[order]
    twice = np.flatnonzero(ascending[1:] == ascending[:-1])
    if len(twice):
        row = int(order[twice[0] + 1])
        raise FileError(path, f"the point number {points.numbers[row]} is duplicated", where=points.where(row))
    rows = np.empty(len(order), np.int64)
    rows[order] = np.arange(len(order))
    return order, rows


def _find_numbers(numbers: NDArray[np.int64], wanted: NDArray[np.int64]) -> NDArray[np.int64]:
    if not len(numbers):
        return np.full(len(wanted), -1)
    if numbers[0] >= 0 and numbers[-1] < 8 * len(numbers) + MAX_TABLE_IDS:  # a table is four times faster than a search
        table = np.full(int(numbers[-1]) + 2, -1)
        table[numbers] = np.arange(len(numbers))
        return table[np.where((wanted >= 0) & (wanted <= numbers[-1]), wanted, numbers[-1] + 1)]
    at = np.searchsorted(numbers, wanted).clip(0, len(numbers) - 1)
    return np.where(numbers[at] == wanted, at, -1)


def _check_tracks(
    path: Path,
    points: Points,
    rows: NDArray[np.int64],
    images: list[Image],
    starts: NDArray[np.int64],
    owners: NDArray[np.int64],
) -> None:
    tracks = points.tracks
    if not len(tracks):
        return
    of_tracks = np.repeat(np.arange(len(rows)), points.lengths)
    numbers = np.array([p.number for p in images])
    by_number = np.argsort(numbers)
    at = _find_numbers(numbers[by_number], tracks[:, 0])
    image = by_number[at]
    wrong = (at < 0) | (tracks[:, 1] >= np.diff(starts)[image]) | (tracks[:, 1] < 0)
    keypoint = np.where(wrong, 0, starts[image] + tracks[:, 1])
    wrong |= owners[keypoint] != points.numbers[of_tracks] if len(owners) else True
    first = np.flatnonzero(wrong)
    if len(first):
        row = int(of_tracks[first[0]])
        number, index = tracks[first[0]].tolist()
        reason = (
            f"point {points.numbers[row]} is observed as keypoint {index} of image {number}, which does not refer to it"
        )
        raise FileError(path, reason, where=points.where(row), remedy=MIXED)


@dataclasses.dataclass
class Records:
    """A model with COLMAP's ids, from 1, and unique `cameras` in image order.
    `starts` (n + 1,) is the first observation of each image, `order` (k,) the observations sorted by point,
    `track_starts` (m + 1,) the start of each track, `tracks` (k, 2) image id and keypoint index. Quaternions are w, x,
    y, z. Unknown errors are -1."""

    model: SfmModel
    cameras: list[CameraModel]
    camera_numbers: list[int]
    quaternions: NDArray[np.float64]
    starts: NDArray[np.int64]
    keypoints: NDArray[np.float64]
    track_starts: NDArray[np.int64]
    tracks: NDArray[np.int64]
    errors: NDArray[np.float64]


def records_of(model: SfmModel) -> Records:
    cameras = list(dict.fromkeys(model.cameras))
    numbers = {camera: i for i, camera in enumerate(cameras, 1)}
    images, points = model.observations.T
    starts = np.searchsorted(images, np.arange(len(model) + 1))
    order = np.argsort(points, kind="stable")
    tracks = np.stack([images + 1, np.arange(len(images)) - starts[images]], axis=1)[order]
    return Records(
        model,
        cameras,
        [numbers[camera] for camera in model.cameras],
        rotations_to_quaternions(nearest_rotations(model.T_camera_world[:, :3, :3]))[:, [3, 0, 1, 2]],
        starts,
        model.pixels + PIXEL_OFFSET,
        np.concatenate([[0], np.cumsum(model.view_counts)]),
        tracks,
        np.where(np.isnan(model.errors), -1.0, model.errors),
    )
