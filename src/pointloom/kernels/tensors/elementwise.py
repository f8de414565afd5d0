"""Elementwise functions of arrays with broadcasting, and reductions, each chosen by a number.

Kernels compute in float64 or int64. For float32 operands this gives the correctly rounded sum, difference, product,
quotient and square root (Figueroa, "When is double rounding innocuous?", SIGNUM Newsletter 30, 1995). 24 B per element
of a function, 8 B per element of a reduction.
"""

from typing import Any, TypeVar

import numpy as np

from ..array_types import Doubles, LongIntegers
from ..lang import (
    array,
    compute,
    cos,
    exp,
    float64,
    floor,
    func,
    int64,
    isfinite,
    kernel,
    launch,
    sin,
    sqrt,
    tid,
    vec4i,
)
from ..memory import clone, empty

MAX_AXES = 4
ELEMENTS_PER_THREAD = 64  # of a reduction

OPERATION_ADD, OPERATION_SUB, OPERATION_MUL, OPERATION_DIV, OPERATION_MAXIMUM, OPERATION_MINIMUM = range(6)
OPERATION_GT, OPERATION_LT, OPERATION_GE, OPERATION_LE, OPERATION_EQ, OPERATION_NE = range(6, 12)
FUNCTION_SQRT, FUNCTION_SIN, FUNCTION_COS, FUNCTION_EXP, FUNCTION_ABS, FUNCTION_NEG = range(6)
FUNCTION_FLOOR, FUNCTION_CEIL, FUNCTION_ROUND, FUNCTION_TRUNC = range(6, 10)
FUNCTION_ISNAN, FUNCTION_ISINF, FUNCTION_ISFINITE = range(10, 13)


@func
def is_nan(x: float64) -> int:
    return 0 if x <= 0.0 or x > 0.0 else 1


@func
def larger(x: float64, y: float64) -> float64:
    """The larger number. NaN if one is NaN."""
    return x if is_nan(x) == 1 or (is_nan(y) == 0 and x > y) else y


@func
def truth(is_true: int) -> float64:
    return float64(is_true)


@func
def combine_floats(x: float64, y: float64, operation: int) -> float64:
    result = x + y
    if operation == OPERATION_SUB:
        result = x - y
    elif operation == OPERATION_MUL:
        result = x * y
    elif operation == OPERATION_DIV:
        result = x / y
    elif operation == OPERATION_MAXIMUM:
        result = larger(x, y)
    elif operation == OPERATION_MINIMUM:
        result = -larger(-x, -y)
    elif operation == OPERATION_GT:
        result = truth(1 if x > y else 0)
    elif operation == OPERATION_LT:
        result = truth(1 if x < y else 0)
    elif operation == OPERATION_GE:
        result = truth(1 if x >= y else 0)
    elif operation == OPERATION_LE:
        result = truth(1 if x <= y else 0)
    elif operation == OPERATION_EQ:
        result = truth(1 if x == y else 0)
    elif operation == OPERATION_NE:
        result = truth(0 if x == y else 1)
    return result


@func
def combine_integers(x: int64, y: int64, operation: int) -> int64:
    """As `combine_floats`, without a quotient."""
    result = x + y
    if operation == OPERATION_SUB:
        result = x - y
    elif operation == OPERATION_MUL:
        result = x * y
    elif operation == OPERATION_MAXIMUM:
        result = max(x, y)
    elif operation == OPERATION_MINIMUM:
        result = min(x, y)
    elif operation == OPERATION_GT:
        result = int64(1 if x > y else 0)
    elif operation == OPERATION_LT:
        result = int64(1 if x < y else 0)
    elif operation == OPERATION_GE:
        result = int64(1 if x >= y else 0)
    elif operation == OPERATION_LE:
        result = int64(1 if x <= y else 0)
    elif operation == OPERATION_EQ:
        result = int64(1 if x == y else 0)
    elif operation == OPERATION_NE:
        result = int64(0 if x == y else 1)
    return result


