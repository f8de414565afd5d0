"""Clouds with a known true surface, to measure the accuracy of surface reconstruction."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import open3d as o3d
from numpy.typing import NDArray
from real_data import DataMissingError, real_data

import pointloom as loom
from pointloom.core.devices import resolve_device
from pointloom.datasets.scenes.furniture import sofa
from pointloom.datasets.scenes.room import room_sequence, surface_errors
from pointloom.kernels.lang import vec3d
from pointloom.kernels.memory import download, upload
from pointloom.kernels.scenes.primitives import Solids, distance_to_solids
from pointloom.meshing.mesh.isosurface import marching_cubes

Array = NDArray[np.float64]
SAMPLES = 50_000  # of a true surface


@dataclass(frozen=True)
class Scene:
    """A cloud and its true surface.

    Attributes:
        name: Name of the scene.
        points, normals: float64 [n, 3], the input of both libraries.
        radii: For ball pivoting [m].
        alpha: For alpha shapes [m].
        error_of: Returns the distances [m] of points from the true surface.
        truth: Points of the true surface covered by the cloud, [k, 3]; None if unknown.
    """

    name: str
    points: Array
    normals: Array
    radii: tuple[float, ...]
    alpha: float
    error_of: Callable[[Any], Array]
    truth: Array | None


def ray_scene(vertices: Any, triangles: Any) -> Any:
    """Open3D's scene of a mesh, for distances from it."""
    scene = o3d.t.geometry.RaycastingScene()
    scene.add_triangles(
        o3d.core.Tensor(np.asarray(vertices, np.float32)), o3d.core.Tensor(np.asarray(triangles, np.uint32))
    )
    return scene


def distances_to(vertices: Any, triangles: Any) -> Callable[[Any], Array]:
    """A function that returns the distance of points from a mesh."""
    scene = ray_scene(vertices, triangles)
    return lambda points: scene.compute_distance(o3d.core.Tensor(np.asarray(points, np.float32))).numpy()


def spacing_of(points: Array) -> float:
    """Mean distance of a point from its nearest neighbor."""
    cloud = loom.PointCloud(points)
    return float(np.mean(cloud.compute_nearest_neighbor_distance()))


def _scene(name: str, points: Array, normals: Array, error_of: Any, truth: Array | None) -> Scene:
    step = spacing_of(points)
    radii = tuple(factor * step for factor in (1.5, 2.5, 4.0))
    return Scene(name, points, normals, radii, 3.0 * step, error_of, truth)


def sampled(name: str, mesh: Any, count: int, noise: float, normals: str) -> Scene:
    """Samples of a mesh with isotropic noise [m]; normals of the surface ("true") or fitted ("fitted")."""
    mesh.compute_vertex_normals()
    o3d.utility.random.seed(0)
    drawn = mesh.sample_points_uniformly(count)
    truth = np.asarray(mesh.sample_points_uniformly(SAMPLES).points)
    points = np.asarray(drawn.points) + np.random.default_rng(0).normal(0, noise, (count, 3)) * (noise > 0)
    known = np.asarray(drawn.normals)
    if normals == "fitted":
        known = fitted_normals(points, known)
    return _scene(name, points, known, distances_to(mesh.vertices, mesh.triangles), truth)


def fitted_normals(points: Array, sides: Array) -> Array:
    """Normals fitted to 30 neighbors, oriented like the given vectors."""
    normals = loom.PointCloud(points).estimate_normals(max_nn=30).normals.astype(np.float64)
    return normals * np.where((normals * sides).sum(axis=1) < 0, -1.0, 1.0)[:, None]


def cad_part() -> Scene:
    """The simulated scan of a CAD part of points2surf, with fitted and oriented normals."""
    name = "00011084_fddd53ce45f640f3ab922328_trimesh_019"
    mesh = o3d.io.read_triangle_mesh(str(real_data(f"mesh-points2surf-abc/03_meshes/{name}.ply")))
    points = np.loadtxt(real_data(f"mesh-points2surf-abc/04_pts_vis/{name}.xyz"))[:, :3]
    cloud = loom.PointCloud(points).estimate_normals(max_nn=30).orient_normals_consistent_tangent_plane(30)
    normals = cloud.normals.astype(np.float64)
    center = points.mean(axis=0)
    if ((points - center) * normals).sum() < 0:
        normals = -normals
    truth = np.asarray(mesh.sample_points_uniformly(SAMPLES).points)
    return _scene("CAD part, scanned", points, normals, distances_to(mesh.vertices, mesh.triangles), truth)


