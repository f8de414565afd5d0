"""Retrieval of similar pictures, independent of their order and reproducible."""

import sqlite3
from pathlib import Path

import numpy as np

from pointloom.photogrammetry.sfm import matches
from pointloom.photogrammetry.sfm.matches import match


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


def test_views_of_one_scene_are_retrieved_together():
    sets = descriptors_of_scenes(count=12, views=4)
    alike = matches.alike_pictures(sets, 3, seed=0, words=16)
    right = [j // 4 == i // 4 for i, row in enumerate(alike) for j in row]
    assert len(right) == 3 * 48 and np.mean(right) > 0.95
    assert all(i not in row for i, row in enumerate(alike))


def test_a_second_run_changes_nothing():
    sets = descriptors_of_scenes(count=6, views=4)
    assert matches.alike_pictures(sets, 3, seed=0, words=16) == matches.alike_pictures(sets, 3, seed=0, words=16)


def test_distances_are_exact_and_the_first_of_equal_words_is_taken():
    rng = np.random.default_rng(0)
    descriptors, words = (rng.integers(0, 256, (count, 128), dtype=np.uint8) for count in (500, 9))
    words[5] = words[2]
    exact = ((descriptors[:, None].astype(int) - words[None]) ** 2).sum(axis=2).argmin(axis=1)
    assert np.array_equal(matches.nearest_words(descriptors, words), exact) and 5 not in exact


def test_pictures_without_features_are_like_none():
    none = np.zeros((0, 128), np.uint8)
    sets = [*descriptors_of_scenes(count=2, views=2), none]
    alike = matches.alike_pictures(sets, 9, seed=0, words=8)
    assert alike[4] == [] and [len(row) for row in alike] == [3, 3, 3, 3, 0]
    assert matches.alike_pictures([none, none], 9, seed=0) == [[], []]


def test_many_pictures_are_matched_in_sequence_and_by_retrieval(tmp_path, monkeypatch):
    sets = descriptors_of_scenes(count=11, views=4)
    order = np.random.default_rng(3).permutation(len(sets))
    database = tmp_path / "f.db"
    with sqlite3.connect(database) as connection:
        connection.execute("CREATE TABLE images (image_id INTEGER, name TEXT)")
        connection.execute("CREATE TABLE descriptors (image_id INTEGER, rows INTEGER, cols INTEGER, data BLOB)")
        connection.execute("CREATE TABLE two_view_geometries (pair_id INTEGER, rows INTEGER)")
        for k, index in enumerate(order):
            connection.execute("INSERT INTO images VALUES (?, ?)", (k + 1, f"a picture {k:02d}.png"))
            connection.execute("INSERT INTO descriptors VALUES (?, 45, 128, ?)", (k + 1, sets[index].tobytes()))
    connection.close()
    given = {}

    def run_job(job, path, **limits):
        if "list" in job:
            given[job["pairs"]] = [tuple(map(int, line.split())) for line in Path(job["list"]).read_text().splitlines()]
        return {}, 0

    monkeypatch.setattr(matches, "run_job", run_job)
    for pairs in ("retrieval", "auto"):
        report = match(database, tmp_path / "m.db", pairs=pairs, overlap=2, neighbors=3)
        with sqlite3.connect(tmp_path / "m.db") as connection:
            assert "a picture 07.png" in {name for (name,) in connection.execute("SELECT name FROM images")}
        connection.close()
        assert report.pair_count == len(given[report.pairs]) == len(set(given[report.pairs]))
    looks, mixed = given["retrieval"], given[matches.MIXED]
    assert set(looks) < set(mixed) and len(mixed) > 80 and (1, 3) in mixed
    same = [order[a - 1] // 4 == order[b - 1] // 4 for a, b in looks]
    assert sum(same) >= 0.9 * 6 * 11  # of the six pairs of each scene
