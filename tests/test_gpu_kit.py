"""The kit of the first half-hour on a GPU: order and time limits, going on, packing, and that no figure is made up."""

from __future__ import annotations

import json
import os
import struct
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
BENCHMARKS = str(ROOT / "benchmarks")
sys.path.append(BENCHMARKS)
from gpu_kit import documents, fatbins, layout, profile, register_trials, suite, under_tools  # noqa: E402
from gpu_kit.device import Device, EmulatedDeviceError, chip_of  # noqa: E402
from gpu_kit.runner import MORE, Run  # noqa: E402
from gpu_kit.steps import STEPS, Step  # noqa: E402

sys.path.remove(BENCHMARKS)

GPU = Device("NVIDIA H100 80GB HBM3", 90, 132, 79.1, "13.0", "13.4")
EMULATED = replace(GPU, name="Emulated CUDA device")


# ------------------------------------------------------------------------------------------------ figures


@pytest.mark.parametrize(
    ("name", "chip"),
    [
        *[("NVIDIA H100 80GB HBM3", "h100"), ("NVIDIA H200", "h200"), ("NVIDIA A100-SXM4-40GB", "a100")],
        *[("NVIDIA GeForce RTX 4090", "rtx-4090"), ("NVIDIA GeForce RTX 4070 Ti SUPER", "rtx-4070-ti-super")],
        *[("NVIDIA RTX PRO 6000 Blackwell", "rtx-pro-6000"), ("Tesla T4", "t4"), ("NVIDIA L40S", "l40s")],
    ],
)
def test_a_chip_is_known_by_the_name_of_its_device(name, chip):
    assert chip_of(name) == chip


def test_a_run_on_a_gpu_becomes_one_document(tmp_path):
    documents.keep_part(tmp_path / "run", GPU, "operations", {"tree 5": {"caller_ms": 2.0}})
    documents.keep_part(tmp_path / "run", GPU, "constants", {"GRAPH_NODE": 2e-6})
    path = documents.keep(tmp_path / "run", tmp_path / "results")
    assert path.name.startswith("gpu-run-h100-")
    found = json.loads(path.read_text())
    assert found["operations"] == {"tree 5": {"caller_ms": 2.0}}
    assert found["constants"] == {"GRAPH_NODE": 2e-6}
    assert found["device"] == GPU.as_json()


def test_nothing_of_the_emulated_device_becomes_a_document(tmp_path):
    documents.keep_part(tmp_path / "run", GPU, "constants", {"GRAPH_NODE": 2e-6})
    documents.keep_part(tmp_path / "run", EMULATED, "operations", {"tree 5": {"caller_ms": 2.0}})
    with pytest.raises(EmulatedDeviceError, match="Emulated CUDA device"):
        documents.keep(tmp_path / "run", tmp_path / "results")
    assert not (tmp_path / "results").exists()
    documents.keep_part(tmp_path / "run", replace(GPU, name=""), "operations", {})
    with pytest.raises(EmulatedDeviceError, match="without a name"):
        documents.keep(tmp_path / "run", tmp_path / "results")


def test_the_emulated_device_has_the_name_that_is_refused():
    from .emulated_cuda.properties import Properties

    name = Properties._CONSTANT["wp_cuda_device_get_name"].decode()
    assert replace(GPU, name=name).is_emulated
    assert not GPU.is_emulated


def test_parts_of_two_devices_are_no_document(tmp_path):
    documents.keep_part(tmp_path, GPU, "constants", {})
    documents.keep_part(tmp_path, replace(GPU, name="NVIDIA H200"), "operations", {})
    with pytest.raises(ValueError, match="different device"):
        documents.collected(tmp_path)


def test_parts_of_two_states_of_the_kernels_are_no_document(tmp_path, monkeypatch):
    documents.keep_part(tmp_path, GPU, "constants", {})
    monkeypatch.setattr("pointloom.kernels.language.compiled_ahead.digest_of_sources", lambda: "other")
    documents.keep_part(tmp_path, GPU, "operations", {})
    with pytest.raises(ValueError, match="different sources of kernels"):
        documents.collected(tmp_path)


# ------------------------------------------------------------------------------------------------ steps


@pytest.fixture
def scripted(tmp_path, monkeypatch):
    """A function (name, lines of Python, ...): a step that runs them; its first arguments are in `sys.argv`."""

    def make(name: str, code: str, **values: object) -> Step:
        path = tmp_path / f"{name}.py"
        path.write_text(f"import pathlib, sys, time\nstate = pathlib.Path(sys.argv[1])\n{code}\n")
        step = Step(name, name, 0.0, 60.0, **{"needs": (), **values})
        command = lambda self, state, seconds: [sys.executable, str(tmp_path / f"{self.module}.py"), str(state)]  # noqa: E731
        monkeypatch.setattr(Step, "command", command)
        return step

    return make


