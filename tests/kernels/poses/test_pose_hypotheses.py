"""Poses from correspondences: compatibility graph, samples, scores and refinement against brute force and Open3D."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize
from scipy.spatial.transform import Rotation

from pointloom.kernels.lang import cpu_compiler, int32, int64, mat44d, vec3
from pointloom.kernels.memory import download, empty, upload
from pointloom.kernels.poses.consensus_poses import (
    CompatibilityGraph,
    distinct_poses,
    find_consensus,
    order_descending,
    seed_poses,
)
from pointloom.kernels.poses.pair_fits import PAIRS_PER_BLOCK, PairCoordinates
from pointloom.kernels.poses.pose_fitness import PoseFitness
from pointloom.kernels.poses.pose_hypotheses import REJECTED_SCORE, Checks, Samples, score_poses
from pointloom.kernels.poses.pose_search import MAX_DISTINCT, MAX_RANKED, PoseSearch
from pointloom.kernels.poses.similar_tuples import similar_tuples
from pointloom.kernels.search.many_clouds import ManyClouds
from pointloom.kernels.search.point_tree import PointTree

from ...registration.poses import as_pose, moved


def random_poses(rng, count, size=0.5, scale=1.0):
    poses = np.tile(np.eye(4), (count, 1, 1))
    poses[:, :3, :3] = scale * Rotation.random(count, random_state=int(rng.integers(1 << 30))).as_matrix()
    poses[:, :3, 3] = rng.uniform(-size, size, (count, 3))
    return poses


def near_poses(rng, count, angle=0.3, size=0.1):
    poses = random_poses(rng, count, size)
    poses[:, :3, :3] = Rotation.from_rotvec(rng.normal(size=(count, 3)) * angle).as_matrix()
    return poses


def search_over(source, target, pairs, device):
    source, target = upload(source, vec3, device), upload(target, vec3, device)
    fitness = PoseFitness(ManyClouds([source]), PointTree(target))
    return PoseSearch(fitness, source, target, upload(pairs, int32, device))


def identity_pairs(count):
    return np.column_stack([np.arange(count), np.arange(count)])


@pytest.mark.parametrize(("count", "distance"), [(1, 10.0), (7, 0.3), (8, 0.02), (9, 0.3), (500, 0.3), (500, 10.0)])
def test_matched_points_of_each_pose_are_counted(device, rng, count, distance):
    source = rng.uniform(-1, 1, (count, 3)).astype(np.float32) + np.float32(3)
    target = rng.uniform(-1, 1, (700, 3)).astype(np.float32) - np.float32(2)
    source[::50] = np.nan
    target[::90] = np.inf
    poses = near_poses(rng, 11)
    search = search_over(source, target, np.zeros((0, 2)), device)
    counts = search.fitness.count(upload(poses, mat44d, device), distance)
    a, b = (middle.astype(float) for middle in search.fitness.middles)
    finite = [cloud[np.isfinite(cloud).all(axis=1)].astype(float) for cloud in (source, target)]
    for pose, matched_count in zip(poses, counts, strict=True):
        d = np.linalg.norm((moved(finite[0] - a, pose) + b)[:, None] - finite[1], axis=2).min(axis=1, initial=np.inf)
        assert matched_count == (d < distance).sum() or np.abs(d - distance).min() < 1e-5


def test_counts_are_those_of_the_nearest_points(device, rng):
    """The two kernels measure distances by the same operations, so that not even a tie is counted differently."""
    source, target = (rng.integers(0, 12, (3000, 3)) / 10.0 for _ in range(2))
    search = search_over(source, target, np.zeros((0, 2)), device)
    for distance in (0.05, 0.1, 0.2):  # lengths of the lattice itself
        poses = upload(np.eye(4)[None], mat44d, device)
        sums = download(search.fitness.match(poses, distance))[0]
        assert search.fitness.count(poses, distance)[0] == sums[0]


@pytest.mark.parametrize("empties", ["source", "target", "both"])
def test_empty_clouds_match_nothing(device, rng, empties):
    clouds = {name: rng.random((0 if empties in (name, "both") else 9, 3)) for name in ("source", "target")}
    search = search_over(**clouds, pairs=np.zeros((0, 2)), device=device)
    poses = upload(random_poses(rng, 3), mat44d, device)
    assert search.fitness.count(poses, 1.0).tolist() == [0, 0, 0]
    pose, count, squares = search.fitness.refine(upload(np.eye(4)[None], mat44d, device), 1.0, 3, False)
    assert count == 0 and squares == 0
    np.testing.assert_array_equal(pose, np.eye(4))


def test_refinement_ends_at_the_pose_of_the_matches(device, rng):
    """A grid of distant positions: each point matches itself, so the first fit is exact."""
    target = np.stack(np.meshgrid(*[np.arange(6.0)] * 3), -1).reshape(-1, 3) + rng.uniform(-0.2, 0.2, (216, 3))
    true = near_poses(rng, 1, 0.02, 0.05)[0]
    middle = target.mean(axis=0)
    source = (target - middle - true[:3, 3]) @ true[:3, :3] + middle
    search = search_over(source, target, np.zeros((0, 2)), device)
    pose, count, squares = search.fitness.refine(upload(np.eye(4)[None], mat44d, device), 0.4, 8, False)
    a, b = search.fitness.middles
    np.testing.assert_allclose(moved(source - a, pose) + b, target, atol=2e-6)
    assert count == 216 and squares < 1e-9


@pytest.fixture
def clutter(rng):
    """Correspondences of which a third are right, with normals: source, target, their normals, pairs."""
    source = rng.uniform(-1, 1, (400, 3))
    pose = random_poses(rng, 1)[0]
    normals = rng.normal(size=(400, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    target, rotated = moved(source, pose) + 0.01 * rng.normal(size=(400, 3)), normals @ pose[:3, :3].T
    pairs = identity_pairs(400)
    pairs[150:, 1] = rng.integers(0, 400, 250)
    return source, target, normals, rotated, pairs


def draw(search, count, sample_size, similarity=0.0, seed=0, first=0):
    drawn = Samples(search.pairs, sample_size, count, Checks(similarity=similarity), seed, first)
    return download(drawn.similar).copy(), download(drawn.rows).reshape(count, sample_size).copy(), drawn


@pytest.mark.parametrize("sample_size", [3, 4, 8])
def test_samples_are_distinct_and_even(device, clutter, sample_size):
    source, target, _, _, pairs = clutter
    rows, samples, _ = draw(search_over(source, target, pairs, device), 4000, sample_size)
    sorted_samples = np.sort(samples[rows], axis=1)
    assert (np.diff(sorted_samples, axis=1) > 0).all()
    drawn = np.bincount(samples[rows].ravel(), minlength=400)
    assert len(rows) > 3500 and abs(drawn / drawn.mean() - 1).max() < 0.8


def test_a_sample_is_the_same_in_any_round(device, clutter):
    source, target, _, _, pairs = clutter
    search = search_over(source, target, pairs, device)
    rows, samples, _ = draw(search, 300, 3)
    second_rows, second_samples, _ = draw(search, 100, 3, first=200)
    np.testing.assert_array_equal(rows[rows >= 200] - 200, second_rows)
    np.testing.assert_array_equal(samples[rows[rows >= 200]], second_samples[second_rows])
    assert (draw(search, 300, 3, seed=1)[1] != samples).any()


def open3d_poses(o3d, clouds, samples, with_scaling):
    """The pose of each sample of correspondences, float32 [n, 4, 4]."""
    estimation = o3d.pipelines.registration.TransformationEstimationPointToPoint(with_scaling)
    clouds = [o3d.geometry.PointCloud(o3d.utility.Vector3dVector(cloud.astype(np.float64))) for cloud in clouds]
    samples = [o3d.utility.Vector2iVector(sample.astype(np.int32)) for sample in samples]
    return np.array([estimation.compute_transformation(*clouds, sample) for sample in samples], np.float32)


@pytest.mark.parametrize(("with_scaling", "sample_size"), [(False, 3), (True, 5)])
def test_poses_of_samples_match_open3d(device, clutter, oracle, with_scaling, sample_size, tolerances):
    source, target, _, _, pairs = (array.astype(np.float32) for array in clutter)
    search = search_over(source, target, pairs, device)
    rows, samples, drawn = draw(search, 200, sample_size)
    poses, _ = drawn.fit(Checks(), [empty(0, vec3, device)] * 2, with_scaling)
    a, b = (middle.astype(float) for middle in search.fitness.middles)
    chosen = pairs.astype(np.int32)[samples[rows]]
    expected = oracle(f"kernels/pose_hypotheses/{sample_size}", open3d_poses, (source, target), chosen, with_scaling)
    for sample, pose, pose_expected in zip(chosen, download(poses), expected, strict=True):
        points, limit = source[sample[:, 0]], tolerances.sampled_pose
        np.testing.assert_allclose(moved(points - a, pose) + b, moved(points, pose_expected), atol=limit)


CHECKS = {
    "length": Checks(similarity=0.8),
    "distance": Checks(distance=0.25),
    "normal": Checks(cosine=np.cos(1.0)),
    "rotation": Checks(rotation=(1.0, 2.0, 1.5)),
    "all": Checks(0.6, 0.3, np.cos(1.2), (2.5, 2.0, 2.5)),
}


def open3d_checks(o3d, clouds, normals, samples, poses, checks):
    """True for each sample and pose that pass Open3D's checkers."""
    r = o3d.pipelines.registration
    checkers = [
        r.CorrespondenceCheckerBasedOnEdgeLength(checks.similarity),
        r.CorrespondenceCheckerBasedOnDistance(min(checks.distance, 1e9)),
        r.CorrespondenceCheckerBasedOnNormal(np.arccos(max(checks.cosine, -1.0))),
        r.CorrespondenceCheckerBasedOnSourceRotation(np.minimum(checks.rotation, 4.0)),
    ]
    given = [o3d.geometry.PointCloud(o3d.utility.Vector3dVector(cloud.astype(np.float64))) for cloud in clouds]
    for cloud, own in zip(given, normals, strict=True):
        cloud.normals = o3d.utility.Vector3dVector(own.astype(np.float64))
    samples = [o3d.utility.Vector2iVector(sample) for sample in samples]
    return np.array([all(c.Check(*given, *each) for c in checkers) for each in zip(samples, poses, strict=True)])


