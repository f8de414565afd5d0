"""TriangleMesh: Open3D's normals, areas, volumes and manifold tests; exact far from zero; no in-place changes."""

import ast
import inspect
import itertools
import pickle

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom import TriangleMesh
from pointloom.meshing import marching_cubes

from .open3d_meshes import arrays_of, for_each, in_open3d, one_by_one

TETRAHEDRON = ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
FAR = np.array([5.0e5, 5.4e6, 100.0])


def rough_ball(device=None, *, noise=0.02, samples=24) -> TriangleMesh:
    rng = np.random.default_rng(0)
    x = np.linspace(-1, 1, samples)
    x, y, z = np.meshgrid(x, x, x, indexing="ij")
    field = np.sqrt(x * x + y * y + z * z) - 0.7 + noise * rng.normal(size=x.shape)
    return marching_cubes(field, spacing=[2 / (samples - 1)] * 3, origin=[-1, -1, -1], device=device)


def colored(device=None) -> TriangleMesh:
    mesh = rough_ball(device).compute_vertex_normals()
    mesh.vertex_colors = np.random.default_rng(1).random((len(mesh.vertices), 3))
    return mesh


def open3d_measures(o3d, mesh):
    peer = in_open3d(o3d, mesh)
    normals = arrays_of(peer.compute_vertex_normals(), "vertex_normals", "triangle_normals")
    box = peer.get_axis_aligned_bounding_box()
    sizes = peer.get_surface_area(), peer.get_volume(), np.array(box.min_bound), np.array(box.max_bound)
    return *(values.astype(np.float32) for values in normals), *sizes


def test_normals_area_volume_and_box_match_open3d(device, oracle):
    mesh = rough_ball(device, noise=0.004, samples=12)  # in rougher ones Open3D finds triangles that touch
    at_vertices, of_triangles, area, volume, low, high = oracle("meshing/mesh/measures", open3d_measures, mesh)
    normals = mesh.compute_vertex_normals().vertex_normals
    np.testing.assert_allclose(normals, at_vertices, atol=2e-7)  # rounding to float32
    np.testing.assert_allclose(mesh.compute_triangle_normals(), of_triangles, atol=2e-7)
    assert mesh.get_surface_area() == pytest.approx(area, rel=1e-12)
    assert mesh.get_volume() == pytest.approx(volume, rel=1e-12)
    np.testing.assert_array_equal([*mesh.get_axis_aligned_bounding_box()], [low, high])


AT_A_VERTEX = [*TETRAHEDRON[0], [-1, 0, 0], [0, -1, 0], [0, 0, -1]]
AT_AN_EDGE = [*TETRAHEDRON[0], [-1, 0, 0.5], [0, -1, 0.5]]
FAN = [[0, 0, 0], [0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, -1, 0]]
MESHES = {
    "nothing": ([], []),
    "lone vertices": ([[0, 0, 0], [1, 0, 0]], []),
    "one triangle": ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]),
    "tetrahedron": TETRAHEDRON,
    "tetrahedron without a side": (TETRAHEDRON[0], TETRAHEDRON[1][:3]),
    "three triangles at an edge": (FAN, [[0, 1, 2], [0, 1, 3], [1, 0, 4]]),
    "two tetrahedra at a vertex": (AT_A_VERTEX, [*TETRAHEDRON[1], [0, 4, 5], [0, 6, 4], [0, 5, 6], [4, 6, 5]]),
    "two tetrahedra at an edge": (AT_AN_EDGE, [*TETRAHEDRON[1], [0, 3, 4], [0, 5, 3], [0, 4, 5], [3, 5, 4]]),
    "two triangles at a vertex": ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]], [[0, 1, 2], [0, 3, 4]]),
}


def open3d_manifolds(o3d, mesh):
    """Open3D's watertight meshes also have one fan at each vertex."""
    peer = in_open3d(o3d, mesh)
    edges = [peer.is_edge_manifold(), peer.is_edge_manifold(allow_boundary_edges=False), peer.is_vertex_manifold()]
    return [np.array([*edges, peer.is_watertight()])]


