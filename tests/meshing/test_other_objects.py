"""Clouds and meshes of other libraries: accepted, converted with all attributes, and converted back."""

import warnings

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.other_geometry import OtherGeometry, read_other

UTM = np.array([412_300.0, 5_651_200.0, 120.0])
CUBE = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
QUADS = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
TRIANGLES = QUADS[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)
BYTES = np.arange(24, dtype=np.uint8).reshape(8, 3) * 10
NORMALS = (CUBE - 0.5) / np.linalg.norm(CUBE - 0.5, axis=1, keepdims=True)
INTENSITY = np.arange(8, dtype=np.int32)
IMAGE = np.arange(4 * 6 * 3, dtype=np.uint8).reshape(4, 6, 3)

BOX, POINTS = loom.TriangleMesh.create_box(), loom.PointCloud(CUBE)


def full_cloud(shift=UTM):
    colors = BYTES.astype(np.float32) / 255
    return loom.PointCloud(CUBE + shift, normals=NORMALS, colors=colors, intensity=INTENSITY, unit="metre", crs=25832)


def full_mesh(shift=UTM, **options):
    colors = BYTES.astype(np.float32) / 255
    options = {"vertex_attributes": {"heat": np.arange(8.0)}, "triangle_attributes": {"part": np.arange(12)}} | options
    mesh = loom.TriangleMesh(CUBE + shift, TRIANGLES, vertex_normals=NORMALS, vertex_colors=colors, **options)
    mesh.unit, mesh.crs = "metre", 25832
    return mesh


def make_trimesh(shift):
    trimesh = pytest.importorskip("trimesh")
    options = {"vertex_normals": NORMALS.copy(), "vertex_colors": BYTES, "process": False}
    return trimesh.Trimesh(CUBE + shift, TRIANGLES, vertex_attributes={"heat": INTENSITY}, **options)


def make_open3d(shift):
    o3d = pytest.importorskip("open3d")
    vectors = o3d.utility.Vector3dVector
    mesh = o3d.geometry.TriangleMesh(vectors(CUBE + shift), o3d.utility.Vector3iVector(TRIANGLES))
    mesh.vertex_normals, mesh.vertex_colors = vectors(NORMALS), vectors(BYTES / 255)
    return mesh


def make_open3d_tensor(shift):
    o3d = pytest.importorskip("open3d")
    tensor = o3d.core.Tensor
    mesh = o3d.t.geometry.TriangleMesh(tensor(CUBE + shift), tensor(TRIANGLES))
    mesh.vertex["normals"], mesh.vertex["colors"] = tensor(NORMALS.astype(np.float32)), tensor(BYTES)
    mesh.vertex["heat"] = tensor(INTENSITY[:, None])
    return mesh


def make_pyvista(shift):
    pyvista = pytest.importorskip("pyvista")
    mesh = pyvista.PolyData(CUBE + shift, np.insert(QUADS, 0, 4, axis=1).reshape(-1))
    mesh.point_data["Normals"], mesh.point_data["RGB"], mesh.point_data["heat"] = NORMALS, BYTES, INTENSITY
    mesh.cell_data["side"] = np.arange(6, dtype=np.int32)
    return mesh


def make_vtk(shift):
    pytest.importorskip("vtkmodules")
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    data, points, polygons = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(CUBE + shift, deep=True))
    starts, corners = np.arange(0, 28, 4), QUADS.reshape(-1)
    polygons.SetData(*(numpy_to_vtkIdTypeArray(values, deep=True) for values in (starts[:7], corners)))
    data.SetPoints(points)
    data.SetPolys(polygons)
    for name, values in {"Normals": NORMALS, "RGB": BYTES, "heat": INTENSITY}.items():
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    return data


