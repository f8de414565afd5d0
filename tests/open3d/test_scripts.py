"""benchmarks/open3d_scripts.py: the Open3D names of a script, and the comparison of two runs."""

import numpy as np

import pointloom.open3d
from benchmarks.open3d_scripts import compare, names_of

SCRIPT = """
import open3d as o3d
import open3d.core as o3c
from open3d.utility import Vector3dVector as V

cloud = o3d.io.read_point_cloud("a.ply")
cloud.points = V([[0, 0, 0]])
cloud.points.foo()
cloud.invented()
old = o3d.registration.registration_icp(cloud, cloud, 1)
cloud = other.cloud()
cloud.unrelated()
o3c.Tensor([1]).numpy()
"""


def test_the_names_of_a_script():
    names = names_of(SCRIPT, pointloom.open3d)
    assert {"io.read_point_cloud", "utility.Vector3dVector", "core", "core.Tensor"} <= names.known
    assert {"geometry", "geometry.PointCloud", "geometry.PointCloud.points"} <= names.known
    assert names.unknown == {"registration", "geometry.PointCloud.invented"}


def test_results_are_compared_by_value():
    a = {"x": np.array([1.0, np.nan]), "n": np.array(3)}
    assert compare(a, a, a) == "equal"
    assert compare(a | {"x": np.array([1.0001, np.nan])}, a, a) == compare({"n": a["n"]}, a, a) == "different: x"
    assert compare("TypeError: b", a, a) == "raises here: TypeError: b"
    assert compare(a, "TypeError", a) == compare(a, a, "TypeError") == "raises there: TypeError"
    assert compare({"output": ""}, {"output": ""}, {"output": ""}) == "nothing to compare"


def test_the_order_of_rows_and_the_log_are_told_apart_from_other_differences():
    a = {"x": np.array([[1.0, 2], [3, 4]]), "output": "1.5 points\n[Open3D DEBUG] 3\n"}
    assert compare(a | {"x": a["x"][::-1]}, a, a) == "other order: x"
    assert compare(a | {"output": "1.5000001  points\n\n"}, a, a) == "equal"
    assert compare(a | {"output": "1.6 points\n"}, a, a) == "different: output"


def test_values_that_vary_between_runs_are_left_out():
    a = {"x": np.array([1.0, 2.0]), "n": np.array(3)}
    random = [a | {"x": np.array([value, 2.0])} for value in (4.0, 5.0)]
    assert compare(a, *random) == "equal except for x"
    assert compare(a | {"n": np.array(4)}, *random) == "different: n"
    assert compare({"x": a["x"]}, *({"x": other["x"]} for other in random)) == "nothing to compare except for x"
