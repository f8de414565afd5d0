"""Images with known poses: matching along epipolar lines, and rejection of wrong poses."""

import dataclasses

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.kernels.features.epipolar_matching import LineFeatures, LineSearches, match_along_lines
from pointloom.photogrammetry.sfm import guided_matches, triangulation
from pointloom.photogrammetry.sfm.guided_matches import essential_of, match_guided, pairs_in_view
from pointloom.photogrammetry.sfm.model_quality import ModelQuality, assess_model
from pointloom.photogrammetry.sfm.pose_check import check_poses
from pointloom.photogrammetry.sfm.posed_images import with_poses as images_with_poses
from pointloom.photogrammetry.sfm.settings import SfmSettings

from .conftest import has_pycolmap, silent, write_images
from .made_features import FOCAL, POINTS, camera_row, features_of, rays_as, some_looks, with_poses
from .scene import FOCAL as SCENE_FOCAL
from .scene import HEIGHT, WIDTH
from .scene import camera_path as scene_poses


@pytest.fixture(scope="module")
def model():
    return camera_row()


@pytest.fixture(scope="module")
def features(model):
    return features_of(model, count=60, strangers=24)


def checked(model, features):
    return check_poses(rays_as(model, features), model, pairs_in_view(model.cameras, model.T_camera_world))


def with_ones(rays):
    return np.pad(rays, ((0, 0), (0, 1)), constant_values=1.0)


def test_a_match_is_the_nearest_descriptor_on_both_epipolar_lines(model, features, device):
    pairs = np.array([[0, 1], [1, 0], [2, 5]])
    essential = essential_of(model.T_camera_world, pairs)
    counts = np.diff(features.firsts)[pairs[:, 0]]
    starts = np.concatenate([[0], np.cumsum(counts)])
    limits = np.full((3, 2), (2.0 / FOCAL) ** 2)
    searches = LineSearches(starts, pairs, essential.reshape(-1, 9), limits, device)
    on_device = LineFeatures(features.firsts, features.rays, features.descriptors, device)
    nearest = match_along_lines(searches, on_device, int(starts[-1]))
    for k, (a, b) in enumerate(pairs):
        x, y = (with_ones(features.rays[features.of(i)]) for i in (a, b))
        off = np.abs(x @ essential[k].T @ y.T)
        there = off / np.linalg.norm((x @ essential[k].T)[:, :2], axis=1)[:, None]
        back = off / np.linalg.norm((y @ essential[k])[:, :2], axis=1)
        p, q = (features.descriptors[features.of(i)].astype(np.int64) for i in (a, b))
        sqdists = ((p[:, None] - q[None]) ** 2).sum(axis=2)
        sqdists[np.maximum(there, back) > 2.0 / FOCAL] = 0x7FFFFFFF
        mine = nearest[starts[k] : starts[k + 1]]
        np.testing.assert_array_equal(mine[:, 1], sqdists.min(axis=1))
        np.testing.assert_array_equal(mine[:, 2], np.sort(sqdists, axis=1)[:, 1])
        some = mine[:, 0] >= 0
        np.testing.assert_array_equal(mine[some, 0], sqdists.argmin(axis=1)[some])
        assert (mine[~some, 1] == 0x7FFFFFFF).all()


def test_guided_matches_are_points_visible_in_both(model, features, tmp_path):
    pairs = pairs_in_view(model.cameras, model.T_camera_world)
    assert [0, 1] in pairs.tolist()
    guided = match_guided(features, model, pairs, distance=2.0, device="cpu", progress=silent)
    for k, (a, b) in enumerate(guided.pairs):
        matches = guided.of(k)
        p, q = (features.descriptors[features.of(i)][matches[:, s]] for s, i in enumerate((a, b)))
        alike = np.abs(p.astype(int) - q).max(axis=1) <= 12
        assert alike.mean() > 0.95 and len(matches) > 36
        x, y = (with_ones(features.rays[features.of(i)][matches[:, s]]) for s, i in enumerate((a, b)))
        lines = x @ essential_of(model.T_camera_world, np.array([[a, b]]))[0].T
        assert (np.abs((lines * y).sum(axis=1)) / np.linalg.norm(lines[:, :2], axis=1)).max() <= 2.001 / FOCAL
    guided_matches.write_matches(tmp_path / "matches.npz", guided)
    again = guided_matches.read_matches(tmp_path / "matches.npz")
    np.testing.assert_array_equal(again.matches, guided.matches)


