"""How far what was made of pictures lies from the truth: cameras, depth maps, a surface.

Structure from motion knows neither unit nor frame, so cameras are first brought onto the true ones by a similarity;
what it finds for them is then applied to depth and surface, and nothing else is fitted.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.trajectory import Trajectory
from ...core.checks import check_positive, check_rigid, check_rows
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.scene.raycasting_scene import RaycastingScene
from ...registration.trajectories.trajectory_error import ErrorStatistics, evaluate_trajectory
from .error_figures import CameraErrors, DepthErrors, ErrorFigures, MeshErrors
from .room import surface_errors

Matrix = NDArray[np.float64]

FEWEST = 3  # cameras that settle a similarity
WITHIN_DEPTH = 0.01  # of the true depth
WITHIN_SURFACE = 0.02  # [m]
_CHUNK = 2**18  # points whose distance from the mesh is asked for at once


def camera_errors(poses: ArrayLike, truths: ArrayLike) -> CameraErrors | None:
    """How far cameras lie from the true ones after the similarity that fits their centres best.

    Args:
        poses: Camera to world, shape [n, 4, 4], in any unit and frame.
        truths: The true ones, shape [n, 4, 4] [m].

    Returns:
        The errors, and the similarity. None of fewer than three cameras, or of true centres at one place.

    Raises:
        ValueError: Other shapes, not as many truths as poses, poses that are not rigid.

    Notes:
        Centres that lie on a line leave a turn about it open; the orientations decide it then. Umeyama 1991.

    Example:
        >>> import numpy as np
        >>> truths = np.tile(np.eye(4), (4, 1, 1))
        >>> truths[:, :3, 3] = [[0, 0, 0], [3, 0, 0], [0, 4, 0], [0, 0, 1]]
        >>> poses = truths.copy()
        >>> poses[:, :3, 3] *= 10
        >>> found = camera_errors(poses, truths)
        >>> round(found.scale, 6), found.m.max < 1e-9
        (0.1, True)
    """
    found, known = _checked_poses("poses", poses), _checked_poses("truths", truths)
    if len(found) != len(known):
        raise ValueError(f"truths: expected {len(found)} poses as of `poses`, got {len(known)}")
    extent = float(np.linalg.norm(np.ptp(known[:, :3, 3], axis=0))) if len(known) else 0.0
    if len(found) < FEWEST or not extent or not np.ptp(found[:, :3, 3], axis=0).any():
        return None
    errors = evaluate_trajectory(Trajectory(found), Trajectory(known), with_scale=True)
    metres = _figures(errors.absolute_translation)
    percent = ErrorFigures(*(100 * value / extent for value in (metres.rmse, metres.median, metres.max)))
    turns = _figures(errors.absolute_rotation)
    similarity = errors.scale, errors.transformation.tolist()
    return CameraErrors(len(found), *similarity, extent, metres, percent, turns)


def depth_errors(pairs: Iterable[tuple[ArrayLike, ArrayLike]], *, within: float = WITHIN_DEPTH) -> DepthErrors | None:
    """How complete and how exact depth maps are.

    Args:
        pairs: (depth, true depth) of each picture, shape [h, w] in one unit; 0 where there is none.
        within: Share of the true depth.

    Returns:
        The errors: each is the mean over the pictures, as if each were asked alone, medians over those that kept
        something. None without a picture, or where nothing has a true depth.

    Raises:
        ValueError: Maps of different sizes, or such that are not [h, w].

    Example:
        >>> found = depth_errors([([[1.0, 2.02, 0.0, 4.4]], [[1.0, 2.0, 3.0, 4.0]])])
        >>> found.kept, round(found.median_relative, 4), round(found.within, 4), found.complete
        (0.75, 0.01, 0.6667, 0.5)
    """
    within = check_positive("within", within)
    rows, medians = [], []
    for number, (depth, truth) in enumerate(pairs):
        z, known = np.asarray(depth, np.float64), np.asarray(truth, np.float64)
        if z.ndim != 2 or z.shape != known.shape:
            shapes = f"{list(z.shape)} and {list(known.shape)}"
            raise ValueError(f"pairs[{number}]: expected two maps of one shape [h, w], got {shapes}")
        there = known > 0
        kept = there & (z > 0)
        if not there.any():
            continue
        relative = np.abs(z[kept] - known[kept]) / known[kept]
        good = int(np.count_nonzero(relative <= within * (1 + 1e-12)))
        rows.append((kept.sum() / there.sum(), good / there.sum()))
        if len(relative):
            medians.append((np.median(relative), np.quantile(relative, 0.9), good / len(relative)))
    if not rows:
        return None
    kept_share, complete = np.mean(rows, axis=0)
    middle, ninth, right = np.mean(medians, axis=0) if medians else (np.nan,) * 3
    figures = (kept_share, middle, ninth, right, complete)
    return DepthErrors(len(rows), *(float(value) for value in figures))


def room_mesh_errors(mesh: TriangleMesh, seen: ArrayLike, *, within: float = WITHIN_SURFACE) -> MeshErrors | None:
    """How far a mesh lies from the room's true surface, and how much of what was seen it covers.

    Args:
        mesh: In the frame of the room [m].
        seen: Points of the true surface that the pictures show, shape [n, 3] [m].
        within: Distance [m] up to which mesh and surface are one.

    Returns:
        Of the vertices' distances from the surface, and the share of `seen` that is covered. None of an empty mesh.

    Raises:
        ValueError: Points of another shape, a distance that is not positive.
    """
    within, points = check_positive("within", within), check_rows("seen", seen, 3, dtype=np.float64)
    if not len(mesh.triangles):
        return None
    away = surface_errors(mesh.vertices, device=mesh.device)
    scene = RaycastingScene(device=mesh.device)
    scene.add_triangles(mesh)
    parts = [points[k : k + _CHUNK].astype(np.float32) for k in range(0, len(points), _CHUNK)]
    apart = np.concatenate([scene.compute_distance(part) for part in parts]) if parts else np.zeros(0)
    return MeshErrors(
        vertices=len(away),
        median=float(np.median(away)),
        rmse=float(np.sqrt(np.mean(away**2))),
        p95=float(np.quantile(away, 0.95)),
        largest=float(away.max()),
        within=float(np.mean(away <= within)),
        covered=float(np.mean(apart <= within)) if len(apart) else float("nan"),
    )


def _checked_poses(name: str, poses: ArrayLike) -> Matrix:
    values = np.asarray(poses, np.float64)
    if values.ndim != 3 or values.shape[1:] != (4, 4):
        raise ValueError(f"{name}: expected shape [n, 4, 4], got {list(values.shape)}")
    return np.array([check_rigid(f"{name}[{i}]", T) for i, T in enumerate(values)]).reshape(-1, 4, 4)


def _figures(errors: ErrorStatistics) -> ErrorFigures:
    return ErrorFigures(errors.rmse, errors.median, errors.max)
