"""Photometric cost of a plane hypothesis: weighted normalized cross-correlation of patches, and round-trip distance.

A source sees pixel p at inverse depth w at A p + b w, A = K_s R K^-1, b = K_s t. Samples are weighted by distance and
brightness difference (Schoenberger et al. 2016, "Pixelwise view selection for unstructured multi-view stereo", eq. 6,
with rational weights for reproducibility). Reference terms are precomputed per pixel (`window_of`).
"""

import numpy as np

from ..array_types import Array1, Device, Scalars
from ..lang import array, float32, floor, func, int32, mat33, sqrt, struct, vec2, vec3, vec4, vec4i, vector
from ..memory import upload
from .inverse_planes import inverse_depth_at

BAD = 2.0  # cost if a source does not see a patch, or of negatively correlated ones
COLOR_SCALE = 0.06  # brightness difference that halves a sample's weight
SPACE_SCALE = 18.0  # squared pixels that halve the weight
MIN_VARIANCE = 1.0e-6  # minimum brightness variance for a correlation
NEAR = 1.0e-6  # minimum depth in a source, in the units of A p + b w
MAX_BACK = 3.0  # [px] maximum round-trip error
LANES = 8  # samples processed together
MAX_BLOCKS = 4  # groups per patch

samples = vector(LANES * MAX_BLOCKS, float32)
eight = vector(LANES, float32)
eight_indices = vector(LANES, int32)


@struct
class Reference:
    """Reference image at one size. Inverse depth `limits`; `pixels_per`: source displacement per unit of it [px]."""

    width: int
    height: int
    first: int
    lens: vec4
    farthest: float
    nearest: float
    pixels_per: float
    blocks: int
    patch: array(dtype=float32)

    def __init__(
        self,
        width: int,
        height: int,
        first: int,
        lens: tuple[float, float, float, float],
        limits: tuple[float, float],
        pixels_per: float,
        patch: Scalars,
    ) -> None:
        self.width, self.height, self.first, self.lens = width, height, first, vec4(*lens)
        self.farthest, self.nearest = limits
        self.pixels_per, self.patch, self.blocks = pixels_per, patch, patch.size // (3 * LANES)


def patch_on(pattern: np.ndarray, device: Device) -> Scalars:
    """Patch from integer sample offsets (n, 2) [px]: columns, rows, then distance weights. Zero-padded."""
    near = 1 / (1 + (pattern**2).sum(1) / SPACE_SCALE)
    columns = np.column_stack([pattern, near])
    return upload(np.pad(columns, ((0, -len(pattern) % LANES), (0, 0))).T.ravel(), float32, device)


@struct
class Sources:
    """Source images: `there` (n, 3, 4): A and b; `map_there`, `map_back`: to and from the source's plane map."""

    count: int
    there: array(dtype=mat33)
    shift: array(dtype=vec3)
    map_there: array(dtype=mat33)
    map_shift: array(dtype=vec3)
    map_back: array(dtype=mat33)
    map_back_shift: array(dtype=vec3)
    layout: array(dtype=vec4i)
    map_layout: array(dtype=vec4i)
    pictures: array(dtype=float32)
    maps: array(dtype=vec4)

    def __init__(
        self,
        there: np.ndarray,
        map_there: np.ndarray,
        map_back: np.ndarray,
        layout: np.ndarray,
        map_layout: np.ndarray,
        pictures: Scalars,
        maps: Array1[vec4],
    ) -> None:
        device = pictures.device
        self.count = len(there)
        (self.there, self.shift), (self.map_there, self.map_shift), (self.map_back, self.map_back_shift) = (
            (upload(m[:, :, :3], mat33, device), upload(m[:, :, 3], vec3, device)) for m in (there, map_there, map_back)
        )
        self.layout, self.map_layout = (
            upload(np.column_stack([table, np.zeros(len(table))]), vec4i, device) for table in (layout, map_layout)
        )
        self.pictures, self.maps = pictures, maps


@func
def window_of(x: int, y: int, reference: Reference, sources: Sources) -> tuple[samples, samples, float]:
    """Normalized weights of a pixel's samples, times centered brightness, and the variance."""
    count = LANES * reference.blocks
    weights = samples(0.0)
    rises = samples(0.0)
    center = sources.pictures[reference.first + y * reference.width + x]
    total = 0.0
    sum_r = 0.0
    sum_rr = 0.0
    for k in range(count):
        dx = int(reference.patch[k])
        dy = int(reference.patch[count + k])
        row = y + dy
        column = x + dx
        if row >= 0 and row < reference.height and column >= 0 and column < reference.width:
            r = sources.pictures[reference.first + row * reference.width + column] - center
            d = r * (1.0 / COLOR_SCALE)
            w = reference.patch[2 * count + k] / (1.0 + d * d)
            weights[k] = w
            rises[k] = r
            total += w
            sum_r += w * r
            sum_rr += w * r * r
    share = 1.0 / total
    mean = sum_r * share
    for k in range(count):
        weights[k] = weights[k] * share
        rises[k] = weights[k] * (rises[k] - mean)
    return weights, rises, sum_rr * share - mean * mean


