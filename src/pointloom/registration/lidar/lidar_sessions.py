"""Finished submaps of LiDAR SLAM, and the file of their graph, with which a later session continues the map."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write
from ...core.checks import check_rigid
from ...core.errors import FileError
from ...core.paths import is_file, refuse_link
from ...core.records import digest_of_file
from ...core.work_folder import RunFolder
from ...io.points.npz import read_arrays
from ...kernels.linear_algebra import eigvalsh, matmul
from .lidar_graph import MotionEdge, SubmapGraph
from .lidar_loops import LidarLoop, Place
from .lidar_submaps import PointStore
from .place_descriptor import describe_place
from .position_priors import PositionPriors

Matrix = NDArray[np.float64]

MAP_FILE = "map.npz"
FILE_VERSION = 1
MAX_NUMBER = 1e12  # [m] and [m^2]: larger ones are damage, and their squares overflow
# Kind and shape of each array: n submaps, m edges, p given positions, r references (0 or 1).
MAP_ARRAYS: dict[str, tuple[str, tuple[int | str, ...]]] = {
    "version": ("i", ()), "sizes": ("f", (4,)), "scans": ("i", ("n", 3)), "point_counts": ("i", ("n",)),
    "path": ("f", ("n", 2)), "middles": ("f", ("n", 3)), "odometry_poses": ("f", ("n", 4, 4)),
    "poses": ("f", ("n", 4, 4)), "edge_ends": ("i", ("m", 2)), "edge_poses": ("f", ("m", 4, 4)),
    "edge_covariances": ("f", ("m", 6, 6)), "reference": ("f", ("r", 4, 4)), "prior_nodes": ("i", ("p",)),
    "prior_points": ("f", ("p", 3)), "prior_positions": ("f", ("p", 3)), "prior_sigmas": ("f", ("p", 3)),
    "prior_shares": ("f", ("p",)), "prior_weights": ("f", ("p",)), "prior_origin": ("f", (3,)),
    "prior_times": ("f", ("p",)), "prior_velocities": ("f", ("p", 3)),
}  # fmt: skip
REMEDY = "Restore the folder, or map the scans again"


@dataclass(frozen=True, eq=False)
class SubmapRecord:
    """A finished submap: scans, pose in the frame of its session's odometry, length [m], and number of points."""

    session: int
    first_scan: int
    last_scan: int
    T_odometry_submap: Matrix
    length: float
    point_count: int


@dataclass(frozen=True, eq=False)
class SlamState:
    """What changes when a submap is finished: replaced at once, so that an interruption leaves the old one."""

    submaps: tuple[SubmapRecord, ...] = ()
    places: tuple[Place, ...] = ()
    graph: SubmapGraph = field(default_factory=SubmapGraph)
    loops: tuple[LidarLoop, ...] = ()
    searched: int = 0  # submaps whose loops were searched


@dataclass(frozen=True)
class MapSizes:
    """Sizes [m] that all sessions of a map share."""

    voxel_size: float
    max_range: float
    min_range: float
    submap_length: float


def place_of(
    points: NDArray[np.float32], T_odometry_submap: Matrix, middle: Matrix, begin: float, length: float, radius: float
) -> Place:
    """The place of a submap, whose path has its middle there in the submap's frame."""
    R = T_odometry_submap[:3, :3]
    level = matmul(points.astype(np.float64), R.T).astype(np.float32)
    return Place(describe_place(level, matmul(R, middle), radius), R, begin, begin + length, middle)


def write_map(folder: Path, sizes: MapSizes, state: SlamState) -> None:
    """Write the graph of the submaps atomically. Their points are in files of their own."""
    submaps, places, graph = state.submaps, state.places, state.graph
    arrays: dict[str, Any] = {
        "version": FILE_VERSION, "sizes": list(asdict(sizes).values()),
        "scans": [(each.session, each.first_scan, each.last_scan) for each in submaps],
        "point_counts": [each.point_count for each in submaps],
        "path": [(place.begin, each.length) for place, each in zip(places, submaps, strict=True)],
        "middles": [place.center for place in places],
        "odometry_poses": [each.T_odometry_submap for each in submaps], "poses": graph.poses,
        "edge_ends": [(edge.source, edge.target) for edge in graph.edges],
        "edge_poses": [edge.transformation for edge in graph.edges],
        "edge_covariances": [edge.covariance for edge in graph.edges],
        "reference": [] if graph.reference is None else [graph.reference],
        **{f"prior_{name}": values for name, values in vars(graph.priors).items()},
    }  # fmt: skip
    rows = {"n": len(submaps), "m": len(graph.edges), "p": len(graph.priors), "r": len(arrays["reference"])}
    with atomic_write(refuse_link(folder / MAP_FILE)) as file:
        stored = {}
        for name, (kind, shape) in MAP_ARRAYS.items():
            values = np.array(arrays[name], np.int64 if kind == "i" else np.float64)
            stored[name] = values.reshape([rows[size] if isinstance(size, str) else size for size in shape])
        np.savez(file, **stored)


def digest_of_map(folder: Path) -> str:
    """Digest of the graph of the submaps. Empty if there is none."""
    path = refuse_link(folder / MAP_FILE)
    return digest_of_file(path) if is_file(path) else ""


