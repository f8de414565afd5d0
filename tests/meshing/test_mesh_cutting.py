"""Cuts of meshes by planes and at levels of vertex values: closed parts stay closed, agreement with brute force."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import LineSet, TriangleMesh
from pointloom.kernels.lang import cpu_compiler

from .open3d_meshes import tensor_mesh
from .poisson_scenes import edges_by_use, poisson, sphere

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


@pytest.mark.parametrize("method", ["clip_plane", "slice_plane"])
def test_the_warning_of_an_open_mesh_refers_to_the_line_of_the_user(method):
    box = TriangleMesh.create_box()
    opened = TriangleMesh(box.vertices, box.triangles[1:])
    with pytest.warns(UserWarning, match="1 outlines are not closed") as caught:
        getattr(opened, method)([0.5, 0.5, 0.5], [0.3, 0.2, 1], cap=True)
    assert [each.filename for each in caught] == [__file__]


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


def grid(size: int, device=None, **arrays) -> TriangleMesh:
    """The square from 0 to `size`, two triangles per unit; vertex (x, y) has index x (size + 1) + y."""
    positions = np.stack(np.meshgrid(np.arange(size + 1), np.arange(size + 1), indexing="ij"), axis=-1).reshape(-1, 2)
    corner = (positions[:, 0] * (size + 1) + positions[:, 1])[(positions < size).all(axis=1)]
    right, up = corner + size + 1, corner + 1
    triangles = np.concatenate([np.stack([corner, right, up], axis=1), np.stack([right, right + 1, up], axis=1)])
    vertices = np.concatenate([positions, np.zeros((len(positions), 1))], axis=1)
    return TriangleMesh(vertices, triangles, device=device, **arrays)


def clip(corners, values, level):
    """The polygon of a triangle above the level, float64 [k, d], by Sutherland and Hodgman."""
    clipped = []
    for p, q, a, b in zip(corners, np.roll(corners, -1, axis=0), values, np.roll(values, -1), strict=True):
        if a >= level:
            clipped.append(p)
        if (a > level > b) or (a < level < b):
            clipped.append(p + (q - p) * (level - a) / (b - a))
    return np.array(clipped).reshape(-1, corners.shape[1])


def signed_areas(vertices, triangles):
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    return ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2


@pytest.mark.parametrize("values", list(itertools.product([0.0, 1.0, 3.0], repeat=3)))
def test_one_triangle_is_clipped_as_a_polygon(device, values):
    corners = np.array([[0, 0, 0], [4.0, 0, 0], [1, 8, 0]])
    mesh = TriangleMesh(corners, [[0, 1, 2]], device=device)
    left = mesh.trim(values, 1.0, island_ratio=0)
    polygon = clip(corners, values, 1.0)
    x, y = polygon[:, :2].T
    area = (x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2
    areas = signed_areas(left.vertices, left.triangles)
    assert (areas > 0).all() and abs(areas.sum() - area) < 1e-6
    if area > 0:
        assert {tuple(np.float32(p)) for p in polygon} == {tuple(np.float32(p)) for p in left.vertices}


def test_a_cut_ball_matches_brute_force(device):
    mesh, _ = poisson(sphere(600), depth=4, device=device)
    vertices, triangles = mesh.arrays["vertices"].numpy().astype(float), mesh.triangles
    values = np.random.default_rng(0).normal(size=len(vertices)) + vertices[:, 2]
    left = mesh.trim(values, 0.25, island_ratio=0)
    polygons = (clip(vertices[t], values[t], 0.25) for t in triangles)
    sides = ((p[i] - p[0], p[i + 1] - p[0]) for p in polygons for i in range(1, len(p) - 1))
    wanted = sum(np.linalg.norm(np.cross(a, b)) / 2 for a, b in sides)
    assert abs(left.get_surface_area() / wanted - 1) < 1e-6
    edges = np.unique(np.sort(triangles[:, [0, 1, 1, 2, 0, 2]].reshape(-1, 2), axis=1), axis=0)
    a, b = edges.T
    cut = (values[a] - 0.25) * (values[b] - 0.25) < 0
    a, b = a[cut], b[cut]
    fraction = ((0.25 - values[a]) / (values[b] - values[a]))[:, None]
    positions = np.float32(vertices[a] * (1 - fraction) + vertices[b] * fraction)
    remaining = np.unique(triangles[(values[triangles] > 0.25).any(axis=1)])
    remaining = remaining[values[remaining] >= 0.25]
    wanted = np.concatenate([np.float32(vertices[remaining]), positions])
    np.testing.assert_array_equal(left.vertices, np.float64(wanted))
    normals = mesh.vertex_normals.astype(float)
    between = normals[a] * (1 - fraction) + normals[b] * fraction
    between /= np.linalg.norm(between, axis=1, keepdims=True)
    np.testing.assert_allclose(left.vertex_normals, np.concatenate([normals[remaining], between]), atol=1e-7)


def test_colors_are_interpolated_along_the_edge(device):
    mesh = TriangleMesh([[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 1, 2]], vertex_colors=np.eye(3), device=device)
    left = mesh.trim([0, 4, 0], 1)
    np.testing.assert_array_equal(left.vertex_colors, np.float32([[0, 1, 0], [0.75, 0.25, 0], [0, 0.25, 0.75]]))
    assert left.vertex_normals is None


def test_a_level_out_of_range_keeps_all_or_nothing(device):
    mesh = grid(4, device)
    values = np.arange(25.0)
    for level in (-1, 0):
        left = mesh.trim(values, level)
        np.testing.assert_array_equal(left.triangles, mesh.triangles)
        np.testing.assert_array_equal(left.vertices, mesh.vertices)
    left = mesh.trim(values, 24.5)
    assert len(left) == 0 and len(left.vertices) == 0
    assert len(TriangleMesh(device=device).trim([], 0)) == 0


def dots(size, *cells, inside=1.0):
    """Values 1 at some vertices of a grid and 0 elsewhere (or the other way round)."""
    values = np.full((size + 1, size + 1), 1.0 - inside)
    for cell in cells:
        values[cell] = inside
    return values.ravel()


def area_of(mesh, values, level=0.5, **options):
    return mesh.trim(values, level, **options).get_surface_area()


DOT = 6 * 0.5**3  # six triangles around a vertex, each cut halfway


def test_holes_below_the_ratio_are_preserved(device):
    mesh = grid(10, device)
    values = dots(10, (2, 2), inside=0.0)
    assert abs(area_of(mesh, values, island_ratio=0) - (100 - DOT)) < 1e-4
    assert abs(area_of(mesh, values, island_ratio=0.0074) - (100 - DOT)) < 1e-4
    left = mesh.trim(values, 0.5, island_ratio=0.0076)
    assert abs(left.get_surface_area() - 100) < 1e-4
    _, counts, _ = edges_by_use(left.triangles)
    assert counts.max() == 2 and (counts == 1).sum() == 40  # the square's boundary alone: no crack along the hole


def test_an_isolated_part_below_the_level_is_removed(device):
    mesh = grid(10, device)
    ball, _ = poisson(sphere(200), depth=3, device=device)
    vertices = np.concatenate([mesh.vertices, ball.vertices * 0.1 + 50])
    both = TriangleMesh(vertices, np.concatenate([mesh.triangles, ball.triangles + 121]), device=device)
    values = np.concatenate([np.ones(121), np.zeros(len(ball.vertices))])
    assert abs(both.trim(values, 0.5, island_ratio=0.1).get_surface_area() - 100) < 1e-4


def parts_of(triangles, chosen):
    """Edge-connected components of chosen triangles, by flood fill."""
    at = {}
    for i in np.flatnonzero(chosen):
        for k in range(3):
            at.setdefault(frozenset((triangles[i][k], triangles[i][(k + 1) % 3])), []).append(i)
    left, parts = set(np.flatnonzero(chosen)), []
    while left:
        front, part = [left.pop()], set()
        while front:
            i = front.pop()
            part.add(i)
            for k in range(3):
                for j in at[frozenset((triangles[i][k], triangles[i][(k + 1) % 3]))]:
                    if j in left:
                        left.remove(j)
                        front.append(j)
        parts.append(part)
    return parts


@settings(deadline=None, max_examples=40)
@given(st.integers(0, 10**6), st.sampled_from([0.0, 0.01, 0.05, 0.2]), st.floats(0.1, 0.9))
def test_islands_and_holes_match_flood_fill(seed, ratio, fraction):
    """Values of 0 and 1, so that every cut is in the middle of an edge."""
    rng = np.random.default_rng(seed)
    mesh = grid(8)
    corners = mesh.triangles[rng.permutation(128)[:120]]  # some missing: an inner boundary
    wanted = rng.random(len(corners)) < fraction
    vertices = mesh.vertices[corners].reshape(-1, 3)  # a value per corner: separate triangles, then one mesh
    values = np.repeat(wanted, 3) * 2.0 - 1
    levels = np.zeros(81)
    levels[corners[wanted].ravel()] = 1.0
    with cpu_compiler("warp"):
        joined = TriangleMesh(mesh.vertices, corners)
        split = joined.trim(levels, 0.5, island_ratio=0)
        left = joined.trim(levels, 0.5, island_ratio=ratio)
        apart = TriangleMesh(vertices, np.arange(360).reshape(-1, 3)).trim(values, 0.0, island_ratio=0)
    assert abs(apart.get_surface_area() - wanted.sum() / 2) < 1e-4
    pieces, above, positions = pieces_of(mesh.vertices, corners, levels)
    areas, total = np.abs(signed_areas(positions, pieces)), len(corners) / 2
    assert abs(areas[above].sum() - split.get_surface_area()) < 1e-4
    for part in parts_of(pieces, above):
        if areas[list(part)].sum() < ratio * total - 1e-9:
            above[list(part)] = False
    uses = {}
    for i, t in enumerate(pieces):
        for k in range(3):
            uses.setdefault(frozenset((t[k], t[(k + 1) % 3])), []).append(i)
    selected = above.copy()
    for part in parts_of(pieces, ~above):
        around = [uses[frozenset((pieces[i][k], pieces[i][(k + 1) % 3]))] for i in part for k in range(3)]
        enclosed = all(len(at) > 1 for at in around) and any(above[j] for at in around for j in at)
        if enclosed and areas[list(part)].sum() < ratio * total - 1e-9:
            selected[list(part)] = True
    assert abs(left.get_surface_area() - areas[selected].sum()) < 1e-4


def pieces_of(vertices, triangles, values):
    """(triangles, above, positions) of a mesh whose edges between 0 and 1 are split by hand."""
    positions, numbers, pieces, above = list(vertices), {}, [], []

    def middle(a, b):
        key = frozenset((a, b))
        if key not in numbers:
            numbers[key] = len(positions)
            positions.append((vertices[a] + vertices[b]) / 2)
        return numbers[key]

    for t in triangles:
        high = values[t] > 0.5
        if high.all() or not high.any():
            pieces.append(tuple(t))
            above.append(bool(high.all()))
            continue
        lone = int(np.flatnonzero(high == (high.sum() == 1))[0])
        a, b, c = t[lone], t[(lone + 1) % 3], t[(lone + 2) % 3]
        p, q = middle(a, b), middle(a, c)
        pieces += [(a, p, q), (p, b, c), (p, c, q)]
        above += [bool(high[lone])] + [not high[lone]] * 2
    return np.array(pieces), np.array(above), np.array(positions)


def test_huge_values_are_cut_correctly(device):
    mesh = TriangleMesh([[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 1, 2]], device=device)
    np.testing.assert_array_equal(mesh.trim([-1e100, 1e100, -1e100], 0).vertices, [[4, 0, 0], [2, 0, 0], [2, 2, 0]])