def make_meshio(shift):
    meshio = pytest.importorskip("meshio")
    cells = [("quad", QUADS[:3]), ("triangle", TRIANGLES[6:])]
    data = {"Normals": NORMALS, "RGB": BYTES, "heat": INTENSITY}
    return meshio.Mesh(
        CUBE + shift,
        cells,
        point_data=data,
        cell_data={"side": [np.arange(3, dtype=np.int32), np.arange(6, dtype=np.int32)]},
    )


MESHES = [make_trimesh, make_open3d, make_open3d_tensor, make_pyvista, make_vtk, make_meshio]


@pytest.mark.parametrize("make", MESHES)
def test_meshes_of_other_libraries_are_exact_and_keep_their_attributes(make, device):
    given = make(UTM)
    for convert in (loom.TriangleMesh, loom.from_any):
        mesh = convert(given, device=device)
        assert str(mesh.device) == str(device)
        np.testing.assert_array_equal(mesh.vertices, CUBE + UTM)
        assert len(mesh) == 12
        assert mesh.get_volume() == pytest.approx(abs(mesh.get_volume()))
        assert mesh.get_surface_area() == pytest.approx(6)
        np.testing.assert_array_equal(mesh.vertex_colors, BYTES.astype(np.float32) / np.float32(255))
        np.testing.assert_allclose(mesh.vertex_normals, NORMALS, rtol=1e-6)
        if make is not make_open3d:
            assert mesh.vertex_attributes["heat"].reshape(-1).tolist() == list(range(8))
    if make is make_pyvista:
        assert mesh.triangle_attributes["side"].tolist() == np.repeat(np.arange(6), 2).tolist()
    if make is make_meshio:
        assert mesh.triangle_attributes["side"].tolist() == [0, 0, 1, 1, 2, 2, *range(6)]


@pytest.mark.parametrize("make", MESHES)
def test_drawn_and_written_meshes_of_other_libraries_are_as_converted_ones(make, tmp_path):
    given = make(np.zeros(3))
    np.testing.assert_array_equal(
        np.asarray(loom.render(given, size=(64, 48))), np.asarray(loom.render(loom.from_any(given), size=(64, 48)))
    )
    loom.write_triangle_mesh(tmp_path / "a.ply", given)
    loom.write_triangle_mesh(tmp_path / "b.ply", loom.from_any(given))
    assert (tmp_path / "a.ply").read_bytes() == (tmp_path / "b.ply").read_bytes()


def clouds():
    o3d = pytest.importorskip("open3d")
    legacy = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(CUBE + UTM))
    legacy.colors = o3d.utility.Vector3dVector(BYTES / 255)
    tensor = o3d.t.geometry.PointCloud(o3d.core.Tensor(CUBE + UTM))
    tensor.point["colors"] = o3d.core.Tensor(BYTES)
    return {"legacy": legacy, "tensor": tensor}


def cloud_of(library):
    if library in ("legacy", "tensor"):
        return clouds()[library]
    if library == "trimesh":
        return pytest.importorskip("trimesh").PointCloud(CUBE + UTM, colors=BYTES)
    if library == "meshio":
        cells = [("vertex", np.arange(8)[:, None])]
        return pytest.importorskip("meshio").Mesh(CUBE + UTM, cells, point_data={"RGB": BYTES})
    cloud = getattr(pytest.importorskip("pyvista"), library)(CUBE + UTM)
    cloud.point_data["RGB"] = BYTES
    return cloud


@pytest.mark.parametrize("library", ["legacy", "tensor", "trimesh", "meshio", "PolyData", "PointSet"])
def test_clouds_of_other_libraries_are_exact_and_keep_their_colors(library, tmp_path):
    given = cloud_of(library)
    for convert in (loom.PointCloud, loom.from_any):
        cloud = convert(given)
        np.testing.assert_array_equal(cloud.points, CUBE + UTM)
        np.testing.assert_array_equal(cloud.colors, BYTES.astype(np.float32) / np.float32(255))
    other = loom.PointCloud(given, colors=np.zeros((8, 3)), label=np.arange(8), crs=25832)
    assert not other.colors.any()
    assert other["label"][7] == 7
    assert other.crs.epsg == 25832
    loom.write_point_cloud(tmp_path / "a.ply", given)
    np.testing.assert_array_equal(loom.read_point_cloud(tmp_path / "a.ply").points, CUBE + UTM)
    assert np.asarray(loom.render(given, size=(32, 24))).any()


