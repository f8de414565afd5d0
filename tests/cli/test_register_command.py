"""register: poses, outputs, reports and errors."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.registration.globally import pair as pair_module
from pointloom.registration.globally.pair import METHODS
from pointloom.registration.voxel_size import choose_voxel_size

from ..registration.room_corners import ONE, OTHER, corner
from .commands import answer, chosen_device, names_in, refusal, run, unreliable
from .surface_poses import NEAR, POSE, VOXEL, bumpy, colors_at, moved, yaw_pose


@pytest.fixture
def pair(tmp_path, rng) -> tuple[Path, Path]:
    """Two parts of a surface that overlap by one third; the first is moved by POSE's inverse and has attributes."""
    points = bumpy(rng)
    target, source = points[points[:, 0] < 0.4], points[points[:, 0] > -0.4]
    paths, times = (tmp_path / "a.ply", tmp_path / "b.ply"), np.arange(len(source)) / 3
    cloud = loom.PointCloud(moved(source, np.linalg.inv(POSE)), colors=colors_at(source), time=times)
    loom.write_point_cloud(paths[0], cloud)
    loom.write_point_cloud(paths[1], loom.PointCloud(target, colors=colors_at(target)))
    return paths


def test_register_finds_the_pose_from_anywhere(pair, tmp_path, device):
    pose, aligned = tmp_path / "T.txt", tmp_path / "moved.ply"
    report = answer("register", *pair, *VOXEL, "-o", pose, "--aligned", aligned, "--device", device)
    T = np.loadtxt(pose)
    np.testing.assert_array_equal(T, report["transformation"])  # all digits
    np.testing.assert_allclose(T, POSE, atol=0.01)
    assert report["files"] == [str(pose), str(aligned)]
    assert (report["init"], report["method"], report["voxel_size"]) == ("global", "point-to-plane", 0.06)
    assert report["score"] > 0.5
    assert 0.4 < report["fitness"] < 0.8  # the overlapping half and points within 2 voxels of it
    assert abs(report["rotation_deg"] - 90) < 0.5
    source, cloud = loom.read_point_cloud(pair[0]), loom.read_point_cloud(aligned)
    np.testing.assert_allclose(cloud.points, moved(source.points, T), atol=1e-5)
    np.testing.assert_array_equal(cloud["time"], source["time"])
    np.testing.assert_array_equal(cloud.colors, source.colors)


def test_a_pose_file_starts_another_run(pair, tmp_path):
    np.savetxt(tmp_path / "T.txt", POSE @ NEAR, fmt="%.4f")
    report = answer("register", *pair, *VOXEL, "--init", tmp_path / "T.txt", "-o", tmp_path / "T.txt", "--force")
    np.testing.assert_allclose(np.loadtxt(tmp_path / "T.txt"), POSE, atol=0.01)
    assert "search" not in report["seconds"] and report["iterations"] > 3
    assert run("info", tmp_path / "T.txt").exit_code == 0


def test_register_accepts_meshes_and_kitti_scans(near, tmp_path):
    source, target = (loom.read_point_cloud(path).points for path in near)
    np.column_stack([source, np.arange(len(source))]).astype(np.float32).tofile(tmp_path / "a.bin")
    loom.write_triangle_mesh(tmp_path / "m.ply", loom.TriangleMesh(target, [[0, 1, 2]]))
    words = ["register", tmp_path / "a.bin", tmp_path / "m.ply", *VOXEL, "--init", "identity"]
    np.testing.assert_allclose(answer(*words, "--aligned", tmp_path / "c.ply")["transformation"], NEAR, atol=0.01)
    assert loom.read_point_cloud(tmp_path / "c.ply")["intensity"].tolist() == list(range(len(source)))


@pytest.mark.parametrize("method", ["point-to-point", "symmetric", "colored"])
def test_each_method_refines_a_nearby_initial_pose(near, method):
    estimated = {"symmetric": ["source", "target"], "colored": ["target"]}.get(method, [])
    assert method in METHODS
    report = answer("register", *near, *VOXEL, "--init", "identity", "--method", method)
    np.testing.assert_allclose(report["transformation"], NEAR, atol=0.01)
    assert report["normals_estimated"] == estimated and (report["normal_radius"] is None) == (not estimated)
    assert report["max_correspondence_distance"] == 0.12


def test_a_given_distance_is_used_for_a_single_scale(near):
    report = answer("register", *near, *VOXEL, "--init", "identity", "--distance", "0.2")
    clouds = [loom.read_point_cloud(path, device="auto").voxel_down_sample(0.06) for path in near]
    normals = clouds[1].estimate_normals(radius=3 * 0.06, max_nn=30)
    estimation_method = loom.registration.TransformationEstimationPointToPlane()
    expected = loom.registration.registration_icp(clouds[0], normals, 0.2, estimation_method=estimation_method)
    np.testing.assert_array_equal(report["transformation"], expected.transformation)
    assert report["iterations"] == expected.iterations


