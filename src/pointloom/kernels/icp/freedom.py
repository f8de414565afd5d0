"""Free motions of registration jobs and the poses of their parameters.

A pose is T = D T0 with D(p) = c + F t + s F R F^T (p - c), pivot c, axes F (columns). Fixed parameters stay 0, so
nothing drifts. R is Rz(yaw) Ry(pitch) Rx(roll), or a quaternion if all rotations are free (no gimbal lock). Float64.
"""

from typing import Any

import numpy as np

from ..algebra.matrices import multiply33
from ..algebra.rigid_solve import euler_motion, rotation_about, square, vec6d
from ..arrays.side_by_side import SideBySide
from ..lang import (
    array,
    atan2,
    cos,
    cross,
    dot,
    float64,
    func,
    int32,
    mat33d,
    mat44d,
    sin,
    sqrt,
    struct,
    vec3d,
    vec4d,
    vector,
)

motion_state = vector(8, float64)  # roll, pitch, yaw [rad] and 0, or a quaternion xyzw; translation [m]. Scale
SHIFT_AT = 4
SCALE_AT = 7
NO_MOTION = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
STILL_TURNING = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
SMALL_ANGLE = 1.0e-4  # [rad] below, the series of the logarithm's derivative is exact to rounding


@struct
class Freedom:
    """Constraints of jobs and their motion. `frame`: axes as columns; `free`: roll, pitch, yaw, x, y, z; `noise` of
    residuals, 0 to estimate it; `firsts`: poses T0; `pivots` [m] under T0; `prior_rotations`: R0 R_p^T; `shifted` [m]:
    pivot offset from prior to T0; `information`: rotation first; `prior_counts`: motions determined only by the prior.
    """

    firsts: array(dtype=mat44d)
    pivots: array(dtype=vec3d)
    states: array(dtype=motion_state)
    prior_rotations: array(dtype=mat33d)
    shifted: array(dtype=vec3d)
    information: array(dtype=square)
    prior_counts: array(dtype=int32)
    free: array(dtype=int32)
    frames: array(dtype=mat33d)
    free_rotation: int
    informed: int
    noise: float64
    residual_count: int

    def __init__(
        self,
        values: dict[str, tuple[np.ndarray, Any]],
        frame: np.ndarray,
        free: np.ndarray,
        *,
        noise: float,
        informed: bool,
        residual_count: int,
        device: Any,
    ) -> None:
        shared = {"free": (free.astype(np.int32), int32), "frames": (frame[None], mat33d)}
        self.storage = SideBySide(values | shared, device)
        vars(self).update(self.storage.arrays)
        self.free_rotation, self.informed, self.noise = int(free[:3].all()), int(informed), noise
        self.residual_count = residual_count


@func
def columns_of(axes: mat33d, column: int) -> vec3d:
    return vec3d(axes[0, column], axes[1, column], axes[2, column])


@func
def rotation_of_state(state: motion_state, free_rotation: int) -> mat44d:
    pose = rotation_about(0.0, 0.0, 0.0, 1.0)
    if free_rotation == 1:
        pose = rotation_about(state[0], state[1], state[2], state[3])
    else:
        pose = euler_motion(vec6d(state[0], state[1], state[2], 0.0, 0.0, 0.0))
    return pose


@func
def target_rotation_of_state(state: motion_state, frame: mat33d, free_rotation: int) -> mat33d:
    """Rotation of a state in target coordinates, F R F^T. Exact identity without rotation."""
    one = float64(1.0)
    zero = float64(0.0)
    rotation = mat33d(one, zero, zero, zero, one, zero, zero, zero, one)
    if free_rotation == 1 or state[0] != 0.0 or state[1] != 0.0 or state[2] != 0.0:
        pose = rotation_of_state(state, free_rotation)
        inner = mat33d(0.0)
        back = mat33d(0.0)
        for i in range(3):
            for j in range(3):
                inner[i, j] = pose[i, j]
                back[i, j] = frame[j, i]
        rotation = multiply33(multiply33(frame, inner), back)
    return rotation


