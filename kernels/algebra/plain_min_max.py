"""The smaller and the larger of two numbers, for inner loops whose numbers are known not to be NaN.

The language's min and max promise the number where the other is NaN, which takes three instructions on the CPU; a
comparison and a choice are one. Where a number may be NaN the second argument comes back.
"""

from ..lang import func


@func
def smaller(a: float, b: float) -> float:
    """The smaller of two numbers."""
    return a if a < b else b


@func
def larger(a: float, b: float) -> float:
    """The larger of two numbers."""
    return a if a > b else b
