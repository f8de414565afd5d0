"""Files of docs/other-tools.md, read and written by CloudCompare and PDAL where these programs are installed."""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom

from ..page_blocks import blocks_of

UTM = np.array([500_000.0, 5_400_000.0, 300.0])


def run(folder: Path, *command: str) -> str:
    if shutil.which(command[0]) is None:
        pytest.skip(f"the program {command[0]} is not installed")
    settings = os.environ | {"QT_QPA_PLATFORM": "offscreen"}  # CloudCompare without a display
    return subprocess.run(
        command, cwd=folder, env=settings, check=True, capture_output=True, text=True, timeout=60
    ).stdout


def cloudcompare(folder: Path, name: str, *options: str) -> Path:
    """Load a file and save it as out.ply."""
    run(folder, "CloudCompare", "-SILENT", "-O", *options, name, "-C_EXPORT_FMT", "PLY", "-M_EXPORT_FMT", "PLY",
        "-NO_TIMESTAMP", "-SAVE_CLOUDS" if "mesh" not in name else "-SAVE_MESHES", "FILE", "out.ply")  # fmt: skip
    return folder / "out.ply"


def test_cloudcompare_keeps_points_normals_colors_and_scalar_fields(tmp_path):
    rng = np.random.default_rng(0)
    points, normals = rng.random((1000, 3)), rng.normal(size=(1000, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    cloud = loom.PointCloud(
        points,
        normals=normals,
        colors=rng.integers(0, 256, (1000, 3)) / 255,
        scalar_height=points[:, 2],
        intensity=rng.random(1000),
        roughness=points[:, 0],
    )
    loom.write_point_cloud(tmp_path / "scan.ply", cloud)
    back = loom.read_point_cloud(cloudcompare(tmp_path, "scan.ply"))
    np.testing.assert_array_equal(back.points, cloud.points)
    np.testing.assert_allclose(back.normals, cloud.normals, atol=5e-3)  # CloudCompare stores normals in 21 bits
    np.testing.assert_allclose(back.colors, cloud.colors, atol=1e-6)
    assert set(back.attributes) == {"scalar_height", "scalar_intensity"}  # the page states that others are lost
    np.testing.assert_allclose(back["scalar_height"], cloud["scalar_height"], rtol=1e-6)
    np.testing.assert_allclose(back["scalar_intensity"], cloud["intensity"], rtol=1e-6)


def test_cloudcompare_needs_a_global_shift_for_large_coordinates(tmp_path):
    cloud = loom.PointCloud(np.random.default_rng(0).random((1000, 3)) * 50 + UTM)
    loom.write_point_cloud(tmp_path / "scan.ply", cloud)
    back = loom.read_point_cloud(cloudcompare(tmp_path, "scan.ply", "-GLOBAL_SHIFT", "AUTO"))
    np.testing.assert_allclose(back.points, cloud.points, rtol=0, atol=1e-4)
    without = loom.read_point_cloud(cloudcompare(tmp_path, "scan.ply"))
    assert np.abs(without.points - cloud.points).max() > 0.1  # [m], float32


@pytest.mark.parametrize("suffix", [".ply", ".obj"])
def test_cloudcompare_keeps_a_mesh(tmp_path, suffix):
    mesh = loom.TriangleMesh.create_sphere(0.5)
    loom.write_triangle_mesh(tmp_path / f"mesh{suffix}", mesh)
    back = loom.read_triangle_mesh(cloudcompare(tmp_path, f"mesh{suffix}"))
    np.testing.assert_allclose(back.vertices, mesh.vertices, atol=1e-6)
    np.testing.assert_array_equal(back.triangles, mesh.triangles)


def commands_of(program: str) -> list[list[str]]:
    """The commands of the page that start a program."""
    lines = [
        line
        for block in blocks_of("docs/other-tools.md")
        if block.language == "text"
        for line in block.code.splitlines()
    ]
    return [shlex.split(line) for line in lines if line.startswith(program)]


def test_the_command_of_cloudcompare_writes_a_file_that_pointloom_reads(tmp_path):
    points = np.random.default_rng(0).random((1000, 3))
    loom.write_point_cloud(tmp_path / "scan.ply", loom.PointCloud(points, scalar_roughness=points[:, 2]))
    (command,) = commands_of("CloudCompare")
    run(tmp_path, *command)
    (made,) = set(tmp_path.iterdir()) - {tmp_path / "scan.ply"}
    back = loom.read_point_cloud(made)
    assert 500 < len(back) < 1000
    separations = loom.PointCloud(back.points).compute_nearest_neighbor_distance()
    assert separations.min() >= 0.05 - 1e-6


def survey() -> loom.PointCloud:
    rng = np.random.default_rng(0)
    cloud = loom.PointCloud(
        rng.random((1000, 3)) * [100, 100, 5] + UTM,
        crs=25832,
        colors=rng.integers(0, 256, (1000, 3)) / 255,
        intensity=rng.integers(0, 60_000, 1000).astype(np.uint16),
        gps_time=rng.random(1000) * 1e5,
        return_number=rng.integers(1, 4, 1000).astype(np.uint8),
        number_of_returns=np.full(1000, 4, np.uint8),
        roughness=rng.random(1000),
    )
    cloud["classification"] = np.where(loom.classify_ground(cloud), 2, 1).astype(np.uint8)
    return cloud


DIMENSIONS = {
    "intensity": "Intensity",
    "gps_time": "GpsTime",
    "return_number": "ReturnNumber",
    "number_of_returns": "NumberOfReturns",
    "classification": "Classification",
    "roughness": "roughness",
}


@pytest.mark.parametrize("suffix", [".las", ".laz"])
def test_pdal_reads_points_and_all_attributes(tmp_path, suffix):
    cloud = survey()
    loom.write_point_cloud(tmp_path / f"a{suffix}", cloud)
    run(tmp_path, "pdal", "translate", f"{tmp_path}/a{suffix}", f"{tmp_path}/a.csv", "--writers.text.precision=9")
    names, *rows = (tmp_path / "a.csv").read_text().splitlines()
    columns = dict(zip(shlex.split(names.replace(",", " ")), np.loadtxt(rows, delimiter=",").T, strict=True))
    points = np.stack([columns[axis] for axis in "XYZ"], 1)
    np.testing.assert_allclose(points, cloud.points, rtol=0, atol=6e-6)  # the scale of the file is 1e-5 m
    for name, dimension in DIMENSIONS.items():
        np.testing.assert_allclose(columns[dimension], cloud[name], rtol=0, atol=1e-8, err_msg=name)
    np.testing.assert_allclose(columns["Green"] / 65_535, cloud.colors[:, 1], atol=1e-6)
    assert "25832" in run(tmp_path, "pdal", "info", "--metadata", f"{tmp_path}/a{suffix}")


@pytest.mark.parametrize("suffix", [".las", ".laz"])
def test_pointloom_reads_files_of_pdal(tmp_path, suffix):
    cloud = survey()
    loom.write_point_cloud(tmp_path / "a.laz", cloud)
    options = [f"--writers.las.{option}" for option in ("extra_dims=all", "forward=all", "minor_version=4")]
    run(tmp_path, "pdal", "translate", f"{tmp_path}/a.laz", f"{tmp_path}/b{suffix}", *options)
    back = loom.read_point_cloud(tmp_path / f"b{suffix}")
    np.testing.assert_allclose(back.points, cloud.points, rtol=0, atol=6e-6)
    np.testing.assert_allclose(back.colors, cloud.colors, atol=1e-6)
    for name in DIMENSIONS:
        np.testing.assert_allclose(back[name], cloud[name], rtol=0, atol=1e-8, err_msg=name)
    assert back.crs == cloud.crs