@pytest.mark.parametrize("name", CHECKS)
def test_accepted_hypotheses_match_the_checkers_of_open3d(device, clutter, oracle, name):
    source, target, normals, rotated, pairs = (array.astype(np.float32) for array in clutter)
    pairs, checks = pairs.astype(np.int32), CHECKS[name]
    search = search_over(source, target, pairs, device)
    similar, _, drawn = draw(search, 500, 3, checks.similarity)
    device_normals = [upload(n, vec3, device) for n in (normals, rotated)]
    _, scores = drawn.fit(checks, device_normals, False)
    passed = np.zeros(500, bool)
    passed[similar[download(scores) != REJECTED_SCORE]] = True
    rows, samples, everything = draw(search, 500, 3)  # every pose, to ask Open3D about
    poses = download(everything.fit(Checks(), device_normals, False)[0]).copy()
    a, b = (middle.astype(float) for middle in search.fitness.middles)
    poses[:, :3, 3] += b - poses[:, :3, :3] @ a
    arguments = (source, target), (normals, rotated), pairs[samples[rows]], poses, checks
    expected = np.zeros(500, bool)
    expected[rows] = oracle(f"kernels/pose_hypotheses/{name}", open3d_checks, *arguments)
    np.testing.assert_array_equal(passed, expected)
    assert 0 < passed.sum() < 450, "else the check was never put to the test"


