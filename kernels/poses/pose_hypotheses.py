"""Poses from random samples of correspondences: drawn, checked and scored, all hypotheses of a round at once.

Fischler and Bolles, "Random sample consensus", CACM 1981. Samples are distinct and a function of (seed, number of the
hypothesis). Lengths between their points are compared while they are drawn, since a pose keeps them: most samples end
there, before a pose was fitted. A thread scores GROUP poses on a run of blocks of correspondences, in vector registers
on the CPU; counts are whole numbers, so neither the number of threads nor the compiler changes them. 4 B a sampled
point and 128 B a surviving pose are written.
"""

from ..algebra.rigid_solve import fit_pose, move, pair_sums, sums_of_pair, turn
from ..algebra.transform import widen
from ..arrays.random import random_below, random_bits
from ..lang import (
    array,
    asin,
    atan2,
    atomic_add,
    dot,
    float32,
    float64,
    func,
    int32,
    kernel,
    mat44d,
    sqrt,
    tid,
    uint8,
    vec3,
    vec3d,
    vector,
)
from .pair_fits import BLOCK, source_point, target_point

GROUP = 8  # poses a thread
CPU_RUN, CUDA_RUN = 16, 1  # blocks a thread: few atomics on the CPU, many threads on CUDA
REFUSED = -1  # the score of a hypothesis that a checker refused
COLLAPSED = 1.0e-6  # of the target's extent: a sample that a scaling pose shrinks to less is none
eight_counts = vector(GROUP, int32)


@func
def keep_lengths(p: vec3d, q: vec3d, other_p: vec3d, other_q: vec3d, similarity: float64) -> int:
    """1 where the way between two source points is about as long as that between their targets, and neither is zero."""
    u = p - other_p
    v = q - other_q
    a = dot(u, u)
    b = dot(v, v)
    least = similarity * similarity
    return 0 if a < least * b or b < least * a or a == float64(0.0) or b == float64(0.0) else 1


@kernel
def draw_samples_kernel(
    coordinates: array(dtype=float32),
    count: int,
    seed: int,
    first: int,
    sample_size: int,
    similarity: float64,
    samples: array(dtype=int32),
    kept: array(dtype=uint8),
):
    """Draw sample `first + i`; 1 where all its lengths agree, whatever the rest of the round.

    Floyd's way to draw distinct numbers (Bentley and Floyd, "A sample of brilliance", CACM 1987).
    """
    i = tid()
    base = i * sample_size
    similar = int(1)
    for j in range(sample_size):
        if similar == 1:
            last = count - sample_size + j
            drawn = random_below(random_bits(seed, first + i, j), last + 1)
            for earlier in range(base, base + j):
                if samples[earlier] == drawn:
                    drawn = last + 0
            samples[base + j] = drawn
            p = source_point(coordinates, count, drawn)
            q = target_point(coordinates, count, drawn)
            for earlier in range(base, base + j):
                row = samples[earlier]
                other_p = source_point(coordinates, count, row)
                other_q = target_point(coordinates, count, row)
                if keep_lengths(p, q, other_p, other_q, similarity) == 0:
                    similar = 0
    kept[i] = uint8(similar)


@func
def turns_within(pose: mat44d, scale: float64, limits: vec3d) -> int:
    """1 where none of the angles [rad] of a rotation Rz Ry Rx is larger than its limit."""
    x = abs(atan2(pose[2, 1], pose[2, 2]))
    y = abs(asin(max(min(pose[2, 0] / scale, float64(1.0)), float64(-1.0))))
    z = abs(atan2(pose[1, 0], pose[0, 0]))
    return 1 if x <= limits[0] and y <= limits[1] and z <= limits[2] else 0


@func
def scale_of(pose: mat44d) -> float64:
    """The scale of a similarity."""
    return sqrt(pose[0, 0] * pose[0, 0] + pose[1, 0] * pose[1, 0] + pose[2, 0] * pose[2, 0])


