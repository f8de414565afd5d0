"""TriangleMesh: Open3D's normals, areas, volumes and manifold tests; exact far from zero; nothing changed in place."""

from __future__ import annotations

import copy

import numpy as np
import pytest
import warp as wp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from pointloom import TriangleMesh, marching_cubes, read_triangle_mesh, write_triangle_mesh
from pointloom.core.errors import DeviceError, FileError

TETRAHEDRON = ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
FAR = np.array([5.0e5, 5.4e6, 100.0])


def rough_ball(device=None, *, noise=0.02) -> TriangleMesh:
    rng = np.random.default_rng(0)
    x = np.linspace(-1, 1, 24)
    x, y, z = np.meshgrid(x, x, x, indexing="ij")
    field = np.sqrt(x * x + y * y + z * z) - 0.7 + noise * rng.normal(size=x.shape)
    return marching_cubes(field, spacing=[2 / 23] * 3, origin=[-1, -1, -1], device=device)


def in_open3d(mesh: TriangleMesh):
    o3d = pytest.importorskip("open3d", exc_type=ImportError)
    geometry, vector = o3d.geometry, o3d.utility
    vertices, triangles = mesh.vertices.copy(), mesh.triangles.copy()  # Open3D refuses arrays that are read-only
    return geometry.TriangleMesh(vector.Vector3dVector(vertices), vector.Vector3iVector(triangles))


def colored(device=None) -> TriangleMesh:
    mesh = rough_ball(device).compute_vertex_normals()
    mesh.vertex_colors = np.random.default_rng(1).random((len(mesh.vertices), 3))
    return mesh


# ------------------------------------------------------------------------------------------------ conformance


def test_vertex_normals_are_those_of_open3d(device):
    mesh = rough_ball(device)
    peer = in_open3d(mesh).compute_vertex_normals()
    normals = mesh.compute_vertex_normals().vertex_normals
    np.testing.assert_allclose(normals, np.asarray(peer.vertex_normals), atol=2e-7)  # rounding to float32


def test_triangle_normals_are_those_of_open3d(device):
    mesh = rough_ball(device)
    peer = in_open3d(mesh).compute_triangle_normals()
    np.testing.assert_allclose(mesh.compute_triangle_normals(), np.asarray(peer.triangle_normals), atol=2e-7)


def test_area_volume_and_box_are_those_of_open3d(device):
    mesh = rough_ball(device, noise=0.004)  # Open3D finds a pair of triangles that touch in the rougher one
    peer = in_open3d(mesh)
    assert mesh.get_surface_area() == pytest.approx(peer.get_surface_area(), rel=1e-12)
    assert mesh.get_volume() == pytest.approx(peer.get_volume(), rel=1e-12)
    low, high = mesh.get_axis_aligned_bounding_box()
    box = peer.get_axis_aligned_bounding_box()
    np.testing.assert_array_equal((low, high), (box.min_bound, box.max_bound))


MESHES = {
    "nothing": ([], []),
    "lone vertices": ([[0, 0, 0], [1, 0, 0]], []),
    "one triangle": ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]),
    "tetrahedron": TETRAHEDRON,
    "tetrahedron without a side": (TETRAHEDRON[0], TETRAHEDRON[1][:3]),
    "three triangles at an edge": (
        [[0, 0, 0], [0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, -1, 0]],
        [[0, 1, 2], [0, 1, 3], [1, 0, 4]],
    ),
    "two tetrahedra at a vertex": (
        [*TETRAHEDRON[0], [-1, 0, 0], [0, -1, 0], [0, 0, -1]],
        [*TETRAHEDRON[1], [0, 4, 5], [0, 6, 4], [0, 5, 6], [4, 6, 5]],
    ),
    "two tetrahedra at an edge": (
        [*TETRAHEDRON[0], [-1, 0, 0.5], [0, -1, 0.5]],
        [*TETRAHEDRON[1], [0, 3, 4], [0, 5, 3], [0, 4, 5], [3, 5, 4]],
    ),
    "two triangles at a vertex": ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]], [[0, 1, 2], [0, 3, 4]]),
}


