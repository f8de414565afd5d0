"""No file, function or kernel grows past what a reader holds in mind; the few that do are listed with the reason."""

import ast
import gc
from collections.abc import Iterator

import pytest

from scripts.check_types import is_device_code

from .test_imports import ROOT, modules

FILE_LINES = 800
FUNCTION_LINES = 60
KERNEL_LINES = 60
KERNEL_PARAMETERS = 14

# What is longer, and why. An entry that nobody needs any more is a fault too.
LONG_FILES: dict[str, str] = {}
LONG_FUNCTIONS: dict[str, str] = {}
LONG_KERNELS: dict[str, str] = {
    "kernels/icp/correspondences.py:match_lanes_kernel": "one warp's walk: its state lives between the ballots",
    "kernels/rays/nearest_of_lanes.py:find_nearest_of_lanes": "one warp's walk, likewise",
    "kernels/reconstruction/alpha_stars.py:grow_star": "one call site, as Taichi writes every call of a function out",
    "kernels/search/nearest_point.py:find_nearest_kernel": "the walk's stack stays in registers only within one body",
    "kernels/volumes/integrate.py:integrate_depth_kernel": "CPU vector code over rows of a block that are local arrays",
    "kernels/volumes/tsdf_raycast.py:cast_rays_kernel": "one march over the state of a ray, which lives in registers",
}
MANY_PARAMETERS: dict[str, str] = {}


def measure(source: str, path: str) -> dict[str, dict[str, int]]:
    """What a file has beyond the budgets: of which kind, under which name, and how much of it."""
    beyond: dict[str, dict[str, int]] = {"file": {}, "function": {}, "kernel": {}, "parameters": {}}
    if (count := source.count("\n")) > FILE_LINES:
        beyond["file"][path] = count
    for node in ast.walk(ast.parse(source)):
        if not isinstance(node, ast.FunctionDef):
            continue
        name, device = f"{path}:{node.name}", is_device_code(node)  # there the compilers ask for one function
        lines = lines_of_code(node)
        if lines > (KERNEL_LINES if device else FUNCTION_LINES):
            beyond["kernel" if device else "function"][name] = lines
        if device and len(node.args.args) > KERNEL_PARAMETERS:
            beyond["parameters"][name] = len(node.args.args)
    return beyond


def lines_of_code(node: ast.FunctionDef) -> int:
    """The lines of a function from its name to its end, its docstring aside."""
    first = node.body[0]
    is_docstring = isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)
    docstring = (first.end_lineno or 0) - first.lineno + 1 if is_docstring else 0
    return (node.end_lineno or 0) - node.lineno + 1 - docstring


@pytest.fixture(autouse=True, scope="module")
def no_search_for_rubbish() -> Iterator[None]:
    """Trees of a million nodes have none, and looking for it takes three times as long as parsing."""
    gc.disable()
    yield
    gc.enable()


@pytest.fixture(scope="module")
def beyond() -> dict[str, dict[str, int]]:
    found: dict[str, dict[str, int]] = {}
    for path in modules():
        for kind, entries in measure((ROOT / path).read_text(), path).items():
            found.setdefault(kind, {}).update(entries)
    return found


@pytest.mark.parametrize(
    ("kind", "argued"),
    [("file", LONG_FILES), ("function", LONG_FUNCTIONS), ("kernel", LONG_KERNELS), ("parameters", MANY_PARAMETERS)],
)
def test_what_is_longer_than_its_budget_is_listed_with_a_reason(beyond, kind, argued):
    assert {name: size for name, size in beyond[kind].items() if name not in argued} == {}
    assert set(argued) <= set(beyond[kind])
    assert all(len(reason) > 20 for reason in argued.values())


@pytest.mark.parametrize(
    ("kind", "source"),
    [
        ("file", "x = 1\n" * 801),
        ("function", "def f():\n" + "    x = 1\n" * 60),
        ("kernel", "@kernel\ndef f():\n" + "    x = 1\n" * 60),
        ("kernel", "@walk.on_cuda\ndef f():\n" + "    x = 1\n" * 60),
        ("parameters", "@kernel(most_registers=80)\ndef f(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o): pass\n"),
    ],
)
def test_what_is_too_long_is_found(kind, source):
    found = measure(source, "kernels/x.py")
    assert [name for name, entries in found.items() if entries] == [kind]


def test_docstrings_and_what_is_just_within_its_budget_pass():
    function = 'def f():\n    """A."""\n' + "    x = 1\n" * 59
    kernel = "@kernel\ndef g():\n" + "    x = 1\n" * 59
    assert not any(measure(function + kernel, "pcd/x.py").values())
