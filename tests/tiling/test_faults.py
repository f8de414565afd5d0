"""Errors name the file or the tile, and no points are lost or duplicated."""

import os
import struct
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.points.las_writer import write_las
from pointloom.io.table import PointTable
from pointloom.tiling import plan as plan_module
from pointloom.tiling import tasks
from pointloom.tiling.manifest import DISTRIBUTES, Manifest, worker_lock
from pointloom.tiling.runners import retry_tiles
from pointloom.tiling.status import tile_status
from pointloom.tiling.steps.parse import KNOWN, parse_steps

from ..hostile import call_of, faults_of, missing_from, public_arguments, read_table
from .scenes import CORNER, RADIUS, SIDE, STEP, finished, plan_of, rows_of, survey, tiled

# One line per call: the function and a valid value of each argument. No job exists, so that nothing is run.
CALLS = """
loom.tiling.plan_tiles(sources=["scan.las"], steps=[{"step": "estimate_normals"}], folder="job", size=10.0, points=None, only=None, only_crs=None, output="laz", progress=None)
loom.tiling.run_tiles(folder="tiles", workers=1, part=None, tile=None, scheduler=None, security=None, device="cpu", functions=(), progress=None)
loom.tiling.retry_tiles(folder="tiles")
loom.tiling.finish_tiles(folder="tiles", path=None, output=None, workers=1, progress=None)
loom.tiling.plan_registration(scans=["scan.las", "scan.las"], folder="job", voxel_size=0.5, places=None, place_error=0.0, neighbors=None, pairs=None, known=(), max_similar=8, free=None, seed=0)
loom.tiling.plan_fusion(frames="frames", folder="job", voxel_size=0.1, size=2.0, truncation=0.4, depth_max=3.0, weight_threshold=0.0, layout="auto", intrinsic=None, depth_scale=1000.0, every=1)
loom.tiling.run_job(folder="scans", workers=1, part=None, device="cpu", progress=None)
loom.tiling.retry_job(folder="scans")
loom.tiling.job_status(folder="scans")
loom.tiling.finish_registration(folder="scans")
loom.tiling.finish_fusion(folder="scans", path=None)
"""  # noqa: E501
TABLE = read_table(CALLS, {})


def test_the_table_names_every_argument_of_every_public_call():
    assert missing_from(TABLE, public_arguments(loom.tiling, set())) == {}


@pytest.mark.parametrize("every", [False, pytest.param(True, marks=pytest.mark.slow)])
@pytest.mark.parametrize("call", TABLE)
def test_a_hostile_value_of_a_job_is_rejected_by_name(tmp_path, monkeypatch, call, every):
    monkeypatch.chdir(tmp_path)
    loom.write_point_cloud("scan.las", loom.PointCloud(np.eye(3)))
    function, expressions = TABLE[call]
    good, faults = {name: eval(text) for name, text in expressions.items()}, []
    for argument in good:
        faults += faults_of(call_of(function, {"loom": loom}), good, argument, every=every)
    assert not faults, "\n".join(faults)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"size": 10.0, "points": 1000}, "size, points: expected one of them, got both"),
        ({"size": 1e-7}, "size: expected at most"),
        ({"output": "las"}, "output: expected 'laz' or 'copc', got 'las'"),
        ({"only_crs": "EPSG:25832"}, "only_crs: expected polygons in only="),
        ({"only": [[0, 0], [1, 0]]}, "only: expected at least three corners, got 2"),
        ({"only": [0, 0, np.nan, 1]}, "only: expected finite"),
    ],
)
def test_options_that_contradict_or_exceed_are_rejected_when_planned(files, tmp_path, options, message):
    with pytest.raises(ValueError, match=f"^{message}"):
        loom.tiling.plan_tiles(files, RADIUS, tmp_path / "job", **options)
    assert not (tmp_path / "job").exists()


@pytest.mark.parametrize("part", [3, "1/4", (1, 2, 3), (5, 4), (0, 4), (1, 0), (1.5, 4), (1, 2.5), (1, "4")])
def test_a_part_that_does_not_exist_is_rejected(job, part):
    with pytest.raises((TypeError, ValueError), match=r"^part: expected"):
        loom.tiling.run_tiles(job, part=part)


