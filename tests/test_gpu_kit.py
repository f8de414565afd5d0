"""The kit of the first half-hour on a GPU: the plan and its limits, going on, packing, and no figure is made up."""

from __future__ import annotations

import importlib
import json
import os
import re
import struct
import subprocess
import sys
from dataclasses import replace

import pytest

from .programs import BENCHMARKS, benchmarks_on_path

with benchmarks_on_path():
    import pages
    from gpu_kit import compare, documents, fatbins, layout, measure, page, peers, records, steps, under_tools
    from gpu_kit.device import Device, EmulatedDeviceError
    from gpu_kit.gpu_only import FAILURES
    from gpu_kit.runner import MARGIN, MORE, Run
    from gpu_kit.steps import Call, Step

GPU = Device("NVIDIA H100 80GB HBM3", 90, 132, 79.1, "13.0", "13.4")
EMULATED = replace(GPU, name="Emulated CUDA device")


def test_nothing_of_the_emulated_device_becomes_a_document(tmp_path):
    documents.keep_part(tmp_path / "run", GPU, "constants", {"GRAPH_NODE": 2e-6})
    documents.keep_part(tmp_path / "run", EMULATED, "operations", {"tree 5": {"caller_ms": 2.0}})
    with pytest.raises(EmulatedDeviceError, match="Emulated CUDA device:"):
        documents.keep(tmp_path / "run", tmp_path / "results")
    assert not (tmp_path / "results").exists()
    documents.keep_part(tmp_path / "run", replace(GPU, name=""), "operations", {})
    with pytest.raises(EmulatedDeviceError, match="without a name"):
        documents.keep(tmp_path / "run", tmp_path / "results")


def test_parts_of_two_devices_are_no_document(tmp_path):
    documents.keep_part(tmp_path, GPU, "constants", {})
    documents.keep_part(tmp_path, replace(GPU, name="NVIDIA H200"), "operations", {})
    with pytest.raises(ValueError, match="different device"):
        documents.collected(tmp_path)


@pytest.fixture
def scripted(tmp_path, monkeypatch):
    """A function (name, lines of Python, ...): a step that runs them; its first arguments are in `sys.argv`."""

    def make(name: str, code: str, **values: object) -> Step:
        path = tmp_path / f"{name}.py"
        path.write_text(f"import pathlib, sys, time\nstate = pathlib.Path(sys.argv[1])\n{code}\n")
        step = Step(name, name, **{"seconds": 5, "gives": "", "needs": (), **values})
        command = lambda self, state, seconds: [  # noqa: E731
            sys.executable, str(tmp_path / f"{self.module}.py"), str(state), str(seconds)
        ]  # fmt: skip
        monkeypatch.setattr(Step, "command", command)
        return step

    return make


def test_a_step_that_has_more_to_do_is_begun_again(scripted, tmp_path):
    step = scripted(
        "more", f"again = state / 'again'\nexists = again.exists()\nagain.touch()\nsys.exit(0 if exists else {MORE})"
    )
    run = Run(tmp_path / "run", 100, dry=False)
    assert run.all([step]) == [] and run.status(step) == ""
    assert run.all([step]) == [] and run.status(step) == "done"


def test_the_seconds_of_each_step_are_recorded(scripted, tmp_path):
    run = Run(tmp_path / "run", 100, dry=False)
    run.all([scripted("good", "time.sleep(0.1)"), scripted("bad", "sys.exit(3)")])
    recorded = records.recorded(tmp_path / "run", "steps")
    assert [recorded[name]["ended"] for name in ("good", "bad")] == ["done", "FAILED, exit 3"]
    assert recorded["good"]["seconds"] > 0.1


def test_a_step_gets_the_seconds_that_later_steps_do_not_need(scripted, tmp_path):
    write = "(state / sys.argv[0].rpartition('/')[2]).write_text(sys.argv[2])"
    run = Run(tmp_path / "run", 100, dry=False)
    assert run.all([scripted("first", write, seconds=10), scripted("last", write, seconds=30)]) == []
    first, last = (float((tmp_path / "run" / f"{name}.py").read_text()) for name in ("first", "last"))
    assert 100 - MARGIN - 30 - 5 < first <= 100 - MARGIN - 30
    assert 30 <= last <= 100 - MARGIN


