"""Which pictures are compared with which: those that together see a picture's points from a little aside.

The best angle between two views of a point is 2 to 15 degrees: below that the depth is uncertain, above it the patches
look different. Pictures that score best one by one all look at the same part; chosen greedily, each adds points that
those before it do not see well (Goesele et al. 2007, "Multi-view stereo for community photo collections", section 4).
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count
from ..frusta import places_before
from .posed_pictures import PosedCamera, SparsePoints, check_cameras, check_sparse

COUNT = 8
MOST_SOURCES = 256  # as many as a picture can be compared with in reasonable time
ENOUGH = 3.0  # good views of a point: more of them add nothing
NARROW, WIDE, FALLOFF = 3.0, 10.0, 10.0  # [degrees] full weight from here to there, then it falls by e each FALLOFF
WITHOUT_POINTS = 3.0  # baselines of the typical step between cameras that are as good as one


def choose_sources(cameras: Any, sparse: Any, *, count: int = COUNT) -> tuple[tuple[int, ...], ...]:
    """For each picture, the others that multi-view stereo should compare it with, the most useful first.

    Each next source is the one that adds most to what the picture's sparse points have: a point counts until three
    good views see it, and a view is as good as its angle with the picture's at that point: full weight from 3 to 10
    degrees, less below, and falling by e every 10 degrees above.

    A picture that shares no sparse point with any other has sources by the cameras alone: in the same way, with places
    along rays through it in place of points, which count by how many cameras have them in their pictures. Where there
    are no such places either, those that look the same way, from a place some steps aside, where a step is the median
    distance from a camera to its nearest neighbour.

    Args:
        cameras: A PosedCamera for each picture.
        sparse: SparsePoints, or what has `points` [m, 3] and `observations` [k, 2] as an SfmModel has; None for none.
        count: The most sources of a picture, 1 to 256.

    Returns:
        For each picture the numbers of its sources; fewer than `count` where no more add anything, none for a picture
        alone.

    Raises:
        TypeError: Not such cameras or points.
        ValueError: A count out of range, or an observation by a picture that is not there.

    Notes:
        The same pictures each time; of equals the lower number. Time and memory grow with the observations that
        pictures share: 150 pictures with 50,000 points seen by 10 each take a second.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.photos.mvs.posed_pictures import SparsePoints
        >>> from pointloom.photos.mvs.sources import choose_sources
        >>> intrinsic = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> poses = np.tile(np.eye(4), (4, 1, 1))
        >>> poses[:, 0, 3] = [0.0, -0.1, -0.2, -2.0]
        >>> cameras = [loom.mvs.PosedCamera(intrinsic, pose) for pose in poses]
        >>> sparse = SparsePoints([[0.0, 0.0, 1.0]], [[0, 0], [1, 0], [2, 0], [3, 0]])
        >>> choose_sources(cameras, sparse, count=2)
        ((1, 2), (0, 2), (1, 0), (2, 1))
    """
    posed = check_cameras("cameras", cameras)
    most = check_count("count", count, maximum=MOST_SOURCES, because="each takes its share of the time")
    points = SparsePoints(np.zeros((0, 3)), np.zeros((0, 2), np.int64))
    if sparse is not None:
        points = check_sparse("sparse", sparse)
    seen = points.observations
    if seen.size and seen[:, 0].max() >= len(posed):
        raise ValueError(f"sparse: pictures up to {seen[:, 0].max()} see points, but there are {len(posed)} cameras")
    centers = np.array([camera.center for camera in posed]).reshape(-1, 3)
    tracks = _Tracks(seen, len(points.points))
    step, out = _step(centers), []
    for i in range(len(posed)):
        chosen = _by_cover(i, points, tracks, centers, most)
        out.append(chosen or _by_frusta(i, posed, most) or _by_camera(i, posed, centers, step, most))
    return tuple(out)


class _Tracks:
    """The pictures that see each point, one point's after the other's."""

    def __init__(self, observations: NDArray[np.int64], count: int):
        order = np.argsort(observations[:, 1], kind="stable")
        self.pictures = observations[order, 0]
        self.starts = np.searchsorted(observations[order, 1], np.arange(count + 1))

    def of(self, points: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """All (place in `points`, picture) where the picture sees that point."""
        first, lengths = self.starts[points], np.diff(self.starts)[points]
        places = np.repeat(np.arange(len(points)), lengths)
        inside = np.arange(len(places)) - np.repeat(np.cumsum(lengths) - lengths, lengths)
        return places, self.pictures[np.repeat(first, lengths) + inside]


def _by_cover(
    i: int, sparse: SparsePoints, tracks: _Tracks, centers: NDArray[np.float64], most: int
) -> tuple[int, ...]:
    """Sources by the points that they share with picture i; none where there are no such points."""
    mine = sparse.seen_by(i)
    places, pictures = tracks.of(mine)
    others = pictures != i
    places, pictures = places[others], pictures[others]
    at = sparse.points[mine[places]]
    weights = _worth(at - centers[i], at - centers[pictures])
    wanted, chosen = np.full(len(mine), ENOUGH), []
    for _ in range(most):
        gain = np.bincount(pictures, np.minimum(weights, wanted[places]), minlength=len(centers))
        gain[chosen] = 0.0
        best = int(gain.argmax())
        if not gain[best] > 0:
            break
        chosen.append(best)
        its = pictures == best
        wanted[places[its]] = np.maximum(wanted[places[its]] - weights[its], 0.0)
    return tuple(chosen)


def _worth(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    """How good it is to see a point along b beside a, by the angle between them."""
    cross = np.linalg.norm(np.cross(a, b), axis=1)
    return _worth_of(np.degrees(np.arctan2(cross, (a * b).sum(axis=1))))  # exact for small ones, which arccos is not


def _worth_of(angle: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.clip(angle / NARROW, 0, 1) * np.exp(-np.maximum(angle - WIDE, 0) / FALLOFF)


def _by_frusta(i: int, cameras: tuple[PosedCamera, ...], most: int) -> tuple[int, ...]:
    """Sources by what they may see of the same; none where no camera has such places from aside."""
    poses = np.array([camera.T_camera_world for camera in cameras])
    places, seen, angles = places_before(i, [camera.intrinsic for camera in cameras], poses)
    weights = _worth_of(angles) * seen
    often = seen.sum(axis=1) / max(1, len(cameras) - 1)
    wanted, chosen = np.full(len(places), ENOUGH), []
    for _ in range(most):
        gain = often @ np.minimum(weights, wanted[:, None])
        gain[chosen] = 0.0
        best = int(gain.argmax())
        if not gain[best] > 0:
            break
        chosen.append(best)
        wanted = np.maximum(wanted - weights[:, best], 0.0)
    return tuple(chosen)


def depth_in_view(i: int, cameras: tuple[PosedCamera, ...], low: float, high: float) -> tuple[float, float] | None:
    """Between which depths of a picture others may see the same; None where they nowhere do.

    Args:
        i: Number of the picture.
        cameras: Of all.
        low, high: Shares of the places along its rays, by how many see them, that lie nearer.
    """
    poses = np.array([camera.T_camera_world for camera in cameras])
    places, seen, _ = places_before(i, [camera.intrinsic for camera in cameras], poses)
    weights = seen.sum(axis=1)
    if not weights.any():
        return None
    z = places @ poses[i, 2, :3] + poses[i, 2, 3]
    order = np.argsort(z, kind="stable")
    below = np.cumsum(weights[order]) / weights.sum()
    nearest, farthest = (float(z[order[int(np.searchsorted(below, share))]]) for share in (low, high - 1e-9))
    return nearest, farthest


def _by_camera(
    i: int, cameras: tuple[PosedCamera, ...], centers: NDArray[np.float64], step: float, most: int
) -> tuple[int, ...]:
    if len(cameras) < 2:
        return ()
    axes = np.array([camera.T_camera_world[2, :3] for camera in cameras])
    alike = np.maximum(axes @ axes[i], 0.0) ** 4  # a quarter at 45 degrees
    steps = np.linalg.norm(centers - centers[i], axis=1) / max(step, np.finfo(float).tiny)
    worth = alike * np.minimum(steps, 1.0) * np.exp(-np.maximum(steps / WITHOUT_POINTS - 1.0, 0.0))
    worth[i] = 0.0
    order = np.argsort(-worth, kind="stable")[:most]
    return tuple(int(j) for j in order if worth[j] > 0)


def _step(centers: NDArray[np.float64]) -> float:
    distinct = np.unique(centers, axis=0)
    if len(distinct) < 2:
        return 0.0
    longest = np.ptp(distinct, axis=0).argmax()
    row = distinct[np.argsort(distinct[:, longest])]
    nearest = np.full(len(row), np.inf)  # squared
    for k in range(1, len(row)):
        apart = row[k:] - row[:-k]
        if (apart[:, longest] ** 2 >= np.maximum(nearest[k:], nearest[:-k])).all():
            break  # those that stand farther apart in the row are no nearer
        squares = (apart * apart).sum(axis=1)
        nearest[k:] = np.minimum(nearest[k:], squares)
        nearest[:-k] = np.minimum(nearest[:-k], squares)
    return float(np.median(np.sqrt(nearest)))
