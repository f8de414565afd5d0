"""RGBDImage of tensors."""

from __future__ import annotations

from typing import Any, Self

from ... import geometry as legacy
from ...core.dtype import int64
from ...core.tensor import Tensor
from .geometry import Geometry
from .image import Image


class RGBDImage(Geometry):
    """A color image and a depth image.

    Args:
        color, depth: Images or tensors, which are shared. Empty images if they are missing.
        aligned: Both images have one camera.
    """

    _parts = ("color", "depth")

    color: Image
    depth: Image
    aligned_: bool

    def __init__(self, color: Any = None, depth: Any = None, aligned: bool = True):
        self.color = Image() if color is None else color
        self.depth = Image() if depth is None else depth
        self.aligned_ = aligned
        if aligned and self.color.as_tensor().shape[:2] != self.depth.as_tensor().shape[:2]:
            sizes = [list(image.as_tensor().shape[:2]) for image in (self.color, self.depth)]
            raise ValueError(
                f"color, depth: expected one size, got {sizes[0]} and {sizes[1]}; aligned=False allows two"
            )

    def __setattr__(self, name: str, value: Any) -> None:
        is_image = name in self._parts and not isinstance(value, Image)
        super().__setattr__(name, Image(value) if is_image else value)

    def are_aligned(self) -> bool:
        return self.aligned_

    def is_empty(self) -> bool:
        return self.color.is_empty() and self.depth.is_empty()

    def clear(self) -> Self:
        for name in self._parts:
            getattr(self, name).clear()
        return self

    def get_min_bound(self) -> Tensor:
        return self.color.get_min_bound()

    def get_max_bound(self) -> Tensor:
        """Columns of both images side by side, and rows."""
        return Tensor([self.color.columns + self.depth.columns, self.color.rows], int64)

    def to_legacy(self) -> Any:
        made = legacy.RGBDImage()
        made.color, made.depth = self.color.to_legacy(), self.depth.to_legacy()
        return made

    def __repr__(self) -> str:
        parts = [
            f"{name.capitalize()} [size=({image.columns},{image.rows}), channels={image.channels}, "
            f"format={image.dtype}, device={image.device}]"
            for name, image in (("color", self.color), ("depth", self.depth))
        ]
        return "\n".join([f"RGBD Image pair [{'A' if self.aligned_ else 'Not a'}ligned]", *parts])
