"""Visibility, quality and mean color of triangles in images (Waechter, Moehrle and Goesele, "Let There Be Color!", ECCV
2014, section 3).

Visible: all corners and the center are inside, unoccluded by rays, and seen at most 75 degrees from the normal. Quality
is the integral of the gradient magnitude (Gal et al. 2010) plus half a gray level per pixel, times 0.1 beside depth
edges. At most about 4096 pixels per triangle.
"""

from collections.abc import Callable, Iterator

from ..algebra.transform import narrow
from ..array_types import Doubles, Indices, Integers, Mask, Points, Triangles, Vectors
from ..arrays.concatenation import concatenate_rows
from ..arrays.prefix_sum import exclusive_scan
from ..lang import (
    array,
    ceil,
    compute,
    cross,
    dot,
    float64,
    floor,
    func,
    int32,
    kernel,
    launch,
    length,
    sqrt,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import copy, empty
from ..rays.scene_trees import SceneTrees
from ..rays.triangle_voxels import widened_corners
from .atlas_colors import side_of
from .hidden_vertices import drop_hidden, render_depth
from .stacked_images import StackedImages, camera_center, color_at, is_inside, pixel, project_vertex
from .surface_texels import STEP_MARGIN, mark_steps_kernel
from .vertex_views import Sightings, list_sightings, mask_in_frame

MIN_VIEW_COSINE = 0.258819  # cosine of the view angle: 75 degrees, as in the paper
BORDER_PIXELS = 1.0  # [px] ignored image border, for bilinear neighbors
MAX_SAMPLES = 4096.0  # pixels sampled per triangle, relative to its box
EDGE_FACTOR = 0.1  # quality factor beside depth edges
UNIFORM_GRADIENT = 0.002  # [1 / px] of brightness, half a gray level: value of a uniform triangle


@struct
class FaceViews:
    """Candidate images per triangle: `starts` (t + 1). Ascending `views`, `qualities`, mean `colors` 0..1 (k)."""

    starts: array(dtype=int32)
    views: array(dtype=int32)
    qualities: array(dtype=float64)
    colors: array(dtype=vec3)

    def __init__(self, starts: Integers, views: Indices, qualities: Doubles, colors: Vectors) -> None:
        self.starts, self.views, self.qualities, self.colors = starts, views, qualities, colors
        self.count, self.device = views.size, views.device


@kernel
def compute_centers_kernel(vertices: array(dtype=vec3), triangles: array(dtype=vec3i), centers: array(dtype=vec3)):
    i = tid()
    a, b, c = widened_corners(vertices, triangles[i])
    centers[i] = narrow((a + b + c) / 3.0)


@func
def facing(vertices: array(dtype=vec3), t: vec3i, eye: vec3d) -> float64:
    """Cosine between a triangle's normal and the direction to the eye. 0 without area."""
    a, b, c = widened_corners(vertices, t)
    n = cross(b - a, c - a)
    way = eye - (a + b + c) / 3.0
    scale = length(n) * length(way)
    cosine = float64(0.0)
    if scale > 0.0:
        cosine = dot(n, way) / scale
    return cosine


@func
def inside_margin(p: vec3, image: int, stack: StackedImages) -> int:
    projected = project_vertex(p, image, stack)
    inside = 0
    if projected[2] > 0.0:
        inside = is_inside(projected[0], projected[1], image, float64(BORDER_PIXELS), stack)
    return inside


@kernel
def mask_faces_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    image: int,
    stack: StackedImages,
    visible: array(dtype=uint8),
    mask: array(dtype=uint8),
):
    """1 for triangles entirely visible from the front; `visible` has vertices, then centers."""
    i = tid()
    t = triangles[i]
    flag = 0
    if visible[t[0]] != 0 and visible[t[1]] != 0 and visible[t[2]] != 0 and visible[vertices.shape[0] + i] != 0:
        eye = camera_center(image, stack)
        inside = inside_margin(vertices[t[0]], image, stack) + inside_margin(vertices[t[1]], image, stack)
        inside += inside_margin(vertices[t[2]], image, stack)
        if inside == 3:
            if facing(vertices, t, eye) > float64(MIN_VIEW_COSINE):
                flag = 1
    mask[i] = uint8(flag)


