"""Similarity transforms of SfM models: scale from a known distance, and georeferencing by camera positions.

Umeyama 1991 (fit). Fischler and Bolles 1981 (RANSAC). Rousseeuw 1984 (least median of squares).
"""

from __future__ import annotations

import itertools
import math
import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.image_names import ImageNames
from ...cameras.trajectory import Trajectory, read_trajectory
from ...core.attribute_hints import nearest_name
from ...core.checks import check_finite, check_list, check_name, check_positive, check_seed, check_shape, shown
from ...core.errors import FileError
from ...core.matched_counts import why_few_matched
from ...core.paths import path_of
from ...core.reports import AssessedRecord, failed
from ...io.ascii_rows import is_float
from ...io.models.sfm_model import SfmModel
from ...io.number_tables import SYNONYMS, TableForm, read_number_table, table_lines
from ...kernels.linear_algebra import det, matmul, norm
from ..rigid import fit_pose, scale_of

MIN_PAIRS = 3  # minimum pairs. They leave 2 of 9 numbers, so their residuals are small even if one is wrong
MAX_ROTATION_UNCERTAINTY = 5.0  # [degrees] 9 cm per meter from the cameras
MAX_TRIPLES = 2000  # with half outliers, one triple of eight is correct
TRIPLES_PER_BLOCK = 256  # triples per block
OUTLIER_SIGMAS = 2.5  # outlier threshold in standard deviations
TO_SIGMA = 1.4826  # MAD to standard deviation
MAX_REFITS = 20  # refits to the inliers
MIN_LATERAL_RATIO = 1e-6  # relative lateral extent below which cameras are collinear
ROUND_OFF = 1e-14  # float64 rounding relative to the coordinates
EXACT_RATIO = 1e-9  # relative to the extent: smaller errors are rounding

_NUMBER = re.compile(r"\d+(?:\.\d+)?")
_NAMES = SYNONYMS["name"] + " image image_name file filename file_name photo"
FORM = TableForm(("name x y z",), synonyms={"name": _NAMES}, are_names_joined=True)


@dataclass(frozen=True)
class SimilarityFit(AssessedRecord):
    """Similarity that aligns a model with given positions.

    Attributes:
        transformation: T_world_model with scale, float64 [4, 4], for `SfmModel.transform`.
        scale: World units per model unit.
        names: The images with given positions, sorted.
        residuals: Distance of each camera from its given position, shape [n] [world unit].
        inliers: Mask of the positions used by the fit, shape [n].
        rmse: Root mean square residual of the inliers.
        rotation_uncertainty: Standard deviation [degrees] of the rotation about the least determined axis.
        possible_count: Number of images that could have a position: all images, or all given positions if fewer.
        reliable, warnings: True if all quality checks passed, and those that failed.
    """

    transformation: NDArray[np.float64]
    scale: float
    names: tuple[str, ...]
    residuals: NDArray[np.float64]
    inliers: NDArray[np.bool_]
    rmse: float
    rotation_uncertainty: float
    possible_count: int = 0

    @property
    def warnings(self) -> tuple[str, ...]:
        count, used = len(self.names), int(self.inliers.sum())
        remedy = "use the names or numbers of the images"
        few_names = why_few_matched(count, self.possible_count, "positions have the name of an image", remedy)
        outliers = why_few_matched(
            used, count, "positions agree with the model", "check them, or use a larger max_error"
        )
        redundant = None
        if used == MIN_PAIRS:
            redundant = f"the fit to {used} positions cannot be checked: give more"
        turned = None
        if self.rotation_uncertainty > MAX_ROTATION_UNCERTAINTY:
            degrees = f"{self.rotation_uncertainty:.2g} degrees"
            turned = f"the positions determine the rotation only to {degrees}: give positions farther from the line"
        return failed(few_names, outliers, redundant, turned)


