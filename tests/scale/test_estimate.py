"""What a job of tiles will take, held against what it takes."""

import math
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.files.points.copc_writer import write_copc
from pointloom.files.points.las import read_las
from pointloom.files.points.las_writer import write_las
from pointloom.files.table import PointTable
from pointloom.scale import calibration, estimate
from pointloom.scale import plan as plan_module
from pointloom.scale.calibration import Counts
from pointloom.scale.plan import open_plan

from .scenes import survey

SOURCES = str(Path(__file__).parents[2] / "src")
THIN = [{"step": "voxel_down_sample", "voxel_size": 0.5}]
CHAIN = [
    {"step": "remove_statistical_outlier", "nb_neighbors": 12, "std_ratio": 3.0},
    {"step": "voxel_down_sample", "voxel_size": 0.5},
    {"step": "estimate_normals", "radius": 2.0, "max_nn": 30, "orient": "up"},
]


def uneven(folder, count, *, files=2):
    """A hilly ground of ten points a unit of area, ten times as dense about one place as at the rim."""
    rng = np.random.default_rng(0)
    places = rng.random((8 * count, 2))
    nearness = np.exp(-((places - 0.35) ** 2).sum(axis=1) / 0.03)
    places = places[rng.random(len(places)) < 0.1 + 0.9 * nearness][:count] * (count / 10) ** 0.5
    assert len(places) == count
    height = np.sin(places[:, 0] / 20) * 5 + rng.normal(size=count) * 0.05
    height[::200] += rng.random(len(height[::200])) * 20
    points = np.column_stack([places, height])
    paths = []
    for number, rows in enumerate(np.array_split(np.argsort(places[:, 0], kind="stable"), files)):
        path = folder / f"uneven{number}.laz"
        table = PointTable(points[np.sort(rows)], attributes={"gps_time": np.sort(rng.random(len(rows)))})
        write_las(path, table, scale=0.001, offset=np.zeros(3))
        paths.append(path)
    return paths


@pytest.fixture
def in_this_process(monkeypatch):
    """A calibration whose tasks start no process."""

    def measured(folder, what, threads, functions):
        manifest, plan = open_plan(folder)
        manifest.base.close()
        told = calibration._lay(plan, folder) if what == "files" else calibration._work(plan, folder, int(what), 0.0)
        return calibration.Measured(**told | {"base": 1, "peak": 1 + told["points"]})

    monkeypatch.setattr(calibration, "_measured", measured)


def counted(paths, folder, **how):
    loom.scale.plan_tiles(paths, THIN, folder, **how)
    manifest, plan = open_plan(folder)
    manifest.base.close()
    return plan, Counts(plan)


def test_tiles_and_their_halos_are_counted(tmp_path):
    paths = uneven(tmp_path, 4000)
    plan, counts = counted(paths, tmp_path / "job", size=3.98765)
    places = np.concatenate([read_las(path).points for path in paths])[:, :2]
    own = np.bincount(plan.tile_of(places), minlength=plan.shape[0] * plan.shape[1])
    np.testing.assert_allclose(counts.within(0.0).ravel(), own, atol=1e-6)
    wide = np.zeros(plan.shape[::-1])
    for iy in range(plan.shape[1]):
        for ix in range(plan.shape[0]):
            x0, y0, x1, y1 = plan.window(ix, iy, plan.size / 4)  # two of the eight cells of a tile
            x, y = places[:, 0], places[:, 1]
            wide[iy, ix] = ((x >= x0) & (x < x1) & (y >= y0) & (y < y1)).sum()
    np.testing.assert_allclose(counts.within(plan.size / 4), wide, atol=1e-6)
    assert not counts.is_sample and counts.within(1e9).min() == 4000


