"""Alpha shape of given tetrahedra."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import det

# Opposite each corner, outward if det(b - a, c - a, d - a) > 0
TETRAHEDRON_FACES = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))


def alpha_faces(
    vertices: NDArray[np.float64], tetras: NDArray[np.integer], alpha: float
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Boundary of the tetrahedra with a circumradius of at most `alpha`.

    Returns:
        (ascending vertex indices (m,), outward triangles of positions in them (k, 3)).
    """
    corners = vertices[tetras]
    edges = corners[:, 1:] - corners[:, :1]
    volumes = det(edges)
    lengths = (edges**2).sum(axis=2)
    p, q, r = edges.transpose(1, 0, 2)
    offsets = (
        lengths[:, :1] * np.cross(q, r) + lengths[:, 1:2] * np.cross(r, p) + lengths[:, 2:] * np.cross(p, q)
    )  # of the circumcenter, by 2 det
    radii = np.sqrt((offsets**2).sum(axis=1))
    kept = (volumes != 0) & (radii <= 2 * np.abs(volumes) * alpha)
    oriented = np.where(volumes[kept, None] > 0, tetras[kept], tetras[kept][:, [1, 0, 2, 3]])
    faces = oriented[:, TETRAHEDRON_FACES].reshape(-1, 3)
    _, places, counts = np.unique(np.sort(faces, axis=1), axis=0, return_inverse=True, return_counts=True)
    used, triangles = np.unique(faces[counts[places.reshape(-1)] == 1], return_inverse=True)
    return used, triangles.reshape(-1, 3)
