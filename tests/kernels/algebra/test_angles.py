"""Angles by square roots and a polynomial: right to rounding over the whole half turn."""

import numpy as np

from pointloom.kernels.algebra.angles import angle_of
from pointloom.kernels.lang import array, float64, kernel, launch, tid
from pointloom.kernels.memory import empty, upload


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
