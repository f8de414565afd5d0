"""Point-to-plane rows between deformed fragments (Zhou and Koltun 2014, eqs. 4 to 6).

A row pairs a point p with its nearest point q of another fragment, both deformed by the lattice and posed. The residual
is (p' - q') n'. Derivatives are recomputed from 100 B per row. Sums have a fixed order.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from ..algebra.rigid_solve import move, rotate
from ..algebra.transform import narrow, transform_points, widen
from ..array_types import Indices, Integers, Points, Vectors
from ..arrays.key_starts import find_key_starts
from ..arrays.packed_keys import key_index
from ..arrays.prefix_sum import find_owner
from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.select import positions_and_starts
from ..arrays.sort import argsort_keys
from ..lang import (
    array,
    compute,
    cross,
    dot,
    float64,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    mat44d,
    struct,
    tid,
    transpose,
    uint8,
    vec3,
    vec3d,
    vector,
)
from ..linear_algebra import solve
from ..memory import download, empty, upload, zeros
from ..search.nearest_point import find_nearest
from ..search.point_tree import PointTree
from ..search.tree_search import order_along_curve
from .control_lattice import (
    CELL_CORNERS,
    ControlLattice,
    bend_normals,
    bend_points,
    corner_weight,
    find_cell,
    fraction_of,
    locate_points_kernel,
)

corner_sums = vector(24, float64)  # three per cell corner
slope_sums = vector(6, float64)


@struct
class FragmentRows:
    """Rows at given poses and shifts. `ends`: source and target fragments per pair; `positions`, `normals`: q' and
    n' in the pose frame. Cells (-1: rigid); `residuals` [m]; `images`: product with a step; `order`: 2 row + 1 for the
    target.
    """

    ends: array(dtype=int32)
    pairs: array(dtype=int32)
    positions: array(dtype=vec3)
    normals: array(dtype=vec3)
    source_normals: array(dtype=vec3)
    target_normals: array(dtype=vec3)
    source_cells: array(dtype=int32)
    target_cells: array(dtype=int32)
    source_fractions: array(dtype=vec3)
    target_fractions: array(dtype=vec3)
    residuals: array(dtype=float64)
    images: array(dtype=float64)
    order: array(dtype=int32)

    def __init__(self, count: int, ends: Integers) -> None:
        device, self.count, self.ends = ends.device, count, ends
        self.pairs = empty(count, int32, device)
        self.starts = np.zeros(1, np.int64)
        self.sums: SegmentBlocks  # of the rows of each pair. Set once they are known
        for name in (
            "positions",
            "normals",
            "source_normals",
            "target_normals",
            "source_fractions",
            "target_fractions",
        ):
            setattr(self, name, empty(count, vec3, device))
        self.source_cells, self.target_cells = empty(count, int32, device), empty(count, int32, device)
        self.residuals, self.images = empty(count, float64, device), empty(count, float64, device)

    def sort_by_cell(self, cell_count: int) -> None:
        """Order the row ends by cell and set the SegmentBlocks of pairs and cells. Syncs."""
        device = self.ends.device
        starts = empty(cell_count + 1, int32, device)
        self.order = empty(0, int32, device)
        if cell_count:
            keys = compute(key_ends_kernel, 2 * self.count, [cell_count, self], int64, device)
            sorted_keys, self.order = argsort_keys(keys, max(1, cell_count.bit_length()))
            find_key_starts(sorted_keys, starts)
        else:
            starts = zeros(1, int32, device)
        first = download(starts)  # sync
        self.cells = SegmentBlocks(first[:-1], np.diff(first), device)


@struct
class Fragments:
    """Concatenated clouds of all fragments about one origin; `moved`, `bent`: deformed points and normals."""

    points: array(dtype=vec3)
    normals: array(dtype=vec3)
    cells: array(dtype=int32)
    moved: array(dtype=vec3)
    bent: array(dtype=vec3)

    def __init__(self, points: Points, normals: Vectors, counts: Sequence[int], lattice: ControlLattice) -> None:
        self.points, self.normals, self.lattice = points, normals, lattice
        self.counts = np.asarray(counts, np.int64)
        self.firsts = np.concatenate([[0], np.cumsum(self.counts)])
        self.cells = empty(points.size, int32, points.device)
        launch(locate_points_kernel, points.size, [points, lattice, self.cells])
        self.bend()

    def bend(self) -> None:
        self.moved = bend_points(self.points, self.lattice)
        self.bent = bend_normals(self.points, self.normals, self.lattice)

    def part(self, fragment: int) -> Vectors:
        first, count = int(self.firsts[fragment]), int(self.counts[fragment])
        return self.moved[first : first + count] if count else empty(0, vec3, self.moved.device)


@kernel
def pair_points_kernel(
    nearest: array(dtype=int64),
    source_first: int,
    target_first: int,
    first: int,
    T_target_source: mat44d,
    min_cosine: float64,
    sided: int,
    fragments: Fragments,
    partners: array(dtype=int32),
    mask: array(dtype=uint8),
):
    """Partner of each point if the normals agree. Of either sign if they are unoriented."""
    i = tid()
    partner = key_index(nearest[i])
    keep = 0
    if partner >= 0:
        partner += target_first
        n = rotate(T_target_source, widen(fragments.bent[source_first + i]))
        m = widen(fragments.bent[partner])
        agreement = dot(n, m)
        if sided == 0:
            agreement = abs(agreement)
        if isfinite(agreement) and agreement >= min_cosine:
            keep = 1
    partners[first + i] = partner
    mask[first + i] = uint8(keep)


@kernel
def fill_rows_kernel(
    positions: array(dtype=int32),
    partners: array(dtype=int32),
    candidate_firsts: array(dtype=int32),
    source_firsts: array(dtype=int32),
    row_starts: array(dtype=int32),
    poses: array(dtype=mat44d),
    lattice: ControlLattice,
    fragments: Fragments,
    rows: FragmentRows,
):
    i = tid()
    owner = find_owner(row_starts, i)
    position = positions[i]
    p = source_firsts[owner] + position - candidate_firsts[owner]
    q = partners[position]
    source = poses[rows.ends[2 * owner]]
    target = poses[rows.ends[2 * owner + 1]]
    normal = widen(fragments.bent[p])
    rotated_normal = rotate(source, normal)
    target_position = move(target, widen(fragments.moved[q]))
    rows.pairs[i] = owner
    rows.positions[i] = narrow(target_position)
    rows.normals[i] = narrow(rotated_normal)
    rows.source_normals[i] = fragments.bent[p]
    rows.target_normals[i] = narrow(rotate(transpose(target), rotated_normal))
    rows.residuals[i] = dot(move(source, widen(fragments.moved[p])) - target_position, rotated_normal)
    rows.source_cells[i] = fragments.cells[p]
    rows.target_cells[i] = fragments.cells[q]
    at = fragments.points[p]
    rows.source_fractions[i] = narrow(fraction_of(at, find_cell(at, lattice.cell_size), lattice.cell_size))
    at = fragments.points[q]
    rows.target_fractions[i] = narrow(fraction_of(at, find_cell(at, lattice.cell_size), lattice.cell_size))


@kernel
def key_ends_kernel(cell_count: int, rows: FragmentRows, keys: array(dtype=int64)):
    """Cell of each row end. The last number if it has none."""
    i = tid()
    cell = rows.source_cells[i // 2]
    if i % 2 == 1:
        cell = rows.target_cells[i // 2]
    if cell < 0:
        cell = cell_count
    keys[i] = int64(cell)


@func
def shift_within(cell: int, fraction: vec3, lattice: ControlLattice, first: int, steps: array(dtype=vec3d)) -> vec3d:
    """Displacement at a position in a cell by the anchors' steps from row `first` on."""
    total = vec3d(0.0, 0.0, 0.0)
    if cell >= 0:
        n = int(CELL_CORNERS)
        for k in range(n):
            total += corner_weight(k, widen(fraction)) * steps[first + lattice.corners[CELL_CORNERS * cell + k]]
    return total


