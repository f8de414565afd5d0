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

DEAR = {"slam, DenseSLAM", "run_system"}  # what they are made of has lines of its own
# What Taichi compiles for ten to forty seconds after a change, as it writes out each call of a function. In `make test`
# their results on Warp are held against NumPy and Open3D.
DEAR |= {"scene, closest points and signs", "rays, all queries", "alpha_shape", "alpha_shape, several"}
DEAR |= {"from_point_cloud_ball_pivoting", "from_point_cloud_ball_pivoting, radii"}
# Whose own kernels take Taichi a second and a half or more to load, compiled before.
DEAR |= {"color_map", "demo, video", "detect_planar_patches", "mvs, estimate_depth_maps, plain wall", "mvs, fuse"}
DEAR |= {"region_growing", "rgbd odometry", "sfm.detect_keypoints, match_keypoints"}
DEAR |= {
    f"mesh, {name}" for name in ("cleaned", "metrics and error map", "remesh_isotropic", "repair", "seams", "sheets")
}
DEAR |= {f"mesh, {name}" for name in ("simplify_quadric_decimation", "texture_from_pictures", "topology")}
DEAR |= {"mesh, triangles that meet"}


def lines(names):
    return [
        pytest.param(name, marks=[pytest.mark.slow] if name in DEAR else [])
        for name in names
        if not name.startswith(ON_HOST) and not name.endswith("far")  # which are the same kernels as near by
    ]


def test_what_is_dear_is_there():
    assert {*ON_CLOUDS, *ONCE} >= DEAR


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


@pytest.mark.parametrize("operation", lines(ON_CLOUDS))
def test_both_compilers_give_a_cloud_the_same_bits(results_agree, operation):
    results_agree(lambda scenes: ON_CLOUDS[operation](scenes.surface))


@pytest.mark.parametrize("operation", lines(ONCE))
def test_both_compilers_give_a_scene_the_same_bits(results_agree, operation):
    results_agree(ONCE[operation])
