"""Read and write point clouds. The extension selects the format."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import library_for
from ...core.checks import check_count, check_positive
from ...core.coordinate_systems import CoordinateSystem, check_crs, common_crs
from ...core.coordinates import FLOAT32_MAX, choose_origin, finite_box, quiet, warn_if_rounded, written_steps
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.other_geometry import is_other
from ...core.paths import path_of, recording_remedy
from ...core.units import LengthUnit, warn_of_units
from ...kernels.memory import download
from ...pcd.bounding_box import BOX_REMEDY
from ...pcd.boxes import AxisAlignedBoundingBox
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import VECTORS, check_cloud
from ..attribute_names import NameRules, new_names, warn_of_names
from ..file_formats import listed
from ..images.image_formats import IMAGES
from ..table import PointTable
from .by_extension import read_points, write_table
from .codecs import WriteOptions
from .copc import open_copc
from .e57 import iterate_e57
from .formats import CLOUD_FORMATS, WITH_SCANS, WRITTEN
from .las import LasFile, iterate_las, open_las
from .las_crs import is_geographic, warn_of_degrees
from .pcd import warn_of_viewpoint


def read_point_cloud(
    path: FilePath,
    *,
    device: DeviceLike = None,
    scan: int | None = None,
    columns: Sequence[str] | None = None,
    arrays: str | None = None,
) -> PointCloud:
    """Read a point cloud with all its attributes.

    The extension selects the format (docs/files.md). An .obj has no faces. A truncated file, trailing bytes or counts
    that do not match the file size raise `FileError` before memory is allocated.

    Text: a header line names the columns: x y z, nx ny nz, r g b (0..1, or integers in 0..255). Other names are
    attributes. Without a header, 3 columns are x y z and more columns require `columns`. A .bin has float32 columns,
    by default x, y, z, intensity as in KITTI. Numbers that contradict it raise `FileError`. A warning is issued if
    another layout is as likely.

    LAS and LAZ keep the unit and coordinate system of the file, see `cloud.unit`. Their dimensions become attributes
    with laspy's names. In extra dimensions, no_data values become NaN. Call `project_to_utm` after a GeographicWarning.
    E57 and PTX scans are transformed by their poses [m]. Directions without a return are dropped. LAS and E57 need an
    extra: `pip install "pointloom[las]"`, `pip install "pointloom[e57]"`.

    Args:
        path: The file.
        device: Device of the cloud.
        scan: For .e57 and .ptx: index of the scan, from 0. None reads all scans and adds the attribute `scan_index`.
        columns: For tables such as .csv, .xyz and .bin: the names of all columns, which replace those of the file.
        arrays: Library of returned arrays, as of `PointCloud`. If None: "numpy".

    Raises:
        FileError: The file cannot be read, with the byte or line, or a required package is missing.
        DeviceError: No such device.
        IndexError: There is no such scan.
        ValueError: `scan` or `columns` for a format without them, or columns without x, y and z.

    Warns:
        GeographicWarning: x and y are degrees.
        UnitWarning: z has another unit than x and y, the file gives two units, or float32 about the cloud's origin is
            coarser than the steps of the file for some points (docs/determinism.md).
        UserWarning: A 64-bit LAS attribute has a no_data value, or a PCD has a VIEWPOINT (not applied) or NaN colors.
            Some scans lack an array that others have, or a cloud cannot store lists, elements or fields of the file.

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
    extension, library = _extension(path), library_for(arrays)
    if columns is not None or scan is None:
        return cloud_of(read_points(path, columns), path, device=device, arrays=library)
    if extension not in WITH_SCANS:
        raise ValueError(f"scan: only {listed(WITH_SCANS, 'and')} have scans, got {escaped(Path(path).suffix)}")
    table = CLOUD_FORMATS[extension].codec.read(path, scan=check_count("scan", scan, minimum=0))
    return cloud_of(table, path, device=device, arrays=library)


