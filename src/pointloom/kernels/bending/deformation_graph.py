"""Embedded deformation of points, normals and volumes (Sumner, Schmid and Pauly, "Embedded deformation for shape
manipulation", SIGGRAPH 2007, eqs. 1 to 3) with rotations instead of affine maps.

A point moves by the weighted mean of R (p - g) + c over near nodes, with weights (1 - d / D)^2, D being the distance of
the first excluded node. Nodes with common points are neighbors.
"""

from typing import Any

from ..algebra.transform import distance_between, narrow, widen
from ..array_types import Array1, Doubles, Indices, Points, Positions, Scalars, Vectors
from ..arrays.unique import UniqueKeys
from ..lang import (
    array,
    compute,
    cross,
    dot,
    float32,
    float64,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    mat33d,
    outer,
    sqrt,
    struct,
    tid,
    vec3,
    vec3d,
)
from ..memory import empty, flat
from ..meshes.vertex_neighbors import VertexNeighbors
from ..search.point_tree import PointTree
from ..search.tree_search import search_nearest

NODES_PER_POINT = 4  # nodes that influence a point, as in the paper
LISTED_NODES = 5  # plus the next one, where the weight becomes zero
MEMBER_PAIRS = 6  # pairs of members
FEW_NODES_RADIUS = 2.0  # with fewer nodes, weights vanish at this multiple of the farthest distance


@struct
class DeformationGraph:
    """Nodes and their motion: `nodes` about the body's origin, `centers` about the target's."""

    nodes: array(dtype=vec3)
    rotations: array(dtype=mat33d)
    centers: array(dtype=vec3d)
    listed: int

    def __init__(self, nodes: Points, rotations: Array1[mat33d], centers: Positions) -> None:
        self.nodes, self.rotations, self.centers = nodes, rotations, centers
        self.count, self.listed = nodes.size, min(LISTED_NODES, nodes.size)
        self.tree = PointTree(nodes)


@struct
class Influence:
    """Nodes of points: `near` (n listed); influencing `members` (four each); `fractions`: weights, 0 if missing."""

    points: array(dtype=vec3)
    near: array(dtype=int32)
    members: array(dtype=int32)
    fractions: array(dtype=float64)

    def __init__(self, points: Points, graph: DeformationGraph) -> None:
        count, device = points.size, points.device
        self.points, self.count = points, count
        self.near = flat(search_nearest(graph.tree, points, graph.listed)[0])
        listed = NODES_PER_POINT * count
        self.members, self.fractions = empty(listed, int32, device), empty(listed, float64, device)
        launch(share_nodes_kernel, count, [graph, self])


@func
def end_of_weights(p: vec3d, first: int, near: array(dtype=int32), graph: DeformationGraph) -> float64:
    """Distance of zero weight."""
    farthest = distance_between(p, widen(graph.nodes[near[first + graph.listed - 1]]))
    return farthest if graph.listed == LISTED_NODES else float64(FEW_NODES_RADIUS) * farthest


@func
def members_of(listed: int) -> int:
    return min(listed, NODES_PER_POINT)


@kernel
def share_nodes_kernel(graph: DeformationGraph, influence: Influence):
    """Nodes of a point and their weights. Only the nearest if all are equally far."""
    i = tid()
    p = widen(influence.points[i])
    first = graph.listed * i
    n = int(NODES_PER_POINT)
    for k in range(n):
        influence.members[NODES_PER_POINT * i + k] = 0
        influence.fractions[NODES_PER_POINT * i + k] = 0.0
    if isfinite(p) and influence.near[first] >= 0:
        end = end_of_weights(p, first, influence.near, graph)
        total = float64(0.0)
        for k in range(members_of(graph.listed)):
            node = influence.near[first + k]
            influence.members[NODES_PER_POINT * i + k] = node
            weight = float64(0.0)
            if end > 0.0:
                weight = max(1.0 - distance_between(p, widen(graph.nodes[node])) / end, 0.0)
            influence.fractions[NODES_PER_POINT * i + k] = weight * weight
            total += weight * weight
        if total > 0.0:
            for k in range(n):
                influence.fractions[NODES_PER_POINT * i + k] = influence.fractions[NODES_PER_POINT * i + k] / total
        else:
            influence.fractions[NODES_PER_POINT * i] = 1.0


