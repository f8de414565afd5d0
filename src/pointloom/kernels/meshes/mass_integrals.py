"""Integrals of 1, coordinates and their products over the volume of a closed mesh, in float64 and a fixed order.

Each triangle and the reference point form a signed tetrahedron, whose integrals are polynomials of its corners.
42 B read and about 60 operations per triangle. Eberly, "Polyhedral mass properties (revisited)", Geometric Tools, 2002.
"""

import numpy as np
from numpy.typing import NDArray

from ..algebra.transform import widen
from ..array_types import Points, Triangles
from ..lang import array, cross, dot, float64, reduce, reduction, tid, vec3, vec3i, vector
from ..memory import download

mass_sums = vector(10, float64)
CORNER_PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))  # rows and columns of the last six sums


@reduction
def integrate_tetrahedron(vertices: array(dtype=vec3), triangles: array(dtype=vec3i)) -> mass_sums:
    """6, 24 and 120 times the integrals of a triangle's tetrahedron with the first corner of the first triangle."""
    i = tid()
    t = triangles[i]
    reference = widen(vertices[triangles[0][0]])
    a = widen(vertices[t[0]]) - reference
    b = widen(vertices[t[1]]) - reference
    c = widen(vertices[t[2]]) - reference
    s = a + b + c
    v = dot(a, cross(b, c))
    return mass_sums(
        v, v * s[0], v * s[1], v * s[2],
        v * (a[0] * a[0] + b[0] * b[0] + c[0] * c[0] + s[0] * s[0]),
        v * (a[1] * a[1] + b[1] * b[1] + c[1] * c[1] + s[1] * s[1]),
        v * (a[2] * a[2] + b[2] * b[2] + c[2] * c[2] + s[2] * s[2]),
        v * (a[0] * a[1] + b[0] * b[1] + c[0] * c[1] + s[0] * s[1]),
        v * (a[1] * a[2] + b[1] * b[2] + c[1] * c[2] + s[1] * s[2]),
        v * (a[2] * a[0] + b[2] * b[0] + c[2] * c[0] + s[2] * s[0]),
    )  # fmt: skip


def integrate_volume(vertices: Points, triangles: Triangles) -> tuple[float, NDArray[np.float64], NDArray[np.float64]]:
    """Signed volume, centroid (3,) relative to the origin of the vertices, and second moments (3, 3) about it.

    The volume is 0, and the others are NaN or infinite, if the mesh encloses nothing. At least one triangle.
    """
    sums = np.asarray(download(reduce(integrate_tetrahedron, triangles.size, [vertices, triangles]))[0], np.float64)
    volume, second = sums[0] / 6, np.empty((3, 3))
    for (row, column), value in zip(CORNER_PAIRS, sums[4:] / 120, strict=True):
        second[row, column] = second[column, row] = value
    with np.errstate(all="ignore"):
        center = sums[1:4] / (4 * sums[0])
        second -= volume * np.outer(center, center)
    first = int(download(triangles[:1]).reshape(-1)[0])  # sync
    return float(volume), center + download(vertices[first : first + 1])[0], second
