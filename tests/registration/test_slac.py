"""SLAC aligns fragments: camera distortion is removed, undistorted fragments stay, problems are reported."""

import dataclasses
from unittest.mock import Mock

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.poses import fragment_rows
from pointloom.kernels.search import nearest_point
from pointloom.registration import PoseGraph, PoseGraphEdge, PoseGraphNode
from pointloom.registration.deformable.slac import run_rigid_optimizer_for_fragments
from pointloom.registration.rigid import fit_pose, invert_pose, pose_of

from .bent_fragments import BentRoom, moved
from .poses import as_pose

slac = loom.rgbd


@pytest.fixture(scope="module")
def bent():
    return BentRoom(bend=0.02)


@pytest.fixture(scope="module")
def straight():
    return BentRoom(bend=0.0)


@pytest.fixture(scope="module")
def aligned(bent):
    rigid = run_rigid_optimizer_for_fragments(bent.clouds, bent.graph)
    return rigid, *slac.run_slac_optimizer_for_fragments(bent.clouds, bent.graph)


@pytest.mark.slow
def test_distorted_fragments_agree_after_calibration(aligned):
    rigid, solved, _ = aligned
    assert solved.report.rmse[0] == rigid.report.rmse[0] > 0.012
    assert solved.report.rmse[-1] < 0.35 * rigid.report.rmse[-1] < 0.35 * rigid.report.rmse[0]


def test_the_returned_grid_and_poses_are_consistent():
    T = pose_of(np.array([0, 0, 2.0, 0.1, 0.2, 0.1]))
    views = corner(1000), moved(invert_pose(T), corner(1000, seed=1))
    clouds = [loom.PointCloud(points + 0.05 * points[:, 2:] * points) for points in views]
    graph = PoseGraph([PoseGraphNode(), PoseGraphNode(T)], [PoseGraphEdge(0, 1)])
    solved, grid = slac.run_slac_optimizer_for_fragments(clouds, graph)
    straight, still = [grid.deform(cloud) for cloud in clouds], slac.SLACOptimizerParams(max_iterations=0)
    measured = run_rigid_optimizer_for_fragments(straight, solved, still)
    assert measured.report.rmse[0] == pytest.approx(solved.report.rmse[-1], rel=0.01)


@pytest.mark.slow
def test_the_surface_is_closer_to_the_truth_than_with_rigid_fragments(bent, aligned):
    rigid, solved, grid = aligned
    assert bent.error(solved, grid) < 0.6 * bent.error(rigid)


@pytest.mark.slow
def test_the_grid_recovers_the_camera_distortion(bent, aligned):
    """Up to a rigid motion, which belongs to the poses, and to a scale, which fragments do not determine."""
    _, _, grid = aligned
    points, truths = (np.concatenate(a) for a in (bent.points, bent.truths))
    deformed = np.concatenate([grid.deform(cloud).points for cloud in bent.clouds])
    before, after = (moved(fit_pose(p, truths, with_scaling=True), p) - truths for p in (points, deformed))
    assert np.sqrt((after**2).sum(axis=1).mean()) < 0.5 * np.sqrt((before**2).sum(axis=1).mean())


@pytest.mark.slow
def test_undistorted_fragments_stay_undistorted(straight):
    solved, grid = slac.run_slac_optimizer_for_fragments(straight.clouds, straight.graph)
    shifts = np.linalg.norm(grid.get_curr_positions() - grid.get_init_positions(), axis=1)
    assert np.median(shifts) < 0.001 and shifts.max() < 0.005 and straight.error(solved, grid) < 0.002


@pytest.mark.slow
@pytest.mark.parametrize("bends", [True, False], ids=["bent", "rigid"])
def test_pose_errors_are_corrected(straight, bends):
    rng = np.random.default_rng(1)
    nodes = [PoseGraphNode(T @ pose_of(rng.normal(size=6) * (i > 0) * 0.01)) for i, T in enumerate(straight.poses)]
    graph = PoseGraph(nodes, straight.graph.edges)
    if bends:
        solved, _ = slac.run_slac_optimizer_for_fragments(straight.clouds, graph)
    else:
        solved = run_rigid_optimizer_for_fragments(straight.clouds, graph)
    poses = (np.array([node.pose for node in current]) for current in (nodes, solved.nodes))
    off, left = (np.abs(np.linalg.inv(straight.poses) @ T - np.eye(4)).max(axis=(1, 2)) for T in poses)
    assert left.max() < 0.006 < 0.015 < off.max() and np.median(left) < 0.3 * np.median(off)


