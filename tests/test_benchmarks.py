"""The harness of the benchmarks on tiny data: its scenes, its checks of results, its report. No times are asserted."""

from __future__ import annotations

import json
import os
import platform
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

FOLDER = Path(__file__).resolve().parent.parent / "benchmarks"


@pytest.fixture(scope="module", autouse=True)
def harness() -> Iterator[None]:
    """The benchmarks' folder on the path, as it is when they run, and its modules gone afterwards."""
    before = set(sys.modules)
    for path in FOLDER.glob("*.py"):
        sys.modules.pop(path.stem, None)  # another test's module may have the name
    sys.path.insert(0, str(FOLDER))
    yield
    sys.path.remove(str(FOLDER))
    for name in set(sys.modules) - before:
        if str(getattr(sys.modules[name], "__file__", "")).startswith(str(FOLDER)):
            del sys.modules[name]


def rounds(label: str, seconds: list[float], units: int = 1, first_call: float = 0.0) -> dict:
    info = {"operation": "voxel_down_sample", "size": "1M", "label": label, "units": units, "first_call_s": first_call}
    return {"extra_info": info, "stats": {"data": seconds}}


# ------------------------------------------------------------------------------------------------ scenes


@pytest.mark.parametrize("name", ["bumpy_surface", "spinning_scan"])
def test_points_are_the_same_in_every_run_and_exact_in_float32(name):
    import scenes

    make = getattr(scenes, name)
    points = make(2000)
    assert points.shape == (2000, 3) and np.isfinite(points).all()
    assert np.array_equal(points, make(2000))
    assert np.array_equal(points, points.astype(np.float32))


def test_density_of_the_spinning_scan_varies_a_thousandfold():
    import scenes
    from scipy.spatial import cKDTree

    points = scenes.spinning_scan(50_000)
    distances = cKDTree(points).query(points, k=6)[0][:, 5]
    low, high = np.quantile(1 / distances**2, (0.005, 0.995))
    assert high > 1000 * low


def test_depth_frames_show_the_walls_of_the_room():
    import scenes

    frames = scenes.room_frames(2, 64, 48)
    fx, fy, cx, cy = frames.intrinsic
    for depth, T_camera_world in zip(frames.depths, frames.extrinsics, strict=True):
        v, u = np.mgrid[:48, :64]
        z = depth / 1000
        points = np.stack([(u - cx) / fx * z, (v - cy) / fy * z, z], axis=-1).reshape(-1, 3)
        T_world_camera = np.linalg.inv(T_camera_world)
        points = points @ T_world_camera[:3, :3].T + T_world_camera[:3, 3]
        assert np.linalg.det(T_world_camera[:3, :3]) == pytest.approx(1)
        assert (points > scenes.ROOM[0] - 0.05).all() and (points < scenes.ROOM[1] + 0.05).all()
        on_wall = np.minimum(np.abs(points - scenes.ROOM[0]), np.abs(points - scenes.ROOM[1])).min(axis=1) < 0.03
        assert 0.3 < on_wall.mean() < 1


def test_file_of_colored_points_reads_back():
    import scenes

    import pointloom as loom

    scene = scenes.colored_points(100)
    cloud = loom.read_point_cloud(scene.source)
    assert np.array_equal(cloud.points, scene.points)
    assert np.array_equal(np.round(cloud.colors * 255), scene.colors)


# ------------------------------------------------------------------------------------------------ operations


def test_every_target_names_an_operation_a_size_and_peers_that_run():
    import contest
    import targets

    known = contest.operations()
    for target in targets.TARGETS:
        _, operation = known[target.operation]
        labels = {label for _, _, label in operation.places("cpu")}
        assert target.size in operation.scenes
        assert set(target.peers) <= labels - {contest.OURS}


def test_every_operation_has_ours_first_and_a_peer_on_every_device():
    import contest

    for _, operation in contest.operations().values():
        assert operation.memory_size is None or operation.memory_size in operation.scenes
        for device in ("cpu", "cuda:0"):
            labels = [label for _, _, label in operation.places(device)]
            assert labels[0] == contest.OURS and len(labels) > 1
            for label in labels:
                contestant, place = operation.contestant(label, device)
                assert place.split(":")[0] in contestant.devices or label == contest.OURS