@pytest.mark.parametrize(
    "count", [3, PAIRS_PER_BLOCK - 1, PAIRS_PER_BLOCK, PAIRS_PER_BLOCK + 1, 3 * PAIRS_PER_BLOCK + 5]
)
def test_scores_are_the_correspondences_that_agree(device, rng, count):
    pose_count = {3: 1, PAIRS_PER_BLOCK: 21, 3 * PAIRS_PER_BLOCK + 5: 21}.get(count, 8)
    source, target = rng.uniform(-1, 1, (2, count, 3)).astype(np.float32)
    search = search_over(source, target, identity_pairs(count), device)
    poses = random_poses(rng, pose_count)
    refused = np.arange(pose_count) % 5 == 3
    scores = upload(np.where(refused, REJECTED_SCORE, 0), int32, device)
    score_poses(search.ranking, upload(poses, mat44d, device), 0.8, scores)
    a, b = (middle.astype(float) for middle in search.fitness.middles)
    d = np.array([np.linalg.norm(moved(source - a, pose) - (target - b), axis=1) for pose in poses])
    unclear = np.abs(d - 0.8).min(axis=1) < 1e-5
    expected = np.where(refused, REJECTED_SCORE, (d < 0.8).sum(axis=1))
    assert (np.asarray(download(scores)) == expected)[~unclear].all()