def test_the_first_fragment_keeps_its_pose_and_the_input_graph_is_unchanged():
    clouds, given = two()
    before = [node.pose.copy() for node in given.nodes]
    bent = slac.run_slac_optimizer_for_fragments(clouds, given)[0]
    for graph in (run_rigid_optimizer_for_fragments(clouds, given), bent):
        assert np.abs(graph.nodes[0].pose - before[0]).max() < 1e-12
        assert np.abs(graph.nodes[1].pose - np.eye(4)).max() < 1e-3, "the surfaces are brought together"
        assert [(e.source_node_id, e.target_node_id) for e in graph.edges] == [(0, 1)]
    assert given.report is None and all((node.pose == T).all() for node, T in zip(given.nodes, before, strict=True))


@pytest.mark.slow
def test_results_are_reproducible_and_equal_for_files(bent, aligned, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    _, first, first_grid = aligned
    second, grid = slac.run_slac_optimizer_for_fragments(bent.clouds, bent.graph)
    assert (grid.get_curr_positions() == first_grid.get_curr_positions()).all()
    assert all((a.pose == b.pose).all() for a, b in zip(first.nodes, second.nodes, strict=True))
    assert not list(tmp_path.iterdir())


def corner(count=2500, seed=0, at=(0.3, 0.3, 0.3)):
    """Points on three walls that meet, one meter wide."""
    points = np.random.default_rng(seed).random((3 * count, 3))
    points.reshape(3, count, 3)[range(3), :, range(3)] = 0
    return points + at


def two(offset=0.01, at=(0.3, 0.3, 0.3)):
    """Two views of one corner, the second with a small pose error; and their graph."""
    graph = PoseGraph([PoseGraphNode(), PoseGraphNode(as_pose(shift=[offset] * 3))], [PoseGraphEdge(0, 1)])
    return [loom.PointCloud(corner(seed=s, at=at)) for s in (0, 1)], graph


def test_fragments_run_on_every_device(device, monkeypatch):
    monkeypatch.setattr(nearest_point, "order_along_curve", None)  # not called: one order of each fragment is enough
    monkeypatch.setattr(fragment_rows, "order_along_curve", Mock(wraps=fragment_rows.order_along_curve))
    clouds, graph = two()
    solved, grid = slac.run_slac_optimizer_for_fragments([c.to(device) for c in clouds], graph)
    assert np.abs(solved.nodes[1].pose - np.eye(4)).max() < 1e-3 and str(grid.device) == device
    bent = grid.deform(clouds[0].to(device).estimate_normals(max_nn=10))
    assert np.abs(bent.points - clouds[0].points).max() < 2e-3 and len(bent.normals) == len(bent)
    assert fragment_rows.order_along_curve.call_count == len(graph.edges)


def test_the_grid_has_cells_of_the_requested_size():
    clouds, graph = two()
    for size in (0.25, 0.5):
        params = slac.SLACOptimizerParams(grid_size=size, max_iterations=1)
        _, grid = slac.run_slac_optimizer_for_fragments(clouds, graph, params)
        steps = np.diff(np.unique(np.round(grid.get_init_positions()[:, 0], 6)))
        assert grid.grid_size == size and steps == pytest.approx(size)


@pytest.mark.parametrize(
    ("options", "used"),
    [
        ({}, True),
        ({"fitness_threshold": 0.5}, True),
        ({"fitness_threshold": 0.7}, False),
        ({"distance_threshold": 0.02}, False),
    ],
)
def test_edges_are_used_by_their_distances_and_fitness(options, used):
    """A rotation of 0.1 rad: 60 % of the pairs move by less than 0.07 m, 14 % by less than 0.02 m."""
    clouds, graph = two(at=(0, 0, 0))
    clouds.append(loom.PointCloud(corner(seed=2, at=(0, 0, 0))))
    graph.nodes.append(PoseGraphNode(as_pose([0, 0, 0.1])))
    graph.edges += [PoseGraphEdge(1, 2), PoseGraphEdge(0, 2)]
    solved = run_rigid_optimizer_for_fragments(clouds, graph, slac.SLACOptimizerParams(**options))
    assert [overlap.used for overlap in solved.report.overlaps] == [True, True, used]


def test_options_of_deformed_depth_are_those_of_clouds_and_images():
    """The grid moves all points by 2 cm along the view of a rotated camera."""
    camera = loom.PinholeCameraIntrinsic(32, 24, 40.0, 40.0, 15.5, 11.5)
    depth = np.where(np.arange(32) < 16, 2000, 3000).astype(np.uint16) * np.ones((24, 1), np.uint16)
    extrinsic = as_pose([0, np.pi / 2, 0], [0, 0, 0.5])
    grid = slac.ControlGrid(0.5)
    grid.touch(loom.PointCloud.create_from_depth_image(depth, camera, extrinsic, 500.0, 7.0))
    grid.set_positions(grid.get_init_positions() + invert_pose(extrinsic)[:3, :3] @ [0, 0, 0.02])
    image = loom.RGBDImage(np.zeros((24, 32, 3), np.uint8), depth, depth_scale=500.0, depth_trunc=7.0)
    for limit, far in ((7.0, 6.02), (5.0, 0.0)):
        results = (
            grid.deform_depth(depth, camera, extrinsic, 500.0, limit),
            grid.deform_rgbd(image, camera, extrinsic, depth_max=limit).depth,
        )
        for result in results:
            np.testing.assert_allclose(result, np.where(depth == 2000, 4.02, far), rtol=1e-6)


def test_a_stiffer_grid_bends_less():
    clouds, graph = two()
    clouds[1] = loom.PointCloud(clouds[1].points * [1, 1, 1.03])
    shifts = []
    for weight in (0.1, 10.0):
        params = slac.SLACOptimizerParams(regularizer_weight=weight)
        _, grid = slac.run_slac_optimizer_for_fragments(clouds, graph, params)
        moves = grid.get_curr_positions() - grid.get_init_positions()
        shifts.append(np.linalg.norm(moves - moves.mean(axis=0), axis=1).max())
    assert shifts[1] < 0.7 * shifts[0]


def test_stray_points_are_removed():
    clouds, graph = two()
    _, grid = slac.run_slac_optimizer_for_fragments(clouds, graph)
    stray = [loom.PointCloud(np.concatenate([c.points, [[30.0, 5, 5], [-20, 8, 0]]])) for c in clouds]
    _, with_stray = slac.run_slac_optimizer_for_fragments(stray, graph)
    assert len(with_stray) == len(grid)


def test_large_coordinates_change_nothing(tolerances):
    far = np.array([5e5, 4.6e6, 300.0])
    (clouds, graph), (away, there) = two(), two(at=far + 0.3)
    near, grid = slac.run_slac_optimizer_for_fragments(clouds, graph)
    gone, far_grid = slac.run_slac_optimizer_for_fragments(away, there)
    for a, b in zip(near.nodes, gone.nodes, strict=True):
        moves = moved(b.pose, far[None])[0] - far - a.pose[:3, 3]
        assert np.abs(a.pose[:3, :3] - b.pose[:3, :3]).max() < 5e-4 and np.abs(moves).max() < 1e-3
    assert (far_grid.origin != 0).any() and grid.origin.tolist() == [0, 0, 0]


def test_an_edge_that_contradicts_the_poses_is_pruned_and_reported():
    clouds, graph = two()
    clouds, wrong = [*clouds, loom.PointCloud(corner(seed=2))], as_pose(shift=[0.5, 0, 0])
    graph.nodes.append(PoseGraphNode())
    graph.edges += [PoseGraphEdge(1, 2), PoseGraphEdge(0, 2, wrong)]
    solved = run_rigid_optimizer_for_fragments(clouds, graph)
    assert [overlap.used for overlap in solved.report.overlaps] == [True, True, False]
    assert solved.report.overlaps[2].fitness < 0.3 and solved.report.overlaps[2].correspondences == 0
    assert solved.report.overlaps[0].correspondences > 500


@pytest.mark.parametrize("run", [slac.run_slac_optimizer_for_fragments, run_rigid_optimizer_for_fragments])
def test_fragments_that_overlap_with_no_other_are_reported(run):
    def report_of(clouds, graph):
        solved = run(clouds, graph)
        return (solved[0] if isinstance(solved, tuple) else solved).report

    clouds, graph = two()
    assert report_of(clouds, graph).reliable
    graph.nodes.append(PoseGraphNode(as_pose(shift=[40.0, 0, 0])))
    graph.edges.append(PoseGraphEdge(1, 2, as_pose(shift=[40.0, 0, 0])))
    report = report_of([*clouds, clouds[0]], graph)
    assert not report.reliable and "1 fragments (2) overlap with no other" in report.warnings[0]
    unused = [overlap._replace(used=False) for overlap in report.overlaps]
    assert "no two fragments overlap at their poses" in dataclasses.replace(report, overlaps=unused).warnings[0]
    assert "farther apart than before" in str(dataclasses.replace(report, rmse=np.array([0.1, 0.2])).warnings)


def test_unconnected_fragments_stay():
    clouds, graph = two()
    clouds += [loom.PointCloud(corner(seed=2)) for _ in range(2)]
    T = pose_of(np.array([0.1, 0.2, 0.3, 4, 5, 6]))
    graph.nodes += [PoseGraphNode(T), PoseGraphNode(T @ T)]
    solved, _ = slac.run_slac_optimizer_for_fragments(clouds, graph)
    assert np.abs(solved.nodes[2].pose - T).max() < 1e-12 and np.abs(solved.nodes[3].pose - T @ T).max() < 1e-12
    alone, grid = slac.run_slac_optimizer_for_fragments(clouds[:1], PoseGraph([PoseGraphNode(T)]))
    assert np.abs(alone.nodes[0].pose - T).max() < 1e-12
    assert (grid.get_curr_positions() == grid.get_init_positions()).all()


def test_fragments_can_be_files(tmp_path):
    clouds, graph = two()
    for i, cloud in enumerate(clouds):
        loom.write_point_cloud(tmp_path / f"{i}.pcd", cloud)
    steps = []
    paths = [tmp_path / "0.pcd", str(tmp_path / "1.pcd")]
    read = run_rigid_optimizer_for_fragments(paths, graph, progress=lambda *step: steps.append(step))
    given = run_rigid_optimizer_for_fragments(clouds, graph)
    assert np.abs(read.nodes[1].pose - given.nodes[1].pose).max() < 1e-6
    assert steps == [("slac", i, 5) for i in range(6)]


def test_a_grid_deforms_depth_like_points(device):
    camera = loom.PinholeCameraIntrinsic(32, 24, 40.0, 40.0, 15.5, 11.5)
    depth = np.full((24, 32), 2000, np.uint16)
    depth[:3] = 0
    grid = slac.ControlGrid(0.5, device=device)
    cloud = loom.PointCloud.create_from_depth_image(depth, camera, device=device)
    grid.touch(cloud)
    assert (grid.deform_depth(depth, camera) == depth / np.float32(1000)).all()
    grid.set_positions(1.25 * grid.get_init_positions())
    assert np.abs(grid.deform_depth(depth, camera)[3:] - 2.5).max() < 1e-6
    color = np.arange(24 * 32 * 3, dtype=np.uint8).reshape(24, 32, 3)
    deformed = grid.deform_rgbd(loom.RGBDImage(color, depth, device=device), camera)
    assert np.abs(deformed.depth[3:] - 2.5).max() < 1e-6 and (deformed.color[3:] == color[3:]).all()


def test_a_grid_that_is_extended_keeps_its_shifts():
    grid = slac.ControlGrid(1.0)
    assert len(grid) == 0 and grid.get_curr_positions().shape == (0, 3)
    grid.touch(loom.PointCloud([[0.5, 0.5, 0.5]]))
    grid.set_positions(np.add(grid.get_init_positions(), [0.1, 0, 0]))
    grid.touch(loom.PointCloud([[1.5, 0.5, 0.5], [np.nan, 0, 0]]))
    shifts = grid.get_curr_positions() - grid.get_init_positions()
    assert len(grid) == 12 and np.abs(shifts[:8, 0] - 0.1).max() < 1e-12 and not shifts[8:].any()


def test_a_cloud_keeps_its_attributes(rng):
    grid, cloud = slac.ControlGrid(1.0), loom.PointCloud(rng.random((50, 3)), label=np.arange(50))
    grid.touch(cloud)
    cloud = cloud.estimate_covariances()
    bent = grid.deform(cloud)
    assert (bent["label"] == np.arange(50)).all() and "covariances" not in bent and "covariances" in cloud
    assert (bent.points == cloud.points).all()
