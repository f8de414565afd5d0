"""Structure from motion of a synthetic scene with known cameras, builds of pycolmap, retrieval of images."""

import json
import runpy
import sqlite3
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.photogrammetry.sfm import colmap_jobs, features, matches
from pointloom.photogrammetry.sfm.features import find_features
from pointloom.photogrammetry.sfm.mapping import map_images
from pointloom.photogrammetry.sfm.matches import match_features
from pointloom.photogrammetry.sfm.settings import SfmSettings

from .conftest import COUNT, FEATURES, has_pycolmap, write_images
from .scene import FOCAL, HEIGHT, WIDTH, camera_path, image


def fit_similarity(source: np.ndarray, target: np.ndarray) -> tuple[float, np.ndarray, np.ndarray]:
    a, b = source - source.mean(0), target - target.mean(0)
    u, d, vt = np.linalg.svd(b.T @ a)
    flip = np.array([1, 1, np.sign(np.linalg.det(u @ vt))])
    R, scale = (u * flip) @ vt, (d * flip).sum() / (a**2).sum()
    return scale, R, target.mean(0) - scale * R @ source.mean(0)


def content(database) -> list:
    with sqlite3.connect(database) as connection:
        tables = ("images", "cameras", "keypoints", "descriptors", "matches", "two_view_geometries")
        return [connection.execute(f"SELECT * FROM {table} ORDER BY 1").fetchall() for table in tables]


@pytest.mark.slow
def test_all_images_have_their_true_pose(stages):
    model = stages.result.model
    assert stages.result.reliable and len(model) == COUNT and stages.result.missing == ()
    truth = np.linalg.inv(camera_path(COUNT))
    scale, R, t = fit_similarity(model.centers, truth[:, :3, 3])
    off = np.linalg.norm(scale * model.centers @ R.T + t - truth[:, :3, 3], axis=1)
    assert off.max() < 0.003 * np.linalg.norm(np.ptp(truth[:, :3, 3], axis=0))
    rotations = np.einsum("nji,jk,nkl->nil", truth[:, :3, :3], R, model.T_world_camera[:, :3, :3])
    assert np.degrees(np.arccos(np.clip((np.trace(rotations, axis1=1, axis2=2) - 1) / 2, -1, 1))).max() < 0.1
    assert model.cameras[0].params[0] == pytest.approx(FOCAL, rel=0.01)


@pytest.mark.slow
def test_points_project_onto_their_observations(stages):
    model = stages.result.model
    seen = model.observations
    poses, points = model.T_camera_world[seen[:, 0]], model.points[seen[:, 1]]
    local = np.einsum("nij,nj->ni", poses[:, :3, :3], points) + poses[:, :3, 3]
    off = np.linalg.norm(model.cameras[0].project(local) - model.pixels, axis=1)
    assert np.median(off) < 0.1 and off.max() < 6


