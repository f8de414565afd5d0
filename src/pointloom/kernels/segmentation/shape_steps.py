"""Levenberg-Marquardt steps of many shape fits on the device (Marquardt 1963).

One reduction over the rows of all fits, then one thread per fit that evaluates the trial, solves the damped system of
up to seven unknowns by LDL^T, and proposes the next. A fit may also reselect its inliers while they increase. No data
returns to the host before all fits have ended.
"""

from ..lang import array, cross, dot, float64, func, kernel, sqrt, tid, vec3d, vector
from .shape_fit_rows import (
    COUNT_AT,
    ENDED_PHASE,
    FIRST_SUMS_PHASE,
    POSITIONS_AT,
    SELECTION_PHASE,
    SQUARES_AT,
    STEP_PHASE,
    FitRules,
    ShapeFits,
    axis_in,
    fit_sums,
    position_in,
)
from .shape_models import CONE, CYLINDER, PLANE, SPHERE, TORUS

FIRST_DAMPING, MIN_DAMPING, MAX_DAMPING = 1.0e-4, 1.0e-12, 1.0e12
MAX_STEPS = 60
MIN_STEPS = 12  # steps before a fit is given up: true shapes take 2 to 6
SHORT_STEP = 1.0e-12  # of the size of the points: a step as short has no effect
MIN_PIVOT_RATIO = 1.0e-14  # of its diagonal: a smaller pivot leaves its unknown undetermined
MAX_SHAPE_NUMBER = 1.0e300
seven = vector(7, float64)
seven_square = vector(49, float64)


@func
def first_across(a: vec3d, kind: int) -> vec3d:
    e = vec3d(1.0, 0.0, 0.0)
    if abs(a[1]) < abs(a[0]):
        e = vec3d(0.0, 1.0, 0.0)
    if abs(a[2]) < abs(a[0]) and abs(a[2]) < abs(a[1]):
        e = vec3d(0.0, 0.0, 1.0)
    u = cross(e, a)
    u = u / sqrt(dot(u, u))
    if kind == SPHERE:
        u = vec3d(1.0, 0.0, 0.0)
    return u


@func
def third_of(a: vec3d, kind: int) -> vec3d:
    w = a * 1.0
    if kind == SPHERE:
        w = vec3d(0.0, 0.0, 1.0)
    return w


@func
def frame_offer(kind: int, k: int, fits: ShapeFits) -> int:
    a = third_of(axis_in(fits.offers, k), kind)
    u = first_across(a, kind)
    fits.frames[k, 0] = u
    fits.frames[k, 1] = cross(a, u)
    fits.frames[k, 2] = a
    return 0


@func
def is_proper(kind: int, shapes: array(dtype=float64, ndim=2), k: int) -> int:
    proper = 1
    count = int(8)
    for entry in range(count):
        if not abs(shapes[k, entry]) < float64(MAX_SHAPE_NUMBER):
            proper = 0
    if kind != PLANE and not shapes[k, 6] > 0.0:
        proper = 0
    if (kind == CONE or kind == TORUS) and not shapes[k, 7] > 0.0:
        proper = 0
    return proper


@func
def is_allowed(kind: int, shapes: array(dtype=float64, ndim=2), k: int, smallest: float64, largest: float64) -> int:
    allowed = 1
    radius = shapes[k, 6]
    if kind == TORUS:
        radius = shapes[k, 7]
    if kind == SPHERE or kind == CYLINDER or kind == TORUS:
        if not (radius >= smallest and shapes[k, 6] <= largest):
            allowed = 0
    return allowed


@func
def is_free(kind: int, unknown: int) -> int:
    """1 if a kind has an unknown: shifts along u, v and the axis, tilts to u and v, two sizes."""
    free = 1
    if kind == PLANE and (unknown < 2 or unknown > 4):
        free = 0
    if kind == SPHERE and (unknown == 3 or unknown == 4 or unknown == 6):
        free = 0
    if kind == CYLINDER and (unknown == 2 or unknown == 6):
        free = 0
    if kind == CONE and unknown == 6:
        free = 0
    return free


@func
def scale_of(kind: int, unknown: int, size: float64) -> float64:
    scale = float64(1.0)
    if unknown == 3 or unknown == 4 or (unknown == 5 and kind == CONE):
        scale = size * 1.0
    return scale


@func
def free_count(kind: int) -> int:
    count = 0
    n = int(7)
    for i in range(n):
        count += is_free(kind, i)
    return count


