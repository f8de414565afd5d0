"""TetraMesh and HalfEdgeTriangleMesh of pointloom.open3d."""

import copy
import pickle

import numpy as np
import pytest

import pointloom.open3d as o3d

G, V = o3d.geometry, o3d.utility.Vector3dVector


def volumes(mesh):
    corners = np.asarray(mesh.vertices)[np.asarray(mesh.tetras)]
    return np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])) / 6


def test_tetrahedra_of_a_cloud_fill_its_hull_without_points_inside_their_spheres(rng):
    points = rng.normal(size=(60, 3))
    points[7] = np.nan
    mesh, rows = G.TetraMesh.create_from_point_cloud(G.PointCloud(V(np.r_[points, points[:1]])))
    assert len(rows) == 59 and 7 not in rows and {0, 60} - set(rows) != set()
    vertices = np.asarray(mesh.vertices)
    np.testing.assert_array_equal(vertices, np.r_[points, points[:1]][rows])
    np.testing.assert_allclose(volumes(mesh).sum(), mesh.compute_convex_hull()[0].get_volume(), rtol=1e-5)
    a, *others = np.moveaxis(vertices[np.asarray(mesh.tetras)], 1, 0)
    edges = np.stack([other - a for other in others], axis=1)
    centers = a + np.linalg.solve(2 * edges, (edges**2).sum(axis=2)[..., None])[..., 0]
    radii = np.linalg.norm(centers - a, axis=1)
    distances = np.linalg.norm(vertices - centers[:, None], axis=2)
    assert (distances >= radii[:, None] * (1 - 1e-6)).all()


@pytest.mark.parametrize("points", [np.zeros((0, 3)), np.eye(3), np.c_[np.eye(5)[:, :2], np.zeros(5)]])
def test_points_on_a_plane_have_no_tetrahedra(points):
    with pytest.raises(ValueError, match="point_cloud:"):
        G.TetraMesh.create_from_point_cloud(G.PointCloud(V(points)))


def test_an_isosurface_of_distances_is_a_closed_sphere(rng):
    mesh, _ = G.TetraMesh.create_from_point_cloud(G.PointCloud(V(rng.uniform(-1, 1, (4000, 3)))))
    values = np.linalg.norm(mesh.vertices, axis=1)
    surface = mesh.extract_triangle_mesh(o3d.utility.DoubleVector(values), 0.6)
    assert surface.is_watertight()
    # linear interpolation between values across edges of about 0.1
    np.testing.assert_allclose(np.linalg.norm(surface.vertices, axis=1), 0.6, atol=0.03)
    np.testing.assert_allclose(surface.get_volume(), 4 / 3 * np.pi * 0.6**3, rtol=0.03)  # positive: faces outward
    assert len(mesh.extract_triangle_mesh(values, 5).triangles) == 0
    with pytest.raises(ValueError, match="values:"):
        mesh.extract_triangle_mesh(values[:-1], 0.6)


def small():
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0], [9, 9, 9]]
    tetras = [[0, 1, 2, 3], [3, 2, 1, 0], [4, 1, 2, 3], [0, 0, 1, 2], [0, 4, 1, 2]]
    return G.TetraMesh(V(points), o3d.utility.Vector4iVector(tetras))


def test_removals_keep_the_first_and_rename_vertices():
    mesh = small()
    mesh.vertex_colors = V(np.arange(18).reshape(6, 3) / 18)
    assert mesh.remove_duplicated_vertices() is mesh
    assert np.asarray(mesh.tetras).tolist() == [[0, 1, 2, 3], [3, 2, 1, 0], [0, 1, 2, 3], [0, 0, 1, 2], [0, 0, 1, 2]]
    assert np.asarray(mesh.remove_duplicated_tetras().tetras).tolist() == [[0, 1, 2, 3], [0, 0, 1, 2]]
    assert np.asarray(mesh.remove_degenerate_tetras().tetras).tolist() == [[0, 1, 2, 3]]
    assert np.asarray(mesh.remove_unreferenced_vertices().vertices).tolist() == [*np.eye(4, 3, -1).tolist()]
    np.testing.assert_allclose(mesh.vertex_colors, np.arange(12).reshape(4, 3) / 18, atol=1e-7)


