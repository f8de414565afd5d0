"""Facades with a period: synthetic features in COLMAP's database, without images and COLMAP."""

import dataclasses
import sqlite3
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.photogrammetry.sfm.model_quality import ModelQuality, assess_model
from pointloom.photogrammetry.sfm.repetition_check import RepetitionCheck, check_repetition

SIZE, FOCAL, AWAY, PERIOD, STEP, COUNT = (320, 240), 300.0, 6.0, 2.0, 1.0, 6
PAIR = 2147483647


def facade(*, windows: int = 40, unique: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Points of a facade and descriptors: `windows` points that repeat in each period, and unique ones."""
    rng = np.random.default_rng(0)
    places, kinds = rng.uniform((0, -1.8, 0), (PERIOD, 1.8, 0.4), (windows, 3)), rng.dirichlet(np.ones(128), windows)
    points = np.concatenate([places + np.array([k * PERIOD, 0, 0]) for k in range(-3, 7)])
    alone = rng.uniform((-3 * PERIOD, -1.8, 0), (7 * PERIOD, 1.8, 0.4), (unique, 3))
    seen = np.concatenate([*[kinds] * 10, rng.dirichlet(np.ones(128), unique)])
    return np.concatenate([points, alone]), np.rint(512 * np.sqrt(seen)).astype(np.uint8)


def scene(path: Path, points: np.ndarray, descriptors: np.ndarray) -> loom.SfmModel:
    """Write the database of a camera along the facade, with correct matches; returns the correct model."""
    camera = loom.CameraModel("PINHOLE", *SIZE, [FOCAL, FOCAL, SIZE[0] / 2, SIZE[1] / 2])
    poses = np.tile(np.eye(4), (COUNT, 1, 1))
    poses[:, 0, 3], poses[:, 2, 3] = -STEP * np.arange(COUNT), AWAY
    rows, pixels, seen = [], [], []
    with sqlite3.connect(path) as database:
        database.execute("CREATE TABLE images (image_id INTEGER, name TEXT)")
        for table in ("keypoints", "descriptors", "two_view_geometries"):
            key = "pair_id" if table == "two_view_geometries" else "image_id"
            database.execute(f"CREATE TABLE {table} ({key} INTEGER, rows INTEGER, cols INTEGER, data BLOB)")

        def insert(table, number, values):
            database.execute(f"INSERT INTO {table} VALUES (?, ?, ?, ?)", (number, *values.shape, values.tobytes()))

        for k, pose in enumerate(poses):
            at = camera.project(points + pose[:3, 3])
            inside = np.flatnonzero(((at > 0) & (at < np.array(SIZE) - 1)).all(axis=1))
            shape = np.tile([2.0, 0, 0, 2.0], (len(inside), 1))
            database.execute("INSERT INTO images VALUES (?, ?)", (k + 1, f"{k}.jpg"))
            insert("keypoints", k + 1, np.column_stack([at[inside] + 0.5, shape]).astype(np.float32))
            insert("descriptors", k + 1, descriptors[inside])
            rows.append(np.column_stack([np.full(len(inside), k), inside]))
            pixels.append((at[inside] + 0.5).astype(np.float32) - 0.5)
            seen.append(inside)
        for i in range(COUNT):
            for j in range(i + 1, COUNT):
                _, first, second = np.intersect1d(seen[i], seen[j], return_indices=True)
                insert(
                    "two_view_geometries", PAIR * (i + 1) + j + 1, np.column_stack([first, second]).astype(np.uint32)
                )
    database.close()
    names = [f"{k}.jpg" for k in range(COUNT)]
    return loom.SfmModel(
        names, [camera] * COUNT, poses, points, observations=np.concatenate(rows), pixels=np.concatenate(pixels)
    )


def checked(path: Path, **parts: int) -> RepetitionCheck:
    return check_repetition(scene(path, *facade(**parts)), path)


def test_a_facade_without_unique_parts_is_unreliable(tmp_path):
    check = checked(tmp_path / "matches.db")
    assert check.repeating_count == COUNT and check.connected_count == 1
    assert check.period == pytest.approx(PERIOD * FOCAL / AWAY, rel=0.1)
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
