"""Phases of one launch: one block of CUDA, one thread of the CPU."""

import numpy as np
import pytest

from pointloom.kernels.arrays.blocks import block_threads, wait_for_block
from pointloom.kernels.lang import array, int32, kernel, launch, tid
from pointloom.kernels.memory import download, empty, upload

COUNT = 1024  # numbers: four per CUDA thread
FAR = 97  # ranks between a reader and its writer: in another warp


@kernel
def rotate_kernel(rounds: int, far: int, threads: int, numbers: array(dtype=int32), others: array(dtype=int32)):
    """Move each number to the rank `far` below, twice in each round. The writer of a number is another thread."""
    i = tid()
    count = numbers.shape[0]
    for _ in range(rounds):
        row = i + 0
        while row < count:
            others[row] = numbers[(row + far) % count]
            row += threads
        wait_for_block()
        row = i + 0
        while row < count:
            numbers[row] = others[(row + far) % count]
            row += threads
        wait_for_block()


def rotate(device, rounds: int) -> np.ndarray:
    numbers, others = upload(np.arange(COUNT), int32, device), empty(COUNT, int32, device)
    threads = block_threads(others.device)
    launch(rotate_kernel, threads, [rounds, FAR, threads, numbers, others])
    return download(numbers)


@pytest.mark.parametrize("rounds", [1, 5])
def test_threads_read_what_others_of_their_block_wrote_before_the_barrier(device, rounds):
    np.testing.assert_array_equal(rotate(device, rounds), np.roll(np.arange(COUNT), -2 * rounds * FAR))
