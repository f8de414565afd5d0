"""A lattice of anchors over a frame, which bends what lies in it: points by trilinear weights, normals by the slopes.

Space is cut into cells; those that hold points are kept, and their corners are the anchors, each with a shift. A point
moves by the mean of the eight shifts about it as they weigh; a normal takes the inverse transpose of the Jacobian.
Anchors stand in the order of their keys, so a lattice does not depend on the order of the points. Zhou and Koltun 2014,
section 3. A point takes eight look-ups in a hash table and some 100 operations; an anchor 150 B.
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

CORNERS = 8
AROUND = 6
FARTHEST = 1 << 19  # cells from the origin: what a key holds, with room for neighbours
REACH = float(FARTHEST)
NOWHERE = 0x7FFF_FFFF_FFFF_FFFF  # the key of what lies in no cell


@struct
class ControlLattice:
    """Cells, their corners, and how far these are shifted.

    Attributes:
        cell_size: Edge of a cell [m].
        cells, anchors: HashTables of the keys of the cells and of their corners.
        corners: The anchors at a cell's corners, int32 [8 cells]; corner 4 x + 2 y + z lies x, y, z cells further.
        sharers: The cells whose corner 0 to 7 an anchor is, -1 where there is none, int32 [8 anchors].
        around: The anchors one cell away along -x, x, -y, y, -z, z, -1 where there is none, int32 [6 anchors].
        shifts: vec3d [anchors] [m].
        cell_keys, anchor_keys: Ascending, int64.
    """

    cell_size: float64
    cells: HashTable
    anchors: HashTable
    corners: array(dtype=int32)
    sharers: array(dtype=int32)
    around: array(dtype=int32)
    shifts: array(dtype=vec3d)

    def __init__(self, cell_size: float, cell_keys: Keys) -> None:
        """The lattice of cells by their ascending keys, nothing shifted."""
        device = cell_keys.device
        self.cell_size, self.cell_keys, self.cell_count = float(cell_size), cell_keys, cell_keys.size
        self.cells = list_keys(cell_keys, self.cell_count, self.cell_count)
        corner_keys = empty(CORNERS * self.cell_count, int64, device)
        launch(key_corners_kernel, self.cell_count, [cell_keys, corner_keys])
        self.anchor_keys = UniqueKeys(corner_keys).keys  # sync
        self.anchor_count = self.anchor_keys.size
        self.anchors = list_keys(self.anchor_keys, self.anchor_count, self.anchor_count)
        self.corners = self.anchors.find(corner_keys)[0]
        self.sharers = empty(CORNERS * self.anchor_count, int32, device)
        self.around = empty(AROUND * self.anchor_count, int32, device)
        self.shifts = zeros(self.anchor_count, vec3d, device)
        given = [self.anchor_keys, self.cells, self.anchors, self.sharers, self.around]
        launch(join_anchors_kernel, self.anchor_count, given)


@func
def find_cell(p: vec3, cell_size: float64) -> vec3i:
    """The cell of a finite place; (FARTHEST, ..) where it lies beyond all keys."""
    place = widen(p) / cell_size
    limit = float64(REACH)
    cell = vec3i(FARTHEST, FARTHEST, FARTHEST)
    if max(abs(place[0]), max(abs(place[1]), abs(place[2]))) < limit:
        cell = vec3i(int(floor(place[0])), int(floor(place[1])), int(floor(place[2])))
    return cell


@func
def share_of(p: vec3, cell: vec3i, cell_size: float64) -> vec3d:
    """How far along its cell a place lies, 0 to 1 an axis."""
    place = widen(p) / cell_size
    return place - vec3d(float64(cell[0]), float64(cell[1]), float64(cell[2]))


@func
def corner_weight(corner: int, share: vec3d) -> float64:
    """What a corner of its cell counts for a place."""
    one = float64(1.0)
    x = share[0]
    y = share[1]
    z = share[2]
    if (corner >> 2) == 0:
        x = one - x
    if ((corner >> 1) & 1) == 0:
        y = one - y
    if (corner & 1) == 0:
        z = one - z
    return x * y * z


@func
def corner_slope(corner: int, share: vec3d) -> vec3d:
    """How that changes along each axis, a cell."""
    one = float64(1.0)
    x = share[0]
    y = share[1]
    z = share[2]
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
    """The key of each point's cell."""
    i = tid()
    p = points[i]
    key = int64(NOWHERE)
    if isfinite(p):
        cell = find_cell(p, cell_size)
        if cell[0] < FARTHEST:
            key = block_key(cell[0], cell[1], cell[2])
    keys[i] = key


