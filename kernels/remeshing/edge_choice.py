"""Edges that collapse at once: none has an end next to an end of another.

The least key of the edges at each vertex is found; an edge whose key is the least at both its ends and at all vertices
around them is looked at, and chosen where it may collapse (Luby, "A simple parallel algorithm for the maximal
independent set problem", 1986, with prices for random numbers). What is next to a chosen edge is out, what may not
collapse is out until something near it moves, and the rest chooses again.
"""

from ..array_types import Bytes, Indices
from ..arrays.packed_keys import NO_KEY
from ..lang import array, atomic_min, func, int32, int64, kernel, launch, tid, uint8
from ..memory import empty, fill
from ..meshes.mesh_topology import corner_vertex, next_corner
from .collapse_mesh import BENDING, EDGES, REFUSED_KEY, STALE_KEY, VERTICES, CollapseMesh
from .edge_prices import may_collapse


@kernel
def take_edges_kernel(
    mesh: CollapseMesh, edges: array(dtype=int32), blocked: array(dtype=uint8), least: array(dtype=int64)
):
    """The least key of the edges at each vertex, of edges with no end blocked; a minimum is the same in any order."""
    i = tid()
    if i >= mesh.numbers[EDGES]:
        return
    h = edges[i]
    key = mesh.keys[h]
    if key < int64(STALE_KEY):
        a = corner_vertex(mesh.triangles, h)
        b = corner_vertex(mesh.triangles, next_corner(h))
        if blocked[a] == 0 and blocked[b] == 0:
            atomic_min(least, a, key)
            atomic_min(least, b, key)


@func
def is_least_around(mesh: CollapseMesh, v: int, key: int64, least: array(dtype=int64)) -> int:
    """1 where no vertex around v has an edge with a lower key."""
    found = 1
    j = mesh.starts[v]
    while j < mesh.starts[v + 1] and found == 1:
        s = mesh.spokes[j]
        if least[s[0]] < key or least[s[1]] < key:
            found = 0
        j += 1
    return found


@func
def block_around(mesh: CollapseMesh, v: int, blocked: array(dtype=uint8)):
    """Block a vertex and those around it; threads that meet write the same."""
    blocked[v] = 1
    for j in range(mesh.starts[v], mesh.starts[v + 1]):
        s = mesh.spokes[j]
        blocked[s[0]] = 1
        blocked[s[1]] = 1


@kernel
def choose_edges_kernel(
    mesh: CollapseMesh,
    edges: array(dtype=int32),
    least: array(dtype=int64),
    keys: array(dtype=int64),
    chosen: array(dtype=uint8),
    blocked: array(dtype=uint8),
):
    """Choose or refuse the edges whose key is the least all around; `keys` are those of the mesh."""
    i = tid()
    if i >= mesh.numbers[EDGES]:
        return
    h = edges[i]
    key = mesh.keys[h]
    a = corner_vertex(mesh.triangles, h)
    b = corner_vertex(mesh.triangles, next_corner(h))
    if least[a] == key and least[b] == key:
        first = is_least_around(mesh, a, key, least)
        if first == 1:
            first = is_least_around(mesh, b, key, least)
        if first == 1:
            if may_collapse(mesh, h, a, b, mesh.numbers[BENDING]) == 1:
                chosen[i] = 1
                block_around(mesh, a, blocked)
                block_around(mesh, b, blocked)
            else:
                keys[h] = int64(REFUSED_KEY)


class EdgeChoice:
    """Room to choose edges.

    Attributes:
        chosen: uint8 mask of edges; zero behind those there are.
    """

    def __init__(self, mesh: CollapseMesh) -> None:
        device = mesh.numbers.device
        self.chosen: Bytes = empty(mesh.keys.size, uint8, device)
        self._least = empty(mesh.positions.size, int64, device)

    def run(self, mesh: CollapseMesh, edges: Indices, turns: int) -> None:
        """Choose edges that may collapse at once; `mesh.touched` becomes 1 for their vertices and those around them.

        Args:
            mesh: CollapseMesh, whose keys of refused edges change.
            edges: int32, the owners of edges to choose from, as many as the record says.
            turns: How often the rest chooses again.
        """
        count, vertices = mesh.live(EDGES, edges.size), mesh.live(VERTICES, mesh.positions.size)
        fill(self.chosen[:count], 0)
        fill(mesh.touched[:vertices], 0)
        least = self._least[:vertices]
        for _ in range(turns):
            fill(least, NO_KEY)
            launch(take_edges_kernel, count, [mesh, edges, mesh.touched, self._least])
            arguments = [mesh, edges, self._least, mesh.keys, self.chosen, mesh.touched]
            launch(choose_edges_kernel, count, arguments)
