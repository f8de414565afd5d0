"""Voxel traversal of range scans, identical to OctoMap's `OcTreeBaseImpl::computeRayKeys`.

Hornung et al., "OctoMap", Autonomous Robots 34, 2013. After Amanatides and Woo, "A fast voxel traversal algorithm",
Eurographics 1987. Positions and directions are float32, crossings float64 sums. At equal crossings z goes before y
before x. The first pass marks blocks, the second voxels (1 B each).
"""

from ..algebra.transform import narrow, widen
from ..arrays.block_keys import block_key
from ..arrays.hash_table import HashTable, find_position
from ..lang import (
    NAN,
    array,
    float64,
    floor,
    func,
    int32,
    isfinite,
    kernel,
    loop,
    sqrt,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
)
from .tsdf_blocks import BLOCK_VOXELS, NO_CROSSING, BlockMarks, leave_mark, step_along, voxel_in_block

NO_RAY, HIT_RAY, CUT_RAY = 0, 1, 2  # no ray, one with an end point, one that was cut


@struct
class Lattice:
    """Lattice of voxels k * voxel_size .. (k + 1) * voxel_size [m]. `half` [m] is rounded to float32 as in OctoMap."""

    voxel_size: float64
    per_meter: float64
    half: float64

    def __init__(self, voxel_size: float, half: float) -> None:
        self.voxel_size, self.per_meter, self.half = voxel_size, 1.0 / voxel_size, half


@func
def voxel_of(a: float, lattice: Lattice) -> int:
    return int(floor(lattice.per_meter * float64(a)))


@func
def span_of(d: vec3) -> float:
    """Vector length: float32 sum, float64 root, rounded once."""
    square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
    return float(sqrt(float64(square)))


@func
def unit_of(d: vec3) -> vec3:
    span = span_of(d)
    u = d
    if span > 0.0:
        u = vec3(d[0] / span, d[1] / span, d[2] / span)
    return u


@func
def crossing_of(k: int, a: float, d: float, lattice: Lattice) -> float64:
    t = float64(NO_CROSSING)
    if d != 0.0:
        border = (float64(k) + 0.5) * lattice.voxel_size
        if d > 0.0:
            border = border + lattice.half
        else:
            border = border - lattice.half
        t = (border - float64(a)) / float64(d)
    return t


@func
def stride_of(d: float, lattice: Lattice) -> float64:
    t = float64(NO_CROSSING)
    if d != 0.0:
        t = lattice.voxel_size / abs(float64(d))
    return t


@loop
def voxels_on_ray(a: vec3, b: vec3, with_end: int, lattice: Lattice) -> tuple[int, int, int, float64]:
    """Voxels from a to b with their entry distances [m]. The last one only if `with_end` is 1."""
    ray = b - a
    u = unit_of(ray)
    distance = float64(span_of(ray))
    x = voxel_of(a[0], lattice)
    y = voxel_of(a[1], lattice)
    z = voxel_of(a[2], lattice)
    ex = voxel_of(b[0], lattice)
    ey = voxel_of(b[1], lattice)
    ez = voxel_of(b[2], lattice)
    sx = step_along(float64(u[0]))
    sy = step_along(float64(u[1]))
    sz = step_along(float64(u[2]))
    tx = crossing_of(x, a[0], u[0], lattice)
    ty = crossing_of(y, a[1], u[1], lattice)
    tz = crossing_of(z, a[2], u[2], lattice)
    dx = stride_of(u[0], lattice)
    dy = stride_of(u[1], lattice)
    dz = stride_of(u[2], lattice)
    t = float64(0.0)
    going = 1
    if with_end == 0 and x == ex and y == ey and z == ez:
        going = 0
    while going == 1:
        yield x, y, z, t
        if tx < ty and tx < tz:
            t = tx
            x += sx
            tx += dx
        else:
            if tx >= ty and ty < tz:
                t = ty
                y += sy
                ty += dy
            else:
                t = tz
                z += sz
                tz += dz
        if with_end == 1:
            if t > distance:
                going = 0
        else:
            if (x == ex and y == ey and z == ez) or min(tx, min(ty, tz)) > distance:
                going = 0


