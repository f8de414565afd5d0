"""Straight segments between points: `LineSet`."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..cameras.camera import PinholeCameraIntrinsic, check_camera
from ..core.callable_bool import CallableBool
from ..core.checks import (
    check_count,
    check_finite,
    check_positive,
    check_rigid,
    check_rows,
    check_shape,
    check_transformation,
)
from ..core.dropped_results import returns_new
from ..core.exchange import on_host
from ..core.html_tables import array_type, html_table
from ..core.other_geometry import conversion_of
from ..kernels.linear_algebra import inv, matmul
from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from .motion import Movable
from .point_arrays import check_cloud

Rows = NDArray[np.float64]

# Edges of a box between corners in the order of `get_box_points`, in Open3D's order.
BOX_EDGES = np.array(
    [(0, 1), (1, 7), (7, 2), (2, 0), (3, 6), (6, 4), (4, 5), (5, 3), (0, 3), (1, 6), (7, 4), (2, 5)], np.int32
)

# Camera: from its center to the image corners, around them, and its axes.
CAMERA_EDGES = np.array(
    [(0, 1), (0, 2), (0, 3), (0, 4), (1, 2), (2, 3), (3, 4), (4, 1), (0, 5), (0, 6), (0, 7)], np.int32
)
CAMERA_COLORS = np.array([[0.0, 0.0, 1.0]] * 8 + [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class LineSet(Movable):
    """Line segments between points, for rendering and the viewer; immutable.

    Args:
        points: Shape (n, 3) [m], finite.
        lines: Point index pairs, shape (m, 2).
        colors: One per line, shape (m, 3), 0 to 1, or None.

    Raises:
        TypeError: If an array is not numeric.
        ValueError: If a shape is wrong, a point is not finite, or a line index is out of range.

    Example:
        >>> import pointloom as loom
        >>> loom.LineSet([[0, 0, 0], [1, 0, 0], [1, 1, 0]], [[0, 1], [1, 2]])
        LineSet(3 points, 2 lines)
    """

    points: Rows
    lines: NDArray[np.int32]
    colors: Rows | None = None

    def __post_init__(self):
        points = check_rows("points", on_host("points", self.points), 3, dtype=np.float64)
        missing = int((~np.isfinite(points)).any(axis=1).sum())
        if missing:
            raise ValueError(f"points: expected finite coordinates, got {missing} points without")
        lines = check_rows("lines", on_host("lines", self.lines), 2)
        if lines.size and (lines.dtype.kind not in "iu" or lines.min() < 0 or lines.max() >= len(points)):
            raise ValueError(f"lines: expected indices of {len(points)} points, got {lines.min()} to {lines.max()}")
        object.__setattr__(self, "points", points)
        object.__setattr__(self, "lines", lines.astype(np.int32))
        if self.colors is not None:
            colors = check_rows("colors", on_host("colors", self.colors), 3, rows=len(lines), dtype=np.float64)
            object.__setattr__(self, "colors", check_finite("colors", colors))

    @classmethod
    def create_from_axis_aligned_bounding_box(cls, box: AxisAlignedBoundingBox) -> LineSet:
        """The twelve edges of a box, in its color.

        Example:
            >>> import pointloom as loom
            >>> loom.LineSet.create_from_axis_aligned_bounding_box(loom.AxisAlignedBoundingBox([0, 0, 0], [1, 2, 3]))
            LineSet(8 points, 12 lines)
        """
        return cls._of_box(box, AxisAlignedBoundingBox)

    @classmethod
    def create_from_oriented_bounding_box(cls, box: OrientedBoundingBox) -> LineSet:
        """The twelve edges of an oriented box, in its color."""
        return cls._of_box(box, OrientedBoundingBox)

    @classmethod
    def _of_box(cls, box: Any, expected: type) -> LineSet:
        if not isinstance(box, expected):
            raise TypeError(f"box: expected an {expected.__name__}, got {type(box).__name__}")
        return cls(box.get_box_points(), BOX_EDGES).paint_uniform_color(box.color)

    @classmethod
    def create_from_triangle_mesh(cls, mesh: object) -> LineSet:
        """The unique edges of a mesh, in vertex order.

        Args:
            mesh: A TriangleMesh, or an object with `vertices` (n, 3) [m] and `triangles` (t, 3).
        """
        if not (hasattr(mesh, "vertices") and hasattr(mesh, "triangles")):
            given = f"{type(mesh).__name__}{conversion_of(mesh, expected='mesh')}"
            raise TypeError(f"mesh: expected a TriangleMesh, got {given}")
        vertices = check_rows("mesh.vertices", getattr(mesh, "vertices", None), 3, dtype=np.float64)
        triangles = check_rows("mesh.triangles", getattr(mesh, "triangles", None), 3)
        edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        return cls(vertices, np.unique(edges, axis=0).astype(np.int32))

    @classmethod
    def create_from_point_cloud_correspondences(cls, cloud0: Any, cloud1: Any, correspondences: ArrayLike) -> LineSet:
        """Lines between corresponding points of two clouds.

        Args:
            cloud0, cloud1: Point clouds, or objects with `points` (n, 3) [m].
            correspondences: Index pairs, shape (m, 2).

        Raises:
            ValueError: If an index is out of range.

        Example:
            >>> import pointloom as loom
            >>> first, second = loom.PointCloud([[0, 0, 0], [1, 0, 0]]), loom.PointCloud([[0, 0, 1]])
            >>> loom.LineSet.create_from_point_cloud_correspondences(first, second, [[1, 0]]).get_line_coordinate(0)
            (array([1., 0., 0.]), array([0., 0., 1.]))
        """
        pairs = check_rows("correspondences", on_host("correspondences", correspondences), 2)
        if pairs.size and pairs.dtype.kind not in "iu":
            raise ValueError(f"correspondences: expected integers, got {pairs.dtype}. Round them first")
        ends = []
        for name, cloud, indices in (("cloud0", cloud0, pairs[:, 0]), ("cloud1", cloud1, pairs[:, 1])):
            if not hasattr(cloud, "points"):
                check_cloud(name, cloud)
            points = check_rows(f"{name}.points", getattr(cloud, "points", None), 3, dtype=np.float64)
            if indices.size and (indices.min() < 0 or indices.max() >= len(points)):
                raise ValueError(f"correspondences: expected indices of {len(points)} points of {name}, got {indices}")
            ends.append(points[indices.astype(np.int64)])
        count = len(pairs)
        return cls(np.vstack(ends), np.arange(2 * count, dtype=np.int32).reshape(2, count).T)

    @classmethod
    def create_camera_visualization(
        cls, intrinsic: PinholeCameraIntrinsic, extrinsic: ArrayLike, scale: float = 1.0
    ) -> LineSet:
        """A camera as a pyramid (blue) with its axes (red, green, blue).

        Args:
            intrinsic: The camera.
            extrinsic: World to camera, 4x4 [m].
            scale: Distance of the image from the camera, and length of the axes [m].

        Example:
            >>> import numpy as np, pointloom as loom
            >>> camera = loom.PinholeCameraIntrinsic(640, 480, 525.0, 525.0, 319.5, 239.5)
            >>> loom.LineSet.create_camera_visualization(camera, np.eye(4), scale=0.2)
            LineSet(8 points, 11 lines)
        """
        check_camera("intrinsic", intrinsic)
        T_world_camera = inv(check_rigid("extrinsic", extrinsic))
        size = check_positive("scale", scale)
        left, right = -intrinsic.cx / intrinsic.fx, (intrinsic.width - intrinsic.cx) / intrinsic.fx
        top, bottom = -intrinsic.cy / intrinsic.fy, (intrinsic.height - intrinsic.cy) / intrinsic.fy
        corners = [(0, 0, 0), (left, top, 1), (right, top, 1), (right, bottom, 1), (left, bottom, 1)]
        local = size * np.array([*corners, *np.eye(3)])
        return cls(matmul(local, T_world_camera[:3, :3].T) + T_world_camera[:3, 3], CAMERA_EDGES, CAMERA_COLORS)

    def __repr__(self) -> str:
        return f"LineSet({len(self.points)} points, {len(self.lines)} lines)"

    def _repr_html_(self) -> str:
        arrays = {"points": self.points, "lines": self.lines, "colors": self.colors}
        return html_table(repr(self), ((n, array_type(np.asarray(v))) for n, v in arrays.items() if v is not None))

    def __len__(self) -> int:
        return len(self.lines)

    @property
    def has_points(self) -> CallableBool:
        """True if there are points. Also callable."""
        return CallableBool(len(self.points))

    @property
    def has_lines(self) -> CallableBool:
        """True if there are lines. Also callable."""
        return CallableBool(len(self.lines))

    @property
    def has_colors(self) -> CallableBool:
        """True if each line has a color. Also callable."""
        return CallableBool(self.colors is not None)

    @property
    def is_empty(self) -> CallableBool:
        """True if there are no points. Also callable."""
        return CallableBool(len(self.points) == 0)

    @returns_new
    def clear(self) -> LineSet:
        """Empty set: `lines = lines.clear()`."""
        return LineSet(np.zeros((0, 3)), np.zeros((0, 2), np.int32))

    def __add__(self, other: LineSet) -> LineSet:
        """Concatenate. Colors stay if both sets have some.

        Example:
            >>> import pointloom as loom
            >>> line = loom.LineSet([[0, 0, 0], [1, 0, 0]], [[0, 1]])
            >>> (line + line).lines.tolist()
            [[0, 1], [2, 3]]
        """
        if not isinstance(other, LineSet):
            return NotImplemented
        colors = None
        if self.colors is not None and other.colors is not None:
            colors = np.concatenate([self.colors, other.colors])
        lines = np.concatenate([self.lines, other.lines + len(self.points)])
        return LineSet(np.concatenate([self.points, other.points]), lines, colors)

    def get_line_coordinate(self, line_index: int) -> tuple[Rows, Rows]:
        """The two end points of a line [m], shape (3,) each."""
        if check_count("line_index", line_index, minimum=0) >= len(self.lines):
            raise ValueError(f"line_index: expected one of {len(self.lines)} lines, got {line_index}")
        first, second = self.points[self.lines[line_index]]
        return first, second

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """Axis-aligned box of the points."""
        return AxisAlignedBoundingBox.create_from_points(self.points)

    def get_min_bound(self) -> Rows:
        """Minimum coordinates of the points [m], shape (3,); zeros if there are none."""
        return self.get_axis_aligned_bounding_box().min_bound

    def get_max_bound(self) -> Rows:
        """Maximum coordinates of the points [m], shape (3,); zeros if there are none."""
        return self.get_axis_aligned_bounding_box().max_bound

    def get_center(self) -> Rows:
        """Mean of the points [m]. Zero if there are none."""
        if not len(self.points):
            return np.zeros(3)
        return np.ascontiguousarray(self.points.T).mean(axis=1)  # NumPy adds contiguous values pairwise

    @returns_new
    def paint_uniform_color(self, color: ArrayLike) -> LineSet:
        """Set one color for all lines: red, green and blue, 0 to 1."""
        checked = check_finite("color", check_shape("color", color, (3,)))
        return dataclasses.replace(self, colors=np.tile(checked, (len(self.lines), 1)))

    @returns_new
    def transform(self, transformation: ArrayLike) -> LineSet:
        """Apply a 4x4 matrix."""
        return self._mapped("transformation", check_transformation("transformation", transformation))

    def _mapped(self, name: str, T: Rows) -> LineSet:
        return dataclasses.replace(self, points=matmul(self.points, T[:3, :3].T) + T[:3, 3])
