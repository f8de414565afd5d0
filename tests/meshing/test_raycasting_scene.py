"""RaycastingScene: Embree's hits, float64 brute force, watertight rays, poses, large coordinates, invalid rays."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from pointloom import RaycastingScene
from pointloom.kernels.lang import cpu_compiler
from pointloom.meshing import marching_cubes

from ..registration.poses import as_pose
from .open3d_meshes import raycasting_scene

FAR = np.array([5.0e5, 5.4e6, 100.0])
SQUARE = ([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
OCTAHEDRON = (
    np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], np.float64),
    [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]],
)
INVALID = RaycastingScene.INVALID_ID


def scene_of(*meshes, device=None) -> RaycastingScene:
    scene = RaycastingScene(device)
    for vertices, triangles in meshes:
        scene.add_triangles(vertices, triangles)
    return scene


def open3d_hits(o3d, mesh, rays):
    """Embree's first hits, all hits, hit counts, and occlusion within limits."""
    scene = raycasting_scene(o3d, mesh)
    rays = o3d.core.Tensor(np.ascontiguousarray(rays, np.float32))
    casts = scene.cast_rays, scene.list_intersections
    first, listed = ({n: v.numpy() for n, v in cast(rays).items()} for cast in casts)
    hidden = [scene.test_occlusions(rays, **limits).numpy() for limits in LIMITS]
    return first, listed, scene.count_intersections(rays).numpy().astype(np.int32), hidden


LIMITS = ({}, {"tnear": 1.0}, {"tfar": 1.0}, {"tnear": 0.6, "tfar": 0.9})


def ball(cells: int = 16):
    """A closed mesh with vertices off any grid."""
    x = np.linspace(-1, 1, cells)
    x, y, z = np.meshgrid(x, x, x, indexing="ij")
    mesh = marching_cubes(np.sqrt(x * x + 1.1 * y * y + 0.9 * z * z) - 0.7, spacing=[2 / (cells - 1)] * 3)
    return mesh.vertices - 1.0, mesh.triangles


def rays_through(count: int, seed: int = 0) -> np.ndarray:
    """Rays from outside the ball to positions in its box."""
    rng = np.random.default_rng(seed)
    origins = rng.normal(size=(count, 3))
    origins *= 2 / np.linalg.norm(origins, axis=1, keepdims=True)
    targets = rng.uniform(-0.9, 0.9, (count, 3))
    return np.hstack([origins, targets - origins]).astype(np.float32)


def brute_force(vertices, triangles, rays) -> np.ndarray:
    """The ray parameter of each ray and triangle in float64 [n, t]; infinite for a miss."""
    a, b, c = np.asarray(vertices, np.float32).astype(np.float64)[np.asarray(triangles)].transpose(1, 0, 2)
    o, d = (np.asarray(rays, np.float64)[:, None, k : k + 3] for k in (0, 3))
    with np.errstate(divide="ignore", invalid="ignore"):
        p = np.cross(d, c - a)
        det = (p * (b - a)).sum(-1)
        u = (p * (o - a)).sum(-1) / det
        q = np.cross(o - a, b - a)
        v = (q * d).sum(-1) / det
        t = (q * (c - a)).sum(-1) / det
        return np.where((u >= 0) & (v >= 0) & (u + v <= 1) & (t >= 0), t, np.inf)