REQUIRED = {"other": ["a.las"], "to_crs": "EPSG:25833", "call": "os:getenv"}  # of other kinds than numbers
GOOD = {"m3c2": {"normal_radii": 1.0, "core_spacing": 1.0}, "crop": {"min_bound": [0, 0, 0], "max_bound": [1, 1, 1]}}
FOUND_LATER = {"wkt", "scales", "offsets", "crs"}  # computed by planning, and the system that writing looks up
PARAMETERS = [
    (name, parameter)
    for name, step in KNOWN.items()
    for parameter in (*step.required, *step.defaults)
    if parameter not in {*REQUIRED, *FOUND_LATER, "arguments"}
]


@pytest.mark.parametrize(("name", "parameter"), PARAMETERS)
def test_every_parameter_of_a_step_rejects_wrong_values_by_name(name, parameter):
    step = KNOWN[name]
    good = {"step": name} | {required: REQUIRED.get(required, 4) for required in step.required} | GOOD.get(name, {})
    default = step.defaults.get(parameter, 4)
    is_number = isinstance(default, int | float) and not isinstance(default, bool)
    for wrong in ({"a": 1}, [[1]], *(("much", np.nan, -1) if is_number else ())):
        with pytest.raises((TypeError, ValueError), match=rf"\b{parameter}\b"):
            parse_steps([good | {parameter: wrong}])


@pytest.mark.parametrize(
    ("steps", "message"),
    [
        ([{"step": "voxel_down_sampel", "voxel_size": 1}], "'voxel_down_sample'"),
        ([{"step": "voxel_down_sample", "voxel": 1}], "'voxel'"),
        ([{"step": "voxel_down_sample"}], "voxel_size"),
        ([{"step": "voxel_down_sample", "voxel_size": -1}], "voxel_size"),
        ([{"step": "estimate_normals", "max_nn": None}], "radius"),
        ([{"step": "segment_plane", "distance": 1}], "complete cloud"),
        ([{"step": "cluster_dbscan", "eps": 1}], "min_points"),
        ([{"step": "function", "call": lambda cloud: cloud, "reach": 1}], "top-level function"),
        ([{"step": "function", "call": "no.such:thing", "reach": 1}], "call: 'no.such:thing'"),
        ([{"step": "function", "call": "no_such", "reach": 1}], "call: .*'no_such'"),
        ([{"step": "function", "call": os.getenv, "reach": 1, "arguments": [1]}], "arguments"),
        (["voxel_down_sample"], "dictionary"),
    ],
)
def test_invalid_steps_are_rejected_when_planned(files, tmp_path, steps, message):
    with pytest.raises(ValueError, match=message):
        loom.tiling.plan_tiles(files, steps, tmp_path / "job")
    assert not (tmp_path / "job").exists()


def test_steps_may_be_given_in_a_file(files, job, tmp_path):
    path, plan = tmp_path / "steps.toml", plan_of(job)
    path.write_text('[[step]]\nname = "remove_radius_outlier"\nnb_points = 4\nradius = 0.9\n')
    loom.tiling.plan_tiles(files, path, job, size=30.0)
    assert plan_of(job) == plan


@pytest.mark.parametrize(
    "text",
    [
        "step = [1, 2]",
        "[[step]]\nstep = 1",
        '[[step]]\nstep = "shell"',
        '[[step]]\nstep = "voxel_down_sample"\nvoxel_size = "1"',
        '[[step]]\nstep = "voxel_down_sample"\nvoxel_size = 1e999',
        '[[step]]\nstep = "rasterize"\ncell = 1\nname = "../a"',
        '[[step]]\nstep = "function"\ncall = "x"\nreach = 0\narguments = {day = 2020-01-01}',
        '[[step]]\nstep = "function"\ncall = "os:mkdir"\nreach = 0\narguments = {path = "called"}',
        "x = " + "[" * 100_000,
        "\xff",
    ],
)
def test_invalid_steps_in_a_file_are_an_error_that_names_it_and_no_function_is_called(
    files, tmp_path, monkeypatch, text
):
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "steps.toml"
    path.write_text(text, "latin-1")
    with pytest.raises(FileError, match=r"steps\.toml"):
        loom.tiling.plan_tiles(files, path, tmp_path / "job")
    assert {each.name for each in tmp_path.iterdir()} == {path.name, *(file.name for file in files)}


