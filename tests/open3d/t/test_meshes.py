"""`o3d.t.geometry.TriangleMesh`: values by arithmetic, types and devices of results, files."""

import copy
import pickle

import numpy as np
import pytest

import pointloom as loom
import pointloom.open3d as o3d
from pointloom.open3d.core import Tensor, float32, float64, int32, int64, uint8

Mesh = o3d.t.geometry.TriangleMesh
PRIMITIVES = ["box", "sphere", "tetrahedron", "octahedron", "icosahedron", "cylinder", "cone", "ellipsoid", "torus"]
PRIMITIVES += ["arrow", "coordinate_frame", "mobius"]
AREAS = [4, 4, 6, 6, 4, 4, 6, 6, 3, 3, 3, 3]  # of the triangles of a box 2 x 3 x 4
TURN = np.array([[0.0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]])


def device_named(device):
    return o3d.core.Device(device.upper())


@pytest.fixture
def box(device):
    return Mesh.create_box(2, 3, 4, float64, int32, device_named(device))


def values(tensor):
    return tensor.numpy()


def volume(mesh):
    return mesh.to_legacy().get_volume()


@pytest.mark.parametrize("name", PRIMITIVES)
def test_primitives_have_the_requested_types_and_the_shape_of_the_legacy_ones(name):
    made = getattr(Mesh, f"create_{name}")(float_dtype=float64, int_dtype=int32)
    legacy = getattr(o3d.geometry.TriangleMesh, f"create_{name}")()
    assert (made.vertex.positions.dtype, made.triangle.indices.dtype) == (float64, int32)
    np.testing.assert_allclose(values(made.vertex.positions), np.asarray(legacy.vertices), atol=1e-6)
    np.testing.assert_array_equal(values(made.triangle.indices), np.asarray(legacy.triangles))
    default = getattr(Mesh, f"create_{name}")()
    assert (default.vertex.positions.dtype, default.triangle.indices.dtype) == (float32, int64)


def test_a_mesh_of_tensors_shares_them_and_describes_itself(device):
    where = device_named(device)
    corners, rows = Tensor(np.eye(3), float64, where), Tensor([[0, 1, 2]], int64, where)
    mesh = Mesh(corners, rows)
    shared, own = Mesh(mesh), mesh.clone()
    corners[0, 0] = 5.0
    assert [values(m.vertex.positions)[0, 0] for m in (mesh, shared, own)] == [5, 5, 1]
    assert mesh.device == where and mesh.is_cuda == (device != "cpu") and not mesh.is_empty()
    assert str(mesh).startswith(f"TriangleMesh on {where} [3 vertices (Float64) and 1 triangles (Int64)].")
    for same in (copy.deepcopy(mesh), pickle.loads(pickle.dumps(mesh)), mesh.to(where, copy=True)):
        np.testing.assert_array_equal(values(same.vertex.positions), values(corners))
    empty = Mesh(device=where)
    assert empty.is_empty() and empty.device == where and empty.get_surface_area() == 0
    assert mesh.clear().is_empty() and mesh.device == where


def test_legacy_meshes_keep_their_digits_colors_normals_and_texture():
    legacy = o3d.geometry.TriangleMesh.create_box(create_uv_map=True)
    legacy.vertices = o3d.utility.Vector3dVector(np.asarray(legacy.vertices) + 1 / 3)
    legacy.compute_vertex_normals()
    legacy.paint_uniform_color([0.2, 0.4, 0.6])
    legacy.textures = [o3d.geometry.Image(np.arange(48, dtype=np.uint8).reshape(4, 4, 3))]
    mesh = Mesh.from_legacy(legacy, float64, int32)
    assert mesh.triangle.texture_uvs.numpy().shape == (12, 3, 2) and mesh.triangle.indices.dtype == int32
    assert mesh.has_valid_material()
    np.testing.assert_array_equal(values(mesh.material.texture_maps["albedo"].as_tensor())[0, 0], [36, 37, 38])
    back = mesh.to_legacy()
    for name in ("vertices", "triangles", "vertex_normals", "vertex_colors", "triangle_normals", "triangle_uvs"):
        np.testing.assert_array_equal(np.asarray(getattr(back, name)), np.asarray(getattr(legacy, name)))
    np.testing.assert_array_equal(np.asarray(back.textures[0]), np.asarray(legacy.textures[0]))
    mesh.vertex.colors = Tensor(np.full((8, 3), 51, np.uint8))
    np.testing.assert_allclose(np.asarray(mesh.to_legacy().vertex_colors), 0.2)


