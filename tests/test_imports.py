"""Imports go one way, one file knows Taichi, kernel files know neither compiler, and `import pointloom` is light."""

import ast
import gc
import re
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from scipy.sparse.csgraph import connected_components

from pointloom import atomic_imports

from .sigint import sigint_enabled

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "src" / "pointloom"

# The packages by layer, lowest first. A package imports from itself and from lower layers.
LAYERS = [
    ["kernels"],
    ["core"],
    ["cameras"],
    ["pcd"],
    ["io"],
    ["registration", "meshing"],
    ["rgbd", "visualization", "torch"],
    ["photogrammetry", "tiling"],
    ["datasets"],
    ["cli", "open3d"],
]
LINKED = {"kernels", "pcd", "registration", "meshing"}  # at the top level of a checkout
PACKAGES = [package for floor in LAYERS for package in floor]
MAY_IMPORT = {
    package: {below for floor in LAYERS[:level] for below in floor}
    for level, floor in enumerate(LAYERS)
    for package in floor
}

# The subpackages of each package. A subpackage may import from those before it in its list and from the top-level
# modules of the package, which import from no subpackage.
SUBPACKAGES = {
    "kernels": [
        *("language", "algebra", "arrays", "tensors", "search", "extent", "surface", "features", "sampling"),
        *("segmentation", "terrain"),
        *("poses", "icp", "volumes", "odometry", "meshes", "bending", "remeshing", "rays", "reconstruction", "images"),
        *("stereo", "drawing", "rgbd", "textures", "splats", "scenes"),
    ],
    "io": ["images", "points", "splats", "meshes", "frames", "models", "bags"],
    "registration": ["icp", "globally", "pose_graphs", "lidar", "stations", "deformable", "trajectories"],
    "meshing": ["mesh", "scene", "volume", "color_map"],
    "rgbd": ["odometry", "slam", "fusion", "reconstruction"],
    "visualization": ["render", "change", "page", "recording", "viewer"],
    "photogrammetry": ["sfm", "mvs", "depth", "video"],
    "datasets": ["scenes", "made", "public"],
    "tiling": ["steps", "jobs"],
    "cli": ["jobs", "shell"],
    "open3d": ["core", "data", "utility", "camera", "geometry", "pipelines", "io", "visualization", "t"],
}

# Top-level modules that may import from subpackages. lang.py and memory.py re-export the lowest subpackages,
# check_cuda.py, cpu_kernels.py and cuda_cache.py read all of them.
MODULES_ABOVE_SUBPACKAGES = {
    "kernels": {"lang", "launches", "memory", "check_cuda", "cpu_kernels", "cuda_cache"},
    "tiling": {"epochs", "halos", "plan", "rasters", "status", "work_tile"},
}

TAICHI_FILES = {"kernels/language/taichi_compiler.py"}
TAICHI_NAMES = {"taichi", "quadrants"}  # quadrants is Taichi's successor under another name

# The files of kernels/ that may use Warp itself: the compilers, and code on Warp's memory, sort and scan.
WARP_FILES = {
    "kernels/array_types.py", "kernels/language/arguments.py", "kernels/launches.py", "kernels/lang.py",
    "kernels/language/casts.py", "kernels/language/compiled_ahead.py", "kernels/cpu_kernels.py",
    "kernels/language/cpu_archive.py", "kernels/language/cpu_code.py", "kernels/language/kernel_cache.py",
    "kernels/language/pool_code.py", "kernels/language/module_loading.py", "kernels/cuda_cache.py",
    "kernels/language/device_lock.py", "kernels/language/prepared_launches.py", "kernels/language/cuda_launches.py",
    "kernels/language/device_arrays.py", "kernels/language/warp_parts.py", "kernels/language/segment_launches.py",
    "kernels/language/pools.py", "kernels/language/streams.py", "kernels/language/warp_compiler.py",
    "kernels/language/cuda_code.py", "kernels/language/taichi_compiler.py", "kernels/check_cuda.py",
    "kernels/memory.py", "kernels/arrays/side_by_side.py", "kernels/arrays/sort.py", "kernels/arrays/prefix_sum.py",
    "kernels/language/pinned_uploads.py",
}  # fmt: skip

