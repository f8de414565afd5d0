"""From a z-buffer to a picture: colours, light, and the mean over the cells of each pixel.

One thread a pixel of the picture; reads 8 B a cell and what the triangle or point seen there holds, writes 3 B. A pixel
is the mean of its `SAMPLES` x `SAMPLES` cells. One lamp is at the camera and one above left of it, by Lambert's cosine,
and a share of the light comes from everywhere.

Points without normals get their relief from the depths around them: eye-dome lighting (Boucheny, thesis, Grenoble
2009, chapter 4), a cell being the darker the more its neighbours lie before it.
"""

from ..arrays.packed_keys import key_number
from ..images.raster import EMPTY
from ..lang import (
    array,
    cross,
    dot,
    exp,
    func,
    int32,
    int64,
    kernel,
    launch,
    length,
    log,
    mat33,
    tid,
    transpose,
    uint8,
    vec3,
    vec4,
)
from ..memory import empty

SAMPLES = 2  # cells a pixel and axis
AMBIENT = 0.34
HEADLIGHT = 0.36
KEYLIGHT = 0.38
KEY_X, KEY_Y, KEY_Z = 0.45, 0.65, 0.612  # away from the lamp above left, in the camera's frame: x right, y down
RELIEF = 45.0  # strength of eye-dome lighting, of the logarithm of the depth
RELIEF_LIMIT = 0.025  # ... of which a neighbour counts at most this much, so that outlines stay grey
RELIEF_REACH = 3  # [cells]


@func
def light_face(normal: vec3, view: vec3, rotation: mat33) -> float:
    """The light on a surface, both sides of which are lit: from the camera, from above left of it, from everywhere."""
    size = length(normal) * length(view)
    cosine = float(0.5)
    side = float(0.5)
    if size > 0.0:
        cosine = dot(normal, view) / size
        side = dot(normal, transpose(rotation) @ vec3(KEY_X, KEY_Y, KEY_Z)) / length(normal)
        if cosine < 0.0:
            side = -side
        cosine = abs(cosine)
        side = max(side, 0.0)
    return AMBIENT + HEADLIGHT * cosine + KEYLIGHT * side


