"""Point clouds from and to files, by extension."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_count, check_positive
from ...core.coordinates import FLOAT32_MAX, choose_origin, finite_box, quiet, written_steps
from ...core.devices import resolve_device
from ...core.errors import FileError
from ...core.escaped_text import escaped
from ...core.paths import path_of
from ...core.units import LengthUnit, warn_of_units
from ...kernels.memory import download
from ...pcd.boxes import AxisAlignedBoundingBox
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import VECTORS, check_cloud
from ..attribute_names import NameRules, new_names, warn_of_names
from ..table import PointTable
from .copc import open_copc
from .formats import READERS, WRITTEN, read_points, write_table
from .las import LasFile, iterate_las, open_las
from .las_crs import is_geographic, warn_of_degrees
from .pcd import warn_of_viewpoint


def read_point_cloud(
    path: str | os.PathLike[str], *, device: Any = None, scan: int | None = None, columns: Sequence[str] | None = None
) -> PointCloud:
    """Read a cloud with all its attributes.

    The formats are .ply .pcd .xyz .xyzn .xyzrgb .pts .csv .txt .asc .npz .bin .las .laz .e57 .ptx.

    The readers are strict: a file that is truncated, has trailing bytes, or counts that do not fit its size is
    refused by name and place, before memory is taken for it; nothing is ever filled in.

    Columns of .csv, .txt, .asc and .xyz are what a first line of names says: x y z, nx ny nz, r g b (0..1, or whole
    numbers in 0..255), and attributes by any other name. Without names three columns are x y z, and more are refused:
    give `columns`. A line with the number of points, as CloudCompare writes it, is checked. A .bin holds float32
    columns without names: x, y, z, intensity as KITTI has them, unless `columns` names others, such as x, y, z,
    intensity, ring of nuScenes. A .bin whose numbers repeat with another period is refused.

    LAS and LAZ come in the file's own unit and coordinate system, which may be feet: `cloud.unit` says so where the
    file does (docs/units.md). Their dimensions are attributes by laspy's names (intensity, classification, gps_time and
    so on). An extra dimension is NaN where it has the no_data value that the file declares. Where the file says that
    they are longitude and latitude, a GeographicWarning says so: they are kept to the file's steps, but a radius or a
    voxel of degrees is no length, so that `project_to_utm` should come next. The scans of an E57 or PTX file lie
    where their poses place them, in metres; directions without a return are left out. LAS and E57 need an extra:
    `pip install "pointloom[las]"`, `pip install "pointloom[e57]"`.

    Args:
        path: The file.
        device: Where the cloud goes.
        scan: For .e57 and .ptx: the scan to read, from 0; None reads all, with the attribute `scan_index`.
        columns: For .csv, .txt, .asc, .xyz and .bin: the names of all columns, in place of those of the file.

    Raises:
        FileError: The file cannot be read; says which byte or line, and why; or the package for it is missing.
        DeviceError: No such device.
        IndexError: There is no such scan.
        ValueError: A scan of a file that is no .e57 or .ptx, columns of one that names its own, or columns without x,
            y and z.

    Warns:
        GeographicWarning: x and y are degrees.
        UnitWarning: z is in another unit than x and y, or the file tells two units.
        UserWarning: Missing values of an attribute are a number: LAS declares one for integers of 64 bits. Or a PCD has
            a VIEWPOINT, the pose of its sensor, which is not applied, or colors that are "nan".

    Example:
        >>> import pointloom as loom
        >>> loom.write_point_cloud("scan.ply", loom.PointCloud([[0, 0, 0], [1, 2, 3]], intensity=[7.0, 8.0]))
        >>> loom.read_point_cloud("scan.ply")["intensity"].tolist()
        [7.0, 8.0]
        >>> from pathlib import Path
        >>> length = Path("scan.csv").write_text("x,y,z,ring\\n0,0,0,5\\n1,2,3,6\\n")
        >>> loom.read_point_cloud("scan.csv")["ring"].tolist()
        [5.0, 6.0]
    """
    extension = _extension(path)
    if columns is not None or scan is None:
        return cloud_of(read_points(path, columns), path, device=device)
    if extension not in (".e57", ".ptx"):
        raise ValueError(f"scan: only .e57 and .ptx have scans, got {escaped(Path(path).suffix)}")
    return cloud_of(READERS[extension](path, scan=check_count("scan", scan, minimum=0)), path, device=device)


def read_las_chunks(
    path: str | os.PathLike[str], chunk_size: int = 1_000_000, *, device: Any = None
) -> Iterator[PointCloud]:
    """Read a LAS or LAZ file in parts, for one that is larger than the memory.

    All parts have one origin, that of the box that the header gives, so that they can be worked on together.

    Args:
        path: The file: .las or .laz.
        chunk_size: Points of a part; the last one has what is left.
        device: Where the clouds go.

    Returns:
        The parts in the order of the file; none of a file without points. Each is read when it is asked for.

    Raises:
        FileError: As read_point_cloud; what is wrong inside the file shows when its part is read. Also colours that
            look like 8 bits in one part and like 16 in a later one.
        DeviceError: No such device.
        ValueError: A chunk size below 1.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> loom.write_point_cloud("tile.laz", loom.PointCloud(np.random.default_rng(0).random((1000, 3))))
        >>> [len(chunk) for chunk in loom.read_las_chunks("tile.laz", 400)]
        [400, 400, 200]
    """
    size, where = check_count("chunk_size", chunk_size), resolve_device(device)
    if _extension(path) not in (".las", ".laz"):
        raise FileError(path, "is read in parts only as .las or .laz", remedy="Use read_point_cloud")
    file = open_las(path)
    warn_of_degrees(path, is_geographic(file.header), stacklevel=3)
    return _chunks(file, size, where)


def read_copc(
    path: str | os.PathLike[str],
    *,
    within: AxisAlignedBoundingBox | None = None,
    spacing: float = 0.0,
    device: Any = None,
) -> PointCloud:
    """Read a part of a COPC file: what lies in a box, or a coarse version of it.

    The file's octree tells which of its chunks may hold such points; no others are read.

    Args:
        path: The file: .copc.laz.
        within: A box, ends included; None takes all.
        spacing: Of the coarsest version that is at least as fine as this [unit of the file]; 0 takes every point.
        device: Where the cloud goes.

    Returns:
        The points, level by level, with all their attributes.

    Raises:
        FileError: As read_point_cloud; or the file has no octree, or one that does not go with its chunks.
        DeviceError: No such device.
        TypeError: No box, or no number.
        ValueError: A spacing below 0.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> cloud = loom.PointCloud(np.random.default_rng(0).random((50_000, 3)) * (100, 100, 1))
        >>> loom.write_point_cloud("tile.copc.laz", cloud)
        >>> len(loom.read_copc("tile.copc.laz", within=loom.AxisAlignedBoundingBox((0, 0, 0), (50, 50, 1)))) < 13_000
        True
        >>> len(loom.read_copc("tile.copc.laz", spacing=1)) < len(cloud)
        True
    """
    spacing, where = check_positive("spacing", spacing, allow_zero=True), resolve_device(device)
    if within is not None and not isinstance(within, AxisAlignedBoundingBox):
        raise TypeError(f"within: expected an AxisAlignedBoundingBox, got {type(within).__name__}")
    low, high = (None, None) if within is None else (within.min_bound, within.max_bound)
    file = open_copc(path_of(path))
    return cloud_of(file.read(low, high, spacing), file.path, device=where)


@quiet()
def _common_origin(file: LasFile, first: PointTable) -> NDArray[np.float64]:
    """The origin of all parts: that of the box which the header gives, unless the first part lies outside it."""
    box = np.array(file.header.bounds, np.float64)
    low, high = finite_box(first.points)
    slack = np.array(file.header.scales)  # headers round
    is_right = bool(((box[0] - slack <= low) & (high <= box[1] + slack) & (np.abs(box) < FLOAT32_MAX / 4)).all())
    return choose_origin(box if is_right else first.points, first.steps)


def _chunks(file: LasFile, chunk_size: int, device: Any) -> Iterator[PointCloud]:
    origin = None
    for table in iterate_las(file, chunk_size):
        if origin is None:
            origin = _common_origin(file, table)
        else:
            table.unit_doubt = None  # which the first part has told
        yield cloud_of(table, file.path, device=device, origin=origin)


def cloud_of(
    table: PointTable, path: str | os.PathLike[str], *, device: Any = None, origin: ArrayLike | None = None
) -> PointCloud:
    """The cloud of what was read from a file, about an origin that is chosen where none is given.

    Raises:
        FileError: Points too far apart for float32.
        DeviceError: No such device.

    Warns:
        UserWarning: An attribute has the name of an array that every cloud has, and is read under another.
    """
    warn_of_viewpoint(path, table.viewpoint, stacklevel=3)
    try:
        origin = origin_of(table, path, stacklevel=5) if origin is None else origin
        cloud = PointCloud(table.points, normals=table.normals, colors=table.colors, device=device, origin=origin)
    except FileError:
        raise
    except ValueError as error:
        raise FileError(path, f"{error}", remedy="Drop the points that lie so far out") from error
    if renamed := new_names(table.attributes, NameRules(lambda letter: True, VECTORS, in_parts=False)):
        warn_of_names(path, "read under other names, since every cloud has arrays of these names", renamed)
    for name, values in table.attributes.items():  # one by one: a file may call one "device" or "origin"
        cloud[renamed.get(name, name)] = values
    cloud.grid, cloud.unit = table.grid, unit_told(table, path)
    return cloud


def unit_told(table: PointTable, path: str | os.PathLike[str]) -> LengthUnit | None:
    """The unit that a file tells of its coordinates; warns where the file itself speaks against it."""
    if table.unit_doubt is not None:
        warn_of_units(f"{path}: {table.unit_doubt}")
    return table.unit


def origin_of(table: PointTable, path: str | os.PathLike[str], *, stacklevel: int = 3) -> NDArray[np.float64]:
    """The origin about which a cloud holds what a file told apart; warns where the file says that it holds degrees.

    Raises:
        ValueError: Points too far apart for float32.
    """
    warn_of_degrees(path, table.is_geographic, stacklevel=stacklevel)
    return choose_origin(table.points, written_steps(table.points) if table.steps is None else table.steps)


def write_point_cloud(
    path: str | os.PathLike[str],
    cloud: PointCloud,
    *,
    ascii: bool = False,
    overwrite: bool = True,
    scale: ArrayLike | None = None,
    like: str | os.PathLike[str] | None = None,
) -> None:
    """Write a cloud with all its attributes, whole or not at all; the extension gives the format.

    Coordinates of a cloud whose origin is zero are written in float32 as they are held; those of a moved origin in
    float64, so that nothing is lost. LAS and LAZ alone round them, to multiples of `scale` about the cloud's origin.
    Colors are rounded to 16 bits a channel in LAS and LAZ, and to 8 bits in PLY, PCD, PTS and E57. A name that ends
    in .copc.laz makes a Cloud Optimized Point Cloud: LAZ in the order of an octree, of which `read_copc`, QGIS, PDAL
    and Potree read parts. A cloud knows no coordinate system: `like` takes it over from the file that the cloud came
    from. Its unit is written where the format has a place for it; E57 holds metres, so that coordinates in another unit
    are multiplied, and its scans (by `scan_index`) have no poses here: `write_stations` writes them.

    Args:
        path: The file: .ply .pcd .npz .xyz .xyzn .xyzrgb .pts .las .laz .e57.
        cloud: The cloud.
        ascii: Text instead of binary, for .ply and .pcd.
        overwrite: Whether an existing file may be replaced.
        scale: Step of the coordinates [m], for .las and .laz: one for all axes, or one for each. None takes 0.001, and
            finer ones for axes along which most points lie within 1000 m: a millionth of that as a power of ten.
            Coarser steps make smaller LAZ files.
        like: For .las and .laz: the LAS or LAZ file that the cloud came from, or one in the same system. Its
            coordinate system, other records, identification, offset, kind of GPS time and, where none is given, scale
            are taken over. Its extra dimensions keep type, scale, no_data value and description if no value changes by
            that.

    Raises:
        FileError: The file cannot be made, or the format cannot hold an attribute, a point that is not finite or, of
            E57, degrees.
        TypeError: No cloud.
        ValueError: A scale that is not above 0; `scale` or `like` for another format.

    Warns:
        UnitWarning: The cloud's unit is not that of `like`, not the format's, or one that the format cannot tell.
        UserWarning: Attributes are written under other names: a character that the format cannot hold becomes "_", a
            name in use gets "_2" at its end, and values that a dimension of LAS cannot hold, such as an intensity in
            0..1, go to "intensity_value". Or `like` has waveforms or a spatial index, which are not copied.

    Example:
        >>> import pointloom as loom
        >>> cloud = loom.PointCloud([[0, 0, 0], [1, 2, 3]], colors=[[1, 0, 0], [0, 1, 0]])
        >>> loom.write_point_cloud("scan.pcd", cloud)
        >>> len(loom.read_point_cloud("scan.pcd"))
        2
    """
    if _extension(path) not in WRITTEN:
        remedy = f"Use one of {' '.join(WRITTEN)}"
        raise FileError(path, f"clouds are read from {Path(path).suffix}, but not written to it", remedy=remedy)
    check_cloud("cloud", cloud)
    if Path(path).suffix.lower() not in (".las", ".laz"):
        for name, value in (("scale", scale), ("like", like)):
            if value is not None:
                raise ValueError(f"{name}: is for .las and .laz, got {escaped(Path(path).suffix)}")
    if like is not None and not isinstance(like, str | os.PathLike):
        raise TypeError(f"like: expected the path of a LAS or LAZ file, got {type(like).__name__}")
    header = None if like is None else open_las(like).header
    offset = cloud.origin if cloud.origin.any() and header is None else None
    write_table(
        path,
        table_of(cloud),
        ascii=ascii,
        overwrite=overwrite,
        scale=scale,
        offset=offset,
        like=header,
        device=cloud.device,
    )


def table_of(cloud: PointCloud) -> PointTable:
    """What a file of this cloud holds."""
    return PointTable(
        points=cloud.points if cloud.origin.any() else download(cloud._device_array("points")),
        normals=cloud.normals if cloud.has_normals else None,
        colors=cloud.colors if cloud.has_colors else None,
        attributes=dict(cloud.attributes),
        grid=cloud.grid,
        unit=cloud.unit,
    )


def _extension(path: str | os.PathLike[str]) -> str:
    extension = path_of(path).suffix.lower()
    if extension not in READERS:
        if extension in (".obj", ".stl", ".off", ".glb", ".gltf"):
            raise FileError(
                path, f"{extension} files hold meshes", remedy="Use read_triangle_mesh, write_triangle_mesh"
            )
        known = " ".join(READERS)
        if not extension and not path_of(path).exists():
            raise FileError(path, "does not exist")
        if path_of(path).is_dir():
            raise FileError(path, "is a folder", remedy=f"Give the name of a file: {known}")
        if extension in (".jpg", ".jpeg", ".png"):
            raise FileError(path, "is a picture", remedy="Use read_color, or read_depth for depth maps")
        raise FileError(path, f"unknown extension {extension!r}", remedy=f"Use one of {known}")
    return extension
