"""Two GPUs: an operation on the second never uses the first, and both work in two threads at once."""

from pathlib import Path

import pytest

from .processes import run

PROGRAM = str(Path(__file__).with_name("devices_apart.py"))
CHOSEN = ("voxel_down_sample", "estimate_normals, knn", "icp, point to plane", "cluster_dbscan", "tsdf, integrate")
LONG = pytest.mark.slow_on_emulated_cuda("every operation three times and more, a quarter of an hour")


@pytest.mark.parametrize("how", ["one", "both"])
@pytest.mark.parametrize("names", [CHOSEN, pytest.param((), marks=[pytest.mark.slow, LONG])], ids=["some", "every"])
def test_operations_keep_to_their_gpu(how, names):
    report = run(PROGRAM, how, *names, EMULATED_CUDA_DEVICES="2", POINTLOOM_CPU="warp")
    assert report["faults"] == []
    assert len(report["found"]) >= len(names)
    assert not {name: what for name, what in report["found"].items() if what}
