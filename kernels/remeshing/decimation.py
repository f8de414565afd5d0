"""A mesh with fewer triangles: edges collapse in rounds, the cheapest first.

Garland and Heckbert, "Surface simplification using quadric error metrics", 1997, in rounds: edges near what moved are
priced, those up to a limit that leaves out most are looked at, and of them a set collapses in which no edge is next to
another.
"""

import numpy as np

from ..arrays.bounds import bound_points
from ..arrays.packed_keys import NO_KEY
from ..arrays.select import gather_rows, positions_of
from ..lang import array, float64, int32, int64, kernel, launch, tid, uint8, vec3, vec3d
from ..memory import clone, download, empty, full, zeros
from .collapse_mesh import MOVED, CollapseMesh
from .edge_choice import choose_edges
from .edge_collapse import cheapest_edges, collapse_edges
from .edge_prices import BIN_SHIFT, BINS, mark_cheap_edges_kernel, price_edges_kernel, sum_quadrics_kernel
from .quadrics import quadric

SHARE = 0.2  # of all edges that may collapse those that are looked at in a round: more is faster and less exact
LEAST = 32  # edges are looked at in any case
TURNS = 3  # of choosing a round
LEFT = 0.75  # of the triangles: where fewer are left, what is gone is squeezed out

import os, time
T = {}
def tick(name, t0):
    t = time.perf_counter(); T[name] = T.get(name, 0) + t - t0
    return t


@kernel
def scale_points_kernel(points: array(dtype=vec3), center: vec3d, scale: float64, scaled: array(dtype=vec3d)):
    """Points in a box of one unit about zero; exact, since the scale is a power of two."""
    i = tid()
    p = points[i]
    scaled[i] = (vec3d(float64(p[0]), float64(p[1]), float64(p[2])) - center) * scale


@kernel
def unscale_points_kernel(scaled: array(dtype=vec3d), center: vec3d, scale: float64, points: array(dtype=vec3)):
    """The points as they were."""
    i = tid()
    p = scaled[i] / scale + center
    points[i] = vec3(float(p[0]), float(p[1]), float(p[2]))


class Frame:
    """The box of finite points.

    Attributes:
        center: vec3d.
        scale: A power of two.
    """

    def __init__(self, points):
        low, high, count = bound_points(points)  # sync
        low, high = low.astype(np.float64), high.astype(np.float64)
        extent = float((high - low).max()) if count else 0.0
        self.scale = 2.0 ** -np.ceil(np.log2(extent)) if extent > 0 else 1.0
        self.center = vec3d(*(((low + high) / 2).astype(np.float32) if count else np.zeros(3)))

    def scaled(self, points):
        """vec3d of vec3."""
        scaled = empty(points.size, vec3d, points.device)
        launch(scale_points_kernel, points.size, [points, self.center, self.scale, scaled])
        return scaled

    def unscaled(self, scaled):
        """vec3 of vec3d."""
        points = empty(scaled.size, vec3, scaled.device)
        launch(unscale_points_kernel, points.size, [scaled, self.center, self.scale, points])
        return points


def price_limit(bins, share):
    """The largest key of edges to be looked at, -1 where there are none; bins are counts of prices."""
    counts = np.cumsum(download(bins), dtype=np.int64)  # sync
    if counts[-1] == 0:
        return -1
    last = int(np.searchsorted(counts, min(max(share * counts[-1], LEAST), counts[-1])))
    return ((last + 1) << (BIN_SHIFT + 32)) - 1


def decimate(vertices, triangles, target, share=None, turns=None):
    share = share or SHARE
    turns = turns or TURNS
    device = vertices.device
    frame = Frame(vertices)
    t0 = time.perf_counter()
    mesh = CollapseMesh(frame.scaled(vertices), triangles, None, None, [])
    t0 = tick("init", t0)
    mesh.quadrics = empty(vertices.size, quadric, device)
    mesh.keys = full(3 * triangles.size, NO_KEY, int64, device)
    mesh.find_features(True)
    launch(sum_quadrics_kernel, vertices.size, [mesh, 1.0, mesh.quadrics])
    t0 = tick("init2", t0)
    rounds = 0
    while mesh.triangle_count > target:
        t0 = time.perf_counter()
        if rounds:
            mesh.find_features(True)
        t0 = tick("features", t0)
        bins = zeros(BINS, int32, device)
        launch(price_edges_kernel, mesh.keys.size, [mesh, np.inf, mesh.keys, bins])
        t0 = tick("price", t0)
        limit = price_limit(bins, share)
        if limit < 0:
            break
        mask = empty(mesh.keys.size, uint8, device)
        launch(mark_cheap_edges_kernel, mask.size, [mesh.keys, limit, mask])
        edges = positions_of(mask)
        t0 = tick("mark", t0)
        chosen, touched = choose_edges(mesh, edges, turns, False)
        t0 = tick("choose", t0)
        edges = gather_rows(edges, positions_of(chosen))
        if 2 * edges.size > mesh.triangle_count - target:
            edges = cheapest_edges(mesh, edges, mesh.triangle_count - target)
        t0 = tick("cut", t0)
        collapse_edges(mesh, edges, [], touched)
        t0 = tick("collapse", t0)
        if mesh.triangle_count < LEFT * mesh.triangles.size or mesh.triangle_count <= target:
            mesh.squeeze()
        t0 = tick("squeeze", t0)
        rounds += 1
    mesh.squeeze()
    return frame.unscaled(mesh.positions), mesh.triangles, rounds