def test_peers_without_gpu_code_stand_beside_ours_on_the_cpu():
    import contest

    _, operation = contest.operations()["marching_cubes"]
    places = {label: place for _, place, label in operation.places("cuda:0")}
    assert places["pointloom"] == "cuda:0"
    assert places["vtk (cpu)"] == "cpu"


@pytest.mark.parametrize("name", ["voxel_down_sample", "marching_cubes", "knn20_with_build"])
def test_ours_agrees_with_itself_and_not_with_a_wrong_answer(name):
    import contest
    import scenes

    tiny = {
        "voxel_down_sample": lambda: scenes.bumpy_surface(3000),
        "marching_cubes": lambda: scenes.wavy_ball(16),
        "knn20_with_build": lambda: scenes.spinning_scan(500),
    }
    _, operation = contest.operations()[name]
    contestant = operation.contestants[0]
    scene = tiny[name]()
    facts = contestant.facts(contestant.trial(scene, "cpu").once())
    operation.check(facts, facts, "open3d-legacy")
    wrong = tuple(f[:-1] if isinstance(f, np.ndarray) else f + 1 for f in facts) if isinstance(facts, tuple) else facts
    if wrong is facts:
        wrong = facts + 0.1
    with pytest.raises(AssertionError):
        operation.check(facts, wrong, "open3d-legacy")


# ------------------------------------------------------------------------------------------------ peers


PEERS = {
    "embreex": ("ray_casting", "embreex"),
    "fast-simplification": ("decimation", "fast_simplification"),
    "pyfqmr": ("decimation", "pyfqmr"),
    "meshoptimizer": ("decimation", "meshoptimizer"),
    "fpsample": ("farthest_points", "fpsample"),
    "genz-icp": ("odometry", "genz_icp"),
    "rko-lio": ("odometry", "rko_lio"),
    "numba": ("transform_kernel", "numba"),
    "quadrants": ("transform_kernel", "quadrants"),
    "py4dgeo": ("m3c2", "py4dgeo"),
    "pyransac3d": ("segment_sphere", "pyransac3d"),
}


@pytest.mark.slow
@pytest.mark.parametrize("peer", PEERS)
def test_peer_that_is_here_agrees_with_ours_at_the_quick_size(peer):
    import contest

    name, module = PEERS[peer]
    pytest.importorskip(module)
    _, operation = contest.operations()[name]
    (make,) = operation.quick.values()
    scene = make()
    facts = []
    for label in (contest.OURS, peer):
        contestant, place = operation.contestant(label, "cpu")
        facts.append(contestant.facts(contestant.trial(scene, place).once()))
    operation.check(*facts, peer)


@pytest.mark.slow
def test_peer_that_is_not_here_is_left_out_said_so_and_is_no_failure(tmp_path):
    (tmp_path / "numba.py").write_text("raise ModuleNotFoundError(\"No module named 'numba'\")\n")
    places = os.pathsep.join([str(tmp_path), *filter(None, [os.environ.get("PYTHONPATH")])])
    done = run_script("--quick", "--only", "transform_kernel", PYTHONPATH=places)
    assert done.returncode == 0, done.stderr
    assert "left out transform_kernel: numba: No module named 'numba'" in done.stderr.splitlines()
    assert "transform_kernel" in done.stdout and "numba" not in done.stdout


def test_kernel_of_the_compilers_turns_and_shifts_points():
    import bench_compilers as compilers

    points = compilers.points_of(300)()
    ours = compilers.prepare_pointloom(points, "cpu")()
    expected = points.astype(np.float64) @ compilers.MATRIX.T + compilers.SHIFT
    compilers.check(ours, expected.astype(np.float32), "numpy")
    with pytest.raises(AssertionError):
        compilers.check(ours, (expected + 1e-5).astype(np.float32), "numpy")


