"""The tests that CI runs on the emulated device, in order 3: shuffled, and interleaved at memory accesses.

Beside these the device's own tests are in it; its test_orders.py compares every operation in order 0 and in order 3.
"""

from __future__ import annotations

CHOSEN = {
    "tests/kernels/": "every room of kernels against NumPy and SciPy, on small arrays",
    "tests/pcd/test_cloud.py": "uploads, downloads, moves between devices",
    "tests/pcd/test_interop.py": "arrays of other libraries, streams, pickles",
    "tests/registration/test_icp_input.py": "graphs over clouds that are empty, few, not finite or far apart",
    "tests/meshing/test_tsdf_integration.py": "blocks that frames touch, volumes that grow",
}


def holds(node: str) -> bool:
    """Whether a test is in the set: a run on the device, in a file or folder that is named."""
    return "cuda:0" in node and node.startswith(tuple(CHOSEN))
