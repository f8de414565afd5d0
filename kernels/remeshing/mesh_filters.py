"""Values at vertices smoothed or sharpened along the edges of a mesh, pass by pass.

A pass reads the values of the pass before and sums over the neighbours of each vertex in ascending order, in float64
throughout; the end alone is rounded. A neighbour that is not finite is left out, and a vertex that is not finite or has
no neighbours stays. Per pass and array 24 B read and written a vertex, and 28 B read a neighbour. Source: Taubin, "A
signal processing approach to fair surface design", SIGGRAPH 1995; weights after Open3D.
"""

from collections.abc import Iterable

from ..array_types import Positions, Triangles
from ..lang import Kernel, array, dot, float64, func, isfinite, kernel, launch, sqrt, struct, tid, vec3d
from ..memory import empty
from ..meshes.mesh_edges import MeshEdges
from ..meshes.vertex_neighbors import VertexNeighbors

NEAREST = 1.0e-12  # added to distances [m] in weights, so that vertices at one place have a finite one


@struct
class FilterPass:
    """What a pass works on.

    Attributes:
        around: The neighbours of each vertex.
        positions: vec3d [m], which weights are taken from.
    """

    around: VertexNeighbors
    positions: array(dtype=vec3d)

    def __init__(self, around: VertexNeighbors, positions: Positions) -> None:
        self.around, self.positions = around, positions


@kernel
def average_kernel(rule: FilterPass, values: array(dtype=vec3d), factor: float64, out: array(dtype=vec3d)):
    """The mean of a vertex and its neighbours."""
    i = tid()
    own = values[i]
    total = own + vec3d(0.0, 0.0, 0.0)
    count = float64(1.0)
    for j in range(rule.around.starts[i], rule.around.starts[i + 1]):
        value = values[rule.around.vertices[j]]
        if isfinite(value):
            total = total + value
            count += 1.0
    if isfinite(own):
        own = total / count
    out[i] = own


@kernel
def sharpen_kernel(rule: FilterPass, values: array(dtype=vec3d), factor: float64, out: array(dtype=vec3d)):
    """A vertex moved away from its neighbours: by `factor` times the sum of its differences from them."""
    i = tid()
    own = values[i]
    away = vec3d(0.0, 0.0, 0.0)
    for j in range(rule.around.starts[i], rule.around.starts[i + 1]):
        value = values[rule.around.vertices[j]]
        if isfinite(value):
            away = away + (own - value)
    if isfinite(own):
        own = own + factor * away
    out[i] = own


@func
def inverse_distance(p: vec3d, q: vec3d) -> float64:
    """The weight of a neighbour at q; zero where either is not finite."""
    d = q - p
    sqdist = dot(d, d)
    weight = float64(0.0)
    if isfinite(sqdist):
        weight = 1.0 / (sqrt(sqdist) + float64(NEAREST))
    return weight


@kernel
def approach_mean_kernel(rule: FilterPass, values: array(dtype=vec3d), factor: float64, out: array(dtype=vec3d)):
    """A vertex moved the share `factor` of the way to the mean of its neighbours, nearer ones with more weight."""
    i = tid()
    own = values[i]
    way = vec3d(0.0, 0.0, 0.0)
    weights = float64(0.0)
    for j in range(rule.around.starts[i], rule.around.starts[i + 1]):
        neighbor = rule.around.vertices[j]
        weight = inverse_distance(rule.positions[i], rule.positions[neighbor])
        value = values[neighbor]
        if weight > 0.0 and isfinite(value):
            way = way + weight * (value - own)
            weights += weight
    if isfinite(own) and weights > 0.0:
        own = own + factor * (way / weights)
    out[i] = own


def filter_values(
    triangles: Triangles,
    positions: Positions,
    names: Iterable[str],
    wide: dict[str, Positions],
    passes: Iterable[tuple[Kernel, float]],
) -> dict[str, Positions]:
    """Run passes over values at vertices.

    Args:
        triangles: vec3i [t].
        positions: vec3d [m].
        names: Of the values; those of "vertices" are the positions of the next pass.
        wide: vec3d [m] arrays by name.
        passes: (kernel, factor) of each.

    Returns:
        The values by name, vec3d [m]. One sync for the edges.
    """
    around = VertexNeighbors(MeshEdges(triangles, positions.size), positions.size)
    values = {name: wide[name] for name in names}
    for kernel_of_pass, factor in passes:
        rule = FilterPass(around, values.get("vertices", positions))
        for name, before in list(values.items()):
            after = empty(before.size, vec3d, before.device)
            launch(kernel_of_pass, before.size, [rule, before, factor, after])
            values[name] = after
    return values
