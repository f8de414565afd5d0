"""Surface grain: 3D value noise of the world position.

Smooth blend of Perlin ("An image synthesizer", SIGGRAPH 1985) over hashed lattice values (Teschner et al. 2003,
finalizer of xxHash32). Float32 + - * / and integers only: bitwise identical everywhere.
"""

import numpy as np

from ..algebra.camera import Camera, CameraLike, pixel_ray
from ..algebra.transform import Transform, narrow
from ..array_types import Bytes, Scalars
from ..drawing.shading import color_byte
from ..lang import array, float32, float64, floor, func, kernel, launch, tid, uint8, uint32, vec3
from ..memory import empty

# Detail at near and far range: 0.12 m is 30 px of a VGA image at 2 m, 15 mm is 4 px.
COARSE_SPACING, MIDDLE_SPACING, FINE_SPACING = 0.12, 0.04, 0.015  # [m] spacing of the octaves' lattices
COARSE_WEIGHT, MIDDLE_WEIGHT, FINE_WEIGHT = 0.45, 0.33, 0.22  # their fractions
MIN_COLOR_FACTOR = 0.45  # color factor at noise 0 ...
COLOR_FACTOR_RANGE = 1.1  # ... and its increase at noise 1: the mean is 1

PRIME_X, PRIME_Y, PRIME_Z = 73856093, 19349663, 83492791  # of Teschner et al.
PRIME_SEED = 2654435761
MIX_1, MIX_2 = 2246822519, 3266489917  # of xxHash32
HALF_WORD = 0xFFFF


@func
def lattice_value(x: int, y: int, z: int, seed: int) -> float:
    """Lattice value, one of 65,536 from 0 to 1."""
    h = (uint32(x) * uint32(PRIME_X)) ^ (uint32(y) * uint32(PRIME_Y)) ^ (uint32(z) * uint32(PRIME_Z))
    h = h ^ (uint32(seed) * uint32(PRIME_SEED))
    h = (h ^ (h >> 15)) * uint32(MIX_1)
    h = (h ^ (h >> 13)) * uint32(MIX_2)
    return float32((h ^ (h >> 16)) & uint32(HALF_WORD)) / 65535.0


@func
def ease(t: float) -> float:
    """Smooth step from 0 to 1."""
    return t * t * (3.0 - 2.0 * t)


@func
def lattice_row(x: int, y: int, z: int, fx: float, seed: int) -> float:
    return lattice_value(x, y, z, seed) * (1.0 - fx) + lattice_value(x + 1, y, z, seed) * fx


@func
def value_noise(p: vec3, seed: int) -> float:
    """Value noise of unit lattice spacing, 0 to 1. The second derivative is discontinuous."""
    x = floor(p[0])
    y = floor(p[1])
    z = floor(p[2])
    fx = ease(p[0] - x)
    fy = ease(p[1] - y)
    fz = ease(p[2] - z)
    i = int(x)
    j = int(y)
    k = int(z)
    low = lattice_row(i, j, k, fx, seed) * (1.0 - fy) + lattice_row(i, j + 1, k, fx, seed) * fy
    high = lattice_row(i, j, k + 1, fx, seed) * (1.0 - fy) + lattice_row(i, j + 1, k + 1, fx, seed) * fy
    return low * (1.0 - fz) + high * fz


@func
def grain(p: vec3, seed: int) -> float:
    """Color factor at a position [m]: three octaves, mean 1."""
    coarse = COARSE_WEIGHT * value_noise(p / COARSE_SPACING, seed)
    middle = MIDDLE_WEIGHT * value_noise(p / MIDDLE_SPACING, seed + 1)
    fine = FINE_WEIGHT * value_noise(p / FINE_SPACING, seed + 2)
    return MIN_COLOR_FACTOR + COLOR_FACTOR_RANGE * (coarse + middle + fine)


@kernel
def grain_pixels_kernel(
    camera: Camera,
    T_world_camera: Transform,
    seed: int,
    depth: array(dtype=float32),
    colors: array(dtype=uint8),
    grained: array(dtype=uint8),
):
    i = tid()
    z = depth[i]
    ray = pixel_ray(float64(i % camera.width), float64(i // camera.width), camera)
    p = T_world_camera.t + T_world_camera.R @ (ray * float64(z))
    factor = 1.0
    if z > 0.0:
        factor = grain(narrow(p), seed)
    n = int(3)
    for c in range(n):
        grained[3 * i + c] = color_byte(float32(int(colors[3 * i + c])) / 255.0 * factor)


def grain_pixels(
    camera: CameraLike, T_world_camera: np.ndarray, depth: Scalars, colors: Bytes, *, seed: int = 1
) -> Bytes:
    """Apply grain to an image, uint8 (3 * h * w); `depth`, `colors` as of `Room.render`, one `seed` per scene."""
    grained = empty(colors.size, uint8, colors.device)
    launch(grain_pixels_kernel, depth.size, [camera, Transform(T_world_camera), seed, depth, colors, grained])
    return grained
