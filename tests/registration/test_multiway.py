"""Many clouds in one frame: synthetic fragments, unrelated clouds, ten bunny scans, and the errors of the poses."""

from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.registration.pose_graphs.connected_parts import connected_parts
from pointloom.registration.pose_graphs.fragment_graph import MAX_DISTANCE, Extent, _agreement, refine_pairs
from pointloom.registration.rigid import make_pose

from .poses import as_pose, moved
from .test_alignment import UTM, about
from .test_pose_covariance import whitened

# Range scans of Stanford have a grid of indices beside their points.
pytestmark = pytest.mark.filterwarnings("ignore:.*element 'range_grid'")


reg = loom.registration


def relief(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    z = 0.25 * np.sin(2.1 * x) * np.cos(1.7 * y) + 0.12 * np.sin(4.3 * y + x) + 0.08 * np.cos(5.9 * x - 2 * y)
    return z + 0.15 * np.exp(-4 * ((x - 0.7) ** 2 + (y + 0.4) ** 2))


@pytest.fixture(scope="module")
def fragments():
    """Five overlapping parts of a relief, each randomly rotated and shifted: clouds, and their poses in the relief."""
    rng = np.random.default_rng(3)
    clouds, poses = [], []
    for k in range(5):
        x, y = rng.uniform(-1.1, 1.1, (2, 9000))
        x = x + 0.8 * k - 1.6
        points = np.column_stack([x, y, relief(x, y)])
        T = make_pose(Rotation.random(random_state=k).as_matrix(), rng.uniform(-3, 3, 3))
        clouds.append((points - T[:3, 3]) @ T[:3, :3])
        poses.append(T)
    return SimpleNamespace(clouds=clouds, poses=np.array(poses))


def worst_shift(poses: np.ndarray, truth: np.ndarray, members: list[int], points: np.ndarray) -> float:
    """The largest point displacement [m] by a pose; both sets of poses in the frame of the first member."""
    relative, true = (np.linalg.inv(each[members[0]]) @ each[members] for each in (poses, truth))
    return max(float(np.linalg.norm(moved(points, error), axis=1).max()) for error in relative - true)


@pytest.mark.slow
def test_fragments_in_any_order_are_aligned_to_the_first(device, fragments):
    order = [3, 0, 4, 1, 2]
    clouds = [loom.PointCloud(fragments.clouds[k], device=device) for k in order]
    result = reg.register_multiway(clouds, voxel_size=0.06)
    assert result.placed.all() and result.reference == 0 and (result.groups == 0).all() and result.reliable
    np.testing.assert_array_equal(result.poses[0], np.eye(4))
    assert worst_shift(result.poses, fragments.poses[order], list(range(5)), fragments.clouds[order[0]][::50]) < 0.01
    assert len(result.pose_graph.nodes) == 5 and len(result.pairs) >= 4


def test_a_cloud_without_overlap_is_excluded_and_reported(fragments, rng):
    stray = rng.normal(0, 1, (4000, 3)) * [1, 1, 0.01]
    clouds = [loom.PointCloud(p) for p in (fragments.clouds[0], stray, fragments.clouds[1], fragments.clouds[2])]
    result = reg.register_multiway(clouds, voxel_size=0.06)
    assert result.placed.tolist() == [True, False, True, True]
    np.testing.assert_array_equal(result.poses[1], np.eye(4))
    assert result.groups[1] not in result.groups[[0, 2, 3]]
    assert not result.reliable and result.warnings[0].startswith("1 of 4 clouds (1) match none of the others")
    assert result.to_dict()["warnings"] == [*result.warnings] and result.warnings[0] in str(result)


def test_a_single_cloud_defines_its_frame():
    result = reg.register_multiway([loom.PointCloud(np.random.default_rng(0).random((500, 3)))], voxel_size=0.1)
    np.testing.assert_array_equal(result.poses, np.eye(4)[None])
    assert result.placed.tolist() == [True] and not result.pairs and result.reliable


def test_empty_clouds_are_excluded(fragments):
    clouds = [loom.PointCloud(p) for p in (np.empty((0, 3)), fragments.clouds[0], fragments.clouds[1])]
    assert reg.register_multiway(clouds, voxel_size=0.06).placed.tolist() == [False, True, True]


def test_a_known_pair_is_refined_without_a_search(fragments):
    clouds = [loom.PointCloud(p) for p in fragments.clouds[:2]]
    near, seen = np.linalg.inv(fragments.poses[0]) @ fragments.poses[1], []
    near[:3, 3] += 0.02
    known = [reg.FragmentPair(1, 0, near, 0.0, 1.0)]
    result = reg.register_multiway(clouds, voxel_size=0.06, known=known, progress=lambda *step: seen.append(step))
    assert seen == [("pairs", 0, 0)] and [(pair.source, pair.target) for pair in result.pairs] == [(1, 0)]
    assert worst_shift(result.poses, fragments.poses[:2], [0, 1], fragments.clouds[0][::50]) < 0.01


def test_a_known_pair_without_overlap_is_unreliable(fragments):
    far = np.eye(4)
    far[0, 3] = 50.0
    clouds = [loom.PointCloud(p) for p in fragments.clouds[:2]]
    result = reg.register_multiway(clouds, voxel_size=0.06, known=[reg.FragmentPair(1, 0, far, 0.0, 1.0)])
    assert result.placed.all() and not result.reliable and "(1 and 0)" in result.warnings[0]


SCANS = ("bun000", "bun045", "bun090", "bun180", "bun270", "bun315", "chin", "ear_back", "top2", "top3")


@pytest.mark.slow
def test_ten_scans_of_the_bunny_are_registered_without_a_guess(real_file, o3d):
    folder = real_file("reg-bunny-scans")
    scans = [loom.read_point_cloud(folder / "data" / f"{name}.ply") for name in SCANS]
    result = reg.register_multiway(scans, voxel_size=0.003)
    assert result.placed.all()
    # the model is in the frame of bun000, the reference
    model = o3d.io.read_triangle_mesh(str(folder / "reconstruction" / "bun_zipper.ply"))
    scene = o3d.t.geometry.RaycastingScene()
    scene.add_triangles(o3d.t.geometry.TriangleMesh.from_legacy(model))
    for name, scan, T in zip(SCANS, scans, result.poses, strict=True):
        transformed = (scan.points[::20] @ T[:3, :3].T + T[:3, 3]).astype(np.float32)
        assert np.median(scene.compute_distance(transformed).numpy()) < 0.0005, name


def test_the_information_of_a_pair_is_about_the_source_coordinates(device, fragments, rng):
    """For any rotation and 50 m apart, against manual rows: the target's points in source coordinates."""
    size, T = 0.06, as_pose([1.2, -0.7, 2.0], [50, -20, 30])
    source = fragments.clouds[0][::4]
    target = moved(source[rng.permutation(len(source))[:1500]], T)
    clouds = [loom.PointCloud(p, device=device).estimate_normals(max_nn=20) for p in (source, target)]
    (pair,), (information,) = refine_pairs(clouds, [reg.FragmentPair(0, 1, T, 1.0, 1.0)], size)
    source, target = (c.points for c in clouds)
    distances, rows = cKDTree(target).query(moved(source, pair.transformation))
    matched = target[rows[distances < MAX_DISTANCE * size]]
    x, y, z = ((matched - pair.transformation[:3, 3]) @ pair.transformation[:3, :3]).T
    zero, one = np.zeros(len(x)), np.ones(len(x))
    G = np.array([[zero, z, -y, one, zero, zero], [-z, zero, x, zero, one, zero], [y, -x, zero, zero, zero, one]])
    expected = np.einsum("kin,kjn->ij", G, G)
    assert np.abs(information - expected).max() < 1e-3 * np.abs(expected).max()


def test_pairs_support_each_other_only_if_they_close_a_loop(fragments):
    clouds = [Extent.of(loom.PointCloud(p[::20])) for p in fragments.clouds[:3]]
    between = {(s, t): np.linalg.inv(fragments.poses[t]) @ fragments.poses[s] for s, t in ((0, 1), (1, 2), (0, 2))}
    scores = np.array([0.9, 0.8, 0.6])
    pairs = [reg.FragmentPair(*ends, T, 1.0, score) for (ends, T), score in zip(between.items(), scores, strict=True)]
    np.testing.assert_array_equal(_agreement(clouds, pairs, 0.1), 2 * scores)
    for shift, factor in ((0.09, 2), (0.11, 1)):
        off = pairs[2]._replace(transformation=as_pose(shift=[shift, 0, 0]) @ pairs[2].transformation)
        np.testing.assert_array_equal(_agreement(clouds, [*pairs[:2], off], 0.1), factor * scores)
    np.testing.assert_array_equal(_agreement(clouds, pairs[:2], 0.1), scores[:2])


def test_level_clouds_stay_level(fragments):
    clouds, truth = [], []
    for k, (points, pose) in enumerate(zip(fragments.clouds[:3], fragments.poses[:3], strict=True)):
        rotation = Rotation.from_euler("z", 40 * k, degrees=True).as_matrix()
        world = moved(points, pose) - [0.3 * k, 0, 0.1 * k]
        clouds.append(loom.PointCloud(world @ rotation))  # as from a leveled scanner
        truth.append(make_pose(rotation, np.array([0.3 * k, 0, 0.1 * k])))
    result = reg.register_multiway(clouds, voxel_size=0.06, free=("x", "y", "z", "yaw"))
    assert result.placed.all()
    assert np.abs(result.poses[:, 2, :2]).max() < 1e-15 and np.abs(result.poses[:, :2, 2]).max() < 1e-15
    assert worst_shift(result.poses, np.linalg.inv(truth[0]) @ truth, [0, 1, 2], clouds[0].points[::50]) < 0.01
    tilted = make_pose(Rotation.from_euler("x", 1, degrees=True).as_matrix(), np.zeros(3))
    known = [reg.FragmentPair(1, 0, tilted, 0.0, 1.0)]
    with pytest.raises(ValueError, match=r"known\[0\]\.transformation:.*1"):
        reg.register_multiway(clouds, voxel_size=0.06, free=("x", "y", "z", "yaw"), known=known)


def scipys(source, target, count) -> np.ndarray:
    return connected_components(coo_matrix((np.ones(len(source)), (source, target)), (count, count)), directed=False)[1]


@given(st.integers(1, 60), st.integers(0, 80), st.integers(0, 2**31 - 1))
@settings(deadline=None)
def test_components_are_numbered_as_in_scipy(count, edges, seed):
    source, target = np.random.default_rng(seed).integers(0, count, (2, edges))
    parts = connected_parts(source, target, count)
    assert parts.dtype == np.int32
    np.testing.assert_array_equal(parts, scipys(source, target, count))


@pytest.mark.parametrize("shape", ["chain", "shuffled chain", "star", "comb"])
def test_long_graphs_are_one_component(shape, rng):
    order = rng.permutation(20_000) if shape.startswith("shuffled") else np.arange(20_000)
    source, target = order[:-1], order[1:]
    if shape == "star":
        source, target = np.full(19_999, 19_999), order[:-1]
    if shape == "comb":
        source, target = np.arange(10_000, 20_000), np.arange(10_000)
        source, target = np.append(source, source[:-1]), np.append(target, source[1:])
    assert not connected_parts(source, target, 20_000).any()


def test_a_graph_without_nodes_has_no_components():
    assert connected_parts(np.zeros(0, np.int64), np.zeros(0, np.int64), 0).shape == (0,)


SIZE = 0.1
LEVEL = ("x", "y", "z", "yaw")


def parts(rng, shifts, count=6000):
    """Overlapping parts of a relief, each in a frame of its own, and their poses in the first one's frame."""
    clouds, poses = [], []
    for k, shift in enumerate(shifts):
        x, y = rng.uniform(-1.1, 1.1, (2, count))
        points = np.column_stack([x + shift, y, relief(x + shift, y)])
        T = make_pose(Rotation.from_euler("z", 20 * k, degrees=True).as_matrix(), np.array([shift, 0.0, 0.0]))
        clouds.append((points - T[:3, 3]) @ T[:3, :3])
        poses.append(T)
    return clouds, np.linalg.inv(poses[0]) @ poses


def registered(points, poses, pairs, device="cpu", **options):
    clouds = [loom.PointCloud(p, device=device) for p in points]
    known = [reg.FragmentPair(s, t, np.linalg.inv(poses[t]) @ poses[s], 1.0, 1.0) for s, t in pairs]
    return clouds, reg.register_multiway(clouds, voxel_size=SIZE, known=known, pairs=(), **options)


def test_a_single_pair_has_the_covariance_of_its_pose(device, rng):
    clouds, result = registered(*parts(rng, (0.0, 0.8)), [(1, 0)], device)
    reference, other = result.pose_covariances(clouds)
    expected = reg.assess_registration(clouds[1], clouds[0], result.poses[1], 1.5 * SIZE).covariance.about(other.center)
    assert not reference.matrix.any() and (other.matrix == other.matrix.T).all()
    scale = np.sqrt(np.outer(np.diag(expected.matrix), np.diag(expected.matrix)))
    np.testing.assert_allclose(other.matrix / scale, expected.matrix / scale, atol=1e-6)
    assert (result.pose_covariances(clouds)[1].matrix == other.matrix).all()


@pytest.mark.slow
def test_two_thirds_of_the_errors_are_within_one_standard_deviation(rng):
    sizes = []
    for _ in range(4):
        points, poses = parts(rng, (0.0, 0.7, 1.4, 0.5, 1.1))
        clouds, result = registered(points, poses, [(k + 1, k) for k in range(4)])
        assert len(result.pose_graph.edges) > 4
        found = result.pose_covariances(clouds)
        sizes += [np.abs(whitened(poses[k] @ np.linalg.inv(result.poses[k]), found[k])) for k in range(1, 5)]
    within = [np.mean(np.concatenate(sizes) < limit) for limit in (1, 2, 4)]
    assert 0.5 < within[0] < 0.95 and within[1] > 0.85 and within[2] == 1


def test_errors_grow_along_a_chain(rng):
    clouds, result = registered(*parts(rng, (0.0, 1.1, 2.2, 3.3)), [(k + 1, k) for k in range(3)])
    assert len(result.pose_graph.edges) == 3
    sigmas = [np.linalg.norm(found.sigmas[3:]) for found in result.pose_covariances(clouds)]
    assert sigmas[0] == 0 and (np.diff(sigmas) > 0).all()


@pytest.mark.parametrize("overlap", [0.04, -17.0])
def test_a_cloud_whose_surfaces_hardly_match_is_as_uncertain_as_it_is_large(rng, overlap):
    clouds, result = registered(*parts(rng, (0.0, 0.8, 3.0 - overlap)), [(1, 0), (2, 1)])
    _, near, far = result.pose_covariances(clouds)
    assert near.sigmas.max() < 0.01 and far.sigmas.min() > 0.3


def test_level_clouds_have_no_error_of_tilt(rng):
    points, poses = parts(rng, (0.0, 0.8, 1.6))
    clouds, result = registered(points, poses, [(1, 0), (2, 1)], free=LEVEL)
    for found in result.pose_covariances(clouds)[1:]:
        assert not found.matrix[:2].any() and not found.matrix[:, :2].any()
        assert (np.linalg.eigvalsh(found.matrix[2:, 2:]) > 0).all()


def test_covariances_at_utm_coordinates_are_those_near_zero(device, rng):
    points, poses = parts(rng, (0.0, 0.8, 1.6))
    clouds, result = registered(points, poses, [(1, 0), (2, 1)], device)
    far_poses = [about(UTM, T) for T in poses]
    far, far_result = registered([p + UTM for p in points], far_poses, [(1, 0), (2, 1)], device)
    near_found, found = result.pose_covariances(clouds), far_result.pose_covariances(far)
    for one, other in zip(near_found[1:], found[1:], strict=True):
        assert np.abs(other.center - one.center - UTM).max() < 1.5
        assert other.sigmas == pytest.approx(one.about(other.center - UTM).sigmas, rel=0.2)


def test_clouds_without_a_pose_have_an_infinite_covariance(rng):
    points, poses = parts(rng, (0.0, 0.8))
    clouds, result = registered([points[0], np.empty((0, 3)), points[1]], poses[[0, 0, 1]], [(2, 0)])
    assert result.placed.tolist() == [True, False, True]
    finite = [bool(np.isfinite(found.matrix).all()) for found in result.pose_covariances(clouds)]
    assert finite == [True, False, True]


def test_motions_that_the_surfaces_do_not_determine_are_as_uncertain_as_their_size(rng):
    planes = [np.column_stack([*rng.uniform(-1, 1, (2, 8000)), 0.004 * rng.normal(size=8000)]) for _ in range(2)]
    clouds, result = registered(planes, np.array([np.eye(4)] * 2), [(1, 0)])
    sigmas = result.pose_covariances(clouds)[1].sigmas
    assert sigmas[[2, 3, 4]].min() > 0.4 and sigmas[[0, 1, 5]].max() < 0.01
