"""Structure-from-motion models: consistent selection, and rejected arguments."""

import copy
import pickle

import numpy as np
import pytest

import pointloom as loom

from .sfm_models import LENS, assert_same, ring_model

MODEL = ring_model()


def reprojections(model: loom.SfmModel) -> np.ndarray:
    seen = np.empty_like(model.pixels)
    for i, camera in enumerate(model.cameras):
        rows = model.observations[:, 0] == i
        T = model.T_camera_world[i]
        seen[rows] = camera.project(model.points[model.observations[rows, 1]] @ T[:3, :3].T + T[:3, 3])
    return seen


def test_pictures_are_sorted_by_name_with_all_that_belongs_to_them():
    order = [3, 1, 5, 0, 4, 2]
    rows = np.column_stack([np.argsort(order)[MODEL.observations[:, 0]], MODEL.observations[:, 1]])
    pictures = [MODEL.names[i] for i in order], [MODEL.cameras[i] for i in order], MODEL.T_camera_world[order]
    points = MODEL.points, MODEL.colors, MODEL.errors
    shuffled = loom.SfmModel(*pictures, *points, rows[::-1], MODEL.pixels[::-1])
    assert shuffled.names == tuple(sorted(MODEL.names))
    assert_same(shuffled, MODEL)


@pytest.mark.parametrize("scale", [1e-6, 1.0, 37.0, 1e6])
@pytest.mark.parametrize("far", [0.0, 5e6])
def test_a_moved_model_is_seen_as_before(scale, far):
    T = np.eye(4)
    T[:3, :3] = scale * MODEL.T_camera_world[2, :3, :3]
    T[:3, 3] = [far, -far, 3.0]
    moved = MODEL.transform(T)
    assert np.abs(moved.centers - (MODEL.centers @ T[:3, :3].T + T[:3, 3])).max() <= 1e-9 * max(scale, far, 1)
    slack = 1e-9 + 1e-12 * far / scale
    assert np.abs(reprojections(moved) - reprojections(MODEL)).max() < 500 * slack
    R = moved.T_camera_world[:, :3, :3]
    assert np.abs(R @ R.transpose(0, 2, 1) - np.eye(3)).max() < 1e-13


def test_centers_follow_from_poses_and_scaling_is_inverted_by_the_inverse_scale():
    for center, T in zip(MODEL.centers, MODEL.T_camera_world, strict=True):
        assert np.abs(T[:3, :3] @ center + T[:3, 3]).max() < 1e-14
    assert np.abs(MODEL.T_world_camera @ MODEL.T_camera_world - np.eye(4)).max() < 1e-14
    assert_same(MODEL.scaled(8.0).scaled(0.125), MODEL)
    larger = MODEL.scaled(2.0)
    assert np.array_equal(larger.centers, 2 * MODEL.centers) and np.array_equal(larger.points, 2 * MODEL.points)
    assert np.array_equal(larger.pixels, MODEL.pixels)


def test_selected_pictures_keep_their_observed_points():
    names = [MODEL.names[4], MODEL.names[1]]
    part = MODEL.select(names)
    assert part.names == tuple(sorted(names))
    assert np.array_equal(np.unique(part.observations[:, 1]), np.arange(len(part.points)))
    selected = np.isin(MODEL.observations[:, 0], [1, 4])
    assert np.array_equal(part.points[part.observations[:, 1]], MODEL.points[MODEL.observations[selected, 1]])
    assert np.array_equal(reprojections(part), reprojections(MODEL)[selected]) and len(MODEL.select([])) == 0


def test_poses_go_out_as_a_trajectory(tmp_path):
    for name in ("poses.log", "poses.tum", "poses.kitti"):
        loom.write_trajectory(tmp_path / name, MODEL.trajectory())
        back = loom.read_trajectory(tmp_path / name)
        assert np.abs(back.poses - MODEL.T_world_camera).max() < 1e-14
    times = np.arange(6) / 30
    loom.write_trajectory(tmp_path / "times.tum", MODEL.trajectory(times))
    assert np.array_equal(loom.read_trajectory(tmp_path / "times.tum").timestamps, times)
    assert loom.read_trajectory(tmp_path / "poses.log").ids[:, 0].tolist() == list(range(6))