@kernel
def key_corners_kernel(cell_keys: array(dtype=int64), keys: array(dtype=int64)):
    """The keys of the eight corners of each cell."""
    i = tid()
    cell = key_block(cell_keys[i])
    n = int(CORNERS)
    for k in range(n):
        keys[CORNERS * i + k] = block_key(cell[0] + (k >> 2), cell[1] + ((k >> 1) & 1), cell[2] + (k & 1))


@kernel
def join_anchors_kernel(
    anchor_keys: array(dtype=int64),
    cells: HashTable,
    anchors: HashTable,
    sharers: array(dtype=int32),
    around: array(dtype=int32),
):
    """The cells and the neighbours of each anchor."""
    i = tid()
    place = key_block(anchor_keys[i])
    n = int(CORNERS)
    for k in range(n):
        key = block_key(place[0] - (k >> 2), place[1] - ((k >> 1) & 1), place[2] - (k & 1))
        sharers[CORNERS * i + k] = find_position(key, cells)
    m = int(AROUND)
    for k in range(m):
        step = 2 * (k & 1) - 1
        x = place[0]
        y = place[1]
        z = place[2]
        if (k >> 1) == 0:
            x += step
        if (k >> 1) == 1:
            y += step
        if (k >> 1) == 2:
            z += step
        around[AROUND * i + k] = find_position(block_key(x, y, z), anchors)


@kernel
def locate_points_kernel(points: array(dtype=vec3), lattice: ControlLattice, cells: array(dtype=int32)):
    """The cell that each point lies in, -1 where that is none of the lattice."""
    i = tid()
    p = points[i]
    found = -1
    if isfinite(p):
        cell = find_cell(p, lattice.cell_size)
        if cell[0] < FARTHEST:
            found = find_position(block_key(cell[0], cell[1], cell[2]), lattice.cells)
    cells[i] = found


@kernel
def bend_points_kernel(points: array(dtype=vec3), lattice: ControlLattice, moved: array(dtype=vec3)):
    """Each point moved by the anchors about it; where some are not there, by the others as they weigh."""
    i = tid()
    p = points[i]
    q = p + vec3(0.0, 0.0, 0.0)
    if isfinite(p):
        cell = find_cell(p, lattice.cell_size)
        if cell[0] < FARTHEST:
            share = share_of(p, cell, lattice.cell_size)
            total = vec3d(0.0, 0.0, 0.0)
            weights = float64(0.0)
            missing = 0
            n = int(CORNERS)
            for k in range(n):
                key = block_key(cell[0] + (k >> 2), cell[1] + ((k >> 1) & 1), cell[2] + (k & 1))
                anchor = find_position(key, lattice.anchors)
                if anchor >= 0:
                    w = corner_weight(k, share)
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
    """Each normal as the surface turns at its point, of its own length; as it was in cells that are not all there."""
    i = tid()
    p = points[i]
    n = normals[i]
    m = n + vec3(0.0, 0.0, 0.0)
    if isfinite(p):
        cell = find_cell(p, lattice.cell_size)
        if cell[0] < FARTHEST:
            found = find_position(block_key(cell[0], cell[1], cell[2]), lattice.cells)
            if found >= 0:
                share = share_of(p, cell, lattice.cell_size)
                x = vec3d(1.0, 0.0, 0.0)
                y = vec3d(0.0, 1.0, 0.0)
                z = vec3d(0.0, 0.0, 1.0)
                count = int(CORNERS)
                for k in range(count):
                    shift = lattice.shifts[lattice.corners[CORNERS * found + k]]
                    slope = corner_slope(k, share) / lattice.cell_size
                    x += shift[0] * slope
                    y += shift[1] * slope
                    z += shift[2] * slope
                # the cofactors of the Jacobian, whose rows these are
                d = widen(n)
                e = vec3d(dot(cross(y, z), d), dot(cross(z, x), d), dot(cross(x, y), d))
                size = dot(e, e)
                if size > 0.0:
                    m = narrow(e * (length_of(d) / length_of(e)))
    bent[i] = m


