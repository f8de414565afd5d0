"""The noise of a structured-light depth camera.

One thread a pixel: reads 9 depths, draws four random numbers, writes one depth; some 150 operations, most of
them the random numbers'.

Source: Nguyen, Izadi and Lovell, "Modeling Kinect sensor noise for improved 3D reconstruction and tracking", 3DIMPVT
2012: axial standard deviation 1.2 mm + 1.9 mm (z - 0.4 m)^2 / m^2. No measurement at grazing angles, and seldom one
beside an edge, where the pattern is torn.
"""

from ..array_types import Scalars
from ..arrays.random import gaussian_pair, random_uniform
from ..lang import array, float32, floor, kernel, launch, tid
from ..memory import empty

AXIAL_BASE = 0.0012  # [m]
AXIAL_GROWTH = 0.0019  # [1/m]
AXIAL_NEAREST = 0.4  # [m]
GRAZING = 0.17364818  # cos 80 degrees
EDGE_JUMP = 0.04  # a jump of depth is an edge beyond this share of the depth
EDGE_LOSS = 0.7  # share of the edge pixels that are lost
NEAREST = 0.3  # [m] the camera measures nothing closer
FARTHEST = 8.0  # [m] nor beyond


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
    """Depth [m] as a structured-light camera gives it, in whole millimetres; 0 where it measures nothing."""
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
    kept = 1
    if noisy < NEAREST or noisy > FARTHEST or incidence[i] < GRAZING:
        kept = 0
    if jump > EDGE_JUMP * z and u[2] < EDGE_LOSS:
        kept = 0
    value = 0.0
    if kept == 1:
        value = floor(noisy * 1000.0 + 0.5) * 0.001
    measured[i] = value


def measure_depth(depth: Scalars, incidence: Scalars, width: int, height: int, *, seed: int, frame: int) -> Scalars:
    """Depth as a structured-light camera measures it.

    Args:
        depth, incidence: As `Room.render` gives them.
        width, height: Size of the picture [px].
        seed, frame: Choose the noise; the same two give the same noise.

    Returns:
        float32 device array [h * w] [m], whole millimetres; 0 where nothing is measured.
    """
    measured = empty(depth.size, float32, depth.device)
    launch(measure_depth_kernel, depth.size, [width, height, seed, frame, depth, incidence, measured])
    return measured
