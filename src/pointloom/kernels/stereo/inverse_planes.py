"""Planes as inverse depths, linear in the image: w + gx (q.x - p.x) + gy (q.y - p.y) about pixel p. A hypothesis is a
vec4 of w [1 / pose unit], gx, gy [1 / (unit px)] and cost. A lens is fx, fy, cx, cy [px]. Normals point away.
"""

from ..lang import array, dot, func, kernel, normalize, tid, vec2, vec3, vec4

MIN_COSINE = 0.2  # between normal and ray: surfaces beyond 78 degrees cannot be compared
MIN_NORMAL_TILT = 0.25  # of the ray, added to normals beyond


@func
def ray_of(x: int, y: int, lens: vec4) -> vec3:
    return vec3((float(x) - lens[2]) / lens[0], (float(y) - lens[3]) / lens[1], 1.0)


@func
def slopes_of(direction: vec3, ray: vec3, w: float, lens: vec4) -> vec2:
    """gx and gy of the plane with a normal of this direction and any length at inverse depth w of a ray."""
    scale = w / dot(direction, ray)
    return vec2(direction[0] * scale / lens[0], direction[1] * scale / lens[1])


@func
def normal_of(plane: vec4, x: int, y: int, lens: vec4) -> vec3:
    z = plane[0] - plane[1] * (float(x) - lens[2]) - plane[2] * (float(y) - lens[3])
    return normalize(vec3(plane[1] * lens[0], plane[2] * lens[1], z))


@func
def limited_tilt(direction: vec3, ray: vec3) -> vec3:
    """A normal of any length and sign, tilted to the ray if almost perpendicular to it."""
    c = dot(direction, ray)
    tilted = direction
    if c * c <= MIN_COSINE * MIN_COSINE * (dot(direction, direction) * dot(ray, ray)):
        leaning = MIN_NORMAL_TILT
        if c < 0.0:
            leaning = -MIN_NORMAL_TILT
        tilted = normalize(direction) + normalize(ray) * leaning
    return tilted


@func
def random_direction(u: vec4) -> vec3:
    """A vector in a cube about 0 from uniform numbers u[1:]."""
    return vec3(u[1] * 2.0 - 1.0, u[2] * 2.0 - 1.0, u[3] * 2.0 - 1.0)


@func
def inverse_depth_at(plane: vec4, dx: float, dy: float) -> float:
    return plane[0] + plane[1] * dx + plane[2] * dy


@kernel
def refine_planes_kernel(
    coarse: array(dtype=vec4), columns: int, rows: int, width: int, height: int, planes: array(dtype=vec4)
):
    """Resample hypotheses from the nearest pixel of a smaller image."""
    i = tid()
    x = i % width
    y = i // width
    across = float(columns) / float(width)
    down = float(rows) / float(height)
    u = (float(x) + 0.5) * across - 0.5
    v = (float(y) + 0.5) * down - 0.5
    column = min(max(int(u + 0.5), 0), columns - 1)
    row = min(max(int(v + 0.5), 0), rows - 1)
    plane = coarse[row * columns + column]
    w = inverse_depth_at(plane, u - float(column), v - float(row))
    planes[i] = vec4(w, plane[1] * across, plane[2] * down, plane[3])