@pytest.mark.parametrize("count", [2, 3, 4, 5])
@pytest.mark.parametrize("run", steps.RUNS)
def test_the_plan_keeps_the_limits_of_the_device(run, count):
    calls = steps.calls_of(run, count)
    assert [step for call in calls for step in call.steps] == steps.steps_of(run)
    assert max(call.seconds for call in calls) <= 600
    assert steps.total_seconds(calls) <= 900


def test_a_plan_beyond_the_limits_is_an_error(monkeypatch):
    monkeypatch.setattr(steps, "STEPS", (Step("long", "long", 590, ""),))
    with pytest.raises(ValueError, match="run 1: expected calls of at most 600 s"):
        steps.calls_of(1, 2)


def test_every_step_has_a_module_and_measures_times_before_a_profile():
    with benchmarks_on_path():
        for step in steps.STEPS:
            importlib.import_module(f"gpu_kit.{step.module}")
    names = [step.name for step in steps.STEPS]
    assert names.index("times") < names.index("profile") < names.index("ncu") < names.index("tests")


def test_every_named_call_is_an_operation():
    with benchmarks_on_path():
        from gpu_operations import OPERATIONS
    calls = [
        *under_tools.NCU_CALLS,
        *under_tools.SANITIZED,
        *(call for change in compare.CHANGES for call in change.calls),
    ]
    assert {call.partition("=")[0] for call in calls} <= set(OPERATIONS)


def test_ncu_runs_the_calls_with_the_longest_launches(tmp_path):
    rows = {
        "many 5": [{"kernel": "step_kernel", "us": 900.0, "launches": 300}],
        "one 5": [
            {"kernel": "search_kernel", "us": 500.0, "launches": 1},
            {"kernel": "cub::x", "us": 1e6, "launches": 1},
        ],
        "one 9": [{"kernel": "search_kernel", "us": 800.0, "launches": 1}],
    }
    documents.keep_part(tmp_path, GPU, "operations", {key: {"kernels": each} for key, each in rows.items()})
    kernels, calls = under_tools.hottest(tmp_path)
    assert kernels == ("search_kernel", "step_kernel") and calls == ("one=9", "many=5")


def test_no_time_follows_a_profile_in_one_process(monkeypatch):
    monkeypatch.setattr(measure.Profiler, "attached", True)
    with pytest.raises(RuntimeError, match="times after a profile in one process"):
        measure.times_of("tree", 100)


def test_the_tables_of_the_readme_are_those_of_the_plan():
    readme = BENCHMARKS / "gpu_kit" / "README.md"
    for run in steps.RUNS:
        assert pages.text_between(readme, f"run {run}") == steps.plan_table(run)
    assert pages.text_between(readme, "dry") == steps.dry_table()


def test_the_page_has_a_row_for_each_result():
    sides = {"former": {"tree 100": {"best_ms": 3.0}}, "present": {"tree 100": {"best_ms": 1.5}}}
    frames = {"frames": 95, "median_ms": 2.0, "p99_ms": 4.0, "max_ms": 5.0, "first_ms": 90.0}
    run = {
        "peers": {
            "knn 1000 beside CuPy": {"best_ms": {"pointloom": 2.0, "CuPy": 3.0}},
            "knn 9 beside torch": {"skipped": "no torch"},
        },
        "frames": {"SLAM": frames, "TSDF": {"error": "lost"}},
        "large": {"tree 10000000": {"best_ms": 20.0, "peak bytes per point": 44.0}},
        "comparisons": {"warps": {"before": "1234567^", "laps": [{"kind": "call", **sides}]}},
    }
    expected = {
        "libraries": "| knn | 1,000 | CuPy | 2.00 | 3.00 | 1.50 |",
        "sequences": "| SLAM | 95 | 2.00 | 4.00 | 5.00 | 90.00 |",
        "large": "| tree | 10,000,000 | 20.0 | 44.0 |",
        "changes": "| warps | tree | 100 | 3.00 | 1.50 | 2.00 | - | - | - |",
    }
    for name, row in expected.items():
        assert page.TABLES[name]([run])[2:] == [row]
        assert page.TABLES[name]([]) == ["Not measured yet."]


FAILING = """
import os, pytest

@pytest.mark.parametrize("device", ["cuda:0"])
def test_fails(device):
    assert device == "cpu", "the wrong device"

@pytest.mark.parametrize("device", ["cuda:0"])
def test_is_ended(device):
    os._exit(1)
"""


