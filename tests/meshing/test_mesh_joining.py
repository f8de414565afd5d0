"""Simple shapes, joining, bounding, extrusion and revolution of meshes; triangulation of polygons."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from pointloom import PointCloud, TriangleMesh
from pointloom.meshing.mesh.measures import signed_volume

FAR = np.array([5.0e5, 5.4e6, 100.0])
TRIANGLE = ([[1, 1, 0], [0.7, 1, 0], [1, 0.7, 0]], [[0, 1, 2]])


def dressed(device=None) -> TriangleMesh:
    box = TriangleMesh.create_box(create_uv_map=True, device=device).compute_vertex_normals()
    box = box.paint_uniform_color([1, 0, 0])
    box.textures = [np.zeros((4, 4, 3), np.uint8)]
    box.vertex_attributes["a"], box.triangle_attributes["b"] = np.arange(8), np.arange(24.0).reshape(12, 2)
    return box


def test_a_sum_has_all_triangles_and_attributes_of_both(device):
    box = dressed(device)
    both = box + box.translate(FAR)
    np.testing.assert_array_equal(both.vertices, np.r_[box.vertices, box.vertices + FAR])
    np.testing.assert_array_equal(both.triangles, np.r_[box.triangles, box.triangles + 8])
    for name in ("vertex_normals", "vertex_colors", "triangle_uvs"):
        np.testing.assert_array_equal(getattr(both, name), np.tile(getattr(box, name), (2, 1)))
    assert both.triangle_material_ids.tolist() == [0] * 12 + [1] * 12 and len(both.textures) == 2
    assert both.vertex_attributes["a"].tolist() == [*range(8)] * 2
    np.testing.assert_array_equal(both.triangle_attributes["b"][12:], box.triangle_attributes["b"])


def test_sums_of_many_meshes_and_of_none(device):
    box = dressed(device)
    assert len(sum([box] * 3)) == 36 and len(TriangleMesh(device=device) + box) == 12
    box += box
    assert len(box) == 24 and len(TriangleMesh(device=device) + TriangleMesh(device=device)) == 0
    with pytest.raises(TypeError):
        box + 1


def test_attributes_missing_in_one_mesh_are_dropped():
    with pytest.warns(UserWarning, match=r"^meshes: the .* and textures are dropped"):
        both = dressed() + TriangleMesh.create_box()
    assert not both.has_vertex_normals and not both.has_triangle_uvs and not both.vertex_attributes
    other = TriangleMesh.create_box()
    other.vertex_attributes["a"] = np.zeros(8, np.float32)
    bare = dressed().with_arrays(triangle_uvs=None)
    with pytest.raises(TypeError, match="a:"):
        bare + other


def test_boxes_and_hulls_match_those_of_the_vertices(device):
    mesh = TriangleMesh.create_torus(2, 0.5, 12, 8).rotate(np.linalg.qr(np.ones((3, 3)) + np.eye(3))[0]).to(device)
    cloud = PointCloud(mesh.vertices)
    low, high = mesh.get_axis_aligned_bounding_box()
    np.testing.assert_array_equal([low, high], [mesh.get_min_bound(), mesh.get_max_bound()])
    np.testing.assert_array_equal([low, high], [mesh.vertices.min(0), mesh.vertices.max(0)])
    for name in ("get_oriented_bounding_box", "get_minimal_oriented_bounding_box"):
        assert getattr(mesh, name)().volume() == pytest.approx(getattr(cloud, name)().volume(), rel=1e-6)
    hull, indices = mesh.compute_convex_hull()
    assert hull.is_watertight() and hull.get_volume() == pytest.approx(cloud.compute_convex_hull()[0].volume, rel=1e-6)
    np.testing.assert_allclose(hull.vertices, mesh.vertices[indices])


def test_normals_are_normalized_and_faces_selected_by_mask():
    mesh = dressed()
    doubled = mesh.with_arrays()
    doubled.vertex_normals = 2 * mesh.vertex_normals
    np.testing.assert_allclose(doubled.normalize_normals().vertex_normals, mesh.vertex_normals, atol=1e-7)
    top = mesh.select_faces_by_mask(mesh.compute_triangle_normals()[:, 2] > 0.5)
    assert top.vertices[:, 2].tolist() == [1] * 4 and len(top.triangle_attributes["b"]) == 2


def open3d_isosurfaces(o3d, volume):
    peer = o3d.t.geometry.TriangleMesh.create_isosurfaces(volume, [0, 0.2])
    return tuple(peer.vertex.positions.shape), peer.get_min_bound().numpy()


def test_isosurfaces_match_open3d(oracle):
    grid = np.stack(np.meshgrid(*(np.linspace(-1, 1, n) for n in (12, 14, 16)), indexing="ij"), -1)
    volume = (0.7 - np.linalg.norm(grid, axis=-1)).astype(np.float32)
    result = TriangleMesh.create_isosurfaces(volume, [0, 0.2])
    shape, lowest = oracle("meshing/joining/isosurfaces", open3d_isosurfaces, volume)
    assert result.vertices.shape == shape
    np.testing.assert_allclose(result.get_min_bound(), lowest, atol=1e-5)
    assert result.get_volume() > 0  # it faces the lower field values, as in Open3D


@settings(max_examples=25, deadline=None)
@given(
    way=st.tuples(*[st.integers(-3, 3)] * 2, st.sampled_from([-2, -1, 1, 2])),
    is_reversed=st.booleans(),
    is_far=st.booleans(),
)
def test_a_prism_is_closed_and_has_its_volume(way, is_reversed, is_far):
    outline = np.array([[0, 0], [4, 0], [4, 4], [2, 1], [0, 4]])
    base = TriangleMesh.from_polygon(outline[::-1] if is_reversed else outline, [[[1, 0.5], [2, 0.5], [1.5, 0.75]]])
    base = base.translate(FAR) if is_far else base
    prism = base.extrude_linear(way)
    assert prism.is_watertight()
    assert prism.get_volume() == pytest.approx(base.get_surface_area() * abs(way[2]), rel=1e-6)
    assert signed_volume(prism) > 0


def test_a_spring_matches_open3ds_example():
    spring = TriangleMesh(*TRIANGLE).extrude_rotation(3 * 360, [0, 1, 0], resolution=3 * 16, translation=2)
    assert (len(spring.vertices), len(spring)) == (147, 290) and spring.is_watertight()
    steps = np.linspace(0, 1, 49)[:, None] * [0.0, 1.0, 0.0]
    rings = [Rotation.from_rotvec(6 * np.pi * step).apply(TRIANGLE[0]) + 2 * step for step in steps]
    np.testing.assert_allclose(spring.vertices, np.concatenate(rings), atol=1e-6)


@pytest.mark.parametrize("angle", [360, -360, 90, -90])
def test_a_half_disc_revolves_into_a_ball(angle):
    corners = [[np.cos(a), np.sin(a)] for a in np.linspace(-np.pi / 2, np.pi / 2, 33)]
    half = TriangleMesh.from_polygon(corners).rotate([[1, 0, 0], [0, 0, -1], [0, 1, 0]])
    ball = half.extrude_rotation(angle, [0, 0, 1], resolution=abs(angle) // 5)
    assert ball.is_watertight() and ball.get_volume() == pytest.approx(4 / 3 * np.pi * abs(angle) / 360, rel=0.01)


def test_sweeps_copy_colors_and_attributes(device):
    plane = TriangleMesh.create_plane(device=device).paint_uniform_color([0, 1, 0]).compute_vertex_normals()
    plane.vertex_attributes["a"], plane.triangle_attributes["b"] = np.arange(4), np.array([7, 8])
    block = plane.extrude_linear([0, 0, 1])
    assert block.vertex_attributes["a"].tolist() == [0, 1, 2, 3] * 2 and block.vertex_colors.tolist() == [[0, 1, 0]] * 8
    assert sorted(block.triangle_attributes["b"].tolist()) == [7] * 6 + [8] * 6
    assert block.vertex_normals[0].tolist() == pytest.approx([-(3**-0.5)] * 3, abs=0.3)
    assert len(plane.extrude_linear([0, 0, 1], capping=False)) == 8


def test_profiles_revolve_about_the_axis():
    drum = TriangleMesh.revolve([[0, 0], [1, 0], [1, 2], [0, 2]], resolution=256)
    assert drum.get_volume() == pytest.approx(2 * np.pi, rel=1e-3)
    ring = TriangleMesh.revolve([[2, 0], [3, 0], [3, 1], [2, 1], [2, 0]], resolution=256)
    assert ring.get_volume() == pytest.approx(5 * np.pi, rel=1e-3) and ring.euler_poincare_characteristic() == 0
    assert len(TriangleMesh.revolve([[1, 0], [1, 1]], 90, 4).get_boundary_edges()) == 10


def test_triangulations_use_exactly_the_polygon_corners():
    outline = [[0, 0], [1, 0], [2, 0], [3, 0], [3, 3], [0, 3], [0, 0]]  # collinear corners, the first one repeated
    holes = [[[1, 1], [2, 1], [2, 2], [1, 2]], [[1, 2], [0.5, 2.5], [1, 2.5]]]  # two that touch
    mesh = TriangleMesh.from_polygon(outline, holes)
    assert len(mesh.vertices) == 13 and mesh.get_surface_area() == pytest.approx(8 - 0.125)
    assert set(mesh.triangles.ravel().tolist()) == set(range(13))
    assert len(mesh.get_boundary_edges()) == 13 and (mesh.compute_triangle_normals()[:, 2] > 0).all()
    tilted = TriangleMesh.from_polygon(np.array([[0, 0, 0], [0, 1, 1], [0, 1, 0]]) + FAR)
    assert tilted.compute_triangle_normals()[0].tolist() == pytest.approx([-1, 0, 0], abs=1e-6)


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
    answers = oracle("meshing/shapes/arrays", open3d_shapes)
    for (name, options), (vertices, triangles) in zip(SHAPES + PLAIN, answers, strict=True):
        result = getattr(TriangleMesh, f"create_{name}")(**options, device=device)
        # vertices are float32, and numpy's sine may differ in the last bit of float64
        np.testing.assert_allclose(result.vertices, vertices, rtol=1e-6, atol=1e-7, err_msg=f"{name} {options}")
        np.testing.assert_array_equal(result.triangles, triangles)
        assert result.triangle_uvs is None and result.device == TriangleMesh(device=device).device


def test_an_arrow_has_the_rings_of_its_shaft_and_head(device):
    arrow = TriangleMesh.create_arrow(0.5, 1.5, cylinder_height=3, cone_height=2, resolution=8, cylinder_split=3,
                                      cone_split=4, device=device)  # fmt: skip
    heights = np.round(arrow.vertices[:, 2], 5)
    radii = {z: np.hypot(*arrow.vertices[heights == z, :2].T).max() for z in np.unique(heights)}
    head = {3 + z: 1.5 * (1 - z / 2) for z in (0, 0.5, 1, 1.5, 2)}
    assert radii == pytest.approx({0: 0.5, 1: 0.5, 2: 0.5} | head, abs=1e-6)
    assert len(arrow.vertices) == 8 * (3 + 1 + 4) + 4 and len(arrow) == 8 * 2 * (3 + 1 + 4)


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


@pytest.mark.parametrize("create", [
    TriangleMesh.create_box, TriangleMesh.create_plane, TriangleMesh.create_tetrahedron, TriangleMesh.create_octahedron,
    TriangleMesh.create_icosahedron, TriangleMesh.create_sphere, TriangleMesh.create_ellipsoid,
    TriangleMesh.create_cylinder, TriangleMesh.create_cone,
])  # fmt: skip
def test_texture_coordinates_are_inside_of_the_image_and_created_on_request(create, device):
    sizes = {"radius_x": 1, "radius_y": 2, "radius_z": 3} if create == TriangleMesh.create_ellipsoid else {}
    mesh = create(**sizes, create_uv_map=True, device=device)
    uvs = mesh.triangle_uvs
    assert uvs.shape == (3 * len(mesh), 2) and uvs.min() >= -1e-6 and uvs.max() <= 1 + 1e-6
    x, y = np.moveaxis(uvs.reshape(-1, 3, 2).astype(float), 2, 0)
    areas = np.abs((x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])) / 2
    assert areas.sum() > 0.1 and areas.min() > 1e-6  # no triangle is a line in the image
    assert create(**sizes, device=device).triangle_uvs is None


def test_a_cone_is_seen_from_below_and_above_in_its_image():
    """Two discs of the radius 1/4: the bottom around (0.5, 0.25), the mantle from above around (0.5, 0.75)."""
    cone = TriangleMesh.create_cone(2.0, 3.0, 12, 3, create_uv_map=True)
    corners, uvs = cone.vertices[cone.triangles], cone.triangle_uvs.reshape(-1, 3, 2)
    is_bottom = (corners[:, :, 2] == 0).all(axis=1)
    assert is_bottom.sum() == 12
    middle = np.where(is_bottom, 0.25, 0.75)[:, None]
    np.testing.assert_allclose(
        uvs, np.stack([0.5 + corners[..., 0] / 8, middle + corners[..., 1] / 8], axis=2), atol=1e-6
    )


def open3d_frame(o3d):
    peer = o3d.geometry.TriangleMesh.create_coordinate_frame(2)
    return np.array(peer.vertex_normals, np.float32)[::7], np.array(peer.vertex_colors, np.float32)[::7]


def test_a_coordinate_frame_has_the_normals_and_colors_of_open3d(device, oracle):
    result = TriangleMesh.create_coordinate_frame(2, device=device)
    normals, colors = oracle("meshing/shapes/coordinate_frame", open3d_frame)
    np.testing.assert_allclose(result.vertex_normals[::7], normals, atol=1e-6)
    np.testing.assert_array_equal(result.vertex_colors[::7], colors)


def test_a_plane_shows_the_full_image():
    mesh = TriangleMesh.create_plane(2, 3, create_uv_map=True)
    np.testing.assert_array_equal(mesh.triangle_uvs * [2, 3], mesh.vertices[mesh.triangles.reshape(-1), :2])
    np.testing.assert_array_equal(mesh.compute_triangle_normals(), [[0, 0, 1]] * 2)


def test_a_sum_names_the_arrays_that_some_meshes_lack(device):
    one, other = (TriangleMesh.create_box(device=device).compute_vertex_normals() for _ in range(2))
    one.vertex_colors = np.zeros((8, 3))
    one.vertex_attributes["heat"], other.triangle_attributes["part"] = np.zeros(8), np.zeros(12)
    for pair in ([one, other], [other, one]):
        with pytest.warns(UserWarning, match="vertex_colors, heat and part are dropped, because not") as told:
            both = TriangleMesh.concatenate(pair)
        assert len(told) == 1 and both.has_vertex_normals and not both.vertex_attributes and not both.has_vertex_colors


def test_vertices_without_triangles_keep_the_attributes_of_triangles():
    mesh = TriangleMesh.create_box()
    mesh.triangle_attributes["part"] = np.arange(12)
    assert (mesh + TriangleMesh([[5, 5, 5]])).triangle_attributes["part"].tolist() == [*range(12)]
