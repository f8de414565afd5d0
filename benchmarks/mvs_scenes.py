"""Pictures with known cameras for multi-view stereo: the made-up room, and real sets.

Sparse points are found in the pictures and never in the truth: OpenCV's SIFT features, matched between pictures that
look the same way, kept where they fit the cameras' epipolar lines and triangulated to within a pixel, as structure from
motion would have them.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from real_data import DataMissingError, real_data

from pointloom.photogrammetry.mvs.posed_pictures import SparsePoints

FEATURES = 4000  # of a picture
RATIO = 0.8  # of the distances of the nearest and the second feature (Lowe 2004)
EPIPOLAR = 1.5  # [px] from the line
REPROJECTION = 1.5  # [px]
MIN_ANGLE = 1.0  # [degrees] between the two ways to a point
AHEAD = 6  # pictures that each is matched with: those whose axes are nearest to its own
MAX_TURN = 50.0  # [degrees] between the axes of pictures that are matched


@dataclass
class Scene:
    """What multi-view stereo is given, and what is known beside it.

    Attributes:
        pictures: uint8 [h, w, 3].
        cameras: A PosedCamera each.
        truth: Depth, float32 [h, w], 0 where it is unknown; or None a picture.
        disparity: (focal length times baseline, offset): disparity is the first over depth, less the second.
        box: Lower and upper corner of what is to be seen.
    """

    pictures: list[Any]
    cameras: list[Any]
    truth: list[Any]
    disparity: tuple[float, float] | None = None
    box: Any = None
    sparse: Any = field(default=None)

    def __post_init__(self) -> None:
        self.sparse = sparse_points(self.pictures, self.cameras)


def room(frames: int, width: int = 320, *, texture: bool = True) -> Scene:
    """Frames of the room with or without its grain, with exact depth, with the noise of a camera in their colors.

    30 frames go once round; 12 are neighbors on the walk, 6 to 8 degrees and 8 cm apart.
    """
    import pointloom as loom
    from pointloom.datasets.scenes.room import room_sequence

    count, size = 120 if frames > 12 else 240, {"width": width, "height": width * 3 // 4}
    sequence = room_sequence(count, **size, noise=False, texture=texture, color_noise=2.0)
    made = [sequence.read(i) for i in range(frames)]
    cameras = [loom.mvs.PosedCamera(f.intrinsic, np.linalg.inv(f.T_world_camera)) for f in made]
    return Scene([f.color for f in made], cameras, [f.depth.astype(np.float32) for f in made])


def motorcycle() -> Scene:
    """The pair of Middlebury 2014 at a quarter of its size; only the left picture's truth is known."""
    import pointloom as loom

    folder = real_data("stereo-skimage-motorcycle")
    pictures = [loom.read_color(folder / f"motorcycle_{side}.png") for side in ("left", "right")]
    disparity = np.load(folder / "motorcycle_disp.npz")["arr_0"]
    focal, cx, cy, offset, baseline = 994.978, 311.193, 254.877, 31.086, 193.001  # its calib.txt; mm
    height, width = disparity.shape
    cameras = []
    for shift, column in ((0.0, cx), (-baseline, cx + offset)):
        T = np.eye(4)
        T[0, 3] = shift
        cameras.append(loom.mvs.PosedCamera(loom.PinholeCameraIntrinsic(width, height, focal, focal, column, cy), T))
    known = np.isfinite(disparity) & (disparity > 0)
    depth = np.where(known, focal * baseline / (np.where(known, disparity, 1) + offset), 0).astype(np.float32)
    return Scene(pictures, cameras, [depth, None], (focal * baseline, offset))


def motorcycle_disparities() -> int:
    """How many whole disparities its calib.txt says there are, at a quarter of the size."""
    return 70


def fountain(width: int) -> Scene:
    """The eleven pictures of the fountain with their given cameras (Strecha et al. 2008), made smaller."""
    import pointloom as loom
    from pointloom.io.pictures.image_files import resize_color

    folder = real_data("mvs-fountain-p11")
    pictures, cameras = [], []
    for path in sorted((folder / "images").glob("*.jpg")):
        numbers = (folder / "gt_dense_cameras" / f"{path.name}.camera").read_text().split()
        values = np.array(numbers[:24], float)
        K, R, center = values[:9].reshape(3, 3), values[12:21].reshape(3, 3), values[21:24]
        whole = loom.PinholeCameraIntrinsic.from_matrix(K, int(numbers[24]), int(numbers[25]))
        lens, T = whole.scaled(width / whole.width), np.eye(4)
        T[:3, :3], T[:3, 3] = R.T, -R.T @ center  # the file has camera to world
        pictures.append(resize_color(loom.read_color(path), (lens.height, lens.width), str(path)))
        cameras.append(loom.mvs.PosedCamera(lens, T))
    return Scene(pictures, cameras, [None] * len(pictures))


def temple() -> Scene:
    """templeSparseRing of Seitz et al. 2006: sixteen pictures with exact calibration, and the temple's tight box."""
    import pointloom as loom

    folder = real_data("mvs-temple")
    pictures, cameras = [], []
    for line in (folder / "templeSR_par.txt").read_text().splitlines()[1:]:
        name, *numbers = line.split()
        values = np.array(numbers, float)
        picture = loom.read_color(folder / name)
        lens = loom.PinholeCameraIntrinsic.from_matrix(values[:9].reshape(3, 3), picture.shape[1], picture.shape[0])
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = values[9:18].reshape(3, 3), values[18:]
        pictures.append(picture)
        cameras.append(loom.mvs.PosedCamera(lens, T))
    box = np.array([[-0.073568, 0.021728, -0.012445], [0.028855, 0.181892, 0.062736]])  # its README
    return Scene(pictures, cameras, [None] * len(pictures), box=box)