@kernel
def map_rows_kernel(first: int, steps: array(dtype=vec3d), lattice: ControlLattice, rows: FragmentRows):
    """Change of each residual under a step: two vectors per fragment (rotation, translation), then one per anchor."""
    i = tid()
    a = 2 * rows.ends[2 * rows.pairs[i]]
    b = 2 * rows.ends[2 * rows.pairs[i] + 1]
    n = widen(rows.normals[i])
    value = dot(cross(widen(rows.positions[i]), n), steps[a] - steps[b]) + dot(n, steps[a + 1] - steps[b + 1])
    p = shift_within(rows.source_cells[i], rows.source_fractions[i], lattice, first, steps)
    q = shift_within(rows.target_cells[i], rows.target_fractions[i], lattice, first, steps)
    rows.images[i] = value + dot(widen(rows.source_normals[i]), p) - dot(widen(rows.target_normals[i]), q)


class Pairs:
    """Fragment pairs and the search for correspondences within `distance` [m]; `sided`: normals are oriented."""

    def __init__(
        self, ends: ArrayLike, fragments: Fragments, distance: float, min_cosine: float, *, sided: bool
    ) -> None:
        self.fragments, self.distance = fragments, distance
        self.min_cosine, self.sided = float(min_cosine), int(sided)
        self.ends = np.asarray(ends, np.int64).reshape(-1, 2)
        device = fragments.points.device
        counts = fragments.counts[self.ends[:, 0]]
        self.firsts = np.concatenate([[0], np.cumsum(counts)])
        self.device_ends = upload(self.ends.ravel().astype(np.int32), int32, device)
        self.partners = empty(int(self.firsts[-1]), int32, device)
        self.mask = empty(int(self.firsts[-1]), uint8, device)
        self.orders: dict[int, Indices] = {}  # of the points of a fragment along a curve, at any pose

    def match(self, poses: np.ndarray) -> FragmentRows:
        """Rows at poses (fragments, 4, 4) and the current lattice; syncs."""
        fragments, device = self.fragments, self.partners.device
        trees = {int(t): PointTree(fragments.part(int(t))) for t in np.unique(self.ends[:, 1])}
        for k, (s, t) in enumerate(self.ends.tolist()):
            T = solve(poses[t], poses[s])
            queries = transform_points(fragments.part(s), T[:3, :3], T[:3, 3])
            if s not in self.orders:
                self.orders[s] = order_along_curve(trees[t], queries)
            nearest = find_nearest(trees[t], queries, radius=self.distance, order=self.orders[s])
            where = [int(fragments.firsts[s]), int(fragments.firsts[t]), int(self.firsts[k])]
            rule = [mat44d(*T.ravel()), self.min_cosine, self.sided]
            launch(pair_points_kernel, queries.size, [nearest, *where, *rule, fragments, self.partners, self.mask])
        positions, starts = positions_and_starts(self.mask, self.firsts)  # sync
        rows = FragmentRows(positions.size, self.device_ends)
        rows.starts = starts
        rows.sums = SegmentBlocks(rows.starts[:-1], np.diff(rows.starts), device)
        tables = [self.firsts[:-1], fragments.firsts[self.ends[:, 0]], rows.starts]
        given = [upload(table.astype(np.int32), int32, device) for table in tables]
        device_poses = upload(np.ascontiguousarray(poses), mat44d, device)
        launch(
            fill_rows_kernel,
            rows.count,
            [positions, self.partners, *given, device_poses, fragments.lattice, fragments, rows],
        )
        rows.sort_by_cell(fragments.lattice.cell_count)
        return rows
