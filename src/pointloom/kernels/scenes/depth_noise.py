"""Noise of a structured-light depth camera (Nguyen, Izadi and Lovell, "Modeling Kinect sensor noise for improved 3D
reconstruction and tracking", 3DIMPVT 2012): axial standard deviation 1.2 mm + 1.9 mm (z - 0.4 m)^2 / m^2, no depth at
grazing angles, rarely beside edges.
"""

from ..array_types import Scalars
from ..arrays.random import gaussian_pair, random_uniform
from ..lang import array, float32, floor, kernel, launch, tid
from ..memory import empty

AXIAL_BASE = 0.0012  # [m]
AXIAL_GROWTH = 0.0019  # [1/m]
AXIAL_NEAREST = 0.4  # [m]
MIN_INCIDENCE_COSINE = 0.17364818  # cos 80 degrees
EDGE_JUMP = 0.04  # relative depth step at an edge
EDGE_LOSS = 0.7  # fraction of edge pixels without depth
MIN_RANGE = 0.3  # [m]
MAX_RANGE = 8.0  # [m]


@kernel
def measure_depth_kernel(
    width: int,
    height: int,
    seed: int,
    frame: int,
    depth: array(dtype=float32),
    incidence: array(dtype=float32),
    measured: array(dtype=float32),
):
    """Measured depth [m] in whole millimeters. 0 where there is none."""
    i = tid()
    z = depth[i]
    column = i % width
    row = i // width
    jump = 0.0
    for k in range(9):
        x = min(max(column + k % 3 - 1, 0), width - 1)
        y = min(max(row + k // 3 - 1, 0), height - 1)
        jump = max(jump, abs(depth[y * width + x] - z))
    u = random_uniform(seed, i, frame)
    away = z - AXIAL_NEAREST
    noisy = z + (AXIAL_BASE + AXIAL_GROWTH * away * away) * gaussian_pair(u[0], u[1])[0]
    is_valid = 1
    if noisy < MIN_RANGE or noisy > MAX_RANGE or incidence[i] < MIN_INCIDENCE_COSINE:
        is_valid = 0
    if jump > EDGE_JUMP * z and u[2] < EDGE_LOSS:
        is_valid = 0
    value = 0.0
    if is_valid == 1:
        value = floor(noisy * 1000.0 + 0.5) * 0.001
    measured[i] = value


def measure_depth(depth: Scalars, incidence: Scalars, width: int, height: int, *, seed: int, frame: int) -> Scalars:
    """Measured depth, float32 (h * w) [m], in whole millimeters, 0 for none; (`seed`, `frame`) selects the noise."""
    measured = empty(depth.size, float32, depth.device)
    launch(measure_depth_kernel, depth.size, [width, height, seed, frame, depth, incidence, measured])
    return measured
