"""Registration is bitwise identical for any number of threads, and in several threads at once."""

import os
import subprocess
import sys
import threading

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels import lang

DIGESTS = """
import hashlib, numpy as np, pointloom as loom
reg, rng = loom.registration, np.random.default_rng(3)

def show(*values):
    print(hashlib.sha256(b"".join(np.asarray(value).tobytes() for value in values)).hexdigest())

def cloud(shift):
    xy = rng.uniform(-1, 1, (12000, 2))
    points = np.column_stack([xy, 0.2 * np.sin(3 * xy[:, 0]) * np.cos(4 * xy[:, 1])])
    points[::500] = np.nan
    colors, speeds = rng.random((12000, 3)), rng.random(12000).astype(np.float32)
    return loom.PointCloud(points + shift, colors=colors, dopplers=speeds).estimate_normals(max_nn=12)

source, target = cloud(0.02), cloud(0)
names = "PointToPlane", "Symmetric", "ForColoredICP", "ForDopplerICP", "ForGeneralizedICP"
methods = [getattr(reg, f"TransformationEstimation{name}")() for name in names]
methods += [reg.TransformationEstimationPointToPoint(True)]
methods += [reg.TransformationEstimationForGeneralizedICP(voxel_size=0.1)]
methods += [reg.TransformationEstimationPointToPlane(reg.CauchyLoss(0.02))]
for method in methods:
    r = reg.registration_icp(source, target, 0.1, None, method, reg.ICPConvergenceCriteria(0, 0, 4), overlap=0.9)
    show(r.transformation, r.correspondence_set, r.inlier_rmse)

r = reg.registration_ndt(source, target, reg.NormalDistributionsTransformOption(0.25))
show(r.transformation, r.correspondence_set, r.inlier_rmse)

box = rng.uniform(-1, 1, (3000, 3))
pairs = np.column_stack([np.arange(3000)] * 2)
pairs[300:, 1] = rng.integers(0, 3000, 2700)
clouds = loom.PointCloud(box), loom.PointCloud(box[:, [1, 2, 0]] + 0.01 * rng.normal(size=(3000, 3)))
for r in (
    reg.registration_ransac_based_on_correspondence(*clouds, pairs, 0.03),
    reg.registration_fgr_based_on_correspondence(*clouds, pairs),
    reg.registration_robust_based_on_correspondence(*clouds, pairs[:1500], 0.05),
):
    assert r.fitness > 0.9
    show(r.transformation, r.fitness, r.score, r.iterations)
p = rng.uniform(-1, 1, (8000, 3))
p[:, 2] = 0.2 * np.sin(3 * p[:, 0]) * np.cos(4 * p[:, 1]) + 0.1 * np.sin(7 * p[:, 1] + p[:, 0])
r = reg.register_globally(loom.PointCloud(p[:5000] + 3), loom.PointCloud(p[3000:]), voxel_size=0.06)
show(r.transformation, r.score, r.fitness)

room = rng.uniform(-8, 8, (4000, 3)) * [1, 1, 0.3]
room[np.arange(4000), np.arange(4000) % 3] = np.where(rng.random(4000) < 0.5, -1, 1) * 8.0
odometry = reg.LidarOdometry(max_range=20, min_range=0.5, voxel_size=0.5)
for k in range(4):
    odometry.register(loom.PointCloud(room - [0.4 * k, 0, 0]), np.arange(4000) / 4000)
show(odometry.poses, odometry.map.points)
"""


@pytest.mark.slow
@pytest.mark.slow_on_emulated_cuda("its processes run on the CPU alone")
def test_results_are_bitwise_identical_for_any_number_of_threads():
    runs = []
    for threads in ("1", "2"):
        environment = os.environ | {"POINTLOOM_CPU_THREADS": threads}
        environment["PYTHONPATH"] = os.pathsep.join(p for p in sys.path if p)
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
        runs.append(subprocess.Popen([sys.executable, "-c", DIGESTS], env=environment, **pipes))
    answers = [run.communicate() for run in runs]  # both at once: startup takes longest
    assert [run.returncode for run in runs] == [0, 0], answers
    assert answers[0][0] == answers[1][0] and len(set(answers[0][0].split())) == 14


@pytest.fixture
def eager_threads():
    """Threads that switch a thousand times as often as usual."""
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)
    yield
    sys.setswitchinterval(interval)


@pytest.fixture
def work(device, rng):
    """Operations that launch, copy, sort, scan and record, each as a function that returns all of its numbers."""
    points = rng.random((400, 3))
    source, target = (loom.PointCloud(points + shift, device=device) for shift in (0.0, [0.01, 0, 0]))
    features = rng.random((60, 5)).astype(np.float32)
    return {
        "voxels": lambda: source.voxel_down_sample(0.2).points,
        "registration": lambda: loom.registration.registration_icp(source, target, 0.1).transformation,
        "upload and download": lambda: loom.PointCloud(points, device=device).points,
        "search": lambda: loom.NearestNeighborSearch(source.copy()).radius_search(points[:30], 0.2).sqdists,
        "features": lambda: loom.registration.correspondences_from_features(features, features[::-1], device=device),
        "copies": lambda: source.__deepcopy__({}).select_by_index(np.arange(0, 400, 3)).points,
    }


def run_at_once(tasks):
    """Run (operation, expected numbers, repetitions) in a thread each; return a description of the errors."""
    compiler, faults = lang.current_cpu_compiler(), []

    def repeat(name, operation, expected, times):
        with lang.cpu_compiler(compiler):
            for _ in range(times):
                try:
                    if operation().tobytes() != expected.tobytes():
                        faults.append(f"{name}: other numbers than alone")
                except Exception as error:
                    faults.append(f"{name}: {error!r}")

    threads = [threading.Thread(target=repeat, args=task) for task in tasks]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return sorted(set(faults))


def test_threads_beside_a_registration_disturb_neither(work, eager_threads):
    alone = {name: operation() for name, operation in work.items()}
    beside = ("voxels", "copies")
    tasks = [("registration", work["registration"], alone["registration"], 15)]
    tasks += [(name, work[name], alone[name], 30) for name in beside]
    assert run_at_once(tasks) == []
    np.testing.assert_array_equal(work["registration"](), alone["registration"])


def test_operations_in_threads_are_bitwise_identical_to_single_ones(work, eager_threads):
    alone = {name: operation() for name, operation in work.items()}
    assert run_at_once([(name, operation, alone[name], 8) for name, operation in work.items()]) == []