def test_the_voxel_size_is_chosen_from_the_clouds_and_reported(near, rng):
    clouds = [loom.read_point_cloud(path) for path in near]
    size = choose_voxel_size(*clouds)
    assert 0.02 < size < 0.05  # three quarters of the points are within 1 m of the center
    report = answer("register", *near, "--init", "identity")
    assert (report["voxel_size"], report["voxel_size_given"]) == (size, False)
    large = loom.PointCloud(clouds[0].points * 100)
    alone = [choose_voxel_size(cloud) for cloud in clouds]
    assert size == min(alone) and choose_voxel_size(large) == pytest.approx(100 * alone[0], rel=0.1)
    assert choose_voxel_size(*clouds, large) == max(alone)  # the median
    sparse = loom.PointCloud(rng.random((60, 3)))
    spacing = np.linalg.norm(sparse.points[:, None] - sparse.points, axis=2)
    np.fill_diagonal(spacing, np.inf)
    assert choose_voxel_size(sparse) >= np.median(spacing.min(axis=1))


def test_the_summary_describes_the_registration(near, tmp_path):
    result = run("register", *near, "--init", "identity", "-o", tmp_path / "T.txt")
    assert result.exit_code == 0, result.stderr
    assert result.stderr == ""
    rows = np.loadtxt(tmp_path / "T.txt")
    words = ["5,000 onto 5,000", "chosen from the clouds", "identity", "normals of the target estimated, radius 0."]
    words += ["converged", f"{rows[0][0]:.9f}", f"{rows[1][3]:.9f}", f"on {chosen_device()}", "T.txt"]
    assert [word for word in words if word not in result.stdout] == []


def test_the_picture_shows_both_clouds_before_and_after(near, tmp_path):
    far = tmp_path / "far.ply"
    cloud = loom.read_point_cloud(near[0])
    loom.write_point_cloud(far, cloud.transform(yaw_pose(0, 0, 0, 1)))
    answer("register", far, near[1], *VOXEL, "--picture", tmp_path / "a.png")
    image = np.asarray(Image.open(tmp_path / "a.png")).astype(int)
    assert image.shape == (960, 1928, 3)
    sides = []
    for half in (image[:, :960], image[:, 968:]):
        is_orange, is_blue = half[..., 0] - half[..., 2] > 100, half[..., 2] - half[..., 0] > 100
        assert min(is_orange.sum(), is_blue.sum()) > 5000
        sides.append(abs(np.argwhere(is_orange).mean(axis=0) - np.argwhere(is_blue).mean(axis=0)).max())
    assert sides[0] > 60 > 20 > sides[1]  # [px] apart before, together after


def test_map_coordinates_lose_no_accuracy(near, tmp_path):
    offset = np.array([5e5, 5.4e6, 300])
    for path in near:
        cloud = loom.read_point_cloud(path)
        loom.write_point_cloud(path, loom.PointCloud(cloud.points + offset), overwrite=True)
    expected = yaw_pose(0, *offset) @ NEAR @ yaw_pose(0, *-offset)
    report = answer("register", *near, *VOXEL, "--init", "identity", "--aligned", tmp_path / "c.ply")
    T = np.array(report["transformation"])
    np.testing.assert_allclose(moved(offset, T), moved(offset, expected), atol=0.01)
    assert report["shift_m"] < 0.1  # measured at the cloud, not at the origin
    aligned, source = loom.read_point_cloud(tmp_path / "c.ply").points, loom.read_point_cloud(near[0]).points
    np.testing.assert_allclose(aligned, moved(source, T), atol=1e-5)


def test_surfaces_that_do_not_overlap_are_unreliable_and_written(pair, tmp_path):
    np.savetxt(tmp_path / "T.txt", yaw_pose(120, 0.3, 0.3, 0) @ POSE)
    report = unreliable("register", *pair, *VOXEL, "--init", tmp_path / "T.txt", "-o", tmp_path / "out.txt")
    assert "not above 0.5: the surfaces hardly overlap; try --init global" in str(report["warnings"])
    assert report["score"] < 0.5
    np.testing.assert_array_equal(np.loadtxt(tmp_path / "out.txt"), report["transformation"])


@pytest.mark.parametrize("init", ["identity", "global"])
def test_scans_that_share_only_walls_are_unreliable(tmp_path, rng, init):
    paths = tmp_path / "a.ply", tmp_path / "b.ply"
    for path, boxes in zip(paths, (ONE, OTHER), strict=True):
        loom.write_point_cloud(path, loom.PointCloud(corner(rng, boxes, 20000)))
    report = unreliable("register", *paths, *VOXEL, "--init", init)
    assert report["score"] < 0.1 and report["fitness"] > 0.3
    assert init == "identity" or "three planes" in str(report["warnings"])


def test_without_a_correspondence_nothing_is_written(pair, tmp_path):
    outputs = ["-o", tmp_path / "T.txt", "--aligned", tmp_path / "c.ply", "--picture", tmp_path / "p.png"]
    report = unreliable("register", *pair, *VOXEL, "--init", "identity", *outputs)
    assert report["files"] == []
    assert "no point of the source has a correspondence; nothing was written" in str(report["warnings"])
    assert names_in(tmp_path) == ["a.ply", "b.ply"]


