"""Depth image filters: bilateral, edge erosion, halving. Depth is in meters. Missing pixels (0) stay missing."""

from ..array_types import Array2, Scalars
from ..lang import array, bits_float, compute, float32, floor, func, kernel, launch, loop, tid, uint8, vec3, vector
from ..memory import empty

CENTER_WEIGHT, SIDE_WEIGHT, CORNER_WEIGHT = 0.375, 0.25, 0.0625  # the binomial weights 6, 4, 1 of 16
# Gaussian of deviation 1 at 0, 1 and 2 pixels, normalized over five.
GAUSS_CENTER, GAUSS_NEAR, GAUSS_FAR = 0.40261995, 0.24420134, 0.05448868
HALF_WINDOW = 2
MAX_EXPONENT = 87.0  # exponent beyond which a weight is 0
INVERSE_LOG2 = 1.44269504
LOG2_HIGH = 0.693359375  # of ln 2: 10 bits, so that integer multiples are exact
LOG2_LOW = -2.12194440e-4
EXPONENT_BIAS, EXPONENT_SHIFT = 127, 23  # of a float32
LANE_COUNT = 8  # pixels of a thread of the bilateral filter, which a CPU filters at once
octet = vector(8, float32)  # one number per pixel of a thread


@func
def falloff(x: float) -> float:
    """exp(-x) for x >= 0, to 2e-7, bitwise identical everywhere and branch-free. 0 beyond MAX_EXPONENT."""
    n = int(min(x, float(MAX_EXPONENT)) * INVERSE_LOG2 + 0.5)
    k = float(n)
    r = (k * LOG2_HIGH - x) + k * LOG2_LOW
    s = 1.9875691500e-4 * r + 1.3981999507e-3
    s = s * r + 8.3334519073e-3
    s = s * r + 4.1665795894e-2
    s = s * r + 1.6666665459e-1
    s = s * r + 5.0000001201e-1
    s = s * (r * r) + r + 1.0
    value = s * bits_float((EXPONENT_BIAS - n) << EXPONENT_SHIFT)  # s / 2^n, exact
    return value if x <= float(MAX_EXPONENT) else 0.0


@kernel
def filter_bilateral_kernel(
    depth: array(dtype=float32),
    width: int,
    height: int,
    radius: int,
    value_falloff: float,
    distance_falloff: float,
    filtered: array(dtype=float32),
):
    """Bilateral filter (Tomasi and Manduchi 1998) with replicated border. A thread filters LANE_COUNT pixels."""
    i = tid()
    groups = (width + LANE_COUNT - 1) // LANE_COUNT
    first = (i % groups) * LANE_COUNT
    v = i // groups
    center = octet(0.0)
    value = octet(0.0)
    total = octet(0.0)
    weights = octet(0.0)
    for lane in range(LANE_COUNT):
        center[lane] = depth[v * width + min(first + lane, width - 1)]
    for dv in range(-radius, radius + 1):
        row = min(max(v + dv, 0), height - 1) * width
        for du in range(-radius, radius + 1):
            sqdist = du * du + dv * dv
            if sqdist <= radius * radius:
                start = first + du
                if start >= 0 and start + LANE_COUNT <= width:
                    for lane in range(LANE_COUNT):
                        value[lane] = depth[row + start + lane]
                else:
                    for lane in range(LANE_COUNT):
                        value[lane] = depth[row + min(max(start + lane, 0), width - 1)]
                distance = float(sqdist) * distance_falloff
                for lane in range(LANE_COUNT):
                    difference = value[lane] - center[lane]  # flat regions stay bitwise unchanged
                    w = falloff(difference * difference * value_falloff + distance)
                    w = w if value[lane] > 0.0 else 0.0
                    total[lane] += w * difference
                    weights[lane] += w
    for lane in range(LANE_COUNT):
        if first + lane < width:
            mean = 0.0
            if center[lane] > 0.0:
                mean = center[lane] + total[lane] / weights[lane]
            filtered[v * width + first + lane] = mean


