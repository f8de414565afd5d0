"""Lengths printed by commands for files in units other than meters."""

import json
import re

import numpy as np
import pytest

import pointloom as loom

from .commands import answer, run


@pytest.fixture
def feet(tmp_path, rng):
    path = tmp_path / "feet.ply"
    points = np.column_stack([rng.random((2000, 2)) * 10, 0.001 * rng.normal(size=2000)])
    loom.write_point_cloud(path, loom.PointCloud(points, unit="foot"))
    return path


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["downsample", "--voxel", 1], "one a voxel of 1 ft"),
        (["cluster", "--eps", 0.001], "eps 0.001 ft"),
        (["cluster", "--eps", 0.001], "no point has 10 points within 0.001 ft"),
        (["normals", "--radius", 0.001], r"within 0.001 ft, .* have 3 within \S+ ft:"),
        (["clean", "--radius", 0.001, "--min-neighbors", 5], r"within 0.001 ft; .* within \S+ ft:"),
        (["mesh", "--method", "alpha", "--alpha", 1], "ft^2"),
    ],
)
def test_lengths_are_printed_in_the_unit_of_the_file(words, message, feet, tmp_path):
    result = run(words[0], feet, tmp_path / "out.ply", *words[1:], "--device", "cpu")
    assert re.search(message.replace("^", r"\^"), result.stdout + result.stderr), result.stdout + result.stderr
    note = f"note: the unit of {feet} is foot (0.3048 m): all lengths, input and output, are in this unit\n"
    assert note in result.stderr
    if (tmp_path / "out.ply").exists():
        (report,) = answer("info", tmp_path / "out.ply")["files"]
        assert report["unit"] == "foot"


def test_json_contains_the_unit(feet, tmp_path):
    result = run("downsample", feet, tmp_path / "out.npz", "--voxel", 1, "--json", "--device", "cpu")
    assert result.stderr == "" and json.loads(result.stdout)["unit"] == "foot"


def test_files_in_meters_or_of_unknown_unit_are_reported_in_meters(tmp_path):
    for unit in (None, "metre"):
        loom.write_point_cloud(tmp_path / "a.npz", loom.PointCloud(np.eye(3), unit=unit))
        result = run("downsample", tmp_path / "a.npz", tmp_path / "b.ply", "--voxel", 1, "--force", "--device", "cpu")
        assert "one a voxel of 1 m, the mean\n" in result.stdout and "note" not in result.stderr
        (report,) = answer("info", tmp_path / "a.npz")["files"]
        assert report.get("unit") == unit


@pytest.mark.filterwarnings("always::pointloom.UnitWarning")
def test_files_in_different_units_cause_a_warning(feet, tmp_path):
    other = tmp_path / "meters.ply"
    cloud = loom.read_point_cloud(feet)
    loom.write_point_cloud(other, cloud.to_unit("metre"))
    result = run("register", feet, other, "--init", "identity", "--voxel", 1, "--device", "cpu")
    assert "warning: source, target: expected one unit of length, got foot and metre" in result.stderr
    result = run("register", feet, feet, "--init", "identity", "--voxel", 1, "--device", "cpu")
    assert "warning" not in result.stderr
    assert "one per voxel of 1 ft" in result.stdout and " ft at the middle of the source" in result.stdout


@pytest.mark.filterwarnings("always::pointloom.UnitWarning")
def test_formats_without_a_unit_cause_a_warning(feet, tmp_path):
    result = run("convert", feet, tmp_path / "a.xyz")
    assert result.exit_code == 0 and "coordinates are in foot" in result.stderr
    result = run("convert", feet, tmp_path / "a.e57")
    assert result.exit_code == 0 and "meters by its standard" in result.stderr
    assert loom.read_point_cloud(tmp_path / "a.e57").points.max() < 3.05


def test_meshes_are_compared_in_their_unit(tmp_path):
    for name, size in (("a.ply", 1.0), ("b.ply", 1.1)):
        mesh = loom.TriangleMesh.create_box(size, size, size)
        mesh.unit = "US survey foot"
        loom.write_triangle_mesh(tmp_path / name, mesh)
    result = run("compare-meshes", tmp_path / "a.ply", tmp_path / "b.ply", "--samples", 500, "--device", "cpu")
    assert re.search(r"chamfer +0\.\d+ US ft\n", result.stdout) and " US ft from A to B" in result.stdout
