"""LineSet, changed in place as in Open3D."""

from __future__ import annotations

from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...pcd import boxes, line_set
from ...pcd.cloud import PointCloud as OurCloud
from ..argument_types import BoxLike, CloudLike, MeshLike
from ..indices import indices_of
from ..vectors import Vector2iVector, Vector3dVector
from ..wrapper import Rows, column, unwrap
from .bounded import BoundedByBoxes
from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox, oriented_box
from .point_cloud import PointCloud


class LineSet(BoundedByBoxes):
    """Segments between points; `points`, `lines` and `colors` (per line) are assignable."""

    _kind = line_set.LineSet
    _arrays: ClassVar = {"points": "points"}

    points = Rows(Vector3dVector)
    lines = Rows(Vector2iVector)
    colors = Rows(Vector3dVector)

    def __init__(self, points: Any = (), lines: Any = ()):
        given = unwrap(points)
        empty = line_set.LineSet(np.zeros((0, 3)), np.zeros((0, 2), np.int32))
        self._wrapped, self._shared = given if isinstance(given, self._kind) else empty, {}
        if isinstance(points, LineSet):
            vars(self).update(vars(points.__copy__()))
        elif given is not self._wrapped:
            self.points, self.lines = Vector3dVector(points), Vector2iVector(lines)

    def _read(self, name: str) -> NDArray[Any]:
        values = getattr(self._wrapped, name)
        return np.zeros((0, 3)) if values is None else values

    def _token(self, native: Any, name: str) -> tuple[Any, ...] | None:
        array = getattr(native, name)
        return None if array is None else (array,)

    def _made(self, changed: list[str]) -> Any:
        colors = np.array(self.colors) if self._count("colors") == self._count("lines") > 0 else None
        return line_set.LineSet(np.array(self.points), np.array(self.lines), colors)

    @classmethod
    def create_from_axis_aligned_bounding_box(cls, box: BoxLike) -> Self:
        return cls.from_native(
            cls._kind.create_from_axis_aligned_bounding_box(unwrap(box, AxisAlignedBoundingBox, "box"))
        )

    @classmethod
    def create_from_oriented_bounding_box(cls, box: BoxLike) -> Self:
        return cls.from_native(cls._kind.create_from_oriented_bounding_box(unwrap(box, OrientedBoundingBox, "box")))

    @classmethod
    def create_from_triangle_mesh(cls, mesh: MeshLike) -> Self:
        """Unique edges of a mesh, in the order of their first triangles."""
        surface = unwrap(mesh)
        edges = surface.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
        _, first = np.unique(np.sort(edges, axis=1), axis=0, return_index=True)
        return cls(Vector3dVector(surface.vertices), Vector2iVector(edges[np.sort(first)]))

    @classmethod
    def create_from_point_cloud_correspondences(
        cls, cloud0: CloudLike, cloud1: CloudLike, correspondences: ArrayLike
    ) -> Self:
        """A line per correspondence. The points are those of `cloud0`, then `cloud1`."""
        pairs, ends, points = np.asarray(correspondences).reshape(-1, 2), [], []
        for i, name in enumerate(("cloud0", "cloud1")):
            cloud = unwrap((cloud0, cloud1)[i], PointCloud, name)
            points.append(cloud.points)
            ends.append(indices_of("correspondences", pairs[:, i], len(cloud), f"cloud of {len(cloud)} points, {name}"))
        lines = np.column_stack([ends[0], ends[1] + len(points[0])])
        return cls(Vector3dVector(np.concatenate(points)), Vector2iVector(lines))

    @classmethod
    def create_camera_visualization(cls, *args: Any, **kwargs: Any) -> Self:
        """A camera as a pyramid: (intrinsic, extrinsic, scale=1.0), or (width, height, K, extrinsic, scale=1.0)."""
        from ...cameras.camera import PinholeCameraIntrinsic

        if len(args) > 1 and np.ndim(args[0]) == 0 and isinstance(args[0], int):
            width, height, K, *rest = args
            args = (PinholeCameraIntrinsic(width, height, K), *rest)
        elif "view_width_px" in kwargs:
            size = kwargs.pop("view_width_px"), kwargs.pop("view_height_px")
            kwargs["intrinsic"] = PinholeCameraIntrinsic(*size, kwargs["intrinsic"])
        return cls.from_native(
            cls._kind.create_camera_visualization(*map(unwrap, args), **{k: unwrap(v) for k, v in kwargs.items()})
        )

    def has_points(self) -> bool:
        return self._count("points") > 0

    def has_lines(self) -> bool:
        return self.has_points() and self._count("lines") > 0

    def has_colors(self) -> bool:
        return 0 < self._count("lines") == self._count("colors")

    def is_empty(self) -> bool:
        return not self.has_points()

    def paint_uniform_color(self, color: ArrayLike) -> Self:
        return self._become(self.native.paint_uniform_color(column("color", color)))

    def get_line_coordinate(self, line_index: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        return self.native.get_line_coordinate(line_index)

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """Box along the principal axes."""
        return oriented_box(boxes.OrientedBoundingBox.create_from_points(self.native.points, robust))

    def get_minimal_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        made = OurCloud(self.native.points).get_minimal_oriented_bounding_box(robust)
        return oriented_box(made)

    def _joined(self, other: object) -> Any:
        """Both sets as one. Colors are kept if all lines have them."""
        parts = [self.native, unwrap(other, LineSet, "other")]
        made, colors = parts[0] + parts[1], [part.colors for part in parts if len(part.lines)]
        if made.colors is None and colors and all(rows is not None for rows in colors):
            return self._kind(made.points, made.lines, np.concatenate(colors))
        return made

    def __add__(self, other: object) -> LineSet:
        return LineSet.from_native(self._joined(other))

    def __iadd__(self, other: object) -> Self:
        return self._become(self._joined(other))

    def __repr__(self) -> str:
        return f"LineSet with {self._count('lines')} lines."
