"""Mesh decimation by rounds of edge collapses with quadric error metrics.

Garland and Heckbert, "Surface simplification using quadric error metrics", 1997. Each round considers the cheaper third
of the edges and collapses an independent set, about 6% of the vertices, close to the order of a queue: 25 rounds to a
tenth. 200 B per triangle and round.
"""

from collections.abc import Sequence

import numpy as np

from ..array_types import Array1, Indices, Integers, Points, Triangles, Vectors
from ..arrays.packed_keys import NO_KEY, pack_key
from ..arrays.select import gather_rows, positions_of
from ..arrays.sort import argsort_keys
from ..lang import array, compute, cross, int32, int64, kernel, launch, length, tid, uint8, vec2
from ..memory import clone, download, empty, full
from ..meshes.mesh_edits import gather_corners
from .collapse_mesh import TRIANGLE_COUNT, VERTEX_COUNT, CollapseMesh, edge_valence
from .collapse_rounds import CollapseRounds
from .edge_costs import sum_quadrics_kernel
from .quadrics import quadric
from .unit_frame import UnitFrame


@kernel
def mark_valid_kernel(mesh: CollapseMesh, mask: array(dtype=uint8)):
    i = tid()
    t = mesh.triangles[i]
    valid = 1
    if t[0] == t[1] or t[1] == t[2] or t[2] == t[0]:
        valid = 0
    for j in range(mesh.starts[t[0]], mesh.starts[t[0] + 1]):
        s = mesh.spokes[j]
        if s[0] == t[1] and s[1] == t[2] and mesh.corners[j] // 3 < i:
            valid = 0
    mask[i] = uint8(valid)


@kernel
def measure_lone_kernel(mesh: CollapseMesh, keys: array(dtype=int64)):
    """Area and index key of each triangle without neighbors. NO_KEY for others."""
    i = tid()
    t = mesh.triangles[i]
    key = int64(NO_KEY)
    if edge_valence(mesh, t[0], t[1]) + edge_valence(mesh, t[1], t[2]) + edge_valence(mesh, t[2], t[0]) == 3:
        p = mesh.positions[t[0]]
        area = length(cross(mesh.positions[t[1]] - p, mesh.positions[t[2]] - p))
        key = pack_key(0.0, i)
        if area > 0.0:
            key = pack_key(float(area), i)
    keys[i] = key


@kernel
def keep_lone_kernel(keys: array(dtype=int64), order: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    if keys[i] != int64(NO_KEY):
        mask[order[i]] = uint8(0)


class Decimation:
    """Decimation to `target` triangles. `per_vertex` are vec3 [m] arrays, vertices first; `unit` marks unit vectors.
    `max_error` limits the error (area times squared distance). `border_weight` scales the planes along features."""

    def __init__(
        self,
        triangles: Triangles,
        per_vertex: Sequence[Points],
        unit: Sequence[bool],
        uvs: Array1[vec2] | None,
        materials: Integers | None,
        target: int,
        max_error: float,
        border_weight: float,
    ) -> None:
        self.frame, self.unit, self.target = UnitFrame(per_vertex[0]), unit, target
        self.max_error = max_error * self.frame.scale**4
        mesh = self._valid_mesh(triangles, per_vertex, uvs, materials)
        device = triangles.device
        mesh.quadrics = empty(mesh.positions.size, quadric, device)
        mesh.find_all_features()
        launch(sum_quadrics_kernel, mesh.positions.size, [mesh, border_weight, mesh.quadrics])
        self.mesh = mesh

    def _valid_mesh(
        self, triangles: Triangles, per_vertex: Sequence[Points], uvs: Array1[vec2] | None, materials: Integers | None
    ) -> CollapseMesh:
        positions = self.frame.scaled(per_vertex[0])
        mesh = CollapseMesh(positions, triangles, uvs, materials, per_vertex[1:])
        mask = compute(mark_valid_kernel, triangles.size, [mesh], uint8, triangles.device)
        rows = positions_of(mask)  # sync
        return mesh if rows.size == triangles.size else self._mesh_at(rows, mesh)

    def _mesh_at(self, rows: Indices, mesh: CollapseMesh) -> CollapseMesh:
        uvs = gather_corners(mesh.uvs, rows) if mesh.has_uvs else None
        materials = gather_rows(mesh.materials, rows) if mesh.has_materials else None
        return CollapseMesh(mesh.positions, gather_rows(mesh.triangles, rows), uvs, materials, mesh.rows)

    def run(self) -> None:
        """Collapse edges until the target is reached. If impossible without an error limit, give up texture seams, then
        allow flips for one round at a time, and finally remove isolated triangles."""
        mesh = self.mesh
        if not mesh.triangles.size:
            return
        rounds = CollapseRounds(mesh, self.unit, self.target, self.max_error)
        rounds.run()
        self.mesh = mesh = rounds.mesh
        numbers = download(mesh.numbers)  # sync
        left, vertices = int(numbers[TRIANGLE_COUNT]), int(numbers[VERTEX_COUNT])
        sizes = {"triangles": left, "positions": vertices}
        sizes |= {"uvs": 3 * left} if mesh.has_uvs else {}
        sizes |= {"materials": left} if mesh.has_materials else {}
        for name, count in sizes.items():
            setattr(mesh, name, clone(getattr(mesh, name)[:count]))
        mesh.rows = [clone(rows[:vertices]) for rows in mesh.rows]
        if left > self.target and np.isinf(self.max_error):
            self._drop_lone()

    def _drop_lone(self) -> None:
        mesh = self.mesh
        count, device = mesh.triangles.size, mesh.triangles.device
        keys, mask = empty(count, int64, device), full(count, 1, uint8, device)
        launch(measure_lone_kernel, count, [mesh, keys])
        keys, order = argsort_keys(keys)
        launch(keep_lone_kernel, count - self.target, [keys, order, mask])
        rows = positions_of(mask)  # sync
        if rows.size < count:
            positions, self.mesh = mesh.positions, self._mesh_at(rows, mesh)
            self.mesh.positions = positions

    def result(self) -> tuple[Triangles, list[Vectors], Array1[vec2] | None, Integers | None]:
        """(triangles, per_vertex, uvs or None, materials or None). Some vertices may be unused."""
        mesh = self.mesh
        uvs, materials = mesh.uvs if mesh.has_uvs else None, mesh.materials if mesh.has_materials else None
        return mesh.triangles, [self.frame.unscaled(mesh.positions), *mesh.rows], uvs, materials
