"""Shading of triangles: vertex colors or texture, smooth or flat normals, edges."""

from typing import NamedTuple

import numpy as np

from ..array_types import Array1, Indices, Points, Vectors
from ..lang import array, cross, dot, floor, func, int32, kernel, launch, sqrt, struct, tid, uint8, vec2, vec3, vector
from ..memory import empty, upload
from .shading import CELLS_PER_PIXEL, Region, Veil, clamp_color, element_at, light_face, seen_fraction
from .z_buffer import DepthBuffer, View, ray_through, to_camera

EDGE_WIDTH = 0.5  # [px] half width of an edge inside a triangle
EDGE_SHADE = 0.12  # brightness factor of edges
NO_COLOR = vec3(0.0, 0.0, 0.0)
cell_indices = vector(CELLS_PER_PIXEL * CELLS_PER_PIXEL, int32)  # an index per cell of a pixel


class Texture(NamedTuple):
    """An image, uint8 (h, w, 3 or 4), top row first, and its coordinates per corner ((0, 0) is lower left)."""

    pixels: np.ndarray
    uvs: Array1[vec2]


@struct
class Surface:
    """Triangles and their appearance: per-vertex `normals` and `colors`, or empty; a texture; `plain` default color."""

    vertices: array(dtype=vec3)
    triangles: array(dtype=int32)
    normals: array(dtype=vec3)
    colors: array(dtype=vec3)
    uvs: array(dtype=vec2)
    texture: array(dtype=uint8)
    texture_width: int
    texture_height: int
    plain: vec3
    lit: int
    edges: int

    def __init__(
        self,
        vertices: Points,
        triangles: Indices,
        *,
        normals: Vectors,
        colors: Vectors,
        texture: Texture | None = None,
        plain: vec3 = NO_COLOR,
        lit: bool = False,
        edges: bool = False,
    ) -> None:
        device = vertices.device
        self.vertices, self.triangles, self.normals, self.colors = vertices, triangles, normals, colors
        if texture is None:
            self.texture, self.uvs = empty(0, uint8, device), empty(0, vec2, device)
            self.texture_height = self.texture_width = 0
        else:
            pixels, self.uvs = np.ascontiguousarray(texture.pixels[:, :, :3]), texture.uvs
            self.texture, (self.texture_height, self.texture_width, _) = (
                upload(pixels.ravel(), uint8, device),
                pixels.shape,
            )
        self.plain, self.lit, self.edges = plain, int(lit), int(edges)


@func
def texel(column: int, row: int, surface: Surface) -> vec3:
    """Texture pixel with repetition, 0 to 1."""
    x = (column % surface.texture_width + surface.texture_width) % surface.texture_width
    y = (row % surface.texture_height + surface.texture_height) % surface.texture_height
    k = 3 * (y * surface.texture_width + x)
    r = float(int(surface.texture[k]))
    g = float(int(surface.texture[k + 1]))
    b = float(int(surface.texture[k + 2]))
    return vec3(r, g, b) / 255.0


@func
def read_texture(u: float, v: float, surface: Surface) -> vec3:
    across = u - floor(u)
    down = 1.0 - (v - floor(v))
    if not (across >= 0.0 and across <= 1.0 and down >= 0.0 and down <= 1.0):  # NaN
        across = 0.0
        down = 0.0
    x = across * float(surface.texture_width) - 0.5
    y = down * float(surface.texture_height) - 0.5
    column = int(floor(x))
    row = int(floor(y))
    s = x - float(column)
    t = y - float(row)
    upper = texel(column, row, surface) * (1.0 - s) + texel(column + 1, row, surface) * s
    lower = texel(column, row + 1, surface) * (1.0 - s) + texel(column + 1, row + 1, surface) * s
    return upper * (1.0 - t) + lower * t


@func
def mix_corners(triangle: int, wa: float, wb: float, wc: float, surface: Surface) -> vec3:
    color = surface.plain
    if surface.texture_width > 0:
        ta = surface.uvs[3 * triangle]
        tb = surface.uvs[3 * triangle + 1]
        tc = surface.uvs[3 * triangle + 2]
        x = ta[0] * wa + tb[0] * wb + tc[0] * wc
        y = ta[1] * wa + tb[1] * wb + tc[1] * wc
        color = read_texture(x, y, surface)
    elif surface.colors.shape[0] > 0:
        a = surface.colors[surface.triangles[3 * triangle]]
        b = surface.colors[surface.triangles[3 * triangle + 1]]
        c = surface.colors[surface.triangles[3 * triangle + 2]]
        color = clamp_color(a * wa + b * wb + c * wc)
    return color


