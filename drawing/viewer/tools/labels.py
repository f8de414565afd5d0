"""Labels painted onto the points of a cloud: which points a shape on the screen means, and what was painted."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....core.checks import check_name
from ....kernels.drawing.picking import mask_seen
from ....kernels.lang import vec2d, vec3
from ....kernels.memory import download, upload
from ....pcd.cloud import PointCloud
from ...render.coloring import Coloring, label_color, name_labels
from ...render.view import View
from .picking import T_camera_points, Target

Color = tuple[int, int, int]

BRUSH_CORNERS = 32
HIGHEST = 255  # label: a byte a point, as of LAS
CELL = 4.0  # [px] of the grid in which the foremost point hides what lies behind it
STEEPNESS = 10.0  # lengths as wide as a cell that a point may lie behind the foremost one and still be seen


@dataclasses.dataclass(frozen=True)
class Label:
    """A class that is painted: its number in the attribute, what it is called, red, green and blue 0 to 255."""

    number: int
    name: str
    color: Color


def usual_labels(attribute: str, labels: Iterable[int]) -> dict[int, Label]:
    """Classes by number: those that are there, and the standard's usual ones under the name "classification"."""
    numbers = sorted({*(int(k) for k in labels if 0 <= k <= HIGHEST), *_FIRST.get(attribute, range(3))})
    names = name_labels(numbers, attribute)
    return {k: Label(k, names[k], to_color(label_color(k))) for k in numbers}


def to_color(share: Any) -> Color:
    """Red, green and blue of 0 to 1 as bytes."""
    red, green, blue = (round(255 * float(c)) for c in share)
    return red, green, blue


_FIRST = {"classification": (0, 1, 2, 3, 4, 5, 6, 7, 9)}  # of LAS: what is given to points most often


def brush(x: float, y: float, radius: float) -> NDArray[np.float64]:
    """A round brush on the screen as a polygon of the same area [px], shape [32, 2]."""
    angles = 2 * math.pi * np.arange(BRUSH_CORNERS) / BRUSH_CORNERS
    reach = radius * math.sqrt(2 * math.pi / BRUSH_CORNERS / math.sin(2 * math.pi / BRUSH_CORNERS))
    return np.column_stack([x + reach * np.cos(angles), y + reach * np.sin(angles)])


def meant_points(
    target: Target, others: Iterable[Target], view: View, polygon: NDArray[np.float64], *, through: bool
) -> NDArray[np.int64]:
    """The points of a cloud that a shape on the screen means, ascending.

    Args:
        target: The cloud; points that it hides are never meant.
        others: What else is in the scene and may lie before it: clouds.
        view: Where the shape was drawn.
        polygon: Its corners [px], shape [m, 2]; the even-odd rule says what is inside.
        through: Whether points that lie behind others are meant as well.

    Notes:
        A point is seen where no other in its square of 4 pixels lies more than ten of them nearer, as picking has it;
        so surfaces count to 84 degrees of slope, and points of a second surface close behind the first one, too.
        Surfaces of triangles hide nothing.
    """
    indices, places, depths = _inside(target, view, polygon)
    if through or not len(indices):
        return indices
    low, high = polygon.min(axis=0) - CELL, polygon.max(axis=0) + CELL  # cells at the edge need all of their points
    around = np.array([[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]])
    cells, nearer = [_cells(places)], [depths]
    for other in (target, *others):
        if other.cloud is not None and len(other.cloud):
            _, beside, before = _inside(other, view, around)
            cells.append(_cells(beside))
            nearer.append(before)
    _, numbers = np.unique(np.concatenate(cells), return_inverse=True)
    foremost = np.full(int(numbers.max()) + 1, np.inf)
    np.minimum.at(foremost, numbers, np.concatenate(nearer))
    nearest = foremost[numbers[: len(indices)]]
    reach = STEEPNESS * CELL * nearest / view.intrinsic.fx
    return indices[depths <= nearest + reach]


def _inside(target: Target, view: View, polygon: NDArray[np.float64]) -> tuple[Any, Any, Any]:
    """Which points of a cloud lie in a polygon on the screen, hidden ones left out; their pixels and depths."""
    cloud = target.cloud
    assert cloud is not None
    T = T_camera_points(view, cloud, np.eye(4) if target.pose is None else np.asarray(target.pose, np.float64))
    corners = upload(polygon, vec2d, cloud.device)
    mask = download(mask_seen(cloud.device_array("points"), T, view.intrinsic, corners)) != 0  # sync
    if target.hidden is not None:
        mask &= download(target.hidden) == 0
    indices = np.flatnonzero(mask)
    rows = download(cloud.device_array("points")).reshape(-1, 3)[indices].astype(np.float64)
    local = rows @ T[:3, :3].T + T[:3, 3]
    camera = view.intrinsic
    pixels = np.column_stack(
        [camera.fx * local[:, 0] / local[:, 2] + camera.cx, camera.fy * local[:, 1] / local[:, 2] + camera.cy]
    )
    return indices, pixels, local[:, 2]


def _cells(places: NDArray[np.float64]) -> NDArray[np.int64]:
    at = np.floor(places / CELL).astype(np.int64)
    return at[:, 1] * (1 << 24) + at[:, 0]