# What a file takes from lang.py when it defines device code.
DEVICE_DECORATORS = {
    "cuda_func", "cuda_loop", "func", "kernel", "loop", "reduction", "segment_reduction", "struct", "*",
}  # fmt: skip


class Import(NamedTuple):
    """One imported name: its line, the full module (folders as pointloom.<folder>), and the name from it."""

    line: int
    module: str
    name: str = ""
    relative: bool = False


@cache
def parsed(source: str) -> ast.Module:
    """Syntax tree of a file, shared by all checks: read-only."""
    return ast.parse(source)


def statements_of(node: ast.AST) -> Iterator[ast.stmt]:
    """All statements in a tree, without the expressions, which are most of its nodes."""
    for field in ("body", "orelse", "finalbody", "handlers", "cases"):
        inner = getattr(node, field, None)
        for child in inner if isinstance(inner, list) else ():
            if isinstance(child, ast.stmt):
                yield child
            yield from statements_of(child)


@cache
def imports_of(source: str, path: str) -> list[Import]:
    """Every import in a file, inside functions and under TYPE_CHECKING too, and those by `import_module("...")`."""
    parts = ["pointloom", *Path(path).with_suffix("").parts]
    package = parts[:-1]
    imports = []
    has_calls = "import_module" in source or "__import__" in source
    for node in ast.walk(parsed(source)) if has_calls else statements_of(parsed(source)):
        if isinstance(node, ast.Import):
            imports += [Import(node.lineno, alias.name) for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) + 1 - node.level] if node.level else []
            module = ".".join([*base, *([node.module] if node.module else [])])
            imports += [Import(node.lineno, module, alias.name, node.level > 0) for alias in node.names]
        elif isinstance(node, ast.Call) and node.args and isinstance(node.args[0], ast.Constant):
            called = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
            if called in {"import_module", "__import__"} and isinstance(node.args[0].value, str):
                imports.append(Import(node.lineno, node.args[0].value))
    return imports


def top_level(imported: Import) -> str:
    return imported.module.split(".")[0]


def layer_faults(source: str, path: str) -> list[str]:
    folder = path.split("/")[0]
    faults = []
    for imported in imports_of(source, path):
        where = f"{path}:{imported.line}"
        if top_level(imported) in {*LINKED, "src"}:
            faults.append(f"{where}: {imported.module} exists in a checkout only; import it relatively")
        if top_level(imported) != "pointloom":
            continue
        if not imported.relative:
            faults.append(f"{where}: {imported.module} is imported by its full name; import it relatively")
        target = (*imported.module.split(".")[1:], imported.name)[0]
        if target in {"__version__", "public_names"}:
            continue
        if target != folder and target not in MAY_IMPORT[folder]:
            faults.append(f"{where}: {folder} must not import from {target or 'pointloom'}")
    return faults


def compiler_faults(source: str, path: str) -> list[str]:
    imports = imports_of(source, path)
    faults = []
    for imported in imports:
        where = f"{path}:{imported.line}"
        if top_level(imported) in TAICHI_NAMES and path not in TAICHI_FILES:
            faults.append(f"{where}: only {', '.join(sorted(TAICHI_FILES))} imports {top_level(imported)}")
        if top_level(imported) == "warp" and path.startswith("kernels/") and path not in WARP_FILES:
            faults.append(f"{where}: kernel files import from .lang, not from warp")
        if imported.module == "__future__" and imported.name == "annotations" and defines_device_code(imports, path):
            faults.append(f"{where}: `from __future__ import annotations` hides the types that the compilers read")
    return faults


def defines_device_code(imports: list[Import], path: str) -> bool:
    is_kernel_file = path.startswith("kernels/") and path not in WARP_FILES
    return is_kernel_file and any(i.module == "pointloom.kernels.lang" and i.name in DEVICE_DECORATORS for i in imports)


