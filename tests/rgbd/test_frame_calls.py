"""`fuse`, `track`, `reconstruct`, `check_focal` accept any frames, match the commands, and depend on no threads."""

import json
import os
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import pointloom as loom
from pointloom.cli.shell.cli import cli
from pointloom.core.errors import FileError
from pointloom.core.timing import Clock
from pointloom.rgbd.reconstruction.config import ReconstructionConfig
from pointloom.rgbd.reconstruction.fragment_model import FragmentOptions

from ..products import few_quick
from .fusion.walls import Wall
from .sequences import CAMERA, turning_path, waves


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Six frames of a wavy wall on disk, with poses, the camera moving along it."""
    path = tmp_path_factory.mktemp("frames") / "waves"
    loom.record_frames(loom.frames_from(waves(), CAMERA), path)
    return path


@pytest.mark.parametrize("call", [loom.rgbd.fuse, loom.rgbd.track, loom.rgbd.reconstruct])
def test_no_frame_at_all_is_refused(call):
    for frames in ([], iter([])):
        with pytest.raises(ValueError, match="frames:"):
            call(loom.frames_from(frames, CAMERA))


def test_a_clock_counts_the_stages():
    fused, tracked = Clock(), Clock()
    loom.rgbd.fuse(Wall(3), voxel_size=0.05, clock=fused)
    loom.rgbd.track(loom.frames_from(waves()[:2], CAMERA), clock=tracked)
    assert list(fused.seconds) == ["read", "integrate", "extract", "check"]
    assert list(tracked.seconds) == ["read", "track"]


def run(*words: object, codes: tuple[int, ...] = (0,)) -> str:
    shown = CliRunner().invoke(cli, [*map(str, words), "--device", "cpu"])
    assert shown.exit_code in codes, shown.stderr
    return shown.stdout


def command(*words: object) -> dict[str, Any]:
    return json.loads(run("reconstruct", *words, "--json", codes=(0, 3)))


@few_quick(1, "refine", [False, True], ids=["as given", "refined"])
def test_a_list_a_generator_and_a_folder_give_the_same_bits(folder, refine):
    listed, streamed = loom.frames_from(waves(), CAMERA), loom.frames_from(iter(waves()), CAMERA)
    options = {"voxel_size": 0.02, "refine": refine}
    first, *others = (loom.rgbd.fuse(frames, **options) for frames in (listed, streamed, loom.open_dataset(folder)))
    assert first.frame_count == 6 and len(first.mesh) > 100
    for other in others:
        assert other.frame_count == 6
        for name in ("vertices", "triangles", "vertex_colors"):
            np.testing.assert_array_equal(getattr(other.mesh, name), getattr(first.mesh, name))


def test_frames_of_unknown_number_are_counted_as_they_arrive():
    reported = []
    loom.rgbd.fuse(
        loom.frames_from(iter(waves()), CAMERA), voxel_size=0.05, progress=lambda *step: reported.append(step)
    )
    assert reported == [*(("frames", i, 0) for i in range(7)), ("extract", 0, 0)]


def test_one_frame_is_a_surface_already():
    result = loom.rgbd.fuse(loom.frames_from(waves()[:1], CAMERA), voxel_size=0.02)
    assert (result.frame_count, result.weight_threshold, result.reliable) == (1, 0.0, True)
    assert len(result.mesh) > 100
    refined = loom.rgbd.fuse(loom.frames_from(waves()[:1], CAMERA), voxel_size=0.02, refine=True)
    assert refined.refinement is not None and refined.refinement.reliable


def test_a_frame_without_a_pose_is_named():
    frames = [(None, np.full((48, 64), 1000, np.uint16))]
    with pytest.raises(ValueError, match="frame frame-000000:"):
        loom.rgbd.fuse(loom.frames_from(frames, CAMERA))


def test_images_without_a_camera_are_sent_to_frames_from():
    with pytest.raises(TypeError, match="frames:"):
        loom.rgbd.fuse([(None, np.ones((48, 64), np.uint16))])  # type: ignore[arg-type]


@few_quick(1, "refine", [False, True], ids=["as given", "refined"])
def test_the_command_gives_the_same_bits_figures_and_lines(folder, tmp_path, refine):
    words = ["fuse", folder, "-o", tmp_path / "mesh.ply", "--voxel", 0.02, *(["--refine"] if refine else [])]
    shown, report = run(*words), json.loads(run(*words, "--force", "--json"))
    result = loom.rgbd.fuse(loom.open_dataset(folder), voxel_size=0.02, refine=refine)
    loom.write_triangle_mesh(tmp_path / "own.ply", result.mesh)
    assert (tmp_path / "own.ply").read_bytes() == (tmp_path / "mesh.ply").read_bytes()
    assert report.items() >= json.loads(json.dumps(result.to_dict())).items()
    more = {"command", "dataset", "layout", "left_out", "camera", "seconds", "peak_bytes", "files"}
    assert set(report) - set(result.to_dict()) == more
    unpadded = [" ".join(line.split()) + " " for line in shown.splitlines()]
    for line in str(result).splitlines():
        expected = " ".join(line.replace("volume", "volume,").split()) + " "
        assert any(printed.startswith(expected) for printed in unpadded), line


def test_one_frame_is_a_mesh_already():
    result = loom.rgbd.reconstruct(loom.frames_from(waves()[:1], CAMERA), voxel_size=0.02)
    assert (result.method, len(result.trajectory), result.error, result.warnings) == ("slam", 1, None, ())
    assert len(result.mesh) > 100


def test_an_empty_mesh_is_unreliable():
    result = loom.rgbd.reconstruct(loom.frames_from([(None, np.zeros((48, 64), np.uint16))] * 2, CAMERA))
    assert len(result.mesh) == len(result.trajectory) == 0 and "check the depth maps" in str(result.warnings)


def test_the_command_gives_the_same_bits_and_figures(folder, tmp_path):
    words = ["--voxel", 0.02, "--trajectory", tmp_path / "poses.log"]
    report = command(folder, "-o", tmp_path / "mesh.ply", *words)
    result = loom.rgbd.reconstruct(
        loom.frames_from(iter(waves()), CAMERA), voxel_size=0.02
    )  # read once, as from a camera
    loom.write_triangle_mesh(tmp_path / "own.ply", result.mesh)
    loom.write_trajectory(tmp_path / "own.log", result.trajectory)
    assert (tmp_path / "own.ply").read_bytes() == (tmp_path / "mesh.ply").read_bytes()
    assert (tmp_path / "own.log").read_bytes() == (tmp_path / "poses.log").read_bytes()
    assert report.items() >= json.loads(json.dumps(result.to_dict())).items()
    assert report["errors"]["absolute"]["m"]["rmse"] == pytest.approx(result.error.absolute_translation.rmse)


def test_by_fragments_the_command_gives_the_same_bits_and_figures(folder, tmp_path):
    words = ["--method", "fragments", "--voxel", 0.02, "--work", tmp_path / "stages"]
    report = command(folder, "-o", tmp_path / "mesh.ply", *words)
    config = ReconstructionConfig(depth_max=4.0, tsdf_voxel_size=0.02)
    result = loom.rgbd.reconstruct(loom.open_frames(folder), fragments=FragmentOptions(tmp_path / "own", config))
    assert result.method == report["method"] == "fragments"
    loom.write_triangle_mesh(tmp_path / "own.ply", result.mesh)
    assert (tmp_path / "own.ply").read_bytes() == (tmp_path / "mesh.ply").read_bytes()
    own = json.loads(json.dumps(result.to_dict())) | {"work": report["work"]}
    assert report.items() >= own.items()
    for label in ("frames", "fragments", "stages", "mesh", "bounds"):
        assert f"  {label} " in str(result)


def texture(frames: Any, _: Path) -> Any:
    return loom.meshing.texture_mesh(loom.rgbd.fuse(frames, voxel_size=0.1).mesh, frames, method="none")


def fuse_by_cubes(frames: Any, job: Path) -> Any:
    loom.tiling.plan_fusion(frames.folder, job, voxel_size=0.1, intrinsic=frames.intrinsic)
    return loom.tiling.run_job(job)


SMALL_FRAGMENTS = ReconstructionConfig(depth_max=4.0, tsdf_voxel_size=0.1)
CALLS = {
    "fuse": lambda frames, _: loom.rgbd.fuse(frames, voxel_size=0.1),
    "fuse, refined": lambda frames, _: loom.rgbd.fuse(frames, voxel_size=0.1, refine=True),
    "track": lambda frames, _: loom.rgbd.track(frames, voxel_size=0.1),
    "reconstruct": lambda frames, _: loom.rgbd.reconstruct(frames, voxel_size=0.1),
    "by fragments": lambda frames, work: loom.rgbd.reconstruct(
        frames, fragments=FragmentOptions(work, SMALL_FRAGMENTS)
    ),
    "run_reconstruction_system": lambda frames, work: loom.rgbd.run_reconstruction_system(
        frames, SMALL_FRAGMENTS, work
    ),
    "texture_mesh": texture,
    "tiling": fuse_by_cubes,
}


@pytest.mark.parametrize("name", CALLS)
def test_results_of_frames_with_a_doubtful_camera_are_unreliable(folder, tmp_path, name):
    camera = loom.PinholeCameraIntrinsic(CAMERA.width, CAMERA.height, CAMERA.fx, CAMERA.fy, 0.0, 0.0)
    result = CALLS[name](loom.open_dataset(folder, intrinsic=camera), tmp_path / "work")
    assert not result.reliable
    assert any(line.startswith("the camera may be wrong (the intrinsic given)") for line in result.warnings)
    assert result.to_dict()["reliable"] is False


class Damaged:
    """Frames that can be read by index, except some."""

    intrinsic, depth_scale = CAMERA, 1000.0

    def __init__(self, *damaged: int):
        self.damaged = damaged

    def __len__(self) -> int:
        return 6

    def read(self, index: int):
        if index in self.damaged:
            raise FileError(f"frame-{index}.png", "damaged")
        return waves()[index]


def test_a_list_a_generator_and_a_folder_give_the_same_path(folder):
    listed, streamed = loom.frames_from(waves(), CAMERA), loom.frames_from(iter(waves()), CAMERA)
    first, *others = (
        loom.rgbd.track(frames, voxel_size=0.02) for frames in (listed, streamed, loom.open_frames(folder))
    )
    assert len(first.trajectory) == first.frame_count == 6
    for other in others:
        np.testing.assert_array_equal(other.trajectory.poses, first.trajectory.poses)
        assert other.to_dict() == first.to_dict()


def test_the_error_is_reported_for_frames_with_poses():
    path = loom.rgbd.track(loom.frames_from(waves(), CAMERA), voxel_size=0.02)
    assert path.error is not None and path.error.absolute_translation.rmse < 0.01
    untold = loom.rgbd.track(
        loom.frames_from([(f.color, f.depth, f.timestamp) for f in waves()], CAMERA), voxel_size=0.02
    )
    assert untold.error is None
    np.testing.assert_array_equal(untold.trajectory.poses, path.trajectory.poses)


def test_one_frame_defines_the_world_origin():
    path = loom.rgbd.track(loom.frames_from(waves()[:1], CAMERA))
    np.testing.assert_array_equal(path.trajectory.poses, np.eye(4)[None])
    assert (path.residuals, path.warnings, path.error) == ((), (), None)


def test_unreadable_frames_are_named_and_excluded():
    path = loom.rgbd.track(Damaged(2), voxel_size=0.02)
    assert path.unreadable == {2: "frame-2.png: damaged"}
    assert path.trajectory.ids[:, 0].tolist() == [0, 1, 3, 4, 5]
    assert "1 of 6 frames cannot be read and are left out: frame-2.png: damaged" in str(path.warnings)
    with pytest.raises(FileError, match=r"frame-0\.png"):
        loom.rgbd.track(Damaged(*range(6)))


def test_the_command_gives_the_same_poses_figures_and_lines(folder, tmp_path):
    words = ["track", folder, "-o", tmp_path / "poses.log"]
    shown, report = run(*words), json.loads(run(*words, "--force", "--json"))
    path = loom.rgbd.track(loom.open_frames(folder))
    loom.write_trajectory(tmp_path / "own.log", path.trajectory)
    assert (tmp_path / "own.log").read_bytes() == (tmp_path / "poses.log").read_bytes()
    assert report.items() >= json.loads(json.dumps(path.to_dict())).items()
    printed = dict(line.split(maxsplit=1) for line in shown.splitlines()[1:] if not line.startswith("   "))
    for label, value in (line.split(maxsplit=1) for line in str(path).splitlines()):
        assert printed[label].split("; ")[-1] == value.split("; ")[-1]


def test_without_a_trajectory_the_frames_are_tracked_first():
    """The frames hardly rotate: the check returns no result."""
    assert loom.rgbd.check_focal(loom.frames_from(waves(), CAMERA)) is None


def test_frames_of_a_list_are_checked_as_those_that_can_be_read():
    class Readable(Damaged):
        def read(self, index: int):
            return waves()[0]

    listed = loom.frames_from([waves()[0]] * 6, CAMERA)
    assert loom.rgbd.check_focal(listed, turning_path()) == loom.rgbd.check_focal(Readable(), turning_path())


def test_a_number_of_no_frame_is_refused():
    poses = turning_path().poses
    strange = loom.Trajectory(poses, ids=np.array([[0, 0, 1], [90, 90, 91], [91, 91, 92], [92, 92, 93]]))
    for frames in (Damaged(), loom.frames_from(waves(), CAMERA)):
        with pytest.raises(ValueError, match="trajectory:"):
            loom.rgbd.check_focal(frames, strange)


ROOT = Path(__file__).parents[2]
PROGRAM = f"""
import sys
sys.path.insert(0, {str(ROOT)!r})
import hashlib
import pytest
import pointloom as loom
from tests.rgbd.slam.slam_walks import begun, frame, frames, sequence

