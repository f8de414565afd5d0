"""Outlier images of triangles (passers-by, highlights). Starts at the medoid color and its neighbors within three
median distances, then refits a Gaussian to the inliers up to ten times (Waechter, Moehrle and Goesele 2014, section
3.3). With fewer than four inliers all are kept. Color noise is at least two gray levels.
"""

from ..algebra.transform import widen
from ..array_types import Mask
from ..lang import array, float64, func, kernel, launch, length, tid, uint8, vec3, vector
from ..memory import empty
from .face_views import FaceViews

MIN_VIEWS = 4  # minimum images for outlier detection
MAX_SQUARED_DEVIATION = 10.23  # squared Mahalanobis distance: exp(-x / 2) is 6e-3, as in the paper
NOISE_VARIANCE = 6.0e-5  # variance always added: two gray levels, in 0..1
INITIAL_MEDIAN_DISTANCES = 3.0  # median distances from the medoid of the initial inliers
MIN_DISTANCE = 0.02  # [0..1] and at least this, five gray levels
MAX_ITERATIONS = 10

moments = vector(10, float64)  # count, sums, and sums of products: xx, xy, xz, yy, yz, zz


@func
def find_medoid(first: int, last: int, colors: array(dtype=vec3)) -> int:
    """Medoid color of a run."""
    middle = first
    min_total = float64(-1.0)
    for i in range(first, last):
        total = float64(0.0)
        for j in range(first, last):
            total += length(widen(colors[i]) - widen(colors[j]))
        if min_total < 0.0 or total < min_total:
            min_total = total
            middle = i
    return middle


@func
def median_distance(middle: int, first: int, last: int, colors: array(dtype=vec3)) -> float64:
    """Lower median distance of a run's colors from one of them."""
    median = float64(0.0)
    for i in range(first, last):
        distance = length(widen(colors[i]) - widen(colors[middle]))
        rank = 0
        for j in range(first, last):
            other = length(widen(colors[j]) - widen(colors[middle]))
            if other < distance or (other == distance and j < i):
                rank += 1
        if rank == (last - first - 1) // 2:
            median = distance
    return median


@func
def moments_of(first: int, last: int, colors: array(dtype=vec3), keep: array(dtype=uint8)) -> moments:
    sums = moments(0.0)
    for k in range(first, last):
        if keep[k] != 0:
            c = widen(colors[k])
            part = moments(1.0, c[0], c[1], c[2], c[0] * c[0], c[0] * c[1], c[0] * c[2], c[1] * c[1], c[1] * c[2], 0.0)
            part[9] = c[2] * c[2]
            sums += part
    return sums


@func
def squared_deviations(c: vec3, sums: moments) -> float64:
    """Squared Mahalanobis distance of a color."""
    n = sums[0]
    x = float64(c[0]) - sums[1] / n
    y = float64(c[1]) - sums[2] / n
    z = float64(c[2]) - sums[3] / n
    known = float64(NOISE_VARIANCE)
    xx = sums[4] / n - (sums[1] / n) * (sums[1] / n) + known
    xy = sums[5] / n - (sums[1] / n) * (sums[2] / n)
    xz = sums[6] / n - (sums[1] / n) * (sums[3] / n)
    yy = sums[7] / n - (sums[2] / n) * (sums[2] / n) + known
    yz = sums[8] / n - (sums[2] / n) * (sums[3] / n)
    zz = sums[9] / n - (sums[3] / n) * (sums[3] / n) + known
    a = yy * zz - yz * yz
    b = xz * yz - xy * zz
    c0 = xy * yz - xz * yy
    d = xx * zz - xz * xz
    e = xy * xz - xx * yz
    f = xx * yy - xy * xy
    determinant = xx * a + xy * b + xz * c0
    return (a * x * x + d * y * y + f * z * z + 2.0 * (b * x * y + c0 * x * z + e * y * z)) / determinant


@kernel
def keep_likely_kernel(views: FaceViews, keep: array(dtype=uint8)):
    """Flag the images in which a triangle has an inlier color."""
    i = tid()
    first = views.starts[i]
    last = views.starts[i + 1]
    if last - first < MIN_VIEWS:
        for k in range(first, last):
            keep[k] = uint8(1)
        return
    middle = find_medoid(first, last, views.colors)
    max_distance = max(
        float64(INITIAL_MEDIAN_DISTANCES) * median_distance(middle, first, last, views.colors), float64(MIN_DISTANCE)
    )
    count = 0
    for k in range(first, last):
        is_in = 0
        if length(widen(views.colors[k]) - widen(views.colors[middle])) <= max_distance:
            is_in = 1
        keep[k] = uint8(is_in)
        count += is_in
    changed = 1
    iteration = 0
    while iteration < MAX_ITERATIONS and changed == 1 and count >= MIN_VIEWS:
        sums = moments_of(first, last, views.colors, keep)
        changed = 0
        count = 0
        for k in range(first, last):
            is_in = 0
            if squared_deviations(views.colors[k], sums) <= float64(MAX_SQUARED_DEVIATION):
                is_in = 1
            if int(keep[k]) != is_in:
                changed = 1
            keep[k] = uint8(is_in)
            count += is_in
        iteration += 1
    if count < MIN_VIEWS:
        for k in range(first, last):
            keep[k] = uint8(1)


def keep_likely(views: FaceViews) -> Mask:
    """Mask, uint8 (k), of pairs with inlier colors."""
    keep = empty(views.count, uint8, views.device)
    launch(keep_likely_kernel, views.starts.size - 1, [views, keep])
    return keep