# Files that may ask Warp itself to work on a device: those that take the lock around it, or are called with it held.
DEVICE_FILES = {
    "kernels/language/casts.py", "kernels/language/pool_code.py", "kernels/language/device_lock.py",
    "kernels/language/prepared_launches.py", "kernels/language/cuda_launches.py",
    "kernels/language/device_arrays.py", "kernels/language/warp_parts.py", "kernels/language/arguments.py",
    "kernels/language/warp_compiler.py", "kernels/memory.py", "kernels/launches.py",
    "kernels/language/cuda_code.py",
}  # fmt: skip
# What Warp does to arrays outside the lock: methods of an array, and functions of its module.
DEVICE_METHODS = {"numpy", "list", "fill_", "zero_", "assign", "contiguous"}
DEVICE_FUNCTIONS = {
    *("empty", "empty_like", "zeros", "zeros_like", "ones", "full", "full_like", "clone", "copy", "from_numpy"),
    *("launch", "launch_tiled", "synchronize", "synchronize_device", "synchronize_stream", "from_dlpack", "Stream"),
    *("ScopedStream", "ScopedCapture", "capture_begin", "capture_end", "capture_launch", "capture_while", "set_stream"),
    *("utils.array_scan", "utils.array_cast", "utils.radix_sort_pairs"),
}
DEVICE_NAMES = DEVICE_METHODS | {name.rpartition(".")[2] for name in DEVICE_FUNCTIONS}
HOST_METHODS = {("core/other_geometry.py", "tensors[name].cpu().numpy")}  # Open3D's own arrays, on the host


def device_faults(source: str, path: str) -> list[str]:
    """Calls that reach a device past the lock; functions of Warp are right in a `with` that takes it."""
    if path in DEVICE_FILES or not any(f".{name}(" in source for name in DEVICE_NAMES):
        return []
    faults, nodes = [], list(ast.walk(parsed(source)))
    locked = {
        id(inner)
        for node in nodes
        if isinstance(node, ast.With) and any(takes_the_lock(item.context_expr) for item in node.items)
        for inner in ast.walk(node)
    }
    for node in nodes:
        if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Attribute):
            continue
        if node.func.attr not in DEVICE_NAMES:
            continue
        called = ast.unparse(node.func)
        is_of_tensor = path.startswith(("open3d/", "torch/"))  # methods of other libraries' tensors have these names
        is_method = node.func.attr in DEVICE_METHODS and (path, called) not in HOST_METHODS and not is_of_tensor
        is_function = called.startswith("wp.") and called[len("wp.") :] in DEVICE_FUNCTIONS and id(node) not in locked
        if is_method or is_function:
            faults.append(f"{path}:{node.lineno}: {called} is not thread-safe; use kernels/memory.py")
    return faults


def takes_the_lock(expression: ast.expr) -> bool:
    return ast.unparse(expression) == "lock" or ast.unparse(expression).startswith("lock_for(")


def modules() -> list[str]:
    return sorted(
        path.relative_to(PACKAGE).as_posix() for folder in MAY_IMPORT for path in (PACKAGE / folder).rglob("*.py")
    )


def subpackage_faults(source: str, path: str) -> list[str]:
    """Forbidden imports within a package: from a subpackage into a later one, or from a top-level module into one."""
    package, *inside = Path(path).with_suffix("").parts
    if package not in SUBPACKAGES:
        return []
    ranks = {subpackage: k for k, subpackage in enumerate(SUBPACKAGES[package])}
    own = ranks.get(inside[0], len(ranks)) if len(inside) > 1 else -1
    if own < 0 and inside[0] in {*MODULES_ABOVE_SUBPACKAGES.get(package, set()), "__init__"}:
        return []
    faults = []
    for imported in imports_of(source, path):
        steps = [*imported.module.split("."), imported.name]
        if steps[:2] == ["pointloom", package] and ranks.get(steps[2], -1) > own:
            who = inside[0] if own >= 0 else package
            faults.append(f"{path}:{imported.line}: {who} must not import from {steps[2]}")
    return faults


def import_cycles(edges: dict[str, set[str]]) -> list[list[str]]:
    """The sets of modules that import each other, each sorted."""
    names = sorted(edges)
    matrix = np.array([[target in edges[name] for target in names] for name in names])
    _, components = connected_components(matrix, connection="strong")
    cycles = [[name for name, k in zip(names, components, strict=True) if k == n] for n in np.unique(components)]
    return [cycle for cycle in cycles if len(cycle) > 1]


