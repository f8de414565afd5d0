"""The scale and pose of a structure-from-motion model from other known data."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration.rigid import fit_pose
from pointloom.registration.trajectories.similarity import fit_to_positions, read_positions, scale_from_known

from ..io.sfm_models import LENS, ring_model

ROTATION = ring_model().T_camera_world[2, :3, :3]


def similarity(scale: float = 3.5, shift=(10.0, -20.0, 5.0)) -> np.ndarray:
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = scale * ROTATION, shift
    return T


def curved_path(count: int = 40, *, seed: int = 0) -> loom.SfmModel:
    """Cameras along a curve, without points."""
    rng = np.random.default_rng(seed)
    s = np.linspace(0, 6, count)
    centers = np.stack([s, np.sin(s), 0.3 * np.cos(2 * s)], axis=1) + 0.01 * rng.normal(size=(count, 3))
    poses = np.tile(np.eye(4), (count, 1, 1))
    poses[:, :3, 3] = -centers
    return loom.SfmModel([f"frame_{i:04d}.png" for i in range(count)], [LENS] * count, poses)


def positions_of(model: loom.SfmModel, T: np.ndarray) -> dict[str, np.ndarray]:
    return dict(zip(model.names, model.centers @ T[:3, :3].T + T[:3, 3], strict=True))


def test_a_known_distance_gives_the_scale():
    model = curved_path()
    factor = scale_from_known(model, "frame_0003.png", "frame_0030.png", 7.5)
    scaled = model.scaled(factor)
    a, b = (scaled.centers[model.index_of(name)] for name in ("frame_0003.png", "frame_0030.png"))
    assert np.linalg.norm(a - b) == pytest.approx(7.5)


def test_a_distance_can_be_between_points():
    assert scale_from_known(curved_path(), [0, 0, 0], [0, 0.25, 0], 1.0) == 4.0


@pytest.mark.parametrize("scale", [1e-5, 3.5, 1e5])
@pytest.mark.parametrize("shift", [(0.0, 0.0, 0.0), (5e5, 5.4e6, 100.0)])
def test_exact_positions_give_the_similarity(scale, shift):
    model, T = curved_path(), similarity(scale, shift)
    fit = fit_to_positions(model, positions_of(model, T))
    assert fit.scale == pytest.approx(scale, rel=1e-8 + 1e-9 * max(shift) / scale)
    assert fit.inliers.all()
    assert fit.rmse <= 1e-9 * scale + 1e-8 * (max(shift) > 0)
    moved = model.transform(fit.transformation)
    wanted = np.array(list(positions_of(model, T).values()))
    assert np.abs(moved.centers - wanted).max() <= 1e-9 * scale + 1e-8 * (max(shift) > 0)


@pytest.mark.parametrize("wrong", [0, 4, 12, 18])
@pytest.mark.parametrize("limit", [None, 0.2])
def test_wrong_positions_are_detected_and_excluded(wrong, limit):
    model, T = curved_path(), similarity()
    rng = np.random.default_rng(wrong)
    positions = positions_of(model, T)
    for name in positions:
        positions[name] = positions[name] + rng.normal(0, 0.03, 3)
    far = sorted(rng.choice(model.names, wrong, replace=False))
    for name in far:
        positions[name] = positions[name] + rng.normal(0, 30, 3)
    fit = fit_to_positions(model, positions, max_error=limit)
    assert set(far).isdisjoint(np.array(fit.names)[fit.inliers])
    assert fit.inliers.sum() >= 0.85 * (len(model) - wrong)
    right = fit.inliers
    best = fit_pose(model.centers[right], np.array(list(positions.values()))[right], with_scaling=True)
    assert np.abs(best - fit.transformation).max() < 1e-9
    assert fit.scale == pytest.approx(3.5, rel=0.01)
    assert 0.02 < fit.rmse < 0.08
    assert (fit.residuals[~np.isin(fit.names, far)] < 0.25).all()


def test_few_positions_of_some_images_suffice():
    model, T = curved_path(), similarity()
    known = positions_of(model, T)
    some = {name: known[name] for name in model.names[::15]} | {"elsewhere.png": (0, 0, 0)}
    fit = fit_to_positions(model, some)
    assert fit.names == tuple(model.names[::15])
    assert np.abs(fit.transformation - T).max() < 1e-8


def test_the_result_is_reproducible():
    model = curved_path(200)
    rng = np.random.default_rng(1)
    known = {n: p + rng.normal(0, 0.1, 3) for n, p in positions_of(model, similarity()).items()}
    a, b = (fit_to_positions(model, known, seed=3) for _ in range(2))
    assert np.array_equal(a.transformation, b.transformation)
    assert np.array_equal(a.residuals, b.residuals)


@pytest.mark.slow
def test_the_rotation_uncertainty_matches_many_trials():
    """About the axis of an almost straight path it is large, and the reported value matches."""
    model = curved_path(30)
    thin = np.diag([1.0, 0.02, 0.02, 1.0])
    poses = model.T_camera_world.copy()
    poses[:, :3, 3] = poses[:, :3, 3] @ thin[:3, :3]
    model = loom.SfmModel(model.names, model.cameras, poses)
    rng = np.random.default_rng(0)
    angles, uncertainties = [], []
    for _ in range(60):
        known = {n: p + rng.normal(0, 0.005, 3) for n, p in positions_of(model, np.eye(4)).items()}
        fit = fit_to_positions(model, known, max_error=1.0)
        R = fit.transformation[:3, :3] / fit.scale
        angles.append(np.degrees((R[2, 1] - R[1, 2]) / 2))
        uncertainties.append(fit.rotation_uncertainty)
    assert np.std(angles) == pytest.approx(np.median(uncertainties), rel=0.5)
    assert np.median(uncertainties) > 1.0


def test_cameras_on_a_line_are_rejected():
    model = curved_path()
    line = {name: (i, 2.0 * i, 0.0) for i, name in enumerate(model.names)}
    with pytest.raises(ValueError, match="positions:"):
        fit_to_positions(model, line)
    with pytest.raises(ValueError, match="positions:"):
        fit_to_positions(model, dict.fromkeys(model.names, (1.0, 2.0, 3.0)))
    still = loom.SfmModel(model.names, model.cameras, np.tile(np.eye(4), (len(model), 1, 1)))
    with pytest.raises(ValueError, match="model:"):
        fit_to_positions(still, positions_of(model, np.eye(4)))


def test_a_file_of_names_and_positions_is_read(tmp_path):
    names = ("left/IMG 1.JPG", "left/IMG_2.JPG", "right/IMG_3.JPG")
    path = tmp_path / "known.txt"
    path.write_text("# name x y z\nleft/IMG 1.JPG 1 2 3\nIMG_2 4,5,6\nright/IMG_3,7,8,9\nother.jpg 0 0 0\n")
    positions = read_positions(path, names)
    assert [positions[name].tolist() for name in names] == [[1, 2, 3], [4, 5, 6], [7, 8, 9]]
    assert len(positions) == 3


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a.png 1 2\n", "line 1.*name and three numbers, got 3"),
        ("a.png 1 2 x\n", "line 1.*not a number"),
        ("a.png 1 2 nan\n", "line 1.*finite"),
        ("a.png 1 2 3\na 1 2 3\n", "line 2.*'a.png' is duplicated"),
        ("b 1 2 3\n", r"line 1.*may be b.jpg or b.png"),
        ("z.png 1 2 3\n", "contains no name of a picture of the model.*'a.png'"),
        ("", "contains no pose"),
    ],
)
def test_an_invalid_position_file_is_rejected(tmp_path, text, message):
    path = tmp_path / "known.txt"
    path.write_text(text)
    with pytest.raises(loom.FileError, match=message):
        read_positions(path, ("a.png", "b.jpg", "b.png"))


@pytest.mark.parametrize("kind", ["known.log", "known.tum", "known.txt"])
def test_trajectory_poses_are_matched_to_images_by_number(tmp_path, kind):
    """Every fifth frame of a video was chosen, and the trajectory has all frames."""
    names = tuple(f"frame_{i:06d}.color.png" for i in range(0, 50, 5))
    poses = np.tile(np.eye(4), (50, 1, 1))
    poses[:, 0, 3] = np.arange(50)
    ids = np.stack([np.arange(50)] * 2 + [np.arange(1, 51)], axis=1)
    path = tmp_path / kind
    loom.write_trajectory(path, loom.Trajectory(poses, ids=ids), format="log" if kind.endswith("log") else "tum")
    assert [read_positions(path, names)[name][0] for name in names] == list(range(0, 50, 5))


def test_times_of_a_trajectory_can_be_image_names(tmp_path):
    names = ("1305031102.175304.png", "1305031102.211214.png", "1305031102.275326.png")
    times = [1305031102.175304, 1305031102.211214, 1305031102.275326]
    poses = np.tile(np.eye(4), (3, 1, 1))
    poses[:, 1, 3] = [1, 2, 3]
    loom.write_trajectory(tmp_path / "t.tum", loom.Trajectory(poses[::-1], timestamps=times[::-1]))
    assert [read_positions(tmp_path / "t.tum", names)[name][1] for name in names] == [1, 2, 3]


def test_a_trajectory_without_numbers_is_matched_by_order_if_the_counts_agree(tmp_path):
    poses = np.tile(np.eye(4), (3, 1, 1))
    poses[:, 2, 3] = [4, 5, 6]
    loom.write_trajectory(tmp_path / "t.kitti", loom.Trajectory(poses))
    positions = read_positions(tmp_path / "t.kitti", ("a.png", "b.png", "c.png"))
    assert [position[2] for position in positions.values()] == [4, 5, 6]
    with pytest.raises(loom.FileError, match=r"/t\.kitti:.*3.*2"):
        read_positions(tmp_path / "t.kitti", ("a.png", "b.png"))
