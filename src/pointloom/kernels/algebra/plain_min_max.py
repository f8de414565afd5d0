"""Minimum and maximum without NaN handling, for inner loops: with NaN the second argument is returned."""

from ..lang import func


@func
def smaller(a: float, b: float) -> float:
    return a if a < b else b


@func
def larger(a: float, b: float) -> float:
    return a if a > b else b
