"""Non-iterative eigensolver of symmetric 3x3 matrices, robust to degenerate cases.

Eberly, "A robust eigensolver for 3x3 symmetric matrices", Geometric Tools, 2014. The eigenvector of the best separated
eigenvalue comes first, the others from its orthogonal plane. Signs follow from the order of operations and match
Open3D's, so unoriented normals have the same side.
"""

from ..lang import acos, cos, cross, dot, float64, func, mat33d, sqrt, vec3d, vector

TWO_THIRDS_PI = 2.0943951023931953  # 2 pi / 3
pair = vector(2, float64)
spectrum = vector(6, float64)  # ascending eigenvalues, and the unit eigenvector of the smallest


@func
def largest_entry(a: mat33d) -> float64:
    diagonal = max(max(abs(a[0, 0]), abs(a[1, 1])), abs(a[2, 2]))
    return max(diagonal, max(max(abs(a[0, 1]), abs(a[0, 2])), abs(a[1, 2])))


@func
def off_diagonal(a: mat33d) -> float64:
    """Sum of the squares above the diagonal."""
    return a[0, 1] * a[0, 1] + a[0, 2] * a[0, 2] + a[1, 2] * a[1, 2]


@func
def sorted_eigenvalues(a: mat33d) -> vec3d:
    """Ascending eigenvalues of a matrix with entries up to magnitude 1."""
    q = (a[0, 0] + a[1, 1] + a[2, 2]) / 3.0
    b00 = a[0, 0] - q
    b11 = a[1, 1] - q
    b22 = a[2, 2] - q
    p = sqrt((b00 * b00 + b11 * b11 + b22 * b22 + 2.0 * off_diagonal(a)) / 6.0)
    values = vec3d(q, q, q)
    if p > 0.0:
        s = 1.0 / p  # scale the deviator before its determinant, whose terms could underflow
        c00 = (b11 * s) * (b22 * s) - (a[1, 2] * s) * (a[1, 2] * s)
        c01 = (a[0, 1] * s) * (b22 * s) - (a[1, 2] * s) * (a[0, 2] * s)
        c02 = (a[0, 1] * s) * (a[1, 2] * s) - (b11 * s) * (a[0, 2] * s)
        det = (b00 * s) * c00 - (a[0, 1] * s) * c01 + (a[0, 2] * s) * c02
        half = min(max(det * 0.5, -1.0), 1.0)
        angle = acos(half) / 3.0
        high = 2.0 * cos(angle)
        low = 2.0 * cos(angle + float64(TWO_THIRDS_PI))
        values = vec3d(q + p * low, q - p * (low + high), q + p * high)
    return values


@func
def separated_eigenvector(a: mat33d, value: float64) -> vec3d:
    """Unit eigenvector of a simple eigenvalue: the best conditioned cross product of two rows."""
    r0 = vec3d(a[0, 0] - value, a[0, 1], a[0, 2])
    r1 = vec3d(a[0, 1], a[1, 1] - value, a[1, 2])
    r2 = vec3d(a[0, 2], a[1, 2], a[2, 2] - value)
    best = cross(r0, r1)
    size = dot(best, best)
    other = cross(r0, r2)
    if dot(other, other) > size:
        best = other
        size = dot(other, other)
    other = cross(r1, r2)
    if dot(other, other) > size:
        best = other
        size = dot(other, other)
    unit = vec3d(0.0, 0.0, 1.0)
    if size > 0.0:
        unit = best / sqrt(size)
    return unit


@func
def orthogonal_direction(w: vec3d) -> vec3d:
    u = vec3d(0.0, w[2], -w[1])
    if abs(w[0]) > abs(w[1]):
        u = vec3d(-w[2], 0.0, w[0])
    return u / sqrt(dot(u, u))


@func
def smallest_in_plane(a: mat33d, w: vec3d) -> vec3d:
    """Unit eigenvector of the smaller eigenvalue orthogonal to the eigenvector w, more accurate than by the cubic."""
    u = orthogonal_direction(w)
    v = cross(w, u)
    au = a @ u
    av = a @ v
    half = (dot(u, au) - dot(v, av)) * 0.5
    mixed = dot(u, av)
    size = max(abs(half), abs(mixed))
    x = float64(0.0)
    y = float64(-1.0)
    if size > 0.0:
        half = half / size
        mixed = mixed / size
        larger = abs(half) + sqrt(half * half + mixed * mixed)
        if half > 0.0:
            x = mixed
            y = -larger
        else:
            x = -larger
            y = mixed
        length = sqrt(x * x + y * y)
        x = x / length
        y = y / length
    return u * x + v * y


