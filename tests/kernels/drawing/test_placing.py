"""Lines along normals."""

import numpy as np

from pointloom.kernels.drawing.placing import make_normal_lines_kernel
from pointloom.kernels.lang import int32, launch, vec3
from pointloom.kernels.memory import download, empty, upload


def test_lines_along_normals_have_one_length_and_none_where_the_normal_has_none(device, rng):
    points, normals = rng.normal(size=(2, 20, 3)).astype(np.float32)
    normals[3] = 0
    ends, lines = empty(40, vec3, device), empty(40, int32, device)
    given = [upload(points, vec3, device), upload(normals, vec3, device), 0.5, ends, lines]
    launch(make_normal_lines_kernel, 20, given)
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    tips = points + 0.5 * normals / np.where(lengths > 0, lengths, 1)
    np.testing.assert_allclose(download(ends), np.stack([points, tips], axis=1).reshape(-1, 3), rtol=0, atol=1e-6)
    np.testing.assert_array_equal(download(lines), np.arange(40))
