"""Point cloud files: round trips, names, units, non-finite values, NPZ archives, and warnings about losses."""

import builtins
import contextlib
import importlib
import io
import os
import re
import sys
import threading
import warnings
import zipfile
from concurrent.futures import ThreadPoolExecutor
from contextlib import nullcontext

import laspy
import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.core.units import LengthUnit
from pointloom.io import source
from pointloom.io.attribute_names import NameRules, is_word, new_names
from pointloom.io.meshes.by_extension import read_mesh
from pointloom.io.meshes.mesh_formats import MESH_FORMATS
from pointloom.io.meshes.tables import write_cloud_table
from pointloom.io.points.by_extension import read_points, write_table
from pointloom.io.points.codecs import WriteOptions
from pointloom.io.points.formats import CLOUD_FORMATS, WRITTEN
from pointloom.io.points.in_parts import open_in_parts
from pointloom.io.points.las import read_las
from pointloom.io.points.npz import read_npz, write_npz
from pointloom.io.points.pcd import write_pcd
from pointloom.io.points.ply import read_ply, write_ply
from pointloom.io.points.scan_files import list_scans, read_scans
from pointloom.io.points.text_parts import TextInParts
from pointloom.io.table import PointTable
from pointloom.registration import run_odometry

from .las_files import edited, make
from .point_tables import assert_same_table, table_of

UTM = np.array([5.01234e5, 5.412345e6, 212.5])
BINARY = [(".ply", False), (".ply", True), (".pcd", False), (".pcd", True), (".npz", False)]


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
    loom.write_point_cloud(path, cloud, write_ascii=ascii)
    result = loom.read_point_cloud(path, device=device)
    assert result.device == cloud.device and sorted(result.attributes) == sorted(cloud.attributes)
    for name in ("points", "normals", "colors", *cloud.attributes):
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
        loom.write_point_cloud(path, cloud, write_ascii=ascii)
        np.testing.assert_array_equal(read_points(path).points, cloud.points)
        np.testing.assert_allclose(loom.read_point_cloud(path).points, cloud.points, rtol=0, atol=limit)


@pytest.mark.parametrize("extension", [".ply", ".pcd", ".npz"])
def test_colors_between_the_steps_of_8_bits_are_rounded(extension, rng, tmp_path, tolerances):
    cloud = loom.PointCloud(rng.random((300, 3)), colors=rng.random((300, 3)))
    path = tmp_path / f"cloud{extension}"
    loom.write_point_cloud(path, cloud)
    limit = tolerances.color_8bit if extension != ".npz" else 0
    np.testing.assert_allclose(loom.read_point_cloud(path).colors, cloud.colors, rtol=0, atol=limit)


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
    with pytest.raises(loom.FileError, match=re.escape(f"one of {' '.join(WRITTEN)};")):  # not .ptx, which is only read
        loom.write_point_cloud(tmp_path / "cloud", loom.PointCloud())
    for missing in ("missing", "missing.ply"):
        with pytest.raises(loom.FileError, match=f"{missing}: (does not exist|cannot be read)"):
            loom.read_point_cloud(tmp_path / missing)
    with pytest.raises(loom.FileError):
        loom.write_point_cloud(tmp_path / "no" / "folder" / "cloud.ply", loom.PointCloud())
    with pytest.raises(TypeError, match="cloud:"):
        loom.write_point_cloud(tmp_path / "cloud.ply", np.eye(3))  # type: ignore[arg-type]
    assert list(tmp_path.iterdir()) == []


def test_other_arguments_folders_and_images_are_named(tmp_path, rng):
    cloud, path = loom.PointCloud(np.add(rng.random((5, 3)), [4e5, 5e6, 0]), crs=25832), tmp_path / "a.las"
    loom.write_point_cloud(path, cloud)
    (tmp_path / "folder").mkdir()
    systems = "the coordinate system of the points is EPSG:25833, that of the file in like is .*32N"
    for error, reason, call in (
        (TypeError, "like: expected the path of a LAS or LAZ file, got int", {"like": 3}),
        (loom.FileError, rf"/b\.las: {systems}\. Call reproject, or set crs if one", {"like": path, "other": True}),
        (ValueError, r"scale: expected finite numbers > 0, got \[0.1, -0.1, 0.1\]", {"scale": [0.1, -0.1, 0.1]}),
        (ValueError, r"scale: expected finite numbers > 0, got \[0.1, nan, 0.1\]", {"scale": [0.1, np.nan, 0.1]}),
    ):
        written = loom.PointCloud(cloud.points, crs=25833) if call.pop("other", False) else cloud
        with pytest.raises(error, match=reason):
            loom.write_point_cloud(tmp_path / "b.las", written, **call)
    assert not (tmp_path / "b.las").exists()
    with pytest.raises(TypeError, match="within: expected an AxisAlignedBoundingBox, got int"):
        loom.read_copc(tmp_path / "a.copc.laz", within=3)
    with pytest.raises(loom.FileError, match=r"/folder: is a folder\. Give the name of a file: \.ply"):
        loom.read_point_cloud(tmp_path / "folder")
    with pytest.raises(loom.FileError, match=r"/a\.png: is an image\. Use read_color, or read_depth for depth maps"):
        loom.read_point_cloud(tmp_path / "a.png")
    with pytest.raises(TypeError, match="scans: expected a folder, files or clouds, got int"):
        list(read_scans(3))


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


WORDS = {"Pulse width": "Pulse_width", "größe": "gr__e", "": "_", "a\tb": "a_b"}
LONG = "Reflectance of the second return 2"  # 34 bytes


