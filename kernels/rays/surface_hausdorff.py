"""The largest distance from a surface to another one, between two bounds that close in on each other.

The distance to one triangle is convex, so over a piece of the surface it is largest at a corner; and the distance to
the other surface is at most that to any one of its triangles. So a piece lies within the largest distance of its
corners from the triangle nearest to its middle. What may still lie farther than the farthest point that is known is cut
into four, in rounds, all pieces of a round at once; after a few rounds only those about the farthest points are left.
(Tang, Lee and Kim, "Interactive Hausdorff distance computation for general polygonal models", SIGGRAPH 2009, bounds
alike.) 60 B a piece.
"""

import math

from ..algebra.transform import narrow, widen
from ..array_types import Doubles, Points, Triangles
from ..arrays.select import positions_of
from ..extent.distance_sums import summarize_distances
from ..lang import (
    array,
    atomic_max,
    float64,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    reduce,
    reduction,
    sqrt,
    tid,
    uint8,
    vec2d,
    vec3,
    vec3i,
)
from ..memory import download, empty, full, zeros
from ..meshes.mesh_edits import mark_referenced_kernel
from .nearest_triangle import NearestTriangles
from .point_triangle import measure_triangle
from .triangle_tree import TriangleTree

MOST_PIECES = 2**22  # of a round: about 250 MB
ROUNDS = 24  # a float32 has as many bits to halve


@kernel
def take_roots_kernel(sqdists: array(dtype=float64), points: array(dtype=vec3), distances: array(dtype=float64)):
    """Distances from squared ones; NaN for points that are not finite."""
    i = tid()
    p = points[i]
    distances[i] = sqrt(sqdists[i]) + float64((p[0] - p[0]) + (p[1] - p[1]) + (p[2] - p[2]))  # zero, or NaN


@reduction
def square_distance(distances: array(dtype=float64)) -> vec2d:
    """The square of each distance."""
    i = tid()
    return vec2d(distances[i] * distances[i], 0.0)


@kernel
def find_farthest_vertex_kernel(distances: array(dtype=float64), used: array(dtype=int32), known: array(dtype=float64)):
    """The largest finite distance of a vertex that triangles use; the atomic settles which."""
    i = tid()
    if used[i] == 1 and isfinite(distances[i]):
        atomic_max(known, 0, distances[i])


@kernel
def list_pieces_kernel(vertices: array(dtype=vec3), triangles: array(dtype=vec3i), pieces: array(dtype=vec3)):
    """The corners of triangles."""
    i = tid()
    t = triangles[i]
    for k in range(3):
        pieces[3 * i + k] = vertices[t[k]]


@kernel
def find_piece_middles_kernel(pieces: array(dtype=vec3), middles: array(dtype=vec3)):
    """The middle of each piece."""
    i = tid()
    total = widen(pieces[3 * i]) + widen(pieces[3 * i + 1]) + widen(pieces[3 * i + 2])
    middles[i] = narrow(total / 3.0)


@func
def measure_row(p: vec3, vertices: array(dtype=vec3), t: vec3i) -> float64:
    """The squared distance of a point from a triangle."""
    found = measure_triangle(widen(p), widen(vertices[t[0]]), widen(vertices[t[1]]), widen(vertices[t[2]]))
    return found[3]


@kernel(most_registers=128)  # two blocks of an SM, not one
def bound_pieces_kernel(
    pieces: array(dtype=vec3),
    nearest: NearestTriangles,
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    bounds: array(dtype=float64),
    known: array(dtype=float64),
):
    """How far a piece reaches at most; its middle is a point that is known. The atomic settles the largest."""
    i = tid()
    bounds[i] = -1.0
    row = nearest.triangles[i]
    if row >= 0:
        t = triangles[row]
        most = float64(0.0)
        corners = int(3)
        for k in range(corners):
            most = max(most, measure_row(pieces[3 * i + k], vertices, t))
        bounds[i] = sqrt(most)
        atomic_max(known, 0, sqrt(nearest.sqdists[i]))


@kernel
def mark_far_pieces_kernel(bounds: array(dtype=float64), limit: float64, mask: array(dtype=uint8)):
    """1 where a piece may reach beyond a limit."""
    i = tid()
    mask[i] = uint8(1 if bounds[i] > limit else 0)