@func
def entry_at(row: int, column: int) -> int:
    """Index of the product of two entries of a row, row <= column."""
    return row * 8 - (row * (row - 1)) // 2 + column - row


@func
def damped_step(kind: int, sums: fit_sums, damping: float64, size: float64) -> seven:
    """Step of the damped system, as lengths. Zero for undetermined unknowns."""
    h = seven_square(0.0)
    x = seven(0.0)
    trace = float64(0.0)
    n = int(7)
    for i in range(n):
        if is_free(kind, i) == 1:
            trace += sums[entry_at(i, i)] / (scale_of(kind, i, size) * scale_of(kind, i, size))
    for i in range(n):
        for j in range(i, n):
            both = is_free(kind, i) * is_free(kind, j)
            if both == 1:
                h[7 * i + j] = sums[entry_at(i, j)] / (scale_of(kind, i, size) * scale_of(kind, j, size))
                h[7 * j + i] = h[7 * i + j]
        x[i] = -sums[entry_at(i, 7)] / scale_of(kind, i, size)
        h[7 * i + i] = h[7 * i + i] + damping * (h[7 * i + i] + 1.0e-12 * max(trace, float64(1.0e-300)))
    for i in range(n):  # LDL^T. Fixed unknowns, or those lost to rounding, stay unchanged
        pivot = h[7 * i + i]
        for j in range(i):
            pivot -= h[7 * i + j] * h[7 * i + j] * h[7 * j + j]
        lost = 1 - is_free(kind, i)
        if not pivot > float64(MIN_PIVOT_RATIO) * h[7 * i + i]:
            lost = 1
        for k in range(i + 1, n):
            entry = h[7 * k + i]
            for j in range(i):
                entry -= h[7 * k + j] * h[7 * i + j] * h[7 * j + j]
            h[7 * k + i] = entry / pivot if lost == 0 else float64(0.0)
        for j in range(i):
            x[i] = x[i] - h[7 * i + j] * x[j]
        if lost == 1:
            x[i] = 0.0
        h[7 * i + i] = pivot if lost == 0 else float64(0.0)
    for i in range(n):
        x[i] = x[i] / h[7 * i + i] if h[7 * i + i] > 0.0 else float64(0.0)
    for back in range(n):
        i = 6 - back
        for j in range(i + 1, n):
            x[i] = x[i] - h[7 * j + i] * x[j]
        if not h[7 * i + i] > 0.0:
            x[i] = 0.0
    return x


@func
def offer_step(kind: int, k: int, x: seven, size: float64, fits: ShapeFits) -> float64:
    """Propose the accepted shape plus a step. Returns the longest component."""
    old = axis_in(fits.shapes, k)
    a = third_of(old, kind)
    u = first_across(a, kind)
    v = cross(a, u)
    p = position_in(fits.shapes, k) + u * x[0] + v * x[1] + a * x[2]
    d = old + (u * x[3] + v * x[4]) / size
    d = d / sqrt(dot(d, d))
    r = fits.shapes[k, 6] * 1.0
    s = fits.shapes[k, 7] * 1.0
    if kind == CONE:
        rotation = x[5] / size
        c = fits.shapes[k, 6] - fits.shapes[k, 7] * rotation
        s = fits.shapes[k, 7] + fits.shapes[k, 6] * rotation
        far = sqrt(c * c + s * s)
        r = c / far
        s = s / far
    if kind == SPHERE or kind == CYLINDER or kind == TORUS:
        r = r + x[5]
        s = s + x[6]
    for axis in range(3):
        fits.offers[k, axis] = p[axis]
        fits.offers[k, 3 + axis] = d[axis]
    fits.offers[k, 6] = r
    fits.offers[k, 7] = s
    longest = float64(0.0)
    n = int(7)
    for i in range(n):
        longest = max(longest, abs(x[i]))
    return longest


@func
def take_over(to: array(dtype=float64, ndim=2), values: array(dtype=float64, ndim=2), k: int) -> int:
    count = int(8)
    for entry in range(count):
        to[k, entry] = values[k, entry]
    return 0


@func
def center_offer(kind: int, k: int, sums: fit_sums, fits: ShapeFits) -> int:
    """Move the position of a plane or cylinder along itself to the mean of its rows."""
    moved = fits.frames[k, 2] * (sums[POSITIONS_AT + 2] / sums[COUNT_AT])
    if kind == PLANE:
        moved = (fits.frames[k, 0] * sums[POSITIONS_AT] + fits.frames[k, 1] * sums[POSITIONS_AT + 1]) / sums[COUNT_AT]
    for axis in range(3):
        fits.offers[k, axis] = fits.offers[k, axis] + moved[axis]
    return 0