def test_a_small_share_of_correspondences_or_a_score_of_a_half_is_unreliable(near, tmp_path, monkeypatch):
    target = loom.read_point_cloud(near[1]).points
    far = moved(target, yaw_pose(0, 0, 0, 50))
    loom.write_point_cloud(tmp_path / "c.ply", loom.PointCloud(np.vstack([target[:80], far])))
    report = unreliable("register", tmp_path / "c.ply", near[1], *VOXEL, "--init", "identity")
    assert 0 < report["fitness"] < 0.1
    assert "of the source, less than 10%, has a correspondence" in str(report["warnings"])
    monkeypatch.setattr(pair_module, "rate_registration", lambda *_: 0.5)
    assert unreliable("register", *near, *VOXEL, "--init", "identity")["score"] == 0.5


def test_outputs_are_checked_before_the_clouds_are_read(tmp_path):
    for option, name, why in (
        ("-o", "T.log", "poses are not written to .log"),
        ("--aligned", "c.docx", "clouds are not written to .docx"),
        ("--picture", "p.jpg", "expected .png or .webp"),
        ("-o", "none/T.txt", "the folder"),
    ):
        assert why in refusal("register", tmp_path / "no.ply", tmp_path / "no.ply", option, tmp_path / name)


def test_existing_outputs_are_not_overwritten_without_force(near, tmp_path):
    for option, name in (("-o", "T.txt"), ("--aligned", "c.ply")):
        (tmp_path / name).write_bytes(b"kept")
        words = ["register", *near, *VOXEL, "--init", "identity", option, tmp_path / name]
        assert f"{name}: exists already" in refusal(*words) and (tmp_path / name).read_bytes() == b"kept"
        answer(*words, "--force")
        assert (tmp_path / name).read_bytes() != b"kept"


def test_clouds_that_cannot_be_registered_are_named(near, tmp_path):
    write, bad = loom.write_point_cloud, tmp_path / "bad.ply"
    for points, why in (
        (np.empty((0, 3)), "bad.ply: expected finite points, got no points"),
        (np.full((4, 3), np.nan), "bad.ply: expected finite points, got 4 points, all of them not finite"),
        (np.eye(3), "bad.ply: has points in 3 voxels of 0.06 m, and 10 are needed. Use a smaller --voxel"),
        (np.ones((50, 3)), "bad.ply: has points in 1 voxel of 0.06 m"),
    ):
        write(bad, loom.PointCloud(points), overwrite=True)
        assert why in refusal("register", near[0], bad, *VOXEL) and why in refusal("register", bad, near[0], *VOXEL)
    assert "has points in 1 voxel of 1 m" in refusal("register", bad, bad)
    write(bad, loom.PointCloud(loom.read_point_cloud(near[0]).points), overwrite=True)
    refused = refusal("register", near[0], bad, "--method", "colored")
    assert "bad.ply: has no colors, which --method colored needs" in refused
    bad.write_bytes(near[0].read_bytes()[:-1])
    assert refusal("register", near[0], bad, "-o", tmp_path / "T.txt").startswith(f"error: {bad}")
    assert names_in(tmp_path) == ["a.ply", "b.ply", "bad.ply"]


def test_an_invalid_initial_pose_is_an_error(near, tmp_path):
    start = tmp_path / "T.txt"
    for rows, why in ((3, "expected 4 rows of a pose, got 3"), (4, "expected a rigid motion")):
        start.write_text("1 0 0 0\n" * rows)
        assert why in refusal("register", *near, "--init", start)


def test_fixed_degrees_of_freedom_keep_their_initial_values(near, tmp_path):
    np.savetxt(tmp_path / "start.txt", np.eye(4))
    report = answer("register", *near, *VOXEL, "--init", tmp_path / "start.txt", "--free", "x,y,z,yaw")
    T = np.array(report["transformation"])
    assert (T[2, :3] == [0, 0, 1]).all() and set(report["free"]) == {"x", "y", "z", "yaw"}
    np.testing.assert_allclose(T, NEAR, atol=0.06)
    assert answer("register", *near, *VOXEL, "--init", "identity")["free"] is None
    searched = answer("register", *near, *VOXEL, "--free", "x, y, z, yaw")
    assert np.array(searched["transformation"])[2, 2] == 1


def test_a_prior_pose_constrains_a_plane(tmp_path, rng):
    floor = np.column_stack([rng.uniform(-2, 2, (4000, 2)), rng.normal(0, 1e-3, 4000)])
    paths = tmp_path / "a.ply", tmp_path / "b.ply"
    for path, shift in zip(paths, (0.1, 0.0), strict=True):
        loom.write_point_cloud(path, loom.PointCloud(floor - [shift, 0, 0]))
    known = np.eye(4)
    known[0, 3] = 0.1
    np.savetxt(tmp_path / "gnss.txt", known)
    prior = "--prior", tmp_path / "gnss.txt", "--prior-sigma", "0.05", "1"
    report = unreliable("register", *paths, "--voxel", 0.1, "--init", "identity", *prior)  # planes are no evidence
    assert len(report["prior_directions"]) == 3
    np.testing.assert_allclose(np.array(report["transformation"])[:3, 3], [0.1, 0, 0], atol=0.01)
