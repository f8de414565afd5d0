"""The texels of a mesh's texture, where each lies on the surface, and their colours from posed pictures.

A texel belongs to the triangle whose place in the texture holds its centre, to the smallest number where several do.
One thread a triangle visits the texels of its box in the texture: 8 B a texel, some 20 operations. Of texels that
belong to none, those within some texels of one that does (the gutter) take the mean of their neighbours, ring by ring,
so that what blends texels does not blend in the background.

A texel's colour is the mean over the pictures that show it, by weights (cos / z)^4, the angle of view and the depth: of
two pictures the one with twice as many pixels there counts four times. Weights fall to zero at a picture's border, so
that it leaves no seam. Beside the edges of the mesh, as its own depth tells, a picture counts for nothing. Sums are
made picture by picture, in their order: 76 B a texel, some 150 operations and a ray a picture, and a ray a pixel.
"""

from ..algebra.transform import narrow, widen
from ..arrays.select import positions_of
from ..lang import (
    array,
    atomic_min,
    cross,
    dot,
    float32,
    float64,
    floor,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    length,
    tid,
    uint8,
    vec2,
    vec3,
    vec3d,
    vec3i,
    vec4d,
)
from ..memory import empty, full, zeros
from .hidden_vertices import drop_hidden, render_depth
from .posed_pictures import PosedPictures, camera_place, color_at, nearest_pixel, project_vertex
from .vertex_views import see_in_frame

NOBODY = 2**31 - 1  # owner of a texel that belongs to no triangle
STEEPEST = 0.1  # cosine of the angle of view below which a picture shows next to nothing
FEATHER = 0.05  # share of a picture's shorter side over which weights fall to zero
STEP = 0.05  # share of the depth by which neighbouring pixels differ at the edge of what stands before something else
BESIDE = 2  # pixels from such an edge that are not looked at: poses are not that exact
OUTSIDE = -1.0e-9  # of an edge function: centres on an edge belong to both sides


@func
def edge_value(a: vec2, b: vec2, x: float64, y: float64) -> float64:
    """Twice the area of the triangle of an edge and a place, counter-clockwise."""
    ax = float64(a[0])
    ay = float64(a[1])
    return (float64(b[0]) - ax) * (y - ay) - (float64(b[1]) - ay) * (x - ax)


@func
def weights_at(a: vec2, b: vec2, c: vec2, x: float64, y: float64) -> vec3d:
    """The shares of the three corners at a place; all -1 in a triangle without area."""
    area = edge_value(a, b, float64(c[0]), float64(c[1]))
    result = vec3d(float64(-1.0), float64(-1.0), float64(-1.0))
    if abs(area) > float64(0.0):
        result = vec3d(edge_value(b, c, x, y) / area, edge_value(c, a, x, y) / area, edge_value(a, b, x, y) / area)
    return result


@kernel
def claim_texels_kernel(uvs: array(dtype=vec2), size: int, owners: array(dtype=int32)):
    """Give the texels whose centres lie in a triangle to it. The atomic leaves the smallest number, in any order."""
    i = tid()
    a = uvs[3 * i]
    b = uvs[3 * i + 1]
    c = uvs[3 * i + 2]
    if isfinite(a) and isfinite(b) and isfinite(c):
        scale = float(size)
        low = min(min(a[0], b[0]), c[0])
        high = max(max(a[0], b[0]), c[0])
        floor_v = min(min(a[1], b[1]), c[1])
        top_v = max(max(a[1], b[1]), c[1])
        first = int(max(floor(min(low, 1.0) * scale - 1.0), 0.0))
        last = int(min(floor(max(high, 0.0) * scale), scale - 1.0))
        top = int(max(floor((1.0 - max(top_v, 0.0)) * scale - 1.0), 0.0))
        bottom = int(min(floor((1.0 - min(floor_v, 1.0)) * scale), scale - 1.0))
        for row in range(top, bottom + 1):
            y = float64(1.0) - (float64(row) + float64(0.5)) / float64(size)
            for column in range(first, last + 1):
                x = (float64(column) + float64(0.5)) / float64(size)
                w = weights_at(a, b, c, x, y)
                if w[0] >= float64(OUTSIDE) and w[1] >= float64(OUTSIDE) and w[2] >= float64(OUTSIDE):
                    atomic_min(owners, row * size + column, i)


@kernel
def mark_owned_kernel(owners: array(dtype=int32), mask: array(dtype=uint8)):
    """1 where a texel belongs to a triangle."""
    i = tid()
    owned = int(0)
    if owners[i] != NOBODY:
        owned = 1
    mask[i] = uint8(owned)


