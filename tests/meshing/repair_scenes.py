"""Valid and invalid meshes as written by other programs: a repair must not make any of them worse."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pointloom import TriangleMesh

from .mesh_soups import FAR, grid


def joined(*meshes: TriangleMesh) -> TriangleMesh:
    """Meshes as one, without shared vertices."""
    firsts = np.cumsum([0] + [len(mesh.vertices) for mesh in meshes])
    triangles = [mesh.triangles + first for mesh, first in zip(meshes, firsts, strict=False)]
    return TriangleMesh(np.vstack([mesh.vertices for mesh in meshes]), np.vstack(triangles))


def moved(mesh: TriangleMesh, shift: Any) -> TriangleMesh:
    return TriangleMesh(mesh.vertices + np.asarray(shift, float), mesh.triangles)


def flipped(mesh: TriangleMesh) -> TriangleMesh:
    return TriangleMesh(mesh.vertices, mesh.triangles[:, ::-1])


def two_sided(mesh: TriangleMesh) -> TriangleMesh:
    """Each triangle in both orientations, over the same vertices."""
    return TriangleMesh(mesh.vertices, np.vstack([mesh.triangles, mesh.triangles[:, ::-1]]))


def with_more(mesh: TriangleMesh, triangles: Any) -> TriangleMesh:
    """The mesh with additional triangles between its vertices."""
    return TriangleMesh(mesh.vertices, np.vstack([mesh.triangles, triangles]))


def loose(mesh: TriangleMesh, seed: int = 0) -> TriangleMesh:
    """Triangles in random order without shared vertices."""
    corners = np.random.default_rng(seed).permutation(mesh.triangles)
    return TriangleMesh(mesh.vertices[corners].reshape(-1, 3), np.arange(corners.size).reshape(-1, 3))


def welded(mesh: TriangleMesh) -> TriangleMesh:
    return mesh.remove_duplicated_vertices()


def partly_flipped(mesh: TriangleMesh, fraction: float = 0.3) -> TriangleMesh:
    triangles = mesh.triangles.copy()
    chosen = np.random.default_rng(0).random(len(triangles)) < fraction
    triangles[chosen] = triangles[chosen][:, ::-1]
    return TriangleMesh(mesh.vertices, triangles)


def sphere(radius: float = 1.0) -> TriangleMesh:
    return TriangleMesh.create_sphere(radius, 6)


def box(*shift: float) -> TriangleMesh:
    return moved(TriangleMesh.create_box(), shift or (0, 0, 0))


def shells(count: int) -> TriangleMesh:
    """Nested closed surfaces: a solid in a cavity in a solid, and so on."""
    parts = [sphere(1 / (1 + k)) for k in range(count)]
    return joined(*(flipped(part) if k % 2 else part for k, part in enumerate(parts)))


def sheet(size: int = 5) -> TriangleMesh:
    positions = np.argwhere(np.ones((size, size))).astype(float)
    return TriangleMesh(np.column_stack([positions, np.zeros(len(positions))]), grid(size, size))


def blocks(full: NDArray[np.bool_]) -> TriangleMesh:
    """The surface of some cubes of a grid with merged vertices: edges of four triangles where cubes touch."""
    numbers: dict[tuple[int, ...], int] = {}
    triangles, filled = [], {tuple(cell) for cell in np.argwhere(full).tolist()}
    for cell in sorted(filled):
        for axis, side in ((axis, side) for axis in range(3) for side in (0, 1)):
            beyond = list(cell)
            beyond[axis] += 2 * side - 1
            if tuple(beyond) in filled:
                continue
            corners = []
            for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = list(cell)
                corner[axis] += side
                corner[(axis + 1) % 3] += u
                corner[(axis + 2) % 3] += v
                corners.append(numbers.setdefault(tuple(corner), len(numbers)))
            a, b, c, d = corners if side else corners[::-1]
            triangles += [[a, b, c], [a, c, d]]
    return TriangleMesh(np.array(list(numbers), float), triangles)


def fans(count: int) -> TriangleMesh:
    """Half discs of several triangles that share one edge, like the pages of a book."""
    angle = 2 * np.pi * np.arange(count) / count
    tips = [[r * np.cos(a), r * np.sin(a), z] for a in angle for r, z in ((1, 0), (1, 1))]
    pages = [[[0, 1, 3 + 2 * k], [0, 3 + 2 * k, 2 + 2 * k]] for k in range(count)]
    return TriangleMesh([[0, 0, 0], [0, 0, 1], *tips], np.vstack(pages))


def ring() -> TriangleMesh:
    """Seven cubes in a ring that touches itself along an edge, which exists twice between the same two vertices."""
    full = np.zeros((2, 2, 3), bool)
    full[:, :, [0, 2]] = [[[True], [True]], [[False], [True]]]
    full[0, 0, 1] = full[1, 1, 1] = True
    return blocks(full)


SIDE_BY_SIDE = joined(box(), box(1, 0, 0))
DIAGONAL = joined(box(), box(1, 1, 0))
# valid meshes that a repair does not change
VALID = {
    "a ball": sphere(),
    "two boxes side by side": SIDE_BY_SIDE,
    "two boxes at an edge": DIAGONAL,
    "two boxes at a vertex": joined(box(), box(1, 1, 1)),
    "a box among others": joined(*(box(x, y, z) for x, y, z in np.argwhere(np.ones((3, 3, 3))))),
    "a hollow ball": shells(2),
    "shells three deep": shells(3),
    "a ball in a ball": joined(sphere(), sphere(0.5)),
    "a ball that fills a hollow": joined(shells(2), sphere(0.5)),
    "a sheet": sheet(),
}
# name -> (damaged mesh, expected repaired mesh)
REPAIR_CASES = {
    "a ball inside out": (flipped(sphere()), sphere()),
    "a ball of loose triangles": (loose(sphere()), sphere()),
    "a ball wound both ways": (partly_flipped(sphere()), sphere()),
    "a ball with two sides": (two_sided(sphere()), sphere()),
    "a ball within its other side": (joined(flipped(sphere()), sphere()), sphere()),
    "a ball given twice": (joined(sphere(), sphere()), sphere()),
    "a ball with some triangles twice": (with_more(sphere(), sphere().triangles[5:9]), sphere()),
    "a ball far away": (moved(two_sided(sphere()), FAR), sphere()),
    "two boxes side by side, welded": (welded(SIDE_BY_SIDE), SIDE_BY_SIDE),
    "two boxes at an edge, welded": (welded(DIAGONAL), DIAGONAL),
    "two boxes at an edge, loose": (loose(DIAGONAL), DIAGONAL),
    "a hollow ball inside out": (flipped(shells(2)), shells(2)),
    "a hollow ball with two sides": (two_sided(shells(2)), shells(2)),
    "shells three deep wound both ways": (partly_flipped(shells(3)), shells(3)),
    "a box with two walls in one": (with_more(box(), box().triangles[:2, ::-1]), box()),
    "a ball with two sides wound both ways": (partly_flipped(two_sided(sphere())), sphere()),
    "a sheet with two sides": (two_sided(sheet()), sheet()),
    "cubes that touch themselves": (ring(), ring()),
}  # fmt: skip
