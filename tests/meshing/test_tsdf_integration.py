"""TSDFVolume: voxels, surfaces and views follow the rule in its docstring; rejected input."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

import pointloom as loom
from pointloom.cameras.images import upload_raw_depth
from pointloom.kernels.images.depth import largest_depth, metric_depth
from pointloom.kernels.lang import uint8, uint16
from pointloom.kernels.memory import upload
from pointloom.kernels.volumes.tsdf_blocks import BLOCK_SIDE, block_box, touched_blocks

from ..registration.poses import as_pose
from . import tsdf_scenes as scenes
from .poisson_scenes import edges_by_use
from .tsdf_scenes import CAMERA, FINE, RADIUS, SMALL, TRUNCATION, VOXEL, fingerprint, fuse, fused_sphere, look_at


class Reference:
    """The rule in float64 NumPy, for the blocks that each frame touches."""

    def __init__(self, voxel_size, truncation):
        self.voxel_size, self.truncation, self.blocks = voxel_size, truncation, {}

    def integrate(self, depth, camera, T, color=None):
        raw, scale, farthest, height, width = upload_raw_depth(depth, None, 3.0, None)
        metric, largest = metric_depth(raw, scale, farthest)
        keys = touched_blocks(metric, largest_depth(largest), camera, T, self.truncation, self.voxel_size)
        grid = np.moveaxis(np.mgrid[:8, :8, :8], 0, -1)
        for key, block in zip(keys.numpy().tolist(), block_box(keys.numpy()), strict=True):
            shape = (8, 8, 8)
            fresh = (np.zeros(shape), np.zeros(shape, int), np.zeros((*shape, 3)), np.ones(shape, bool))
            mean, weight, shade, clear = self.blocks.setdefault(key, fresh)
            p = (block * 8 + grid) * self.voxel_size @ np.linalg.inv(T)[:3, :3].T + np.linalg.inv(T)[:3, 3]
            z = p[..., 2]
            front = np.where(z > 0, z, 1)
            u, v = p[..., 0] / front * camera.fx + camera.cx + 0.5, p[..., 1] / front * camera.fy + camera.cy + 0.5
            clear &= (np.abs(u - np.round(u)) > 1e-3) & (np.abs(v - np.round(v)) > 1e-3) & (np.abs(z) > 1e-5)
            inside = (z > 0) & (u >= 0) & (v >= 0) & (u < width) & (v < height)
            row, column = (np.where(inside, np.floor(c), 0).astype(int) for c in (v, u))
            d = metric.numpy().reshape(height, width)[row, column].astype(np.float64)
            sdf = d - z
            clear &= np.abs(sdf + self.truncation) > 1e-5
            seen = inside & (d > 0) & (sdf >= -self.truncation)
            value = np.minimum(1, sdf / self.truncation)
            w = weight[seen]
            mean[seen] = (mean[seen] * w + value[seen]) / (w + 1)
            if color is not None:
                shade[seen] = (shade[seen] * w[:, None] + color[row, column][seen] * 257.0) / (w + 1)[:, None]
            weight[seen] = np.minimum(w + 1, 65535)

    def arrays(self):
        return [np.stack([self.blocks[key][i] for key in sorted(self.blocks)]) for i in range(4)]


def test_a_removed_frame_leaves_the_voxels_of_the_others(device, rng):
    frames = list(scenes.small_frames(rng, 6))
    partial, complete = (loom.TSDFVolume(voxel_size=0.02, device=device) for _ in range(2))
    for k, (depth, T, color) in enumerate(frames):
        for volume in (partial, complete)[k in (1, 4) :]:
            volume.integrate(depth, SMALL, np.linalg.inv(T), color=color)
    emptied = complete.copy()
    for volume, numbers in ((complete, (1, 4)), (emptied, range(6))):
        for k in numbers:
            depth, T, color = frames[k]
            raw, scale, farthest, *_ = upload_raw_depth(depth, None, 3.0, volume.device)
            pixels = upload(color.reshape(-1, 3), uint8, volume.device)
            T = np.linalg.inv(np.linalg.inv(T))
            volume.remove_device_frame(metric_depth(raw, scale, farthest)[0], SMALL, T, pixels, farthest)
    assert (partial.frame_count, complete.frame_count, emptied.frame_count) == (4, 4, 0)
    assert scenes.voxels_of(emptied)[2].max() == 0 and not len(emptied.extract_triangle_mesh(0))
    expected, result = (
        {tuple(block): rest for block, *rest in zip(*scenes.voxels_of(volume), strict=True)}
        for volume in (partial, complete)
    )
    for block, (distances, weights, colors) in result.items():
        if block not in expected:
            assert weights.max() == 0
            continue
        kept, seen = expected[block], weights > 0
        np.testing.assert_array_equal(weights, kept[1])
        np.testing.assert_allclose(distances[seen], kept[0][seen], atol=2e-6)
        assert np.abs(colors[seen].astype(float) - kept[2][seen]).max(initial=0) <= 257 / 8, "an eighth of a level"


@pytest.mark.parametrize(("voxel_size", "truncation"), [(0.02, 0.08), (0.05, 0.05), (0.03, 0.4)])
def test_voxels_follow_the_rule_in_float64(device, rng, voxel_size, truncation):
    volume = loom.TSDFVolume(voxel_size=voxel_size, truncation=truncation, device=device)
    reference = Reference(voxel_size, truncation)
    for depth, T, color in scenes.small_frames(rng, 6):
        volume.integrate(depth, SMALL, np.linalg.inv(T), color=color)
        reference.integrate(depth, SMALL, T, color)
    blocks, distances, weights, colors = scenes.voxels_of(volume)
    mean, weight, shade, clear = reference.arrays()
    assert len(blocks) == len(mean)
    assert clear.mean() > 0.97, "voxels left out for lying within 0.001 pixel of another pixel"
    np.testing.assert_array_equal(weights[clear], weight[clear])
    assert weight.max() >= 3
    assert np.abs(distances - mean)[clear].max() < 1e-5  # p in float32: 3 m x 6e-8 over the smallest truncation, 0.05 m
    assert np.abs(colors.astype(float) - shade)[clear].max() <= 3  # half a step of 1/65535 a frame


def test_weights_saturate_at_65535_and_values_continue_as_a_running_mean(device):
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, color=False, device=device)
    depth = np.full((SMALL.height, SMALL.width), 1.005)
    volume.integrate(depth, SMALL, np.eye(4))
    weights = volume.blocks.weights.numpy()
    scenes.set_voxels(volume, "weights", np.where(weights > 0, 65534, 0).astype(np.uint16))
    for expected in (65535, 65535):
        volume.integrate(depth + 0.02, SMALL, np.eye(4))
        now = volume.blocks.weights.numpy()
        assert now.max() == expected and now.dtype == np.uint16
        assert (now[weights > 0] >= 65534).all(), "no weight wraps around"
    mesh = volume.extract_triangle_mesh(weight_threshold=65534)
    assert len(mesh) > 0 and np.abs(mesh.vertices[:, 2] - 1.005).max() < 1e-4
    assert len(volume.extract_triangle_mesh(weight_threshold=65535)) == 0


@pytest.mark.parametrize("bad", [0.0, np.nan, np.inf, -np.inf, -1.0, 3.5, 3e38])
def test_invalid_pixels_are_treated_as_zero(device, rng, bad):
    depth, T, _ = next(scenes.small_frames(rng, 1))
    holes = rng.random(depth.shape) < 0.3
    volumes = []
    for value in (0.0, bad):
        frame = np.where(holes, value, depth)
        volumes.append(fuse([(frame, T)], device, camera=SMALL))
    assert fingerprint(volumes[0]) == fingerprint(volumes[1]) and volumes[0].memory_bytes == volumes[1].memory_bytes
    if not 3 < bad < np.inf:
        volumes.append(fuse([(np.where(holes, bad, depth), T)], device, camera=SMALL, depth_max=np.inf))
        assert fingerprint(volumes[2]) == fingerprint(volumes[0])


def test_scaled_integers_equal_floats_in_meters(device, rng):
    depth, T, _ = next(scenes.small_frames(rng, 1))
    raw = np.round(depth * 5000).astype(np.uint16)
    a, b, c = (loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, color=False, device=device) for _ in range(3))
    a.integrate(raw, SMALL, np.linalg.inv(T), depth_scale=5000.0)
    b.integrate(raw.astype(np.float32) / np.float32(5000), SMALL, np.linalg.inv(T))
    c.integrate(raw.astype(np.int64), SMALL, np.linalg.inv(T), depth_scale=5000.0)
    assert fingerprint(a) == fingerprint(b) == fingerprint(c) and a.block_count > 10


def test_color_is_required_for_all_frames_or_none(device, rng):
    """Color without its own weight cannot skip frames: mixing is rejected, not averaged with black."""
    depth, T, color = next(scenes.small_frames(rng, 1))
    E = np.linalg.inv(T)
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    volume.integrate(depth, SMALL, E, color=color)
    before = fingerprint(volume)
    with pytest.raises(ValueError, match="color:"):
        volume.integrate(depth, SMALL, E)
    assert fingerprint(volume) == before and volume.frame_count == 1
    plain = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    plain.integrate(depth, SMALL, E)
    colorless = loom.TSDFVolume(voxel_size=VOXEL, color=False, device=device)
    for each in (plain, colorless):
        with pytest.raises(ValueError, match="color:"):
            each.integrate(depth, SMALL, E, color=color)
    assert plain.extract_triangle_mesh(0).vertex_colors is None
    assert not plain.extract_point_cloud(0).has_colors and colorless.frame_count == 0
    assert plain.ray_cast(SMALL, E, weight_threshold=0).colors is None


def test_gray_images_and_colors_are_integrated(device):
    depth, E = np.full((SMALL.height, SMALL.width), 1.01), np.eye(4)
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    shade = np.empty((SMALL.height, SMALL.width, 3), np.uint8)
    shade[:] = (250, 120, 3)
    for _ in range(5):
        volume.integrate(depth, SMALL, E, color=shade)
    expected = np.array([250, 120, 3]) / 255
    mesh, view = volume.extract_triangle_mesh(3), volume.ray_cast(SMALL, E)
    assert np.abs(mesh.vertex_colors - expected).max() < 2e-5
    assert np.abs(view.colors[view.depth > 0] - expected).max() < 2e-5
    gray = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    gray.integrate(depth, SMALL, E, color=shade[:, :, 1])
    assert np.abs(gray.extract_triangle_mesh(0).vertex_colors - 120 / 255).max() < 2e-5


def test_a_frame_without_depth_is_counted_and_changes_nothing(device):
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    assert volume.integrate(np.zeros((SMALL.height, SMALL.width), np.uint16), SMALL, np.eye(4)) == 0
    assert (volume.frame_count, volume.block_count) == (1, 0) and len(volume.extract_triangle_mesh(0)) == 0


def test_mean_colors_are_rounded_to_nearest(device, rng):
    """Truncation would darken a surface over hundreds of frames."""
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    depth = np.full((SMALL.height, SMALL.width), 1.005)
    volume.integrate(depth, SMALL, np.eye(4), color=np.zeros((*depth.shape, 3), np.uint8))
    seen = volume.blocks.weights.numpy() == 1
    weights = np.where(seen, rng.integers(1, 200, seen.shape), 0)
    colors = np.where(seen[:, None], rng.integers(0, 65536, (len(seen), 3)), 0)
    scenes.set_voxels(volume, "weights", weights.astype(np.uint16))
    scenes.set_voxels(volume, "colors", colors.astype(np.uint16))
    volume.integrate(depth, SMALL, np.eye(4), color=np.full((*depth.shape, 3), 77, np.uint8))
    mean = (colors * weights[:, None] + 77 * 257.0) / (weights[:, None] + 1)
    again = volume.blocks.weights.numpy() == weights + 1
    assert again.sum() == seen.sum() > 1000
    error = (volume.blocks.colors.numpy() - mean)[again]
    assert np.abs(error).max() < 0.51  # half a step, and the rounding of float32 sums of up to 1.3e7


DEPTH, E = np.full((24, 32), 1.0), np.eye(4)
MIRROR, SCALED = np.diag([-1.0, 1, 1, 1]), np.diag([2.0, 2, 2, 1])
OTHER = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
COLOR = np.zeros((24, 32, 3), np.uint8)
FAR = as_pose(shift=[1e9, 0, 0])
WRONG = {
    ValueError: {
        "depth": [DEPTH[0], DEPTH[None], np.full((24, 32), 70_000)], "intrinsic": [OTHER],
        "extrinsic": [MIRROR, SCALED, FAR], "color": [COLOR[:12]], "depth_max": [0, np.nan], "depth_scale": [0],
    },
    TypeError: {
        "depth": [DEPTH.astype(complex)], "intrinsic": ["prime sense"], "extrinsic": ["pose"], "color": [COLOR / 255]
    },
}  # fmt: skip
ROWS = [(error, name, value) for error, named in WRONG.items() for name, values in named.items() for value in values]


@pytest.mark.parametrize(("error", "name", "value"), ROWS)
def test_a_rejected_frame_leaves_the_volume_unchanged(device, error, name, value):
    given = {"depth": DEPTH, "intrinsic": SMALL, "extrinsic": E, "color": COLOR} | {name: value}
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    for filled in (False, True):
        before = fingerprint(volume) if filled else b""
        state = (volume.frame_count, volume.block_count, volume.origin.tolist(), volume.memory_bytes)
        if value is not FAR or filled:  # the first camera sets the origin at any position
            with pytest.raises(error, match=rf"(^|\b){name}\b.*:"):
                volume.integrate(**given)
            assert state == (volume.frame_count, volume.block_count, volume.origin.tolist(), volume.memory_bytes)
            assert not filled or fingerprint(volume) == before
        if not filled:
            volume.integrate(DEPTH, SMALL, E, color=COLOR)


@pytest.mark.parametrize(
    ("name", "value"),
    [*(("voxel_size", value) for value in (0, 1e300, 5e-324)), ("truncation", 1e300), ("truncation", 0.019)],
)
def test_invalid_volume_sizes_are_rejected(name, value):
    with pytest.raises(ValueError, match=f"^{name}: "):
        loom.TSDFVolume(**{"voxel_size": 0.02} | {name: value})


@pytest.mark.filterwarnings("ignore:depth_scale, depth_max")  # true of 1e30 m
@settings(deadline=None, derandomize=True, max_examples=15)
@given(
    st.lists(
        st.sampled_from([0.0, -1.0, np.nan, np.inf, 1e-30, 0.3, 0.31, 1.0, 2.999, 3.0, 1e30]), min_size=4, max_size=4
    ),
    st.floats(0.01, 0.2),
)
def test_any_depth_gives_finite_voxels_within_one(values, voxel_size):
    volume = loom.TSDFVolume(voxel_size=voxel_size, color=False)
    depth = np.resize(np.array(values, np.float32), (24, 32))
    volume.integrate(depth, SMALL, E)
    _, distances, weights, _ = scenes.voxels_of(volume)
    assert (np.abs(distances) <= 1).all() and weights.max(initial=0) <= 1
    assert np.isfinite(volume.extract_triangle_mesh(0).vertices).all()
    assert uint16 == volume.blocks.weights.dtype


def test_a_rejected_far_first_frame_sets_no_origin(device):
    """Its camera would have become the origin; the next frame is near zero."""
    volume, far = loom.TSDFVolume(voxel_size=1e-7, device=device), as_pose(shift=[-1e6, 0, 0])
    with pytest.raises(ValueError, match="extrinsic:"):
        volume.integrate(DEPTH, SMALL, far)
    assert volume.origin.tolist() == [0, 0, 0] and (volume.frame_count, volume.block_count) == (0, 0)
    volume.integrate(np.zeros((24, 32)), SMALL, far)
    assert volume.origin.tolist() != [0, 0, 0] and volume.frame_count == 1


def test_an_outlier_pixel_uses_few_blocks_or_is_rejected():
    def volume_of(pixel):
        depth = np.full((48, 64), 1.0, np.float32)
        depth[20, 40] = pixel
        volume = loom.TSDFVolume(voxel_size=0.01, color=False)
        volume.integrate(depth, OTHER, np.eye(4), depth_max=np.inf)
        return volume

    plain = volume_of(1.0)
    for pixel in (1000.0, 80_000.0):
        wild = volume_of(pixel)
        assert wild.block_count <= plain.block_count + 20 and wild.memory_bytes <= 2 * plain.memory_bytes
    for pixel in (1e6, 1e30):
        with pytest.raises(ValueError, match=r"depth, extrinsic:.*0\.01"):
            volume_of(pixel)


def dense_field(volume, threshold):
    """(field, low voxel): the distances in one array, NaN where weights do not exceed the threshold."""
    blocks, distances, weights, _ = scenes.voxels_of(volume)
    low = blocks.min(axis=0)
    size = (blocks.max(axis=0) + 1 - low) * BLOCK_SIDE
    field = np.full(size, np.nan, np.float32)
    for block, d, w in zip((blocks - low) * BLOCK_SIDE, distances, weights, strict=True):
        x, y, z = (slice(k, k + 8) for k in block)
        field[x, y, z] = np.where(w > threshold, d, np.nan)
    return field, low * BLOCK_SIDE


def test_a_sphere_seen_from_all_sides_is_closed_and_round(device):
    mesh = fused_sphere(device).extract_triangle_mesh(0)
    assert np.isfinite(mesh.vertices).all()
    assert np.array_equal(np.unique(mesh.triangles), np.arange(len(mesh.vertices))), "no vertex without a triangle"
    assert len(np.unique(mesh.vertices.astype(np.float32), axis=0)) == len(mesh.vertices), "no two at one place"
    _, counts, repeated = edges_by_use(mesh.triangles)
    assert (counts == 2).all() and repeated == 0 and mesh.is_watertight()
    error = np.linalg.norm(mesh.vertices, axis=1) - RADIUS
    assert np.sqrt(np.mean(error**2)) < 0.3 * VOXEL
    normals, centers = scenes.triangle_normals(mesh)
    assert (np.einsum("ij,ij->i", normals, centers) > 0).all(), "outward, toward the cameras"
    assert mesh.get_volume() == pytest.approx(4 / 3 * np.pi * RADIUS**3, rel=0.03)


def test_a_surface_of_random_values_matches_the_dense_copy(device, rng):
    """Every case of the table, across block boundaries, with random unseen voxels."""
    volume = fused_sphere(device)
    count = volume.blocks.distances.size
    scenes.set_voxels(volume, "distances", rng.uniform(-1, 1, count).astype(np.float32))
    scenes.set_voxels(volume, "weights", rng.integers(0, 30, count).astype(np.uint16))
    mesh = volume.extract_triangle_mesh(1)
    field, low = dense_field(volume, 1)
    dense = loom.meshing.marching_cubes(field, spacing=[VOXEL] * 3, origin=low * VOXEL, device=device)
    assert len(mesh) == len(dense) > 10_000 and len(mesh.vertices) == len(dense.vertices)
    a, b = (np.sort(scenes.triangle_normals(m)[1].round(4), axis=0) for m in (mesh, dense))
    assert np.abs(a - b).max() < 2e-4 and cKDTree(dense.vertices).query(mesh.vertices)[0].max() < 2e-6


def test_a_voxel_counts_if_more_frames_than_the_threshold_observed_it(device):
    frame = (np.full((120, 160), 1.2345), np.eye(4))
    volume = fuse([frame] * 3, device)
    sizes = [len(volume.extract_triangle_mesh(t)) for t in (0, 2, 2.5, 3, 4)]
    assert sizes[0] == sizes[1] == sizes[2] > 0 and sizes[3:] == [0, 0]
    assert [len(volume.extract_point_cloud(t)) > 0 for t in (2, 3)] == [True, False]
    assert [(volume.ray_cast(CAMERA, np.eye(4), weight_threshold=t).depth > 0).any() for t in (2, 3)] == [True, False]


def test_points_are_on_the_sphere_with_outward_normals(device):
    volume = fused_sphere(device)
    cloud, mesh = volume.extract_point_cloud(0), volume.extract_triangle_mesh(0)
    radii = np.linalg.norm(cloud.points, axis=1)
    assert np.sqrt(np.mean((radii - RADIUS) ** 2)) < 0.3 * VOXEL
    assert np.abs(np.linalg.norm(cloud.normals, axis=1) - 1).max() < 1e-5
    cosines = np.einsum("ij,ij->i", cloud.normals, cloud.points / radii[:, None])
    # means of clipped distances from many sides tilt the gradient; 13.8 degrees were measured
    assert cosines.min() > 0.8 and np.quantile(cosines, 0.05) > np.cos(np.radians(15))
    points = set(map(tuple, cloud.points.astype(np.float32).tolist()))
    assert set(map(tuple, mesh.vertices.astype(np.float32).tolist())) <= points, "each vertex is a point"


def test_an_empty_volume_gives_empty_results(device):
    volume = loom.TSDFVolume(voxel_size=VOXEL, device=device)
    mesh, cloud, view = volume.extract_triangle_mesh(), volume.extract_point_cloud(), volume.ray_cast(SMALL, np.eye(4))
    assert (len(mesh), len(mesh.vertices), len(cloud)) == (0, 0, 0)
    assert view.depth.shape == (24, 32) and not view.depth.any()
    assert np.isnan(view.points).all() and np.isnan(view.normals).all()
    assert volume.truncation == 4 * VOXEL


MEDIUM = loom.PinholeCameraIntrinsic(320, 240, 262.0, 266.0, 158.4, 119.7)


def angles_between(a, b):
    return np.degrees(np.arccos(np.clip(np.einsum("...i,...i->...", a, b), -1, 1)))


def test_a_ray_cast_sphere_has_exact_depth_and_points(device):
    """From new positions. Means of distances along z are off by 0.12 voxel rms, see the mesh."""
    volume = fused_sphere(device)
    for eye in ((1.0, 0.5, 0.4), (-0.3, 1.2, 0.2), (0.7, 0.2, -0.3)):
        T = look_at(eye)
        view, truth = scenes.view_from(volume, T), scenes.sphere_depth(CAMERA, T)
        sight = scenes.rays_of(CAMERA, T)
        outward = (sight * truth[..., None] + T[:3, 3]) / RADIUS
        facing = -(outward * sight).sum(-1) / np.linalg.norm(sight, axis=-1)
        inner = (truth > 0) & (facing > 0.5)
        assert inner.sum() > 3000
        assert (view.depth[inner] > 0).all(), "no pixel passes the surface"
        error = np.abs(view.depth - truth)[inner]
        assert np.quantile(error, 0.99) < 0.5 * VOXEL and error.max() < VOXEL
        assert np.quantile(angles_between(view.normals[inner], outward[inner]), 0.9) < 13
        assert np.abs(view.points - (sight * view.depth[..., None] + T[:3, 3]))[inner].max() < 1e-5
        empty = (truth == 0) & (view.depth == 0)
        assert np.isnan(view.points[empty]).all() and np.isnan(view.normals[empty]).all()
        assert empty.sum() > 0.9 * (truth == 0).sum()


@pytest.mark.parametrize(("truncation", "tilt"), [(1, 0), (2, 75), (4, 60), (24, 75)])
def test_no_ray_passes_a_wall(device, truncation, tilt):
    """Fused from a camera at a grazing angle, where the truncation is thin, then viewed frontally."""
    angle = np.radians(tilt)
    normal, offset = np.array([0.0, 0.0, -1.0]), -0.0137
    T = look_at((1.2 * np.sin(angle), 0.02, -1.2 * np.cos(angle)))
    frame = scenes.plane_depth(FINE, T, normal, offset), T
    volume = fuse([frame], device, camera=FINE, truncation=truncation * VOXEL)
    mesh = volume.extract_triangle_mesh(0)
    centers = cKDTree(scenes.triangle_normals(mesh)[1])
    for eye in ((0.0, 0.0, -0.8), (0.02, 0.3, -0.5), (0.6 * np.sin(angle), 0, -0.6 * np.cos(angle) - 0.05)):
        V = look_at(eye)
        view, truth = scenes.view_from(volume, V, MEDIUM), scenes.plane_depth(MEDIUM, V, normal, offset)
        checked = view.depth == 0  # all misses, and a quarter of the rest
        checked[::2, ::2] = True
        checked &= truth > 0
        wall = (scenes.rays_of(MEDIUM, V) * truth[..., None] + V[:3, 3])[checked]
        covered = centers.query(wall, 8)[0][:, 7] < 1.1 * VOXEL  # four cells with triangles around it
        depth, points = view.depth[checked][covered], view.points[checked][covered]
        assert len(depth) > 1000 and (depth == 0).sum() == 0
        assert centers.query(points)[0].max() < 1.2 * VOXEL, "hits lie on the mesh"


def test_no_ray_passes_a_plate_of_two_voxels(device):
    """Seen from both sides: its inside is so thin that a long step would pass it."""
    poses = [look_at((0.7, 0.1, -0.9)), look_at((0.6, -0.1, 0.9)), look_at((-0.7, 0, -0.9)), look_at((-0.7, 0.05, 0.9))]
    sides = [-0.021 if T[2, 3] < 0 else 0.021 for T in poses]
    frames = [(scenes.plane_depth(FINE, T, np.array([0, 0, 1.0]), z), T) for T, z in zip(poses, sides, strict=True)]
    volume = fuse(frames, device, camera=FINE)
    for sign in (-1, 1):
        view = scenes.view_from(volume, look_at((0.05, 0.02, sign * 0.6)), CAMERA)
        middle = np.s_[20:100, 30:130]
        assert (view.depth[middle] > 0).all()
        assert np.abs(view.points[middle][..., 2] - sign * 0.021).max() < 1.5 * VOXEL


def test_the_image_does_not_depend_on_the_unit_of_length(device):
    scale, large, T = 0.002, fused_sphere(device), look_at((1.0, 0.5, 0.4))
    small = fuse(scenes.sphere_frames(scale=scale), device, voxel_size=VOXEL * scale, truncation=TRUNCATION * scale)
    S = T.copy()
    S[:3, 3] *= scale
    a, b = scenes.view_from(large, T), scenes.view_from(small, S, depth_min=0.1 * scale, depth_max=3.0 * scale)
    same = (a.depth > 0) & (b.depth > 0)
    assert ((a.depth > 0) ^ (b.depth > 0)).mean() < 0.002
    assert np.quantile(np.abs(a.depth - b.depth / scale)[same], 0.99) < 0.05 * VOXEL


def test_depth_limits_cut_the_image(device):
    volume = fuse([(np.full((120, 160), 1.2345), np.eye(4))], device)
    inner = np.s_[20:100, 20:140]
    assert (scenes.view_from(volume, np.eye(4)).depth[inner] > 0).all()
    assert (scenes.view_from(volume, np.eye(4), depth_min=1.1, depth_max=1.3).depth[inner] > 0).all()
    assert not scenes.view_from(volume, np.eye(4), depth_max=1.2).depth.any()
    assert not scenes.view_from(volume, np.eye(4), depth_min=1.3).depth.any()
    assert not scenes.view_from(volume, look_at((0, 0, 5), (0, 0, 9))).depth.any(), "behind the camera"


def test_a_far_camera_sees_surfaces_within_its_depth(device):
    """The ray enters the bounding box of the blocks at once and does not end in the empty space before it."""
    volume = fused_sphere(device)
    tele = loom.PinholeCameraIntrinsic(32, 24, 31_000.0, 31_000.0, 15.5, 11.5)
    T = look_at((900.0, 200.0, 100.0))
    view, truth = scenes.view_from(volume, T, tele, depth_max=2000.0), scenes.sphere_depth(tele, T)
    assert (truth > 0).sum() > 300
    inner = (truth > 0) & (np.roll(truth, 2, 0) > 0) & (np.roll(truth, -2, 0) > 0) & (np.roll(truth, 2, 1) > 0)
    assert np.abs(view.depth - truth)[inner].max() < VOXEL
    assert scenes.view_from(volume, T, tele, depth_max=900.0).depth.max() == 0


def partly_seen_plane(device, normal, offset, is_seen):
    """A plane with exact distances, seen from below where `is_seen(x, z)` [voxels]."""
    T = look_at((0, 0, -1.2))
    volume = fuse([(scenes.plane_depth(FINE, T, normal, offset), T)], device, camera=FINE)
    count, cells = volume.block_count, volume.block_count * BLOCK_SIDE**3
    blocks = block_box(volume.blocks.keys.numpy()[:count])
    x, y, z = (blocks[:, :, None] * BLOCK_SIDE).T.reshape(3, -1, 1) + np.indices([BLOCK_SIDE] * 3).reshape(3, 1, -1)
    inward = (np.stack([x, y, z], axis=-1) @ normal * VOXEL - offset).reshape(-1) / TRUNCATION
    distances, weights = (getattr(volume.blocks, name).numpy().copy() for name in ("distances", "weights"))
    distances[:cells] = np.clip(inward, -1, 1)
    weights[:cells] = (np.abs(inward) < 1) & is_seen(x, z).reshape(-1)
    scenes.set_voxels(volume, "distances", distances)
    scenes.set_voxels(volume, "weights", weights)
    return volume


def test_a_ray_past_an_unseen_voxel_hits_the_surface(device):
    """It enters a cell beside a voxel before the surface, passes the unseen voxel, and leaves beside one behind."""
    volume = partly_seen_plane(device, np.array([0, 0, -1.0]), -VOXEL / 2, lambda x, z: (z != 0) | (x % 2 == 0))
    entry, camera = np.array([0.1, 0.3, 0]) * VOXEL, loom.PinholeCameraIntrinsic(2, 2, 1000, 1000, 0.5, 0.5)
    view = scenes.view_from(volume, look_at(entry - [0.4, 0, 0.4], entry), camera)
    assert (view.depth > 0).all() and np.abs(view.points - entry).max() < VOXEL


@pytest.mark.parametrize("side", [1, -1])
def test_normals_beside_unseen_voxels_match_the_surface(device, side):
    """A tilted plane, half of it unseen: the last hits have a gradient on one side only."""
    normal = np.array([-0.5, 0, -np.sqrt(0.75)])
    volume = partly_seen_plane(device, normal, 0.013, lambda x, z: side * x <= 0)
    view = scenes.view_from(volume, look_at((0, 0, -0.9)), FINE)
    hit = view.depth > 0
    beside = hit & (side * view.points[..., 0] > -0.45 * VOXEL)
    known = np.isfinite(view.normals).all(axis=-1)  # a hit in a corner between unseen voxels has no normal
    assert (hit & known).sum() > 10_000 and (beside & known).sum() > 500
    assert angles_between(view.normals[hit & known], normal).max() < 0.2
