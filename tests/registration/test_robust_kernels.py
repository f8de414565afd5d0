"""Robust weights against Open3D's and Barron's formulas, on device and host."""

import itertools
import math

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.devices import resolve_device
from pointloom.kernels.icp.robust_weights import Loss, robust_weight
from pointloom.kernels.lang import array, float64, kernel, launch, tid
from pointloom.kernels.memory import empty, upload

reg = loom.registration
SCALES = (1e-3, 0.3, 1.0, 40.0)
NAMED = ("HuberLoss", "CauchyLoss", "GMLoss", "TukeyLoss")
SHAPES = (2.0, 1.999, 1.5, 1.0, 0.5, 1e-3, 0.0, -1e-3, -1.0, -2.0, -1000.0, -1e8, -math.inf)


@kernel
def weigh_kernel(residuals: array(dtype=float64), loss: Loss, weights: array(dtype=float64)):
    i = tid()
    weights[i] = robust_weight(loss, residuals[i])


def residuals():
    sizes = np.concatenate([[0.0], np.geomspace(1e-12, 1e3, 200), SCALES])
    return np.concatenate([sizes, -sizes])


LOSSES = {
    repr(loss): loss
    for loss in (
        reg.L2Loss(), reg.L1Loss(), *(getattr(reg, name)(k) for name in NAMED for k in SCALES),
        *(reg.GeneralizedLoss(k, shape) for k in SCALES for shape in SHAPES),
    )
}  # fmt: skip


def barron(r, c, alpha):
    """The general kernel's rho'(r) / r (Barron 2019, equation 9), with its special cases as limits."""
    x = (r / c) ** 2
    if alpha == 2:
        return np.ones_like(r) / c**2
    if alpha == 0:
        return 2 / (r**2 + 2 * c**2)
    if alpha == -math.inf:
        return np.exp(-x / 2) / c**2
    return (x / abs(alpha - 2) + 1) ** (alpha / 2 - 1) / c**2


def weights_of(o3d, r):
    """Open3D's weights of residuals for each kernel."""
    theirs = o3d.pipelines.registration
    made = {name: getattr(theirs, name)() for name in ("L2Loss", "L1Loss")}
    made |= {f"{name} {k}": getattr(theirs, name)(k) for name in NAMED for k in SCALES}
    return {name: np.array([loss.weight(x) for x in r]) for name, loss in made.items()}


def test_weights_match_open3d(oracle, tolerances):
    r = residuals()[::7]
    r = r[np.abs(r) > 2e-9]  # 1 / |r| is limited at 1e-9
    for case, expected in oracle("registration/robust_kernels", weights_of, r).items():
        name, *k = case.split()
        loss = getattr(reg, name)(*map(float, k))
        np.testing.assert_allclose(loss.weight(r), expected, rtol=tolerances.weight, err_msg=case)


def test_the_general_weights_match_barron(tolerances):
    r = residuals()
    for k, shape in itertools.product(SCALES, (2.0, 1.0, 0.5, 0.0, -2.0, -1e3, -math.inf)):
        result = reg.GeneralizedLoss(k, shape).weight(r)
        np.testing.assert_allclose(result, barron(r, k, shape), rtol=tolerances.weight, err_msg=f"{k}, {shape}")


@pytest.mark.parametrize(
    ("limit", "near", "step"), [(0.0, 1e-6, 1e-5), (0.0, -1e-6, 1e-5), (2.0, 2 - 2.1e-3, 1e-2), (-math.inf, -9e6, 1e-5)]
)
def test_the_general_weights_are_continuous(limit, near, step):
    """The largest step is at 2: shapes within 2e-3 are treated as 2, as in Open3D."""
    r = np.linspace(0, 4, 60)
    at_limit, beside = reg.GeneralizedLoss(1.0, limit).weight(r), reg.GeneralizedLoss(1.0, near).weight(r)
    np.testing.assert_allclose(beside, at_limit, rtol=step)


def test_device_weights_match_the_host(device, tolerances):
    where, r = resolve_device(device), residuals()
    weights, given = empty(len(r), float64, where), upload(r, float64, where)
    for name, loss in LOSSES.items():
        launch(weigh_kernel, len(r), [given, Loss(*loss.parameters), weights])
        expected = loss.weight(r)
        assert np.isfinite(expected).all() and (expected >= 0).all(), name
        np.testing.assert_allclose(weights.numpy(), expected, rtol=tolerances.weight, atol=1e-300, err_msg=name)


def test_weights_keep_the_shape_of_residuals():
    assert reg.HuberLoss(1).weight(np.zeros((2, 3))).shape == (2, 3)
    assert float(reg.TukeyLoss(2).weight(3)) == 0 and reg.L2Loss().weight([1, 2]).dtype == np.float64


def test_kernels_of_one_scale_are_equal():
    assert reg.HuberLoss(0.5) == reg.HuberLoss(0.5) != reg.HuberLoss(0.4)
    assert reg.HuberLoss(0.5) != reg.CauchyLoss(0.5) and len({reg.TukeyLoss(1), reg.TukeyLoss(1)}) == 1