@pytest.mark.slow
def test_failures_are_written_before_a_run_of_tests_ends(tmp_path):
    (tmp_path / "test_two.py").write_text(FAILING)
    inherited = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    environment = {**inherited, FAILURES: str(tmp_path / "failures.jsonl"), "PYTHONPATH": str(BENCHMARKS)}
    command = [sys.executable, "-m", "pytest", "-q", "-p", "gpu_kit.gpu_only", "-c", os.devnull, "test_two.py"]
    subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, check=False)
    (failure,) = [json.loads(line) for line in (tmp_path / "failures.jsonl").read_text().splitlines()]
    assert failure["test"] == "test_two.py::test_fails[cuda:0]" and "the wrong device" in failure["text"]


def test_the_newest_measurement_of_a_row_counts_if_it_has_the_field(tmp_path, monkeypatch):
    monkeypatch.setattr(documents, "RESULTS", tmp_path)
    for day, rows in ((1, {"a": {"best_ms": 1.0}, "b": {}}), (2, {"a": {"device_ms": 1.0}, "b": {"error": "no"}})):
        about = {"date": f"2026-01-0{day}", "commit": f"{day}" * 12, "device": {"name": "NVIDIA H100 80GB"}}
        (tmp_path / f"gpu-run-x-{day}.json").write_text(json.dumps({**about, "operations": rows}))
    assert documents.last_measured("operations", chip="h100", field="best_ms") == {"a": ("2026-01-01", "1111111")}
    every = {"a": ("2026-01-02", "2222222"), "b": ("2026-01-01", "1111111")}
    assert documents.last_measured("operations", chip="h100") == every
    assert documents.last_measured("operations", chip="h200") == {}, "of another chip"


def test_each_chip_has_tables_of_its_own():
    def run(chip, day, best):
        about = {"device": {"name": f"NVIDIA {chip}"}, "date": f"2026-01-0{day}", "commit": "a" * 12}
        return {**about, "operations": {f"tree {1000 * day}": {"best_ms": best}}}

    lines = page.by_chip(page.operations, [run("H100", 1, 1.5), run("H200", 2, 2.5), run("H100", 3, 3.5)])
    at = {name: lines.index(f"**NVIDIA {name}**") for name in ("H100", "H200")}
    assert at["H100"] == 0 < at["H200"], "the chip with the newest run is the first"
    times = [[cell for line in part for cell in ("1.50", "2.50", "3.50") if cell in line]
             for part in (lines[: at["H200"]], lines[at["H200"] :])]  # fmt: skip
    assert times == [["1.50", "3.50"], ["2.50"]]


def test_the_first_page_counts_the_rows_that_are_ahead_of_open3d():
    rows = [
        {"size": size, "peer": peer, "best_ms": best}
        for size, peer, best in (
            ("1k", "pointloom", 1.0), ("1k", "open3d-tensor", 2.0), ("2k", "pointloom", 2.0),
            ("2k", "open3d-tensor", 1.0), ("3k", "pointloom", 1.0),
        )
    ]  # fmt: skip
    about = {"device": {"name": "Chip"}, "date": "2026-01-02T03:04", "commit": "abcdef123456"}
    sentence = page.summary([{**about, "benchmarks": {"operations": {"fpfh": rows}}}])
    assert "On one Chip, pointloom is ahead of Open3D's CUDA code in 1 of 2 rows" in sentence
    assert "2026-01-02, commit abcdef12" in sentence


def test_a_peer_with_another_result_is_not_timed():
    def disagree(own, other):
        assert own == other, "1 and 2"

    peer = peers.Peer("other", "sum", 5, 5, lambda size, device: peers.Pair(lambda: 1, lambda: 2, disagree))
    result = peers.measured(peer, 5, "cpu")
    assert list(result) == ["error"] and result["error"].startswith("AssertionError: 1 and 2")


def test_a_peer_that_is_not_installed_is_skipped():
    def prepare(size, device):
        raise ModuleNotFoundError("No module named 'cupy'")

    assert peers.measured(peers.Peer("CuPy", "sum", 5, 5, prepare), 5, "cpu") == {"skipped": "No module named 'cupy'"}


