"""Solids: their distance against plain NumPy, and rays that stop exactly on them."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from pointloom.kernels import memory
from pointloom.kernels.lang import array, float64, int32, kernel, launch, tid, vec3d, vec4d
from pointloom.kernels.scenes.primitives import BOX, CYLINDER, Solids, distance_to_solids, meet_solid


@kernel
def meet_kernel(
    origins: array(dtype=vec3d), directions: array(dtype=vec3d), extents: array(dtype=vec4d),
    kinds: array(dtype=int32), parameters: array(dtype=float64),
):  # fmt: skip
    i = tid()
    parameters[i] = meet_solid(origins[i], directions[i], extents[0], kinds[0], float64(100.0))


def reference_distance(points, kind, rotation, center, extent):
    """Signed distances in float64, written without the kernels' case distinctions."""
    q = (points - center) @ rotation.T
    if kind == CYLINDER:
        q = np.column_stack([np.hypot(q[:, 0], q[:, 1]), q[:, 2]])
        half = np.array([extent[0], extent[2]])
    else:
        half = np.array(extent[:3])
    a = np.abs(q) - half
    return np.linalg.norm(np.maximum(a, 0), axis=1) + np.minimum(a.max(axis=1), 0) - extent[3]


def random_scene(seed=0, count=12):
    rng = np.random.default_rng(seed)
    kinds = rng.integers(0, 2, count)
    extents = rng.uniform(0.05, 0.6, (count, 4))
    extents[kinds == CYLINDER, 1] = 0
    extents[0], kinds[0] = (0, 0, 0, 0.4), BOX  # a sphere
    extents[1], kinds[1] = (0, 0, 0.5, 0.2), CYLINDER  # a capsule
    extents[2], kinds[2] = (0.3, 0.2, 0.1, 0), BOX  # sharp edges
    return kinds, Rotation.random(count, rng=rng).as_matrix(), rng.uniform(-2, 2, (count, 3)), extents


def measure(points, solids, device):
    return distance_to_solids(memory.upload(np.asarray(points), vec3d, device), solids).numpy()


def test_distances_are_those_of_plain_numpy(device):
    scene = random_scene()
    points = np.random.default_rng(1).uniform(-3, 3, (3001, 3))
    expected = np.min([reference_distance(points, *solid) for solid in zip(*scene, strict=True)], axis=0)
    assert np.abs(measure(points, Solids(*scene, device), device) - expected).max() < 1e-12


def test_points_that_are_not_finite_have_no_distance(device):
    solids = Solids(*random_scene(), device)
    distances = measure([[np.nan, 0, 0], [0, np.inf, 0], [9, 0, 0]], solids, device)
    assert np.isnan(distances[:2]).all() and distances[2] > 0


def test_no_points_and_one_point(device):
    solids = Solids([BOX], np.eye(3)[None], np.zeros((1, 3)), [[0, 0, 0, 1.0]], device)
    assert measure(np.empty((0, 3)), solids, device).shape == (0,)
    assert measure([[3.0, 0, 0]], solids, device).tolist() == [2.0]


def meet(device, kind, extent, origins, directions):
    """The ray parameters at which rays meet one solid at the origin."""
    parameters = memory.empty(len(origins), float64, device)
    rays = [memory.upload(np.asarray(values, np.float64), vec3d, device) for values in (origins, directions)]
    solid = [memory.upload(np.array([extent]), vec4d, device), memory.upload(np.array([kind]), int32, device)]
    launch(meet_kernel, len(origins), [*rays, *solid, parameters])
    return parameters.numpy()


SHAPES = [(BOX, (0.4, 0.3, 0.2, 0.0)), (BOX, (0.3, 0.2, 0.1, 0.1)), (BOX, (0.0, 0.0, 0.0, 0.5))]
SHAPES += [(CYLINDER, (0.3, 0.0, 0.4, 0.0)), (CYLINDER, (0.2, 0.0, 0.3, 0.1)), (CYLINDER, (0.0, 0.0, 0.3, 0.2))]


@pytest.mark.parametrize(("kind", "extent"), SHAPES)
def test_rays_stop_on_the_surface_and_misses_pass_it_by(device, kind, extent):
    rng = np.random.default_rng(2)
    origins = rng.normal(size=(2000, 3))
    origins *= 3 / np.linalg.norm(origins, axis=1, keepdims=True)
    directions = rng.uniform(-0.7, 0.7, (2000, 3)) - origins
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    t = meet(device, kind, extent, origins, directions)
    hit = np.isfinite(t)
    assert 0.1 < hit.mean() < 0.95

    def reference(points):
        return reference_distance(points, kind, np.eye(3), np.zeros(3), extent)

    assert np.abs(reference(origins[hit] + t[hit, None] * directions[hit])).max() < 2e-6
    for share in np.linspace(0, 0.999, 50):  # nothing was met before
        assert reference(origins[hit] + share * t[hit, None] * directions[hit]).min() > -1e-9
    for s in np.linspace(0, 6, 200):
        assert reference(origins[~hit] + s * directions[~hit]).min() > -2e-6


def test_a_ray_along_an_axis_meets_a_face_exactly(device):
    assert meet(device, BOX, (0.5, 0.5, 0.5, 0.0), [[0.1, 0.2, -3.0]], [[0.0, 0.0, 1.0]]).tolist() == [2.5]
    assert np.isinf(meet(device, BOX, (0.5, 0.5, 0.5, 0.0), [[0.1, 0.2, -3.0]], [[0.0, 0.0, -1.0]])).all()


@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 10_000))
def test_the_distance_never_changes_faster_than_the_point_moves(seed):
    solids = Solids(*random_scene(seed), "cpu")
    rng = np.random.default_rng(seed)
    a, b = rng.uniform(-3, 3, (2, 200, 3))
    change = np.abs(measure(a, solids, "cpu") - measure(b, solids, "cpu"))
    assert (change <= np.linalg.norm(a - b, axis=1) + 1e-12).all()