def test_a_correspondence_at_the_distance_does_not_agree_as_in_open3d(device):
    points = np.array([[x, y, z] for x in (-4, 4) for y in (-2, 2) for z in (-1, 1)], np.float32)
    search, shifted = search_over(points, points, identity_pairs(8), device), as_pose(shift=[0.5, 0, 0])
    for distance, count in ((0.5, 0), (0.51, 8)):
        scores = upload(np.zeros(1), int32, device)
        score_poses(search.ranking, upload(shifted[None], mat44d, device), distance, scores)
        assert download(scores).tolist() == [count]


def test_coincident_and_collapsing_samples_are_refused(device, rng):
    """Open3D draws with replacement: a sample of one correspondence three times fits any rotation."""
    source = np.concatenate([np.zeros((40, 3)), rng.uniform(-1, 1, (40, 3))])
    search = search_over(source, source, identity_pairs(80), device)
    rows, samples, _ = draw(search, 500, 3)
    assert len(rows) and ((samples[rows] < 40).sum(axis=1) <= 1).all()
    # three collinear points whose targets are in reverse order: no rotation but a scale of nearly zero fits
    target = source.copy()
    source[:3], target[:3] = [[-1, 0, 0], [0, 0, 0], [1, 0, 0]], [[0, -1, 0], [0, 2, 0], [0, -1, 1e-9]]
    search = search_over(source, target, np.array([[0, 0], [1, 1], [2, 2]]), device)
    _, scores = draw(search, 20, 3)[2].fit(Checks(), [empty(0, vec3, device)] * 2, True)
    assert (download(scores) == REJECTED_SCORE).all()


def first_apart(poses, scores, size, distance):
    """By NumPy: the best poses, each of which moves the middle or a place on an axis away from where others do."""
    order = np.argsort(-scores, kind="stable")
    order = order[scores[order] > REJECTED_SCORE][:MAX_RANKED]
    probes = np.concatenate([poses[:, :3, 3:], poses[:, :3, :3] * size + poses[:, :3, 3:]], axis=2)[order]
    left, selected = np.ones(len(order), bool), []
    while left.any() and len(selected) < MAX_DISTINCT:
        first = int(np.argmax(left))
        selected.append(first)
        left &= ((probes - probes[first]) ** 2).sum(axis=1).max(axis=1) > distance * distance
        left[first] = False
    return order[selected]


@pytest.mark.parametrize(
    ("count", "distance"), [(1, 0.1), (31, 0.0), (33, 50.0), (700, 0.1), (700, 0.4), (MAX_RANKED + 500, 0.1)]
)
def test_the_best_poses_that_are_unlike_each_other_are_chosen(device, rng, count, distance):
    search = search_over(rng.random((40, 3)), rng.random((40, 3)), identity_pairs(40), device)
    poses = near_poses(rng, count, 0.2, 0.2)
    poses[rng.random(count) < 0.3] = poses[0]
    scores = rng.integers(REJECTED_SCORE, 20, count).astype(np.int32)
    chosen_count = search._select_distinct(upload(poses, mat44d, device), upload(scores, int32, device), distance)
    chosen, selected = first_apart(poses, scores, search.fitness.size, distance), download(search._distinct)
    assert download(search._distinct_count)[0] == len(chosen) and chosen_count in (len(chosen), MAX_DISTINCT)
    np.testing.assert_array_equal(selected[: len(chosen)], poses[chosen])
    if len(chosen):
        assert (selected[len(chosen) :] == selected[0]).all()


def test_annealing_finds_the_minimum_of_the_geman_mcclure_cost(device, clutter):
    source, target, _, _, pairs = clutter
    search = search_over(source, target, pairs, device)
    coordinates = search.pairs
    pose = upload(np.eye(4)[None], mat44d, device)
    mu = 0.05
    coordinates.anneal(pose, 4.0, mu * 1.0001, 4.0 / mu, 40, 120)
    result = download(pose)[0].copy()
    a, b = (middle.astype(float) for middle in search.fitness.middles)
    p, q = source[pairs[:, 0]] - a, target[pairs[:, 1]] - b

    def cost(twist):
        T = result.copy()
        T[:3, :3] = Rotation.from_rotvec(twist[:3]).as_matrix() @ T[:3, :3]
        sqdist = ((moved(p, T) + twist[3:] - q) ** 2).sum(axis=1)
        return (mu * sqdist / (mu + sqdist)).sum()

    best = minimize(cost, np.zeros(6), method="BFGS", options={"gtol": 1e-9})
    assert np.abs(best.x).max() < 1e-4


