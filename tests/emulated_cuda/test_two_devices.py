"""Two GPUs: each has its own clouds, results are the same on both, and what belongs to both is refused by name."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PROGRAM = f"""
import sys
sys.path[:0] = [{str(ROOT / "src")!r}, {str(ROOT / "tests")!r}]
from emulated_cuda.install import install, installed
install()
import json
import numpy as np
import pointloom as loom
from pointloom.kernels.language import device_lock

reg = loom.registration
points = np.random.default_rng(0).random((400, 3)).astype(np.float32)
depth, camera = np.full((12, 16), 0.8, np.float32), loom.PinholeCameraIntrinsic(16, 12, 14.0, 14.0, 8.0, 6.0)
clouds = [loom.PointCloud(points, device=f"cuda:{{k}}") for k in (0, 1)]

def results(cloud):
    device = str(cloud.device)
    normals = cloud.voxel_down_sample(0.1).estimate_normals(max_nn=8)
    moved = loom.PointCloud(points + np.float32(0.01), device=device)
    icp = reg.registration_icp(moved, normals, 0.2, estimation_method=reg.TransformationEstimationPointToPlane())
    volume = loom.TSDFVolume(voxel_size=0.05, color=False, device=device)
    volume.integrate(depth, camera, np.eye(4))
    fused = volume.extract_point_cloud()
    assert {{str(c.device) for c in (normals, moved, fused)}} == {{device}}
    labels = np.asarray(cloud.cluster_dbscan(0.1, 4))
    return [a.tolist() for a in (normals.points, normals.normals, icp.transformation, fused.points, labels)]

def attempt(action):
    try:
        action()
    except Exception as error:
        return [type(error).__name__, str(error)]
    return ["none", ""]

def late():
    # a cloud that moves while its own GPU has not made it yet
    cloud = loom.PointCloud(points, device="cuda:0")
    turned = cloud.transform(np.diag([2, 2, 2, 1.0])).to("cuda:1")
    return bool((turned.points == 2.0 * points.astype(np.float64)).all())

first, second = clouds
found = {{
    "same": results(first) == results(second) == results(first.to("cuda:1")) == results(second.to("cuda:0")),
    "late": late(),
    "moved": [str(first.to("cuda:1").device), str(second.to("cpu").device)],
    "loops": sorted(device_lock._recording_streams),
    "refused": {{
        "sum": attempt(lambda: first + second),
        "icp": attempt(lambda: reg.registration_icp(first, second, 0.2)),
        "distance": attempt(lambda: first.compute_point_cloud_distance(second)),
    }},
    "third": attempt(lambda: loom.PointCloud(points, device="cuda:2")),
    "auto": str(loom.PointCloud(points, device="auto").device),
    "faults": installed().findings.faults,
}}
print(json.dumps(found))
"""


@pytest.fixture(scope="module")
def report(emulated):
    environment = os.environ | {"EMULATED_CUDA_DEVICES": "2", "POINTLOOM_CPU": "warp"}
    done = subprocess.run([sys.executable, "-c", PROGRAM], env=environment, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr[-3000:]
    result = json.loads(done.stdout.splitlines()[-1])
    assert result["faults"] == []
    return result


def test_operations_on_the_second_gpu_are_bitwise_identical(report):
    assert report["same"]
    assert report["loops"] == ["cuda:0", "cuda:1"]


def test_a_cloud_moves_once_its_own_gpu_has_made_it(report):
    assert report["late"]


def test_clouds_move_between_gpus_and_auto_is_the_first(report):
    assert (report["moved"], report["auto"]) == (["cuda:1", "cpu"], "cuda:0")


def test_operands_on_different_gpus_are_refused_by_name(report):
    for kind, message in report["refused"].values():
        assert kind == "DeviceError"
        assert re.search(r"operands on cuda:(\d) and cuda:(?!\1)(\d); move one with .to\('cuda:\2'\)", message)


def test_the_error_for_a_missing_gpu_lists_the_available_ones(report):
    kind, message = report["third"]
    assert kind == "DeviceError" and "expected one of cpu, cuda:0, cuda:1 or auto, got 'cuda:2'" in message