def test_normals_areas_and_bounds_of_a_box(box):
    box.compute_vertex_normals(normalized=False)
    lengths = np.linalg.norm(values(box.triangle.normals), axis=1)
    np.testing.assert_allclose(lengths, 2 * np.array(AREAS))
    np.testing.assert_allclose(values(box.vertex.normals)[0], [-12, -8, -6])  # by hand: areas at corner 0
    box.normalize_normals()
    unit = values(box.triangle.normals)
    np.testing.assert_allclose(np.linalg.norm(unit, axis=1), 1)
    box.compute_vertex_normals()
    np.testing.assert_allclose(values(box.triangle.normals), unit, atol=1e-7)
    np.testing.assert_allclose(values(box.compute_triangle_areas().triangle.areas), AREAS)
    assert box.triangle.areas.dtype == box.vertex.normals.dtype == float64
    assert box.get_surface_area() == 52
    assert [values(v).tolist() for v in (box.get_min_bound(), box.get_max_bound(), box.get_center())] == [
        [0, 0, 0],
        [2, 3, 4],
        [1, 1.5, 2],
    ]
    assert values(box.get_axis_aligned_bounding_box().get_extent()).tolist() == [2, 3, 4]


def test_motions_change_positions_and_both_normals_in_place(box):
    start, memory = values(box.vertex.positions).copy(), box.vertex.positions
    box.compute_vertex_normals()
    before = values(box.triangle.normals).copy(), values(box.vertex.normals).copy()
    assert box.transform(TURN) is box
    moved = start @ TURN[:3, :3].T + TURN[:3, 3]
    np.testing.assert_allclose(values(memory), moved, atol=1e-12)
    for name, old in zip(("triangle", "vertex"), before, strict=True):
        normals = values(getattr(box, name)["normals"])
        np.testing.assert_allclose(normals, old @ TURN[:3, :3].T, atol=1e-6)
    box.rotate(Tensor(TURN[:3, :3].T), Tensor(TURN[:3, 3])).translate([-1, -2, -3])
    np.testing.assert_allclose(values(box.vertex.positions), start, atol=1e-12)
    box.scale(0.5, [0, 0, 0]).translate([5, 5, 5], relative=False)
    np.testing.assert_allclose(values(box.get_min_bound()), [4.5, 4.25, 4], atol=1e-12)


def test_selections_keep_attributes_types_and_order(box):
    box.vertex.number = Tensor(np.arange(8), int64, box.device)
    box.vertex.colors = Tensor(np.full((8, 3), 200), uint8, box.device)
    box.triangle.grid = Tensor(np.arange(48.0).reshape(12, 2, 2), float32, box.device)
    chosen = box.select_by_index([7, 2, 0, 1, 99, -3])
    assert values(chosen.vertex.number).tolist() == [0, 1, 2, 7] and values(chosen.triangle.indices).tolist() == [
        [0, 1, 2]
    ]
    assert values(chosen.triangle.grid).tolist() == [[[16, 17], [18, 19]]] and chosen.vertex.colors.dtype == uint8
    top = box.select_faces_by_mask(Tensor(np.arange(12) < 2, device=box.device))
    assert values(top.vertex.positions)[:, 1].tolist() == [3] * 4 and top.triangle.indices.dtype == int32
    assert "number" not in box.select_by_index([0, 1], copy_attributes=False).vertex
    for wrong in (lambda: box.select_by_index([0.5]), lambda: box.select_faces_by_mask(np.ones(11, bool))):
        with pytest.raises(RuntimeError, match=r"indices|mask"):
            wrong()
    three = Mesh(Tensor(np.eye(4, 3), device=box.device), Tensor([[0, 1, 3], [0, 1, 3], [1, 0, 3]], device=box.device))
    assert values(three.get_non_manifold_edges()).tolist() == [[0, 1], [0, 3], [1, 3]]
    assert values(three.remove_unreferenced_vertices().vertex.positions).shape == (3, 3)
    assert values(three.remove_non_manifold_edges().get_non_manifold_edges()).shape == (0, 2)


