"""Products of matrices are sums of products in their order, the same bits everywhere."""

import numpy as np
import pytest

from pointloom.kernels import lang
from pointloom.kernels.memory import download, empty, upload

SOURCE = """
    from pointloom.kernels.algebra.matrices import multiply{size}

    @kernel
    def multiply_kernel(a: array(dtype=mat{size}d), b: array(dtype=mat{size}d), product: array(dtype=mat{size}d)):
        i = tid()
        product[i] = multiply{size}(a[i], b[i])
"""


@pytest.mark.parametrize("size", [3, 4])
def test_a_product_rounds_after_each_step(write_kernels, rng, device, size):
    kernels = write_kernels(f"products_{size}", SOURCE.format(size=11 * size))
    kind = getattr(lang, f"mat{11 * size}d")
    a, b = rng.normal(size=(2, 3000, size, size))
    product = empty(len(a), kind, device)
    lang.launch(kernels.multiply_kernel, len(a), [upload(a, kind, device), upload(b, kind, device), product])
    expected = a[:, :, 0, None] * b[:, 0, None, :]
    for k in range(1, size):
        expected = expected + a[:, :, k, None] * b[:, k, None, :]
    np.testing.assert_array_equal(download(product).reshape(expected.shape), expected)
