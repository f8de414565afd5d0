"""pytest --emulated-cuda: which tests run, and which of them fail for what the device saw."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

CONFTEST = f"""
import sys

import pytest

sys.path.insert(0, {str(Path(__file__).parents[2])!r})
from tests.emulated_cuda import plugin

def pytest_addoption(parser, pluginmanager):
    plugin.add_options(parser)
    plugin.install_if_requested(pluginmanager.get_plugin("pytestconfig"))

def pytest_configure(config):
    config.addinivalue_line("markers", "slow_on_emulated_cuda(reason)")

@pytest.fixture(params=["cpu-warp", "cuda:0"])
def device(request):
    return request.param
"""
TESTS = """
import numpy as np
import pytest
import warp as wp

@wp.kernel(enable_backward=False)
def past_the_end_kernel(a: wp.array(dtype=int)):
    i = wp.tid()
    a[i + 1] = i

@wp.kernel(enable_backward=False)
def copy_kernel(a: wp.array(dtype=int), out: wp.array(dtype=int)):
    i = wp.tid()
    out[i] = a[i]

def test_swallows_a_fault(device):
    try:
        wp.launch(past_the_end_kernel, 4, [wp.zeros(4, dtype=int, device=device)], device=device)
        wp.synchronize()
    except RuntimeError:
        pass

def test_never_waits_for_a_fault(device):
    wp.launch(past_the_end_kernel, 4, [wp.zeros(4, dtype=int, device=device)], device=device)

def test_reads_what_nobody_wrote(device):
    a, out = (wp.empty(4, dtype=int, device=device) for _ in range(2))
    wp.launch(copy_kernel, 4, [a, out], device=device)

@pytest.mark.slow_on_emulated_cuda("a thousand blocks")
def test_takes_minutes(device):
    raise AssertionError

def test_is_right(device):
    assert wp.zeros(4, dtype=int, device=device).numpy().sum() == 0

def test_takes_no_device():
    pass
"""


@pytest.fixture
def run(tmp_path):
    (tmp_path / "conftest.py").write_text(CONFTEST)
    (tmp_path / "test_some.py").write_text(TESTS)

    def start(*options: str) -> str:
        command = [sys.executable, "-m", "pytest", "-q", "-rA", "-p", "no:cacheprovider", "-p", "no:dash", *options]
        environment = os.environ | {"EMULATED_CUDA_ORDER": "0"}
        return subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, env=environment).stdout

    return start


def outcome(output: str, test: str) -> str:
    lines = [line for line in output.splitlines() if test in line and line.startswith(("PASSED", "FAILED"))]
    return lines[0].split()[0] if lines else "not run"


@pytest.mark.parametrize("strict", [False, True])
def test_faults_fail_their_test_and_notes_only_where_they_shall(run, strict):
    expected = {
        "swallows_a_fault": "FAILED",
        "never_waits_for_a_fault": "FAILED",
        "reads_what_nobody_wrote": "FAILED" if strict else "PASSED",
        "is_right": "PASSED",
        "takes_no_device": "PASSED",
    }
    output = run("--emulated-cuda", *(["--emulated-cuda-strict"] if strict else []))
    outcomes = {name: outcome(output, f"test_{name}") for name in expected}
    assert outcomes == expected, output
    assert "slow on the emulated device: a thousand blocks" in output
    assert "NOTE copy_kernel: read of bytes that nobody wrote, 4 in 1 launches: a[byte 0], thread 0" in output
    assert "FAULT past_the_end_kernel: address outside any live array" in output
    assert "cpu-" not in output
