"""Every element belongs to one thread for any device and count."""

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.arrays.runs import CUDA_MIN_LENGTH, CUDA_THREADS, Runs, elements_of, row_of
from pointloom.kernels.lang import array, atomic_add, int32, kernel, launch, tid
from pointloom.kernels.memory import download, zeros

LENGTH = 64  # of a run on the CPU


@kernel
def visit_elements_kernel(runs: Runs, visits: array(dtype=int32), taken: array(dtype=int32)):
    i = tid()
    for j in elements_of(i, runs):
        visits[j] = visits[j] + 1
        atomic_add(taken, row_of(i, runs), 1)


@pytest.mark.parametrize("count", [0, 1, LENGTH - 1, LENGTH, LENGTH + 1, 1000, CUDA_MIN_LENGTH * CUDA_THREADS + 5])
def test_each_element_is_taken_once(device, count):
    warp_device = resolve_device(device)
    runs = Runs(count, warp_device, LENGTH)
    visits, taken = zeros(count, int32, warp_device), zeros(runs.rows, int32, warp_device)
    launch(visit_elements_kernel, runs.threads, [runs, visits, taken])
    assert (download(visits) == 1).all()
    assert download(taken).sum() == count


class Gpu:
    is_cuda = True


def test_gpu_launches_use_full_warps_up_to_the_device_limit():
    assert Runs(200_000, Gpu(), 4096).threads == 50_016
    assert Runs(1, Gpu(), 4096).threads == 32
    assert Runs(50_000_000, Gpu(), 4096).threads == CUDA_THREADS


@pytest.mark.parametrize("count", [1, 2**31 - 1])
def test_all_numbers_of_the_largest_arrays_fit_in_32_bits(count):
    runs = Runs(count, Gpu(), 4096)
    last = runs.threads - 1
    assert last * runs.stride < 2**31
    assert max((count - 1 - last) // runs.step + 1, runs.length) < 2**31
    assert last + ((count - 1 - last) // runs.step) * runs.step <= count - 1
    assert np.int64(runs.rows) <= 256