@func
def distance_to_edge(edge: vec3, ray: vec3, view: View) -> float:
    """Distance [cells] of a ray from the zero line of an edge function."""
    x = edge[0] / float(view.camera.fx)
    y = edge[1] / float(view.camera.fy)
    slope = sqrt(x * x + y * y)
    distance = 1.0e6
    if slope > 0.0:
        distance = abs(dot(edge, ray)) / slope
    return distance


@func
def color_of(triangle: int, column: float, row: float, view: View, surface: Surface) -> vec3:
    ia = surface.triangles[3 * triangle]
    ib = surface.triangles[3 * triangle + 1]
    ic = surface.triangles[3 * triangle + 2]
    corner = surface.vertices[ia]
    a = to_camera(corner, view)
    ab = view.rotation @ (surface.vertices[ib] - corner)
    ac = view.rotation @ (surface.vertices[ic] - corner)
    ray = ray_through(column, row, view)
    # Moeller and Trumbore's edge functions: linear in the ray, and exact for small distant triangles
    edge_b = cross(a, ac)
    edge_c = cross(ab, a)
    facing = cross(ac, ab)
    u = dot(edge_b, ray)
    v = dot(edge_c, ray)
    total = dot(facing, ray)
    wa = 1.0
    wb = 0.0
    wc = 0.0
    if total != 0.0:
        inverse = 1.0 / total
        wb = min(max(u * inverse, 0.0), 1.0)
        wc = min(max(v * inverse, 0.0), 1.0 - wb)
        wa = 1.0 - wb - wc
    color = mix_corners(triangle, wa, wb, wc, surface)
    if surface.edges == 1:
        distance = min(distance_to_edge(edge_b, ray, view), distance_to_edge(edge_c, ray, view))
        distance = min(distance, distance_to_edge(facing - edge_b - edge_c, ray, view)) / float(CELLS_PER_PIXEL)
        cover = min(max(EDGE_WIDTH + 0.5 - distance, 0.0), 1.0)
        color = color * (1.0 - cover * (1.0 - EDGE_SHADE))
    if surface.lit == 1:
        if total < 0.0:
            facing = -facing
        normal = facing
        if surface.normals.shape[0] > 0:
            mixed = surface.normals[ia] * wa + surface.normals[ib] * wb + surface.normals[ic] * wc
            normal = view.rotation @ mixed
        color = color * light_face(normal, facing, ray)
    return color


@kernel
def shade_surface_kernel(
    buffer: DepthBuffer, view: View, region: Region, surface: Surface, veil: Veil, light: array(dtype=vec3)
):
    """Add the colors of the cells that show triangles: of a texture per cell, else one per triangle of a pixel, at the
    mean of its cells.
    """
    i = tid()
    column = region.left + i % region.wide
    row = region.top + i // region.wide
    first = row * CELLS_PER_PIXEL * buffer.width + column * CELLS_PER_PIXEL
    triangles = cell_indices(-1)
    left = 0
    for k in range(CELLS_PER_PIXEL * CELLS_PER_PIXEL):
        triangles[k] = element_at(first + (k // CELLS_PER_PIXEL) * buffer.width + k % CELLS_PER_PIXEL, region, buffer)
        if triangles[k] >= 0:
            left = 1
    if left == 1:
        total = vec3(0.0, 0.0, 0.0)
        for k in range(CELLS_PER_PIXEL * CELLS_PER_PIXEL):
            triangle = triangles[k]
            if triangle >= 0:
                across = float(0.0)
                down = float(0.0)
                count = float(0.0)
                fraction = float(0.0)
                for j in range(CELLS_PER_PIXEL * CELLS_PER_PIXEL):
                    if triangles[j] == triangle and (j == k or surface.texture_width == 0):
                        across = across + float(j % CELLS_PER_PIXEL)
                        down = down + float(j // CELLS_PER_PIXEL)
                        count = count + 1.0
                        cell = first + (j // CELLS_PER_PIXEL) * buffer.width + j % CELLS_PER_PIXEL
                        fraction = fraction + seen_fraction(cell, veil)
                        triangles[j] = -1
                x = float(column * CELLS_PER_PIXEL) + across / count
                y = float(row * CELLS_PER_PIXEL) + down / count
                total = total + color_of(triangle, x, y, view, surface) * fraction
        pixel = row * (buffer.width // CELLS_PER_PIXEL) + column
        light[pixel] = light[pixel] + total


def shade_surface(
    buffer: DepthBuffer, view: View, region: Region, light: Vectors, surface: Surface, veil: Veil
) -> None:
    """Add the light of triangles. Arguments as of `draw_triangles` and `shade_points`."""
    launch(shade_surface_kernel, region.pixels, [buffer, view, region, surface, veil, light])
