"""Seam leveling: a color shift per vertex and image (Waechter, Moehrle and Goesele 2014, eq. 3).

Minimizes sum over ends of seam edges (d + g_a - g_b)^2 + (1 / lambda) sum over chart edges (g_v - g_w)^2 with a weak
pull to zero. Differences d are weighted means of up to 32 samples along the edge, per edge instead of per vertex.
Conjugate gradients with diagonal preconditioner in float64, fixed-order sums.
"""

from ..algebra.transform import widen
from ..array_types import Indices, Points, Positions, Triangles
from ..arrays.conjugate_gradients import ConjugateGradients, Gradients, weigh_by_diagonal_kernel
from ..arrays.unique import UniqueKeys
from ..lang import (
    array,
    ceil,
    float64,
    func,
    int32,
    int64,
    kernel,
    launch,
    reduce,
    reduction,
    sqrt,
    struct,
    tid,
    vec2d,
    vec3,
    vec3d,
    vec3i,
    vector,
)
from ..memory import download, empty, zeros
from ..meshes.mesh_edges import corner_at
from ..meshes.mesh_topology import corner_vertex, next_corner
from .exposures import Exposures, exposed
from .stacked_images import StackedImages, color_at, project_vertex

MAX_EDGE_SAMPLES = 32  # maximum samples per edge: one per pixel
EDGE_STIFFNESS = 5.0  # half of 1 / lambda, lambda 0.1 as in the paper: an edge within a chart belongs to two triangles
ZERO_SHIFT_WEIGHT = 1.0e-5  # weight of zero shift,
PULL_LEVEL = 0.1  # and for exposure-corrected images: remaining differences come from poses and stay within ten edges
MAX_RESIDUAL_RATIO = 1.0e-12  # of the initial squared residual
MAX_ITERATIONS = 3000

step_sums = vector(3, float64)  # sample count, sums of steps and of their squares


@struct
class Seams:
    """Seams between images (merged vertices; `twins`, `views` or -1). `nodes`: unknown per corner; `starts`, `corners`
    per unknown; `begins`, `ends`: color difference at the edge ends, 0..255.
    """

    triangles: array(dtype=vec3i)
    twins: array(dtype=int32)
    views: array(dtype=int32)
    nodes: array(dtype=int32)
    starts: array(dtype=int32)
    corners: array(dtype=int32)
    begins: array(dtype=vec3d)
    ends: array(dtype=vec3d)

    def __init__(
        self, triangles: Triangles, twins: Indices, views: Indices, image_count: int, vertex_count: int
    ) -> None:
        device, corners = triangles.device, 3 * triangles.size
        self.triangles, self.twins, self.views = triangles, twins, views
        keys, bits = empty(corners, int64, device), max(1, image_count.bit_length())
        launch(list_node_keys_kernel, corners, [triangles, views, bits, keys])
        unique = UniqueKeys(keys, bits + max(1, vertex_count.bit_length()))  # sync
        self.count, self.starts, self.corners = unique.count, unique.starts, unique.order
        self.nodes = empty(corners, int32, device)
        launch(name_nodes_kernel, self.count, [self.starts, self.corners, self.nodes])
        self.begins, self.ends = zeros(corners, vec3d, device), zeros(corners, vec3d, device)


