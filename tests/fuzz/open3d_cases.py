"""Readers of `pointloom.open3d`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import mutations
import numpy as np
from job_cases import anything, arrays, saved, values
from public_cases import array, camera_list, depth_png, graph, image, mesh, polygon, write_cloud, written

import pointloom as loom
import pointloom.open3d as o3d
from pointloom.open3d.io.shapes import OF_POINTS

core, G, T = o3d.core, o3d.geometry, o3d.t.geometry


def cloud() -> Any:
    rng = np.random.default_rng(12)
    made = G.PointCloud(o3d.utility.Vector3dVector(rng.random((6, 3))))
    made.colors = o3d.utility.Vector3dVector(rng.random((6, 3)))
    return made


def write_lines(path: Path, *, ascii: bool = False) -> None:
    lines = G.LineSet(o3d.utility.Vector3dVector(np.eye(3)), o3d.utility.Vector2iVector([[0, 1], [2, 1]]))
    lines.colors = o3d.utility.Vector3dVector([[1, 0, 0.2], [0, 1, 0.4]])
    o3d.io.write_line_set(path, lines, write_ascii=ascii)


def write_grid(path: Path, *, ascii: bool = False) -> None:
    grid = G.VoxelGrid.create_from_point_cloud(cloud(), 0.3)
    grid.rotate(G.get_rotation_matrix_from_xyz([0.1, 0.2, 0.3]), [0, 0, 0])
    o3d.io.write_voxel_grid(path, grid, write_ascii=ascii)


def write_feature(path: Path) -> None:
    feature = o3d.pipelines.registration.Feature()
    feature.data = np.arange(12.0).reshape(4, 3)
    o3d.io.write_feature(path, feature)


def write_parameters(path: Path) -> None:
    parameters = o3d.camera.PinholeCameraParameters()
    parameters.intrinsic = o3d.camera.PinholeCameraIntrinsic(64, 48, 50, 50, 31.5, 23.5)
    o3d.io.write_pinhole_camera_parameters(path, parameters)


def write_mesh_archive(path: Path) -> None:
    made = T.TriangleMesh.from_legacy(G.TriangleMesh.from_native(mesh(textured=True)))
    made.vertex["heat"] = np.arange(8.0)[:, None]
    o3d.t.io.write_triangle_mesh(path, made)


def load_options(path: Path) -> Any:
    options = o3d.visualization.RenderOption()
    options.load_from_json(path)
    return options


def write_options(path: Path) -> None:
    o3d.visualization.RenderOption().save_to_json(path)


def sound_grid(path: Path, grid: Any) -> str | None:
    """Check that a voxel grid has finite voxels."""
    numbers = [*grid.origin, grid.voxel_size, *np.ravel(grid.rotation)]
    return None if np.isfinite(numbers).all() and len(grid.get_voxels()) >= 0 else "not finite"


def sound_lines(path: Path, lines: Any) -> str | None:
    """Check that lines are indices of finite points."""
    ends, points = np.asarray(lines.lines), np.asarray(lines.points)
    is_right = np.isfinite(points).all() and (not ends.size or 0 <= ends.min() <= ends.max() < len(points))
    return None if is_right else "invalid lines"


def sound_surface(path: Path, made: Any) -> str | None:
    """Check that triangles are indices of vertices."""
    ends = made.triangle.indices.numpy() if "indices" in made.triangle else np.zeros(0)
    return None if not ends.size or 0 <= ends.min() <= ends.max() < len(made.vertex.positions) else "invalid triangles"


io, tio = o3d.io, o3d.t.io
CAMERA = o3d.camera.PinholeCameraIntrinsic(9, 8, 7, 7, 4, 3)
BOTH = (lambda p: write_grid(p), lambda p: write_grid(p, ascii=True))
LINES = (lambda p: write_lines(p), lambda p: write_lines(p, ascii=True))
MESH = written(".ply", lambda p: loom.write_triangle_mesh(p, mesh()))


def mixed(rng: Any, data: bytes) -> bytes:
    """Mutations of text or of bytes, by the header of a .ply."""
    return (mutations.text if b"ascii" in data[:40] else mutations.binary)(rng, data)


# name, suffix, seeds, mutate, read, oracle: as in cases.Case
OPEN3D = [
    *((f"open3d cloud {end}", end, written(end, write_cloud), mutations.binary, io.read_point_cloud, anything)
      for end in OF_POINTS),
    *((f"open3d tensor cloud {end}", end, written(end, write_cloud), mutations.binary, tio.read_point_cloud, anything)
      for end in (".ply", ".pcd", ".npz", ".xyz", ".las")),
    ("open3d mesh", ".ply", MESH, mutations.binary, io.read_triangle_mesh, anything),
    ("open3d mesh .stl", ".stl", written(".stl", lambda p: loom.write_triangle_mesh(p, mesh())), mutations.binary,
     io.read_triangle_mesh, anything),
    ("open3d tensor mesh", ".ply", MESH, mutations.binary, tio.read_triangle_mesh, sound_surface),
    ("open3d tensor mesh .glb", ".glb", written(".glb", lambda p: loom.write_triangle_mesh(p, mesh(textured=True))),
     mutations.binary, tio.read_triangle_mesh, sound_surface),
    ("open3d tensor mesh .npz", ".npz", written(".npz", write_mesh_archive), arrays, tio.read_triangle_mesh,
     sound_surface),
    ("open3d line set", ".ply", written(".ply", *LINES), mixed, io.read_line_set, sound_lines),
    ("open3d voxel grid", ".ply", written(".ply", *BOTH), mixed, io.read_voxel_grid, sound_grid),
    ("open3d feature", ".bin", written(".bin", write_feature), mutations.binary, io.read_feature, anything),
    ("open3d image .png", ".png", lambda: [depth_png(), image("PNG"), image("PNG", "P"), image("PNG", "LA"),
                                           image("PNG", "RGBA"), image("PNG", "1")], mutations.binary, io.read_image,
     anything),
    ("open3d image .jpg", ".jpg", lambda: [image("JPEG"), image("JPEG", "L"), image("JPEG", "CMYK")], mutations.binary,
     tio.read_image, anything),
    ("open3d intrinsic", ".json",
     written(".json", lambda p: io.write_pinhole_camera_intrinsic(p, CAMERA)), values,
     io.read_pinhole_camera_intrinsic, anything),
    ("open3d parameters", ".json", written(".json", write_parameters), values, io.read_pinhole_camera_parameters,
     anything),
    ("open3d trajectory .json", ".json", written(".json", camera_list), values, io.read_pinhole_camera_trajectory,
     anything),
    ("open3d trajectory .log", ".log", lambda: [b"0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"], mutations.text,
     io.read_pinhole_camera_trajectory, anything),
    ("open3d pose graph", ".json", written(".json", graph), values, io.read_pose_graph, anything),
    ("open3d polygon", ".json", written(".json", polygon), values,
     o3d.visualization.read_selection_polygon_volume, anything),
    ("open3d options", ".json", written(".json", write_options), values, load_options, anything),
    ("open3d tensor", ".npy", lambda: [array(np.arange(12.0).reshape(3, 4)), array(np.array(5)),
                                       array(np.asfortranarray(np.eye(3, dtype=np.int16)))], mutations.binary,
     core.Tensor.load, anything),
    ("open3d voxel block grid", ".npz", saved(lambda p: loom.TSDFVolume(voxel_size=0.1).save(p)), arrays,
     T.VoxelBlockGrid.load, anything),
]  # fmt: skip