def read_las_chunks(
    path: FilePath, chunk_size: int = 1_000_000, *, device: DeviceLike = None, arrays: str | None = None
) -> Iterator[PointCloud]:
    """Read a LAS or LAZ file in chunks, for files larger than the memory.

    All chunks have the same origin, computed from the bounding box in the header.

    Args:
        path: The .las or .laz file.
        chunk_size: Points of a chunk. The last one may be smaller.
        device: Device of the clouds.
        arrays: Library of returned arrays, as of `PointCloud`. If None: "numpy".

    Returns:
        An iterator over the chunks in file order, read lazily. Empty if the file has no points.

    Raises:
        FileError: As `read_point_cloud`, when the chunk is read; or colors are 8-bit in one chunk and 16-bit in a later
            one.
        DeviceError: No such device.
        ValueError: A chunk size below 1.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> loom.write_point_cloud("tile.laz", loom.PointCloud(np.random.default_rng(0).random((1000, 3))))
        >>> [len(chunk) for chunk in loom.read_las_chunks("tile.laz", 400)]
        [400, 400, 200]
    """
    size, where, library = check_count("chunk_size", chunk_size), resolve_device(device), library_for(arrays)
    if _extension(path) not in (".las", ".laz"):
        raise FileError(path, "is read in parts only as .las or .laz", remedy="Use read_point_cloud")
    file = open_las(path)
    warn_of_degrees(path, is_geographic(file.header), stacklevel=3)
    return _chunks(file, size, where, library)


def read_e57_chunks(
    path: FilePath,
    chunk_size: int = 1_000_000,
    *,
    scan: int | None = None,
    device: DeviceLike = None,
    arrays: str | None = None,
) -> Iterator[PointCloud]:
    """Read an E57 file in chunks, for scans larger than the memory.

    A chunk has points of one scan, in world coordinates. All chunks have the same origin, computed from the first one.
    They have the arrays that all scans have, with a warning of the others. An attribute that the file marks as invalid
    at some points is a float.

    Args:
        path: The .e57 file.
        chunk_size: Maximum points of a chunk.
        scan: Index of the only scan to read, from 0. None reads all scans and adds the attribute `scan_index`.
        device: Device of the clouds.
        arrays: Library of returned arrays, as of `PointCloud`. If None: "numpy".

    Returns:
        An iterator over the chunks in file order, read lazily. Empty if the file has no points.

    Raises:
        FileError: As `read_point_cloud`, when the chunk is read.
        DeviceError: No such device.
        IndexError: There is no such scan.
        ValueError: A chunk size below 1.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> clouds = [loom.PointCloud(np.random.default_rng(k).random((1000, 3))) for k in range(2)]
        >>> loom.write_stations("scans.e57", clouds, [np.eye(4), np.eye(4)])
        >>> [len(chunk) for chunk in loom.read_e57_chunks("scans.e57", 600)]
        [600, 400, 600, 400]
    """
    size, where, library = check_count("chunk_size", chunk_size), resolve_device(device), library_for(arrays)
    number = None if scan is None else check_count("scan", scan, minimum=0)
    if _extension(path) != ".e57":
        raise FileError(path, "is not an .e57 file", remedy="Use read_point_cloud")
    return _e57_chunks(path_of(path), size, number, where, library)


def _e57_chunks(path: Path, size: int, scan: int | None, device: DeviceLike, arrays: str) -> Iterator[PointCloud]:
    origin, is_reported = None, False
    for table in iterate_e57(path, size, scan=scan):
        origin = origin_of(table, path) if origin is None else origin
        is_reported = is_reported or warn_if_rounded(path, table.points, origin, table.steps, table.unit_lengths)
        yield cloud_of(table, path, device=device, origin=origin, arrays=arrays)


def read_copc(
    path: FilePath,
    *,
    within: AxisAlignedBoundingBox | None = None,
    spacing: float = 0.0,
    device: DeviceLike = None,
    arrays: str | None = None,
) -> PointCloud:
    """Read a part of a COPC file: the points in a box, or a coarser level of detail.

    Only octree chunks that can contain such points are read.

    Args:
        path: The .copc.laz file.
        within: Box, bounds included. None reads all points.
        spacing: Read the coarsest level at least as fine as this [unit of the file]. 0 reads every point.
        device: Device of the cloud.
        arrays: Library of returned arrays, as of `PointCloud`. If None: "numpy".

    Returns:
        The points with all attributes, level by level.

    Raises:
        FileError: As `read_point_cloud`, or the octree is missing or does not match its chunks.
        DeviceError: No such device.
        TypeError: `within` is no box, or `spacing` is no number.
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
    library = library_for(arrays)
    if within is not None and not isinstance(within, AxisAlignedBoundingBox):
        raise TypeError(f"within: expected an AxisAlignedBoundingBox, got {type(within).__name__}; {BOX_REMEDY}")
    low, high = (None, None) if within is None else (within.min_bound, within.max_bound)
    file = open_copc(path_of(path))
    return cloud_of(file.read(low, high, spacing), file.path, device=where, arrays=library)


@quiet()
def _common_origin(file: LasFile, first: PointTable) -> NDArray[np.float64]:
    """The origin of all chunks, from the header's box. From the first chunk if its points are outside the box."""
    box = np.array(file.header.bounds, np.float64)
    low, high = finite_box(first.points)
    slack = np.array(file.header.scales)  # headers are rounded
    is_right = bool(((box[0] - slack <= low) & (high <= box[1] + slack) & (np.abs(box) < FLOAT32_MAX / 4)).all())
    corners = box if is_right else first.points
    origin = choose_origin(corners, first.steps, in_degrees=first.in_degrees)
    warn_if_rounded(file.path, corners, origin, first.steps, first.unit_lengths)
    return origin