@kernel
def fit_samples_kernel(
    coordinates: array(dtype=float32),
    count: int,
    pairs: array(dtype=int32, ndim=2),
    source_normals: array(dtype=vec3),
    target_normals: array(dtype=vec3),
    samples: array(dtype=int32),
    sample_size: int,
    rows: array(dtype=int32),
    with_scaling: int,
    most_sqdist: float64,
    least_cosine: float64,
    most_rotation: vec3d,
    poses: array(dtype=mat44d),
    scores: array(dtype=int32),
):
    """The pose of each sample whose lengths agree; its score is 0, or REFUSED where a check refuses it."""
    i = tid()
    base = rows[i] * sample_size
    middle_p = source_point(coordinates, count, samples[base])
    middle_q = target_point(coordinates, count, samples[base])
    s = pair_sums(float64(0.0))
    for j in range(base, base + sample_size):  # about the first point: the sums of a small sample lose no digits
        p = source_point(coordinates, count, samples[j]) - middle_p
        q = target_point(coordinates, count, samples[j]) - middle_q
        s += sums_of_pair(p, q, float64(1.0))
    pose = fit_pose(s, with_scaling)
    scale = scale_of(pose)
    score = int(0)
    if scale * scale * s[16] < float64(COLLAPSED * COLLAPSED) * s[17]:
        score = REFUSED
    shift = middle_q - turn(pose, middle_p)
    for axis in range(3):
        pose[axis, 3] = pose[axis, 3] + shift[axis]
    for j in range(base, base + sample_size):
        row = samples[j]
        r = move(pose, source_point(coordinates, count, row)) - target_point(coordinates, count, row)
        if dot(r, r) > most_sqdist:
            score = REFUSED
        if source_normals.shape[0] > 0:
            n = turn(pose, widen(source_normals[pairs[row, 0]]))
            if dot(n, widen(target_normals[pairs[row, 1]])) < least_cosine * scale:
                score = REFUSED
    if turns_within(pose, scale, most_rotation) == 0:
        score = REFUSED
    poses[i] = pose
    scores[i] = score


@kernel
def score_poses_kernel(
    coordinates: array(dtype=float32),
    count: int,
    run: int,
    poses: array(dtype=mat44d),
    pose_count: int,
    limit: float,
    scores: array(dtype=int32),
):
    """How many correspondences lie closer than a squared distance under each pose; whole sums, in any order."""
    i = tid()
    groups = (pose_count + GROUP - 1) // GROUP
    head = (i // groups) * run
    start = (i % groups) * GROUP
    size = min(GROUP, pose_count - start)
    totals = eight_counts(0)
    for block in range(head, min(head + run, (count + BLOCK - 1) // BLOCK)):
        first = block * BLOCK
        last = min(first + BLOCK, count)
        for k in range(size):
            if scores[start + k] != REFUSED:
                pose = poses[start + k]
                r00 = float(pose[0, 0])
                r01 = float(pose[0, 1])
                r02 = float(pose[0, 2])
                r10 = float(pose[1, 0])
                r11 = float(pose[1, 1])
                r12 = float(pose[1, 2])
                r20 = float(pose[2, 0])
                r21 = float(pose[2, 1])
                r22 = float(pose[2, 2])
                tx = float(pose[0, 3])
                ty = float(pose[1, 3])
                tz = float(pose[2, 3])
                found = int(0)
                for j in range(first, last):
                    px = coordinates[j]
                    py = coordinates[count + j]
                    pz = coordinates[2 * count + j]
                    x = r00 * px + r01 * py + r02 * pz + tx - coordinates[3 * count + j]
                    y = r10 * px + r11 * py + r12 * pz + ty - coordinates[4 * count + j]
                    z = r20 * px + r21 * py + r22 * pz + tz - coordinates[5 * count + j]
                    if x * x + y * y + z * z < limit:
                        found += 1
                totals[k] = totals[k] + found
    for k in range(size):
        if totals[k] > 0:
            atomic_add(scores, start + k, totals[k])
