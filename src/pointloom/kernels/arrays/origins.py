"""Conversion of float64 positions to float32 about an origin, and back, on the device."""

import numpy as np

from ..algebra.transform import narrow, widen
from ..array_types import AnyArray, Doubles, Integers, Points, Positions, Scalars
from ..lang import array, atomic_max, compute, float32, float64, int32, isfinite, kernel, launch, tid, vec3, vec3d
from ..memory import contiguous, empty, zeros
from .side_by_side import read_together


@kernel
def find_far_kernel(points: array(dtype=vec3), limit: float, far: array(dtype=int32)):
    """Set the flag if a finite point has a coordinate beyond the limit."""
    i = tid()
    p = points[i]
    if isfinite(p):
        if max(abs(p[0]), max(abs(p[1]), abs(p[2]))) > limit:
            if far[0] == 0:  # saves atomics. All writers set 1
                atomic_max(far, 0, 1)


@kernel
def find_far_wide_kernel(points: array(dtype=vec3d), limit: float64, far: array(dtype=int32)):
    i = tid()
    p = points[i]
    if isfinite(p):
        if max(abs(p[0]), max(abs(p[1]), abs(p[2]))) > limit:
            if far[0] == 0:
                atomic_max(far, 0, 1)


@kernel
def subtract_origin_kernel(points: array(dtype=vec3d), origin: vec3d, lost: array(dtype=int32), out: array(dtype=vec3)):
    """out = p - origin, rounded once. Set the flag if a finite point becomes infinite."""
    i = tid()
    p = points[i]
    q = narrow(p - origin)
    out[i] = q
    if isfinite(p) and not isfinite(q):
        if lost[0] == 0:
            atomic_max(lost, 0, 1)


@kernel
def add_origin_kernel(points: array(dtype=vec3), origin: vec3d, out: array(dtype=vec3d)):
    i = tid()
    out[i] = widen(points[i]) + origin


@kernel
def shift_rays_kernel(rays: array(dtype=float64), origin: vec3d, out: array(dtype=float32)):
    """Rays of six numbers with their starts about an origin. One thread per number."""
    i = tid()
    k = i % 6
    value = rays[i]
    if k == 0:
        value = value - origin[0]
    if k == 1:
        value = value - origin[1]
    if k == 2:
        value = value - origin[2]
    out[i] = float(value)


def has_far_points(points: AnyArray, limit: float, step: int) -> tuple[bool, np.ndarray]:
    """(True if a finite point has a coordinate beyond the limit, every `step`-th point). One sync."""
    flag = zeros(1, int32, points.device)
    launch(find_far_kernel if points.dtype == vec3 else find_far_wide_kernel, points.size, [points, limit, flag])
    far, sample = read_together([flag, contiguous(points[::step])])  # sync
    return bool(far[0]), sample


def subtract_origin(points: Positions, origin: np.ndarray) -> tuple[Points, Integers]:
    """float64 points (vec3d) about an origin: (vec3 array, int32 (1) flag set if a finite point became infinite)."""
    out, lost = empty(points.size, vec3, points.device), zeros(1, int32, points.device)
    launch(subtract_origin_kernel, points.size, [points, vec3d(*np.asarray(origin).tolist()), lost, out])
    return out, lost


def add_origin(points: Points, origin: np.ndarray) -> Positions:
    """Points about an origin in world coordinates, an array of vec3d."""
    return compute(add_origin_kernel, points.size, [points, vec3d(*np.asarray(origin).tolist())], vec3d, points.device)


def shift_rays(rays: Doubles, origin: np.ndarray) -> Scalars:
    """Rays, float64 (6 n) on the device, as float32 with their starts about an origin."""
    return compute(shift_rays_kernel, rays.size, [rays, vec3d(*np.asarray(origin).tolist())], float32, rays.device)
