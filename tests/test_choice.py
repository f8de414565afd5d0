"""`make test` leaves out slow tests, tests that need Open3D itself and runs on Taichi, and nothing else."""

from __future__ import annotations

import itertools
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path
from types import SimpleNamespace

import pytest

import pointloom as loom

from . import choice, rest_set
from .cpu_seconds import CpuSeconds
from .mutants.run import QUICK
from .products import each_pair, few_quick
from .smallest_set import Taken

ROOT = Path(__file__).resolve().parents[1]

SUITE = """
import pytest

def test_a_claim():
    pass

@pytest.mark.slow
def test_a_slow_claim():
    pass

@pytest.mark.nightly
def test_a_nightly_claim():
    pass

@pytest.mark.parametrize("count", [1, pytest.param(9, marks=pytest.mark.slow)])
def test_a_claim_of_which_one_case_is_slow(count):
    pass

def test_of_a_device(device):
    pass

@pytest.mark.both_compilers
def test_of_the_compilers(device):
    pass

@pytest.mark.taichi
def test_of_taichi():
    pass

@pytest.mark.parametrize("compiler", ["warp", "taichi"])
def test_of_a_compiler(compiler):
    pass

def test_of_open3d(o3d):
    pass

def test_of_a_stored_answer(oracle):
    pass
"""
PLAIN = 'addopts = "-p no:dash -p no:hypothesispytest -p no:benchmark"\n'  # a start in half the time
CONFTEST = """
import pytest
from tests import choice
from tests import oracle as answers

choice.HAS_TAICHI, answers.HAS_OPEN3D = {installed}, {installed}
choice.rest_set.left_out = lambda: {left_out}
pytest_collection_modifyitems = choice.pytest_collection_modifyitems

def pytest_addoption(parser):
    choice.pytest_addoption(parser)
    answers.pytest_addoption(parser)

def pytest_generate_tests(metafunc):
    if "device" in metafunc.fixturenames:
        metafunc.parametrize("device", choice.cpu_devices_of(metafunc.definition))

@pytest.fixture
def o3d():
    pass

@pytest.fixture
def oracle():
    pass
"""
QUICK_TESTS = [
    "test_a_claim", "test_a_claim_of_which_one_case_is_slow[1]", "test_of_a_compiler[warp]",
    "test_of_a_device[cpu-warp]", "test_of_a_stored_answer", "test_of_the_compilers[cpu-warp]",
]  # fmt: skip
SLOW_TESTS = ["test_a_claim_of_which_one_case_is_slow[9]", "test_a_slow_claim"]
ON_TAICHI = ["test_of_a_compiler[taichi]", "test_of_taichi", "test_of_the_compilers[cpu-taichi]"]

# Public names of which tests/test_compilers.py has no line, and why not.
NOT_COMPARED = {
    "on the host": (
        *(
            "from_open3d",
            "to_open3d",
            "to_open3d_tensor",
            "to_trimesh",
            "to_pyvista",
            "to_meshio",
            "set_pose",
            "create_rays_pinhole",
            "compute_uvatlas",
        ),
        *("boolean_difference", "boolean_intersection", "boolean_union"),
        *("from_polygon", "revolve", "extrude_linear", "extrude_rotation"),
    ),
    "shapes that NumPy makes": (
        *("create_arrow", "create_box", "create_cone", "create_cylinder", "create_ellipsoid", "create_icosahedron"),
        *("create_mobius", "create_octahedron", "create_sphere", "create_tetrahedron"),
    ),
    "by the kernels of a line": (
        *("get_max_bound", "get_min_bound"),  # get_axis_aligned_bounding_box
        *("is_intersecting", "is_orientable", "is_vertex_manifold", "euler_poincare_characteristic"),  # mesh, topology
        *("remove_degenerate_triangles", "remove_duplicated_triangles", "remove_duplicated_vertices"),  # mesh, cleaned
        *("remove_non_manifold_edges", "remove_triangles_by_index", "remove_vertices_by_index"),
        "compute_distance",  # scene, closest points and signs
        # by without, scale, pyproj, select_by_index, marching_cubes
        *("clear", "to_unit", "reproject", "select_faces_by_mask", "create_isosurfaces"),
        *("slice_plane", "section_loops"),  # clip_plane
    ),
    "by the operations that hand arrays on by it": ("search_tree", "edge_topology"),
    "on scenes that hold such shapes, by tests/pcd/test_shapes.py": (
        *("detect_shapes", "find_boxes", "fit_shape", "segment_shape"),
    ),
}


