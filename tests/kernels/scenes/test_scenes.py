"""Solids: distances and rays. The grain of surfaces and the noise of the sensor, bitwise identical to NumPy."""

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from pointloom.kernels import memory
from pointloom.kernels.algebra.camera import Camera
from pointloom.kernels.lang import array, float32, float64, int32, kernel, launch, tid, uint8, vec3, vec3d, vec4d
from pointloom.kernels.memory import download, empty, upload
from pointloom.kernels.scenes.color_noise import measure_colors
from pointloom.kernels.scenes.primitives import BOX_KIND, CYLINDER_KIND, Solids, distance_to_solids, meet_solid
from pointloom.kernels.scenes.value_noise import grain_pixels, value_noise


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
    if kind == CYLINDER_KIND:
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
    extents[kinds == CYLINDER_KIND, 1] = 0
    extents[0], kinds[0] = (0, 0, 0, 0.4), BOX_KIND  # a sphere
    extents[1], kinds[1] = (0, 0, 0.5, 0.2), CYLINDER_KIND  # a capsule
    extents[2], kinds[2] = (0.3, 0.2, 0.1, 0), BOX_KIND  # sharp edges
    return kinds, Rotation.random(count, rng).as_matrix(), rng.uniform(-2, 2, (count, 3)), extents


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
    solids = Solids([BOX_KIND], np.eye(3)[None], np.zeros((1, 3)), [[0, 0, 0, 1.0]], device)
    assert measure(np.empty((0, 3)), solids, device).shape == (0,)
    assert measure([[3.0, 0, 0]], solids, device).tolist() == [2.0]


def meet(device, kind, extent, origins, directions):
    """The ray parameters at which rays meet one solid at the origin."""
    parameters = memory.empty(len(origins), float64, device)
    rays = [memory.upload(np.asarray(values, np.float64), vec3d, device) for values in (origins, directions)]
    solid = [memory.upload(np.array([extent]), vec4d, device), memory.upload(np.array([kind]), int32, device)]
    launch(meet_kernel, len(origins), [*rays, *solid, parameters])
    return parameters.numpy()


SHAPES = [(BOX_KIND, (0.4, 0.3, 0.2, 0.0)), (BOX_KIND, (0.3, 0.2, 0.1, 0.1)), (BOX_KIND, (0.0, 0.0, 0.0, 0.5))]
SHAPES += [
    (CYLINDER_KIND, (0.3, 0.0, 0.4, 0.0)),
    (CYLINDER_KIND, (0.2, 0.0, 0.3, 0.1)),
    (CYLINDER_KIND, (0.0, 0.0, 0.3, 0.2)),
]


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
    for fraction in np.linspace(0, 0.999, 50):  # nothing was met before
        assert reference(origins[hit] + fraction * t[hit, None] * directions[hit]).min() > -1e-9
    for s in np.linspace(0, 6, 200):
        assert reference(origins[~hit] + s * directions[~hit]).min() > -2e-6


def test_a_ray_along_an_axis_meets_a_face_exactly(device):
    assert meet(device, BOX_KIND, (0.5, 0.5, 0.5, 0.0), [[0.1, 0.2, -3.0]], [[0.0, 0.0, 1.0]]).tolist() == [2.5]
    assert np.isinf(meet(device, BOX_KIND, (0.5, 0.5, 0.5, 0.0), [[0.1, 0.2, -3.0]], [[0.0, 0.0, -1.0]])).all()


CAMERA = Camera(37, 23, 40.0, 41.5, 17.3, 11.9)
POSE = np.array([[0.36, 0.48, -0.8, 1.5], [-0.8, 0.6, 0.0, -0.75], [0.48, 0.64, 0.6, 2.25], [0, 0, 0, 1]])


@kernel
def noise_kernel(seed: int, points: array(dtype=vec3), values: array(dtype=float32)):
    i = tid()
    values[i] = value_noise(points[i], seed)


def reference_noise(points, seed):
    """Value noise in float32, one operation after the other, written over whole arrays."""
    base = np.floor(points)
    t = points - base
    t = t * t * (np.float32(3) - np.float32(2) * t)
    nodes = base.astype(np.int64)
    values = np.empty((2, 2, 2, len(points)), np.float32)
    for z, y, x in np.ndindex(2, 2, 2):
        k = nodes + np.array([x, y, z])
        h = (k[:, 0] * 73856093 ^ k[:, 1] * 19349663 ^ k[:, 2] * 83492791 ^ seed * 2654435761) & 0xFFFFFFFF
        h = (h ^ h >> 15) * 2246822519 & 0xFFFFFFFF
        h = (h ^ h >> 13) * 3266489917 & 0xFFFFFFFF
        values[z, y, x] = ((h ^ h >> 16) & 0xFFFF).astype(np.float32) / np.float32(65535)
    for axis in range(3):
        values = values[..., 0, :] * (1 - t[:, axis]) + values[..., 1, :] * t[:, axis]
    return values


