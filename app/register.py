"""One cloud brought onto another: `register_files`.

Operations see the clouds thinned to voxels; what is written is the pose, and the source with all it has, moved.
"""

from __future__ import annotations

import dataclasses
import os
from statistics import median_low
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..pcd.cloud import PointCloud
from ..pcd.devices import resolve_device
from ..pcd.errors import FileError
from ..pcd.io.atomic import atomic_write
from ..pcd.io.formats import WRITTEN
from ..pcd.io.point_cloud import cloud_of, table_of
from ..pcd.io.table import MeshTable
from ..pcd.io.trajectory import read_pose
from ..pcd.search import NearestNeighborSearch
from ..pcd.watching import standing_for
from ..registration.estimation import (
    TransformationEstimation,
    TransformationEstimationForColoredICP,
    TransformationEstimationForGeneralizedICP,
    TransformationEstimationPointToPlane,
    TransformationEstimationPointToPoint,
    TransformationEstimationSymmetric,
)
from ..registration.global_registration import register_globally
from ..registration.icp import registration_icp
from ..registration.rating import rate_registration
from ..registration.result import RegistrationResult
from ..registration.rigid import pose_error
from . import tables
from .clouds import FilePath, closing_fields, make_report
from .console import Clock, ReportProgress, format_share, say_nothing
from .pictures.pair_picture import draw_pair
from .pictures.picture_files import check_picture
from .probes import distance_of_nearest, probe_points, rounded_up

Matrix = NDArray[np.float64]

IDENTITY, GLOBAL = "identity", "global"
LEAST_SCORE, LEAST_FITNESS = 0.5, 0.1  # a result is poor whose score is no more, or whose fitness is less

# A voxel of a 32nd of the distance from the middle within which three quarters of the points lie: some 5,000 to 15,000
# of them hold points of a room, an object or a street.
_VOXELS_TO_MIDDLE, _WITHIN = 32.0, 0.75

# Correspondences lie closer than two voxels: neighbours on a thinned surface are about one apart. From a start that was
# not searched for, coarser clouds come first, so that it may be wrong by more.
_DISTANCE = 2.0  # [voxels]
_COARSE_TO_FINE, _AT_ONCE = (4.0, 2.0, 1.0), (1.0,)

_NORMAL_RADIUS, _NORMAL_NEIGHBORS = 3.0, 30  # [voxels], points at most
_RATED_WITHIN = 1.5  # [voxels] as global registration rates its own poses
_FEWEST_VOXELS = 10  # with points in them


@dataclasses.dataclass(frozen=True)
class Method:
    """A kind of ICP, which of the two clouds need normals, and whether both need colours."""

    estimation: type[TransformationEstimation]
    normals: tuple[str, ...] = ()
    needs_colors: bool = False


METHODS = {
    "point-to-point": Method(TransformationEstimationPointToPoint),
    "point-to-plane": Method(TransformationEstimationPointToPlane, ("target",)),
    "symmetric": Method(TransformationEstimationSymmetric, ("source", "target")),
    "generalized": Method(TransformationEstimationForGeneralizedICP),
    "colored": Method(TransformationEstimationForColoredICP, ("target",), needs_colors=True),
}


class Pair(NamedTuple):
    """The cloud that moves and the cloud that stays."""

    source: PointCloud
    target: PointCloud


class Fit(NamedTuple):
    """What the last and finest scale of ICP found, on which thinned clouds, and whose normals were estimated."""

    result: RegistrationResult
    thinned: Pair
    distance: float
    estimated: list[str]


