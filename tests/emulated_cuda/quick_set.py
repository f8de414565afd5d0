"""The tests that CI runs on the emulated device, in order 3: shuffled, and interleaved at memory accesses.

Beside these the device's own tests are in it, of which test_orders.py runs 120 operations in all four orders.
"""

from __future__ import annotations

CHOSEN = {
    "tests/kernels/": "every room of kernels against NumPy and SciPy, on small arrays",
    "tests/pcd/test_cloud.py": "uploads, downloads, moves between devices",
    "tests/pcd/test_interop.py": "arrays of other libraries, streams, pickles",
    "tests/pcd/test_search.py": "searches with results of all sizes",
    "tests/pcd/test_normals.py": "the walk over leaves that most operations share",
    "tests/pcd/test_voxel_down_sample.py": "sort, unique and runs of rows together",
    "tests/pcd/test_clusters.py": "union by atomics",
    "tests/registration/test_icp_input.py": "what a graph must not be given",
    "tests/registration/test_icp_degenerate.py": "loops that the device ends, with solvers that fail",
    "tests/registration/test_icp_rejection.py": "loops with all that rejects pairs",
    "tests/meshing/test_tsdf_integration.py": "blocks that frames touch, volumes that grow",
}


def holds(node: str) -> bool:
    """Whether a test is in the set: a run on the device, in a file or folder that is named."""
    return "cuda:0" in node and node.startswith(tuple(CHOSEN))
