"""Quality of a model: angles, parallax, focal lengths, and structure that repeats."""

import dataclasses
import json
import math
import sqlite3
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.photogrammetry.sfm import colmap_worker
from pointloom.photogrammetry.sfm import model_quality as module
from pointloom.photogrammetry.sfm.camera_check import CameraCheck
from pointloom.photogrammetry.sfm.model_quality import ModelQuality, assess_model, parallax, triangulation_angles
from pointloom.photogrammetry.sfm.repetition_check import RepetitionCheck, check_repetition

from ...products import few_quick
from .conftest import has_pycolmap

FOCAL, WIDTH, HEIGHT = 500.0, 640, 480


def model_of(poses, points, *, focal=FOCAL, k=0.0, wrong_focal=1.0, noise=0.0) -> loom.SfmModel:
    """The model of a camera that sees points, stored with a wrong focal length."""
    true = loom.CameraModel("SIMPLE_RADIAL", WIDTH, HEIGHT, [focal, WIDTH / 2, HEIGHT / 2, k])
    stored = loom.CameraModel("SIMPLE_RADIAL", WIDTH, HEIGHT, [focal * wrong_focal, WIDTH / 2, HEIGHT / 2, 0.0])
    rng, seen, pixels = np.random.default_rng(1), [], []
    for number, T in enumerate(poses):
        at = true.project(points @ T[:3, :3].T + T[:3, 3])
        inside = ((at >= 0) & (at < (WIDTH, HEIGHT))).all(axis=1)
        seen += [(number, point) for point in np.flatnonzero(inside)]
        pixels.append(at[inside] + rng.normal(0, noise, (inside.sum(), 2)))
    names = [f"{k:03d}" for k in range(len(poses))]
    made = {"observations": seen, "pixels": np.concatenate(pixels), "errors": np.full(len(points), 0.5)}
    return loom.SfmModel(names, [stored] * len(poses), np.array(poses), points=points, **made)


def views(count: int, *, side: float, angle: float) -> list[np.ndarray]:
    poses = []
    for along in np.linspace(-0.5, 0.5, count):
        yaw, T = angle * along, np.eye(4)
        T[:3, :3] = [[np.cos(yaw), 0, np.sin(yaw)], [0, 1, 0], [-np.sin(yaw), 0, np.cos(yaw)]]
        T[:3, 3] = -T[:3, :3] @ [side * along, 0, 0]
        poses.append(T)
    return poses


@pytest.fixture
def points(rng):
    return np.column_stack([rng.uniform(-4, 4, (400, 2)), rng.uniform(3, 8, 400)])


@pytest.mark.parametrize(("focal", "k"), [(0.7, 0.1), (1.0, -0.1), (1.5, 0.0)])
def test_pure_rotation_gives_no_parallax_for_any_lens(points, focal, k):
    model = model_of(views(8, side=0.0, angle=0.6), points, k=k, wrong_focal=focal, noise=0.3)
    assert parallax(model) < 1.0  # of which features that are 0.3 px off make up 0.6


@few_quick(1, "side", [0.2, 1.0])
def test_rotation_does_not_explain_a_moving_camera(points, side):
    model = model_of(views(8, side=side, angle=0.3), points, noise=0.3)
    assert parallax(model) > 3 and parallax(model, fixed=True) >= parallax(model)
    assert (assess_model(model, 8).reliable) == (side == 1.0)  # else the angles are too small


def test_a_rotating_camera_is_rejected_despite_wide_angles(points):
    seen = model_of(views(8, side=0.0, angle=0.6), points, noise=0.3)
    moved = seen.T_camera_world.copy()
    moved[:, 0, 3] = np.linspace(-0.5, 0.5, 8)  # motion that was made up
    quality = assess_model(dataclasses.replace(seen, T_camera_world=moved), 8)
    assert quality.angle > 2 and "the camera hardly moved" in str(quality.warnings)
    assert "move instead of only rotating" in str(quality.warnings)


def test_far_points_are_uncertain(points):
    quality = assess_model(model_of(views(8, side=0.1, angle=0.3), points * [1, 1, 0.6]), 8)
    assert quality.angle < 2 and "; ".join(quality.warnings)


