"""Errors of surfaces reconstructed from points, beside Open3D from the same points.

    POINTLOOM_DATA=... python benchmarks/surface_errors.py [--method ball] [--only sofa] [--depth 8] [--pictures DIR]

For each scene (surface_scenes.py) and method: distances of the mesh, sampled by area, from the true surface, and of
the true surface's points from the mesh, median and 95 %. Poisson: vertices below the 1 % quantile of
the densities are removed, as in Open3D's tutorial.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import open3d as o3d
from surface_scenes import SAMPLES, Scene, distances_to, scenes

import pointloom as loom
from pointloom.visualization.render.picture_files import write_image
from pointloom.visualization.render.surface_picture import draw_surface

QUANTILE = 0.01


def pointloom_surface(scene: Scene, method: str, depth: int) -> Any:
    """pointloom's mesh of a scene."""
    cloud = loom.PointCloud(scene.points, normals=scene.normals)
    if method == "poisson":
        mesh, densities = loom.TriangleMesh.create_from_point_cloud_poisson(cloud, depth)
        return mesh.remove_vertices_by_mask(densities < np.quantile(densities, QUANTILE))
    if method == "ball":
        return loom.TriangleMesh.create_from_point_cloud_ball_pivoting(cloud, scene.radii)
    return loom.TriangleMesh.create_from_point_cloud_alpha_shape(cloud, scene.alpha)


def open3d_surface(scene: Scene, method: str, depth: int) -> Any:
    """Open3D's mesh of a scene, converted to pointloom's class."""
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(scene.points))
    cloud.normals = o3d.utility.Vector3dVector(scene.normals)
    kind = o3d.geometry.TriangleMesh
    if method == "poisson":
        mesh, densities = kind.create_from_point_cloud_poisson(cloud, depth=depth)
        mesh.remove_vertices_by_mask(np.asarray(densities) < np.quantile(densities, QUANTILE))
    elif method == "ball":
        mesh = kind.create_from_point_cloud_ball_pivoting(cloud, o3d.utility.DoubleVector(scene.radii))
    else:
        mesh = kind.create_from_point_cloud_alpha_shape(cloud, scene.alpha)
    return loom.TriangleMesh(np.asarray(mesh.vertices), np.asarray(mesh.triangles))


def measure(scene: Scene, mesh: Any) -> list[float]:
    """(mesh to truth, median and 95 %; truth to mesh, median and 95 %) [mm]; NaN without a mesh or ground truth."""
    if not len(mesh):
        return [np.nan] * 4
    errors = [scene.error_of(mesh.sample_points_uniformly(SAMPLES).points)]
    if scene.truth is not None:
        errors.append(distances_to(mesh.vertices, mesh.triangles)(scene.truth))
    quantiles = [1e3 * float(np.quantile(e, q)) for e in errors for q in (0.5, 0.95)]
    return quantiles + [np.nan] * (4 - len(quantiles))


def main() -> None:
    """Print the table of docs/surfaces.md."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--method", action="append", choices=("poisson", "ball", "alpha"), help="default: all")
    parser.add_argument("--only", action="append", help="scenes whose names start with this")
    parser.add_argument("--depth", type=int, default=8, help="depth of Poisson's octree")
    parser.add_argument("--pictures", type=Path, help="write an image of each of pointloom's meshes into this folder")
    arguments = parser.parse_args()
    o3d.utility.set_verbosity_level(o3d.utility.VerbosityLevel.Error)
    print("| scene | method | | triangles | mesh to truth, median / 95 % [mm] | truth to mesh [mm] |")
    print("|-|-|-|-|-|-|")
    makers: dict[str, Callable[..., Any]] = {"pointloom": pointloom_surface, "Open3D": open3d_surface}
    for scene in scenes(arguments.only):
        for method in arguments.method or ("poisson", "ball", "alpha"):
            for name, make in makers.items():
                mesh = make(scene, method, arguments.depth)
                a, b, c, d = measure(scene, mesh)
                figures = f"{a:.3g} / {b:.3g} | " + (f"{c:.3g} / {d:.3g}" if np.isfinite(c) else "-")
                print(f"| {scene.name} | {method} | {name} | {len(mesh):,} | {figures} |", flush=True)
                if arguments.images and name == "pointloom" and len(mesh):
                    arguments.images.mkdir(parents=True, exist_ok=True)
                    file = arguments.images / f"{scene.name.replace(' ', '_').replace(',', '')}-{method}.png"
                    write_image(file, draw_surface(mesh))


if __name__ == "__main__":
    main()
