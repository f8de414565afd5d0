"""Keep a reconstruction within a closed mesh: octree corners outside it are set to outside.

By the generalized winding number in float64 (Van Oosterom and Strackee, "The solid angle of a plane triangle", IEEE
TBME 30(2), 1983). Each thread reads all triangles, so envelopes should have some thousand triangles at most.
"""

import numpy as np

from ..algebra.transform import widen
from ..array_types import Mask, Points, Scalars, Triangles
from ..lang import (
    array,
    atan2,
    cross,
    dot,
    float32,
    float64,
    func,
    kernel,
    launch,
    length,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
    vec3i,
)
from .octree_levels import BLOCK_SLOTS, OctreeLevel, slot_position
from .sample_cells import Cube

OUTSIDE_VALUE = 0.5  # value of the function there: it rises by 1 across the surface, and is about 0 on it
FULL_ANGLE = 12.566370614359172  # 4 pi


@struct
class Envelope:
    """A closed mesh, its vertices relative to the cloud's origin, and its bounding box."""

    vertices: array(dtype=vec3)
    triangles: array(dtype=vec3i)
    count: int
    low: vec3
    high: vec3

    def __init__(self, vertices: Points, triangles: Triangles, low: np.ndarray, high: np.ndarray) -> None:
        self.vertices, self.triangles, self.count = vertices, triangles, triangles.size
        self.low, self.high = vec3(*low), vec3(*high)


@func
def solid_angle(a: vec3d, b: vec3d, c: vec3d) -> float64:
    la = length(a)
    lb = length(b)
    lc = length(c)
    volume = dot(a, cross(b, c))
    return atan2(volume, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb)


@func
def is_enclosed(p: vec3d, envelope: Envelope) -> int:
    inside = 1
    for axis in range(3):
        if p[axis] < float64(envelope.low[axis]) or p[axis] > float64(envelope.high[axis]):
            inside = 0
    if inside == 1:
        angle = float64(0.0)
        for j in range(envelope.count):
            t = envelope.triangles[j]
            a = widen(envelope.vertices[t[0]]) - p
            b = widen(envelope.vertices[t[1]]) - p
            c = widen(envelope.vertices[t[2]]) - p
            angle += 2.0 * solid_angle(a, b, c)
        if abs(angle) < float64(0.5 * FULL_ANGLE):
            inside = 0
    return inside


@kernel
def fix_outside_kernel(
    level: OctreeLevel, cube: Cube, envelope: Envelope, mask: array(dtype=uint8), values: array(dtype=float32)
):
    """Set the function outside the envelope. Values from the coarser level at the rim stay, for continuity."""
    i = tid()
    if mask[i] != 0:
        color = i // level.count
        slot = BLOCK_SLOTS * (i - color * level.count) + color
        position = slot_position(slot, level)
        x = vec3d(float64(position[0]), float64(position[1]), float64(position[2])) / float64(1 << level.depth)
        if is_enclosed(cube.corner + x * cube.side, envelope) == 0:
            values[slot] = float(OUTSIDE_VALUE)
            mask[i] = 0


def fix_outside(level: OctreeLevel, cube: Cube, envelope: Envelope, mask: Mask, values: Scalars) -> None:
    """Set the values of a level outside an envelope; `mask` marks unknowns by color and block (uint8)."""
    launch(fix_outside_kernel, mask.size, [level, cube, envelope, mask, values])
