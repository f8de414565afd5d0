"""Texture from posed images: each texel is the weighted mean over images that show it, with weights (cos / z)^4 that
fade at image borders and vanish beside depth edges. Ownership and gutter as in atlas_colors.py; summed in image order.
"""

from ..algebra.transform import narrow, widen
from ..array_types import Array1, Bytes, Points, Triangles, Vectors
from ..arrays.prefix_sum import exclusive_scan, sum_counts
from ..arrays.select import positions_of
from ..lang import (
    array,
    compute,
    cross,
    dot,
    float32,
    float64,
    int32,
    kernel,
    launch,
    length,
    tid,
    uint8,
    vec2,
    vec3,
    vec3i,
    vec4d,
)
from ..memory import empty, full, zeros
from ..rays.scene_trees import SceneTrees
from ..rays.triangle_voxels import widened_corners
from .atlas_colors import (
    NO_TRIANGLE,
    Atlas,
    claim_texels_kernel,
    count_rows_kernel,
    mix_texels_kernel,
    round_texels_kernel,
    side_of,
    spread_texels_kernel,
    texel_corners,
)
from .hidden_vertices import drop_hidden, render_depth
from .stacked_images import StackedImages, camera_center, color_at, nearest_pixel, project_vertex
from .vertex_views import mask_in_frame

MIN_VIEW_COSINE = 0.1  # minimum cosine of the view angle
FEATHER_FRACTION = 0.05  # fraction of the shorter image side over which weights fall to zero
MAX_DEPTH_STEP = 0.05  # relative depth step of an occlusion edge
STEP_MARGIN = 2  # pixels ignored beside such an edge, because of pose errors