@func
def length_of(v: vec3d) -> float64:
    """The length of a vector."""
    return sqrt(dot(v, v))


@kernel
def place_anchors_kernel(
    anchor_keys: array(dtype=int64), cell_size: float64, shifts: array(dtype=vec3d), places: array(dtype=vec3d)
):
    """Where each anchor is."""
    i = tid()
    cell = key_block(anchor_keys[i])
    places[i] = vec3d(float64(cell[0]), float64(cell[1]), float64(cell[2])) * cell_size + shifts[i]


@kernel
def carry_shifts_kernel(anchor_keys: array(dtype=int64), known: ControlLattice, shifts: array(dtype=vec3d)):
    """The shifts of the anchors that another lattice has; zero of those that are new."""
    i = tid()
    found = find_position(anchor_keys[i], known.anchors)
    shift = vec3d(0.0, 0.0, 0.0)
    if found >= 0:
        shift = known.shifts[found]
    shifts[i] = shift


@reduction
def sum_bent_pairs(points: array(dtype=vec3), moved: array(dtype=vec3)) -> pair_sums:
    """What `fit_pose` takes of points and where they went."""
    i = tid()
    total = pair_sums(0.0)
    if isfinite(points[i]) and isfinite(moved[i]):
        total = sums_of_pair(widen(points[i]), widen(moved[i]), 1.0)
    return total


def make_lattice(cell_size: float, points: Points, known: ControlLattice | None = None) -> ControlLattice:
    """The lattice of the cells that points lie in, and of those of another lattice, with its shifts; one sync."""
    device = points.device
    keys = empty(points.size, int64, device)
    launch(key_cells_kernel, points.size, [points, float(cell_size), keys])
    found = UniqueKeys(keys)
    found.drop_last(NOWHERE)
    cell_keys = found.keys
    if known is not None and known.cell_count:
        cell_keys = UniqueKeys(concatenate_rows([known.cell_keys, cell_keys])).keys
    lattice = ControlLattice(cell_size, cell_keys)
    if known is not None and known.cell_count:
        launch(carry_shifts_kernel, lattice.anchor_count, [lattice.anchor_keys, known, lattice.shifts])
    return lattice


def bend_points(points: Points, lattice: ControlLattice) -> Points:
    """A device array of vec3, bent."""
    moved = empty(points.size, vec3, points.device)
    launch(bend_points_kernel, points.size, [points, lattice, moved])
    return moved


def bend_normals(points: Points, normals: Vectors, lattice: ControlLattice) -> Vectors:
    """The normals at points that are not bent yet, as the surface turns."""
    bent = empty(points.size, vec3, points.device)
    launch(bend_normals_kernel, points.size, [points, normals, lattice, bent])
    return bent


@kernel
def fit_motion_kernel(sums: array(dtype=pair_sums), motion: array(dtype=mat44d)):
    """The rigid motion that is nearest to what the lattice does to the points. One thread."""
    i = tid()
    motion[i] = fit_pose(sums[i], 0)


@kernel
def move_anchors_kernel(
    anchor_keys: array(dtype=int64), cell_size: float64, motion: mat44d, shifts: array(dtype=vec3d)
):
    """Move each anchor, from where it is, by a rigid motion."""
    i = tid()
    cell = key_block(anchor_keys[i])
    rest = vec3d(float64(cell[0]), float64(cell[1]), float64(cell[2])) * cell_size
    shifts[i] = move(motion, rest + shifts[i]) - rest


def motion_of(points: Points, moved: Vectors) -> np.ndarray:
    """The rigid motion nearest to the way from points to others, float64 [4, 4] (one sync)."""
    sums, motion = reduce(sum_bent_pairs, points.size, [points, moved]), empty(1, mat44d, points.device)
    launch(fit_motion_kernel, 1, [sums, motion])
    return np.array(download(motion)[0], np.float64)  # sync