@pytest.fixture
def run_suite(tmp_path):
    """A function that gives the tests that ran, in order of name."""

    def run(*options, installed=True, left_out=()):
        (tmp_path / "test_suite.py").write_text(SUITE)
        (tmp_path / "conftest.py").write_text(CONFTEST.format(installed=installed, left_out=left_out))
        markers = ["slow", "nightly", "both_compilers", "taichi"]
        (tmp_path / "pyproject.toml").write_text(
            f'[tool.pytest.ini_options]\npythonpath = ["{ROOT}"]\nmarkers = {markers}\n' + PLAIN
        )
        command = [sys.executable, "-m", "pytest", "-n", "0", "-vv", *options]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=120)
        assert done.returncode == 0, done.stdout
        return sorted(re.findall(r"::(\S+) PASSED", done.stdout))

    return run


def test_make_test_leaves_out_slow_tests_open3d_and_taichi(run_suite):
    assert run_suite(*QUICK) == QUICK_TESTS


@pytest.mark.nightly
def test_all_tests_include_those_left_out(run_suite):
    nightly = "test_a_nightly_claim"
    assert run_suite() == sorted([*QUICK_TESTS, *SLOW_TESTS, *ON_TAICHI, "test_of_open3d", nightly])
    assert run_suite("--rest") == sorted([*SLOW_TESTS, "test_of_open3d"])
    assert run_suite("--rest", left_out={f"test_suite.py::{SLOW_TESTS[1]}"}) == [SLOW_TESTS[0], "test_of_open3d"]
    assert run_suite("--nightly", left_out={f"test_suite.py::{SLOW_TESTS[1]}"}) == sorted(
        [SLOW_TESTS[1], "test_of_a_stored_answer", nightly]
    )
    assert run_suite("--taichi") == ON_TAICHI
    assert run_suite(installed=False) == sorted([*QUICK_TESTS, *SLOW_TESTS, nightly])


@pytest.mark.parametrize(
    "owner",
    [loom.PointCloud, loom.TriangleMesh, loom.TSDFVolume, loom.OccupancyGrid, loom.RaycastingScene, loom.DistanceField],
    ids=lambda owner: owner.__name__,
)
def test_the_compilers_are_compared_on_every_operation(owner):
    paths = [path for kind in ("digest_*.py", "operations_on_*.py") for path in (ROOT / "benchmarks").glob(kind)]
    written = "".join(path.read_text() for path in paths)
    names = {name for name in dir(owner) if not name.startswith("_") and callable(getattr(owner, name))}
    names -= {
        name for name in names if name.startswith("create_from_") and hasattr(owner, name.removeprefix("create_"))
    }
    excused = {name for reason in NOT_COMPARED.values() for name in reason}
    assert names - set(re.findall(r"\w+", written)) - excused == set()


def test_the_slowest_subpackages_exist_and_start_first():
    assert [group for group in choice.SLOWEST if not (choice.TESTS / group).exists()] == []
    assert max(Counter(choice.SLOWEST).values()) == 1
    files = ["test_copies.py", "kernels/icp/test_step.py", "pcd/test_cloud.py", "kernels/test_memory.py"]
    groups = [choice.group_of(choice.TESTS / file) for file in files]
    assert groups == ["test_copies.py", "kernels/icp", "pcd", "kernels"]
    assert sorted(groups, key=lambda group: choice.rank_of(group, ("pcd", "kernels/icp")))[:2] == ["pcd", "kernels/icp"]