@dataclasses.dataclass(frozen=True, eq=False)
class Stroke:
    """What one gesture changed, so that it can be taken back.

    Attributes:
        indices: The points that changed.
        before: Their labels then.
        label: Their label now.
    """

    indices: NDArray[np.int32]
    before: NDArray[np.uint8]
    label: int

    @property
    def nbytes(self) -> int:
        """The memory that it takes."""
        return self.indices.nbytes + self.before.nbytes


class Painting:
    """Labels of the points of one cloud while they are painted.

    Args:
        attribute: What they are called in the cloud.
        count: Points of the cloud.
        labels: What is there already, whole numbers from 0 to 255, shape [n]; None begins with 0 everywhere.

    Attributes:
        labels: uint8 [n].
        classes: By number.
        unsaved: Gestures since the labels were saved.

    Raises:
        ValueError: Labels that do not fit into a byte, or another shape.

    Example:
        >>> painting = Painting("label", 5)
        >>> stroke = painting.paint([1, 3], 2)
        >>> painting.labels.tolist(), painting.unsaved
        ([0, 2, 0, 2, 0], 1)
        >>> painting.take_back(stroke)
        >>> painting.labels.tolist()
        [0, 0, 0, 0, 0]
    """

    def __init__(self, attribute: str, count: int, labels: Any = None):
        self.attribute = check_name("attribute", attribute)
        given = np.zeros(count, np.uint8) if labels is None else np.asarray(labels)
        if given.shape != (count,) or given.dtype.kind not in "biu":
            raise ValueError(f"{attribute}: expected a whole number a point, got {given.dtype} {list(given.shape)}")
        if len(given) and not (int(given.min()) >= 0 and int(given.max()) <= HIGHEST):
            low, high = int(given.min()), int(given.max())
            raise ValueError(f"{attribute}: labels of 0 to 255 are painted, these go from {low} to {high}")
        self.labels = given.astype(np.uint8)
        self.classes = usual_labels(attribute, np.unique(self.labels))
        self.unsaved = 0

    def add_class(self, number: int, name: str, color: Color) -> Label:
        """Another class, or another name and colour of one.

        Raises:
            ValueError: A number that does not fit into a byte, or no name.
        """
        if not 0 <= number <= HIGHEST:
            raise ValueError(f"class: expected a number from 0 to {HIGHEST}, got {number}")
        self.classes[number] = Label(number, check_name("name", name), color)
        return self.classes[number]

    def free_number(self) -> int:
        """The least number of no class.

        Raises:
            ValueError: All are taken.
        """
        for number in range(HIGHEST + 1):
            if number not in self.classes:
                return number
        raise ValueError("class: all numbers from 0 to 255 are taken")

    def paint(self, indices: Any, label: int) -> Stroke:
        """Give points a label; the stroke holds those that had another."""
        rows = np.asarray(indices, np.int64)
        rows = rows[self.labels[rows] != label]
        stroke = Stroke(rows.astype(np.int32), self.labels[rows], label)
        self.redo(stroke)
        return stroke

    def take_back(self, stroke: Stroke) -> None:
        """Give the points of a stroke back what they had."""
        self.labels[stroke.indices] = stroke.before
        self.unsaved += 1

    def redo(self, stroke: Stroke) -> None:
        """Paint a stroke again."""
        self.labels[stroke.indices] = stroke.label
        self.unsaved += 1

    def table(self) -> NDArray[np.uint8]:
        """The colour of each label, uint8 [256, 3]."""
        colors = np.array([to_color(label_color(k)) for k in range(HIGHEST + 1)], np.uint8)
        for label in self.classes.values():
            colors[label.number] = label.color
        return colors

    def colors_of(self, indices: Any) -> NDArray[np.uint8]:
        """The colours of points, uint8 [k, 3]."""
        return self.table()[self.labels[indices]]

    def usual_color(self, number: int) -> Color:
        """The colour that a label has unless it is given another."""
        return to_color(label_color(number))

    def coloring(self, device: Any) -> Coloring:
        """The colours of all points, and what they mean; 12 B a point."""
        shares = self.table().astype(np.float32) / np.float32(255)
        there = [number for number, count in self.counts().items() if count]
        names = name_labels(there, self.attribute) | {k: label.name for k, label in self.classes.items() if k in there}
        colors = {k: (float(shares[k, 0]), float(shares[k, 1]), float(shares[k, 2])) for k in there}
        values = upload(shares[self.labels], vec3, device)
        return Coloring(values, "labels", names=names, title=self.attribute, label_colors=colors)

    def counts(self) -> dict[int, int]:
        """How many points have each class, those with none too."""
        found = np.bincount(self.labels, minlength=HIGHEST + 1)
        return {number: int(found[number]) for number in sorted({*self.classes, *np.flatnonzero(found).tolist()})}

    def on(self, cloud: PointCloud) -> PointCloud:
        """A cloud with the labels as an attribute, which shares all else with the one that is given."""
        arrays = {name: cloud.device_array(name) for name in ("points", *_VECTORS) if name in cloud}
        arrays |= {name: cloud.device_array(name) for name in cloud.attributes if name != self.attribute}
        painted = PointCloud.from_device_arrays(arrays, cloud.origin)
        painted[self.attribute] = self.labels
        painted.unit = cloud.unit
        return painted


_VECTORS = ("normals", "colors")
