"""Taichi gives bitwise the results of Warp for every operation of benchmarks/digests.py, on small scenes.

The tests that take `device` compare Warp's results with Open3D, NumPy and brute force. The two compilers hand out work
to their threads in different chunks; Taichi runs on all cores here and Warp on one.
"""

from __future__ import annotations

import pytest

from pointloom.kernels.lang import cpu_compiler

from .small_scenes import ON_CLOUDS, ON_HOST, ONCE, SmallScenes, digest

pytestmark = pytest.mark.taichi

# Kernels that Taichi compiles for ten to forty seconds each.
NIGHTLY = {
    "scene, closest points and signs", "rays, all queries", "alpha_shape", "alpha_shape, several",
    "create_from_point_cloud_ball_pivoting", "create_from_point_cloud_ball_pivoting, radii",
}  # fmt: skip


def lines(names):
    return [
        pytest.param(name, marks=[pytest.mark.nightly] * (name in NIGHTLY))
        for name in names
        if not name.startswith(ON_HOST) and not name.endswith("far")  # which are the same kernels as near by
    ]


def test_slow_entries_exist():
    assert {*ON_CLOUDS, *ONCE} >= NIGHTLY


@pytest.fixture(scope="module")
def results_agree():
    """A function (operation): both compilers give it the same bits, each on scenes that it has made itself."""
    made = {}

    def check(operation) -> None:
        digests = {}
        for compiler in ("warp", "taichi"):
            with cpu_compiler(compiler):
                made.setdefault(compiler, SmallScenes("cpu"))
                digests[compiler] = digest(operation(made[compiler]))
        assert digests["taichi"] == digests["warp"]

    return check


@pytest.mark.parametrize("operation", lines(ON_CLOUDS))
def test_both_compilers_are_bitwise_identical_on_clouds(results_agree, operation):
    results_agree(lambda scenes: ON_CLOUDS[operation](scenes.surface))


@pytest.mark.parametrize("operation", lines(ONCE))
def test_both_compilers_are_bitwise_identical_on_scenes(results_agree, operation):
    results_agree(ONCE[operation])
