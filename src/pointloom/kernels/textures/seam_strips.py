"""Seam blending in strips of 20 texels (Waechter, Moehrle and Goesele 2014, section 4.2): both sides take their mean at
the seam, adjusted to the mean of all images at shared vertices. The change fades harmonically to zero (Laplace
equation; Perez et al. 2003), by conjugate gradients.
"""

from ..algebra.transform import widen
from ..array_types import Indices, Positions
from ..arrays.conjugate_gradients import ConjugateGradients, Gradients, weigh_by_diagonal_kernel
from ..arrays.select import number_rows_kernel, positions_of
from ..lang import array, dot, float64, func, int32, kernel, launch, length, tid, uint8, vec2d, vec3, vec3d
from ..memory import empty, zeros
from ..meshes.mesh_topology import corner_vertex, next_corner
from .atlas_colors import NO_TRIANGLE, texel_corners
from .chart_texels import EXTRAPOLATED_RINGS, UNREACHED_STEPS, ChartTexels, fractions_at, point_at, side_of_corner
from .exposures import Exposures
from .seam_levels import SeamLevels, Seams, image_color, is_seam, node_beyond
from .stacked_images import StackedImages

ON_SEAM = 1.5  # [texels] maximum distance of a chart's texel on a seam
MAX_RING_DISTANCE = 4.0  # [texels] the same for ring texels
STRIP_TEXELS = 20  # texels over which a change fades, as in the paper
MAX_RESIDUAL_RATIO = 1.0e-8
MAX_ITERATIONS = 400


@func
def on_segment(a: vec3d, b: vec3d, x: float64, y: float64) -> float64:
    """Parameter of the nearest point on segment a b."""
    way = b - a
    squared = dot(way, way)
    fraction = float64(0.0)
    if squared > 0.0:
        fraction = min(max(dot(vec3d(x, y, 0.0) - a, way) / squared, 0.0), 1.0)
    return fraction


@func
def nearest_seam(texels: ChartTexels, seams: Seams, owner: int, x: float64, y: float64) -> vec3d:
    """Nearest seam half-edge of a triangle, its distance, and the parameter."""
    a, b, c = texel_corners(texels.atlas, owner)
    nearest = vec3d(-1.0, 1.0e9, 0.0)
    for side in range(3):
        if is_seam(3 * owner + side, seams) == 1:
            begin = side_of_corner(a, b, c, side)
            end = side_of_corner(a, b, c, side + 1)
            fraction = on_segment(begin, end, x, y)
            distance = length(begin * (1.0 - fraction) + end * fraction - vec3d(x, y, 0.0))
            if distance < nearest[1]:
                nearest = vec3d(float64(3 * owner + side), distance, fraction)
    return nearest


