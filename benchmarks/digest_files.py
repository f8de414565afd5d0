"""The files of digests.py: the bytes of each format that the library writes.

An E57 file contains random identifiers and their checksums, so the digest is of the values read from it.
"""

from __future__ import annotations

import re
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from digest_scenes import Scenes, loom, pose_of, reg
from numpy.typing import NDArray

CLOUDS = {
    "ply": {}, "ascii.ply": {"write_ascii": True}, "pcd": {}, "ascii.pcd": {"write_ascii": True}, "npz": {}, "xyz": {},
    "xyzn": {}, "xyzrgb": {}, "pts": {}, "las": {"scale": 1e-4}, "laz": {"scale": 1e-4}, "copc.laz": {"scale": 1e-4},
}  # fmt: skip
LEFT_OUT = {
    "xyz": ("normals", "colors", "intensity", "label"), "xyzn": ("colors", "intensity", "label"),
    "xyzrgb": ("normals", "intensity", "label"), "pts": ("normals", "label"),
}  # fmt: skip
MESHES = {"ply": {}, "ascii.ply": {"write_ascii": True}, "obj": {}, "stl": {}, "off": {}, "glb": {}, "gltf": {}}

# Times that formats require.
CHANGING = re.compile(rb"\d{4}-\d\d-\d\dT[\d:.]+Z?")


def contents(write: Callable[[Path], Any]) -> dict[str, NDArray[np.uint8]]:
    """The bytes of the files that a function writes into a folder, by name."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write(folder)
        files = sorted(path for path in folder.rglob("*") if path.is_file())
        return {str(path.relative_to(folder)): np.frombuffer(plain(path.read_bytes()), np.uint8) for path in files}


def plain(data: bytes) -> bytes:
    """The contents of a file without folder paths and times."""
    return CHANGING.sub(b"", data.replace(tempfile.gettempdir().encode(), b""))


def finite(some: Any) -> Any:
    """The cloud without invalid points: LAS and E57 do not store them."""
    return some.remove_non_finite_points()


def cloud(ending: str, options: dict[str, Any]) -> Callable[[Scenes], Any]:
    def write(d: Scenes) -> Any:
        some = finite(d.surface.facing).without(*LEFT_OUT.get(ending, ()))
        return contents(lambda folder: loom().write_point_cloud(folder / f"cloud.{ending}", some, **options))

    return write


def mesh(ending: str, options: dict[str, Any]) -> Callable[[Scenes], Any]:
    def write(d: Scenes) -> Any:
        ball = d.ball.compute_vertex_normals()
        ball.vertex_colors = np.abs(ball.vertex_normals)
        return contents(lambda folder: loom().write_triangle_mesh(folder / f"mesh.{ending}", ball, **options))

    return write


def poses(d: Scenes) -> Any:
    def write(folder: Path) -> None:
        path = loom().Trajectory(np.stack([np.eye(4), d.surface.pose]), timestamps=np.array([1.5, 2.25]))
        camera = loom().PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.2, 23.7)
        for ending in ("log", "tum", "kitti"):
            loom().write_trajectory(folder / f"path.{ending}", path)
        loom().write_trajectory(folder / "path.json", path, intrinsic=camera)
        camera.write(folder / "camera.json")

    return contents(write)


def images(d: Scenes) -> Any:
    return contents(lambda folder: loom().write_image(folder / "paint.png", d.paint))


def volumes(d: Scenes) -> Any:
    return contents(lambda folder: d.volume.save(folder / "volume.npz"))


def graph(d: Scenes) -> Any:
    return contents(lambda folder: reg().write_pose_graph(folder / "graph.json", reg().PoseGraph()))


def view(d: Scenes) -> Any:
    points = finite(d.surface.cloud).points
    fitted, bounds = loom().View.fit(points, width=64, height=48), (points.min(axis=0), points.max(axis=0))
    return contents(lambda folder: loom().write_view(folder / "view.json", fitted, bounds))


def stations(d: Scenes) -> Any:
    some, poses = finite(d.surface.facing).without("label"), [np.eye(4), d.surface.pose]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "stations.e57"
        loom().write_stations(path, [some, some], poses)
        read = loom().read_stations(path)
    return read


def model(d: Scenes) -> Any:
    """A model of two images and five points."""
    poses, points = np.stack([np.eye(4), pose_of(5.0, [0.1, 0.0, 0.0])]), np.add(np.eye(5, 3), [0, 0, 4])
    lens = loom().CameraModel("SIMPLE_RADIAL", 640, 480, [500.0, 320.0, 240.0, -0.05])
    rows = [(image, point) for image in range(2) for point in range(5)]
    pixels = np.arange(20.0).reshape(10, 2) + 100
    given = (["a.jpg", "b/c.png"], [lens, lens], poses, points, np.full((5, 3), 7, np.uint8), np.ones(5), rows, pixels)
    result = loom().SfmModel(*given)

    def write(folder: Path) -> None:
        loom().write_colmap_model(folder / "bin", result)
        loom().write_colmap_model(folder / "txt", result, format="txt")
        loom().write_transforms(folder / "transforms.json", result)

    return contents(write)


def splats(ending: str) -> Callable[[Scenes], Any]:
    rng = np.random.default_rng(3)
    centers, quaternions, colors = rng.normal(size=(20, 3)), rng.normal(size=(20, 4)), rng.normal(size=(20, 3))
    given = (centers, rng.uniform(0.1, 1.0, (20, 3)), quaternions, rng.uniform(0.1, 0.9, 20), colors)

    def write(d: Scenes) -> Any:
        result = loom().GaussianSplats(*given, device=d.device)
        return contents(lambda folder: loom().write_splats(folder / f"splats.{ending}", result))

    return write


def polygon(d: Scenes) -> Any:
    return contents(lambda folder: d.surface.polygon.to_json(folder / "polygon.json"))


def grids(d: Scenes) -> Any:
    """An occupancy grid and a textured mesh."""
    grid = loom().OccupancyGrid(0.05, device=d.device)
    grid.insert_scan(d.ball.vertices[::7], np.zeros(3))
    textured = loom().TriangleMesh.create_plane(create_uv_map=True, device=d.device)
    textured.textures = [np.arange(4 * 4 * 3, dtype=np.uint8).reshape(4, 4, 3)]

    def write(folder: Path) -> None:
        grid.save(folder / "grid.npz")
        for ending in ("obj", "glb"):
            loom().write_triangle_mesh(folder / f"textured.{ending}", textured)

    return contents(write)


def recording(ending: str) -> Callable[[Scenes], Any]:
    def write(folder: Path, d: Scenes) -> None:
        with loom().record(folder / f"film.{ending}", size=(64, 48)) as film:
            film.add("cloud", d.surface.cloud)
            film.step()
            film.set_pose("cloud", d.surface.pose)
            film.step()

    return lambda d: contents(lambda folder: write(folder, d))


WRITTEN: dict[str, Callable[[Scenes], Any]] = {
    **{f"file cloud.{ending}": cloud(ending, options) for ending, options in CLOUDS.items()},
    **{f"file mesh.{ending}": mesh(ending, options) for ending, options in MESHES.items()},
    "file trajectories": poses,
    "file images": images,
    "file volume": volumes,
    "file pose graph": graph,
    "file view": view,
    "file stations": stations,
    "file model": model,
    "file polygon": polygon,
    "file grid, textured meshes": grids,
    **{f"file splats.{ending}": splats(ending) for ending in ("ply", "splat", "spz")},
    **{f"file recording.{ending}": recording(ending) for ending in ("gif", "html")},
}