# ------------------------------------------------------------------------------------------ sparse points


def sparse_points(pictures: list[Any], cameras: list[Any]) -> Any:
    """Points that features of several pictures agree on."""

    features = [_features(picture) for picture in pictures]
    parent = {}
    for i, j in _pairs(cameras):
        for a, b in _matches(features[i], features[j], cameras[i], cameras[j]):
            _unite(parent, (i, a), (j, b))
    tracks: dict[Any, list[Any]] = {}
    for node in parent:
        tracks.setdefault(_root(parent, node), []).append(node)
    points, observations = [], []
    for track in tracks.values():
        seen = {i: features[i][0][a] for i, a in sorted(track)}
        point = _triangulated(seen, cameras) if len(seen) == len(track) else None
        if point is not None:
            observations += [(i, len(points)) for i in seen]
            points.append(point)
    if not points:
        raise ValueError("sparse points: no two pictures have features that agree")
    return SparsePoints(np.array(points), np.array(observations))


def _features(picture: Any) -> tuple[Any, Any]:
    """Places [n, 2] and descriptors [n, 128]."""
    try:
        import cv2
    except ModuleNotFoundError as error:
        raise DataMissingError("OpenCV, which finds the sparse points, is not installed") from error
    gray = cv2.cvtColor(picture, cv2.COLOR_RGB2GRAY)
    keys, descriptors = cv2.SIFT_create(FEATURES).detectAndCompute(gray, None)
    places = np.array([key.pt for key in keys]).reshape(-1, 2)
    return places, np.zeros((0, 128), np.float32) if descriptors is None else descriptors


def _pairs(cameras: list[Any]) -> list[tuple[int, int]]:
    axes = np.array([camera.T_camera_world[2, :3] for camera in cameras])
    turns = np.degrees(np.arccos(np.clip(axes @ axes.T, -1, 1)))
    pairs = set()
    for i in range(len(cameras)):
        near = [j for j in np.argsort(turns[i], kind="stable").tolist() if j != i and turns[i, j] < MAX_TURN]
        pairs |= {(min(i, j), max(i, j)) for j in near[:AHEAD]}
    return sorted(pairs)


def _matches(first: Any, second: Any, one: Any, other: Any) -> list[tuple[int, int]]:
    """Features that are each other's nearest, clearly, and lie on each other's epipolar lines."""
    import cv2

    if min(len(first[0]), len(second[0])) < 2:
        return []
    there = cv2.BFMatcher().knnMatch(first[1], second[1], k=2)
    back = {m[0].queryIdx: m[0].trainIdx for m in cv2.BFMatcher().knnMatch(second[1], first[1], k=1)}
    pairs = [(m.queryIdx, m.trainIdx) for m, n in there if m.distance < RATIO * n.distance]
    pairs = np.array([(a, b) for a, b in pairs if back[b] == a], int).reshape(-1, 2)
    T = other.T_camera_world @ np.linalg.inv(one.T_camera_world)
    t = T[:3, 3]
    E = np.array([[0, -t[2], t[1]], [t[2], 0, -t[0]], [-t[1], t[0], 0]]) @ T[:3, :3]
    F = np.linalg.inv(other.intrinsic.matrix).T @ E @ np.linalg.inv(one.intrinsic.matrix)
    p = np.column_stack([first[0][pairs[:, 0]], np.ones(len(pairs))])
    q = np.column_stack([second[0][pairs[:, 1]], np.ones(len(pairs))])
    lines = p @ F.T
    off = np.abs((lines * q).sum(1)) / np.maximum(np.linalg.norm(lines[:, :2], axis=1), 1e-12)
    return [tuple(pair) for pair in pairs[off < EPIPOLAR].tolist()]


def _triangulated(seen: dict[int, Any], cameras: list[Any]) -> Any:
    """The point that some pictures see at these places, or None where they do not fit."""
    rows = []
    for i, (u, v) in seen.items():
        P = cameras[i].intrinsic.matrix @ cameras[i].T_camera_world[:3]
        rows += [u * P[2] - P[0], v * P[2] - P[1]]
    X = np.linalg.svd(np.array(rows))[2][-1]
    if abs(X[3]) < 1e-12 * np.abs(X).max():
        return None
    X = X[:3] / X[3]
    ways = []
    for i, (u, v) in seen.items():
        p = cameras[i].intrinsic.matrix @ (cameras[i].T_camera_world[:3, :3] @ X + cameras[i].T_camera_world[:3, 3])
        if p[2] <= 0 or np.hypot(p[0] / p[2] - u, p[1] / p[2] - v) > REPROJECTION:
            return None
        way = X - cameras[i].center
        ways.append(way / np.linalg.norm(way))
    angle = max(np.degrees(np.arccos(np.clip(a @ b, -1, 1))) for a, b in itertools.combinations(ways, 2))
    return X if angle >= MIN_ANGLE else None


def _root(parent: dict[Any, Any], node: Any) -> Any:
    while parent[node] != node:
        parent[node] = parent[parent[node]]
        node = parent[node]
    return node


def _unite(parent: dict[Any, Any], a: Any, b: Any) -> None:
    a, b = (_root(parent, parent.setdefault(node, node)) for node in (a, b))
    parent[max(a, b)] = min(a, b)
