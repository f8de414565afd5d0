"""Modules and names that pointloom.open3d lacks raise errors with its own equivalents."""

import re

import pytest

import pointloom.open3d as o3d
from pointloom.core.open3d_names import BRIDGE, sections


@pytest.mark.parametrize(
    "line",
    [
        "import pointloom.open3d.core as o3c",
        "import pointloom.open3d.t.geometry",
        "import pointloom.open3d.visualization.rendering as rendering",
        "import pointloom.open3d.data",
        "from pointloom.open3d.visualization import draw, rendering, webrtc_server",
        "from pointloom.open3d.visualization.rendering import MaterialRecord",
    ],
)
def test_modules_are_imported_by_any_statement(line):
    exec(line)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("from pointloom.open3d.visualization import gui", "not here: o3d.visualization.draw"),
        ("import pointloom.open3d.visualization.gui as gui", "not here: o3d.visualization.draw"),
        ("import pointloom.open3d.visualization.app", "not here: o3d.visualization.draw"),
        ("from pointloom.open3d.visualization.rendering import OffscreenRenderer", "here: window = o3d.visual"),
        ("import pointloom.open3d.ml.torch as ml3d", "not here: "),
        ("import pointloom.open3d.cpu.pybind.geometry", "not here: import the module itself"),
        ("from pointloom.open3d.open3d_pybind import geometry", "not here: import the module itself"),
        ("from pointloom.open3d import registration", "it is o3d.pipelines.registration"),
        ("import pointloom.open3d.color_map", "it is o3d.pipelines.color_map"),
    ],
)
def test_a_missing_module_is_an_import_error_with_the_equivalent(line, message):
    with pytest.raises(ImportError, match=message):
        exec(line)


@pytest.mark.parametrize(
    ("path", "message"),
    [
        *[(old, f"it is o3d.pipelines.{old}") for old in ("registration", "integration", "odometry", "color_map")],
        ("visualization.rendering.Open3DScene", "o3d.visualization.draw"),
        ("visualization.webrtc_server.call_http_api", "o3d.visualization.draw"),
        ("io.read_triangle_model", "o3d.io.read_triangle_mesh"),
        ("camera.PrimeSenseDefault", "o3d.camera.PinholeCameraIntrinsicParameters"),
        ("visualization.O3DVisualizer.scene_shader", "set_background"),
        ("visualization.VisualizerWithVertexSelection.pick_points", "add_picked_points"),
    ],
)
def test_a_missing_name_is_an_attribute_error_with_the_equivalent(path, message):
    owner = o3d
    *parents, name = path.split(".")
    for parent in parents:
        owner = getattr(owner, parent)
    with pytest.raises(AttributeError, match=re.escape(message)):
        getattr(owner, name)


def test_equivalents_in_errors_exist():
    rows = [row for section, names in sections().items() if section.split(".")[0] == BRIDGE for row in names.values()]
    for path in set(re.findall(r"\bo3d((?:\.\w+)+)", "\n".join(rows))):
        owner = o3d
        for name in path[1:].split("."):
            owner = getattr(owner, name)


def test_constants_of_old_scripts_exist():
    assert o3d.utility.Debug is o3d.utility.VerbosityLevel.Debug
    assert o3d.utility.Error is o3d.utility.VerbosityLevel.Error
    assert o3d.visualization.webrtc_server.enable_webrtc() is None and o3d.utility.reset_print_function() is None
