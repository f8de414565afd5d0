"""The unit of lengths in files: formats that store it, formats with a fixed unit, and the others."""

from contextlib import nullcontext

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.units import LengthUnit

TRIANGLE = [[0, 0, 0], [10, 0, 0], [0, 10, 0]], [[0, 1, 2]]
LINK = LengthUnit("Gunter's link", "li", 0.201168)


@pytest.mark.parametrize("unit", [None, "foot", "metre", "degree", LINK], ids=str)
@pytest.mark.parametrize("ascii", [False, True])
@pytest.mark.parametrize("suffix", [".ply", ".pcd", ".npz"])
def test_the_unit_survives(suffix, ascii, unit, tmp_path):
    cloud = loom.PointCloud([[0, 0, 0], [1, 2, 3]], unit=unit, ring=np.int32([1, 2]))
    path = tmp_path / f"a{suffix}"
    loom.write_point_cloud(path, cloud, ascii=ascii)
    back = loom.read_point_cloud(path)
    assert (back.unit, back.points.tolist(), [*back.attributes]) == (cloud.unit, cloud.points.tolist(), ["ring"])


def test_file_without_a_unit_is_unchanged(tmp_path):
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud([[0, 0, 0]]), ascii=True)
    assert "comment" not in (tmp_path / "a.ply").read_text()
    loom.write_point_cloud(tmp_path / "a.pcd", loom.PointCloud([[0, 0, 0]]), ascii=True)
    assert "unit" not in (tmp_path / "a.pcd").read_text()
    loom.write_point_cloud(tmp_path / "a.npz", loom.PointCloud([[0, 0, 0]]))
    assert np.load(tmp_path / "a.npz").files == ["points"]


def test_other_comments_and_those_after_the_header_are_ignored(tmp_path):
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud([[0, 0, 0]], unit="foot"), ascii=True)
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
