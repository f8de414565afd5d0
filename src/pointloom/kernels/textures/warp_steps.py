"""Joint steps of image poses and warps (Zhou and Koltun 2014, section 4.3).

A residual depends on the pose and four anchors, so in column order the matrix is banded with 2 (rows + 2) entries and a
border of six columns. Pairs are sorted by cell and sums have a fixed order. One thread per image: banded Cholesky
(Golub and Van Loan, section 4.3.5) and a Schur complement for the pose.
"""

import numpy as np

from ..algebra.matrices import multiply44
from ..algebra.rigid_solve import small_motion, solve_system, triangle, triangle_index, vec6d
from ..array_types import Points
from ..arrays.key_starts import find_key_starts
from ..arrays.side_by_side import read_together
from ..arrays.sort import argsort_keys
from ..lang import (
    array,
    float32,
    float64,
    floor,
    func,
    int32,
    int64,
    kernel,
    launch,
    sqrt,
    struct,
    tid,
    vec2d,
    vec2i,
    vec3,
    vector,
)
from ..memory import clone, copy, empty, upload
from .color_steps import ColorSearch, SearchState, measure_pair, pose_sums
from .stacked_images import StackedImages, Warps
from .vertex_views import Sightings

VALUES_PER_ROW = 11  # derivatives along u and v, position in the cell (p, q), residual, pose derivatives
TARGETS_PER_ANCHOR = 6  # per anchor: itself, four neighbors, and the border
ANCHOR_WEIGHT = 0.125  # of the anchors' squares: Open3D's gradients are 8 times too large, so its anchors count 1/8
border_sums = vector(14, float64)


@struct
class WarpSystem:
    """Normal equations of all anchors and poses. `fractions`: visible fraction of vertices, scales the `weight`;
    `cells`: first sorted pair; `band` entry (r, c) at c - r + width - 1; `border`: pose columns, right side, scratch.
    """

    cells: array(dtype=int32)
    rows: array(dtype=float32, ndim=2)
    band: array(dtype=float64, ndim=2)
    border: array(dtype=float64, ndim=2)
    ties: array(dtype=float64)
    width: int

    def __init__(self, warps: Warps, pair_count: int, fractions: np.ndarray, weight: float) -> None:
        device = warps.shifts.device
        self.width = 2 * (warps.rows + 1) + 2
        self.cells = empty(warps.count + 1, int32, device)
        self.rows = empty((pair_count, VALUES_PER_ROW), float32, device)
        self.band = empty((2 * warps.count, self.width), float64, device)
        self.border = empty((2 * warps.count, 8), float64, device)
        self.ties = upload(ANCHOR_WEIGHT * np.square(weight * np.asarray(fractions, np.float64)), float64, device)


@kernel
def number_cells_kernel(
    vertices: array(dtype=vec3),
    sightings: Sightings,
    stack: StackedImages,
    warps: Warps,
    cell_count: int,
    keys: array(dtype=int64),
):
    """Cell of each pair, as its first anchor. The last number if it does not count."""
    i = tid()
    image = sightings.images[i]
    row = measure_pair(vertices[sightings.vertices[i]], image, 0.0, stack, warps)
    cell = cell_count
    if row[0] > 0.0:
        grid = warps.grids[image]
        step = warps.steps[image]
        a = min(max(int(floor(row[10] / step)), 0), grid[0] - 2)
        b = min(max(int(floor(row[11] / step)), 0), grid[1] - 2)
        cell = grid[2] + a * grid[1] + b
    keys[i] = int64(cell)


@kernel
def fill_rows_kernel(
    vertices: array(dtype=vec3),
    sightings: Sightings,
    proxies: array(dtype=float64),
    stack: StackedImages,
    warps: Warps,
    order: array(dtype=int32),
    system: WarpSystem,
):
    i = tid()
    pair = order[i]
    image = sightings.images[pair]
    vertex = sightings.vertices[pair]
    row = measure_pair(vertices[vertex], image, proxies[vertex], stack, warps)
    step = warps.steps[image]
    grid = warps.grids[image]
    a = row[10] / step
    b = row[11] / step
    system.rows[i, 0] = float(row[8])
    system.rows[i, 1] = float(row[9])
    system.rows[i, 2] = float(a - float64(min(max(int(floor(a)), 0), grid[0] - 2)))
    system.rows[i, 3] = float(b - float64(min(max(int(floor(b)), 0), grid[1] - 2)))
    system.rows[i, 4] = float(row[1])
    n = int(6)
    for k in range(n):
        system.rows[i, 5 + k] = float(row[2 + k])


@func
def anchor_weight(pair: int, right: int, down: int, system: WarpSystem) -> float64:
    p = float64(system.rows[pair, 2])
    q = float64(system.rows[pair, 3])
    w = float64(1.0)
    if right == 1:
        w = p
    else:
        w = w - p
    if down == 1:
        w = w * q
    else:
        w = w * (1.0 - q)
    return w