@pytest.mark.parametrize("method", ["to_pyvista", "to_meshio", "to_open3d_tensor"])
@pytest.mark.parametrize("shift", [np.zeros(3), UTM])
def test_a_cloud_returns_with_all_it_had(method, shift):
    pytest.importorskip(method.removeprefix("to_").partition("_")[0])
    cloud = full_cloud(shift)
    back = loom.from_any(getattr(cloud, method)())
    np.testing.assert_array_equal(back.points, cloud.points)
    np.testing.assert_array_equal(back.normals, cloud.normals)
    np.testing.assert_array_equal(back.colors, cloud.colors)
    assert back["intensity"].reshape(-1).tolist() == list(range(8))
    if method != "to_open3d_tensor":
        assert (back.crs, back.unit) == (cloud.crs, cloud.unit)


def test_a_trimesh_cloud_names_what_it_cannot_store():
    pytest.importorskip("trimesh")
    with pytest.warns(UserWarning, match="left out: normals, intensity"):
        made = full_cloud().to_trimesh()
    back = loom.from_any(made)
    np.testing.assert_array_equal(back.points, CUBE + UTM)
    assert (back.crs.epsg, back.unit.name) == (25832, "metre")
    np.testing.assert_array_equal(back.colors, full_cloud().colors)


def test_a_legacy_cloud_names_what_it_cannot_store(o3d):
    with pytest.warns(UserWarning, match="left out: intensity"):
        full_cloud().to_open3d()


@pytest.mark.parametrize("method", ["to_trimesh", "to_pyvista", "to_meshio", "to_open3d_tensor"])
@pytest.mark.parametrize("shift", [np.zeros(3), UTM])
def test_a_mesh_returns_with_all_it_had(method, shift):
    pytest.importorskip(method.removeprefix("to_").partition("_")[0])
    mesh = full_mesh(shift)
    back = loom.from_any(getattr(mesh, method)())
    np.testing.assert_array_equal(back.vertices, mesh.vertices)
    np.testing.assert_array_equal(back.triangles, mesh.triangles)
    np.testing.assert_allclose(back.vertex_normals, mesh.vertex_normals, rtol=1e-6)
    np.testing.assert_array_equal(back.vertex_colors, mesh.vertex_colors)
    assert back.vertex_attributes["heat"].reshape(-1).tolist() == list(range(8))
    assert back.triangle_attributes["part"].reshape(-1).tolist() == list(range(12))
    if method != "to_open3d_tensor":
        assert (back.crs, back.unit) == (mesh.crs, mesh.unit)


@pytest.mark.parametrize("method", ["to_trimesh", "to_open3d", "to_open3d_tensor"])
def test_a_texture_returns_with_its_orientation(method):
    pytest.importorskip(method.removeprefix("to_").partition("_")[0])
    uvs = np.random.default_rng(0).random((36, 2)).astype(np.float32)
    mesh = loom.TriangleMesh(CUBE, TRIANGLES, triangle_uvs=uvs, textures=[IMAGE])
    back = loom.from_any(getattr(mesh, method)())
    np.testing.assert_array_equal(back.textures[0], IMAGE)
    np.testing.assert_array_equal(back.triangle_uvs, uvs)
    np.testing.assert_array_equal(back.vertices[back.triangles], mesh.vertices[mesh.triangles])