def _chunks(file: LasFile, chunk_size: int, device: DeviceLike, arrays: str) -> Iterator[PointCloud]:
    origin = None
    for table in iterate_las(file, chunk_size):
        if origin is None:
            origin = _common_origin(file, table)
        else:
            table.warnings = ()  # already reported for the first chunk
        yield cloud_of(table, file.path, device=device, origin=origin, arrays=arrays)


def cloud_of(
    table: PointTable,
    path: FilePath,
    *,
    device: DeviceLike = None,
    origin: ArrayLike | None = None,
    arrays: str | None = None,
) -> PointCloud:
    """Build a cloud from a table. If `origin` is None, one is chosen, with a warning if float32 rounds too much."""
    warn_of_viewpoint(path, table.viewpoint, stacklevel=3)
    try:
        if origin is None:
            origin = origin_of(table, path, stacklevel=5)
            warn_if_rounded(path, table.points, origin, table.steps, table.unit_lengths)
        vectors: dict[str, Any] = {"normals": table.normals, "colors": table.colors}
        cloud = PointCloud(table.points, **vectors, device=device, origin=origin, arrays=arrays)
    except FileError:
        raise
    except ValueError as error:
        raise FileError(path, f"{error}", remedy="Remove the distant points") from error
    if renamed := new_names(table.attributes, NameRules(lambda letter: True, VECTORS, in_parts=False)):
        warn_of_names(path, "read under other names, because every cloud has arrays of these names", renamed)
    for name, values in table.attributes.items():  # one by one: a file may call one "device" or "origin"
        cloud[renamed.get(name, name)] = values
    cloud.grid, cloud.unit, cloud.crs = table.grid, unit_with_warnings(table, path), table.crs
    return cloud


def unit_with_warnings(table: PointTable, path: FilePath) -> LengthUnit | None:
    """The unit of the coordinates. Warns if the file contradicts itself."""
    for warning in table.warnings:
        warn_of_units(f"{path}: {warning}")
    return table.unit


def origin_of(table: PointTable, path: FilePath, *, stacklevel: int = 3) -> NDArray[np.float64]:
    """Choose the origin of a cloud so that points distinct in the file stay distinct. Warns if the file has degrees."""
    warn_of_degrees(path, table.is_geographic, stacklevel=stacklevel)
    steps = written_steps(table.points) if table.steps is None else table.steps
    return choose_origin(table.points, steps, in_degrees=table.in_degrees)


