"""Detection of objects fixed to the camera, such as a gripper, a hand or a bumper, in cells of the image.

Cells that keep their depth and brightness while the camera moves are candidates. The motion is estimated without them.
A candidate is fixed to the camera if the motion of the scene contradicts it: at the predicted position, depth or
brightness differ.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.lang import uint8
from ...kernels.linear_algebra import matmul, norm
from ...kernels.memory import upload
from ...kernels.rgbd.alignment import align_levels
from ...kernels.rgbd.stream_views import CELLS_PER_ROW, StreamView, hide_cells
from ...registration.rigid import invert_pose, rotation_vector
from ..odometry.alignment import OdometryMethod, descent
from ..odometry.motion_checks import judge
from .frame_checks import FIRM_OVERLAP, MIN_EIGENVALUE
from .frames import SensorFrame

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]

FROM_FIRST = 12  # frames that are compared with the first one, and all checked
REFERENCE_DISTANCE = 8  # frames back to the reference of later ones
CHECK_INTERVAL = 4  # frames between later checks
SAME_DEPTH = 0.02  # relative depth difference of an unchanged cell: sensor noise of a cell up to 0.007
SAME_SHADE = 0.03  # brightness difference, 0..1; noise of a cell up to 0.004
PREDICTED_TOLERANCE = 2.0  # factor of both at the predicted position
MIN_SHIFT, MIN_ROTATION = 0.03, np.deg2rad(1.5)  # [m], [rad] minimum motion of the camera
MIN_FIXED = 0.25  # minimum fraction of the unchanged cells that are contradicted: scenes up to 0.15 | objects 0.37
# Minimum ratio to that of changed cells, at edges of the scene: scenes up to 0.7 | objects 1.8 and more
MIN_CHANGED_RATIO = 1.5
MIN_CELLS = 0.02  # minimum fraction of measured cells
MIN_AGREEMENT = 0.9  # fraction of the rest on the earlier surface
MAX_FILLED_GAP = 2  # [cells] gaps that are filled
MAX_CHANGED = 0.5  # fraction of changed cells at which the object has gone


@dataclasses.dataclass(frozen=True, eq=False)
class Look:
    """A frame with its cells: `nearness` [1/m] and `shade` (rows, columns)."""

    frame: SensorFrame
    nearness: NDArray[np.float32]
    shade: NDArray[np.float32]
    pose: Floats | None = None


class FixedParts:
    """Finds cells that move with the camera.

    Attributes:
        hidden: The excluded cells of the last frame, bool (rows, columns). None if there are none.
        note: Description of the last object. Empty if there was none.
    """

    def __init__(self) -> None:
        self.hidden: Mask | None = None
        self.note = ""
        self._looks: list[Look] = []
        self._core: Mask | None = None
        self._shape: NDArray[np.float32] | None = None
        self._shade: NDArray[np.float32] | None = None
        self._count = -1

    def remove(self, frame: SensorFrame, view: StreamView, expected: Floats | None) -> Floats | None:
        """Remove the fixed cells of the next frame. Returns its pose if they were found just now and it is known."""
        self._count += 1
        if frame.pixels is None:
            return None
        look = Look(frame, view.host_nearness, view.host_brightness)  # sync
        pose = None
        if self._looks and (self._count <= FROM_FIRST or self._count % CHECK_INTERVAL == 0):
            pose = self._search(look, view, expected)
        self._looks = [*self._looks[:1], *self._looks[1:][-REFERENCE_DISTANCE:], look]
        if pose is None:
            self._drop_changed(look)
        if self.hidden is not None:
            frame.leave_only(self._without([frame], view, self.hidden)[0])
        return pose

    def set_pose(self, pose: Floats | None) -> None:
        if self._looks:
            self._looks[-1] = dataclasses.replace(self._looks[-1], pose=pose)

    def _search(self, look: Look, view: StreamView, expected: Floats | None) -> Floats | None:
        earlier = self._looks[0] if self._count <= FROM_FIRST else self._looks[min(1, len(self._looks) - 1)]
        is_still = same_nearness(look.nearness, earlier.nearness, 1.0) & same_shade(look.shade, earlier.shade, 1.0)
        measured = int(((look.nearness > 0.0) & (earlier.nearness > 0.0)).sum())
        if is_still.sum() < MIN_CELLS * measured:
            return None
        start = np.eye(4) if earlier.pose is None or expected is None else matmul(invert_pose(earlier.pose), expected)
        motion = self._motion_without(widened(is_still, 1), look, earlier, view, start)
        if motion is None:
            return None
        is_other = contradicted(motion, look, earlier, cell_lens(look.frame, view))
        is_fixed = is_still & is_other
        usual = float((is_other & ~is_still).sum()) / max(measured - int(is_still.sum()), 1)
        min_fraction = max(MIN_FIXED, MIN_CHANGED_RATIO * usual)
        if is_fixed.sum() < MIN_CELLS * measured or is_fixed.sum() < min_fraction * is_still.sum():
            return None
        is_new = self.hidden is None
        found = opened(closed(is_fixed) & is_still)
        self._core = found if self._core is None else self._core | found
        self.hidden = widened(self._core, 1)
        self._shape, self._shade = look.nearness, look.shade
        distance = 1.0 / float(np.median(look.nearness[is_fixed]))
        part = f"{distance:.2f} m away in {self.hidden.mean():.0%} of the image"
        self.note = f"an object that moves with the camera, {part}, is left out"
        return matmul(earlier.pose, motion) if is_new and earlier.pose is not None else None

    def _motion_without(
        self, hidden: Mask, look: Look, earlier: Look, view: StreamView, start: Floats
    ) -> Floats | None:
        """T_earlier_now by the other cells. None if it is small or uncertain."""
        depths = self._without([look.frame, earlier.frame], view, hidden)
        source, target = look.frame.pyramid_of(depths[0]), earlier.frame.pyramid_of(depths[1])
        (alignment,) = align_levels(descent(source, target, start, OdometryMethod.Hybrid))
        result = judge(alignment, source)
        T = result.transformation
        if not np.isfinite(T).all() or result.contradiction or result.smallest_eigenvalue < MIN_EIGENVALUE:
            return None
        if result.fitness < MIN_AGREEMENT * result.overlap or result.overlap < FIRM_OVERLAP:
            return None
        has_moved = norm(T[:3, 3]) > MIN_SHIFT or norm(rotation_vector(T[:3, :3])) > MIN_ROTATION
        return T if has_moved else None

    def _without(self, frames: Sequence[SensorFrame], view: StreamView, hidden: Mask) -> list[Any]:
        """The depths of frames without cells."""
        flags = upload(hidden.reshape(-1).astype(np.uint8), uint8, frames[0].device)
        return [hide_cells(frame.depth, flags, view, frame.intrinsic.width) for frame in frames]

    def _drop_changed(self, look: Look) -> None:
        """Show cells again that changed. If most of them did, the object has gone."""
        if self._core is None or self._shape is None or self._shade is None:
            return
        is_unchanged = (look.nearness == 0.0) | same_nearness(look.nearness, self._shape, PREDICTED_TOLERANCE)
        kept = self._core & is_unchanged & same_shade(look.shade, self._shade, PREDICTED_TOLERANCE)
        if kept.sum() < (1.0 - MAX_CHANGED) * self._core.sum():
            self._core, self.hidden, self._looks = None, None, [look]
        else:
            self._core, self.hidden = kept, widened(kept, 1)


def same_nearness(now: NDArray[np.float32], before: NDArray[np.float32], factor: float) -> Mask:
    difference = np.abs(now - before)
    return (now > 0.0) & (before > 0.0) & (difference < factor * SAME_DEPTH * np.maximum(now, before))


def same_shade(now: NDArray[np.float32], before: NDArray[np.float32], factor: float) -> Mask:
    return np.abs(now - before) < factor * SAME_SHADE


def cell_lens(frame: SensorFrame, view: StreamView) -> tuple[float, float, float, float]:
    """Focal lengths and center in cells."""
    side, camera = max(1, frame.intrinsic.width // CELLS_PER_ROW), frame.intrinsic
    return camera.fx / side, camera.fy / side, (camera.cx + 0.5) / side - 0.5, (camera.cy + 0.5) / side - 0.5


def contradicted(T_earlier_now: Floats, look: Look, earlier: Look, lens: tuple[float, float, float, float]) -> Mask:
    """Cells of now that the motion would move to a position of the earlier frame with other depth or brightness."""
    rows, columns = look.nearness.shape
    fx, fy, cx, cy = lens
    v, u = np.mgrid[:rows, :columns]
    z = 1.0 / np.maximum(look.nearness.astype(np.float64), 1e-6)
    points = np.stack([(u - cx) / fx * z, (v - cy) / fy * z, z], axis=-1)
    x, y, depth = np.moveaxis(matmul(points.reshape(-1, 3), T_earlier_now[:3, :3].T) + T_earlier_now[:3, 3], -1, 0)
    depth = np.maximum(depth, 1e-6)
    column, row = np.rint(fx * x / depth + cx).astype(int), np.rint(fy * y / depth + cy).astype(int)
    is_inside = (column >= 0) & (column < columns) & (row >= 0) & (row < rows)
    at = np.where(is_inside, row * columns + column, 0)
    nearness, shade = earlier.nearness.reshape(-1)[at], earlier.shade.reshape(-1)[at]
    is_other = (nearness > 0.0) & ~same_nearness((1.0 / depth).astype(np.float32), nearness, PREDICTED_TOLERANCE)
    is_other |= ~same_shade(look.shade.reshape(-1), shade, PREDICTED_TOLERANCE)
    return (is_inside & is_other & (look.nearness.reshape(-1) > 0.0)).reshape(rows, columns)


def widened(mask: Mask, cells: int) -> Mask:
    out = mask.copy()
    for _ in range(cells):
        padded = np.pad(out, 1)
        out = np.logical_or.reduce([padded[r : r + len(out), c : c + out.shape[1]] for r in range(3) for c in range(3)])
    return out


def opened(mask: Mask) -> Mask:
    """Remove parts of less than three cells in width."""
    return mask & widened(~widened(~mask, 1), 1)


def closed(mask: Mask) -> Mask:
    """Fill gaps of a few cells."""
    return ~widened(~widened(mask, MAX_FILLED_GAP), MAX_FILLED_GAP) | mask