@pytest.mark.slow
def test_each_stage_reports_its_results(stages):
    assert stages.features.names == tuple(f"view {k}.png" for k in range(COUNT))
    assert min(stages.features.counts) > 0.8 * FEATURES and stages.features.poor_names == ()
    assert stages.features.sizes == {(WIDTH, HEIGHT): COUNT}
    assert (stages.matches.pairs, stages.matches.pair_count) == ("exhaustive", COUNT * (COUNT - 1) // 2)
    assert stages.matches.verified_count == 28 and stages.matches.isolated == ()
    assert stages.result.quality.model_sizes == (COUNT,)
    assert stages.features.reliable and stages.matches.reliable
    assert all(peak > 2**20 for peak in (stages.features.peak_bytes, stages.matches.peak_bytes))
    for stage, total in (("features", COUNT), ("pairs", 28), ("model", COUNT)):
        steps = [step for step in stages.steps if step[0] == stage]
        assert {step[2] for step in steps} == {total}
        assert (steps[0][1], steps[-1][1]) == (0, total)
    assert {path.name for path in stages.work.iterdir()} == {"Bilder", "features.db", "matches.db", "sparse"}


@pytest.mark.slow
def test_the_model_is_the_same_from_run_to_run(stages, tmp_path):
    map_images(stages.images, stages.matches_db, tmp_path / "again")
    for name in ("cameras.bin", "images.bin", "points3D.bin"):
        assert (tmp_path / "again" / name).read_bytes() == (stages.sparse / name).read_bytes()


@pytest.mark.slow
@pytest.mark.parametrize("cores", [1, 3])
def test_features_and_matches_are_the_same_on_any_number_of_cores(stages, tmp_path, monkeypatch, cores):
    monkeypatch.setattr(features, "usable_cores", lambda: cores)
    monkeypatch.setattr(matches, "usable_cores", lambda: cores)
    find_features(stages.images, tmp_path / "f.db", SfmSettings(max_features=FEATURES))
    match_features(tmp_path / "f.db", tmp_path / "m.db")
    assert content(tmp_path / "m.db") == content(stages.matches_db)


@pytest.mark.slow
def test_sequential_pairs_are_matched(stages, tmp_path):
    report = match_features(stages.features_db, tmp_path / "m.db", SfmSettings(pairs="sequential", overlap=3))
    with sqlite3.connect(tmp_path / "m.db") as connection:
        assert connection.execute("SELECT count(*) FROM matches").fetchone() == (report.pair_count,)
    assert report.pairs == "sequential" and report.pair_count == 7 + 6 + 4  # offsets 1, 2 and 4


@pytest.mark.slow
def test_a_known_camera_is_fixed_and_scaled_to_the_images(scene_images, tmp_path):
    images = write_images(tmp_path / "images", scene_images)
    twice = loom.PinholeCameraIntrinsic(2 * WIDTH, 2 * HEIGHT, 2 * FOCAL, 2 * FOCAL, WIDTH - 0.5, HEIGHT - 0.5)
    settings, steps = SfmSettings(intrinsic=twice, max_features=500), []
    options = {"progress": lambda *step: steps.append(step)}
    result = loom.photogrammetry.reconstruct_images(images, tmp_path / "work", settings, **options)
    assert [stage for stage, done, _ in steps if not done][:1] == ["features"]
    assert len(result.model) == COUNT and result.reliable
    camera = result.model.cameras[0]
    assert (camera.model, camera.params) == ("PINHOLE", (FOCAL, FOCAL, WIDTH / 2, HEIGHT / 2))
    assert set(result.seconds) == {"features", "pairs", "model"}
    with pytest.raises(loom.FileError, match="sparse:"):
        loom.photogrammetry.reconstruct_images(images, tmp_path / "work")


def test_a_gpu_that_is_requested_and_missing_is_an_error(scene_images, tmp_path):
    if pytest.importorskip("pycolmap").has_cuda:
        pytest.skip("pycolmap has CUDA")
    images = write_images(tmp_path / "in", scene_images[:2])
    with pytest.raises(loom.FileError, match="use_gpu: this pycolmap was built without CUDA"):
        find_features(images, tmp_path / "f.db", SfmSettings(use_gpu=True))


def test_a_camera_of_other_images_is_refused(scene_images, tmp_path):
    other = loom.PinholeCameraIntrinsic(640, 640, 500, 500, 320, 320)
    images = write_images(tmp_path / "in", scene_images[:2])
    with pytest.raises(ValueError, match="intrinsic:"):
        find_features(images, tmp_path / "f.db", SfmSettings(intrinsic=other))


@pytest.mark.slow
def test_a_camera_that_only_rotates_is_reported(tmp_path):
    """COLMAP registers all images, with a focal length that imitates motion."""
    images = write_images(tmp_path / "images", [image(T) for T in camera_path(6, rotate_only=True)])
    result = loom.photogrammetry.reconstruct_images(images, tmp_path / "work", SfmSettings(max_features=500))
    assert "move instead of only rotating" in str(result.warnings)


@pytest.mark.slow
def test_blank_images_give_no_model_but_a_warning(tmp_path):
    images = write_images(tmp_path / "images", [np.full((64, 96), 40 * k, np.uint8) for k in range(3)])
    features = find_features(images, tmp_path / "f.db")
    assert features.counts == (0, 0, 0) and len(features.poor_names) == 3
    matched = match_features(tmp_path / "f.db", tmp_path / "m.db")
    assert matched.verified_count == 0 and len(matched.isolated) == 3
    result = map_images(images, tmp_path / "m.db", tmp_path / "sparse")
    assert result.model is None and len(result.missing) == 3
    assert "none of the 3 images could be registered" in str(result.warnings)
    assert "3 of 3 images have fewer than 50 features (view 0.png, view 1.png, " in str(features.warnings)
    assert "3 of 3 images have no verified matches (view 0.png, view 1.png, " in str(matched.warnings)
    for report in (features, matched, result):
        assert json.loads(json.dumps(report.to_dict(), allow_nan=False))["reliable"] is False


@pytest.mark.parametrize(
    ("name", "remedy"), [("empty.png", "empty"), ("gray.png", "16-bit gray"), ("side.jpg", "is not upright")]
)
def test_images_misread_by_colmap_are_rejected(scene_images, tmp_path, name, remedy):
    images = write_images(tmp_path / "images", scene_images[:2])
    exif = Image.Exif()
    exif[0x0112] = 6
    if name == "empty.png":
        (images / name).touch()
    else:
        pixels = scene_images[0].astype(np.uint16) * 256 if name == "gray.png" else scene_images[0]
        Image.fromarray(pixels).save(images / name, **({} if name == "gray.png" else {"exif": exif}))
    with pytest.raises(loom.FileError, match=rf"{name}.*{remedy}"):
        find_features(images, tmp_path / "f.db")


def test_an_image_alone_is_refused(scene_images, tmp_path):
    with pytest.raises(loom.FileError, match="/one:"):
        find_features(write_images(tmp_path / "one", scene_images[:1]), tmp_path / "f.db")


@pytest.mark.slow
def test_global_and_incremental_mapping_agree(stages, tmp_path):
    result = map_images(stages.images, stages.matches_db, tmp_path / "g", SfmSettings(mapper="global"))
    map_images(stages.images, stages.matches_db, tmp_path / "h", SfmSettings(mapper="global"))
    assert result.model is not None and result.model.names == stages.result.model.names
    for name in ("cameras.bin", "images.bin", "points3D.bin"):
        assert (tmp_path / "g" / name).read_bytes() == (tmp_path / "h" / name).read_bytes()
    centers = [model.centers for model in (result.model, stages.result.model)]
    apart = [np.linalg.norm(each[:, None] - each[None], axis=2) for each in centers]
    scale = (apart[0] * apart[1]).sum() / (apart[0] ** 2).sum()
    assert np.abs(scale * apart[0] - apart[1]).max() < 0.01 * apart[1].max()


WORKER = runpy.run_path(str(Path(colmap_jobs.__file__).with_name("colmap_worker.py")))


@pytest.mark.parametrize(
    ("has_cuda", "devices", "wanted", "used"),
    [(True, 1, None, True), (True, 1, False, False), (True, 0, None, False), (False, 1, None, False)],
)
def test_a_gpu_is_used_where_pycolmap_and_the_machine_have_one(monkeypatch, has_cuda, devices, wanted, used):
    monkeypatch.setitem(WORKER["on_gpu"].__globals__, "_cuda_devices", lambda: devices)
    assert WORKER["on_gpu"](SimpleNamespace(has_cuda=has_cuda), {"gpu": wanted}) is used


def test_a_requested_but_missing_gpu_is_an_error(monkeypatch):
    monkeypatch.setitem(WORKER["on_gpu"].__globals__, "_cuda_devices", lambda: 0)
    for has_cuda, message in ((False, "pip install pycolmap-cuda12"), (True, "there is no CUDA device")):
        with pytest.raises(RuntimeError, match=message):
            WORKER["on_gpu"](SimpleNamespace(has_cuda=has_cuda), {"gpu": True})


@pytest.mark.slow
@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
def test_missing_networks_are_a_named_error(scene_images, tmp_path):
    images = write_images(tmp_path / "p", scene_images[:2])
    with pytest.raises(loom.FileError, match="ALIKED and LightGlue require a pycolmap built with ONNX"):
        find_features(images, tmp_path / "f.db", SfmSettings(kind="aliked"))
    assert not (tmp_path / "f.db").exists()


def descriptors_of_scenes(count: int, views: int, seed: int = 0) -> list[np.ndarray]:
    """Descriptors of several views of several scenes, in order; each view has most of its scene's 60."""
    rng = np.random.default_rng(seed)
    sets = []
    for _ in range(count):
        things = rng.integers(0, 200, (60, 128))
        for _ in range(views):
            seen = things[rng.permutation(60)[:45]] + rng.integers(-12, 13, (45, 128))
            sets.append(np.clip(seen, 0, 255).astype(np.uint8))
    return sets


def test_images_without_features_are_like_none():
    none = np.zeros((0, 128), np.uint8)
    sets = [*descriptors_of_scenes(count=2, views=2), none]
    alike = matches.alike_images(sets, 9, seed=0, words=8)
    assert alike[4] == [] and [len(row) for row in alike] == [3, 3, 3, 3, 0]
    assert matches.alike_images([none, none], 9, seed=0) == [[], []]


def test_many_images_are_matched_in_sequence_and_by_retrieval(tmp_path, monkeypatch):
    sets = descriptors_of_scenes(count=11, views=4)
    order = np.random.default_rng(3).permutation(len(sets))
    database = tmp_path / "f.db"
    with sqlite3.connect(database) as connection:
        connection.execute("CREATE TABLE images (image_id INTEGER, name TEXT)")
        connection.execute("CREATE TABLE descriptors (image_id INTEGER, rows INTEGER, cols INTEGER, data BLOB)")
        connection.execute("CREATE TABLE two_view_geometries (pair_id INTEGER, rows INTEGER)")
        for k, index in enumerate(order):
            connection.execute("INSERT INTO images VALUES (?, ?)", (k + 1, f"an image {k:02d}.png"))
            connection.execute("INSERT INTO descriptors VALUES (?, 45, 128, ?)", (k + 1, sets[index].tobytes()))
    connection.close()
    given = {}

    def run_job(job, path, **limits):
        if "list" in job:
            given[job["pairs"]] = [tuple(map(int, line.split())) for line in Path(job["list"]).read_text().splitlines()]
        return {}, 0

    monkeypatch.setattr(matches, "run_job", run_job)
    for pairs in ("retrieval", "auto"):
        settings = SfmSettings(pairs=pairs, overlap=2, neighbors=3)
        report = match_features(database, tmp_path / "m.db", settings)
        with sqlite3.connect(tmp_path / "m.db") as connection:
            assert "an image 07.png" in {name for (name,) in connection.execute("SELECT name FROM images")}
        connection.close()
        assert report.pair_count == len(given[report.pairs]) == len(set(given[report.pairs]))
    looks, mixed = given["retrieval"], given[matches.MIXED]
    assert set(looks) < set(mixed) and len(mixed) > 80 and (1, 3) in mixed
    same = [order[a - 1] // 4 == order[b - 1] // 4 for a, b in looks]
    assert sum(same) >= 0.9 * 6 * 11  # of the six pairs of each scene
