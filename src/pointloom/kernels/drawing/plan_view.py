"""Orthographic top view of a mesh: triangle, height and color at each cell center, by vertical rays. Heights are
float64 from the stored corners. Empty cells are NaN in height and 0 in alpha. Processed in strips of rows.
"""

from ..algebra.transform import widen
from ..array_types import Array1, Bytes, Device, Indices, Integers, Points, Scalars
from ..lang import (
    INFINITY,
    NAN,
    array,
    float32,
    float64,
    floor,
    int32,
    isfinite,
    kernel,
    launch,
    struct,
    tid,
    uint8,
    vec2,
    vec3,
    vec3i,
)
from ..memory import empty, zeros
from ..rays.ray_casting import BEFORE_ALL, NO_ID
from ..rays.ray_hits import next_hit
from ..rays.scene_trees import SceneTrees
from .shading import clamp_color
from .surfaces import Surface, mix_corners

NUM_CHANNELS = 4
OPAQUE_ALPHA = 255


@struct
class PlanCells:
    """Square cells, row by row from the high y; `left`, `top` about the origin, `cell`, ray start `above` [m]."""

    left: float64
    top: float64
    cell: float64
    columns: int
    above: float

    def __init__(self, left: float, top: float, cell: float, columns: int, above: float) -> None:
        self.left, self.top, self.cell, self.columns, self.above = left, top, cell, columns, above


@struct
class VisibleTriangles:
    """Visible `triangles` int32 (NO_ID for none) and `weights` vec2 of the second and third corner."""

    triangles: array(dtype=int32)
    weights: array(dtype=vec2)

    def __init__(self, count: int, device: Device) -> None:
        self.triangles, self.weights = empty(count, int32, device), empty(count, vec2, device)


@kernel
def look_down_kernel(cells: PlanCells, first_row: int, trees: SceneTrees, visible: VisibleTriangles):
    i = tid()
    row = first_row + i // cells.columns
    column = i % cells.columns
    x = cells.left + (float64(column) + 0.5) * cells.cell
    y = cells.top - (float64(row) + 0.5) * cells.cell
    o = vec3(float(x), float(y), cells.above)
    hit = next_hit(o, vec3(0.0, 0.0, -1.0), 0.0, INFINITY, float64(BEFORE_ALL), NO_ID, 0, trees)
    triangle = int(NO_ID)
    if isfinite(hit[0]):
        triangle = trees.order[int(hit[2])]
    visible.triangles[i] = triangle
    visible.weights[i] = vec2(float(hit[3]), float(hit[4]))


@kernel
def measure_heights_kernel(
    visible: VisibleTriangles,
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    origin: float64,
    heights: array(dtype=float32),
):
    """Height of the surface in each cell. NaN for none."""
    i = tid()
    height = float(NAN)
    if visible.triangles[i] >= 0:
        t = triangles[visible.triangles[i]]
        w = visible.weights[i]
        a = widen(vertices[t[0]])
        b = widen(vertices[t[1]])
        c = widen(vertices[t[2]])
        height = float(origin + a[2] + (b[2] - a[2]) * float64(w[0]) + (c[2] - a[2]) * float64(w[1]))
    heights[i] = height


@kernel
def color_cells_kernel(
    visible: VisibleTriangles, surface: Surface, materials: array(dtype=int32), number: int, colors: array(dtype=uint8)
):
    """RGBA with alpha 255 for cells that see a triangle of a material. Others stay."""
    i = tid()
    triangle = visible.triangles[i]
    wanted = 0
    if triangle >= 0:
        wanted = 1
        if number >= 0:
            wanted = 1 if materials[triangle] == number else 0
    if wanted == 1:
        w = visible.weights[i]
        color = clamp_color(mix_corners(triangle, 1.0 - w[0] - w[1], w[0], w[1], surface))
        for k in range(3):
            colors[NUM_CHANNELS * i + k] = uint8(int(floor(255.0 * color[k] + 0.5)))
        colors[NUM_CHANNELS * i + 3] = uint8(OPAQUE_ALPHA)


def look_down(cells: PlanCells, first_row: int, rows: int, trees: SceneTrees) -> VisibleTriangles:
    count = rows * cells.columns
    visible = VisibleTriangles(count, trees.device)
    launch(look_down_kernel, count, [cells, first_row, trees, visible])
    return visible


def heights_of(visible: VisibleTriangles, vertices: Points, triangles: Array1[vec3i], origin: float) -> Scalars:
    """Heights, float32 (n), of vertices about an origin. NaN for none."""
    heights = empty(visible.triangles.size, float32, vertices.device)
    launch(measure_heights_kernel, heights.size, [visible, vertices, triangles, origin, heights])
    return heights


def colors_of(visible: VisibleTriangles, surfaces: list[tuple[int, Surface]], materials: Indices | Integers) -> Bytes:
    """Visible colors, uint8 (4 n) RGBA. `surfaces`: (material number or negative for all, appearance) pairs."""
    device, count = visible.triangles.device, visible.triangles.size
    colors = zeros(NUM_CHANNELS * count, uint8, device)
    for number, surface in surfaces:
        launch(color_cells_kernel, count, [visible, surface, materials, number, colors])
    return colors
