"""The tests that reach a function, on a small package."""

from __future__ import annotations

import pytest

from .callers import CallGraph

FILES = {
    "src/pointloom/pcd/normals.py": """
from ..kernels.fits import fit

class Cloud:
    def __init__(self):
        self.a = 1

    def normals(self):
        return fit(self)

    def planes(self):
        return self
""",
    "src/pointloom/kernels/fits.py": """
LIMIT = 3

def fit(a):
    return weight(a)

def weight(a):
    return a * LIMIT

def unused(a):
    return a
""",
    "tests/pcd/conftest.py": """
def tilted(rng):
    return loom.Cloud().normals()
""",
    "tests/pcd/test_normals.py": """
from .helpers import up

def test_normals():
    assert loom.Cloud().normals()

def test_planes():
    assert loom.Cloud().planes()

@pytest.mark.slow
def test_slow_normals():
    assert loom.Cloud().normals()

def test_a_helper():
    assert up()

def test_a_fixture(tilted):
    assert tilted

def test_a_name():
    assert getattr(loom.Cloud(), "normals")()
""",
    "tests/pcd/test_table.py": """
CALLS = '''
cloud.normals()
cloud.fit(1)
'''

def test_all_calls_of_a_table():
    for call in CALLS:
        eval(call)
""",
    "tests/pcd/helpers.py": """
def up():
    return loom.Cloud().normals()
""",
    "tests/kernels/test_fits.py": """
from pointloom.kernels.fits import fit

def test_fit():
    assert fit(1) == 3
""",
}


@pytest.fixture
def graph(tmp_path):
    for name, text in FILES.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return CallGraph(tmp_path, FILES)


def names(graph, file, owner, **options):
    return [test.name for _, test in graph.tests_of(f"src/pointloom/{file}", owner, **options)]


def test_a_method_has_the_tests_that_name_it_first(graph):
    found = names(graph, "pcd/normals.py", "Cloud.normals")
    assert {*found[:2]} == {"test_normals", "test_a_name"}
    assert {"test_a_helper", "test_a_fixture"} < {*found} and "test_slow_normals" not in found
    assert found.index("test_planes") == len(found) - 1  # uses the class


def test_a_table_of_calls_is_a_use_of_its_functions(graph):
    assert "test_all_calls_of_a_table" in names(graph, "pcd/normals.py", "Cloud.normals")
    assert "test_all_calls_of_a_table" not in names(graph, "pcd/normals.py", "Cloud.planes")


def test_slow_tests_are_included_on_request(graph):
    assert "test_slow_normals" in names(graph, "pcd/normals.py", "Cloud.normals", with_slow=True)


@pytest.mark.parametrize("owner", ["weight", "LIMIT", "weight.inner"])
def test_private_functions_and_constants_have_the_tests_of_their_callers_the_nearest_first(graph, owner):
    found = names(graph, "kernels/fits.py", owner)
    assert found[0] == "test_fit" and "test_normals" in found
    assert found[-1] == "test_planes"  # makes an object of the class


def test_a_function_that_no_test_reaches_has_the_tests_of_its_module(graph):
    assert names(graph, "kernels/fits.py", "unused")[0] == "test_fit"


def test_the_start_of_an_object_has_the_tests_that_make_one(graph):
    assert "test_normals" in names(graph, "pcd/normals.py", "Cloud.__init__")
