"""Stored answers of Open3D come back as they were, and another answer is noticed."""

import numpy as np
import pytest

from . import oracle

ANSWER = {"normals": np.eye(3), "pair": (1, 2.5), "labels": [np.array([1, -1]), None], "name": "cube", "size": 7}


@pytest.fixture
def stored(tmp_path):
    path = tmp_path / "house" / "answer.npz"
    oracle.write_answer(path, ANSWER, "0.20.0")
    return path


def test_a_stored_answer_is_the_one_that_was_written(stored):
    np.testing.assert_equal(oracle.read_answer(stored), ANSWER)


@pytest.mark.parametrize(
    "other",
    [
        {"size": 8},
        {"pair": [1, 2.5]},
        {"pair": (1, 2.6)},
        {"labels": [np.array([1, 1]), None]},
        {"normals": np.ones(3)},
    ],
    ids=lambda other: next(iter(other)),
)
def test_another_answer_is_noticed(stored, other):
    with pytest.raises(AssertionError, match="make oracle"):
        oracle.compare_answers(oracle.read_answer(stored), ANSWER | other, "answer")


def test_an_answer_that_differs_by_rounding_leaves_the_file_alone(stored):
    before = stored.read_bytes()
    oracle.write_answer(stored, ANSWER | {"normals": np.eye(3) * (1 + 1e-9)}, "0.21.0")
    assert stored.read_bytes() == before


def test_an_answer_that_is_not_stored_names_the_remedy(tmp_path):
    with pytest.raises(FileNotFoundError, match="make oracle"):
        oracle.read_answer(tmp_path / "missing.npz")


def test_large_answers_are_refused(tmp_path):
    with pytest.raises(ValueError, match="100,000 bytes"):
        oracle.write_answer(tmp_path / "large.npz", np.random.default_rng(0).random(20_000), "0.20.0")


@pytest.mark.parametrize(
    ("mode", "fixtures", "selected"),
    [
        ("stored", ["oracle"], True),
        ("stored", ["o3d"], False),
        ("live", ["o3d"], True),
        ("write", ["oracle"], True),
        ("write", ["device"], False),
    ],
)
def test_only_tests_with_stored_answers_run_without_open3d(mode, fixtures, selected):
    assert oracle.is_selected(mode, fixtures) == selected