def test_what_is_done_is_not_done_again_and_what_failed_is_left_alone(scripted, tmp_path):
    count = "file = state / 'count'\nfile.write_text(str(int(file.read_text() if file.exists() else 0) + 1))"
    steps = [scripted("good", count), scripted("bad", "sys.exit(3)")]
    for _ in range(2):
        run = Run(tmp_path / "run", 100, dry=False)
        failed = run.all(steps)
    assert (tmp_path / "run" / "count").read_text() == "1"
    assert failed == [] and run.status(steps[1]) == "failed"
    part = tmp_path / "run" / "parts" / "figures.json"
    part.write_text("{}")
    run.forget(replace(steps[0], part="figures"))
    run.all(steps)
    assert (tmp_path / "run" / "count").read_text() == "2" and not part.exists()


def test_a_step_that_has_more_to_do_is_begun_again(scripted, tmp_path):
    step = scripted(
        "more", f"again = state / 'again'\nexists = again.exists()\nagain.touch()\nsys.exit(0 if exists else {MORE})"
    )
    run = Run(tmp_path / "run", 100, dry=False)
    assert run.all([step]) == [] and run.status(step) == ""
    assert run.all([step]) == [] and run.status(step) == "done"


def test_a_step_that_takes_too_long_is_ended_and_its_words_are_kept(scripted, tmp_path, monkeypatch):
    monkeypatch.setattr("gpu_kit.runner.MARGIN", 0.5)
    step = replace(scripted("slow", "print('begun', flush=True)\ntime.sleep(60)"), at_most=0.5)
    run = Run(tmp_path / "run", 100, dry=False)
    assert run.one(step) == MORE
    assert (tmp_path / "run" / "logs" / "slow.txt").read_text() == "begun\n"


def test_why_a_step_waits_is_told(tmp_path):
    run = Run(tmp_path, 10, dry=True)
    step = Step("a", "a", 5, 60, ("warp", "open3d"))
    assert run.why_not(step, None) == "" and run.why_not(step, ["warp", "open3d"]) == ""
    assert run.why_not(step, ["warp"]) == "waits for open3d"
    assert run.why_not(replace(step, at_least=11.0), None) == "no time left, it wants 11 s"
    assert run.why_not(replace(step, program="no-such-program"), None) == "no no-such-program here"
    assert run.why_not(replace(step, in_dry_run=False), None) == "not in a dry run"


def test_every_step_is_a_module_of_the_kit():
    folder = Path(BENCHMARKS) / "gpu_kit"
    assert all((folder / f"{step.module}.py").exists() for step in STEPS)
    assert len({step.name for step in STEPS}) == len(STEPS)


def test_failures_for_want_of_a_package_are_counted_apart():
    text = "FAILED tests/a.py::b - assert 1\nERROR tests/c.py - ModuleNotFoundError: No module named 'open3d'\n"
    assert suite.failures(text) == (["tests/a.py::b"], 1)
    ran = suite.Ran(1, "....\n== 1 failed, 3 passed in 0.1s ==\n")
    assert suite.summary(ran) == "1 failed, 3 passed in 0.1s"


def test_kernels_of_a_trace_are_summed_by_their_names_in_the_sources():
    def event(name: str, us: float, kind: str = "kernel") -> dict:
        return {"cat": kind, "name": name, "dur": us, "args": {"registers per thread": 80}}

    name = "fit_normals_kernel_1a2b3c4d_cuda_kernel_forward"
    rows = profile.rows_of([event(name, 2.0), event(name, 3.0), event("Memset", 9.0, "gpu_memset"), {"cat": "cpu_op"}])
    assert [(row["kernel"], row["launches"], row["us"]) for row in rows] == [
        ("Memset", 1, 9.0),
        ("fit_normals_kernel", 2, 5.0),
    ]


def test_a_profiler_that_fails_leaves_the_callers_time(monkeypatch):
    def fail(_: object) -> None:
        raise RuntimeError("no CUPTI")

    monkeypatch.setattr(profile, "timed", lambda *_: ([0.002, 0.004, 0.003], None))
    monkeypatch.setattr(profile, "kernels_of", fail)
    assert profile.measured("tree", 5) == {"caller_ms": 3.0, "best_ms": 2.0, "profiler": "RuntimeError: no CUPTI"}


