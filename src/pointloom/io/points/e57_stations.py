"""E57 and PTX files as stations: each scan in scanner coordinates with its pose."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import library_for
from ...core.atomic import check_writable
from ...core.checks import check_list, check_rigid
from ...core.coordinate_systems import CoordinateSystem, check_crs
from ...core.devices import DeviceLike
from ...core.errors import FileError, FilePath
from ...core.paths import path_of
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud, list_clouds
from ..optional_imports import foreign_errors
from ..source import netted
from ..table import PointTable
from .e57 import SCAN_INDEX, crs_of_image, open_e57, read_pose, read_scan, warn_of_lost_fields
from .e57_writer import check_e57, columns_of, unstorable_in_e57, write_scans
from .point_cloud import cloud_of, table_of
from .ptx import iterate_ptx


@dataclass(frozen=True, eq=False)
class Stations:
    """The scans of a file.

    Attributes:
        names: Names of the scans; numbered if missing or duplicated.
        clouds: Clouds in scanner coordinates.
        poses: T_world_scanner, float64 (n, 4, 4); identity if the file has none.
        posed: True if the file has a pose, bool (n,).
        crs: Coordinate system of the world coordinates, or None.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> loom.write_stations("one.e57", [loom.PointCloud(np.zeros((1, 3)))], [np.eye(4)])
        >>> loom.read_stations("one.e57").posed
        array([ True])
    """

    names: tuple[str, ...]
    clouds: list[PointCloud]
    poses: NDArray[np.float64]
    posed: NDArray[np.bool_]
    crs: CoordinateSystem | None = None

    @property
    def approximate_poses(self) -> NDArray[np.float64] | None:
        """The poses if each station has one and they differ, otherwise None: some files have identities."""
        is_known = self.posed.all() and len(self.poses) and (self.poses != self.poses[0]).any()
        return self.poses if is_known else None


def read_stations(path: FilePath, *, device: DeviceLike = "auto", arrays: str | None = None) -> Stations:
    """Read the scans of an E57 or PTX file in scanner coordinates, with their poses.

    `read_point_cloud` reads them as one cloud in world coordinates.

    Args:
        path: The file.
        device: Device of the clouds.
        arrays: Library of returned arrays, as of `PointCloud`. If None: "numpy".

    Returns:
        Names, clouds and poses, for `registration.register_stations` and `write_stations`.

    Raises:
        FileError: As `read_point_cloud`.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> cloud = loom.PointCloud(np.random.default_rng(0).random((100, 3)))
        >>> pose = np.array([[0, -1, 0, 5], [1, 0, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1.0]])
        >>> loom.write_stations("hall.e57", [cloud], [pose], names=["A"])
        >>> found = loom.read_stations("hall.e57")
        >>> found.names, found.poses[0, :3, 3].tolist(), bool(np.allclose(found.clouds[0].points, cloud.points))
        (('A',), [5.0, 6.0, 7.0], True)
    """
    library = library_for(arrays)
    tables, names, poses, posed, crs = _ptx_scans(path) if path_of(path).suffix.lower() == ".ptx" else _e57_scans(path)
    clouds = [cloud_of(table, path, device=device, arrays=library) for table in tables]
    if not all(names) or len(set(names)) < len(names):
        names = [f"{i} {name}".strip() for i, name in enumerate(names)]
    return Stations(tuple(names), clouds, poses, posed, crs)


_read_ptx = netted(lambda path: [*iterate_ptx(path)])
_Scans = tuple[list[PointTable], list[str], NDArray[np.float64], NDArray[np.bool_], CoordinateSystem | None]


def _e57_scans(path: FilePath) -> _Scans:
    with open_e57(path) as (image, scans):
        warn_of_lost_fields(path, scans)
        tables = [read_scan(path, node, in_world=False) for node in scans]
        with foreign_errors(path, "its list of scans is damaged"):
            names = [node["name"].value() if node.isDefined("name") else "" for node in scans]
            posed = np.array([node.isDefined("pose") for node in scans], bool)
            poses = np.tile(np.eye(4), (len(scans), 1, 1))
            for T, node in zip(poses, scans, strict=True):
                T[:3, :3], T[:3, 3] = read_pose(path, node)
        crs = crs_of_image(image)
    return tables, names, poses, posed, crs


def _ptx_scans(path: FilePath) -> _Scans:
    tables, poses = zip(*_read_ptx(path), strict=True)
    return [*tables], [""] * len(tables), np.stack(poses), np.ones(len(tables), bool), None


def write_stations(
    path: FilePath,
    clouds: Sequence[PointCloud] | Stations,
    poses: ArrayLike | None = None,
    *,
    names: Sequence[str] | None = None,
    crs: str | int | CoordinateSystem | None = None,
    overwrite: bool = True,
    drop_unsupported: bool = False,
) -> None:
    """Write clouds as scans of an E57 file, each in its own coordinates with its pose, atomically.

    Args:
        path: The file.
        clouds: One per station, or the stations of `read_stations`, with their poses, names and coordinate system.
        poses: T_world_scanner of each, (n, 4, 4). If None: those of the stations, which remain without a pose if they
            had none.
        names: Names of the scans. If None: those of the stations, otherwise numbers.
        crs: Coordinate system of the world coordinates. If None: that of the stations, unless `poses` replace unknown
            ones.
        overwrite: Replace an existing file.
        drop_unsupported: Leave out attributes that E57 cannot store, instead of an error.

    Raises:
        FileError: The file cannot be written, or E57 cannot store some attributes (all are named).
        ValueError: Different numbers of poses, names and clouds, a pose that is not rigid, or clouds without poses.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> clouds = [loom.PointCloud(np.eye(3)), loom.PointCloud(np.eye(3))]
        >>> loom.write_stations("two.e57", clouds, [np.eye(4), np.eye(4)], names=["hall", "stairs"])
        >>> loom.read_stations("two.e57").names
        ('hall', 'stairs')
        >>> loom.write_stations("copy.e57", loom.read_stations("two.e57"))
        >>> loom.read_stations("copy.e57").names
        ('hall', 'stairs')
    """
    path, system, posed = path_of(path), check_crs("crs", crs), None
    if isinstance(clouds, Stations):
        names = clouds.names if names is None else names
        if system is None and (poses is None or clouds.approximate_poses is not None):
            system = clouds.crs
        if poses is None:
            poses, posed = clouds.poses, clouds.posed
        clouds = clouds.clouds
    if poses is None:
        raise ValueError("poses: expected one pose per cloud, got None. Only stations of read_stations have their own")
    listed = list_clouds("clouds", clouds)
    for i, cloud in enumerate(listed):
        check_cloud(f"clouds[{i}]", cloud)
    matrices = [check_rigid(f"poses[{i}]", T) for i, T in enumerate(check_list("poses", poses, "poses"))]
    called = [f"Scan {i}" for i in range(len(listed))] if names is None else check_list("names", names, "text")
    if len(matrices) != len(listed) or len(called) != len(listed):
        raise ValueError(f"poses, names: expected {len(listed)}, one per cloud, got {len(matrices)} and {len(called)}")
    path = check_writable(path, overwrite=overwrite)
    if not listed:
        raise FileError(path, "would contain no scan", remedy="Give at least one cloud")
    tables = [table_of(cloud) for cloud in listed]
    for table in tables:
        for name in [SCAN_INDEX, *(unstorable_in_e57(table) if drop_unsupported else ())]:
            table.attributes.pop(name, None)
    tables = [check_e57(path, table) for table in tables]
    kept = [True] * len(listed) if posed is None else posed.tolist()
    scans = [
        (str(name), columns_of(path, table), T if has_pose else None)
        for name, table, T, has_pose in zip(called, tables, matrices, kept, strict=True)
    ]
    write_scans(path, scans, overwrite=overwrite, crs=system)
