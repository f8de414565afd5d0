"""Arrays in one allocation, and arrays downloaded together: each has its own values, type and shape."""

import numpy as np
import pytest

from pointloom.kernels.arrays.side_by_side import SideBySide, read_together
from pointloom.kernels.lang import array, float32, float64, int32, kernel, launch, mat44d, tid, uint8, vec3, vec3d
from pointloom.kernels.memory import download, fill, upload


@kernel
def raise_kernel(counts: array(dtype=int32), positions: array(dtype=vec3d)):
    i = tid()
    counts[i] = counts[i] + 1
    positions[i] = positions[i] + vec3d(1.0, 2.0, 3.0)


def values_of(rng, count):
    return {
        "counts": (rng.integers(0, 99, count), int32),
        "places": (rng.random((count, 3)), vec3d),
        "fractions": (rng.random(count), float32),
        "poses": (rng.random((count, 4, 4)), mat44d),
        "rows": (rng.random((count, 5)), float64),
    }


@pytest.mark.parametrize("count", [0, 1, 3, 64, 65])
def test_arrays_come_back_as_they_were_given(device, rng, count):
    values = values_of(rng, count)
    together = SideBySide(values, device)
    result = together.download()
    assert list(result) == list(values)
    for name, (value, dtype) in values.items():
        scalar = {int32: np.int32, float32: np.float32}.get(dtype, np.float64)
        np.testing.assert_array_equal(result[name], value.astype(scalar))
        np.testing.assert_array_equal(download(together.arrays[name]).reshape(value.shape), value.astype(scalar))
        assert result[name].dtype == scalar and together.arrays[name].dtype == dtype
    assert list(together.download("rows", "counts")) == ["rows", "counts"]


def test_a_launch_changes_its_arrays_and_no_neighbor(device, rng):
    values = values_of(rng, 7)
    together = SideBySide(values, device)
    launch(raise_kernel, 7, [together.arrays["counts"], together.arrays["places"]])
    fill(together.arrays["fractions"], 2.0)
    result = together.download()
    np.testing.assert_array_equal(result["counts"], values["counts"][0] + 1)
    np.testing.assert_array_equal(result["places"], values["places"][0] + [1.0, 2.0, 3.0])
    np.testing.assert_array_equal(result["fractions"], np.full(7, 2.0, np.float32))
    for name in ("poses", "rows"):
        np.testing.assert_array_equal(result[name], values[name][0])


def test_arrays_that_are_not_rewritten_get_their_last_values_again(device, rng):
    values, others = values_of(rng, 7), values_of(rng, 7)
    together = SideBySide(values, device)
    together.rewrite({"places": others["places"]})
    launch(raise_kernel, 7, [together.arrays["counts"], together.arrays["places"]])
    together.rewrite({"counts": others["counts"]})
    result = together.download()
    for name in values:
        expected = (others if name in ("places", "counts") else values)[name][0]
        np.testing.assert_array_equal(result[name], expected.astype(result[name].dtype))


def test_an_array_outlives_its_container(device):
    left = SideBySide({"a": (np.arange(5), int32), "b": (np.arange(9.0), float64)}, device).arrays["b"]
    np.testing.assert_array_equal(download(left), np.arange(9.0))


@pytest.mark.parametrize("count", [0, 1, 77])
def test_each_has_its_type_its_shape_and_its_numbers(device, rng, count):
    matrix = upload(rng.normal(size=(max(count, 2), 6)), float64, device)
    arrays = [
        upload(rng.integers(0, 99, count), int32, device),
        upload(rng.normal(size=(count, 3)), vec3, device),
        matrix,
        matrix[:, 1],  # with gaps
        upload(rng.integers(0, 2, count), uint8, device),
    ]
    for read, values in zip(read_together(arrays), arrays, strict=True):
        alone = download(values)
        assert (read.dtype, read.shape) == (alone.dtype, alone.shape)
        np.testing.assert_array_equal(read, alone)
