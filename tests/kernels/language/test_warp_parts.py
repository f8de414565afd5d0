"""Warp's private parts: those in use exist, and without each of them results keep their bits."""

import ctypes
import os
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import warp as wp

from pointloom.kernels.language import warp_parts

SCRIPT = Path(__file__).with_name("hide_names.py")
CONTEXT, TYPES = "wp._src.context", "wp._src.types"
HIDDEN = {
    "cpu": {
        "import": "warp._src",
        "wp": "_src ModuleBuildOptions get_cpu_kernel_cache_key",
        CONTEXT: "CpuDefaultAllocator MemoryKind runtime",
        f"{CONTEXT}.runtime": "llvm",
        TYPES: "launch_bounds_t",
        f"{CONTEXT}.Module": "execs load get_module_identifier _get_compile_output_name _get_meta_name",
        f"{CONTEXT}.KernelHooks": "forward",
        f"{CONTEXT}.Launch": "hooks params",
        f"{CONTEXT}.Kernel": "adj get_mangled_name",
    },
    "cuda:0": {
        "import": "warp._src",
        "wp": "ModuleBuildOptions",
        CONTEXT: "MemoryKind _raise_cuda_launch_error",
        f"{CONTEXT}.runtime": "_apic_capture core tape",
        f"{CONTEXT}.runtime.core": "wp_cuda_launch_kernel wp_alloc_device_async",
        TYPES: "array_t",
        f"{CONTEXT}.Device": "_custom_allocator mempool_allocator",
        f"{CONTEXT}.Module": "execs",
        f"{CONTEXT}.KernelHooks": "forward_smem_bytes",
        f"{CONTEXT}.Launch": "cluster_dim module_exec",
        f"{CONTEXT}.Kernel": "adj",
    },
}
NAMES = [(o, name, where) for where, owners in HIDDEN.items() for o, names in owners.items() for name in names.split()]
# Only another version of Warp lacks a single name.
ROWS = [pytest.param(*row, marks=pytest.mark.nightly if row[0] != "import" else (), id=".".join(row)) for row in NAMES]


def run(owner: str, name: str, device: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """Digest small operations in a new process with empty caches and a name hidden from pointloom."""
    environment = os.environ | {"WARP_CACHE_PATH": str(folder), "POINTLOOM_CPU_KERNELS": ""}
    command = [sys.executable, str(SCRIPT), owner, name, device]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr[-2000:]
    return done


def digest(*arguments: Any) -> str:
    return run(*arguments).stdout.splitlines()[-1]


def test_this_warp_has_the_private_parts_that_are_used():
    missing = warp_parts.missing()
    assert missing == [], (
        f"warp-lang {wp.__version__} lacks, or has in another form: {', '.join(missing)}. Launches and arrays on a GPU "
        "go by wp.launch and wp.empty with it, ten times slower: read kernels/language/warp_parts.py beside its sources"
    )


def test_missing_parts_are_listed_and_not_used(monkeypatch):
    class array_t(ctypes.Structure):  # noqa: N801  Warp's name
        _fields_ = (("data", ctypes.c_uint64), ("shape", ctypes.c_int32 * 4))

    monkeypatch.setattr(warp_parts, "is_known", cache(warp_parts.is_known.__wrapped__))  # not called yet
    monkeypatch.setattr(warp_parts.types, "array_t", array_t)
    monkeypatch.setitem(warp_parts.FUNCTIONS, "wp_cuda_launch_kernel", 12)
    monkeypatch.setattr(warp_parts, "ARRAY", {*warp_parts.ARRAY, "_place"})
    missing = warp_parts.missing()
    assert missing[0].startswith("array_t") and "array._place" in missing and not warp_parts.is_known()


@pytest.fixture(scope="module")
def with_all_names(tmp_path_factory):
    return digest("", "", "cpu", tmp_path_factory.mktemp("cache"))


@pytest.mark.slow
@pytest.mark.parametrize(("owner", "name", "where"), ROWS)
def test_without_a_private_name_the_cpu_and_a_gpu_give_the_same_bits(owner, name, where, with_all_names, tmp_path):
    assert digest(owner, name, where, tmp_path) == with_all_names


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["refused", "wrong"])
def test_an_untested_warp_runs_without_the_cuda_header_if_it_fails_a_trial(kind, with_all_names, tmp_path):
    done = run("cuda_access.h", kind, "cuda:0", tmp_path)
    assert done.stdout.splitlines()[-1] == with_all_names and "RuntimeWarning: GPU kernels are slower" in done.stderr