def test_points_go_out_as_a_cloud(tmp_path):
    cloud = MODEL.point_cloud()
    loom.write_point_cloud(tmp_path / "sparse.ply", cloud)
    back = loom.read_point_cloud(tmp_path / "sparse.ply")
    assert np.abs(back.points - MODEL.points).max() < 1e-6 and np.array_equal(np.round(back.colors * 255), MODEL.colors)
    assert np.array_equal(back["views"], MODEL.view_counts)
    assert np.array_equal(back["error"], MODEL.errors.astype(np.float32), equal_nan=True)
    assert len(ring_model(2, 0).point_cloud().points) == 0


def test_model_is_immutable_copies_its_arguments_and_survives_pickling():
    with pytest.raises(ValueError, match="read-only"):
        MODEL.points[0] = 0
    points = np.zeros((1, 3))
    model = loom.SfmModel(["a"], [LENS], np.eye(4)[None], points)
    points[0] = 7
    assert model.points[0].tolist() == [0, 0, 0]
    for other in (pickle.loads(pickle.dumps(MODEL)), copy.deepcopy(MODEL)):
        assert_same(other, MODEL)


def test_picture_index_is_looked_up_by_name():
    assert [MODEL.index_of(name) for name in MODEL.names] == list(range(6))
    with pytest.raises(KeyError, match="did you mean"):
        MODEL.index_of("left/0.png")


def good(**changed):
    fields = {"names": ["a", "b"], "cameras": [LENS] * 2, "T_camera_world": np.tile(np.eye(4), (2, 1, 1))}
    fields |= {"points": np.zeros((3, 3)), "observations": [[0, 2]], "pixels": [[1.0, 2.0]], **changed}
    return fields


@pytest.mark.parametrize(
    ("changed", "kind", "message"),
    [
        ({"names": ["a", "a"]}, ValueError, "names: 'a' is duplicated"),
        ({"names": ["", "a"]}, ValueError, "an empty one"),
        ({"names": ["a", 1]}, TypeError, "names"),
        ({"cameras": [LENS]}, ValueError, "cameras: expected 2, one per image, got 1"),
        ({"cameras": [LENS, LENS.params]}, TypeError, "cameras: expected CameraModels"),
        ({"T_camera_world": np.tile(2 * np.eye(4), (2, 1, 1))}, ValueError, r"T_camera_world\[0\]"),
        ({"T_camera_world": np.full((2, 4, 4), np.nan)}, ValueError, r"T_camera_world\[0\]"),
        ({"T_camera_world": [np.eye(4), np.diag([1, 1, -1, 1])]}, ValueError, r"T_camera_world\[1\]"),
        ({"points": [[0, 0, np.nan]] * 3}, ValueError, "points: expected finite"),
        ({"points": np.zeros((3, 2))}, ValueError, "points"),
        ({"colors": np.zeros((2, 3), np.uint8)}, ValueError, "colors"),
        ({"colors": np.zeros((3, 3))}, TypeError, "colors: expected uint8"),
        ({"errors": [0.0, -1.0, 0.0]}, ValueError, "errors"),
        ({"errors": [0.0]}, ValueError, "errors"),
        ({"observations": [[-1, 0]]}, ValueError, "row 0"),
        ({"observations": [[0.0, 1.0]]}, TypeError, "whole numbers"),
        ({"pixels": None}, ValueError, "pixels: expected one per row"),
        ({"pixels": [[np.nan, 0]]}, ValueError, "pixels: expected finite"),
        ({"observations": None}, ValueError, "pixels: given without observations"),
        ({"left_out": "text"}, TypeError, "left_out"),
    ],
)
def test_inconsistent_arguments_are_rejected(changed, kind, message):
    loom.SfmModel(**good())
    with pytest.raises(kind, match=message):
        loom.SfmModel(**good(**changed))


def test_invalid_scales_and_similarities_are_rejected():
    for factor in (0, -1, np.nan, np.inf, 1e31):
        with pytest.raises(ValueError, match="factor"):
            MODEL.scaled(factor)
    for T in (np.diag([1, 2, 1, 1.0]), np.diag([1, 1, -1, 1.0]), np.full((4, 4), np.nan)):
        with pytest.raises(ValueError, match="transformation"):
            MODEL.transform(T)