@func
def deformed_position(i: int, graph: DeformationGraph, influence: Influence) -> vec3d:
    p = widen(influence.points[i])
    total = vec3d(0.0, 0.0, 0.0)
    n = int(NODES_PER_POINT)
    for k in range(n):
        fraction = influence.fractions[NODES_PER_POINT * i + k]
        if fraction > 0.0:
            node = influence.members[NODES_PER_POINT * i + k]
            total += fraction * (graph.rotations[node] @ (p - widen(graph.nodes[node])) + graph.centers[node])
    return total


@func
def slope_at(i: int, graph: DeformationGraph, influence: Influence) -> mat33d:
    p = widen(influence.points[i])
    here = deformed_position(i, graph, influence)
    zero = float64(0.0)
    slope = mat33d(zero, zero, zero, zero, zero, zero, zero, zero, zero)
    first = graph.listed * i
    end = end_of_weights(p, first, influence.near, graph)
    last = widen(graph.nodes[influence.near[first + graph.listed - 1]])
    beyond = distance_between(p, last)
    end_slope = vec3d(0.0, 0.0, 0.0)
    if beyond > 0.0:
        end_slope = (end / (beyond * beyond)) * (p - last)
    total = float64(0.0)
    pulls = mat33d(zero, zero, zero, zero, zero, zero, zero, zero, zero)
    for k in range(members_of(graph.listed)):
        node = influence.near[first + k]
        fraction = influence.fractions[NODES_PER_POINT * i + k]
        arm = p - widen(graph.nodes[node])
        away = sqrt(dot(arm, arm))
        slope = slope + fraction * graph.rotations[node]
        if end > 0.0 and away < end:
            along = (away / (end * end)) * end_slope
            if away > 0.0:
                along = along - (1.0 / (end * away)) * arm
            change = (2.0 * (1.0 - away / end)) * along
            pulls = pulls + outer(graph.rotations[node] @ arm + graph.centers[node] - here, change)
            total += (1.0 - away / end) * (1.0 - away / end)
    if total > 0.0:
        slope = slope + pulls * (1.0 / total)
    return slope


@func
def volume_of(slope: mat33d) -> float64:
    x = vec3d(slope[0, 0], slope[0, 1], slope[0, 2])
    y = vec3d(slope[1, 0], slope[1, 1], slope[1, 2])
    z = vec3d(slope[2, 0], slope[2, 1], slope[2, 2])
    return dot(x, cross(y, z))


@func
def deformed_normal(slope: mat33d, normal: vec3d) -> vec3d:
    """Normal under the cofactors of a Jacobian, with its length kept."""
    x = vec3d(slope[0, 0], slope[0, 1], slope[0, 2])
    y = vec3d(slope[1, 0], slope[1, 1], slope[1, 2])
    z = vec3d(slope[2, 0], slope[2, 1], slope[2, 2])
    deformed = vec3d(dot(cross(y, z), normal), dot(cross(z, x), normal), dot(cross(x, y), normal))
    size = dot(deformed, deformed)
    scale = float64(0.0)
    if size > 0.0:
        scale = sqrt(dot(normal, normal) / size)
    return scale * deformed


@kernel
def bend_points_kernel(graph: DeformationGraph, influence: Influence, moved: array(dtype=vec3)):
    i = tid()
    p = influence.points[i]
    q = p + vec3(0.0, 0.0, 0.0)
    if isfinite(p):
        q = narrow(deformed_position(i, graph, influence))
    moved[i] = q


@kernel
def bend_wide_kernel(graph: DeformationGraph, influence: Influence, origin: vec3d, moved: array(dtype=vec3d)):
    i = tid()
    p = influence.points[i]
    q = widen(p)
    if isfinite(p):
        q = deformed_position(i, graph, influence) + origin
    moved[i] = q


@kernel
def bend_normals_kernel(
    graph: DeformationGraph, influence: Influence, normals: array(dtype=vec3), bent: array(dtype=vec3)
):
    i = tid()
    n = normals[i]
    m = n + vec3(0.0, 0.0, 0.0)
    if isfinite(influence.points[i]):
        deformed = narrow(deformed_normal(slope_at(i, graph, influence), widen(n)))
        if dot(deformed, deformed) > 0.0:
            m = deformed
    bent[i] = m


