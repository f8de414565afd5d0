"""Host code leaves no sum to BLAS or LAPACK, whose order of sums depends on the processor.

kernels/linear_algebra.py has what takes their place.

The exceptions are in ALLOWED, by file and function, each with the reason.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from .emulated_cuda.kernel_coverage import is_device_code

PACKAGE = Path(__file__).parents[1] / "src" / "pointloom"
PACKAGES = ("cameras", "core", "datasets", "kernels", "meshing", "pcd", "registration", "rgbd", "tiling")
LINALG = {"cholesky", "cond", "det", "eig", "eigh", "eigvals", "eigvalsh", "inv", "lstsq", "matrix_rank", "pinv", "qr"}
LINALG |= {"slogdet", "solve", "svd"}
NUMPY = {"convolve", "corrcoef", "correlate", "cov", "dot", "inner", "matmul", "polyfit", "tensordot", "vdot"}
MAY_HAVE_ONE = re.compile(r"@[\s=]|linalg|\boptimize\b|\.\s*(" + "|".join(sorted(NUMPY)) + r")\s*\(")
SPARSE = "a sparse product, which SciPy adds up itself"
DECIDES = "compared with a limit alone: no bit of it is in a result"
ALLOWED = {
    ("core/checks.py", "check_transformation"): DECIDES,
    ("kernels/language/taichi_compiler.py", "dot"): "device code of Taichi",
    ("kernels/linear_algebra.py", "eigh"): "only the signs are used",
    ("kernels/reconstruction/octree_levels.py", "*"): "whole numbers",
    ("meshing/scene/pinhole_rays.py", "*"): DECIDES,
    **{("pcd/cell_heights.py", name): SPARSE for name in ("cell_variance", "sum_variance", "coarser", "weights")},
    **{("pcd/cell_heights.py", name): SPARSE for name in ("__init__", "center_heights")},
    ("registration/icp/constraint.py", "_check_prior"): DECIDES,
    ("registration/pose_graphs/pose_graph.py", "*"): DECIDES,
    ("registration/pose_graphs/pose_graph_system.py", ""): "SuperLU orders the unknowns, by whole numbers",
    ("registration/pose_graphs/pose_graph_system.py", "linearize"): SPARSE,
    ("registration/stations/adjustment.py", "_cofactors"): SPARSE,
    ("registration/stations/adjustment.py", "_descend"): SPARSE,
    ("registration/stations/adjustment.py", "_null_space"): SPARSE,
    ("registration/stations/stations.py", "*"): DECIDES,
    ("registration/trajectories/similarity.py", "*"): "not yet: cameras aligned to known places",
    ("rgbd/odometry/rgbd_odometry.py", "*"): DECIDES,
}


def is_of_blas(call: ast.Call) -> bool:
    owner, _, name = ast.unparse(call.func).rpartition(".")
    if owner == "np.linalg":
        return name in LINALG or (name == "norm" and len(call.args) == 1 and not call.keywords)
    is_optimized = any(word.arg == "optimize" for word in call.keywords)
    return bool(owner) and (name == "dot" or (owner == "np" and (name in NUMPY or is_optimized)))


def calls_of(node: ast.AST, function: str = "") -> Iterator[tuple[str, str, int]]:
    """The enclosing function, the text and the line of each product and call that BLAS or LAPACK may do."""
    for child in ast.iter_child_nodes(node):
        if is_device_code(child):
            continue
        if isinstance(child, ast.BinOp) and isinstance(child.op, ast.MatMult):
            yield function, "@", child.lineno
        elif isinstance(child, ast.Call) and is_of_blas(child):
            yield function, ast.unparse(child.func), child.lineno
        elif isinstance(child, ast.ImportFrom) and child.module in ("scipy.linalg", "scipy.sparse.linalg"):
            yield function, f"from {child.module}", child.lineno
        yield from calls_of(child, child.name if isinstance(child, ast.FunctionDef) else function)


@cache
def occurrences_in(package: str) -> dict[tuple[str, str], list[str]]:
    """The calls of a package by file and function; "*" means all functions of a file."""
    result: dict[tuple[str, str], list[str]] = {}
    for path in sorted((PACKAGE / package).rglob("*.py")):
        name = path.relative_to(PACKAGE).as_posix()
        source = path.read_text(encoding="utf-8")
        for function, text, line in calls_of(ast.parse(source)) if MAY_HAVE_ONE.search(source) else ():
            key = (name, "*") if (name, "*") in ALLOWED else (name, function)
            result.setdefault(key, []).append(f"{name}:{line}: {text}")
    return result


@pytest.mark.parametrize("package", PACKAGES)
def test_host_code_leaves_no_sum_to_blas(package):
    assert [text for key, texts in occurrences_in(package).items() if key not in ALLOWED for text in texts] == []


def test_every_exception_is_still_there():
    assert ALLOWED.keys() <= {key for package in PACKAGES for key in occurrences_in(package)}