@func
def sum_of(lanes: eight) -> float:
    """Fixed-order sum of eight numbers."""
    return ((lanes[0] + lanes[4]) + (lanes[1] + lanes[5])) + ((lanes[2] + lanes[6]) + (lanes[3] + lanes[7]))


@func
def correlation_cost(
    middle: vec3,
    across: vec3,
    down: vec3,
    center: float,
    there: vec4i,
    weights: samples,
    rises: samples,
    variance: float,
    reference: Reference,
    sources: Sources,
) -> float:
    """1 - weighted correlation of a patch about `middle` with a source; vectorized by LLVM."""
    count = LANES * reference.blocks
    means = eight(0.0)
    squares = eight(0.0)
    products = eight(0.0)
    right = float(there[0] - 1)
    bottom = float(there[1] - 1)
    for block in range(reference.blocks):
        first = block * LANES
        indices = eight_indices(0)
        along = eight(0.0)
        below = eight(0.0)
        for k in range(LANES):
            dx = reference.patch[first + k]
            dy = reference.patch[count + first + k]
            inverse = 1.0 / max(middle[2] + across[2] * dx + down[2] * dy, NEAR)
            u = min(max((middle[0] + across[0] * dx + down[0] * dy) * inverse, 0.0), right)
            v = min(max((middle[1] + across[1] * dx + down[1] * dy) * inverse, 0.0), bottom)
            column = min(int(u), there[0] - 2)
            row = min(int(v), there[1] - 2)
            along[k] = u - float(column)
            below[k] = v - float(row)
            indices[k] = there[2] + row * there[0] + column
        here = eight(0.0)
        beside = eight(0.0)
        under = eight(0.0)
        opposite = eight(0.0)
        for k in range(LANES):
            index = indices[k]
            low = index + there[0]
            here[k] = sources.pictures[index]
            beside[k] = sources.pictures[index + 1]
            under[k] = sources.pictures[low]
            opposite[k] = sources.pictures[low + 1]
        for k in range(LANES):
            top = here[k] + (beside[k] - here[k]) * along[k]
            shown = top + ((under[k] + (opposite[k] - under[k]) * along[k]) - top) * below[k]
            q = shown - center
            wq = weights[first + k] * q
            means[k] = means[k] + wq
            squares[k] = squares[k] + wq * q
            products[k] = products[k] + rises[first + k] * q
    mean = sum_of(means)
    spread = sum_of(squares) - mean * mean
    cost = float(BAD)
    if spread > MIN_VARIANCE:
        cost = min(max(1.0 - sum_of(products) / sqrt(variance * spread), 0.0), BAD)
    return cost


@func
def patch_cost(
    x: int,
    y: int,
    plane: vec4,
    s: int,
    weights: samples,
    rises: samples,
    variance: float,
    reference: Reference,
    sources: Sources,
) -> float:
    """1 - weighted correlation of a slanted patch with a source, 0 to 2. BAD if not visible."""
    A = sources.there[s]
    b = sources.shift[s]
    there = sources.layout[s]
    middle = A @ vec3(float(x), float(y), 1.0) + b * plane[0]
    cost = float(BAD)
    inside = 0
    if middle[2] > NEAR and variance > MIN_VARIANCE:
        u = middle[0] / middle[2]
        v = middle[1] / middle[2]
        if u >= 0.0 and v >= 0.0 and u <= float(there[0]) - 1.0 and v <= float(there[1]) - 1.0:
            inside = 1
    if inside == 1:
        across = vec3(A[0, 0], A[1, 0], A[2, 0]) + b * plane[1]
        down = vec3(A[0, 1], A[1, 1], A[2, 1]) + b * plane[2]
        center = sources.pictures[reference.first + y * reference.width + x]
        cost = correlation_cost(middle, across, down, center, there, weights, rises, variance, reference, sources)
    return cost


@func
def round_trip(x: int, y: int, w: float, s: int, sources: Sources) -> vec2:
    """Round-trip error [px] through a source's surface, at most MAX_BACK, and the inverse depth, 0 if unknown."""
    p = sources.map_there[s] @ vec3(float(x), float(y), 1.0) + sources.map_shift[s] * w
    distance = float(MAX_BACK)
    back = 0.0
    if p[2] > NEAR:
        u = p[0] / p[2]
        v = p[1] / p[2]
        there = sources.map_layout[s]
        if u > -0.5 and v > -0.5 and u < float(there[0]) - 0.5 and v < float(there[1]) - 0.5:
            column = int(floor(u + 0.5))
            row = int(floor(v + 0.5))
            plane = sources.maps[there[2] + row * there[0] + column]
            inverse_depth = inverse_depth_at(plane, u - float(column), v - float(row))
            q = sources.map_back[s] @ vec3(u, v, 1.0) + sources.map_back_shift[s] * inverse_depth
            if q[2] > NEAR and inverse_depth > 0.0:
                dx = q[0] / q[2] - float(x)
                dy = q[1] / q[2] - float(y)
                distance = min(sqrt(dx * dx + dy * dy), MAX_BACK)
                back = inverse_depth / q[2]  # q is the pixel times the decrease of the inverse depth
    return vec2(distance, back)
