"""Front-to-back blending of splats (Kerbl et al. 2023, eq. 3) down to 1e-4 of the light, and their surface."""

from ..algebra.exponential import exp_in_float
from ..array_types import Array2, Scalars, Vectors
from ..arrays.packed_keys import NO_KEY, key_number
from ..drawing.shading import CELLS_PER_PIXEL, color_byte
from ..drawing.z_buffer import DepthBuffer, View, ray_through
from ..lang import INFINITY, array, dot, float32, func, int64, kernel, launch, length, struct, tid, uint8, vec3, vec4
from ..memory import empty, zeros
from .projection import MAX_OPACITY, MIN_OPACITY, TILE_PIXELS, ProjectedSplats
from .tile_lists import TileLists, pixel_of_thread

MIN_LEFT = 1.0e-4  # transmittance at which blending stops


@struct
class SplatSurface:
    """Pixels of splats: transmittance `left`. Mean `depths`; `medians` at half transmittance. Unit `normals`."""

    colors: array(dtype=vec3)
    left: array(dtype=float32)
    depths: array(dtype=float32)
    medians: array(dtype=float32)
    normals: array(dtype=vec3)

    def __init__(self, lists: TileLists) -> None:
        pixels, device = lists.width * lists.height, lists.members.device
        self.colors, self.normals = zeros(pixels, vec3, device), zeros(pixels, vec3, device)
        self.left, self.depths, self.medians = (zeros(pixels, float32, device) for _ in range(3))


@func
def opacity_at(splat: int, column: float, row: float, projected: ProjectedSplats) -> float:
    """Opacity of a splat in a pixel, 0 if negligible."""
    middle = projected.middles[splat]
    conic = projected.conics[splat]
    x = column - middle[0]
    y = row - middle[1]
    power = -0.5 * (conic[0] * x * x + conic[2] * y * y) - conic[1] * x * y
    opacity = 0.0
    if power > -projected.limits[splat]:
        opacity = min(projected.opacities[splat] * exp_in_float(min(power, 0.0)), MAX_OPACITY)
    return opacity if opacity >= MIN_OPACITY else 0.0


@func
def meet_splat(splat: int, ray: vec3, projected: ProjectedSplats) -> float:
    """Depth of maximum density of a splat along a ray of depth 1."""
    middle = projected.middles[splat][2]
    sides = projected.others[splat]
    a = projected.diagonals[splat]
    x = a[0] * ray[0] + sides[0] * ray[1] + sides[1] * ray[2]
    y = sides[0] * ray[0] + a[1] * ray[1] + sides[2] * ray[2]
    z = sides[1] * ray[0] + sides[2] * ray[1] + a[2] * ray[2]
    steep = dot(ray, vec3(x, y, z))
    depth = middle + 0.0
    if steep > 0.0:
        depth = dot(ray, projected.pulls[splat]) / steep
    max_offset = projected.depths[splat]
    return min(max(depth, middle - max_offset), middle + max_offset)


@kernel
def blend_splats_kernel(
    lists: TileLists,
    projected: ProjectedSplats,
    buffer: DepthBuffer,
    left: array(dtype=float32),
    light: array(dtype=vec3),
):
    """Add splats to an image whose cells contain the solid surfaces."""
    i = tid()
    pixel = pixel_of_thread(i, lists)
    if pixel >= 0:
        column = pixel % lists.width
        row = pixel // lists.width
        corner = row * CELLS_PER_PIXEL * buffer.width + column * CELLS_PER_PIXEL
        lefts = vec4(0.0)
        solid = vec4(0.0)
        for k in range(CELLS_PER_PIXEL * CELLS_PER_PIXEL):
            cell = corner + (k // CELLS_PER_PIXEL) * buffer.width + k % CELLS_PER_PIXEL
            lefts[k] = left[cell]
            solid[k] = INFINITY
            if buffer.words[cell] != int64(NO_KEY):
                solid[k] = key_number(buffer.words[cell])
        total = vec3(0.0)
        max_left = 1.0
        index = lists.starts[i // TILE_PIXELS]
        last = lists.starts[i // TILE_PIXELS + 1]
        while index < last and max_left > MIN_LEFT:
            splat = lists.members[index]
            opacity = opacity_at(splat, float(column), float(row), projected)
            if opacity > 0.0:
                depth = projected.middles[splat][2]
                seen = 0.0
                max_left = 0.0
                for k in range(CELLS_PER_PIXEL * CELLS_PER_PIXEL):
                    fraction = lefts[k] * opacity if depth < solid[k] else 0.0
                    seen = seen + fraction
                    lefts[k] = lefts[k] - fraction
                    max_left = max(max_left, lefts[k] if depth < solid[k] else 0.0)
                total = total + projected.colors[splat] * seen
            index += 1
        for k in range(CELLS_PER_PIXEL * CELLS_PER_PIXEL):
            left[corner + (k // CELLS_PER_PIXEL) * buffer.width + k % CELLS_PER_PIXEL] = lefts[k]
        light[pixel] = light[pixel] + total


@kernel
def find_surface_kernel(lists: TileLists, projected: ProjectedSplats, view: View, surface: SplatSurface):
    i = tid()
    pixel = pixel_of_thread(i, lists)
    if pixel >= 0:
        column = float(pixel % lists.width)
        row = float(pixel // lists.width)
        ray = ray_through(column, row, view)
        color = vec3(0.0)
        normal = vec3(0.0)
        depth = 0.0
        median = 0.0
        left = 1.0
        index = lists.starts[i // TILE_PIXELS]
        last = lists.starts[i // TILE_PIXELS + 1]
        while index < last and left > MIN_LEFT:
            splat = lists.members[index]
            opacity = opacity_at(splat, column, row, projected)
            if opacity > 0.0:
                fraction = left * opacity
                met = meet_splat(splat, ray, projected)
                color = color + projected.colors[splat] * fraction
                normal = normal + projected.normals[splat] * fraction
                depth = depth + met * fraction
                if left > 0.5 and left - fraction <= 0.5:
                    median = met
                left = left - fraction
            index += 1
        size = length(normal)
        if size > 0.0:
            normal = normal / size
        surface.colors[pixel] = color
        surface.left[pixel] = left
        surface.depths[pixel] = depth / (1.0 - left) if left < 1.0 else 0.0
        surface.medians[pixel] = median
        surface.normals[pixel] = normal


@kernel
def color_surface_kernel(surface: SplatSurface, pixels: array(dtype=uint8, ndim=2)):
    i = tid()
    fraction = 1.0 - surface.left[i]
    for channel in range(3):
        value = 0.0
        if fraction > 0.0:
            value = surface.colors[i][channel] / fraction
        pixels[i, channel] = color_byte(value)


def blend_splats(
    lists: TileLists, projected: ProjectedSplats, buffer: DepthBuffer, left: Scalars, light: Vectors
) -> None:
    """Add splats in front of a buffer of SAMPLES cells per pixel and axis, in its unit; updates `left`."""
    launch(blend_splats_kernel, lists.threads, [lists, projected, buffer, left, light])


def find_surface(lists: TileLists, projected: ProjectedSplats, view: View) -> SplatSurface:
    surface = SplatSurface(lists)
    launch(find_surface_kernel, lists.threads, [lists, projected, view, surface])
    return surface


def color_surface(surface: SplatSurface) -> Array2[uint8]:
    pixels = empty((surface.left.size, 3), uint8, surface.left.device)
    launch(color_surface_kernel, surface.left.size, [surface, pixels])
    return pixels
