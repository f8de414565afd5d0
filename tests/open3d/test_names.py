"""Modules, names and data sets of Open3D: those that are missing raise errors with the equivalents."""

import functools
import inspect
import re
import subprocess
import sys
from pathlib import Path

import pytest

import pointloom as loom
import pointloom.open3d as o3d
from pointloom.core.errors import FileError
from pointloom.core.open3d_names import BRIDGE, sections

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


def test_the_page_of_other_libraries_is_fresh():
    from scripts.open3d_names_page import common_page

    assert (ROOT / "docs/other-libraries.md").read_text() == common_page(), "run scripts/write_open3d_names.py"


MOVED = "registration", "integration", "odometry", "color_map"


@pytest.mark.parametrize(
    ("line", "message"),
    [
        *((f"o3d.{old}", f"it is o3d.pipelines.{old}") for old in MOVED),
        ("o3d.visualization.rendering.Open3DScene", "o3d.visualization.draw"),
        ("o3d.io.read_triangle_model", "o3d.io.read_triangle_mesh"),
        ("o3d.camera.PrimeSenseDefault", "o3d.camera.PinholeCameraIntrinsicParameters"),
        ("o3d.visualization.O3DVisualizer.scene_shader", "set_background"),
        ("o3d.visualization.VisualizerWithVertexSelection", "VisualizerWithEditing"),
        ("o3d.t.io.RGBDVideoReader", "loom.RealSenseCamera"),
        ("o3d.pipelines.odometry.compute_correspondence", "inliers counts them"),
        ("o3d.pipelines.registration.PointCloud", "it is o3d.geometry.PointCloud"),
        ("o3d.visualization.Viewer", "it is loom.Viewer"),
        ("o3d.read_point_cloud", "it is o3d.io.read_point_cloud"),
        ("o3d.visualization.Visualizer().register_mouse_move_callback", "not here"),
        ("o3d.pipelines.registration.ICPConvergenceCriteria().max_iterations", "did you mean 'max_iteration'"),
        ("from pointloom.open3d.visualization import gui", "not here: o3d.visualization.draw"),
        ("import pointloom.open3d.visualization.app", "not here: o3d.visualization.draw"),
        ("from pointloom.open3d.visualization.rendering import OffscreenRenderer", "here: window = o3d.visual"),
        ("import pointloom.open3d.ml.torch as ml3d", "not here: "),
        ("import pointloom.open3d.cpu.pybind.geometry", "not here: import the module itself"),
        ("from pointloom.open3d.open3d_pybind import geometry", "not here: import the module itself"),
        ("from pointloom.open3d import registration", "it is o3d.pipelines.registration"),
        ("import pointloom.open3d.pybind", "not here: import the module itself"),
        ("o3d.core.sycl", "not here: devices are CPUs and CUDA GPUs"),
        ("o3d.core.Device.SYCL", "not here: devices are CPUs and CUDA GPUs"),
        ("o3d.core.HashMap", "np.unique"),
        ("o3d.core.Tensor([[1.0]]).lu_ipiv", "scipy.linalg"),
        ("o3d.core.triul", "np.tril"),
        ("from pointloom.open3d.visualization import webrtc_server", "every window is a page of the browser"),
        ("o3d.geometry.OrientedBoundingEllipsoid", "OrientedBoundingBox"),
        ("o3d.geometry.PointCloud().get_oriented_bounding_ellipsoid", "get_oriented_bounding_box"),
        ("o3d.geometry.HalfEdgeTriangleMesh", "loom.TriangleMesh: get_boundaries"),
        ("o3d.geometry.Octree(3).insert_point", "convert_from_point_cloud"),
        ("o3d.geometry.TetraMesh().extract_triangle_mesh", "loom.TriangleMesh.create_isosurfaces"),
        ("o3d.io.read_octree", "pickle"),
        ("o3d.t.geometry.LineSet().extrude_linear", "of meshes: mesh.extrude_linear"),
        ("o3d.io.read_point_cloud_from_bytes", "pickle.dumps"),
        ("o3d.t.pipelines.odometry.compute_odometry_result_hybrid", "rgbd_odometry_multi_scale"),
    ],
)
def test_a_missing_name_or_module_is_an_error_with_the_equivalent(line, message):
    with pytest.raises(ImportError if "import " in line else AttributeError, match=message):
        exec(line, {"o3d": o3d})


