"""The harness of the benchmarks on tiny data: its scenes, its checks of results, its report. No times are asserted."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

FOLDER = Path(__file__).resolve().parent.parent / "benchmarks"


@pytest.fixture(scope="module", autouse=True)
def harness() -> Iterator[None]:
    """The benchmarks' folder on the path, as it is when they run, and its modules gone afterward."""
    before = set(sys.modules)
    for path in FOLDER.glob("*.py"):
        sys.modules.pop(path.stem, None)  # another test's module may have the name
    sys.path.insert(0, str(FOLDER))
    yield
    sys.path.remove(str(FOLDER))
    for name in set(sys.modules) - before:
        if str(getattr(sys.modules[name], "__file__", "")).startswith(str(FOLDER)):
            del sys.modules[name]


# ------------------------------------------------------------------------------------------------ scenes


# ------------------------------------------------------------------------------------------------ operations


def test_every_target_names_an_operation_a_size_and_peers_that_run():
    import contest
    import targets

    known = contest.operations()
    for target in targets.TARGETS:
        _, operation = known[target.operation]
        labels = {label for _, _, label in operation.contestants_on("cpu")}
        assert target.size in operation.scenes
        assert set(target.peers) <= labels - {contest.POINTLOOM}


def test_every_operation_has_pointloom_first_and_a_baseline_on_every_device():
    import contest

    for _, operation in contest.operations().values():
        assert operation.memory_size is None or operation.memory_size in operation.scenes
        for device in ("cpu", "cuda:0"):
            labels = [label for _, _, label in operation.contestants_on(device)]
            assert labels[0] == contest.POINTLOOM and len(labels) > 1
            for label in labels:
                contestant, device_name = operation.contestant(label, device)
                assert device_name.split(":")[0] in contestant.devices or label == contest.POINTLOOM


@pytest.mark.parametrize("name", ["voxel_down_sample", "marching_cubes", "knn20_with_build"])
def test_results_agree_with_themselves_and_not_with_a_wrong_result(name):
    import contest
    import scenes

    tiny = {
        "voxel_down_sample": lambda: scenes.bumpy_surface(3000),
        "marching_cubes": lambda: scenes.wavy_ball(16),
        "knn20_with_build": lambda: scenes.spinning_scan(500),
    }
    _, operation = contest.operations()[name]
    contestant = operation.contestants[0]
    scene = tiny[name]()
    facts = contestant.facts(contestant.trial(scene, "cpu").once())
    operation.check(facts, facts, "open3d-legacy")
    wrong = tuple(f[:-1] if isinstance(f, np.ndarray) else f + 1 for f in facts) if isinstance(facts, tuple) else facts
    if wrong is facts:
        wrong = facts + 0.1
    with pytest.raises(AssertionError):
        operation.check(facts, wrong, "open3d-legacy")


# ------------------------------------------------------------------------------------------------ peers


PEERS = {
    "embreex": ("ray_casting", "embreex"),
    "fast-simplification": ("decimation", "fast_simplification"),
    "pyfqmr": ("decimation", "pyfqmr"),
    "meshoptimizer": ("decimation", "meshoptimizer"),
    "fpsample": ("farthest_points", "fpsample"),
    "genz-icp": ("odometry", "genz_icp"),
    "rko-lio": ("odometry", "rko_lio"),
    "numba": ("transform_kernel", "numba"),
    "quadrants": ("transform_kernel", "quadrants"),
    "py4dgeo": ("m3c2", "py4dgeo"),
    "pyransac3d": ("segment_sphere", "pyransac3d"),
}


@pytest.mark.slow
@pytest.mark.parametrize("peer", PEERS)
def test_available_baselines_agree_with_pointloom_at_the_quick_size(peer, monkeypatch):
    import contest

    monkeypatch.delenv("OMP_NUM_THREADS", raising=False)  # py4dgeo warns if it is set
    name, module = PEERS[peer]
    pytest.importorskip(module)
    _, operation = contest.operations()[name]
    (make,) = operation.quick.values()
    scene = make()
    facts = []
    for label in (contest.POINTLOOM, peer):
        contestant, device_name = operation.contestant(label, "cpu")
        facts.append(contestant.facts(contestant.trial(scene, device_name).once()))
    operation.check(*facts, peer)


# ------------------------------------------------------------------------------------------------ memory, launches


# ------------------------------------------------------------------------------------------------ report, run


# ------------------------------------------------------------------------------------------------ first use