@pytest.mark.parametrize("name", MESHES)
def test_manifold_tests_agree_with_open3d(device, name):
    mesh = TriangleMesh(*MESHES[name], device=device)
    peer = in_open3d(mesh)
    assert mesh.is_edge_manifold() == peer.is_edge_manifold()
    assert mesh.is_edge_manifold(allow_boundary_edges=False) == peer.is_edge_manifold(allow_boundary_edges=False)
    # Open3D asks for one fan at each vertex, too
    assert (mesh.is_watertight() and mesh.is_vertex_manifold()) == (peer.is_watertight() and len(mesh) > 0)


def test_parts_that_touch_at_a_vertex_are_closed_and_have_a_volume(device):
    mesh = TriangleMesh(*MESHES["two tetrahedra at a vertex"], device=device)
    assert mesh.is_watertight() and mesh.get_volume() == pytest.approx(1 / 3)
    assert not TriangleMesh(*MESHES["two tetrahedra at an edge"], device=device).is_watertight()


def test_a_mesh_without_triangles_is_not_watertight(device):
    assert not TriangleMesh(device=device).is_watertight()
    assert not TriangleMesh([[0, 0, 0], [1, 0, 0]], device=device).is_watertight()


TRIPLES = st.permutations(range(5)).map(lambda p: p[:3])


@settings(deadline=None, max_examples=60)
@given(triangles=st.lists(TRIPLES, max_size=9, unique_by=lambda t: tuple(sorted(t))))
def test_manifold_tests_agree_with_open3d_on_random_triangles(triangles):
    mesh = TriangleMesh(np.random.default_rng(0).random((5, 3)), triangles)
    peer = in_open3d(mesh)
    assert mesh.is_edge_manifold() == peer.is_edge_manifold()
    assert mesh.is_edge_manifold(False) == peer.is_edge_manifold(False)
    assert mesh.is_watertight() == (peer.is_edge_manifold(False) and len(triangles) > 0)
    assert mesh.is_vertex_manifold() == peer.is_vertex_manifold()


# ------------------------------------------------------------------------------------------------ operations


def test_normals_have_the_same_bits_in_two_runs(device):
    mesh = rough_ball(device)
    first, second = (mesh.compute_vertex_normals().vertex_normals for _ in range(2))
    assert first.tobytes() == second.tobytes()


def test_normals_of_a_vertex_in_thousands_of_triangles_are_right(device):
    n = 5000
    angle = np.linspace(0, 2 * np.pi, n, endpoint=False)
    rim = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(n)])
    fan = np.column_stack([np.zeros(n, int), 1 + np.arange(n), 1 + (np.arange(n) + 1) % n])
    mesh = TriangleMesh(np.vstack([[0, 0, 1], rim]), fan, device=device).compute_vertex_normals()
    np.testing.assert_allclose(mesh.vertex_normals[0], [0, 0, 1], atol=1e-6)
    assert mesh.is_edge_manifold()


def test_vertices_without_area_point_up_and_vertices_that_are_not_finite_have_no_normal(device):
    vertices = [[0, 0, 0], [0, 1, 0], [0, 0, 1], [5, 5, 5], [1, 1, 1], [np.nan, 0, 0]]
    mesh = TriangleMesh(vertices, [[0, 1, 2], [3, 3, 3], [0, 1, 5]], device=device).compute_vertex_normals()
    np.testing.assert_array_equal(mesh.vertex_normals[:5], [[1, 0, 0]] * 3 + [[0, 0, 1]] * 2)
    assert np.isnan(mesh.vertex_normals[5]).all()
    assert mesh.get_surface_area() == 0.5
    np.testing.assert_array_equal(mesh.compute_triangle_normals(), [[1, 0, 0], [0, 0, 1], [0, 0, 1]])
    np.testing.assert_array_equal([*mesh.get_axis_aligned_bounding_box()], [[0, 0, 0], [5, 5, 5]])


@pytest.mark.parametrize("scale", [1e-18, 1e-3, 1e12])
def test_normals_do_not_depend_on_the_size_of_the_mesh(device, scale):
    mesh = TriangleMesh(np.array(TETRAHEDRON[0]) * scale, TETRAHEDRON[1], device=device).compute_vertex_normals()
    assert np.abs(np.linalg.norm(mesh.vertex_normals, axis=1) - 1).max() < 1e-6
    np.testing.assert_allclose(mesh.vertex_normals[0], [-(3**-0.5)] * 3, atol=1e-6)