def scale_from_known(model: SfmModel, a: str | ArrayLike, b: str | ArrayLike, distance: float) -> float:
    """Compute the scale factor of a model from a known distance.

    Args:
        model: The model.
        a, b: Image names (their camera positions), or points of the model, shape [3].
        distance: Distance between the two [m], > 0.

    Returns:
        The factor for `SfmModel.scaled`, which makes the model's unit the meter.

    Raises:
        TypeError: Not an SfmModel, or neither names nor positions.
        KeyError: No image has the name.
        ValueError: Identical positions, or a distance that is not positive.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])
        >>> poses = np.tile(np.eye(4), (2, 1, 1))
        >>> poses[1, 0, 3] = -0.5
        >>> model = loom.SfmModel(["a.png", "b.png"], [camera] * 2, poses)
        >>> loom.registration.scale_from_known(model, "a.png", "b.png", 1.0)
        2.0
    """
    _check_model(model)
    wanted = check_positive("distance", distance, maximum=1e30)
    positions = [_position_of(model, name, value) for name, value in (("a", a), ("b", b))]
    measured = float(norm(positions[1] - positions[0]))
    extent = max(float(np.abs(position).max()) for position in positions)
    if not measured > EXACT_RATIO * extent:
        raise ValueError("a, b: expected two different positions in the model, got equal ones")
    return wanted / measured


def _position_of(model: SfmModel, name: str, value: str | ArrayLike) -> NDArray[np.float64]:
    if isinstance(value, str):
        if value not in model.names:
            raise KeyError(f"{name}: no image {shown(value)}{nearest_name(value, model.names)}")
        return model.centers[model.index_of(value)]
    return check_finite(name, check_shape(name, value, (3,)))


def fit_to_positions(
    model: SfmModel, positions: Mapping[str, ArrayLike], *, max_error: float | None = None, seed: int = 0
) -> SimilarityFit:
    """Fit the similarity that aligns the cameras of a model with given positions.

    Args:
        model: The model.
        positions: Position by image name, shape [3] each [m]. Unknown names are ignored.
        max_error: Maximum residual of an inlier [m]; None: estimated, if more than half of the positions are correct.
        seed: Seed for the choice of triples if there are too many.

    Returns:
        The fit, with the residual of each camera.

    Raises:
        TypeError: Not an SfmModel, or no mapping from names to positions.
        ValueError: Fewer than 3 known positions or inliers, collinear or identical cameras, or non-finite positions.

    Notes:
        On the host in float64. Up to 2000 triples. Reproducible.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])
        >>> poses = np.tile(np.eye(4), (4, 1, 1))
        >>> poses[1:, :3, 3] = -np.eye(3)
        >>> model = loom.SfmModel(["a", "b", "c", "d"], [camera] * 4, poses)
        >>> known = {"a": (1, 0, 0), "b": (3, 0, 0), "c": (1, 2, 0), "d": (1, 0, 2)}
        >>> fit = loom.registration.fit_to_positions(model, known)
        >>> round(fit.scale, 6), (model.transform(fit.transformation).centers[1].round(6) + 0.0).tolist()
        (2.0, [3.0, 0.0, 0.0])
    """
    _check_model(model)
    if not isinstance(positions, Mapping):
        raise TypeError(f"positions: expected a mapping from names to positions, got {type(positions).__name__}")
    limit = None if max_error is None else check_positive("max_error", max_error, allow_zero=True, maximum=1e30)
    seed = check_seed(seed)
    names = tuple(name for name in model.names if name in positions)
    if len(names) < MIN_PAIRS:
        raise ValueError(f"positions: expected those of at least {MIN_PAIRS} images of the model, got {len(names)}")
    target = np.array([check_finite("positions", check_shape("positions", positions[n], (3,))) for n in names])
    source = model.centers[[model.index_of(name) for name in names]]
    _check_spread("model", source)
    _check_spread("positions", target)
    T, limit = _best_of_triples(source, target, limit, seed)
    T, inliers = _refine(source, target, T, limit)
    if inliers.sum() < MIN_PAIRS:
        raise ValueError(
            f"max_error: only {inliers.sum()} of {len(names)} cameras agree to {limit:.4g}; give a larger one"
        )
    _check_spread("positions", source[inliers])
    residuals = _distances(source, target, T)
    rmse = math.sqrt(float((residuals[inliers] ** 2).mean()))
    scale = scale_of(T)
    uncertainty = _uncertainty(scale * source[inliers], rmse)
    possible = min(len(model.names), len(positions))
    return SimilarityFit(T, scale, names, residuals, inliers, rmse, uncertainty, possible)


def _check_model(model: object) -> None:
    if not isinstance(model, SfmModel):
        raise TypeError(f"model: expected an SfmModel, got {type(model).__name__}")


def _check_spread(name: str, positions: NDArray[np.float64]) -> None:
    spread = np.linalg.svd(positions - positions.mean(axis=0), compute_uv=False)
    if not spread[1] > MIN_LATERAL_RATIO * spread[0]:
        what = "at one position" if not spread[0] > 0 else "on a line"
        raise ValueError(
            f"{name}: expected cameras that are spread out, got all {what}, which leaves the rotation undetermined"
        )


