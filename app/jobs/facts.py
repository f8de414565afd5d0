"""What a file or folder holds: `Facts`, and a class for each kind that `pointloom info` knows."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

from ...core.reports import Fields, Report, values_of
from ...core.units import LengthUnit
from ...core.wording import format_bounds, format_share, format_triple, plain

Bounds = dict[str, list[float]] | None  # of `describe_bounds`


@dataclass(frozen=True)
class Facts(Report):
    """What there is to tell of one kind of file or folder: its attributes by name, in their order.

    An attribute that is `Facts` itself is told on the same level, in its place. What is None is null for programs, and
    not told to people.

    Attributes:
        KIND: What people call it; empty for a part of another.
        SPARE: Attributes that programs are not told of either where they are None.
    """

    KIND: ClassVar[str] = ""
    SPARE: ClassVar[tuple[str, ...]] = ()

    def named(self) -> Iterator[tuple[str, Any]]:
        """All names and values on one level."""
        for name, value in values_of(self).items():
            if isinstance(value, Facts):
                yield from value.named()
            elif value is not None or name not in self.SPARE:
                yield name, value

    def to_dict(self) -> dict[str, Any]:
        """All of it on one level, in JSON's types."""
        return {name: plain(value) for name, value in self.named()}

    def fields(self) -> Fields:
        """The facts that there are."""
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
        return format_share(value) if name.endswith("share") else f"{value:.6g}"
    return f"{value:,}" if isinstance(value, int) else str(value)


# ------------------------------------------------------------------------------------------------ points


@dataclass(frozen=True)
class Table(Facts):
    """What clouds and meshes have in common.

    Attributes:
        coordinates: NumPy's type of them.
        attributes: The types of all else that points have, by name.
        not_finite: Points that are not.
        bounds: The box around the others; None without any.
        origin: The point that positions are counted from in float32.
    """

    coordinates: str
    attributes: dict[str, str]
    not_finite: int
    bounds: Bounds
    origin: list[float]


class Shape(Facts):
    """Points, with or without triangles."""

    @property
    def point_count(self) -> int:
        """How many points, or vertices of a mesh."""
        raise NotImplementedError

    @property
    def line(self) -> str:
        """Its size and bounds, for a list of files."""
        raise NotImplementedError


