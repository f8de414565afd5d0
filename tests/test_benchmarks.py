"""The harness of the benchmarks on tiny data: its scenes, its checks of results, its report. No times are asserted."""

from __future__ import annotations

import argparse
import contextlib
import importlib
import json
import sys
from collections import Counter
from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from .programs import BENCHMARKS as FOLDER
from .programs import benchmarks_on_path, load_program


@pytest.fixture(scope="module", autouse=True)
def harness() -> Iterator[None]:
    with benchmarks_on_path():
        yield


def benchmark_module(name: str) -> Any:
    """A fixture with a module of benchmarks/."""
    return pytest.fixture(lambda harness: importlib.import_module(name), scope="module", name=name)


bench_launch, code_digests, contest, report = map(
    benchmark_module, ("bench_launch", "code_digests", "contest", "report")
)
run, scenes, targets, write_pages = map(benchmark_module, ("run", "scenes", "targets", "write_pages"))

# ------------------------------------------------------------------------------------------------ operations


def test_every_target_and_every_reason_names_an_operation_and_a_size(contest, targets):
    known = contest.operations()
    for operation, size in [*targets.TARGETS, *targets.REASONS]:
        assert size in known[operation][1].scenes


def test_long_and_memory_sizes_are_sizes_of_the_operation(contest):
    for _, operation in contest.operations().values():
        assert set(operation.long) < set(operation.scenes)
        assert list(operation.sizes(long=True)) == list(operation.scenes)
        assert operation.memory_size is None or operation.memory_size in operation.sizes()


def test_baselines_of_long_runs_are_contestants_beside_another_one(contest):
    for _, operation in contest.operations().values():
        names = {contestant.name for contestant in operation.contestants}
        for size, slow in operation.slow.items():
            assert size in operation.sizes() and {*slow} < names - {contest.POINTLOOM}


def test_every_operation_has_pointloom_first_and_a_baseline_on_every_device(contest):
    for _, operation in contest.operations().values():
        for device in ("cpu", "cuda:0"):
            labels = [label for _, _, label in operation.contestants_on(device)]
            assert labels[0] == contest.POINTLOOM and len(labels) > 1
            for label in labels:
                contestant, device_name = operation.contestant(label, device)
                assert device_name.split(":")[0] in contestant.devices or label == contest.POINTLOOM


def test_launches_by_warp_pass_the_arguments_of_the_kernel(bench_launch, monkeypatch):
    monkeypatch.setattr(bench_launch, "LAUNCHES", 2)
    own, warp = (prepare(100, "cpu")() for prepare in (bench_launch.prepare_pointloom, bench_launch.prepare_warp))
    bench_launch.check(own, warp, "warp")
    assert np.abs(own).max() > 0


@pytest.mark.parametrize("name", ["voxel_down_sample", "marching_cubes", "knn20_with_build"])
def test_results_agree_with_themselves_and_not_with_a_wrong_result(name, contest, scenes):
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
def test_available_baselines_agree_with_pointloom_at_the_quick_size(peer, monkeypatch, contest):
    monkeypatch.delenv("OMP_NUM_THREADS", raising=False)  # py4dgeo warns if it is set
    name, module = PEERS[peer]
    pytest.importorskip(module)
    _, operation = contest.operations()[name]
    (make,) = operation.quick.values()
    scene = make()
    facts = []
    for label in (contest.POINTLOOM, peer):
        contestant, device_name = operation.contestant(label, "cpu")
        facts.append(contestant.facts(contestant.trial(scene, device_name).once()))
    operation.check(*facts, peer)


# ------------------------------------------------------------------------------------------------ report, run


def saved_run(ratio: float, operation: str = "dbscan", size: str = "1k") -> dict:
    seconds = {"pointloom": 0.01, "other": ratio / 100}
    contestants = {name: {"min_s": each, "peak_memory_bytes": None} for name, each in seconds.items()}
    row = {"operation": operation, "size": size, "contestants": contestants, "target": 2.0}
    return {
        "date": "2026-02-01T00:00:00+00:00", "seconds": 60.0, "commit": "0123456789ab",
        "machine": {"cpu": "a processor", "threads": 2},
        "results": [{**row, "best_peer": "other", "ratio": ratio}, {**row, "size": "alone"}],
        "problems": {"failed": ["dbscan 1k third: it failed"]},
    }  # fmt: skip


def test_the_page_has_each_row_with_a_baseline(write_pages):
    text = write_pages.measured_table(saved_run(3.0))
    assert "1 February 2026" in text and "2 cores (a processor)" in text
    assert "| `dbscan` | 1k | 10.0 ms | other 30.0 ms | 3.0 | 2 |  |" in text and "alone" not in text
    assert "- dbscan 1k third: it failed" in text


@pytest.mark.parametrize("ratio", [0.5, 1.5])
def test_a_row_below_its_target_needs_a_reason(ratio, monkeypatch, write_pages):
    monkeypatch.setattr(write_pages, "REASONS", {})
    with pytest.raises(ValueError, match="dbscan 1k"):
        write_pages.measured_table(saved_run(ratio))
    monkeypatch.setattr(write_pages, "REASONS", {("dbscan", "1k"): "Memory is the limit."})
    assert "| `dbscan` | 1k | Memory is the limit. |" in write_pages.measured_table(saved_run(ratio))