def test_an_empty_mesh_takes_every_operation(device):
    mesh = TriangleMesh(device=device)
    assert (len(mesh), mesh.vertices.shape, mesh.triangles.shape) == (0, (0, 3), (0, 3))
    assert mesh.compute_vertex_normals().vertex_normals.shape == (0, 3)
    assert mesh.compute_triangle_normals().shape == (0, 3)
    assert (mesh.get_surface_area(), mesh.get_volume()) == (0.0, 0.0)
    assert len(mesh.transform(np.eye(4)).remove_unreferenced_vertices()) == 0
    np.testing.assert_array_equal([*mesh.get_axis_aligned_bounding_box()], np.zeros((2, 3)))


def test_volume_is_refused_where_there_is_none(device):
    vertices, triangles = TETRAHEDRON
    with pytest.raises(ValueError, match="not watertight"):
        TriangleMesh(vertices, triangles[:3], device=device).get_volume()
    with pytest.raises(ValueError, match="orient them alike"):
        TriangleMesh(vertices, [*triangles[:3], triangles[3][::-1]], device=device).get_volume()


def test_area_and_volume_are_exact_far_from_zero(device):
    vertices, triangles = TETRAHEDRON
    mesh = TriangleMesh(np.array(vertices) + FAR, triangles, device=device)
    assert mesh.get_volume() == pytest.approx(1 / 6, rel=1e-12)
    assert mesh.get_surface_area() == pytest.approx(1.5 + np.sqrt(3) / 2, rel=1e-7)
    np.testing.assert_array_equal(mesh.vertices, np.array(vertices) + FAR)


@pytest.mark.parametrize("shift", [(0, 0, 0), (1, 2, 3), tuple(FAR)])
@pytest.mark.parametrize("mirror", [1, -1])
def test_normals_turn_with_the_mesh_whatever_the_matrix(device, shift, mirror):
    T = np.eye(4)
    T[:3, :3] = Rotation.from_rotvec([0.3, -0.8, 0.5]).as_matrix() @ np.diag([mirror, 2.0, 0.5])
    T[:3, 3] = shift
    mesh = rough_ball(device).compute_vertex_normals()
    moved = mesh.transform(T)
    np.testing.assert_allclose(moved.vertices, mesh.vertices @ T[:3, :3].T + T[:3, 3], atol=3e-7)
    peer = in_open3d(moved).compute_triangle_normals()
    face = mesh.compute_triangle_normals() @ np.linalg.inv(T[:3, :3])
    face /= np.linalg.norm(face, axis=1, keepdims=True)
    alignment = np.einsum("ij,ij->i", np.asarray(peer.triangle_normals), face)
    assert np.median(alignment) > 0.9999 and alignment.min() > 0  # slivers of the ball turn a little
    expected = mesh.vertex_normals @ np.linalg.inv(T[:3, :3])
    expected /= np.linalg.norm(expected, axis=1, keepdims=True)
    np.testing.assert_allclose(moved.vertex_normals, expected, atol=1e-6)
    assert moved.get_volume() == pytest.approx(mesh.get_volume(), rel=1e-5)


@pytest.mark.parametrize("shift", [(0, 0, 0), tuple(FAR)])
def test_a_mesh_is_moved_turned_and_scaled_about_its_middle_as_in_open3d(device, shift):
    mesh = rough_ball(device).translate(shift)
    peer, turn = in_open3d(mesh), Rotation.from_rotvec([0.3, -0.8, 0.5]).as_matrix()
    np.testing.assert_allclose(mesh.get_center(), np.asarray(peer.vertices).mean(axis=0), rtol=1e-12, atol=1e-7)
    for ours, theirs in (
        (mesh.rotate(turn), copy.deepcopy(peer).rotate(turn)),
        (mesh.rotate(turn, [1, 2, 3]), copy.deepcopy(peer).rotate(turn, [1, 2, 3])),
        (mesh.scale(2.5), copy.deepcopy(peer).scale(2.5, peer.get_center())),
        (mesh.translate([1, 2, 3]), copy.deepcopy(peer).translate([1, 2, 3])),
        (mesh.translate([1, 2, 3], relative=False), copy.deepcopy(peer).translate([1, 2, 3], relative=False)),
    ):
        np.testing.assert_allclose(ours.vertices, np.asarray(theirs.vertices), atol=2e-6, rtol=2e-7)


def test_a_painted_mesh_has_one_colour_and_the_old_one_keeps_its_own(device):
    mesh = rough_ball(device)
    painted = mesh.paint_uniform_color([1, 0.5, 0.25])
    assert (painted.vertex_colors == [1, 0.5, 0.25]).all() and len(painted.vertex_colors) == len(mesh.vertices)
    with pytest.raises(ValueError, match="divide 8-bit colours by 255"):
        mesh.paint_uniform_color([255, 0, 0])


