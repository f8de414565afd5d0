"""Point cloud files: round trips of every format and attribute, warnings about losses, atomic writing."""

import builtins
import importlib
import sys

import numpy as np
import pytest

import pointloom as loom
from pointloom.io.points.formats import READERS

UTM = np.array([5.01234e5, 5.412345e6, 212.5])
BINARY = [(".ply", False), (".ply", True), (".pcd", False), (".pcd", True), (".npz", False)]
EVERYTHING = ["points", "normals", "colors", "ring", "label", "code", "curvature", "time"]


def full_cloud(rng, device=None, count=150, shift=0.0):
    """A cloud with the attributes of a scanner, colors in steps of 1/255."""
    normals = rng.normal(size=(count, 3))
    return loom.PointCloud(
        rng.normal(size=(count, 3)) * 30 + shift,
        normals=normals / np.linalg.norm(normals, axis=1, keepdims=True),
        colors=rng.integers(0, 256, (count, 3)).astype(np.uint8),
        device=device,
        ring=rng.integers(0, 64, count).astype(np.uint8),
        label=rng.integers(-(2**31), 2**31, count).astype(np.int32),
        code=rng.integers(0, 2**16, count).astype(np.uint16),
        curvature=rng.random(count).astype(np.float32),
        time=rng.random(count) + 1.7e9,
    )


@pytest.mark.parametrize(("extension", "ascii"), BINARY)
@pytest.mark.parametrize(("shift", "count"), [(0.0, 150), (UTM, 150), (0.0, 0)])
def test_every_attribute_survives_a_round_trip_in_its_own_type(device, extension, ascii, shift, count, rng, tmp_path):
    cloud = full_cloud(rng, device, count, shift)
    path = tmp_path / f"cloud{extension}"
    loom.write_point_cloud(path, cloud, ascii=ascii)
    result = loom.read_point_cloud(path, device=device)
    assert result.device == cloud.device and sorted(result.attributes) == sorted(cloud.attributes)
    for name in EVERYTHING:
        assert result[name].dtype == cloud[name].dtype
        np.testing.assert_array_equal(result[name], cloud[name], err_msg=name)
    np.testing.assert_array_equal(result.origin, cloud.origin)


@pytest.mark.parametrize(("extension", "ascii"), [*BINARY, (".xyz", True), (".pts", True)])
def test_utm_coordinates_are_exact_in_every_format(extension, ascii, rng, tmp_path, tolerances):
    """Exact in the file; in the cloud exact for the same origin, otherwise to float32 of its extent."""
    full = loom.PointCloud(rng.random((500, 3)) * [2000, 2000, 50] + UTM)
    part = full.select_by_mask(full.points[:, 0] > UTM[0] + 1500)
    for cloud, limit in ((full, 0), (part, tolerances.float32_relative * 1001)):
        path = tmp_path / f"cloud{extension}"
        loom.write_point_cloud(path, cloud, ascii=ascii)
        np.testing.assert_array_equal(READERS[extension](path).points, cloud.points)
        np.testing.assert_allclose(loom.read_point_cloud(path).points, cloud.points, rtol=0, atol=limit)


@pytest.mark.parametrize("extension", [".ply", ".pcd", ".npz"])
def test_colors_between_the_steps_of_8_bits_are_rounded(extension, rng, tmp_path, tolerances):
    cloud = loom.PointCloud(rng.random((300, 3)), colors=rng.random((300, 3)))
    path = tmp_path / f"cloud{extension}"
    loom.write_point_cloud(path, cloud)
    limit = tolerances.color_8bit if extension != ".npz" else 0
    np.testing.assert_allclose(loom.read_point_cloud(path).colors, cloud.colors, rtol=0, atol=limit)


@pytest.mark.parametrize("extension", [".pcd", ".npz"])
def test_an_organized_cloud_keeps_its_grid_and_its_holes(device, extension, tmp_path):
    depth = np.full((4, 6), 1500, np.uint16)
    depth[1, 2:4] = 0
    camera = loom.PinholeCameraIntrinsic(6, 4, 5, 5, 2.5, 1.5)
    cloud = loom.PointCloud.create_from_depth_image(depth, camera, project_valid_depth_only=False, device=device)
    path = tmp_path / f"cloud{extension}"
    loom.write_point_cloud(path, cloud)
    result = loom.read_point_cloud(path, device=device)
    assert result.grid == (4, 6)
    np.testing.assert_array_equal(result.points, cloud.points)
    assert np.isnan(result.points).any()


