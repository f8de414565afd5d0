"""Colours made to agree where charts of different pictures meet: a shift for each vertex and picture.

Unknowns are pairs of a vertex and a picture that a triangle at it takes. Along each seam edge the colours of both
pictures are compared at up to 32 places; the difference at either end is their mean, by weights that fall to zero at
the other. The shifts g minimise

    sum over ends of seam edges (d + g_a - g_b)^2 + (1 / lambda) sum over edges within charts (g_v - g_w)^2

and a pull to zero that is far weaker, so that the mean stays, or holds shifts near their seams where pictures are at
one exposure already (Waechter, Moehrle and Goesele 2014, eq. 3; there the
differences are taken for each vertex, here for each edge, so that at a vertex of three pictures only colours along the
same edge are compared). The three channels are one system, solved by conjugate gradients with the diagonal as
preconditioner, in float64; sums run in fixed orders. A turn costs some 60 B a corner.
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
from .posed_pictures import PosedPictures, color_at, project_vertex

SAMPLES = 32  # of an edge at most: one a pixel
STIFFNESS = 5.0  # half of 1 / lambda, lambda 0.1 as in the paper: an edge within a chart counts for two triangles
PULL = 1.0e-5  # towards no shift,
PULL_LEVEL = 0.1  # and of pictures at one exposure: what still differs there, by poses, goes no farther than ten edges
SOLVED = 1.0e-12  # of the squared residual that the solve begins with
MOST_TURNS = 3000

step_sums = vector(3, float64)  # how many samples, the sum of steps, of their squares


@struct
class Seams:
    """Where the pictures of a mesh's triangles meet.

    Args:
        triangles: vec3i [t], by vertices that are one where they lie at one place.
        twins: The half-edge beyond each, int32 [3 t]; -1 for none.
        views: The picture of each triangle, int32 [t]; -1 for none.
        picture_count: How many there are.
        vertex_count: Of the mesh.

    Attributes:
        nodes: The unknown at each corner, int32 [3 t].
        starts, corners: The corners of each unknown, int32 [n + 1] and [3 t].
        begins, ends: The difference of colours at either end of each half-edge on a seam, this picture's less the
            other's, 0..255; vec3d [3 t].
        count: Unknowns n.
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
        self, triangles: Triangles, twins: Indices, views: Indices, picture_count: int, vertex_count: int
    ) -> None:
        """One sync."""
        device, corners = triangles.device, 3 * triangles.size
        self.triangles, self.twins, self.views = triangles, twins, views
        keys, bits = empty(corners, int64, device), max(1, picture_count.bit_length())
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
    """The vertex of each corner above its picture; 0 stands for none."""
    i = tid()
    keys[i] = (int64(corner_vertex(triangles, i)) << int64(bits)) | int64(views[i // 3] + 1)


@kernel
def name_nodes_kernel(starts: array(dtype=int32), corners: array(dtype=int32), nodes: array(dtype=int32)):
    """The unknown at each corner."""
    i = tid()
    for j in range(starts[i], starts[i + 1]):
        nodes[corners[j]] = i


@func
def is_seam(h: int, seams: Seams) -> int:
    """1 where the triangles at both sides of a half-edge take different pictures."""
    found = 0
    twin = seams.twins[h]
    if twin >= 0:
        here = seams.views[h // 3]
        there = seams.views[twin // 3]
        if here >= 0 and there >= 0 and here != there:
            found = 1
    return found


@func
def picture_color(p: vec3d, image: int, pictures: PosedPictures, exposures: Exposures) -> vec3d:
    """The colour of a place in a picture at the exposure of all, 0..255; beyond the border that of the last pixel."""
    place = project_vertex(vec3(float(p[0]), float(p[1]), float(p[2])), image, pictures)
    size = pictures.sizes[image]
    u = min(max(place[0], 0.0), float64(size[0] - 1))
    v = min(max(place[1], 0.0), float64(size[1] - 1))
    return exposed(color_at(u, v, image, pictures), u, v, image, pictures, exposures)


@func
def samples_of(a: vec3, b: vec3, image: int, pictures: PosedPictures) -> int:
    """How many places of an edge are looked at: one a pixel of a picture."""
    p = project_vertex(a, image, pictures)
    q = project_vertex(b, image, pictures)
    x = q[0] - p[0]
    y = q[1] - p[1]
    return int(min(max(ceil(sqrt(x * x + y * y)), 2.0), float64(SAMPLES)))


@kernel
def compare_sides_kernel(vertices: array(dtype=vec3), seams: Seams, pictures: PosedPictures, exposures: Exposures):
    """The difference of the colours at both sides, at either end of each seam edge."""
    i = tid()
    at_begin = vec3d(0.0, 0.0, 0.0)
    at_end = vec3d(0.0, 0.0, 0.0)
    if is_seam(i, seams) == 1:
        here = seams.views[i // 3]
        there = seams.views[seams.twins[i] // 3]
        p = vertices[corner_vertex(seams.triangles, i)]
        q = vertices[corner_vertex(seams.triangles, next_corner(i))]
        count = samples_of(p, q, min(here, there), pictures)
        total = float64(0.0)
        for k in range(count):
            share = (float64(k) + 0.5) / float64(count)
            place = widen(p) * (1.0 - share) + widen(q) * share
            step = picture_color(place, here, pictures, exposures) - picture_color(place, there, pictures, exposures)
            at_begin += step * (1.0 - share)
            at_end += step * share
            total += share
        at_begin = at_begin / total
        at_end = at_end / total
    seams.begins[i] = at_begin
    seams.ends[i] = at_end


@func
def node_beyond(h: int, v: int, seams: Seams) -> int:
    """The unknown at a vertex of a half-edge, on the other side of it."""
    return seams.nodes[corner_at(seams.triangles, seams.twins[h], v)]


@kernel
def begin_levels_kernel(seams: Seams, pull: float64, weights: array(dtype=float64), state: Gradients):
    """The diagonal of the matrix, and the right side, which is the residual of no shift."""
    i = tid()
    weight = pull
    right = vec3d(0.0, 0.0, 0.0)
    for j in range(seams.starts[i], seams.starts[i + 1]):
        h = seams.corners[j]
        before = next_corner(next_corner(h))
        if seams.views[h // 3] >= 0:
            weight += 2.0 * float64(STIFFNESS)
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
    """The product of the matrix and the search direction."""
    i = tid()
    total = weights[i] * state.search[i]
    for j in range(seams.starts[i], seams.starts[i + 1]):
        h = seams.corners[j]
        after = next_corner(h)
        before = next_corner(after)
        if seams.views[h // 3] >= 0:
            total -= float64(STIFFNESS) * (state.search[seams.nodes[after]] + state.search[seams.nodes[before]])
            v = corner_vertex(seams.triangles, h)
            if is_seam(h, seams) == 1:
                total -= state.search[node_beyond(h, v, seams)]
            if is_seam(before, seams) == 1:
                total -= state.search[node_beyond(before, v, seams)]
    state.image[i] = total


@reduction
def sum_steps(
    vertices: array(dtype=vec3), seams: Seams, pictures: PosedPictures, exposures: Exposures, shifts: array(dtype=vec3d)
) -> step_sums:
    """The steps across seam edges with shifts, in the mean of three channels: count, sum, sum of squares."""
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
        count = samples_of(vertices[a], vertices[b], min(here, there), pictures)
        for k in range(count):
            share = (float64(k) + 0.5) / float64(count)
            place = widen(vertices[a]) * (1.0 - share) + widen(vertices[b]) * share
            step = picture_color(place, here, pictures, exposures) - picture_color(place, there, pictures, exposures)
            step += at_a * (1.0 - share) + at_b * share
            size = (abs(step[0]) + abs(step[1]) + abs(step[2])) / 3.0
            sums += step_sums(1.0, size, size * size)
    return sums


class SeamLevels:
    """The shifts of one mesh's colours.

    Args:
        vertices: vec3 [m].
        seams: Seams.
        pictures: PosedPictures.
        exposures: Theirs.

    Attributes:
        shifts: vec3d [n], 0..255; zero until `solve`.
        turns: How many the solve took.
    """

    def __init__(self, vertices: Points, seams: Seams, pictures: PosedPictures, exposures: Exposures) -> None:
        self.vertices, self.seams, self.pictures, self.exposures = vertices, seams, pictures, exposures
        self.shifts: Positions = zeros(seams.count, vec3d, vertices.device)
        self.turns = 0
        launch(compare_sides_kernel, 3 * seams.triangles.size, [vertices, seams, pictures, exposures])

    def solve(self, *, level: bool = False) -> None:
        """Find the shifts, `level` where pictures were brought to one exposure; one sync."""
        count, device = self.seams.count, self.vertices.device
        state = Gradients(self.shifts, SOLVED, MOST_TURNS, zeros(1, vec2d, device))
        weights = empty(count, float64, device)

        def apply() -> None:
            launch(map_levels_kernel, count, [self.seams, weights, state])

        def weigh() -> None:
            launch(weigh_by_diagonal_kernel, count, [weights, state])

        launch(begin_levels_kernel, count, [self.seams, PULL_LEVEL if level else PULL, weights, state])
        ConjugateGradients(state, apply, weigh).solve()
        self.turns = int(download(state.turns)[0])  # sync

    def mean_step(self) -> float | None:
        """The mean step across seams with these shifts, 0..255, in float64; None where there are none. One sync."""
        given = [self.vertices, self.seams, self.pictures, self.exposures, self.shifts]
        count, total, _ = download(reduce(sum_steps, 3 * self.seams.triangles.size, given))[0].tolist()  # sync
        return total / count if count else None