@kernel
def measure_volumes_kernel(graph: DeformationGraph, influence: Influence, volumes: array(dtype=float32)):
    """Volume ratio at each point, negative if the deformation folds over, NaN for invalid points."""
    i = tid()
    p = influence.points[i]
    volume = p[0] + p[1] + p[2]  # NaN or infinite: no volume
    if isfinite(p):
        volume = float(volume_of(slope_at(i, graph, influence)))
    volumes[i] = volume


def bend_points(graph: DeformationGraph, influence: Influence) -> Points:
    """Deformed points, vec3 about the origin of the graph's centers."""
    return compute(bend_points_kernel, influence.count, [graph, influence], vec3, influence.points.device)


def bend_wide(graph: DeformationGraph, influence: Influence, origin: Any) -> Positions:
    moved = empty(influence.count, vec3d, influence.points.device)
    launch(bend_wide_kernel, influence.count, [graph, influence, vec3d(*origin), moved])
    return moved


def bend_normals(graph: DeformationGraph, influence: Influence, normals: Vectors) -> Vectors:
    """Deformed normals at undeformed points."""
    return compute(bend_normals_kernel, influence.count, [graph, influence, normals], vec3, influence.points.device)


def measure_volumes(graph: DeformationGraph, influence: Influence) -> Scalars:
    """Volume ratios, float32 (n)."""
    return compute(measure_volumes_kernel, influence.count, [graph, influence], float32, influence.points.device)


@kernel
def key_neighbors_kernel(influence: Influence, bits: int, keys: array(dtype=int64)):
    """Keys of node pairs that share a point, lower first. The maximum for none."""
    i = tid()
    none = (int64(1) << int64(2 * bits)) - 1
    at = MEMBER_PAIRS * i
    n = int(NODES_PER_POINT)
    first = n * i
    for a in range(n):
        for b in range(a + 1, n):
            key = none
            if influence.fractions[first + a] > 0.0 and influence.fractions[first + b] > 0.0:
                low = min(influence.members[first + a], influence.members[first + b])
                high = max(influence.members[first + a], influence.members[first + b])
                key = (int64(low) << int64(bits)) | int64(high)
            keys[at] = key
            at += 1


@kernel
def split_neighbors_kernel(keys: array(dtype=int64), bits: int, lows: array(dtype=int32), highs: array(dtype=int32)):
    i = tid()
    lows[i] = int(keys[i] >> int64(bits))
    highs[i] = int(keys[i] & ((int64(1) << int64(bits)) - 1))


class NodePairs:
    """Nodes with common points: `lows`, `highs` (int32 (e), ascending) and `count`."""

    lows: Indices
    highs: Indices

    def __init__(self, graph: DeformationGraph, influence: Influence) -> None:
        device, bits = graph.nodes.device, max(1, graph.count.bit_length())
        keys = empty(MEMBER_PAIRS * influence.count, int64, device)
        launch(key_neighbors_kernel, influence.count, [influence, bits, keys])
        unique = UniqueKeys(keys, 2 * bits)  # sync
        unique.drop_last((1 << (2 * bits)) - 1)
        self.count = unique.count
        self.lows, self.highs = empty(self.count, int32, device), empty(self.count, int32, device)
        launch(split_neighbors_kernel, self.count, [unique.keys, bits, self.lows, self.highs])


def neighbors_of(graph: DeformationGraph, influence: Influence) -> VertexNeighbors:
    return VertexNeighbors(NodePairs(graph, influence), graph.count)


@kernel
def measure_strain_kernel(graph: DeformationGraph, around: VertexNeighbors, strains: array(dtype=float64)):
    """Relative deviation of a node's neighbors from its rotation, or -1 without neighbors."""
    i = tid()
    squares = float64(0.0)
    length = float64(0.0)
    for j in range(around.starts[i], around.starts[i + 1]):
        k = around.vertices[j]
        rest = widen(graph.nodes[k]) - widen(graph.nodes[i])
        d = graph.rotations[i] @ rest + graph.centers[i] - graph.centers[k]
        squares += dot(d, d)
        length += dot(rest, rest)
    strain = float64(-1.0)
    if length > 0.0:
        strain = sqrt(squares / length)
    strains[i] = strain


def measure_strain(graph: DeformationGraph, around: VertexNeighbors) -> Doubles:
    """Strain of the graph at each node, float64 (m): 0 for pure bending, -1 without neighbors."""
    return compute(measure_strain_kernel, graph.count, [graph, around], float64, graph.nodes.device)
