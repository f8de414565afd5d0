"""Lines with width and round ends in a z-buffer, drawn slightly nearer so that lines on surfaces stay visible."""

from typing import TYPE_CHECKING

from ..array_types import Integers, Points
from ..arrays.packed_keys import offer_cell
from ..lang import array, floor, func, int32, isfinite, kernel, launch, sqrt, struct, tid, vec2, vec3
from .z_buffer import MIN_DEPTH, DepthBuffer, View, project, to_camera

if TYPE_CHECKING:
    from ..algebra.camera import Camera

LINE_DEPTH_OFFSET = 2.0e-4  # fraction of the depth by which lines are drawn nearer; and ...
LIFT_SLOPE = 3.0  # ... tangent of the surface slope up to which half of a line's width stays visible


@struct
class Pen:
    """Line style: `radius`, half the width [cells]; `closer`, factor of depths."""

    radius: float
    closer: float

    def __init__(self, radius: float, camera: "Camera") -> None:
        self.radius = radius
        self.closer = 1.0 - min(LINE_DEPTH_OFFSET + LIFT_SLOPE * radius / float(camera.fx), 0.05)


@func
def depth_inside(k: int, q: vec3, margin: float, view: View) -> float:
    """Distance of a camera-frame point to the inner side of frustum plane k."""
    inside = q[2] - MIN_DEPTH
    x = float(view.camera.fx) * q[0] + float(view.camera.cx) * q[2]
    y = float(view.camera.fy) * q[1] + float(view.camera.cy) * q[2]
    if k == 1:
        inside = x + margin * q[2]
    if k == 2:
        inside = (float(view.camera.width) + margin) * q[2] - x
    if k == 3:
        inside = y + margin * q[2]
    if k == 4:
        inside = (float(view.camera.height) + margin) * q[2] - y
    return inside


@func
def clip_line(p: vec3, q: vec3, margin: float, view: View) -> vec2:
    """Visible parameter range of a line (Liang and Barsky 1984), reversed if none."""
    first = 0.0
    last = 1.0
    planes = int(5)
    for k in range(planes):
        a = depth_inside(k, p, margin, view)
        b = depth_inside(k, q, margin, view)
        if a < 0.0 and b < 0.0:
            first = 2.0
        elif a < 0.0:
            first = max(first, a / (a - b))
        elif b < 0.0:
            last = min(last, a / (a - b))
    return vec2(first, last)


@func
def draw_line(a: vec3, b: vec3, index: int, pen: Pen, buffer: DepthBuffer):
    """Draw a line between projected ends along its longer axis."""
    dx = b[0] - a[0]
    dy = b[1] - a[1]
    is_steep = 0
    slope = 0.0
    if abs(dy) > abs(dx):
        is_steep = 1
        slope = dx / dy
    elif dx != 0.0:
        slope = dy / dx
    along = a[0]
    across = a[1]
    end = b[0]
    steps = buffer.width
    limit = buffer.height
    if is_steep == 1:
        along = a[1]
        across = a[0]
        end = b[1]
        steps = buffer.height
        limit = buffer.width
    half = pen.radius * sqrt(1.0 + slope * slope)
    squared = dx * dx + dy * dy
    near_a = 1.0 / a[2]
    near_b = 1.0 / b[2]
    first = max(int(floor(min(along, end) - pen.radius)), 0)
    last = min(int(floor(max(along, end) + pen.radius)) + 1, steps - 1)
    for step in range(first, last + 1):
        middle = across + (float(step) - along) * slope
        low = max(int(floor(middle - half)), 0)
        high = min(int(floor(middle + half)) + 1, limit - 1)
        for side in range(low, high + 1):
            column = step
            row = side
            if is_steep == 1:
                column = side
                row = step
            x = float(column) - a[0]
            y = float(row) - a[1]
            fraction = 0.0
            if squared > 0.0:
                fraction = min(max((x * dx + y * dy) / squared, 0.0), 1.0)
            ex = x - fraction * dx
            ey = y - fraction * dy
            if ex * ex + ey * ey <= pen.radius * pen.radius:
                depth = pen.closer / (near_a + (near_b - near_a) * fraction)
                offer_cell(row * buffer.width + column, depth, index, buffer.words)


@kernel
def draw_lines_kernel(
    points: array(dtype=vec3), lines: array(dtype=int32), view: View, pen: Pen, start: int, buffer: DepthBuffer
):
    i = tid()
    p = to_camera(points[lines[2 * i]], view)
    q = to_camera(points[lines[2 * i + 1]], view)
    if isfinite(p) and isfinite(q):
        fractions = clip_line(p, q, pen.radius + 1.0, view)
        if fractions[0] <= fractions[1]:
            a = project(p + (q - p) * fractions[0], view)
            b = project(p + (q - p) * fractions[1], view)
            if a[2] > 0.0 and b[2] > 0.0:
                draw_line(a, b, start + i, pen, buffer)


def draw_lines(points: Points, lines: Integers, view: View, buffer: DepthBuffer, *, pen: Pen, start: int = 0) -> None:
    """Draw lines into a z-buffer. `lines` int32 (2 m), two points each; `start` index of the first line."""
    launch(draw_lines_kernel, lines.size // 2, [points, lines, view, pen, start, buffer])
