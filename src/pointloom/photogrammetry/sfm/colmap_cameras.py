"""Camera checks of COLMAP models, run by `colmap_worker.py` in its process without imports of this package.

Tests whether several focal lengths explain the images better, whether a given focal length contradicts the images, and
whether they determine it at all (fixed at factors of the estimate, the error hardly rises for forward motion or nadir
views of flat ground). Uses a reproducible subset of points, and Ceres on one thread.
"""

from __future__ import annotations

import math
import sqlite3
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np

# Test factors of the focal length: 15% too short a flight over ground makes heights 15% too small.
FIXED_FACTORS = (0.85, 1.18)

# Minimum relative error decrease with one camera per image to try several cameras, as slow as the first mapping. Images
# of one camera have 1 to 4%.
WORTH_TRYING = 0.2
MUCH_BETTER = 2 / 3  # maximum relative error of a model with several cameras
SAME_LENS = 1.04  # focal lengths within this factor are one camera: single estimates are a few per cent off

# Rise of the error: below the first value the focal length is undetermined, above the second determined; between them
# parts of the images are left out.
MIN_ERROR_RISE, DETERMINED_ERROR_RISE = 0.002, 0.05
MAX_SPREAD = 0.025  # relative spread. Twice that (5%) is EXIF's error
GIVEN_WORSE = 0.8  # relative error with the preferred focal length that contradicts a given one
MAX_EXIF_RISE = 0.02  # maximum relative rise of the error with EXIF's focal length

_MAX_FOCAL_DIFFERENCE = 0.01  # relative difference of two focal lengths for square pixels
_AS_GOOD = 1.1  # maximum relative error of merged cameras

_MIN_POINTS = 30  # minimum points for the checks
_MAX_POINTS = 1500  # adjusted points, unless there are many images
_POINTS_A_IMAGE = 25
_MIN_SEEN = 20  # minimum points for an own camera
_MODELS_WITH_DISTORTION = {"SIMPLE_PINHOLE": ("RADIAL", 2), "PINHOLE": ("OPENCV", 4), "SIMPLE_RADIAL": ("RADIAL", 1)}
_SEQUENCE_BLOCKS, _CELLS_PER_SIDE = 6, 3  # jackknife groups: sequence blocks, image cells per side
_ADJUSTMENT_STEPS = 60  # adjustment steps
_FEW_STEPS = 25  # adjustment steps for a rough error


def rms_error(model: Any) -> float:
    total, count = 0.0, 0
    for number in sorted(model.reg_image_ids()):
        image = model.image(number)
        seen = [point for point in image.points2D if point.has_point3D()]
        if seen:
            points = np.array([model.point3D(point.point3D_id).xyz for point in seen])
            at = np.asarray(image.camera.img_from_cam(image.cam_from_world() * points), np.float64)
            off = ((at - np.array([point.xy for point in seen])) ** 2).sum(axis=1)
            total, count = total + float(off[np.isfinite(off)].sum()), count + int(np.isfinite(off).sum())
    return math.sqrt(total / count) if count else math.nan


def adjusted(
    pycolmap: ModuleType, model: Any, *, focal: bool, lens: bool = True, steps: int = _ADJUSTMENT_STEPS
) -> float:
    """Bundle-adjust a model, optionally with focal length and distortion. Returns the error."""
    options = pycolmap.BundleAdjustmentOptions()
    options.refine_focal_length, options.refine_extra_params, options.print_summary = focal, lens, False
    solver = options.ceres.solver_options
    solver.num_threads, solver.max_num_iterations, solver.function_tolerance = 1, steps, 1e-8
    config = pycolmap.BundleAdjustmentConfig()
    for number in sorted(model.reg_image_ids()):
        config.add_image(number)
    config.fix_gauge(pycolmap.BundleAdjustmentGauge.TWO_CAMS_FROM_WORLD)
    pycolmap.create_default_bundle_adjuster(options, config, model).solve()
    return rms_error(model)


def thinned(pycolmap: ModuleType, model: Any) -> Any:
    copy = pycolmap.Reconstruction(model)
    for number in [number for number in copy.point3D_ids() if copy.point3D(number).track.length() < 2]:
        copy.delete_point3D(number)
    numbers = sorted(copy.point3D_ids())
    max_points = max(_MAX_POINTS, _POINTS_A_IMAGE * copy.num_reg_images())
    selected = (
        {numbers[k] for k in np.linspace(0, len(numbers) - 1, max_points).round().astype(int)} if numbers else set()
    )
    for number in numbers:
        if number not in selected:
            copy.delete_point3D(number)
    return copy


