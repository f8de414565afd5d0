"""Facts about a file or folder: a class for each kind that `pointloom info` supports."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

from ...core.reports import Fields, Report, values_of
from ...core.units import LengthUnit
from ...core.wording import format_bounds, format_fraction, format_triple, plain

Bounds = dict[str, list[float]] | None  # of `describe_bounds`


@dataclass(frozen=True)
class Facts(Report):
    """Facts of one kind of file or folder: ordered attributes. Nested `Facts` are flattened in place.

    None becomes null in JSON and is not printed. KIND is the displayed kind, empty for a part. SPARE lists attributes
    that are omitted from JSON if None.
    """

    KIND: ClassVar[str] = ""
    SPARE: ClassVar[tuple[str, ...]] = ()

    def named(self) -> Iterator[tuple[str, Any]]:
        for name, value in values_of(self).items():
            if isinstance(value, Facts):
                yield from value.named()
            elif value is not None or name not in self.SPARE:
                yield name, value

    def to_dict(self) -> dict[str, Any]:
        return {name: plain(value) for name, value in self.named()}

    def fields(self) -> Fields:
        return [(name.replace("_", " "), _format(name, value)) for name, value in self.named() if value is not None]


def _format(name: str, value: Any) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, LengthUnit):
        return value.in_words()
    if name.endswith("bounds"):
        return format_bounds(value)
    if name in ("origin", "position", "offset"):
        return format_triple(value)
    if name == "scale":
        return "[" + ", ".join(f"{step:g}" for step in value) + "]"
    if isinstance(value, dict):
        return ", ".join(f"{key} {_format(key, item)}" for key, item in value.items()) or "none"
    if isinstance(value, list):
        return "\n".join(" ".join(f"{x:g}" for x in row) if isinstance(row, list) else str(row) for row in value)
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return format_fraction(value) if name.endswith("fraction") else f"{value:.6g}"
    return f"{value:,}" if isinstance(value, int) else str(value)


@dataclass(frozen=True)
class Table(Facts):
    """Common facts of clouds and meshes; `bounds` are those of finite points, `origin` that of float32 positions."""

    coordinates: str
    attributes: dict[str, str]
    not_finite: int
    bounds: Bounds
    origin: list[float]


class Shape(Facts):
    @property
    def point_count(self) -> int:
        raise NotImplementedError

    @property
    def line(self) -> str:
        raise NotImplementedError


@dataclass(frozen=True)
class Cloud(Shape):
    """A point cloud; `grid` is rows and columns of an organized scan, `scans` describes those of an E57 file.

    `viewpoint` is the sensor position and quaternion w x y z of a PCD file, not applied.
    """

    KIND = "point cloud"
    SPARE = ("grid", "unit", "scans", "viewpoint")

    points: int
    grid: str | None
    unit: LengthUnit | None
    table: Table
    scans: list[str] | None = None
    viewpoint: str | None = None

    @property
    def point_count(self) -> int:
        return self.points

    @property
    def line(self) -> str:
        return f"{self.points:,} points, {format_bounds(self.table.bounds)}"


@dataclass(frozen=True)
class Mesh(Shape):
    KIND = "mesh"
    SPARE = ("textures", "unit")

    vertices: int
    triangles: int
    textures: str | None
    unit: LengthUnit | None
    table: Table

    @property
    def point_count(self) -> int:
        return self.vertices

    @property
    def line(self) -> str:
        return f"{self.vertices:,} vertices, {self.triangles:,} triangles, {format_bounds(self.table.bounds)}"


@dataclass(frozen=True)
class Las(Shape):
    """A LAS or LAZ cloud, from its header. Lengths are in its unit.

    `unit_notes` are contradictions to the unit in the file, such as another unit of z.
    """

    KIND = "point cloud"
    SPARE = ("unit_notes",)

    points: int
    version: str
    point_format: int
    coordinates: str
    scale: list[float]
    offset: list[float]
    coordinate_system: str | None
    unit: LengthUnit | None
    unit_notes: list[str] | None
    attributes: dict[str, str]
    bounds: Bounds
    software: str | None

    @property
    def point_count(self) -> int:
        return self.points

    @property
    def line(self) -> str:
        return f"{self.points:,} points, {format_bounds(self.bounds)}"


@dataclass(frozen=True)
class Heights(Facts):
    """A raster of a GeoTIFF: columns x rows, minimum, median and maximum of the cells with a value."""

    KIND = "raster"
    SPARE = ("values", "unit")

    size: str
    cell: float
    values: str | None
    coordinate_system: str | None
    unit: LengthUnit | None
    known_fraction: float
    filled_fraction: float
    heights: dict[str, float]
    bounds: Bounds


@dataclass(frozen=True)
class Picture(Facts):
    """An image; `size` is width x height."""

    KIND = "picture"

    format: str
    size: str
    channels: int


@dataclass(frozen=True)
class DepthMap(Facts):
    """A depth map: size, NumPy type, fraction of pixels with depth, and minimum, median and maximum depth in `unit`."""

    KIND = "depth map"

    size: str
    type: str
    measured_fraction: float
    depth: dict[str, float]
    unit: str


@dataclass(frozen=True)
class Camera(Facts):
    """A pinhole camera [px]: width x height, fx and fy, cx and cy."""

    KIND = "camera"

    size: str
    focal_length: dict[str, float]
    principal_point: dict[str, float]


@dataclass(frozen=True)
class CameraMatrix(Facts):
    """The 3x3 matrix of a camera, by rows."""

    KIND = "camera matrix"

    matrix: list[list[float]]


@dataclass(frozen=True)
class Pose(Facts):
    """One pose: its 4x4 matrix by rows, and its position [m]."""

    KIND = "pose"

    matrix: list[list[float]]
    position: list[float]


@dataclass(frozen=True)
class CameraPath(Facts):
    """Bounds of camera positions [m] and length of the path [m]."""

    camera_bounds: Bounds
    path_length_m: float


@dataclass(frozen=True)
class Trajectory(Facts):
    """A trajectory: number of poses, their path, and duration if it has times."""

    KIND = "trajectory"
    SPARE = ("duration_s",)

    poses: int
    camera_path: CameraPath
    duration_s: float | None


@dataclass(frozen=True)
class DataSet(Facts):
    """A folder of RGB-D frames.

    `left_out` is the number of unusable frames, `camera_from` the source of the camera parameters, `camera_notes` the
    reasons why they may not fit the images, `depth_scale` the stored depth of one meter.
    """

    KIND = "RGB-D data set"
    SPARE = ("camera_notes", "camera_path")

    layout: str
    frames: int
    poses: int
    has_color: bool
    left_out: int
    camera: Camera
    camera_from: str
    camera_notes: list[str] | None
    depth_scale: float
    first_frame_measured_fraction: float
    first_frame_depth_m: dict[str, float]
    camera_path: CameraPath | None


@dataclass(frozen=True)
class Cameras(Facts):
    """The cameras of a model: images with a pose, descriptions of lenses (truncated), bounds of positions."""

    images: int
    cameras: list[str]
    camera_bounds: Bounds


@dataclass(frozen=True)
class ColmapModel(Facts):
    """A COLMAP model in a subfolder (None: the given folder), `form` "binary" or "text".

    `mean_views` is the number of images per point, `mean_error_px` the known reprojection error [px]. None without
    points.
    """

    KIND = "COLMAP model"

    folder: str | None
    form: str
    views: Cameras
    points: int
    observations: int
    mean_views: float | None
    mean_error_px: float | None
    bounds: Bounds
    unit: str = "arbitrary, unless the model was scaled"


@dataclass(frozen=True)
class MetashapeCameras(Facts):
    """Cameras exported by Metashape, and images without a pose (truncated)."""

    KIND = "Metashape cameras"

    views: Cameras
    left_out: list[str] | None
