"""From a z-buffer to a picture: colours, light, and the mean over the cells of each pixel.

One thread a pixel of the picture; reads 8 B a cell and what the triangle or point seen there holds, writes 3 B. A pixel
is the mean of its `SAMPLES` x `SAMPLES` cells. One lamp is at the camera and one above left of it, by Lambert's cosine,
and a share of the light comes from everywhere.

Points without normals get their relief from the depths around them: eye-dome lighting (Boucheny, thesis, Grenoble
2009, chapter 4), a cell being the darker the more its neighbours lie before it.
"""

from ..arrays.packed_keys import NO_KEY, key_index, key_number
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
    loop,
    struct,
    tid,
    transpose,
    uint8,
    vec3,
)
from ..memory import empty
from .z_buffer import DepthBuffer, View

SAMPLES = 2  # cells a pixel and axis
AMBIENT = 0.34
HEADLIGHT = 0.36
KEYLIGHT = 0.38
KEY_X, KEY_Y, KEY_Z = 0.45, 0.65, 0.612  # away from the lamp above left, in the camera's frame: x right, y down
RELIEF = 45.0  # strength of eye-dome lighting, of the logarithm of the depth
RELIEF_LIMIT = 0.025  # ... of which a neighbour counts at most this much, so that outlines stay grey
RELIEF_REACH = 3  # [cells]


@struct
class Look:
    """How what is drawn looks.

    Attributes:
        normals, colors: vec3, one a vertex or point; or none.
        has_normals, has_colors: Whether there are.
        plain, background: Shares of red, green and blue: of what has no colours, and of cells where nothing is.
        lit: Whether light falls at an angle.
        relief: Whether what lies behind its neighbours is darker.
    """

    normals: array(dtype=vec3)
    colors: array(dtype=vec3)
    has_normals: int
    has_colors: int
    plain: vec3
    background: vec3
    lit: int
    relief: int

    def __init__(self, normals, colors, *, plain, background, lit, relief=False):
        """With arrays that are empty where there are no normals or colours."""
        self.normals, self.has_normals = normals, int(normals.size > 0)
        self.colors, self.has_colors = colors, int(colors.size > 0)
        self.plain, self.background, self.lit, self.relief = plain, background, int(lit), int(relief)


@func
def light_face(normal: vec3, ray: vec3, view: View) -> float:
    """The light on a surface, both sides of which are lit: from the camera, from above left of it, from everywhere."""
    size = length(normal) * length(ray)
    cosine = float(0.5)
    side = float(0.5)
    if size > 0.0:
        cosine = dot(normal, ray) / size
        side = dot(normal, transpose(view.rotation) @ vec3(KEY_X, KEY_Y, KEY_Z)) / length(normal)
        if cosine < 0.0:
            side = -side
        cosine = abs(cosine)
        side = max(side, 0.0)
    return AMBIENT + HEADLIGHT * cosine + KEYLIGHT * side