def used_cameras(model: Any) -> list[int]:
    return sorted({model.image(number).camera_id for number in model.reg_image_ids()})


def focal_length(camera: Any) -> float:
    return float(camera.mean_focal_length())


def scale_focal_lengths(model: Any, factors: dict[int, float]) -> None:
    for number, factor in factors.items():
        camera = model.camera(number)
        params = np.array(camera.params)
        params[list(camera.focal_length_idxs())] *= factor
        camera.params = params


def resolve_cameras(
    pycolmap: ModuleType, job: dict[str, Any], models: list[Any], map_again: Callable[[], list[Any]]
) -> tuple[list[Any], dict[str, Any]]:
    """Check the cameras of the largest model. Returns the models and the values of `camera_check.CameraCheck`."""
    if models[0].num_points3D() < _MIN_POINTS or models[0].num_reg_images() < 2:
        return models, {}
    if job["fixed_camera"]:
        return models, judge_given(pycolmap, models[0])
    known = _known_focal_lengths(pycolmap, job["database"])
    models, record = split_cameras(pycolmap, job, models, map_again)
    record |= profile(pycolmap, models[0])
    if is_open(record["rise"], record.get("spread", 0.0)) and any(
        number in known for number in used_cameras(models[0])
    ):
        first, exif_record = fix_at_exif(pycolmap, models[0], known)
        return [first, *models[1:]], record | exif_record
    return models, record


def is_open(rise: float, spread: float) -> bool:
    return rise < MIN_ERROR_RISE or spread > MAX_SPREAD


def _known_focal_lengths(pycolmap: ModuleType, database: str) -> dict[int, float]:
    with pycolmap.Database.open(database) as opened:
        cameras = opened.read_all_cameras()
    return {camera.camera_id: focal_length(camera) for camera in cameras if camera.has_prior_focal_length}


def with_own_cameras(pycolmap: ModuleType, model: Any) -> Any:
    made = pycolmap.Reconstruction()
    for number in sorted(model.reg_image_ids()):
        image = model.image(number)
        if image.num_points3D < _MIN_SEEN:
            continue
        camera = pycolmap.Camera(image.camera.todict())
        camera.camera_id = number
        made.add_camera_with_trivial_rig(camera)
        pixels = np.array([point.xy for point in image.points2D]).reshape(-1, 2)
        copy = pycolmap.Image(name=image.name, keypoints=pixels, camera_id=number, image_id=number)
        made.add_image_with_trivial_frame(copy, image.cam_from_world())
    for number in sorted(model.point3D_ids()):
        point, track = model.point3D(number), pycolmap.Track()
        for element in point.track.elements:
            if made.exists_image(element.image_id):
                track.add_element(element.image_id, element.point2D_idx)
        if track.length() >= 2:
            made.add_point3D(point.xyz, track, point.color)
    return made


def own_focal_lengths(pycolmap: ModuleType, model: Any) -> tuple[float, float, dict[int, float]]:
    """The error with shared and with own cameras, adjusted alike, and the latter's focal lengths."""
    few = thinned(pycolmap, model)
    own = with_own_cameras(pycolmap, few)
    shared = adjusted(pycolmap, few, focal=True)
    alone = adjusted(pycolmap, own, focal=True, lens=False, steps=_FEW_STEPS)
    return shared, alone, {number: focal_length(own.camera(number)) for number in own.reg_image_ids()}


def clusters(lengths: dict[int, float]) -> list[list[int]]:
    """Group images by focal length, split where neighbors differ by more than one lens does."""
    order = sorted(lengths, key=lambda number: (lengths[number], number))
    groups: list[list[int]] = []
    for number in order:
        if groups and lengths[number] <= SAME_LENS * lengths[groups[-1][-1]]:
            groups[-1].append(number)
        else:
            groups.append([number])
    return groups


