"""The mesh of Gaussian splats lies on the surface that they represent."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.meshing.volume.splat_fusion import views_around

UTM = np.array([500_000.0, 4_000_000.0, 100.0])


def splats_of(mesh, count, color=(0.8, 0.3, 0.1), *, thickness=0.1, at=(0, 0, 0), device="cpu"):
    cloud = mesh.sample_points_uniformly(count, use_triangle_normal=True, seed=0)
    normals = cloud.normals.astype(float)
    axes = np.cross([0.0, 0.0, 1.0], normals)
    angles = np.arctan2(np.linalg.norm(axes, axis=1), normals[:, 2])
    axes /= np.maximum(np.linalg.norm(axes, axis=1, keepdims=True), 1e-12)
    rotations = np.roll(Rotation.from_rotvec(axes * angles[:, None]).as_quat(), 1, axis=1)
    size = 0.8 * np.sqrt(mesh.get_surface_area() / count)
    harmonics = np.tile((np.array(color) - 0.5) / 0.28209479177387814, (count, 1))
    scales = np.tile([size, size, thickness * size], (count, 1))
    return loom.GaussianSplats(cloud.points + at, scales, rotations, np.full(count, 0.95), harmonics, device=device)


def test_a_ball_is_reconstructed_with_its_color(device, at=UTM):
    splats = splats_of(loom.TriangleMesh.create_sphere(1.0, 40), 2000, at=at, device=device)
    mesh = loom.fuse_splats(splats, voxel_size=0.08)
    apart = np.linalg.norm(mesh.vertices - at, axis=1) - 1
    assert np.abs(apart).max() < 0.06 and np.abs(apart).mean() < 0.02
    assert abs(mesh.get_surface_area() / (4 * np.pi) - 1) < 0.05
    assert mesh.is_watertight()
    np.testing.assert_allclose(np.median(mesh.vertex_colors, axis=0), [0.8, 0.3, 0.1], atol=0.01)


def test_given_views_show_the_inside_of_a_room(device):
    room = loom.TriangleMesh.create_box(4, 3, 2.5).translate([-2, -1.5, -1.2])
    splats = splats_of(room, 8000, device=device)
    camera = loom.PinholeCameraIntrinsic(80, 60, 45.0, 45.0, 39.5, 29.5)
    poses = []
    for k in range(24):
        T = np.eye(4)
        rotation = Rotation.from_euler("yx", [30 * k, 35 * (-1) ** k], degrees=True)
        T[:3, :3] = (rotation.inv() * Rotation.from_euler("x", 90, degrees=True)).as_matrix()
        poses.append(T)
    mesh = loom.fuse_splats(splats, camera, poses, voxel_size=0.1, weight_threshold=1)
    v = mesh.vertices
    apart = np.min(np.abs(np.abs(v - [0, 0, 0.05]) - [2, 1.5, 1.25]), axis=1)
    assert len(v) > 5000 and np.median(apart) < 0.003 and np.quantile(apart, 0.95) < 0.02


def test_orbit_views_show_all_sides():
    centers = np.random.default_rng(0).normal((5, 0, 1), size=(500, 3))
    camera, poses = views_around(centers, 0.1)
    eyes = np.array([np.linalg.inv(T)[:3, 3] for T in poses])
    away = eyes - np.median(centers, axis=0)
    assert np.ptp(np.linalg.norm(away, axis=1)) < 1e-9 and np.linalg.norm(away.mean(axis=0)) < 0.05
    for T in poses:
        np.testing.assert_allclose(T[:3, :3] @ T[:3, :3].T, np.eye(3), atol=1e-12)
        assert np.linalg.det(T[:3, :3]) == pytest.approx(1)
        q = centers @ T[:3, :3].T + T[:3, 3]
        u, v = camera.fx * q[:, 0] / q[:, 2] + camera.cx, camera.fy * q[:, 1] / q[:, 2] + camera.cy
        assert ((u > 0) & (u < camera.width) & (v > 0) & (v < camera.height)).mean() > 0.97
