"""Marching cubes: the surface of scikit-image, closed for every field, bitwise reproducible."""

import numpy as np
import pytest
import warp as wp
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from scipy.spatial import cKDTree

from pointloom import TriangleMesh, marching_cubes

SHAPES = [(2, 3, 2), (5, 4, 31), (3, 7, 32), (6, 3, 33), (5, 2, 65)]


def wavy_ball(n: int) -> np.ndarray:
    x = np.linspace(-1, 1, n, dtype=np.float32)
    x, y, z = np.meshgrid(x, x, x, indexing="ij", sparse=True)
    waves = np.float32(0.05) * np.sin(9 * x) * np.sin(8 * y) * np.sin(7 * z)
    return (np.sqrt(x * x + y * y + z * z) - np.float32(0.7) + waves).astype(np.float32)


def noise(shape, seed=0) -> np.ndarray:
    return np.random.default_rng(seed).normal(size=shape).astype(np.float32)


def bordered(field: np.ndarray) -> np.ndarray:
    return np.pad(field, 1, constant_values=1.0)


def assert_closed(mesh: TriangleMesh) -> None:
    t, m = mesh.triangles.astype(np.int64), len(mesh.vertices)
    a, b = t.ravel(), np.roll(t, -1, axis=1).ravel()
    assert len(np.unique(a * m + b)) == len(a)
    np.testing.assert_array_equal(np.sort(a * m + b), np.sort(b * m + a))


def test_a_smooth_surface_has_the_vertices_and_triangles_of_scikit_image(device):
    measure = pytest.importorskip("skimage.measure")
    field = wavy_ball(96)
    mesh = marching_cubes(field, device=device)
    vertices, triangles, _, _ = measure.marching_cubes(field, 0.0)
    assert len(mesh) == len(triangles) > 40_000
    assert len(mesh.vertices) == len(vertices)
    for queries, theirs in ((mesh.vertices, vertices), (vertices, mesh.vertices)):
        assert cKDTree(theirs).query(queries)[0].max() < 1e-4  # [samples] float32 at indices up to 255


@pytest.mark.parametrize("shape", SHAPES)
def test_noise_of_any_shape_is_closed_if_its_border_is_outside(device, shape):
    for seed in range(4):
        mesh = marching_cubes(bordered(noise(shape, seed)), device=device)
        assert_closed(mesh)
        assert mesh.is_watertight()
        assert np.linalg.det(mesh.vertices[mesh.triangles]).sum() > 0  # outwards


@pytest.mark.parametrize("shape", SHAPES)
def test_vertices_are_the_edge_crossings_in_field_order(device, shape):
    field, level = noise(shape, 7), 0.25
    mesh = marching_cubes(field, level, device=device)
    expected = []
    for axis in range(3):
        a, b = (np.delete(field, s, axis=axis).astype(np.float64) for s in (-1, 0))
        index = np.argwhere((a < level) != (b < level))
        positions = index.astype(np.float64)
        positions[:, axis] += ((level - a) / (b - a))[tuple(index.T)]
        expected.append(np.column_stack([index, np.full(len(index), axis), positions]))
    rows = np.concatenate(expected)
    rows = rows[np.lexsort(rows[:, 3::-1].T)]
    np.testing.assert_allclose(mesh.vertices, rows[:, 4:], atol=1e-5)
    assert set(mesh.triangles.ravel().tolist()) == set(range(len(rows)))


@settings(deadline=None, max_examples=40)
@given(
    field=hnp.arrays(
        np.float32,
        hnp.array_shapes(min_dims=3, max_dims=3, min_side=2, max_side=6),
        elements=st.sampled_from([-1.0, -0.25, 0.0, 0.5, 1.0]),
    )
)
def test_fields_that_touch_the_level_are_closed_as_well(field):
    mesh = marching_cubes(bordered(field))
    assert_closed(mesh)
    assert np.isfinite(mesh.vertices).all()


@pytest.mark.parametrize("value", [-1.0, 0.0, np.nan])
def test_a_constant_field_gives_an_empty_mesh(device, value):
    mesh = marching_cubes(np.full((3, 4, 33), value, np.float32), device=device)
    assert (len(mesh), mesh.vertices.shape, mesh.triangles.shape) == (0, (0, 3), (0, 3))