def test_hits_counts_lists_and_occlusions_match_embree(device, oracle):
    mesh, rays = ball(), rays_through(700)
    scene = scene_of(mesh, device=device)
    wanted, wanted_list, counts, hidden = oracle("meshing/raycasting/hits", open3d_hits, mesh, rays)
    result = scene.cast_rays(rays)
    kinds, wanted_kinds = ({name: (v.shape, v.dtype) for name, v in each.items()} for each in (result, wanted))
    assert kinds == wanted_kinds and 0.3 < np.isfinite(result["t_hit"]).mean() < 0.95
    np.testing.assert_array_equal(np.isfinite(result["t_hit"]), np.isfinite(wanted["t_hit"]))
    np.testing.assert_allclose(result["t_hit"], wanted["t_hit"], rtol=5e-6)  # Embree's depths are float32
    # Beside an edge, float32 rounding puts the ray on different sides.
    same = result["primitive_ids"] == wanted["primitive_ids"]
    assert same.mean() > 0.998
    np.testing.assert_array_equal(result["geometry_ids"], wanted["geometry_ids"])
    # a sliver's weights and normal are ill-conditioned in float32
    np.testing.assert_allclose(result["primitive_uvs"][same], wanted["primitive_uvs"][same], atol=2e-3)
    cosines = (result["primitive_normals"][same] * wanted["primitive_normals"][same]).sum(1)
    assert np.median(cosines[np.isfinite(result["t_hit"][same])]) > 0.999999
    np.testing.assert_array_equal(scene.count_intersections(rays), counts)
    listed = scene.list_intersections(rays)
    for name in ("ray_splits", "ray_ids", "geometry_ids"):
        np.testing.assert_array_equal(listed[name], wanted_list[name])
    np.testing.assert_allclose(listed["t_hit"], wanted_list["t_hit"], rtol=5e-6)  # as above
    assert (listed["primitive_ids"] == wanted_list["primitive_ids"]).mean() > 0.998
    for limits, wanted in zip(LIMITS, hidden, strict=True):
        np.testing.assert_array_equal(scene.test_occlusions(rays, **limits), wanted)
    is_hit = np.isfinite(result["t_hit"])
    u, v = result["primitive_uvs"][is_hit].T.astype(np.float64)
    corners = mesh[0][np.asarray(mesh[1])[result["primitive_ids"][is_hit]]]
    on_ray = rays[is_hit, :3].astype(np.float64) + rays[is_hit, 3:] * result["t_hit"][is_hit, None]
    by_weights = np.einsum("kn,nkc->nc", [1 - u - v, u, v], corners)
    np.testing.assert_allclose(by_weights, on_ray, atol=2e-6)  # float32 up to 2


K, T = np.array([[100, 3, 2.0], [0, 110, 1.5], [0, 0, 1]]), as_pose([0.3, 0.2, 0.1], [0.1, 0.2, 0.3])
VIEW = (60, [0.1, 0.2, 0.3], [1, 2, 3.0], [0.1, 1, 0], 8, 6)


def open3d_cameras(o3d):
    make, tensor = o3d.t.geometry.RaycastingScene.create_rays_pinhole, o3d.core.Tensor
    return make(*VIEW).numpy(), make(tensor(K), tensor(T), 4, 3).numpy()


def test_cameras_match_open3d(oracle):
    looking, posed = oracle("meshing/raycasting/cameras", open3d_cameras)
    np.testing.assert_allclose(RaycastingScene.create_rays_pinhole(*VIEW), looking, atol=1e-6)  # float32
    given = {"intrinsic_matrix": K, "extrinsic_matrix": T, "width_px": 4, "height_px": 3}
    rays = RaycastingScene.create_rays_pinhole(**given)
    np.testing.assert_allclose(rays, posed, atol=1e-6)  # float32
    # through the middle of pixel (2, 1), at depth 1
    middle = T[:3, :3] @ (rays[1, 2, :3] + rays[1, 2, 3:]) + T[:3, 3]
    np.testing.assert_allclose(K @ middle, [2.5, 1.5, 1], atol=1e-5)


@pytest.mark.parametrize("edges", [False, True])
def test_hits_do_not_depend_on_adjacent_rays(device, edges):
    """On the CPU, eight rays of the same octant are cast together."""
    vertices, triangles = ball(10)
    scene = scene_of((vertices, triangles), device=device)
    rays = RaycastingScene.create_rays_pinhole(50, [0, 0, 0], [0.2, -0.3, 3], [0, 1, 0], 37, 29).reshape(-1, 6)
    if edges:  # targets shared by several triangles
        targets = (vertices[triangles[:, 0]] + vertices[triangles[:, 1]]) / 2
        rays = np.hstack([np.broadcast_to([0.2, -0.3, 3], targets.shape), targets - [0.2, -0.3, 3]])
    order = np.random.default_rng(5).permutation(len(rays))
    together, apart = scene.cast_rays(rays), scene.cast_rays(rays[order])
    assert np.isfinite(together["t_hit"]).mean() > 0.1
    for name, values in together.items():
        np.testing.assert_array_equal(values[order], apart[name], err_msg=name)