@pytest.mark.parametrize("kind", ["sample", pytest.param("copc", marks=pytest.mark.slow)])
def test_points_of_tiles_are_told_from_a_sample_or_an_octree(tmp_path, monkeypatch, kind):
    monkeypatch.setattr(calibration, "WHOLE", 1000)
    monkeypatch.setattr(calibration, "SAMPLE", 2000)
    total = 20_000 if kind == "sample" else 400_000  # in some nodes
    paths = uneven(tmp_path, total)
    if kind == "copc":
        copc = [path.with_suffix(".copc.laz") for path in paths]
        for path, target in zip(paths, copc, strict=True):
            write_copc(target, read_las(path), scale=0.001)
        paths = copc
    else:
        paths = [Path(shutil.copy(path, path.with_suffix(".las"))) for path in paths]
        for path in paths:
            loom.write_point_cloud(path, loom.read_point_cloud(path.with_suffix(".laz")), scale=0.001)
    plan, counts = counted(paths, tmp_path / "job", points=total // 8)
    places = np.concatenate([loom.read_point_cloud(path).points for path in paths])[:, :2]
    own = np.bincount(plan.tile_of(places), minlength=plan.shape[0] * plan.shape[1])
    told = counts.within(0.0).ravel()
    assert counts.is_sample == (kind == "sample") and told.sum() == pytest.approx(total)
    assert np.abs(told - own).sum() < 0.2 * total


def test_an_estimate_adds_up(tmp_path, in_this_process):
    """All tiles are alike but for their points, of which each takes as much: what is measured is what is told."""
    paths = uneven(tmp_path, 6000)
    told = loom.scale.estimate_tiles(paths, THIN, size=8.0, workers=2)
    loom.scale.plan_tiles(paths, THIN, tmp_path / "job", size=8.0)
    real = loom.scale.run_tiles(tmp_path / "job")
    assert (told.workers, told.points, told.tiles, told.poor) == (2, 6000, real.done, None)
    assert told.points_out.value == pytest.approx(real.points_out, rel=0.15)
    assert told.points_out.low <= real.points_out <= told.points_out.high
    assert told.temporary.value == pytest.approx(real.bucket_bytes, rel=0.5)
    assert "rows laid by tile; points of tiles counted" in told.calibration
    for figure in (told.seconds, told.cpu_seconds, told.memory, told.temporary, told.output):
        assert 0 < figure.low <= figure.value <= figure.high
    assert told.seconds.value < told.cpu_seconds.value
    assert told.to_json()["memory"]["value"] == told.memory.value
    copc = loom.scale.estimate_tiles(paths, THIN, size=8.0, output="copc")
    assert copc.temporary.value == pytest.approx(told.temporary.value + told.output.value, rel=1e-6)


def test_of_many_rows_some_are_read_and_that_is_said(tmp_path, monkeypatch, in_this_process):
    monkeypatch.setattr(calibration, "MOST_READ", 3000)
    told = loom.scale.estimate_tiles(uneven(tmp_path, 6000), THIN, size=8.0)
    assert "of every 2.0 rows one: neighbours are fewer" in told.calibration


def test_copc_files_need_no_buckets(tmp_path, in_this_process):
    (path,) = uneven(tmp_path, 4000, files=1)
    write_copc(tmp_path / "a.copc.laz", read_las(path), scale=0.001)
    told = loom.scale.estimate_tiles(tmp_path / "a.copc.laz", THIN, size=8.0)
    assert told.temporary.high == 0 and "laid" not in told.calibration and "temporary  none" in str(told)


def test_a_tile_that_holds_too_much_is_told(tmp_path, monkeypatch, in_this_process):
    monkeypatch.setattr(plan_module, "LEAST_POINTS", 500)
    monkeypatch.setattr(plan_module, "MOST_POINTS", 2)
    told = loom.scale.estimate_tiles(uneven(tmp_path, 4000), THIN, size=3.0)
    assert told.poor.endswith("at most 500 may be: take smaller tiles")


def test_costs_follow_the_points_of_tiles():
    counts = np.array([0.0, 50.0, 100.0, 200.0, 400.0])
    total = estimate._over(counts, [200, 100], [30.0, 10.0])  # 0.1 a point, then 0.15
    assert total.value == 0 + 5 + 10 + 30 + 60
    assert total.low == pytest.approx(75.0) and total.high == pytest.approx(112.5)
    assert estimate._over(counts, [200, 100], [30.0, 10.0], among=4).value == 60  # one tile's time
    assert estimate._over(counts, [200, 100], [30.0, 10.0], among=1, intercept=1.0).value == 1 + 5.5 + 100


@pytest.mark.slow
def test_what_fails_in_a_calibration_is_told(tmp_path):
    steps = [{"step": "function", "call": math.sqrt, "reach": 1.0}]
    with pytest.raises(ValueError, match=r"the calibration failed at tile \d+: .*TypeError"):
        loom.scale.estimate_tiles(survey(tmp_path, count=500), steps)
    with pytest.raises(FileError, match="missing"):
        loom.scale.estimate_tiles(tmp_path / "missing.laz", THIN)


@pytest.mark.slow
@pytest.mark.parametrize(("steps", "points"), [(CHAIN, 15_000), (THIN, 30_000)])
def test_a_run_takes_what_was_estimated(tmp_path, steps, points):
    """Within a factor of two, in CPU time, memory, temporary disk and output."""
    paths = uneven(tmp_path, 200_000)
    told = loom.scale.estimate_tiles(paths, steps, points=points)
    loom.scale.plan_tiles(paths, steps, tmp_path / "job", points=points)
    program = (
        f"import sys, time; sys.path.insert(0, {SOURCES!r}); import pointloom as loom\n"
        "from pointloom.scale.calibration import _peak\n"
        f"loom.scale.run_tiles({str(tmp_path / 'job')!r}); print(time.process_time(), _peak())"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True, timeout=300)
    cpu, peak = map(float, done.stdout.split())
    real = loom.scale.tile_status(tmp_path / "job")
    size = sum(path.stat().st_size for path in (tmp_path / "job" / "tiles").iterdir())
    pairs = [(told.cpu_seconds, cpu), (told.memory, peak), (told.temporary, real.bucket_bytes), (told.output, size)]
    for figure, found in [*pairs, (told.points_out, real.points_out)]:
        assert found / 2 < figure.value < found * 2, (figure, found)


@pytest.mark.slow
def test_what_tiles_leave_for_a_join_is_estimated(tmp_path, in_this_process, monkeypatch):
    steps = [{"step": "cluster_euclidean", "tolerance": 0.2}]
    paths = uneven(tmp_path, 6000)
    told = loom.scale.estimate_tiles(paths, steps, points=500)
    loom.scale.plan_tiles(paths, steps, tmp_path / "job", points=500)
    assert loom.scale.run_tiles(tmp_path / "job").is_finished
    left = sum(path.stat().st_size for name in ("left", "joined") for path in (tmp_path / "job" / name).rglob("*.npy"))
    assert left > 100_000
    buckets = loom.scale.tile_status(tmp_path / "job").bucket_bytes
    assert told.temporary.low < left + buckets < told.temporary.high
