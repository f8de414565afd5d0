"""The trial run of pictures alone: with a made-up job, whose result is known, its errors are found at their size."""

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.app.demos import demo_video
from pointloom.app.demos.demo_video import OUTPUTS, Judgement, VideoTrial, seen_points
from pointloom.app.demos.trial import run_trial
from pointloom.cameras.trajectory import read_trajectory
from pointloom.core.wording import to_json
from pointloom.data.scenes.error_figures import CameraErrors, DepthErrors, ErrorFigures, MeshErrors
from pointloom.data.scenes.room import surface_errors
from pointloom.data.scenes.room_video import room_video_frames
from pointloom.meshing.mesh.mesh_files import read_triangle_mesh
from pointloom.photos.sfm.verdict import Verdict
from pointloom.photos.video.result import StageReport, VideoFigures, VideoResult

from .commands import answer, names_in, poor_answer, refusal, run

FRAMES = 12
TAKEN = (0, 2, 3, 7, 11)  # frames of the video
UNIT = 0.25  # [m] of the made-up model
DEPTH_ERROR = 1.0015


class MadeJob:
    """A job that finds the truth but for planted errors, in a frame and unit of its own."""

    def __init__(self, frames, *, shift=0.0, placed=5, holes=0.2, told=None, with_mesh=True):
        self.frames, self.shift, self.holes, self.with_mesh = frames, shift, holes, with_mesh
        self.told = told
        self.placed = TAKEN[:placed]
        self.calls = []

    def __call__(self, source, settings, *, outputs, work, device, progress):
        self.calls.append((Path(source), settings))
        assert Path(source).exists()
        progress("depth: pictures", 1, 2)
        model = self._model()
        files = []
        if model is not None:
            cameras = [
                loom.mvs.PosedCamera(c.intrinsic, T) for c, T in zip(model.cameras, model.T_camera_world, strict=True)
            ]
            for name in ("undistorted", "fused"):
                (work / name).mkdir(parents=True)
            loom.write_colmap_model(work / "undistorted" / "sparse", model)
            loom.mvs.DepthMaps(cameras, [()] * len(cameras), self._maps(), folder=work / "fused" / "maps")
            if self.with_mesh:
                corners = [[0.0, 0.0, 0.005], [5, 0, 0.005], [5, 4, 0.005], [0, 4, 0.005]]
                mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 2, 3]]).subdivide_midpoint(4)
                loom.write_triangle_mesh(outputs.mesh, mesh)
                loom.write_trajectory(outputs.trajectory, loom.Trajectory(self.frames.poses[list(self.placed)]))
                Image.new("RGB", (8, 8), (200, 100, 0)).save(outputs.picture)
                files = [str(outputs.mesh), str(outputs.trajectory), str(outputs.picture)]
        verdict = Verdict(len(TAKEN), len(self.placed), (len(self.placed),), 100, 50.0, 8.0, 30.0, 0.4, ())
        told = StageReport(False, {"seconds": 0.5}, {"kept": len(TAKEN), "frames": FRAMES})
        return VideoResult(
            source=str(source),
            device=str(device),
            mesh=read_triangle_mesh(outputs.mesh) if files else None,
            cloud=None,
            model=model,
            fit=None,
            figures=VideoFigures(FRAMES, len(TAKEN), (), verdict, (), only_turned=False),
            reasons=() if self.told is None else (self.told,),
            stages={"frames": told, "undistorted": None if model is None else told},
            files=tuple(files),
            work=str(work),
            peak_bytes=0,
        )

    def _model(self):
        if not self.placed:
            return None
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = Rotation.from_euler("xyz", [10, 50, -70], degrees=True).as_matrix(), (1, -2, 30)
        truths = self.frames.poses[list(self.placed)]
        truths[:, 2, 3] += self.shift * (-1.0) ** np.arange(len(truths))
        poses = T @ truths
        poses[:, :3, 3] /= UNIT
        names = [f"frame_{k:06d}.png" for k in self.placed]
        camera = loom.CameraModel.from_intrinsic(self.frames.intrinsic)
        return loom.SfmModel(names, [camera] * len(names), np.linalg.inv(poses))

    def _maps(self):
        for k in self.placed:
            depth = self.frames.read(k).depth * np.float32(DEPTH_ERROR / UNIT)
            depth[: round(self.holes * len(depth))] = 0
            there = depth > 0
            yield loom.mvs.DepthMap(depth, there[..., None] * np.float32([0, 0, -1]), there.astype(np.float32))


def run_demo(folder, progress=None):
    """The report of a short trial run, in JSON's types."""
    return run_trial(folder, VideoTrial(FRAMES), progress=progress).to_json()


@pytest.fixture
def job(monkeypatch):
    """Puts a made-up job in the place of the true one, and small frames in that of the video's."""
    frames = room_video_frames(FRAMES, width=64, height=48)
    monkeypatch.setattr(demo_video, "room_video_frames", lambda *_, **__: frames)

    def install(**options):
        made = MadeJob(frames, **options)
        monkeypatch.setattr(demo_video, "reconstruct", made)
        return made

    return install