@func
def shift_of_state(state: motion_state, frame: mat33d) -> vec3d:
    """Displacement of the pivot's image in target coordinates."""
    return frame @ vec3d(state[SHIFT_AT], state[SHIFT_AT + 1], state[SHIFT_AT + 2])


@func
def pose_of_state(first: mat44d, pivot: vec3d, frame: mat33d, state: motion_state, free_rotation: int) -> mat44d:
    """Pose of the parameters. Bitwise the first pose if all are 0."""
    scaled_rotation = target_rotation_of_state(state, frame, free_rotation) * state[SCALE_AT]
    shift = shift_of_state(state, frame)
    start = vec3d(first[0, 3], first[1, 3], first[2, 3])
    arm = start - pivot
    rotation = mat33d(0.0)
    for i in range(3):
        for j in range(3):
            rotation[i, j] = first[i, j]
    product = multiply33(scaled_rotation, rotation)
    pose = first * 1.0
    for i in range(3):
        moved = float64(0.0)
        for j in range(3):
            pose[i, j] = product[i, j]
            entry = scaled_rotation[i, j]
            if i == j:
                entry = entry - 1.0
            moved += entry * arm[j]
        pose[i, 3] = start[i] + shift[i] + moved
    return pose


@func
def rotation_axes(state: motion_state, frame: mat33d, free_rotation: int) -> mat33d:
    """Axes of small changes of roll, pitch and yaw, as columns: F (Rz Ry e_x, Rz e_y, e_z)."""
    axes = frame * 1.0
    if free_rotation == 0:
        one = float64(1.0)
        zero = float64(0.0)
        cy = cos(state[1])
        sy = sin(state[1])
        cz = cos(state[2])
        sz = sin(state[2])
        axes = multiply33(frame, mat33d(cz * cy, -sz, zero, sz * cy, cz, zero, -sy, zero, one))
    return axes


@func
def quaternion_of(R: mat33d) -> vec4d:
    """Unit quaternion (x, y, z, w), w >= 0, of a rotation (Shepperd 1978)."""
    trace = R[0, 0] + R[1, 1] + R[2, 2]
    q = vec4d(R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1], 1.0 + trace)
    if R[0, 0] > trace and R[0, 0] >= R[1, 1] and R[0, 0] >= R[2, 2]:
        q = vec4d(1.0 + 2.0 * R[0, 0] - trace, R[1, 0] + R[0, 1], R[0, 2] + R[2, 0], R[2, 1] - R[1, 2])
    elif R[1, 1] > trace and R[1, 1] >= R[2, 2]:
        q = vec4d(R[1, 0] + R[0, 1], 1.0 + 2.0 * R[1, 1] - trace, R[2, 1] + R[1, 2], R[0, 2] - R[2, 0])
    elif R[2, 2] > trace:
        q = vec4d(R[0, 2] + R[2, 0], R[2, 1] + R[1, 2], 1.0 + 2.0 * R[2, 2] - trace, R[1, 0] - R[0, 1])
    length = sqrt(dot(q, q))
    if q[3] < 0.0:
        length = -length
    return q / length


@func
def logarithm(R: mat33d) -> vec3d:
    """Rotation vector, 0 to pi [rad] long."""
    q = quaternion_of(R)
    v = vec3d(q[0], q[1], q[2])
    sine = sqrt(dot(v, v))
    fraction = float64(2.0)
    if sine > 0.0:
        fraction = 2.0 * atan2(sine, q[3]) / sine
    return v * fraction


@func
def change_of_logarithm(v: vec3d, w: vec3d) -> vec3d:
    """Inverse left Jacobian: change of the rotation vector v under a small rotation w."""
    angle = sqrt(dot(v, v))
    fraction = float64(1.0 / 12.0) + angle * angle * float64(1.0 / 720.0)
    if angle > float64(SMALL_ANGLE):
        half = 0.5 * angle
        fraction = (1.0 - half * cos(half) / sin(half)) / (angle * angle)
    change = cross(v, w)
    return w - 0.5 * change + fraction * cross(v, change)
