"""Synthetic flights: georeferenced cameras, the model of the images, and their GPS."""

import numpy as np

import pointloom as loom
from pointloom.photogrammetry.sfm.image_positions import ImagePosition, ImagePositions
from pointloom.registration.rigid import make_pose

CAMERA = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])
FRAME = loom.WorldFrame(47.5, 8.25, 400.0)


def look(eye, way, up=(0.0, 0.0, 1.0)):
    """The pose of a level camera."""
    z = np.array(way, float) / np.linalg.norm(way)
    x = np.cross(z, up)
    x /= np.linalg.norm(x)
    return make_pose(np.stack([x, np.cross(z, x), z], axis=1), np.array(eye, float))


def nadir(rows=4, columns=6, seed=0):
    """Rows to and fro at 50 m, looking almost straight down."""
    rng = np.random.default_rng(seed)
    return np.array([
        look((9 * i + rng.normal(0, 0.3), 16 * j, 50 + rng.normal(0, 0.5)), (*rng.normal(0, 0.03, 2), -1.0),
             up=(0.0, 1.0 if j % 2 else -1.0, 0.0))
        for j in range(rows) for i in range(columns)
    ])  # fmt: skip


def oblique(count=24, seed=0):
    """A circle around an object, looking down at it."""
    rng = np.random.default_rng(seed)
    return np.array([
        look((30 * np.cos(a), 30 * np.sin(a), 12 + rng.normal(0, 0.5)), (-np.cos(a), -np.sin(a), -0.4))
        for a in np.linspace(0, 6, count)
    ])  # fmt: skip


def street(count=20, seed=0):
    """Straight along a street at chest height, looking at the houses on both sides."""
    rng = np.random.default_rng(seed)
    ways = [(rng.normal(0, 0.4), 1.0 if k % 3 else -1.0, rng.normal(0, 0.1)) for k in range(count)]
    return np.array([look((3.0 * k, 0.0, 1.5), way) for k, way in enumerate(ways)])


def hidden(poses, seed=0):
    """The model of the poses in an arbitrary frame and unit, and T_world_model that restores them."""
    rng = np.random.default_rng(seed)
    q = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    T = make_pose(0.137 * q * np.sign(np.linalg.det(q)), np.array([3.0, -2.0, 7.0]))
    names = [f"IMG_{k:04d}.jpg" for k in range(len(poses))]
    model = loom.SfmModel(names, [CAMERA] * len(poses), np.linalg.inv(poses))
    return model.transform(T), np.linalg.inv(T)


def gps_of(poses, noise=0.0, wild=(), altitudes=True, attitudes=None, sigma=None, seed=0):
    """GPS of images at these poses, with noise [m] in plan and twice as much in height; some are outliers."""
    rng = np.random.default_rng(seed)
    enu = poses[:, :3, 3] + rng.normal(size=(len(poses), 3)) * np.array([1, 1, 2]) * noise
    for k in wild:
        enu[k] += (40.0, -30.0, 5.0)
    rows = FRAME.to_geodetic(enu).tolist()
    positions = [
        ImagePosition(f"IMG_{k:04d}.JPG", lat, lon, height if altitudes else None, horizontal_sigma=sigma)
        for k, (lat, lon, height) in enumerate(rows)
    ]
    return ImagePositions(tuple(positions), attitudes or {}, {}, len(poses))


def attitudes_of(poses):
    """Yaw, pitch and roll [degrees] of cameras in a world whose z is up, by name."""
    attitudes = {}
    for k, R in enumerate(poses[:, :3, :3]):
        pitch = np.degrees(np.arcsin(R[2, 2]))
        roll = np.degrees(np.arctan2(-R[2, 0], -R[2, 1]))
        attitudes[f"IMG_{k:04d}.JPG"] = (0.0, float(pitch), float(roll))
    return attitudes


def errors(fit, model, poses):
    """Relative scale error, tilt of up [degrees], and the largest position error of a camera [m]."""
    _, true = hidden(poses)
    scales = [float(np.cbrt(np.linalg.det(T[:3, :3]))) for T in (fit.T_world_model, true)]
    R = fit.T_world_model[:3, :3] @ true[:3, :3].T / scales[0] / scales[1]
    centers = model.transform(fit.T_world_model).centers
    if fit.frame is not None:
        centers = FRAME.to_enu(fit.frame.to_geodetic(centers))
    gaps = np.linalg.norm(centers - poses[:, :3, 3], axis=1)
    return scales[0] / scales[1] - 1, float(np.degrees(np.arccos(min(1.0, R[2, 2])))), float(gaps.max())