def test_an_unknown_name_does_not_hide_the_package_from_a_later_import():
    lines = "import pointloom", "hasattr(pointloom, 'x')", "import pointloom.open3d", "pointloom.open3d.geometry"
    subprocess.run([sys.executable, "-c", "; ".join(lines)], check=True)


def test_native_classes_of_registration_have_the_public_names_of_open3d():
    """Such as `TukeyLoss`: users of Open3D type the name first, and no other call creates the object."""
    theirs = o3d.pipelines.registration
    classes = {name: value for name in theirs.__all__ if hasattr(value := getattr(theirs, name), "native_kind")}
    named = [name for name, value in classes.items() if getattr(value.native_kind(), "__name__", "") == name]
    assert len(named) >= 23
    for name in named:
        native = getattr(loom.registration, name)
        assert native is classes[name].native_kind()
        given, wanted = ([*inspect.signature(each).parameters] for each in (native, classes[name]))
        assert given[: len(wanted)] == wanted or wanted == ["other"], name  # `other` is copied


@pytest.mark.parametrize("name", ["write_point_cloud", "write_triangle_mesh"])
def test_options_of_native_writers_have_the_names_of_open3d(name):
    theirs, native = (inspect.signature(getattr(module, name)).parameters.keys() for module in (o3d.io, loom))
    assert {option for option in theirs if option.startswith("write_")} <= native


def test_volumes_take_the_size_of_voxels_and_the_truncation_by_position_as_in_open3d(tmp_path):
    volumes = loom.TSDFVolume(0.05, 0.1), loom.PagedTSDFVolume(tmp_path / "pages", 0.05, 0.1)
    assert {(volume.voxel_size, volume.truncation) for volume in volumes} == {(0.05, 0.1)}
    assert [*inspect.signature(o3d.pipelines.integration.ScalableTSDFVolume).parameters][:2] == [
        "voxel_length",
        "sdf_trunc",
    ]


def modules_of(package, path=""):
    """Each module of `pointloom.open3d` with its path from the package, without data sets and tensor kernels."""
    for name in dir(package):
        value = getattr(package, name) if not name.startswith("_") and name not in ("data", "robust_kernel") else None
        if inspect.ismodule(value) and value.__name__ == f"{package.__name__}.{name}":
            yield f"{path}{name}", value
            yield from modules_of(value, f"{path}{name}.")


def test_paths_of_open3d_lead_to_the_names_of_pointloom():
    packages = [loom, loom.registration, loom.rgbd, loom.meshing]
    found = 0
    for path, module in modules_of(o3d):
        at = functools.reduce(getattr, path.split("."), loom)
        for name in getattr(module, "__all__", ()):
            native = [getattr(package, name) for package in packages if name in package.__all__]
            if native and not inspect.ismodule(native[0]):
                assert getattr(at, name) in native, f"{path}.{name}"
                found += 1
    assert found > 60
    assert not {"io", "geometry", "core"} & {*dir(loom)}  # they repeat names
    assert {"PointCloud", "TriangleMesh"} <= {*dir(loom.geometry)}


def test_enumerations_and_vectors_of_open3d_are_taken_at_their_paths():
    cloud = loom.PointCloud(loom.utility.Vector3dVector([[0, 0, 0], [1, 2, 3]]))
    assert cloud.points.tolist() == [[0, 0, 0], [1, 2, 3]]
    box, scope = loom.TriangleMesh.create_box(), loom.geometry.FilterScope.Vertex
    assert (
        box.filter_smooth_simple(1, scope).vertices.tolist() == box.filter_smooth_simple(1, "vertex").vertices.tolist()
    )
    kinect = loom.camera.PinholeCameraIntrinsicParameters.PrimeSenseDefault
    assert loom.PinholeCameraIntrinsic(kinect) == loom.PinholeCameraIntrinsic.prime_sense_default()


def test_features_are_in_the_module_of_open3d():
    assert loom.registration.compute_fpfh_feature is loom.compute_fpfh_feature


def test_modules_are_imported_by_any_statement():
    exec("""import pointloom.open3d.core as o3c
import pointloom.open3d.t.geometry
import pointloom.open3d.visualization.rendering as rendering
from pointloom.open3d.visualization import draw, rendering
from pointloom.open3d.visualization.rendering import MaterialRecord""")


def test_equivalents_in_errors_exist():
    rows = [row for section, names in sections().items() if section.split(".")[0] == BRIDGE for row in names.values()]
    for path in set(re.findall(r"\bo3d((?:\.\w+)+)", "\n".join(rows))):
        owner = o3d
        for name in path[1:].split("."):
            owner = getattr(owner, name)


