"""Real spherical harmonics of 3D Gaussian splats, and the rotation of their coefficients.

Basis of Kerbl et al. 2023 and Sloan, "Stupid Spherical Harmonics (SH) Tricks" (2008), appendix A2, with Condon-Shortley
signs: degree 1 is (-y, z, -x) times sqrt(3 / 4 pi).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from ..kernels.linear_algebra import matmul, solve

MAX_DEGREE = 4
DEGREE_0_HARMONIC = 0.5 / math.sqrt(math.pi)  # harmonic of degree 0


def degree_of(count: int) -> int | None:
    """Degree with this number of coefficients per color, including the first. None if there is none."""
    degree = math.isqrt(count) - 1
    return degree if 0 <= degree <= MAX_DEGREE and (degree + 1) ** 2 == count else None


def harmonics_at(directions: NDArray[np.float64], degree: int) -> NDArray[np.float64]:
    """Basis at unit vectors (m, 3): (m, (degree + 1)^2), by band, order -l to l."""
    x, y, z = directions.T
    columns = []
    cosines, sines = _azimuths(x, y, degree)
    legendre = _legendre(z, degree)
    for band in range(degree + 1):
        for order in range(-band, band + 1):
            azimuthal = cosines[order] if order >= 0 else sines[-order]
            columns.append(legendre[band, abs(order)] * azimuthal)
    return sizes_of(degree) * np.stack(columns, axis=1)


def sizes_of(degree: int) -> NDArray[np.float64]:
    """Normalization of each harmonic: ((degree + 1)^2,)."""
    sizes = []
    for band in range(degree + 1):
        for order in range(-band, band + 1):
            m = abs(order)
            ratio = math.factorial(band - m) / math.factorial(band + m)
            sizes.append(math.sqrt((2 * band + 1) / (4 * math.pi) * ratio) * (math.sqrt(2) if m else 1.0) * (-1) ** m)
    return np.array(sizes)


def rotation_of_harmonics(R: NDArray[np.float64], degree: int) -> NDArray[np.float64]:
    """Rotation matrix of the coefficients beyond the first: float64 (K - 1, K - 1), least squares per band."""
    size = (degree + 1) ** 2 - 1
    rotation = np.zeros((size, size))
    directions = _spread(4 * (size + 1))
    before, after = harmonics_at(matmul(directions, R), degree), harmonics_at(directions, degree)
    for band in range(1, degree + 1):
        columns = slice(band**2, (band + 1) ** 2)
        rows = slice(band**2 - 1, (band + 1) ** 2 - 1)
        part = after[:, columns]
        rotation[rows, rows] = solve(matmul(part.T, part), matmul(part.T, before[:, columns]))
    return rotation


def signs_of_flip(flips: tuple[int, int, int], degree: int) -> NDArray[np.float64]:
    """Signs of the coefficients beyond the first under axis flips (-1 for each): (K - 1,)."""
    directions = _spread(4 * (degree + 1) ** 2)
    before, after = harmonics_at(directions * np.array(flips, np.float64), degree), harmonics_at(directions, degree)
    return np.sign((before * after).sum(axis=0))[1:]


def _azimuths(
    x: NDArray[np.float64], y: NDArray[np.float64], degree: int
) -> tuple[list[NDArray[np.float64]], list[NDArray[np.float64]]]:
    """Real and imaginary parts of (x + i y)^m for m = 0 to degree."""
    cosines, sines = [np.ones_like(x)], [np.zeros_like(x)]
    for _ in range(degree):
        c, s = cosines[-1], sines[-1]
        cosines.append(x * c - y * s)
        sines.append(x * s + y * c)
    return cosines, sines


def _legendre(z: NDArray[np.float64], degree: int) -> dict[tuple[int, int], NDArray[np.float64]]:
    """Associated Legendre functions of z over (1 - z^2)^(m/2), without the phase, by (l, m)."""
    values = {}
    for m in range(degree + 1):
        values[m, m] = np.full_like(z, math.prod(range(1, 2 * m, 2)))
        for band in range(m + 1, degree + 1):
            below = values.get((band - 2, m), np.zeros_like(z))
            values[band, m] = ((2 * band - 1) * z * values[band - 1, m] - (band + m - 1) * below) / (band - m)
    return values


def _spread(count: int) -> NDArray[np.float64]:
    """Unit vectors on a spiral: (count, 3)."""
    index = np.arange(count) + 0.5
    z = 1 - 2 * index / count
    angle, radius = index * math.pi * (1 + math.sqrt(5)), np.sqrt(1 - z * z)
    return np.stack([radius * np.cos(angle), radius * np.sin(angle), z], axis=1)
