"""Several Python threads on one device get bitwise identical results and leave nothing behind."""

import sys
import threading

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels import lang


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
