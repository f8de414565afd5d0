"""Every operation of the digests gives the same bits on every processor, as docs/determinism.md promises.

A processor is imitated by what depends on it: the kernels of OpenBLAS, the vector instructions of NumPy's loops, the
variants of functions in the C library, and the level of x86-64 that CPU kernels are compiled for.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).parents[1]
UFUNCS = (getattr(np, "_core", None) or np.core)._multiarray_umath  # np.core in NumPy 1
FEATURES: dict[str, bool] = UFUNCS.__cpu_features__
DISPATCHED: list[str] = UFUNCS.__cpu_dispatch__  # beyond NumPy's baseline
# The instructions that a level of x86-64 has in NumPy's words, whichever of them this NumPy uses.
V3 = {"AVX", "F16C", "FMA3", "AVX2", "X86_V3"}
V4 = V3 | {"AVX512F", "AVX512CD", "AVX512_SKX", "X86_V4"}
NO_AVX512 = "glibc.cpu.hwcaps=-AVX512F,-AVX512VL,-AVX512BW,-AVX512DQ,-AVX512CD"


@dataclass(frozen=True)
class Processor:
    """The settings of a process, and its expected report.

    Attributes:
        blas: OPENBLAS_CORETYPE, and the kernels that the OpenBLAS of NumPy's and SciPy's wheels has for it.
        numpy: The dispatched instructions that NumPy may use.
        target: Of CPU kernels.
        needs: What the processor that runs the test must have for it.
    """

    blas: tuple[str, str]
    numpy: frozenset[str]
    target: str
    needs: str | None = None
    environment: dict[str, str] = field(default_factory=dict)


PROCESSORS = {
    "Nehalem": Processor(("Nehalem", "Nehalem"), frozenset(), "x86-64-v2"),
    "Sandybridge": Processor(("Sandybridge", "Sandybridge"), frozenset({"AVX"}), "x86-64-v2", "AVX"),
    "Haswell": Processor(("Haswell", "Haswell"), frozenset(V3), "x86-64-v3", "AVX2", {"GLIBC_TUNABLES": NO_AVX512}),
    "Zen": Processor(("Zen", "Haswell"), frozenset(V3), "x86-64-v3", "AVX2", {"GLIBC_TUNABLES": NO_AVX512}),
    "SkylakeX": Processor(("SkylakeX", "SkylakeX"), frozenset(V4), "x86-64-v4", "AVX512_SKX"),
}


def run_digests(*arguments: str, **environment: str) -> tuple[dict, dict[str, str]]:
    """What a new process reports of itself, and the digests by operation."""
    command = [sys.executable, "-m", "tests.small_digests", *arguments]
    inherited = {name: value for name, value in os.environ.items() if not name.startswith("POINTLOOM_")}
    variables = inherited | environment
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True, env=variables)
    first, *lines = done.stdout.splitlines()
    return json.loads(first), {name: digest for digest, name in (line.split(" ", 1) for line in lines)}


@cache
def digests_here() -> dict[str, str]:
    return run_digests()[1]


def differing(digests: dict[str, str]) -> list[str]:
    """The operations whose digests are not those of this processor."""
    assert digests.keys() == digests_here().keys()
    return [name for name, digest in digests.items() if digest != digests_here()[name]]


def has_level(needs: str | None) -> bool:
    same = {"AVX512_SKX": "X86_V4", "AVX2": "X86_V3"}  # the names of NumPy 2.4
    return needs is None or FEATURES.get(needs, False) or FEATURES.get(same.get(needs, needs), False)


@pytest.mark.nightly
@pytest.mark.parametrize("name", PROCESSORS)
def test_every_operation_is_bitwise_identical_on_a_processor_like(name):
    processor = PROCESSORS[name]
    if not has_level(processor.needs):
        pytest.skip(f"this processor has no {processor.needs}")
    disabled = " ".join(one for one in DISPATCHED if one not in processor.numpy)
    environment = {"OPENBLAS_CORETYPE": processor.blas[0], "NPY_DISABLE_CPU_FEATURES": disabled}
    report, digests = run_digests("--cpu-target", processor.target, **environment, **processor.environment)
    if not report["blas"]:
        pytest.skip("NumPy and SciPy here use another BLAS than OpenBLAS")
    assert set(report["blas"]) == {processor.blas[1]}
    assert not set(report["numpy"]) & set(disabled.split())
    assert f"-target-cpu {processor.target}" in report["flags"] and report["pool"]
    assert differing(digests) == []


@pytest.mark.nightly
@pytest.mark.parametrize("threads", [1, 2])
def test_every_operation_is_bitwise_identical_with_any_number_of_threads(threads):
    counts = {"POINTLOOM_CPU_THREADS": str(threads), "OPENBLAS_NUM_THREADS": str(3 - threads)}
    assert differing(run_digests(**counts)[1]) == []


@pytest.mark.nightly
def test_no_operation_of_the_digests_fails():
    errors = [name for name, digest in digests_here().items() if digest.startswith("error-")]
    assert errors == []
