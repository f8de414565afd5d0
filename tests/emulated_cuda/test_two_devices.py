"""Two GPUs: each has its own clouds, results are the same on both, and what belongs to both is refused by name."""

import re

import pytest

from .processes import START, run

PROGRAM = """
import warp as wp
from pointloom.kernels.language import device_lock

reg = loom.registration
points = np.random.default_rng(0).random((400, 3)).astype(np.float32)
untouched = [loom.free_memory("cuda:1"), wp.get_device("cuda:1").has_context]
first, second = (loom.PointCloud(points, device=f"cuda:{k}") for k in (0, 1))

def results(cloud):
    normals = cloud.voxel_down_sample(0.1).estimate_normals(max_nn=8)
    moved = loom.PointCloud(points + np.float32(0.01), device=cloud.device)
    icp = reg.registration_icp(moved, normals, 0.2, estimation_method=reg.TransformationEstimationPointToPlane())
    assert str(normals.device) == str(moved.device) == str(cloud.device)
    return [a.tolist() for a in (normals.points, normals.normals, icp.transformation)]

def late():
    # a cloud that moves while its own GPU has not made it yet
    cloud = loom.PointCloud(points, device="cuda:0")
    turned = cloud.transform(np.diag([2, 2, 2, 1.0])).to("cuda:1")
    return bool((turned.points == 2.0 * points.astype(np.float64)).all())

found = {
    "same": results(first) == results(second) == results(first.to("cuda:1")) == results(second.to("cuda:0")),
    "late": late(),
    "moved": [str(first.to("cuda:1").device), str(second.to("cpu").device)],
    "untouched": untouched,
    "loops": sorted(device_lock._recording_streams),
    "refused": {
        "sum": attempt(lambda: first + second),
        "icp": attempt(lambda: reg.registration_icp(first, second, 0.2)),
        "distance": attempt(lambda: first.compute_point_cloud_distance(second)),
    },
    "third": attempt(lambda: loom.PointCloud(points, device="cuda:2")),
    "auto": str(loom.PointCloud(points, device="auto").device),
    "faults": installed().findings.faults,
}
print(json.dumps(found))
"""


@pytest.fixture(scope="module")
def report(emulated):
    result = run("-c", START + PROGRAM, EMULATED_CUDA_DEVICES="2", POINTLOOM_CPU="warp")
    assert result["faults"] == []
    return result


def test_moved_clouds_give_bitwise_identical_results(report):
    assert report["same"] and report["loops"] == ["cuda:0", "cuda:1"]


def test_memory_of_an_untouched_gpu_is_freed_without_a_context(report):
    assert report["untouched"] == [0, False]


def test_clouds_move_between_gpus_once_they_are_made_and_auto_is_the_first(report):
    assert (report["late"], report["moved"], report["auto"]) == (True, ["cuda:1", "cpu"], "cuda:0")


def test_operands_on_different_gpus_are_refused_by_name(report):
    for kind, message in report["refused"].values():
        assert kind == "DeviceError"
        assert re.search(r"operands on cuda:(\d) and cuda:(?!\1)(\d); move one with .to\('cuda:\2'\)", message)


def test_the_error_for_a_missing_gpu_lists_the_available_ones(report):
    kind, message = report["third"]
    assert kind == "DeviceError" and "expected one of cpu, cuda:0, cuda:1 or auto, got 'cuda:2'" in message
