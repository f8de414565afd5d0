"""Plane cuts of meshes: closed parts remain closed, both parts fit, and sections lie in the plane."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import LineSet, TriangleMesh

from .open3d_meshes import tensor_mesh

FAR = np.array([5.0e5, 5.4e6, 100.0])
SHAPES = {
    "box": TriangleMesh.create_box(),
    "ball": TriangleMesh.create_sphere(1.0, 8),
    "torus": TriangleMesh.create_torus(1.0, 0.4, 12, 8),
    "cone": TriangleMesh.create_cone(),
}


def hollow(cavity_flipped: bool = True) -> TriangleMesh:
    outer, inner = TriangleMesh.create_sphere(1.0, 10), TriangleMesh.create_sphere(0.5, 10)
    inside = inner.triangles[:, ::-1] if cavity_flipped else inner.triangles
    return TriangleMesh(np.r_[outer.vertices, inner.vertices], np.r_[outer.triangles, inside + len(outer.vertices)])


def textured_box(device=None) -> TriangleMesh:
    box = TriangleMesh.create_box(create_uv_map=True, device=device).compute_vertex_normals()
    box.vertex_colors = box.vertices
    box.triangle_material_ids = np.arange(12) // 2
    box.textures = [np.zeros((4, 4, 3), np.uint8)] * 6
    box.vertex_attributes["place"] = box.vertices
    box.triangle_attributes["row"] = np.arange(12)
    return box


POINT, NORMAL = np.array([0.1, 0.2, 0.3]), np.array([0.3, -0.5, 0.7])


def open3d_cuts(o3d):
    """Areas and bounds of clipped shapes; counts and lengths of the lines of slices."""
    clips = {name: tensor_mesh(o3d, mesh).clip_plane(POINT, NORMAL).to_legacy() for name, mesh in SHAPES.items()}
    box, ball = (tensor_mesh(o3d, SHAPES[name]) for name in ("box", "ball"))
    slices = [box.slice_plane([0, 0.5, 0], [1, 1, 1]), ball.slice_plane([0, 0, 0], [0, 0, 1], [-0.4, 0.05, 0.5])]
    ends = [peer.point.positions.numpy()[peer.line.indices.numpy()] for peer in slices]
    return (
        {name: [peer.get_surface_area(), peer.get_min_bound(), peer.get_max_bound()] for name, peer in clips.items()},
        [(len(pairs), float(np.linalg.norm(pairs[:, 1] - pairs[:, 0], axis=1).sum())) for pairs in ends],
    )


def test_clips_and_slices_match_open3d(device, oracle):
    clips, slices = oracle("meshing/cutting/planes", open3d_cuts)
    for name, (area, low, high) in clips.items():
        clipped = SHAPES[name].to(device).clip_plane(POINT, NORMAL)
        assert clipped.get_surface_area() == pytest.approx(area, rel=1e-5)
        np.testing.assert_allclose([*clipped.get_axis_aligned_bounding_box()], [low, high], atol=1e-6)
    result = SHAPES["box"].slice_plane([0, 0.5, 0], [1, 1, 1])
    several = SHAPES["ball"].slice_plane([0, 0, 0], [0, 0, 1], [-0.4, 0.05, 0.5])
    assert len(result) == slices[0][0] and lengths(result).sum() == pytest.approx(slices[0][1], rel=1e-6)
    assert lengths(several).sum() == pytest.approx(slices[1][1], rel=1e-5)


def lengths(lines: LineSet):
    ends = lines.points[lines.lines]
    return np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)


@settings(max_examples=25, deadline=None)
@given(
    name=st.sampled_from(sorted(SHAPES)),
    point=st.tuples(*[st.sampled_from([-0.5, 0.0, 0.1, 0.25, 0.5, 1.0])] * 3),
    normal=st.tuples(*[st.integers(-2, 2)] * 3).filter(any),
    is_far=st.booleans(),
)
def test_capped_parts_are_closed_and_fill_the_volume(name, point, normal, is_far):
    mesh, position = SHAPES[name], np.array(point)
    if is_far:
        mesh, position = mesh.translate(FAR), position + FAR
    parts = [mesh.clip_plane(position, way, cap=True) for way in (normal, np.negative(normal))]
    assert all(half.is_watertight() for half in parts if len(half))
    volumes = [half.get_volume() for half in parts if len(half)]
    assert sum(volumes) == pytest.approx(mesh.get_volume(), rel=1e-5)
    for half, way in zip(parts, (1, -1), strict=True):
        heights = (half.vertices - position) @ np.array(normal) * way
        assert (heights > -3e-6).all()


@pytest.mark.parametrize("normal", [[0, 0, 1], [0, 0, -1]])
def test_a_face_in_the_plane_belongs_to_the_adjacent_body(device, normal):
    box = textured_box(device)
    below, above = ([0, 0, 0], [0, 0, 1]) if normal[2] > 0 else ([0, 0, 1], [0, 0, 0])
    complete, nothing = box.clip_plane(below, normal, cap=True), box.clip_plane(above, normal, cap=True)
    assert len(nothing) == 0 and len(box.clip_plane(above, normal)) == 2  # without a cap, triangles in the plane stay
    np.testing.assert_array_equal(complete.triangle_attributes["row"], np.arange(12))  # and no new cap is added


def test_cavities_are_preserved():
    plane = ([0.0, 0.0, 0.1], [0.0, 0.2, 1.0])
    parts = [hollow().clip_plane(plane[0], np.multiply(plane[1], way), cap=True) for way in (1, -1)]
    assert all(half.is_watertight() for half in parts)
    assert sum(half.get_volume() for half in parts) == pytest.approx(hollow().get_volume(), rel=1e-6)
    assert [len(loop) > 8 for loop in hollow().section_loops(*plane)] == [True, True]


def test_inconsistent_triangles_are_capped_by_parity():
    mesh = hollow(cavity_flipped=False)
    corners = mesh.triangles.copy()
    corners[::3] = corners[::3, ::-1]
    rough = TriangleMesh(mesh.vertices, corners).clip_plane([0, 0, 0.1], [0, 0, 1], cap=True)
    topology = rough.edge_topology()
    assert not topology.has_boundary and not topology.has_crowded_edge
    reference = hollow().clip_plane([0, 0, 0.1], [0, 0, 1], cap=True)
    assert rough.get_surface_area() == pytest.approx(reference.get_surface_area(), rel=1e-6)  # a ring, and no disc


def test_an_open_mesh_is_cut_without_a_cap():
    ball = TriangleMesh.create_sphere(1.0, 8)
    bowl = ball.remove_triangles_by_mask(ball.vertices[ball.triangles].mean(axis=1)[:, 0] > 0.3)
    with pytest.warns(UserWarning, match=r"^cap:.*1"):
        half = bowl.clip_plane([0, 0, 0.1], [0, 0, 1], cap=True)
    assert len(half) == len(bowl.clip_plane([0, 0, 0.1], [0, 0, 1]))
    [path] = bowl.section_loops([0, 0, 0.1], [0, 0, 1])
    assert not (path[0] == path[-1]).all()


def test_outlines_that_touch_at_a_vertex_are_two_loops():
    corners = [[0, 0], [1, 1], [0, 1], [-1, -1], [0, -1]]
    columns = np.array([[x, y, z] for z in (-1, 1) for x, y in corners], float)
    walls = [(a, b, b + 5, a + 5) for a, b in ((0, 1), (1, 2), (2, 0), (0, 3), (3, 4), (4, 0))]
    mesh = TriangleMesh(columns, [t for a, b, c, d in walls for t in ((a, b, c), (a, c, d))])
    loops = mesh.section_loops([0, 0, 0], [0, 0, 1])
    assert len(loops) == 2 and all((loop[0] == loop[-1]).all() for loop in loops)
    areas = [np.cross(loop[:-1], loop[1:]).sum(axis=0)[2] / 2 for loop in loops]
    np.testing.assert_allclose(areas, [0.5, 0.5], atol=1e-6)


def test_a_cut_interpolates_all_attributes(device):
    box = textured_box(device)
    half = box.clip_plane([0.25, 0, 0], [1, 0, 0], cap=True)
    np.testing.assert_allclose(half.vertex_attributes["place"], half.vertices, atol=1e-6)
    np.testing.assert_allclose(half.vertex_colors, half.vertices, atol=1e-6)
    np.testing.assert_allclose(np.linalg.norm(half.vertex_normals, axis=1), 1, atol=1e-6)
    np.testing.assert_array_equal(half.triangle_material_ids, half.triangle_attributes["row"] // 2)
    walls = np.abs((half.vertices[half.triangles] - 0.25)[:, :, 0]).max(axis=1) > 1e-6
    # On a wall the texture is the same linear function of position as before.
    for row in np.unique(half.triangle_attributes["row"][walls]):
        own = walls & (half.triangle_attributes["row"] == row)
        system = np.c_[box.vertices[box.triangles[row]], np.ones(3)]
        coefficients, *_ = np.linalg.lstsq(system, box.triangle_uvs[3 * row : 3 * row + 3], rcond=None)
        homogeneous = np.concatenate([np.c_[half.vertices[t], np.ones(3)] for t in half.triangles[own]])
        uvs = half.triangle_uvs.reshape(-1, 3, 2)[own].reshape(-1, 2)
        np.testing.assert_allclose(homogeneous @ coefficients, uvs, atol=1e-6)


def test_empty_and_degenerate_cuts_are_handled(device):
    for corners in ([], [[0, 1, 2]], [[0, 0, 1]], [[0, 1, 2], [0, 1, 2], [1, 0, 2]]):
        mesh = TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 0, 1], [np.nan] * 3], corners, device=device)
        for cap in (False, True) if not corners else (False,):
            assert len(mesh.clip_plane([0.25, 0, 0], [1, 0, 0], cap=cap)) <= 2 * len(corners)
        assert len(mesh.slice_plane([0.25, 0, 0], [1, 0, 0])) == (len(corners) > 0 and 2 in corners[0])
    lost = TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 0, np.nan]], [[0, 1, 2]], device=device)
    assert len(lost.clip_plane([0, 0, 0], [0, 0, 1])) == 0


def test_slice_plane_with_a_cap_is_the_clipped_mesh():
    box = TriangleMesh.create_box()
    sliced, clipped = (getattr(box, name)([0.5, 0, 0], [1, 0, 0], cap=True) for name in ("slice_plane", "clip_plane"))
    np.testing.assert_array_equal(sliced.triangles, clipped.triangles)