@func
def smallest_eigenvector(covariance: mat33d) -> vec3d:
    """Unit eigenvector of the smallest eigenvalue; (0, 0, 1) for a multiple of the identity."""
    result = vec3d(0.0, 0.0, 1.0)
    size = largest_entry(covariance)
    if size > 0.0:
        a = covariance * (1.0 / size)
        if off_diagonal(a) > 0.0:
            values = sorted_eigenvalues(a)
            if values[1] - values[0] >= values[2] - values[1]:
                result = separated_eigenvector(a, values[0])
            else:
                result = smallest_in_plane(a, separated_eigenvector(a, values[2]))
        else:
            if a[0, 0] < a[2, 2] and a[0, 0] <= a[1, 1]:
                result = vec3d(1.0, 0.0, 0.0)
            if a[1, 1] < a[2, 2] and a[1, 1] < a[0, 0]:
                result = vec3d(0.0, 1.0, 0.0)
    return result


@func
def eigenvalues_in_plane(a: mat33d, w: vec3d) -> pair:
    """Ascending eigenvalues in the plane orthogonal to the eigenvector w."""
    u = orthogonal_direction(w)
    v = cross(w, u)
    au = a @ u
    av = a @ v
    half = (dot(u, au) - dot(v, av)) * 0.5
    mixed = dot(u, av)
    middle = (dot(u, au) + dot(v, av)) * 0.5
    spread = sqrt(half * half + mixed * mixed)
    return pair(middle - spread, middle + spread)


@func
def sorted_diagonal(a: mat33d) -> vec3d:
    low = min(a[0, 0], a[1, 1])
    high = max(a[0, 0], a[1, 1])
    return vec3d(min(low, a[2, 2]), max(low, min(high, a[2, 2])), max(high, a[2, 2]))


@func
def eigenvalues(covariance: mat33d) -> vec3d:
    """Ascending eigenvalues, accurate to a few roundings of the largest. The cubic only selects the separated one."""
    values = vec3d(0.0, 0.0, 0.0)
    size = largest_entry(covariance)
    if size > 0.0:
        a = covariance * (1.0 / size)
        if off_diagonal(a) > 0.0:
            roots = sorted_eigenvalues(a)
            if roots[1] - roots[0] >= roots[2] - roots[1]:
                w = separated_eigenvector(a, roots[0])
                others = eigenvalues_in_plane(a, w)
                values = vec3d(dot(w, a @ w), others[0], others[1])
            else:
                w = separated_eigenvector(a, roots[2])
                others = eigenvalues_in_plane(a, w)
                values = vec3d(others[0], others[1], dot(w, a @ w))
        else:
            values = sorted_diagonal(a)
        values = values * size
    return values


@func
def values_and_smallest_vector(covariance: mat33d) -> spectrum:
    """The results of `eigenvalues` and `smallest_eigenvector`, bitwise, in half of the time."""
    result = spectrum(0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
    size = largest_entry(covariance)
    if size > 0.0:
        a = covariance * (1.0 / size)
        if off_diagonal(a) > 0.0:
            roots = sorted_eigenvalues(a)
            is_smallest = roots[1] - roots[0] >= roots[2] - roots[1]
            w = separated_eigenvector(a, roots[0] if is_smallest else roots[2])
            own = dot(w, a @ w)
            others = eigenvalues_in_plane(a, w)
            if is_smallest:
                result = spectrum(own * size, others[0] * size, others[1] * size, w[0], w[1], w[2])
            else:
                n = smallest_in_plane(a, w)
                result = spectrum(others[0] * size, others[1] * size, own * size, n[0], n[1], n[2])
        else:
            values = eigenvalues(covariance)
            n = smallest_eigenvector(covariance)
            result = spectrum(values[0], values[1], values[2], n[0], n[1], n[2])
    return result
