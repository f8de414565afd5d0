"""Scripts written for Open3D: tutorials give Open3D's numbers, and names and results of scripts are compared."""

from types import SimpleNamespace

import numpy as np
import pytest

import pointloom.open3d
from benchmarks.open3d_scripts import compare, names_of
from benchmarks.open3d_stand_ins import replace

from .runner import CHAPTERS, assert_same_results

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


def test_results_are_compared_by_value_and_by_the_order_of_rows():
    a = {"x": np.array([1.0, np.nan]), "n": np.array(3)}
    assert compare(a, a, a) == "equal"
    assert compare(a | {"x": np.array([1.0001, np.nan])}, a, a) == compare({"n": a["n"]}, a, a) == "different: x"
    assert compare("TypeError: b", a, a) == "raises here: TypeError: b"
    assert compare(a, "TypeError", a) == compare(a, a, "TypeError") == "raises there: TypeError"
    assert compare({"output": ""}, {"output": ""}, {"output": ""}) == "nothing to compare"
    b = {"x": np.array([[1.0, 2], [3, 4]]), "output": "1.5 points\n[Open3D DEBUG] 3\n"}
    assert compare(b | {"x": b["x"][::-1]}, b, b) == "other order: x"
    assert compare(b | {"output": "1.5000001  points\n\n"}, b, b) == "equal"
    assert compare(b | {"output": "1.6 points\n"}, b, b) == "different: output"


def test_values_that_vary_between_runs_are_left_out():
    a = {"x": np.array([1.0, 2.0]), "n": np.array(3)}
    random = [a | {"x": np.array([value, 2.0])} for value in (4.0, 5.0)]
    assert compare(a, *random) == "equal except for x"
    assert compare(a | {"n": np.array(4)}, *random) == "different: n"
    assert compare({"x": a["x"]}, *({"x": other["x"]} for other in random)) == "nothing to compare except for x"


@pytest.fixture
def package():
    """Modules of a package whose readers return the path."""
    io = SimpleNamespace(read_point_cloud=str, read_image=lambda filename, options=0: (filename, options))
    return SimpleNamespace(visualization=SimpleNamespace(), io=io, t=SimpleNamespace(io=SimpleNamespace()))


def test_missing_files_are_replaced_by_those_of_the_same_kind(package, tmp_path):
    folder = tmp_path / "stand_ins"
    folder.mkdir()
    (folder / "cloud.ply").touch()
    replace(package, "data", tmp_path)
    assert package.data == "data" and package.io.read_point_cloud("absent/a.PLY") == str(folder / "cloud.ply")
    assert package.io.read_point_cloud("absent/a.other") == "absent/a.other"
    assert package.io.read_point_cloud(folder / "cloud.ply") == str(folder / "cloud.ply")
    assert package.io.read_image(filename="Depth/1.png", options=2) == (str(folder / "depth.png"), 2)
    assert package.io.read_image("color/1.jpg")[0] == str(folder / "color.jpg")


def test_windows_record_their_geometries_and_end_at_once(package):
    drawn = replace(package, None, None)
    window = package.visualization.Visualizer()
    assert window.create_window("title") and window.add_geometry("cloud") and not window.poll_events()
    window.get_view_control().set_zoom(0.5).anything()
    assert len(window.get_picked_points()) == 0 and float(window.get_render_option().point_size) == 0
    package.visualization.draw_geometries(["mesh", "lines"], zoom=0.5)
    package.visualization.draw("box")
    assert drawn == ["cloud", "mesh", "lines", "box"] and package.io.read_point_cloud("a.ply") == "a.ply"


# Positions are float32 about an origin here, float64 in Open3D: inputs differ by 1e-7 of a length, small sums more.
USUAL = 2e-6  # relative to the largest number, or to 1
TOLERANCES: dict[str, dict[str, float]] = {
    "chapter_11_surfaces": {"Poisson's area": 5e-3},  # the same equation on other cells
    "chapter_15_posed_frames": {"means": 2e-5},  # a point on a voxel face may be assigned to either side
}


@pytest.mark.parametrize("chapter", sorted(path.stem for path in CHAPTERS.glob("*.py")))
def test_a_script_runs_with_its_import_line_changed(chapter, oracle, tutorial_files, monkeypatch):
    assert_same_results(oracle, chapter, tutorial_files, monkeypatch, TOLERANCES.get(chapter, {}), USUAL)
