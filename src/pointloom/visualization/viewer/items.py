"""Geometries in the viewer (`Item`) and the coordinates of the page (`Frame`)."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.coordinates import box_of_finite, finite_rows
from ...kernels.arrays.bounds import bound_points
from ...kernels.memory import download
from ...pcd.cloud import PointCloud
from ..render.coloring import Coloring
from ..render.geometries import bounds_of, parts_of
from ..render.parts import Part, Points, Triangles
from ..render.styles import Style
from .extents import Bounds

if TYPE_CHECKING:
    from .copc_tree import CopcTree
    from .detail_tree import DetailTree


Matrix = NDArray[np.float64]

# Extents [m] suitable for a browser's camera. Otherwise the page uses another unit.
MIN_EXTENT, MAX_EXTENT = 0.05, 1e5

MAX_NUMPY_POINTS = 2_000_000  # NumPy finds the bounds of fewer points as fast

MAX_SAMPLE_POINTS = 2000  # points that estimate the distance of a cloud from a camera


@dataclasses.dataclass(frozen=True, eq=False)
class Frame:
    """Coordinates of the page, scaled so that the scene is neither tiny nor huge.

    `origin` is the world position of the page's origin [m], `unit` the meters per page unit.
    """

    origin: NDArray[np.float64]
    unit: float = 1.0

    @classmethod
    def around(cls, bounds: Bounds) -> Frame:
        """Frame at the center of a box. In meters unless its size is below 5 cm or above 100 km."""
        low, high = bounds
        extent = float(np.linalg.norm(high - low))
        unit = 1.0
        if extent > 0 and not MIN_EXTENT <= extent <= MAX_EXTENT:
            unit = 10.0 ** np.floor(np.log10(extent))
        return cls((low + high) / 2, unit)

    def pose_in_page(
        self, origin: NDArray[np.float64], pose: Matrix | None
    ) -> tuple[Matrix | None, NDArray[np.float64]]:
        """Rotation (None: identity) and position in the page for positions relative to `origin`."""
        if pose is None:
            return None, self.to_page(origin)
        return pose[:3, :3], self.to_page(pose[:3, :3] @ origin + pose[:3, 3])

    def placing(self, origin: NDArray[np.float64], pose: Matrix | None) -> dict[str, Any]:
        """The same with scale, as properties of a node."""
        R, t = self.pose_in_page(origin, pose)
        return {"R": R, "t": t, "scale": 1 / self.unit}

    def to_page(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        return (points - self.origin) / self.unit

    def to_world(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        return points * self.unit + self.origin


@dataclasses.dataclass(eq=False)
class Item:
    """A geometry in the scene. Names are arbitrary, so its nodes in the page use `number`.

    `cloud` is set if all parts are points, `bounds` are None if empty, `pose` (4x4) is applied after the style's pose,
    `coloring` replaces the cloud's own colors, and `tree` has the levels of detail of a large cloud.
    """

    name: str
    number: int
    geometry: Any
    style: Style
    parts: list[Part]
    cloud: PointCloud | None = None
    bounds: Bounds | None = None
    visible: bool = True
    pose: Matrix | None = None
    coloring: Any = None
    tree: Any = None

    def __post_init__(self):
        self._shown: NDArray[np.uint8] | None = None
        self._label_counts: tuple[str, dict[int, int]] | None = None
        self._moved: tuple[Matrix | None, Bounds | None] | None = None
        self._sample: NDArray[np.float64] | None = None

    @property
    def points(self) -> Points | None:
        part = self.parts[0] if self.parts else None
        return part if isinstance(part, Points) else None

    @property
    def has_surface(self) -> bool:
        return any(isinstance(part, Triangles) for part in self.parts)

    @property
    def triangle_count(self) -> int:
        return sum(part.indices.size // 3 for part in self.parts if isinstance(part, Triangles))

    def pose_of(self, part: Part) -> Matrix | None:
        if self.pose is None or part.pose is None:
            return part.pose if self.pose is None else self.pose
        return self.pose @ part.pose

    def world_bounds(self) -> Bounds | None:
        """Bounds of all parts with the pose. None if empty."""
        if self.bounds is None or self.pose is None:
            return self.bounds
        if self._moved is None or self._moved[0] is not self.pose:
            # the center moves and half the extent rotates: the extent along an axis is the sum of absolute components
            R, t = self.pose[:3, :3], self.pose[:3, 3]
            middle, half = (self.bounds[0] + self.bounds[1]) / 2, (self.bounds[1] - self.bounds[0]) / 2
            center, half_extent = R @ middle + t, np.abs(R) @ half
            self._moved = self.pose, (center - half_extent, center + half_extent)
        return self._moved[1]

    @property
    def has_colors_in_tree(self) -> bool:
        """True if only the levels of detail store the original colors, as for a large file."""
        if self.tree is None or self.cloud is None or self.cloud.has_colors:
            return False
        return self.tree.colors_of(np.zeros(0, np.int64)) is not None

    @property
    def is_in_parts(self) -> bool:
        """True if the tree reads more points on demand."""
        return getattr(self.tree, "is_in_parts", False)

    @property
    def point_count(self) -> int:
        """Number of points, including those not read yet."""
        if self.cloud is None:
            return 0
        return self.tree.count if self.is_in_parts else len(self.cloud)

    def select(self, indices: Any) -> PointCloud:
        """Points by index as a cloud, with the colors of the file."""
        assert self.cloud is not None
        some = self.cloud.select_by_index(indices)
        if self.has_colors_in_tree:
            some.colors = self.tree.colors_of(np.asarray(indices, np.int64))
        return some

    def recolor(self, coloring: Coloring | None) -> None:
        self.coloring, self._shown = coloring, None

    def colors_of(self, indices: Any) -> NDArray[np.uint8]:
        """Displayed colors of points, uint8 (k, 3)."""
        part = self.points
        assert part is not None
        if self.is_in_parts:
            return self._colors_in_parts(np.asarray(indices, np.int64), part)
        if self._shown is None:
            values = part.colors if self.coloring is None else self.coloring.colors
            if self.tree is not None and self.coloring is None and self.style.color is None and not values.size:
                colors = self.tree.colors_of(indices)
                if colors is not None:  # the colors of a file are stored in its tree only
                    return colors
            if values.size:
                self._shown = to_bytes(download(values).reshape(-1, 3))
            else:
                self._shown = np.broadcast_to(to_bytes([part.plain]), (part.positions.size, 3))
        return self._shown[indices]

    def _colors_in_parts(self, indices: NDArray[np.int64], part: Points) -> NDArray[np.uint8]:
        """Displayed colors of points of a partly read cloud."""
        coloring = self.coloring
        if coloring is not None and coloring.paint is not None:
            return self.tree.paint(indices, lambda cloud: to_bytes(download(coloring.paint(cloud)).reshape(-1, 3)))
        own = self.tree.colors_of(indices) if self.style.color is None else None
        shown = np.broadcast_to(to_bytes([part.plain]), (len(indices), 3)) if own is None else own
        if coloring is not None:  # colors given per point for the first ones
            shown, known = shown.copy(), indices < len(self.cloud or ())
            shown[known] = to_bytes(download(coloring.colors).reshape(-1, 3)[indices[known]])
        return shown

    def label_counts(self, name: str) -> dict[int, int]:
        """Number of points of each value of an integer attribute. Empty if there is no such attribute."""
        if self.cloud is None or name not in self.cloud.attributes:
            return {}
        if self._label_counts is None or self._label_counts[0] != name:
            values, numbers = np.unique(np.asarray(self.cloud[name]), return_counts=True)
            self._label_counts = name, dict(zip(map(int, values), map(int, numbers), strict=True))
        return self._label_counts[1]

    def sample(self) -> NDArray[np.float64]:
        """Sample of the cloud's points in the world, shape (k, 3) [m]."""
        part = self.points
        assert part is not None
        if self._sample is None:
            step = max(1, part.positions.size // MAX_SAMPLE_POINTS)
            some = download(part.positions).reshape(-1, 3)[::step].astype(np.float64)
            self._sample = some[finite_rows(some)] + part.origin
        pose = self.pose_of(part)
        return self._sample if pose is None else self._sample @ pose[:3, :3].T + pose[:3, 3]


def make_item(
    name: str, number: int, geometry: object, style: Style, tree: CopcTree | DetailTree | None = None
) -> Item:
    """Make an item. Raises TypeError if it cannot be drawn and ValueError for inconsistent arrays."""
    parts = parts_of(geometry, style)
    cloud = None
    if len(parts) == 1 and isinstance(parts[0], Points):
        cloud = geometry if isinstance(geometry, PointCloud) else _cloud_of(parts[0])
    return Item(name, number, geometry, style, parts, cloud, _bounds(parts), tree=tree)


def _bounds(parts: list[Part]) -> Bounds | None:
    one = parts[0] if len(parts) == 1 and parts[0].pose is None else None
    if one is not None and one.positions.device.is_cpu and 0 < one.positions.size <= MAX_NUMPY_POINTS:
        # a kernel's first launch compiles it, which takes longer than all else before the first image
        rows = download(one.positions).reshape(-1, 3)
        box = box_of_finite(rows)
        return None if box is None else (box[0] + one.origin, box[1] + one.origin)
    drawn = [part for part in parts if part.positions.size and bound_points(part.positions)[2]]
    return bounds_of(drawn) if drawn else None


def _cloud_of(part: Points) -> PointCloud:
    """The cloud of points given as an array or a plain object."""
    arrays = {"normals": part.normals, "colors": part.colors}
    rows: dict[str, Any] = {
        name: np.nan_to_num(download(values)).reshape(-1, 3) for name, values in arrays.items() if values.size
    }
    if "colors" in rows:
        rows["colors"] = np.clip(rows["colors"], 0, 1)
    return PointCloud(download(part.positions).reshape(-1, 3) + part.origin, **rows)


def to_bytes(colors: ArrayLike) -> NDArray[np.uint8]:
    """Colors from 0 to 1 as uint8; clipped, NaN is black."""
    values = np.nan_to_num(np.asarray(colors, np.float32), nan=0.0, posinf=1.0, neginf=0.0)
    return (np.clip(values, 0, 1) * np.float32(255) + np.float32(0.5)).astype(np.uint8)
