"""Gauss-Newton systems of six unknowns about a center, rotations in units of length, in float64."""

from ..algebra.rigid_solve import UNKNOWN_COUNT, full_matrix, square, triangle, vec6d
from ..lang import cross, float64, func, vec3d


@func
def about(h: triangle, center: vec3d, size: float64) -> square:
    """6x6 matrix about a center, rotations in units of length: B^T H B with B = (I/s, 0; [c]x/s, I)."""
    a = full_matrix(h)
    c = square(0.0)
    for i in range(6):  # C = A B
        for j in range(3):
            c[i * UNKNOWN_COUNT + 3 + j] = a[i * UNKNOWN_COUNT + 3 + j]
        v = vec3d(a[i * UNKNOWN_COUNT + 3], a[i * UNKNOWN_COUNT + 4], a[i * UNKNOWN_COUNT + 5])
        w = cross(v, center)  # v^T [c]x
        for j in range(3):
            c[i * UNKNOWN_COUNT + j] = (a[i * UNKNOWN_COUNT + j] + w[j]) / size
    out = square(0.0)
    for j in range(6):  # B^T C
        v = vec3d(c[3 * UNKNOWN_COUNT + j], c[4 * UNKNOWN_COUNT + j], c[5 * UNKNOWN_COUNT + j])
        w = cross(v, center)
        for i in range(3):
            out[i * UNKNOWN_COUNT + j] = (c[i * UNKNOWN_COUNT + j] + w[i]) / size
            out[(3 + i) * UNKNOWN_COUNT + j] = v[i]
    return out


@func
def vector_about(g: vec6d, center: vec3d, size: float64) -> vec6d:
    w = cross(vec3d(g[3], g[4], g[5]), center)
    return vec6d((g[0] + w[0]) / size, (g[1] + w[1]) / size, (g[2] + w[2]) / size, g[3], g[4], g[5])
