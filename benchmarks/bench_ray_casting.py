"""First hits of a camera's rays and of unordered rays on a mesh of 76k triangles, beside Embree.

Embree is included twice, as called by Open3D and by embreex. embreex casts rays one by one on one core; it returns the
same data as pointloom: distance, triangle, barycentric coordinates, normal.
"""

from __future__ import annotations

from functools import cache, partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, load_open3d, timed
from mesh_scenes import Arrays, scene_in_open3d, scene_in_pointloom, wavy_mesh
from numpy.typing import NDArray
from reasons import CALL, SPREAD

Scene = tuple[Arrays, NDArray[np.float32]]


@cache
def camera_scene(cells: int = 128, width: int = 1280, height: int = 960) -> Scene:
    """An image that the mesh mostly fills."""
    import pointloom as loom

    vertices, triangles = wavy_mesh(cells)
    middle, size = (vertices.min(axis=0) + vertices.max(axis=0)) / 2, np.ptp(vertices, axis=0).max()
    eye = middle + size * np.array([0.2, 0.3, 1.2])
    rays = loom.RaycastingScene.create_rays_pinhole(60, middle, eye, [0, 1, 0], width, height)
    return (vertices, triangles), rays.astype(np.float32)  # float64 if the eye is far from zero


@cache
def crossing_scene(cells: int = 128, count: int = 500_000) -> Scene:
    """Rays between random points around the mesh."""
    vertices, triangles = wavy_mesh(cells)
    rng = np.random.default_rng(0)
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    margin = 0.2 * (high - low)
    origins, targets = rng.uniform(low - margin, high + margin, (count, 3)), rng.uniform(low, high, (count, 3))
    return (vertices, triangles), np.hstack([origins, targets - origins]).astype(np.float32)


def prepare_pointloom(scene: Scene, device: str) -> Any:
    arrays, rays = scene
    return partial(scene_in_pointloom(arrays, device).cast_rays, rays)  # the result is on the host


def prepare_open3d(scene: Scene, device: str) -> Any:
    arrays, rays = scene
    return partial(scene_in_open3d(arrays).cast_rays, load_open3d().core.Tensor(rays))


def prepare_embreex(scene: Scene, device: str) -> Any:
    from embreex.mesh_construction import TriangleMesh
    from embreex.rtcore_scene import EmbreeScene

    (vertices, triangles), rays = scene
    flat = rays.reshape(-1, 6)
    origins, directions = (np.ascontiguousarray(part) for part in (flat[:, :3], flat[:, 3:]))
    tree = EmbreeScene()
    mesh = TriangleMesh(tree, vertices.astype(np.float32), np.array(triangles, np.int32))
    tree.run(origins[:1], directions[:1])  # builds the tree

    def cast(scene_mesh: Any = mesh) -> Any:
        return tree.run(origins, directions, output=True)

    return cast


def facts(hits: Any) -> NDArray[np.float32]:
    """The depth along each ray; infinite without a hit."""
    if "tfar" in hits:
        return np.where(hits["primID"] >= 0, hits["tfar"], np.float32(np.inf))
    distances = hits["t_hit"]
    return np.asarray(distances if isinstance(distances, np.ndarray) else distances.numpy()).ravel()


def check(actual: NDArray[np.float32], reference: NDArray[np.float32], peer: str) -> None:
    """Check for the same depths to rounding, except for rays at an outline."""
    both = np.isfinite(actual) & np.isfinite(reference)
    assert (np.isfinite(actual) == np.isfinite(reference)).mean() > 0.9999, peer
    close = np.isclose(actual[both], reference[both], rtol=1e-4)
    assert close.mean() > 0.9999, peer


RAY_CASTING = Operation(
    name="ray_casting",
    scenes={
        "camera 64x48": partial(camera_scene, 16, 64, 48),
        "camera 1280x960": camera_scene,
        "crossing 500k": crossing_scene,
    },
    quick={"camera": partial(camera_scene, 24, 64, 48)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("open3d-tensor", prepare_open3d, facts),
        Contestant("embreex", prepare_embreex, facts),
    ),
    check=check,
    targets={"camera 1280x960": 1, "crossing 500k": 1},
    reasons={
        "camera 64x48": CALL,
        "camera 1280x960": SPREAD.format("1.1"),
        "crossing 500k": (
            "A ray visits 6.3 nodes of eight boxes and 2.1 leaves of eight triangles alone; camera rays share them."
        ),
    },
)
OPERATIONS = (RAY_CASTING,)


@timed(RAY_CASTING)
def test_ray_casting(time_lap) -> None:
    time_lap()
