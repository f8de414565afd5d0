"""How well a plane explains a pixel in other pictures: normalised correlation of patches, and there-and-back distance.

A pixel p of the reference with inverse depth w is seen by a source at A p + b w, with A = K_s R K^-1 and b = K_s t: a
patch on a plane is a sum of three vectors a sample. A sample weighs less the farther it is from the middle and the more
its brightness differs (Schoenberger et al. 2016, "Pixelwise view selection for unstructured multi-view stereo", eq. 6,
with rational weights, since exponentials round differently on each device).

A sample reads a brightness of the reference and four of the source, and takes some 70 operations.
"""

import numpy as np

from ..array_types import Array1, Scalars
from ..lang import array, float32, floor, func, mat33, sqrt, struct, vec2, vec3, vec4, vec4i
from ..memory import upload
from .inverse_planes import inverse_depth_at

BAD = 2.0  # the cost of what a source does not see, and of patches that are each other's negative
COLOR_SCALE = 0.06  # brightness that halves a sample's weight
SPACE_SCALE = 18.0  # squared pixels that halve it
LEAST_VARIANCE = 1.0e-6  # of brightness over a patch, that a correlation can be spoken of
NEAR = 1.0e-6  # least depth before a source, in the units of A p + b w
FARTHEST_BACK = 3.0  # [px] that the distance there and back is cut at


@struct
class Reference:
    """The picture whose depth is sought, at one of its sizes.

    Args:
        width, height: [px].
        first: Its first pixel among the pictures.
        lens: fx, fy, cx, cy [px].
        limits: The least and the greatest inverse depth looked for.
        pixels_per: How far the sources' pixels move for an inverse depth of one [px].
        radius: From the middle of a patch to its border [px].
        step: Between the samples of a patch [px].
    """

    width: int
    height: int
    first: int
    lens: vec4
    farthest: float
    nearest: float
    pixels_per: float
    radius: int
    step: int

    def __init__(
        self,
        width: int,
        height: int,
        first: int,
        lens: tuple[float, float, float, float],
        limits: tuple[float, float],
        pixels_per: float,
        radius: int,
        step: int,
    ) -> None:
        self.width, self.height, self.first, self.lens = width, height, first, vec4(*lens)
        self.farthest, self.nearest = limits
        self.pixels_per, self.radius, self.step = pixels_per, radius, step


@struct
class Sources:
    """The pictures that a reference is compared with, and their depth where it is known.

    Args:
        there: A and b of each, float64 [n, 3, 4], from pixels of the reference to the source's picture.
        map_there: The same to the source's map of planes, which may have another size.
        map_back: From the source's map to pixels of the reference.
        layout: Width, height, first pixel of each in `pictures`, int [n, 3].
        map_layout: The same in `maps`.
        pictures: Brightness of all pictures, 0..1.
        maps: Planes of all maps.
    """

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
def brightness_at(pictures: array(dtype=float32), first: int, x: float, y: float, width: int, height: int) -> float:
    """Bilinear; the border goes on."""
    u = min(max(x, 0.0), float(width - 1))
    v = min(max(y, 0.0), float(height - 1))
    column = min(int(u), width - 2)
    row = min(int(v), height - 2)
    fu = u - float(column)
    fv = v - float(row)
    k = first + row * width + column
    top = pictures[k] + (pictures[k + 1] - pictures[k]) * fu
    low = pictures[k + width] + (pictures[k + width + 1] - pictures[k + width]) * fu
    return top + (low - top) * fv


@func
def patch_cost(x: int, y: int, plane: vec4, s: int, reference: Reference, sources: Sources) -> float:
    """1 - the weighted correlation of a slanted patch with a source, 0 to 2; BAD where the source does not see it."""
    A = sources.there[s]
    b = sources.shift[s]
    there = sources.layout[s]
    middle = A @ vec3(float(x), float(y), 1.0) + b * plane[0]
    cost = float(BAD)
    inside = 0
    if middle[2] > NEAR:
        u = middle[0] / middle[2]
        v = middle[1] / middle[2]
        if u >= 0.0 and v >= 0.0 and u <= float(there[0]) - 1.0 and v <= float(there[1]) - 1.0:
            inside = 1
    if inside == 1:
        across = vec3(A[0, 0], A[1, 0], A[2, 0]) + b * plane[1]
        down = vec3(A[0, 1], A[1, 1], A[2, 1]) + b * plane[2]
        center = sources.pictures[reference.first + y * reference.width + x]
        weights = 0.0
        sum_r = 0.0
        sum_s = 0.0
        sum_rr = 0.0
        sum_ss = 0.0
        sum_rs = 0.0
        side = 2 * reference.radius // reference.step + 1
        for j in range(side):
            dy = j * reference.step - reference.radius
            row = y + dy
            if row >= 0 and row < reference.height:
                for i in range(side):
                    dx = i * reference.step - reference.radius
                    column = x + dx
                    if column >= 0 and column < reference.width:
                        r = sources.pictures[reference.first + row * reference.width + column] - center
                        p = middle + across * float(dx) + down * float(dy)
                        inverse = 1.0 / max(p[2], NEAR)
                        shown = brightness_at(
                            sources.pictures, there[2], p[0] * inverse, p[1] * inverse, there[0], there[1]
                        )
                        q = shown - center
                        d = r / COLOR_SCALE
                        k = 1.0 / ((1.0 + d * d) * (1.0 + float(dx * dx + dy * dy) / SPACE_SCALE))
                        weights += k
                        sum_r += k * r
                        sum_s += k * q
                        sum_rr += k * r * r
                        sum_ss += k * q * q
                        sum_rs += k * r * q
        mean_r = sum_r / weights
        mean_s = sum_s / weights
        variance_r = sum_rr / weights - mean_r * mean_r
        variance_s = sum_ss / weights - mean_s * mean_s
        if variance_r > LEAST_VARIANCE and variance_s > LEAST_VARIANCE:
            covariance = sum_rs / weights - mean_r * mean_s
            cost = min(max(1.0 - covariance / sqrt(variance_r * variance_s), 0.0), BAD)
    return cost


@func
def way_back(x: int, y: int, w: float, s: int, sources: Sources) -> vec2:
    """How far [px] a pixel lands from itself after going to a source's surface and back, and at what inverse depth.

    The distance is FARTHEST_BACK at most, and with inverse depth 0 where the source has no surface there.
    """
    p = sources.map_there[s] @ vec3(float(x), float(y), 1.0) + sources.map_shift[s] * w
    distance = float(FARTHEST_BACK)
    back = 0.0
    if p[2] > NEAR:
        u = p[0] / p[2]
        v = p[1] / p[2]
        there = sources.map_layout[s]
        if u > -0.5 and v > -0.5 and u < float(there[0]) - 0.5 and v < float(there[1]) - 0.5:
            column = int(floor(u + 0.5))
            row = int(floor(v + 0.5))
            plane = sources.maps[there[2] + row * there[0] + column]
            found = inverse_depth_at(plane, u - float(column), v - float(row))
            q = sources.map_back[s] @ vec3(u, v, 1.0) + sources.map_back_shift[s] * found
            if q[2] > NEAR and found > 0.0:
                dx = q[0] / q[2] - float(x)
                dy = q[1] / q[2] - float(y)
                distance = min(sqrt(dx * dx + dy * dy), FARTHEST_BACK)
                back = found / q[2]  # q is the pixel times what the inverse depth fell by
    return vec2(distance, back)