def test_pairs_that_are_not_finite_are_left_out(device, rng):
    source, target = rng.random((2, 20, 3))
    source[3], target[5, 1] = np.nan, np.inf
    pairs = np.column_stack([np.arange(20), np.roll(np.arange(20), 1)])
    clouds = [upload(c, vec3, device) for c in (source, target)]
    pair_coordinates = PairCoordinates(*clouds, upload(pairs, int32, device), np.zeros(3), np.zeros(3))
    expected = pairs[(pairs[:, 0] != 3) & (pairs[:, 1] != 5)]
    np.testing.assert_array_equal(download(pair_coordinates.rows), expected)
    coordinates = download(pair_coordinates.coordinates).reshape(6, -1).T
    np.testing.assert_array_equal(coordinates[:, :3], source[expected[:, 0]].astype(np.float32))
    np.testing.assert_array_equal(coordinates[:, 3:], target[expected[:, 1]].astype(np.float32))


def test_members_of_similar_triples_have_similar_sides(device, clutter):
    source, target, _, _, pairs = clutter
    search = search_over(source, target, pairs, device)
    rows = download(similar_tuples(search.pairs, 0, 40000, 0.95, 100))
    assert rows.shape == (300,)
    triples = pairs[rows].reshape(-1, 3, 2)
    p, q = source[triples[..., 0]], target[triples[..., 1]]
    sides = [np.linalg.norm(x - np.roll(x, 1, axis=1), axis=2) for x in (p, q)]
    ratio = sides[0] / sides[1]
    assert ((ratio > 0.95 - 1e-5) & (ratio < 1 / 0.95 + 1e-5)).all()
    assert (rows < 150).mean() > 0.8, "a third were right"


def test_triples_are_listed_in_the_order_of_their_numbers(device, clutter):
    source, target, _, _, pairs = clutter
    search = search_over(source, target, pairs, device)
    few, many = (download(similar_tuples(search.pairs, 0, 40000, 0.95, max_count)).copy() for max_count in (20, 100))
    np.testing.assert_array_equal(few, many[:60])
    assert (download(similar_tuples(search.pairs, 1, 40000, 0.95, 20)) != few).any()
    assert download(similar_tuples(search.pairs, 0, 50, 0.999, 20)).shape[0] < 60, "no more trials than asked for"


def make_pairs(p, q, device="cpu"):
    points = [upload(np.asarray(a, np.float32), vec3, device) for a in (p, q)]
    return PairCoordinates(*points, upload(identity_pairs(len(p)), int32, device), *np.zeros((2, 3), np.float32))


def edges_of(graph):
    words = graph.bits.numpy().reshape(graph.count, graph.words).view(np.uint32)
    return ((words[:, :, None] >> np.arange(32, dtype=np.uint32)) & 1).reshape(graph.count, -1).astype(bool)


def distances(p):
    return np.linalg.norm(p[:, None].astype(np.float64) - p[None], axis=2)


def brute_edges(p, q, bound, min_length):
    """The edges, and which of them no rounding can change."""
    a, b = distances(p), distances(q)
    sure = (np.abs(np.abs(a - b) - bound) > 1e-5) & (np.abs(np.minimum(a, b) - min_length) > 1e-5)
    return (np.abs(a - b) <= bound) & (np.minimum(a, b) > min_length), sure


@pytest.mark.parametrize("count", [1, 2, 31, 32, 33, 200])
def test_edges_connect_pairs_of_equal_length(device, rng, count):
    p, q = rng.random((2, count, 3)).astype(np.float32)
    graph = CompatibilityGraph(make_pairs(p, q, device), 0.1, 0.2)
    edges = edges_of(graph)
    expected, sure = brute_edges(p, q, 0.1, 0.2)
    assert not edges[:, count:].any()
    edges = edges[:, :count]
    assert (edges == expected)[sure].all() and sure.mean() > 0.99
    assert (edges == edges.T).all() and not np.diag(edges).any()
    assert (graph.degrees.numpy() == edges.sum(axis=1)).all()


@pytest.mark.parametrize("compiler", ["warp", pytest.param("taichi", marks=pytest.mark.slow)])
@settings(max_examples=30, deadline=None)
@given(rows=st.lists(st.tuples(*[st.integers(0, 4)] * 6).map(lambda t: tuple(map(float, t))), min_size=1, max_size=40))
def test_counts_are_those_of_brute_force_on_lattices_and_duplicates(compiler, rows):
    points = np.array(rows, np.float32)
    with cpu_compiler(compiler):
        graph = CompatibilityGraph(make_pairs(points[:, :3], points[:, 3:]), 0.3, 0.3)
        edges = edges_of(graph)[:, : len(points)].astype(int)
        expected, sure = brute_edges(points[:, :3], points[:, 3:], 0.3, 0.3)
        assert sure.all() and (edges == expected).all()
        common = edges @ edges * edges
        sums = graph.support()
        assert (sums.numpy() == common.sum(axis=1)).all()
        chosen = upload(np.arange(len(points))[::3], int32, "cpu")
        assert (graph.common(chosen).numpy().reshape(-1, len(points)) == common[::3]).all()


