"""What the viewer holds of a geometry: `Item`; and the coordinates of the page: `Frame`."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.coordinates import box_of_finite, finite_rows
from ...kernels.arrays.bounds import bound_points
from ...kernels.memory import download
from ...pcd.cloud import PointCloud
from ..render.geometries import bounds_of, parts_of
from ..render.parts import Part, Points, Triangles
from ..render.styles import Style
from .extents import Bounds

Matrix = NDArray[np.float64]

# Extents [m] that a browser's camera works well in; others are drawn in another unit of length.
SMALLEST, LARGEST = 0.05, 1e5

SMALL = 2_000_000  # points whose bounds NumPy finds as soon

SAMPLE = 2000  # points by which it is told how far a cloud is from a camera


@dataclasses.dataclass(frozen=True, eq=False)
class Frame:
    """The coordinates of the page: about an origin, in metres or a unit in which the scene is neither tiny nor huge.

    Args:
        origin: Where the page's zero lies [m], shape [3].
        unit: Metres in one unit of the page.
    """

    origin: NDArray[np.float64]
    unit: float = 1.0

    @classmethod
    def around(cls, bounds: Bounds) -> Frame:
        """The frame about the middle of a box, in metres unless that is below 5 cm or beyond 100 km."""
        low, high = bounds
        extent = float(np.linalg.norm(high - low))
        unit = 1.0
        if extent > 0 and not SMALLEST <= extent <= LARGEST:
            unit = 10.0 ** np.floor(np.log10(extent))
        return cls((low + high) / 2, unit)

    def place(self, origin: NDArray[np.float64], pose: Matrix | None) -> tuple[Matrix | None, NDArray[np.float64]]:
        """The rotation (None: none) and the position in the page of what counts from `origin`."""
        if pose is None:
            return None, self.to_page(origin)
        return pose[:3, :3], self.to_page(pose[:3, :3] @ origin + pose[:3, 3])

    def placing(self, origin: NDArray[np.float64], pose: Matrix | None) -> dict[str, Any]:
        """The same and the scale, as nodes of the page take them."""
        R, t = self.place(origin, pose)
        return {"R": R, "t": t, "scale": 1 / self.unit}

    def to_page(self, places: NDArray[np.float64]) -> NDArray[np.float64]:
        """Places of the world [m] in the coordinates of the page."""
        return (places - self.origin) / self.unit

    def to_world(self, places: NDArray[np.float64]) -> NDArray[np.float64]:
        """Places in the page in the world [m]."""
        return places * self.unit + self.origin


@dataclasses.dataclass(eq=False)
class Item:
    """A geometry in the scene.

    Args:
        name: What it is called.
        number: What its nodes in the page are called by: names may hold anything.
        geometry: As it was given.
        style: How it is drawn.
        parts: What is drawn.
        cloud: The cloud, where points are all that is drawn.
        bounds: The lowest and highest corner of the parts [m]; None where nothing is drawn.
        visible: Whether it is shown.
        pose: Moves it, on top of the style's; 4x4 or None.
        coloring: The colours of the cloud in place of its own; None for those.
        tree: The levels of detail of a large cloud.
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
        """The part with the points, of a cloud."""
        part = self.parts[0] if self.parts else None
        return part if isinstance(part, Points) else None

    @property
    def has_surface(self) -> bool:
        """Whether there are triangles."""
        return any(isinstance(part, Triangles) for part in self.parts)

    @property
    def triangle_count(self) -> int:
        """How many triangles there are."""
        return sum(part.indices.size // 3 for part in self.parts if isinstance(part, Triangles))

    def pose_of(self, part: Part) -> Matrix | None:
        """Where a part stands."""
        if self.pose is None or part.pose is None:
            return part.pose if self.pose is None else self.pose
        return self.pose @ part.pose

    def world_bounds(self) -> Bounds | None:
        """The box around all that is drawn, moved by the pose; None where nothing is."""
        if self.bounds is None or self.pose is None:
            return self.bounds
        if self._moved is None or self._moved[0] is not self.pose:
            # the middle moves, and half the extent turns: what reaches along an axis are the parts along it
            R, t = self.pose[:3, :3], self.pose[:3, 3]
            middle, half = (self.bounds[0] + self.bounds[1]) / 2, (self.bounds[1] - self.bounds[0]) / 2
            place, reach = R @ middle + t, np.abs(R) @ half
            self._moved = self.pose, (place - reach, place + reach)
        return self._moved[1]

    @property
    def has_colors_in_tree(self) -> bool:
        """Whether only the levels of detail hold the cloud's own colours, as of a large file."""
        if self.tree is None or self.cloud is None or self.cloud.has_colors:
            return False
        return self.tree.colors_of(np.zeros(0, np.int64)) is not None

    @property
    def is_in_parts(self) -> bool:
        """Whether the cloud is the head of a tree that reads further points when a view wants them."""
        return getattr(self.tree, "is_in_parts", False)

    @property
    def point_count(self) -> int:
        """Points of the cloud, those too that are not read yet."""
        if self.cloud is None:
            return 0
        return self.tree.count if self.is_in_parts else len(self.cloud)

    def select(self, indices: Any) -> PointCloud:
        """Some points of the cloud as a cloud, with the colours of its file."""
        assert self.cloud is not None
        some = self.cloud.select_by_index(indices)
        if self.has_colors_in_tree:
            some.colors = self.tree.colors_of(np.asarray(indices, np.int64))
        return some

    def recolor(self, coloring: Any) -> None:
        """Take other colours; None for its own."""
        self.coloring, self._shown = coloring, None

    def colors_of(self, indices: Any) -> NDArray[np.uint8]:
        """The colours of points as they are shown, uint8 [k, 3]."""
        part = self.points
        assert part is not None
        if self.is_in_parts:
            return self._colors_in_parts(np.asarray(indices, np.int64), part)
        if self._shown is None:
            values = part.colors if self.coloring is None else self.coloring.colors
            if self.tree is not None and self.coloring is None and self.style.color is None and not values.size:
                found = self.tree.colors_of(indices)
                if found is not None:  # of a file, whose colours only its tree holds
                    return found
            if values.size:
                self._shown = to_bytes(download(values).reshape(-1, 3))
            else:
                self._shown = np.broadcast_to(to_bytes([part.plain]), (part.positions.size, 3))
        return self._shown[indices]

    def _colors_in_parts(self, indices: NDArray[np.int64], part: Points) -> NDArray[np.uint8]:
        """The colours of points of which only the first ones are in the cloud."""
        coloring = self.coloring
        if coloring is not None and coloring.paint is not None:
            return self.tree.paint(indices, lambda cloud: to_bytes(download(coloring.paint(cloud)).reshape(-1, 3)))
        own = self.tree.colors_of(indices) if self.style.color is None else None
        shown = np.broadcast_to(to_bytes([part.plain]), (len(indices), 3)) if own is None else own
        if coloring is not None:  # colours that are given point by point, for the first ones
            shown, known = shown.copy(), indices < len(self.cloud or ())
            shown[known] = to_bytes(download(coloring.colors).reshape(-1, 3)[indices[known]])
        return shown

    def label_counts(self, name: str) -> dict[int, int]:
        """How many points have each value of an attribute of whole numbers; none of another cloud's attribute."""
        if self.cloud is None or name not in self.cloud.attributes:
            return {}
        if self._label_counts is None or self._label_counts[0] != name:
            values, numbers = np.unique(np.asarray(self.cloud[name]), return_counts=True)
            self._label_counts = name, dict(zip(map(int, values), map(int, numbers), strict=True))
        return self._label_counts[1]

    def sample(self) -> NDArray[np.float64]:
        """Some of the cloud's points where they stand in the world, shape [k, 3] [m]."""
        part = self.points
        assert part is not None
        if self._sample is None:
            step = max(1, part.positions.size // SAMPLE)
            some = download(part.positions).reshape(-1, 3)[::step].astype(np.float64)
            self._sample = some[finite_rows(some)] + part.origin
        pose = self.pose_of(part)
        return self._sample if pose is None else self._sample @ pose[:3, :3].T + pose[:3, 3]


def make_item(name: str, number: int, geometry: Any, style: Style, tree: Any = None) -> Item:
    """What the viewer holds of a geometry, and of a cloud perhaps its levels of detail.

    Raises:
        TypeError: Of no kind that is drawn.
        ValueError: Arrays that do not belong together.
    """
    parts = parts_of(geometry, style)
    cloud = None
    if len(parts) == 1 and isinstance(parts[0], Points):
        cloud = geometry if isinstance(geometry, PointCloud) else _cloud_of(parts[0])
    return Item(name, number, geometry, style, parts, cloud, _bounds(parts), tree=tree)


def _bounds(parts: list[Part]) -> Bounds | None:
    """The box around parts; None where nothing is drawn."""
    one = parts[0] if len(parts) == 1 and parts[0].pose is None else None
    if one is not None and one.positions.device.is_cpu and 0 < one.positions.size <= SMALL:
        # the first launch of a kernel starts its compiler, which takes longer than all else before the first picture
        rows = download(one.positions).reshape(-1, 3)
        box = box_of_finite(rows)
        return None if box is None else (box[0] + one.origin, box[1] + one.origin)
    drawn = [part for part in parts if part.positions.size and bound_points(part.positions)[2]]
    return bounds_of(drawn) if drawn else None


def _cloud_of(part: Points) -> PointCloud:
    """The cloud of points that came as an array or a plain object."""
    held = {"normals": part.normals, "colors": part.colors}
    rows: dict[str, Any] = {
        name: np.nan_to_num(download(values)).reshape(-1, 3) for name, values in held.items() if values.size
    }
    if "colors" in rows:
        rows["colors"] = np.clip(rows["colors"], 0, 1)
    return PointCloud(download(part.positions).reshape(-1, 3) + part.origin, **rows)


def to_bytes(colors: Any) -> NDArray[np.uint8]:
    """Colours 0 to 1 as uint8; what is out of range is cut, what is no number is black."""
    values = np.nan_to_num(np.asarray(colors, np.float32), nan=0.0, posinf=1.0, neginf=0.0)
    return (np.clip(values, 0, 1) * np.float32(255) + np.float32(0.5)).astype(np.uint8)
