"""Colors of distances: five colors of viridis, linearly interpolated."""

from ..array_types import Doubles, Vectors
from ..lang import array, compute, float64, isfinite, kernel, tid, vec3

COLOR_STEPS = 4


@kernel
def color_distances_kernel(distances: array(dtype=float64), largest: float, colors: array(dtype=vec3)):
    """Color of each distance from 0 to `largest`; gray if it is not finite."""
    i = tid()
    d = float(distances[i])
    color = vec3(0.5, 0.5, 0.5)
    if isfinite(d):
        fraction = 0.0
        if largest > 0.0:
            fraction = min(d / largest, 1.0)
        position = fraction * float(COLOR_STEPS)
        step = min(int(position), COLOR_STEPS - 1)
        rest = position - float(step)
        a = vec3(0.267, 0.005, 0.329)
        b = vec3(0.230, 0.322, 0.546)
        if step == 1:
            a = vec3(0.230, 0.322, 0.546)
            b = vec3(0.128, 0.567, 0.551)
        if step == 2:
            a = vec3(0.128, 0.567, 0.551)
            b = vec3(0.369, 0.789, 0.383)
        if step == 3:
            a = vec3(0.369, 0.789, 0.383)
            b = vec3(0.993, 0.906, 0.144)
        color = a + (b - a) * rest
    colors[i] = color


def color_distances(distances: Doubles, largest: float) -> Vectors:
    return compute(color_distances_kernel, distances.size, [distances, largest], vec3, distances.device)