def graph_of(sources: dict[str, str]) -> dict[str, set[str]]:
    """The files that each file imports, in functions too, but not for types alone; paths as in `modules`."""
    edges: dict[str, set[str]] = {}
    for path, source in sources.items():
        edges[path] = set()
        for_types = lines_for_types(source)
        for imported in imports_of(source, path):
            if imported.line in for_types:
                continue
            steps = [*imported.module.split("."), imported.name][1:]
            names = "/".join(steps), "/".join(steps[:-1])
            targets = [f"{name}{end}" for name in names for end in (".py", "/__init__.py")]
            edges[path].update([target for target in targets if target in sources and target != path][:1])
    return edges


def lines_for_types(source: str) -> set[int]:
    """The lines of the code under `if TYPE_CHECKING:`."""
    blocks = [n for n in parsed(source).body if isinstance(n, ast.If) and ast.unparse(n.test) == "TYPE_CHECKING"]
    return {line for block in blocks for line in range(block.lineno, (block.end_lineno or block.lineno) + 1)}


@pytest.fixture(autouse=True, scope="module")
def no_search_for_rubbish() -> Iterator[None]:
    """Trees of a million nodes have none, and looking for it takes three times as long as parsing."""
    gc.disable()
    yield
    parsed.cache_clear()
    gc.enable()


def test_every_folder_has_modules():
    assert {path.split("/")[0] for path in modules()} == set(MAY_IMPORT)


@pytest.mark.parametrize(
    "faults", [layer_faults, subpackage_faults, compiler_faults, device_faults], ids=lambda faults: faults.__name__
)
def test_imports_go_one_way_kernels_import_no_compiler_and_device_calls_hold_the_lock(faults):
    assert [fault for path in modules() for fault in faults((PACKAGE / path).read_text(), path)] == []


def test_every_subpackage_is_listed():
    folders: dict[str, set[str]] = {}
    for package, subpackage, *rest in (path.split("/") for path in modules()):
        if rest:
            folders.setdefault(package, set()).add(subpackage)
    assert folders == {package: set(subpackages) for package, subpackages in SUBPACKAGES.items()}


def test_readme_of_kernels_lists_subpackages_in_order():
    page = (PACKAGE / "kernels" / "README.md").read_text()
    assert re.findall(r"^\| `(\w+)/` \|", page, flags=re.MULTILINE) == SUBPACKAGES["kernels"]


def test_imports_from_later_subpackages_are_reported():
    for path, line, fault in (
        ("kernels/search/tree.py", "from ..icp.rows import x", "search must not import from icp"),
        ("io/points/ply.py", "from ..meshes.obj import x", "points must not import from meshes"),
        ("io/source.py", "from .points.ply import x", "io must not import from points"),
        ("photogrammetry/sfm/model.py", "from .. import mvs", "sfm must not import from mvs"),
        ("cli/jobs/register.py", "from ..shell.options import x", "jobs must not import from shell"),
    ):
        assert subpackage_faults(line, path) == [f"{path}:1: {fault}"]


def test_no_two_modules_import_each_other_not_even_inside_a_function():
    assert import_cycles(graph_of({path: (PACKAGE / path).read_text() for path in modules()})) == []


def test_import_cycles_through_functions_are_reported():
    sources = {
        "pcd/cloud.py": "from .search import x",
        "pcd/search.py": "def f():\n    from . import cloud",
        "pcd/planes.py": "from .cloud import y\nif TYPE_CHECKING:\n    from .hulls import z",
        "pcd/hulls.py": "from .planes import z",
    }
    assert import_cycles(graph_of(sources)) == [["pcd/cloud.py", "pcd/search.py"]]


