"""Taichi makes of every operation, bit for bit, what Warp makes of it.

The operations are those of benchmarks/digests.py on small scenes. Warp's results are held against Open3D, NumPy and
brute force by the tests that take `device`; so in `make test`, where those run on Warp alone, these are the tests of
Taichi. The two hand out work to their threads in different chunks: what that might change is seen here as well.
"""

from __future__ import annotations

import pytest

from pointloom.kernels.lang import cpu_compiler

from .small_scenes import ON_CLOUDS, ON_HOST, ONCE, SmallScenes, digest

pytestmark = pytest.mark.taichi


@pytest.fixture(scope="module")
def results_agree():
    """A function (operation): both compilers give it the same bits, each on scenes that it has made itself."""
    made = {}

    def check(operation) -> None:
        found = {}
        for compiler in ("warp", "taichi"):
            with cpu_compiler(compiler):
                made.setdefault(compiler, SmallScenes("cpu"))
                found[compiler] = digest(operation(made[compiler]))
        assert found["taichi"] == found["warp"]

    return check


@pytest.mark.parametrize("operation", [name for name in ON_CLOUDS if not name.startswith(ON_HOST)])
def test_both_compilers_give_a_cloud_the_same_bits(results_agree, operation):
    results_agree(lambda scenes: ON_CLOUDS[operation](scenes.surface))


DEAR = ("slam, DenseSLAM", "run_system")  # what they are made of has lines of its own
SCENES = [  # "far" are the same kernels as near by
    pytest.param(name, marks=[pytest.mark.slow] if name in DEAR else [])
    for name in ONCE
    if not name.startswith(ON_HOST) and not name.endswith("far")
]


@pytest.mark.parametrize("operation", SCENES)
def test_both_compilers_give_a_scene_the_same_bits(results_agree, operation):
    results_agree(ONCE[operation])
