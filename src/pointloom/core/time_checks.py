"""Reject times that float32 cannot resolve: seconds since 1970 are 128 s apart in float32."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .checks import check_number

MAX_TIME_STEP = 0.01  # [s] a third of a frame at 30 Hz. The step of float32 is larger from 2^17 s on
MAX_TIME = 1e11  # [s] since 1970: the year 5138. Milliseconds exceed it since 1973
_UNITS = (("milliseconds", 1e3), ("microseconds", 1e6), ("nanoseconds", 1e9))
_FIX = "Pass float64, or subtract the first time before the conversion to float32"


def float32_step(largest: float) -> float:
    """Distance of a number to the next larger float32."""
    return float(np.spacing(np.float32(abs(largest))))


def is_single(dtype: Any) -> bool:
    """True for floating-point types of at most 32 bits."""
    dtype = np.dtype(dtype)
    return dtype.kind == "f" and dtype.itemsize <= 4


def check_seconds(name: str, times: NDArray[Any]) -> None:
    """Raise ValueError for float32 times [s] of any shape that are more than 10 ms apart from the next number."""
    times = np.asarray(times)
    if not is_single(times.dtype):
        return
    finite = np.abs(times[np.isfinite(times)].astype(np.float64))
    if finite.size and float32_step(finite.max()) > MAX_TIME_STEP:
        largest = float(finite.max())
        raise ValueError(f"{name}: {_reason(largest)}. {_FIX}")


def check_unit_of_seconds(name: str, times: NDArray[np.float64]) -> None:
    """Raise ValueError for times so large that they are milliseconds, microseconds or nanoseconds since 1970."""
    largest = float(np.abs(times).max(initial=0.0))
    if largest > MAX_TIME:
        unit, factor = next((unit, factor) for unit, factor in _UNITS if largest / factor <= MAX_TIME or factor == 1e9)
        raise ValueError(f"{name}: expected timestamps in seconds, got {largest:.6g}. Divide {unit} by {factor:,.0f}")


def check_time(name: str, time: object) -> float:
    """A finite time [s]. Raises ValueError as `check_seconds`."""
    value = check_number(name, time)
    check_seconds(name, np.asarray(time))
    return value


def check_span(name: str, first: float, last: float, min_steps: int) -> None:
    """Raise ValueError if float32 numbers from `first` to `last`, in any unit, have fewer than `min_steps` steps.
    Equal times are accepted if float32 resolves units there."""
    largest = max(abs(first), abs(last))
    step = float32_step(largest)
    if (last - first < min_steps * step) if last > first else step >= 1:
        raise ValueError(f"{name}: {_reason(largest)}. {_FIX}")


def _reason(largest: float) -> str:
    step = float32_step(largest)
    return f"expected times in float64, got float32 numbers up to {largest:.6g}, which are {step:g} apart"
