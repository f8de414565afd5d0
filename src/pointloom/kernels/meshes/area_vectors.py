"""Vector area of a mesh: the area-weighted sum of its triangle normals. It is zero for a closed mesh."""

from ..array_types import Points, Triangles
from ..lang import array, float64, length, reduce, reduction, tid, vec3, vec3i, vector
from ..memory import download
from .mesh_measures import triangle_cross

area_sums = vector(4, float64)


@reduction
def sum_area_vectors(vertices: array(dtype=vec3), triangles: array(dtype=vec3i)) -> area_sums:
    """Twice the vector area, and twice the area. Triangles with a corner that is not finite do not count."""
    i = tid()
    n = triangle_cross(vertices, triangles[i])
    return area_sums(n[0], n[1], n[2], length(n))


def vector_area(vertices: Points, triangles: Triangles) -> tuple[list[float], float]:
    """The vector area, and the area of the triangles."""
    *vector_sum, area = download(reduce(sum_area_vectors, triangles.size, [vertices, triangles]))[0].tolist()  # sync
    return [value / 2 for value in vector_sum], area / 2