def bunny_scans() -> Scene:
    """The ten range scans of the bunny in one frame, with fitted normals; compared with the merged model."""
    folder = real_data("reg-bunny-scans")
    model = o3d.io.read_triangle_mesh(str(folder / "reconstruction/bun_zipper.ply"))
    parts, sides = [], []
    for line in (folder / "data/bun.conf").read_text().splitlines():
        words = line.split()
        if not words or words[0] != "bmesh":
            continue
        t, (x, y, z, w) = np.array(words[2:5], float), np.array(words[5:9], float)
        R = o3d.geometry.get_rotation_matrix_from_quaternion([w, -x, -y, -z])
        scan = np.asarray(o3d.io.read_point_cloud(str(folder / "data" / words[1])).points)
        parts.append(scan @ R.T + t)
        sides.append(np.tile(R @ [0.0, 0.0, 1.0], (len(scan), 1)))  # the scanner looks along -z
    points = np.concatenate(parts)
    normals = fitted_normals(points, np.concatenate(sides))
    truth = np.asarray(model.sample_points_uniformly(SAMPLES).points)
    truth = truth[distances_to_points(points, truth) < 1e-3]  # the part covered by the scans
    return _scene("bunny, 10 scans", points, normals, distances_to(model.vertices, model.triangles), truth)


def distances_to_points(points: Array, queries: Array) -> Array:
    """The distance of each query from its nearest point."""
    return loom.PointCloud(queries).compute_point_cloud_distance(loom.PointCloud(points))


def made_room() -> Scene:
    """The synthetic room scanned by a noisy depth camera in 40 frames: points and normals of the frames."""
    parts = []
    for frame in room_sequence(40, width=320, height=240):
        cloud = loom.PointCloud.create_from_depth_image(
            frame.depth, frame.intrinsic, np.linalg.inv(frame.T_world_camera), stride=2, with_normals=False
        )
        cloud = cloud.estimate_normals(max_nn=30)
        parts.append(cloud.orient_normals_towards_camera_location(frame.T_world_camera[:3, 3]))
    points = np.concatenate([part.points for part in parts])
    normals = np.concatenate([part.normals for part in parts]).astype(np.float64)
    cloud = loom.PointCloud(points, normals=normals).voxel_down_sample(0.02).normalize_normals()
    points, normals = cloud.points.copy(), cloud.normals.astype(np.float64)
    return _scene("room, depth camera", points, normals, surface_errors, None)


def made_sofa() -> Scene:
    """The sofa of the synthetic room: 60,000 points with 3 mm of noise, and normals fitted to 30 neighbors."""
    solids = sofa().solids(resolve_device("cpu"))
    cloud = scan_of(solids)

    def errors(points: Any) -> Array:
        return np.abs(distances_from(np.asarray(points, np.float64), solids))

    return _scene("sofa, scanned", cloud.points.copy(), cloud.normals.astype(np.float64), errors, None)


def scan_of(solids: Solids, cell: float = 0.03, noise: float = 0.003) -> loom.PointCloud:
    """Points on the surface of solids with noise [m]; a grid of `cell` [m] locates the surface."""
    extents, centers = download(solids.extents), download(solids.centers)
    radii = np.linalg.norm(extents[:, :3], axis=1) + extents[:, 3]
    low = (centers - radii[:, None]).min(axis=0) - 3 * cell
    high = (centers + radii[:, None]).max(axis=0) + 3 * cell
    axes = [np.arange(a, b, cell) for a, b in zip(low, high, strict=True)]
    nodes = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    field = distances_from(nodes.reshape(-1, 3), solids).reshape(nodes.shape[:3]).astype(np.float32)
    outline = marching_cubes(field, spacing=[cell] * 3, origin=low)
    cloud = outline.sample_points_uniformly(60_000, use_triangle_normal=True, seed=0)
    points = cloud.points - distances_from(cloud.points, solids)[:, None] * cloud.normals
    cloud.points = points + np.random.default_rng(0).normal(0, noise, points.shape)
    return cloud.estimate_normals(max_nn=30)


def distances_from(points: Array, solids: Solids) -> Array:
    """Signed distances of points [m] from solids, negative inside."""
    return download(distance_to_solids(upload(points, vec3d, solids.device), solids)).copy()


def scenes(only: list[str] | None = None) -> Iterator[Scene]:
    """All scenes with available data, the synthetic ones last, filtered by name prefix."""
    makers: dict[str, Callable[[], Scene]] = {"CAD part": cad_part, "bunny, 10 scans": bunny_scans}
    makers |= {row[0]: _mesh_scene(*row) for row in MESHES}
    makers |= {"room": made_room, "sofa": made_sofa}
    for name, make in makers.items():
        if only and not any(name.startswith(prefix) for prefix in only):
            continue
        try:
            yield make()
        except DataMissingError as error:
            print(f"left out: {error}")


MESHES = (
    ("bunny, exact", "stanford-bunny", 100_000, 0.0, "true"),
    ("bunny, 0.3 mm noise", "stanford-bunny", 100_000, 0.002, "fitted"),
    ("fandisk, noise", "fandisk", 60_000, 0.002, "fitted"),
    ("cheburashka, noise", "cheburashka", 60_000, 0.002, "fitted"),
)


def _mesh_scene(name: str, file: str, count: int, noise: float, normals: str) -> Callable[[], Scene]:
    """A scene of a mesh of the real data; noise as a fraction of its longest edge."""

    def make() -> Scene:
        mesh = o3d.io.read_triangle_mesh(str(real_data(f"mesh-common3d/{file}.obj")))
        extent = float(np.ptp(np.asarray(mesh.vertices), axis=0).max())
        return sampled(name, mesh, count, noise * extent, normals)

    return make
