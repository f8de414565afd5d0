"""Functions of arrays with broadcasting, and reductions of rows: those of NumPy."""

import numpy as np
import pytest

from pointloom.kernels.lang import float64, int64
from pointloom.kernels.memory import upload
from pointloom.kernels.tensors import elementwise as kernels

NUMBERS = np.array([0.0, 1.0, -1.0, 0.5, 2.5, -2.5, 1e300, np.inf, -np.inf, np.nan])
BINARY = {
    **{"ADD": np.add, "SUB": np.subtract, "MUL": np.multiply, "DIV": np.divide},
    **{"MAXIMUM": np.maximum, "MINIMUM": np.minimum, "GT": np.greater, "LT": np.less},
    **{"GE": np.greater_equal, "LE": np.less_equal, "EQ": np.equal, "NE": np.not_equal},
}
UNARY = {name: getattr(np, name.lower()) for name in ("ABS", "FLOOR", "CEIL", "ROUND", "TRUNC", "SQRT", "SIN", "COS")}
UNARY |= {name: getattr(np, name.lower()) for name in ("EXP", "ISNAN", "ISINF", "ISFINITE")} | {"NEG": np.negative}
FOLDS = {"ADD": np.sum, "MUL": np.prod, "MAXIMUM": np.max, "MINIMUM": np.min}
SHAPES = [
    ((10,), (10, 1)),
    ((10,), (1,)),
    ((2, 5), (2, 5)),
    ((2, 1, 5), (3, 1)),
    ((5, 1, 2, 1), (2, 1, 5)),
    ((1,), (7,)),
]


@pytest.mark.parametrize(("left", "right"), SHAPES)
def test_functions_of_two_arrays_broadcast_as_numpy(device, left, right, rng):
    for dtype, element in ((np.float64, float64), (np.int64, int64)):
        values = NUMBERS if dtype == np.float64 else np.array([0, 1, -1, 7, -(2**63), 2**63 - 1, 2**40])
        a, b = (rng.choice(values, shape).astype(dtype) for shape in (left, right))
        for name, function in BINARY.items():
            if dtype == np.int64 and name == "DIV":
                continue
            out, shape = kernels.combine(
                upload(a.ravel(), element, device),
                left,
                upload(b.ravel(), element, device),
                right,
                getattr(kernels, name),
            )
            with np.errstate(all="ignore"):
                expected = function(a, b)
            assert shape == expected.shape
            np.testing.assert_array_equal(out.numpy().reshape(shape), expected.astype(dtype), err_msg=name)


def test_shapes_that_do_not_broadcast_are_rejected(device):
    a = upload(np.ones(6), float64, device)
    with pytest.raises(ValueError, match=r"\(2,3\).*|mismatch"):
        kernels.combine(a, (2, 3), a, (3, 2), kernels.ADD)


def test_functions_of_each_number_are_numpys(device):
    for name, function in UNARY.items():
        numbers = NUMBERS[:6] if name in ("SIN", "COS") else NUMBERS
        with np.errstate(all="ignore"):
            expected = function(numbers).astype(float)
        values = kernels.map_floats(upload(numbers, float64, device), getattr(kernels, name)).numpy()
        np.testing.assert_allclose(values, expected, rtol=1e-15, atol=1e-15, err_msg=name)


@pytest.mark.parametrize("count", [1, 2, 63, 64, 65, 4097])
def test_reductions_of_rows_are_numpys(device, count, rng):
    for element, values in ((float64, rng.normal(size=(3, count))), (int64, rng.integers(-99, 99, (3, count)))):
        for name, function in FOLDS.items():
            rows = kernels.fold_rows(upload(values.ravel(), element, device), count, getattr(kernels, name))
            np.testing.assert_allclose(rows.numpy(), function(values, axis=1), rtol=1e-12, atol=1e-12)
    values[1, -1], floats = 0, values.astype(float)
    floats[1, -1] = np.nan
    rows = kernels.fold_rows(upload(floats.ravel(), float64, device), count, kernels.MAXIMUM).numpy()
    np.testing.assert_array_equal(np.isnan(rows), [False, True, False])
