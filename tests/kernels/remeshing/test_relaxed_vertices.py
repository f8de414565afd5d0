"""Vertices move only as far as no triangle flips."""

import numpy as np

from pointloom.kernels.lang import uint8, vec3, vec3i
from pointloom.kernels.memory import download, upload, zeros
from pointloom.kernels.remeshing.creased_mesh import CreasedMesh
from pointloom.kernels.remeshing.relaxed_vertices import move_without_flips

SQUARE = np.array([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [1, 1, 0], [5, 5, 0], [6, 5, 0], [7, 5, 0]], float)
FANS = np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [5, 6, 7]])


def test_vertices_of_triangles_that_would_flip_stay(device):
    """The last triangle has no area, so nothing can turn there."""
    for step, stays in ((0.5, False), (1.5, True)):
        faces, count = upload(FANS, vec3i, device), len(SQUARE)
        creases, corners = zeros(3 * len(FANS), uint8, device), zeros(count, uint8, device)
        mesh = CreasedMesh(upload(SQUARE, vec3, device), faces, creases, corners)
        moved = SQUARE.copy()
        moved[4:6, 0] += step
        move_without_flips(mesh, upload(moved, vec3, device))
        expected = moved.copy()
        if stays:
            expected[4] = SQUARE[4]
        np.testing.assert_array_equal(download(mesh.vertices), expected.astype(np.float32))
