"""Photometric cost of a plane hypothesis: weighted normalized cross-correlation of patches, and round-trip distance.

A source sees pixel p at inverse depth w at A p + b w, A = K_s R K^-1, b = K_s t. Samples are weighted by distance and
brightness difference (Schoenberger et al. 2016, "Pixelwise view selection for unstructured multi-view stereo", eq. 6,
with rational weights for reproducibility). Reference terms are precomputed per pixel (`window_of`).
"""

import numpy as np

from ..array_types import Array1, Device, Scalars
from ..lang import array, float32, floor, func, int32, mat33, sqrt, struct, uint64, vec2, vec3, vec4, vec4i, vector
from ..memory import upload
from .brightness import MAX_PACKED_LEVEL, PACKED_LEVEL_MASK, brightness_in
from .inverse_planes import inverse_depth_at

MAX_PATCH_COST = 2.0  # cost if a source does not see a patch, or of negatively correlated ones
COLOR_SCALE = 0.06  # brightness difference that halves a sample's weight
SPACE_SCALE = 18.0  # squared pixels that halve the weight
MIN_VARIANCE = 1.0e-6  # minimum brightness variance for a correlation
MIN_SOURCE_DEPTH = 1.0e-6  # minimum depth in a source, in the units of A p + b w
MAX_BACK = 3.0  # [px] maximum round-trip error
LANE_COUNT = 8  # samples processed together
MAX_BLOCKS = 4  # groups per patch

samples = vector(LANE_COUNT * MAX_BLOCKS, float32)
eight = vector(LANE_COUNT, float32)
eight_indices = vector(LANE_COUNT, int32)
eight_blocks = vector(LANE_COUNT, uint64)


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
        self.pixels_per, self.patch, self.blocks = pixels_per, patch, patch.size // (3 * LANE_COUNT)


def patch_on(pattern: np.ndarray, device: Device) -> Scalars:
    """Patch from integer sample offsets (n, 2) [px]: columns, rows, then distance weights. Zero-padded."""
    near = 1 / (1 + (pattern**2).sum(1) / SPACE_SCALE)
    columns = np.column_stack([pattern, near])
    return upload(np.pad(columns, ((0, -len(pattern) % LANE_COUNT), (0, 0))).T.ravel(), float32, device)


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
    images: array(dtype=uint64)
    maps: array(dtype=vec4)

    def __init__(
        self,
        there: np.ndarray,
        map_there: np.ndarray,
        map_back: np.ndarray,
        layout: np.ndarray,
        map_layout: np.ndarray,
        images: Array1[uint64],
        maps: Array1[vec4],
    ) -> None:
        device = images.device
        self.count = len(there)
        (self.there, self.shift), (self.map_there, self.map_shift), (self.map_back, self.map_back_shift) = (
            (upload(m[:, :, :3], mat33, device), upload(m[:, :, 3], vec3, device)) for m in (there, map_there, map_back)
        )
        self.layout, self.map_layout = (
            upload(np.column_stack([table, np.zeros(len(table))]), vec4i, device) for table in (layout, map_layout)
        )
        self.images, self.maps = images, maps


@func
def sum_of(lanes: eight) -> float:
    """Fixed-order sum of eight numbers."""
    return ((lanes[0] + lanes[4]) + (lanes[1] + lanes[5])) + ((lanes[2] + lanes[6]) + (lanes[3] + lanes[7]))


@func
def window_of(x: int, y: int, reference: Reference, sources: Sources) -> tuple[samples, samples, float]:
    """Normalized weights of a pixel's samples, times centered brightness, and the variance; vectorized by LLVM."""
    count = LANE_COUNT * reference.blocks
    weights = samples(0.0)
    rises = samples(0.0)
    center = brightness_in(sources.images[reference.first + y * reference.width + x])
    totals = eight(0.0)
    sums = eight(0.0)
    squares = eight(0.0)
    for block in range(reference.blocks):
        first = block * LANE_COUNT
        indices = eight_indices(0)
        near = eight(0.0)
        for k in range(LANE_COUNT):
            dx = x + int(reference.patch[first + k])
            dy = y + int(reference.patch[count + first + k])
            column = min(max(dx, 0), reference.width - 1)
            row = min(max(dy, 0), reference.height - 1)
            indices[k] = reference.first + row * reference.width + column
            near[k] = reference.patch[2 * count + first + k] if column == dx else 0.0
            near[k] = near[k] if row == dy else 0.0
        r = eight(0.0)
        for k in range(LANE_COUNT):
            r[k] = brightness_in(sources.images[indices[k]])
        for k in range(LANE_COUNT):
            rise = r[k] - center
            d = rise * (1.0 / COLOR_SCALE)
            w = near[k] / (1.0 + d * d)
            weights[first + k] = w
            rises[first + k] = rise
            totals[k] = totals[k] + w
            sums[k] = sums[k] + w * rise
            squares[k] = squares[k] + w * rise * rise
    fraction = 1.0 / sum_of(totals)
    mean = sum_of(sums) * fraction
    for block in range(reference.blocks):
        first = block * LANE_COUNT
        for k in range(LANE_COUNT):
            weights[first + k] = weights[first + k] * fraction
            rises[first + k] = weights[first + k] * (rises[first + k] - mean)
    return weights, rises, sum_of(squares) * fraction - mean * mean