@func
def slope_at(u: int, v: int, image: int, stack: StackedImages) -> float64:
    """Gradient magnitude at a pixel [1 / px], by central differences."""
    size = stack.sizes[image]
    left = size[2] + v * size[0] + max(u - 1, 0)
    right = size[2] + v * size[0] + min(u + 1, size[0] - 1)
    top = size[2] + max(v - 1, 0) * size[0] + u
    bottom = size[2] + min(v + 1, size[1] - 1) * size[0] + u
    x = 0.5 * (float64(stack.brightness[right]) - float64(stack.brightness[left]))
    y = 0.5 * (float64(stack.brightness[bottom]) - float64(stack.brightness[top]))
    return sqrt(x * x + y * y)


@func
def pixel_color(u: int, v: int, image: int, stack: StackedImages) -> vec3d:
    size = stack.sizes[image]
    at = size[2] + v * size[0] + u
    red = float64(int(stack.pixels[at, 0]))
    green = float64(int(stack.pixels[at, 1]))
    return vec3d(red, green, float64(int(stack.pixels[at, 2])))


@func
def flat(projected: pixel) -> vec3d:
    return vec3d(projected[0], projected[1], 0.0)


@func
def is_near_step(u: float64, v: float64, image: int, stack: StackedImages, steps: array(dtype=uint8)) -> int:
    """1 if the depth is discontinuous within two pixels."""
    size = stack.sizes[image]
    column = int(floor(u + 0.5))
    row = int(floor(v + 0.5))
    is_near = 0
    for y in range(max(row - STEP_MARGIN, 0), min(row + STEP_MARGIN, size[1] - 1) + 1):
        for x in range(max(column - STEP_MARGIN, 0), min(column + STEP_MARGIN, size[0] - 1) + 1):
            if steps[size[2] + y * size[0] + x] != 0:
                is_near = 1
    return is_near


@kernel
def measure_views_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    sightings: Sightings,
    stack: StackedImages,
    steps: array(dtype=uint8),
    views: array(dtype=int32),
    qualities: array(dtype=float64),
    colors: array(dtype=vec3),
):
    """Image, quality and mean color of each pair, in triangle order."""
    i = tid()
    pair = sightings.order[i]
    image = sightings.images[pair]
    t = triangles[sightings.vertices[pair]]
    a = flat(project_vertex(vertices[t[0]], image, stack))
    b = flat(project_vertex(vertices[t[1]], image, stack))
    c = flat(project_vertex(vertices[t[2]], image, stack))
    doubled = side_of(a, b, c[0], c[1])
    sign = float64(1.0)
    if doubled < 0.0:
        sign = -1.0
    left = int(ceil(min(a[0], min(b[0], c[0]))))
    right = int(floor(max(a[0], max(b[0], c[0]))))
    top = int(ceil(min(a[1], min(b[1], c[1]))))
    bottom = int(floor(max(a[1], max(b[1], c[1]))))
    room = float64(max(right - left + 1, 1)) * float64(max(bottom - top + 1, 1))
    stride = max(int(ceil(sqrt(room / float64(MAX_SAMPLES)))), 1)
    count = float64(0.0)
    slope = float64(0.0)
    color = vec3d(0.0, 0.0, 0.0)
    v = top
    while v <= bottom:
        y = float64(v)
        u = left
        while u <= right:
            x = float64(u)
            min_side = min(side_of(a, b, x, y) * sign, min(side_of(b, c, x, y) * sign, side_of(c, a, x, y) * sign))
            if min_side >= 0.0:
                count += 1.0
                slope += slope_at(u, v, image, stack)
                color += pixel_color(u, v, image, stack)
            u += stride
        v += stride
    x = (a[0] + b[0] + c[0]) / 3.0
    y = (a[1] + b[1] + c[1]) / 3.0
    if count == 0.0:
        count = 1.0
        slope = slope_at(int(floor(x + 0.5)), int(floor(y + 0.5)), image, stack)
        color = color_at(x, y, image, stack)
    views[i] = image
    quality = 0.5 * abs(doubled) * (slope / count + float64(UNIFORM_GRADIENT))
    beside = is_near_step(a[0], a[1], image, stack, steps) + is_near_step(b[0], b[1], image, stack, steps)
    beside += is_near_step(c[0], c[1], image, stack, steps) + is_near_step(x, y, image, stack, steps)
    if beside > 0:
        quality = quality * float64(EDGE_FACTOR)
    qualities[i] = quality
    colors[i] = narrow(color / (255.0 * count))