def part_cameras(pycolmap: ModuleType, database: str, groups: list[list[int]], lengths: dict[int, float]) -> None:
    numbers = []
    with pycolmap.Database.open(database) as opened:
        for group in groups:
            camera = opened.read_camera(opened.read_image(group[0]).camera_id)
            params = np.array(camera.params)
            params[list(camera.focal_length_idxs())] = float(np.median([lengths[number] for number in group]))
            camera.params, camera.has_prior_focal_length = params, False
            numbers.append(opened.write_camera(camera))
    connection = sqlite3.connect(database)
    with connection:
        for camera, group in zip(numbers, groups, strict=True):
            made = connection.execute("INSERT INTO rigs (ref_sensor_id, ref_sensor_type) VALUES (?, 0)", (camera,))
            for number in group:
                (frame,) = connection.execute("SELECT frame_id FROM frame_data WHERE data_id = ?", (number,)).fetchone()
                connection.execute("UPDATE images SET camera_id = ? WHERE image_id = ?", (camera, number))
                connection.execute("UPDATE frames SET rig_id = ? WHERE frame_id = ?", (made.lastrowid, frame))
                connection.execute("UPDATE frame_data SET sensor_id = ? WHERE data_id = ?", (camera, number))
    connection.close()


def split_cameras(
    pycolmap: ModuleType, job: dict[str, Any], models: list[Any], map_again: Callable[[], list[Any]]
) -> tuple[list[Any], dict[str, Any]]:
    """Use several cameras if they reduce the error by a third; refined cameras that agree are merged again."""
    shared, alone, lengths = own_focal_lengths(pycolmap, models[0])
    record: dict[str, Any] = {"own_error": alone}
    groups = clusters(lengths)
    if not alone < (1 - WORTH_TRYING) * shared or len(groups) < 2:
        return models, record
    if len(groups) > len(lengths) // 2:  # a continuous zoom, or a rough first model
        groups = [[number] for number in sorted(lengths)]
    max_error = MUCH_BETTER * rms_error(models[0])
    selected = _parted(pycolmap, job, models, groups, lengths, map_again, max_error)
    if selected is models:
        return models, record
    first = selected[0]
    lengths |= {number: focal_length(first.image(number).camera) for number in first.reg_image_ids()}
    joined = clusters(lengths)
    if len(joined) < len(groups):
        selected = _parted(pycolmap, job, selected, joined, lengths, map_again, _AS_GOOD * rms_error(first))
    return selected, record | {"parted": len(used_cameras(selected[0]))}


def _parted(
    pycolmap: ModuleType,
    job: dict[str, Any],
    models: list[Any],
    groups: list[list[int]],
    lengths: dict[int, float],
    map_again: Callable[[], list[Any]],
    max_error: float,
) -> list[Any]:
    """Models with a camera per group. The previous ones if those place fewer images or have larger errors."""
    part_cameras(pycolmap, job["database"], groups, lengths)
    others = map_again()
    if not others or others[0].num_reg_images() < models[0].num_reg_images():
        return models
    return others if rms_error(others[0]) <= max_error else models


def judge_given(pycolmap: ModuleType, model: Any) -> dict[str, Any]:
    """The focal length preferred by the images over a given one, and the error with either."""
    few = thinned(pycolmap, model)
    first = used_cameras(few)[0]
    _tie_focal_lengths(pycolmap, few)
    given = focal_length(few.camera(first))
    error = adjusted(pycolmap, few, focal=False, lens=False)
    freed = adjusted(pycolmap, few, focal=True)
    estimated = focal_length(few.camera(first))
    record = {"given": given, "error": error, "found": estimated, "freed_error": freed}
    record |= {"own_error": own_focal_lengths(pycolmap, few)[1]}
    # with a small decrease, parts of the images have to agree
    is_off = abs(math.log(estimated / given)) > 2 * MAX_SPREAD and error > (1 + MAX_EXIF_RISE) * freed
    return record | ({"spread": spread_of_parts(pycolmap, few)} if is_off and freed > GIVEN_WORSE * error else {})


def _tie_focal_lengths(pycolmap: ModuleType, model: Any) -> None:
    """Use a single focal length for square pixels: two free ones diverge for cameras in a row."""
    for number in used_cameras(model):
        camera = model.camera(number)
        if camera.model_name == "PINHOLE":
            fx, fy, *center = camera.params
            if abs(fx / fy - 1) < _MAX_FOCAL_DIFFERENCE:
                camera.model = pycolmap.CameraModelId.SIMPLE_PINHOLE
                camera.params = [(fx + fy) / 2, *center]


