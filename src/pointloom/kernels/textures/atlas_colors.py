"""Vertex colors rasterized into a texture (Pineda, "A Parallel Algorithm for Polygon Rasterization", SIGGRAPH 1988). A
texel takes the lowest triangle that contains its center (atomic minimum) and mixes corner colors in float64. The gutter
is filled with neighbor means against bleeding.
"""

from ..algebra.transform import narrow, widen
from ..array_types import Array1, Bytes, Triangles, Vectors
from ..arrays.prefix_sum import exclusive_scan, find_owner
from ..lang import (
    array,
    atomic_min,
    ceil,
    compute,
    float64,
    floor,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    struct,
    tid,
    uint8,
    vec2,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import empty, full

NO_TRIANGLE = 2147483647
WINDOW_TEXELS = 9  # texels of a 3 x 3 square


@struct
class Atlas:
    """Triangle corner coordinates `uvs` (3 t), (0, 0) lower left, in an image of `width` x `height` texels."""

    uvs: array(dtype=vec2)
    width: int
    height: int

    def __init__(self, uvs: Array1[vec2], width: int, height: int) -> None:
        self.uvs, self.width, self.height = uvs, width, height


@func
def texel_position(uv: vec2, width: int, height: int) -> vec3d:
    """Texture coordinates in texels from the upper left corner."""
    x = float64(uv[0]) * float64(width)
    y = (1.0 - float64(uv[1])) * float64(height)
    return vec3d(x, y, 0.0)


@func
def texel_corners(atlas: Atlas, t: int) -> tuple[vec3d, vec3d, vec3d]:
    a = texel_position(atlas.uvs[3 * t], atlas.width, atlas.height)
    b = texel_position(atlas.uvs[3 * t + 1], atlas.width, atlas.height)
    c = texel_position(atlas.uvs[3 * t + 2], atlas.width, atlas.height)
    return a, b, c


@func
def first_texel(x: float64, count: int) -> int:
    """First texel whose center is not below x; `count` if none."""
    texel = ceil(x - 0.5)
    return int(min(max(texel, 0.0), float64(count)))


@func
def last_texel(x: float64, count: int) -> int:
    texel = floor(x - 0.5)
    return int(min(max(texel, -1.0), float64(count - 1)))


@func
def side_of(a: vec3d, b: vec3d, x: float64, y: float64) -> float64:
    """Twice the signed area of a, b and (x, y)."""
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])


@kernel
def count_rows_kernel(atlas: Atlas, counts: array(dtype=int32)):
    """Rows of texels that each triangle may cover. None without area."""
    i = tid()
    a, b, c = texel_corners(atlas, i)
    count = 0
    if isfinite(a) and isfinite(b) and isfinite(c):
        if side_of(a, b, c[0], c[1]) != 0.0:
            low = first_texel(min(a[1], min(b[1], c[1])), atlas.height)
            high = last_texel(max(a[1], max(b[1], c[1])), atlas.height)
            count = max(high - low + 1, 0)
    counts[i] = count


@kernel
def claim_texels_kernel(atlas: Atlas, rows: array(dtype=int32), owners: array(dtype=int32)):
    """Lowest triangle at each texel (atomic minimum)."""
    i = tid()
    owner = find_owner(rows, i)
    a, b, c = texel_corners(atlas, owner)
    row = first_texel(min(a[1], min(b[1], c[1])), atlas.height) + i - rows[owner]
    sign = float64(1.0)
    if side_of(a, b, c[0], c[1]) < 0.0:
        sign = -1.0
    y = float64(row) + 0.5
    begin = first_texel(min(a[0], min(b[0], c[0])), atlas.width)
    end = last_texel(max(a[0], max(b[0], c[0])), atlas.width)
    for column in range(begin, end + 1):
        x = float64(column) + 0.5
        min_side = min(side_of(a, b, x, y) * sign, min(side_of(b, c, x, y) * sign, side_of(c, a, x, y) * sign))
        if min_side >= 0.0:
            atomic_min(owners, row * atlas.width + column, owner)


@kernel
def mix_texels_kernel(
    atlas: Atlas,
    owners: array(dtype=int32),
    triangles: array(dtype=vec3i),
    colors: array(dtype=vec3),
    texels: array(dtype=vec3),
    marks: array(dtype=uint8),
):
    i = tid()
    owner = owners[i]
    marks[i] = 0
    texels[i] = vec3(0.0, 0.0, 0.0)
    if owner != NO_TRIANGLE:
        a, b, c = texel_corners(atlas, owner)
        x = float64(i % atlas.width) + 0.5
        y = float64(i // atlas.width) + 0.5
        doubled_area = side_of(a, b, c[0], c[1])
        wa = side_of(b, c, x, y) / doubled_area
        wb = side_of(c, a, x, y) / doubled_area
        t = triangles[owner]
        mixed = widen(colors[t[0]]) * wa + widen(colors[t[1]]) * wb
        texels[i] = narrow(mixed + widen(colors[t[2]]) * (1.0 - wa - wb))
        marks[i] = 1


@kernel
def spread_texels_kernel(
    width: int,
    height: int,
    texels: array(dtype=vec3),
    marks: array(dtype=uint8),
    wider: array(dtype=vec3),
    wider_marks: array(dtype=uint8),
):
    """Fill uncolored texels with the mean of their colored neighbors."""
    i = tid()
    wider[i] = texels[i]
    wider_marks[i] = marks[i]
    if marks[i] == 0:
        total = vec3d(0.0, 0.0, 0.0)
        count = 0
        around = int(WINDOW_TEXELS)
        for k in range(around):
            x = i % width + k % 3 - 1
            y = i // width + k // 3 - 1
            if x >= 0 and x < width and y >= 0 and y < height:
                if marks[y * width + x] == 1:
                    total += widen(texels[y * width + x])
                    count += 1
        if count > 0:
            wider[i] = narrow(total / float64(count))
            wider_marks[i] = 1


@kernel
def round_texels_kernel(texels: array(dtype=vec3), image: array(dtype=uint8)):
    i = tid()
    for k in range(3):
        level = min(max(texels[i][k], 0.0), 1.0)
        image[3 * i + k] = uint8(int(floor(level * 255.0 + 0.5)))


def draw_vertex_colors(triangles: Triangles, colors: Vectors, uvs: Array1[vec2], size: int, gutter: int) -> Bytes:
    """Square image of vertex colors, uint8 (3 size^2), one sync. Raises ValueError for 2^31 texel rows."""
    device, count = triangles.device, size * size
    atlas = Atlas(uvs, size, size)
    counts = compute(count_rows_kernel, triangles.size, [atlas], int32, device)
    rows, total = exclusive_scan(counts, largest=size)  # sync, rows of the image
    owners = full(count, NO_TRIANGLE, int32, device)
    launch(claim_texels_kernel, total, [atlas, rows, owners])
    texels, marks = empty(count, vec3, device), empty(count, uint8, device)
    launch(mix_texels_kernel, count, [atlas, owners, triangles, colors, texels, marks])
    wider, wider_marks = empty(count, vec3, device), empty(count, uint8, device)
    for _ in range(gutter):
        launch(spread_texels_kernel, count, [size, size, texels, marks, wider, wider_marks])
        texels, wider, marks, wider_marks = wider, texels, wider_marks, marks
    image = empty(3 * count, uint8, device)
    launch(round_texels_kernel, count, [texels, image])
    return image
