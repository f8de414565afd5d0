"""SelectionPolygonVolume with assignable polygon and bounds."""

from __future__ import annotations

from ...core.attribute_hints import KnownNames
from ...core.errors import FilePath
from ...pcd import polygon_volume
from ..argument_types import CloudLike, VectorLike
from ..geometry import PointCloud, TriangleMesh
from ..vectors import Vector3dVector
from ..wrapper import as_array, unwrap


class SelectionPolygonVolume(KnownNames):
    """A polygon swept along `orthogonal_axis` from `axis_min` to `axis_max`."""

    orthogonal_axis: str
    axis_min: float
    axis_max: float
    _polygon: Vector3dVector

    def __init__(self, other: SelectionPolygonVolume | polygon_volume.SelectionPolygonVolume | None = None):
        self.orthogonal_axis = "" if other is None else other.orthogonal_axis
        self.axis_min = 0.0 if other is None else other.axis_min
        self.axis_max = 0.0 if other is None else other.axis_max
        self._polygon = Vector3dVector(() if other is None else as_array(other.bounding_polygon))

    @property
    def bounding_polygon(self) -> Vector3dVector:
        """Corners, assignable."""
        return self._polygon

    @bounding_polygon.setter
    def bounding_polygon(self, corners: VectorLike) -> None:
        self._polygon = Vector3dVector(corners)

    @property
    def native(self) -> polygon_volume.SelectionPolygonVolume:
        corners = as_array(self._polygon)
        return polygon_volume.SelectionPolygonVolume(corners, self.orthogonal_axis, self.axis_min, self.axis_max)

    def crop_point_cloud(self, input: CloudLike) -> PointCloud:
        return PointCloud.from_native(unwrap(input, PointCloud, "input").crop(self.native))

    def crop_triangle_mesh(self, input: CloudLike) -> TriangleMesh:
        """Vertices inside and the triangles between them."""
        return TriangleMesh.from_native(unwrap(input, TriangleMesh, "input").crop(self.native))

    def crop_in_polygon(self, input: CloudLike) -> list[int]:
        """Indices of the points inside."""
        return self.native.crop_in_polygon(unwrap(input, PointCloud, "input")).tolist()

    def __repr__(self) -> str:
        members = "orthogonal_axis, bounding_polygon, axis_min, axis_max"
        return f"SelectionPolygonVolume, access its members:\n{members}"


def read_selection_polygon_volume(filename: FilePath) -> SelectionPolygonVolume:
    """Read `cropped.json`."""
    return SelectionPolygonVolume(polygon_volume.SelectionPolygonVolume.from_json(filename))