def test_constants_of_old_scripts_exist():
    assert o3d.utility.Debug is o3d.utility.VerbosityLevel.Debug
    assert o3d.utility.Error is o3d.utility.VerbosityLevel.Error
    assert o3d.utility.reset_print_function() is None


ICP_FILES = ("cloud_bin_0.pcd", "cloud_bin_1.pcd", "cloud_bin_2.pcd", "init.log")


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    """An empty home and no folder of samples."""
    for name in ("POINTLOOM_SAMPLES", "OPEN3D_DATA_ROOT"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    return tmp_path / "home"


def write(folder: Path, *names: str) -> list[str]:
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).touch()
    return [str(folder / name) for name in names]


@pytest.mark.parametrize("layout", ["extract/DemoICPPointClouds", "DemoICPPointClouds"])
@pytest.mark.parametrize("place", ["argument", "POINTLOOM_SAMPLES", "OPEN3D_DATA_ROOT", "open3d_data"])
def test_files_are_found_in_each_folder(place, layout, tmp_path, home, monkeypatch):
    root = home / "open3d_data" if place == "open3d_data" else tmp_path / "samples"
    paths = write(root / layout, *ICP_FILES)
    if place.isupper():
        monkeypatch.setenv(place, str(root))
    dataset = o3d.data.DemoICPPointClouds(data_root=str(root) if place == "argument" else "")
    assert dataset.paths == paths[:3] and dataset.transformation_log_path == paths[3]
    assert (dataset.data_root, dataset.extract_dir) == (str(root), str(root / layout))
    assert dataset.prefix == "DemoICPPointClouds" and dataset.download_dir.endswith("download/DemoICPPointClouds")


def test_a_missing_file_is_an_error_with_its_folder_and_an_alternative(tmp_path, monkeypatch):
    with pytest.raises(FileError) as raised:
        o3d.data.BunnyMesh().path  # noqa: B018
    assert raised.value.path.endswith("home/open3d_data/extract/BunnyMesh/BunnyMesh.ply")
    assert "POINTLOOM_SAMPLES" in raised.value.remedy and "loom.datasets.object_mesh()" in raised.value.remedy
    samples = tmp_path / "samples"
    monkeypatch.setenv("POINTLOOM_SAMPLES", str(samples))
    write(samples / "DemoICPPointClouds", *ICP_FILES[:1])
    with pytest.raises(FileError) as raised:
        o3d.data.DemoICPPointClouds().paths  # noqa: B018
    assert raised.value.path == str(samples / "DemoICPPointClouds/cloud_bin_1.pcd")
    with pytest.raises(FileError):  # a given folder is the only one that is searched
        o3d.data.DemoICPPointClouds(str(tmp_path / "other")).paths  # noqa: B018


def test_models_and_textures_have_maps_of_paths(tmp_path):
    crate = write(tmp_path / "CrateModel", "crate.mtl", "crate.obj", "crate.jpg")
    dataset = o3d.data.CrateModel(str(tmp_path))
    assert dataset.path == crate[1]
    assert dataset.path_map == dict(zip(("crate_material", "crate_model", "texture_image"), crate, strict=True))
    names = ("image/b.jpg", "image/a.jpg", "depth/0.png")
    colors = sorted(write(tmp_path / "SampleFountainRGBDImages", *names)[:2])
    assert o3d.data.SampleFountainRGBDImages(str(tmp_path)).color_paths == colors


def test_a_data_set_of_the_caller_needs_its_folder(tmp_path):
    descriptor = o3d.data.DataDescriptor(o3d.data.open3d_downloads_prefix + "a.zip", "0" * 32)
    with pytest.raises(FileError):
        o3d.data.DownloadDataset("Own", descriptor, str(tmp_path))
    write(tmp_path / "Own", "a.ply")
    assert o3d.data.DownloadDataset("Own", descriptor, str(tmp_path)).extract_dir == str(tmp_path / "Own")
    with pytest.raises(ValueError, match="prefix:"):
        o3d.data.Dataset("")


@pytest.mark.slow
def test_data_sets_have_the_attributes_of_open3d():
    real = pytest.importorskip("open3d").data
    for name in dir(real):
        kind = getattr(real, name)
        if not name.startswith("_") and isinstance(kind, type) and name != "DataDescriptor":
            attributes = {each for each in dir(kind) if not each.startswith("_")}
            assert attributes == {each for each in dir(getattr(o3d.data, name)) if not each.startswith("_")}, name
