"""Atomics of a thread's result on the row of its warp (runs.py). On CUDA lanes are reduced first: one atomic per warp.

All threads of a warp call these together, with the same position `at`. All are order-independent: sums of integers,
minimum, maximum.
"""

from ..lang import array, atomic_add, atomic_max, atomic_min, float64, func, int32, int64, lane
from .lanes import (
    max_double_of_lanes,
    max_int_of_lanes,
    min_int_of_lanes,
    min_long_of_lanes,
    sum_int_of_lanes,
    sum_long_of_lanes,
)


@func
def add_int(sums: array(dtype=int32), at: int, value: int):
    atomic_add(sums, at, value)


@add_int.on_cuda
def add_int_of_lanes(sums: array(dtype=int32), at: int, value: int):
    total = sum_int_of_lanes(value)
    if lane() == 0:
        atomic_add(sums, at, total)


@func
def add_long(sums: array(dtype=int64), at: int, value: int64):
    atomic_add(sums, at, value)


@add_long.on_cuda
def add_long_of_lanes(sums: array(dtype=int64), at: int, value: int64):
    total = sum_long_of_lanes(value)
    if lane() == 0:
        atomic_add(sums, at, total)


@func
def raise_int(maxima: array(dtype=int32), at: int, value: int):
    atomic_max(maxima, at, value)


@raise_int.on_cuda
def raise_int_of_lanes(maxima: array(dtype=int32), at: int, value: int):
    highest = max_int_of_lanes(value)
    if lane() == 0:
        atomic_max(maxima, at, highest)


@func
def raise_double(maxima: array(dtype=float64), at: int, value: float64):
    atomic_max(maxima, at, value)


@raise_double.on_cuda
def raise_double_of_lanes(maxima: array(dtype=float64), at: int, value: float64):
    highest = max_double_of_lanes(value)
    if lane() == 0:
        atomic_max(maxima, at, highest)


@func
def lower_int(minima: array(dtype=int32), at: int, value: int):
    atomic_min(minima, at, value)


@lower_int.on_cuda
def lower_int_of_lanes(minima: array(dtype=int32), at: int, value: int):
    lowest = min_int_of_lanes(value)
    if lane() == 0:
        atomic_min(minima, at, lowest)


@func
def lower_long(minima: array(dtype=int64), at: int, value: int64):
    if value < minima[at]:  # a stale minimum only adds an atomic
        atomic_min(minima, at, value)


@lower_long.on_cuda
def lower_long_of_lanes(minima: array(dtype=int64), at: int, value: int64):
    lowest = min_long_of_lanes(value)
    if lane() == 0:
        if lowest < minima[at]:
            atomic_min(minima, at, lowest)