def test_names_unsupported_by_the_format_are_changed(tmp_path):
    for suffix, names in (
        (".ply", WORDS | {"x": "x_2"}),
        (".pcd", WORDS | {"x": "x_2", "": "__2", "_": "__2", "rgb": "rgb_2"}),
        (".npz", {"a/b": "a_b", "": "_", "new\nline": "new_line", "grid": "grid_2"}),
        (".las", {LONG: LONG[:32], "": "_", "new\nline": "new_line", "X": "X_2", "red": "red_2"}),
        (".copc.laz", {LONG: LONG[:32]}),
    ):
        for old, new in names.items():
            cloud = loom.PointCloud(np.eye(3), **{old: np.array([1.5, -2, 3], np.float32)})
            with pytest.warns(UserWarning, match="under other names"):
                loom.write_point_cloud(tmp_path / f"a{suffix}", cloud)
            assert loom.read_point_cloud(tmp_path / f"a{suffix}")[new].tolist() == [1.5, -2, 3]


ODD = (
    "class:car",
    "a::b",
    ":",
    "a.b",
    "t=0",
    "[x]",
    "a,b;c",
    "//c",
    "#d",
    "'q'",
    "%d{0}",
    "1e5",
    "nan",
    "comment",
    "x_0",
)


@pytest.mark.parametrize("suffix", [".las", ".laz", ".copc.laz", ".ply", ".pcd", ".npz"])
@pytest.mark.parametrize("count", [0, 3])
@pytest.mark.filterwarnings("error")
def test_names_of_any_visible_ascii_characters_are_preserved(tmp_path, suffix, count):
    names = [name for name in ODD if suffix != ".npz" or "/" not in name]
    values = {name: np.arange(k, k + count, dtype=np.float32) for k, name in enumerate(names)}
    loom.write_point_cloud(tmp_path / f"a{suffix}", loom.PointCloud(np.eye(3)[:count], **values))
    read = loom.read_point_cloud(tmp_path / f"a{suffix}")
    assert {*read.attributes} >= {*names}
    for name in names:
        np.testing.assert_array_equal(np.sort(read[name]), values[name])


@pytest.mark.parametrize("suffix", [".glb", ".gltf"])
def test_gltf_keeps_names_of_any_characters_and_reports_empty_ones(tmp_path, suffix):
    mesh = loom.TriangleMesh(np.eye(3), [[0, 1, 2]])
    for name in (*ODD, "größe", "a b", ""):
        mesh.vertex_attributes[name] = np.arange(3, dtype=np.float32)
    with pytest.warns(UserWarning, match="'' left out, because glTF cannot store"):
        loom.write_triangle_mesh(tmp_path / f"a{suffix}", mesh)
    read = loom.read_triangle_mesh(tmp_path / f"a{suffix}")
    assert {*read.vertex_attributes} == {*ODD, "größe", "a b"}


def test_names_that_would_become_one_stay_apart(tmp_path):
    for suffix, names, changed in (
        (".ply", ["a b", "a_b", "a\tb"], ["a_b_2", "a_b", "a_b_3"]),
        (".ply", ["nx", "ny", "nz"], ["nx", "ny", "nz_2"]),  # no normals
        (".ply", ["red", "green", "blue"], ["red", "green", "blue_2"]),
        (".pcd", ["normal x", "normal_y", "normal_z"], ["normal_x_2", "normal_y", "normal_z"]),
        (".las", [LONG, LONG + "b", "b" * 32], [LONG[:32], LONG[:30] + "_2", "b" * 32]),
    ):
        cloud = loom.PointCloud(np.eye(3), **{name: np.full(3, k, np.int16) for k, name in enumerate(names)})
        with pytest.warns(UserWarning, match="under other names"):
            loom.write_point_cloud(tmp_path / f"a{suffix}", cloud)
        read = loom.read_point_cloud(tmp_path / f"a{suffix}")
        assert [read[name].tolist() for name in changed] == [[k] * 3 for k in range(3)]
        assert not read.has_normals and not read.has_colors


def test_components_take_names_too():
    pairs = np.zeros((2, 2))
    assert new_names({"a": pairs, "a_1": pairs[0]}, NameRules(is_word)) == {"a_1": "a_1_2"}
    assert new_names({"b c": pairs}, NameRules(is_word, max_bytes=4)) == {"b c": "b_"}


@pytest.mark.parametrize("suffix", [".las", ".laz"])
def test_values_out_of_range_of_a_standard_dimension_get_an_extra_one(suffix, tmp_path):
    columns = {"intensity": np.array([0.0, 0.1, 0.9]), "classification": np.array([-1, 0, 300])}
    with pytest.warns(UserWarning, match="'intensity_value', 'classification' as 'classification_value'"):
        loom.write_point_cloud(tmp_path / f"a{suffix}", loom.PointCloud(np.eye(3), **columns))
    read = loom.read_point_cloud(tmp_path / f"a{suffix}")
    for name, values in columns.items():
        np.testing.assert_array_equal(read[f"{name}_value"], values)


def test_mesh_attribute_names_are_valid_in_ply(tmp_path):
    values = np.arange(3, dtype=np.float32)
    mesh = loom.TriangleMesh(np.eye(3), [[0, 1, 2]], vertex_attributes={"a b": values, "x": values})
    mesh.triangle_attributes["vertex_indices"] = values[:1]
    with pytest.warns(UserWarning, match=r"/a\.ply:"):
        loom.write_triangle_mesh(tmp_path / "a.ply", mesh)
    read = loom.read_triangle_mesh(tmp_path / "a.ply")
    assert sorted(read.vertex_attributes) == ["a_b", "x_2"] and [*read.triangle_attributes] == ["vertex_indices_2"]


TYPES = [([2**31 - 1, -1], "i4"), ([2**32 - 1, 0], "u4"), ([2**53, -1], "f8"), ([2**53 + 1, 0], None), ([], "i4")]


