"""Quantiles and medians of non-negative numbers, bitwise as NumPy's. On CUDA by one sort and one sync."""

from collections.abc import Sequence

import numpy as np

from ..array_types import Doubles
from ..lang import array, float64, func, int32, int64, isfinite, kernel, launch, tid, vector
from ..memory import download, empty
from .side_by_side import part_of
from .sort import SortKeys, put_key

MAX_QUANTILES = 8  # of a call, passed by value
quantile_fractions = vector(MAX_QUANTILES, float64)
NO_NUMBER = 0x7FFF_FFFF_FFFF_FFFF  # above the bits of every number, so excluded ones are sorted last


@kernel
def encode_doubles_kernel(values: array(dtype=float64), bits: array(dtype=int64), above_zero: int, keys: SortKeys):
    i = tid()
    key = int64(NO_NUMBER)
    if isfinite(values[i]) and values[i] >= 0.0:
        if above_zero == 0 or values[i] > 0.0:
            key = bits[i] & int64(NO_NUMBER)
    put_key(i, key, keys)


@func
def count_numbers(keys: array(dtype=int64), size: int) -> int:
    low = 0
    high = size
    while low < high:
        middle = low + (high - low) // 2
        if keys[middle] < int64(NO_NUMBER):
            low = middle + 1
        else:
            high = middle
    return low


@kernel
def pick_quantiles_kernel(
    values: array(dtype=float64),
    keys: array(dtype=int64),
    order: array(dtype=int32),
    fractions: quantile_fractions,
    is_median: int,
    quantiles: array(dtype=float64),
):
    """Each quantile, interpolated linearly. Then the count of valid numbers."""
    i = tid()
    count = count_numbers(keys, values.shape[0])
    if i == quantiles.shape[0] - 1:
        quantiles[i] = float64(count)
        return
    if count == 0:
        quantiles[i] = float64(0.0)
        return
    rank = float64(count - 1) * fractions[i]
    below = min(int(rank), count - 1)
    above = min(below + 1, count - 1)
    if is_median == 1:
        below = (count - 1) // 2
        above = count // 2
    a = values[order[below]]
    b = values[order[above]]
    fraction = rank - float64(below)
    between = a + (b - a) * fraction
    if fraction >= 0.5:
        between = b - (b - a) * (1.0 - fraction)
    if is_median == 1:
        between = (a + b) / 2.0
        if below == above:
            between = a
    quantiles[i] = between


def _pick(values: Doubles, fractions: Sequence[float], above_zero: bool, is_median: bool) -> tuple[int, list[float]]:
    device = values.device
    keys = SortKeys(values.size, device)
    launch(encode_doubles_kernel, values.size, [values, part_of(values, 0, int64, values.size), int(above_zero), keys])
    sorted_keys, order = keys.sort()
    picked = empty(len(fractions) + 1, float64, device)
    wanted = quantile_fractions(*fractions, *[0.0] * (MAX_QUANTILES - len(fractions)))
    launch(pick_quantiles_kernel, picked.size, [values, sorted_keys, order, wanted, int(is_median), picked])
    *quantiles, count = download(picked).tolist()  # sync
    return int(count), quantiles


def _counted(values: Doubles, above_zero: bool) -> np.ndarray:
    numbers = download(values)
    return numbers[np.isfinite(numbers) & ((numbers > 0) if above_zero else (numbers >= 0))]


def quantiles_of(values: Doubles, fractions: Sequence[float]) -> list[float]:
    """`np.quantile` of the finite non-negative numbers of a float64 array, bitwise, or empty. One sync."""
    if values.device.is_cuda and values.size:
        count, quantiles = _pick(values, fractions, False, False)
        return quantiles if count else []
    numbers = _counted(values, False)
    return np.quantile(numbers, fractions).tolist() if numbers.size else []


def median_above_zero(values: Doubles) -> float | None:
    """`np.median` of the finite positive numbers of an array, bitwise, or None. One sync."""
    if values.device.is_cuda and values.size:
        count, (median,) = _pick(values, [0.5], True, True)
        return median if count else None
    numbers = _counted(values, True)
    return float(np.median(numbers)) if numbers.size else None