@pytest.mark.parametrize("count", [1, 31, 33, 1100])  # more words than lanes of a warp
def test_common_neighbors_and_seed_poses_are_those_of_the_cpu(device, rng, count):
    p, q = rng.integers(0, 9, (2, count, 3)).astype(np.float32)
    graphs = [CompatibilityGraph(make_pairs(p, q, each), 0.3, 0.3) for each in ("cpu", device)]
    edges = edges_of(graphs[0])[:, :count].astype(float)
    common, poses = edges @ edges * edges, []
    for graph in graphs:
        seeds = upload(np.arange(count)[::5], int32, graph.device)
        assert (graph.support().numpy() == common.sum(axis=1)).all()
        assert (graph.common(seeds).numpy().reshape(-1, count) == common[::5]).all()
        poses.append(seed_poses(graph, seeds)[0].numpy())
    assert np.array_equal(*poses, equal_nan=True)


def test_support_counts_the_vertices_of_highest_degree_first(device, rng):
    p, q = rng.random((2, 100, 3)).astype(np.float32)
    graph = CompatibilityGraph(make_pairs(p, q, device), 0.2, 0.0)
    full_support, degrees = graph.support().numpy(), graph.degrees.numpy()
    part = graph.support(work=int(degrees.sum()) * graph.words // 4).numpy()
    counted = part > 0
    assert 0 < counted.sum() < 60 and (part[counted] == full_support[counted]).all()
    assert degrees[counted].min() >= degrees[~counted].max()


def test_peaks_are_local_maxima(device, rng):
    p, q = rng.random((2, 150, 3)).astype(np.float32)
    graph = CompatibilityGraph(make_pairs(p, q, device), 0.2, 0.0)
    sums = graph.support()
    values, radius = sums.numpy(), 0.4
    near = (distances(p) < radius) & (distances(q) < radius)
    index = np.arange(150)
    stronger = (values[None] > values[:, None]) | ((values[None] == values[:, None]) & (index[None] < index[:, None]))
    expected = np.flatnonzero(~(near & stronger).any(axis=1) & (values > 0))
    expected = expected[np.argsort(-values[expected], kind="stable")]
    assert 10 < len(expected) < 140 and graph.peaks(sums, radius, 1000).numpy().tolist() == expected.tolist()
    assert graph.peaks(sums, radius, 7).numpy().tolist() == expected[:7].tolist()


def test_descending_order_keeps_ties_in_order(device):
    values = upload(np.array([3, 9, 3, 0, 9, 2**40]), int64, device)
    assert order_descending(values).numpy().tolist() == [5, 1, 4, 0, 2, 3]


def test_poses_that_move_the_source_alike_are_one():
    spread = np.vstack([np.eye(3), -np.eye(3)])
    poses = np.tile(np.eye(4), (4, 1, 1))
    poses[1, 0, 3], poses[2, 0, 3], poses[3, 1, 3] = 0.05, 0.3, 1.0
    assert distinct_poses(poses, spread, 0.1).tolist() == [0, 2, 3]
    assert distinct_poses(poses[:0], spread, 0.1).tolist() == []


def test_two_motions_give_two_poses_the_larger_first(device, rng):
    p = rng.random((300, 3))
    q = rng.random((300, 3))
    q[:60] = p[:60] + np.array([0.5, 0, 0])
    q[60:100] = p[60:100][:, [1, 2, 0]]
    poses, saved = find_consensus(make_pairs(p, q, device), 0.02, 0.02, np.vstack([np.eye(3), -np.eye(3)]) / 3)
    assert 59.9 < saved[0] < 66 and 39.9 < saved[1] < 46 and (np.diff(saved) <= 0).all()
    np.testing.assert_allclose(poses[0][:3], np.column_stack([np.eye(3), [0.5, 0, 0]]), atol=1e-3)
    np.testing.assert_allclose(poses[1][:3, :3], np.eye(3)[[1, 2, 0]], atol=1e-3)