@pytest.mark.parametrize(("values", "kind"), TYPES)
def test_convert_writes_64_bit_integers_to_ply_if_none_changes(values, kind, tmp_path):
    table = PointTable(np.zeros((len(values), 3)), attributes={"label": np.array(values, np.int64)})
    assert write_cloud_table(tmp_path / "a.ply", table) == ([] if kind else ["label"])
    attributes = read_ply(tmp_path / "a.ply").attributes
    expected = {"label": (np.dtype(kind), values)} if kind else {}
    assert {name: (column.dtype, column.tolist()) for name, column in attributes.items()} == expected
    with nullcontext() if kind else pytest.raises(FileError, match="'label': the format has no type for int64"):
        write_ply(tmp_path / "b.ply", table)
        assert read_ply(tmp_path / "b.ply").attributes["label"].dtype == np.dtype(kind)


@pytest.mark.parametrize("suffix", [".ply", ".csv", ".txt", ".pcd", ".npz", ".npy", ".vtk", ".vtp", ".las", ".laz"])
@pytest.mark.parametrize("name", ["heat", "level"])
def test_an_attribute_of_one_column_keeps_its_name(tmp_path, suffix, name):
    path, values = tmp_path / f"a{suffix}", np.arange(4, dtype=np.uint16)
    loom.write_point_cloud(path, loom.PointCloud(np.eye(4, 3), **{name: values[:, None], "pair": np.eye(4, 2)}))
    cloud = loom.read_point_cloud(path)
    assert np.ravel(cloud[name]).tolist() == values.tolist()
    if suffix in (".ply", ".csv", ".txt"):
        assert {*cloud.attributes} == {name, "pair_0", "pair_1"}


@pytest.mark.parametrize("of", ["vertex", "triangle"])
@pytest.mark.parametrize("values", [np.full(3, 2**63, np.uint64), np.full(3, -(2**62)), np.ones(3, bool)])
def test_types_of_mesh_attributes_that_ply_lacks_have_a_remedy_that_works(of, values, tmp_path):
    mesh = loom.TriangleMesh(np.eye(3), [[0, 1, 2]] * 3)
    attributes = getattr(mesh, f"{of}_attributes")
    attributes["label"] = values
    with pytest.raises(FileError, match=f"write .vtp, or delete it from .*mesh.{of}_attributes") as error:
        loom.write_triangle_mesh(tmp_path / "a.ply", mesh)
    assert "drop_unsupported" not in str(error.value)
    loom.write_triangle_mesh(tmp_path / "a.vtp", mesh)
    read = getattr(loom.read_triangle_mesh(tmp_path / "a.vtp"), f"{of}_attributes")["label"]
    assert read.tolist() == values.tolist()
    del attributes["label"]
    loom.write_triangle_mesh(tmp_path / "a.ply", mesh)


@pytest.mark.parametrize("suffix", [".ply", ".glb", ".vtk", ".vtp"])
def test_mesh_attributes_of_one_column_and_of_64_bits_keep_name_and_values(tmp_path, suffix):
    values = np.arange(3)[:, None]
    mesh = loom.TriangleMesh(np.eye(3), [[0, 1, 2]], vertex_attributes={"heat": values})
    mesh.triangle_attributes["part"] = values[2:]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore" if suffix == ".glb" else "error")  # glTF has no attributes of triangles
        loom.write_triangle_mesh(tmp_path / f"a{suffix}", mesh)
    back = loom.read_triangle_mesh(tmp_path / f"a{suffix}")
    assert np.ravel(back.vertex_attributes["heat"]).tolist() == [0, 1, 2]
    if suffix != ".glb":
        assert np.ravel(back.triangle_attributes["part"]).tolist() == [2]


TRIANGLE = [[0, 0, 0], [10, 0, 0], [0, 10, 0]], [[0, 1, 2]]
LINK = LengthUnit("Gunter's link", "li", 0.201168)


@pytest.mark.parametrize("unit", [None, "foot", "metre", "degree", LINK], ids=str)
@pytest.mark.parametrize("ascii", [False, True])
@pytest.mark.parametrize("suffix", [".ply", ".pcd", ".npz"])
def test_the_unit_survives(suffix, ascii, unit, tmp_path):
    cloud = loom.PointCloud([[0, 0, 0], [1, 2, 3]], unit=unit, ring=np.int32([1, 2]))
    path = tmp_path / f"a{suffix}"
    loom.write_point_cloud(path, cloud, write_ascii=ascii)
    back = loom.read_point_cloud(path)
    assert (back.unit, back.points.tolist(), [*back.attributes]) == (cloud.unit, cloud.points.tolist(), ["ring"])


def test_file_without_a_unit_is_unchanged(tmp_path):
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud([[0, 0, 0]]), write_ascii=True)
    assert "comment" not in (tmp_path / "a.ply").read_text()
    loom.write_point_cloud(tmp_path / "a.pcd", loom.PointCloud([[0, 0, 0]]), write_ascii=True)
    assert "unit" not in (tmp_path / "a.pcd").read_text()
    loom.write_point_cloud(tmp_path / "a.npz", loom.PointCloud([[0, 0, 0]]))
    assert np.load(tmp_path / "a.npz").files == ["points"]


def test_other_comments_and_those_after_the_header_are_ignored(tmp_path):
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud([[0, 0, 0]], unit="foot"), write_ascii=True)
    text, twice = (tmp_path / "a.ply").read_text(), "unit foot\ncomment unit metre"
    for comments in ("unit mm", "unit of the scan", "units foot", twice, "Unit foot", "unit x = 0 m"):
        (tmp_path / "a.ply").write_text(text.replace("unit foot", comments))
        assert loom.read_point_cloud(tmp_path / "a.ply").unit is None
    points = np.frombuffer(b"\ncomment unit foot\n".ljust(24), "<f4").reshape(2, 3)
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(points, origin=[0, 0, 0]))
    assert b"unit foot" in (tmp_path / "a.ply").read_bytes() and loom.read_point_cloud(tmp_path / "a.ply").unit is None


