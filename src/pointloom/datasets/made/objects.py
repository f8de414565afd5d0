"""A synthetic figure: its mesh, and scans of it from all sides."""

from __future__ import annotations

import math

import numpy as np

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_count, check_seed
from ...meshing.mesh.mesh import TriangleMesh
from ...pcd.cloud import PointCloud
from ..array_cache import Arrays, cached
from ..scenes.figure import owl
from .results import PosedScans
from .views import ring, scene_of, view_mesh

SCAN_CAMERA = PinholeCameraIntrinsic(320, 240, 400.0, 400.0, 159.5, 119.5)
CAMERA_DISTANCE = 0.6  # [m] from the camera to the center of the figure
CAMERA_ELEVATIONS = (math.radians(15), math.radians(35))  # elevations of the camera, alternating
MIN_INCIDENCE_COSINE = 0.2  # minimum cosine to the normal of a return
RANGE_NOISE = 0.0005  # [m] standard deviation, as of a close-range structured-light scanner
COLOR_NOISE = 2.0 / 255


def object_mesh() -> TriangleMesh:
    """An owl on a stump: a closed, colored mesh with details of 3 to 10 mm.

    It is 0.30 m tall and 0.19 m wide, centered at zero, z up, facing -y.

    Returns:
        A watertight, manifold mesh of one component with about 84,000 triangles, vertex colors and normals.

    Notes:
        Bitwise reproducible. Cached in the user's cache folder if it took long.

    Example:
        >>> import pointloom as loom
        >>> mesh = loom.datasets.object_mesh()
        >>> mesh.is_watertight(), round(float(mesh.get_max_bound()[2] - mesh.get_min_bound()[2]), 2)
        (True, 0.3)
    """

    def make() -> Arrays:
        mesh = owl()
        return {name: getattr(mesh, name) for name in ("vertices", "triangles", "vertex_colors", "vertex_normals")}

    return TriangleMesh(**cached("object_mesh", {}, make))


def object_scans(count: int = 10, *, noise: bool = True, seed: int = 0) -> PosedScans:
    """Scans of the owl of `object_mesh` from all sides by a depth camera 0.6 m away.

    The camera circles once, alternating between 15 and 35 degrees above. Surfaces seen at more than 78 degrees to the
    normal are missing.

    Args:
        count: Number of scans, evenly spaced.
        noise: Add 0.5 mm of noise along each ray and 2 of 255 to colors. Without it points are on the mesh.
        seed: Seed of the noise.

    Returns:
        `scans`: clouds of about 15,000 points [m] in the camera frame (x right, y down, z forward), with `colors`.
        `poses`: T_object_camera, float64 (n, 4, 4) [m], in the frame of `object_mesh`.

    Raises:
        TypeError: A count that is not an integer.
        ValueError: A count below 1.

    Notes:
        Bitwise reproducible. Cached in the user's cache folder if it took long.

    Example:
        >>> import pointloom as loom
        >>> scans = loom.datasets.object_scans(2, noise=False)
        >>> scene = loom.RaycastingScene()
        >>> mesh = loom.datasets.object_mesh()
        >>> added = scene.add_triangles(mesh.vertices.astype("float32"), mesh.triangles)
        >>> points = scans.in_world(1).points.astype("float32")
        >>> bool(scene.compute_distance(points).max() < 1e-5)
        True
    """
    count, noise, seed = check_count("count", count), bool(noise), check_seed(seed)
    poses = ring(count, CAMERA_DISTANCE, CAMERA_ELEVATIONS, start=-math.pi / 2)

    def make() -> Arrays:
        mesh, rng, scans = object_mesh(), np.random.default_rng(seed), []
        scene = scene_of(mesh)
        v, u = np.mgrid[: SCAN_CAMERA.height, : SCAN_CAMERA.width]
        directions = np.stack(
            [(u - SCAN_CAMERA.cx) / SCAN_CAMERA.fx, (v - SCAN_CAMERA.cy) / SCAN_CAMERA.fy, np.ones(u.shape)], axis=-1
        )
        for T in poses:
            view = view_mesh(mesh, scene, SCAN_CAMERA, T)
            seen = (view.depth > 0) & (view.cosine > MIN_INCIDENCE_COSINE)
            points, colors = directions[seen] * view.depth[seen, None], view.colors[seen]
            if noise:
                ranges = np.linalg.norm(points, axis=1, keepdims=True)
                points *= 1 + rng.normal(0, RANGE_NOISE, (len(points), 1)) / ranges
                colors = np.clip(colors + rng.normal(0, COLOR_NOISE, colors.shape), 0, 1)
            scans.append((points.astype(np.float32), colors.astype(np.float32)))
        columns = {"points": np.concatenate([p for p, _ in scans]), "colors": np.concatenate([c for _, c in scans])}
        return columns | {"counts": np.array([len(p) for p, _ in scans])}

    arrays = cached("object_scans", {"count": count, "noise": noise, "seed": seed}, make)
    ends = np.cumsum(arrays["counts"])[:-1]
    pairs = zip(np.split(arrays["points"], ends), np.split(arrays["colors"], ends), strict=True)
    return PosedScans([PointCloud(points, colors=colors) for points, colors in pairs], poses)