@func
def write_entries(
    image: int,
    anchor: int,
    target: int,
    beside: vec2i,
    total: border_sums,
    warps: Warps,
    state: SearchState,
    system: WarpSystem,
):
    """Write the sums of an anchor with a neighbor at offset `beside`, or with the pose."""
    grid = warps.grids[image]
    column = anchor // grid[1]
    row = anchor % grid[1]
    first = 2 * (grid[2] + anchor)
    if target == 5:
        tie = system.ties[image]
        shift = warps.shifts[grid[2] + anchor]
        n = int(6)
        for m in range(n):
            system.border[first, m] = total[m]
            system.border[first + 1, m] = total[7 + m]
        system.border[first, 6] = -(total[6] + tie * shift[0])
        system.border[first + 1, 6] = -(total[13] + tie * shift[1])
    else:
        last = system.width - 1
        if target == 0:
            tie = system.ties[image]
            damping = 1.0 + state.error[2]
            system.band[first, last] = (total[0] + tie) * damping
            system.band[first + 1, last - 1] = total[1]
            system.band[first + 1, last] = (total[2] + tie) * damping
        else:
            # the later anchor's rows contain the entry
            other = first + 2 * (beside[0] * grid[1] + beside[1])
            if row + beside[1] >= 0 and row + beside[1] < grid[1] and column + beside[0] < grid[0]:
                at = last + first - other
                system.band[other, at] = total[0]
                system.band[other, at + 1] = total[1]
                system.band[other + 1, at - 1] = total[1]
                system.band[other + 1, at] = total[2]


@kernel
def gather_anchors_kernel(image: int, warps: Warps, state: SearchState, system: WarpSystem):
    """Sums of one anchor with itself, a later neighbor, or the pose. Threads write distinct entries."""
    i = tid()
    grid = warps.grids[image]
    anchor = i // TARGETS_PER_ANCHOR
    target = i % TARGETS_PER_ANCHOR
    column = anchor // grid[1]
    row = anchor % grid[1]
    across = 0
    down = 0
    if target == 1:
        down = 1
    if target > 1 and target < 5:
        across = 1
        down = target - 3
    total = border_sums(0.0)
    for a in range(2):
        for b in range(2):
            # the cell of which both the anchor (corner (a, b)) and the neighbor are corners
            x = column - a
            y = row - b
            inside = x >= 0 and y >= 0 and x < grid[0] - 1 and y < grid[1] - 1
            if inside and a + across <= 1 and b + down >= 0 and b + down <= 1:
                cell = grid[2] + x * grid[1] + y
                for k in range(system.cells[cell], system.cells[cell + 1]):
                    w = anchor_weight(k, a, b, system)
                    gx = float64(system.rows[k, 0])
                    gy = float64(system.rows[k, 1])
                    if target < 5:
                        w = w * anchor_weight(k, a + across, b + down, system)
                        total[0] += w * gx * gx
                        total[1] += w * gx * gy
                        total[2] += w * gy * gy
                    else:
                        r = float64(system.rows[k, 4])
                        total[6] += w * gx * r
                        total[13] += w * gy * r
                        n = int(6)
                        for m in range(n):
                            slope = w * float64(system.rows[k, 5 + m])
                            total[m] += slope * gx
                            total[7 + m] += slope * gy
    write_entries(image, anchor, target, vec2i(across, down), total, warps, state, system)


@kernel
def clear_band_kernel(band: array(dtype=float64, ndim=2)):
    i = tid()
    for k in range(band.shape[1]):
        band[i, k] = 0.0


@func
def factor_band(first: int, count: int, system: WarpSystem):
    """Cholesky factor of an image's band in place. A non-positive pivot drops its unknown."""
    last = system.width - 1
    for r in range(count):
        row = first + r
        begin = max(0, r - last)
        for c in range(begin, r + 1):
            value = system.band[row, c - r + last]
            for k in range(max(begin, c - last), c):
                value -= system.band[row, k - r + last] * system.band[first + c, k - c + last]
            if c < r:
                system.band[row, c - r + last] = value * system.band[first + c, last]
            else:
                pivot = float64(0.0)
                if value > 0.0:
                    pivot = 1.0 / sqrt(value)
                system.band[row, last] = pivot  # the reciprocal, which is used


@func
def forward_band(first: int, count: int, system: WarpSystem):
    """Forward substitution of the border's columns and right side."""
    last = system.width - 1
    columns = int(7)
    for r in range(count):
        row = first + r
        for m in range(columns):
            value = system.border[row, m]
            for k in range(max(0, r - last), r):
                value -= system.band[row, k - r + last] * system.border[first + k, m]
            system.border[row, m] = value * system.band[row, last]