REPORTED = {
    layer_faults: [
        ("kernels/knn.py", "from ..pcd import cloud"),
        ("kernels/knn.py", "from .. import pcd"),
        ("core/checks.py", "from ..cameras.camera import check_keys"),
        ("cameras/camera.py", "from ..io.source import open_source"),
        ("pcd/cloud.py", "from ..meshing.mesh.mesh import TriangleMesh"),
        ("pcd/cloud.py", "def f():\n    from ..registration import icp"),
        ("io/points/ply.py", "from ...registration import icp"),
        ("io/points/ply.py", "from ... import PointCloud"),
        ("registration/icp/icp.py", "from ...meshing.volume import tsdf"),
        ("meshing/volume/tsdf.py", "from ... import kernels, registration"),
        ("meshing/volume/tsdf.py", "if TYPE_CHECKING:\n    from ...cli.shell import cli"),
        ("rgbd/slam/model.py", "from ...cli.shell.cli import cli"),
        ("rgbd/slam/model.py", "from ...visualization.viewer.hub import GuardedHub"),
        ("visualization/render/render.py", "from ...rgbd.slam.model import Model"),
        ("photogrammetry/mvs/fusion.py", "from ...cli.jobs.register import register_files"),
        ("cli/shell/cli.py", "import pointloom.pcd.cloud"),
        ("cli/shell/cli.py", "from pcd.cloud import PointCloud"),
    ],
    compiler_faults: [
        ("kernels/knn.py", "import taichi as ti"),
        ("kernels/lang.py", "from taichi.lang import impl"),
        ("cli/shell/cli.py", "import importlib\nti = importlib.import_module('taichi')"),
        ("kernels/knn.py", "import warp as wp"),
        ("kernels/knn.py", "from warp.types import vec3"),
        ("kernels/knn.py", "from __future__ import annotations\nfrom .lang import *"),
        ("kernels/knn.py", "from __future__ import annotations\nfrom .lang import kernel, tid"),
    ],
    device_faults: [
        ("pcd/cloud.py", "points = tree.points.numpy()"),
        ("pcd/cloud.py", "return int(reduce(total, n, [values]).numpy()[0])"),
        ("pcd/cloud.py", "offsets.zero_()"),
        ("pcd/cloud.py", "rows = values[rows].contiguous()"),
        ("pcd/cloud.py", "kept = wp.clone(points)"),
        ("pcd/cloud.py", "wp.utils.array_cast(a, b)"),
        ("pcd/cloud.py", "with open(path) as file:\n    wp.synchronize_device(device)"),
    ],
}
ALLOWED = {
    layer_faults: [
        ("io/points/ply.py", "from ...core.errors import FileError"),
        ("io/points/ply.py", "from ...kernels import memory"),
        ("meshing/volume/tsdf.py", "from ... import kernels, pcd"),
        ("registration/icp/icp.py", "import numpy as np\nfrom . import robust"),
        ("photogrammetry/mvs/fusion.py", "from ...visualization.render.render import render"),
        ("cli/shell/cli.py", "from ... import __version__"),
        ("cli/shell/cli.py", "from ...registration.icp.icp import registration_icp"),
    ],
    subpackage_faults: [
        ("kernels/search/tree.py", "from ..arrays.sort import x"),
        ("kernels/search/tree.py", "from ..lang import kernel"),
        ("kernels/search/tree.py", "from .tree_walk import x"),
        ("io/meshes/obj.py", "from ..source import x"),
        ("cli/shell/cli.py", "from ..jobs.register import x"),
    ],
    device_faults: [
        ("kernels/arrays/sort.py", "with lock:\n    wp.copy(a, b)"),
        ("kernels/arrays/sort.py", "with lock_for(device):\n    wp.utils.array_scan(a)"),
        ("kernels/arrays/sort.py", "np.zeros(3)"),
        *(("kernels/memory.py", line) for _, line in REPORTED[device_faults]),
    ],
}


@pytest.mark.parametrize(
    ("faults", "path", "line", "count"),
    [
        pytest.param(faults, path, line, count, id=f"{faults.__name__}-{path}-{line}")
        for count, table in enumerate((ALLOWED, REPORTED))
        for faults, cases in table.items()
        for path, line in cases
    ],
)
def test_forbidden_imports_and_calls_are_reported_and_others_pass(faults, path, line, count):
    assert len(faults(line, path)) == count


FIRST_CLOUD = """
import numpy as np
pointloom.PointCloud(np.arange(30.0).reshape(10, 3)).voxel_down_sample(5.0)
"""


