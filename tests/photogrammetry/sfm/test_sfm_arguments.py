"""Every public call of structure from motion rejects invalid arguments by name."""

import contextlib
import itertools
import sqlite3
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pointloom as loom
from pointloom.photogrammetry.sfm import features, mapping, matches
from pointloom.photogrammetry.sfm.settings import SfmSettings

from ...hostile import missing_from, public_arguments, read_table
from ..argument_tests import argument_tests, call_of
from .conftest import write_images

CAMERA = "camera_model='PINHOLE', intrinsic=None, fix_intrinsic=None"
FEATURES = "max_size=640, max_features=500, kind='sift', use_gpu=None"
PAIRS = "pairs='auto', overlap=10, neighbors=5, mapper='auto'"
CALLS = f"""
loom.photogrammetry.SfmSettings({CAMERA}, {FEATURES}, {PAIRS}, seed=0, max_seconds=60.0, max_memory=2**32)
loom.photogrammetry.choose_frames(source=images, folder=new(), max_frames=5, max_size=64, kind="png", masks=None, sampling=sampling, progress=None)
loom.photogrammetry.VideoSampling(min_movement=0.04, max_gap=30, reader="auto", max_seconds=60.0, max_memory=2**32)
loom.photogrammetry.find_features(images=images, database=new(), settings=settings, masks=None, progress=None)
loom.photogrammetry.match_features(database=database, matches=new(), settings=settings, progress=None)
loom.photogrammetry.map_images(images=images, matches=database, folder=new(), settings=settings, progress=None)
loom.photogrammetry.reconstruct_images(images=images, work=new(), settings=settings, masks=None, progress=None)
loom.photogrammetry.assess_model(model=model, image_count=3, model_sizes=[2, 1], focal=None, poses=None, repetition=None)
loom.photogrammetry.read_image_positions(source=images)
loom.photogrammetry.write_training_folder(folder=new(), model=model, images=[gray, gray], masks=[None, seen], max_size=64, shift=True, device="cpu", overwrite=True, progress=None)
loom.photogrammetry.triangulate(images=images, cameras=posed, settings=settings, device="cpu", progress=None)
"""  # noqa: E501
TABLE = read_table(CALLS, {})
RESULTS = {"FrameChoice", "ImagePosition", "ImagePositions", "TrainingFolder", "TriangulationResult"}
RESULTS |= {"FeatureReport", "MatchReport", "SfmResult", "ModelQuality"}


@pytest.fixture(scope="module")
def things(tmp_path_factory) -> dict[str, Any]:
    rng, folder, numbers = np.random.default_rng(0), tmp_path_factory.mktemp("sfm"), itertools.count()
    images = write_images(folder / "in", rng.integers(0, 256, (2, 48, 64)).astype(np.uint8))
    database = folder / "made.db"
    with sqlite3.connect(database) as connection:
        connection.execute("CREATE TABLE images (image_id INTEGER, name TEXT)")
        for table in ("keypoints", "descriptors"):
            connection.execute(f"CREATE TABLE {table} (image_id INTEGER, rows INTEGER, cols INTEGER, data BLOB)")
        connection.execute("CREATE TABLE two_view_geometries (pair_id INTEGER, rows INTEGER)")
        connection.execute("INSERT INTO two_view_geometries VALUES (2147483649, 9)")
        connection.executemany("INSERT INTO images VALUES (?, ?)", [(1, "view 0.png"), (2, "view 1.png")])
    connection.close()
    camera = loom.CameraModel("PINHOLE", 64, 48, [60, 60, 32, 24])
    poses = np.tile(np.eye(4), (2, 1, 1))
    poses[1, 0, 3] = -1
    gray = rng.integers(0, 256, (48, 64)).astype(np.uint8)
    return {
        "loom": loom, "images": images, "database": database, "gray": gray, "seen": gray >= 0,
        "model": loom.SfmModel(["a", "b"], [camera] * 2, poses, points=[[0, 0, 2.0]]),
        "posed": loom.SfmModel(["view 0", "view 1"], [camera] * 2, poses),
        "sampling": loom.photogrammetry.VideoSampling(),
        "settings": loom.photogrammetry.SfmSettings(max_seconds=60.0, max_memory=2**32),
        "new": lambda: folder / f"new {next(numbers)}",
    }  # fmt: skip


@pytest.fixture(autouse=True)
def no_colmap(monkeypatch, things):
    """Replace COLMAP's jobs; arguments are checked before them."""

    def run_job(job: dict[str, Any], path: Path, **limits: Any) -> tuple[dict[str, Any], int]:
        assert limits["max_seconds"] > 0
        if job["stage"] == "features":
            Path(job["database"]).write_bytes(things["database"].read_bytes())
        return {"gpu": False, "sizes": [], "cameras": {}}, 0

    for module in (features, mapping, matches):
        monkeypatch.setattr(module, "run_job", run_job)


def test_the_table_names_every_argument_of_every_public_call():
    assert missing_from(TABLE, public_arguments(loom.photogrammetry, RESULTS, "photogrammetry.sfm")) == {}


test_good_arguments_are_accepted, test_hostile_values_are_rejected_by_name = argument_tests(TABLE)


@pytest.mark.parametrize("change", [
    "UPDATE images SET name = x'ff'", "UPDATE images SET name = ''",
    "UPDATE images SET image_id = 'x'", "ALTER TABLE images RENAME COLUMN name TO other", "DROP TABLE descriptors",
    "INSERT INTO descriptors VALUES (1, 2, 128, x'00')", "INSERT INTO descriptors VALUES (1, 0, 0, x'0001')",
    "INSERT INTO descriptors VALUES (2, 'x', 128, 'text')", "UPDATE two_view_geometries SET pair_id = 'x'",
    "UPDATE two_view_geometries SET rows = 'x'", "DROP TABLE images",
])  # fmt: skip
def test_values_of_other_types_in_a_database_are_errors_that_name_it(things, tmp_path, change):
    database = tmp_path / "changed.db"
    database.write_bytes(things["database"].read_bytes())
    with contextlib.closing(sqlite3.connect(database)) as connection, connection:
        connection.execute(change)
    with pytest.raises(loom.FileError, match=r"changed\.db|out\.db"):
        loom.photogrammetry.match_features(database, tmp_path / "out.db", SfmSettings(pairs="retrieval"))


def test_a_database_without_images_has_no_pairs(things, tmp_path):
    database = tmp_path / "empty.db"
    database.write_bytes(things["database"].read_bytes())
    with contextlib.closing(sqlite3.connect(database)) as connection, connection:
        connection.execute("DELETE FROM images")
    assert (
        loom.photogrammetry.match_features(database, tmp_path / "out.db", SfmSettings(pairs="retrieval")).pair_count
        == 0
    )


def test_a_mapper_is_chosen_by_how_many_images_there_are(monkeypatch, things):
    jobs, results = [], {"sizes": [], "cameras": {}}
    monkeypatch.setattr(mapping, "run_job", lambda job, *_, **__: jobs.append(job) or (results, 0))
    call, good = call_of(TABLE, "map_images", things)
    for many in (2, 1):
        monkeypatch.setattr(mapping, "MANY_IMAGES", many)
        call(**good)
    assert [job["mapper"] for job in jobs] == ["incremental", "global"]