def test_open3d_reads_a_texture_file_as_we_do(o3d, tmp_path):
    uvs = np.random.default_rng(0).random((36, 2)).astype(np.float32)
    loom.write_triangle_mesh(tmp_path / "m.obj", loom.TriangleMesh(CUBE, TRIANGLES, triangle_uvs=uvs, textures=[IMAGE]))
    expected = loom.read_triangle_mesh(tmp_path / "m.obj")
    for reader in (o3d.io.read_triangle_mesh, o3d.t.io.read_triangle_mesh):
        mesh = loom.from_any(reader(str(tmp_path / "m.obj")))
        np.testing.assert_array_equal(mesh.textures[0], IMAGE)
        assert len(mesh.textures) == 1
        assert mesh.triangle_material_ids is None or not mesh.triangle_material_ids.any()
        order, own = (np.lexsort(np.asarray(m.triangle_uvs).T) for m in (mesh, expected))
        np.testing.assert_allclose(mesh.triangle_uvs[order], expected.triangle_uvs[own], atol=1e-6)


def test_textures_that_a_library_cannot_store_are_named():
    pytest.importorskip("pyvista")
    uvs = np.zeros((36, 2), np.float32)
    mesh = loom.TriangleMesh(CUBE, TRIANGLES, triangle_uvs=uvs, textures=[IMAGE])
    with pytest.warns(UserWarning, match="textures"):
        back = loom.from_any(mesh.to_pyvista())
    np.testing.assert_array_equal(back.triangle_uvs, uvs)


def test_a_scene_of_trimesh_is_one_mesh_with_its_poses():
    trimesh = pytest.importorskip("trimesh")
    scene = trimesh.Scene()
    pose = np.eye(4)
    pose[:3, 3] = 5, 0, 0
    scene.add_geometry(trimesh.creation.box(), transform=pose)
    scene.add_geometry(trimesh.creation.box())
    mesh = loom.from_any(scene)
    assert len(mesh) == 24
    np.testing.assert_allclose(mesh.get_max_bound(), [5.5, 0.5, 0.5])


def test_a_scene_must_contain_meshes_only():
    class Scene:
        geometry = None

        def __init__(self, *parts):
            self.dump = lambda: parts

    box = loom.TriangleMesh.create_box()
    assert len(loom.from_any(Scene(box, box))) == 2 * len(box)
    for parts, count in (((), 0), ((loom.PointCloud(CUBE),), 1), ((box, loom.PointCloud(CUBE)), 1)):
        with pytest.raises(TypeError, match=f"^geometry: expected a scene of meshes, got {count} other parts"):
            loom.from_any(Scene(*parts))


# ------------------------------------------------------------------------------------------------ replacements


class Attributes:
    def __init__(self, **values):
        vars(self).update(values)


def stand_in(name, module="__main__", **values):
    return type(name, (Attributes,), {"__module__": module})(**values)


def test_stand_ins_without_the_packages_are_accepted():
    mesh = stand_in("Trimesh", vertices=CUBE, faces=TRIANGLES, triangles=CUBE[TRIANGLES])
    assert len(loom.TriangleMesh(mesh)) == 12
    legacy = stand_in("PointCloud", "open3d.cuda.pybind.geometry", points=CUBE, colors=BYTES / 255, normals=())
    np.testing.assert_array_equal(loom.PointCloud(legacy).points, CUBE)
    data = stand_in("PolyData", points=CUBE, verts=[], lines=[], faces=[3, 0, 1, 2, 4, 0, 1, 3, 2], point_data={},
                    cell_data={"k": [1, 2]})  # fmt: skip
    made = loom.from_any(data)
    assert made.triangle_attributes["k"].tolist() == [1, 2, 2]


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        (BYTES, BYTES / 255),
        (BYTES.astype(np.uint16) * 257, BYTES / 255),
        (BYTES.astype(np.int64), BYTES / 255),
        (BYTES.astype(np.float64), BYTES / 255),
        (BYTES / 255, BYTES / 255),
        (np.full((8, 3), 1.0000001), np.ones((8, 3))),
    ],
)
def test_colors_of_any_range_are_in_0_to_1(values, expected):
    cloud = loom.PointCloud(stand_in("PointCloud", points=CUBE, colors=values))
    np.testing.assert_allclose(cloud.colors, expected, atol=1e-6)


