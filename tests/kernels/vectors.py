"""Vectors on a device, and rotations."""

import numpy as np

from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import upload


def vectors(device, values):
    return upload(np.asarray(values, np.float32).reshape(-1, 3), vec3, device)


def rotation(rng):
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q
