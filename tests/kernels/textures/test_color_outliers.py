"""Views in which a triangle has another color than in most, against NumPy in float64."""

import numpy as np

from pointloom.kernels.lang import float64, int32, vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.textures import color_outliers as outliers
from pointloom.kernels.textures.face_views import FaceViews


def likely(colors):
    """The mask of one triangle's colors, and the number of Gaussians fitted until convergence."""
    if len(colors) < outliers.MIN_VIEWS:
        return np.ones(len(colors), bool), 0
    gaps = np.linalg.norm(colors[:, None] - colors, axis=2)
    middle = gaps[gaps.sum(axis=1).argmin()]
    keep = middle <= max(outliers.NEAR * np.sort(middle)[(len(colors) - 1) // 2], outliers.MIN_DISTANCE)
    for iteration in range(outliers.MAX_ITERATIONS):
        if keep.sum() < outliers.MIN_VIEWS:
            return np.ones(len(colors), bool), iteration
        off = colors - colors[keep].mean(axis=0)
        inverse = np.linalg.inv(np.cov(colors[keep].T, bias=True) + outliers.NOISE_VARIANCE * np.eye(3))
        before, keep = keep, np.einsum("ni,ij,nj->n", off, inverse, off) <= outliers.UNLIKELY
        if (keep == before).all():
            break
    return keep, iteration


def test_likely_views_belong_to_a_gaussian_fitted_until_convergence(device, rng):
    faces = [np.zeros((0, 3)), rng.random((3, 3)), rng.random((4, 3))]
    for count in rng.integers(4, 20, 60):
        spread = rng.choice([0.01, 0.05], count)[:, None]
        far = (rng.random(count) < 0.25)[:, None] * rng.uniform(0, 0.6, (count, 1))
        faces.append(rng.uniform(0.2, 0.6, 3) + spread * rng.normal(size=(count, 3)) + far)
    faces.append(np.vstack([np.zeros((2, 3)), np.eye(3)]))  # only the two equal ones are near: all stay
    faces = [face.astype(np.float32) for face in faces]
    starts = np.cumsum([0, *map(len, faces)])
    count = int(starts[-1])
    numbers = np.zeros(count)
    arrays = (upload(starts, int32, device), upload(numbers, int32, device), upload(numbers, float64, device))
    mask = download(outliers.keep_likely(FaceViews(*arrays, upload(np.vstack(faces), vec3, device))))
    expected = [likely(face.astype(float)) for face in faces]
    np.testing.assert_array_equal(mask, np.concatenate([keep for keep, _ in expected]))
    assert max(iterations for _, iterations in expected) > 0 and 0.5 < mask[: -len(faces[-1])].mean() < 0.99
    assert mask[-len(faces[-1]) :].all()