def test_the_demo_finds_the_errors_that_were_planted(tmp_path, job):
    made, said = job(), []
    report = run_demo(tmp_path / "demo", progress=lambda *step: said.append(step))
    assert report["poor"] is None
    assert report["cameras"]["scale"] == pytest.approx(UNIT, rel=1e-6)
    assert report["cameras"]["m"]["max"] < 1e-6 and report["cameras"]["deg"]["max"] < 1e-3
    assert report["depth"]["pictures"] == len(TAKEN)
    assert report["depth"]["kept"] == pytest.approx(0.8, abs=0.02)
    assert report["depth"]["median_relative"] == pytest.approx(DEPTH_ERROR - 1, rel=0.01)
    assert report["depth"]["within"] == 1.0
    assert report["surface"]["median"] < 0.006
    assert 0.02 < report["surface"]["covered"] < 0.6  # the floor alone
    assert {stage for stage, _, _ in said} == {"video", "depth: pictures", "measure"}
    assert Path(made.calls[0][1].units.align).name == "truth.log"


@pytest.mark.slow
def test_the_demo_leaves_its_files_and_nothing_else(tmp_path, job):
    job()
    report = run_demo(tmp_path / "demo")
    assert names_in(tmp_path / "demo") == sorted(OUTPUTS)
    assert report["files"] == [str(tmp_path / "demo" / name) for name in OUTPUTS]
    assert json.loads((tmp_path / "demo" / "report.json").read_text()) == json.loads(to_json(report))
    truth = read_trajectory(tmp_path / "demo" / "truth.log")
    np.testing.assert_array_equal(truth.poses, room_video_frames(FRAMES).poses)


@pytest.mark.slow
def test_without_ffmpeg_the_job_gets_a_folder_of_pictures(tmp_path, job, monkeypatch):
    made = job()
    monkeypatch.setattr(demo_video.shutil, "which", lambda _: None)
    report = run_demo(tmp_path / "demo")
    assert made.calls[0][0].name == "pictures" and report["poor"] is None
    assert names_in(tmp_path / "demo") == sorted(OUTPUTS[1:])


@pytest.mark.slow
def test_the_command_prints_a_table_or_one_json_object(tmp_path, job):
    job()
    words = ["demo", "video", "-o", tmp_path / "demo", "--frames", FRAMES]
    shown = run(*words)
    assert shown.exit_code == 0, shown.stderr
    for part in ("5 placed of 5", "0.000 %", "% of the pixels kept", "off by 0.15 %", "mesh.ply", "within 2 cm"):
        assert part in shown.stdout
    assert "exists already" in refusal(*words)
    assert answer(*words, "--force")["form"] == "video"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("options", "reasons"),
    [
        ({"shift": 0.015}, ["the cameras are off by", "depth is off by", "of the depth is within 1 %"]),
        ({"placed": 4}, ["4 of 5 pictures were placed"]),
        ({"holes": 0.7}, ["of the depth is kept, less than 75.0%"]),
        ({"told": "the job says so"}, ["the job says so"]),
        ({"with_mesh": False}, ["there is no mesh"]),
        ({"placed": 0, "told": "no two pictures"}, ["no two pictures", "0 of 5 pictures were", "there is no mesh"]),
    ],
)
def test_a_missed_bar_is_a_poor_result_and_the_report_stays(tmp_path, job, options, reasons):
    job(**options)
    report = poor_answer("demo", "video", "-o", tmp_path / "demo", "--frames", FRAMES)
    assert report["poor"].count(";") == len(reasons) - 1
    for reason in reasons:
        assert reason in report["poor"]
    assert "report.json" in names_in(tmp_path / "demo")
    assert report["video"]["command"] == "video" and "files" not in report["video"]


@pytest.mark.parametrize(("factor", "count"), [(1.0, 0), (1.01, 5)])
def test_a_demo_is_poor_beyond_its_limits_and_not_at_them(factor, count):
    d = demo_video
    centers = ErrorFigures(factor * d.LARGEST_CENTER, 0.0, 0.0)
    cameras = CameraErrors(30, 1.0, [], 1.0, ErrorFigures(1.0, 1.0, 1.0), centers, centers)
    depth = DepthErrors(30, d.LEAST_KEPT / factor, factor * d.LARGEST_DEPTH, 0.0, d.LEAST_WITHIN / factor, 1.0)
    surface = MeshErrors(9, factor * d.LARGEST_MEDIAN, 0.0, 0.0, 0.0, 1.0, 1.0)
    assert len(Judgement(cameras, depth, surface).why_poor()) == count


@pytest.mark.slow
def test_an_interrupted_demo_leaves_nothing(tmp_path, job, monkeypatch):
    job()

    def interrupt(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr(demo_video, "judge", interrupt)
    with pytest.raises(KeyboardInterrupt):
        run_demo(tmp_path / "demo")
    assert names_in(tmp_path) == []


def test_points_that_cameras_see_lie_on_the_surface(device):
    frames = room_video_frames(3, width=320, height=240)
    seen = seen_points(frames.poses, frames.intrinsic, device=device)
    assert seen.shape == (3 * 20 * 15, 3)
    assert surface_errors(seen, device=device).max() < 2e-6