def test_angles_are_between_the_two_farthest_rays(points):
    poses = views(9, side=1.0, angle=0.0)
    model = model_of(poses, points)
    angles = triangulation_angles(model)
    for point in range(0, 400, 17):
        rays = model.centers[model.observations[model.observations[:, 1] == point, 0]] - points[point]
        rays /= np.linalg.norm(rays, axis=1, keepdims=True)
        widest = np.degrees(np.arccos(np.clip((rays @ rays.T).min(), -1, 1))) if len(rays) > 1 else 0.0
        assert angles[point] == pytest.approx(widest, abs=1e-5)


def test_points_with_at_most_one_observation_have_no_angle():
    camera = loom.CameraModel("PINHOLE", 64, 48, [60, 60, 32, 24])
    seen = {"points": np.ones((2, 3)), "observations": [[0, 1]], "pixels": [[3.0, 4.0]]}
    model = loom.SfmModel(["a"], [camera], np.eye(4)[None], **seen)
    assert triangulation_angles(model).tolist() == [0, 0] and np.isnan(parallax(model))
    empty = loom.SfmModel([], [], np.zeros((0, 4, 4)))
    assert triangulation_angles(empty).tolist() == [] and np.isnan(parallax(empty))
    assert "only 0 points" in str(assess_model(empty, 0).warnings)
    assert "only 1 of 5 images" in str(assess_model(model, 5).warnings)


@few_quick(1, "scale", [1e-6, 1e6])
def test_the_quality_does_not_depend_on_the_unit_or_the_position(points, scale):
    model = model_of(views(8, side=1.0, angle=0.3), points)
    T = np.diag([scale, scale, scale, 1.0])
    T[:3, 3] = 5e5 * scale, 4e6 * scale, 0
    moved, before = assess_model(model.transform(T), 8), assess_model(model, 8)
    assert moved.reliable
    assert (moved.angle, moved.parallax) == (pytest.approx(before.angle, rel=1e-5), pytest.approx(before.parallax))


def test_few_images_few_points_and_several_models_are_reported(points):
    model = model_of(views(4, side=1.0, angle=0.3), points)
    assert assess_model(model, 4).reliable
    assert "only 4 of 10 images could be registered" in str(assess_model(model, 10).warnings)
    assert "the images form 2 separate models (4, 2 images)" in str(assess_model(model, 6, model_sizes=(4, 2)).warnings)
    assert assess_model(model, 4, model_sizes=(4, 2)).reliable  # the same images again
    few = assess_model(model_of(views(4, side=1.0, angle=0.3), points[:30]), 4)
    assert "only 30 points were triangulated" in str(few.warnings)


def row_of(centers, seen, pixels=None):
    """Cameras on the x axis, each of which sees a number of the first points."""
    cameras = [loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])] * len(centers)
    poses = np.tile(np.eye(4), (len(centers), 1, 1))
    poses[:, 0, 3] = np.negative(centers)
    points = np.random.default_rng(0).uniform([-1, -1, 4], [1, 1, 6], (max(seen), 3))
    observations = np.array([[image, k] for image, count in enumerate(seen) for k in range(count)])
    pixels = np.zeros((len(observations), 2)) if pixels is None else pixels
    made = {"points": points, "observations": observations, "pixels": pixels}
    return loom.SfmModel([str(k) for k in range(len(centers))], cameras, poses, **made)


def test_an_image_is_compared_with_one_that_is_far_and_sees_much_of_the_same(monkeypatch):
    monkeypatch.setattr(module, "_MAX_PAIRS", 1)  # for the first image alone
    # distance times the root of the number of shared points: 45, 54 and 42
    assert module._far_pairs(row_of([0.0, 10.0, 7.0, 3.0], [200, 20, 60, 200])) == [(0, 2)]


def test_a_mirrored_image_is_no_rotated_one():
    rays = np.random.default_rng(1).uniform(-0.5, 0.5, (60, 2))
    once = rays * 500 + [319.5, 239.5]
    for second, is_rotated in ((once, True), ((rays * [-1, 1]) * 500 + [319.5, 239.5], False)):
        off = module.parallax(row_of([0.0, 1.0], [60, 60], np.concatenate([once, second])), fixed=True)
        assert (off < 1e-6) is is_rotated and (off > 50) is not is_rotated


