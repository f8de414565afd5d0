"""The kit of the first half-hour on a GPU: order and time limits, going on, packing, and that no figure is made up."""

from __future__ import annotations

import os
import struct
import sys
from dataclasses import replace

import pytest

from .programs import benchmarks_on_path

with benchmarks_on_path():
    from gpu_kit import documents, fatbins, layout
    from gpu_kit.device import Device, EmulatedDeviceError
    from gpu_kit.runner import MORE, Run
    from gpu_kit.steps import Step

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
        step = Step(name, name, 0.0, 60.0, **{"needs": (), **values})
        command = lambda self, state, seconds: [sys.executable, str(tmp_path / f"{self.module}.py"), str(state)]  # noqa: E731
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
    report = layout.lay_out(tmp_path / "out", pieces, 3, (2 << 20) + layout.SPARE)
    assert "wheels: not built, skipped" in report and "warp: 3.0 MiB, complete with call 2" in report
    for name, expected in (("warp", random[: 3 << 20]), ("open3d", random[3 << 20 :])):
        parts = sorted((tmp_path / "out").glob(f"*/{name}.*.part*"), key=lambda path: path.name)
        assert b"".join(path.read_bytes() for path in parts) == expected
    for folder in (tmp_path / "out").iterdir():
        assert sum(path.stat().st_size for path in folder.glob("*.part*")) <= 2 << 20
