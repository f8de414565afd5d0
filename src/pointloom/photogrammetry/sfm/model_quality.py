"""Quality of SfM models: triangulation angles, and whether a purely rotating camera explains the images.

A rotating camera with a wrong focal length can yield a false model with large angles and small residuals. So a pure
rotation with free focal length and radial distortion is fitted: if it explains the images, depth is undetermined.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count, check_list
from ...core.reports import Assessed, quality
from ...io.models.sfm_model import SfmModel
from .camera_check import CameraCheck
from .pose_check import PoseCheck
from .repetition_check import RepetitionCheck

Array = NDArray[np.float64]

_MAX_RAYS = 1 << 20  # rays compared at once: 24 MB, and the products of a point
_MAX_PAIRS = 40  # image pairs tested for pure rotation
_MAX_SHARED = 120  # points per pair
_FEW_SHARED = 20
_LOG_FACTORS = (-np.log(2.0), np.log(2.0))  # focal length factors of the rotation test
_MAX_DISTORTION = 0.5
_SEARCH_STEPS, _SEARCH_ROUNDS = 9, 5  # values of both per round, and rounds, each with a third of the previous range
_RANGE_REDUCTION = 3.0


def triangulation_angles(model: SfmModel) -> Array:
    """The widest angle between two rays of each point, shape [m] [degrees]. 0 for a single ray."""
    angles = np.zeros(len(model.points))
    order = np.argsort(model.observations[:, 1], kind="stable")
    images, points = model.observations[order].T
    rays = model.centers[images] - model.points[points]
    rays /= np.maximum(np.linalg.norm(rays, axis=1, keepdims=True), np.finfo(np.float64).tiny)
    counts = np.bincount(points, minlength=len(angles))
    starts = np.cumsum(counts) - counts
    for count in np.unique(counts[counts > 1]):
        chosen = np.flatnonzero(counts == count)
        for part in np.array_split(chosen, -(-len(chosen) * int(count) ** 2 // _MAX_RAYS)):
            these = rays[starts[part][:, None] + np.arange(count)]
            cosines = np.einsum("kid,kjd->kij", these, these).min(axis=(1, 2))
            angles[part] = np.degrees(np.arccos(np.clip(cosines, -1.0, 1.0)))
    return angles


def parallax(model: SfmModel, *, fixed: bool = False) -> float:
    """Parallax that no pure rotation explains [px], with a common focal length and distortion unless `fixed`."""
    pairs = _far_pairs(model)
    if not pairs:
        return float("nan")
    first, second, weights = _rays_of(model, pairs)
    focal = float(np.median([camera.params[0] for camera in model.cameras]))
    if fixed:
        return float(focal * _turning_error(first, second, weights, 1.0, 0.0))
    center, half_range = [0.0, 0.0], (_LOG_FACTORS[1], _MAX_DISTORTION)
    best = float("inf")
    for _ in range(_SEARCH_ROUNDS):
        logs = np.clip(np.linspace(center[0] - half_range[0], center[0] + half_range[0], _SEARCH_STEPS), *_LOG_FACTORS)
        bends = np.linspace(center[1] - half_range[1], center[1] + half_range[1], _SEARCH_STEPS)
        tried = [(_turning_error(first, second, weights, np.exp(a), b), a, b) for a in logs for b in bends]
        error, *center = min(tried)
        best = min(best, error)
        half_range = (half_range[0] / _RANGE_REDUCTION, half_range[1] / _RANGE_REDUCTION)
    return float(focal * best)


def _far_pairs(model: SfmModel) -> list[tuple[int, int]]:
    count = max(len(model.points), 1)
    at = np.sort(model.observations @ (count, 1))
    images, points = np.divmod(at[np.diff(at, prepend=-1) > 0], count)  # a point may be observed twice in an image
    pairs = set()
    for image in np.unique(np.linspace(0, len(model) - 1, _MAX_PAIRS).round().astype(int)) if len(model) else ():
        seen = np.zeros(len(model.points), bool)
        seen[points[images == image]] = True
        shared = np.bincount(images[seen[points]], minlength=len(model))
        distances = np.linalg.norm(model.centers - model.centers[image], axis=1)
        # The farthest of all may share only a corner, whose points may be equally distant.
        worth = np.where(shared < _FEW_SHARED, -1.0, distances * np.sqrt(shared))
        worth[image] = -1.0
        other = int(np.argmax(worth))
        if worth[other] >= 0:
            pairs.add((min(int(image), other), max(int(image), other)))
    return sorted(pairs)


def _rays_of(model: SfmModel, pairs: list[tuple[int, int]]) -> tuple[Array, Array, Array]:
    """Normalized positions of the shared points of each pair, twice [p, s, 2], and weights [p, s]."""
    first = np.zeros((len(pairs), _MAX_SHARED, 2))
    second, weights = first.copy(), np.zeros(first.shape[:2])
    for k, pair in enumerate(pairs):
        rows = [np.flatnonzero(model.observations[:, 0] == image) for image in pair]
        seen, seen_beside = (model.observations[r, 1] for r in rows)
        _, at, beside = np.intersect1d(seen, seen_beside, return_indices=True)
        some = np.unique(np.linspace(0, len(at) - 1, _MAX_SHARED).round().astype(int))
        for rays, image, chosen in ((first, pair[0], rows[0][at[some]]), (second, pair[1], rows[1][beside[some]])):
            rays[k, : len(some)] = model.cameras[image].unproject(model.pixels[chosen])[:, :2]
        weights[k, : len(some)] = 1.0
    weights[~np.isfinite(first + second).all(axis=2)] = 0.0  # outside the valid lens area
    return np.nan_to_num(first), np.nan_to_num(second), weights


def _turning_error(first: Array, second: Array, weights: Array, factor: float, distortion: float) -> float:
    """Median error over pairs of the best rotations, in normalized coordinates."""
    a, b = (_bent(rays, factor, distortion) for rays in (first, second))
    products = np.einsum("ps,psi,psj->pij", weights, b / _length(b), a / _length(a))
    u, _, vt = np.linalg.svd(products)
    flip = np.ones((len(u), 3))
    flip[:, 2] = np.sign(np.linalg.det(u @ vt))
    rotated = np.einsum("pij,psj->psi", (u * flip[:, None]) @ vt, a)
    off = rotated[..., :2] / np.maximum(rotated[..., 2:], 1e-3) - b[..., :2]
    count = np.maximum(weights.sum(axis=1), 1)
    return float(np.median(np.sqrt((weights * (off**2).sum(axis=2)).sum(axis=1) / count))) / factor


def _bent(rays: Array, factor: float, distortion: float) -> Array:
    radius = (rays**2).sum(axis=2, keepdims=True)
    bent = rays * factor * (1.0 + distortion * radius)
    return np.concatenate([bent, np.ones_like(radius)], axis=2)


def _length(rays: Array) -> Array:
    return np.linalg.norm(rays, axis=2, keepdims=True)


MIN_REGISTERED = 0.6  # fraction of the images
MIN_LARGEST_FRACTION = 0.95  # fraction in the largest model above which others are ignored: they overlap
MIN_ANGLE = 2.0  # [degrees] gives point depth within a few per cent
MIN_PARALLAX = 0.002  # relative to the longer side: a few pixels, several times the feature error
MAX_ERROR = 1.0  # [px] at feature extraction size. A correct lens gives 0.1 to 0.6
FINDING_SIZE = 1600  # [px] longer side for feature extraction
MIN_POINTS = 100
MIN_POINTS_A_IMAGE = 20

_MOVE = "move instead of only rotating: walk sideways around the scene"


@dataclasses.dataclass(frozen=True)
class ModelQuality(Assessed):
    """Quality of an SfM model.

    Args:
        image_count: Number of images.
        registered_count: Images with a pose.
        model_sizes: Images of each model, the largest first.
        point_count: Points.
        points_an_image: Median number of points per image.
        angle: Median over points of the widest triangulation angle [degrees]. NaN without points.
        parallax: Parallax that a pure rotation does not explain [px]. NaN if unknown.
        error: Median reprojection error [px]. NaN without points.
        warnings: Failed quality checks, each with its remedy. Empty if the model is reliable.
        focal: Check of the focal length. None if not done.
        poses: Check of given poses. None if they were estimated.
        repetition: Check for repeating structure, such as windows. None if not done.
    """

    image_count: int
    registered_count: int
    model_sizes: tuple[int, ...]
    point_count: int
    points_an_image: float
    angle: float
    parallax: float
    error: float
    warnings: tuple[str, ...]
    focal: CameraCheck | None = None
    poses: PoseCheck | None = None
    repetition: RepetitionCheck | None = None

    @property
    def notes(self) -> tuple[str, ...]:
        """Remarks that do not affect reliability, such as differing cameras or a focal length from EXIF."""
        return tuple(line for check in (self.focal, self.poses) if check is not None for line in check.notes())

    def to_dict(self) -> dict[str, Any]:
        fields = dataclasses.asdict(self) | {"model_sizes": list(self.model_sizes), **quality(self)}
        checks = {"focal": self.focal, "poses": self.poses, "repetition": self.repetition}
        fields |= {name: None if check is None else check.to_dict() for name, check in checks.items()}
        fields |= {"notes": list(self.notes)}
        numbers = {key: value for key, value in fields.items() if isinstance(value, float)}
        return fields | {key: None if math.isnan(value) else value for key, value in numbers.items()}

    @classmethod
    def from_json(cls, record: Mapping[str, Any]) -> ModelQuality:
        """The quality that `to_dict` wrote."""
        checks: dict[str, Any] = {"focal": CameraCheck, "poses": PoseCheck, "repetition": RepetitionCheck}
        names = [field.name for field in dataclasses.fields(cls) if field.name not in checks]
        fields: dict[str, Any] = {name: record[name] for name in names}
        fields |= {name: math.nan if fields[name] is None else fields[name] for name in ("angle", "parallax", "error")}
        fields |= {name: tuple(fields[name]) for name in ("model_sizes", "warnings")}
        for name, check in checks.items():
            found = record.get(name)  # missing in older records
            fields[name] = None if found is None else check.from_json(found)
        return cls(**fields)


def assess_model(
    model: SfmModel | None,
    image_count: int,
    *,
    model_sizes: Sequence[int] | None = None,
    fix_intrinsic: bool = False,
    focal: CameraCheck | None = None,
    poses: PoseCheck | None = None,
    repetition: RepetitionCheck | None = None,
) -> ModelQuality:
    """Assess a model: how many images have a pose, and how well they determine the depth of its points.

    Args:
        model: The model. None if there is none.
        image_count: Number of images.
        model_sizes: Images of each model, this one first; None: only this one.
        fix_intrinsic: The cameras were known. Otherwise pure rotation is tested with free intrinsics.
        focal: Focal length check of `map_images`. None if not done.
        poses: Pose check of `triangulate`.
        repetition: Check for repeating structure of `map_images`.

    Returns:
        The measures, and a warning for each failed check: fewer than 60% of the images have a pose; less than 95% with
        other models present; angles below 2 degrees, or pure rotation. A median error above one pixel (of larger
        images, one at 1600 px). A contradicted or undetermined focal length; poses that repeating structure leaves
        undetermined; too few points.

    Raises:
        TypeError, ValueError: Not a model, or counts that do not fit it.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.photogrammetry.sfm.model_quality import assess_model
        >>> found = assess_model(None, 12)
        >>> found.registered_count, found.warnings[0].split(":")[0]
        (0, 'none of the 12 images could be registered')
    """
    if model is not None and not isinstance(model, SfmModel):
        raise TypeError(f"model: expected an SfmModel or None, got {type(model).__name__}")
    if focal is not None and not isinstance(focal, CameraCheck):
        raise TypeError(f"focal: expected a ModelQuality's `focal` or None, got {type(focal).__name__}")
    if poses is not None and not isinstance(poses, PoseCheck):
        raise TypeError(f"poses: expected a ModelQuality's `poses` or None, got {type(poses).__name__}")
    if repetition is not None and not isinstance(repetition, RepetitionCheck):
        raise TypeError(f"repetition: expected a ModelQuality's `repetition` or None, got {type(repetition).__name__}")
    registered = 0 if model is None else len(model)
    check_count("image_count", image_count, minimum=registered)
    given = [registered] if model_sizes is None else check_list("model_sizes", model_sizes, "counts")
    sizes = tuple(check_count("model_sizes", size, minimum=0) for size in given if model is not None)
    if model is None:
        nothing = (
            f"none of the {image_count} images could be registered: no two of them share enough of the scene from "
            "positions far enough apart. Make sure that they overlap by two thirds, are sharp and show texture; "
            + _MOVE
        )
        return ModelQuality(image_count, 0, (), 0, 0.0, math.nan, math.nan, math.nan, (nothing,))
    seen = np.bincount(model.observations[:, 0], minlength=registered)
    errors = model.errors[np.isfinite(model.errors)]
    quality = ModelQuality(
        image_count,
        registered,
        sizes,
        len(model.points),
        float(np.median(seen)) if registered else 0.0,
        float(np.median(triangulation_angles(model))) if len(model.points) else math.nan,
        parallax(model, fixed=fix_intrinsic),
        float(np.median(errors)) if len(errors) else math.nan,
        (),
        focal,
        poses,
        repetition,
    )
    longer = max((max(camera.width, camera.height) for camera in model.cameras), default=1)
    return dataclasses.replace(quality, warnings=tuple(_warnings(quality, longer)))


def _warnings(quality: ModelQuality, longer_side: int) -> list[str]:
    reasons = [] if quality.poses is None else quality.poses.reasons(quality.registered_count)
    count, registered = quality.image_count, quality.registered_count
    if quality.poses is not None and quality.poses.are_wrong:
        return reasons
    if registered < MIN_REGISTERED * count and quality.poses is not None:
        reasons.append(f"only {registered} of {count} images have a pose: give the poses of the others too")
    elif registered < MIN_REGISTERED * count:
        remedy = "film more slowly, or take images that overlap by two thirds"
        reasons.append(f"only {registered} of {count} images could be registered: {remedy}")
    if registered < MIN_LARGEST_FRACTION * count and len(quality.model_sizes) > 1:
        sizes = ", ".join(map(str, quality.model_sizes))
        remedy = "take images that connect them"
        reasons.append(f"the images form {len(quality.model_sizes)} separate models ({sizes} images): {remedy}")
    if quality.parallax < MIN_PARALLAX * longer_side:
        off = f"a pure rotation explains the points to within {quality.parallax:.2g} px"
        reasons.append(f"the camera hardly moved ({off}), so depth is unknown: {_MOVE}")
    elif quality.angle < MIN_ANGLE:
        reasons.append(
            f"the triangulation angle is only {quality.angle:.2g} degrees (median), so depth is uncertain: {_MOVE}"
        )
    reasons += [] if quality.repetition is None else quality.repetition.reasons()
    reasons += (focal_reasons := [] if quality.focal is None else quality.focal.reasons())
    if not focal_reasons and quality.error > (max_error := MAX_ERROR * max(1.0, longer_side / FINDING_SIZE)):
        off = f"the reprojection error is {quality.error:.2g} px (median), more than {max_error:.2g} px"
        remedy = "do not zoom, keep the scene static, and give camera_model for a lens with strong distortion"
        what = f"no camera model fits the images; {remedy}"
        if quality.poses is not None:
            what = "the given poses and cameras are not more accurate; without them they are estimated"
        reasons.append(f"{off}: {what}")
    if quality.point_count < MIN_POINTS or quality.points_an_image < MIN_POINTS_A_IMAGE:
        each = f"{quality.points_an_image:.0f} per image"
        remedy = "take sharp images of a scene with texture"
        also = "" if reasons and reasons[-1].endswith(_MOVE) else f"; {_MOVE}"
        reasons.append(f"only {quality.point_count} points were triangulated, {each} (median): {remedy}{also}")
    return reasons