@func
def backward_band(first: int, count: int, motion: vec6d, system: WarpSystem):
    """Backward substitution: shift steps, in the border's last column."""
    last = system.width - 1
    n = int(6)
    for back in range(count):
        r = count - 1 - back
        row = first + r
        value = system.border[row, 6]
        for m in range(n):
            value -= system.border[row, m] * motion[m]
        for k in range(r + 1, min(r + last + 1, count)):
            value -= system.band[first + k, r - k + last] * system.border[first + k, 7]
        system.border[row, 7] = value * system.band[row, last]


@func
def solve_pose(first: int, count: int, total: pose_sums, damping: float64, system: WarpSystem) -> vec6d:
    h = triangle(0.0)
    b = vec6d(0.0)
    n = int(6)
    for i in range(n):
        for j in range(i, n):
            value = total[triangle_index(i, j)]
            if i == j:
                value = value * (1.0 + damping)
            for k in range(first, first + count):
                value -= system.border[k, i] * system.border[k, j]
            h[triangle_index(i, j)] = value
        value = -total[21 + i]
        for k in range(first, first + count):
            value -= system.border[k, i] * system.border[k, 6]
        b[i] = value
    return solve_system(h, b)


@kernel
def step_warps_kernel(
    state: SearchState, best_sums: array(dtype=pose_sums), stack: StackedImages, warps: Warps, system: WarpSystem
):
    """Step the pose and anchors of each image. One thread per image."""
    i = tid()
    grid = warps.grids[i]
    if state.running[0] == 1 and system.ties[i] > 0.0:
        first = 2 * grid[2]
        count = 2 * grid[0] * grid[1]
        factor_band(first, count, system)
        forward_band(first, count, system)
        motion = solve_pose(first, count, best_sums[i], state.error[2], system)
        backward_band(first, count, motion, system)
        stack.poses[i] = multiply44(small_motion(motion), stack.poses[i])
        for k in range(grid[0] * grid[1]):
            shift = warps.shifts[grid[2] + k]
            step = vec2d(system.border[first + 2 * k, 7], system.border[first + 2 * k + 1, 7])
            warps.shifts[grid[2] + k] = shift + step


@kernel
def sum_ties_kernel(warps: Warps, system: WarpSystem, ties: array(dtype=float64)):
    i = tid()
    grid = warps.grids[i]
    total = float64(0.0)
    for k in range(grid[2], grid[2] + grid[0] * grid[1]):
        shift = warps.shifts[k]
        total += shift[0] * shift[0] + shift[1] * shift[1]
    ties[i] = total * system.ties[i]


class WarpSearch(ColorSearch):
    """Search for poses and warps: ColorSearch with an anchor band per image."""

    def __init__(
        self,
        vertices: Points,
        sightings: Sightings,
        stack: StackedImages,
        warps: Warps,
        max_iterations: int,
        weight: float,
    ) -> None:
        super().__init__(vertices, sightings, stack, warps, max_iterations)
        self.system = WarpSystem(warps, sightings.count, sightings.counts / max(vertices.size, 1), weight)
        self.best_shifts = clone(warps.shifts)
        self.keys = empty(sightings.count, int64, vertices.device)

    def iterate(self) -> bool:
        """One iteration. False after the last (one sync)."""
        warps, system = self.warps, self.system
        self.measure()
        launch(sum_ties_kernel, self.images.count, [warps, system, self.ties])
        self.judge()
        better, running = (int(values[0]) for values in read_together([self.state.outcome, self.state.running]))  # sync
        shifts = (self.best_shifts, warps.shifts) if better else (warps.shifts, self.best_shifts)
        copy(*shifts, count=warps.count)
        if running:
            if not better:
                self.measure()  # rows and means are of the best poses
            self._gather()
            given = [self.state, self.best_sums, self.images, warps, system]
            launch(step_warps_kernel, self.images.count, given)
        return bool(running)

    def _gather(self) -> None:
        warps, system = self.warps, self.system
        shared = [self.vertices, self.sightings]
        launch(number_cells_kernel, self.sightings.count, [*shared, self.images, warps, warps.count, self.keys])
        keys, order = argsort_keys(self.keys, bit_count=max(1, warps.count.bit_length()))
        find_key_starts(keys, system.cells)
        launch(fill_rows_kernel, self.sightings.count, [*shared, self.proxies, self.images, warps, order, system])
        launch(clear_band_kernel, system.band.shape[0], [system.band])
        for image in range(self.images.count):
            anchors = int(np.prod(warps.layout[image][:2]))
            launch(gather_anchors_kernel, TARGETS_PER_ANCHOR * anchors, [image, warps, self.state, system])