@pytest.mark.parametrize("values", [np.full((8, 3), -1.0), np.full((8, 3), np.nan), np.full((8, 3), 300)])
def test_colors_of_no_range_are_left_out_with_a_warning(values):
    with pytest.warns(UserWarning, match="left out: colors"):
        cloud = loom.PointCloud(stand_in("PointCloud", points=CUBE, colors=values))
    assert not cloud.has_colors


def test_one_warning_names_all_that_is_left_out():
    data = stand_in(
        "PolyData", points=CUBE, verts=[], lines=[2, 0, 1], faces=[3, 0, 1, 2], cell_data={},
        point_data={"names": np.array(["a"] * 8), "phase": np.ones(8, complex), "short": np.ones(3)},
        field_data={"author": ["x"]},
    )  # fmt: skip
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        loom.from_any(data)
    (message,) = [str(each.message) for each in caught]
    assert caught[0].filename == __file__
    for name in ("1 lines", "names", "phase", "short", "metadata 'author'"):
        assert name in message


def test_transparency_is_an_attribute_unless_opaque():
    rgba = np.column_stack([BYTES, np.full(8, 255, np.uint8)])
    assert list(loom.PointCloud(stand_in("PointCloud", points=CUBE, colors=rgba)).attributes) == []
    rgba[0, 3] = 7
    assert loom.PointCloud(stand_in("PointCloud", points=CUBE, colors=rgba))["alpha"].tolist() == [7] + [255] * 7


@pytest.mark.parametrize(
    ("given", "call", "words"),
    [
        (stand_in("Trimesh", vertices=CUBE, faces=TRIANGLES), loom.PointCloud, ("12 faces", "loom.TriangleMesh")),
        (stand_in("PointCloud", points=CUBE, colors=()), loom.TriangleMesh, ("loom.PointCloud",)),
        (stand_in("Hull", vertices=CUBE, faces=TRIANGLES), loom.from_any, ("loom.TriangleMesh(x.vertices, x.faces)",)),
        (stand_in("Hull", vertices=CUBE, faces=TRIANGLES), loom.PointCloud, ("loom.TriangleMesh",)),
        (stand_in("Cloud", points=CUBE), loom.PointCloud, ("loom.PointCloud(x.points)",)),
        (stand_in("Grid", points=CUBE, extract_surface=len), loom.from_any, ("x.extract_surface()",)),
        (stand_in("Grid", points=CUBE, extract_surface=len), loom.TriangleMesh, ("x.extract_surface()",)),
        (BOX, loom.PointCloud, ("loom.PointCloud(x.vertices)", "x.sample_points_uniformly(")),
        (BOX, loom.PointCloud.from_open3d, ("loom.PointCloud(x.vertices)",)),
        (BOX, loom.PointCloud(CUBE).__add__, ("loom.PointCloud(mesh.vertices)",)),
        (BOX, loom.PointCloud(CUBE).__radd__, ("loom.PointCloud(mesh.vertices)",)),
        (BOX, loom.NearestNeighborSearch, ("mesh.vertices",)),
        (POINTS, loom.TriangleMesh, ("loom.meshing.create_surface(x)", "loom.TriangleMesh(x.points, triangles)")),
        (POINTS, lambda x: loom.TriangleMesh(x, TRIANGLES), ("loom.TriangleMesh(x.points, triangles)",)),
        (POINTS, lambda x: setattr(loom.TriangleMesh(CUBE), "vertices", x), ("x.points",)),
        (POINTS, lambda x: loom.RaycastingScene().add_triangles(x, TRIANGLES), ("x.points",)),
        (POINTS, lambda x: loom.VoxelGrid.create_from_triangle_mesh(x, 0.1), ("create_surface(x)",)),
        (POINTS, loom.LineSet.create_from_triangle_mesh, ("create_surface(x)",)),
        (POINTS, loom.TriangleMesh.from_open3d, ("create_surface(x)",)),
        (loom.LineSet(CUBE, [[0, 1]]), loom.TriangleMesh, ("create_surface(loom.PointCloud(x.points))",)),
        (loom.PointCloud(CUBE).compute_convex_hull()[0], loom.PointCloud, ("loom.PointCloud(x.vertices)",)),
    ],
)
def test_errors_name_the_conversion(given, call, words):
    with pytest.raises(TypeError) as error:
        call(given)
    assert all(word in str(error.value) for word in words), str(error.value)
    assert "expected real numbers" not in str(error.value) or call is loom.NearestNeighborSearch