@settings(deadline=None, max_examples=25)
@given(
    st.lists(st.tuples(*[st.integers(0, 9)] * 3), min_size=1, max_size=12),
    st.lists(st.tuples(*[st.integers(-2, 2)] * 6), min_size=1, max_size=8),
)
@example([(3, 4, 9)], [(-1, -1, 0, -1, 0, 1), (-1, -1, 0, -1, -1, 0)])  # from a position on the triangle
def test_integer_coordinates_are_hit_exactly(triangles, rays):
    """Corners and rays on a grid, so that rays often hit edges and corners; the direction steps are exact."""
    vertices = np.random.default_rng(3).integers(-2, 3, (10, 3))
    steps = np.array(rays)
    steps[:, 3:] = np.sign(steps[:, 3:])  # divisions by 1
    every = brute_force(vertices, triangles, steps)
    with cpu_compiler("warp"):
        scene = scene_of((vertices, triangles))
        result = scene.cast_rays(steps)
        counts = scene.count_intersections(steps)
    wanted = every.astype(np.float32)
    np.testing.assert_allclose(result["t_hit"], wanted.min(axis=1), rtol=1e-6, atol=1e-15)  # thirds in the weights
    for row, t in enumerate(wanted):
        close = np.unique(np.round(t[np.isfinite(t)].astype(np.float64), 5))  # of one t, once
        assert counts[row] == len(close)
        if len(close):
            first = np.flatnonzero(np.abs(t - t.min()) < 1e-6)  # ties go to the smallest number
            assert result["primitive_ids"][row] == first[0]


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_rays_cannot_pass_edges_and_corners_of_a_closed_mesh(device, scale):
    vertices, triangles = ball(10)
    vertices = (vertices * scale).astype(np.float32)
    corners = vertices[np.asarray(triangles)]
    targets = np.concatenate([vertices, (corners[:, 0] + corners[:, 1]) / 2, 0.3 * corners[:, 1] + 0.7 * corners[:, 2]])
    origin = np.array([0.013, -0.021, 0.034], np.float32) * np.float32(scale)  # inside
    rays = np.hstack([np.broadcast_to(origin, targets.shape), targets - origin])
    result = scene_of((vertices, triangles), device=device).cast_rays(rays)
    np.testing.assert_allclose(result["t_hit"], 1, rtol=1e-4)  # the next triangle may lean toward the ray


def test_edges_and_corners_are_crossed_once(device):
    scene = scene_of(OCTAHEDRON, device=device)
    rays = [
        [0, 0, 3, 0, 0, -1],  # two corners of four triangles
        [0.25, 0, 3, 0, 0, -1],  # two edges
        [0.25, 0.25, 3, 0, 0, -1],  # two faces
        [0.5, 0.5, 3, 0, 0, -1],  # touches an edge
        [3, 0, 0, -1, 0, 0],
        [1, 0, 3, 0, 0, -1],  # touches a corner
    ]
    assert scene.count_intersections(rays).tolist() == [2, 2, 2, 1, 2, 1]
    result = scene.list_intersections(rays)
    assert result["primitive_ids"][:4].tolist() == [0, 4, 0, 4]
    assert result["t_hit"].tolist() == [2, 4, 2.25, 3.75, 2.5, 3.5, 3, 2, 4, 3]
    assert set(result["primitive_uvs"][[2, 3, 6]].ravel().tolist()) <= {0, 0.25, 0.5, 0.75}  # as for integers