@kernel
def mark_owned_kernel(owners: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    owned = 0
    if owners[i] != NO_TRIANGLE:
        owned = 1
    mask[i] = uint8(owned)


@kernel
def locate_texels_kernel(
    texels: array(dtype=int32),
    atlas: Atlas,
    owners: array(dtype=int32),
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
):
    """Surface point of each texel's center, and the triangle's unit normal (0 without area)."""
    i = tid()
    texel = texels[i]
    t = owners[texel]
    u, v, w = texel_corners(atlas, t)
    x = float64(texel % atlas.width) + 0.5
    y = float64(texel // atlas.width) + 0.5
    doubled_area = side_of(u, v, w[0], w[1])
    fraction_b = side_of(w, u, x, y) / doubled_area
    fraction_c = side_of(u, v, x, y) / doubled_area
    a, b, c = widened_corners(vertices, triangles[t])
    points[i] = narrow(a + (b - a) * fraction_b + (c - a) * fraction_c)
    n = cross(b - a, c - a)
    area = length(n)
    normal = vec3(0.0, 0.0, 0.0)
    if area > 0.0:
        normal = narrow(n / area)
    normals[i] = normal


@kernel
def mark_steps_kernel(depth: array(dtype=float32), width: int, height: int, marks: array(dtype=uint8)):
    i = tid()
    u = i % width
    v = i // width
    d = depth[i]
    mark = 0
    for row in range(max(v - 1, 0), min(v + 1, height - 1) + 1):
        for column in range(max(u - 1, 0), min(u + 1, width - 1) + 1):
            other = depth[row * width + column]
            if abs(other - d) > MAX_DEPTH_STEP * min(d, other):
                mark = 1
    marks[i] = uint8(mark)


@kernel
def drop_near_steps_kernel(
    points: array(dtype=vec3), image: int, stack: StackedImages, marks: array(dtype=uint8), mask: array(dtype=uint8)
):
    """Drop texels beside depth edges, where small pose errors matter."""
    i = tid()
    if mask[i] != 0:
        projected = project_vertex(points[i], image, stack)
        size = stack.sizes[image]
        at = nearest_pixel(projected[0], projected[1], image, stack) - size[2]
        u = at % size[0]
        v = at // size[0]
        visible = 1
        for row in range(max(v - STEP_MARGIN, 0), min(v + STEP_MARGIN, size[1] - 1) + 1):
            for column in range(max(u - STEP_MARGIN, 0), min(u + STEP_MARGIN, size[0] - 1) + 1):
                if marks[row * size[0] + column] != 0:
                    visible = 0
        mask[i] = uint8(visible)


@kernel
def blend_image_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    image: int,
    stack: StackedImages,
    mask: array(dtype=uint8),
    sums: array(dtype=vec4d),
):
    """Add an image's color and weight to each visible texel."""
    i = tid()
    if mask[i] != 0:
        p = points[i]
        eye = camera_center(image, stack)
        way = eye - widen(p)
        distance = length(way)
        cosine = dot(way, widen(normals[i])) / distance
        if cosine > float64(MIN_VIEW_COSINE):
            projected = project_vertex(p, image, stack)
            size = stack.sizes[image]
            feather = float64(FEATHER_FRACTION) * float64(min(size[0], size[1]))
            border = min(projected[0] + 0.5, float64(size[0]) - 0.5 - projected[0])
            border = min(border, min(projected[1] + 0.5, float64(size[1]) - 0.5 - projected[1]))
            detail = cosine / projected[2]
            w = detail * detail * detail * detail * min(max(border / feather, 1.0e-6), 1.0)
            color = color_at(projected[0], projected[1], image, stack)
            sums[i] = sums[i] + vec4d(w * color[0], w * color[1], w * color[2], w)


@kernel
def write_texels_kernel(
    texels: array(dtype=int32), sums: array(dtype=vec4d), image: array(dtype=vec3), marks: array(dtype=uint8)
):
    i = tid()
    texel = texels[i]
    s = sums[i]
    if s[3] > 0.0:
        scale = 255.0 * s[3]
        image[texel] = vec3(float(s[0] / scale), float(s[1] / scale), float(s[2] / scale))
    marks[texel] = 1


@kernel
def mark_visible_kernel(sums: array(dtype=vec4d), visible: array(dtype=int32)):
    i = tid()
    visible[i] = 1 if sums[i][3] > 0.0 else 0


class SurfaceTexels:
    """Texels that belong to triangles: `owners` or NO_TRIANGLE. Ascending `texels`. Surface `points`, `normals`."""

    def __init__(self, vertices: Points, triangles: Triangles, uvs: Array1[vec2], size: int) -> None:
        device, count = vertices.device, size * size
        self.triangles, self.size, self.atlas = triangles, size, Atlas(uvs, size, size)
        counts, self.owners = empty(triangles.size, int32, device), full(count, NO_TRIANGLE, int32, device)
        launch(count_rows_kernel, triangles.size, [self.atlas, counts])
        rows, total = exclusive_scan(counts, largest=size)  # sync, rows of the image
        launch(claim_texels_kernel, total, [self.atlas, rows, self.owners])
        mask = compute(mark_owned_kernel, count, [self.owners], uint8, device)
        self.texels = positions_of(mask)
        self.points, self.normals = (empty(self.texels.size, vec3, device) for _ in range(2))
        given = [self.texels, self.atlas, self.owners, vertices, triangles, self.points, self.normals]
        launch(locate_texels_kernel, self.texels.size, given)

    def blend(self, stack: StackedImages, trees: SceneTrees) -> Array1[vec4d]:
        """Weighted sums of colors, 0..255, and of weights over the visible images: vec4d (n)."""
        sums = zeros(self.texels.size, vec4d, self.points.device)
        for image in range(stack.count):
            mask = mask_in_frame(self.points, image, stack, float("inf"))
            drop_hidden(self.points, image, stack, trees, mask)
            depth = render_depth(image, stack, trees)
            marks, (width, height, _) = empty(depth.size, uint8, depth.device), stack.layout[image].tolist()
            launch(mark_steps_kernel, depth.size, [depth, width, height, marks])
            launch(drop_near_steps_kernel, self.texels.size, [self.points, image, stack, marks, mask])
            given = [self.points, self.normals, image, stack, mask, sums]
            launch(blend_image_kernel, self.texels.size, given)
        return sums

    def visible_fraction(self, sums: Array1[vec4d]) -> float:
        """Fraction of texels visible in an image. One sync."""
        visible = compute(mark_visible_kernel, sums.size, [sums], int32, sums.device)
        return sum_counts(visible) / sums.size  # sync

    def write(self, sums: Array1[vec4d], colors: Vectors | None, gutter: int) -> Bytes:
        """Texture, uint8 (3 size^2). Vertex `colors` fill invisible texels (None: black); `gutter` rings."""
        device, size, count = self.points.device, self.size, self.size * self.size
        image, marks = zeros(count, vec3, device), zeros(count, uint8, device)
        if colors is not None:
            launch(mix_texels_kernel, count, [self.atlas, self.owners, self.triangles, colors, image, marks])
        launch(write_texels_kernel, self.texels.size, [self.texels, sums, image, marks])
        wider, wider_marks = empty(count, vec3, device), empty(count, uint8, device)
        for _ in range(gutter):
            launch(spread_texels_kernel, count, [size, size, image, marks, wider, wider_marks])
            image, wider, marks, wider_marks = wider, image, wider_marks, marks
        pixels = empty(3 * count, uint8, device)
        launch(round_texels_kernel, count, [image, pixels])
        return pixels
