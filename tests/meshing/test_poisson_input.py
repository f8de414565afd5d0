"""create_from_point_cloud_poisson with few, degenerate and invalid points and arguments."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels import memory

from .poisson_scenes import assert_only_the_cube_cuts, poisson, sphere


def assert_sane(mesh, densities, points, scale=1.1):
    assert np.isfinite(mesh.vertices).all() and np.isfinite(densities).all() and densities.min() >= 0
    np.testing.assert_allclose(np.linalg.norm(mesh.vertex_normals, axis=1), 1, atol=1e-6)
    assert len(mesh) > 0 and mesh.triangles.min() == 0 and mesh.triangles.max() == len(mesh.vertices) - 1
    assert_only_the_cube_cuts(mesh, points, scale)


@pytest.mark.parametrize("count", [2, 10])
def test_a_few_points_give_a_surface(device, count):
    points = sphere(count)
    assert_sane(*poisson(points, depth=6, device=device), points)


@pytest.mark.parametrize("depth", [2, 3])
def test_the_coarsest_trees_give_a_closed_ball(device, depth):
    points = sphere(300)
    mesh, densities = poisson(points, depth=depth, device=device)
    assert_sane(mesh, densities, points)
    assert mesh.is_watertight() and mesh.get_volume() > 2


def test_the_deepest_tree_ends_at_single_points(device):
    points = sphere(200)
    (mesh, densities), (other, _) = (poisson(points, depth=d, device=device) for d in (20, 12))
    assert_sane(mesh, densities, points)
    assert densities.max() < 4 and len(mesh) < 1.2 * len(other) + 100


def test_two_close_positions_refine_the_tree_to_full_depth(device):
    points = np.concatenate([sphere(40), sphere(40) * 1e-5])
    mesh, densities = poisson(points, np.concatenate([sphere(40)] * 2), depth=16, device=device)
    assert_sane(mesh, densities, points)
    assert densities.max() > 14


@pytest.mark.parametrize("normal", [(0, 0, 1), (1, 0, 0)])
def test_points_on_a_line_give_a_surface(device, normal):
    points = np.linspace(0, 1, 100)[:, None] * [1.0, 0, 0]
    assert_sane(*poisson(points, np.tile(normal, (100, 1)), device=device), points)


def test_a_flat_sheet_stays_flat_and_ends_at_the_cube(device):
    points = np.random.default_rng(0).random((2000, 3)) * [1, 1, 0]
    mesh, densities = poisson(points, np.tile([0, 0, 1.0], (2000, 1)), device=device)
    assert_sane(mesh, densities, points)
    inner = (np.abs(mesh.vertices[:, :2] - 0.5) < 0.49).all(axis=1)
    assert inner.sum() > 500 and np.abs(mesh.vertices[inner, 2]).max() < 0.003
    assert (mesh.vertex_normals[inner, 2] > 0.99).all()


def test_a_tight_cube_cuts_the_surface_at_its_sides(device):
    points = sphere(800)
    assert_sane(*poisson(points, scale=1.0, device=device), points, 1.0)


@pytest.mark.parametrize("allowed", [0, 2_000_000])
def test_a_too_large_tree_is_rejected_with_its_size(device, monkeypatch, allowed):
    """The samples first, then levels from about the seventh on; nothing of the rejected level is allocated."""
    points, requests = sphere(2000), []
    poisson(points, device=device)
    room = memory.check_room

    def check(target_device, size, what):
        requests.append((size, what))
        room(target_device, size, what)

    for module in ("poisson", "octree_levels"):
        monkeypatch.setattr(f"pointloom.kernels.reconstruction.{module}.check_room", check)
    monkeypatch.setattr(memory, "free_bytes", lambda target_device: allowed)
    with pytest.raises(MemoryError, match=r"would take about .* GB, and .* has .* GB free; take a smaller depth"):
        poisson(points, depth=8, device=device)
    *fitting, (size, what) = requests
    assert size > allowed >= max([needed for needed, _ in fitting], default=0)
    assert what.startswith("the cells of 2,000 points" if allowed < 180_000 else "level ")


def box(low, high, device="cpu"):
    grid = np.array([[i & 1, i >> 1 & 1, i >> 2 & 1] for i in range(8)])
    corners = np.where(grid == 1, high, low).astype(float)
    quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    return loom.TriangleMesh(corners, [t for a, b, c, d in quads for t in ([a, b, c], [a, c, d])], device=device)


def half_sphere(device, offset=0.0):
    points = sphere(4000)
    points = points[points[:, 2] > 0]
    return loom.PointCloud(points + offset, normals=points, device=device)


@pytest.mark.parametrize("offset", [0.0, np.array([5e5, 5.4e6, 100.0])])
def test_an_open_scan_stays_within_its_envelope(device, offset):
    cloud = half_sphere(device, offset)
    envelope = box(np.array([-1.15, -1.15, -0.1]) + offset, np.array([1.15, 1.15, 1.15]) + offset, device)
    free, _ = loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 6, scale=1.5)
    bounded, _ = loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 6, scale=1.5, envelope=envelope)
    cell = 1.5 * 2 / 2**5
    lowest = (free.vertices - offset)[:, 2].min(), (bounded.vertices - offset)[:, 2].min()
    assert lowest[0] < -0.4 and -0.1 - cell < lowest[1]
    assert bounded.is_watertight() and not free.is_watertight()


def test_an_inverted_envelope_gives_the_same_result(device):
    cloud = half_sphere(device)
    envelope = box([-1.15, -1.15, -0.1], [1.15, 1.15, 1.15], device)
    flipped = loom.TriangleMesh(envelope.vertices, envelope.triangles[:, ::-1], device=device)
    meshes = [loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 5, envelope=e)[0] for e in (envelope, flipped)]
    assert np.array_equal(meshes[0].vertices, meshes[1].vertices)


def test_open_invalid_or_too_fine_envelopes_are_rejected():
    cloud = half_sphere("cpu")
    with pytest.raises(ValueError, match="envelope:"):
        opened = box([-2] * 3, [2] * 3)
        opened = loom.TriangleMesh(opened.vertices, opened.triangles[1:])
        loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 4, envelope=opened)
    with pytest.raises(TypeError, match="envelope:"):
        loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 4, envelope="box")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="envelope:"):
        fine = loom.TriangleMesh(np.zeros((3, 3)), np.zeros((10_001, 3), int))
        loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 4, envelope=fine)


def test_opposite_normals_cause_a_warning(device):
    points = sphere(1000)
    signs = np.where(np.random.default_rng(0).random(1000) < 0.5, 1.0, -1.0)[:, None]
    cloud = loom.PointCloud(points, normals=points * signs, device=device)
    with pytest.warns(loom.NormalsWarning, match="orient_normals_consistent_tangent_plane") as caught:
        loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 4)
    assert caught[0].filename == __file__, "it points at the user's line"
    alike = cloud.orient_normals_consistent_tangent_plane(12)
    loom.TriangleMesh.create_from_point_cloud_poisson(alike, 4)  # no warning
