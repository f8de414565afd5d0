"""Voxels of a mesh: Open3D's set, a brute-force solid; marching cubes: closed for every field."""

import numpy as np
import pytest
import warp as wp
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from scipy.spatial import cKDTree

from pointloom import TriangleMesh
from pointloom.meshing import marching_cubes

from .open3d_meshes import in_open3d
from .surface_oracles import winding_numbers


def open3d_voxels(o3d, mesh: TriangleMesh, size: float, bounds=None) -> np.ndarray:
    legacy, make = in_open3d(o3d, mesh), o3d.geometry.VoxelGrid
    if bounds is None:
        grid = make.create_from_triangle_mesh(legacy, size)
    else:
        grid = make.create_from_triangle_mesh_within_bounds(legacy, size, *bounds)
    cells = np.array([voxel.grid_index for voxel in grid.get_voxels()], np.int16).reshape(-1, 3)
    return cells[np.lexsort(cells.T)]


def as_set(grid) -> set[tuple[int, ...]]:
    return set(map(tuple, grid.coordinates.tolist()))


def soup(seed: int, count: int = 60) -> TriangleMesh:
    """Triangles of all sizes, some of them flat, in a box of edge 2."""
    rng = np.random.default_rng(seed)
    corners = rng.uniform(-1, 1, (count, 1, 3)) + rng.normal(size=(count, 3, 3)) * rng.uniform(0, 0.6, (count, 1, 1))
    corners[::7, 2] = corners[::7, 1]  # no area
    corners[::11, 1:] = corners[::11, :1]  # a point
    corners[::5, :, 1] = corners[::5, :1, 1]  # along an axis
    return TriangleMesh(np.clip(corners, -1, 1).reshape(-1, 3), np.arange(3 * count).reshape(-1, 3))


def assert_touched_as_in_open3d(oracle, name, mesh: TriangleMesh, size: float, bounds=None) -> None:
    """Within the bounds the voxels are Open3D's, plus voxels that triangles only touch from outside."""
    grid = mesh.voxelize(size, *(bounds or ()))
    theirs = oracle(f"meshing/voxels/{name}", open3d_voxels, mesh, size, bounds)
    theirs = set(map(tuple, theirs[((theirs >= 0) & (theirs < grid.counts)).all(axis=1)].tolist()))
    assert theirs <= as_set(grid)
    for cell in as_set(grid) - theirs:
        gap = gap_to(mesh, grid.origin + (np.array(cell) + 0.5) * size, size)
        assert abs(gap) <= 1e-8 * size  # a billionth of a voxel, and the rounding of this measure


def gap_to(mesh: TriangleMesh, center: np.ndarray, size: float) -> float:
    """The gap between a voxel and the nearest triangle along the best separating axis; negative if they overlap."""
    corners = mesh.vertices[mesh.triangles] - center
    edges = np.roll(corners, -1, axis=1) - corners
    crosses = np.cross(edges[:, :, None], np.eye(3)[None, None]).reshape(len(corners), 9, 3)
    normals = np.cross(edges[:, 0], edges[:, 1])[:, None]
    axes = np.concatenate([np.broadcast_to(np.eye(3), (len(corners), 3, 3)), crosses, normals], axis=1)
    lengths = np.linalg.norm(axes, axis=2, keepdims=True)
    axes = np.divide(axes, lengths, out=np.zeros_like(axes), where=lengths > 0)
    along = np.einsum("tak,tck->tac", axes, corners)
    radius = size / 2 * np.abs(axes).sum(axis=2)
    gaps = np.maximum(along.min(axis=2) - radius, -along.max(axis=2) - radius)
    gaps[lengths[:, :, 0] == 0] = -np.inf
    return float(gaps.max(axis=1).min())


SCENES = {
    "torus": (lambda device: TriangleMesh.create_torus(device=device), 0.17),
    "box": (lambda device: TriangleMesh.create_box(device=device), 0.25),
    "arrow": (lambda device: TriangleMesh.create_arrow(device=device), 0.4),
    "soup": (lambda device: soup(1).to(device), 0.11),
    "one triangle": (lambda device: TriangleMesh([[0, 0, 0], [3, 1, 2], [1, 2, 0]], [[0, 1, 2]], device=device), 0.3),
    "a point": (lambda device: TriangleMesh([[1, 2, 3]], [[0, 0, 0]], device=device), 0.5),
}


