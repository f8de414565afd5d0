"""SIFT features of grey pictures, those of the largest scales first: scale space, extrema, orientations, descriptors.

Octaves are looked at from the coarsest on, until there are as many extrema as are wanted; the finest level that has
some of them is taken whole, as COLMAP takes it. What is left out costs no descriptor. All octaves stay on the device:
48 B a pixel of the doubled picture and its halves, 256 B a pixel of the picture. Three waits an octave.
"""

import numpy as np

from ..array_types import Array1, Array2, Bytes, Device, Mask
from ..lang import uint8, vec4
from ..memory import download, empty, rows_of
from .descriptors import WIDTH, OrientedPlaces
from .extrema import Extrema
from .scale_space import SCALES, ScaleSpace

BYTES_A_PIXEL = 300  # of the picture: six levels of twice its size and of the smaller octaves, and one between passes


class FeatureFinder:
    """Finds features of pictures of one size, in arrays that are used for one after the other.

    Args:
        width, height: Of the pictures [px].
        device: Where to compute.
    """

    def __init__(self, width: int, height: int, device: Device) -> None:
        self.space = ScaleSpace(width, height, device)
        self.device = device

    def find(self, picture: Bytes, mask: Mask, most: int) -> tuple[np.ndarray, np.ndarray]:
        """The features of a grey picture.

        Args:
            picture: uint8 [height * width] on the device.
            mask: Of the same size, or empty: no feature where it is 0.
            most: Finer levels are left out once there are more extrema than this.

        Returns:
            x, y, sigma [px] and orientation [rad, 0 to 2 pi, from x to y] float32 [n, 4], the middle of the first pixel
            being (0, 0); descriptors uint8 [n, 128]. From the finest octave to the coarsest, in each by level, row and
            column.
        """
        self.space.show(picture)
        found: list[OrientedPlaces] = []
        count = 0
        for octave in reversed(self.space.octaves):
            extrema = Extrema(octave, mask, self.space.width)
            left_out = 0
            for level in reversed(range(SCALES)):
                if count > most:
                    left_out += extrema.counts[level]
                count += extrema.counts[level]
            if left_out < extrema.rows.size:
                rows = rows_of(extrema.rows, left_out, extrema.rows.size)
                found.append(OrientedPlaces(octave, extrema.places, rows))
            if count > most:
                break
        return self._describe(found[::-1])

    def _describe(self, found: list[OrientedPlaces]) -> tuple[np.ndarray, np.ndarray]:
        """Features and descriptors of some octaves, in this order."""
        total = sum(places.count for places in found)
        features: Array1[vec4] = empty(total, vec4, self.device)
        descriptors: Array2[uint8] = empty((total, WIDTH), uint8, self.device)
        first = 0
        for places in found:
            places.describe(first, features, descriptors)
            first += places.count
        return download(features).reshape(-1, 4), download(descriptors)  # sync
