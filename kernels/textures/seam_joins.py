"""Texels beside seams changed so that both sides have the same colours as they are drawn: bilinear, all along.

The two sides of a seam lie on grids of their own, so the same colours at the same places do not draw the same: where a
picture changes within a texel they differ by what each grid leaves out. So each seam edge is looked at in two places a
texel, each the difference of four texels at either side by their bilinear weights, and texels change by x such that

    sum over places (step + difference of x)^2 + HOLD sum over texels x^2

is least (Iwanicki, "Lighting technology of The Last of Us", SIGGRAPH 2013, for light maps). Only texels that are drawn
at a seam are unknowns. Conjugate gradients, sums in fixed orders; some 200 B a place, 200 B a texel of these and turn.
"""

from ..array_types import Array1, Bytes
from ..arrays.conjugate_gradients import ConjugateGradients, Gradients, weigh_by_diagonal_kernel
from ..arrays.prefix_sum import exclusive_scan, find_owner
from ..arrays.quantiles import quantiles_of
from ..arrays.unique import UniqueKeys
from ..lang import (
    array,
    ceil,
    float64,
    floor,
    func,
    int32,
    int64,
    kernel,
    launch,
    length,
    reduce,
    reduction,
    struct,
    tid,
    uint8,
    vec2d,
    vec3d,
    vector,
)
from ..memory import download, empty, zeros
from ..meshes.mesh_edges import corner_at
from ..meshes.mesh_topology import corner_vertex, next_corner
from .atlas_colors import Atlas, texel_place
from .chart_texels import ChartTexels
from .seam_levels import Seams, is_seam, name_nodes_kernel

A_TEXEL = 2.0  # places looked at, of the longer side
MOST_PLACES = 1024  # of an edge
SIDES = 8  # texels that a place is drawn from: four at either side
HOLD = 0.01  # to no change: it leaves a hundredth of a step
SOLVED = 1.0e-8
MOST_TURNS = 300
MOST = 0.95  # of steps: what `drawn_steps` gives beside the mean

step_sums = vector(2, float64)  # how many places, the sum of steps


@struct
class SeamPlaces:
    """Where seams are looked at, and the texels that are drawn there.

    Args:
        texels: ChartTexels, whose seams have a twin each.
        seams: Seams.

    Attributes:
        firsts: The first place of each half-edge, int32 [3 t + 1]; seams count at their lower half-edge.
        keys: The texel, int64 [8 p]: four at one side, four at the other.
        weights: Theirs in the difference of both sides, float64 [8 p].
        starts, entries: The entries of each unknown, int32 [n + 1] and [8 p].
        nodes: The unknown of each entry, int32 [8 p].
        count, place_count: Unknowns n, and places p.
    """

    firsts: array(dtype=int32)
    keys: array(dtype=int64)
    weights: array(dtype=float64)
    starts: array(dtype=int32)
    entries: array(dtype=int32)
    nodes: array(dtype=int32)

    def __init__(self, texels: ChartTexels, seams: Seams) -> None:
        """Two syncs."""
        device, corners = texels.owners.device, seams.twins.size
        counts = empty(corners, int32, device)
        launch(count_places_kernel, corners, [texels.atlas, seams, counts])
        self.firsts, self.place_count = exclusive_scan(counts)  # sync
        entries = SIDES * self.place_count
        self.keys, self.weights = empty(entries, int64, device), empty(entries, float64, device)
        self.nodes, self.count = empty(entries, int32, device), 0
        self.starts, self.entries = zeros(1, int32, device), empty(0, int32, device)
        if entries:
            launch(place_samples_kernel, self.place_count, [texels.atlas, seams, self])
            unique = UniqueKeys(self.keys, max(1, (texels.size * texels.size - 1).bit_length()))  # sync
            self.count, self.starts, self.entries = unique.count, unique.starts, unique.order
            launch(name_nodes_kernel, self.count, [self.starts, self.entries, self.nodes])


@func
def side_places(h: int, other: int, atlas: Atlas, seams: Seams) -> tuple[vec3d, vec3d]:
    """The ends of an edge in texels as a half-edge of it has them, in the order of another."""
    v = corner_vertex(seams.triangles, other)
    begin = corner_at(seams.triangles, h, v)
    end = next_corner(h)
    if begin == end:
        end = h
    return (
        texel_place(atlas.uvs[begin], atlas.width, atlas.height),
        texel_place(atlas.uvs[end], atlas.width, atlas.height),
    )


@kernel
def count_places_kernel(atlas: Atlas, seams: Seams, counts: array(dtype=int32)):
    """How many places each half-edge is looked at; none but on seams, and there at the lower one of two."""
    i = tid()
    count = 0
    seam = is_seam(i, seams)
    if seams.twins[i] > i and seam == 1:
        a, b = side_places(i, i, atlas, seams)
        c, d = side_places(seams.twins[i], i, atlas, seams)
        longest = max(length(b - a), length(d - c))
        count = int(min(max(ceil(float64(A_TEXEL) * longest), 2.0), float64(MOST_PLACES)))
    counts[i] = count