def test_farthest_points_from_another_start_are_a_sequence_of_the_farthest():
    import bench_farthest_points as farthest
    import scenes

    points = scenes.bumpy_surface(4000)
    ours = farthest.prepare_pointloom(points, "cpu").once().points
    sequence, distances = [7], np.full(len(points), np.inf)
    while len(sequence) < farthest.SAMPLES:
        distances = np.minimum(distances, np.linalg.norm(points - points[sequence[-1]], axis=1))
        sequence.append(int(distances.argmax()))
    farthest.check(ours, (points, points[sequence]), "fpsample")
    with pytest.raises(AssertionError, match="not open3d-legacy's"):
        farthest.check(ours, points[sequence], "open3d-legacy")
    with pytest.raises(AssertionError, match="fpsample's point 1 is"):
        farthest.check(ours, (points, points[: len(ours)]), "fpsample")


@pytest.mark.parametrize("missing", ["ours", "theirs"])
def test_surface_of_too_many_triangles_is_no_decimation(missing, o3d):
    import bench_decimation as decimation

    scene = decimation.wavy(16, 0.2)
    thin = decimation.facts(decimation.prepare_pointloom(scene, "cpu")())
    decimation.check(thin, thin, "pyfqmr")
    whole = (scene, scene.arrays)
    with pytest.raises(AssertionError, match="triangles for"):
        decimation.check(*((whole, thin) if missing == "ours" else (thin, whole)), "pyfqmr")


def test_inertial_sensor_of_the_drive_feels_its_path():
    import bench_odometry as odometry
    from street import TURN, pose_at

    times, forces, rates = odometry.inertia(30)
    assert times[0] == 0 and times[-1] >= 30 * TURN
    path = odometry.SPEED * times
    places, headings = pose_at(path, 0.0)
    step = 1 / odometry.IMU_RATE
    turned = headings[0] + np.concatenate([[0], np.cumsum((rates[1:, 2] + rates[:-1, 2]) / 2 * step)])
    np.testing.assert_allclose(turned, headings, atol=1e-4)
    c, s = np.cos(headings), np.sin(headings)
    sideways = s * forces[:, 0] + c * forces[:, 1]  # y of the world
    speeds = (places[1, 1] - places[0, 1]) / step + np.concatenate([[0], np.cumsum(sideways[:-1] * step)])
    way = places[0, 1] + np.concatenate([[0], np.cumsum(speeds[:-1] * step)])
    np.testing.assert_allclose(way, places[:, 1], atol=0.05)
    np.testing.assert_allclose(forces[:, 2], odometry.GRAVITY, atol=1e-6)


def test_trajectory_error_is_that_of_the_way_not_of_the_start():
    import bench_odometry as odometry

    truth = odometry.street_drive(3, 4, 60)().poses
    start = np.array([[0, -1, 0, 3], [1, 0, 0, 4], [0, 0, 1, 5], [0, 0, 0, 1]], float)
    assert odometry.trajectory_error(start @ truth, truth) < 1e-9
    astray = truth.copy()
    astray[1:, 2, 3] += 0.3
    assert odometry.trajectory_error(astray, truth) == pytest.approx(0.3 * np.sqrt(2 / 3))


def test_document_is_found_where_a_library_speaks_after_it():
    import run

    assert run.document_in('map begun\n{"bytes": 3}\nProfiling results\n') == {"bytes": 3}
    with pytest.raises(IndexError):
        run.document_in("Profiling results\n")


# ------------------------------------------------------------------------------------------------ memory, launches


@pytest.mark.slow
def test_peak_memory_counts_what_a_call_held_and_let_go():
    import contest
    import memory

    def call() -> int:
        held = np.ones(8_000_000)
        return int(held.sum())

    peak = memory.peak_bytes(contest.Trial(call))
    assert 56e6 < peak < 90e6


def test_launches_are_counted_by_name_and_given_back():
    import launches

    import pointloom as loom
    from pointloom.kernels import lang
    from pointloom.kernels.sampling import voxel_keys

    cloud = loom.PointCloud(np.random.default_rng(0).random((100, 3)))
    warm = cloud.voxel_down_sample(0.5)
    original = lang.launch
    with launches.timed_launches("cpu") as times:
        assert voxel_keys.launch is not original
        again = cloud.voxel_down_sample(0.5)
    assert len(again) == len(warm)
    assert lang.launch is original and voxel_keys.launch is original
    assert sum(times.counts.values()) > 1
    assert all(name.endswith("_kernel") for name in times.counts)
    times.total = 1.0
    assert "host" in times.table("voxels", 1)


