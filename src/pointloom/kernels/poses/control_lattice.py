"""Control lattice for non-rigid deformation: points by trilinear weights, normals by the inverse transpose Jacobian.

Zhou and Koltun 2014, section 3. Anchors are the corners of occupied cells, in key order, independent of point order.
"""

import numpy as np

from ..algebra.rigid_solve import fit_pose, move, pair_sums, sums_of_pair
from ..algebra.transform import narrow, widen
from ..array_types import Keys, Points, Vectors
from ..arrays.block_keys import block_key, key_block
from ..arrays.concatenation import concatenate_rows
from ..arrays.hash_table import HashTable, find_position, list_keys
from ..arrays.unique import UniqueKeys
from ..lang import (
    array,
    compute,
    cross,
    dot,
    float64,
    floor,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    mat44d,
    reduce,
    reduction,
    sqrt,
    struct,
    tid,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import download, empty, zeros

CELL_CORNERS = 8
ANCHOR_NEIGHBORS = 6
MAX_CELL = 1 << 19  # cells from the origin: range of a key, with room for neighbors
MAX_COORDINATE = float(MAX_CELL)
OUTSIDE_KEY = 0x7FFF_FFFF_FFFF_FFFF  # key of points outside all cells


@struct
class ControlLattice:
    """Cells of edge `cell_size` [m], their corner anchors (corner 4 x + 2 y + z) and `shifts` [m]; `sharers`: cells
    with the anchor as corner 0 to 7; `around`: neighbors along -x, x, -y, y, -z, z; -1 for none.
    """

    cell_size: float64
    cells: HashTable
    anchors: HashTable
    corners: array(dtype=int32)
    sharers: array(dtype=int32)
    around: array(dtype=int32)
    shifts: array(dtype=vec3d)

    def __init__(self, cell_size: float, cell_keys: Keys) -> None:
        """Lattice of ascending cell keys with zero shifts."""
        device = cell_keys.device
        self.cell_size, self.cell_keys, self.cell_count = float(cell_size), cell_keys, cell_keys.size
        self.cells = list_keys(cell_keys, self.cell_count, self.cell_count)
        corner_keys = empty(CELL_CORNERS * self.cell_count, int64, device)
        launch(key_corners_kernel, self.cell_count, [cell_keys, corner_keys])
        self.anchor_keys = UniqueKeys(corner_keys).keys  # sync
        self.anchor_count = self.anchor_keys.size
        self.anchors = list_keys(self.anchor_keys, self.anchor_count, self.anchor_count)
        self.corners = self.anchors.find(corner_keys)[0]
        self.sharers = empty(CELL_CORNERS * self.anchor_count, int32, device)
        self.around = empty(ANCHOR_NEIGHBORS * self.anchor_count, int32, device)
        self.shifts = zeros(self.anchor_count, vec3d, device)
        given = [self.anchor_keys, self.cells, self.anchors, self.sharers, self.around]
        launch(join_anchors_kernel, self.anchor_count, given)


@func
def find_cell(p: vec3, cell_size: float64) -> vec3i:
    """Cell of a finite position; (MAX_CELL, ..) beyond all keys."""
    scaled = widen(p) / cell_size
    limit = float64(MAX_COORDINATE)
    cell = vec3i(MAX_CELL, MAX_CELL, MAX_CELL)
    if max(abs(scaled[0]), max(abs(scaled[1]), abs(scaled[2]))) < limit:
        cell = vec3i(int(floor(scaled[0])), int(floor(scaled[1])), int(floor(scaled[2])))
    return cell


@func
def fraction_of(p: vec3, cell: vec3i, cell_size: float64) -> vec3d:
    """Position within a cell, 0 to 1 per axis."""
    scaled = widen(p) / cell_size
    return scaled - vec3d(float64(cell[0]), float64(cell[1]), float64(cell[2]))


@func
def corner_weight(corner: int, fraction: vec3d) -> float64:
    one = float64(1.0)
    x = fraction[0]
    y = fraction[1]
    z = fraction[2]
    if (corner >> 2) == 0:
        x = one - x
    if ((corner >> 1) & 1) == 0:
        y = one - y
    if (corner & 1) == 0:
        z = one - z
    return x * y * z


@func
def corner_slope(corner: int, fraction: vec3d) -> vec3d:
    one = float64(1.0)
    x = fraction[0]
    y = fraction[1]
    z = fraction[2]
    along = vec3d(one, one, one)
    if (corner >> 2) == 0:
        x = one - x
        along[0] = -one
    if ((corner >> 1) & 1) == 0:
        y = one - y
        along[1] = -one
    if (corner & 1) == 0:
        z = one - z
        along[2] = -one
    return vec3d(along[0] * y * z, along[1] * x * z, along[2] * x * y)


@kernel
def key_cells_kernel(points: array(dtype=vec3), cell_size: float64, keys: array(dtype=int64)):
    i = tid()
    p = points[i]
    key = int64(OUTSIDE_KEY)
    if isfinite(p):
        cell = find_cell(p, cell_size)
        if cell[0] < MAX_CELL:
            key = block_key(cell[0], cell[1], cell[2])
    keys[i] = key


@kernel
def key_corners_kernel(cell_keys: array(dtype=int64), keys: array(dtype=int64)):
    i = tid()
    cell = key_block(cell_keys[i])
    n = int(CELL_CORNERS)
    for k in range(n):
        keys[CELL_CORNERS * i + k] = block_key(cell[0] + (k >> 2), cell[1] + ((k >> 1) & 1), cell[2] + (k & 1))


@kernel
def join_anchors_kernel(
    anchor_keys: array(dtype=int64),
    cells: HashTable,
    anchors: HashTable,
    sharers: array(dtype=int32),
    around: array(dtype=int32),
):
    i = tid()
    position = key_block(anchor_keys[i])
    n = int(CELL_CORNERS)
    for k in range(n):
        key = block_key(position[0] - (k >> 2), position[1] - ((k >> 1) & 1), position[2] - (k & 1))
        sharers[CELL_CORNERS * i + k] = find_position(key, cells)
    m = int(ANCHOR_NEIGHBORS)
    for k in range(m):
        step = 2 * (k & 1) - 1
        x = position[0]
        y = position[1]
        z = position[2]
        if (k >> 1) == 0:
            x += step
        if (k >> 1) == 1:
            y += step
        if (k >> 1) == 2:
            z += step
        around[ANCHOR_NEIGHBORS * i + k] = find_position(block_key(x, y, z), anchors)


@kernel
def locate_points_kernel(points: array(dtype=vec3), lattice: ControlLattice, cells: array(dtype=int32)):
    i = tid()
    p = points[i]
    cell_index = -1
    if isfinite(p):
        cell = find_cell(p, lattice.cell_size)
        if cell[0] < MAX_CELL:
            cell_index = find_position(block_key(cell[0], cell[1], cell[2]), lattice.cells)
    cells[i] = cell_index


@kernel
def bend_points_kernel(points: array(dtype=vec3), lattice: ControlLattice, moved: array(dtype=vec3)):
    """Displace points by trilinear weights, renormalized where anchors are missing."""
    i = tid()
    p = points[i]
    q = p + vec3(0.0, 0.0, 0.0)
    if isfinite(p):
        cell = find_cell(p, lattice.cell_size)
        if cell[0] < MAX_CELL:
            fraction = fraction_of(p, cell, lattice.cell_size)
            total = vec3d(0.0, 0.0, 0.0)
            weights = float64(0.0)
            missing = 0
            n = int(CELL_CORNERS)
            for k in range(n):
                key = block_key(cell[0] + (k >> 2), cell[1] + ((k >> 1) & 1), cell[2] + (k & 1))
                anchor = find_position(key, lattice.anchors)
                if anchor >= 0:
                    w = corner_weight(k, fraction)
                    total += w * lattice.shifts[anchor]
                    weights += w
                else:
                    missing += 1
            if missing > 0 and weights > 0.0:
                total = total / weights
            q = narrow(widen(p) + total)
    moved[i] = q


@kernel
def bend_normals_kernel(
    points: array(dtype=vec3), normals: array(dtype=vec3), lattice: ControlLattice, bent: array(dtype=vec3)
):
    """Rotate normals with the surface, keeping their length; unchanged in incomplete cells."""
    i = tid()
    p = points[i]
    n = normals[i]
    m = n + vec3(0.0, 0.0, 0.0)
    if isfinite(p):
        cell = find_cell(p, lattice.cell_size)
        if cell[0] < MAX_CELL:
            cell_index = find_position(block_key(cell[0], cell[1], cell[2]), lattice.cells)
            if cell_index >= 0:
                fraction = fraction_of(p, cell, lattice.cell_size)
                x = vec3d(1.0, 0.0, 0.0)
                y = vec3d(0.0, 1.0, 0.0)
                z = vec3d(0.0, 0.0, 1.0)
                count = int(CELL_CORNERS)
                for k in range(count):
                    shift = lattice.shifts[lattice.corners[CELL_CORNERS * cell_index + k]]
                    slope = corner_slope(k, fraction) / lattice.cell_size
                    x += shift[0] * slope
                    y += shift[1] * slope
                    z += shift[2] * slope
                # rows of the cofactors of the Jacobian
                d = widen(n)
                e = vec3d(dot(cross(y, z), d), dot(cross(z, x), d), dot(cross(x, y), d))
                size = dot(e, e)
                if size > 0.0:
                    m = narrow(e * (length_of(d) / length_of(e)))
    bent[i] = m


@func
def length_of(v: vec3d) -> float64:
    return sqrt(dot(v, v))


@kernel
def anchor_positions_kernel(
    anchor_keys: array(dtype=int64), cell_size: float64, shifts: array(dtype=vec3d), positions: array(dtype=vec3d)
):
    i = tid()
    cell = key_block(anchor_keys[i])
    positions[i] = vec3d(float64(cell[0]), float64(cell[1]), float64(cell[2])) * cell_size + shifts[i]


@kernel
def carry_shifts_kernel(anchor_keys: array(dtype=int64), known: ControlLattice, shifts: array(dtype=vec3d)):
    """Shifts of the anchors that another lattice has. Zero for new ones."""
    i = tid()
    anchor = find_position(anchor_keys[i], known.anchors)
    shift = vec3d(0.0, 0.0, 0.0)
    if anchor >= 0:
        shift = known.shifts[anchor]
    shifts[i] = shift


@reduction
def sum_bent_pairs(points: array(dtype=vec3), moved: array(dtype=vec3)) -> pair_sums:
    """Sums for `fit_pose` of points and displaced points."""
    i = tid()
    total = pair_sums(0.0)
    if isfinite(points[i]) and isfinite(moved[i]):
        total = sums_of_pair(widen(points[i]), widen(moved[i]), 1.0)
    return total


def make_lattice(cell_size: float, points: Points, known: ControlLattice | None = None) -> ControlLattice:
    """Lattice of the cells of points and of the `known` lattice, whose shifts it keeps. One sync."""
    device = points.device
    keys = compute(key_cells_kernel, points.size, [points, float(cell_size)], int64, device)
    groups = UniqueKeys(keys)
    groups.drop_last(OUTSIDE_KEY)
    cell_keys = groups.keys
    if known is not None and known.cell_count:
        cell_keys = UniqueKeys(concatenate_rows([known.cell_keys, cell_keys])).keys
    lattice = ControlLattice(cell_size, cell_keys)
    if known is not None and known.cell_count:
        launch(carry_shifts_kernel, lattice.anchor_count, [lattice.anchor_keys, known, lattice.shifts])
    return lattice


def bend_points(points: Points, lattice: ControlLattice) -> Points:
    return compute(bend_points_kernel, points.size, [points, lattice], vec3, points.device)


def bend_normals(points: Points, normals: Vectors, lattice: ControlLattice) -> Vectors:
    """Deform the normals at undeformed points."""
    return compute(bend_normals_kernel, points.size, [points, normals, lattice], vec3, points.device)


@kernel
def fit_motion_kernel(sums: array(dtype=pair_sums), motion: array(dtype=mat44d)):
    """Rigid motion nearest to the deformation of the points. One thread."""
    i = tid()
    motion[i] = fit_pose(sums[i], 0)


@kernel
def move_anchors_kernel(
    anchor_keys: array(dtype=int64), cell_size: float64, motion: mat44d, shifts: array(dtype=vec3d)
):
    i = tid()
    cell = key_block(anchor_keys[i])
    rest = vec3d(float64(cell[0]), float64(cell[1]), float64(cell[2])) * cell_size
    shifts[i] = move(motion, rest + shifts[i]) - rest


def motion_of(points: Points, moved: Vectors) -> np.ndarray:
    """Best rigid motion from points to moved points, float64 (4, 4) (one sync)."""
    sums, motion = reduce(sum_bent_pairs, points.size, [points, moved]), empty(1, mat44d, points.device)
    launch(fit_motion_kernel, 1, [sums, motion])
    return np.array(download(motion)[0], np.float64)  # sync
