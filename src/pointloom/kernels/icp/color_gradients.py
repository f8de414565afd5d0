"""Intensity gradients along a colored surface.

Park, Zhou and Koltun, "Colored point cloud registration revisited", ICCV 2017, eq. 10: least squares over the
neighbors, here with two unknowns in the tangent plane. No neighbor lists; float64 sums.
"""

from ..algebra.eigen import orthogonal_direction
from ..algebra.transform import narrow, widen
from ..array_types import Scalars, Vectors
from ..arrays.packed_keys import key_index
from ..arrays.select import gather_vec3_kernel
from ..lang import (
    array,
    compute,
    cross,
    dot,
    float32,
    float64,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    sqrt,
    tid,
    vec3,
    vec3d,
    vector,
)
from ..memory import empty, zeros
from ..search.distinct_points import by_distinct_points
from ..search.group_scratch import GroupScratch, LaunchPart, stored_key
from ..search.group_search import launch_over_leaves, nearest_of_leaves
from ..search.point_tree import PointTree
from ..search.tree_search import squared_radius

MIN_NEIGHBORS = 4.0  # including the point itself. With fewer, noise dominates the gradient
MIN_RELATIVE_DETERMINANT = 1.0e-6  # of the squared neighborhood length: thinner ones (1:1000) determine one direction
plane_sums = vector(6, float64)  # count. A^2, a b, b^2. A c, b c of plane coordinates (a, b) and differences c


@kernel
def average_colors_kernel(colors: array(dtype=vec3), intensities: array(dtype=float32)):
    i = tid()
    c = widen(colors[i])
    intensities[i] = float((c[0] + c[1] + c[2]) / 3.0)


@kernel
def gather_intensities_kernel(
    intensities: array(dtype=float32), order: array(dtype=int32), sorted_intensities: array(dtype=float32)
):
    i = tid()
    sorted_intensities[i] = intensities[order[i]]


@func
def add_difference(total: plane_sums, d: vec3, change: float, u: vec3d, v: vec3d) -> plane_sums:
    """Add a neighbor at offset d with intensity difference `change`. NaN is skipped."""
    sums = total
    if isfinite(change):
        w = widen(d)
        c = float64(change)
        a = dot(u, w)
        b = dot(v, w)
        sums = total + plane_sums(1.0, a * a, a * b, b * b, a * c, b * c)
    return sums


@func
def solve_gradient(total: plane_sums, u: vec3d, v: vec3d) -> vec3d:
    """Gradient in the plane of u and v. Minimum norm if the neighbors are collinear."""
    half = (total[1] - total[3]) * 0.5
    spread = sqrt(half * half + total[2] * total[2])
    largest = (total[1] + total[3]) * 0.5 + spread
    a = float64(0.0)
    b = float64(0.0)
    if total[0] >= float64(MIN_NEIGHBORS) and largest > 0.0:
        det = total[1] * total[3] - total[2] * total[2]  # product of both eigenvalues
        if det > float64(MIN_RELATIVE_DETERMINANT) * largest * largest:
            a = (total[3] * total[4] - total[2] * total[5]) / det
            b = (total[1] * total[5] - total[2] * total[4]) / det
        else:
            x = total[2]
            y = spread - half
            if half >= 0.0:
                x = spread + half
                y = total[2]
            fraction = (x * total[4] + y * total[5]) / ((x * x + y * y) * largest)
            a = x * fraction
            b = y * fraction
    return u * a + v * b


@kernel(max_registers=80)
def fit_gradients_kernel(
    part: LaunchPart,
    tree: PointTree,
    positions: array(dtype=int32),
    scratch: GroupScratch,
    sqradius: float,
    normals: array(dtype=vec3),
    intensities: array(dtype=float32),
    gradients: array(dtype=vec3),
):
    """Gradients from the k nearest points within a radius; inputs in tree order."""
    i = tid()
    for rank, base, size in nearest_of_leaves(i, part, tree, positions, scratch, sqradius, 0):
        n = widen(normals[rank])
        length = sqrt(dot(n, n))
        if isfinite(n) and isfinite(intensities[rank]) and length > 0.0:
            p = tree.points[rank]
            u = orthogonal_direction(n / length)
            v = cross(n / length, u)
            total = plane_sums(0.0)
            for j in range(size):
                q = key_index(stored_key(scratch, base, j))
                total = add_difference(total, tree.points[q] - p, intensities[q] - intensities[rank], u, v)
            gradients[tree.order[rank]] = narrow(solve_gradient(total, u, v))


def average_colors(colors: Vectors) -> Scalars:
    """Intensity: mean of the three color channels, float32 (n)."""
    return compute(average_colors_kernel, colors.size, [colors], float32, colors.device)


def estimate_color_gradients(
    tree: PointTree, normals: Vectors, colors: Vectors, radius: float, max_nn: int
) -> tuple[Scalars, Vectors]:
    """(intensities, gradients per meter, orthogonal to the normal). Zero gradients for fewer than 4 neighbors
    (including itself) with a finite color within `radius` [m], or without a normal.
    """
    intensities = average_colors(colors)

    def fit(tree: PointTree, normals: Vectors, intensities: Scalars) -> list[Vectors]:
        return [_fit_gradients(tree, normals, intensities, radius, max_nn)]

    (gradients,) = by_distinct_points(tree, max_nn, radius, fit, normals, intensities)
    return intensities, gradients


def _fit_gradients(tree: PointTree, normals: Vectors, intensities: Scalars, radius: float, max_nn: int) -> Vectors:
    device = tree.device
    count, gradients = tree.count, zeros(tree.source.size, vec3, device)
    sorted_normals, sorted_intensities = empty(count, vec3, device), empty(count, float32, device)
    launch(gather_vec3_kernel, count, [normals, tree.order, sorted_normals])
    launch(gather_intensities_kernel, count, [intensities, tree.order, sorted_intensities])
    arguments = [squared_radius(radius), sorted_normals, sorted_intensities, gradients]
    launch_over_leaves(fit_gradients_kernel, tree, max_nn, arguments)
    return gradients