def test_an_npz_names_its_unit_as_text(tmp_path):
    path = tmp_path / "a.npz"
    loom.write_point_cloud(path, loom.PointCloud([[0, 0, 0]], unit="foot"))
    assert str(np.load(path)["unit"]) == "foot"
    np.savez(path, points=np.zeros((2, 3)), unit=[3, 4])  # an attribute of that name
    cloud = loom.read_point_cloud(path)
    assert cloud.unit is None and cloud["unit"].tolist() == [3, 4]
    cloud.unit = "foot"
    with pytest.warns(UserWarning, match=r"/a\.npz:.*unit_2"):
        loom.write_point_cloud(path, cloud)
    for wrong in ("ell", "", "x" * 300, np.array(["foot"])):
        np.savez(path, points=np.zeros((2, 3)), unit=wrong)
        with pytest.raises(loom.FileError, match=r"unit|archive"):
            loom.read_point_cloud(path)


def test_an_e57_is_in_metres(tmp_path):
    path = tmp_path / "a.e57"
    loom.write_point_cloud(path, loom.PointCloud([[0, 0, 0], [1, 2, 3]]))
    cloud = loom.read_point_cloud(path)
    assert cloud.unit == "metre" and cloud.points[1].tolist() == [1, 2, 3]
    assert loom.read_point_cloud(path, scan=0).unit == "metre"
    with pytest.warns(loom.UnitWarning, match=r"/a\.e57:.*0\.3048"):
        loom.write_point_cloud(path, loom.PointCloud([[0, 0, 0], [0, 0, 1000]], unit="ft"))
    assert loom.read_point_cloud(path).points[1, 2] == pytest.approx(304.8)
    with pytest.raises(loom.FileError, match=r"degrees.*project_to_utm"):
        loom.write_point_cloud(path, loom.PointCloud([[8, 48, 0]], unit="degree"))


def test_meshes_keep_the_unit_if_the_format_stores_it(tmp_path):
    mesh = loom.TriangleMesh(*TRIANGLE)
    mesh.unit = "foot"
    loom.write_triangle_mesh(tmp_path / "a.ply", mesh)
    assert loom.read_triangle_mesh(tmp_path / "a.ply").unit == "foot"
    assert loom.read_point_cloud(tmp_path / "a.ply").unit == "foot"
    with pytest.warns(loom.UnitWarning, match=r"/a\.glb:"):
        loom.write_triangle_mesh(tmp_path / "a.glb", mesh)
    back = loom.read_triangle_mesh(tmp_path / "a.glb")
    assert back.unit == "metre" and back.vertices.max() == pytest.approx(3.048)


@pytest.mark.parametrize("suffix", [".obj", ".stl", ".off", ".xyz"])
def test_format_without_a_unit_field_warns(suffix, tmp_path):
    path = tmp_path / f"a{suffix}"
    for unit, count in (("foot", 1), ("metre", 0), (None, 0)):
        mesh = loom.TriangleMesh(*TRIANGLE)
        mesh.unit = unit
        cloud = loom.PointCloud(TRIANGLE[0], unit=unit)
        with pytest.warns(loom.UnitWarning, match="coordinates are in foot") if count else nullcontext():
            if suffix == ".xyz":
                loom.write_point_cloud(path, cloud)
            else:
                loom.write_triangle_mesh(path, mesh)


SIGNALLING = {np.float32: (np.uint32, 0x7F800001), np.float64: (np.uint64, 0x7FF0000000000001)}
KINDS = ("signalling", "all signalling", "infinite", "all infinite", "largest", "far signalling", "far infinite")


def vectors(kind, dtype):
    rows = np.arange(18, dtype=dtype).reshape(6, 3) + dtype(1e6 if kind.startswith("far") else 0)
    unsigned, bits = SIGNALLING[dtype]
    if kind.endswith("signalling"):
        rows.view(unsigned)[2:, 1] = bits
        if kind.startswith("all"):
            rows.view(unsigned)[...] = bits
    elif kind.endswith("infinite"):
        rows[2] = np.inf
        rows[3] = -np.inf
        if kind.startswith("all"):
            rows[...] = np.inf
            rows[::2] = -np.inf
    else:
        rows[2, 1], rows[3, 1] = np.finfo(dtype).max, -np.finfo(dtype).max
    return rows