@kernel
def count_selected_kernel(starts: array(dtype=int32), keep: array(dtype=uint8), counts: array(dtype=int32)):
    i = tid()
    count = 0
    for k in range(starts[i], starts[i + 1]):
        if keep[k] != 0:
            count += 1
    counts[i] = count


@kernel
def copy_selected_kernel(before: FaceViews, keep: array(dtype=uint8), after: FaceViews):
    i = tid()
    slot = after.starts[i]
    for k in range(before.starts[i], before.starts[i + 1]):
        if keep[k] != 0:
            after.views[slot] = before.views[k]
            after.qualities[slot] = before.qualities[k]
            after.colors[slot] = before.colors[k]
            slot += 1


class FaceVisibility:
    """Visibility of a mesh's triangles image by image. Points beyond `farthest` [m] are not visible."""

    def __init__(
        self, vertices: Points, triangles: Triangles, stack: StackedImages, trees: SceneTrees, farthest: float
    ) -> None:
        self.vertices, self.triangles, self.images, self.trees = vertices, triangles, stack, trees
        self.farthest = float(farthest)
        centers = compute(compute_centers_kernel, triangles.size, [vertices, triangles], vec3, vertices.device)
        self.points = concatenate_rows([vertices, centers])
        self.steps = empty(stack.pixels.shape[0], uint8, vertices.device)

    def mask(self, image: int) -> Mask:
        points, stack = self.points, self.images
        visible = mask_in_frame(points, image, stack, self.farthest)
        drop_hidden(points, image, stack, self.trees, visible)
        depth = render_depth(image, stack, self.trees)
        marks, (width, height, first) = empty(depth.size, uint8, depth.device), stack.layout[image].tolist()
        launch(mark_steps_kernel, depth.size, [depth, width, height, marks])
        copy(self.steps, marks, count=marks.size, offset=first)
        mask = empty(self.triangles.size, uint8, visible.device)
        launch(mask_faces_kernel, mask.size, [self.vertices, self.triangles, image, stack, visible, mask])
        return mask

    def views(self, report: Callable[[int], None]) -> FaceViews:
        """Images of all triangles. Calls `report` with the number of each image. A few syncs."""
        sightings = list_sightings(self._masks(report))  # sync
        device, count = self.vertices.device, sightings.count
        views, qualities = empty(count, int32, device), empty(count, float64, device)
        colors = empty(count, vec3, device)
        given = [self.vertices, self.triangles, sightings, self.images, self.steps, views, qualities, colors]
        launch(measure_views_kernel, count, given)
        return FaceViews(sightings.starts, views, qualities, colors)

    def _masks(self, report: Callable[[int], None]) -> Iterator[Mask]:
        for image in range(self.images.count):
            report(image)
            yield self.mask(image)


def keep_views(views: FaceViews, keep: Mask) -> FaceViews:
    """Select pairs by a mask uint8 (k). One sync."""
    faces, device = views.starts.size - 1, views.device
    counts = compute(count_selected_kernel, faces, [views.starts, keep], int32, device)
    starts, total = exclusive_scan(counts, largest=keep.size)  # sync, some of all pairs
    selected = FaceViews(starts, empty(total, int32, device), empty(total, float64, device), empty(total, vec3, device))
    launch(copy_selected_kernel, faces, [views, keep, selected])
    return selected