@pytest.mark.parametrize("what", ["scale", "attributes", "unit"])
def test_incompatible_files_are_named(files, tmp_path, what):
    cloud = loom.PointCloud(np.full((5, 3), CORNER), origin=CORNER, intensity=np.arange(5, dtype=np.uint16))
    if what != "attributes":
        cloud["gps_time"], cloud["range"] = np.zeros(5), np.zeros(5, np.float32)
    if what == "unit":
        cloud.unit = "foot"
    other = tmp_path / "other.laz"
    loom.write_point_cloud(other, cloud, scale=0.001 if what == "scale" else STEP)
    with pytest.raises(FileError, match=r"other\.laz"):
        loom.tiling.plan_tiles([*files, other], RADIUS, tmp_path / "job")


@pytest.mark.parametrize("name", ["missing.laz", "cloud.ply", "empty"])
def test_unreadable_sources_are_named(tmp_path, name):
    (tmp_path / "empty").mkdir()
    (tmp_path / "cloud.ply").write_text("ply")
    with pytest.raises(FileError, match=name):
        loom.tiling.plan_tiles(tmp_path / name, RADIUS, tmp_path / "job")


def test_wrong_bounds_in_a_header_are_an_error_during_the_pass(tmp_path):
    (path, _) = survey(tmp_path, count=1000, suffix=".las")
    content = bytearray(path.read_bytes())
    struct.pack_into("<d", content, 179, CORNER[0] + SIDE / 2)  # the highest x
    path.write_bytes(content)
    loom.tiling.plan_tiles(path, RADIUS, tmp_path / "job", size=10.0)
    with pytest.raises(FileError, match="outside"):
        loom.tiling.run_tiles(tmp_path / "job")
    assert tile_status(tmp_path / "job").sources_waiting == 0


def test_a_changed_plan_is_rejected_with_the_differences(files, tmp_path):
    first = loom.tiling.plan_tiles(files, RADIUS, tmp_path / "job", size=10.0)
    assert loom.tiling.plan_tiles(files, RADIUS, tmp_path / "job", size=10.0) == first
    with pytest.raises(FileError, match=r"size 20\.0, was 10\.0"):
        loom.tiling.plan_tiles(files, RADIUS, tmp_path / "job", size=20.0)
    with pytest.raises(FileError, match=r"part1\.laz"):
        loom.tiling.plan_tiles(files[:1], RADIUS, tmp_path / "job", size=10.0)


def test_a_file_modified_after_planning_is_rejected(files, job):
    os.utime(files[1], ns=(0, 0))
    with pytest.raises(FileError, match=r"part1\.laz"):
        loom.tiling.run_tiles(job)


def test_another_version_is_rejected(job, monkeypatch):
    monkeypatch.setattr(plan_module, "__version__", "9.9")
    with pytest.raises(FileError, match=r"/plan\.sqlite:.*9\.9"):
        loom.tiling.run_tiles(job)


def test_a_folder_with_other_files_is_rejected(files, tmp_path):
    with pytest.raises(FileError, match="contains files"):
        loom.tiling.plan_tiles(files, RADIUS, tmp_path)
    with pytest.raises(FileError, match="plan_tiles"):
        loom.tiling.run_tiles(tmp_path)


def test_parts_of_an_array_job_do_all_tiles_once(job, expected):
    done = [loom.tiling.run_tiles(job, part=(which, 3)).done for which in (2, 1, 3)]
    assert done[0] < done[1] < done[2]
    np.testing.assert_array_equal(rows_of(finished(job)), expected)


def test_a_part_stops_when_it_needs_results_of_other_parts(files, tmp_path):
    job = tmp_path / "job"
    steps = [{"step": "remove_statistical_outlier", "nb_neighbors": 8, "std_ratio": 1.5}]
    loom.tiling.plan_tiles(files, steps, job, size=20.0)
    assert loom.tiling.run_tiles(job, part=(1, 2)).done == 0
    status = loom.tiling.run_tiles(job, part=(2, 2))
    assert 0 < status.done < 9 and f"pass 2 of 2: {status.through} of 9 tiles finished it" in str(status)
    with pytest.raises(FileError, match="is not finished"):
        loom.tiling.finish_tiles(job)
    assert loom.tiling.run_tiles(job, part=(1, 2)).is_finished