def test_manifold_tests_agree_with_open3d(device, oracle):
    rng = np.random.default_rng(0)
    triples = np.array(list(itertools.combinations(range(5), 3)))
    soups = [rng.permuted(rng.permutation(triples)[:count], axis=1) for count in rng.integers(0, 10, 40)]
    meshes = [TriangleMesh(*given, device=device) for given in MESHES.values()]
    meshes += [TriangleMesh(rng.random((5, 3)), triangles, device=device) for triangles in soups]
    answers = oracle("meshing/mesh/manifolds", for_each, open3d_manifolds, [(mesh,) for mesh in meshes])
    for mesh, ((edges, closed, vertices, watertight),) in zip(meshes, one_by_one(answers), strict=True):
        assert (mesh.is_edge_manifold(), mesh.is_edge_manifold(False)) == (edges, closed)
        assert mesh.is_watertight() == (closed and len(mesh) > 0)
        assert (mesh.is_watertight() and mesh.is_vertex_manifold()) == (watertight and len(mesh) > 0)
        assert mesh.is_vertex_manifold() == vertices


def test_vertices_without_area_point_up_and_non_finite_ones_have_no_normal(device):
    vertices = [[0, 0, 0], [0, 1, 0], [0, 0, 1], [5, 5, 5], [1, 1, 1], [np.nan, 0, 0]]
    mesh = TriangleMesh(vertices, [[0, 1, 2], [3, 3, 3], [0, 1, 5]], device=device).compute_vertex_normals()
    np.testing.assert_array_equal(mesh.vertex_normals[:5], [[1, 0, 0]] * 3 + [[0, 0, 1]] * 2)
    assert np.isnan(mesh.vertex_normals[5]).all()
    np.testing.assert_array_equal(mesh.compute_triangle_normals(), [[1, 0, 0], [0, 0, 1], [np.nan] * 3])
    np.testing.assert_array_equal([*mesh.get_axis_aligned_bounding_box()], [[0, 0, 0], [5, 5, 5]])


def test_all_operations_accept_an_empty_mesh(device):
    mesh = TriangleMesh(device=device)
    assert (len(mesh), mesh.vertices.shape, mesh.triangles.shape) == (0, (0, 3), (0, 3))
    assert mesh.compute_vertex_normals().vertex_normals.shape == (0, 3)
    assert mesh.compute_triangle_normals().shape == (0, 3)
    assert (mesh.get_surface_area(), mesh.get_volume()) == (0.0, 0.0)
    assert len(mesh.transform(np.eye(4)).remove_unreferenced_vertices()) == 0
    np.testing.assert_array_equal([*mesh.get_axis_aligned_bounding_box()], np.zeros((2, 3)))


@pytest.mark.parametrize(("shift", "mirror"), [((0, 0, 0), 1), (tuple(FAR), -1)])
def test_normals_rotate_with_the_mesh_for_any_matrix(device, shift, mirror):
    T = np.eye(4)
    T[:3, :3] = Rotation.from_rotvec([0.3, -0.8, 0.5]).as_matrix() @ np.diag([mirror, 2.0, 0.5])
    T[:3, 3] = shift
    mesh = rough_ball(device).compute_vertex_normals()
    moved = mesh.transform(T)
    np.testing.assert_allclose(moved.vertices, mesh.vertices @ T[:3, :3].T + T[:3, 3], atol=3e-7)
    face = mesh.compute_triangle_normals() @ np.linalg.inv(T[:3, :3])
    face /= np.linalg.norm(face, axis=1, keepdims=True)
    alignment = np.einsum("ij,ij->i", moved.compute_triangle_normals(), face)
    assert np.median(alignment) > 0.9999 and alignment.min() > 0  # slivers of the ball rotate a little
    expected = mesh.vertex_normals @ np.linalg.inv(T[:3, :3])
    expected /= np.linalg.norm(expected, axis=1, keepdims=True)
    np.testing.assert_allclose(moved.vertex_normals, expected, atol=1e-6)
    assert moved.get_volume() == pytest.approx(mesh.get_volume(), rel=1e-5)


ROTATION = Rotation.from_rotvec([0.3, -0.8, 0.5]).as_matrix()


@pytest.mark.parametrize("shift", [np.zeros(3), FAR])
def test_meshes_are_moved_rotated_and_scaled_about_a_center(device, shift):
    mesh = TriangleMesh(*MESHES["two tetrahedra at a vertex"], device=device).translate(shift)
    vertices, center, other = mesh.vertices, mesh.vertices.mean(axis=0), np.array([1, 2, 3])
    np.testing.assert_allclose(mesh.get_center(), center, rtol=1e-12, atol=1e-7)
    for result, expected in (
        (mesh.rotate(ROTATION), (vertices - center) @ ROTATION.T + center),
        (mesh.rotate(ROTATION, other), (vertices - other) @ ROTATION.T + other),
        (mesh.scale(2.5), 2.5 * (vertices - center) + center),
        (mesh.translate(other), vertices + other),
        (mesh.translate(other, relative=False), vertices - center + other),
    ):
        np.testing.assert_allclose(result.vertices, expected, atol=2e-6, rtol=2e-7)