# ------------------------------------------------------------------------------------------------ report, run


def test_rounds_of_all_laps_are_joined_and_given_by_unit():
    import report

    first = {"benchmarks": [rounds("pointloom", [0.2, 0.4], units=2, first_call=1.2)]}
    second = {"benchmarks": [rounds("pointloom", [0.6], units=2, first_call=1.2)]}
    timing = report.collect([first, second])["voxel_down_sample", "1M"].timings["pointloom"]
    assert timing.seconds == pytest.approx([0.1, 0.2, 0.3])
    assert (timing.best, timing.median) == pytest.approx((0.1, 0.2))
    assert timing.compile == pytest.approx(1.2 - 2 * 0.2)


@pytest.mark.parametrize(("seconds", "met"), [(0.016, True), (0.017, False)])
def test_target_is_met_by_the_minimum_against_its_own_peers(seconds, met):
    import report

    entries = [rounds("pointloom", [9.0, 0.01]), rounds("open3d-legacy", [seconds, 8.0]), rounds("scipy", [0.001])]
    factor = 1.6 if met else 1.8
    row = report.collect([{"benchmarks": entries}])["voxel_down_sample", "1M"]
    (verdict,) = row.verdicts()
    assert verdict.ratio == pytest.approx(seconds / 0.01)
    assert report.Verdict(factor, verdict.peers, verdict.ratio).met is met
    assert row.best_peer == "scipy" and row.ratio(["scipy"]) == pytest.approx(0.1)


def test_target_whose_peers_did_not_run_is_neither_met_nor_missed():
    import report

    (verdict,) = report.collect([{"benchmarks": [rounds("pointloom", [0.01])]}])["voxel_down_sample", "1M"].verdicts()
    assert verdict.met is None
    assert "not run" in str(verdict)


def test_only_takes_the_beginning_of_an_operation_or_of_a_file():
    import run

    assert list(run.choose(["ply_read"])) == ["ply_read"]
    assert list(run.choose(["tsdf", "bench_ply"])) == [
        "ply_read",
        "ply_write",
        "tsdf_integrate",
        "tsdf_mesh",
        "tsdf_ray_cast",
    ]
    with pytest.raises(ValueError, match=r"--only nothing: expected the beginning of one of .*marching_cubes"):
        run.choose(["nothing"])


def test_messages_keep_the_names_of_files_and_lose_their_folders():
    import run

    line = "marching_cubes 64^3 vtk (cpu): cannot import 'x' (/some/where/a.py): /tmp/b-1/c.ply: does not exist, 3 m/s"
    assert run.without_folders(line) == (
        "marching_cubes 64^3 vtk (cpu): cannot import 'x' (a.py): c.ply: does not exist, 3 m/s"
    )


def run_script(*arguments: str, script: str = "run.py", **environment: str) -> subprocess.CompletedProcess:
    command = [sys.executable, str(FOLDER / script), *arguments]
    inherited = {k: v for k, v in os.environ.items() if k != "PYTEST_XDIST_WORKER"}  # with it nothing is timed
    return subprocess.run(command, capture_output=True, text=True, check=False, env={**inherited, **environment})


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ("", "POINTLOOM_DATA is not set; it names the folder with reg-small-gicp"),
        ("/", "the folder that POINTLOOM_DATA names has no reg-small-gicp"),
    ],
)
def test_real_data_that_are_missing_are_named(monkeypatch, data, said):
    import bench_icp
    import real_data

    monkeypatch.setenv("POINTLOOM_DATA", data)
    with pytest.raises(real_data.DataMissingError, match=re.escape(said)):
        bench_icp.GENERALIZED.scenes["kitti pair"]()


@pytest.mark.slow
def test_a_run_without_real_data_leaves_them_out_says_so_and_is_no_failure():
    done = run_script("--quick", "--only", "gicp", POINTLOOM_DATA="")
    assert done.returncode == 0, done.stderr
    (line,) = [line for line in done.stderr.splitlines() if line.startswith("left out gicp kitti pair")]
    assert "POINTLOOM_DATA is not set" in line
    assert "gicp  " in done.stdout and "kitti pair" not in done.stdout


