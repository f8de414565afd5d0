"""The tests that CI runs on the emulated device, in order 3: shuffled, and interleaved at memory accesses.

Beside these the device's own tests are in it; its test_orders.py compares every operation in order 0 and in order 3.
"""

from __future__ import annotations

CHOSEN = {
    "tests/kernels/": "every room of kernels against NumPy and SciPy, on small arrays",
    "tests/pcd/test_cloud.py": "uploads, downloads, moves between devices",
    "tests/pcd/test_interop.py": "arrays of other libraries, streams, pickles",
    "tests/registration/test_icp_input.py": "graphs over clouds that are empty, few, not finite or far apart",
    "tests/registration/test_icp_freedom.py::test_the_pose_is": "steps of jobs that may move in some ways only",
    "tests/registration/test_icp_freedom.py::test_a_batch_has": "pivots and priors of each job, a job without pairs",
    "tests/registration/test_icp_freedom.py::test_empty_clouds": "one point, no scale to estimate",
    "tests/registration/test_icp_prior.py::test_half_a_turn": "logarithms of all rotations",
    "tests/registration/test_icp_prior.py::test_a_prior_that": "motions that a prior alone determines",
    "tests/registration/test_nonrigid.py::test_fewer_nodes": "a graph of one node",
    "tests/registration/test_nonrigid.py::test_points_that": "a few steps of a body with points that are not finite",
    "tests/registration/test_nonrigid.py::test_the_far_side": "pairs that their normals exclude",
    "tests/meshing/test_tsdf_integration.py": "blocks that frames touch, volumes that grow",
    "tests/meshing/test_splat_fusion.py::test_views_of": "the surface and colors of splats",
    "tests/meshing/test_mesh_cutting.py": "clips and slices of meshes",
    "tests/pcd/test_visibility.py": "hidden points",
    "tests/pcd/test_splat_pictures.py": "splats of pixels, before and behind what is solid",
    "tests/photogrammetry/mvs/test_plane_priors.py": "planes of image regions without texture",
}


def holds(node: str) -> bool:
    """Whether a test is in the set: a run on the device, in a file or folder that is named."""
    return "cuda:0" in node and node.startswith(tuple(CHOSEN))