def test_trials_of_registers_name_kernels_that_are_there():
    sources = "\n".join(path.read_text() for path in (ROOT / "kernels").rglob("*.py"))
    names = {name for *_, kernels in register_trials.TRIALS for name in kernels}
    assert [name for name in names if f"def {name}(" not in sources] == []
    assert register_trials.setting(("a", "b"), 96) == "a=96,b=96" and register_trials.setting(("a",), -1) == ""
    assert register_trials.bound_of("sum_rows", {"sum_rows_tiles": 128}) == 128


def test_ncu_looks_at_what_took_longest(tmp_path):
    assert under_tools.hottest(tmp_path) == under_tools.KNOWN
    rows = [{"kernel": name, "us": us} for name, us in (("a_kernel", 1.0), ("b_kernel", 2.0), ("Memset", 9.0))]
    documents.keep_part(tmp_path, GPU, "operations", {"o 1": {"kernels": rows}, "o 2": {"error": "x"}})
    assert under_tools.hottest(tmp_path) == ("b_kernel", "a_kernel")


# ------------------------------------------------------------------------------------------------ packing


def fatbin(*entries: tuple[int, int, bytes]) -> bytes:
    """A fatbin of entries (kind, architecture, payload)."""
    body = b""
    for kind, architecture, payload in entries:
        header = struct.pack("<HHIQ", kind, 0x101, 64, len(payload)).ljust(28, b"\0")
        body += (header + struct.pack("<I", architecture)).ljust(64, b"\0") + payload
    return struct.pack("<IHHQ", 0xBA55ED50, 1, 16, len(body)) + body


def test_one_architectures_code_is_kept_in_a_library(tmp_path):
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
    said = layout.lay_out(tmp_path / "out", pieces, 3, (2 << 20) + layout.SPARE)
    assert "wheels: not made, left out" in said and "warp: 3.0 MiB, whole with call 2" in said
    for name, expected in (("warp", random[: 3 << 20]), ("open3d", random[3 << 20 :])):
        parts = sorted((tmp_path / "out").glob(f"*/{name}.*.part*"), key=lambda path: path.name)
        assert b"".join(path.read_bytes() for path in parts) == expected
    for folder in (tmp_path / "out").iterdir():
        assert sum(path.stat().st_size for path in folder.glob("*.part*")) <= 2 << 20


def test_what_does_not_fit_is_left_out_and_said(tmp_path):
    for name, size in (("warp", 1 << 20), ("open3d", 9 << 20)):
        (tmp_path / f"{name}.tar.xz").write_bytes(bytes(size))
    pieces = [layout.Piece(name, tmp_path / f"{name}.tar.xz") for name in ("warp", "open3d")]
    said = layout.lay_out(tmp_path / "out", pieces, 2, (3 << 20) + layout.SPARE)
    assert any(line.startswith("open3d: 4.0 MiB more than 2 calls carry") for line in said)
    assert not list((tmp_path / "out").glob("*/open3d*"))


@pytest.mark.slow
def test_calls_take_in_their_pieces_and_go_on(tmp_path):
    """call.sh with small archives: the second call completes a piece, the facts are found once."""
    stage = tmp_path / "stage"
    (stage / "package").mkdir(parents=True)
    (stage / "package" / "data.bin").write_bytes(os.urandom(3 << 20))
    archive = tmp_path / "warp.tar.xz"
    subprocess.run(["tar", "-I", "xz -1", "-cf", archive, "-C", stage, "."], check=True)
    layout.lay_out(tmp_path / "calls", [layout.Piece("warp", archive)], 2, (2 << 20) + layout.SPARE)
    home = tmp_path / "home"
    environment = {**os.environ, "POINTLOOM_GPU_HOME": str(home), "POINTLOOM_GPU_DRY": "1", "PYTHON": sys.executable}
    said = []
    for call in ("1", "2"):
        command = ["bash", "benchmarks/gpu_kit/call.sh", str(tmp_path / "calls" / call), "30"]
        done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=120)
        said.append(done.stdout + done.stderr)
    assert "== facts: done" in said[0] and "== questions: waits for warp, kernels" in said[0]
    assert "warp.tar.xz is here" in said[1] and "== facts: done before" in said[1]
    assert "== questions: waits for kernels" in said[1]
    assert (home / "site" / "package" / "data.bin").read_bytes() == (stage / "package" / "data.bin").read_bytes()
    assert {path.name for path in (home / "out").iterdir()} == {"gpu-run-1.tar.gz", "gpu-run-2.tar.gz"}