@pytest.mark.parametrize(("shape", "bad"), [((4, 5, 6), np.nan), ((5, 4, 70), np.inf), ((4, 5, 6), -np.inf)])
def test_only_cells_around_non_finite_values_are_excluded(device, shape, bad):
    rng = np.random.default_rng(3)
    field = noise(shape, 3)
    holes = rng.random(shape) < 0.06
    field[holes] = bad
    mesh = marching_cubes(field, device=device)
    assert np.isfinite(mesh.vertices).all()
    assert set(mesh.triangles.ravel().tolist()) == set(range(len(mesh.vertices)))

    filled = marching_cubes(np.where(holes, 0.5, field), device=device)
    cells = np.floor(filled.vertices[filled.triangles].mean(axis=1)).astype(int)
    open_cells = np.ones(np.array(shape) - 1, bool)
    for x, y, z in np.argwhere(holes):
        open_cells[max(x - 1, 0) : x + 1, max(y - 1, 0) : y + 1, max(z - 1, 0) : z + 1] = False
    remaining = filled.triangles[open_cells[tuple(cells.T)]]
    np.testing.assert_array_equal(mesh.vertices[mesh.triangles], filled.vertices[remaining])


def test_a_sample_at_the_level_counts_as_above_it(device):
    field = np.zeros((2, 2, 3), np.float32)
    assert len(marching_cubes(field, device=device)) == 0
    field[:, :, 0] = -1
    mesh = marching_cubes(field, device=device)
    assert len(mesh) == 2
    np.testing.assert_array_equal(mesh.vertices[:, 2], 1.0)


@pytest.mark.parametrize("huge", [1e30, 3.4e38])
def test_values_near_the_end_of_float32_are_interpolated_without_overflow(device, huge):
    field = np.full((2, 2, 2), huge, np.float32)
    field[:, :, 0] = -huge
    mesh = marching_cubes(field, device=device)
    np.testing.assert_array_equal(mesh.vertices[:, 2], 0.5)


@pytest.mark.parametrize("step", [1e-30, 1e30])
def test_spacing_of_any_size_scales_the_surface(device, step):
    field = wavy_ball(20)
    unit, scaled = marching_cubes(field, device=device), marching_cubes(field, spacing=[step] * 3, device=device)
    np.testing.assert_array_equal(unit.triangles, scaled.triangles)
    np.testing.assert_allclose(scaled.vertices / step, unit.vertices, atol=2e-6 * 20)


def test_spacing_and_origin_apply_to_each_axis(device):
    field = noise((6, 7, 8))
    unit = marching_cubes(field, device=device)
    scaled = marching_cubes(field, spacing=(0.5, 2.0, 4.0), origin=(1, -2, 3), device=device)
    np.testing.assert_allclose(scaled.vertices, unit.vertices * (0.5, 2.0, 4.0) + (1, -2, 3), atol=1e-5)


def test_a_grid_far_from_zero_keeps_its_precision(device):
    field, far = wavy_ball(24), np.array([5.0e5, 5.4e6, 100.0])
    near, away = (marching_cubes(field, spacing=[0.01] * 3, origin=o, device=device) for o in ((0, 0, 0), far))
    assert away.origin.any()
    np.testing.assert_allclose(away.vertices - far, near.vertices, atol=1e-7)


def test_the_type_and_order_of_the_field_do_not_matter(device):
    field = np.round(noise((5, 6, 7)) * 4)
    expected = marching_cubes(field, 0.5, device=device)
    strided = np.empty((10, 6, 7), np.float32)[::2]
    strided[:] = field
    read_only = field.copy()
    read_only.flags.writeable = False
    others = [field.astype(kind) for kind in (np.float64, np.int32, ">f4")]
    for other in (*others, np.asfortranarray(field), strided, read_only, field.tolist()):
        mesh = marching_cubes(other, 0.5, device=device)
        np.testing.assert_array_equal(mesh.vertices, expected.vertices)
        np.testing.assert_array_equal(mesh.triangles, expected.triangles)


def test_device_arrays_are_used_on_their_device(device):
    field = noise((5, 6, 7))
    expected = marching_cubes(field, device=device)
    for dtype in (wp.float32, wp.float64):
        values = wp.array(field.astype(wp.dtype_to_numpy(dtype)), dtype=dtype, device=device)
        mesh = marching_cubes(values)
        assert str(mesh.device) == str(device)
        np.testing.assert_array_equal(mesh.vertices, expected.vertices)