@struct
class ScanRays:
    """Rays relative to the grid's origin. One start if `shared`. `ends` are NaN and `kinds` NO_RAY for none."""

    lattice: Lattice
    starts: array(dtype=vec3)
    shared: int
    ends: array(dtype=vec3)
    kinds: array(dtype=uint8)

    def __init__(self, lattice: Lattice, starts: object, ends: object, kinds: object) -> None:
        self.lattice, self.starts, self.ends, self.kinds = lattice, starts, ends, kinds
        self.shared = int(starts.size == 1)  # type: ignore[attr-defined]


@func
def start_of(i: int, rays: ScanRays) -> vec3:
    k = i
    if rays.shared == 1:
        k = 0
    return rays.starts[k]


@kernel
def prepare_rays_kernel(
    points: array(dtype=vec3), shift: vec3d, longest: float, rays: ScanRays, infinite: array(dtype=int32)
):
    """End and kind of each ray, cut at `longest` [m]; sets a flag for infinite points."""
    i = tid()
    p = points[i]
    q = narrow(widen(p) + shift)
    kind = NO_RAY
    if isfinite(p):
        a = start_of(i, rays)
        ray = q - a
        kind = HIT_RAY
        if span_of(ray) > longest:
            kind = CUT_RAY
            u = unit_of(ray)
            q = vec3(a[0] + u[0] * longest, a[1] + u[1] * longest, a[2] + u[2] * longest)
    else:
        q = vec3(NAN, NAN, NAN)
        if max(abs(p[0]), max(abs(p[1]), abs(p[2]))) > 1.0e38:
            infinite[0] = 1  # all threads write the same
    rays.ends[i] = q
    rays.kinds[i] = uint8(kind)


@loop
def voxels_by_block(a: vec3, b: vec3, lattice: Lattice):
    """Voxels on a ray, and 1 for the first one in each block, else 0."""
    bx = int(1 << 30)
    by = int(0)
    bz = int(0)
    for x, y, z, _t in voxels_on_ray(a, b, 0, lattice):
        is_entry = int(0)
        if (x >> 3) != bx or (y >> 3) != by or (z >> 3) != bz:
            bx = x >> 3
            by = y >> 3
            bz = z >> 3
            is_entry = 1
        yield x, y, z, is_entry


@kernel
def mark_blocks_kernel(rays: ScanRays, marks: BlockMarks):
    i = tid()
    if int(rays.kinds[i]) != NO_RAY:
        a = start_of(i, rays)
        b = rays.ends[i]
        for x, y, z, is_entry in voxels_by_block(a, b, rays.lattice):
            if is_entry == 1:
                leave_mark(x >> 3, y >> 3, z >> 3, 0, 0, marks)
    if int(rays.kinds[i]) == HIT_RAY:
        q = rays.ends[i]
        ex = voxel_of(q[0], rays.lattice) >> 3
        ey = voxel_of(q[1], rays.lattice) >> 3
        ez = voxel_of(q[2], rays.lattice) >> 3
        leave_mark(ex, ey, ez, 0, 0, marks)


@kernel
def mark_passed_kernel(rays: ScanRays, table: HashTable, rows: array(dtype=int32), flags: array(dtype=uint8)):
    i = tid()
    base = int(0)
    if int(rays.kinds[i]) != NO_RAY:
        a = start_of(i, rays)
        b = rays.ends[i]
        for x, y, z, is_entry in voxels_by_block(a, b, rays.lattice):
            if is_entry == 1:
                base = rows[find_position(block_key(x >> 3, y >> 3, z >> 3), table)] * BLOCK_VOXELS
            flags[base + voxel_in_block(x, y, z)] = 1  # all threads write the same


@kernel
def mark_hits_kernel(rays: ScanRays, table: HashTable, rows: array(dtype=int32), flags: array(dtype=uint8)):
    """2 for each voxel with an end point, overriding passes."""
    i = tid()
    if int(rays.kinds[i]) == HIT_RAY:
        q = rays.ends[i]
        x = voxel_of(q[0], rays.lattice)
        y = voxel_of(q[1], rays.lattice)
        z = voxel_of(q[2], rays.lattice)
        row = rows[find_position(block_key(x >> 3, y >> 3, z >> 3), table)]
        flags[row * BLOCK_VOXELS + voxel_in_block(x, y, z)] = 2  # all threads write the same