SIZE, FACADE_FOCAL, AWAY, PERIOD, STEP, COUNT = (320, 240), 300.0, 6.0, 2.0, 1.0, 6
PAIR = 2147483647


def facade(*, windows: int = 40, unique: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Points of a facade and descriptors: `windows` points that repeat in each period, and unique ones."""
    rng = np.random.default_rng(0)
    places, kinds = rng.uniform((0, -1.8, 0), (PERIOD, 1.8, 0.4), (windows, 3)), rng.dirichlet(np.ones(128), windows)
    points = np.concatenate([places + np.array([k * PERIOD, 0, 0]) for k in range(-3, 7)])
    alone = rng.uniform((-3 * PERIOD, -1.8, 0), (7 * PERIOD, 1.8, 0.4), (unique, 3))
    seen = np.concatenate([*[kinds] * 10, rng.dirichlet(np.ones(128), unique)])
    return np.concatenate([points, alone]), np.rint(512 * np.sqrt(seen)).astype(np.uint8)


def scene(
    path: Path, points: np.ndarray, descriptors: np.ndarray, *, roll: float = 0.0, turned: bool = False
) -> loom.SfmModel:
    """Write the database of a camera along the facade, with correct matches; returns the correct model.

    The camera is rotated by `roll` [rad] about its viewing direction. `turned`: features have random orientations.
    """
    turn = np.array([[np.cos(roll), -np.sin(roll), 0], [np.sin(roll), np.cos(roll), 0], [0, 0, 1]])
    camera = loom.CameraModel("PINHOLE", *SIZE, [FACADE_FOCAL, FACADE_FOCAL, SIZE[0] / 2, SIZE[1] / 2])
    poses = np.tile(np.eye(4), (COUNT, 1, 1))
    poses[:, 0, 3], poses[:, 2, 3] = -STEP * np.arange(COUNT), AWAY
    poses[:, :3] = turn @ poses[:, :3]
    rows, pixels, seen = [], [], []
    with sqlite3.connect(path) as database:
        database.execute("CREATE TABLE images (image_id INTEGER, name TEXT)")
        for table in ("keypoints", "descriptors", "two_view_geometries"):
            key = "pair_id" if table == "two_view_geometries" else "image_id"
            database.execute(f"CREATE TABLE {table} ({key} INTEGER, rows INTEGER, cols INTEGER, data BLOB)")

        def insert(table, number, values):
            database.execute(f"INSERT INTO {table} VALUES (?, ?, ?, ?)", (number, *values.shape, values.tobytes()))

        for k, pose in enumerate(poses):
            at = camera.project(points @ pose[:3, :3].T + pose[:3, 3])
            inside = np.flatnonzero(((at > 0) & (at < np.array(SIZE) - 1)).all(axis=1))
            angles = np.random.default_rng(k).uniform(0, 2 * np.pi, len(inside)) if turned else np.zeros(len(inside))
            c, s = 2 * np.cos(angles), 2 * np.sin(angles)
            shape = np.column_stack([c, -s, s, c])
            database.execute("INSERT INTO images VALUES (?, ?)", (k + 1, f"{k}.jpg"))
            insert("keypoints", k + 1, np.column_stack([at[inside] + 0.5, shape]).astype(np.float32))
            insert("descriptors", k + 1, descriptors[inside])
            rows.append(np.column_stack([np.full(len(inside), k), inside]))
            pixels.append((at[inside] + 0.5).astype(np.float32) - 0.5)
            seen.append(inside)
        for i in range(COUNT):
            for j in range(i + 1, COUNT):
                pairs = np.intersect1d(seen[i], seen[j], return_indices=True)[1:]
                insert("two_view_geometries", PAIR * (i + 1) + j + 1, np.column_stack(pairs).astype(np.uint32))
    database.close()
    names, made = [f"{k}.jpg" for k in range(COUNT)], {"observations": np.concatenate(rows)}
    return loom.SfmModel(names, [camera] * COUNT, poses, points, **made, pixels=np.concatenate(pixels))


def checked(path: Path, **parts: int) -> RepetitionCheck:
    return check_repetition(scene(path, *facade(**parts)), path)


def test_a_facade_without_unique_parts_is_unreliable(tmp_path):
    check = checked(tmp_path / "matches.db")
    assert check.repeating_count == COUNT and check.connected_count == 1
    assert check.period == pytest.approx(PERIOD * FACADE_FOCAL / AWAY, rel=0.1)
    assert check.baselines == pytest.approx(PERIOD / STEP, rel=0.1)
    (reason,) = check.reasons()
    assert "the structure repeats every" in reason and "connect only 1 of 6 images" in reason
    assert "2 times the distance of two cameras" in reason and "such as a door or a sign" in reason


def test_unique_parts_decide(tmp_path):
    check = checked(tmp_path / "matches.db", unique=1200)
    assert check.repeating_count == COUNT and check.connected_count == COUNT and check.contradiction < 0.05
    assert check.reasons() == []


def test_a_scene_without_repetition_is_not_reported(tmp_path):
    check = checked(tmp_path / "matches.db", windows=0, unique=1200)
    assert check.repeating_count == 0 and check.reasons() == []


@pytest.mark.parametrize("roll", [np.pi / 2, np.pi / 4])
def test_a_facade_in_vertical_and_rotated_images_is_unreliable(tmp_path, roll):
    check = check_repetition(scene(tmp_path / "matches.db", *facade(), roll=roll), tmp_path / "matches.db")
    assert check.repeating_count == COUNT and check.reasons()
    assert check.period == pytest.approx(PERIOD * FACADE_FOCAL / AWAY, rel=0.1)


def with_objects(size: float, *, count: int = 25, kinds: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """A facade without windows, and two equal objects 0.66 image widths apart, or patches of a texture of `kinds`."""
    points, seen = facade(windows=0, unique=4000)
    rng = np.random.default_rng(1)
    parts, own = rng.uniform((0, -size, 0), (size, size, 0.2), (count, 3)), rng.dirichlet(np.ones(128), kinds or count)
    for x in (-1.0, 3.2):
        if kinds:
            parts = rng.uniform((0, -size, 0), (size, size, 0.2), (count, 3))
        chosen = own[rng.integers(0, kinds, count)] if kinds else own
        points = np.concatenate([points, parts + np.array([x, 0, 0])])
        noise = rng.integers(-6, 7, chosen.shape)
        seen = np.concatenate([seen, np.clip(np.rint(512 * np.sqrt(chosen)) + noise, 0, 255).astype(np.uint8)])
    return points, seen


@pytest.mark.slow
def test_two_equal_objects_are_no_repetition(tmp_path):
    """Only one period fits, and the objects are small compared with the shift. Three of six images show both."""
    check = check_repetition(scene(tmp_path / "matches.db", *with_objects(0.5)), tmp_path / "matches.db")
    assert check.repeating_count == 0 and check.reasons() == []


@pytest.mark.slow
def test_patches_of_one_texture_are_no_repetition(tmp_path):
    """Such as gravel or text: similar features, but none has a copy at a common shift."""
    objects = with_objects(1.2, count=150, kinds=60)
    check = check_repetition(scene(tmp_path / "matches.db", *objects), tmp_path / "matches.db")
    assert check.repeating_count == 0 and check.reasons() == []


def test_similar_features_of_other_orientations_are_no_repetition(tmp_path):
    model = scene(tmp_path / "matches.db", *facade(windows=15, unique=1200), turned=True)
    assert check_repetition(model, tmp_path / "matches.db").repeating_count == 0


def test_poses_that_unique_parts_contradict_are_unreliable(tmp_path):
    model = scene(tmp_path / "matches.db", *facade(unique=1200))
    poses = model.T_camera_world.copy()
    poses[0, 0, 3] -= PERIOD
    check = check_repetition(dataclasses.replace(model, T_camera_world=poses), tmp_path / "matches.db")
    assert check.contradiction > 0.9 and "of the other matches of an image do not fit" in check.reasons()[0]


def test_the_quality_has_the_check(tmp_path):
    model = scene(tmp_path / "matches.db", *facade())
    quality = assess_model(model, COUNT, repetition=check_repetition(model, tmp_path / "matches.db"))
    assert any("the structure repeats every" in reason for reason in quality.warnings)
    assert ModelQuality.from_json(quality.to_dict()).repetition == quality.repetition
    with pytest.raises(TypeError, match="repetition: expected a ModelQuality's `repetition` or None, got int"):
        assess_model(model, COUNT, repetition=3)


def warnings_of(**figures: float) -> str:
    return "; ".join(CameraCheck(**figures).reasons())


def test_a_given_camera_is_reported_with_both_numbers():
    message = warnings_of(given=600, found=526, error=0.85, freed_error=0.5)
    assert "given focal length is 600 px, but 526 px fits the images better" in message
    assert "(the error falls from 0.85 to 0.5 px)" in message
    assert "given focal length is 600 px" in warnings_of(given=600, found=526, error=0.5, freed_error=0.45, spread=0.02)


@pytest.mark.parametrize(
    "figures",
    [
        {"given": 600, "found": 526, "error": 0.5, "freed_error": 0.45},  # the images do not determine it
        {"given": 600, "found": 526, "error": 0.5, "freed_error": 0.45, "spread": 0.03},  # nor do parts of them
        {"given": 526, "found": 530, "error": 0.85, "freed_error": 0.5},  # it was something else
        {"given": 526, "found": 526, "error": 0.5, "freed_error": 0.5, "own_error": 0.45},
        {"found": 526, "rise": 0.01, "spread": 0.02, "error": 0.5, "own_error": 0.45},
        {},
    ],
)
def test_a_camera_that_fits_is_not_reported(figures):
    assert warnings_of(**figures) == ""


def test_an_undetermined_focal_length_is_reported():
    message = warnings_of(found=663, rise=0.0, error=0.4)
    assert "the images do not determine the focal length (with a focal length 15% off 663 px" in message
    message = warnings_of(found=663, rise=0.026, spread=0.046, error=0.4)
    assert "the error rises by 2.6%, and subsets of the images" in message
    assert "or a lens with more distortion, change the focal length by 5%" in message
    assert "the 525 px of EXIF fit worse" in warnings_of(found=663, rise=0, error=0.4, exif=525, freed_error=0.6)


def test_exif_determines_the_focal_length_if_the_images_do_not():
    check = CameraCheck(found=663, rise=0.0, error=0.4, exif=525, freed_error=0.401)
    assert check.reasons() == []
    (remark,) = check.notes()
    assert "EXIF's 525 px are used" in remark and "across the viewing direction may be off by 5%" in remark


def test_several_focal_lengths_are_reported_or_get_separate_cameras():
    figures = {"found": 600.0, "rise": 0.1, "error": 1.4, "own_error": 0.4}
    message = warnings_of(**figures)
    assert "several focal lengths (with one focal length per image the error falls from 1.4 to 0.4 px)" in message
    parted = CameraCheck(**figures | {"parted": 2})
    assert parted.reasons() == [] and "2 cameras with different focal lengths do" in parted.notes()[0]
    assert "several focal lengths" in warnings_of(given=525, freed_error=1.2, **figures)


def test_a_check_and_a_quality_are_read_again_from_json():
    check = CameraCheck(found=663, rise=0.0, error=0.4)
    quality = dataclasses.replace(assess_model(None, 3), focal=check)
    again = ModelQuality.from_json(json.loads(json.dumps(quality.to_dict(), allow_nan=False)))
    assert again.focal is not None and again.focal.reasons() == check.reasons() and math.isnan(again.focal.given)
    older = {key: value for key, value in quality.to_dict().items() if key not in ("focal", "notes")}
    assert ModelQuality.from_json(older).focal is None


def test_reprojection_errors_above_a_pixel_are_reported(points):
    model = model_of(views(4, side=1.0, angle=0.3), points)
    for error, size, refused in ((0.9, 1, False), (1.1, 1, True), (1.5, 4, False), (1.7, 4, True)):
        cameras = [loom.CameraModel("PINHOLE", size * WIDTH, size * HEIGHT, [FOCAL, FOCAL, 9, 9])] * len(model)
        scaled = dataclasses.replace(model, cameras=cameras, errors=np.full(len(points), error))
        warnings = assess_model(scaled, 4, focal=CameraCheck()).warnings
        assert ("the reprojection error is" in str(warnings)) == refused


def test_the_check_of_the_focal_length_makes_a_warning(points):
    model = model_of(views(4, side=1.0, angle=0.3), points)
    quality = assess_model(model, 4, focal=CameraCheck(found=600, rise=0.001, error=0.4))
    assert not quality.reliable
    assert quality.warnings[0].startswith("the images do not determine the focal length")
    noted = assess_model(model, 4, focal=CameraCheck(found=600, rise=0.001, error=0.4, exif=1, freed_error=0.4))
    assert noted.reliable and noted.to_dict()["notes"] == list(noted.notes) != []


SCRIPT = """
import json, pathlib, runpy, sys
import pycolmap
pycolmap.logging.minloglevel = 2
script = runpy.run_path(sys.argv[1])
results = {}
for path in sorted(pathlib.Path(sys.argv[2]).iterdir()):
    model = pycolmap.Reconstruction(str(path))
    shared, own, lengths = script["own_focal_lengths"](pycolmap, model)
    results[path.name] = script["profile"](pycolmap, model) | {"own": own / shared}
    results[path.name] |= script["judge_given"](pycolmap, model)
    results[path.name]["clusters"] = sorted(len(group) for group in script["clusters"](lengths))
print(json.dumps(results))
"""


def zoomed(poses, points) -> loom.SfmModel:
    """A model with one camera, although every second image has another focal length."""
    near, far = (model_of(poses, points, focal=focal, noise=0.2) for focal in (FOCAL, 1.3 * FOCAL))
    parts = [(model, model.observations[:, 0] % 2 == k) for k, model in enumerate((near, far))]
    seen = np.concatenate([model.observations[mine] for model, mine in parts])
    pixels = np.concatenate([model.pixels[mine] for model, mine in parts])
    return dataclasses.replace(near, observations=seen, pixels=pixels)


@pytest.fixture(scope="module")
def results(tmp_path_factory) -> dict:
    """Results of COLMAP's process for models of synthetic points, without images."""
    if not has_pycolmap():
        pytest.skip("pycolmap is not installed")
    rng = np.random.default_rng(0)
    points = np.column_stack([rng.uniform(-4, 4, (300, 2)), rng.uniform(3, 8, 300)])
    around, ahead = views(8, side=2.0, angle=0.5), [np.eye(4) for _ in range(8)]
    for k, T in enumerate(ahead):
        T[2, 3] = -0.2 * k
    models = {
        "around": model_of(around, points, noise=0.2),
        "ahead": model_of(ahead, points, noise=0.2),
        "wrong": model_of(around, points, noise=0.2, wrong_focal=1.15),
        "zoom": zoomed(around, points),
    }
    folder = tmp_path_factory.mktemp("models")
    for name, model in models.items():
        loom.write_colmap_model(folder / name, model)
    script = Path(colmap_worker.__file__).with_name("colmap_cameras.py")
    command = [sys.executable, "-P", "-c", SCRIPT, str(script), str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=300)
    return json.loads(done.stdout.splitlines()[-1])


@pytest.mark.slow
def test_sideways_motion_determines_the_focal_length_and_forward_motion_does_not(results):
    assert results["around"]["rise"] > 0.1 and results["around"]["found"] == pytest.approx(FOCAL, rel=0.01)
    assert results["ahead"]["rise"] < 0.002


def test_a_given_focal_length_is_checked_against_the_images(results):
    assert CameraCheck.from_json(results["around"]).reasons() == []
    check = CameraCheck.from_json(results["wrong"])
    assert check.given == pytest.approx(1.15 * FOCAL) and check.found == pytest.approx(FOCAL, rel=0.01)
    assert check.freed_error < 0.6 * check.error


def test_images_of_two_focal_lengths_form_two_clusters(results):
    assert results["zoom"]["own"] < 0.5 < 0.9 < results["around"]["own"]
    assert results["zoom"]["clusters"] == [4, 4] and results["around"]["clusters"] == [8]