def test_vertices_and_origin_are_converted_to_another_unit(device):
    mesh = TriangleMesh(*MESHES["two tetrahedra at a vertex"], device=device).translate(FAR)
    mesh.unit = "foot"
    meters = mesh.to_unit("metre")
    assert meters.unit == "metre" and np.array_equal(meters.origin, mesh.origin * 0.3048)
    np.testing.assert_allclose(meters.vertices - meters.origin, (mesh.vertices - mesh.origin) * 0.3048, rtol=1e-6)


def test_a_painted_mesh_has_one_color_and_the_original_is_unchanged(device):
    mesh = rough_ball(device)
    painted = mesh.paint_uniform_color([1, 0.5, 0.25])
    assert (painted.vertex_colors == [1, 0.5, 0.25]).all() and len(painted.vertex_colors) == len(mesh.vertices)


def test_unreferenced_vertices_are_removed_and_the_rest_is_unchanged(device):
    mesh = colored(device)
    selected = mesh.triangles[::7]
    options = {"vertex_normals": mesh.vertex_normals, "vertex_colors": mesh.vertex_colors, "device": device}
    cut = TriangleMesh(mesh.vertices, selected, **options)
    clean = cut.remove_unreferenced_vertices()
    used = np.unique(selected)
    for name in ("vertices", "vertex_colors", "vertex_normals"):
        np.testing.assert_array_equal(getattr(clean, name), getattr(mesh, name)[used])
    np.testing.assert_array_equal(used[clean.triangles], selected)


def test_operations_return_new_meshes_that_share_unchanged_arrays(device):
    mesh = rough_ball(device)
    with_normals = mesh.compute_vertex_normals()
    assert mesh.vertex_normals is None and with_normals.arrays["vertices"] is mesh.arrays["vertices"]
    assert with_normals.arrays["triangles"] is mesh.arrays["triangles"] and mesh.to(device) is mesh


def test_arrays_are_read_only_copies(device):
    mesh = colored(device)
    for name in ("vertices", "triangles", "vertex_normals", "vertex_colors", "origin"):
        with pytest.raises(ValueError, match="read-only"):
            getattr(mesh, name)[:] = 7
        getattr(mesh, name).copy()[:] = 7


def test_far_vertices_move_the_origin_but_a_given_origin_stays(device):
    vertices = np.array(TETRAHEDRON[0]) + FAR
    mesh = TriangleMesh(vertices, TETRAHEDRON[1], device=device)
    assert np.abs(mesh.origin - FAR).max() <= 1 and np.abs(mesh.arrays["vertices"].numpy()).max() <= 1
    given = TriangleMesh(vertices, TETRAHEDRON[1], origin=FAR - 2, device=device)
    np.testing.assert_array_equal(given.origin, FAR - 2)
    np.testing.assert_array_equal(given.vertices, vertices)


def test_a_missing_array_and_a_flat_matrix_are_rejected():
    mesh = TriangleMesh(*TETRAHEDRON)
    with pytest.raises(KeyError, match="vertex_normals: "):
        mesh.array("vertex_normals")
    with pytest.raises(ValueError, match="transformation: "):
        mesh.transform(np.diag([1.0, 1.0, 0.0, 1.0]))
    for name, rows in (("vertex_colors", 1), ("vertex_normals", 5)):
        with pytest.raises(ValueError, match=rf"{name}:"):
            setattr(mesh, name, np.ones((rows, 3)))


