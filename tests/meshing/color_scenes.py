"""A ball in front of a wall with a smooth position-dependent color, seen by cameras with exact poses."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

import pointloom as loom

from .tsdf_scenes import look_at

BALL, RADIUS, WALL = np.array([0.0, 0.0, 1.2]), 0.3, 1.6


@dataclass
class Scene:
    """The mesh, the images, and the true camera poses (camera to world)."""

    mesh: loom.TriangleMesh
    frames: list[loom.RGBDImage]
    camera: loom.PinholeCameraIntrinsic
    poses: np.ndarray

    def path(self, poses=None):
        return loom.Trajectory(self.poses if poses is None else poses)


def paint(points):
    x, y, z = points[..., 0], points[..., 1], points[..., 2]
    red = np.sin(11 * x + 3 * z) * np.cos(9 * y) + 0.4 * np.sin(23 * y + 17 * x)
    green = np.cos(8 * x - 5 * y) + 0.5 * np.sin(19 * x + 4 * z)
    blue = np.sin(7 * y + 6 * z) + 0.5 * np.cos(21 * x - 8 * y)
    return np.clip(0.5 + 0.3 * np.stack([red, green, blue], -1), 0, 1)


def take(camera, pose, bend=0.0):
    """Colors uint8 and depth [m] of the scene; `bend` shifts pixels outwards by that fraction of the squared radius."""
    v, u = np.mgrid[: camera.height, : camera.width].astype(float)
    x, y = (u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy

    def cast(x, y):
        rays = np.stack([x, y, np.ones_like(x)], -1) @ pose[:3, :3].T
        eye = pose[:3, 3]
        depth = (WALL - eye[2]) / rays[..., 2]
        a, b = (rays**2).sum(-1), ((eye - BALL) * rays).sum(-1)
        inner = b * b - a * (((eye - BALL) ** 2).sum() - RADIUS**2)
        hit = inner > 0
        depth = np.where(hit, (-b - np.sqrt(np.where(hit, inner, 0))) / a, depth)
        return eye + rays * depth[..., None], depth

    _, depth = cast(x, y)
    scale = 1 + bend * (x * x + y * y)
    points, _ = cast(x * scale, y * scale)
    return np.rint(paint(points) * 255).astype(np.uint8), depth.astype(np.float32)


def wall_and_ball(rows=41):
    s = np.linspace(-1.0, 1.0, rows)
    wall = np.stack([*np.meshgrid(s, s), np.full((rows, rows), WALL)], -1).reshape(-1, 3)
    a, b = np.meshgrid(np.linspace(0, 2 * np.pi, rows), np.linspace(0, np.pi, rows))
    ball = BALL + RADIUS * np.stack([np.sin(b) * np.cos(a), np.sin(b) * np.sin(a), -np.cos(b)], -1).reshape(-1, 3)
    i, j = np.mgrid[: rows - 1, : rows - 1]
    k = (i * rows + j).ravel()
    faces = np.concatenate([np.stack([k, k + rows, k + 1], 1), np.stack([k + 1, k + rows, k + rows + 1], 1)])
    return np.concatenate([wall, ball]), np.concatenate([faces, faces[:, [0, 2, 1]] + rows * rows])


def make_scene(device="cpu", *, views=5, width=160, height=120, rows=41, bend=0.0, shift=(0.0, 0.0, 0.0)):
    # no vertex of the grid projects exactly between two pixels, where rounding is ambiguous
    middle = (width / 2 - 0.363, height / 2 - 0.441)
    camera = loom.PinholeCameraIntrinsic(width, height, 0.95 * width, 0.95 * width, *middle)
    angles = np.linspace(0, 2 * np.pi, views, endpoint=False)
    eyes = [np.array([0.3 * np.cos(t), 0.3 * np.sin(t), 0.05 * np.sin(3 * t)]) for t in angles]
    poses = np.array([look_at(eye, (0.0, 0.0, 1.3), (0.0, -1.0, 0.0)) for eye in eyes])
    frames = []
    for pose in poses:
        color, depth = take(camera, pose, bend)
        frames.append(loom.RGBDImage(color, depth, device=device))
    vertices, triangles = wall_and_ball(rows)
    mesh = loom.TriangleMesh(vertices + shift, triangles, device=device)
    poses = poses.copy()
    poses[:, :3, 3] += shift
    return Scene(mesh, frames, camera, poses)


def perturb(poses, degrees=0.5, meters=0.01, seed=0):
    """Poses, each rotated and shifted a little at random."""
    rng, result = np.random.default_rng(seed), poses.copy()
    for pose in result:
        axis = rng.normal(size=3)
        rotation = Rotation.from_rotvec(np.radians(degrees) * axis / np.linalg.norm(axis))
        pose[:3, :3] = rotation.as_matrix() @ pose[:3, :3]
        step = rng.normal(size=3)
        pose[:3, 3] += meters * step / np.linalg.norm(step)
    return result


def pose_errors(estimated, true):
    """Mean rotation [degrees] and translation [m] errors of the poses relative to the first."""
    angles, moves = [], []
    for a, b in zip(estimated[1:], true[1:], strict=True):
        D = np.linalg.inv(np.linalg.inv(true[0]) @ b) @ (np.linalg.inv(estimated[0]) @ a)
        angles.append(np.degrees(np.arccos(np.clip((np.trace(D[:3, :3]) - 1) / 2, -1, 1))))
        moves.append(np.linalg.norm(D[:3, 3]))
    return float(np.mean(angles)), float(np.mean(moves))
