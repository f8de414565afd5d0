"""Texel corrections so that bilinear colors agree along seams (Iwanicki, "Lighting technology of The Last of Us",
SIGGRAPH 2013). Two samples per texel along seam edges; minimizes sum (step + difference of x)^2 + ZERO_WEIGHT sum x^2
over the texels drawn at seams, by conjugate gradients with fixed-order sums.
"""

from ..array_types import Array1, Bytes
from ..arrays.conjugate_gradients import ConjugateGradients, Gradients, weigh_by_diagonal_kernel
from ..arrays.prefix_sum import exclusive_scan, find_owner
from ..arrays.quantiles import quantiles_of
from ..arrays.unique import UniqueKeys
from ..lang import (
    array,
    ceil,
    compute,
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
from .atlas_colors import Atlas, texel_position
from .chart_texels import ChartTexels
from .seam_levels import Seams, is_seam, name_nodes_kernel

A_TEXEL = 2.0  # samples per texel along the longer side
MAX_SAMPLES = 1024  # per edge
TEXELS_PER_SAMPLE = 8  # texels of a sample: four per side
ZERO_WEIGHT = 0.01  # weight of no change: leaves 1 % of a step
MAX_RESIDUAL_RATIO = 1.0e-8
MAX_ITERATIONS = 300
HIGH_QUANTILE = 0.95  # quantile reported by `drawn_steps`

step_sums = vector(2, float64)  # sample count, sum of steps


@struct
class SeamSamples:
    """Seam samples: `firsts` per half-edge; `keys`, `weights` (8 p): four texels per side; `nodes`: unknowns."""

    firsts: array(dtype=int32)
    keys: array(dtype=int64)
    weights: array(dtype=float64)
    starts: array(dtype=int32)
    entries: array(dtype=int32)
    nodes: array(dtype=int32)

    def __init__(self, texels: ChartTexels, seams: Seams) -> None:
        device, corners = texels.owners.device, seams.twins.size
        counts = compute(count_samples_kernel, corners, [texels.atlas, seams], int32, device)
        self.firsts, self.sample_count = exclusive_scan(counts, largest=MAX_SAMPLES)  # sync
        entries = TEXELS_PER_SAMPLE * self.sample_count
        self.keys, self.weights = empty(entries, int64, device), empty(entries, float64, device)
        self.nodes, self.count = empty(entries, int32, device), 0
        self.starts, self.entries = zeros(1, int32, device), empty(0, int32, device)
        if entries:
            launch(compute_samples_kernel, self.sample_count, [texels.atlas, seams, self])
            unique = UniqueKeys(self.keys, max(1, (texels.size * texels.size - 1).bit_length()))  # sync
            self.count, self.starts, self.entries = unique.count, unique.starts, unique.order
            launch(name_nodes_kernel, self.count, [self.starts, self.entries, self.nodes])


@func
def side_positions(h: int, other: int, atlas: Atlas, seams: Seams) -> tuple[vec3d, vec3d]:
    """Texel coordinates of an edge's ends from a half-edge, in another's order."""
    v = corner_vertex(seams.triangles, other)
    begin = corner_at(seams.triangles, h, v)
    end = next_corner(h)
    if begin == end:
        end = h
    return (
        texel_position(atlas.uvs[begin], atlas.width, atlas.height),
        texel_position(atlas.uvs[end], atlas.width, atlas.height),
    )


@kernel
def count_samples_kernel(atlas: Atlas, seams: Seams, counts: array(dtype=int32)):
    """Samples of each half-edge. Only on seams, at the lower half-edge."""
    i = tid()
    count = 0
    seam = is_seam(i, seams)
    if seams.twins[i] > i and seam == 1:
        a, b = side_positions(i, i, atlas, seams)
        c, d = side_positions(seams.twins[i], i, atlas, seams)
        longest = max(length(b - a), length(d - c))
        count = int(min(max(ceil(float64(A_TEXEL) * longest), 2.0), float64(MAX_SAMPLES)))
    counts[i] = count


@kernel
def compute_samples_kernel(atlas: Atlas, seams: Seams, samples: SeamSamples):
    i = tid()
    h = find_owner(samples.firsts, i)
    fraction = (float64(i - samples.firsts[h]) + 0.5) / float64(samples.firsts[h + 1] - samples.firsts[h])
    for side in range(2):
        from_side = h
        sign = float64(1.0)
        if side == 1:
            from_side = seams.twins[h]
            sign = -1.0
        a, b = side_positions(from_side, h, atlas, seams)
        x = min(max(a[0] * (1.0 - fraction) + b[0] * fraction - 0.5, 0.0), float64(atlas.width - 1))
        y = min(max(a[1] * (1.0 - fraction) + b[1] * fraction - 0.5, 0.0), float64(atlas.height - 1))
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
            samples.keys[at] = int64(row + k // 2) * int64(atlas.width) + int64(column + k % 2)
            samples.weights[at] = weight


@kernel
def measure_steps_kernel(samples: SeamSamples, colors: array(dtype=vec3d), steps: array(dtype=vec3d)):
    i = tid()
    step = vec3d(0.0, 0.0, 0.0)
    for k in range(TEXELS_PER_SAMPLE):
        step += colors[int(samples.keys[8 * i + k])] * samples.weights[8 * i + k]
    steps[i] = step


@kernel
def begin_joins_kernel(
    samples: SeamSamples, steps: array(dtype=vec3d), diagonal: array(dtype=float64), state: Gradients
):
    i = tid()
    weight = float64(ZERO_WEIGHT)
    right = vec3d(0.0, 0.0, 0.0)
    for j in range(samples.starts[i], samples.starts[i + 1]):
        entry = samples.entries[j]
        w = samples.weights[entry]
        weight += w * w
        right -= steps[entry // 8] * w
    diagonal[i] = weight
    state.residual[i] = right


@kernel
def search_steps_kernel(samples: SeamSamples, state: Gradients, steps: array(dtype=vec3d)):
    i = tid()
    step = vec3d(0.0, 0.0, 0.0)
    for k in range(TEXELS_PER_SAMPLE):
        step += state.search[samples.nodes[8 * i + k]] * samples.weights[8 * i + k]
    steps[i] = step


@kernel
def map_joins_kernel(samples: SeamSamples, steps: array(dtype=vec3d), state: Gradients):
    i = tid()
    total = state.search[i] * float64(ZERO_WEIGHT)
    for j in range(samples.starts[i], samples.starts[i + 1]):
        entry = samples.entries[j]
        total += steps[entry // 8] * samples.weights[entry]
    state.image[i] = total


@kernel
def change_joined_kernel(samples: SeamSamples, solution: array(dtype=vec3d), colors: array(dtype=vec3d)):
    i = tid()
    texel = int(samples.keys[samples.entries[samples.starts[i]]])
    colors[texel] = colors[texel] + solution[i]


def join_seams(samples: SeamSamples, colors: Array1[vec3d]) -> None:
    """Correct colors, 0..255, in place. No sync besides the solve."""
    device, count = colors.device, samples.count
    if not count:
        return
    steps, diagonal = empty(samples.sample_count, vec3d, device), empty(count, float64, device)
    state = Gradients(zeros(count, vec3d, device), MAX_RESIDUAL_RATIO, MAX_ITERATIONS, zeros(1, vec2d, device))

    def apply() -> None:
        launch(search_steps_kernel, samples.sample_count, [samples, state, steps])
        launch(map_joins_kernel, count, [samples, steps, state])

    def weigh() -> None:
        launch(weigh_by_diagonal_kernel, count, [diagonal, state])

    launch(measure_steps_kernel, samples.sample_count, [samples, colors, steps])
    launch(begin_joins_kernel, count, [samples, steps, diagonal, state])
    ConjugateGradients(state, apply, weigh).solve()
    launch(change_joined_kernel, count, [samples, state.solution, colors])


@kernel
def drawn_steps_kernel(samples: SeamSamples, image: array(dtype=uint8), sizes: array(dtype=float64)):
    """Step at each sample of the finished texture, 0..255, mean of three channels."""
    i = tid()
    total = float64(0.0)
    for channel in range(3):
        step = float64(0.0)
        for k in range(TEXELS_PER_SAMPLE):
            texel = int(samples.keys[8 * i + k])
            step += float64(image[3 * texel + channel]) * samples.weights[8 * i + k]
        total += abs(step)
    sizes[i] = total / 3.0


@reduction
def sum_steps(sizes: array(dtype=float64)) -> step_sums:
    i = tid()
    return step_sums(1.0, sizes[i])


def drawn_steps(samples: SeamSamples, image: Bytes) -> tuple[float, float] | None:
    """(mean, 95th percentile) of the finished texture's steps across seams, 0..255, or None. A few syncs."""
    if not samples.sample_count:
        return None
    sizes = compute(drawn_steps_kernel, samples.sample_count, [samples, image], float64, image.device)
    count, total = download(reduce(sum_steps, samples.sample_count, [sizes]))[0].tolist()  # sync
    return total / count, quantiles_of(sizes, [HIGH_QUANTILE])[0]  # sync