QUARTER = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])  # takes y to z
Y, Z = (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


@pytest.fixture
def cone(device):
    mesh = loom.TriangleMesh.create_cone(0.5, 4.0).rotate(QUARTER.T, (0, 0, 0)).to(device)
    mesh.up = "y"
    return mesh


@pytest.mark.parametrize(("name", "up", "expected"), [("a.glb", "y", Y), ("a.gltf", "z", Z), ("a.ply", "y", None)])
def test_gltf_files_define_the_up_axis(tmp_path, name, up, expected):
    loom.write_triangle_mesh(tmp_path / name, loom.TriangleMesh.create_box())
    assert loom.read_triangle_mesh(tmp_path / name, up=up).up == expected


@pytest.mark.parametrize("name", ["a.glb", "a.gltf"])
@pytest.mark.parametrize("up", ["x", "y", "z", (-1, 0, 0), (0, -1, 0), (0, 0, -1), (0.2, -0.6, 0.5)])
def test_meshes_of_any_up_direction_are_upright_in_gltf_and_read_as_before(cone, tmp_path, name, up):
    placed = cone.translate((10.0, 0.0, 0.0))
    given = placed.vertices - placed.vertices.mean(axis=0)
    placed.up = up
    path, height = tmp_path / name, given @ np.asarray(placed.up)
    loom.write_triangle_mesh(path, placed)
    stored = loom.read_triangle_mesh(path, up="y")
    np.testing.assert_allclose(stored.vertices[:, 1] - stored.vertices[:, 1].mean(), height, atol=1e-5)
    assert stored.up == Y
    same = loom.read_triangle_mesh(path)
    np.testing.assert_allclose(same.vertices, placed.vertices, atol=1e-5)
    np.testing.assert_allclose(same.up, placed.up, atol=1e-12)
    if np.count_nonzero(placed.up) == 1:
        np.testing.assert_array_equal(same.vertices, placed.vertices)
    trimesh = pytest.importorskip("trimesh")
    seen = trimesh.load(path, force="mesh", process=False).vertices
    np.testing.assert_allclose(seen[:, 1] - seen[:, 1].mean(), height, atol=1e-5)


def test_meshes_of_a_map_have_z_up_in_gltf_and_others_are_stored_as_given(tmp_path):
    mesh = loom.TriangleMesh.create_cone(0.5, 4.0)
    path = tmp_path / "a.glb"
    loom.write_triangle_mesh(path, mesh)
    np.testing.assert_array_equal(loom.read_triangle_mesh(path).vertices, mesh.vertices)
    mesh.crs = "EPSG:25832"
    with pytest.warns(UserWarning, match="coordinate system"):
        loom.write_triangle_mesh(path, mesh)
    np.testing.assert_array_equal(loom.read_triangle_mesh(path, up="y").vertices[:, 1], mesh.vertices[:, 2])
    again = loom.read_triangle_mesh(path)
    np.testing.assert_array_equal(again.vertices, mesh.vertices)
    assert again.up == Z


@pytest.mark.parametrize("extras", ['"up"', '{"pointloom_up": "z"}', '{"pointloom_up": [0, 0]}', '{"pointloom_up": 0}'])
def test_damaged_records_of_the_up_axis_are_ignored(tmp_path, extras):
    path = tmp_path / "a.gltf"
    loom.write_triangle_mesh(path, loom.TriangleMesh.create_box())
    text = (
        path.read_text()
        .replace('"asset": {', '"asset": {"extras": ' + extras + ", ")
        .replace('"asset":{', '"asset":{"extras":' + extras + ",")
    )
    assert "extras" in text
    path.write_text(text)
    assert loom.read_triangle_mesh(path).up == Y


def test_up_axis_follows_rotations_of_the_mesh(cone):
    assert cone.translate((1, 2, 3)).compute_vertex_normals().paint_uniform_color((1, 0, 0)).up == Y
    assert cone.rotate(QUARTER, (0, 0, 0)).up == Z and cone.scale(3.0, (0, 0, 0)).up == Y
    assert pickle.loads(pickle.dumps(cone)).up == Y
    assert loom.TriangleMesh.create_box().translate((1, 0, 0)).up is None


def test_images_are_upright(cone):
    same = loom.render(cone, None, (120, 120), up="y")
    assert np.array_equal(loom.render(cone, None, (120, 120)), same)
    assert not np.array_equal(loom.render(cone, None, (120, 120), up="z"), same)
    rotation = np.eye(4)
    rotation[:3, :3] = QUARTER
    posed = loom.render({"geometry": cone, "pose": rotation}, None, (120, 120))
    rows, columns = np.nonzero((posed != 255).any(axis=2))
    assert np.ptp(rows) > 2 * np.ptp(columns)


@pytest.mark.parametrize("kind", TriangleMesh.__mro__[:4], ids=lambda kind: kind.__name__)
def test_the_public_methods_are_docstrings_and_calls_of_functions_of_their_topics(kind):
    source = ast.parse(inspect.getsource(inspect.getmodule(kind)))
    [body] = [node.body for node in source.body if isinstance(node, ast.ClassDef)]
    methods = [node for node in body if isinstance(node, ast.FunctionDef) and not node.name.startswith("__")]
    statements = {each.name: sum(not is_text(node) for node in each.body) for each in methods}
    assert len(statements) > 15 and {name for name, count in statements.items() if count > 1} == set()


def is_text(node):
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
