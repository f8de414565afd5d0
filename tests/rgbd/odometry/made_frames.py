"""Ray-traced images of a synthetic room corner with a ball, with exact depth, colors and poses."""

import numpy as np

import pointloom as loom

CAMERA = loom.PinholeCameraIntrinsic(160, 120, 140.0, 140.0, 79.5, 59.5)
WALLS = np.array([[0, 0, 1, 2.6], [1, 0, 0.2, 1.6], [-1, 0.1, 0.3, 1.8], [0, 1, 0, 0.9], [0, -1, 0, 1.1]], float)
BALL, RADIUS = np.array([0.2, 0.4, 1.7]), 0.35


def pose_of(angles, shift):
    """A pose T_world_camera of small rotations about x, y, z [rad] and a shift [m]."""
    size = np.linalg.norm(angles)
    axis = np.array(angles) / max(size, 1e-12)
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    pose = np.eye(4)
    pose[:3, :3] += np.sin(size) * k + (1 - np.cos(size)) * k @ k
    pose[:3, 3] = shift
    return pose


def image(pose, camera=CAMERA, *, noise=0.0, seed=0, ball=BALL):
    """Depth, float32 [h, w] [m], and colors, uint8 [h, w, 3], from a pose; `noise` scales the noise of a Kinect."""
    v, u = np.mgrid[: camera.height, : camera.width]
    rays = np.stack([(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, np.ones(u.shape)], -1)
    ways, origin = rays @ pose[:3, :3].T, pose[:3, 3]
    depth = np.full(u.shape, np.inf)
    for a, b, c, d in WALLS:
        along = ways @ [a, b, c]
        with np.errstate(divide="ignore"):
            distance = np.where(along > 1e-9, (d - origin @ [a, b, c]) / along, np.inf)
        depth = np.minimum(depth, distance)
    m, square = origin - ball, np.sum(ways * ways, -1)
    half = ways @ m
    inside = half * half - square * (m @ m - RADIUS**2)
    hit = (-half - np.sqrt(np.maximum(inside, 0))) / square
    depth = np.where((inside > 0) & (hit > 0), np.minimum(depth, hit), depth)
    points = origin + depth[..., None] * ways
    x, y, z = np.moveaxis(points, -1, 0)
    shade = 125 + 45 * np.sin(17 * x + 5 * y) + 40 * np.cos(15 * y - 9 * z) + 35 * np.sin(21 * z + 13 * x)
    rng = np.random.default_rng(seed)
    depth = depth + noise * (0.0012 + 0.0019 * np.maximum(depth - 0.4, 0) ** 2) * rng.standard_normal(depth.shape)
    shade = shade + noise * 2 * rng.standard_normal(depth.shape)
    color = np.stack([shade, 0.8 * shade + 20, 1.1 * shade], -1).clip(0, 255).astype(np.uint8)
    return depth.astype(np.float32), color


def frame(pose, device, camera=CAMERA, *, with_color=True, **options):
    depth, color = image(pose, camera, **options)
    return loom.rgbd.OdometryFrame(depth, camera, color if with_color else None, device=device)


def errors_of(estimate, truth):
    """Angle [deg] and distance [mm] between two poses."""
    error = np.linalg.inv(truth) @ estimate
    angle = np.degrees(2 * np.arcsin(min(np.linalg.norm(error[:3, :3] - np.eye(3)) / 8**0.5, 1)))
    return angle, 1000 * np.linalg.norm(error[:3, 3])
