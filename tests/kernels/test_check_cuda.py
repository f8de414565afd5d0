"""Kernels compile for CUDA without a GPU, and what a thread of them holds is read from the cubins."""

import pytest
import warp as wp

from pointloom.kernels import check_cuda, lang
from pointloom.kernels.language.warp_compiler import REDUCTION_BLOCK

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
    for name in ("copy_kernel", "mix_kernel", "sum_rows_tiles", "sum_rows_fold_tiles"):
        assert name in names
    assert compiled.sizes[90] > 1000


@pytest.mark.slow
def test_what_only_the_cpu_runs_is_not_compiled_for_cuda_nor_the_other_way_round(compiled):
    assert not any(name.startswith("sum_rows_sum") for name in compiled.usage[90])
    assert not wp.get_module("compiled.cpu").kernels, "made when the CPU first runs one"
    _ = lang.LAUNCHED["compiled"]["sum_rows"].cpu
    assert {name for name in wp.get_module("compiled.cpu").kernels} == {"sum_rows_sum", "copy_kernel", "mix_kernel"}
    assert {name for name in wp.get_module("compiled").kernels} == {"copy_kernel", "mix_kernel"}


@pytest.mark.slow
def test_registers_and_local_memory_are_read(compiled):
    usage = {name.partition("_kernel_")[0]: u for name, u in compiled.usage[90].items()}
    assert 4 <= usage["copy"].registers <= 64 and usage["copy"].local_bytes == 0
    assert usage["mix"].local_bytes >= 256, "64 floats with a computed index lie in local memory"
    (line,) = [line for line in check_cuda.report_heavy(compiled) if "mix_kernel" in line]
    assert "B of local memory" in line
    assert not any("copy_kernel" in line for line in check_cuda.report_heavy(compiled))


@pytest.mark.slow
def test_a_kernel_without_tiles_shares_no_more_than_the_word_a_thread_that_warp_gives_to_all(compiled):
    """And tiles take theirs besides; 1 KB a block is the driver's."""
    words = 4 * REDUCTION_BLOCK + 1024
    shared = {name.rpartition("_cuda_")[0].rpartition("_")[0]: u.shared_bytes for name, u in compiled.usage[90].items()}
    assert shared["copy_kernel"] == shared["mix_kernel"] == words
    vector = REDUCTION_BLOCK // 32 * 8  # a number of each warp
    held = shared["sum_rows_tiles"]
    assert words + 4 * vector <= held == shared["sum_rows_fold_tiles"] < words + 8 * vector, "four numbers at a time"


@pytest.mark.slow
def test_one_block_size_holds_for_a_whole_module(compiled):
    assert wp.get_module_options("compiled")["block_dim"] == REDUCTION_BLOCK


def test_a_failure_is_reported_and_the_rest_goes_on(write_kernels, capsys):
    write_kernels("kernelless", "LIMIT = 3\n")
    assert check_cuda.main(["no_such_module", "kernelless"]) == 1
    printed = capsys.readouterr()
    assert "no_such_module: FAILED" in printed.err and "kernelless: FAILED" in printed.err
    assert "modules failed: 2" in printed.out


@pytest.mark.slow
def test_a_named_module_is_compiled_alone(capsys):
    assert check_cuda.main(["pointloom.kernels.arrays.bounds"]) == 0
    first, last = (line for line in capsys.readouterr().out.splitlines() if not line.startswith(" "))
    assert first.startswith("pointloom.kernels.arrays.bounds: 2 kernels, sm_75 ") and "modules failed: 0" in last
