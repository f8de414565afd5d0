"""Prefilter of convex hull vertices: points strictly inside a coarse hull are excluded.

The farthest point per cube-map cell gives a coarse hull (host). About an inner center the hull is 1 / distance =
g(direction), convex on each cube face, so g interpolated from grid nodes is never too small: one table lookup per
point. RELATIVE_MARGIN covers rounding, also Qhull's. The inner-polytope test of Akl and Toussaint, "A fast convex hull
algorithm", IPL 1978, on a cube map.
"""

import numpy as np

from ..algebra.transform import widen
from ..array_types import Mask, Points, Positions
from ..arrays.packed_keys import pack_key
from ..lang import (
    array,
    atomic_max,
    ceil,
    compute,
    cross,
    dot,
    float64,
    floor,
    func,
    int64,
    isfinite,
    kernel,
    launch,
    length,
    tid,
    uint8,
    vec3,
    vec3d,
    vec4d,
)
from ..linear_algebra import matmul
from ..memory import download, full, upload, zeros

LAST_INDEX = 0x7FFFFFFF  # keys store it minus the index, so that the first of equal points wins
RELATIVE_MARGIN = 1e-9  # of the distance: Qhull's planes of unit coordinates are accurate to 1e-15 over their facet
MIN_OFFSET = 1e-5  # of the farthest corner: facets nearer to the center are too steep to divide by
NODE_WITHOUT_FACET = -1.0  # at nodes without a facet


@func
def locate_direction(p: vec3d) -> vec4d:
    """(face, u, v, distance along the face's axis) of a direction: faces +x -x +y -y +z -z, u and v in -1..1."""
    x = abs(p[0])
    y = abs(p[1])
    z = abs(p[2])
    face = float64(0.0)
    side = p[0]
    along = x
    u = p[1]
    v = p[2]
    if y > x and y >= z:
        face = 2.0
        side = p[1]
        along = y
        u = p[2]
        v = p[0]
    if z > x and z > y:
        face = 4.0
        side = p[2]
        along = z
        u = p[0]
        v = p[1]
    if side < 0.0:
        face += 1.0
    if along > 0.0:
        u = u / along
        v = v / along
    return vec4d(face, u, v, along)


@func
def aim_direction(face: int, u: float64, v: float64) -> vec3d:
    """Inverse of `locate_direction`."""
    side = float64(1 - 2 * (face % 2))
    direction = vec3d(side, u, v)
    if face // 2 == 1:
        direction = vec3d(v, side, u)
    if face // 2 == 2:
        direction = vec3d(u, v, side)
    return direction


@func
def face_coordinates(p: vec3d, face: int) -> vec3d:
    """Components (along, u, v) of a vector on a cube face, before division."""
    side = float64(1 - 2 * (face % 2))
    coordinates = vec3d(side * p[0], p[1], p[2])
    if face // 2 == 1:
        coordinates = vec3d(side * p[1], p[2], p[0])
    if face // 2 == 2:
        coordinates = vec3d(side * p[2], p[0], p[1])
    return coordinates


@func
def grid_index(u: float64, width: int) -> int:
    return min(max(int(floor((u + 1.0) * 0.5 * float64(width))), 0), width - 1)


@kernel
def scale_points_kernel(points: array(dtype=vec3), middle: vec3d, scale: vec3d, out: array(dtype=vec3d)):
    i = tid()
    p = widen(points[i]) - middle
    out[i] = vec3d(p[0] * scale[0], p[1] * scale[1], p[2] * scale[2])


@kernel
def find_farthest_kernel(points: array(dtype=vec3d), center: vec3d, width: int, keys: array(dtype=int64)):
    """Farthest point of each cell (atomic maximum; ties: smaller index)."""
    i = tid()
    p = points[i] - center
    if isfinite(p):
        location = locate_direction(p)
        if location[3] > 0.0:
            row = int(location[0]) * width + grid_index(location[1], width)
            cell = row * width + grid_index(location[2], width)
            key = pack_key(float(length(p)), LAST_INDEX - i)
            if key > keys[cell]:  # usually false, which limits contention
                atomic_max(keys, cell, key)