@dataclass(frozen=True)
class Cloud(Shape):
    """A point cloud.

    Attributes:
        points: How many.
        grid: Rows and columns, of a scan that has them.
        unit: Of its coordinates, where the file tells it.
        table: The rest.
        scans: Of an E57 file, each in words.
        viewpoint: Of a PCD file: position and quaternion w x y z of its sensor, not applied.
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
        """How many points."""
        return self.points

    @property
    def line(self) -> str:
        """Its size and bounds."""
        return f"{self.points:,} points, {format_bounds(self.table.bounds)}"


@dataclass(frozen=True)
class Mesh(Shape):
    """A mesh of triangles.

    Attributes:
        vertices, triangles: How many.
        textures: Their sizes, where there are any.
        unit: Of its coordinates, where the file tells it.
        table: The rest.
    """

    KIND = "mesh"
    SPARE = ("textures", "unit")

    vertices: int
    triangles: int
    textures: str | None
    unit: LengthUnit | None
    table: Table

    @property
    def point_count(self) -> int:
        """How many vertices."""
        return self.vertices

    @property
    def line(self) -> str:
        """Its size and bounds."""
        return f"{self.vertices:,} vertices, {self.triangles:,} triangles, {format_bounds(self.table.bounds)}"


@dataclass(frozen=True)
class Las(Shape):
    """A cloud in LAS or LAZ, as its header tells; lengths are in its unit.

    Attributes:
        points: How many.
        version: Of the format, and whether it is compressed.
        point_format: 0 to 10.
        coordinates: How they are stored.
        scale, offset: What they are stored by.
        coordinate_system: Its name, where one is told.
        unit: Of the coordinates, where one is told.
        unit_doubt: What the file says against it, such as another unit of z; or None.
        attributes: The types of all else that points have, by name.
        bounds: The box around the points; None without any.
        software: What wrote the file, where that is told.
    """

    KIND = "point cloud"
    SPARE = ("unit_doubt",)

    points: int
    version: str
    point_format: int
    coordinates: str
    scale: list[float]
    offset: list[float]
    coordinate_system: str | None
    unit: LengthUnit | None
    unit_doubt: str | None
    attributes: dict[str, str]
    bounds: Bounds
    software: str | None

    @property
    def point_count(self) -> int:
        """How many points."""
        return self.points

    @property
    def line(self) -> str:
        """Its size and bounds."""
        return f"{self.points:,} points, {format_bounds(self.bounds)}"


# ------------------------------------------------------------------------------------------------ pictures, cameras


@dataclass(frozen=True)
class Picture(Facts):
    """A picture; `size` is width x height."""

    KIND = "picture"

    format: str
    size: str
    channels: int


@dataclass(frozen=True)
class DepthMap(Facts):
    """Depth by pixel.

    Attributes:
        size: Width x height.
        type: NumPy's.
        measured_share: Pixels that hold a depth, of all.
        depth: The lowest, the median and the highest; empty where nothing was measured.
        unit: Of these.
    """

    KIND = "depth map"

    size: str
    type: str
    measured_share: float
    depth: dict[str, float]
    unit: str


@dataclass(frozen=True)
class Camera(Facts):
    """A pinhole camera, in pixels: width x height, fx and fy, cx and cy."""

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
    """One pose: its 4x4 matrix by rows, and where it is [m]."""

    KIND = "pose"

    matrix: list[list[float]]
    position: list[float]


@dataclass(frozen=True)
class Walk(Facts):
    """Where cameras were: the box around them [m] and the length of the path through them."""

    camera_bounds: Bounds
    path_length_m: float


@dataclass(frozen=True)
class Trajectory(Facts):
    """A trajectory: how many poses, their walk, and the time from the first to the last where they have times."""

    KIND = "trajectory"
    SPARE = ("duration_s",)

    poses: int
    walk: Walk
    duration_s: float | None


@dataclass(frozen=True)
class DataSet(Facts):
    """A folder of RGB-D frames.

    Attributes:
        layout: How it names its files.
        frames: How many.
        poses: How many of them have one.
        has_color: Whether the first has a picture beside its depth.
        left_out: How many frames cannot be used.
        camera: Of all frames.
        camera_from: Where it was found.
        camera_doubt: Why it may be that of other pictures, or None.
        depth_scale: Stored depth of one metre.
        first_frame_measured_share, first_frame_depth_m: As of `DepthMap`, in metres.
        walk: Of the camera; None without poses.
    """

    KIND = "RGB-D data set"
    SPARE = ("walk",)

    layout: str
    frames: int
    poses: int
    has_color: bool
    left_out: int
    camera: Camera
    camera_from: str
    camera_doubt: str | None
    depth_scale: float
    first_frame_measured_share: float
    first_frame_depth_m: dict[str, float]
    walk: Walk | None


# ------------------------------------------------------------------------------------------------ models


@dataclass(frozen=True)
class Cameras(Facts):
    """The cameras of a model.

    Attributes:
        pictures: How many have a pose.
        cameras: The lenses, each in words; many are cut.
        camera_bounds: The box around where they stood.
    """

    pictures: int
    cameras: list[str]
    camera_bounds: Bounds


@dataclass(frozen=True)
class ColmapModel(Facts):
    """A model of COLMAP.

    Attributes:
        folder: Where it lies below the one that was named; None where it is that.
        form: "binary" or "text".
        views: Its cameras.
        points, observations: How many.
        mean_views: Pictures that see a point; None without points.
        mean_error_px: Of the points whose error is known [px]; None without any.
        bounds: The box around the points; None without any.
        unit: Of the lengths.
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
    """Cameras that Metashape exported, and the pictures without a pose, each in words; many are cut."""

    KIND = "Metashape cameras"

    views: Cameras
    left_out: list[str] | None
