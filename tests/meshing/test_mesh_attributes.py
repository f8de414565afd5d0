"""Vertex and triangle attributes follow all mesh operations with unchanged types."""

import copy
import pickle
import warnings

import numpy as np
import pytest

from pointloom import AxisAlignedBoundingBox, TriangleMesh, read_triangle_mesh, write_triangle_mesh


def labeled(device=None, mesh: TriangleMesh | None = None) -> TriangleMesh:
    """A mesh whose attributes encode each vertex position and triangle number."""
    mesh = TriangleMesh.create_sphere(1.0, 6, device=device) if mesh is None else mesh
    mesh.vertex_attributes["place"] = mesh.vertices
    mesh.vertex_attributes["number"] = np.arange(len(mesh.vertices), dtype=np.uint16)
    mesh.triangle_attributes["row"] = np.arange(len(mesh))
    mesh.triangle_attributes["middle"] = mesh.vertices[mesh.triangles].mean(axis=1).astype(np.float32)
    mesh.triangle_attributes["even"] = np.arange(len(mesh)) % 2 == 0
    return mesh


def attributes_of(mesh: TriangleMesh) -> dict[str, tuple[str, list[int]]]:
    both = dict(mesh.vertex_attributes) | dict(mesh.triangle_attributes)
    return {name: (str(values.dtype), list(values.shape[1:])) for name, values in both.items()}


KINDS = {"place": ("float64", [3]), "number": ("uint16", []), "row": ("int64", []), "middle": ("float32", [3])} | {
    "even": ("bool", [])
}


def test_values_keep_their_types_and_shapes(device):
    mesh = labeled(device)
    assert attributes_of(mesh) == KINDS
    names = "vertex_attributes[place, number], triangle_attributes[row, middle, even]"
    assert repr(mesh).endswith(f"{names}, {mesh.device})")
    np.testing.assert_array_equal(mesh.vertex_attributes["place"], mesh.vertices)
    assert mesh.vertex_attributes.array("number").device == mesh.device
    with pytest.raises(ValueError, match="read-only"):
        mesh.vertex_attributes["place"][0] = 0


def test_copies_have_independent_attributes(device):
    mesh = labeled(device)
    other = mesh.copy()
    del other.vertex_attributes["place"]
    other.triangle_attributes["row"] = np.zeros(len(mesh))
    assert attributes_of(mesh) == KINDS and list(other.vertex_attributes) == ["number"]
    for same in (pickle.loads(pickle.dumps(mesh)), copy.deepcopy(mesh), mesh.to(device)):
        assert attributes_of(same) == KINDS
        np.testing.assert_array_equal(same.triangle_attributes["row"], mesh.triangle_attributes["row"])


def test_the_constructor_accepts_attributes():
    options = {"vertex_attributes": {"a": [1, 2, 3]}, "triangle_attributes": {"b": np.array([[0.5, 1]])}}
    mesh = TriangleMesh(np.eye(3), [[0, 1, 2]], **options)
    assert mesh.vertex_attributes["a"].tolist() == [1, 2, 3] and mesh.triangle_attributes["b"].tolist() == [[0.5, 1]]


CHANGES = {
    "select": lambda m: m.select_by_index(np.arange(len(m.vertices))[::-2]),
    "crop": lambda m: m.crop(AxisAlignedBoundingBox([-2, -2, -2], [2, 2, 0.5])),
    "remove vertices": lambda m: m.remove_vertices_by_mask(m.vertices[:, 2] > 0.5),
    "remove triangles": lambda m: m.remove_triangles_by_index([0, 5, 7]).remove_unreferenced_vertices(),
    "weld": lambda m: m.remove_duplicated_vertices().merge_close_vertices(1e-3),
    "clean": lambda m: m.remove_degenerate_triangles(zero_area=True).remove_duplicated_triangles(),
    "parts": lambda m: m.remove_small_components(min_triangles=2),
    "fill": lambda m: m.remove_triangles_by_index([40]).repair()[0],
}