def test_cuts_sweeps_hulls_and_holes_have_the_volumes_of_solids(box):
    half = box.compute_triangle_areas().clip_plane(Tensor([1.0, 0, 0]), [1, 0, 0])
    assert values(half.get_max_bound() - half.get_min_bound()).tolist() == [1, 3, 4] and "areas" not in half.triangle
    assert volume(half.fill_holes()) == pytest.approx(12) and half.vertex.positions.dtype == float64
    lines = box.slice_plane([0, 0, 1], [0, 0, 1], [0, 1])
    ends = values(lines.point.positions)[values(lines.line.indices)]
    assert np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).sum() == pytest.approx(2 * 10)
    flat = Mesh(Tensor([[2.0, 0, 0], [3, 0, 0], [2, 0, 1]], device=box.device), Tensor([[0, 1, 2]], device=box.device))
    assert volume(flat.extrude_linear([0, -2, 0], 1.5)) == pytest.approx(1.5)
    ring = flat.extrude_rotation(360, [0, 0, 1], 64)  # Pappus: area 1/2, centroid at 7/3
    assert volume(ring) == pytest.approx(np.pi * 7 / 3, rel=2e-3)
    hull = box.compute_convex_hull()
    assert volume(hull) == pytest.approx(24) and sorted(values(hull.vertex.point_indices)) == [*range(8)]
    ball = Mesh.create_sphere(1.0, 20, device=box.device).simplify_quadric_decimation(0.5)
    assert len(values(ball.triangle.indices)) == 760 and volume(ball) == pytest.approx(4 / 3 * np.pi, rel=0.02)


def test_solids_are_combined(device):
    pytest.importorskip("manifold3d")
    one, two = (Mesh.create_box(device=device_named(device)) for _ in range(2))
    two.translate([0.5, 0.5, 0.5])
    made = one.boolean_union(two), one.boolean_intersection(two), one.boolean_difference(two)
    assert [volume(mesh) for mesh in made] == pytest.approx([15 / 8, 1 / 8, 7 / 8])


def test_samples_and_metrics_of_parallel_triangles(device):
    where = device_named(device)
    floor = Mesh(Tensor([[0, 0, 0], [1, 0, 0], [0, 1, 0]], float32, where), Tensor([[0, 1, 2]], int64, where))
    floor.vertex.colors = Tensor(np.full((3, 3), 51), uint8, where)
    cloud = floor.sample_points_uniformly(50, use_triangle_normal=True)
    assert cloud.device == where and (values(cloud.point.positions) @ [1, 1, 0] <= 1).all()
    assert np.ptp(values(cloud.point.normals), axis=0).max() == 0 and values(cloud.point.normals)[0].tolist() == [
        0,
        0,
        1,
    ]
    np.testing.assert_allclose(values(cloud.point.colors), 0.2, atol=1e-6)
    kinds, options = o3d.t.geometry.Metric, o3d.t.geometry.MetricParameters([1, 3], 500)
    found = floor.compute_metrics(floor.clone().translate([0, 0, 2]), (o3d.t.geometry.FScore, *kinds), options)
    np.testing.assert_allclose(values(found), [0, 100, 4, 2, 0, 100], atol=1e-6)
    with pytest.raises(TypeError, match="mesh2"):
        floor.compute_metrics(o3d.geometry.TriangleMesh(), (), options)


def test_isosurfaces_are_in_samples():
    z, y, x = np.mgrid[:9, :9, :9] - 4.0
    ball = Mesh.create_isosurfaces(Tensor(np.sqrt(x**2 + y**2 + (2 * z) ** 2).astype(np.float32)), [3.0])
    np.testing.assert_allclose(values(ball.get_max_bound()), [7, 7, 5.5], atol=0.1)
    assert ball.vertex.normals.dtype == float32


