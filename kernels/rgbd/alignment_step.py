"""From the sums over the pixels to the next pose, the noise and the exposure: one thread, in float64."""

from ..algebra.matrices import multiply44
from ..algebra.rigid_solve import place_of, small_motion, solve_system, triangle, vec6d
from ..lang import array, float64, func, kernel, mat44d, sqrt, tid, vec4
from .alignment_rows import (
    BRIGHTNESS_COUNT,
    BRIGHTNESS_ERROR,
    SHADES,
    SURFACE_COUNT,
    SURFACE_ERROR,
    AlignmentRules,
    AlignmentState,
    row_sums,
)
from .pyramid import FrameLevels

DAMPING = 1.0e-6  # of the diagonal: keeps what the pixels do not determine where it is
LEAST_PIXELS = 12.0  # fewer determine nothing
LEAST_NOISE, MOST_NOISE = 0.25, 100.0  # factor on the variance of depth
LEAST_SHADE_NOISE, MOST_SHADE_NOISE = 0.004, 0.2  # deviation of brightness, 0..1
LEAST_GAIN, MOST_GAIN = 0.5, 2.0  # of an exposure that changes
LEAST_VARIANCE = 1.0e-4  # of brightness: flatter pictures tell no gain


@func
def damped_solution(total: row_sums) -> vec6d:
    """The step that the sums ask for."""
    h = triangle(0.0)
    b = vec6d(0.0)
    n = int(6)
    m = int(21)
    for k in range(m):
        h[k] = total[k]
    for k in range(n):
        at = place_of(k, k)
        h[at] = h[at] * (1.0 + float64(DAMPING)) + 1.0e-12
        b[k] = -total[21 + k]
    return solve_system(h, b)


@func
def bounded(value: float64, least: float64, most: float64) -> float64:
    """The value within limits."""
    return min(max(value, least), most)


@func
def set_warps(level: int, source: FrameLevels, pose: mat44d, warps: array(dtype=vec4)):
    """The rays of a level's pixels under a pose: u w0 + v w1 + w2, and the translation beside them."""
    lens = source.lenses[level]
    fx = float64(lens[0])
    fy = float64(lens[1])
    cx = float64(lens[2])
    cy = float64(lens[3])
    a = vec4(float(pose[0, 0] / fx), float(pose[1, 0] / fx), float(pose[2, 0] / fx), float(pose[0, 3]))
    b = vec4(float(pose[0, 1] / fy), float(pose[1, 1] / fy), float(pose[2, 1] / fy), float(pose[1, 3]))
    c = vec4(
        float(pose[0, 2] - pose[0, 0] * cx / fx - pose[0, 1] * cy / fy),
        float(pose[1, 2] - pose[1, 0] * cx / fx - pose[1, 1] * cy / fy),
        float(pose[2, 2] - pose[2, 0] * cx / fx - pose[2, 1] * cy / fy),
        float(pose[2, 3]),
    )
    warps[0] = a
    warps[1] = b
    warps[2] = c


@func
def learn_noise(total: row_sums, state: AlignmentState):
    """The variances of the residuals and the exposure under the latest pose, for the next step."""
    count = total[SURFACE_COUNT]
    if count > float64(LEAST_PIXELS):
        variance = bounded(total[SURFACE_ERROR] / count, float64(LEAST_NOISE), float64(MOST_NOISE))
        state.scales[0] = float(1.0 / variance)
    count = total[BRIGHTNESS_COUNT]
    if count > float64(LEAST_PIXELS):
        least = float64(LEAST_SHADE_NOISE) * float64(LEAST_SHADE_NOISE)
        most = float64(MOST_SHADE_NOISE) * float64(MOST_SHADE_NOISE)
        state.scales[1] = float(1.0 / bounded(total[BRIGHTNESS_ERROR] / count, least, most))
        weight = total[SHADES]
        source = total[SHADES + 1] / weight
        target = total[SHADES + 2] / weight
        source_variance = total[SHADES + 3] / weight - source * source
        target_variance = total[SHADES + 4] / weight - target * target
        gain = float64(1.0)
        if min(source_variance, target_variance) > float64(LEAST_VARIANCE):
            gain = bounded(sqrt(target_variance / source_variance), float64(LEAST_GAIN), float64(MOST_GAIN))
        state.scales[2] = float(gain)
        state.scales[3] = float(target - gain * source)


@kernel
def step_alignment_kernel(
    source: FrameLevels, rules: AlignmentRules, sums: array(dtype=row_sums), state: AlignmentState
):
    """Move the pose, and go on to the next level where the step was short or there were enough. One thread."""
    i = tid()
    level = state.counts[i]
    total = sums[level]
    learn_noise(total, state)
    state.counts[2] = state.counts[2] + 1
    taken = state.counts[1] + 1
    done = 0
    pose = state.pose[0]
    if total[SURFACE_COUNT] + total[BRIGHTNESS_COUNT] < float64(LEAST_PIXELS):
        done = 1
    else:
        x = damped_solution(total)
        turned = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2])
        moved = sqrt(x[3] * x[3] + x[4] * x[4] + x[5] * x[5])
        if turned < 1.0 and moved < 2.0:  # else, or NaN: the step is rejected
            pose = multiply44(small_motion(x), pose)
            state.pose[0] = pose
            limit = float64(rules.short_step) / float64(source.lenses[level][0])
            if taken > 1 and turned < limit and moved < limit:
                done = 1
        else:
            done = 1
    if taken >= state.most_steps[level]:
        done = 1
    if done == 1:
        state.live[level] = 0
        level = level - 1
        taken = 0
        if level >= rules.first_level:
            state.live[level] = 1
            state.counts[0] = level
        else:
            state.running[0] = 0
    state.counts[1] = taken
    if level >= rules.first_level:
        set_warps(level, source, pose, state.warps)


@kernel
def begin_alignment_kernel(source: FrameLevels, level: int, state: AlignmentState):
    """The first level's rays. One thread."""
    i = tid()
    set_warps(level, source, state.pose[i], state.warps)
