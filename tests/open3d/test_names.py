"""docs/open3d-names.md lists the pointloom equivalent of each name of the installed Open3D."""

import re

import pytest

import pointloom.open3d

from ..test_imports import ROOT


def test_the_page_of_all_names_is_fresh(o3d):
    from scripts.open3d_names_page import HOMES, page, public

    written = (ROOT / "docs/open3d-names.md").read_text()
    assert written == page(), "run .venv/bin/python scripts/write_open3d_names.py"
    assert "| `KDTreeSearchParamHybrid` | keywords: estimate_normals(radius=0.1, max_nn=30)" in written
    assert re.search(r"### open3d.pipelines.registration\n[^#]*\| `registration_icp` \| same \| yes \|", written)
    assert re.search(r"### open3d.pipelines.registration\n[^#]*\| `registration_ndt` \| not here: .*\|  \|", written)
    for path in HOMES:
        owner = o3d
        for part in path.split("."):
            owner = getattr(owner, part)
        assert public(owner)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("o3d.pipelines.registration.registration_ndt", "not here: loom.registration.registration_generalized_icp"),
        ("o3d.visualization.draw_geometries_with_editing", "the tools of the page that loom.draw opens: polygon"),
        ("o3d.visualization.rendering", "loom.render, loom.draw, loom.Viewer"),
        ("o3d.pipelines.odometry.compute_correspondence", "inliers counts them"),
        ("o3d.pipelines.registration.PointCloud", "it is o3d.geometry.PointCloud"),
        ("o3d.visualization.Viewer", "it is loom.Viewer"),
        *[
            (f"o3d.{old}", f"it is o3d.pipelines.{old}")
            for old in ("registration", "integration", "odometry", "color_map")
        ],
        ("o3d.read_point_cloud", "it is o3d.io.read_point_cloud"),
        ("o3d.PoseGraph", "it is o3d.pipelines.registration.PoseGraph"),
        ("o3d.data.BunnyMesh", r"loom\.datasets\.object_mesh"),
        ("o3d.utility.Debug", r"o3d\.utility\.VerbosityLevel"),
        ("o3d.visualization.Visualizer().register_mouse_move_callback", "not here"),
        ("o3d.pipelines.registration.ICPConvergenceCriteria().max_iterations", "did you mean 'max_iteration'"),
    ],
)
def test_a_name_that_is_not_there_names_our_way(line, message):
    with pytest.raises(AttributeError, match=message):
        eval(line, {"o3d": pointloom.open3d})


def test_a_module_that_is_not_there_names_our_way():
    for line, message in (
        ("import pointloom.open3d.core as o3c", "here: arrays of NumPy"),
        ("from pointloom.open3d.core import Tensor", "here: arrays of NumPy"),
        ("import pointloom.open3d.t.geometry", "here: loom itself"),
        ("import pointloom.open3d.visualization.rendering as rendering", "not here: loom.render"),
        ("from pointloom.open3d.visualization import draw, gui", "not here: loom.render"),
        ("import pointloom.open3d.cpu.pybind", "not here: Open3D's binaries"),
        ("from pointloom.open3d import registration", "it is o3d.pipelines.registration"),
        ("from pointloom.open3d.geometry import PointClod", "did you mean 'PointCloud'"),
    ):
        with pytest.raises(ImportError, match=message):
            exec(line)
    exec("import pointloom.open3d.pipelines.registration, pointloom.open3d.geometry.keypoint")
    exec("from pointloom.open3d.visualization import draw_geometries")
