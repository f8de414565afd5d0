"""`loom.reconstruct` as Python calls it: any frames, by either method what the command gives, wrong arguments."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import pointloom as loom
from pointloom.app.shell.cli import cli
from pointloom.rgbd.reconstruction.config import ReconstructionConfig
from pointloom.rgbd.reconstruction.fragment_model import FragmentOptions

from ..sequences import CAMERA, waves


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    path = tmp_path_factory.mktemp("frames") / "waves"
    loom.record_frames(loom.frames_from(waves(), CAMERA), path)
    return path


def command(*words: object) -> dict[str, Any]:
    shown = CliRunner().invoke(cli, ["reconstruct", *map(str, words), "--device", "cpu", "--json"])
    assert shown.exit_code in (0, 3), shown.stderr
    return json.loads(shown.stdout)


def test_a_list_and_a_generator_give_the_same_mesh():
    listed, streamed = loom.frames_from(waves(), CAMERA), loom.frames_from(iter(waves()), CAMERA)
    first, second = (loom.reconstruct(frames, voxel_size=0.02) for frames in (listed, streamed))
    np.testing.assert_array_equal(first.mesh.vertices, second.mesh.vertices)
    assert len(first.mesh) > 100
    assert first.to_json() == second.to_json()


@pytest.mark.parametrize("frames", [[], iter([])], ids=["a list", "a generator"])
def test_no_frame_at_all_is_refused(frames):
    with pytest.raises(ValueError, match="frames: expected at least one frame"):
        loom.reconstruct(loom.frames_from(frames, CAMERA))


def test_one_frame_is_a_mesh_already():
    result = loom.reconstruct(loom.frames_from(waves()[:1], CAMERA), voxel_size=0.02)
    assert (result.method, len(result.trajectory), result.error, result.poor) == ("slam", 1, None, None)
    assert len(result.mesh) > 100


def test_an_empty_mesh_is_a_poor_result():
    blank = [(None, np.zeros((48, 64), np.uint16))] * 2
    result = loom.reconstruct(loom.frames_from(blank, CAMERA))
    assert len(result.mesh) == len(result.trajectory) == 0
    assert "check the depth maps" in str(result.poor)


def test_the_command_gives_the_same_bits_and_figures(folder, tmp_path):
    words = ["--voxel", 0.02, "--trajectory", tmp_path / "poses.log"]
    report = command(folder, "-o", tmp_path / "mesh.ply", *words)
    result = loom.reconstruct(loom.open_frames(folder), voxel_size=0.02)
    loom.write_triangle_mesh(tmp_path / "own.ply", result.mesh)
    loom.write_trajectory(tmp_path / "own.log", result.trajectory)
    assert (tmp_path / "own.ply").read_bytes() == (tmp_path / "mesh.ply").read_bytes()
    assert (tmp_path / "own.log").read_bytes() == (tmp_path / "poses.log").read_bytes()
    assert report.items() >= json.loads(json.dumps(result.to_json())).items()
    assert result.error is not None and report["errors"]["absolute"]["m"]["rmse"] == pytest.approx(
        result.error.absolute_translation.rmse
    )


def test_by_fragments_the_command_gives_the_same_bits_and_figures(folder, tmp_path):
    words = ["--method", "fragments", "--voxel", 0.02, "--work", tmp_path / "stages"]
    report = command(folder, "-o", tmp_path / "mesh.ply", *words)
    config = ReconstructionConfig(depth_max=4.0, tsdf_voxel_size=0.02)
    result = loom.reconstruct(loom.open_frames(folder), fragments=FragmentOptions(tmp_path / "own", config))
    assert result.method == report["method"] == "fragments"
    loom.write_triangle_mesh(tmp_path / "own.ply", result.mesh)
    assert (tmp_path / "own.ply").read_bytes() == (tmp_path / "mesh.ply").read_bytes()
    own = json.loads(json.dumps(result.to_json())) | {"work": report["work"]}
    assert report.items() >= own.items()
    for label in ("frames", "fragments", "stages", "mesh", "bounds"):
        assert f"  {label} " in str(result)
