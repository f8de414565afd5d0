"""LineSet of tensors."""

from __future__ import annotations

from typing import Any, Self

import numpy as np

from ....cameras.camera import PinholeCameraIntrinsic
from ....pcd import line_set
from ... import geometry as legacy
from ...argument_types import DeviceLike, TensorLike
from ...core.device import Device
from ...core.dtype import Dtype, float32, float64, int64
from ...core.tensor import Tensor
from ...wrapper import unwrap
from .geometry import CPU, device_of
from .moved import MovedGeometry
from .tensor_map import TensorMap, array_of, count_of, listed, matrix_of, tensor_of


class LineSet(MovedGeometry):
    """Segments: `point.positions` (n, 3), `line.indices` (m, 2), and any other tensors of points and lines.

    Args:
        point_positions, line_indices: The tensors. Or a device of an empty set, or a set, whose tensors are shared.
    """

    _parts, _fixed = ("point", "line"), ("point", "line")

    point: TensorMap
    line: TensorMap

    def __init__(self, point_positions: object = CPU, line_indices: object = None, *, device: DeviceLike | None = None):
        first = point_positions if device is None else device
        if isinstance(first, LineSet):
            vars(self).update(vars(first.__copy__()))
            return
        self.point, self.line = TensorMap("positions"), TensorMap("indices")
        if isinstance(first, Device | str):
            self._home = device_of(first)
            return
        for part, name, values, width in ((self.point, "positions", first, 3), (self.line, "indices", line_indices, 2)):
            part[name] = values
            if part[name].shape[1:] != (width,):
                raise ValueError(f"{name}: expected shape [n, {width}], got {list(part[name].shape)}")
        self._home = self.point.positions.device

    @staticmethod
    def from_legacy(
        lineset_legacy: object, float_dtype: Dtype = float32, int_dtype: Dtype = int64, device: DeviceLike = CPU
    ) -> LineSet:
        lines = unwrap(lineset_legacy, legacy.LineSet, "lineset_legacy")
        made, where = LineSet(device_of(device)), device_of(device)
        if len(lines.points):
            made.point.positions = Tensor(lines.points, float_dtype, where)
        if len(lines.lines):
            made.line.indices = Tensor(lines.lines, int_dtype, where)
        if lines.colors is not None:
            made.line.colors = Tensor(lines.colors, float_dtype, where)
        return made

    def to_legacy(self) -> Any:
        """A `geometry.LineSet` with the colors of lines."""
        colors = self.line.colors.numpy() if "colors" in self.line else None
        points = self.point.positions.numpy() if "positions" in self.point else np.zeros((0, 3))
        rows = self.line.indices.numpy() if "indices" in self.line else np.zeros((0, 2), np.int32)
        return legacy.LineSet.from_native(line_set.LineSet(points, rows, colors))

    @staticmethod
    def create_camera_visualization(
        view_width_px: int,
        view_height_px: int,
        intrinsic: TensorLike,
        extrinsic: TensorLike,
        scale: float = 1.0,
        color: TensorLike | None = None,
    ) -> LineSet:
        """A camera as a pyramid with the axes of the world, in float32. `extrinsic` is world to camera."""
        K = matrix_of("intrinsic", intrinsic, (3, 3))
        T = matrix_of("extrinsic", extrinsic, (4, 4))
        camera = PinholeCameraIntrinsic(view_width_px, view_height_px, K)
        made = LineSet.from_legacy(line_set.LineSet.create_camera_visualization(camera, T, scale))
        if color is not None and len(rgb := array_of("color", color)):
            made.line.colors[:8] = Tensor(rgb, float32)
        return made

    def paint_uniform_color(self, color: TensorLike) -> Self:
        """Set one color for all lines."""
        rgb = tensor_of("color", color)
        values = matrix_of("color", color, (3,)).clip(0, 1)
        kind = rgb.dtype if rgb.dtype in (float32, float64) else float32
        self.line.colors = Tensor(np.tile(values, (count_of(self.line), 1)), kind, self.device)
        return self

    def __repr__(self) -> str:
        return "\n".join(
            [f"LineSet on {self.device}", self._summary("point", "points"), self._summary("line", "lines")]
        )

    def _summary(self, part: str, name: str) -> str:
        tensors: TensorMap = getattr(self, part)
        kind = str(tensors[tensors.primary_key].dtype) if tensors else ""
        return f"[{count_of(tensors)} {name} ({kind})] Attributes:{listed(tensors)}"