@pytest.mark.parametrize("suffix", [".ply", ".xyz", ".las", ".vtk", ".vtp"])
def test_the_file_of_a_cloud_read_as_a_mesh_names_the_conversion(suffix, tmp_path):
    loom.write_point_cloud(tmp_path / f"cloud{suffix}", POINTS)
    with pytest.raises(loom.FileError, match=r"read_point_cloud\. loom\.meshing\.create_surface"):
        loom.read_triangle_mesh(tmp_path / f"cloud{suffix}")


def poly_data(faces, **arrays):
    return stand_in("PolyData", points=CUBE, faces=faces, point_data={}, cell_data={}, **arrays)


TETRAHEDRON = stand_in("CellBlock", type="tetra", data=[[0, 1, 2, 3]])


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (stand_in("Trimesh", vertices=CUBE, faces=TRIANGLES + 1), "vertices: a face of Trimesh refers to point 8"),
        (stand_in("Trimesh", vertices=CUBE, faces=-TRIANGLES), "vertices: a face of Trimesh refers to point -7"),
        (poly_data([2, 0, 1]), "vertices: a face of PolyData has 2 corners"),
        (poly_data([], lines=[2, 0, 1]), "PolyData: it has lines only"),
        (poly_data([], strips=[4, 0, 1, 2, 3]), "PolyData: triangle strips are not supported"),
        (poly_data([9, 0, 1]), "faces: expected the length of each face before its corners, got 9"),
        (poly_data([3, 0, 1, 2, -1, 4]), "faces: expected the length of each face before its corners, got -1"),
        (poly_data([-1, 0, 1]), "faces: expected the length of each face before its corners, got -1"),
        (stand_in("Mesh", points=CUBE, cells=[TETRAHEDRON], point_data={}), "Mesh: it has tetra cells only"),
        (stand_in("PointCloud", points=CUBE[:, :2], colors=()), r"points: expected shape \[n, 3\], got \[8, 2\]"),
    ],
)
def test_objects_that_do_not_fit_together_are_errors(given, message):
    with pytest.raises(ValueError, match=f"^{message}"):
        loom.from_any(given)


def test_objects_of_pointloom_and_arrays_are_no_others():
    assert read_other(full_cloud()) is None
    assert read_other(full_mesh()) is None
    assert loom.from_any(cloud := full_cloud()) is cloud
    assert loom.from_any(CUBE).points.tolist() == CUBE.tolist()
    assert isinstance(read_other(stand_in("PointCloud", points=CUBE, colors=())), OtherGeometry)
    for wrong, error in ((None, TypeError), (3, ValueError), ("mesh.ply", TypeError), (loom.PointCloud, TypeError)):
        with pytest.raises(error, match=r"^points: expected"):
            loom.from_any(wrong)


def test_objects_of_the_open3d_names_are_accepted():
    from pointloom import open3d as o3d

    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(CUBE + UTM))
    np.testing.assert_array_equal(loom.PointCloud(cloud).points, CUBE + UTM)
    mesh = o3d.geometry.TriangleMesh(o3d.utility.Vector3dVector(CUBE), o3d.utility.Vector3iVector(TRIANGLES))
    assert len(loom.from_any(mesh)) == 12
