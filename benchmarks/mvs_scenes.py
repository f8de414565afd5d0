"""Images with known cameras for multi-view stereo: the synthetic room, and real sets.

Sparse points are computed from the images, never from the ground truth: OpenCV's SIFT features, matched between images
with similar viewing directions, filtered by the epipolar constraint and triangulated to within a pixel, as in structure
from motion.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from real_data import DataMissingError, real_data

from pointloom.photogrammetry.mvs.posed_images import SparsePoints

FEATURES = 4000  # per image
RATIO = 0.8  # of the distances of the nearest and the second nearest feature (Lowe 2004)
EPIPOLAR = 1.5  # [px] from the epipolar line
REPROJECTION = 1.5  # [px]
MIN_ANGLE = 1.0  # [degrees] triangulation angle
AHEAD = 6  # images that each is matched with: those with the nearest optical axes
MAX_ANGLE = 50.0  # [degrees] between the axes of matched images


@dataclass
class Scene:
    """Inputs of multi-view stereo, and the ground truth.

    Attributes:
        images: uint8 [h, w, 3].
        cameras: A PosedCamera for each.
        truth: For each image the depth, float32 [h, w], 0 if unknown; or None.
        disparity: (focal length times baseline, offset): disparity is the first divided by depth, minus the second.
        box: Lower and upper corner of the object.
    """

    images: list[Any]
    cameras: list[Any]
    truth: list[Any]
    disparity: tuple[float, float] | None = None
    box: Any = None
    sparse: Any = field(default=None)

    def __post_init__(self) -> None:
        self.sparse = sparse_points(self.images, self.cameras)


def room(frames: int, width: int = 320, *, texture: bool = True) -> Scene:
    """Frames of the room with or without fine texture, with exact depth and noisy colors.

    30 frames are one full circle; 12 are neighbors, 6 to 8 degrees and 8 cm apart.
    """
    import pointloom as loom
    from pointloom.datasets.scenes.room import room_sequence

    count, size = 120 if frames > 12 else 240, {"width": width, "height": width * 3 // 4}
    sequence = room_sequence(count, **size, noise=False, texture=texture, color_noise=2.0)
    views = [sequence.read(i) for i in range(frames)]
    cameras = [loom.photogrammetry.PosedCamera(f.intrinsic, np.linalg.inv(f.T_world_camera)) for f in views]
    return Scene([f.color for f in views], cameras, [f.depth.astype(np.float32) for f in views])


def motorcycle() -> Scene:
    """The pair of Middlebury 2014 at a quarter of its size; ground truth is known for the left image only."""
    import pointloom as loom

    folder = real_data("stereo-skimage-motorcycle")
    images = [loom.read_color(folder / f"motorcycle_{side}.png") for side in ("left", "right")]
    disparity = np.load(folder / "motorcycle_disp.npz")["arr_0"]
    focal, cx, cy, offset, baseline = 994.978, 311.193, 254.877, 31.086, 193.001  # its calib.txt; mm
    height, width = disparity.shape
    cameras = []
    for shift, column in ((0.0, cx), (-baseline, cx + offset)):
        T = np.eye(4)
        T[0, 3] = shift
        cameras.append(
            loom.photogrammetry.PosedCamera(loom.PinholeCameraIntrinsic(width, height, focal, focal, column, cy), T)
        )
    known = np.isfinite(disparity) & (disparity > 0)
    depth = np.where(known, focal * baseline / (np.where(known, disparity, 1) + offset), 0).astype(np.float32)
    return Scene(images, cameras, [depth, None], (focal * baseline, offset))


def motorcycle_disparities() -> int:
    """Number of integer disparities in its calib.txt, at a quarter of the size."""
    return 70


def fountain(width: int) -> Scene:
    """The eleven images of the fountain with their given cameras (Strecha et al. 2008), reduced in size."""
    import pointloom as loom
    from pointloom.io.images.image_files import resize_color

    folder = real_data("mvs-fountain-p11")
    images, cameras = [], []
    for path in sorted((folder / "images").glob("*.jpg")):
        numbers = (folder / "gt_dense_cameras" / f"{path.name}.camera").read_text().split()
        values = np.array(numbers[:24], float)
        K, R, center = values[:9].reshape(3, 3), values[12:21].reshape(3, 3), values[21:24]
        full_size = loom.PinholeCameraIntrinsic.from_matrix(K, int(numbers[24]), int(numbers[25]))
        lens, T = full_size.scaled(width / full_size.width), np.eye(4)
        T[:3, :3], T[:3, 3] = R.T, -R.T @ center  # the file contains camera to world
        images.append(resize_color(loom.read_color(path), (lens.height, lens.width), str(path)))
        cameras.append(loom.photogrammetry.PosedCamera(lens, T))
    return Scene(images, cameras, [None] * len(images))


def temple() -> Scene:
    """templeSparseRing of Seitz et al. 2006: sixteen images with exact calibration, and the temple's tight bounding
    box.
    """
    import pointloom as loom

    folder = real_data("mvs-temple")
    images, cameras = [], []
    for line in (folder / "templeSR_par.txt").read_text().splitlines()[1:]:
        name, *numbers = line.split()
        values = np.array(numbers, float)
        image = loom.read_color(folder / name)
        lens = loom.PinholeCameraIntrinsic.from_matrix(values[:9].reshape(3, 3), image.shape[1], image.shape[0])
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = values[9:18].reshape(3, 3), values[18:]
        images.append(image)
        cameras.append(loom.photogrammetry.PosedCamera(lens, T))
    box = np.array([[-0.073568, 0.021728, -0.012445], [0.028855, 0.181892, 0.062736]])  # from its README
    return Scene(images, cameras, [None] * len(images), box=box)


# ------------------------------------------------------------------------------------------ sparse points


def sparse_points(images: list[Any], cameras: list[Any]) -> Any:
    """Triangulate consistent features of several images."""

    features = [_features(image) for image in images]
    parent = {}
    for i, j in _pairs(cameras):
        for a, b in _matches(features[i], features[j], cameras[i], cameras[j]):
            _unite(parent, (i, a), (j, b))
    tracks: dict[Any, list[Any]] = {}
    for node in parent:
        tracks.setdefault(_root(parent, node), []).append(node)
    points, observations = [], []
    for track in tracks.values():
        pixels = {i: features[i][0][a] for i, a in sorted(track)}
        point = _triangulated(pixels, cameras) if len(pixels) == len(track) else None
        if point is not None:
            observations += [(i, len(points)) for i in pixels]
            points.append(point)
    if not points:
        raise ValueError("sparse points: no two images have consistent features")
    return SparsePoints(np.array(points), np.array(observations))


def _features(image: Any) -> tuple[Any, Any]:
    """Positions [n, 2] and descriptors [n, 128]."""
    try:
        import cv2
    except ModuleNotFoundError as error:
        raise DataMissingError("OpenCV, which computes the sparse points, is not installed") from error
    gray = cv2.cvtColor(image, cv2.COLOR_RGB2GRAY)
    keys, descriptors = cv2.SIFT_create(FEATURES).detectAndCompute(gray, None)
    positions = np.array([key.pt for key in keys]).reshape(-1, 2)
    return positions, np.zeros((0, 128), np.float32) if descriptors is None else descriptors


def _pairs(cameras: list[Any]) -> list[tuple[int, int]]:
    axes = np.array([camera.T_camera_world[2, :3] for camera in cameras])
    angles = np.degrees(np.arccos(np.clip(axes @ axes.T, -1, 1)))
    pairs = set()
    for i in range(len(cameras)):
        near = [j for j in np.argsort(angles[i], kind="stable").tolist() if j != i and angles[i, j] < MAX_ANGLE]
        pairs |= {(min(i, j), max(i, j)) for j in near[:AHEAD]}
    return sorted(pairs)


def _matches(first: Any, second: Any, one: Any, other: Any) -> list[tuple[int, int]]:
    """Mutual nearest features that pass the ratio test and the epipolar constraint."""
    import cv2

    if min(len(first[0]), len(second[0])) < 2:
        return []
    candidates = cv2.BFMatcher().knnMatch(first[1], second[1], k=2)
    back = {m[0].queryIdx: m[0].trainIdx for m in cv2.BFMatcher().knnMatch(second[1], first[1], k=1)}
    pairs = [(m.queryIdx, m.trainIdx) for m, n in candidates if m.distance < RATIO * n.distance]
    pairs = np.array([(a, b) for a, b in pairs if back[b] == a], int).reshape(-1, 2)
    T = other.T_camera_world @ np.linalg.inv(one.T_camera_world)
    t = T[:3, 3]
    E = np.array([[0, -t[2], t[1]], [t[2], 0, -t[0]], [-t[1], t[0], 0]]) @ T[:3, :3]
    F = np.linalg.inv(other.intrinsic.matrix).T @ E @ np.linalg.inv(one.intrinsic.matrix)
    p = np.column_stack([first[0][pairs[:, 0]], np.ones(len(pairs))])
    q = np.column_stack([second[0][pairs[:, 1]], np.ones(len(pairs))])
    lines = p @ F.T
    distances = np.abs((lines * q).sum(1)) / np.maximum(np.linalg.norm(lines[:, :2], axis=1), 1e-12)
    return [tuple(pair) for pair in pairs[distances < EPIPOLAR].tolist()]


def _triangulated(pixels: dict[int, Any], cameras: list[Any]) -> Any:
    """Triangulate a point from its image positions; None if the reprojection errors are too large."""
    rows = []
    for i, (u, v) in pixels.items():
        P = cameras[i].intrinsic.matrix @ cameras[i].T_camera_world[:3]
        rows += [u * P[2] - P[0], v * P[2] - P[1]]
    X = np.linalg.svd(np.array(rows))[2][-1]
    if abs(X[3]) < 1e-12 * np.abs(X).max():
        return None
    X = X[:3] / X[3]
    directions = []
    for i, (u, v) in pixels.items():
        p = cameras[i].intrinsic.matrix @ (cameras[i].T_camera_world[:3, :3] @ X + cameras[i].T_camera_world[:3, 3])
        if p[2] <= 0 or np.hypot(p[0] / p[2] - u, p[1] / p[2] - v) > REPROJECTION:
            return None
        direction = X - cameras[i].center
        directions.append(direction / np.linalg.norm(direction))
    angle = max(np.degrees(np.arccos(np.clip(a @ b, -1, 1))) for a, b in itertools.combinations(directions, 2))
    return X if angle >= MIN_ANGLE else None


def _root(parent: dict[Any, Any], node: Any) -> Any:
    while parent[node] != node:
        parent[node] = parent[parent[node]]
        node = parent[node]
    return node


def _unite(parent: dict[Any, Any], a: Any, b: Any) -> None:
    a, b = (_root(parent, parent.setdefault(node, node)) for node in (a, b))
    parent[max(a, b)] = min(a, b)
