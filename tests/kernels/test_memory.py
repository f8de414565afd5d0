"""Arrays that come from NumPy and go back."""

from __future__ import annotations

import numpy as np

from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload
from pointloom.pcd.devices import resolve_device


def test_an_uploaded_array_is_a_copy(device, rng):
    values = rng.random((7, 3)).astype(np.float32)
    array = upload(values, vec3, resolve_device(device))
    kept = values.copy()
    values[:] = 0
    np.testing.assert_array_equal(download(array), kept)
