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


def test_a_stored_answer_equals_the_written_one(stored):
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