def test_concurrent_runs_share_the_tiles(job, expected):
    with ThreadPoolExecutor() as pool:
        [*pool.map(loom.tiling.run_tiles, [job, job])]
    status = tile_status(job)
    assert status.is_finished and status.points_in == status.points
    np.testing.assert_array_equal(rows_of(finished(job)), expected)


def test_claims_of_dead_workers_are_released_and_of_live_ones_are_not(job):
    with Manifest(job) as manifest:
        manifest.claim("sources", "dead")
        with worker_lock(job) as alive:
            manifest.claim("sources", alive)
            assert manifest.release_claims() == 1 and manifest.counts("sources")["running"] == 1
        manifest.claim("sources", "dead again")
    assert loom.tiling.run_tiles(job).is_finished


def test_a_task_that_kills_its_workers_is_quarantined(job):
    with Manifest(job) as manifest:
        for death in range(3):
            assert manifest.claim("tiles", f"dead {death}")["id"] == 0
            manifest.release_claims()
    status = loom.tiling.run_tiles(job)
    assert (status.aside, status.waiting) == (1, 0) and "died 3 times" in status.troubles["0_0"]
    assert not status.reliable and status.warnings[0].startswith("0_0: ") and "died 3 times" in status.warnings[0]
    with pytest.raises(FileError, match="/job:"):
        loom.tiling.finish_tiles(job)
    retry_tiles(job)
    status = loom.tiling.run_tiles(job)
    assert status.is_finished and status.reliable and status.warnings == ()


def test_the_death_of_a_distributing_run_counts_against_no_tile(job):
    with Manifest(job) as manifest:
        for death in range(3):
            assert manifest.claim("tiles", f"dead {death}{DISTRIBUTES}")["id"] == 0
            manifest.release_claims()
    assert loom.tiling.run_tiles(job).is_finished


def fails_in_the_east(cloud):
    if os.environ.get("POINTLOOM_TEST_FAILS") and cloud.points[:, 0].max() > CORNER[0] + 35:
        raise RuntimeError("no points in the east, please")
    return cloud


def test_a_step_that_raises_fails_its_tile_alone(files, tmp_path, monkeypatch):
    job = tmp_path / "job"
    monkeypatch.setenv("POINTLOOM_TEST_FAILS", "1")
    loom.tiling.plan_tiles(files, [{"step": "function", "call": fails_in_the_east, "reach": 0}], job, size=20.0)
    status = loom.tiling.run_tiles(job)
    assert status.failed and status.done and "no points in the east" in str(status)
    assert len(status.warnings) == status.failed and status.to_dict()["reliable"] is False
    monkeypatch.delenv("POINTLOOM_TEST_FAILS")
    retry_tiles(job)
    assert loom.tiling.run_tiles(job).is_finished


@pytest.mark.parametrize("runner", [None, pytest.param("two_workers", marks=pytest.mark.slow)])
def test_a_manifest_cannot_allow_functions(files, tmp_path, monkeypatch, runner, request):
    job = tmp_path / "job"
    loom.tiling.plan_tiles(files, [{"step": "function", "call": fails_in_the_east, "reach": 0}], job, size=20.0)
    monkeypatch.setattr(plan_module, "_passed", {})  # as in another process
    with pytest.raises(FileError, match=r"plan\.sqlite"):
        loom.tiling.run_tiles(job)
    scheduler = runner and request.getfixturevalue(runner)
    assert loom.tiling.run_tiles(job, functions=[fails_in_the_east], scheduler=scheduler).is_finished


def test_empty_tiles_and_a_halo_larger_than_tiles(tmp_path):
    rng = np.random.default_rng(3)
    points = np.concatenate([rng.random((300, 3)), rng.random((300, 3)) + np.array([30, 20, 0])]) + CORNER
    write_las(tmp_path / "two.laz", PointTable(points), scale=0.01, offset=CORNER)
    steps = [{"step": "estimate_normals", "max_nn": 500}]
    result, _ = tiled(tmp_path / "two.laz", steps, tmp_path / "job", size=7.0)
    other, _ = tiled(tmp_path / "two.laz", steps, tmp_path / "one", size=100.0)
    assert tile_status(tmp_path / "job").empty > 3
    np.testing.assert_array_equal(rows_of(result), rows_of(other))


