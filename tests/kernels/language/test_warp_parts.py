"""Warp's private parts: those in use exist, and without each of them results keep their bits."""

import ctypes
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import warp as wp

from pointloom.kernels.language import warp_parts

SCRIPT = Path(__file__).with_name("hide_names.py")
CONTEXT, TYPES = "wp._src.context", "wp._src.types"
ON_HOST = [
    ("import", "warp._src"),
    ("wp", "_src"),
    ("wp", "ModuleBuildOptions"),
    ("wp", "get_cpu_kernel_cache_key"),
    (CONTEXT, "CpuDefaultAllocator"),
    (CONTEXT, "MemoryKind"),
    (CONTEXT, "runtime"),
    (f"{CONTEXT}.runtime", "llvm"),
    (TYPES, "launch_bounds_t"),
    (f"{CONTEXT}.Module", "execs"),
    (f"{CONTEXT}.Module", "load"),
    (f"{CONTEXT}.Module", "get_module_identifier"),
    (f"{CONTEXT}.Module", "_get_compile_output_name"),
    (f"{CONTEXT}.Module", "_get_meta_name"),
    (f"{CONTEXT}.KernelHooks", "forward"),
    (f"{CONTEXT}.Launch", "hooks"),
    (f"{CONTEXT}.Launch", "params"),
    (f"{CONTEXT}.Kernel", "adj"),
    (f"{CONTEXT}.Kernel", "get_mangled_name"),
]
ON_GPU = [
    ("import", "warp._src"),
    ("wp", "ModuleBuildOptions"),
    (CONTEXT, "MemoryKind"),
    (CONTEXT, "_raise_cuda_launch_error"),
    (f"{CONTEXT}.runtime", "_apic_capture"),
    (f"{CONTEXT}.runtime", "core"),
    (f"{CONTEXT}.runtime", "tape"),
    (f"{CONTEXT}.runtime.core", "wp_cuda_launch_kernel"),
    (f"{CONTEXT}.runtime.core", "wp_alloc_device_async"),
    (TYPES, "array_t"),
    (f"{CONTEXT}.Device", "_custom_allocator"),
    (f"{CONTEXT}.Device", "mempool_allocator"),
    (f"{CONTEXT}.Module", "execs"),
    (f"{CONTEXT}.KernelHooks", "forward_smem_bytes"),
    (f"{CONTEXT}.Launch", "cluster_dim"),
    (f"{CONTEXT}.Launch", "module_exec"),
    (f"{CONTEXT}.Kernel", "adj"),
]


def run(owner: str, name: str, device: str, cache: Path) -> subprocess.CompletedProcess[str]:
    """Digest small operations in a new process with empty caches and a name hidden from pointloom."""
    environment = os.environ | {"WARP_CACHE_PATH": str(cache), "POINTLOOM_CPU_KERNELS": ""}
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


@pytest.fixture
def fresh():
    warp_parts.is_known.cache_clear()
    yield
    warp_parts.is_known.cache_clear()


def test_missing_parts_are_listed_and_not_used(monkeypatch, fresh):
    class array_t(ctypes.Structure):  # noqa: N801  Warp's name
        _fields_ = (("data", ctypes.c_uint64), ("shape", ctypes.c_int32 * 4))

    monkeypatch.setattr(warp_parts.types, "array_t", array_t)
    monkeypatch.setitem(warp_parts.FUNCTIONS, "wp_cuda_launch_kernel", 12)
    monkeypatch.setattr(warp_parts, "ARRAY", {*warp_parts.ARRAY, "_place"})
    missing = warp_parts.missing()
    assert missing[0].startswith("array_t") and "array._place" in missing
    assert not warp_parts.is_known()


@pytest.fixture(scope="module")
def with_all_names(tmp_path_factory):
    return digest("", "", "cpu", tmp_path_factory.mktemp("cache"))


@pytest.mark.slow
@pytest.mark.parametrize(("owner", "name"), ON_HOST, ids=[".".join(row) for row in ON_HOST])
def test_without_a_private_name_the_cpu_gives_the_same_bits(owner, name, with_all_names, tmp_path):
    assert digest(owner, name, "cpu", tmp_path) == with_all_names


@pytest.mark.slow
@pytest.mark.parametrize(("owner", "name"), ON_GPU, ids=[".".join(row) for row in ON_GPU])
def test_without_a_private_name_a_gpu_gives_the_same_bits(owner, name, with_all_names, tmp_path):
    assert digest(owner, name, "cuda:0", tmp_path) == with_all_names


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["refused", "wrong"])
def test_an_untested_warp_runs_without_the_cuda_header_if_it_fails_a_trial(kind, with_all_names, tmp_path):
    done = run("cuda_access.h", kind, "cuda:0", tmp_path)
    assert done.stdout.splitlines()[-1] == with_all_names
    assert "RuntimeWarning: GPU kernels are slower" in done.stderr