def test_of_equal_triangles_the_smallest_index_is_hit(device):
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    scene = scene_of((corners, [[0, 2, 1]] * 40), (corners, [[0, 1, 2]]), device=device)
    rays = [[0.2, 0.3, 1, 0, 0, -1]]
    result = scene.cast_rays(rays)
    assert (result["geometry_ids"].tolist(), result["primitive_ids"].tolist()) == ([0], [0])
    assert result["primitive_normals"].tolist() == [[0, 0, -1]]
    listed = scene.list_intersections(rays)
    assert (listed["geometry_ids"].tolist(), listed["primitive_ids"].tolist()) == ([0, 1], [0, 0])


def test_shared_corners_report_the_smallest_index_regardless_of_tree_order(device):
    """The second half rises toward the ray, so its boxes are entered first."""
    angles = np.linspace(np.pi / 2, 5 * np.pi / 2, 32, endpoint=False)
    rim = np.stack([np.cos(angles), np.sin(angles), np.where(np.cos(angles) > 1e-9, 2.0, 0.0)], axis=1)
    fan = [[0, 1 + k, 1 + (k + 1) % 32] for k in range(32)]
    scene = scene_of(([[0, 0, 0], *rim], fan), device=device)
    result = scene.list_intersections([[0, 0, 5, 0, 0, -1]])
    assert (result["t_hit"].tolist(), result["primitive_ids"].tolist()) == ([5], [0])


def test_instances_of_a_mesh_are_transformed_copies(device):
    mesh, rng = ball(8), np.random.default_rng(4)
    poses = np.tile(np.eye(4), (30, 1, 1))
    poses[:, :3, :3] = Rotation.random(30, rng).as_matrix()
    poses[:, :3, 3] = rng.uniform(-4, 4, (30, 3))
    scene, copies = RaycastingScene(device), RaycastingScene(device)
    first = scene.add_triangles(*mesh)
    for number, pose in enumerate(poses):
        if number:
            assert scene.add_instance(first, pose) == number
        moved = mesh[0] @ pose[:3, :3].T + pose[:3, 3]
        copies.add_triangles(moved, mesh[1])
    scene.set_pose(first, poses[0])
    assert len(scene) == 30 and scene._trees[0].count == len(mesh[1]) and len(scene._trees) == 1
    rays = rays_through(1500, 5) * np.float32(3)
    result, wanted = scene.cast_rays(rays), copies.cast_rays(rays)
    np.testing.assert_array_equal(np.isfinite(result["t_hit"]), np.isfinite(wanted["t_hit"]))
    np.testing.assert_allclose(result["t_hit"], wanted["t_hit"], rtol=1e-5, atol=1e-6)  # float32 in another frame
    assert (result["geometry_ids"] == wanted["geometry_ids"]).all()
    assert len(np.unique(result["geometry_ids"])) > 15
    same = result["primitive_ids"] == wanted["primitive_ids"]
    assert same.mean() > 0.998  # beside an edge, as above
    np.testing.assert_allclose(result["primitive_normals"][same], wanted["primitive_normals"][same], atol=1e-3)
    counts = scene.count_intersections(rays)
    np.testing.assert_array_equal(counts, copies.count_intersections(rays))
    np.testing.assert_array_equal(scene.test_occlusions(rays), counts > 0)


def test_a_moved_instance_is_hit_at_its_new_pose(device):
    scene = scene_of(SQUARE, SQUARE, device=device)
    rays = [[0.25, 0.5, 1, 0, 0, -1]]
    assert scene.cast_rays(rays)["geometry_ids"].tolist() == [0]
    scene.set_pose(0, as_pose(shift=[0, 0, -3]))
    assert scene.list_intersections(rays)["t_hit"].tolist() == [1, 4]
    assert scene.list_intersections(rays)["geometry_ids"].tolist() == [1, 0]


def test_a_scene_far_from_zero_gives_the_same_hits(device):
    vertices, triangles = ball()
    vertices = np.round(vertices * 2**20) / 2**20  # representable in float64
    rays = rays_through(800, 8).astype(np.float64)
    rays[:, :3] = np.round(rays[:, :3] * 2**20) / 2**20
    near = scene_of((vertices, triangles), device=device).cast_rays(rays)
    moved = rays.copy()
    moved[:, :3] += FAR
    pose = as_pose(shift=FAR)
    posed = scene_of((vertices, triangles), device=device)
    posed.set_pose(0, pose)
    for name, values in posed.cast_rays(moved).items():
        np.testing.assert_array_equal(near[name], values)