def test_a_tile_with_too_many_points_is_named(tmp_path, monkeypatch):
    monkeypatch.setattr(plan_module, "MIN_POINTS", 500)
    rng = np.random.default_rng(3)
    points = np.concatenate([rng.random((1500, 3)) * 2, rng.random((200, 3)) * SIDE]) + CORNER
    write_las(tmp_path / "dense.laz", PointTable(points), scale=0.01, offset=CORNER)
    loom.tiling.plan_tiles(tmp_path / "dense.laz", RADIUS, tmp_path / "job", size=5.0)
    status = loom.tiling.run_tiles(tmp_path / "job")
    assert status.failed == 1 and "expected at most 500 points" in status.troubles["0_0"]


def test_a_damaged_file_is_named_and_leaves_no_bucket(files, tmp_path):
    content = bytearray(files[1].read_bytes())
    (begin,) = struct.unpack_from("<I", content, 96)
    struct.pack_into("<i", content, begin + 8, 2**31 - 1)  # x of the first point
    files[1].write_bytes(content)
    loom.tiling.plan_tiles(files, RADIUS, tmp_path / "job", size=10.0)
    with pytest.raises(FileError, match=r"part1\.laz"):
        loom.tiling.run_tiles(tmp_path / "job")
    assert [path.name for path in (tmp_path / "job" / "buckets").iterdir()] == ["000000"]


@pytest.mark.slow
def test_progress_is_reported_for_files_and_each_pass_over_the_tiles(files, tmp_path, two_workers):
    steps = [{"step": "remove_statistical_outlier", "nb_neighbors": 4, "std_ratio": 3.0}]
    loom.tiling.plan_tiles(files, steps, tmp_path / "job", size=20.0)
    events = []
    loom.tiling.run_tiles(tmp_path / "job", scheduler=two_workers, progress=lambda *words: events.append(words))
    assert list(dict.fromkeys(stage for stage, _, _ in events)) == ["files", "pass 1 of 2", "pass 2 of 2"]
    assert events[0] == ("files", 0, 2) and events[-1] == ("pass 2 of 2", 9, 9)
    for stage, total in (("files", 2), ("pass 1 of 2", 9), ("pass 2 of 2", 9)):
        done = [count for name, count, of in events if name == stage and of == total]
        assert done == sorted(done) and done[-1] == total
    events.clear()
    loom.tiling.run_tiles(tmp_path / "job", scheduler=two_workers, progress=lambda *words: events.append(words))
    assert events[-1] == ("pass 2 of 2", 9, 9)


def test_one_tile_is_run_alone_and_repeated_if_it_failed(job):
    for wrong in ("3_0", "0", "-1_0", "1_1 ", 4, ("1_1",)):
        with pytest.raises(ValueError, match="tile:"):
            loom.tiling.run_tiles(job, tile=wrong)
    with pytest.raises(ValueError, match="tile, part:"):
        loom.tiling.run_tiles(job, tile="1_1", part=(1, 2))
    with Manifest(job) as manifest, manifest.change() as base:
        base.execute("UPDATE tiles SET state = 'aside', attempts = 3, error = 'a\nb' WHERE ix = 1 AND iy = 1")
    (message,) = tile_status(job).troubles.values()
    assert message == f"a b; run it alone with `pointloom tile run {job} --tile 1_1`"
    for _ in range(2):
        status = loom.tiling.run_tiles(job, tile="1_1")
        assert (status.done, status.waiting, status.aside) == (1, 3, 0)
    assert [path.name for path in (job / "tiles").iterdir()] == ["1_1.laz"]


def test_an_interrupted_run_does_not_count_as_a_failure_of_its_tile(job, monkeypatch):

    def interrupted(*_):
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(tasks, "do_task", interrupted)
        for _ in range(4):
            with pytest.raises(KeyboardInterrupt):
                loom.tiling.run_tiles(job)
    with Manifest(job) as manifest:
        (row,) = manifest.rows("SELECT sum(attempts) AS deaths, sum(state = 'waiting') AS waiting FROM tiles")
    assert (row["deaths"], row["waiting"]) == (0, 4) and loom.tiling.run_tiles(job).is_finished
