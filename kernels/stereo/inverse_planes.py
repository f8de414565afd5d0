"""Planes as inverse depths, linear in the image: w + gx (q.x - p.x) + gy (q.y - p.y) about pixel p. A hypothesis is a
vec4 of w [1 / pose unit], gx, gy [1 / (unit px)] and cost. A lens is fx, fy, cx, cy [px]. Normals point away.
"""

from ..lang import array, dot, func, kernel, normalize, tid, vec2, vec3, vec4

MIN_COSINE = 0.2  # between normal and ray: surfaces beyond 78 degrees cannot be compared
LEANING = 0.25  # of the ray, added to normals beyond


@func
def ray_of(x: int, y: int, lens: vec4) -> vec3:
    return vec3((float(x) - lens[2]) / lens[0], (float(y) - lens[3]) / lens[1], 1.0)


@func
def slopes_of(normal: vec3, x: int, y: int, w: float, lens: vec4) -> vec2:
    """gx and gy of the plane with this normal at inverse depth w."""
    d = dot(normal, ray_of(x, y, lens)) / w
    return vec2(normal[0] / (lens[0] * d), normal[1] / (lens[1] * d))


@func
def normal_of(plane: vec4, x: int, y: int, lens: vec4) -> vec3:
    z = plane[0] - plane[1] * (float(x) - lens[2]) - plane[2] * (float(y) - lens[3])
    return normalize(vec3(plane[1] * lens[0], plane[2] * lens[1], z))


@func
def faced_away(direction: vec3, x: int, y: int, lens: vec4) -> vec3:
    """Unit normal along a direction, mirrored and tilted to point away from the camera."""
    ray = normalize(ray_of(x, y, lens))
    n = normalize(direction)
    c = dot(n, ray)
    if c < 0.0:
        n = n * -1.0
        c = -c
    if c < MIN_COSINE:
        n = normalize(n + ray * LEANING)
    return n


@func
def random_direction(u: vec4, x: int, y: int, lens: vec4) -> vec3:
    """Random normal pointing away from the camera, from uniform numbers u[1:]."""
    return faced_away(vec3(u[1] * 2.0 - 1.0, u[2] * 2.0 - 1.0, u[3] * 2.0 - 1.0), x, y, lens)


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
