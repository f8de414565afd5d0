"""`-` for standard input and output: the same bytes as with files, and one-line errors."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result

import pointloom as loom
from pointloom.cli.shell import pipes
from pointloom.cli.shell.cli import cli
from pointloom.io.bags import recording
from pointloom.io.meshes import tables
from pointloom.io.points.formats import READERS, WRITTEN

from .commands import run

ROOT = Path(__file__).resolve().parents[2]


def feed(content: bytes, *words: object) -> Result:
    return CliRunner().invoke(cli, [str(word) for word in words], input=content)


def start(*words: object, **streams) -> subprocess.Popen:
    environment = os.environ | {"PYTHONPATH": str(ROOT / "src")}
    words = [sys.executable, "-m", "pointloom", *map(str, words)]
    return subprocess.Popen(words, stderr=subprocess.PIPE, env=environment, **streams)


def test_pipes_support_the_extensions_of_files():
    meshes = [suffix for suffix in tables.MESHES if suffix != ".ply"]
    assert sorted(pipes.READ) == sorted(suffix[1:] for suffix in [*READERS, *meshes])
    assert sorted(pipes.RECORDINGS) == sorted(recording._READERS)
    assert sorted(pipes.WRITTEN) == sorted(suffix[1:] for suffix in [*WRITTEN, *meshes])


@pytest.mark.parametrize("extension", ["ply", "npz"])
def test_pipes_carry_the_same_bytes_as_files(cloud, tmp_path, extension):
    out = tmp_path / f"out.{extension}"
    assert run("downsample", cloud, out, "--every", "3").exit_code == 0
    piped = feed(cloud.read_bytes(), "downsample", "-", "-", "--every", "3", "--from", "ply", "--to", extension)
    assert piped.exit_code == 0, piped.stderr
    assert piped.stdout_bytes == out.read_bytes() and "standard input" in piped.stderr
    assert "files    standard output" in piped.stderr
    assert "pointloom-" not in piped.stderr  # no name of a temporary file


def test_info_reads_standard_input_among_files(cloud):
    result = feed(cloud.read_bytes(), "info", cloud, "-", "--from", "ply", "--json")
    first, second = json.loads(result.stdout)["files"]
    assert second == first | {"path": "standard input"}


def test_register_reads_one_of_its_clouds_from_a_pipe(cloud):
    words = ["--from", "ply", "--init", "identity", "--method", "point-to-point", "--voxel", "0.1", "--json"]
    piped = feed(cloud.read_bytes(), "register", "-", cloud, *words)
    assert piped.exit_code == 0, piped.stderr
    report = json.loads(piped.stdout)
    assert (report["source"], report["target"]) == ("standard input", str(cloud))
    np.testing.assert_allclose(report["transformation"], np.eye(4), atol=1e-6)


def test_a_damaged_cloud_in_a_pipe_is_named(cloud):
    for words in (["convert", "-", "-", "--from", "ply", "--to", "pcd"], ["info", "-", "--from", "ply"]):
        result = feed(cloud.read_bytes()[:-1], *words)
        assert result.exit_code == 1 and result.stdout == ""
        assert result.stderr.startswith("error: standard input (byte ")
    assert "standard input (byte 0): is empty" in feed(b"", "info", "-", "--from", "ply").stderr


def test_an_unreliable_result_writes_nothing_to_the_pipe_and_json_excludes_the_cloud(cloud, tmp_path):
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(np.full((4, 3), np.nan)))
    result = run("clean", tmp_path / "a.ply", "-", "--to", "ply")
    assert (result.exit_code, result.stdout_bytes) == (3, b"")
    result = run("convert", cloud, "-", "--to", "ply", "--json")
    assert result.exit_code == 2 and "--json and - both use standard output" in result.stderr


@pytest.mark.skipif(not hasattr(os, "openpty"), reason="this system has no pseudo-terminals")
@pytest.mark.parametrize(
    ("words", "end"),
    [
        pytest.param(["info", "-", "--from", "ply"], "input", marks=pytest.mark.slow),
        (["convert", "CLOUD", "-", "--to", "ply"], "output"),
    ],
)
def test_a_terminal_is_rejected_as_a_pipe(cloud, words, end):
    controller, terminal = os.openpty()
    words = [str(cloud) if word == "CLOUD" else word for word in words]
    stdin, stdout = (terminal, subprocess.PIPE) if end == "input" else (subprocess.DEVNULL, terminal)
    process = start(*words, stdin=stdin, stdout=stdout)
    _, stderr = process.communicate(timeout=300)
    os.close(terminal)
    os.close(controller)
    assert process.returncode == 2 and f"standard {end} is a terminal" in stderr.decode()


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no /dev/full")
@pytest.mark.slow
@pytest.mark.parametrize("words", ["info CLOUD --json", "info CLOUD", "convert CLOUD - --to ply"])
def test_a_full_disk_behind_standard_output_is_one_line(cloud, words):
    with Path("/dev/full").open("wb") as full:
        process = start(*(cloud if word == "CLOUD" else word for word in words.split()), stdout=full)
        _, stderr = process.communicate(timeout=300)
    assert process.returncode == 1
    assert stderr.decode().splitlines()[-1] == "error: standard output: No space left on device"
    assert b"Traceback" not in stderr and b"Exception ignored" not in stderr


@pytest.mark.slow
def test_a_closed_pipe_prints_no_error(cloud):
    read, write = os.pipe()
    os.close(read)
    process = start("info", cloud, "--json", stdout=write)
    os.close(write)
    _, stderr = process.communicate(timeout=300)
    assert (process.returncode, stderr) == (1, b"")


def test_separate_texture_files_are_rejected_for_a_pipe(tmp_path):
    mesh = loom.TriangleMesh.create_plane(create_uv_map=True)
    mesh.textures = [np.full((4, 4, 3), 200, np.uint8)]
    loom.write_triangle_mesh(tmp_path / "plane.glb", mesh)
    words = ("clean-mesh", tmp_path / "plane.glb", "-", "--to")
    refused = feed(b"", *words, "obj")
    assert refused.exit_code == 2 and "pass --to glb" in refused.stderr
    piped = feed(b"", *words, "glb")
    (tmp_path / "piped.glb").write_bytes(piped.stdout_bytes)
    assert loom.read_triangle_mesh(tmp_path / "piped.glb").textures[0].shape == (4, 4, 3)