def test_images_without_overlap_or_baseline_are_no_pairs(model):
    poses = np.array([model.T_camera_world[0], model.T_camera_world[1], model.T_camera_world[1]])
    assert [1, 2] not in pairs_in_view(model.cameras[:3], poses).tolist()  # at one position
    poses[2, :3, :3] = np.diag([-1.0, 1.0, -1.0]) @ poses[2, :3, :3]
    assert pairs_in_view(model.cameras[:3], poses).tolist() == [[0, 1]]  # the last looks the other way


def test_right_poses_are_accepted_in_any_frame_and_unit(model, features):
    check = checked(model, features)
    assert check.fraction > 0.95 and check.distance < 0.4
    assert not check.are_wrong and check.reasons(len(model)) == []
    T = np.diag([7.0, 7.0, 7.0, 1.0])
    T[:3, :3] = 7.0 * np.array([[0.0, 0, 1], [1, 0, 0], [0, 1, 0]])
    T[:3, 3] = 1e6, 2e5, -30.0
    moved = model.transform(T)
    assert checked(moved, features).fraction == pytest.approx(check.fraction, abs=0.02)


FLIP = np.diag([1.0, -1.0, -1.0, 1.0])
QUARTER = np.array([[0.0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])


def inverses(T):
    return np.linalg.inv(T)


def of_centers(T):
    """World-to-camera rotations with the camera centers as translations."""
    out = T.copy()
    out[:, :3, 3] = np.linalg.inv(T)[:, :3, 3]
    return out


@pytest.mark.parametrize(
    ("mistake", "message"),
    [
        (inverses, "each pose is inverted"),
        (lambda T: FLIP @ T, "y up, z back"),
        (lambda T: inverses(FLIP @ T), "y up, z back"),
        (of_centers, "the world in the camera frame"),
        (lambda T: QUARTER @ T, "rotated by 90 degrees"),
        (lambda T: T[::-1], "reverse order"),
        (lambda T: np.roll(T, 1, axis=0), "the one 1 before it"),
        (lambda T: T[np.random.default_rng(1).permutation(len(T))], "belong to other images, have another order"),
    ],
    ids=["inverted", "OpenGL", "OpenGL inverted", "centers", "portrait", "reversed", "shifted", "shuffled"],
)
def test_common_mistakes_in_poses_are_identified(model, features, mistake, message):
    wrong = with_poses(model, np.ascontiguousarray(mistake(model.T_camera_world)))
    check = checked(wrong, features)
    assert check.are_wrong
    (reason,) = check.reasons(len(model))
    assert message in reason
    quality = assess_model(wrong, len(wrong), fix_intrinsic=True, poses=check)
    assert "; ".join(quality.warnings) == reason
    again = ModelQuality.from_json(quality.to_dict())
    assert (again.warnings, again.poses.fraction) == (quality.warnings, check.fraction)


@pytest.mark.parametrize("factor", [0.5, 1.25])
def test_a_wrong_focal_length_is_reported(model, features, factor):
    check = checked(with_poses(model, model.T_camera_world, FOCAL * factor), features)
    assert check.focal == pytest.approx(1 / factor, rel=0.03)
    (reason,) = check.reasons(len(model))
    assert "focal length" in reason


def test_images_without_overlap_are_reported(model, features):
    rng = np.random.default_rng(3)
    strange = dataclasses.replace(features, descriptors=some_looks(rng, len(features.descriptors)))
    (reason,) = checked(model, strange).reasons(len(model))
    assert "no images that overlap" in reason and "belong to other images" in reason


def test_one_wrong_pose_among_many_is_named(model, features):
    poses = model.T_camera_world.copy()
    poses[3] = np.linalg.inv(poses[3]) @ QUARTER
    check = checked(with_poses(model, poses), features)
    assert check.strays == (model.names[3],)
    assert model.names[3] in check.notes()[0]


def blank(folder, names, size=(WIDTH, HEIGHT)):
    folder.mkdir()
    for name in names:
        Image.new("L", size).save(folder / name)
    return sorted(folder.iterdir())


def cameras_named(*names):
    camera = loom.CameraModel("PINHOLE", WIDTH, HEIGHT, [300, 300, 160, 120])
    poses = np.tile(np.eye(4), (len(names), 1, 1))
    poses[:, 0, 3] = -np.arange(len(names))
    return loom.SfmModel(names, [camera] * len(names), poses)


def test_cameras_are_matched_to_images_by_name_or_stem(tmp_path):
    paths = blank(tmp_path / "p", ["IMG_1.png", "IMG_2.1.png", "IMG_3.jpg", "other.png"])
    posed = images_with_poses(tmp_path / "p", paths, cameras_named("left/IMG_3.jpg", "IMG_1", "IMG_2.1", "IMG_9"))
    assert posed.model.names == ("IMG_1.png", "IMG_2.1.png", "IMG_3.jpg")
    assert posed.model.centers[:, 0].tolist() == [1, 2, 0]  # each with its own pose
    assert (posed.without_pose, posed.without_image) == (("other.png",), ("IMG_9",))
    assert posed.notes == ("1 images have no pose: other.png", "1 poses have no image: IMG_9")


def test_names_that_do_not_fit_or_mean_several_are_refused(tmp_path):
    paths = blank(tmp_path / "p", ["1.png", "1.jpg", "10.png"])
    with pytest.raises(FileError, match=r"/p:.*1.*1\.jpg.*1\.png"):
        images_with_poses(tmp_path / "p", paths, cameras_named("1", "10"))
    with pytest.raises(FileError, match=r"/p:.*1.*3"):
        images_with_poses(tmp_path / "p", paths, cameras_named("10", "0", "2"))  # 1 is no part of 10
    with pytest.raises(FileError, match=r"/p:.*10\.png"):
        images_with_poses(tmp_path / "p", paths, cameras_named("10", "a/10.png"))


def test_an_image_of_another_size_than_its_camera_is_refused(tmp_path):
    paths = blank(tmp_path / "p", ["a.png", "b.png"], (WIDTH // 2, HEIGHT // 2))
    with pytest.raises(FileError, match=r"/a\.png:.*320.*240.*160.*120"):
        images_with_poses(tmp_path / "p", paths, cameras_named("a", "b"))


@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
def test_points_are_triangulated_with_fixed_poses(model, features, tmp_path, monkeypatch):
    rows = range(4)
    four = loom.SfmModel([model.names[i] for i in rows], model.cameras[:4], model.T_camera_world[:4])
    write_images(tmp_path / "p", [np.full((480, 640), 40 * i + 90, np.uint8) for i in rows], four.names)
    monkeypatch.setattr(triangulation, "read_feature_rays", lambda *_: features_of(four))
    matches, check = triangulation.match_posed(tmp_path / "db", four, device="cpu", progress=silent)
    given = (tmp_path / "db" / "x", four, matches, check, tmp_path / "p")
    result, _ = triangulation.points_of(*given, SfmSettings(max_seconds=60.0))
    np.testing.assert_array_equal(result.T_camera_world, four.T_camera_world)
    rng = np.random.default_rng(0)
    truth = rng.uniform(-1, 1, (POINTS, 3)) * (1.2, 0.8, 0.8) + (0, 0, 4.0)
    off = np.linalg.norm(result.points[:, None] - truth[None], axis=2).min(axis=1)
    assert len(result.points) > 80 and np.median(off) < 0.01 and off.max() < 0.1
    assert np.median(result.errors) < 0.5 and result.view_counts.min() >= 3
    assert (result.colors == 150).all(axis=1).mean() > 0.5  # the mean of 90, 130, 170 and 210, where all see a point


@pytest.mark.slow
@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
def test_images_with_poses_become_points_on_the_surface(scene_images, tmp_path):
    names = [f"view {k}.png" for k in range(len(scene_images))]
    folder = write_images(tmp_path / "images", scene_images, names)
    camera = loom.CameraModel("PINHOLE", WIDTH, HEIGHT, [SCENE_FOCAL, SCENE_FOCAL, WIDTH / 2, HEIGHT / 2])
    right = loom.SfmModel([name[:-4] for name in names], [camera] * len(names), np.array(scene_poses(len(names))))
    settings = SfmSettings(max_features=1200)
    result = loom.photogrammetry.triangulate(folder, right, settings)
    assert result.reliable and len(result.model.points) > 300
    again = loom.photogrammetry.triangulate(folder, right, settings)
    np.testing.assert_array_equal(result.model.points, again.model.points)
    inverted = loom.SfmModel(right.names, right.cameras, right.T_world_camera)
    wrong = loom.photogrammetry.triangulate(folder, inverted, settings)
    assert "each pose is inverted" in str(wrong.warnings) and not len(wrong.model.points)
    assert wrong.to_dict()["quality"]["poses"]["fraction"] < 0.4