def test_subpackages_share_a_process(tmp_path):
    packages = ("kernels/icp", "kernels/fit", "pcd")
    files = [f"{room}/test_{room.rpartition('/')[2]}_{k}.py" for k in range(6) for room in packages]
    for file in files:
        path = tmp_path / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("import pytest\n@pytest.mark.parametrize('i', range(5))\ndef test_claim(i): pass\n")
    hooks = "pytest_xdist_make_scheduler = choice.pytest_xdist_make_scheduler\nchoice.TESTS = Path(__file__).parent\n"
    (tmp_path / "conftest.py").write_text("from pathlib import Path\nfrom tests import choice\n" + hooks)
    (tmp_path / "pyproject.toml").write_text(f'[tool.pytest.ini_options]\npythonpath = ["{ROOT}"]\n' + PLAIN)
    options = re.search(r"^PYTEST := .* -m pytest -n \S+ (.*)$", (ROOT / "Makefile").read_text(), flags=re.MULTILINE)[1]
    command = [sys.executable, "-m", "pytest", "-n", "2", "-v", *options.split()]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=120)
    ran = re.findall(r"^\[(gw\d)\].* PASSED (\S+)/\w+\.py::", done.stdout, flags=re.MULTILINE)
    assert len(ran) == 5 * len(files), done.stdout
    assert len(set(ran)) == len(packages)


def test_in_make_test_each_two_values_of_parameters_meet():
    values = {"a": [1, 2, 3], "b": "xyz", "c": [None, 0.5], "d": [True]}
    made = each_pair(**{name: list(those) for name, those in values.items()})
    assert made["argnames"] == tuple(values)
    assert [case.values for case in made["argvalues"]] == list(itertools.product(*values.values()))
    quick = [case.values for case in made["argvalues"] if not case.marks]
    assert len(quick) == 9 and all(case.marks in ((), (pytest.mark.slow,)) for case in made["argvalues"])
    for first, second in itertools.combinations(range(len(values)), 2):
        met = {(case[first], case[second]) for case in quick}
        assert met == {*itertools.product(*(list(values.values())[k] for k in (first, second)))}


@pytest.mark.parametrize(("names", "values"), [("a", [1, 2, 3]), (("a", "b"), [(1, 2), (3, 4), (5, 6)])])
def test_only_the_first_cases_run_in_make_test(names, values):
    cases = few_quick(2, names, values).args[1]
    assert [case.values for case in cases] == [value if isinstance(value, tuple) else (value,) for value in values]
    assert [case.marks for case in cases] == [(), (), (pytest.mark.slow,)]


def test_the_slowest_tests_are_listed_in_order(capsys):
    seconds = CpuSeconds()
    for test, spent in (("cheap", 0.1), ("dear", 1.0), ("dearer", 2.0), ("dear", 3.0)):
        seconds.pytest_runtest_logreport(SimpleNamespace(nodeid=test, cpu_seconds=spent))
    config = SimpleNamespace(getoption=lambda name: None)
    seconds.pytest_terminal_summary(SimpleNamespace(section=print, write_line=print, config=config))
    assert capsys.readouterr().out.splitlines() == [
        "slowest tests, of 0.1 CPU min", "   4.0 s  dear", "   2.0 s  dearer",
    ]  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(("limit", "code"), [("1e6", 0), ("1e-3", 1)])
def test_more_cpu_seconds_than_allowed_fail_a_run(tmp_path, limit, code):
    (tmp_path / "conftest.py").write_text(
        "from tests.cpu_seconds import CpuSeconds\n"
        "def pytest_addoption(parser, pluginmanager): pluginmanager.register(CpuSeconds())\n"
    )
    (tmp_path / "test_suite.py").write_text("def test_a_claim(): assert sum(range(1000)) == 499500\n")
    (tmp_path / "pyproject.toml").write_text(f'[tool.pytest.ini_options]\npythonpath = ["{ROOT}"]\n' + PLAIN)
    command = [sys.executable, "-m", "pytest", "-n", "1", "--max-cpu-quotient", limit]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=120)
    quotient = re.search(r"CPU: \d+ s, (\d+) times the reference workload", done.stdout)
    assert quotient and 1 <= int(quotient[1]) < 500, done.stdout
    assert done.returncode == code and ("FAILED: expected at most" in done.stdout) == bool(code)


def test_processes_keep_their_tests():
    function = "tests/kernels/test_memory.py::test_named"
    tests = {
        "processes": Taken(2.0, of_children=1.5, items={1}),
        f"{function}[1]": Taken(2.0, items={1}),
        "another": Taken(0.1, items={1}),
    }
    assert rest_set.required_tests(tests) == {"processes"}
