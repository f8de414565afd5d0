"""Scenes of rounded boxes and cylinders: exact signed distances and ray intersections in float64.

Exact outside (below 1e-12 m of rounding); inside a union a lower bound of the depth. Distances of Quilez, "Distance
functions". Rays use Newton's method on the distance, which is convex along a line, without overshoot.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from ..array_types import Device, Doubles, Positions
from ..lang import (
    INFINITY,
    array,
    compute,
    float64,
    func,
    int32,
    kernel,
    mat33d,
    sqrt,
    struct,
    tid,
    transpose,
    vec3d,
    vec4d,
)
from ..memory import upload

BOX_KIND = 0
CYLINDER_KIND = 1
HIT_DISTANCE = 1e-9  # [m] distance that counts as a hit
TANGENT_HIT_DISTANCE = 1e-6  # [m] ... or this close when the steps run out, for tangent rays
MAX_STEPS = 40
MIN_SLOPE = 1e-12  # replaces a zero direction component
ZERO_LENGTH = 0.0
UNIT_SLOPE = 1.0


@func
def box_field(q: vec3d, extent: vec4d) -> vec4d:
    """Gradient and signed distance [m] of a rounded box at a point in its frame."""
    a = vec3d(abs(q[0]) - extent[0], abs(q[1]) - extent[1], abs(q[2]) - extent[2])
    x = max(a[0], float64(ZERO_LENGTH))
    y = max(a[1], float64(ZERO_LENGTH))
    z = max(a[2], float64(ZERO_LENGTH))
    size = sqrt(x * x + y * y + z * z)
    distance = size + float64(ZERO_LENGTH)
    if size > float64(ZERO_LENGTH):
        x = x / size
        y = y / size
        z = z / size
    else:
        distance = max(a[0], max(a[1], a[2]))
        if a[0] == distance:
            x = float64(UNIT_SLOPE)
        elif a[1] == distance:
            y = float64(UNIT_SLOPE)
        else:
            z = float64(UNIT_SLOPE)
    if q[0] < float64(ZERO_LENGTH):
        x = -x
    if q[1] < float64(ZERO_LENGTH):
        y = -y
    if q[2] < float64(ZERO_LENGTH):
        z = -z
    return vec4d(x, y, z, distance - extent[3])


@func
def cylinder_field(q: vec3d, extent: vec4d) -> vec4d:
    """Gradient and signed distance [m] of a rounded cylinder along z."""
    radius = sqrt(q[0] * q[0] + q[1] * q[1])
    flat = box_field(
        vec3d(radius, float64(ZERO_LENGTH), q[2]), vec4d(extent[0], float64(INFINITY), extent[2], extent[3])
    )
    x = float64(UNIT_SLOPE)
    y = float64(ZERO_LENGTH)
    if radius > float64(ZERO_LENGTH):
        x = q[0] / radius
        y = q[1] / radius
    return vec4d(flat[0] * x, flat[0] * y, flat[2], flat[3])


@func
def solid_field(q: vec3d, extent: vec4d, kind: int) -> vec4d:
    """Gradient (0, 1, 2) and signed distance (3) [m] of a solid at a point in its frame."""
    field = box_field(q, extent)
    if kind == CYLINDER_KIND:
        field = cylinder_field(q, extent)
    return field


@func
def meet_solid(origin: vec3d, direction: vec3d, extent: vec4d, kind: int, limit: float64) -> float64:
    """Parameter at which a ray in a solid's frame first hits it, from the bounding box on; infinite beyond `limit`."""
    near = float64(ZERO_LENGTH)
    far = limit + float64(ZERO_LENGTH)
    for axis in range(3):
        half = extent[axis] + extent[3]
        if kind == CYLINDER_KIND and axis == 1:
            half = extent[0] + extent[3]
        slope = direction[axis]
        if abs(slope) < float64(MIN_SLOPE):
            slope = float64(MIN_SLOPE)
        a = (-half - origin[axis]) / slope
        b = (half - origin[axis]) / slope
        near = max(near, min(a, b))
        far = min(far, max(a, b))
    t = float64(INFINITY)
    if near <= far:
        parameter = near + float64(ZERO_LENGTH)
        searching = 1
        step = 0
        while searching == 1:
            field = solid_field(origin + direction * parameter, extent, kind)
            descent = -(field[0] * direction[0] + field[1] * direction[1] + field[2] * direction[2])
            step += 1
            if field[3] <= float64(HIT_DISTANCE) or (step > MAX_STEPS and field[3] <= float64(TANGENT_HIT_DISTANCE)):
                t = parameter
                searching = 0
            elif descent <= float64(ZERO_LENGTH) or step > MAX_STEPS:
                searching = 0
            else:
                parameter = parameter + field[3] / descent
                if parameter > far:
                    searching = 0
    return t


@struct
class Solids:
    """Boxes, cylinders: rotations world to solid; extents [m]: half sizes (cylinder: radius, 0, half length),
    radius.
    """

    kinds: array(dtype=int32)
    rotations: array(dtype=mat33d)
    centers: array(dtype=vec3d)
    extents: array(dtype=vec4d)

    def __init__(
        self,
        kinds: Sequence[int] | np.ndarray,
        rotations: np.ndarray,
        centers: np.ndarray,
        extents: ArrayLike,
        device: Device,
    ) -> None:
        self.count, self.device = len(kinds), device
        self.kinds = upload(np.asarray(kinds), int32, device)
        self.rotations = upload(np.asarray(rotations), mat33d, device)
        self.centers = upload(np.asarray(centers), vec3d, device)
        self.extents = upload(np.asarray(extents), vec4d, device)


@func
def point_in_solid(p: vec3d, solid: int, solids: Solids) -> vec3d:
    return solids.rotations[solid] @ (p - solids.centers[solid])


@func
def scene_distance(p: vec3d, solids: Solids) -> float64:
    """Signed distance [m] of a point from a union of solids."""
    distance = float64(INFINITY)
    for s in range(solids.kinds.shape[0]):
        field = solid_field(point_in_solid(p, s, solids), solids.extents[s], solids.kinds[s])
        distance = min(distance, field[3])
    return distance


@func
def scene_normal(p: vec3d, solid: int, solids: Solids) -> vec3d:
    field = solid_field(point_in_solid(p, solid, solids), solids.extents[solid], solids.kinds[solid])
    return transpose(solids.rotations[solid]) @ vec3d(field[0], field[1], field[2])


@kernel
def measure_distances_kernel(points: array(dtype=vec3d), solids: Solids, distances: array(dtype=float64)):
    i = tid()
    p = points[i]
    total = p[0] + p[1] + p[2]
    distances[i] = scene_distance(p, solids) + (total - total)


def distance_to_solids(points: Positions, solids: Solids) -> Doubles:
    """Signed distances, float64 (n) [m], of points vec3d (n) from a scene, negative inside. NaN if not finite."""
    return compute(measure_distances_kernel, points.size, [points, solids], float64, points.device)
