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
SHAPES = [((10,), (10, 1)), ((10,), (1,)), ((2, 5), (2, 5)), ((2, 1, 5), (3, 1)), ((5, 1, 2, 1), (2, 1, 5))]
SHAPES += [((1,), (7,))]


@pytest.mark.parametrize(("left", "right"), SHAPES)
def test_functions_of_two_arrays_broadcast_as_numpy(device, left, right, rng):
    for dtype, element in ((np.float64, float64), (np.int64, int64)):
        values = NUMBERS if dtype == np.float64 else np.array([0, 1, -1, 7, -(2**63), 2**63 - 1, 2**40])
        a, b = (rng.choice(values, shape).astype(dtype) for shape in (left, right))
        for name, function in BINARY.items():
            if dtype == np.int64 and name == "DIV":
                continue
            on_device = [upload(values.ravel(), element, device) for values in (a, b)]
            out, shape = kernels.combine(on_device[0], left, on_device[1], right, getattr(kernels, f"OPERATION_{name}"))
            with np.errstate(all="ignore"):
                expected = function(a, b)
            assert shape == expected.shape
            np.testing.assert_array_equal(out.numpy().reshape(shape), expected.astype(dtype), err_msg=name)


def test_shapes_that_do_not_broadcast_are_rejected(device):
    a = upload(np.ones(6), float64, device)
    with pytest.raises(ValueError, match=r"\(2,3\).*|mismatch"):
        kernels.combine(a, (2, 3), a, (3, 2), kernels.OPERATION_ADD)