def test_invalid_rays_hit_nothing(device):
    o, n, i = [0.25, 0.5, 1], np.nan, np.inf
    rays = [[*o, 0, 0, 0], [*o, 0, 0, n], [*o, 0, 0, -i], [n, 0.5, 1, 0, 0, -1], [0.25, i, 1, 0, 0, -1]]
    for scene in (scene_of(SQUARE, device=device), scene_of(SQUARE, SQUARE, device=device)):
        result = scene.cast_rays(rays)
        assert np.isposinf(result["t_hit"]).all()
        assert (result["geometry_ids"] == INVALID).all() and (result["primitive_ids"] == INVALID).all()
        assert not result["primitive_normals"].any() and not result["primitive_uvs"].any()
        assert not scene.count_intersections(rays).any() and not scene.test_occlusions(rays).any()
        assert scene.list_intersections(rays)["ray_splits"].tolist() == [0] * 6


def test_a_triangle_with_a_non_finite_corner_is_never_hit(device):
    vertices, triangles = np.array(SQUARE[0], float), np.array(SQUARE[1])
    broken = np.vstack([vertices, [[np.nan, 0, 0]]]), np.vstack([[[0, 1, len(vertices)]], triangles])
    xy = np.random.default_rng(0).uniform(-0.5, 1.5, (50, 2))
    rays = np.column_stack([xy, np.ones(50), np.zeros((50, 2)), -np.ones(50)])
    with pytest.warns(UserWarning, match="triangle 0 has the vertex"):
        result = scene_of(broken, device=device).cast_rays(rays)
    expected = scene_of((vertices, triangles), device=device).cast_rays(rays)
    np.testing.assert_array_equal(result["t_hit"], expected["t_hit"])
    hits = np.isfinite(expected["t_hit"])
    assert 5 < hits.sum() < 45
    np.testing.assert_array_equal(result["primitive_ids"][hits], expected["primitive_ids"][hits] + 1)


def test_limits_are_included(device):
    scene, rays = scene_of(SQUARE, device=device), [[0.25, 0.5, 1, 0, 0, -1]]
    for limits, wanted in (((0, 1), True), ((1, 1), True), ((0, 0.99), False), ((1.01, 9), False), ((2, 1), False)):
        assert scene.test_occlusions(rays, *limits).tolist() == [wanted]


def test_scenes_without_triangles_have_no_hits(device):
    nothing = RaycastingScene(device)
    flat = scene_of(([], []), device=device)
    with pytest.warns(UserWarning, match=r"^mesh:"):
        spoilt = scene_of(([[np.nan] * 3] * 3, [[0, 1, 2]]), device=device)
    thin = scene_of(([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2], [0, 0, 1]]), device=device)
    rays = np.tile(np.array([0.5, 0, 1, 0, 0, -1], np.float32), (2, 3, 1))
    for scene in (nothing, flat, spoilt, thin):
        result = scene.cast_rays(rays)
        assert result["t_hit"].shape == (2, 3) and np.isposinf(result["t_hit"]).all()
        assert result["primitive_normals"].shape == (2, 3, 3) and result["primitive_uvs"].shape == (2, 3, 2)
        assert scene.count_intersections(rays).tolist() == [[0] * 3] * 2
        assert not scene.test_occlusions(rays).any()
        listed = scene.list_intersections(rays)
        assert (len(listed["t_hit"]), listed["ray_splits"].tolist()) == (0, [0] * 7)
    full = scene_of(([], []), SQUARE, device=device)
    assert full.cast_rays([[0.25, 0.5, 1, 0, 0, -1]])["geometry_ids"].tolist() == [1]
    for scene in (nothing, full):
        assert scene.cast_rays(np.zeros((0, 6)))["t_hit"].shape == (0,)
        assert scene.list_intersections(np.zeros((0, 6)))["ray_splits"].tolist() == [0]