@func
def position_in(i: int, shape: vec4i, steps: vec4i) -> int:
    """Position in a broadcast operand of the element i of the result: its steps are 0 along repeated axes."""
    last = i % shape[3]
    rest = i // shape[3]
    third = rest % shape[2]
    rest = rest // shape[2]
    return (rest // shape[1]) * steps[0] + (rest % shape[1]) * steps[1] + third * steps[2] + last * steps[3]


@kernel
def combine_floats_kernel(
    a: array(dtype=float64),
    b: array(dtype=float64),
    shape: vec4i,
    a_steps: vec4i,
    b_steps: vec4i,
    operation: int,
    out: array(dtype=float64),
):
    i = tid()
    out[i] = combine_floats(a[position_in(i, shape, a_steps)], b[position_in(i, shape, b_steps)], operation)


@kernel
def combine_integers_kernel(
    a: array(dtype=int64),
    b: array(dtype=int64),
    shape: vec4i,
    a_steps: vec4i,
    b_steps: vec4i,
    operation: int,
    out: array(dtype=int64),
):
    i = tid()
    out[i] = combine_integers(a[position_in(i, shape, a_steps)], b[position_in(i, shape, b_steps)], operation)


@func
def round_to_even(x: float64) -> float64:
    below = floor(x)
    odd = below - 2.0 * floor(below / 2.0)
    rest = x - below
    return below + 1.0 if rest > 0.5 or (rest == 0.5 and odd == 1.0) else below


@kernel
def map_floats_kernel(values: array(dtype=float64), function: int, out: array(dtype=float64)):
    i = tid()
    x = values[i]
    result = sqrt(x)
    if function == FUNCTION_SIN:
        result = sin(x)
    elif function == FUNCTION_COS:
        result = cos(x)
    elif function == FUNCTION_EXP:
        result = exp(x)
    elif function == FUNCTION_ABS:
        result = abs(x)
    elif function == FUNCTION_NEG:
        result = -x
    elif function == FUNCTION_FLOOR:
        result = floor(x)
    elif function == FUNCTION_CEIL:
        result = -floor(-x)
    elif function == FUNCTION_ROUND:
        result = round_to_even(x)
    elif function == FUNCTION_TRUNC:
        result = floor(x) if x >= 0.0 else -floor(-x)
    elif function == FUNCTION_ISNAN:
        result = truth(is_nan(x))
    elif function == FUNCTION_ISINF:
        result = truth(1 if not isfinite(x) and is_nan(x) == 0 else 0)
    elif function == FUNCTION_ISFINITE:
        result = truth(1 if isfinite(x) else 0)
    out[i] = result


@kernel
def fold_floats_kernel(values: array(dtype=float64), count: int, parts: int, operation: int, out: array(dtype=float64)):
    """Combine every `parts`-th number of a row of `count`, for each of the parts of each row."""
    i = tid()
    first = (i // parts) * count + i % parts
    result = values[first]
    for k in range(1, (count - i % parts + parts - 1) // parts):
        result = combine_floats(result, values[first + k * parts], operation)
    out[i] = result


@kernel
def fold_integers_kernel(values: array(dtype=int64), count: int, parts: int, operation: int, out: array(dtype=int64)):
    """As `fold_floats_kernel`."""
    i = tid()
    first = (i // parts) * count + i % parts
    result = values[first]
    for k in range(1, (count - i % parts + parts - 1) // parts):
        result = combine_integers(result, values[first + k * parts], operation)
    out[i] = result


Numbers = TypeVar("Numbers", Doubles, LongIntegers)


def combine(
    a: Numbers, a_shape: tuple[int, ...], b: Numbers, b_shape: tuple[int, ...], operation: int
) -> tuple[Numbers, tuple[int, ...]]:
    """A function of two flat arrays with these shapes, of up to four axes, both float64 or int64, and its shape.

    Raises ValueError if the shapes cannot be broadcast.
    """
    shape = np.broadcast_shapes(a_shape, b_shape)
    out: Any = empty(int(np.prod(shape)), a.dtype, a.device)
    chosen = combine_floats_kernel if a.dtype == float64 else combine_integers_kernel
    sizes = vec4i(*(1,) * (MAX_AXES - len(shape)), *shape)
    launch(chosen, out.size, [a, b, sizes, _steps(a_shape), _steps(b_shape), operation, out])
    return out, shape


def _steps(shape: tuple[int, ...]) -> vec4i:
    """Distance of neighbors along each of four axes, 0 where the size is 1."""
    steps = [int(np.prod(shape[axis + 1 :])) if size > 1 else 0 for axis, size in enumerate(shape)]
    return vec4i(*(0,) * (MAX_AXES - len(shape)), *steps)


def map_floats(values: Doubles, function: int) -> Doubles:
    """A function of each number."""
    return compute(map_floats_kernel, values.size, [values, function], float64, values.device)


def fold_rows(values: Numbers, count: int, operation: int) -> Numbers:
    """A sum, product, maximum or minimum of each row of `count` numbers, at least one, of a flat array."""
    if count == 1:
        return clone(values)
    rows = values.size // count
    chosen = fold_floats_kernel if values.dtype == float64 else fold_integers_kernel
    while count > 1:
        parts = (count + ELEMENTS_PER_THREAD - 1) // ELEMENTS_PER_THREAD
        out: Any = empty(rows * parts, values.dtype, values.device)
        launch(chosen, out.size, [values, count, parts, operation, out])
        values, count = out, parts
    return values