def profile(pycolmap: ModuleType, model: Any) -> dict[str, Any]:
    """Minimum rise of the error at fixed focal length factors. If small, also its spread over image subsets."""
    few = thinned(pycolmap, model)
    error = adjusted(pycolmap, few, focal=True)
    cameras, rises = used_cameras(few), []
    for factor in FIXED_FACTORS:
        fixed = pycolmap.Reconstruction(few)
        scale_focal_lengths(fixed, dict.fromkeys(cameras, factor))
        rises.append(adjusted(pycolmap, fixed, focal=False) / error - 1 if error > 0 else 0.0)
    record = {"found": focal_length(few.camera(cameras[0])), "error": error, "rise": min(rises)}
    return record | (
        {"spread": spread_of_parts(pycolmap, few)} if MIN_ERROR_RISE <= record["rise"] < DETERMINED_ERROR_RISE else {}
    )


def spread_of_parts(pycolmap: ModuleType, model: Any) -> float:
    """Relative standard error of the focal length: jackknives over image regions and sequences, and a richer lens."""
    numbers = sorted(model.reg_image_ids())
    blocks = {number: k * _SEQUENCE_BLOCKS // len(numbers) for k, number in enumerate(numbers)}
    by_image = [
        _focal_without(pycolmap, model, lambda n, _xy, _size, k=k: blocks[n] == k) for k in range(_SEQUENCE_BLOCKS)
    ]
    by_cell = [_focal_without(pycolmap, model, lambda _n, *at, k=k: _cell(*at) == k) for k in range(_CELLS_PER_SIDE**2)]
    bent = abs(_focal_of_richer_lens(pycolmap, model) - _log_focal(model)) / 2
    return max(_jackknife(by_image), _jackknife(by_cell), bent)


def _cell(xy: Any, size: tuple[int, int]) -> int:
    column, row = (
        min(max(int(at * _CELLS_PER_SIDE / side), 0), _CELLS_PER_SIDE - 1) for at, side in zip(xy, size, strict=True)
    )
    return row * _CELLS_PER_SIDE + column


def _jackknife(logs: list[float]) -> float:
    values = np.array(logs)
    return math.sqrt((len(values) - 1) / len(values) * float(((values - values.mean()) ** 2).sum()))


def _log_focal(model: Any) -> float:
    return float(np.mean([math.log(focal_length(model.camera(number))) for number in used_cameras(model)]))


def _focal_of_richer_lens(pycolmap: ModuleType, model: Any) -> float:
    """As `_focal_without`, with a second distortion coefficient."""
    richer = pycolmap.Reconstruction(model)
    for number in used_cameras(richer):
        camera = richer.camera(number)
        if camera.model_name in _MODELS_WITH_DISTORTION:
            name, more = _MODELS_WITH_DISTORTION[camera.model_name]
            params = [*camera.params, *[0.0] * more]
            camera.model = getattr(pycolmap.CameraModelId, name)
            camera.params = params
    adjusted(pycolmap, richer, focal=True)
    return _log_focal(richer)


def _focal_without(pycolmap: ModuleType, model: Any, is_left_out: Callable[..., bool]) -> float:
    """Mean log focal length without some of the observations."""
    part = pycolmap.Reconstruction(model)
    for number in sorted(part.reg_image_ids()):
        image = part.image(number)
        size = image.camera.width, image.camera.height
        seen = [(k, point.xy) for k, point in enumerate(image.points2D) if point.has_point3D()]
        for k in [k for k, xy in seen if is_left_out(number, xy, size)]:
            if part.image(number).point2D(k).has_point3D():  # also removes points with a single observation
                part.delete_observation(number, k)
    adjusted(pycolmap, part, focal=True, steps=_FEW_STEPS)
    return _log_focal(part)


def fix_at_exif(pycolmap: ModuleType, model: Any, known: dict[int, float]) -> tuple[Any, dict[str, Any]]:
    """The model with EXIF's focal lengths if they fit as well. Cameras without move along."""
    cameras = used_cameras(model)
    factors = {number: known[number] / focal_length(model.camera(number)) for number in cameras if number in known}
    usual = float(np.median(list(factors.values())))
    fixed, error = pycolmap.Reconstruction(model), rms_error(model)
    scale_focal_lengths(fixed, {number: factors.get(number, usual) for number in cameras})
    after = adjusted(pycolmap, fixed, focal=False)
    fixed.update_point_3d_errors()
    record = {"exif": known[min(factors)], "error": error, "freed_error": after}
    return fixed if after < (1 + MAX_EXIF_RISE) * error else model, record