@kernel
def draw_facets_kernel(
    corners: array(dtype=vec3d), planes: array(dtype=vec3d), width: int, nodes: array(dtype=float64)
):
    """g = plane . direction at the nodes of a facet (atomic maximum)."""
    i = tid()
    a = corners[3 * i]
    b = corners[3 * i + 1]
    c = corners[3 * i + 2]
    ab = cross(a, b)
    bc = cross(b, c)
    ca = cross(c, a)
    zero = float64(0.0)
    if dot(ab, c) > zero:
        for face in range(6):
            p = face_coordinates(a, face)
            q = face_coordinates(b, face)
            r = face_coordinates(c, face)
            low_u = float64(-1.0)
            low_v = float64(-1.0)
            high_u = float64(1.0)
            high_v = float64(1.0)
            if min(min(p[0], q[0]), r[0]) > zero:  # otherwise it leaves the half space where u and v are defined
                low_u = max(low_u, min(min(p[1] / p[0], q[1] / q[0]), r[1] / r[0]))
                low_v = max(low_v, min(min(p[2] / p[0], q[2] / q[0]), r[2] / r[0]))
                high_u = min(high_u, max(max(p[1] / p[0], q[1] / q[0]), r[1] / r[0]))
                high_v = min(high_v, max(max(p[2] / p[0], q[2] / q[0]), r[2] / r[0]))
            if max(max(p[0], q[0]), r[0]) > zero and low_u <= high_u and low_v <= high_v:
                half = 0.5 * float64(width)
                first = max(int(floor((low_v + 1.0) * half)), 0)
                last = min(int(ceil((high_v + 1.0) * half)), width)
                for row in range(max(int(floor((low_u + 1.0) * half)), 0),
                                 min(int(ceil((high_u + 1.0) * half)), width) + 1):  # fmt: skip
                    for column in range(first, last + 1):
                        u = float64(row) / half - 1.0
                        v = float64(column) / half - 1.0
                        d = aim_direction(face, u, v)
                        if dot(ab, d) >= zero and dot(bc, d) >= zero and dot(ca, d) >= zero:
                            node = (face * (width + 1) + row) * (width + 1) + column
                            atomic_max(nodes, node, dot(planes[i], d))


@kernel
def mask_outer_kernel(
    points: array(dtype=vec3d), center: vec3d, width: int, nodes: array(dtype=float64), mask: array(dtype=uint8)
):
    """0 for points strictly inside the coarse hull or not finite."""
    i = tid()
    p = points[i] - center
    keep = 0
    if isfinite(p):
        keep = 1
        location = locate_direction(p)
        row = grid_index(location[1], width)
        column = grid_index(location[2], width)
        half = 0.5 * float64(width)
        u = (location[1] + 1.0) * half - float64(row)
        v = (location[2] + 1.0) * half - float64(column)
        node = (int(location[0]) * (width + 1) + row) * (width + 1) + column
        near = nodes[node]
        right = nodes[node + width + 1]
        up = nodes[node + 1]
        if u + v > 1.0:
            near = nodes[node + width + 2]
            swap = right
            right = up
            up = swap
            u = 1.0 - u
            v = 1.0 - v
        if min(min(near, right), up) >= 0.0:
            g = near + u * (right - near) + v * (up - near)
            if location[3] * g < 1.0 - float64(RELATIVE_MARGIN):
                keep = 0
    mask[i] = uint8(keep)


def scale_points(points: Points, middle: np.ndarray, scale: np.ndarray) -> Positions:
    return compute(scale_points_kernel, points.size, [points, vec3d(*middle), vec3d(*scale)], vec3d, points.device)


def farthest_rows(points: Positions, center: np.ndarray, width: int) -> np.ndarray:
    """Ascending indices of the farthest finite point per cell, int64 on the host; `width` cells per edge. One sync."""
    keys = zeros(6 * width * width, int64, points.device)
    launch(find_farthest_kernel, points.size, [points, vec3d(*center), width, keys])
    host_keys = download(keys)  # sync
    return np.sort(LAST_INDEX - (host_keys[host_keys > 0] & LAST_INDEX))


def mask_outer(points: Positions, center: np.ndarray, corners: np.ndarray, planes: np.ndarray, width: int) -> Mask:
    """0 for points strictly inside a hull about `center`, or not finite; `planes`: normal . p + offset <= 0 inside."""
    device = points.device
    normals, offsets = planes[:, :3], -(planes[:, 3] + matmul(planes[:, :3], center))
    arms = corners - center
    ahead = offsets > MIN_OFFSET * np.abs(arms).max(initial=0)
    nodes = full(6 * (width + 1) ** 2, NODE_WITHOUT_FACET, float64, device)
    facets = upload(arms[ahead].reshape(-1, 3), vec3d, device)
    slopes = upload(normals[ahead] / offsets[ahead, None], vec3d, device)
    launch(draw_facets_kernel, slopes.size, [facets, slopes, width, nodes])
    return compute(mask_outer_kernel, points.size, [points, vec3d(*center), width, nodes], uint8, device)