@kernel
def place_samples_kernel(atlas: Atlas, seams: Seams, places: SeamPlaces):
    """The texels of a place at both sides, and their weights."""
    i = tid()
    h = find_owner(places.firsts, i)
    share = (float64(i - places.firsts[h]) + 0.5) / float64(places.firsts[h + 1] - places.firsts[h])
    for side in range(2):
        from_side = h
        sign = float64(1.0)
        if side == 1:
            from_side = seams.twins[h]
            sign = -1.0
        a, b = side_places(from_side, h, atlas, seams)
        x = min(max(a[0] * (1.0 - share) + b[0] * share - 0.5, 0.0), float64(atlas.width - 1))
        y = min(max(a[1] * (1.0 - share) + b[1] * share - 0.5, 0.0), float64(atlas.height - 1))
        column = min(int(floor(x)), atlas.width - 2)
        row = min(int(floor(y)), atlas.height - 2)
        s = x - float64(column)
        t = y - float64(row)
        for k in range(4):
            weight = sign
            if k % 2 == 0:
                weight = weight * (1.0 - s)
            else:
                weight = weight * s
            if k // 2 == 0:
                weight = weight * (1.0 - t)
            else:
                weight = weight * t
            at = 8 * i + 4 * side + k
            places.keys[at] = int64(row + k // 2) * int64(atlas.width) + int64(column + k % 2)
            places.weights[at] = weight


@kernel
def see_steps_kernel(places: SeamPlaces, colors: array(dtype=vec3d), steps: array(dtype=vec3d)):
    """The difference of both sides at each place."""
    i = tid()
    step = vec3d(0.0, 0.0, 0.0)
    for k in range(SIDES):
        step += colors[int(places.keys[8 * i + k])] * places.weights[8 * i + k]
    steps[i] = step


@kernel
def begin_joins_kernel(places: SeamPlaces, steps: array(dtype=vec3d), diagonal: array(dtype=float64), state: Gradients):
    """The diagonal of the matrix, and the right side."""
    i = tid()
    weight = float64(HOLD)
    right = vec3d(0.0, 0.0, 0.0)
    for j in range(places.starts[i], places.starts[i + 1]):
        entry = places.entries[j]
        w = places.weights[entry]
        weight += w * w
        right -= steps[entry // 8] * w
    diagonal[i] = weight
    state.residual[i] = right


@kernel
def turn_steps_kernel(places: SeamPlaces, state: Gradients, steps: array(dtype=vec3d)):
    """The difference of the search direction at each place."""
    i = tid()
    step = vec3d(0.0, 0.0, 0.0)
    for k in range(SIDES):
        step += state.search[places.nodes[8 * i + k]] * places.weights[8 * i + k]
    steps[i] = step


@kernel
def map_joins_kernel(places: SeamPlaces, steps: array(dtype=vec3d), state: Gradients):
    """The product of the matrix and the search direction."""
    i = tid()
    total = state.search[i] * float64(HOLD)
    for j in range(places.starts[i], places.starts[i + 1]):
        entry = places.entries[j]
        total += steps[entry // 8] * places.weights[entry]
    state.image[i] = total


@kernel
def change_joined_kernel(places: SeamPlaces, solution: array(dtype=vec3d), colors: array(dtype=vec3d)):
    """Change the texels that are drawn at seams."""
    i = tid()
    texel = int(places.keys[places.entries[places.starts[i]]])
    colors[texel] = colors[texel] + solution[i]


def join_seams(places: SeamPlaces, colors: Array1[vec3d]) -> None:
    """Change colours, 0..255, so that both sides of seams are drawn alike; no sync beside the solve."""
    device, count = colors.device, places.count
    if not count:
        return
    steps, diagonal = empty(places.place_count, vec3d, device), empty(count, float64, device)
    state = Gradients(zeros(count, vec3d, device), SOLVED, MOST_TURNS, zeros(1, vec2d, device))

    def apply() -> None:
        launch(turn_steps_kernel, places.place_count, [places, state, steps])
        launch(map_joins_kernel, count, [places, steps, state])

    def weigh() -> None:
        launch(weigh_by_diagonal_kernel, count, [diagonal, state])

    launch(see_steps_kernel, places.place_count, [places, colors, steps])
    launch(begin_joins_kernel, count, [places, steps, diagonal, state])
    ConjugateGradients(state, apply, weigh).solve()
    launch(change_joined_kernel, count, [places, state.solution, colors])


@kernel
def drawn_steps_kernel(places: SeamPlaces, picture: array(dtype=uint8), sizes: array(dtype=float64)):
    """The step at each place as the finished texture is drawn, 0..255, in the mean of three channels."""
    i = tid()
    total = float64(0.0)
    for channel in range(3):
        step = float64(0.0)
        for k in range(SIDES):
            texel = int(places.keys[8 * i + k])
            step += float64(picture[3 * texel + channel]) * places.weights[8 * i + k]
        total += abs(step)
    sizes[i] = total / 3.0


@reduction
def sum_steps(sizes: array(dtype=float64)) -> step_sums:
    """How many there are, and their sum."""
    i = tid()
    return step_sums(1.0, sizes[i])


def drawn_steps(places: SeamPlaces, picture: Bytes) -> tuple[float, float] | None:
    """The mean step of a finished texture across seams, and that which 95 % are below, 0..255; None without seams.

    Three channels in the mean, float64; a few syncs.
    """
    if not places.place_count:
        return None
    sizes = empty(places.place_count, float64, picture.device)
    launch(drawn_steps_kernel, places.place_count, [places, picture, sizes])
    count, total = download(reduce(sum_steps, places.place_count, [sizes]))[0].tolist()  # sync
    return total / count, quantiles_of(sizes, [MOST])[0]  # sync