def test_moving_there_and_back_brings_the_vertices_back(device):
    mesh, T = rough_ball(device), np.eye(4)
    T[:3, :3], T[:3, 3] = Rotation.from_rotvec([0.1, 0.2, 0.3]).as_matrix(), FAR
    back = mesh.transform(T).transform(np.linalg.inv(T))
    assert not back.origin.any()
    np.testing.assert_allclose(back.vertices, mesh.vertices, atol=1e-6)


def test_unreferenced_vertices_go_and_the_rest_keep_their_order_and_values(device):
    mesh = colored(device)
    kept = mesh.triangles[::7]
    cut = TriangleMesh(
        mesh.vertices, kept, vertex_normals=mesh.vertex_normals, vertex_colors=mesh.vertex_colors, device=device
    )
    clean = cut.remove_unreferenced_vertices()
    used = np.unique(kept)
    np.testing.assert_array_equal(clean.vertices, mesh.vertices[used])
    np.testing.assert_array_equal(clean.vertex_colors, mesh.vertex_colors[used])
    np.testing.assert_array_equal(clean.vertex_normals, mesh.vertex_normals[used])
    np.testing.assert_array_equal(used[clean.triangles], kept)


# ------------------------------------------------------------------------------------------------ data


def test_operations_return_new_meshes_that_share_what_they_leave(device):
    mesh = rough_ball(device)
    with_normals = mesh.compute_vertex_normals()
    assert mesh.vertex_normals is None
    assert with_normals.array("vertices") is mesh.array("vertices")
    assert with_normals.array("triangles") is mesh.array("triangles")
    assert mesh.to(device) is mesh


def test_what_is_read_is_a_copy_that_cannot_be_written(device):
    mesh = colored(device)
    for name in ("vertices", "triangles", "vertex_normals", "vertex_colors", "origin"):
        with pytest.raises(ValueError, match="read-only"):
            getattr(mesh, name)[:] = 7
        getattr(mesh, name).copy()[:] = 7


def test_far_vertices_move_the_origin_and_a_given_origin_is_kept(device):
    vertices = np.array(TETRAHEDRON[0]) + FAR
    mesh = TriangleMesh(vertices, TETRAHEDRON[1], device=device)
    assert np.abs(mesh.origin - FAR).max() <= 1
    assert np.abs(mesh.array("vertices").numpy()).max() <= 1
    given = TriangleMesh(vertices, TETRAHEDRON[1], origin=FAR - 2, device=device)
    np.testing.assert_array_equal(given.origin, FAR - 2)
    np.testing.assert_array_equal(given.vertices, vertices)


def test_a_mesh_says_what_it_is():
    mesh = TriangleMesh(*TETRAHEDRON, vertex_colors=np.zeros((4, 3)))
    assert repr(mesh) == "TriangleMesh(4 vertices, 4 triangles, vertex_colors, cpu)"
    assert len(mesh) == 4


@pytest.mark.parametrize("layout", ["triples", "flat", "table"])
def test_kernel_made_meshes_share_the_arrays_that_they_are_given(device, layout):
    vertices = wp.array(np.array(TETRAHEDRON[0], np.float32), dtype=wp.vec3, device=device)
    rows = np.array(TETRAHEDRON[1], np.int32)
    triangles = {
        "triples": lambda: wp.array(rows, dtype=wp.vec3i, device=device),
        "flat": lambda: wp.array(rows.ravel(), dtype=wp.int32, device=device),
        "table": lambda: wp.array(rows, dtype=wp.int32, device=device),
    }[layout]()
    mesh = TriangleMesh.from_device_arrays(vertices, triangles, origin=FAR)
    assert mesh.array("vertices").ptr == vertices.ptr
    assert mesh.array("triangles").ptr == triangles.ptr
    del triangles
    assert mesh.get_volume() == pytest.approx(1 / 6)
    np.testing.assert_array_equal(mesh.vertices, np.array(TETRAHEDRON[0]) + FAR)


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"vertices": np.zeros((2, 4))}, ValueError, r"vertices: expected shape \[n, 3\], got \[2, 4\]"),
        ({"triangles": [[0, 1, 4]]}, ValueError, r"triangles: row 0 is \[0, 1, 4\], but there are vertices 0..3 only"),
        ({"triangles": [[0, 1, -1]]}, ValueError, "triangles: row 0"),
        ({"triangles": [[0.0, 1.0, 2.0]]}, TypeError, "triangles: expected whole numbers, got float64"),
        ({"vertex_normals": np.zeros((3, 3))}, ValueError, r"vertex_normals: expected shape \[4, 3\]"),
        ({"vertex_colors": [["red"] * 3] * 4}, TypeError, "vertex_colors: expected real numbers"),
        ({"origin": [0, 0]}, ValueError, r"origin: expected shape \[3\], got \[2\]"),
        ({"device": "gpu"}, DeviceError, "device: expected one of"),
    ],
)
def test_bad_arguments_are_named(arguments, error, message):
    vertices, triangles = TETRAHEDRON
    with pytest.raises(error, match=message):
        TriangleMesh(**{"vertices": vertices, "triangles": triangles} | arguments)


