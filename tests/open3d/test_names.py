"""docs/open3d-names.md lists the pointloom equivalent of each name of the installed Open3D."""

import re

import pytest

import pointloom.open3d

from ..test_imports import ROOT


def test_the_page_of_all_names_is_fresh(o3d):
    """Each missing name has an alternative, else `page` raises an error."""
    from scripts.open3d_names_page import MODULES, differences, of_path, page, public

    written = (ROOT / "docs/open3d-names.md").read_text()
    assert written == page(), "run .venv/bin/python scripts/write_open3d_names.py"
    assert "| `KDTreeSearchParam*` | keywords: estimate_normals(radius=0.1, max_nn=30)" in written
    assert re.search(r"### pipelines.registration\n\n.*\n.*\n\| [^\n]*`registration_icp`[^\n]* \| same \|", written)
    assert all(public(of_path(o3d, module)) for module in MODULES)
    assert [name for name in differences() if "*" not in name and of_path(o3d, name) is None] == []


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("o3d.t.io.RGBDVideoReader", "loom.RealSenseCamera"),
        ("o3d.pipelines.odometry.compute_correspondence", "inliers counts them"),
        ("o3d.pipelines.registration.PointCloud", "it is o3d.geometry.PointCloud"),
        ("o3d.visualization.Viewer", "it is loom.Viewer"),
        ("o3d.read_point_cloud", "it is o3d.io.read_point_cloud"),
        ("o3d.PoseGraph", "it is o3d.pipelines.registration.PoseGraph"),
        ("o3d.visualization.Visualizer().register_mouse_move_callback", "not here"),
        ("o3d.pipelines.registration.ICPConvergenceCriteria().max_iterations", "did you mean 'max_iteration'"),
    ],
)
def test_a_missing_name_is_an_error_with_the_equivalent(line, message):
    with pytest.raises(AttributeError, match=message):
        eval(line, {"o3d": pointloom.open3d})
