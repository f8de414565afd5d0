"""Positions of pinhole pixels in an equirectangular image (Snyder 1987, Map projections, p. 90), padded by one wrapped
column on either side. Longitude grows to the right, latitude decreases downwards. Only + - * / and square roots
(algebra/angles.py): bitwise identical everywhere.
"""

from typing import Any

from ..algebra.angles import PI, arctangent
from ..array_types import Array1, Device
from ..lang import array, float64, kernel, launch, mat33d, sqrt, tid, vec2, vec3d
from ..memory import empty


@kernel
def find_sphere_positions_kernel(
    side: int, focal: float64, rotations: array(dtype=mat33d), width: int, height: int, positions: array(dtype=vec2)
):
    i = tid()
    face = i // (side * side)
    pixel = i % (side * side)
    middle = 0.5 * float64(side - 1)
    x = (float64(pixel % side) - middle) / focal
    y = (float64(pixel // side) - middle) / focal
    ray = rotations[face] @ vec3d(x, y, 1.0)
    across = arctangent(ray[0], ray[2])
    level = sqrt(ray[0] * ray[0] + ray[2] * ray[2])
    down = arctangent(ray[1], level)
    column = (across / (2.0 * float64(PI)) + 0.5) * float64(width) - 0.5
    row = (down / float64(PI) + 0.5) * float64(height) - 0.5
    positions[i] = vec2(float(column + 1.0), min(max(float(row), 0.0), float(height - 1)))


def find_sphere_positions(
    side: int, focal: float, rotations: Array1[Any], width: int, height: int, device: Device
) -> Array1[vec2]:
    """Positions of square images' pixels, vec2 (faces * side * side). `rotations`: camera to sphere."""
    positions = empty(rotations.size * side * side, vec2, device)
    launch(find_sphere_positions_kernel, positions.size, [side, float64(focal), rotations, width, height, positions])
    return positions