def test_a_stack_of_plates_has_all_voxels_for_any_initial_capacity(device):
    edge, count = 12, 60  # stacked: far more columns than a surface of as many triangles has in this grid
    corners = np.array([[0.25, 0.25, 0], [edge - 0.25, 0.25, 0], [edge - 0.25, edge - 0.25, 0], [0.25, edge - 0.25, 0]])
    heights = np.linspace(0.25, 1.75, count)
    plates = (corners + heights[:, None, None] * [0, 0, 1]).reshape(-1, 3)
    triangles = (np.array([[0, 1, 2], [0, 2, 3]]) + 4 * np.arange(count)[:, None, None]).reshape(-1, 3)
    voxels = TriangleMesh(plates, triangles, device=device).voxelize(1, np.zeros(3), [edge, edge, 2])
    assert as_set(voxels) == {(x, y, z) for x in range(edge) for y in range(edge) for z in range(2)}


@pytest.mark.parametrize("name", SCENES)
def test_touched_voxels_match_open3d(device, oracle, name):
    make, size = SCENES[name]
    mesh = make(device)
    assert_touched_as_in_open3d(oracle, name.replace(" ", "_"), mesh, size)
    grid = mesh.voxelize(size)
    np.testing.assert_allclose(grid.origin, mesh.vertices.min(axis=0) - size / 2, atol=1e-12)
    order = np.lexsort(grid.coordinates.T[::-1])
    np.testing.assert_array_equal(order, np.arange(len(grid)))
    assert (grid.coordinates < grid.counts).all()


@pytest.mark.parametrize("seed", range(5))
def test_touched_voxels_match_open3d_for_any_triangles_and_bounds(oracle, seed):
    rng, mesh = np.random.default_rng(seed), soup(seed, 12)
    size, bounds = rng.uniform(0.15, 0.8), np.sort(rng.uniform(-1.2, 1.2, (2, 3)), axis=0)
    assert_touched_as_in_open3d(oracle, f"bounds_{seed}", mesh, size, tuple(bounds))
    grid = mesh.voxelize(size, *bounds)
    assert (grid.coordinates < grid.counts).all()
    assert grid.counts == tuple(int(n) for n in np.floor((bounds[1] - bounds[0]) / size + 0.5))


def test_voxels_touched_from_outside_are_included():
    square = TriangleMesh([[0, 0, 1], [2, 0, 1], [0, 2, 1]], [[0, 1, 2]])
    grid = square.voxelize(1, [0, 0, 0], [3, 3, 3])
    assert {cell[2] for cell in as_set(grid)} == {0, 1}  # the plane between them; in Open3D it is in one


@pytest.mark.parametrize(
    ("make", "size"),
    [
        (lambda: TriangleMesh.create_torus(radial_resolution=12, tubular_resolution=9), 0.19),
        (lambda: TriangleMesh.create_sphere(resolution=6), 0.23),
        (lambda: TriangleMesh.create_box(), 0.25),  # every plane of the grid's centers contains an edge or a corner
        (lambda: TriangleMesh.create_octahedron(), 0.125),
        (lambda: TriangleMesh.create_cone(resolution=5), 0.2),
    ],
)
def test_a_solid_is_its_surface_and_the_inner_centers(device, make, size):
    mesh = make().to("cpu" if device is None else device)
    surface, solid = mesh.voxelize(size), mesh.voxelize(size, solid=True)
    cells = np.argwhere(np.ones(solid.counts, bool))
    inside = winding_numbers(solid.origin + (cells + 0.5) * size, mesh.vertices[mesh.triangles]) > 0.5
    expected = as_set(surface) | set(map(tuple, cells[inside].tolist()))
    assert as_set(solid) == expected
    flipped = TriangleMesh(mesh.vertices, mesh.triangles[:, ::-1], device=device)
    np.testing.assert_array_equal(flipped.voxelize(size, solid=True).coordinates, solid.coordinates)


def test_the_space_between_two_shells_is_inside():
    outer, inner = TriangleMesh.create_sphere(1.0, 12), TriangleMesh.create_sphere(0.5, 12)
    triangles = np.vstack([outer.triangles, inner.triangles + len(outer.vertices)])
    both = TriangleMesh(np.vstack([outer.vertices, inner.vertices]), triangles)
    grid = both.voxelize(0.08, solid=True)
    queries = [[0, 0, 0], [0.75, 0, 0], [0, 0.74, 0], [1.2, 0, 0], [np.nan, 0, 0]]
    assert grid.check_if_included(queries).tolist() == [False, True, True, False, False]


