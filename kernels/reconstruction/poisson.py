"""A surface from oriented points by the screened Poisson equation: the passes in their order.

Samples by cell (`sample_cells`), the tree grown level by level to where they end (`octree_levels`, `sample_density`),
the equation of each level (`poisson_system`), its solution from coarse to fine (`poisson_solver`), the surface through
the samples' mean value (`octree_surface`), and how dense they lie there.

Kazhdan and Hoppe, "Screened Poisson surface reconstruction", ACM TOG 32(3), 2013.
"""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from ..array_types import Indices, Points, Scalars, Triangles, Vectors
from ..lang import float64, int32, pow, reduce, reduction, tid, vec2d
from ..memory import check_room, empty, fill
from .envelope import Envelope
from .octree_levels import divide, first_levels, next_level
from .octree_surface import OctreeSurface
from .poisson_solver import mean_at_samples, solve, sum_levels
from .poisson_system import constraints
from .sample_cells import Cube, SampleCells, gather_samples
from .sample_density import ENDS, DensityPyramid, SampleReach, local_depths

FULL_DEPTH = 5  # up to this level all cells are divided: the function is sought in the whole cube
BLOCK_BYTES = 800  # of a block of eight slots, in all arrays that live together, the surface's part included
SAMPLE_BYTES = 90  # of a sample on the finest level, with what its cells of the levels above take


@reduction
def sum_areas(cells: SampleCells, reach: SampleReach) -> vec2d:
    """(area, weight) of the samples of cells that end on a level; areas in faces of the cube."""
    i = tid()
    area = float64(0.0)
    weight = float64(0.0)
    if reach.states[i] == ENDS:
        area = float64(cells.weights[i]) * float64(pow(4.0, -reach.depths[i]))
        weight = float64(cells.weights[i])
    return vec2d(area, weight)


class PoissonSurface(NamedTuple):
    """What the equation gives.

    Attributes:
        vertices, normals: vec3 [m].
        triangles: vec3i [t].
        densities: float32 [m], local depths.
        depth: The finest level that the tree came to.
    """

    vertices: Points
    normals: Vectors
    triangles: Triangles
    densities: Scalars
    depth: int


def grow_tree(
    cells: Sequence[SampleCells], sample_count: int, deepest: int, kernel_depth: int, samples_per_cell: float
) -> DensityPyramid:
    """The tree over samples, as a DensityPyramid.

    Raises:
        MemoryError: The device has no room for the next level; nothing of it was allocated.
    """
    device = cells[0].codes.device
    pyramid = DensityPyramid(cells, sample_count, deepest, kernel_depth, samples_per_cell)
    above, level = first_levels(device)
    while level is not None:
        growing = pyramid.enter(level, above)
        if level.depth == deepest:
            break
        is_full = level.depth < FULL_DEPTH
        divide(level, None if is_full else growing)
        above, level = level, next_level(level, BLOCK_BYTES, is_full)  # sync beyond the full levels
    return pyramid


def reconstruct_poisson(
    points: Points,
    normals: Vectors,
    rows: Indices,
    cube: Cube,
    depth: int,
    *,
    is_linear: bool,
    point_weight: float,
    samples_per_cell: float,
    by_length: bool,
    envelope: Envelope | None = None,
    progress: Callable[[str, int, int], None] | None = None,
) -> PoissonSurface:
    """The surface of oriented points.

    Args:
        points, normals: vec3 device arrays.
        rows: int32, those that count: a finite point and a finite normal that is not zero.
        cube: A Cube around the points that count.
        depth: The finest level that the tree may have, at least 2.
        is_linear: Place vertices linearly between corners.
        point_weight: How much the samples pull.
        samples_per_cell: Points in a cell where the tree ends.
        by_length: A normal's length is its weight.
        envelope: An Envelope that the surface does not leave, or None.
        progress: Called with each stage, how many of its steps are done, and how many there are.

    Raises:
        MemoryError: The device has no room for the tree.
        ValueError: More triangles than 32 bits count.
    """
    check_room(points.device, rows.size * SAMPLE_BYTES, f"the cells of {rows.size:,} points")
    cells = gather_samples(points, normals, rows, cube, depth, by_length)
    pyramid = grow_tree(cells, rows.size, depth, max(1, depth - 2), samples_per_cell)
    areas = sum_levels([reduce(sum_areas, c.count, [c, r]) for c, r in pyramid.pairs()])
    tests = constraints(pyramid)
    solutions = solve(pyramid, tests, point_weight, areas, cube, envelope, progress)
    del tests
    if progress is not None:
        progress("surface", 0, 0)
    iso = mean_at_samples(pyramid, solutions)
    surface = OctreeSurface(pyramid.levels, solutions, iso, cube, is_linear)
    depths = empty(surface.slots.size, int32, points.device)
    for level, first, last in surface.ranges:
        if last > first:
            fill(depths[first:last], level)
    densities = local_depths(pyramid, surface.places, surface.slots, depths)
    return PoissonSurface(surface.vertices, surface.normals, surface.triangles, densities, len(pyramid.levels) - 1)
