"""Image poses with consistent vertex brightness (Zhou and Koltun 2014, eqs. 2 to 9): alternates vertex means and a
Gauss-Newton step per image, with Levenberg-Marquardt damping. Steps that increase the mean square are reverted.
Brightness is bilinear, and derivatives match.
"""

import numpy as np

from ..algebra.matrices import multiply44
from ..algebra.rigid_solve import small_motion, solve_system, triangle, triangle_index, vec6d
from ..array_types import Device, Points
from ..arrays.segment_blocks import SegmentBlocks
from ..lang import (
    array,
    float64,
    func,
    int32,
    kernel,
    launch,
    mat44d,
    reduce_segments,
    segment_reduction,
    struct,
    tid,
    vec3,
    vector,
)
from ..memory import empty, full, upload, zeros
from .stacked_images import (
    StackedImages,
    Warps,
    camera_position,
    is_inside,
    pixel,
    project_vertex,
    shade,
    shade_at,
    warp_at,
    warp_sample,
)
from .vertex_views import Sightings

SQUARES_COLUMN, COUNT_COLUMN = 27, 28  # behind 21 of the matrix and 6 of the right side
pose_sums = vector(29, float64)
# 1 if the pair counts, residual, derivatives by the pose's 6 unknowns, image gradient, column, row
pair_row = vector(12, float64)
MISSING_BRIGHTNESS = -1.0  # brightness of a vertex that is not in an image
FIRST_DAMPING = 1.0e-6  # of the diagonal: negligible unless a step fails
MIN_DAMPING, MAX_DAMPING = 1.0e-9, 1.0e4  # above the maximum a step is negligible
DAMPING_DECREASE, DAMPING_INCREASE = 0.1, 10.0  # factors of the damping after good and bad steps
MIN_DECREASE = 1.0e-6  # minimum relative decrease of the mean square


@struct
class SearchState:
    """`iterations`: done and maximum; `error`: initial, best, damping, latest; `outcome`: 1 if the latest was best."""

    running: array(dtype=int32)
    iterations: array(dtype=int32)
    error: array(dtype=float64)
    outcome: array(dtype=int32)

    def __init__(self, max_iterations: int, device: Device) -> None:
        self.running = full(1, 1, int32, device)
        self.iterations = upload(np.array([0, max_iterations]), int32, device)
        self.error = upload(np.array([-1.0, -1.0, FIRST_DAMPING, 0.0]), float64, device)
        self.outcome = zeros(1, int32, device)


@kernel
def average_brightness_kernel(
    vertices: array(dtype=vec3),
    sightings: Sightings,
    stack: StackedImages,
    warps: Warps,
    samples: array(dtype=shade),
    proxies: array(dtype=float64),
):
    """Samples of a vertex in its images, and their mean brightness. 0 without any."""
    i = tid()
    total = float64(0.0)
    count = float64(0.0)
    for k in range(sightings.starts[i], sightings.starts[i + 1]):
        pair = sightings.order[k]
        image = sightings.images[pair]
        projected = project_vertex(vertices[i], image, stack)
        warp = warp_at(projected[0], projected[1], image, warps)
        sampled = sample_pair(projected, warp, image, stack)
        samples[pair] = sampled
        if sampled[0] >= 0.0:
            total += sampled[0]
            count += 1.0
    if count > 0.0:
        total = total / count
    proxies[i] = total


@func
def sample_pair(projected: pixel, warp: warp_sample, image: int, stack: StackedImages) -> shade:
    """Brightness and gradient of a warped vertex. MISSING_BRIGHTNESS, 0, 0 if it is outside or in the margin."""
    sampled = shade(MISSING_BRIGHTNESS, 0.0, 0.0)
    if projected[2] > 0.0:
        u = projected[0]
        v = projected[1]
        inside = is_inside(u, v, image, stack.margin, stack)
        inside += is_inside(u + warp[0], v + warp[1], image, stack.margin, stack)
        if inside == 2:
            sampled = shade_at(u + warp[0], v + warp[1], image, stack)
    return sampled


@func
def pair_row_of(p: vec3, image: int, sampled: shade, proxy: float64, stack: StackedImages, warps: Warps) -> pair_row:
    """Row of a sample. Zero without one."""
    counts = sampled[0] >= 0.0
    q = camera_position(p, image, stack)
    lens = stack.lenses[image]
    x = q[0] if counts else 0.0
    y = q[1] if counts else 0.0
    z = q[2] if counts else 1.0
    inverse = 1.0 / z
    u = lens[0] * x * inverse + lens[2]
    v = lens[1] * y * inverse + lens[3]
    warp = warp_at(u, v, image, warps)
    a = (sampled[1] * (1.0 + warp[2]) + sampled[2] * warp[3]) * lens[0] * inverse
    b = (sampled[1] * warp[4] + sampled[2] * (1.0 + warp[5])) * lens[1] * inverse
    c = -(a * x + b * y) * inverse
    residual = sampled[0] - proxy if counts else 0.0
    count = float64(1.0) if counts else 0.0
    return pair_row(count, residual, y * c - z * b, z * a - x * c, x * b - y * a, a, b, c, sampled[1], sampled[2], u, v)


@func
def measure_pair(p: vec3, image: int, proxy: float64, stack: StackedImages, warps: Warps) -> pair_row:
    """Row of an image and a vertex. Zero if the vertex is outside or in the margin."""
    projected = project_vertex(p, image, stack)
    warp = warp_at(projected[0], projected[1], image, warps)
    sampled = sample_pair(projected, warp, image, stack)
    return pair_row_of(p, image, sampled, proxy, stack, warps)