@func
def cell_ray(cell: int, width: int, rotation: mat33, focal: vec4) -> vec3:
    """The direction with depth 1 through the centre of a cell, in the world's frame."""
    x = (float(cell % width) - focal[2]) / focal[0]
    y = (float(cell // width) - focal[3]) / focal[1]
    return transpose(rotation) @ vec3(x, y, 1.0)


@func
def eye_dome(buffer: array(dtype=int64), cell: int, width: int, height: int) -> float:
    """The share of light that reaches a cell past its neighbours."""
    depth = log(key_number(buffer[cell]))
    hidden = float(0.0)
    for k in range(8):
        place = k + k // 4  # the 8 cells around the middle of a square of 9
        column = cell % width + (place % 3 - 1) * RELIEF_REACH
        row = cell // width + (place // 3 - 1) * RELIEF_REACH
        if column >= 0 and column < width and row >= 0 and row < height:
            word = buffer[row * width + column]
            if word != int64(EMPTY):
                rise = depth - log(key_number(word))
                hidden = hidden + min(max(rise, 0.0), RELIEF_LIMIT)
    return exp(-RELIEF * hidden * 0.125)


@func
def corner_weights(a: vec3, b: vec3, c: vec3, ray: vec3) -> vec3:
    """The weights of a triangle's corners, seen from the origin, where a ray meets its plane."""
    u = dot(cross(b, c), ray)
    v = dot(cross(c, a), ray)
    w = dot(cross(a, b), ray)
    total = u + v + w
    weights = vec3(1.0, 0.0, 0.0)
    if total != 0.0:
        u = max(u / total, 0.0)
        v = max(v / total, 0.0)
        w = max(w / total, 0.0)
        weights = vec3(u, v, w) / max(u + v + w, 1.0e-6)
    return weights


@func
def pixel_byte(value: float) -> uint8:
    """A share of 255, rounded."""
    return uint8(int(min(max(value, 0.0), 1.0) * 255.0 + 0.5))


@kernel
def shade_triangles_kernel(
    buffer: array(dtype=int64),
    width: int,
    rotation: mat33,
    eye: vec3,
    focal: vec4,
    vertices: array(dtype=vec3),
    triangles: array(dtype=int32),
    normals: array(dtype=vec3),
    colors: array(dtype=vec3),
    has_normals: int,
    has_colors: int,
    plain: vec3,
    background: vec3,
    lit: int,
    picture: array(dtype=uint8),
):
    """The picture of the triangles in a z-buffer; `normals` and `colors` hold one a vertex, or nothing."""
    i = tid()
    columns = width // SAMPLES
    total = vec3(0.0, 0.0, 0.0)
    for k in range(SAMPLES * SAMPLES):
        cell = ((i // columns) * SAMPLES + k // SAMPLES) * width + (i % columns) * SAMPLES + k % SAMPLES
        color = background
        if buffer[cell] != int64(EMPTY):
            triangle = int(buffer[cell] & int64(0xFFFFFFFF))
            ia = triangles[3 * triangle]
            ib = triangles[3 * triangle + 1]
            ic = triangles[3 * triangle + 2]
            a = vertices[ia] - eye
            b = vertices[ib] - eye
            c = vertices[ic] - eye
            ray = cell_ray(cell, width, rotation, focal)
            weights = corner_weights(a, b, c, ray)
            color = plain
            if has_colors == 1:
                color = colors[ia] * weights[0] + colors[ib] * weights[1] + colors[ic] * weights[2]
            if lit == 1:
                normal = cross(b - a, c - a)
                if has_normals == 1:
                    normal = normals[ia] * weights[0] + normals[ib] * weights[1] + normals[ic] * weights[2]
                color = color * light_face(normal, ray, rotation)
        total = total + color
    total = total / float(SAMPLES * SAMPLES)
    for k in range(3):
        picture[3 * i + k] = pixel_byte(total[k])


@kernel
def shade_points_kernel(
    buffer: array(dtype=int64),
    width: int,
    height: int,
    rotation: mat33,
    focal: vec4,
    normals: array(dtype=vec3),
    colors: array(dtype=vec3),
    has_normals: int,
    has_colors: int,
    plain: vec3,
    background: vec3,
    lit: int,
    relief: int,
    picture: array(dtype=uint8),
):
    """The picture of the points in a z-buffer; `normals` and `colors` hold one a point, or nothing."""
    i = tid()
    columns = width // SAMPLES
    total = vec3(0.0, 0.0, 0.0)
    for k in range(SAMPLES * SAMPLES):
        cell = ((i // columns) * SAMPLES + k // SAMPLES) * width + (i % columns) * SAMPLES + k % SAMPLES
        color = background
        if buffer[cell] != int64(EMPTY):
            point = int(buffer[cell] & int64(0xFFFFFFFF))
            color = plain
            if has_colors == 1:
                color = colors[point]
            if lit == 1 and has_normals == 1:
                color = color * light_face(normals[point], cell_ray(cell, width, rotation, focal), rotation)
            if relief == 1:
                color = color * eye_dome(buffer, cell, width, height)
        total = total + color
    total = total / float(SAMPLES * SAMPLES)
    for k in range(3):
        picture[3 * i + k] = pixel_byte(total[k])


def shade_triangles(
    buffer, width, height, camera, eye, vertices, triangles, normals, colors, *, plain, background, lit
):
    """The picture of the triangles in a z-buffer.

    Args:
        buffer, width, height, camera: As of `draw_triangles`; the size is a multiple of SAMPLES.
        eye: The camera's place, vec3 [m].
        vertices, triangles: As drawn.
        normals, colors: vec3 [m] one a vertex, or empty arrays: then faces are flat, and `plain` colours all.
        plain, background: vec3 of shares of red, green and blue.
        lit: Shade by the angle between face and view.

    Returns:
        uint8 [3 * pixels] device array.
    """
    pixels = (width // SAMPLES) * (height // SAMPLES)
    picture = empty(3 * pixels, uint8, buffer.device)
    rotation, _, focal = camera
    surface = [vertices, triangles, normals, colors, int(normals.size > 0), int(colors.size > 0)]
    arguments = [buffer, width, rotation, eye, focal, *surface, plain, background, int(lit), picture]
    launch(shade_triangles_kernel, pixels, arguments)
    return picture


def shade_points(buffer, width, height, camera, normals, colors, *, plain, background, lit, relief):
    """The picture of the points in a z-buffer, as `shade_triangles`; `relief` darkens what lies behind neighbours."""
    pixels = (width // SAMPLES) * (height // SAMPLES)
    picture = empty(3 * pixels, uint8, buffer.device)
    rotation, _, focal = camera
    cloud = [normals, colors, int(normals.size > 0), int(colors.size > 0)]
    look = [plain, background, int(lit), int(relief)]
    launch(shade_points_kernel, pixels, [buffer, width, height, rotation, focal, *cloud, *look, picture])
    return picture