def reference_grain(camera, T, depth, colors, seed=1):
    v, u = np.mgrid[: camera.height, : camera.width].reshape(2, -1)
    rays = np.stack([(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, np.ones(u.shape)], axis=1)
    q = rays * depth.astype(np.float64)[:, None]
    rotated = [(T[r, 0] * q[:, 0] + T[r, 1] * q[:, 1]) + T[r, 2] * q[:, 2] for r in range(3)]
    p = (T[:3, 3] + np.stack(rotated, axis=1)).astype(np.float32)
    octaves = [
        np.float32(weight) * reference_noise(p / np.float32(size), seed + k)
        for k, (size, weight) in enumerate([(0.12, 0.45), (0.04, 0.33), (0.015, 0.22)])
    ]
    factor = np.float32(0.45) + np.float32(1.1) * (octaves[0] + octaves[1] + octaves[2])
    factor = np.where(depth > 0, factor, np.float32(1))
    light = colors.reshape(-1, 3).astype(np.float32) / np.float32(255) * factor[:, None]
    return (np.clip(light, 0, 1) * np.float32(255) + np.float32(0.5)).astype(np.uint8).reshape(-1)


@pytest.mark.parametrize("seed", [0, 1, -3, 2**31 - 1])
def test_noise_is_bitwise_identical_to_numpy(device, seed):
    rng = np.random.default_rng(5)
    points = np.concatenate([rng.uniform(-400, 400, (3000, 3)), rng.integers(-9, 9, (200, 3))]).astype(np.float32)
    values = empty(len(points), float32, device)
    launch(noise_kernel, len(points), [seed, upload(points, vec3, device), values])
    assert np.array_equal(download(values), reference_noise(points, seed))


def test_an_image_has_the_grain_of_its_surface_points(device):
    rng = np.random.default_rng(3)
    count = CAMERA.width * CAMERA.height
    depth = rng.uniform(0.5, 4, count).astype(np.float32)
    depth[::17] = 0
    colors = rng.integers(0, 256, 3 * count).astype(np.uint8)
    arrays = upload(depth, float32, device), upload(colors, uint8, device)
    made = np.array(download(grain_pixels(CAMERA, POSE, *arrays)))
    assert np.array_equal(made, reference_grain(CAMERA, POSE, depth, colors))
    assert np.array_equal(made.reshape(-1, 3)[::17], colors.reshape(-1, 3)[::17]) and (made != colors).mean() > 0.8


def test_sensor_noise_is_normal_with_the_given_deviation(device):
    colors = upload(np.full(60_000, 128, np.uint8), uint8, device)
    noise = np.array(download(measure_colors(colors, sigma=8.0, seed=1, frame=0))).astype(float) - 128
    assert abs(noise.mean()) < 0.1 and abs(noise.std() - 8.0) < 0.1
    for limit in (4, 8, 16, 20):  # values are rounded: what was below the limit and a half
        assert abs((np.abs(noise) <= limit).mean() - math.erf((limit + 0.5) / 8 / math.sqrt(2))) < 0.006
    assert abs(np.corrcoef(noise[::3], noise[1::3])[0, 1]) < 0.02


def test_sensor_noise_is_bitwise_identical_on_all_devices_and_stays_in_range(device):
    colors = upload(np.array([0, 0, 0, 255, 255, 255, 100, 100], np.uint8), uint8, device)
    made = [
        np.array(download(measure_colors(colors, sigma=sigma, seed=seed, frame=frame))).tolist()
        for sigma, seed, frame in [(2.0, 0, 0), (2.0, 0, 0), (2.0, 1, 0), (2.0, 0, 1), (0.0, 0, 0), (200.0, 0, 0)]
    ]
    assert made[0] == made[1] == [3, 4, 0, 255, 255, 253, 100, 101]
    assert made[0] != made[2] and made[0] != made[3] and made[4] == [0, 0, 0, 255, 255, 255, 100, 100]
    assert 0 in made[5] or 255 in made[5]
