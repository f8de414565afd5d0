"""Images as arrays with display in notebooks: `Picture`."""

from __future__ import annotations

import io
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from ..notebook_output import still_jpeg

CHANNEL_COUNTS = 3, 4
MAX_PNG_BYTES = 2**21  # in a notebook. Larger images are shown as a JPEG of at most 200 kB


class Picture(np.ndarray[Any, np.dtype[np.uint8]]):
    """An image as a uint8 array, displayed by notebooks and written by `write_image`.

    Shape (h, w, 3) RGB, or (h, w, 4) RGBA (not premultiplied). Slices and stacks (`np.hstack`) are Pictures. Results of
    computations are plain arrays.

    Example:
        >>> import pointloom as loom
        >>> picture = loom.render(loom.TriangleMesh.create_sphere(1.0), size=(64, 48))
        >>> picture.shape, picture.mean(axis=2).shape
        ((48, 64, 3), (48, 64))
        >>> picture
        Picture(64 x 48)
    """

    __array_priority__ = 1.0  # type: ignore  # NumPy's is 0: concatenations with arrays are Pictures

    def __new__(cls, pixels: NDArray[np.uint8]) -> Picture:
        return np.asarray(pixels).view(cls)

    def __array_wrap__(self, array: Any, context: object = None, return_scalar: bool = False) -> Any:
        return array[()] if return_scalar else np.asarray(array)

    def _is_image(self) -> bool:
        return self.ndim == 3 and self.shape[2] in CHANNEL_COUNTS and self.dtype == np.uint8 and self.size > 0

    def _repr_png_(self) -> bytes | None:
        """PNG for notebooks. None for large images and for parts that are no image."""
        if not self._is_image():
            return None
        file = io.BytesIO()
        Image.fromarray(np.ascontiguousarray(self)).save(file, "PNG")
        return file.getvalue() if file.tell() <= MAX_PNG_BYTES else None

    def _repr_jpeg_(self) -> bytes | None:
        """JPEG for notebooks, for large images."""
        return still_jpeg(np.asarray(self)) if self._is_image() and self._repr_png_() is None else None

    def __repr__(self) -> str:
        if not self._is_image():
            return repr(np.asarray(self))
        return f"Picture({self.shape[1]} x {self.shape[0]})"
