"""A small survey, a job of four tiles, and its expected rows."""

import pytest

import pointloom as loom

from .scenes import RADIUS, rows_of, survey, tiled


@pytest.fixture
def files(tmp_path):
    return survey(tmp_path, count=2000)


@pytest.fixture
def job(files, tmp_path):
    loom.tiling.plan_tiles(files, RADIUS, tmp_path / "job", size=30.0)
    return tmp_path / "job"


@pytest.fixture(scope="session")
def two_workers():
    """Address of a scheduler with two worker processes, which are restarted when they die."""
    distributed, config = pytest.importorskip("distributed"), pytest.importorskip("dask.config")
    # By default distributed sets OMP_NUM_THREADS and others in the environment of this process.
    environment = {"distributed.nanny.pre-spawn-environ": {"PYTHONHASHSEED": "random"}}
    options = {"threads_per_worker": 1, "memory_limit": 0, "dashboard_address": "127.0.0.1:0"}
    options |= {"silence_logs": "CRITICAL", "scheduler_kwargs": {"allowed_failures": 2}}
    with config.set(environment), distributed.LocalCluster(2, host="127.0.0.1", **options) as cluster:
        yield cluster.scheduler_address


@pytest.fixture(scope="session")
def expected(tmp_path_factory):
    folder = tmp_path_factory.mktemp("expected")
    return rows_of(tiled(survey(folder, count=2000), RADIUS, folder / "job", size=100.0)[0])