def register_files(
    source: FilePath,
    target: FilePath,
    *,
    output: FilePath | None = None,
    init: FilePath = GLOBAL,
    method: str = "point-to-plane",
    voxel_size: float | None = None,
    distance: float | None = None,
    aligned: FilePath | None = None,
    picture: FilePath | None = None,
    device: Any = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> dict[str, Any]:
    """Find the pose that brings one cloud onto another, and write what is asked for; outputs are checked first.

    Args:
        source: The cloud that moves; of a mesh the vertices count.
        target: The cloud that stays.
        output: A .txt file for the pose T_target_source, four rows of four numbers with all digits.
        init: Where to begin: "global" searches, "identity" takes the clouds as they lie, else a file with such a pose.
        method: One of METHODS.
        voxel_size: Edge of the voxels that both clouds are thinned to [m]; None chooses it from them.
        distance: Correspondences lie closer than this [m]; None takes two voxels, and where the start was not searched
            for, eight and four of them before.
        aligned: A file for the source on the target, with all its attributes.
        picture: A .png file for both clouds before (left) and after (right).
        device: Where to compute.
        overwrite: Replace outputs that exist.
        progress: Called with each stage when it begins.

    Returns:
        What was done, in JSON's types; "poor" says why the result is poor, or is None. Nothing is written where no
        point found a correspondence.

    Raises:
        FileError: A file that cannot be read or written, or a cloud that is empty or lacks colours.
        ValueError: A length that is not positive, or no such method.
        DeviceError: No such device.
    """
    if method not in METHODS:
        raise ValueError(f"method: expected one of {', '.join(METHODS)}, got {method!r}")
    _check_outputs(output, aligned, picture, overwrite)
    say, clock, where = progress or say_nothing, Clock(), resolve_device(device)
    start = None if str(init) in (IDENTITY, GLOBAL) else read_pose(init)
    say("read", 0, 0)
    pair = Pair(read_cloud(source, where), read_cloud(target, where))
    clock.stop("read")
    size = _check_voxels(pair, (source, target), METHODS[method], voxel_size)
    clock.stop("voxels")
    believed, doubt, scales = 1.0, "", _COARSE_TO_FINE if distance is None else _AT_ONCE
    if str(init) == GLOBAL:
        say("search", 0, 0)
        found = register_globally(*pair, voxel_size=size)
        start, believed, doubt, scales = found.transformation, found.score or 0.0, found.reason, _AT_ONCE
        clock.stop("search")
    say("refine", 0, 0)
    fit = _refine(pair, METHODS[method], start, size, scales, distance)
    clock.stop("refine")
    T = fit.result.transformation
    score = min(believed, rate_registration(*pair, T, _RATED_WITHIN * size))
    clock.stop("rate")
    say("write", 0, 0)
    files: list[str] = []
    left_out: list[str] = []
    if fit.result.fitness > 0:
        left_out = _write_results(pair, T, output, aligned, picture, target, overwrite)
        files = [os.fspath(path) for path in (output, aligned, picture) if path is not None]
    clock.stop("write")
    poor = _why_poor(fit.result, score, doubt, str(init))
    report = make_report("register", source, files, clock, left_out, poor=poor)
    options = {"target": os.fspath(target), "device": str(where), "init": os.fspath(init), "method": method}
    sizes = {"voxel_size": size, "voxel_size_given": voxel_size is not None, "score": score}
    return report | options | sizes | _describe(pair, fit, size)


def read_cloud(path: FilePath, device: Any) -> PointCloud:
    """A cloud with all its attributes; of a mesh the vertices.

    Raises:
        FileError: It cannot be read, or holds no finite point.
    """
    table = tables.read_table(path)
    cloud = cloud_of(tables.points_of(table) if isinstance(table, MeshTable) else table, path, device=device)
    if not len(probe_points(cloud)):
        held = f"{len(cloud):,} points, none of them finite" if len(cloud) else "no point"
        raise FileError(path, f"holds {held}, so there is nothing to register", remedy="Give another cloud")
    return cloud


def choose_voxel_size(*clouds: PointCloud) -> float:
    """The edge of voxels [m] that suits the registration of clouds, to two digits.

    A 32nd of the distance from its middle within which three quarters of a cloud's points lie, by a sample of them; no
    less than the usual distance between neighbours. The smaller one of two clouds, the median of more.
    """
    sizes = []
    for cloud in clouds:
        probes = probe_points(cloud)
        reach = float(np.quantile(np.linalg.norm(probes - np.median(probes, axis=0), axis=1), _WITHIN))
        spacing = distance_of_nearest(NearestNeighborSearch(cloud), probes, 2) or 0.0
        sizes.append(max(reach / _VOXELS_TO_MIDDLE, spacing))
    size = median_low(sizes)
    return rounded_up(size) if size > 0 else 1.0


def write_pose(path: FilePath, T: Matrix, *, overwrite: bool = True) -> None:
    """Write a pose as four rows of four numbers with all digits, whole or not at all.

    Raises:
        FileError: The place cannot be written.
    """
    text = "".join(" ".join(repr(float(value)) for value in row) + "\n" for row in T)
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(text.encode("ascii"))


def register_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    counts, thinned = report["points"], report["thinned"]
    voxels = f"{report['voxel_size']:g} m{'' if report['voxel_size_given'] else ', chosen from the clouds'}"
    method = f"{report['method']} within {report['distance']:g} m"
    if report["normals_estimated"]:
        whose = " and ".join(report["normals_estimated"])
        method += f"; normals of the {whose} estimated, radius {report['normal_radius']:g} m"
    fit = f"fitness {format_share(report['fitness'])}, rmse {report['inlier_rmse']:.4g} m, score {report['score']:.2f}"
    open_motions = len(report["degenerate_directions"])
    return [
        ("points", f"{counts['source']:,} onto {counts['target']:,}"),
        ("thinned", f"{thinned['source']:,} onto {thinned['target']:,}, one a voxel of {voxels}"),
        ("start", report["init"]),
        ("method", method),
        ("result", f"{fit}; {report['iterations']} iterations, {report['reason']}"),
        *([("open", f"{open_motions} of 6 motions, which the clouds do not determine")] if open_motions else []),
        ("motion", f"{report['rotation_deg']:.3f} degrees, {report['shift_m']:.4g} m at the middle of the source"),
        ("pose", "\n".join("".join(f"{value:17.9f}" for value in row) for row in report["transformation"])),
        *closing_fields(report),
    ]


def _check_outputs(output: Any, aligned: Any, picture: Any, overwrite: bool) -> None:
    if output is not None:
        tables.check_output(output, (".txt",), what="poses", overwrite=overwrite)
    if aligned is not None:
        tables.check_output(aligned, WRITTEN, what="clouds", overwrite=overwrite)
    if picture is not None:
        check_picture(picture, overwrite=overwrite)


def _check_voxels(pair: Pair, paths: tuple[FilePath, FilePath], method: Method, voxel_size: float | None) -> float:
    """The size of voxels, once it is sure that the clouds have what the method needs."""
    for path, cloud in zip(paths, pair, strict=True):
        if method.needs_colors and not cloud.has_colors:
            remedy = "Choose another --method, such as point-to-plane"
            raise FileError(path, "has no colours, which --method colored needs", remedy=remedy)
    size = choose_voxel_size(*pair) if voxel_size is None else voxel_size
    for path, cloud in zip(paths, pair, strict=True):
        count = len(cloud.voxel_down_sample(size))
        if count < _FEWEST_VOXELS:
            plural = "" if count == 1 else "s"
            reason = f"has points in {count} voxel{plural} of {size:g} m, and {_FEWEST_VOXELS} are needed"
            raise FileError(path, reason, remedy="Take a smaller --voxel, or a cloud with more points")
    return size


def _refine(
    pair: Pair, method: Method, start: Matrix | None, size: float, scales: tuple[float, ...], distance: float | None
) -> Fit:
    """ICP on the clouds thinned to each scale in turn; the iterations are those of all."""
    pose, steps, fit = start, 0, None
    for scale in scales:
        voxel = scale * size
        thinned = Pair(*(cloud.voxel_down_sample(voxel) for cloud in pair))
        estimated = [role for role in method.normals if not getattr(thinned, role).has_normals]
        reach = {"radius": _NORMAL_RADIUS * voxel, "max_nn": _NORMAL_NEIGHBORS}
        thinned = thinned._replace(**{role: getattr(thinned, role).estimate_normals(**reach) for role in estimated})
        limit = distance or _DISTANCE * voxel
        with standing_for(source=pair.source, target=pair.target, voxel_size=voxel):
            result = registration_icp(*thinned, limit, pose, method.estimation())
        pose, steps = result.transformation, steps + result.iterations
        fit = Fit(result, thinned, limit, estimated)
    assert fit is not None
    fit.result.iterations = steps
    return fit


def _write_results(
    pair: Pair, T: Matrix, output: Any, aligned: Any, picture: Any, target: FilePath, overwrite: bool
) -> list[str]:
    """Write what is asked for; returns the names of what the aligned cloud's format cannot hold."""
    left_out = []
    if output is not None:
        write_pose(output, T, overwrite=overwrite)
    if aligned is not None:
        moved = table_of(pair.source.transform(T))
        left_out = tables.write_cloud_table(aligned, moved, source=target, overwrite=overwrite)
    if picture is not None:
        draw_pair(picture, *pair, T, overwrite=overwrite)
    return left_out


def _why_poor(result: RegistrationResult, score: float, doubt: str, init: str) -> str | None:
    other = "another --voxel" if init == GLOBAL else "--init global"
    if result.fitness == 0:
        return f"no point of the source has a correspondence; nothing was written; try {other}"
    if result.fitness < LEAST_FITNESS:
        share = f"{format_share(result.fitness)} of the source, less than {LEAST_FITNESS:.0%}"
        return f"only {share}, has a correspondence; try {other}"
    if score > LEAST_SCORE:
        return None
    why = doubt if doubt not in ("", "converged") else "the surfaces hardly lie on each other"
    return f"the score is {score:.2f}, not above {LEAST_SCORE}: {why}; try {other}"


def _describe(pair: Pair, fit: Fit, size: float) -> dict[str, Any]:
    """The figures of a fit, in JSON's types. The shift is that of the middle: a turn far from zero makes any other."""
    result, T = fit.result, fit.result.transformation
    middle = (pair.source.get_min_bound() + pair.source.get_max_bound()) / 2
    return {
        "points": dict(zip(Pair._fields, map(len, pair), strict=True)),
        "thinned": dict(zip(Pair._fields, map(len, fit.thinned), strict=True)),
        "distance": fit.distance,
        "normals_estimated": fit.estimated,
        "normal_radius": _NORMAL_RADIUS * size if fit.estimated else None,
        "transformation": T.tolist(),
        "rotation_deg": float(np.degrees(pose_error(T, np.eye(4))[0])),
        "shift_m": float(np.linalg.norm(T[:3, :3] @ middle + T[:3, 3] - middle)),
        "fitness": result.fitness,
        "inlier_rmse": result.inlier_rmse,
        "iterations": result.iterations,
        "reason": result.reason,
        "degenerate_directions": result.degenerate_directions.tolist(),
    }
