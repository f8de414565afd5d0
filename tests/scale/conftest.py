"""A small survey, a job of four tiles on it, and the rows that the job gives."""

from __future__ import annotations

import pytest

import pointloom as loom

from .scenes import RADIUS, rows_of, survey, tiled


@pytest.fixture
def files(tmp_path):
    return survey(tmp_path, count=2000)


@pytest.fixture
def job(files, tmp_path):
    loom.scale.plan_tiles(files, RADIUS, tmp_path / "job", size=30.0)
    return tmp_path / "job"


@pytest.fixture(scope="session")
def expected(tmp_path_factory):
    folder = tmp_path_factory.mktemp("expected")
    return rows_of(tiled(survey(folder, count=2000), RADIUS, folder / "job", size=100.0)[0])