def test_bounds_within_a_solid_are_filled():
    grid = TriangleMesh.create_box(10, 10, 10).voxelize(1, [3, 3, 3], [6, 7, 8], solid=True)
    assert grid.dense().all() and grid.counts == (3, 4, 5)
    half = TriangleMesh.create_box(10, 10, 10).voxelize(1, [3, 3, 8], [6, 7, 14], solid=True)
    assert (half.dense().sum(axis=2) == 3).all()  # two inside and the one that the top touches from below


def test_a_dense_grid_equals_the_sparse_one():
    grid = soup(5).voxelize(0.2)
    np.testing.assert_array_equal(np.argwhere(grid.dense()), grid.coordinates)
    assert grid.dense().shape == grid.counts and grid.check_if_included(grid.centers).all()
    assert len(grid) == grid.dense().sum()


def test_an_empty_mesh_touches_nothing(device):
    for mesh in (TriangleMesh(device=device), TriangleMesh([[1, 2, 3]], device=device)):
        assert len(mesh.voxelize(0.5)) == 0 and len(mesh.voxelize(0.5).check_if_included([[0, 0, 0]])) == 1


def test_a_too_large_grid_is_rejected_before_allocation(monkeypatch):
    from pointloom.kernels import memory

    mesh, grid = TriangleMesh.create_box(), TriangleMesh.create_box().voxelize(0.01)
    monkeypatch.setattr(memory, "free_bytes", lambda device: 10_000)
    monkeypatch.setattr(memory, "MIN_CHECKED", 0)
    with pytest.raises(MemoryError, match=r"^voxel_size:"):
        mesh.voxelize(0.01)
    with pytest.raises(MemoryError, match="a dense grid of 1,030,301 voxels would take"):
        grid.dense()


def test_points_have_voxels_inside_and_outside_the_grid():
    grid = TriangleMesh.create_box().translate([5e5, 5e6, 0]).voxelize(0.25)
    cells = np.stack([grid.get_voxel(center) for center in grid.centers])
    np.testing.assert_array_equal(cells, grid.coordinates)
    assert grid.get_voxel(grid.origin - 0.1).tolist() == [-1, -1, -1]
    for bad, message in (([0, 0], "shape"), ([np.nan, 0, 0], "finite"), ([1e90, 0, 0], "beyond the range of 64-bit")):
        with pytest.raises(ValueError, match=message):
            grid.get_voxel(bad)


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
    assert len(mesh) == len(triangles) > 40_000 and len(mesh.vertices) == len(vertices)
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


BOXES = hnp.array_shapes(min_dims=3, max_dims=3, min_side=2, max_side=6)


@settings(deadline=None, max_examples=40)
@given(field=hnp.arrays(np.float32, BOXES, elements=st.sampled_from([-1.0, -0.25, 0.0, 0.5, 1.0])))
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


@pytest.mark.parametrize(
    ("spacing", "origin"), [([1e-30] * 3, (0, 0, 0)), ([1e30] * 3, (0, 0, 0)), ((0.5, 2.0, 4.0), (1, -2, 3))]
)
def test_spacing_of_any_size_and_origin_apply_to_each_axis(device, spacing, origin):
    field = wavy_ball(20)
    unit = marching_cubes(field, device=device)
    scaled = marching_cubes(field, spacing=spacing, origin=origin, device=device)
    np.testing.assert_array_equal(unit.triangles, scaled.triangles)
    np.testing.assert_allclose((scaled.vertices - origin) / spacing, unit.vertices, atol=2e-6 * 20)


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
    for dtype in (wp.float32, wp.float64):
        on_device = wp.array(field.astype(wp.dtype_to_numpy(dtype)), dtype=dtype, device=device)
        assert str(marching_cubes(on_device).device) == device
        others.append(on_device)
    for other in (*others, np.asfortranarray(field), strided, read_only, field.tolist()):
        mesh = marching_cubes(other, 0.5, device=device)
        np.testing.assert_array_equal(mesh.vertices, expected.vertices)
        np.testing.assert_array_equal(mesh.triangles, expected.triangles)
