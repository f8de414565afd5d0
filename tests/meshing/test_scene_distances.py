"""Distances, signs and metrics of surfaces, and intersections of triangles: Open3D's, or brute force."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

import pointloom as loom
from pointloom import RaycastingScene, TriangleMesh

from .mesh_soups import surface
from .open3d_meshes import in_open3d, raycasting_scene
from .surface_oracles import distances_to_triangles, meeting_pairs, winding_numbers

CUBE = (
    [[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)],
    [
        [0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
        [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5],
    ],
)  # fmt: skip
INVALID = 0xFFFFFFFF
FAR = np.array([5.0e5, 5.4e6, 100.0])


def torus(rings: int = 24, sides: int = 12) -> tuple[np.ndarray, np.ndarray]:
    a, b = np.meshgrid(np.arange(rings), np.arange(sides), indexing="ij")
    u, v = 2 * np.pi * a.ravel() / rings, 2 * np.pi * b.ravel() / sides
    r = 1 + 0.4 * np.cos(v)
    points = np.column_stack([r * np.cos(u), r * np.sin(u), 0.4 * np.sin(v)])

    def at(i, j):
        return (i % rings * sides + j % sides).ravel()

    one = np.column_stack([at(a, b), at(a + 1, b), at(a + 1, b + 1)])
    return points, np.vstack([one, np.column_stack([at(a, b), at(a + 1, b + 1), at(a, b + 1)])])


def scene_of(*meshes, device=None) -> RaycastingScene:
    scene = RaycastingScene(device)
    for vertices, triangles in meshes:
        scene.add_triangles(TriangleMesh(vertices, triangles, device=device))
    return scene


def somewhere(n=400, seed=0, size=2.0) -> np.ndarray:
    return ((np.random.default_rng(seed).random((n, 3)) * 2 - 1) * size).astype(np.float32)


def corners_of(vertices, triangles) -> np.ndarray:
    return np.asarray(vertices, np.float32).astype(np.float64)[np.asarray(triangles)]


def open3d_distances(o3d, mesh, queries):
    scene, queries = raycasting_scene(o3d, mesh), o3d.core.Tensor(queries)
    closest = {name: values.numpy() for name, values in scene.compute_closest_points(queries).items()}
    measures = (scene.compute_distance, scene.compute_signed_distance, scene.compute_occupancy)
    return closest, [measure(queries).numpy() for measure in measures]


def test_closest_points_and_distances_match_open3d(device, oracle):
    mesh, queries = torus(), somewhere().reshape(4, 100, 3)
    scene = scene_of(mesh, device=device)
    result = scene.compute_closest_points(queries)
    theirs, measures = oracle("meshing/distances/torus", open3d_distances, mesh, queries)
    assert list(result) == ["points", "geometry_ids", "primitive_ids", "primitive_uvs", "primitive_normals"]
    same = result["primitive_ids"] == theirs["primitive_ids"]  # at edges and corners another triangle is possible
    assert same.mean() > 0.5
    for name, values in theirs.items():
        assert result[name].shape == values.shape and result[name].dtype == values.dtype
        np.testing.assert_allclose(result[name][same], values[same], atol=2e-3)  # float32 all through, in Open3D
    np.testing.assert_allclose(scene.compute_distance(queries), measures[0], atol=1e-5)  # Open3D's float32
    np.testing.assert_allclose(scene.compute_signed_distance(queries), measures[1], atol=1e-5)
    np.testing.assert_array_equal(scene.compute_occupancy(queries), measures[2])


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_closest_points_are_exact_at_all_scales(device, scale):
    vertices, triangles = np.array(torus()[0]) * scale, torus()[1]
    queries = (somewhere(300, 1) * np.float32(scale)).astype(np.float32)
    corners = corners_of(vertices, triangles)
    truth = distances_to_triangles(queries, corners)
    scene = RaycastingScene(device)
    scene.add_triangles(TriangleMesh(vertices, triangles, device=device, origin=[0, 0, 0]))
    result = scene.compute_closest_points(queries)
    chosen = truth[np.arange(len(queries)), result["primitive_ids"]]
    np.testing.assert_allclose(chosen, truth.min(1), rtol=1e-12)  # the oracle's own rounding
    u, v = result["primitive_uvs"].astype(np.float64).T
    picked = corners[result["primitive_ids"]]
    there = picked[:, 0] + u[:, None] * (picked[:, 1] - picked[:, 0]) + v[:, None] * (picked[:, 2] - picked[:, 0])
    np.testing.assert_allclose(result["points"], there, atol=1e-6 * scale)  # both rounded to float32
    np.testing.assert_allclose(scene.compute_distance(queries), truth.min(1), rtol=1e-6, atol=1e-9 * scale)


def test_of_equally_near_triangles_the_first_is_returned(device):
    vertices, triangles = np.array(CUBE[0]), np.array(CUBE[1])
    queries = [[-1, -1, -1], [2, 2, 2], [0.5, -1, 0], [-1, 0.5, 0]]  # two corners, two edges
    for seed in range(4):
        order = np.random.default_rng(seed).permutation(12)
        result = scene_of((vertices, triangles[order]), device=device).compute_closest_points(queries)
        at = distances_to_triangles(np.array(queries), corners_of(vertices, triangles[order]))
        assert result["primitive_ids"].tolist() == at.argmin(1).tolist()
    twice = scene_of((vertices, triangles), (vertices, triangles), device=device)
    assert not twice.compute_closest_points(queries)["geometry_ids"].any()


SMALL = st.integers(-3, 3)


@settings(deadline=None, max_examples=20)
@given(
    vertices=st.lists(st.tuples(SMALL, SMALL, SMALL), min_size=4, max_size=9),
    picks=st.lists(st.tuples(*[st.integers(0, 8)] * 3), min_size=1, max_size=12),
    queries=st.lists(st.tuples(SMALL, SMALL, SMALL), min_size=1, max_size=6),
)
def test_nearest_triangles_of_any_shape_are_returned(vertices, picks, queries):
    triangles = np.array(picks) % len(vertices)  # flat ones, points, and some twice
    truth = distances_to_triangles(np.array(queries), corners_of(vertices, triangles))
    scene = scene_of((vertices, triangles))
    np.testing.assert_allclose(scene.compute_distance(queries), truth.min(1), rtol=1e-6, atol=1e-7)
    ids = scene.compute_closest_points(queries)["primitive_ids"]
    chosen = truth[np.arange(len(queries)), ids]
    np.testing.assert_allclose(chosen, truth.min(1), atol=1e-12)


def test_nearly_coincident_sheets_are_distinguished(device):
    rng = np.random.default_rng(12)
    corners = (rng.random((3, 3)) + rng.normal(size=(64, 3, 3)) * 2e-7).astype(np.float32)
    queries = somewhere(200, 13, 3.0)
    truth = distances_to_triangles(queries, corners)
    scene = scene_of((corners.reshape(-1, 3), np.arange(192).reshape(-1, 3)), device=device)
    chosen = truth[np.arange(200), scene.compute_closest_points(queries)["primitive_ids"]]
    np.testing.assert_allclose(chosen, truth.min(1), rtol=1e-13)  # float64 resolves the difference, float32 does not


def grid(n=13) -> np.ndarray:
    line = np.linspace(-1, 2, n)
    return np.stack(np.meshgrid(line, line, line, indexing="ij"), -1).reshape(-1, 3)


def test_threads_and_samples_of_open3d_change_no_result(device):
    scene, queries = scene_of(CUBE, device=device), somewhere()
    for name in ("compute_signed_distance", "compute_occupancy"):
        call = getattr(scene, name)
        np.testing.assert_array_equal(call(queries, nthreads=2, nsamples=3), call(queries))
    np.testing.assert_array_equal(scene.compute_distance(queries, nthreads=2), scene.compute_distance(queries))
    closest = scene.compute_closest_points(queries, nthreads=2)
    np.testing.assert_array_equal(closest["points"], scene.compute_closest_points(queries)["points"])


def test_points_on_lines_through_edges_have_the_correct_sign(device):
    queries = grid(16).astype(np.float32)
    inside = ((queries > 0) & (queries < 1)).all(1)
    clear = inside | ((queries < -1e-6) | (queries > 1 + 1e-6)).any(1)
    scene = scene_of(CUBE, device=device)
    assert scene.sign_method == "pseudonormals"
    assert ((scene.compute_signed_distance(queries) < 0)[clear] == inside[clear]).all()


@pytest.mark.parametrize("shift", [np.zeros(3), FAR])
def test_inverted_and_far_meshes_enclose_the_same_points(device, shift):
    queries = grid(7) + 0.013
    inside = ((queries > 0) & (queries < 1)).all(1)
    for triangles in (np.array(CUBE[1]), np.array(CUBE[1])[:, ::-1]):
        scene = scene_of((np.array(CUBE[0]) + shift, triangles), device=device)
        assert ((scene.compute_signed_distance(queries + shift) < 0) == inside).all()
        closest = scene.compute_closest_points(queries + shift)["points"]
        assert np.linalg.norm(closest - shift - np.clip(queries, 0, 1), axis=1)[~inside].max() < 1e-6


def test_signs_at_sharp_corners_match_the_solid_angle(device):
    rng = np.random.default_rng(5)
    for seed in range(3):
        spikes = rng.random((4, 3)) * [3, 3, 0.05]
        tip = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
        scene = scene_of((spikes, tip), device=device)
        queries = (spikes[rng.integers(0, 4, 400)] + rng.normal(size=(400, 3)) * 0.05).astype(np.float32)
        number = np.abs(winding_numbers(queries, corners_of(spikes, tip)))
        assert scene.sign_method == "pseudonormals", seed
        assert ((scene.compute_signed_distance(queries) < 0) == (number > 0.5)).all()


@pytest.mark.parametrize("is_open", [True, False])
def test_open_and_self_intersecting_meshes_are_classified_by_winding_numbers(device, is_open):
    vertices, triangles = torus(48, 24)
    if is_open:
        triangles = triangles[vertices[triangles].mean(1)[:, 2] < 0.35]  # without its top
    else:
        vertices[:, :2] *= 1 - 0.7 / np.linalg.norm(vertices[:, :2], axis=1, keepdims=True)  # thicker than its ring
    scene = scene_of((vertices, triangles), device=device)
    queries = somewhere(500, 7, 1.5 if is_open else 0.8)
    number = winding_numbers(queries, corners_of(vertices, triangles))
    assert scene.sign_method == "winding_numbers"
    clear = np.abs(np.abs(number) - 0.5) > 0.02  # the error bound of dipoles for far nodes
    assert clear.mean() > 0.9
    assert ((scene.compute_signed_distance(queries) < 0) == (np.abs(number) > 0.5))[clear].all()


def test_a_klein_bottle_has_no_pseudonormals(device):
    mesh = surface(8, 8, wrap=True, twist=True, close=True).to(device)
    assert mesh.is_watertight()  # each edge has two triangles, but neither side is the inside
    scene = scene_of((mesh.vertices, mesh.triangles), device=device)
    assert scene.sign_method == "winding_numbers"
    assert np.isfinite(scene.compute_signed_distance(somewhere(50))).all()


def test_nested_shells_and_overlapping_geometries_are_one_solid(device):
    cube = np.array(CUBE[0])
    queries = somewhere(500, 8, 2.5)
    outer = (np.abs(queries - 0.5) < 1.5).all(1)
    hollow = (*[np.vstack([cube * 3 - 1, cube])], np.vstack([CUBE[1], np.array(CUBE[1])[:, ::-1] + 8]))
    scene = scene_of(hollow, device=device)
    assert scene.sign_method == "winding_numbers"
    assert ((scene.compute_signed_distance(queries) < 0) == (outer & ~((queries > 0) & (queries < 1)).all(1))).all()
    both = scene_of((cube * 3 - 1, CUBE[1]), (cube * 3, CUBE[1]), device=device)
    shifted = (np.abs(queries - 1.5) < 1.5).all(1)
    assert ((both.compute_signed_distance(queries) < 0) == (outer | shifted)).all()
    assert (outer & shifted).any()  # counted twice: even, so outside in Open3D


def test_instances_are_measured_at_their_poses(device):
    pose = np.eye(4)
    pose[:3, :3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    pose[:3, 3] = [4, 0, 1]
    scene = RaycastingScene(device)
    first = scene.add_triangles(TriangleMesh(*CUBE, device=device))
    second = scene.add_instance(first, pose)
    there = np.array(CUBE[0]) @ pose[:3, :3].T + pose[:3, 3]
    queries = somewhere(300, 9, 5.0)
    corners = [corners_of(v, CUBE[1]) for v in (CUBE[0], there)]
    truth = np.array([distances_to_triangles(queries, c).min(1) for c in corners])
    result = scene.compute_closest_points(queries)
    np.testing.assert_allclose(np.linalg.norm(result["points"] - queries, axis=1), truth.min(0), atol=2e-6)  # float32
    assert (result["geometry_ids"] == truth.argmin(0) * second).all()
    is_second = result["geometry_ids"] == second
    normals = np.cross(corners[1][:, 1] - corners[1][:, 0], corners[1][:, 2] - corners[1][:, 0])
    wanted = normals[result["primitive_ids"][is_second]]
    np.testing.assert_allclose(result["primitive_normals"][is_second], wanted, atol=1e-6)


def test_a_scene_without_triangles_is_infinitely_far(device):
    for meshes in ([], [([], [])], [([[0, 0, 0]], [])]):
        scene = scene_of(*meshes, device=device)
        assert scene.compute_distance([[0, 0, 0]]).tolist() == [np.inf]
        assert scene.compute_signed_distance([[0, 0, 0]]).tolist() == [np.inf]
        assert scene.compute_occupancy(np.zeros((2, 0, 3))).shape == (2, 0)
        assert scene.compute_closest_points([0, 0, 0])["primitive_ids"] == INVALID
        assert scene.sign_method == "winding_numbers"


@pytest.mark.parametrize("is_open", [False, True])
def test_a_non_finite_query_has_no_distance_and_affects_no_other(device, is_open):
    vertices, triangles = CUBE
    scene = scene_of((vertices, triangles[2:] if is_open else triangles), device=device)
    queries = somewhere(40)
    hostile = np.vstack([queries, [[np.nan, 0.5, 0.5], [0.5, np.inf, 0.5]]]).astype(np.float32)
    for answer in (scene.compute_signed_distance, scene.compute_occupancy, scene.compute_distance):
        result = np.asarray(answer(hostile))
        np.testing.assert_array_equal(result[:40], np.asarray(answer(queries)))
        assert np.isnan(result[40:]).all()


def plate(height=0.0, size=1.0, device=None, shift=(0, 0, 0)) -> TriangleMesh:
    corners = np.array([[0, 0, height], [size, 0, height], [size, size, height], [0, size, height]]) + shift
    return TriangleMesh(corners, [[0, 1, 2], [0, 2, 3]], device=device)


def test_distance_of_parallel_plates_is_exact(device):
    result = plate(device=device).compute_metrics(plate(0.5, device=device), [0.4, 0.6], n_sampled_points=500)
    assert result.chamfer == pytest.approx(1, rel=1e-12)
    assert result.hausdorff == result.hausdorff_bound == 0.5 and result.fscore.tolist() == [0, 100]
    assert result.mean == result.rms == result.max == (0.5, 0.5)


@pytest.mark.slow
@pytest.mark.parametrize("shift", [np.zeros(3), FAR])
def test_means_match_dense_sampling_at_any_position(device, shift):
    a, b = torus(), torus(30, 9)
    mesh, other = (TriangleMesh(v + shift, t, device=device) for v, t in (a, b))
    result = mesh.compute_metrics(other, [0.02], n_sampled_points=20000)
    samples = mesh.sample_points_uniformly(4000, seed=7).points - shift
    truth = distances_to_triangles(samples, corners_of(*b)).min(1)
    assert result.mean[0] == pytest.approx(truth.mean(), rel=0.05)  # of 4,000 random points
    assert result.rms[0] == pytest.approx(np.sqrt((truth**2).mean()), rel=0.05)
    assert result.max[0] >= truth.max() - 1e-6


def test_hausdorff_distance_between_vertices_is_detected(device):
    tent = TriangleMesh([[-3, 0, 1], [3, 0, 1], [0, 0.1, 1], [0, -0.1, 1]], [[0, 1, 2], [0, 3, 1]], device=device)
    posts = [[[x, -1, 0], [x, 1, 0], [x, 0, -1]] for x in (-3, 3)]
    ground = TriangleMesh(np.reshape(posts, (-1, 3)), [[0, 1, 2], [3, 4, 5]], device=device)
    result = tent.compute_metrics(ground, [0.1], n_sampled_points=10)
    exact = np.hypot(3, 1)  # at the middle, where no vertex and hardly a sample is: vertices 2 and 3 are located there
    assert result.max[0] == pytest.approx(exact, rel=1e-3) and result.hausdorff_bound >= exact * (1 - 1e-6)
    line = TriangleMesh([[-3, 0, 1], [3, 0, 1], [3, 1e-3, 1]], [[0, 1, 2]], device=device)
    result = line.compute_metrics(ground, [0.1], n_sampled_points=10)
    assert result.max[0] == pytest.approx(exact, abs=1e-3)


def test_bounds_are_valid_and_tight_on_random_surfaces(device):
    rng = np.random.default_rng(0)
    for _ in range(3):
        one, two = (rng.random((18, 3)) for _ in range(2))
        meshes = [TriangleMesh(v, np.arange(18).reshape(-1, 3), device=device) for v in (one, two)]
        result = meshes[0].compute_metrics(meshes[1], [0.1], n_sampled_points=200)
        w = rng.dirichlet([1, 1, 1], 3000)
        points = np.einsum("nk,tkd->tnd", w, one.reshape(-1, 3, 3)).reshape(-1, 3)
        there = distances_to_triangles(points, corners_of(two, np.arange(18).reshape(-1, 3))).min(1).max()
        assert there <= result.hausdorff_bound + 1e-6 and there <= result.max[0] + 2e-5
        assert result.max[0] == pytest.approx(there, abs=0.02)  # of 3,000 points a triangle
        assert 0 <= result.hausdorff_bound - result.hausdorff <= 2e-5


def test_bounds_meet_where_surfaces_coincide(device):
    """Neither mesh has edges of the other: pieces that are only halved along these become millions."""

    def square(count: int) -> TriangleMesh:
        v, u = (k.ravel() for k in np.mgrid[: count + 1, : count + 1])
        first = (v * (count + 1) + u).reshape(count + 1, -1)[:-1, :-1].ravel()
        sides = np.stack([first, first + 1, first + count + 2, first, first + count + 2, first + count + 1], axis=1)
        return TriangleMesh(np.stack([u / count, v / count, 0 * u], axis=1), sides.reshape(-1, 3), device=device)

    result = square(28).compute_metrics(square(19), [0.1], n_sampled_points=100)
    assert result.hausdorff < 1e-7 and result.hausdorff_bound < 2e-5


def test_the_bound_contains_the_parts_that_were_not_split(device):
    sphere = TriangleMesh.create_sphere(0.5, 30, device=device)
    coarse = sphere.simplify_quadric_decimation(len(sphere) // 10)
    result = sphere.compute_metrics(coarse, [0.1], n_sampled_points=500)
    scene = loom.RaycastingScene(device=device)
    scene.add_triangles(coarse)
    points = np.asarray(sphere.sample_points_uniformly(100_000, seed=1).points, np.float32)
    assert np.asarray(scene.compute_distance(points)).max() <= result.hausdorff_bound
    assert result.hausdorff < result.hausdorff_bound <= result.hausdorff + 2e-5


def test_an_error_map_colors_each_vertex_by_its_distance(device):
    vertices, triangles = torus()
    mesh = TriangleMesh(np.vstack([vertices, [[np.nan] * 3]]), triangles, device=device)
    cube = TriangleMesh(*CUBE, device=device)
    colored, distances = mesh.compute_error_map(cube)
    truth = distances_to_triangles(vertices.astype(np.float32), corners_of(*CUBE)).min(1)
    np.testing.assert_allclose(distances[:-1], truth, rtol=1e-6, atol=1e-7)
    assert np.isnan(distances[-1]) and colored.vertex_colors[-1].tolist() == [0.5, 0.5, 0.5]
    order = np.argsort(distances[:-1])
    assert (np.diff(colored.vertex_colors[:-1][order, 1]) >= -1e-6).all()  # green grows along the colors
    capped = mesh.compute_error_map(cube, max_distance=0.1)[0].vertex_colors[:-1]
    yellow = np.broadcast_to(np.float32([0.993, 0.906, 0.144]), ((truth > 0.1).sum(), 3))
    np.testing.assert_allclose(capped[truth > 0.1], yellow, rtol=1e-6)
    assert np.isinf(mesh.compute_error_map(TriangleMesh([], [], device=device))[1][:-1]).all()
    colored, distances = cube.compute_error_map(cube)  # no largest distance to divide by
    assert (distances == 0).all() and (colored.vertex_colors == colored.vertex_colors[0]).all()


def ground(count=30):
    """A hilly sheet of upward-facing triangles."""
    x, y = np.meshgrid(np.arange(count + 1.0), np.arange(count + 1.0))
    corners = np.column_stack([x.ravel(), y.ravel(), np.sin(x.ravel()) + np.cos(y.ravel() / 2)])
    rows = (np.arange(count)[:, None] * (count + 1) + np.arange(count)).ravel()
    up, far = rows + 1, rows + count + 1
    return corners, np.concatenate([np.column_stack([rows, up, far + 1]), np.column_stack([rows, far + 1, far])])


@pytest.mark.parametrize("at", [np.zeros(3), FAR], ids=["here", "in UTM"])
def test_distances_match_brute_force_and_signs_mark_above_and_below(device, rng, at):
    corners, triangles = ground()
    positions = rng.random((100, 2)) * 24 + 3
    height = np.sin(positions[:, 0]) + np.cos(positions[:, 1] / 2)
    lift = rng.choice([-1, 1], 100) * (0.4 + rng.random(100))
    points = np.column_stack([positions, height + lift])
    mesh = loom.TriangleMesh(corners + at, triangles, device=device)
    result = loom.meshing.compare_cloud_to_mesh(loom.PointCloud(points + at, device=device), mesh)
    expected = distances_to_triangles(points, corners[triangles]).min(axis=1)
    np.testing.assert_allclose(np.abs(result.distances), expected, rtol=0, atol=2e-6)
    np.testing.assert_array_equal(result.distances > 0, lift > 0)
    assert not result.beside.any() and result.is_significant.all() and (result.counts == 1).all()


def test_a_point_over_a_sharp_edge_is_above_although_one_triangle_faces_away(device):
    roof = [[0, 0, 0], [4, 0, 0], [4, 1, 3], [0, 1, 3], [4, 1.5, 0], [0, 1.5, 0]]
    mesh = loom.TriangleMesh(roof, [[0, 1, 2], [0, 2, 3], [3, 2, 4], [3, 4, 5]], device=device)
    over, under = [2, 1.0, 3.5], [2, 0.9, 2]
    result = loom.meshing.compare_cloud_to_mesh(loom.PointCloud([over, under], device=device), mesh)
    assert result.distances[0] == pytest.approx(0.5) and result.distances[1] < 0


def test_points_beside_an_open_mesh_are_flagged(device):
    mesh = loom.TriangleMesh(*ground(), device=device)
    points = [[-2, 5, 1], [-1, -1, 0], [31, 31, 1], [15.2, 15.3, 3]]
    result = loom.meshing.compare_cloud_to_mesh(loom.PointCloud(points, device=device), mesh)
    assert result.beside.tolist() == [True, True, True, False]
    assert result.is_significant.tolist() == [False, False, False, True]
    assert result.warnings[0].startswith("only 1 of 4 distances are not from the border of the mesh (25.0%)")
    over = loom.meshing.compare_cloud_to_mesh(loom.PointCloud(points[-1:] * 3, device=device), mesh)
    assert over.reliable and not result.reliable


def test_neighbors_determine_the_noise(device, rng):
    corners, triangles = ground()
    mesh = loom.TriangleMesh(corners * (1, 1, 0), triangles, device=device)
    points = np.column_stack([rng.random((8000, 2)) * 30, 0.05 * rng.normal(size=8000)])
    raised = points[:, 0] > 20
    points[raised, 2] += 0.05
    cloud = loom.PointCloud(points, device=device)
    result = loom.meshing.compare_cloud_to_mesh(cloud, mesh, radius=1.0, registration_error=0.001)
    tree, heights = cKDTree(points), points[:, 2]
    for row in range(0, 8000, 97):
        near = heights[tree.query_ball_point(points[row], 1.0 - 1e-6)]
        assert result.counts[row] == len(near) and result.distances[row] == pytest.approx(near.mean(), abs=1e-7)
        assert result.spreads[row] == pytest.approx(near.std(ddof=1), abs=1e-7)
        limit = 1.96 * (near.std(ddof=1) / np.sqrt(len(near)) + 0.001)
        assert result.level_of_detection[row] == pytest.approx(limit, abs=1e-7)
    inner = np.abs(points[:, 0] - 20) > 1.2
    significant = result.is_significant & inner
    assert significant[raised & inner].mean() > 0.95 and significant[~raised & inner].mean() < 0.12


def test_undefined_distances_are_nan(device):
    mesh = loom.TriangleMesh(*ground(), device=device)
    points = [[15, 15, 50], [np.nan, 0, 0], [15, 15, 1.2]]
    result = loom.meshing.compare_cloud_to_mesh(loom.PointCloud(points, device=device), mesh, max_distance=10)
    assert np.isnan(result.distances).tolist() == [True, True, False]
    assert "only 1 of 3 points have a distance (33.3%): use a larger max_distance" in result.warnings[0]
    assert result.is_significant.tolist()[:2] == [False, False]
    empty = loom.TriangleMesh(np.zeros((0, 3)), np.zeros((0, 3), np.int32), device=device)
    assert np.isnan(loom.meshing.compare_cloud_to_mesh(loom.PointCloud(points, device=device), empty).distances).all()
    none = loom.meshing.compare_cloud_to_mesh(loom.PointCloud(np.zeros((0, 3)), device=device), mesh, radius=1.0)
    assert repr(none) == "CloudToMeshResult(0 points, 0 with a distance, 0 significant)"


def open3d_pairs(o3d, vertices, triangles) -> np.ndarray:
    mesh = TriangleMesh(vertices, triangles, origin=[0, 0, 0])
    pairs = np.asarray(in_open3d(o3d, mesh).get_self_intersecting_triangles(), np.int32).reshape(-1, 2)
    pairs = np.sort(pairs, axis=1)
    return pairs[np.lexsort(pairs.T[::-1])]


def pairs_of(vertices, triangles, device=None) -> list[list[int]]:
    return TriangleMesh(vertices, triangles, device=device).get_self_intersecting_triangles().tolist()


def test_pairs_match_open3d(device, oracle):
    rng = np.random.default_rng(0)
    crowd = rng.random((240, 3)), rng.permutation(240).reshape(-1, 3)
    spread = rng.random((900, 3)) * 0.15 + rng.random((300, 3)).repeat(3, 0), np.arange(900).reshape(-1, 3)
    flat = crowd[0] * [1, 1, 0], crowd[1]
    for name, scene in (("crowd", crowd), ("spread", spread), ("flat", flat)):
        pairs = pairs_of(*scene, device)
        assert pairs == oracle(f"meshing/intersections/{name}", open3d_pairs, *scene).tolist() and len(pairs) > 10


def test_a_torus_intersects_itself_only_after_self_penetration(device, oracle):
    vertices, triangles = torus()
    assert not TriangleMesh(vertices, triangles, device=device).is_self_intersecting()
    two = np.vstack([vertices, vertices + np.array([0.5, 0, 0])]), np.vstack([triangles, triangles + len(vertices)])
    mesh = TriangleMesh(*two, device=device)
    pairs = mesh.get_self_intersecting_triangles().tolist()
    theirs = oracle("meshing/intersections/torus", open3d_pairs, *two).tolist()
    assert mesh.is_self_intersecting() and all(pair in pairs for pair in theirs)
    integers = (mesh.vertices * 2.0**40).astype(np.int64).astype(object)  # exactly
    for pair in pairs:  # pairs that touch are decided as well
        assert pair in theirs or meeting_pairs(integers, two[1][pair]) == [[0, 1]]
    assert len(pairs) > len(theirs) > 100


@pytest.mark.parametrize(
    ("last", "pairs"), [([1, 0, 0], [[0, 1]]), ([0, 0, 0], [[0, 1]]), ([1, -1, 0], []), ([-1, 0, 0], [])]
)
def test_triangles_that_touch_in_one_point_intersect(device, last, pairs):
    corners = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [-1, -3, -1], [-1, -3, 1], last]  # shared: an edge, a corner, nothing
    assert pairs_of(corners, [[0, 1, 2], [3, 4, 5]], device) == pairs


COORDINATES = st.integers(-2, 2)


@pytest.mark.slow
@settings(deadline=None, max_examples=60)
@given(st.lists(st.tuples(COORDINATES, COORDINATES, COORDINATES), min_size=6, max_size=15))
def test_touching_is_decided_exactly(points):
    vertices = np.array(points)[: len(points) // 3 * 3]  # many touch, many are flat, some are points
    triangles = np.arange(len(vertices)).reshape(-1, 3)
    assert pairs_of(vertices, triangles) == meeting_pairs(vertices, triangles)


def test_degenerate_triangles_intersect_where_their_segments_do(device):
    """Differences of these coordinates have more bits than float32, so many signs are undecided in float64."""
    axes = np.array([[1398101, 699051, 466033], [-466033, 1398101, 699051], [3, -5, 7]])
    flat = [[[-5, 0, 0], [1, 0, 0], [3, 0, 0]], [[3, 0, 0], [4, 0, 0], [5, 0, 0]], [[-4, 0, 0]] * 3]
    flat += [[[0, -2, 0], [0, 1, 0], [0, 3, 0]], [[1, 1, 0], [2, 1, 0], [3, 1, 0]]]
    flat += [[[-2, -1, 0], [2, -1, 0], [0, 2, 0]], [[-1, -2, 1], [-1, 1, 1], [-1, 3, 1]]]
    vertices, triangles = np.reshape(flat, (-1, 3)) @ axes, np.arange(3 * len(flat)).reshape(-1, 3)
    pairs = TriangleMesh(vertices, triangles, device=device, origin=[0, 0, 0]).get_self_intersecting_triangles()
    assert pairs.tolist() == meeting_pairs(vertices, triangles) and 3 < len(pairs) < 15


def open3d_counts(o3d, scenes):
    return [len(open3d_pairs(o3d, vertices, [[0, 1, 2], [3, 4, 5]])) for vertices in scenes]


def test_coplanar_disjoint_triangles_do_not_intersect_unlike_open3d(device, oracle):
    # as in Open3D's issue 5117: two adjacent coplanar triangles
    rng, pair = np.random.default_rng(2), [[0, 1, 2], [3, 4, 5]]
    scenes = [rng.integers(0, 6, (6, 3)) * [0, 1, 1] for _ in range(40)]
    result = [pairs_of(scene, pair, device) for scene in scenes]
    assert result == [meeting_pairs(scene, np.array(pair)) for scene in scenes]
    theirs, counts = oracle("meshing/intersections/plane", open3d_counts, scenes), [len(p) for p in result]
    assert sum(counts) and counts != theirs


def test_one_ulp_separates_two_triangles(device):
    touching = np.array([[0, 0, 0], [3, 0, 0], [0, 3, 0], [1, 1, 0], [1, 1, 2], [2, 1, 2]], np.float32)
    apart = touching.copy()
    apart[3, 2] = np.nextafter(np.float32(0), np.float32(1)) * 2**30  # 6e-37, below the resolution of float64 sums
    triangles = [[0, 1, 2], [3, 4, 5]]
    assert pairs_of(touching, triangles, device) == [[0, 1]] and pairs_of(apart, triangles, device) == []


def test_meshes_intersect_at_their_surfaces_and_not_by_containment(device):
    cube = np.array(CUBE[0], float)
    mesh = TriangleMesh(cube, CUBE[1], device=device)
    touching, inside = [([1, 0, 0], 1, True), ([1.0001, 0, 0], 1, False)], [([0.25] * 3, 0.5, False)]
    for shift, size, meets in (*touching, *inside, ([0.5] * 3, 1, True)):
        other = TriangleMesh(cube * size + shift, CUBE[1], device=device)
        assert mesh.is_intersecting(other) == other.is_intersecting(mesh) == meets
    far = TriangleMesh(cube + FAR, CUBE[1], device=device)
    assert far.is_intersecting(TriangleMesh(cube + FAR + 0.5, CUBE[1], device=device))
    assert not far.is_intersecting(mesh)


def test_impossible_pairs_do_not_intersect(device):
    nothing = TriangleMesh([], [], device=device)
    cube = TriangleMesh(*CUBE, device=device)
    assert not nothing.is_self_intersecting() and nothing.get_self_intersecting_triangles().shape == (0, 2)
    assert not cube.is_intersecting(nothing) and not nothing.is_intersecting(cube)
    broken = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [np.nan, 0, 0], [0.2, 0.2, -1], [0.2, 0.2, 1]]
    assert pairs_of(broken, [[0, 1, 2], [3, 4, 5]], device) == []
    assert pairs_of(broken, [[0, 1, 2], [0, 1, 2]], device) == []  # they share vertices
    assert pairs_of([*broken[:3], *broken[:3]], [[0, 1, 2], [3, 4, 5]], device) == [[0, 1]]


def test_a_corner_in_a_slanted_plane_touches_although_float64_disagrees(device, rng):
    for _ in range(40):
        u, v = rng.integers(-999, 1000, (2, 3))
        normal = np.cross(u, v)
        corner = rng.integers(1, 2000) * u + rng.integers(1, 2000) * v  # integers below 2^24: exact in float32
        above = np.round(1000 * normal / np.linalg.norm(normal)).astype(int)
        floor = TriangleMesh([0 * u, 4001 * u, 4001 * v], [[0, 1, 2]], device=device, origin=[0, 0, 0])
        standing = [corner, corner + above, corner + above + u]
        assert floor.is_intersecting(TriangleMesh(standing, [[0, 1, 2]], device=device, origin=[0, 0, 0]))