@func
def end_round(k: int, count: int, fits: ShapeFits) -> int:
    """Next phase after counting inliers: FIRST_SUMS_PHASE, or ENDED_PHASE if they did not increase."""
    phase = int(FIRST_SUMS_PHASE)
    if fits.rounds[k] > 0:
        if count <= fits.best_counts[k]:
            phase = int(ENDED_PHASE)
        else:
            fits.best_counts[k] = count
            fits.best_sums[k] = fits.sums[k]
            take_over(fits.bests, fits.shapes, k)
            if fits.rounds[k] >= fits.max_rounds[k]:
                phase = int(ENDED_PHASE)
    if count == 0:
        phase = int(ENDED_PHASE)
    return phase


@func
def weigh_offer(k: int, trial: fit_sums, rules: FitRules, fits: ShapeFits) -> int:
    """Accept the trial if it is no worse. 1 if the fit has ended."""
    ended = 0
    short = fits.longest[k] <= float64(SHORT_STEP) * rules.size
    proper = is_proper(fits.kinds[k], fits.offers, k)
    if proper == 1 and trial[SQUARES_AT] <= fits.sums[k][SQUARES_AT]:
        gain = fits.sums[k][SQUARES_AT] - trial[SQUARES_AT]
        if short or gain <= rules.gain * trial[SQUARES_AT]:
            ended = 1
        take_over(fits.shapes, fits.offers, k)
        fits.sums[k] = trial
        fits.dampings[k] = max(fits.dampings[k] * 0.1, float64(MIN_DAMPING))
    else:
        if short or fits.dampings[k] > float64(MAX_DAMPING):
            ended = 1
        fits.dampings[k] = fits.dampings[k] * 10.0
    fits.steps[k] = fits.steps[k] + 1
    if fits.steps[k] >= MAX_STEPS:
        ended = 1
    far = fits.sums[k][SQUARES_AT] > rules.hopeless * fits.sums[k][COUNT_AT]
    if rules.hopeless > 0.0 and fits.steps[k] >= MIN_STEPS and far:
        ended = 1
    return ended


@kernel
def step_fits_kernel(rules: FitRules, trials: array(dtype=fit_sums), fits: ShapeFits):
    k = tid()
    phase = fits.phases[k]
    kind = fits.kinds[k]
    if phase != ENDED_PHASE:
        trial = trials[k]
        ended = 0
        needs_sums = 0  # 1 if it needs sums before it continues
        if phase == SELECTION_PHASE:
            phase = end_round(k, int(trial[COUNT_AT]), fits)
            if phase == FIRST_SUMS_PHASE and (kind == PLANE or kind == CYLINDER):
                center_offer(kind, k, trial, fits)
                needs_sums = 1
        if phase == STEP_PHASE:
            ended = weigh_offer(k, trial, rules, fits)
        if phase == FIRST_SUMS_PHASE and needs_sums == 0:
            take_over(fits.shapes, fits.offers, k)
            fits.sums[k] = trial
            fits.dampings[k] = float64(FIRST_DAMPING)
            fits.steps[k] = 0
            phase = int(STEP_PHASE)
            proper = is_proper(kind, fits.shapes, k)
            unknowns = free_count(kind)
            if int(trial[COUNT_AT]) < unknowns or proper == 0:
                ended = 1
        if phase == STEP_PHASE and ended == 0:
            x = damped_step(kind, fits.sums[k], fits.dampings[k], rules.size)
            fits.longest[k] = offer_step(kind, k, x, rules.size, fits)
        if ended == 1:
            fits.rounds[k] = fits.rounds[k] + 1
            take_over(fits.offers, fits.shapes, k)
            phase = int(SELECTION_PHASE)
            allowed = is_allowed(kind, fits.shapes, k, rules.smallest, rules.largest)
            if fits.max_rounds[k] == 0 or allowed == 0:
                phase = int(ENDED_PHASE)
        frame_offer(kind, k, fits)
        fits.phases[k] = phase
        if phase == ENDED_PHASE:
            fits.live[k] = 0


@kernel
def update_running_kernel(fits: ShapeFits):
    i = tid()
    going = 0
    for k in range(fits.live.shape[0]):
        going = max(going, fits.live[k])
    fits.running[i] = going