def run_folder(folder: Path) -> RunFolder:
    """The folder of a map, which one session writes at a time."""
    return RunFolder(folder, MAP_FILE, lambda path: not set(MAP_ARRAYS) - read_arrays(path).keys())


def read_map(folder: Path, store: PointStore) -> tuple[MapSizes, SlamState]:
    """The sizes and submaps of a map. Raises FileError with the name of a missing, damaged or different file."""
    path = refuse_link(folder / MAP_FILE)
    arrays = read_arrays(path, tuple(MAP_ARRAYS))
    try:
        _check_arrays(arrays)
    except ValueError as error:
        raise FileError(path, str(error), remedy=REMEDY) from error
    voxel_size, max_range, min_range, submap_length = arrays["sizes"].tolist()
    sizes = MapSizes(voxel_size, max_range, min_range, submap_length)
    measured = zip(arrays["edge_ends"].tolist(), arrays["edge_poses"], arrays["edge_covariances"], strict=True)
    edges = [MotionEdge(source, target, T, covariance) for (source, target), T, covariance in measured]
    priors = PositionPriors(**{name[len("prior_") :]: arrays[name] for name in MAP_ARRAYS if name.startswith("prior_")})
    reference = arrays["reference"][0] if len(arrays["reference"]) else None
    graph = SubmapGraph(list(arrays["poses"]), edges, priors, reference)
    submaps, places, radius = [], [], submap_range(max_range, min_range)
    for k, (T, (begin, length)) in enumerate(zip(arrays["odometry_poses"], arrays["path"].tolist(), strict=True)):
        (session, first, last), count = arrays["scans"][k].tolist(), int(arrays["point_counts"][k])
        submaps.append(SubmapRecord(session, first, last, T, length, count))
        points = store.checked_points(k, count)
        places.append(place_of(points, T, arrays["middles"][k], begin, length, radius))
    return sizes, SlamState(tuple(submaps), tuple(places), graph, (), len(submaps))


RANGE_FRACTION = 0.6  # of max_range: farther points are sparse and bent most by errors of the heading


def submap_range(max_range: float, min_range: float) -> float:
    """Range [m] of the points of submaps."""
    return max(RANGE_FRACTION * max_range, 2 * min_range)


def _check_arrays(arrays: dict[str, NDArray[Any]]) -> None:
    """Raise ValueError for arrays that no map has."""
    missing, rows = sorted(set(MAP_ARRAYS) - set(arrays)), {}
    if missing:
        raise ValueError(f"is not a map of LidarSLAM: it has no {', '.join(missing)}")
    for name, (kind, shape) in MAP_ARRAYS.items():
        values = arrays[name]
        expected = [rows.setdefault(size, each) if isinstance(size, str) else size
                    for size, each in zip(shape, values.shape, strict=False)]  # fmt: skip
        if values.dtype.kind != kind or values.ndim != len(shape) or list(values.shape) != expected:
            raise ValueError(f"{name}: expected shape {list(shape)}, got {values.dtype} {list(values.shape)}")
        if not (np.abs(values) < MAX_NUMBER).all():
            raise ValueError(f"{name}: expected numbers below {MAX_NUMBER:g}, got others or NaN")
        for k, T in enumerate(values if shape[1:] == (4, 4) else ()):
            check_rigid(f"{name}[{k}]", T)
    n, (sessions, firsts, lasts) = rows["n"], arrays["scans"].T
    ends, nodes, covariances = arrays["edge_ends"], arrays["prior_nodes"], arrays["edge_covariances"]
    scales = np.sqrt(np.maximum(np.einsum("kii->ki", covariances), 1e-300))
    scaled = covariances / (scales[:, :, None] * scales[:, None])
    sizes, weights, shares = arrays["sizes"], arrays["prior_weights"], arrays["prior_shares"]
    checks = {
        "version": arrays["version"] == FILE_VERSION,
        "sizes": sizes.min() >= 0 and sizes[[0, 3]].min() > 0 and sizes[2] < sizes[1] and n > 0,
        "scans": (firsts >= 0).all() and (lasts >= firsts).all() and (np.diff(sessions) >= 0).all(),
        "path": (arrays["path"] >= 0).all(), "point_counts": (arrays["point_counts"] >= 0).all(),
        "edge_ends": ((ends >= 0) & (ends < n)).all() and (ends[:, 0] > ends[:, 1]).all(),
        "edge_covariances": (covariances == covariances.transpose(0, 2, 1)).all()
        and all((eigvalsh(each) > 0).all() for each in scaled),
        "prior_nodes": ((nodes >= 0) & (nodes < n)).all(), "prior_sigmas": (arrays["prior_sigmas"] > 0).all(),
        "prior_shares": ((shares > 0) & (shares <= 1)).all(), "prior_weights": ((weights >= 0) & (weights <= 1)).all(),
        "reference": rows["r"] == 1 or (rows["r"] == 0 and not weights.any()),
    }  # fmt: skip
    wrong = [name for name, is_valid in checks.items() if not is_valid]
    if wrong:
        raise ValueError(f"{', '.join(wrong)}: values that no map of this version has")