def test_a_comparison_of_the_wrong_code_is_an_error(tmp_path, monkeypatch):
    output = json.dumps({"package": "/elsewhere/pointloom", "results": {}})
    done = subprocess.CompletedProcess([], 0, stdout=output, stderr="")
    monkeypatch.setattr(subprocess, "run", lambda *given, **options: done)
    with pytest.raises(RuntimeError, match="got that of /elsewhere/pointloom"):
        compare.times_with(tmp_path, "call", ("tree=100",), 10)


def test_an_operation_that_the_former_code_cannot_run_is_an_error(tmp_path, monkeypatch):
    results = {"tree 100": {"error": "AttributeError: no rgbd"}, "knn 100": {"seconds of call": 1.0}}
    output = json.dumps({"package": str(tmp_path / "pointloom"), "results": results})
    done = subprocess.CompletedProcess([], 0, stdout=output, stderr="")
    monkeypatch.setattr(subprocess, "run", lambda *given, **options: done)
    with pytest.raises(RuntimeError, match="tree 100: AttributeError: no rgbd"):
        compare.times_with(tmp_path, "call", ("tree=100", "knn=100"), 10)


def fatbin(*entries: tuple[int, int, bytes]) -> bytes:
    """A fatbin of entries (kind, architecture, payload)."""
    body = b""
    for kind, architecture, payload in entries:
        header = struct.pack("<HHIQ", kind, 0x101, 64, len(payload)).ljust(28, b"\0")
        body += (header + struct.pack("<I", architecture)).ljust(64, b"\0") + payload
    return struct.pack("<IHHQ", 0xBA55ED50, 1, 16, len(body)) + body


def test_code_for_one_architecture_is_stored_in_a_library(tmp_path):
    library = tmp_path / "library.so"
    content = [(2, 80, b"a" * 24), (2, 90, b"b" * 40), (1, 90, b"c" * 16)]
    library.write_bytes(b"head" + fatbin(*content) + b"between" + fatbin((2, 75, b"d" * 8)))
    assert fatbins.keep_architecture(library, 90) == 24 + 16 + 8
    data = library.read_bytes()
    assert b"b" * 40 in data and not any(letter * 8 in data for letter in (b"a", b"c", b"d"))
    assert [entry[1:] for entry in fatbins.entries(data)] == [(24, 2, 80), (40, 2, 90), (16, 1, 90), (8, 2, 75)]


def test_pieces_are_cut_into_calls_and_put_together_again(tmp_path):
    random = os.urandom(5 << 20)
    first, second = tmp_path / "warp.tar.xz", tmp_path / "open3d.tar.xz"
    first.write_bytes(random[: 3 << 20])
    second.write_bytes(random[3 << 20 :])
    pieces = [layout.Piece("warp", first), layout.Piece("wheels", None), layout.Piece("open3d", second)]
    planned = [Call(1, 10, (steps.STEPS[0],)), Call(2, 20, ()), Call(3, 30, steps.STEPS[1:3])]
    report = layout.lay_out(tmp_path / "out", pieces, planned, 2, (2 << 20) + layout.SPARE)
    plans = [(tmp_path / "out" / str(call.number) / "plan.txt").read_text() for call in planned]
    assert plans == ["10 2 facts\n", "20 2\n", "30 2 torch questions\n"]
    assert "wheels: not built, skipped" in report and "warp: 3.0 MiB, complete with call 2" in report
    for name, expected in (("warp", random[: 3 << 20]), ("open3d", random[3 << 20 :])):
        parts = sorted((tmp_path / "out").glob(f"*/{name}.*.part*"), key=lambda path: path.name)
        assert b"".join(path.read_bytes() for path in parts) == expected
    for folder in (tmp_path / "out").iterdir():
        assert sum(path.stat().st_size for path in folder.glob("*.part*")) <= 2 << 20


def test_each_file_with_cuda_variants_is_on_the_page_of_gpus():
    """Until a GPU has measured a variant, the page states which operation will."""
    kernels, page = BENCHMARKS.parent / "src/pointloom/kernels", (BENCHMARKS.parent / "docs/gpu.md").read_text("utf-8")
    files = [path for path in kernels.rglob("*.py") if re.search(r"^@\w+\.on_cuda$", path.read_text("utf-8"), re.M)]
    missing = [name for name in (path.relative_to(kernels).as_posix() for path in files) if name not in page]
    assert len(files) > 20 and not missing, f"add {missing} to docs/gpu.md, CUDA variants without a measured figure"