@pytest.mark.slow
def test_operations_are_announced_before_their_first_calls_compile():
    done = run_script("--quick", "--only", "ply")
    first, *lines = [line for line in done.stderr.splitlines() if "busy" not in line]
    assert first == "[1/1, 0:00] bench_ply"
    assert lines[0] == "  ply_read 200k (1 of 2)"
    assert lines[1].split()[:3] == ["ply_read", "200k", "pointloom"]
    assert "  ply_write 200k (2 of 2)" in lines


@pytest.mark.slow
def test_an_interrupted_run_ends_at_once_and_says_so():
    command = [sys.executable, str(FOLDER / "run.py"), "--quick", "--only", "ply"]

    def listen() -> None:
        signal.signal(signal.SIGINT, signal.SIG_DFL)  # a shell's background jobs ignore it, and so would their children

    streams = {"stderr": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
    with subprocess.Popen(command, preexec_fn=listen, **streams) as process:
        assert process.stderr is not None
        while "(1 of 2)" not in process.stderr.readline():
            assert process.poll() is None
        process.send_signal(signal.SIGINT)
        out, rest = process.communicate(timeout=300)
    assert process.returncode == 130
    assert rest.splitlines()[-1] == "Interrupted: no table, and nothing is kept."
    assert "Traceback" not in rest and out == ""


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--only", "nothing"], "--only nothing: expected the beginning of one of"),
        (["--threads", "0"], "--threads: expected at least 1, got 0"),
        (["--output", "no/such/folder/a.json"], "its folder does not exist"),
        (["--device", "tpu"], "tpu"),
        (["--fast"], "unrecognized arguments: --fast"),
    ],
)
def test_a_wrong_argument_is_refused_before_anything_runs(arguments, said):
    done = run_script(*arguments)
    assert done.returncode == 2 and done.stdout == ""
    assert said in done.stderr and "Traceback" not in done.stderr


@pytest.mark.slow
def test_quick_run_prints_a_table_and_writes_json_that_names_no_place(tmp_path):
    output = tmp_path / "result.json"
    done = run_script("--quick", "--only", "marching", "--output", str(output))
    assert done.returncode == 0, done.stderr
    assert done.stdout.split("\n")[0].split()[:3] == ["operation", "size", "contestant"]
    text = output.read_text()
    content = json.loads(text)
    for place in (str(FOLDER.parent), str(Path.home()), sys.prefix, platform.node()):
        assert place not in text
    (result,) = content["results"]
    assert result["contestants"].keys() >= {"pointloom", "scikit-image"}
    assert all(0 < c["min_s"] <= c["median_s"] for c in result["contestants"].values())
    assert content["versions"].keys() >= {"pointloom", "warp-lang", "scikit-image"}
    assert content["quick"] and content["problems"]["failed"] == []


# ------------------------------------------------------------------------------------------------ first use


@pytest.mark.slow
def test_first_use_of_processes_together_is_that_of_the_slowest(tmp_path):
    output = tmp_path / "first_use.json"
    chosen = ["--only", "voxel_down_sample", "--laps", "1", "--together", "2", "--output", str(output)]
    done = run_script(*chosen, script="first_use.py")
    assert done.returncode == 0, done.stdout + done.stderr
    content = json.loads(output.read_text())
    assert content["processes"] == 2 and content["failed"] == {}
    (lap,) = content["operations"]["voxel_down_sample"]["laps"]
    assert set(lap) == {"import", "data", "first", "second", "process", "cpu"}
    assert min(lap.values()) > 0


@pytest.mark.slow
def test_first_use_fails_where_one_of_the_processes_does():
    chosen = ["--only", "voxel_down_sample", "--laps", "1", "--cold", "--together", "2"]
    done = run_script(*chosen, script="first_use.py", POINTLOOM_CPU="none")
    assert done.returncode == 1
    assert "FAILED: 2 of 2 processes: RuntimeError: POINTLOOM_CPU: expected warp or taichi, got 'none'" in done.stdout
