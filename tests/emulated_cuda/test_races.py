"""The race detector: accesses of two threads to the same bytes, one of them a write that changes them."""

from pathlib import Path

import pytest

from .processes import run

EXPECTED = {
    "two_writes_kernel": "race: two writes",
    "same_value_kernel": "none",  # writes that change nothing resolve no race
    "own_element_kernel": "none",
    "read_of_another_kernel": "race: read and write",
    "atomics_kernel": "none",
    "atomic_and_plain_kernel": "atomic beside plain access",
    "bytes_of_a_word_kernel": "none",
    "own_byte_kernel": "none",
    "byte_of_another_kernel": "race: read and write",
    "two_writes_of_a_byte_kernel": "race: two writes",
    "own_half_kernel": "none",
    "tiles_kernel": "none",
    "sum_moments_tiles": "none",  # the last block to end reads the sums of the others
    "with_barrier": "none",
    "without_barrier": "race: read and write",
    "with_warp_barrier": "none",
    "with_warp_barrier_between_warps": "race: read and write",
    "readers_before_barrier": "none",
    "readers_without_barrier": "race: read and write",
    "readers_before_warp_barrier": "none",
    "readers_of_two_warps_before_warp_barrier": "race: read and write",
    "readers_of_two_blocks_before_barrier": "race: read and write",
}


@pytest.fixture(scope="module", params=[0, 1, 2, 3])
def races(request) -> dict[str, str]:
    """By kernel, in each order of threads; in a process of its own, as the detector's memory is made at the start."""
    program = str(Path(__file__).with_name("race_kernels.py"))
    return run(program, EMULATED_CUDA_RACES="1", EMULATED_CUDA_ORDER=str(request.param))


@pytest.mark.parametrize("kernel", EXPECTED)
def test_races_are_detected_in_any_order(races, kernel):
    assert races[kernel] == EXPECTED[kernel]
