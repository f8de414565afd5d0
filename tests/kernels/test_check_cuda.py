"""Kernels compile for CUDA without a GPU, and memory per thread is read from the cubins."""

import re
from pathlib import Path

import pytest
import warp as wp

from pointloom.kernels import check_cuda, lang
from pointloom.kernels.language.warp_compiler import REDUCTION_BLOCK, cuda_module

FENCE = "membar.gl"  # __threadfence()
SOURCE = """
V27 = vector(27, float64)

@kernel
def copy_kernel(a: array(dtype=float32), out: array(dtype=float32)):
    i = tid()
    out[i] = a[i]

@kernel
def mix_kernel(a: array(dtype=int32), out: array(dtype=float32)):
    i = tid()
    v = V64(0.0)
    for j in range(a[0]):
        v[a[j]] = float(j)
    out[i] = v[a[i]]

@reduction
def sum_rows(a: array(dtype=float64)) -> V27:
    i = tid()
    return V27(a[i])
"""


@pytest.fixture(scope="module")
def compiled(write_kernels):
    module = write_kernels("compiled", "V64 = vector(64, float32)\n" + SOURCE)
    return check_cuda.compile_module(module.__name__, (90,))


@pytest.mark.slow
def test_a_module_compiles_with_its_reductions(compiled):
    names = " ".join(compiled.usage[90])
    for name in ("copy_kernel", "mix_kernel", "sum_rows_tiles"):
        assert name in names
    assert compiled.sizes[90] > 1000


@pytest.mark.slow
def test_kernels_of_one_device_are_not_compiled_for_the_other(compiled):
    assert not any(name.startswith("sum_rows_sum") for name in compiled.usage[90])
    assert not wp.get_module("compiled.cpu").kernels, "made when the CPU first runs one"
    _ = lang.LAUNCHED["compiled"]["sum_rows"].cpu
    assert {name for name in wp.get_module("compiled.cpu").kernels} == {"sum_rows_sum", "copy_kernel", "mix_kernel"}
    assert {name for name in wp.get_module("compiled").kernels} == {"copy_kernel", "mix_kernel"}


@pytest.mark.slow
def test_only_sums_share_more_than_the_word_a_thread_that_warp_gives_to_all(compiled):
    """A row of each warp, and one of each part of the last sum; 1 KB a block is the driver's."""
    words = 4 * REDUCTION_BLOCK + 1024
    shared = {name.rpartition("_cuda_")[0].rpartition("_")[0]: u.shared_bytes for name, u in compiled.usage[90].items()}
    assert shared["copy_kernel"] == shared["mix_kernel"] == words
    rows = REDUCTION_BLOCK // 32 + REDUCTION_BLOCK // 27
    assert words + 8 * 27 * rows <= shared["sum_rows_tiles"] < words + 8 * 27 * rows + 64


@pytest.mark.slow
def test_sums_of_blocks_are_written_before_they_are_counted_and_read_past_the_first_cache(write_kernels, tmp_path):
    module = write_kernels("fenced", "V64 = vector(64, float32)\n" + SOURCE)
    lang.resolve_module(module.__name__)
    [path] = wp.compile_aot_module(cuda_module(module.__name__), arch=90, module_dir=tmp_path, use_ptx=True)
    kernel = Path(path).read_text(encoding="utf-8").partition("sum_rows_tiles")[2]
    found = re.findall(r"st\.global|membar\.gl|fence\S*|atom\.global\.\S*add|ld\.global\.cg|bar\.sync", kernel)
    counted = next(k for k, text in enumerate(found) if text.startswith("atom"))
    before, after = found[:counted], found[counted:]
    assert before[-2:] == [FENCE, "bar.sync"] and "st.global" in before
    assert after.index(FENCE) < after.index("ld.global.cg") and "ld.global.cg" not in before
