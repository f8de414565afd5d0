"""Descriptor matching along known epipolar lines.

Features are rays with z = 1; E = [t]x R maps a ray of the first image to its line in the second (Hartley and Zisserman
2004, section 9.6). A match must be within a distance of both lines. Integer distances, ties to the lower feature.
"""

import numpy as np

from ..array_types import Array2, Device
from ..lang import array, float64, func, int32, kernel, launch, struct, tid, uint8
from ..memory import download, empty, upload

NO_MATCH = -1
MAX_SQUARED_DISTANCE = 0x7FFFFFFF  # above any squared descriptor distance
DESCRIPTOR_SIZE = 128  # numbers of a descriptor


@struct
class LineSearches:
    """Directed image pairs: first threads, row-major `essential`, `limits`: squared line distances in ray units."""

    starts: array(dtype=int32)
    images: array(dtype=int32, ndim=2)
    essential: array(dtype=float64, ndim=2)
    limits: array(dtype=float64, ndim=2)

    def __init__(
        self, starts: np.ndarray, images: np.ndarray, essential: np.ndarray, limits: np.ndarray, device: Device
    ) -> None:
        self.starts, self.images = upload(starts, int32, device), upload(images, int32, device)
        self.essential, self.limits = upload(essential, float64, device), upload(limits, float64, device)


@struct
class LineFeatures:
    """Concatenated features of all images: `firsts` (n + 1), `rays` (NaN where the lens has none), `descriptors`."""

    firsts: array(dtype=int32)
    rays: array(dtype=float64, ndim=2)
    descriptors: array(dtype=uint8, ndim=2)

    def __init__(self, firsts: np.ndarray, rays: np.ndarray, descriptors: np.ndarray, device: Device) -> None:
        self.firsts, self.rays = upload(firsts, int32, device), upload(rays, float64, device)
        self.descriptors = upload(descriptors, uint8, device)


@func
def search_of(thread: int, starts: array(dtype=int32)) -> int:
    low = int(0)
    high = starts.shape[0] - 1
    while high - low > 1:
        middle = (low + high) // 2
        if starts[middle] <= thread:
            low = middle
        else:
            high = middle
    return low


@func
def descriptor_sqdist(a: int, b: int, descriptors: array(dtype=uint8, ndim=2)) -> int:
    total = int(0)
    for k in range(DESCRIPTOR_SIZE):
        difference = int(descriptors[a, k]) - int(descriptors[b, k])
        total += difference * difference
    return total


@kernel
def match_along_lines_kernel(searches: LineSearches, features: LineFeatures, matches: array(dtype=int32, ndim=2)):
    """Nearest admissible feature of the second image, its squared distance, and that of the second nearest."""
    i = tid()
    s = search_of(i, searches.starts)
    first = searches.images[s, 0]
    second = searches.images[s, 1]
    own_feature = features.firsts[first] + i - searches.starts[s]
    x = features.rays[own_feature, 0]
    y = features.rays[own_feature, 1]
    a = searches.essential[s, 0] * x + searches.essential[s, 1] * y + searches.essential[s, 2]
    b = searches.essential[s, 3] * x + searches.essential[s, 4] * y + searches.essential[s, 5]
    c = searches.essential[s, 6] * x + searches.essential[s, 7] * y + searches.essential[s, 8]
    widest = searches.limits[s, 1] * (a * a + b * b)
    near = searches.limits[s, 0]
    e00 = searches.essential[s, 0]
    e01 = searches.essential[s, 1]
    e10 = searches.essential[s, 3]
    e11 = searches.essential[s, 4]
    e20 = searches.essential[s, 6]
    e21 = searches.essential[s, 7]
    best = int(NO_MATCH)
    min_sqdist = int(MAX_SQUARED_DISTANCE)
    second_sqdist = int(MAX_SQUARED_DISTANCE)
    for j in range(features.firsts[second], features.firsts[second + 1]):
        u = features.rays[j, 0]
        v = features.rays[j, 1]
        off = a * u + b * v + c
        square = off * off
        if square <= widest:
            p = e00 * u + e10 * v + e20
            q = e01 * u + e11 * v + e21
            if square <= near * (p * p + q * q):
                sqdist = descriptor_sqdist(own_feature, j, features.descriptors)
                if sqdist < min_sqdist:
                    second_sqdist = min_sqdist
                    min_sqdist = sqdist
                    best = j - features.firsts[second]
                else:
                    second_sqdist = min(second_sqdist, sqdist)
    matches[i, 0] = best
    matches[i, 1] = min_sqdist
    matches[i, 2] = second_sqdist


def match_along_lines(searches: LineSearches, features: LineFeatures, count: int) -> np.ndarray:
    """int32 (count, 3) per search thread: match or NO_MATCH, its squared distance and the second (or the maximum)."""
    matches: Array2[int32] = empty((count, 3), int32, searches.starts.device)
    launch(match_along_lines_kernel, count, [searches, features, matches])
    return download(matches)  # sync