def test_a_missing_array_and_a_flat_matrix_are_refused():
    mesh = TriangleMesh(*TETRAHEDRON)
    with pytest.raises(KeyError, match="vertex_normals: this mesh has vertices, triangles"):
        mesh.array("vertex_normals")
    with pytest.raises(ValueError, match="transformation: expected an invertible matrix"):
        mesh.transform(np.diag([1.0, 1.0, 0.0, 1.0]))
    with pytest.raises(ValueError, match=r"vertex_colors: expected shape \[4, 3\], one row a vertex, got \[1, 3\]"):
        mesh.vertex_colors = [[1, 0, 0]]
    with pytest.raises(ValueError, match=r"vertex_normals: expected shape \[4, 3\], one row a vertex, got \[5, 3\]"):
        mesh.vertex_normals = np.ones((5, 3))


# ------------------------------------------------------------------------------------------------ files


@pytest.mark.parametrize("ascii", [False, True])
@pytest.mark.parametrize("shift", [(0, 0, 0), tuple(FAR)])
def test_a_mesh_survives_a_ply_file(device, tmp_path, ascii, shift):
    T = np.eye(4)
    T[:3, 3] = shift
    mesh = colored(device).transform(T)
    write_triangle_mesh(tmp_path / "mesh.ply", mesh, ascii=ascii)
    back = read_triangle_mesh(tmp_path / "mesh.ply", device=device)
    np.testing.assert_allclose(back.vertices, mesh.vertices, rtol=0, atol=1e-7)
    np.testing.assert_array_equal(back.triangles, mesh.triangles)
    np.testing.assert_array_equal(back.vertex_normals, mesh.vertex_normals)
    np.testing.assert_allclose(back.vertex_colors, mesh.vertex_colors, atol=0.5 / 255 + 1e-6)


@pytest.mark.parametrize("suffix", [".ply", ".obj", ".stl"])
def test_open3d_reads_what_we_write(tmp_path, suffix):
    o3d = pytest.importorskip("open3d", exc_type=ImportError)
    mesh = rough_ball()
    write_triangle_mesh(tmp_path / f"mesh{suffix}", mesh)
    peer = o3d.io.read_triangle_mesh(str(tmp_path / f"mesh{suffix}"))
    assert len(peer.triangles) == len(mesh)
    corners = np.asarray(peer.vertices)[np.asarray(peer.triangles)]
    np.testing.assert_allclose(corners, mesh.vertices[mesh.triangles], atol=1e-6)


def test_unknown_formats_and_existing_files_are_refused(tmp_path):
    mesh = TriangleMesh(*TETRAHEDRON)
    with pytest.raises(FileError, match=r"written to \.ply, \.obj, \.stl, \.off, \.glb, \.gltf, not to \.fbx"):
        write_triangle_mesh(tmp_path / "mesh.fbx", mesh)
    with pytest.raises(FileError, match=r"read from \.ply, \.obj, \.stl, \.off, \.glb, \.gltf, not from no extension"):
        read_triangle_mesh(tmp_path / "mesh")
    write_triangle_mesh(tmp_path / "mesh.ply", mesh)
    with pytest.raises(FileError):
        write_triangle_mesh(tmp_path / "mesh.ply", mesh, overwrite=False)
    with pytest.raises(ValueError, match="ascii: STL"):
        write_triangle_mesh(tmp_path / "mesh.stl", mesh, ascii=True)