first, second = (loom.rgbd.OdometryFrame(frame(k).depth, sequence().intrinsic, frame(k).color) for k in (0, 3))
pair = loom.rgbd.align_frames(second, first)
slam = begun("cpu", submap_frames=3)
slam.run(frames(*range(7)))
tracked = slam.trajectory.poses.tobytes()
slam.close_loops()
mesh = slam.extract_triangle_mesh(0.0)
assert pair.reliable and len(mesh) > 100
for name, content in [
    ("pair", pair.transformation.tobytes() + pair.information.tobytes()), ("tracked", tracked),
    ("corrected", slam.trajectory.poses.tobytes()), ("mesh", mesh.vertices.tobytes() + mesh.triangles.tobytes()),
]:
    print(name, hashlib.sha256(content).hexdigest())
"""


@pytest.mark.slow
def test_the_number_of_threads_changes_no_bit_of_poses_and_surface():
    answers = []
    for threads in ("1", "2"):
        environment = os.environ | {"POINTLOOM_CPU_THREADS": threads, "PYTHONPATH": str(ROOT / "src")}
        command = [sys.executable, "-c", PROGRAM]
        answers.append(subprocess.check_output(command, env=environment, text=True, timeout=300).splitlines())
    assert len(answers[0]) == 4 and answers[0] == answers[1]


def test_stages_of_fragments_are_reused_and_refined_on_request(folder, tmp_path):
    def run_with(**options):
        given = FragmentOptions(tmp_path / "work", SMALL_FRAGMENTS, **options)
        return loom.rgbd.reconstruct(loom.open_frames(folder), fragments=given).account.system

    assert run_with().resumed == 0 and not (tmp_path / "work" / "slac").exists()
    report = run_with(resume=True, slac=True)
    assert report.resumed and report.slac is not None and (tmp_path / "work" / "slac").exists()


class Recorded:
    """Frames that record the names of the threads that read them."""

    intrinsic, depth_scale = CAMERA, 1000.0

    def __init__(self):
        self.frames, self.threads = waves(), []

    def __len__(self):
        return len(self.frames)

    def read(self, index):
        self.threads.append(threading.current_thread().name)
        return self.frames[index]


@pytest.mark.parametrize("call", [loom.rgbd.track, loom.rgbd.reconstruct])
@pytest.mark.parametrize("count", [0, 2])
def test_frames_are_read_ahead_by_another_thread(call, count):
    frames = Recorded()
    call(frames, voxel_size=0.05, read_ahead=count)
    assert any(name.startswith("pointloom-read") for name in frames.threads) == (count > 0)