def test_meshes_of_tetrahedra_are_joined_moved_and_copied():
    mesh = small().remove_duplicated_vertices().remove_unreferenced_vertices().remove_duplicated_tetras()
    mesh.remove_degenerate_tetras()
    both = mesh + mesh
    assert np.asarray(both.tetras).tolist() == [[0, 1, 2, 3], [4, 5, 6, 7]] and both.has_tetras()
    both.translate([1, 0, 0]).paint_uniform_color([1, 0, 0])
    np.testing.assert_allclose(both.get_center(), [1.25, 0.25, 0.25])
    assert both.has_vertex_colors() and not (both + mesh).has_vertex_colors()
    for again in (copy.deepcopy(both), G.TetraMesh(both), pickle.loads(pickle.dumps(both))):
        assert str(again) == "TetraMesh with 8 points and 2 tetrahedra."
        assert str(again.clear()) == "TetraMesh with 0 points and 0 tetrahedra."
    assert len(both.tetras) == 2 and both.get_geometry_type() == G.Geometry.TetraMesh


def open_sphere():
    mesh = G.TriangleMesh.create_sphere(1.0, 8)
    return G.TriangleMesh(mesh.vertices, o3d.utility.Vector3iVector(np.asarray(mesh.triangles)[20:]))


@pytest.mark.parametrize("make", [open_sphere, G.TriangleMesh.create_box, G.TriangleMesh.create_torus])
def test_half_edges_follow_their_triangles_and_meet_their_twins(make):
    mesh = G.HalfEdgeTriangleMesh.create_from_triangle_mesh(make())
    edges, triangles = mesh.half_edges, np.asarray(mesh.triangles)
    assert mesh.has_half_edges() and len(edges) == 3 * len(triangles)
    boundary = 0
    for index, edge in enumerate(edges):
        start, end = edge.vertex_indices
        following = edges[edge.next]
        assert following.vertex_indices[0] == end and following.triangle_index == edge.triangle_index == index // 3
        assert edges[following.next].next == index and start in triangles[edge.triangle_index]
        boundary += edge.is_boundary()
        if not edge.is_boundary():
            assert edges[edge.twin].vertex_indices.tolist() == [end, start] and edges[edge.twin].twin == index
    fans = mesh.ordered_half_edge_from_vertex
    assert sorted(edge for fan in fans for edge in fan) == list(range(len(edges)))
    assert all(edges[edge].vertex_indices[0] == vertex for vertex, fan in enumerate(fans) for edge in fan)
    assert sum(map(len, mesh.get_boundaries())) == boundary
    for again in (copy.deepcopy(mesh), G.HalfEdgeTriangleMesh(mesh), pickle.loads(pickle.dumps(mesh))):
        assert str(again) == str(mesh) and again.ordered_half_edge_from_vertex == fans


def test_boundaries_are_loops_from_their_lowest_vertex():
    mesh = G.HalfEdgeTriangleMesh.create_from_triangle_mesh(open_sphere())
    directed = {tuple(edge.vertex_indices.tolist()) for edge in mesh.half_edges if edge.is_boundary()}
    for loop in mesh.get_boundaries():
        assert loop[0] == min(loop) and mesh.boundary_vertices_from_vertex(loop[0]) == loop
        assert set(zip(loop, loop[1:] + loop[:1], strict=True)) <= directed
        starts = [mesh.half_edges[i].vertex_indices[0] for i in mesh.boundary_half_edges_from_vertex(loop[0])]
        assert starts == loop
    inner = next(v for v in range(len(mesh.vertices)) if all(v not in loop for loop in mesh.get_boundaries()))
    with pytest.raises(ValueError, match="vertex_index:"):
        mesh.boundary_vertices_from_vertex(inner)


@pytest.mark.parametrize("triangles", [[[0, 1, 2], [0, 1, 3]], [[0, 1, 2], [0, 3, 4]]])
def test_half_edges_need_an_oriented_manifold(triangles):
    points = V([[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]])
    mesh = G.TriangleMesh(points, o3d.utility.Vector3iVector(triangles))
    with pytest.raises(ValueError, match="mesh:"):
        G.HalfEdgeTriangleMesh.create_from_triangle_mesh(mesh)