@kernel
def cut_pieces_kernel(pieces: array(dtype=vec3), rows: array(dtype=int32), cut: array(dtype=vec3)):
    """Each piece in four, at the middles of its edges."""
    i = tid()
    a = pieces[3 * rows[i]]
    b = pieces[3 * rows[i] + 1]
    c = pieces[3 * rows[i] + 2]
    ab = narrow((widen(a) + widen(b)) * 0.5)
    bc = narrow((widen(b) + widen(c)) * 0.5)
    ca = narrow((widen(c) + widen(a)) * 0.5)
    at = 12 * i
    for k in range(4):
        p = ab + vec3(0.0, 0.0, 0.0)
        q = bc + vec3(0.0, 0.0, 0.0)
        r = ca + vec3(0.0, 0.0, 0.0)
        if k == 1:
            p = a + vec3(0.0, 0.0, 0.0)
            q = ab + vec3(0.0, 0.0, 0.0)
        if k == 2:
            p = b + vec3(0.0, 0.0, 0.0)
            r = ab + vec3(0.0, 0.0, 0.0)
        if k == 3:
            p = c + vec3(0.0, 0.0, 0.0)
            q = ca + vec3(0.0, 0.0, 0.0)
            r = bc + vec3(0.0, 0.0, 0.0)
        cut[at + 3 * k] = p
        cut[at + 3 * k + 1] = q
        cut[at + 3 * k + 2] = r


def distances_to(points: Points, tree: TriangleTree) -> Doubles:
    """The distances [m] of vec3 points about a tree's origin from its triangles, float64.

    Infinite where there are none or they lie 1.8e19 m away, NaN for points that are not finite.
    """
    nearest = NearestTriangles(points)
    nearest.look_into(tree, points, 0)
    distances = empty(points.size, float64, points.device)
    launch(take_roots_kernel, points.size, [nearest.sqdists, points, distances])
    return distances


def root_mean_square(distances: Doubles) -> float:
    """The root of the mean square of float64 distances, all finite."""
    total = download(reduce(square_distance, distances.size, [distances]))[0][0]  # sync
    return math.sqrt(float(total) / distances.size)


def farthest_distance(
    vertices: Points, triangles: Triangles, tree: TriangleTree, known_distance: float, tolerance: float
) -> tuple[float, float]:
    """Bounds of the largest distance [m] of the points of a mesh from another one.

    Args:
        vertices: Device array of vec3, about the other mesh's origin.
        triangles: Device array of vec3i.
        tree: The other mesh's TriangleTree.
        known_distance: A distance that some point of the mesh has.
        tolerance: How far the bounds may be apart.

    Returns:
        (least, most): a distance that some point has, and one that none exceeds. They are farther apart than the
        tolerance only where MOST_PIECES would not do.
    """
    device = vertices.device
    known = full(1, known_distance, float64, device)
    used = zeros(vertices.size, int32, device)
    launch(mark_referenced_kernel, triangles.size, [triangles, used])
    launch(find_farthest_vertex_kernel, vertices.size, [distances_to(vertices, tree), used, known])
    pieces = empty(3 * triangles.size, vec3, device)
    launch(list_pieces_kernel, triangles.size, [vertices, triangles, pieces])
    least = most = 0.0
    for _ in range(ROUNDS):
        count = pieces.size // 3
        middles, bounds = empty(count, vec3, device), empty(count, float64, device)
        mask = empty(count, uint8, device)
        launch(find_piece_middles_kernel, count, [pieces, middles])
        nearest = NearestTriangles(middles)
        nearest.look_into(tree, middles, 0)
        launch(bound_pieces_kernel, count, [pieces, nearest, tree.vertices, tree.triangles, bounds, known])
        least = float(download(known)[0])  # sync
        most = max(summarize_distances(bounds, [])[2], least)  # sync
        launch(mark_far_pieces_kernel, count, [bounds, least + tolerance, mask])
        rows = positions_of(mask)  # sync
        if most <= least + tolerance or 4 * rows.size > MOST_PIECES:
            return least, most
        whole, pieces = pieces, empty(12 * rows.size, vec3, device)
        launch(cut_pieces_kernel, rows.size, [whole, rows, pieces])
    return least, most