@kernel
def list_node_keys_kernel(
    triangles: array(dtype=vec3i), views: array(dtype=int32), bits: int, keys: array(dtype=int64)
):
    """Vertex of each corner above its image. 0 for none."""
    i = tid()
    keys[i] = (int64(corner_vertex(triangles, i)) << int64(bits)) | int64(views[i // 3] + 1)


@kernel
def name_nodes_kernel(starts: array(dtype=int32), corners: array(dtype=int32), nodes: array(dtype=int32)):
    i = tid()
    for j in range(starts[i], starts[i + 1]):
        nodes[corners[j]] = i


@func
def is_seam(h: int, seams: Seams) -> int:
    """1 if the triangles of a half-edge use different images."""
    flag = 0
    twin = seams.twins[h]
    if twin >= 0:
        here = seams.views[h // 3]
        there = seams.views[twin // 3]
        if here >= 0 and there >= 0 and here != there:
            flag = 1
    return flag


@func
def image_color(p: vec3d, image: int, stack: StackedImages, exposures: Exposures) -> vec3d:
    """Exposure-corrected color of an image, 0..255, with replicated border."""
    projected = project_vertex(vec3(float(p[0]), float(p[1]), float(p[2])), image, stack)
    size = stack.sizes[image]
    u = min(max(projected[0], 0.0), float64(size[0] - 1))
    v = min(max(projected[1], 0.0), float64(size[1] - 1))
    return exposed(color_at(u, v, image, stack), u, v, image, stack, exposures)


@func
def samples_of(a: vec3, b: vec3, image: int, stack: StackedImages) -> int:
    p = project_vertex(a, image, stack)
    q = project_vertex(b, image, stack)
    x = q[0] - p[0]
    y = q[1] - p[1]
    return int(min(max(ceil(sqrt(x * x + y * y)), 2.0), float64(MAX_EDGE_SAMPLES)))


@kernel
def compare_sides_kernel(vertices: array(dtype=vec3), seams: Seams, stack: StackedImages, exposures: Exposures):
    """Color difference of both sides at the ends of each seam edge."""
    i = tid()
    at_begin = vec3d(0.0, 0.0, 0.0)
    at_end = vec3d(0.0, 0.0, 0.0)
    if is_seam(i, seams) == 1:
        here = seams.views[i // 3]
        there = seams.views[seams.twins[i] // 3]
        p = vertices[corner_vertex(seams.triangles, i)]
        q = vertices[corner_vertex(seams.triangles, next_corner(i))]
        count = samples_of(p, q, min(here, there), stack)
        total = float64(0.0)
        for k in range(count):
            fraction = (float64(k) + 0.5) / float64(count)
            point = widen(p) * (1.0 - fraction) + widen(q) * fraction
            step = image_color(point, here, stack, exposures) - image_color(point, there, stack, exposures)
            at_begin += step * (1.0 - fraction)
            at_end += step * fraction
            total += fraction
        at_begin = at_begin / total
        at_end = at_end / total
    seams.begins[i] = at_begin
    seams.ends[i] = at_end


@func
def node_beyond(h: int, v: int, seams: Seams) -> int:
    """Unknown at a half-edge's vertex, on the other side."""
    return seams.nodes[corner_at(seams.triangles, seams.twins[h], v)]


@kernel
def begin_levels_kernel(seams: Seams, pull: float64, weights: array(dtype=float64), state: Gradients):
    i = tid()
    weight = pull
    right = vec3d(0.0, 0.0, 0.0)
    for j in range(seams.starts[i], seams.starts[i + 1]):
        h = seams.corners[j]
        before = next_corner(next_corner(h))
        if seams.views[h // 3] >= 0:
            weight += 2.0 * float64(EDGE_STIFFNESS)
            if is_seam(h, seams) == 1:
                weight += 1.0
                right -= seams.begins[h]
            if is_seam(before, seams) == 1:
                weight += 1.0
                right -= seams.ends[before]
    weights[i] = weight
    state.residual[i] = right


@kernel
def map_levels_kernel(seams: Seams, weights: array(dtype=float64), state: Gradients):
    i = tid()
    total = weights[i] * state.search[i]
    for j in range(seams.starts[i], seams.starts[i + 1]):
        h = seams.corners[j]
        after = next_corner(h)
        before = next_corner(after)
        if seams.views[h // 3] >= 0:
            total -= float64(EDGE_STIFFNESS) * (state.search[seams.nodes[after]] + state.search[seams.nodes[before]])
            v = corner_vertex(seams.triangles, h)
            if is_seam(h, seams) == 1:
                total -= state.search[node_beyond(h, v, seams)]
            if is_seam(before, seams) == 1:
                total -= state.search[node_beyond(before, v, seams)]
    state.image[i] = total


@reduction
def sum_steps(
    vertices: array(dtype=vec3), seams: Seams, stack: StackedImages, exposures: Exposures, shifts: array(dtype=vec3d)
) -> step_sums:
    """Statistics of shifted steps across seam edges, mean of three channels: count, sum, sum of squares."""
    i = tid()
    sums = step_sums(0.0)
    seam = is_seam(i, seams)
    if seams.twins[i] > i and seam == 1:
        here = seams.views[i // 3]
        there = seams.views[seams.twins[i] // 3]
        a = corner_vertex(seams.triangles, i)
        b = corner_vertex(seams.triangles, next_corner(i))
        at_a = shifts[seams.nodes[i]] - shifts[node_beyond(i, a, seams)]
        at_b = shifts[seams.nodes[next_corner(i)]] - shifts[node_beyond(i, b, seams)]
        count = samples_of(vertices[a], vertices[b], min(here, there), stack)
        for k in range(count):
            fraction = (float64(k) + 0.5) / float64(count)
            point = widen(vertices[a]) * (1.0 - fraction) + widen(vertices[b]) * fraction
            step = image_color(point, here, stack, exposures) - image_color(point, there, stack, exposures)
            step += at_a * (1.0 - fraction) + at_b * fraction
            size = (abs(step[0]) + abs(step[1]) + abs(step[2])) / 3.0
            sums += step_sums(1.0, size, size * size)
    return sums


class SeamLevels:
    """Color shifts of a mesh: `shifts` vec3d (n), 0..255, zero until `solve`; `iterations` of the solve."""

    def __init__(self, vertices: Points, seams: Seams, stack: StackedImages, exposures: Exposures) -> None:
        self.vertices, self.seams = vertices, seams
        self.shifts: Positions = zeros(seams.count, vec3d, vertices.device)
        self.arguments = [vertices, seams, stack, exposures, self.shifts]  # of kernels that sample the images
        self.iterations = 0
        launch(compare_sides_kernel, 3 * seams.triangles.size, [vertices, seams, stack, exposures])

    def solve(self, *, level: bool = False) -> None:
        """Solve for the shifts; `level` if images were exposure-corrected. One sync."""
        count, device = self.seams.count, self.vertices.device
        state = Gradients(self.shifts, MAX_RESIDUAL_RATIO, MAX_ITERATIONS, zeros(1, vec2d, device))
        weights = empty(count, float64, device)

        def apply() -> None:
            launch(map_levels_kernel, count, [self.seams, weights, state])

        def weigh() -> None:
            launch(weigh_by_diagonal_kernel, count, [weights, state])

        launch(begin_levels_kernel, count, [self.seams, PULL_LEVEL if level else ZERO_SHIFT_WEIGHT, weights, state])
        ConjugateGradients(state, apply, weigh).solve()
        self.iterations = int(download(state.iterations)[0])  # sync

    def mean_step(self) -> float | None:
        """Mean step across seams, 0..255. None without seams. One sync."""
        sums = reduce(sum_steps, 3 * self.seams.triangles.size, self.arguments)
        count, total, _ = download(sums)[0].tolist()  # sync
        return total / count if count else None