@kernel
def erode_edges_kernel(
    depth: array(dtype=float32), width: int, height: int, radius: int, jump: float, eroded: array(dtype=float32)
):
    """Drop pixels whose window has a missing pixel or a depth step above `jump`."""
    i = tid()
    left = max(i % width - radius, 0)
    right = min(i % width + radius, width - 1)
    top = max(i // width - radius, 0)
    bottom = min(i // width + radius, height - 1)
    edge = 0
    row = top
    while row <= bottom and edge == 0:
        for column in range(left, right + 1):
            at = row * width + column
            d = depth[at]
            if d == 0.0:
                edge = 1
            if column < right:
                if abs(depth[at + 1] - d) > jump:
                    edge = 1
            if row < bottom:
                if abs(depth[at + width] - d) > jump:
                    edge = 1
        row = row + 1
    d = depth[i]
    if edge == 1:
        d = 0.0
    eroded[i] = d


@func
def binomial_weight(offset: int) -> float:
    weight = float(CENTER_WEIGHT)
    if offset != 0:
        weight = SIDE_WEIGHT
    if abs(offset) == HALF_WINDOW:
        weight = CORNER_WEIGHT
    return weight


@func
def gaussian_weight(offset: int) -> float:
    weight = float(GAUSS_CENTER)
    if offset != 0:
        weight = GAUSS_NEAR
    if abs(offset) == HALF_WINDOW:
        weight = GAUSS_FAR
    return weight


@kernel
def halve_depth_kernel(
    depth: array(dtype=float32), width: int, height: int, columns: int, jump: float, halved: array(dtype=float32)
):
    """Every second pixel: mean of the 5 x 5 pixels within `jump` of its depth. 0 without depth."""
    i = tid()
    u = 2 * (i % columns)
    v = 2 * (i // columns)
    center = depth[v * width + u]
    total = 0.0
    weights = 0.0
    mean = 0.0
    if center > 0.0:
        for row in range(max(v - HALF_WINDOW, 0), min(v + HALF_WINDOW, height - 1) + 1):
            for column in range(max(u - HALF_WINDOW, 0), min(u + HALF_WINDOW, width - 1) + 1):
                d = depth[row * width + column]
                difference = d - center
                if d > 0.0 and abs(difference) < jump:
                    w = binomial_weight(row - v) * binomial_weight(column - u)
                    total += w * difference
                    weights += w
        mean = center + total / weights
    halved[i] = mean


@loop
def gaussian_window(u: int, v: int, width: int, height: int) -> tuple[int, float]:
    """The 5 x 5 pixels around one with weights; replicated border."""
    for dv in range(-HALF_WINDOW, HALF_WINDOW + 1):
        row = min(max(v + dv, 0), height - 1) * width
        for du in range(-HALF_WINDOW, HALF_WINDOW + 1):
            at = row + min(max(u + du, 0), width - 1)
            w = gaussian_weight(dv) * gaussian_weight(du)
            yield at, w


@kernel
def halve_color_kernel(
    pixels: array(dtype=uint8, ndim=2), width: int, height: int, columns: int, halved: array(dtype=uint8, ndim=2)
):
    i = tid()
    u = 2 * (i % columns)
    v = 2 * (i // columns)
    total = vec3(0.0, 0.0, 0.0)
    for at, w in gaussian_window(u, v, width, height):
        total += vec3(float(pixels[at, 0]), float(pixels[at, 1]), float(pixels[at, 2])) * w
    for channel in range(3):
        halved[i, channel] = uint8(int(min(floor(total[channel] + 0.5), 255.0)))


@kernel
def halve_intensity_kernel(
    intensity: array(dtype=float32), width: int, height: int, columns: int, halved: array(dtype=float32)
):
    i = tid()
    u = 2 * (i % columns)
    v = 2 * (i // columns)
    total = 0.0
    for at, w in gaussian_window(u, v, width, height):
        total += intensity[at] * w
    halved[i] = total


def filter_bilateral(
    depth: Scalars, width: int, height: int, radius: int, value_sigma: float, distance_sigma: float
) -> Scalars:
    """Bilateral depth, float32 (height * width); deviations in meters and pixels."""
    filtered = empty(depth.size, float32, depth.device)
    falloffs = [0.5 / max(sigma * sigma, 1e-30) for sigma in (value_sigma, distance_sigma)]  # finite in float32
    threads = height * -(-width // LANE_COUNT)
    launch(filter_bilateral_kernel, threads, [depth, width, height, radius, *falloffs, filtered])
    return filtered


def erode_edges(depth: Scalars, width: int, height: int, radius: int, jump: float) -> Scalars:
    """Depth without pixels within `radius` of an edge, float32 (height * width)."""
    return compute(erode_edges_kernel, depth.size, [depth, width, height, radius, float(jump)], float32, depth.device)


def halve_depth(depth: Scalars, width: int, height: int, jump: float) -> Scalars:
    """Depth at half the size, float32 ((height // 2) * (width // 2))."""
    columns, rows = width // 2, height // 2
    halved = empty(rows * columns, float32, depth.device)
    launch(halve_depth_kernel, rows * columns, [depth, width, height, columns, float(jump), halved])
    return halved


def halve_color(pixels: Scalars | Array2[uint8], width: int, height: int) -> Scalars | Array2[uint8]:
    """Color image, uint8 (pixels, 3), or grayscale, float32 (pixels), at half the size."""
    columns, rows = width // 2, height // 2
    if pixels.dtype == uint8:
        halved = empty((rows * columns, 3), uint8, pixels.device)
        launch(halve_color_kernel, rows * columns, [pixels, width, height, columns, halved])
    else:
        halved = empty(rows * columns, float32, pixels.device)
        launch(halve_intensity_kernel, rows * columns, [pixels, width, height, columns, halved])
    return halved