def attempt(operation, *args, **kwargs):
    """The result, or None if rejected. A warning is an error, even as the cause of a rejection."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.simplefilter("ignore", UserWarning)  # of attributes with other names
        try:
            return operation(*args, **kwargs)
        except (ValueError, TypeError) as error:
            assert "encountered" not in str(error)
            return None


@pytest.mark.parametrize("dtype", SIGNALLING)
@pytest.mark.parametrize("kind", KINDS)
def test_non_finite_cloud_issues_no_warning(kind, dtype, device):
    rows = vectors(kind, dtype)
    cloud = attempt(loom.PointCloud, rows, device=device)
    if cloud is not None:
        points = attempt(lambda: cloud.points)
        np.testing.assert_array_equal(np.isnan(points), np.isnan(rows))
        assert np.isfinite(points[:2]).all() == np.isfinite(rows[:2]).all()
    attempt(loom.PointCloud, rows, origin=[1e5, 0, 0], device=device)
    for name in ("normals", "colors", "intensity"):
        attempt(loom.PointCloud, np.zeros((6, 3)), device=device, **{name: rows})


@pytest.mark.parametrize("dtype", SIGNALLING)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", ["points", "normals", "intensity"])
def test_non_finite_file_issues_no_warning(name, kind, dtype, tmp_path):
    rows = vectors(kind, dtype)
    plain = np.arange(18, dtype=dtype).reshape(6, 3)
    for extension in CLOUD_FORMATS:
        normals = rows if name == "normals" else np.ones((6, 3)) if extension == ".xyzn" else None
        attributes = {"intensity": rows[:, 1].copy()} if name == "intensity" else {}
        colors = np.full((6, 3), 0.5) if extension == ".xyzrgb" else None
        table = PointTable(rows if name == "points" else plain, normals, colors, attributes)
        for ascii in {False, extension in (".ply", ".pcd")}:
            path = tmp_path / f"{ascii}{extension}"
            attempt(write_table, path, table, WriteOptions(ascii=ascii, overwrite=True))
            if path.exists():
                attempt(loom.read_point_cloud, path)
    stored = {"points": plain, name: rows if name != "intensity" else rows[:, 1]}
    np.savez(tmp_path / "raw.npz", **stored)
    attempt(loom.read_point_cloud, tmp_path / "raw.npz")


@pytest.mark.parametrize("bound", ["7ff0000000000001", "7ff0000000000000", "fff0000000000000", "7fefffffffffffff"])
def test_las_header_with_a_non_finite_box_issues_no_warning(bound, small_las):
    edited(small_las, *((at, "<Q", int(bound, 16)) for at in range(179, 227, 8)))
    parts = attempt(lambda: list(loom.read_las_chunks(small_las, 7)))
    assert [len(part) for part in parts] == [7, 7, 6]
    joined = np.concatenate([part.points for part in parts])
    np.testing.assert_allclose(joined, read_las(small_las).points, rtol=0, atol=4)  # 2e7 m apart


def test_extra_dimension_with_a_non_finite_scale_issues_no_warning(tmp_path, rng):
    extra = laspy.ExtraBytesParams("range", "i4", scales=[np.inf], offsets=[-np.inf])
    make(tmp_path / "a.las", 6, 20, rng, [extra])
    cloud = attempt(loom.read_point_cloud, tmp_path / "a.las")
    assert not np.isfinite(cloud["range"]).any()


def test_coordinate_overflow_error_names_the_file(tmp_path):
    (tmp_path / "far.xyz").write_text("0 0 0\n1e39 0 0\n")
    with pytest.raises(loom.FileError, match=r"far\.xyz"):
        loom.read_point_cloud(tmp_path / "far.xyz")


def cloud(count=40, dtype=np.float32, grid=None):
    rng = np.random.default_rng(8)
    attributes = {code: rng.integers(0, 2, count).astype(code) for code in ("?", "i1", "u2", "i4", "u8", "f2", "f8")}
    return table_of(count, dtype, grid, features=rng.random((count, 33)), file=np.arange(count), **attributes)


def array_bytes(array, **changes):
    stream = io.BytesIO()
    np.save(stream, array)
    data = stream.getvalue()
    for old, new in changes.items():
        head, body = data[:128], data[128:]
        old, new = old.encode(), new.encode()
        assert old in head
        data = head.replace(old, new)[:127].ljust(127) + b"\n" + body
    return data


def write_members(path, **members):
    with zipfile.ZipFile(path, "w") as archive:
        for name, data in members.items():
            archive.writestr(f"{name}.npy", data)


@pytest.fixture
def path(tmp_path):
    return tmp_path / "cloud.npz"


@pytest.mark.parametrize(("count", "grid", "dtype"), [(0, None, "f4"), (1, None, "f8"), (40, (5, 8), "f4")])
def test_every_array_survives_a_round_trip_to_the_bit(path, dtype, count, grid):
    table = cloud(count, dtype, grid)
    write_npz(path, table)
    assert_same_table(read_npz(path), table)
    assert list(read_npz(path).attributes) == list(table.attributes)


def test_numpy_reads_written_files_and_their_bytes_are_reproducible(path, tmp_path):
    table = cloud()
    write_npz(path, table)
    with np.load(path) as archive:
        np.testing.assert_array_equal(archive["points"], table.points)
    write_npz(tmp_path / "again.npz", table)
    assert path.read_bytes() == (tmp_path / "again.npz").read_bytes()


@pytest.mark.parametrize("save", [np.savez, np.savez_compressed])
def test_archives_of_numpy_are_read_in_any_layout(path, save):
    points = np.arange(12, dtype=">f8").reshape(3, 4).T
    save(path, points=points, colors=np.full((4, 3), 51, np.uint8), ring=np.arange(8)[::2])
    read = read_npz(path)
    assert read.points.dtype == np.float64 and read.points.flags.c_contiguous
    np.testing.assert_array_equal(read.points, points)
    np.testing.assert_array_equal(read.colors, np.full((4, 3), 0.2, np.float32))
    np.testing.assert_array_equal(read.attributes["ring"], [0, 2, 4, 6])


@pytest.mark.parametrize(
    ("arrays", "reason"),
    [
        ({"xyz": np.zeros((2, 3))}, "no array 'points' (the archive contains: xyz)"),
        ({"points": np.zeros((3, 2))}, "points: expected numbers of shape [n, 3], got float64 [3, 2]"),
        ({"points": np.zeros((2, 3), bool)}, "points: expected numbers"),
        ({"points": np.zeros((2, 3)), "normals": np.zeros((3, 3))}, "normals: expected numbers of shape [2, 3]"),
        ({"points": np.zeros((2, 3)), "colors": np.full((2, 3), 2.0)}, "a color is outside 0..1"),
        ({"points": np.zeros((2, 3)), "ring": np.zeros((2, 2, 2))}, "ring: expected shape [2] or [2, c], got [2, 2"),
        ({"points": np.zeros((2, 3)), "grid": np.array([3, 3])}, "grid: expected height and width"),
        ({"points": np.zeros((2, 3)), "evil": np.array([print, None], object)}, "evil:"),  # never unpickled
    ],
)
def test_an_archive_that_is_no_cloud_is_refused(path, arrays, reason):
    np.savez(path, **arrays)
    with pytest.raises(FileError, match=re.escape(reason)):
        read_npz(path)


SHAPES = f"({10**18}, 3)", "(-2, -3)", "(3, 3)", "(1, 3)", "(2, 3, 1)", "()", "(True, 6)", "(2.0, 3)"


@pytest.mark.parametrize("shape", SHAPES)
def test_header_with_a_wrong_shape_is_rejected_before_allocation(path, shape):
    write_members(path, points=array_bytes(np.zeros((2, 3)), **{"(2, 3)": shape}))
    with pytest.raises(FileError, match="points:"):
        read_npz(path)


@pytest.mark.parametrize("size", [10**9, 2**32 - 2])
def test_directory_with_a_wrong_size_is_rejected(path, size):
    write_members(path, points=array_bytes(np.zeros((2, 3))))
    data = bytearray(path.read_bytes())
    entry = data.rindex(b"PK\1\2")
    data[entry + 24 : entry + 28] = size.to_bytes(4, "little")
    path.write_bytes(data)
    with pytest.raises(FileError, match=f"claims {size} bytes from 176 stored ones"):
        read_npz(path)


def test_a_damaged_archive_is_refused(path):
    for change, reason in (
        (lambda data: b"", "is empty"),
        (lambda data: data[:-1], "truncated"),
        (lambda data: data + b"\0", "bytes follow its end"),
        (lambda data: b"junk" + data, "4 bytes precede the archive"),
        (lambda data: data.replace(b"ring__.npy", b"points.npy"), "is duplicated"),
        (lambda data: data.replace(b"\x93NUMPY\1", b"\x93NUMPY\7"), "Bad CRC-32"),
    ):
        np.savez(path, points=np.zeros((2, 3)), ring__=np.zeros(2))
        path.write_bytes(change(path.read_bytes()))
        with pytest.raises(FileError, match=reason):
            read_npz(path)


@pytest.mark.parametrize("name", ["points", "grid", "", "a/b", "..\\b", "new\nline"])
def test_attribute_name_unsupported_as_member_is_rejected(path, name):
    with pytest.raises(FileError, match=r"/cloud\.npz:"):
        write_npz(path, PointTable(np.zeros((2, 3)), attributes={name: np.zeros(2)}))
    assert not list(path.parent.iterdir())


@pytest.mark.parametrize(
    ("write", "attributes", "reason"),
    [
        (write_ply, {"flag": np.zeros(2, bool)}, "no type for bool"),
        (write_ply, {"größe": np.zeros(2)}, "cannot be named"),
        (write_ply, {"a_0": np.zeros(2), "a": np.zeros((2, 2))}, "'a_0' exists already"),
        (write_ply, {"none": np.zeros((2, 0))}, "no components"),
        (write_ply, {name: np.zeros(2) for name in "rgb"}, "would be read as normals or colors"),
        (write_pcd, {"half": np.zeros(2, np.float16)}, "no type for float16"),
        (write_pcd, {"two words": np.zeros(2)}, "cannot be named"),
        (write_pcd, {"x": np.zeros(2)}, "uses this name itself"),
        (write_pcd, {"none": np.zeros((2, 0))}, "no components"),
        (write_pcd, {"rgb": np.zeros(2, np.uint32)}, "would be read as normals or colors"),
        (write_pcd, {f"normal_{axis}": np.zeros(2) for axis in "xyz"}, "would be read as normals or colors"),
    ],
)
def test_attribute_that_cannot_be_read_back_is_rejected(tmp_path, write, attributes, reason):
    with pytest.raises(FileError, match=re.escape(reason)) as caught:
        write(tmp_path / "cloud", PointTable(np.zeros((2, 3)), attributes=attributes))
    assert caught.value.remedy and not list(tmp_path.iterdir())


@pytest.mark.parametrize("write, cut, size, more", [(write_ply, 7, 236, b"\1"), (write_pcd, 5, 286, b"x")])
def test_missing_and_additional_bytes_of_a_binary_file_are_named_by_their_offset(tmp_path, write, cut, size, more):
    path = tmp_path / ("cloud.ply" if write is write_ply else "cloud.pcd")
    write(path, PointTable(np.zeros((10, 3), np.float32)))
    valid = path.read_bytes()
    path.write_bytes(valid[:-cut])
    with pytest.raises(FileError, match=rf"/{path.name} \(byte {size - cut}\):.*120.*{120 - cut}.*{cut}"):
        read_points(path)
    path.write_bytes(valid + more)
    with pytest.raises(FileError, match=rf"/{path.name} \(byte {size}\): 1 bytes follow"):
        read_points(path)


def test_out_of_memory_error_names_the_file(path, monkeypatch):
    np.savez(path, points=np.zeros((2, 3)))

    def refuse(*args, **kwargs):
        raise MemoryError

    for target in ("zipfile.ZipExtFile.read", "numpy.lib.format.read_array_header_1_0", "numpy.frombuffer"):
        with monkeypatch.context() as patch:
            patch.setattr(target, refuse)
            with pytest.raises(MemoryError, match=re.escape(f"{path}: not enough memory")):
                read_npz(path)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (r"{'descr': '\z', 'fortran_order': False, 'shape': (3,), }", "header is damaged"),  # Python warns of both
        ("{'descr': '<f8', 'fortran_order': False, 'shape': (1or 3,), }", "header is damaged"),
        ("(" * 5000, "header is damaged"),
        (b"\x94NUMPY\1\0v\0", "header is damaged"),
        (b"\x93NUMPY\7\0v\0", "unknown version"),
    ],
    ids=range(5),
)
def test_a_damaged_header_is_an_error_and_no_warning(path, text, reason):
    header = text if isinstance(text, bytes) else b"\x93NUMPY\1\0" + (len(text) + 2).to_bytes(2, "little")
    write_members(path, points=header + (b"" if isinstance(text, bytes) else text.encode() + b" \n") + bytes(200))
    with pytest.raises(FileError, match=reason):
        read_npz(path)


def test_names_with_leading_zeros_and_words_are_ordered(tmp_path):
    names = ["a1.pcd", "a01.pcd", "a002.pcd", "a10.pcd", "b.pcd", "2.pcd", "10.pcd"]
    for name in names:
        (tmp_path / name).touch()
    (tmp_path / "notes.md").touch()
    (tmp_path / "more.pcd").mkdir()
    listed = [path.name for path in list_scans(tmp_path)]
    assert listed == ["a01.pcd", "a1.pcd", "a002.pcd", "a10.pcd", "b.pcd", "2.pcd", "10.pcd"]


def test_tables_beside_scans_are_no_scans(tmp_path):
    for name in ("1.csv", "2.csv"):
        (tmp_path / name).write_text("0,0,0\n1,2,3\n")
    assert [path.name for path in list_scans(tmp_path)] == ["1.csv", "2.csv"]
    for name in ("1.bin", "times.txt"):
        (tmp_path / name).touch()
    assert [path.name for path in list_scans(tmp_path)] == ["1.bin"]


def test_folders_that_are_none_are_named(tmp_path):
    with pytest.raises(FileError, match="contains no scan"):
        run_odometry(tmp_path)
    (tmp_path / "1.bin").touch()
    (tmp_path / "2.ply").touch()
    for wrong, error, message in (
        (tmp_path / "nowhere", FileError, "/nowhere:"),
        (tmp_path, FileError, r"several types: \.bin, \.ply"),
        (tmp_path / "1.bin", FileError, r"/1\.bin:"),
        ([tmp_path / "1.bin"], FileError, "is empty"),
        (loom.PointCloud([[1, 2, 3]]), TypeError, r"^scans:"),
        ([3], TypeError, r"^scans:"),
    ):
        with pytest.raises(error, match=message):
            run_odometry(wrong)
    with pytest.raises(ValueError, match="timestamps:"):
        run_odometry([loom.PointCloud([[1, 2, 3]])], timestamps=[0.0, 1.0])
    assert len(run_odometry([])) == 0


def cut(path):
    os.truncate(path, 100)


def grow(path):
    with path.open("ab") as file:
        file.write(b"1 2 3\n")


def write_over(path):
    """Other content of the same size. The time may be that of the first content, since clocks of files are coarse."""
    status, size = path.stat(), path.stat().st_size
    with path.open("r+b") as file:
        file.write(bytes(size))
    os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns + 10**9))


def write_points(path, count):
    points = np.random.default_rng(0).normal(size=(count, 3))
    vectors = {".xyzn": {"normals": points}, ".xyzrgb": {"colors": points % 1}}
    loom.write_point_cloud(path, loom.PointCloud(points, **vectors.get(path.suffix, {})))


def test_threads_read_their_own_bytes_where_reading_moves_the_position_of_the_file(tmp_path, monkeypatch):
    (tmp_path / "a").write_bytes(bytes(range(200)))
    file, seek, both = source.open_source(tmp_path / "a"), os.lseek, threading.Barrier(2)

    def slow_seek(*arguments):
        seek(*arguments)
        with contextlib.suppress(threading.BrokenBarrierError):
            both.wait(0.2)  # until the other thread has moved the position, too, if it can
        return arguments[1]

    for name in ("pread", "preadv"):  # as on Windows
        monkeypatch.delattr(os, name, raising=False)
    monkeypatch.setattr(os, "lseek", slow_seek)
    with ThreadPoolExecutor(2) as pool:
        parts = list(pool.map(lambda begin: file[begin : begin + 10], (0, 100)))
    assert parts == [bytes(range(10)), bytes(range(100, 110))]


CHANGES = [cut, grow, write_over]
CHANGED = "was changed while it was read: expected .* bytes, got "


@pytest.fixture
def change_after_opening(monkeypatch):
    """Change files when they have been opened, once."""

    def arrange(change):
        class Changing(source.SourceFile):
            def __init__(self, path):
                super().__init__(path)
                monkeypatch.setattr(source, "SourceFile", source.SourceFile.__bases__[0])
                change(path)

        monkeypatch.setattr(source, "SourceFile", Changing)

    return arrange


@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("suffix", [*CLOUD_FORMATS, *MESH_FORMATS, "_binary.stl"])
def test_a_file_that_changes_while_it_is_read_is_an_error(suffix, change, tmp_path, change_after_opening):
    path = tmp_path / f"a{suffix}"
    if suffix == ".ptx":
        path.write_text("3\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n" + "1 2 3 0.5\n" * 3)
    elif suffix == ".bin":
        path.write_bytes(
            np.random.default_rng(0)
            .uniform(-50, 50, (301, 4))
            .clip([-50] * 3 + [0.1], [50] * 3 + [0.9])
            .astype("<f4")
            .tobytes()
        )
    elif suffix == ".obj":
        path.write_text("v 1.5 2.5 3.5\n" * 300)
    elif suffix in CLOUD_FORMATS and suffix not in (".csv", ".txt", ".asc"):
        write_points(path, 300)
    elif suffix in CLOUD_FORMATS:
        path.write_text("x y z\n" + "1.5 2.5 3.5\n" * 300)
    else:
        loom.write_triangle_mesh(path, loom.TriangleMesh.create_sphere(1.0, 5))
    reader = read_points if suffix in CLOUD_FORMATS else read_mesh
    reader(path)
    change_after_opening(change)
    with pytest.raises(FileError, match=CHANGED):
        reader(path)


@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("suffix", [".ply", ".pcd", ".las", ".laz", ".xyz"])
def test_a_file_that_changes_between_its_parts_is_an_error(suffix, change, tmp_path, monkeypatch):
    monkeypatch.setattr("pointloom.io.points.text_parts.BLOCK_BYTES", 1000)
    path = tmp_path / f"a{suffix}"
    write_points(path, 300)
    parts = (TextInParts(path) if suffix == ".xyz" else open_in_parts(path)).parts(10)
    assert len(next(parts).points)
    change(path)
    with pytest.raises(FileError, match=CHANGED):
        list(parts)


@pytest.mark.parametrize("suffix", [".ply", ".las", ".xyz"])
def test_a_file_that_is_replaced_between_its_parts_is_read_to_its_end(suffix, tmp_path):
    path, other = tmp_path / f"a{suffix}", tmp_path / f"b{suffix}"
    for file, count in ((path, 300), (other, 7)):
        write_points(file, count)
    parts = (TextInParts(path) if suffix == ".xyz" else open_in_parts(path)).parts(10)
    first = next(parts)
    other.replace(path)
    assert len(first.points) + sum(len(part.points) for part in parts) == 300


def test_colors_of_16_bits_are_not_rounded_silently(tmp_path):
    fine = np.array([[1000, 0, 65535], [0, 0, 0]]) / 65535
    for suffix in (".ply", ".pcd", ".e57"):
        with pytest.warns(UserWarning, match="rounded to the 8 bits"):
            loom.write_point_cloud(tmp_path / f"a{suffix}", loom.PointCloud(np.eye(3)[:2], colors=fine))
        for colors in (np.rint(fine * 255) / 255, [[0.5, 0.123, 0.7], [0.1, 0.9, 0.3]]):
            loom.write_point_cloud(tmp_path / f"a{suffix}", loom.PointCloud(np.eye(3)[:2], colors=colors))


@pytest.mark.parametrize("padding", [b"\n", b" \r\n", bytes(100), bytes(3912) + b"\n"])
@pytest.mark.parametrize("suffix", [".ply", ".pcd", ".npy", ".stl"])
def test_zeros_and_white_space_after_a_binary_payload_are_left_out(tmp_path, suffix, padding):
    path, corners = tmp_path / f"a{suffix}", np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.float32)
    if suffix == ".stl":
        loom.write_triangle_mesh(path, loom.TriangleMesh(corners, [[0, 1, 2]]))
    else:
        loom.write_point_cloud(path, loom.PointCloud(corners, weight=[1.0, 2.0, 3.0]))
    read = loom.read_triangle_mesh if suffix == ".stl" else loom.read_point_cloud
    valid, expected = path.read_bytes(), read(path)
    path.write_bytes(valid + padding)
    found = read(path)
    for name in ("vertices", "triangles") if suffix == ".stl" else ("points", "weight"):
        given = [one[name] if name == "weight" else getattr(one, name) for one in (expected, found)]
        np.testing.assert_array_equal(*given)
    path.write_bytes(valid + padding + b"\2")
    with pytest.raises(FileError, match="bytes follow"):
        read(path)


CAPITALS = "X Y Z Intensity Normal_X Normal_Y Normal_Z"
PLY_CAPITALS = "X Y Z Intensity NX NY NZ Red Green BLUE"


@pytest.mark.parametrize("name", ["a.pcd", "a.ply", "b.ply", "a.npy"])
def test_names_of_coordinates_normals_and_colors_are_read_in_any_case(tmp_path, name):
    path, rows = tmp_path / name, np.arange(20, dtype=np.float32).reshape(2, 10) / 20
    names = (CAPITALS if name == "a.pcd" else PLY_CAPITALS).split()
    rows = rows[:, : len(names)].copy()
    if name == "a.pcd":
        count = len(names)
        head = f"VERSION 0.7\nFIELDS {CAPITALS}\nSIZE{' 4' * count}\nTYPE{' F' * count}\nCOUNT{' 1' * count}\n"
        path.write_bytes(f"{head}WIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA binary\n".encode() + rows.tobytes())
    elif name == "a.npy":
        np.save(path, rows.view([(key, "f4") for key in names])[:, 0])
    else:
        form = "ascii" if name == "a.ply" else "binary_little_endian"
        head = f"ply\nformat {form} 1.0\nelement vertex 2\n" + "".join(f"property float {key}\n" for key in names)
        body = "\n".join(" ".join(map(str, row)) for row in rows.tolist()).encode()
        path.write_bytes(head.encode() + b"end_header\n" + (body if form == "ascii" else rows.tobytes()))
    cloud = loom.read_point_cloud(path)
    np.testing.assert_array_equal(cloud.points, rows[:, :3])
    np.testing.assert_array_equal(cloud.normals, rows[:, 4:7])
    np.testing.assert_array_equal(cloud["Intensity"], rows[:, 3])
    if name != "a.pcd":
        np.testing.assert_array_equal(cloud.colors, rows[:, 7:])


def test_exact_names_take_precedence_over_capitals(tmp_path):
    np.save(tmp_path / "a.npy", np.array([(1, 2, 3, 9)], [(key, "f4") for key in ("x", "y", "z", "X")]))
    cloud = loom.read_point_cloud(tmp_path / "a.npy")
    assert cloud.points.tolist() == [[1, 2, 3]] and cloud["X"].tolist() == [9]


def test_a_pts_file_without_a_number_of_points_is_read_with_a_warning(tmp_path):
    (tmp_path / "a.pts").write_text("1 2 3 0.5 10 20 30\n4 5 6 0.25 40 50 60\n")
    with pytest.warns(UserWarning, match="no number of points"):
        cloud = loom.read_point_cloud(tmp_path / "a.pts")
    assert cloud.points.tolist() == [[1, 2, 3], [4, 5, 6]] and cloud["intensity"].tolist() == [0.5, 0.25]
    with pytest.warns(UserWarning, match="no number of points"):
        assert TextInParts(tmp_path / "a.pts").count == 2
    (tmp_path / "b.pts").write_text("1 2\n4 5 6\n")
    with pytest.raises(FileError, match="number of points"):
        loom.read_point_cloud(tmp_path / "b.pts")