@func
def correlation_sums(
    x: int, y: int, plane: vec3, s: int, weights: samples, rises: samples, reference: Reference, sources: Sources
) -> vec3:
    """Weighted mean, mean square and product of a slanted patch in a source; vectorized by LLVM."""
    A = sources.there[s]
    b = sources.shift[s]
    there = sources.layout[s]
    middle = A @ vec3(float(x), float(y), 1.0) + b * plane[0]
    across = vec3(A[0, 0], A[1, 0], A[2, 0]) + b * plane[1]
    down = vec3(A[0, 1], A[1, 1], A[2, 1]) + b * plane[2]
    center = brightness_in(sources.images[reference.first + y * reference.width + x])
    count = LANE_COUNT * reference.blocks
    means = eight(0.0)
    squares = eight(0.0)
    products = eight(0.0)
    right = float(there[0] - 1)
    bottom = float(there[1] - 1)
    for block in range(reference.blocks):
        first = block * LANE_COUNT
        indices = eight_indices(0)
        along = eight(0.0)
        below = eight(0.0)
        for k in range(LANE_COUNT):
            dx = reference.patch[first + k]
            dy = reference.patch[count + first + k]
            inverse = 1.0 / max(middle[2] + across[2] * dx + down[2] * dy, MIN_SOURCE_DEPTH)
            u = min(max((middle[0] + across[0] * dx + down[0] * dy) * inverse, 0.0), right)
            v = min(max((middle[1] + across[1] * dx + down[1] * dy) * inverse, 0.0), bottom)
            column = min(int(u), there[0] - 2)
            row = min(int(v), there[1] - 2)
            along[k] = u - float(column)
            below[k] = v - float(row)
            indices[k] = there[2] + row * there[0] + column
        shown = eight_blocks(uint64(0))
        for k in range(LANE_COUNT):
            shown[k] = sources.images[indices[k]]
        for k in range(LANE_COUNT):
            here = float(int(shown[k] & uint64(PACKED_LEVEL_MASK)))
            beside = float(int((shown[k] >> uint64(16)) & uint64(PACKED_LEVEL_MASK)))
            under = float(int((shown[k] >> uint64(32)) & uint64(PACKED_LEVEL_MASK)))
            opposite = float(int(shown[k] >> uint64(48)))
            top = here + (beside - here) * along[k]
            value = top + ((under + (opposite - under) * along[k]) - top) * below[k]
            q = value * (1.0 / MAX_PACKED_LEVEL) - center
            wq = weights[first + k] * q
            means[k] = means[k] + wq
            squares[k] = squares[k] + wq * q
            products[k] = products[k] + rises[first + k] * q
    return vec3(sum_of(means), sum_of(squares), sum_of(products))


@func
def patch_costs(
    x: int,
    y: int,
    w: eight,
    gx: eight,
    gy: eight,
    is_tried: eight_indices,
    s: int,
    weights: samples,
    rises: samples,
    variance: float,
    reference: Reference,
    sources: Sources,
) -> eight:
    """1 - weighted correlation of slanted patches of eight planes, 0 to 2. MAX_PATCH_COST if invisible or not tried."""
    b = sources.shift[s]
    there = sources.layout[s]
    base = sources.there[s] @ vec3(float(x), float(y), 1.0)
    is_visible = eight_indices(0)
    for k in range(LANE_COUNT):
        depth = base[2] + b[2] * w[k]
        inverse = 1.0 / max(depth, MIN_SOURCE_DEPTH)
        u = (base[0] + b[0] * w[k]) * inverse
        v = (base[1] + b[1] * w[k]) * inverse
        beyond = max(max(-u, u - float(there[0] - 1)), max(-v, v - float(there[1] - 1)))
        is_visible[k] = is_tried[k] if depth > MIN_SOURCE_DEPTH else 0
        is_visible[k] = is_visible[k] if beyond <= 0.0 else 0
    means = eight(0.0)
    squares = eight(0.0)
    products = eight(0.0)
    if variance > MIN_VARIANCE:
        listed = eight_indices(0)  # without branches that the processor cannot predict
        number = 0
        for k in range(LANE_COUNT):
            listed[number] = k
            number += is_visible[k]
        for j in range(number):
            k = listed[j]
            sums = correlation_sums(x, y, vec3(w[k], gx[k], gy[k]), s, weights, rises, reference, sources)
            means[k] = sums[0]
            squares[k] = sums[1]
            products[k] = sums[2]
    costs = eight(0.0)
    for k in range(LANE_COUNT):
        spread = squares[k] - means[k] * means[k]
        cost = 1.0 - products[k] / sqrt(variance * max(spread, MIN_VARIANCE))
        costs[k] = min(max(cost, 0.0), MAX_PATCH_COST) if spread > MIN_VARIANCE else float(MAX_PATCH_COST)
    return costs