@kernel
def mean_at_vertices_kernel(
    vertices: array(dtype=vec3),
    seams: Seams,
    stack: StackedImages,
    exposures: Exposures,
    shifts: array(dtype=vec3d),
    means: array(dtype=vec3d),
):
    """Mean color of a vertex over its images, with shifts. One thread per unknown. The first of a vertex writes."""
    i = tid()
    v = corner_vertex(seams.triangles, seams.corners[seams.starts[i]])
    first = 1
    if i > 0:
        if corner_vertex(seams.triangles, seams.corners[seams.starts[i - 1]]) == v:
            first = 0
    if first == 1:
        total = vec3d(0.0, 0.0, 0.0)
        count = 0
        k = i
        more = 1
        while more == 1:
            corner = seams.corners[seams.starts[k]]
            view = seams.views[corner // 3]
            if view >= 0:
                total += image_color(widen(vertices[v]), view, stack, exposures) + shifts[k]
                count += 1
            k += 1
            more = 0
            if k < seams.starts.shape[0] - 1:
                if corner_vertex(seams.triangles, seams.corners[seams.starts[k]]) == v:
                    more = 1
        means[v] = total / float64(max(count, 1))


@func
def both_sides(
    h: int,
    point: vec3d,
    fraction: float64,
    seams: Seams,
    stack: StackedImages,
    exposures: Exposures,
    shifts: array(dtype=vec3d),
) -> vec3d:
    """Mean color of both sides of a seam edge, with interpolated shifts."""
    t = seams.triangles[h // 3]
    total = image_color(point, seams.views[h // 3], stack, exposures)
    total += image_color(point, seams.views[seams.twins[h] // 3], stack, exposures)
    begin = shifts[seams.nodes[h]] + shifts[node_beyond(h, t[h % 3], seams)]
    end = shifts[seams.nodes[next_corner(h)]] + shifts[node_beyond(h, t[next_corner(h) % 3], seams)]
    return 0.5 * (total + begin * (1.0 - fraction) + end * fraction)


@func
def seam_color(
    h: int,
    point: vec3d,
    fraction: float64,
    vertices: array(dtype=vec3),
    seams: Seams,
    stack: StackedImages,
    exposures: Exposures,
    shifts: array(dtype=vec3d),
    means: array(dtype=vec3d),
) -> vec3d:
    """Target color of a seam edge: the mean of both sides, adjusted to the vertex means at both ends."""
    t = seams.triangles[h // 3]
    a = t[h % 3]
    b = t[next_corner(h) % 3]
    begin = means[a] - both_sides(h, widen(vertices[a]), float64(0.0), seams, stack, exposures, shifts)
    end = means[b] - both_sides(h, widen(vertices[b]), float64(1.0), seams, stack, exposures, shifts)
    color = both_sides(h, point, fraction, seams, stack, exposures, shifts)
    return color + begin * (1.0 - fraction) + end * fraction


@kernel
def aim_at_seams_kernel(
    texels: ChartTexels,
    vertices: array(dtype=vec3),
    seams: Seams,
    stack: StackedImages,
    exposures: Exposures,
    shifts: array(dtype=vec3d),
    means: array(dtype=vec3d),
    changes: array(dtype=vec3d),
):
    """Change of texels on a seam to the target color; searches the texel's triangle and those within two texels."""
    i = tid()
    changes[i] = vec3d(0.0, 0.0, 0.0)
    if texels.owners[i] == NO_TRIANGLE:
        return
    if seams.views[texels.owners[i]] < 0:
        return
    size = texels.atlas.width
    x = float64(i % size) + 0.5
    y = float64(i // size) + 0.5
    max_distance = float64(ON_SEAM)
    if texels.rings[i] > 0:
        max_distance = float64(MAX_RING_DISTANCE)
    nearest = vec3d(-1.0, max_distance, 0.0)
    last = -1
    for row in range(max(i // size - EXTRAPOLATED_RINGS, 0), min(i // size + EXTRAPOLATED_RINGS, size - 1) + 1):
        for column in range(max(i % size - EXTRAPOLATED_RINGS, 0), min(i % size + EXTRAPOLATED_RINGS, size - 1) + 1):
            owner = texels.owners[row * size + column]
            if owner != NO_TRIANGLE and owner != last:
                last = owner
                seam = nearest_seam(texels, seams, owner, x, y)
                if seam[0] >= 0.0 and seam[1] < nearest[1]:
                    nearest = seam
    if nearest[0] >= 0.0:
        h = int(nearest[0])
        point = point_at(fractions_at(texels.atlas, h // 3, x, y), seams.triangles[h // 3], vertices)
        color = seam_color(h, point, nearest[2], vertices, seams, stack, exposures, shifts, means)
        changes[i] = color - texels.colors[i]
        texels.steps[i] = 0


@func
def neighbor_texel(i: int, k: int, size: int) -> int:
    """Texel to the left, right, above or below; -1 beyond the border."""
    x = i % size
    y = i // size
    neighbor = -1
    if k == 0 and x > 0:
        neighbor = i - 1
    if k == 1 and x < size - 1:
        neighbor = i + 1
    if k == 2 and y > 0:
        neighbor = i - size
    if k == 3 and y < size - 1:
        neighbor = i + size
    return neighbor


@kernel
def spread_steps_kernel(texels: ChartTexels, seams: Seams, step: int, free: array(dtype=uint8)):
    """Extend the distance by one ring."""
    i = tid()
    owner = texels.owners[i]
    if owner != NO_TRIANGLE and texels.steps[i] == UNREACHED_STEPS:
        if seams.views[owner] >= 0:
            is_next = 0
            for k in range(4):
                j = neighbor_texel(i, k, texels.atlas.width)
                if j >= 0:
                    if texels.steps[j] == step - 1:
                        is_next = 1
            if is_next == 1:
                texels.steps[i] = step
                free[i] = uint8(1)


@kernel
def begin_strips_kernel(
    texels: ChartTexels,
    seams: Seams,
    free: array(dtype=int32),
    changes: array(dtype=vec3d),
    weights: array(dtype=float64),
    state: Gradients,
):
    """Diagonal, and the right side from neighbors on a seam."""
    i = tid()
    texel = free[i]
    weight = float64(0.0)
    right = vec3d(0.0, 0.0, 0.0)
    for k in range(4):
        j = neighbor_texel(texel, k, texels.atlas.width)
        if j >= 0:
            owner = texels.owners[j]
            if owner != NO_TRIANGLE:
                if seams.views[owner] >= 0:
                    weight += 1.0
                    if texels.steps[j] == 0:
                        right += changes[j]
    weights[i] = weight
    state.residual[i] = right


@kernel
def map_strips_kernel(
    texels: ChartTexels,
    free: array(dtype=int32),
    numbers: array(dtype=int32),
    weights: array(dtype=float64),
    state: Gradients,
):
    i = tid()
    total = weights[i] * state.search[i]
    for k in range(4):
        j = neighbor_texel(free[i], k, texels.atlas.width)
        if j >= 0:
            if texels.steps[j] > 0 and texels.steps[j] < UNREACHED_STEPS:
                total -= state.search[numbers[j]]
    state.image[i] = total


@kernel
def change_free_kernel(free: array(dtype=int32), solution: array(dtype=vec3d), changes: array(dtype=vec3d)):
    i = tid()
    changes[free[i]] = solution[i]


@kernel
def add_changes_kernel(texels: ChartTexels, changes: array(dtype=vec3d)):
    i = tid()
    texels.colors[i] = texels.colors[i] + changes[i]


def blend_strips(texels: ChartTexels, levels: SeamLevels) -> None:
    """Blend the colors of texels near seams. A few syncs."""
    seams, device, count = levels.seams, texels.owners.device, texels.size * texels.size
    changes, free = empty(count, vec3d, device), zeros(count, uint8, device)
    means: Positions = zeros(levels.vertices.size, vec3d, device)
    launch(mean_at_vertices_kernel, seams.count, [*levels.arguments, means])
    launch(aim_at_seams_kernel, count, [texels, *levels.arguments, means, changes])
    for step in range(1, STRIP_TEXELS + 1):
        launch(spread_steps_kernel, count, [texels, seams, step, free])
    rows: Indices = positions_of(free)  # sync
    if rows.size:
        numbers, weights = empty(count, int32, device), empty(rows.size, float64, device)
        launch(number_rows_kernel, rows.size, [rows, numbers])
        state = Gradients(zeros(rows.size, vec3d, device), MAX_RESIDUAL_RATIO, MAX_ITERATIONS, zeros(1, vec2d, device))

        def apply() -> None:
            launch(map_strips_kernel, rows.size, [texels, rows, numbers, weights, state])

        def weigh() -> None:
            launch(weigh_by_diagonal_kernel, rows.size, [weights, state])

        launch(begin_strips_kernel, rows.size, [texels, seams, rows, changes, weights, state])
        ConjugateGradients(state, apply, weigh).solve()
        launch(change_free_kernel, rows.size, [rows, state.solution, changes])
    launch(add_changes_kernel, count, [texels, changes])