@kernel
def place_texels_kernel(
    texels: array(dtype=int32),
    size: int,
    owners: array(dtype=int32),
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    uvs: array(dtype=vec2),
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
):
    """Where each texel lies on the surface, and the unit normal of its triangle; 0 of one without area."""
    i = tid()
    texel = texels[i]
    t = owners[texel]
    x = (float64(texel % size) + float64(0.5)) / float64(size)
    y = float64(1.0) - (float64(texel // size) + float64(0.5)) / float64(size)
    w = weights_at(uvs[3 * t], uvs[3 * t + 1], uvs[3 * t + 2], x, y)
    a = widen(vertices[triangles[t][0]])
    b = widen(vertices[triangles[t][1]])
    c = widen(vertices[triangles[t][2]])
    points[i] = narrow(a * w[0] + b * w[1] + c * w[2])
    n = cross(b - a, c - a)
    size_of = length(n)
    normal = vec3(0.0, 0.0, 0.0)
    if size_of > float64(0.0):
        normal = narrow(n / size_of)
    normals[i] = normal


@kernel
def mark_steps_kernel(depth: array(dtype=float32), width: int, height: int, marks: array(dtype=uint8)):
    """1 where the depth steps to a neighbour's."""
    i = tid()
    u = i % width
    v = i // width
    d = depth[i]
    mark = int(0)
    for row in range(max(v - 1, 0), min(v + 1, height - 1) + 1):
        for column in range(max(u - 1, 0), min(u + 1, width - 1) + 1):
            other = depth[row * width + column]
            if abs(other - d) > STEP * min(d, other):
                mark = int(1)
    marks[i] = uint8(mark)


@kernel
def drop_beside_steps_kernel(
    points: array(dtype=vec3), image: int, pictures: PosedPictures, marks: array(dtype=uint8), seen: array(dtype=uint8)
):
    """Drop texels beside a step of the depth, where a small error of the pose shows something else."""
    i = tid()
    if seen[i] != uint8(0):
        place = project_vertex(points[i], image, pictures)
        size = pictures.sizes[image]
        at = nearest_pixel(place[0], place[1], image, pictures) - size[2]
        u = at % size[0]
        v = at // size[0]
        found = int(1)
        for row in range(max(v - BESIDE, 0), min(v + BESIDE, size[1] - 1) + 1):
            for column in range(max(u - BESIDE, 0), min(u + BESIDE, size[0] - 1) + 1):
                if marks[row * size[0] + column] != uint8(0):
                    found = 0
        seen[i] = uint8(found)


@kernel
def blend_picture_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    image: int,
    pictures: PosedPictures,
    seen: array(dtype=uint8),
    sums: array(dtype=vec4d),
):
    """Add a picture's colour, and its weight, to each texel that it shows from before."""
    i = tid()
    if seen[i] != uint8(0):
        p = points[i]
        eye = camera_place(image, pictures)
        way = eye - widen(p)
        distance = length(way)
        cosine = dot(way, widen(normals[i])) / distance
        if cosine > float64(STEEPEST):
            place = project_vertex(p, image, pictures)
            size = pictures.sizes[image]
            reach = float64(FEATHER) * float64(min(size[0], size[1]))
            border = min(place[0] + float64(0.5), float64(size[0]) - float64(0.5) - place[0])
            border = min(border, min(place[1] + float64(0.5), float64(size[1]) - float64(0.5) - place[1]))
            detail = cosine / place[2]
            w = detail * detail * detail * detail * min(max(border / reach, float64(1.0e-6)), float64(1.0))
            color = color_at(place[0], place[1], image, pictures)
            sums[i] = sums[i] + vec4d(w * color[0], w * color[1], w * color[2], w)


@kernel
def write_texels_kernel(
    texels: array(dtype=int32),
    size: int,
    owners: array(dtype=int32),
    triangles: array(dtype=vec3i),
    uvs: array(dtype=vec2),
    colors: array(dtype=vec3),
    sums: array(dtype=vec4d),
    picture: array(dtype=vec3),
    filled: array(dtype=uint8),
):
    """The colours of texels, 0..1; of those that no picture shows that of the vertices, where those have any."""
    i = tid()
    texel = texels[i]
    s = sums[i]
    color = vec3(0.0, 0.0, 0.0)
    if s[3] > float64(0.0):
        scale = float64(255.0) * s[3]
        color = vec3(float(s[0] / scale), float(s[1] / scale), float(s[2] / scale))
    else:
        if colors.shape[0] > 0:
            t = owners[texel]
            x = (float64(texel % size) + float64(0.5)) / float64(size)
            y = float64(1.0) - (float64(texel // size) + float64(0.5)) / float64(size)
            w = weights_at(uvs[3 * t], uvs[3 * t + 1], uvs[3 * t + 2], x, y)
            a = widen(colors[triangles[t][0]])
            b = widen(colors[triangles[t][1]])
            c = widen(colors[triangles[t][2]])
            color = narrow(a * w[0] + b * w[1] + c * w[2])
    picture[texel] = color
    filled[texel] = uint8(1)


@kernel
def grow_texels_kernel(
    size: int,
    picture: array(dtype=vec3),
    filled: array(dtype=uint8),
    grown: array(dtype=vec3),
    grown_filled: array(dtype=uint8),
):
    """Texels, and beside them a ring of means over the filled ones among eight neighbours."""
    i = tid()
    column = i % size
    row = i // size
    color = picture[i]
    mark = int(filled[i])
    if mark == 0:
        total = vec3(0.0, 0.0, 0.0)
        count = float(0.0)
        for y in range(max(row - 1, 0), min(row + 1, size - 1) + 1):
            for x in range(max(column - 1, 0), min(column + 1, size - 1) + 1):
                if filled[y * size + x] != uint8(0):
                    total += picture[y * size + x]
                    count += 1.0
        if count > 0.0:
            color = total / count
            mark = int(1)
    grown[i] = color
    grown_filled[i] = uint8(mark)


@kernel
def round_texels_kernel(picture: array(dtype=vec3), pixels: array(dtype=uint8, ndim=2)):
    """8-bit colours."""
    i = tid()
    color = picture[i]
    n = int(3)
    for channel in range(n):
        value = min(max(color[channel], 0.0), 1.0)
        pixels[i, channel] = uint8(int(floor(value * 255.0 + 0.5)))


class SurfaceTexels:
    """The texels of a square texture that belong to triangles.

    Args:
        vertices, triangles, uvs: Of the mesh, device arrays of vec3, vec3i and vec2 [3 t].
        size: Texels a side.

    Attributes:
        owners: The triangle of each texel, int32 [size^2], NOBODY for none.
        texels: Those that have one, int32 [n], ascending.
        points, normals: Where they lie on the surface, vec3 [n].
    """

    def __init__(self, vertices, triangles, uvs, size):
        device = vertices.device
        self.triangles, self.uvs, self.size = triangles, uvs, size
        self.owners, mask = full(size * size, NOBODY, int32, device), empty(size * size, uint8, device)
        launch(claim_texels_kernel, triangles.size, [uvs, size, self.owners])
        launch(mark_owned_kernel, mask.size, [self.owners, mask])
        self.texels = positions_of(mask)
        self.points, self.normals = (empty(self.texels.size, vec3, device) for _ in range(2))
        given = [self.texels, size, self.owners, vertices, triangles, uvs, self.points, self.normals]
        launch(place_texels_kernel, self.texels.size, given)

    def blend(self, pictures, trees):
        """Weighted sums of colours, 0..255, and of weights, over the pictures that show each texel: vec4d [n]."""
        sums = zeros(self.texels.size, vec4d, self.points.device)
        for image in range(pictures.count):
            seen = see_in_frame(self.points, image, pictures, float("inf"))
            drop_hidden(self.points, image, pictures, trees, seen)
            depth = render_depth(image, pictures, trees)
            marks, (width, height, _) = empty(depth.size, uint8, depth.device), pictures.layout[image].tolist()
            launch(mark_steps_kernel, depth.size, [depth, width, height, marks])
            launch(drop_beside_steps_kernel, self.texels.size, [self.points, image, pictures, marks, seen])
            given = [self.points, self.normals, image, pictures, seen, sums]
            launch(blend_picture_kernel, self.texels.size, given)
        return sums

    def write(self, sums, colors, gutter):
        """The texture, uint8 [size^2, 3].

        Args:
            sums: As of `blend`.
            colors: Of the vertices, for texels that no picture shows: vec3 [m] or [0].
            gutter: Rings about what is filled.
        """
        device, count = self.points.device, self.size * self.size
        picture, filled = zeros(count, vec3, device), zeros(count, uint8, device)
        given = [self.texels, self.size, self.owners, self.triangles, self.uvs, colors, sums, picture, filled]
        launch(write_texels_kernel, self.texels.size, given)
        for _ in range(gutter):
            grown, marks = empty(count, vec3, device), empty(count, uint8, device)
            launch(grow_texels_kernel, count, [self.size, picture, filled, grown, marks])
            picture, filled = grown, marks
        pixels = empty((count, 3), uint8, device)
        launch(round_texels_kernel, count, [picture, pixels])
        return pixels
