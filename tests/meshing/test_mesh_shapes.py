"""Simple shapes: Open3D's arrays in Open3D's order."""

import numpy as np

from pointloom import TriangleMesh

SHAPES = [
    ("box", {}), ("box", {"width": 2, "height": 3, "depth": 0.5}), ("tetrahedron", {"radius": 2}),
    ("octahedron", {"radius": 0.3}), ("icosahedron", {"radius": 1.5}), ("sphere", {}),
    ("sphere", {"radius": 2, "resolution": 2}), ("sphere", {"resolution": 3}),
    ("ellipsoid", {"radius_x": 1, "radius_y": 2, "radius_z": 0.5, "resolution": 5}),
    ("cylinder", {}), ("cylinder", {"radius": 0.5, "height": 3, "resolution": 3, "split": 1}),
    ("cone", {}), ("cone", {"radius": 2, "height": 1, "resolution": 5, "split": 3}),
]  # fmt: skip
PLAIN = [
    ("torus", {}), ("torus", {"torus_radius": 3, "tube_radius": 0.2, "radial_resolution": 3, "tubular_resolution": 4}),
    ("arrow", {}), ("arrow", {"cylinder_radius": 0.1, "cone_radius": 0.2, "resolution": 4, "cone_split": 3}),
    ("mobius", {}), ("mobius", {"length_split": 7, "width_split": 4, "twists": 0}),
    ("mobius", {"length_split": 8, "width_split": 2, "twists": 2, "flatness": 0.5}),
    ("mobius", {"length_split": 9, "width_split": 5, "twists": 3, "radius": 2, "width": 0.5, "scale": 3}),
    ("coordinate_frame", {}), ("coordinate_frame", {"size": 0.5, "origin": [1, 2, 3]}),
]  # fmt: skip


FACES = ("box", {"map_texture_to_each_face": True})


def open3d_shapes(o3d):
    """Arrays of all shapes as 32-bit numbers."""
    make, meshes = o3d.geometry.TriangleMesh, []
    for name, options in SHAPES + PLAIN:
        peer = getattr(make, f"create_{name}")(**options)
        meshes.append([np.array(peer.vertices, np.float32), np.array(peer.triangles, np.int16)])
    return meshes


def test_shapes_match_open3d_vertex_by_vertex(device, oracle):
    for (name, options), (vertices, triangles) in zip(
        SHAPES + PLAIN, oracle("meshing/shapes/arrays", open3d_shapes), strict=True
    ):
        result = getattr(TriangleMesh, f"create_{name}")(**options, device=device)
        # vertices are float32, and numpy's sine may differ in the last bit of float64
        np.testing.assert_allclose(result.vertices, vertices, rtol=1e-6, atol=1e-7, err_msg=f"{name} {options}")
        np.testing.assert_array_equal(result.triangles, triangles)
        assert result.triangle_uvs is None and result.device == TriangleMesh(device=device).device


def open3d_textures(o3d):
    make = o3d.geometry.TriangleMesh
    return [
        np.array(getattr(make, f"create_{name}")(**options, create_uv_map=True).triangle_uvs, np.float32)
        for name, options in [*SHAPES, FACES]
    ]


def test_texture_coordinates_match_open3d(oracle):
    wanted = oracle("meshing/shapes/textures", open3d_textures)
    for (name, options), uvs in zip([*SHAPES, FACES], wanted, strict=True):
        result = getattr(TriangleMesh, f"create_{name}")(**options, create_uv_map=True)
        np.testing.assert_allclose(result.triangle_uvs, uvs, atol=2e-7, err_msg=f"{name} {options}")  # float32, twice


def open3d_frame(o3d):
    peer = o3d.geometry.TriangleMesh.create_coordinate_frame(2)
    return np.array(peer.vertex_normals, np.float32)[::7], np.array(peer.vertex_colors, np.float32)[::7]


def test_a_coordinate_frame_has_the_normals_and_colors_of_open3d(device, oracle):
    result = TriangleMesh.create_coordinate_frame(2, device=device)
    normals, colors = oracle("meshing/shapes/coordinate_frame", open3d_frame)
    np.testing.assert_allclose(result.vertex_normals[::7], normals, atol=1e-6)
    np.testing.assert_array_equal(result.vertex_colors[::7], colors)


def test_a_far_coordinate_frame_keeps_its_precision():
    far = TriangleMesh.create_coordinate_frame(0.01, [5e5, 5.4e6, 100])
    near = TriangleMesh.create_coordinate_frame(0.01)
    np.testing.assert_allclose(far.vertices - [5e5, 5.4e6, 100], near.vertices, atol=2e-9)  # a bit of 5.4e6
    np.testing.assert_allclose(far.get_surface_area(), near.get_surface_area(), rtol=1e-5)


def test_a_plane_shows_the_full_image():
    mesh = TriangleMesh.create_plane(2, 3, create_uv_map=True)
    np.testing.assert_array_equal(mesh.triangle_uvs * [2, 3], mesh.vertices[mesh.triangles.reshape(-1), :2])
    np.testing.assert_array_equal(mesh.compute_triangle_normals(), [[0, 0, 1]] * 2)