@pytest.mark.parametrize(
    ("program", "unneeded"),
    [
        ("", {"warp", "taichi", "scipy", "numpy", "PIL", "rich", "click", "open3d"}),
        (FIRST_CLOUD, {"numpy.ma", "tomllib", "scipy", "PIL", "rich", "click"}),
    ],
    ids=["import", "first cloud"],
)
def test_importing_pointloom_and_a_first_cloud_import_no_slow_modules_that_they_do_not_need(program, unneeded):
    start = f"import sys\nsys.path[:] = {[str(ROOT / 'src'), *sys.path]}\nimport pointloom\n"
    command = [sys.executable, "-c", f"{start}assert pointloom.__version__\n{program}\nprint(*sys.modules)"]
    answer = subprocess.run(command, capture_output=True, text=True, check=True, timeout=300, cwd=ROOT / "tests")
    assert unneeded & set(answer.stdout.split()) == set()


def test_public_packages_show_their_public_names_alone():
    import pointloom as loom
    import pointloom.open3d as o3d
    from pointloom.registration import icp

    packages = [getattr(loom, name) for name in loom.__all__ if name.islower()]
    packages = [package for package in packages if hasattr(package, "__path__")]
    assert {"pointloom.registration", "pointloom.tiling"} <= {each.__name__ for each in packages}
    for package in (loom, o3d, o3d.geometry, *packages):
        assert {name for name in dir(package) if not name.startswith("__")} == set(package.__all__)
    assert sys.modules["pointloom.registration.icp"] is icp
    with pytest.raises(
        AttributeError, match=r"'icp': it is a private module; here: loom.registration.registration_icp"
    ):
        loom.registration.icp  # noqa: B018
    with pytest.raises(AttributeError, match=r"'border_merging': it is a private module$"):
        loom.tiling.border_merging  # noqa: B018
    assert loom.registration is sys.modules["pointloom.registration"]


INTERRUPTED = "import os, signal\nos.kill(os.getpid(), signal.SIGINT)\nimport half.rest\nis_complete = True\n"


@pytest.fixture
def half(tmp_path, monkeypatch):
    """A package that Ctrl-C interrupts while it is imported."""
    (tmp_path / "half").mkdir()
    (tmp_path / "half" / "__init__.py").write_text(INTERRUPTED)
    (tmp_path / "half" / "rest.py").write_text("")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(atomic_imports, "PACKAGES", {*atomic_imports.PACKAGES, "half"})
    yield "half"
    for name in ("half", "half.rest"):
        sys.modules.pop(name, None)


@pytest.mark.parametrize("in_thread", [False, True])
def test_an_import_is_complete_before_ctrl_c_is_handled(half, in_thread):
    thread = threading.Thread(target=__import__, args=(half,))
    with sigint_enabled():
        with pytest.raises(KeyboardInterrupt):
            if in_thread:
                thread.start()
                thread.join()
            else:
                __import__(half)
            threading.Event().wait(60)
        __import__(half)  # waits for the thread
        assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    assert sys.modules[half].is_complete
    assert sys.modules[half].__loader__ is sys.modules[half].__spec__.loader
    assert not isinstance(sys.modules[half].__loader__, atomic_imports._Loader)


def test_a_handler_that_ends_the_process_is_not_deferred(half):
    def end(number, frame):
        raise SystemExit

    end.ends_process = True
    before = signal.signal(signal.SIGINT, end)
    try:
        with pytest.raises(SystemExit):
            __import__(half)
    finally:
        signal.signal(signal.SIGINT, before)


FIRST_CALL = """
import os, signal, sys, time
import numpy as np, pointloom as loom
signal.signal(signal.SIGINT, signal.default_int_handler)
armed = True
def press(event, arguments):
    global armed
    if armed and event == "import" and arguments[0] == sys.argv[1]:
        armed = False
        os.kill(os.getpid(), signal.SIGINT)
sys.addaudithook(press)
def count():
    return len(loom.PointCloud(np.arange(30.0).reshape(10, 3)).voxel_down_sample(1.0))
try:
    count()
    time.sleep(60)
except KeyboardInterrupt:
    print("interrupted", count())
"""


@pytest.mark.slow
@pytest.mark.parametrize("module", ["warp._src.context", "warp._src.builtins"])
def test_the_first_call_works_after_ctrl_c(module):
    done = subprocess.run([sys.executable, "-c", FIRST_CALL, module], capture_output=True, text=True, timeout=300)
    assert (done.stdout, done.returncode) == ("interrupted 10\n", 0), done.stderr