def _best_of_triples(
    source: NDArray[np.float64], target: NDArray[np.float64], limit: float | None, seed: int
) -> tuple[NDArray[np.float64], float]:
    count = len(source)
    best, chosen = (math.inf, math.inf), None
    floor = EXACT_RATIO * float(np.abs(target - target.mean(axis=0)).max()) + ROUND_OFF * float(np.abs(target).max())
    for triples in _triples(count, seed):
        fits = _fit_triples(source[triples], target[triples])
        gaps = np.einsum("kij,nj->kni", fits[:, :3, :3], source) + fits[:, None, :3, 3] - target
        squares = (gaps * gaps).sum(axis=2)
        squares[~np.isfinite(squares)] = np.inf
        middle = np.sort(squares, axis=1)[:, count // 2]
        if limit is None:
            scores = np.stack([middle, middle], axis=1)
        else:
            within = squares <= max(limit, floor) ** 2
            scores = np.stack([-within.sum(axis=1), np.where(within, squares, 0.0).sum(axis=1)], axis=1)
        k = int(np.lexsort((scores[:, 1], scores[:, 0]))[0])
        if tuple(scores[k]) < best:
            best, chosen = tuple(scores[k]), fits[k]
    if chosen is None:
        raise ValueError("positions: expected cameras that are spread out, also in the model, got no such three")
    if limit is None:
        # small sample correction of the median (Rousseeuw and Leroy 1987)
        slack = 1.0 + 5.0 / max(count - MIN_PAIRS, 1)
        limit = OUTLIER_SIGMAS * TO_SIGMA * slack * math.sqrt(best[0])
    return chosen, max(limit, floor)


def _triples(count: int, seed: int):
    if math.comb(count, 3) <= MAX_TRIPLES:
        every = np.array(list(itertools.combinations(range(count), 3)))
    else:
        rng = np.random.Generator(np.random.PCG64(seed))
        every = rng.integers(0, count, (MAX_TRIPLES, 3))
        every = every[(every[:, 0] != every[:, 1]) & (every[:, 1] != every[:, 2]) & (every[:, 0] != every[:, 2])]
    for begin in range(0, len(every), TRIPLES_PER_BLOCK):
        yield every[begin : begin + TRIPLES_PER_BLOCK]


def _fit_triples(source: NDArray[np.float64], target: NDArray[np.float64]) -> NDArray[np.float64]:
    """Similarities of many triples, [k, 3, 3] each. Umeyama 1991, eqs. 40 to 43."""
    means = source.mean(axis=1), target.mean(axis=1)
    s, t = source - means[0][:, None], target - means[1][:, None]
    U, D, Vt = np.linalg.svd(matmul(t.transpose(0, 2, 1), s))
    signs = np.ones((len(s), 3))
    signs[:, 2] = np.sign(det(matmul(U, Vt)))
    R = matmul(U * signs[:, None], Vt)
    with np.errstate(all="ignore"):
        scale = (D * signs).sum(axis=1) / (s * s).sum(axis=(1, 2))
        scale[~((D[:, 1] > MIN_LATERAL_RATIO * D[:, 0]) & (scale > 0))] = np.nan  # collinear
        T = np.tile(np.eye(4), (len(s), 1, 1))
        T[:, :3, :3] = scale[:, None, None] * R
        T[:, :3, 3] = means[1] - np.einsum("kij,kj->ki", T[:, :3, :3], means[0])
    return T


def _refine(
    source: NDArray[np.float64], target: NDArray[np.float64], T: NDArray[np.float64], limit: float
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    inliers = _distances(source, target, T) <= limit
    for _ in range(MAX_REFITS):
        if inliers.sum() < MIN_PAIRS:
            break
        T = fit_pose(source[inliers], target[inliers], with_scaling=True)
        agree = _distances(source, target, T) <= limit
        if (agree == inliers).all():
            break
        inliers = agree
    return T, inliers


def _distances(source: NDArray[np.float64], target: NDArray[np.float64], T: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.linalg.norm(matmul(source, T[:3, :3].T) + T[:3, 3] - target, axis=1)


def _uncertainty(positions: NDArray[np.float64], rmse: float) -> float:
    """Standard deviation of the least determined angle [degrees]."""
    spread = np.linalg.svd(positions - positions.mean(axis=0), compute_uv=False)
    return math.degrees(rmse / math.sqrt(3.0) / math.hypot(spread[1], spread[2]))


def read_positions(path: str | os.PathLike[str], names: Sequence[str]) -> dict[str, NDArray[np.float64]]:
    """Read the positions of images from a file.

    Args:
        path: Lines of `name x y z` (separated by blanks, commas, semicolons or tabs; names with or without folder and
            extension, or image numbers), or a trajectory as of `read_trajectory`. A header names the columns in any
            order: name or image, x or easting, y or northing, z or height. Unknown columns are ignored with a warning.
            Numbers may have decimal commas if semicolons or tabs separate them.
        names: Image names of the model.

    Returns:
        Positions by name. Trajectory poses are assigned by the last number in the image names (first pose id or time),
        else by order if there is one pose per image.

    Raises:
        FileError: Unreadable, a malformed line, a duplicate or ambiguous name, or no name or pose of the model.
        TypeError: `names` is not a list of strings.

    Example:
        >>> from pathlib import Path
        >>> import pointloom as loom
        >>> from pointloom.registration.trajectories.similarity import read_positions
        >>> _ = Path("gps.txt").write_text("porch 1 0 0\\ngarden 3 0 0\\n")
        >>> positions = read_positions("gps.txt", ["0001_garden.jpg", "0002_porch.jpg"])
        >>> positions["0001_garden.jpg"].tolist()
        [3.0, 0.0, 0.0]
    """
    path = path_of(path)
    names = tuple(check_name(f"names[{k}]", name) for k, name in enumerate(check_list("names", names, "names")))
    if path.suffix.lower() not in (".log", ".json") and not _is_trajectory(path):
        return _named_positions(path, names)
    trajectory = read_trajectory(path)
    return _positions_of(path, trajectory, names)


def _is_trajectory(path: Path) -> bool:
    """True if all lines have the 8 columns of TUM or the 12 of KITTI, or there are none."""
    lines = [line for line in table_lines(path) if line.strip() and not line.lstrip().startswith("#")]
    widths = {len(line.split()) for line in lines}
    return widths <= {8} or widths <= {12}


def _named_positions(path: Path, names: tuple[str, ...]) -> dict[str, NDArray[np.float64]]:
    positions: dict[str, NDArray[np.float64]] = {}
    images = ImageNames(names)
    for number, words, numbers in read_number_table(path, FORM):
        given, position = words["name"], np.array([numbers[axis] for axis in "xyz"])
        meant = [names[k] for k in images.matching(given)]
        shorter, _, last = given.rpartition(" ")
        if is_float(last) and images.matching(shorter) and given not in {Path(name).stem for name in meant}:
            reason = f"expected name x y z, got {given!r} as the name"
            raise FileError(path, reason, where=f"line {number}", remedy="Remove other columns, or add a header")
        if len(meant) > 1:
            reason = f"{given!r} may be {' or '.join(meant[:3])}"
            raise FileError(path, reason, where=f"line {number}", remedy="Write the names in full")
        if not meant:
            continue  # an unregistered image
        if meant[0] in positions:
            raise FileError(path, f"the image {meant[0]!r} is duplicated", where=f"line {number}")
        positions[meant[0]] = position
    if not positions:
        remedy = f"Names are those of the images, such as {names[0]!r}" if names else ""
        raise FileError(path, "contains no name of an image of the model", remedy=remedy)
    return positions


def _positions_of(path: Path, trajectory: Trajectory, names: tuple[str, ...]) -> dict[str, NDArray[np.float64]]:
    keys = trajectory.timestamps if trajectory.ids is None else trajectory.ids[:, 0].astype(np.float64)
    numbers = [float(digits[-1]) if (digits := _NUMBER.findall(Path(name).stem)) else math.nan for name in names]
    if keys is not None and len(set(numbers)) == len(names) and len(set(keys.tolist())) == len(keys):
        rows = {key: row for row, key in enumerate(keys.tolist())}
        positions = {n: trajectory.poses[rows[k], :3, 3] for n, k in zip(names, numbers, strict=True) if k in rows}
        if len(positions) >= MIN_PAIRS:
            return positions
    if len(trajectory) == len(names):
        return {name: T[:3, 3] for name, T in zip(names, trajectory.poses, strict=True)}
    reason = f"{len(trajectory)} poses, whose ids or times are not the numbers in the names of the {len(names)} images"
    raise FileError(path, reason, remedy="Write lines of `name x y z` instead")