@pytest.mark.parametrize("name", CHANGES)
def test_remaining_elements_keep_their_attributes(device, name):
    changed = CHANGES[name](labeled(device))
    assert attributes_of(changed) == KINDS
    np.testing.assert_array_equal(changed.vertex_attributes["place"], changed.vertices)
    middles = changed.vertices[changed.triangles].mean(axis=1)
    np.testing.assert_allclose(changed.triangle_attributes["middle"], middles, atol=1e-6)


@pytest.mark.parametrize("name", ["midpoint", "trim"])
def test_new_vertices_have_interpolated_values(device, name):
    mesh = labeled(device)
    changed = mesh.subdivide_midpoint(2) if name == "midpoint" else mesh.trim(mesh.vertices @ [0.3, 0.2, 0.9], 0.1)
    assert attributes_of(changed) == KINDS and len(changed.vertices) > 6
    np.testing.assert_allclose(changed.vertex_attributes["place"], changed.vertices, atol=1e-6)
    near = mesh.vertices[changed.vertex_attributes["number"].astype(int)]
    assert np.linalg.norm(near - changed.vertices, axis=1).max() < 0.6  # an integer is copied from a neighbor
    corners = mesh.vertices[mesh.triangles[changed.triangle_attributes["row"]]]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    off = np.einsum("tc,tkc->tk", normals, changed.vertices[changed.triangles] - corners[:, :1])
    assert abs(off).max() < 1e-6  # a part of a triangle lies in it


def test_an_unused_row_gives_no_nan():
    mesh = TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [2, 1, 3]])
    mesh.vertex_attributes["a"] = [1.0, 2.0, 3.0, np.nan]
    values = mesh.subdivide_midpoint().vertex_attributes["a"]
    assert np.isnan(values).sum() == 3 and values[:3].tolist() == [1, 2, 3]


@pytest.mark.parametrize("name", ["decimation", "clustering"])
def test_simplified_triangles_take_values_at_their_position(name):
    mesh = labeled(mesh=TriangleMesh.create_sphere(1.0, 20))
    changed = mesh.simplify_quadric_decimation(300) if name == "decimation" else mesh.simplify_vertex_clustering(0.2)
    assert attributes_of(changed) == KINDS
    np.testing.assert_allclose(changed.vertex_attributes["place"], changed.vertices, atol=0.02)
    middles = changed.vertices[changed.triangles].mean(axis=1)
    assert np.linalg.norm(changed.triangle_attributes["middle"] - middles, axis=1).max() < 0.15


def test_operations_that_drop_attributes_warn():
    mesh, box = labeled(), TriangleMesh.create_box()
    with pytest.warns(UserWarning, match="vertex_attributes place, number:"):
        arrays = {name: box.array(name) for name in ("vertices", "triangles")}
        bare = mesh._with_arrays(**arrays, triangle_attributes=None)
    assert not bare.vertex_attributes and not bare.triangle_attributes


@pytest.mark.parametrize("as_text", [False, True])
def test_ply_stores_vertex_attributes(tmp_path, as_text):
    mesh = TriangleMesh.create_box()
    mesh.vertex_attributes["quality"] = np.linspace(0, 1, 8)
    mesh.vertex_attributes["label"] = np.arange(8, dtype=np.int32)
    write_triangle_mesh(tmp_path / "m.ply", mesh, ascii=as_text)
    back = read_triangle_mesh(tmp_path / "m.ply")
    for name, values in mesh.vertex_attributes.items():
        np.testing.assert_array_equal(back.vertex_attributes[name], values)
        assert back.vertex_attributes[name].dtype == values.dtype


@pytest.mark.parametrize("suffix", [".obj", ".stl"])
def test_formats_without_attributes_warn(tmp_path, suffix):
    path = tmp_path / f"m{suffix}"
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        write_triangle_mesh(path, labeled())
    messages = " ".join(str(warning.message) for warning in caught)
    assert all(name in messages for name in ("place", "number", "row", "middle", "even")) and "left out" in messages
    assert not read_triangle_mesh(path).vertex_attributes
