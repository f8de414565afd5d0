"""Descriptors of places: structures seen from above, compared over all headings and offsets by correlation.

Related work: bird's-eye images for LiDAR loops as in Gupta et al., "Effectively Detecting Loop Closures using Point
Cloud Density Maps", ICRA 2024; exhaustive correlation over rotations by FFT as in Lu et al., "One RING to Rule Them
All", ICRA 2022.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul
from ..rigid import about_up, make_pose

Matrix = NDArray[np.float64]
Spectrum = NDArray[np.complexfloating]

DISK_CELLS = 96  # across the described disk: 1 m for a radius of 48 m, which resolves doors and parked cars
LAYER_CELLS = 0.8  # cells: height of the layers that are counted in each column
MAX_LAYERS = 6  # higher structures weigh no more: their tops are often beyond the beams
IMAGE_CELLS = {1: 128, 2: 64}  # by the number of cells per pixel: the disk and offsets up to a third of its radius
HEADING_COUNTS = {1: 120, 2: 72}  # 3 and 5 degrees: within 3 pixels at the border of the disk
COARSE_PIXEL, FINE_PIXEL = 2, 1  # cells per pixel: to rank all places, to align the best
PEAK_PIXELS = 4  # between distinct alignments
MIN_PEAK_RATIO = 0.7  # of the highest correlation
MAX_PEAKS = 3
GROUND_PERCENTILE = 5.0  # of heights: below the structures, above reflections from below the ground


@dataclass(frozen=True, eq=False)
class PlaceMatch:
    """An alignment of two places: `similarity` (0..1) of their images, and T_target_source, level, float64 [4, 4]."""

    similarity: float
    transformation: Matrix


@dataclass(frozen=True, eq=False)
class PlaceDescriptor:
    """Columns of structures around the center of a place.

    Attributes:
        center: Center [m] in the frame of the place, whose z axis points up.
        cell: Edge of a cell [m].
        columns: Centers of the occupied columns relative to `center` [m], float64 [n, 2].
        weights: Root of the number of layers above the lowest, float64 [n].
        ground: Height of the ground [m] in the frame of the place.
    """

    center: Matrix
    cell: float
    columns: Matrix
    weights: Matrix
    ground: float

    @cached_property
    def coarse_spectrum(self) -> Spectrum:
        return np.fft.rfft2(self.image(COARSE_PIXEL))

    def spectrum(self, pixel: int) -> Spectrum:
        return self.coarse_spectrum if pixel == COARSE_PIXEL else np.fft.rfft2(self.image(pixel))

    def image(self, pixel: int, heading: float = 0.0) -> NDArray[np.float32]:
        """The weights in pixels of some cells, rotated by a heading [rad], with unit norm."""
        n = IMAGE_CELLS[pixel]
        at = matmul(self.columns, about_up(heading)[:2, :2].T) / (self.cell * pixel) + (n - 1) / 2
        first = np.floor(at).astype(np.int64)
        part = at - first
        image = np.zeros(n * n)
        for corner in ((0, 0), (0, 1), (1, 0), (1, 1)):
            fraction = np.where(corner, part, 1 - part).prod(axis=1)
            i, j = (first + corner).T
            inside = (i >= 0) & (i < n) & (j >= 0) & (j < n)
            image += np.bincount((i * n + j)[inside], (self.weights * fraction)[inside], n * n)
        length = math.sqrt(float((image * image).sum()))
        return (image / max(length, 1e-12)).reshape(n, n).astype(np.float32)

    def rotated_spectra(self, pixel: int) -> Spectrum:
        """Spectra of the images at all headings, [headings, n, n / 2 + 1]."""
        count = HEADING_COUNTS[pixel]
        images = np.stack([self.image(pixel, 2 * math.pi * k / count) for k in range(count)])
        return np.fft.rfft2(images)


def describe_place(points: NDArray[np.float32], center: Matrix, radius: float) -> PlaceDescriptor:
    """Describe the points within a radius [m] of a center, in a frame whose z axis points up."""
    cell = 2 * radius / DISK_CELLS
    offsets = points.astype(np.float64) - center
    near = offsets[(offsets[:, :2] ** 2).sum(axis=1) < radius**2]
    ground = float(np.percentile(near[:, 2], GROUND_PERCENTILE) + center[2]) if len(near) else float(center[2])
    voxels = np.unique(np.floor(near / [cell, cell, LAYER_CELLS * cell]).astype(np.int64), axis=0)
    columns, layers = np.unique(voxels[:, :2], axis=0, return_counts=True)
    is_structure = layers > 1
    weights = np.sqrt(np.minimum(layers[is_structure] - 1, MAX_LAYERS).astype(np.float64))
    centers = (columns[is_structure] + 0.5).astype(np.float64) * cell
    return PlaceDescriptor(center, cell, centers, weights, ground)


class PlaceQuery:
    """A place that is compared with others. Its spectra at all headings are computed once."""

    def __init__(self, place: PlaceDescriptor):
        self.place = place
        self._spectra: dict[int, Spectrum] = {}

    def similarities(self, others: Sequence[PlaceDescriptor]) -> list[float]:
        """Highest correlation (0..1) with each of other places over all headings and offsets, in coarse pixels."""
        return [float(self._correlation(other, COARSE_PIXEL).max()) for other in others]

    def alignments(self, other: PlaceDescriptor) -> list[PlaceMatch]:
        """Distinct alignments T_other_place with a high correlation, the best first."""
        return [self._match(other, FINE_PIXEL, *peak) for peak in _peaks(self._correlation(other, FINE_PIXEL))]

    def _correlation(self, other: PlaceDescriptor, pixel: int) -> NDArray[np.float32]:
        """Correlation by heading and offset of this place, [headings, n, n]."""
        if pixel not in self._spectra:
            self._spectra[pixel] = self.place.rotated_spectra(pixel)
        n = IMAGE_CELLS[pixel]
        return np.fft.irfft2(other.spectrum(pixel) * self._spectra[pixel].conj(), s=(n, n)).astype(np.float32)

    def _match(self, other: PlaceDescriptor, pixel: int, k: int, i: int, j: int, value: float) -> PlaceMatch:
        n, place = IMAGE_CELLS[pixel], self.place
        R = about_up(2 * math.pi * k / HEADING_COUNTS[pixel])
        offset = (np.array([i, j]) + n // 2) % n - n // 2
        shift = np.append(other.center[:2] + offset * (pixel * place.cell), 0.0)
        t = shift - matmul(R, np.append(place.center[:2], 0.0))
        t[2] = other.ground - place.ground
        return PlaceMatch(value, make_pose(R, t))


def _peaks(correlation: NDArray[np.float32]) -> list[tuple[int, int, int, float]]:
    """Highest values whose offsets or headings differ: heading, row, column, value."""
    headings, n, _ = correlation.shape
    values = correlation.copy()
    found: list[tuple[int, int, int, float]] = []
    rows, columns = np.arange(n)[:, None], np.arange(n)[None]
    near_headings = max(1, round(headings * 2 * PEAK_PIXELS / (math.pi * n)))
    while len(found) < MAX_PEAKS:
        k, i, j = (int(index) for index in np.unravel_index(int(values.argmax()), values.shape))
        value = float(values[k, i, j])
        if value <= 0 or (found and value < MIN_PEAK_RATIO * found[0][3]):
            break
        found.append((k, i, j, value))
        apart = [np.abs((axis - at + n // 2) % n - n // 2) for axis, at in ((rows, i), (columns, j))]
        is_near = (apart[0] <= PEAK_PIXELS) & (apart[1] <= PEAK_PIXELS)
        for turn in range(-near_headings, near_headings + 1):
            values[(k + turn) % headings][is_near] = -1.0
    return found