@func
def cell_ray(cell: int, view: View) -> vec3:
    """The direction with depth 1 through the centre of a cell, in the world's frame."""
    x = (float(cell % view.camera.width) - float(view.camera.cx)) / float(view.camera.fx)
    y = (float(cell // view.camera.width) - float(view.camera.cy)) / float(view.camera.fy)
    return transpose(view.rotation) @ vec3(x, y, 1.0)


@func
def eye_dome(cell: int, buffer: DepthBuffer) -> float:
    """The share of light that reaches a cell past its neighbours."""
    depth = log(key_number(buffer.words[cell]))
    hidden = float(0.0)
    for k in range(8):
        place = k + k // 4  # the 8 cells around the middle of a square of 9
        column = cell % buffer.width + (place % 3 - 1) * RELIEF_REACH
        row = cell // buffer.width + (place // 3 - 1) * RELIEF_REACH
        if column >= 0 and column < buffer.width and row >= 0 and row < buffer.height:
            word = buffer.words[row * buffer.width + column]
            if word != int64(NO_KEY):
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
def color_byte(value: float) -> uint8:
    """A share of 255, rounded."""
    return uint8(int(min(max(value, 0.0), 1.0) * 255.0 + 0.5))


@loop
def cells_of(pixel: int, buffer: DepthBuffer) -> int:
    """The cells of a pixel of the picture."""
    columns = buffer.width // SAMPLES
    for k in range(SAMPLES * SAMPLES):
        row = (pixel // columns) * SAMPLES + k // SAMPLES
        cell = row * buffer.width + (pixel % columns) * SAMPLES + k % SAMPLES
        yield cell


@func
def write_mean(total: vec3, pixel: int, picture: array(dtype=uint8)):
    """Write a pixel, from the sum of the colours of its cells."""
    mean = total / float(SAMPLES * SAMPLES)
    for k in range(3):
        picture[3 * pixel + k] = color_byte(mean[k])


@kernel
def shade_triangles_kernel(
    buffer: DepthBuffer,
    view: View,
    vertices: array(dtype=vec3),
    triangles: array(dtype=int32),
    look: Look,
    picture: array(dtype=uint8),
):
    """The picture of the triangles in a z-buffer."""
    i = tid()
    total = vec3(0.0, 0.0, 0.0)
    for cell in cells_of(i, buffer):
        color = look.background
        if buffer.words[cell] != int64(NO_KEY):
            triangle = key_index(buffer.words[cell])
            ia = triangles[3 * triangle]
            ib = triangles[3 * triangle + 1]
            ic = triangles[3 * triangle + 2]
            a = vertices[ia] - view.eye
            b = vertices[ib] - view.eye
            c = vertices[ic] - view.eye
            ray = cell_ray(cell, view)
            weights = corner_weights(a, b, c, ray)
            color = look.plain
            if look.has_colors == 1:
                color = look.colors[ia] * weights[0] + look.colors[ib] * weights[1] + look.colors[ic] * weights[2]
            if look.lit == 1:
                normal = cross(b - a, c - a)
                if look.has_normals == 1:
                    normal = look.normals[ia] * weights[0] + look.normals[ib] * weights[1]
                    normal = normal + look.normals[ic] * weights[2]
                color = color * light_face(normal, ray, view)
        total = total + color
    write_mean(total, i, picture)


@kernel
def shade_points_kernel(buffer: DepthBuffer, view: View, look: Look, picture: array(dtype=uint8)):
    """The picture of the points in a z-buffer."""
    i = tid()
    total = vec3(0.0, 0.0, 0.0)
    for cell in cells_of(i, buffer):
        color = look.background
        if buffer.words[cell] != int64(NO_KEY):
            point = key_index(buffer.words[cell])
            color = look.plain
            if look.has_colors == 1:
                color = look.colors[point]
            if look.lit == 1 and look.has_normals == 1:
                color = color * light_face(look.normals[point], cell_ray(cell, view), view)
            if look.relief == 1:
                color = color * eye_dome(cell, buffer)
        total = total + color
    write_mean(total, i, picture)


def shade_triangles(buffer, view, vertices, triangles, look):
    """The picture of the triangles in a z-buffer.

    Args:
        buffer, view: As of `draw_triangles`; the size is a multiple of SAMPLES.
        vertices, triangles: As drawn.
        look: A Look; without normals faces are flat.

    Returns:
        uint8 [3 * pixels] device array.
    """
    pixels = (buffer.width // SAMPLES) * (buffer.height // SAMPLES)
    picture = empty(3 * pixels, uint8, vertices.device)
    launch(shade_triangles_kernel, pixels, [buffer, view, vertices, triangles, look, picture])
    return picture


def shade_points(buffer, view, look):
    """The picture of the points in a z-buffer, as `shade_triangles`."""
    pixels = (buffer.width // SAMPLES) * (buffer.height // SAMPLES)
    picture = empty(3 * pixels, uint8, buffer.words.device)
    launch(shade_points_kernel, pixels, [buffer, view, look, picture])
    return picture