def write_point_cloud(
    path: FilePath,
    cloud: PointCloud,
    *,
    write_ascii: bool = False,
    overwrite: bool = True,
    drop_unsupported: bool = False,
    scale: ArrayLike | None = None,
    like: FilePath | None = None,
    crs: str | int | CoordinateSystem | None = None,
) -> None:
    """Write a point cloud with all its attributes atomically. The extension selects the format.

    Coordinates are float32 if the cloud's origin is zero and float64 otherwise. LAS and LAZ round them to multiples of
    `scale`. Colors are rounded to 16 bits in LAS and LAZ, and to 8 bits in PLY, PCD, PTS and E57. The extension
    .copc.laz writes a Cloud Optimized Point Cloud (LAZ in octree order). The unit is written if the format supports it.
    E57 coordinates are converted to meters and its scans have no poses here: use `write_stations`.

    Args:
        path: The file (formats: docs/files.md). A .csv (commas) or .txt (blanks) has a header and all attributes; an
            attribute (n, c) with c > 1 has columns name_0, name_1, ...
        cloud: The cloud. Or one of another library, see `from_any`.
        write_ascii: Write text instead of binary, for formats of either encoding, such as .ply.
        overwrite: Replace an existing file.
        drop_unsupported: Leave out colors, normals and attributes that the format cannot store, instead of an error.
        scale: Coordinate step [m], for .las and .laz: a number or one per axis. If None: 0.001, or finer on axes where
            most points are within 1,000 m: a millionth of that as a power of ten. In degrees, x and y have 1e-7, or
            finer within 0.001 degrees. Coarser steps give smaller LAZ files.
        like: For .las and .laz: a LAS or LAZ file whose coordinate system, other records, identification, offset, GPS
            time type and (if not given) scale are copied. Extra dimensions keep type, scale, no_data value and
            description if this changes no value.
        crs: Coordinate system of the file, such as "EPSG:25832". If None: that of the cloud.

    Raises:
        FileError: The file cannot be written, the format cannot store some attributes (all are named), a non-finite
            point or (E57) degrees, or `like` has another coordinate system.
        TypeError: `cloud` is no point cloud.
        ValueError: A scale that is not positive; `scale` or `like` for another format; `crs` is no coordinate system
            or not that of the cloud.

    Warns:
        UnitWarning: The cloud's unit differs from that of `like` or of the format, or the format cannot store it. Or
            float32 about the cloud's origin is coarser than the steps of the LAS file for some points.
        LostSystemWarning: The format cannot store the coordinate system, or pyproj is needed to write it.
        UserWarning: Attributes are renamed: unsupported characters become "_", duplicate names get the suffix "_2", and
            values outside the range of a LAS dimension go to, for example, "intensity_value". Or `like` has waveforms
            or a spatial index, which are not copied.

    Example:
        >>> import pointloom as loom
        >>> cloud = loom.PointCloud([[0, 0, 0], [1, 2, 3]], colors=[[1, 0, 0], [0, 1, 0]])
        >>> loom.write_point_cloud("scan.pcd", cloud)
        >>> len(loom.read_point_cloud("scan.pcd"))
        2
    """
    extension = _extension(path, write=True)
    if extension not in WRITTEN:
        remedy = f"Use one of {' '.join(WRITTEN)}"
        raise FileError(path, f"clouds are read from {Path(path).suffix}, but not written to it", remedy=remedy)
    cloud = PointCloud(cloud) if is_other(cloud) else cloud
    check_cloud("cloud", cloud)
    if extension not in (".las", ".laz"):
        for name, value in (("scale", scale), ("like", like)):
            if value is not None:
                raise ValueError(f"{name}: is for .las and .laz, got {escaped(Path(path).suffix)}")
    if like is not None and not isinstance(like, str | os.PathLike):
        raise TypeError(f"like: expected the path of a LAS or LAZ file, got {type(like).__name__}")
    header = None if like is None else open_las(like).header
    offset = cloud.origin if cloud.origin.any() and header is None else None
    options = WriteOptions(
        ascii=write_ascii, overwrite=overwrite, drop_unsupported=drop_unsupported, scale=scale, offset=offset,
        like=header, device=cloud.device,
    )  # fmt: skip
    system = common_crs("crs, cloud", (check_crs("crs", crs), cloud.crs))
    write_table(path, replace(table_of(cloud), crs=system), options)


def table_of(cloud: PointCloud) -> PointTable:
    return PointTable(
        points=cloud.points if cloud.origin.any() else download(cloud.arrays["points"]),
        normals=cloud.normals if cloud.has_normals else None,
        colors=cloud.colors if cloud.has_colors else None,
        attributes=dict(cloud.attributes),
        grid=cloud.grid,
        unit=cloud.unit,
        crs=cloud.crs,
        origin=cloud.origin,
    )


def _extension(path: FilePath, *, write: bool = False) -> str:
    """The extension of a file to read or write. Raises FileError for one that is in no list of formats."""
    extension = path_of(path).suffix.lower()
    if extension not in CLOUD_FORMATS:
        if remedy := "" if write else recording_remedy(path, "scans()"):
            raise FileError(path, "is a recording, which contains many clouds", remedy=remedy)
        known = " ".join(WRITTEN if write else CLOUD_FORMATS)
        if not write and not extension and not path_of(path).exists():
            raise FileError(path, "does not exist")
        if path_of(path).is_dir():
            raise FileError(path, "is a folder", remedy=f"Give the name of a file: {known}")
        if extension in IMAGES:
            raise FileError(path, "is an image", remedy="Use read_color, or read_depth for depth maps")
        others = "; meshes: write_triangle_mesh" if write else "; meshes: read_triangle_mesh"
        raise FileError(path, f"unknown extension {extension!r} of a cloud", remedy=f"Use one of {known}{others}")
    return extension