@func
def round_trips(x: int, y: int, w: eight, s: int, sources: Sources) -> eight:
    """Round-trip errors [px] of eight inverse depths through a source's surface, at most MAX_BACK."""
    start = sources.map_there[s] @ vec3(float(x), float(y), 1.0)
    shift = sources.map_shift[s]
    back = sources.map_back[s]
    back_shift = sources.map_back_shift[s]
    there = sources.map_layout[s]
    us = eight(0.0)
    vs = eight(0.0)
    across = eight(0.0)
    down = eight(0.0)
    outside = eight(0.0)
    indices = eight_indices(0)
    for k in range(LANE_COUNT):
        depth = start[2] + shift[2] * w[k]
        inverse = 1.0 / max(depth, MIN_SOURCE_DEPTH)
        u = (start[0] + shift[0] * w[k]) * inverse
        v = (start[1] + shift[1] * w[k]) * inverse
        column = floor(min(max(u + 0.5, 0.0), float(there[0]) - 0.5))
        row = floor(min(max(v + 0.5, 0.0), float(there[1]) - 0.5))
        us[k] = u
        vs[k] = v
        across[k] = u - column
        down[k] = v - row
        outside[k] = max(abs(u - column), abs(v - row)) if depth > MIN_SOURCE_DEPTH else 1.0
        indices[k] = there[2] + int(row) * there[0] + int(column)
    middle = eight(0.0)
    slope_x = eight(0.0)
    slope_y = eight(0.0)
    for k in range(LANE_COUNT):
        plane = sources.maps[indices[k]]
        middle[k] = plane[0]
        slope_x[k] = plane[1]
        slope_y[k] = plane[2]
    errors = eight(0.0)
    for k in range(LANE_COUNT):
        d = middle[k] + slope_x[k] * across[k] + slope_y[k] * down[k]
        depth = back[2, 0] * us[k] + back[2, 1] * vs[k] + back[2, 2] + back_shift[2] * d
        inverse = 1.0 / max(depth, MIN_SOURCE_DEPTH)
        dx = (back[0, 0] * us[k] + back[0, 1] * vs[k] + back[0, 2] + back_shift[0] * d) * inverse - float(x)
        dy = (back[1, 0] * us[k] + back[1, 1] * vs[k] + back[1, 2] + back_shift[1] * d) * inverse - float(y)
        error = min(sqrt(dx * dx + dy * dy), MAX_BACK) if outside[k] <= 0.5 else float(MAX_BACK)
        error = error if depth > MIN_SOURCE_DEPTH else float(MAX_BACK)
        errors[k] = error if d > 0.0 else float(MAX_BACK)
    return errors


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
    """1 - weighted correlation of a slanted patch with a source, 0 to 2. MAX_PATCH_COST if not visible."""
    is_tried = eight_indices(0)
    is_tried[0] = 1
    costs = patch_costs(
        x,
        y,
        eight(plane[0]),
        eight(plane[1]),
        eight(plane[2]),
        is_tried,
        s,
        weights,
        rises,
        variance,
        reference,
        sources,
    )
    return costs[0]


@func
def round_trip(x: int, y: int, w: float, s: int, sources: Sources) -> vec2:
    """Round-trip error [px] through a source's surface, at most MAX_BACK, and the inverse depth, 0 if unknown."""
    p = sources.map_there[s] @ vec3(float(x), float(y), 1.0) + sources.map_shift[s] * w
    distance = float(MAX_BACK)
    back = 0.0
    if p[2] > MIN_SOURCE_DEPTH:
        u = p[0] / p[2]
        v = p[1] / p[2]
        there = sources.map_layout[s]
        if u > -0.5 and v > -0.5 and u < float(there[0]) - 0.5 and v < float(there[1]) - 0.5:
            column = int(floor(u + 0.5))
            row = int(floor(v + 0.5))
            plane = sources.maps[there[2] + row * there[0] + column]
            inverse_depth = inverse_depth_at(plane, u - float(column), v - float(row))
            q = sources.map_back[s] @ vec3(u, v, 1.0) + sources.map_back_shift[s] * inverse_depth
            if q[2] > MIN_SOURCE_DEPTH and inverse_depth > 0.0:
                dx = q[0] / q[2] - float(x)
                dy = q[1] / q[2] - float(y)
                distance = min(sqrt(dx * dx + dy * dy), MAX_BACK)
                back = inverse_depth / q[2]  # q is the pixel times the decrease of the inverse depth
    return vec2(distance, back)
