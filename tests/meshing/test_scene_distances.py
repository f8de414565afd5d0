"""Closest points, distances and signs of a scene: Open3D's where it is right, brute force where it is not."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import RaycastingScene, TriangleMesh

from .open3d_meshes import raycasting_scene
from .surface_oracles import distances_to_triangles, winding_numbers

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


def test_needles_and_large_triangles_among_small_ones_are_detected(device):
    rng = np.random.default_rng(3)
    corners = rng.random((200, 3, 3)) * rng.choice([1e-4, 1.0], (200, 1, 1))
    corners[:60, 2] = corners[:60, 1] + rng.random((60, 3)) * 1e-7
    scene = scene_of((corners.reshape(-1, 3), np.arange(600).reshape(-1, 3)), device=device)
    queries = somewhere(300, 4)
    truth = distances_to_triangles(queries, corners.astype(np.float32)).min(1)
    np.testing.assert_allclose(scene.compute_distance(queries), truth, rtol=1e-6, atol=1e-8)


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


def test_open_meshes_are_classified_by_winding_numbers(device):
    vertices, triangles = torus(48, 24)
    keep = vertices[triangles].mean(1)[:, 2] < 0.35  # without its top
    scene = scene_of((vertices, triangles[keep]), device=device)
    queries = somewhere(500, 7, 1.5)
    number = winding_numbers(queries, corners_of(vertices, triangles[keep]))
    assert scene.sign_method == "winding_numbers"
    clear = np.abs(np.abs(number) - 0.5) > 0.02  # the error bound of dipoles for far nodes
    assert clear.mean() > 0.95
    assert ((scene.compute_signed_distance(queries) < 0) == (np.abs(number) > 0.5))[clear].all()


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


def test_a_self_intersecting_shell_is_classified_by_winding_numbers(device):
    vertices, triangles = torus()
    rim = np.linalg.norm(vertices[:, :2], axis=1, keepdims=True)
    vertices[:, :2] *= 1 - 0.7 / rim  # the tube is thicker than its ring
    scene = scene_of((vertices, triangles), device=device)
    assert scene.sign_method == "winding_numbers"
    queries = somewhere(300, 11, 0.8)
    number = winding_numbers(queries, corners_of(vertices, triangles))
    clear = np.abs(np.abs(number) - 0.5) > 0.02
    assert ((scene.compute_signed_distance(queries) < 0) == (np.abs(number) > 0.5))[clear].all()


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


def test_a_klein_bottle_has_no_pseudonormals(device):
    n = 16
    i, j = (axis.ravel() for axis in np.meshgrid(np.arange(n), np.arange(n), indexing="ij"))

    def at(i, j):
        return i % n * n + np.where(i // n % 2 == 1, -j, j) % n  # reversed after a rotation

    one = np.column_stack([at(i, j), at(i + 1, j), at(i + 1, j + 1)])
    triangles = np.vstack([one, np.column_stack([at(i, j), at(i + 1, j + 1), at(i, j + 1)])])
    u, v = 2 * np.pi * i / n, 2 * np.pi * j / n
    r = 2 + np.cos(u / 2) * np.sin(v) - np.sin(u / 2) * np.sin(2 * v)
    z = np.sin(u / 2) * np.sin(v) + np.cos(u / 2) * np.sin(2 * v)
    vertices = np.column_stack([r * np.cos(u), r * np.sin(u), z])
    mesh = TriangleMesh(vertices, triangles, device=device)
    assert mesh.is_watertight()  # each edge has two triangles, but neither side is the inside
    scene = scene_of((vertices, triangles), device=device)
    assert scene.sign_method == "winding_numbers"
    assert np.isfinite(scene.compute_signed_distance(somewhere(50))).all()
