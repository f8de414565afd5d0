"""Projected areas of the triangles that face toward and away from four viewing directions, without occlusion.

They are equal for a closed mesh. 42 B read and about 40 operations per triangle.
"""

import numpy as np
from numpy.typing import NDArray

from ..array_types import Points, Triangles
from ..lang import array, dot, float64, reduce, reduction, tid, vec3, vec3d, vec3i, vector
from ..memory import download, upload
from .mesh_measures import triangle_cross

DIRECTION_COUNT = 4
facing_sums = vector(8, float64)


@reduction
def sum_facing_areas(
    vertices: array(dtype=vec3), triangles: array(dtype=vec3i), directions: array(dtype=vec3d)
) -> facing_sums:
    """Twice the areas toward each direction, then away. Triangles with a corner that is not finite do not count."""
    i = tid()
    n = triangle_cross(vertices, triangles[i])
    total = facing_sums(0.0)
    for k in range(4):
        along = dot(n, directions[k])
        total[k] = max(-along, 0.0)
        total[k + 4] = max(along, 0.0)
    return total


def facing_areas(
    vertices: Points, triangles: Triangles, directions: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Areas that face toward the viewers along four directions (4, 3), shape (4,), and away from them."""
    given = [vertices, triangles, upload(directions, vec3d, vertices.device)]
    sums = np.asarray(download(reduce(sum_facing_areas, triangles.size, given))[0], np.float64) / 2  # sync
    return sums[:DIRECTION_COUNT], sums[DIRECTION_COUNT:]
