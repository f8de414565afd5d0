"""Transformed points, angles and moments: correct to rounding in all ranges of their arguments."""

import numpy as np
import pytest

from pointloom.kernels.algebra.angles import angle_of
from pointloom.kernels.algebra.moments import MAX_EXACT_POINTS, steps_for
from pointloom.kernels.algebra.transform import transform_directions, transform_points
from pointloom.kernels.lang import array, float32, float64, int32, kernel, launch, tid
from pointloom.kernels.memory import download, empty, upload

from ..vectors import vectors


def test_large_terms_that_cancel_leave_the_small_difference(device):
    """R p + t with both near 5e6: float32 arithmetic would leave half a metre of noise."""
    points = np.array([[5e6, 0, 0]], np.float32)
    result = transform_points(vectors(device, points), np.eye(3), [-4999999.875, 0, 0]).numpy()
    assert result.tolist() == [[0.125, 0, 0]]


def test_directions_keep_their_lengths_under_any_map(device, rng, tolerances):
    lengths = np.array([1.0, 0.25, 3.0, 1e-10, 1e10, 1.0])[:, None]
    n = rng.normal(size=(6, 3))
    n = (n / np.linalg.norm(n, axis=1, keepdims=True) * lengths).astype(np.float32)
    A = rng.normal(size=(3, 3)) * 100
    result = transform_directions(vectors(device, n), A).numpy().astype(np.float64)
    expected = n.astype(np.float64) @ A.T
    scale = np.linalg.norm(n.astype(np.float64), axis=1, keepdims=True)
    expected *= scale / np.linalg.norm(expected, axis=1, keepdims=True)
    assert (np.abs(result - expected) <= tolerances.float32_relative * scale).all()


def test_zero_and_nan_directions_stay(device):
    result = transform_directions(vectors(device, [[0, 0, 0], [np.nan, 1, 0]]), np.eye(3) * 2).numpy()
    assert result[0].tolist() == [0, 0, 0] and np.isnan(result[1]).any()


@kernel
def measure_kernel(sines: array(dtype=float64), cosines: array(dtype=float64), angles: array(dtype=float64)):
    i = tid()
    angles[i] = angle_of(sines[i], cosines[i])


def measure(device, sines, cosines):
    angles = empty(len(sines), float64, device)
    launch(measure_kernel, len(sines), [upload(sines, float64, device), upload(cosines, float64, device), angles])
    return angles.numpy()


def test_angles_are_those_of_atan2(device, rng):
    ends = np.geomspace(1e-300, 1, 200), np.pi - np.geomspace(1e-15, 1, 200)
    angles_expected = np.concatenate([np.linspace(0, np.pi, 1001), *ends])
    scales = np.exp(rng.uniform(-100, 100, len(angles_expected)))
    sines, cosines = scales * np.abs(np.sin(angles_expected)), scales * np.cos(angles_expected)
    # five square roots and quotients, twelve terms and eight times the result, at 1.1e-16 each
    np.testing.assert_allclose(measure(device, sines, cosines), np.arctan2(sines, cosines), rtol=2e-15, atol=0)


def test_directions_without_a_length_make_no_angle(device):
    angles = measure(device, np.array([0.0, 0.0, 0.0, 2.0]), np.array([0.0, 3.0, -3.0, 0.0]))
    np.testing.assert_allclose(angles, [0, 0, np.pi, np.pi / 2], rtol=2e-15, atol=0)


@kernel
def measure_steps_kernel(sqdist: float, counts: array(dtype=int32), steps: array(dtype=float32)):
    i = tid()
    steps[i] = steps_for(sqdist, counts[i])


@pytest.mark.parametrize("sqdist", [1e-6, 1.0, 3.99, 4.0, 1e8])
def test_products_of_any_number_of_differences_fit_into_64_bits(device, sqdist):
    counts = np.array([1, MAX_EXACT_POINTS, MAX_EXACT_POINTS + 1, 2**31 - 1])
    steps = empty(len(counts), float32, device)
    launch(measure_steps_kernel, len(counts), [sqdist, upload(counts, int32, device), steps])
    result = download(steps).astype(float)
    assert (counts * (np.sqrt(sqdist) * result + 0.5) ** 2 < 2.0**63).all()
    assert result[0] == result[1] > result[2] == result[3] and np.sqrt(sqdist) * result[2] >= 2**14