def test_the_readme_has_the_operations_that_are_furthest_behind(monkeypatch, write_pages):
    monkeypatch.setattr(write_pages, "SHOWN", {("dbscan", "1k"): ("clusters", "1k points")})
    run = saved_run(3.0)
    ratios = {("fpfh", "a"): 0.9, ("fpfh", "b"): 0.5, ("fpfh", "c"): 0.6, ("poisson", "d"): 0.7, ("ply_read", "e"): 0.8}
    run["results"] += [saved_run(ratio, *key)["results"][0] for key, ratio in ratios.items()]
    lines = [line for line in write_pages.readme_table(run).splitlines() if line.startswith("|")]
    assert [line.split("|")[1:3] for line in lines[2:]] == [
        [" clusters ", " 1k points "], [" `fpfh` ", " b "], [" `poisson` ", " d "]
    ]  # fmt: skip
    assert "ahead in 1 of 6 rows" in " ".join(write_pages.readme_table(run).split())


def test_growth_of_n_squared_has_the_exponent_two(write_pages):
    sizes = [{"count": 4**k, "seconds": 16.0**k, "bytes": 4**k} for k in range(4)]
    rows = [{"operation": "pairs", "sizes": sizes}, {"operation": "other", "error": "MemoryError"}]
    lines = list(write_pages.growth_tables({"about": saved_run(1.0), "rows": rows}))
    assert lines[-2].startswith("| `pairs` |") and [t.strip() for t in lines[-2].split("|")][6::2] == ["2.00", "1.00"]
    assert "MemoryError" in lines[-1]


def test_check_finds_a_page_that_differs_from_the_saved_runs(tmp_path, monkeypatch, capsys, write_pages):
    page = tmp_path / "page.md"
    page.write_text("old")
    monkeypatch.setattr(write_pages, "ROOT", tmp_path)
    monkeypatch.setattr(write_pages, "pages", lambda: {page: "new"})
    assert write_pages_code(monkeypatch, "--check") == 1
    assert "page.md" in capsys.readouterr().err and page.read_text() == "old"
    assert write_pages_code(monkeypatch) == 0 and page.read_text() == "new"
    assert write_pages_code(monkeypatch, "--check") == 0


# ------------------------------------------------------------------------------------------------ digests


MODULE = b'''"""Steps of a search."""

from math import inf, nan

STEPS = ["a", "b"]


def search(count=3, *, limit=inf):
    """Search."""
    return f"{count:>{limit}} of {limit!r}"  # the limit
'''


@pytest.mark.parametrize(
    ("is_same", "old", "new"),
    [
        (True, b"  # the limit", b""),
        (True, b"Steps of a search.", b"Other text."),
        (True, b'    """Search."""\n', b""),
        (True, b'["a", "b"]', b"[\n    'a',  'b', ]"),
        (True, b"\n", b"\r\n"),
        (True, b" of {limit!r}", b' of " f"{limit!r}'),
        (False, b"count=3", b"count=4"),
        (False, b"count=3", b"count=3.0"),
        (False, b"=inf", b"=None"),
        (False, b"inf, nan", b"nan, inf"),
        (False, b'["a", "b"]', b'["a" "b"]'),
        (False, b'["a", "b"]', b'("a", "b")'),
        (False, b"!r", b"!s"),
        (False, b" of ", b" in "),
        (False, b", *, ", b", "),
    ],
)
def test_digest_changes_with_the_code_only_and_not_with_text_and_formatting(is_same, old, new, code_digests):
    assert old in MODULE
    digests = {code_digests.code_digest(code) for code in (MODULE, MODULE.replace(old, new))}
    assert len(digests) == (1 if is_same else 2)


@pytest.mark.parametrize("annotated", [True, False])
def test_annotations_count_only_if_they_are_compiled(annotated, code_digests):
    plain, typed = b"def f(a, b=1): return a", b"def f(a: int, b: float = 1) -> int: return a"
    digests = {code_digests.code_digest(code, annotated=annotated) for code in (plain, typed)}
    assert len(digests) == (2 if annotated else 1)


def write_pages_code(monkeypatch, *arguments: str) -> int:
    import write_pages

    monkeypatch.setattr(sys, "argv", ["write_pages.py", *arguments])
    return write_pages.main()


def test_only_a_complete_run_replaces_the_saved_results(tmp_path, monkeypatch, run):
    monkeypatch.setattr(run, "FOLDER", tmp_path)
    about = {"device": "cpu"}
    run.save(argparse.Namespace(output=None, quick=False, only=["dbscan"]), about, about)
    run.save(argparse.Namespace(output=None, quick=True, only=None), about, about)
    assert list(tmp_path.iterdir()) == []
    run.save(argparse.Namespace(output=None, quick=False, only=None), about, about)
    assert json.loads((tmp_path / "results" / "operations-cpu.json").read_text()) == about


def test_a_clearly_slower_baseline_ends_after_one_lap_and_the_others_do_not(monkeypatch):
    conftest = load_program(FOLDER / "conftest.py", "conftest_of_benchmarks")
    seconds, calls = {"pointloom": 0.01, "slow": 0.05, "best": 0.02, "second": 0.03}, []

    def time_one(label, benchmark, rounds):
        calls.append(label)
        benchmark.stats = SimpleNamespace(stats=SimpleNamespace(min=seconds[label]))
        return rounds * seconds[label], None

    monkeypatch.setattr(conftest, "_timed", time_one)
    started = SimpleNamespace(entries={label: conftest.Entry(label, 0.1, 0.0) for label in seconds})
    for _ in range(conftest.LAPS):
        for label in seconds:
            with contextlib.suppress(pytest.skip.Exception):
                conftest.Contest.later_calls(started, label, SimpleNamespace())
    assert Counter(calls) == {"pointloom": 3, "best": 3, "second": 3, "slow": 1}
    assert started.entries["best"].estimate == pytest.approx(0.02)
