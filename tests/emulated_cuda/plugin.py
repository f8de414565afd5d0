"""pytest --emulated-cuda: the tests on the emulated device. tests/conftest.py takes it in."""

import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ..smallest_set import LeftOut, Recorder
from . import quick_set
from .gcc import EmulationError
from .install import Device, install, installed
from .kernel_coverage import BYTES_OF_MARK, TRUE
from .settings import PREFIX, settings

OPTION, QUICK, STRICT = "--emulated-cuda", "--emulated-cuda-quick", "--emulated-cuda-strict"
FOLDER = quick_set.FOLDER
# Processes of pytest -n have no options when their conftest.py is imported; the first process passes them on.
WORKER, REQUESTED = "PYTEST_XDIST_WORKER", "EMULATED_CUDA_ASKED"


def add_options(parser: pytest.Parser) -> None:
    group = parser.getgroup("emulated CUDA", "an emulated CUDA device: tests/emulated_cuda/README.md")
    group.addoption(OPTION, action="store_true", help="run on an emulated cuda:0, without the runs of CPU compilers")
    group.addoption(QUICK, action="store_true", help="of these, the set that CI runs: all but those of quick_set.txt")
    group.addoption(STRICT, action="store_true", help="fail a test that makes a new note, such as an unwritten read")


def is_requested(config: pytest.Config) -> bool:
    """Whether this run is one on the emulated device; known before options are parsed."""
    if WORKER in os.environ:
        return REQUESTED in os.environ
    return bool({OPTION, QUICK} & set(config.invocation_params.args))


def install_if_requested(config: pytest.Config) -> None:
    """Install the device, before another conftest.py is imported and starts Warp."""
    if is_requested(config):
        os.environ[REQUESTED] = "yes"
        try:
            install()
        except EmulationError as error:
            raise pytest.UsageError(str(error)) from None
        config.pluginmanager.register(EmulatedCudaPlugin())
        if settings.contexts and WORKER in os.environ:
            settings.coverage = settings.coverage.replace("%p", str(os.getpid()))
            os.environ[PREFIX + "COVERAGE"] = settings.coverage  # processes that tests start set marks in the same file
            del os.environ[PREFIX + "CONTEXTS"]
            config.pluginmanager.register(KernelContexts(Path(settings.contexts)))


class EmulatedCudaPlugin:
    """Installs the device, chooses the tests, fails those with faults and lists what was found."""

    def __init__(self) -> None:
        self.known_faults, self.known_notes = 0, set()
        self.strict, self.left_out = False, ()
        self.summaries: dict[str, list[str]] = {}  # of the processes of pytest -n

    def pytest_configure(self, config: pytest.Config) -> None:
        self.strict = config.getoption(STRICT)
        self.left_out = LeftOut(quick_set.FILE) if config.getoption(QUICK) else ()

    def pytest_sessionstart(self) -> None:
        if settings.apart:
            from pointloom.kernels.language import device_arrays

            device_arrays.blocks = ()

    @pytest.hookimpl(trylast=True)
    def pytest_collection_modifyitems(self, config: pytest.Config, items: list[pytest.Item]) -> None:
        chosen = [item for item in items if self._is_chosen(item)]
        config.hook.pytest_deselected(items=[item for item in items if item not in set(chosen)])
        items[:] = chosen
        for item in items:
            mark = item.get_closest_marker("slow_on_emulated_cuda")
            if mark:
                item.add_marker(pytest.mark.skip(reason=f"slow on the emulated device: {mark.args[0]}"))

    def _is_chosen(self, item: pytest.Item) -> bool:
        parameters = item.callspec.params if hasattr(item, "callspec") else {}
        if str(parameters.get("device", "")).startswith("cpu"):
            return False
        return item.nodeid not in self.left_out

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_call(self, item: pytest.Item) -> Iterator[None]:
        passed = False
        try:
            yield
            passed = True
        finally:
            self._look(item, passed)

    def _look(self, item: pytest.Item, passed: bool) -> None:
        """What is new since the test before, the fixtures of this one included."""
        device = installed()
        if device is None:
            return
        device.synchronize()
        faults, notes = device.findings.faults[self.known_faults :], device.findings.notes
        new = [f"{' '.join(key)}: {note.first}" for key, note in notes.items() if key not in self.known_notes]
        self.known_faults, self.known_notes = len(device.findings.faults), set(notes)
        if faults and not passed:
            item.add_report_section("call", "emulated CUDA", "\n".join(faults))
        elif faults:
            pytest.fail(f"passed over {len(faults)} faults of the emulated device:\n" + "\n".join(faults))
        elif passed and new and self.strict and not item.nodeid.startswith(FOLDER):
            pytest.fail("new notes of the emulated device:\n" + "\n".join(new))

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        device = installed()
        if device is not None and hasattr(session.config, "workeroutput"):
            session.config.workeroutput[FOLDER] = summary(device)

    @pytest.hookimpl(optionalhook=True)
    def pytest_testnodedown(self, node: Any) -> None:
        self.summaries[node.gateway.id] = getattr(node, "workeroutput", {}).get(FOLDER, [])

    def pytest_terminal_summary(self, terminalreporter: pytest.TerminalReporter) -> None:
        device = installed()
        if device is None:
            return
        for process, lines in sorted((self.summaries or {"": summary(device)}).items()):
            terminalreporter.section(f"emulated CUDA {process}".strip())
            for line in lines:
                terminalreporter.write_line(line)


class KernelContexts(Recorder):
    """Records the marks of kernels that each test sets: quick_set.py."""

    def _outcomes(self) -> np.ndarray | None:
        """The bytes `false` and `true` of each mark; None before Warp starts."""
        device = installed()
        if device is None:
            return None
        device.synchronize()
        return np.frombuffer(device.launches.marks.bytes, np.uint8).reshape(-1, BYTES_OF_MARK)[:, : TRUE + 1]

    def begin(self, node: str) -> None:
        outcomes = self._outcomes()
        if outcomes is not None:
            outcomes[:] = 0

    def end(self) -> Iterable[int]:
        outcomes = self._outcomes()
        return [] if outcomes is None else np.flatnonzero(outcomes).tolist()


def summary(device: Device) -> list[str]:
    findings = device.findings
    counts = ", ".join(f"{count:,} {name}" for name, count in findings.counts.items())
    seconds = ", ".join(f"{name} {spent:.0f} s" for name, spent in findings.seconds.items())
    lines = [f"order {int(settings.order)}, seed {settings.seed}: {counts}; {seconds}"]
    lines += [f"FAULT {text[:400]}" for text in sorted(set(findings.faults))]
    for (kernel, kind), note in sorted(findings.notes.items()):
        lines.append(f"NOTE {kernel}: {kind}, {note.count:,} in {note.launches:,} launches: {note.first[:300]}")
    return lines