@pytest.mark.parametrize("extension", [".ply", ".pcd", ".npz", ".xyz"])
def test_existing_file_is_replaced_atomically(extension, rng, tmp_path):
    path = tmp_path / f"cloud{extension}"
    first, second = (loom.PointCloud(rng.random((n, 3))) for n in (5, 9))
    loom.write_point_cloud(path, first)
    with pytest.raises(loom.FileError, match="exists"):
        loom.write_point_cloud(path, second, overwrite=False)
    assert len(loom.read_point_cloud(path)) == 5
    loom.write_point_cloud(path, second)
    assert len(loom.read_point_cloud(path)) == 9 and list(tmp_path.iterdir()) == [path]


def test_unknown_and_missing_files_and_other_objects_are_named(tmp_path):
    for call in (loom.read_point_cloud, lambda path: loom.write_point_cloud(path, loom.PointCloud())):
        with pytest.raises(loom.FileError, match=r"cloud\.abc"):
            call(tmp_path / "cloud.abc")
        with pytest.raises(loom.FileError, match=r"cloud\.stl"):
            call(tmp_path / "cloud.stl")
    with pytest.raises(loom.FileError, match=r"missing\.ply"):
        loom.read_point_cloud(tmp_path / "missing.ply")
    with pytest.raises(loom.FileError):
        loom.write_point_cloud(tmp_path / "no" / "folder" / "cloud.ply", loom.PointCloud())
    with pytest.raises(TypeError, match="cloud:"):
        loom.write_point_cloud(tmp_path / "cloud.ply", np.eye(3))  # type: ignore[arg-type]
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["device", "origin", "self", "grid"])
def test_an_attribute_may_have_the_name_of_a_parameter(name, tmp_path):
    path = tmp_path / "cloud.ply"
    cloud = loom.PointCloud([[0, 0, 0], [1, 2, 3]])
    cloud[name] = np.array([4, 5], np.int32)
    loom.write_point_cloud(path, cloud)
    assert loom.read_point_cloud(path)[name].tolist() == [4, 5]


def test_an_attribute_with_the_name_of_a_clouds_own_array_is_read_under_another(tmp_path):
    path = tmp_path / "cloud.ply"
    header = "ply\nformat ascii 1.0\nelement vertex 1\n"
    names = "".join(f"property float {name}\n" for name in ("x", "y", "z", "points"))
    path.write_text(f"{header}{names}end_header\n1 2 3 4\n")
    with pytest.warns(UserWarning, match=r"/cloud\.ply:.*points_2"):
        assert loom.read_point_cloud(path)["points_2"].tolist() == [4]


@pytest.mark.parametrize(("missing", "suffix"), [("laspy", ".las"), ("lazrs", ".laz"), ("pye57", ".e57")])
def test_a_missing_package_is_named_with_the_line_that_installs_it(missing, suffix, monkeypatch, tmp_path):
    extra = "e57" if suffix == ".e57" else "las"
    loom.write_point_cloud(tmp_path / f"a{suffix}", loom.PointCloud([[0, 0, 0]]))
    for name in [name for name in sys.modules if name.split(".")[0] == missing]:
        monkeypatch.delitem(sys.modules, name)
    find, load = builtins.__import__, importlib.import_module

    def refuse(name, *args, loader=find, **kwargs):
        if name.split(".")[0] == missing:
            raise ModuleNotFoundError(f"No module named {missing!r}")
        return loader(name, *args, **kwargs)

    monkeypatch.setattr(builtins, "__import__", refuse)
    monkeypatch.setattr("importlib.import_module", lambda name, package=None: refuse(name, package, loader=load))
    message = rf'{suffix} needs the package {missing}. pip install "pointloom\[{extra}\]"'
    with pytest.raises(loom.FileError, match=message):
        loom.read_point_cloud(tmp_path / f"a{suffix}")
