"""Two GPUs: an operation on the second never uses the first, and both work in two threads at once."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = Path(__file__).with_name("devices_apart.py")
CHOSEN = ("voxel_down_sample", "estimate_normals, knn", "icp, point to plane", "cluster_dbscan", "tsdf, integrate")


def run(how: str, *names: str) -> dict[str, list[str]]:
    """What devices_apart.py finds, of operations whose names begin so."""
    environment = os.environ | {"EMULATED_CUDA_DEVICES": "2", "POINTLOOM_CPU": "warp"}
    command = [sys.executable, str(PROGRAM), how, *names]
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-3000:]
    report = json.loads(done.stdout.splitlines()[-1])
    assert report["faults"] == []
    assert len(report["found"]) >= len(names)
    return report["found"]


@pytest.mark.parametrize("how", ["one", "both"])
def test_some_operations_keep_to_their_gpu(how):
    faults = run(how, *CHOSEN)
    assert not {name: what for name, what in faults.items() if what}


@pytest.mark.slow
@pytest.mark.slow_on_emulated_cuda("every operation three times and more, a quarter of an hour")
@pytest.mark.parametrize("how", ["one", "both"])
def test_every_operation_keeps_to_its_gpu(how):
    faults = run(how)
    assert not {name: what for name, what in faults.items() if what}
