"""Every public call of structure from motion rejects invalid arguments by name."""

import itertools
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pointloom as loom
from pointloom.photogrammetry.sfm import features, mapping, matches

from ...hostile import faults_of, missing_from, public_arguments, read_table, temporary_folder
from .conftest import write_pictures

LIMITS = "seed=0, max_seconds=60.0, max_memory=2**32, progress=None"
KINDS = "masks=None, kind='sift', use_gpu=None"
FEATURE_OPTIONS = f"camera_model='PINHOLE', intrinsic=None, max_size=640, max_features=500, {KINDS}, {LIMITS}"
CALLS = f"""
loom.sfm.choose_frames(source=pictures, folder=new(), max_frames=5, max_size=64, min_movement=0.04, max_gap=30, kind="png", reader="auto", masks=None, max_seconds=60.0, max_memory=2**32, progress=None)
loom.sfm.find_features(pictures=pictures, database=new(), {FEATURE_OPTIONS})
loom.sfm.match(database=database, matches=new(), pairs="auto", overlap=10, neighbors=5, use_gpu=None, {LIMITS})
loom.sfm.map_pictures(pictures=pictures, matches=database, folder=new(), mapper="auto", {LIMITS})
loom.sfm.reconstruct(pictures=pictures, work=new(), pairs="auto", overlap=10, mapper="auto", {FEATURE_OPTIONS})
loom.sfm.assess_model(model=model, picture_count=3, model_sizes=[2, 1], focal=None, poses=None, repetition=None)
loom.sfm.read_picture_places(source=pictures)
loom.sfm.write_training_folder(folder=new(), model=model, pictures=[gray, gray], masks=[None, seen], max_size=64, shift=True, device="cpu", overwrite=True, progress=None)
loom.sfm.triangulate(pictures=pictures, cameras=posed, max_size=640, max_features=500, device="cpu", {LIMITS})
"""  # noqa: E501
TABLE = {name.removeprefix("sfm."): call for name, call in read_table(CALLS, {}).items()}
RESULTS = {"FrameChoice", "PicturePlace", "PicturePlaces", "TrainingFolder", "TriangulationResult"}
RESULTS |= {"FeatureReport", "MatchReport", "SfmResult", "ModelQuality"}


@pytest.fixture(autouse=True)
def no_colmap(monkeypatch):
    """Replace COLMAP's jobs; arguments are checked before them."""

    def run_job(job: dict[str, Any], path: Path, **limits: Any) -> tuple[dict[str, Any], int]:
        assert limits["max_seconds"] > 0
        if job["stage"] == "features":
            Path(job["database"]).write_bytes(things()["database"].read_bytes())
        return {"gpu": False, "sizes": [], "cameras": {}}, 0

    for module in (features, matches, mapping):
        monkeypatch.setattr(module, "run_job", run_job)


@cache
def folder() -> Path:
    return temporary_folder()


@pytest.fixture(scope="module", autouse=True)
def no_files_left():
    yield
    import shutil

    shutil.rmtree(folder())
    folder.cache_clear()
    things.cache_clear()


numbers = itertools.count()


@cache
def things() -> dict[str, Any]:
    import sqlite3

    rng = np.random.default_rng(0)
    pictures = write_pictures(folder() / "in", rng.integers(0, 256, (2, 48, 64)).astype(np.uint8))
    database = folder() / "made.db"
    with sqlite3.connect(database) as connection:
        connection.execute("CREATE TABLE images (image_id INTEGER, name TEXT)")
        connection.execute("CREATE TABLE keypoints (image_id INTEGER, rows INTEGER, cols INTEGER, data BLOB)")
        connection.execute("CREATE TABLE descriptors (image_id INTEGER, rows INTEGER, cols INTEGER, data BLOB)")
        connection.execute("CREATE TABLE two_view_geometries (pair_id INTEGER, rows INTEGER)")
        connection.execute("INSERT INTO two_view_geometries VALUES (2147483649, 9)")
        connection.executemany("INSERT INTO images VALUES (?, ?)", [(1, "view 0.png"), (2, "view 1.png")])
    connection.close()
    camera = loom.CameraModel("PINHOLE", 64, 48, [60, 60, 32, 24])
    poses = np.tile(np.eye(4), (2, 1, 1))
    poses[1, 0, 3] = -1
    model = loom.SfmModel(["a", "b"], [camera] * 2, poses, points=[[0, 0, 2.0]])
    named = {"loom": loom, "pictures": pictures, "database": database, "model": model}
    posed = loom.SfmModel(["view 0", "view 1"], [camera] * 2, poses)
    gray = rng.integers(0, 256, (48, 64)).astype(np.uint8)
    named |= {"posed": posed, "gray": gray, "seen": gray >= 0}
    return named | {"new": lambda: folder() / f"new {next(numbers)}"}


def test_the_table_names_every_argument_of_every_public_call():
    assert missing_from(TABLE, public_arguments(loom.sfm, RESULTS)) == {}


def call_of(name: str) -> tuple[Any, dict[str, Any]]:
    function, expressions = TABLE[name]

    def call(**given: Any) -> Any:
        outputs = {key: eval(value, dict(things())) for key, value in expressions.items() if value == "new()"}
        selected = {key: value for key, value in outputs.items() if given[key] is good[key]}
        return eval(function, dict(things()))(**(given | selected))

    good = {key: eval(value, dict(things())) for key, value in expressions.items()}
    return call, good


@pytest.mark.parametrize("name", TABLE)
def test_the_good_arguments_are_taken(name):
    call, good = call_of(name)
    call(**good)


CASES = [(name, argument) for name, (_, arguments) in TABLE.items() for argument in arguments]


@pytest.mark.parametrize(("name", "argument"), CASES)
def test_a_hostile_value_is_refused_by_name(name, argument, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # where a string of digits is a good name of a file
    call, good = call_of(name)
    faults = faults_of(call, good, argument)
    assert not faults, "\n".join(faults)


def test_a_mapper_is_chosen_by_how_many_pictures_there_are(monkeypatch):
    jobs, results = [], {"sizes": [], "cameras": {}}
    monkeypatch.setattr(mapping, "run_job", lambda job, *_, **__: jobs.append(job) or (results, 0))
    call, good = call_of("map_pictures")
    for many in (2, 1):
        monkeypatch.setattr(mapping, "MANY_PICTURES", many)
        call(**good)
    assert [job["mapper"] for job in jobs] == ["incremental", "global"]
