"""Check an installed pointloom: operations with known results, without a checkout, network, or writable home folder.

    python -I scripts/smoke.py

Prints a line per check. The exit code is 1 if one failed, or if a kernel had to be compiled: wheels contain all CPU
kernels.
"""

from __future__ import annotations

import json
import logging
import subprocess
import sys
import sysconfig
import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np

import pointloom as loom


def grid(count: int = 40) -> np.ndarray:
    """`count`^2 points of the plane z = 0 at a distance of 0.1."""
    x, y = np.meshgrid(np.arange(count), np.arange(count))
    return 0.1 * np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)


def bumps() -> np.ndarray:
    """A surface that has one best alignment with itself."""
    points = grid()
    points[:, 2] = 0.3 * np.sin(2.1 * points[:, 0]) * np.cos(1.3 * points[:, 1])
    return points


def voxels() -> None:
    # Voxels begin half a voxel before the first point: 2, 12 x 3 and 2 points along each axis.
    assert len(loom.PointCloud(grid()).voxel_down_sample(0.3)) == 14 * 14


def normals() -> None:
    result = loom.PointCloud(grid()).estimate_normals(radius=0.25, max_nn=20)
    assert np.allclose(np.abs(np.asarray(result.normals)), [0, 0, 1], atol=1e-5)


def neighbors() -> None:
    cloud = loom.PointCloud(grid())
    squares = np.asarray(loom.NearestNeighborSearch(cloud).knn_search(cloud, 2).sqdists)
    assert np.allclose(squares, [0, 0.01], atol=1e-5)


def plane() -> None:
    points = np.concatenate([grid(), grid(10) + np.array([0, 0, 1])])
    coefficients, inliers = loom.PointCloud(points).segment_plane(0.01, ransac_n=3, num_iterations=200)
    assert len(inliers) == 1600
    assert np.allclose(np.abs(np.asarray(coefficients)), [0, 0, 1, 0], atol=1e-4)


def icp() -> None:
    target = loom.PointCloud(bumps()).estimate_normals(radius=0.25, max_nn=20)
    source = loom.PointCloud(bumps() + np.array([0.02, -0.01, 0.015]))
    method = loom.registration.TransformationEstimationPointToPlane()
    result = loom.registration.registration_icp(source, target, 0.2, None, method)
    assert np.allclose(np.asarray(result.transformation)[:3, 3], [-0.02, 0.01, -0.015], atol=1e-3)


def surface() -> None:
    axis = np.linspace(-1, 1, 33)
    x, y, z = np.meshgrid(axis, axis, axis, indexing="ij")
    mesh = loom.meshing.marching_cubes((np.sqrt(x * x + y * y + z * z) - 0.7).astype(np.float32))
    assert mesh.is_watertight()
    assert abs(mesh.get_volume() * (2 / 32) ** 3 / (4 / 3 * np.pi * 0.7**3) - 1) < 0.02


def files() -> None:
    points = grid()
    with tempfile.TemporaryDirectory() as folder:
        for ending in ("ply", "pcd", "npz"):
            path = Path(folder, f"grid.{ending}")
            loom.write_point_cloud(path, loom.PointCloud(points))
            assert np.allclose(np.asarray(loom.read_point_cloud(path).points), points, atol=1e-6), ending


def commands() -> None:
    program = Path(sysconfig.get_path("scripts"), "pointloom")
    doctor = subprocess.run([program, "doctor", "--json"], capture_output=True, text=True, check=True)
    assert json.loads(doctor.stdout)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "grid.ply")
        loom.write_point_cloud(path, loom.PointCloud(grid()))
        info = subprocess.run([program, "info", path, "--json"], capture_output=True, text=True, check=True)
        assert "1600" in info.stdout


CHECKS: list[Callable[[], None]] = [voxels, normals, neighbors, plane, icp, surface, files, commands]


class Compilations(logging.Handler):
    """Count the kernels that are compiled at first use."""

    count = 0

    def emit(self, record: logging.LogRecord) -> None:
        """Count a record of the compiler."""
        self.count += bool(getattr(record, "compiles", False))


def main() -> int:
    """Run the checks; returns the exit code."""
    compilations, failed = Compilations(logging.INFO), 0
    logging.getLogger("pointloom").setLevel(logging.INFO)
    logging.getLogger("pointloom").addHandler(compilations)
    for check in CHECKS:
        try:
            check()
        except Exception as error:  # each check is reported
            failed += 1
            print(f"{check.__name__}: failed: {type(error).__name__}: {error}")
        else:
            print(f"{check.__name__}: passed")
    if compilations.count:
        print(f"{compilations.count} modules of kernels were compiled, expected none")
    print(
        f"{len(CHECKS) - failed} of {len(CHECKS)} checks passed, pointloom {loom.__version__}, {sys.version.split()[0]}"
    )
    return int(bool(failed or compilations.count))


if __name__ == "__main__":
    sys.exit(main())
