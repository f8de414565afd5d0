"""Triangles and points drawn into a z-buffer, without a graphics library.

A cell of the buffer is one word of 64 bits: the bits of the depth above the index of what is seen there. The smallest
word wins by an atomic minimum, so the picture is the same whatever the order of the threads; equal depths go to the
smaller index. One thread a triangle visits the pixels of its box: 36 B read a triangle, 8 B a pixel, some 20
operations a pixel of the box. The buffer is several cells a pixel of the picture wide (shading.py).

Corners are rounded to 1/256 cell and the edge functions are whole numbers (Pineda, "A parallel algorithm for polygon
rasterization", SIGGRAPH 1988), so neighbouring triangles leave no gaps. Depth is along the optical axis; its reciprocal
is linear in the picture. Triangles with a corner nearer than the near plane, or projected farther outside than the
guard band, are left out whole and not clipped.
"""

from ..algebra.camera import Camera
from ..arrays.packed_keys import NO_KEY, offer_cell
from ..lang import (
    array,
    float32,
    floor,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    mat33,
    struct,
    tid,
    vec3,
)
from ..memory import full

GRID = 256.0  # steps a cell to which corners are rounded
GUARD = 1048576.0  # [cells] corners farther out are not drawn: products of edge functions stay below 2^60
NEAR = 1.0e-4  # [m] smaller depths are behind the camera


@struct
class View:
    """A camera in the world.

    Attributes:
        camera: A Camera, or what has its attributes, in cells of a buffer.
        rotation, offset: World to camera, x -> rotation x + offset.
        eye: The camera's place [m].
    """

    camera: Camera
    rotation: mat33
    offset: vec3
    eye: vec3

    def __init__(self, camera, rotation, eye):
        """From a matrix [3, 3], world to camera, and the camera's place [3]."""
        self.camera, self.rotation, self.offset, self.eye = camera, rotation, -rotation @ eye, eye


@struct
class DepthBuffer:
    """What is seen first in each cell.

    Attributes:
        width, height: Cells.
        words: int64 [height * width]: depth bits above an index, NO_KEY where nothing is seen.
    """

    width: int
    height: int
    words: array(dtype=int64)

    def __init__(self, width, height, device):
        self.width, self.height, self.words = width, height, full(width * height, NO_KEY, int64, device)


@func
def project_point(p: vec3, view: View) -> vec3:
    """Column, row and depth of a point."""
    q = view.rotation @ p + view.offset
    z = q[2]
    safe = max(z, NEAR)
    u = float(view.camera.fx) * q[0] / safe + float(view.camera.cx)
    v = float(view.camera.fy) * q[1] / safe + float(view.camera.cy)
    return vec3(u, v, z)


@func
def is_drawable(p: vec3) -> int:
    """1 for a projected point that lies before the camera and inside the guard band."""
    drawable = int(0)
    if isfinite(p) and p[2] > NEAR and abs(p[0]) < GUARD and abs(p[1]) < GUARD:
        drawable = 1
    return drawable


@kernel
def draw_triangles_kernel(
    vertices: array(dtype=vec3), triangles: array(dtype=int32), view: View, cull: int, buffer: DepthBuffer
):
    """Write the depth and index of each triangle to the cells whose centres it covers, edges included."""
    i = tid()
    a = project_point(vertices[triangles[3 * i]], view)
    b = project_point(vertices[triangles[3 * i + 1]], view)
    c = project_point(vertices[triangles[3 * i + 2]], view)
    if is_drawable(a) + is_drawable(b) + is_drawable(c) < 3:
        return
    ax = int64(int(floor(a[0] * GRID + 0.5)))
    ay = int64(int(floor(a[1] * GRID + 0.5)))
    bx = int64(int(floor(b[0] * GRID + 0.5)))
    by = int64(int(floor(b[1] * GRID + 0.5)))
    cx = int64(int(floor(c[0] * GRID + 0.5)))
    cy = int64(int(floor(c[1] * GRID + 0.5)))
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    # rows run down, so a triangle that is counterclockwise seen from before it has a negative area
    if area == int64(0) or (cull == 1 and area > int64(0)):
        return
    sign = int64(1)
    if area < int64(0):
        sign = int64(-1)
    first = max(int(floor(min(min(a[0], b[0]), c[0]))), 0)
    last = min(int(floor(max(max(a[0], b[0]), c[0]))) + 1, buffer.width - 1)
    top = max(int(floor(min(min(a[1], b[1]), c[1]))), 0)
    bottom = min(int(floor(max(max(a[1], b[1]), c[1]))) + 1, buffer.height - 1)
    scale = 1.0 / float32(area * sign)
    for row in range(top, bottom + 1):
        y = int64(row) * int64(256)
        for column in range(first, last + 1):
            x = int64(column) * int64(256)
            u = ((cx - bx) * (y - by) - (cy - by) * (x - bx)) * sign
            v = ((ax - cx) * (y - cy) - (ay - cy) * (x - cx)) * sign
            w = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) * sign
            if u >= int64(0) and v >= int64(0) and w >= int64(0):
                inverse = (float32(u) / a[2] + float32(v) / b[2] + float32(w) / c[2]) * scale
                offer_cell(row * buffer.width + column, 1.0 / inverse, i, buffer.words)


@kernel
def draw_points_kernel(points: array(dtype=vec3), view: View, radius: float, buffer: DepthBuffer):
    """Write the depth and index of each point to the cells of a disc of this radius [cells]."""
    i = tid()
    p = project_point(points[i], view)
    if is_drawable(p) == 0:
        return
    first = max(int(floor(p[0] - radius + 0.5)), 0)
    last = min(int(floor(p[0] + radius + 0.5)), buffer.width - 1)
    top = max(int(floor(p[1] - radius + 0.5)), 0)
    bottom = min(int(floor(p[1] + radius + 0.5)), buffer.height - 1)
    for row in range(top, bottom + 1):
        for column in range(first, last + 1):
            x = float(column) - p[0]
            y = float(row) - p[1]
            if x * x + y * y <= radius * radius:
                offer_cell(row * buffer.width + column, p[2], i, buffer.words)


def draw_triangles(vertices, triangles, view, *, cull):
    """Draw triangles into a z-buffer of the size of a view.

    Args:
        vertices: Device array of vec3 [m] [m].
        triangles: int32 [3 t], three vertices each, counterclockwise seen from before the triangle.
        view: The View.
        cull: Leave out triangles that look away.

    Returns:
        The DepthBuffer, with indices of triangles.
    """
    buffer = DepthBuffer(view.camera.width, view.camera.height, vertices.device)
    launch(draw_triangles_kernel, triangles.size // 3, [vertices, triangles, view, int(cull), buffer])
    return buffer


def draw_points(points, view, *, radius):
    """Draw points as discs of a radius [cells] into a z-buffer, as `draw_triangles` does; index is the point's."""
    buffer = DepthBuffer(view.camera.width, view.camera.height, points.device)
    launch(draw_points_kernel, points.size, [points, view, float(radius), buffer])
    return buffer