@segment_reduction
def sum_pair_rows(
    vertices: array(dtype=vec3),
    sightings: Sightings,
    proxies: array(dtype=float64),
    samples: array(dtype=shade),
    stack: StackedImages,
    warps: Warps,
) -> pose_sums:
    """Normal equations of an image's pose, squared residuals and pair count."""
    i = tid()
    vertex = sightings.vertices[i]
    row = pair_row_of(vertices[vertex], sightings.images[i], samples[i], proxies[vertex], stack, warps)
    r = row[1]
    a = row[2]
    b = row[3]
    c = row[4]
    d = row[5]
    e = row[6]
    f = row[7]
    return pose_sums(
        a * a, a * b, a * c, a * d, a * e, a * f, b * b, b * c, b * d, b * e, b * f, c * c, c * d, c * e, c * f,
        d * d, d * e, d * f, e * e, e * f, f * f, a * r, b * r, c * r, d * r, e * r, f * r, r * r, row[0],
    )  # fmt: skip


@kernel
def judge_iteration_kernel(sums: array(dtype=pose_sums), ties: array(dtype=float64), state: SearchState):
    """Accept or reject the latest poses, and set the damping; `ties` are squares of warp anchors. One thread."""
    i = tid()
    squares = float64(0.0)
    count = float64(0.0)
    for k in range(sums.shape[0]):
        squares += sums[k][SQUARES_COLUMN] + ties[k]
        count += sums[k][COUNT_COLUMN]
    error = squares / max(count, 1.0)
    best = state.error[1]
    damping = state.error[2]
    outcome = 1
    running = 1
    if best < 0.0:
        state.error[i] = error
        state.error[1] = error
    else:
        if error <= best and count > 0.0:
            if best - error <= float64(MIN_DECREASE) * best:
                running = 0
            state.error[1] = error
            damping = max(damping * float64(DAMPING_DECREASE), float64(MIN_DAMPING))
        else:
            outcome = 0
            damping = damping * float64(DAMPING_INCREASE)
            if damping > float64(MAX_DAMPING):
                running = 0
    if state.iterations[0] >= state.iterations[1] or count == 0.0:
        running = 0
    state.iterations[0] = state.iterations[0] + 1
    state.error[2] = damping
    state.error[3] = error
    state.outcome[i] = outcome
    state.running[i] = running


@func
def damped_step(total: pose_sums, damping: float64) -> vec6d:
    h = triangle(0.0)
    b = vec6d(0.0)
    n = int(6)
    m = int(21)
    for k in range(m):
        h[k] = total[k]
    for k in range(n):
        at = triangle_index(k, k)
        h[at] = h[at] * (1.0 + damping)
        b[k] = -total[21 + k]
    return solve_system(h, b)


@kernel
def keep_best_kernel(
    state: SearchState,
    sums: array(dtype=pose_sums),
    poses: array(dtype=mat44d),
    best_sums: array(dtype=pose_sums),
    best_poses: array(dtype=mat44d),
):
    """Keep the best poses and sums, else restore them. One thread per image."""
    i = tid()
    if state.outcome[0] == 1:
        best_sums[i] = sums[i]
        best_poses[i] = poses[i]
    else:
        poses[i] = best_poses[i]


@kernel
def step_poses_kernel(state: SearchState, best_sums: array(dtype=pose_sums), poses: array(dtype=mat44d)):
    """Step each image from its best pose. One thread per image."""
    i = tid()
    if state.running[0] == 1 and best_sums[i][COUNT_COLUMN] > 0.0:
        poses[i] = multiply44(small_motion(damped_step(best_sums[i], state.error[2])), poses[i])


class ColorSearch:
    """Arrays and iterations of a pose search over `stack`, whose poses change. Vertices about their origin."""

    def __init__(
        self, vertices: Points, sightings: Sightings, stack: StackedImages, warps: Warps, max_iterations: int
    ) -> None:
        device, count = vertices.device, stack.count
        self.vertices, self.sightings, self.images, self.warps = vertices, sightings, stack, warps
        firsts = np.concatenate([[0], np.cumsum(sightings.counts)[:-1]])
        self.blocks = SegmentBlocks(firsts, sightings.counts, device)
        self.live = full(count, 1, int32, device)
        self.partials = self.blocks.partials(pose_sums)
        self.sums, self.best_sums = zeros(count, pose_sums, device), zeros(count, pose_sums, device)
        self.best_poses = zeros(count, mat44d, device)
        self.samples = empty(sightings.count, shade, device)
        self.proxies, self.ties = zeros(vertices.size, float64, device), zeros(count, float64, device)
        self.state = SearchState(max_iterations, device)

    def measure(self) -> None:
        """Evaluate means, sums and acceptance at the current poses."""
        shared = [self.images, self.warps]
        averaged = [self.vertices, self.sightings, *shared, self.samples, self.proxies]
        launch(average_brightness_kernel, self.vertices.size, averaged)
        given = [self.vertices, self.sightings, self.proxies, self.samples, *shared]
        reduce_segments(sum_pair_rows, self.blocks, self.live, given, self.partials, self.sums)

    def judge(self) -> None:
        """Accept or reject, and keep or restore the best poses."""
        launch(judge_iteration_kernel, 1, [self.sums, self.ties, self.state])
        arguments = [self.state, self.sums, self.images.poses, self.best_sums, self.best_poses]
        launch(keep_best_kernel, self.images.count, arguments)

    def iterate_rigid(self) -> None:
        self.measure()
        self.judge()
        launch(step_poses_kernel, self.images.count, [self.state, self.best_sums, self.images.poses])
