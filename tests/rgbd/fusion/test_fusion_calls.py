"""`loom.fuse` as Python calls it: any frames, what the command gives, and wrong arguments refused by name."""

from __future__ import annotations

import json

import numpy as np
import pytest
from click.testing import CliRunner

import pointloom as loom
from pointloom.app.shell.cli import cli
from pointloom.core.timing import Clock

from ..sequences import CAMERA, waves
from .walls import Wall


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Six frames of a wavy wall on disk, with poses, the camera moving along it."""
    path = tmp_path_factory.mktemp("frames") / "waves"
    loom.record_frames(loom.frames_from(waves(), CAMERA), path)
    return path


def same_meshes(*meshes: loom.TriangleMesh) -> None:
    for name in ("vertices", "triangles", "vertex_colors"):
        first, *others = (getattr(mesh, name) for mesh in meshes)
        for other in others:
            np.testing.assert_array_equal(first, other)
    assert len(meshes[0]) > 100


@pytest.mark.parametrize("refine", [False, True], ids=["as given", "refined"])
def test_a_list_a_generator_and_a_folder_give_the_same_bits(folder, refine):
    listed, streamed = loom.frames_from(waves(), CAMERA), loom.frames_from(iter(waves()), CAMERA)
    options = {"voxel_size": 0.02, "refine": refine}
    results = [loom.fuse(frames, **options) for frames in (listed, streamed, loom.open_dataset(folder))]
    same_meshes(*(result.mesh for result in results))
    assert [result.frame_count for result in results] == [6, 6, 6]


def test_frames_whose_number_nobody_knows_are_counted_as_they_come():
    told = []
    loom.fuse(loom.frames_from(iter(waves()), CAMERA), voxel_size=0.05, progress=lambda *step: told.append(step))
    assert told == [*(("frames", i, 0) for i in range(7)), ("extract", 0, 0)]


@pytest.mark.parametrize("frames", [[], iter([])], ids=["a list", "a generator"])
def test_no_frame_at_all_is_refused(frames):
    with pytest.raises(ValueError, match="frames: expected at least one frame"):
        loom.fuse(loom.frames_from(frames, CAMERA))


def test_one_frame_is_a_surface_already():
    result = loom.fuse(loom.frames_from(waves()[:1], CAMERA), voxel_size=0.02)
    assert (result.frame_count, result.weight_threshold, result.poor) == (1, 0.0, None)
    assert len(result.mesh) > 100
    refined = loom.fuse(loom.frames_from(waves()[:1], CAMERA), voxel_size=0.02, refine=True)
    assert refined.refinement is not None and refined.refinement.poor is None


def test_a_frame_without_a_pose_is_named():
    frames = [(None, np.full((48, 64), 1000, np.uint16))]
    with pytest.raises(ValueError, match="frame frame-000000: has no pose"):
        loom.fuse(loom.frames_from(frames, CAMERA))


def test_pictures_without_a_camera_are_sent_to_frames_from():
    with pytest.raises(TypeError, match=r"frames: expected RGB-D frames of one camera, got list; loom\.frames_from"):
        loom.fuse([(None, np.ones((48, 64), np.uint16))])  # type: ignore[arg-type]


def test_a_clock_counts_the_stages():
    clock = Clock()
    loom.fuse(Wall(3), voxel_size=0.05, clock=clock)
    assert list(clock.seconds) == ["read", "integrate", "extract", "check"]


@pytest.mark.parametrize("refine", [False, True], ids=["as given", "refined"])
def test_the_command_gives_the_same_bits_figures_and_lines(folder, tmp_path, refine):
    words = ["fuse", str(folder), "-o", str(tmp_path / "mesh.ply"), "--voxel", "0.02", "--device", "cpu"]
    words += ["--refine"] if refine else []
    shown = CliRunner().invoke(cli, words)
    printed = CliRunner().invoke(cli, [*words, "--force", "--json"])
    assert (shown.exit_code, printed.exit_code) == (0, 0)
    result = loom.fuse(loom.open_dataset(folder), voxel_size=0.02, refine=refine)
    loom.write_triangle_mesh(tmp_path / "own.ply", result.mesh)
    assert (tmp_path / "own.ply").read_bytes() == (tmp_path / "mesh.ply").read_bytes()
    report = json.loads(printed.stdout)
    assert report.items() >= json.loads(json.dumps(result.to_json())).items()
    assert set(report) - set(result.to_json()) == {
        *("command", "dataset", "layout", "left_out", "camera", "seconds", "peak_bytes", "files", "poor")
    }
    unpadded = [line.split() for line in shown.stdout.splitlines()]
    for line in str(result).splitlines():
        assert any(told[: len(line.split())] == line.replace("volume", "volume,").split() for told in unpadded), line
