"""Boxes from detected planes that are perpendicular and touch."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.argument_errors import explain_argument_errors
from ..core.checks import check_positive, shown
from ..core.quaternions import nearest_rotations
from ..core.reports import Assessed, quality
from ..kernels.arrays.sort import positions
from ..kernels.lang import int32
from ..kernels.linear_algebra import det, matmul, norm
from ..kernels.memory import upload
from ..kernels.segmentation.shape_parts import bounds_in_frame, heights_across, rows_labeled
from .cloud import PointCloud
from .point_arrays import check_cloud
from .shape import Shape, ShapeSurface
from .shape_detection import DetectedShapes

UNIT_CORNERS = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], np.float64)
SIDE_CORNERS = np.array(  # corners counterclockwise from outside: low and high of each axis
    [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]
)
HEIGHT_STEPS = 1000  # of the contact distance: heights are integers
MAX_DEGREES = 30.0  # beyond it a plane may be perpendicular to two axes
MIN_EDGE_OVERLAP = 0.5  # required overlap of two faces along their edge, of the shorter one


@dataclass(frozen=True, eq=False)
class BoxShape(Assessed):
    """A box whose faces were detected as planes.

    Attributes:
        center: World coordinates [m], float64 (3,).
        axes: Unit edge directions as rows, right-handed, float64 (3, 3).
        size: Lengths along the axes [m], float64 (3,).
        faces: Shape indices of the low and high face of each axis, -1 if not detected, (3, 2).
        support, rms: Points on the faces, and root mean squared distance from their planes [m].
        tilt: Maximum angle between a face's normal and its axis [rad].
        warnings: Failed quality checks. Empty if the box is reliable.

    Example:
        >>> import pointloom as loom
        >>> cube = loom.TriangleMesh.create_box().sample_points_uniformly(6000, seed=1).estimate_normals()
        >>> (box,) = loom.find_boxes(cube, loom.detect_shapes(cube, 0.01, kinds="plane"), 0.04)
        >>> box.reliable, int((box.faces >= 0).sum()), loom.TriangleMesh(*box.to_mesh()).is_watertight()
        (True, 6, True)
    """

    center: NDArray[np.float64]
    axes: NDArray[np.float64]
    size: NDArray[np.float64]
    faces: NDArray[np.int32]
    support: int
    rms: float
    tilt: float
    warnings: tuple[str, ...]

    def to_mesh(self) -> ShapeSurface:
        """Six faces as twelve triangles: `loom.TriangleMesh(*box.to_mesh())`."""
        vertices = self.center + matmul((UNIT_CORNERS - 0.5) * self.size, self.axes)
        return ShapeSurface(
            vertices, np.concatenate([SIDE_CORNERS[:, :3], SIDE_CORNERS[:, [0, 2, 3]]]).astype(np.int32)
        )

    def to_dict(self) -> dict[str, Any]:
        arrays = {name: getattr(self, name).tolist() for name in ("center", "axes", "size", "faces")}
        return {"kind": "box", **arrays, "support": self.support, "rms": self.rms, "tilt": self.tilt, **quality(self)}

    def __str__(self) -> str:
        size = " x ".join(f"{length:.4g}" for length in self.size)
        parts = [f"{size} m", f"{int((self.faces >= 0).sum())} faces seen", f"{self.support:,} points"]
        return f"box: {', '.join(parts)}, rms {self.rms:.3g} m" + "".join(f"; {warning}" for warning in self.warnings)

    def __repr__(self) -> str:
        return f"BoxShape({self})"


@explain_argument_errors
def find_boxes(
    cloud: PointCloud, shapes: DetectedShapes, distance_threshold: float = 0.01, angle_threshold_deg: float = 3.0
) -> list[BoxShape]:
    """Combine detected planes into boxes: cartons, beams, buildings, or a room seen from inside.

    Faces are neighbors if perpendicular, in contact, and each on one side of the other. A box starts at the largest
    plane and has at most two faces per axis. Ends without a face are where 98% of the points reach, extrapolated for
    even spread. Bitwise reproducible. 8 B per pair of planes.

    Args:
        cloud: The cloud of the shapes.
        shapes: Result of `detect_shapes`.
        distance_threshold: Maximum gap between faces, and overlap beyond an edge [m]; four times that of
            `detect_shapes`.
        angle_threshold_deg: Maximum deviation from a right angle [degrees].

    Returns:
        The boxes, most points first. A shape belongs to at most one. `box.warnings` names lengths that are only the
        extent of points, because no face limits them.

    Raises:
        ValueError: If `shapes` belongs to another cloud, or a threshold is out of range.
        TypeError: If `shapes` is not a result of `detect_shapes`.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> carton = loom.TriangleMesh.create_box(0.4, 0.3, 0.2).sample_points_uniformly(6000, seed=1)
        >>> carton = carton.estimate_normals()
        >>> shapes = loom.detect_shapes(carton, 0.005, kinds="plane")
        >>> [np.sort(box.size).round(2).tolist() for box in loom.find_boxes(carton, shapes, 0.02)]
        [[0.2, 0.3, 0.4]]
    """
    check_cloud("cloud", cloud)
    if not isinstance(shapes, DetectedShapes):
        raise TypeError(f"shapes: expected the DetectedShapes from detect_shapes, got {type(shapes).__name__}")
    if len(shapes.labels) != len(cloud):
        raise ValueError(f"shapes: expected shapes of a cloud of {len(cloud):,} points, got {len(shapes.labels):,}")
    gap = check_positive("distance_threshold", distance_threshold)
    angle = check_positive("angle_threshold_deg", angle_threshold_deg)
    if angle > MAX_DEGREES:
        raise ValueError(f"angle_threshold_deg: expected up to {MAX_DEGREES:g}, got {shown(angle_threshold_deg)}")
    planes = {k: shape for k, shape in enumerate(shapes.shapes) if shape.kind == "plane"}
    free, groups = sorted(planes, key=lambda k: (-planes[k].support, k)), []
    if len(free) < 2 or not len(cloud):
        return []
    sides = _Sides(cloud, shapes, planes, gap)
    while free:
        group = _group_of(free[0], free, planes, sides, float(np.sin(np.radians(angle))))
        free = [k for k in free if k not in group]
        if len(group) > 1:
            groups.append(group)
    boxes = [_box_of(cloud, shapes, planes, group) for group in groups]
    return sorted(boxes, key=lambda box: -box.support)


class _Sides:
    """Side of each plane that the points of each other plane are on."""

    def __init__(self, cloud: PointCloud, detected: DetectedShapes, planes: dict[int, Shape], gap: float) -> None:
        self._number = {k: n for n, k in enumerate(planes)}
        self.gap = gap
        numbers = np.full(len(detected.shapes) + 1, -1, np.int32)  # the last is that of label -1
        numbers[list(planes)] = np.arange(len(planes))
        centers = np.array([plane.center - cloud.origin for plane in planes.values()])
        normals = np.array([plane.axis for plane in planes.values()])
        points = cloud.arrays["points"]
        self._low, self._high = heights_across(points, numbers[detected.labels], centers, normals, gap / HEIGHT_STEPS)

    def side(self, plane: int, other: int) -> int:
        """1 or -1 if all points of `other` are on one side of `plane`, else 0."""
        at = self._number[other], self._number[plane]
        return 1 if self._low[at] >= -self.gap else -1 if self._high[at] <= self.gap else 0

    def touch(self, plane: int, other: int) -> bool:
        pairs = ((self._number[a], self._number[b]) for a, b in ((plane, other), (other, plane)))
        return all(self._low[at] <= self.gap and self._high[at] >= -self.gap for at in pairs)


def _group_of(first: int, free: list[int], planes: dict[int, Shape], sides: _Sides, off: float) -> dict[int, int]:
    """Axis, 0 to 2, of each plane of the box with the plane `first`. Only that plane if there is no box."""
    group, axes, grown = {first: 0}, [planes[first].axis], True
    while grown:
        grown = False
        for k in free:
            if k in group:
                continue
            along = [abs(float(matmul(planes[k].axis, axis))) for axis in axes]
            near = [n for n, cosine in enumerate(along) if cosine >= np.sqrt(1 - off * off)]
            if not near and (len(axes) == 3 or max(along) > off):
                continue
            number = near[0] if near else len(axes)
            if _fits(k, number, group, sides):
                group[k], grown = number, True
                axes += [] if near else [planes[k].axis]
    return group


def _fits(k: int, number: int, group: dict[int, int], sides: _Sides) -> bool:
    """True if a plane touches a face of the box and all planes are on one side of each other."""
    if not any(sides.touch(k, other) for other in group if group[other] != number):
        return False
    faces = [*group, k]
    for face in faces:
        used_sides = {sides.side(face, other) for other in faces if other != face}
        if len(used_sides) != 1 or 0 in used_sides:
            return False
    same = [other for other in group if group[other] == number]
    return not same or (len(same) == 1 and not sides.touch(k, same[0]))


def _axes_of(planes: dict[int, Shape], group: dict[int, int]) -> NDArray[np.float64]:
    """Rotation nearest to the normals of a group, weighted by points."""
    sums = np.zeros((3, 3))
    for k, number in group.items():
        way = np.sign(matmul(sums[number], planes[k].axis)) or 1.0
        sums[number] += way * planes[k].support * planes[k].axis
    if not sums[2].any():
        sums[2] = np.cross(sums[0], sums[1])
        sums[2] *= planes[next(iter(group))].support / norm(sums[2])
    if det(sums) < 0:
        sums[2] = -sums[2]
    return nearest_rotations(sums[None])[0]


def _box_of(cloud: PointCloud, detected: DetectedShapes, planes: dict[int, Shape], group: dict[int, int]) -> BoxShape:
    """Box of a group of faces. Open ends come from the extent of the points."""
    axes, points = _axes_of(planes, group), cloud.arrays["points"]
    labels, every = upload(detected.labels, int32, points.device), positions(len(cloud), points.device)
    reference = planes[next(iter(group))].center
    extents = {
        k: np.array(bounds_in_frame(points, rows_labeled(labels, every, k), reference - cloud.origin, axes))
        for k in group
    }
    ends, faces, messages = np.zeros((3, 2)), np.full((3, 2), -1, np.int32), []
    for number in range(3):
        across = [extents[k][:, number] for k in group if group[k] != number]
        bounds = [min(bound[0] for bound in across), max(bound[1] for bound in across)]
        for k in (k for k in group if group[k] == number):
            height = float(matmul(planes[k].center - reference, axes[number]))
            side = int(abs(height - bounds[1]) < abs(height - bounds[0]))
            bounds[side], faces[number, side] = height, k
        ends[number] = bounds
        if (faces[number] < 0).all():
            length = f"{bounds[1] - bounds[0]:.4g} m"
            messages.append(f"size open: no face across axis {number} is visible, {length} is the extent of the points")
    size, total = ends[:, 1] - ends[:, 0], sum(planes[k].support for k in group)
    tilts = [float(norm(np.cross(planes[k].axis, axes[number]))) for k, number in group.items()]
    messages += [f"face {k}: {warning}" for k in group for warning in planes[k].warnings]
    messages += _apart(group, extents)
    return BoxShape(
        center=reference + matmul(ends.mean(axis=1), axes),
        axes=axes,
        size=size,
        faces=faces,
        support=total,
        rms=float(np.sqrt(sum(planes[k].support * planes[k].rms ** 2 for k in group) / total)),
        tilt=math.asin(min(1.0, max(tilts))),
        warnings=tuple(messages),
    )


def _apart(group: dict[int, int], extents: dict[int, NDArray[np.float64]]) -> list[str]:
    """Faces that share an edge's line, but no part of it."""
    messages = []
    for k in group:
        for other in (other for other in group if other > k and group[other] != group[k]):
            (along,) = {0, 1, 2} - {group[k], group[other]}
            (a0, a1), (b0, b1) = extents[k][:, along], extents[other][:, along]
            if min(a1, b1) - max(a0, b0) < MIN_EDGE_OVERLAP * min(a1 - a0, b1 - b0):
                messages.append(f"faces {k} and {other} are separated along their edge")
    return messages
