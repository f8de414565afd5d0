"""benchmarks/gpu_host_time.py: what it takes away is the emulated device's, and what it counts is the call's."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
TOOL = ROOT / "benchmarks" / "gpu_host_time.py"


def run(*arguments: str) -> str:
    environment = os.environ | {"PYTHONPATH": str(ROOT / "src")}
    command = [sys.executable, str(TOOL), *arguments]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr[-3000:]
    return done.stdout


@pytest.mark.slow
def test_the_table_and_the_file_list_times_and_counts_of_calls(emulated, tmp_path):
    file = tmp_path / "times.json"
    table = run("normals", "--rounds", "2", "--save", str(file))
    (row,) = json.loads(file.read_text())
    assert row["operation"] == "normals k30" and table.splitlines()[1].startswith("normals k30")
    assert row["launches"] == 2 and row["waits"] == 0 and row["host_ms"] > 0
    assert row["native calls"] == row["launches"] + 2 * row["allocations"]
    assert "x " in run("normals", "--rounds", "2", "--against", str(file)).splitlines()[1]


@pytest.mark.slow
def test_the_profile_has_no_time_of_the_emulated_device(emulated):
    lines = run("normals", "--profile").splitlines()
    total = float(lines[0].split()[2])
    emulator = [line.split() for line in lines if "emulated_cuda" in line]
    assert 0 < total < 20 and sum(float(own) for own, *_ in emulator) < 0.05 * total
