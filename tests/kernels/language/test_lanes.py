# ruff: noqa: UP018, RUF046
"""Variants for CUDA, and the lanes of a warp that they may use; on the CPU the same kernels run as they are written."""

import numpy as np
import pytest
import warp as wp

from pointloom.kernels import lang
from pointloom.kernels.lang import array, ballot, float32, float64, int32, lane, shuffle, shuffle_xor, sync_lanes, tid
from pointloom.kernels.language.source import KernelLanguageError
from pointloom.kernels.language.warp_compiler import modules_for_cuda
from pointloom.kernels.memory import download, empty, upload

pytestmark = pytest.mark.both_compilers


@lang.struct
class Row:
    values: array(dtype=float32)
    counts: array(dtype=int32)

    def __init__(self, values, counts):
        self.values, self.counts = values, counts


@lang.cuda_func
def lane_total(x: int) -> int:
    total = x + 0
    for bit in range(5):
        total += shuffle_xor(total, 1 << bit)
    return total


@lang.func
def group_total(i: int, row: Row) -> int:
    total = int(0)
    for j in range((i // 32) * 32, (i // 32) * 32 + 32):
        total += row.counts[j]
    return total


@group_total.on_cuda
def group_total_of_lanes(i: int, row: Row) -> int:
    return lane_total(row.counts[i])


@lang.func
def twice_the_total(i: int, row: Row) -> int:
    return 2 * group_total(i, row)


@lang.loop
def others(i: int, row: Row) -> tuple[int, float]:
    for j in range((i // 32) * 32, (i // 32) * 32 + 32):
        if row.values[j] > 0.5:
            value = row.values[j]
            yield j, value


@others.on_cuda
def others_of_lanes(i: int, row: Row) -> tuple[int, float]:
    value_here = row.values[i]
    chosen = ballot(1 if value_here > 0.5 else 0)
    sync_lanes()
    for other in range(32):
        value = shuffle(value_here, other)
        if ((chosen >> other) & 1) == 1:
            j = (i // 32) * 32 + other
            yield j, value


@lang.kernel(max_registers=64)
def sum_groups_kernel(row: Row, totals: array(dtype=int32), sums: array(dtype=float32), last: array(dtype=int32)):
    i = tid()
    totals[i] = twice_the_total(i, row)
    total = float(0.0)
    last_index = int(-1)
    for j, value in others(i, row):
        total += value
        last_index = j
    sums[i] = total
    last[i] = last_index


@lang.kernel
def copy_kernel(row: Row, out: array(dtype=int32)):
    i = tid()
    out[i] = row.counts[i]


@lang.kernel
def fill_kernel(row: Row, out: array(dtype=int32)):
    i = tid()
    out[i] = group_total(i, row)


@fill_kernel.on_cuda
def fill_in_lanes_kernel(row: Row, out: array(dtype=int32)):
    i = tid()
    out[i] = twice_the_total(i, row) // 2 + lane() - i % 32


@lang.func
def exchanged(i: int, values: array(dtype=float64)) -> float64:
    return values[i - i % 32 + 31 - i % 32] - values[i ^ 1]


@exchanged.on_cuda
def exchanged_of_lanes(i: int, values: array(dtype=float64)) -> float64:
    return shuffle(values[i], 31 - i % 32) - shuffle_xor(values[i], 1)


@lang.kernel
def exchange_kernel(values: array(dtype=float64), out: array(dtype=float64)):
    i = tid()
    out[i] = exchanged(i, values)


def test_shuffles_keep_all_bits_of_float64(device):
    values = np.random.default_rng(0).normal(size=64) * 1e300
    out = empty(64, float64, device)
    lang.launch(exchange_kernel, 64, [upload(values, float64, device), out])
    rows = values.reshape(2, 32)
    expected = rows[:, ::-1] - rows.reshape(2, 16, 2)[:, :, ::-1].reshape(2, 32)
    np.testing.assert_array_equal(download(out), expected.ravel())


@pytest.mark.parametrize("groups", [1, 3, 40])
def test_a_variant_gives_the_result_of_the_original(device, groups):
    rng = np.random.default_rng(groups)
    values, counts = rng.random(32 * groups).astype(np.float32), rng.integers(0, 100, 32 * groups).astype(np.int32)
    row = Row(upload(values, float32, device), upload(counts, int32, device))
    totals, sums, last = (empty(32 * groups, kind, device) for kind in (int32, float32, int32))
    lang.launch(sum_groups_kernel, 32 * groups, [row, totals, sums, last])
    rows = values.reshape(-1, 32)
    assert (download(totals).reshape(-1, 32) == 2 * counts.reshape(-1, 32).sum(1)[:, None]).all()
    in_order = [np.cumsum(np.where(v > 0.5, v, np.float32(0)), dtype=np.float32)[-1] for v in rows]
    assert (download(sums).reshape(-1, 32) == np.array(in_order)[:, None]).all()
    at = np.array([32 * g + np.flatnonzero(v > 0.5)[-1] for g, v in enumerate(rows)])
    assert (download(last).reshape(-1, 32) == at[:, None]).all()


def test_only_what_uses_a_variant_has_a_twin():
    assert sum_groups_kernel.twin is not sum_groups_kernel and copy_kernel.twin is copy_kernel
    assert twice_the_total.twin is not twice_the_total and twice_the_total.twin.twin is twice_the_total.twin


def test_a_variant_has_the_parameters_of_the_original():
    with pytest.raises(TypeError, match=r"^other:.*group_total"):

        @group_total.on_cuda
        def other(i: int, row: Row) -> float:
            return 0.0


def test_lanes_are_refused_outside_a_variant():
    with pytest.raises(KernelLanguageError, match=r"^count:"):

        @lang.func
        def count(x: int) -> int:
            return ballot(x)

    with pytest.raises(KernelLanguageError, match=r"^count_again:.*lane_total"):

        @lang.func
        def count_again(x: int) -> int:
            return lane_total(x)


def test_lanes_accept_32_bit_integers_and_floats():
    @lang.cuda_func
    def far(x: float) -> float:
        return shuffle(x, x)

    with pytest.raises(KernelLanguageError, match=r"^far:.*int32.*float32.*float64.*int32"):
        far.resolve()


@lang.kernel(for_cpu=True)
def count_on_the_cpu_kernel(row: Row, totals: array(dtype=int32)):
    i = tid()
    totals[i] = twice_the_total(i, row)


def test_a_kernel_for_the_cpu_is_not_made_for_cuda(device):
    row = Row(upload(np.zeros(32), float32, device), upload(np.ones(32), int32, device))
    totals = empty(32, int32, device)
    assert count_on_the_cpu_kernel.twin is count_on_the_cpu_kernel
    if totals.device.is_cuda:
        with pytest.raises(TypeError, match="count_on_the_cpu_kernel is the CPU's alone"):
            lang.launch(count_on_the_cpu_kernel, 32, [row, totals])
    else:
        lang.launch(count_on_the_cpu_kernel, 32, [row, totals])
        assert (download(totals) == 64).all()
    lang.resolve_module(__name__)
    made = {kernel.key for module in modules_for_cuda(__name__) for kernel in module.kernels.values()}
    assert "copy_kernel" in made and "count_on_the_cpu_kernel" not in made


def test_a_variant_is_not_made_for_the_cpu():
    """All kernels of a file are compiled together there: one that is CUDA's would take the others along."""
    variants = [kernel for kernel in globals().values() if isinstance(kernel, lang.Kernel) and kernel.for_cuda]
    assert variants == [fill_in_lanes_kernel]
    before = set(wp.get_module(f"{__name__}.cpu").kernels)
    for variant in variants:
        variant.resolve()
        with pytest.raises(TypeError, match=f"{variant.name} is CUDA's alone"):
            _ = variant.cpu
    assert set(wp.get_module(f"{__name__}.cpu").kernels) - before <= set(lang.LAUNCHED[__name__])
