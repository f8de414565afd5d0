"""Positions of pinhole pixels in an equirectangular image (Snyder 1987, Map projections, p. 90), padded by one wrapped
column on either side. Longitude grows to the right, latitude decreases downwards. Only + - * / and square roots
(algebra/angles.py): bitwise identical everywhere.
"""

from typing import Any

from ..algebra.angles import HALF_TURN, arctangent
from ..array_types import Array1, Device
from ..lang import array, float64, kernel, launch, mat33d, sqrt, tid, vec2, vec3d
from ..memory import empty


@kernel
def find_sphere_places_kernel(
    side: int, focal: float64, turns: array(dtype=mat33d), width: int, height: int, places: array(dtype=vec2)
):
    i = tid()
    face = i // (side * side)
    pixel = i % (side * side)
    middle = 0.5 * float64(side - 1)
    x = (float64(pixel % side) - middle) / focal
    y = (float64(pixel // side) - middle) / focal
    ray = turns[face] @ vec3d(x, y, 1.0)
    across = arctangent(ray[0], ray[2])
    level = sqrt(ray[0] * ray[0] + ray[2] * ray[2])
    down = arctangent(ray[1], level)
    column = (across / (2.0 * float64(HALF_TURN)) + 0.5) * float64(width) - 0.5
    row = (down / float64(HALF_TURN) + 0.5) * float64(height) - 0.5
    places[i] = vec2(float(column + 1.0), min(max(float(row), 0.0), float(height - 1)))


def find_sphere_places(
    side: int, focal: float, turns: Array1[Any], width: int, height: int, device: Device
) -> Array1[vec2]:
    """Positions of square images' pixels, vec2 (faces * side * side). `turns`: camera to sphere."""
    places = empty(turns.size * side * side, vec2, device)
    launch(find_sphere_places_kernel, places.size, [side, float64(focal), turns, width, height, places])
    return places