def test_attributes_are_baked_into_texels_at_their_centers(device):
    where = device_named(device)
    corners = Tensor([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], float32, where)
    plane = Mesh(corners, Tensor([[0, 1, 2], [0, 2, 3]], int64, where))
    plane.triangle.texture_uvs = Tensor(values(corners)[values(plane.triangle.indices)][..., :2] / 8, float32, where)
    plane.triangle.number = Tensor([7, 8], int32, where)
    texture = values(plane.bake_vertex_attr_textures(4, {"positions"}, margin=0.1, fill=-1)["positions"])
    np.testing.assert_allclose(texture[3, :2], [[1, 1, 0], [3, 1, 0]], atol=1e-6)  # lower left quarter
    np.testing.assert_allclose(texture[2, 1], [3, 3, 0], atol=1e-6)
    assert (texture[:2] == -1).all() and (texture[:, 2:] == -1).all() and "positions" in plane.material.texture_maps
    numbers = values(plane.bake_triangle_attr_textures(8, ["number"], 0.1, 0, False)["number"])
    assert (
        numbers[7, 2] == 7 and numbers[5, 0] == 8 and numbers[0, 0] == 0 and "number" not in plane.material.texture_maps
    )


def test_files_keep_meshes_and_textures(tmp_path):
    mesh = Mesh.from_legacy(o3d.geometry.TriangleMesh.create_box(create_uv_map=True), float64)
    pixels = np.zeros((4, 4, 3), np.uint8)
    pixels[0, 0] = 10, 20, 30
    mesh.material.set_default_properties()
    mesh.material.texture_maps["albedo"] = o3d.t.geometry.Image(Tensor(pixels))
    for name in ("m.obj", "m.npz", "m.ply"):
        assert o3d.t.io.write_triangle_mesh(tmp_path / name, mesh)
        back = o3d.t.io.read_triangle_mesh(tmp_path / name)
        np.testing.assert_array_equal(values(back.triangle.indices), values(mesh.triangle.indices))
        np.testing.assert_array_equal(values(back.vertex.positions), values(mesh.vertex.positions))
        np.testing.assert_allclose(values(back.triangle.texture_uvs), values(mesh.triangle.texture_uvs), atol=1e-6)
        np.testing.assert_array_equal(values(back.material.texture_maps["albedo"].as_tensor()), pixels)
        assert "number" not in mesh.vertex or values(back.vertex.number).tolist() == [*range(8)]
        mesh.vertex.number = Tensor(np.arange(8, dtype=np.int32))
    assert o3d.t.io.read_triangle_mesh(tmp_path / "m.npz").vertex.positions.dtype == float64
    mesh.vertex.colors = Tensor(np.full((8, 3), 51, np.uint8))
    mesh.compute_vertex_normals().translate([5e5, 5e6, 0])
    o3d.t.io.write_triangle_mesh(tmp_path / "far.ply", mesh)
    far = o3d.t.io.read_triangle_mesh(tmp_path / "far.ply")
    np.testing.assert_allclose(values(far.vertex.positions), values(mesh.vertex.positions), rtol=0, atol=1e-6)
    np.testing.assert_allclose(values(far.vertex.colors), 0.2, atol=1e-7)
    assert far.vertex.positions.dtype == float64 and "normals" in far.vertex and "normals" not in far.triangle
    np.savez(tmp_path / "other.npz", a=np.zeros(3))
    with pytest.raises(loom.FileError, match="vertices"):
        o3d.t.io.read_triangle_mesh(tmp_path / "other.npz")
    with pytest.raises(loom.FileError, match="missing"):
        o3d.t.io.read_triangle_mesh(tmp_path / "missing.npz")


@pytest.mark.parametrize(
    ("call", "error", "name"),
    [
        (lambda m: Mesh.from_legacy(m), TypeError, "mesh_legacy"),
        (lambda m: Mesh(np.zeros((2, 2)), [[0, 1, 0]]), ValueError, "positions"),
        (lambda m: m.simplify_quadric_decimation(100), ValueError, "target_reduction"),
        (lambda m: m.boolean_union(m.to_legacy()), TypeError, "mesh"),
        (lambda m: m.bake_vertex_attr_textures(8, {"positions"}), ValueError, "texture_uvs"),
        (lambda m: m.to_mitsuba("a"), AttributeError, "not here"),
        (lambda m: Mesh.create_text("a"), AttributeError, "not here"),
    ],
)
def test_wrong_arguments_and_missing_methods_are_named(call, error, name):
    with pytest.raises(error, match=name):
        call(Mesh.create_box())
