"""The hard trial run: what it leaves, its errors, and what makes it poor."""

import json

import numpy as np
import pytest
from PIL import Image

from pointloom.app.demos import demo_reconstruct
from pointloom.app.demos.demo_reconstruct import LARGEST_ATE, LARGEST_MEDIAN, OUTPUTS, ReconstructTrial, _why_poor
from pointloom.app.demos.demo_results import SurfaceErrors
from pointloom.app.demos.trial import run_trial
from pointloom.cameras.trajectory import read_trajectory
from pointloom.core.wording import to_json
from pointloom.data.scenes.room import surface_errors
from pointloom.meshing.mesh.mesh_files import read_triangle_mesh

from .commands import answer, names_in, refusal, run


@pytest.fixture(autouse=True)
def short_walk(monkeypatch, walk):
    """The beginning of the walk, in small pictures."""
    monkeypatch.setattr(demo_reconstruct, "room_loop_sequence", lambda *_, **__: walk)


@pytest.mark.slow
def test_the_demo_leaves_a_mesh_a_picture_both_paths_and_a_report(tmp_path, device):
    report = run_trial(tmp_path / "demo", ReconstructTrial(voxel_size=0.05), device=device).to_json()
    assert names_in(tmp_path / "demo") == sorted(OUTPUTS)
    assert json.loads((tmp_path / "demo" / "report.json").read_text()) == json.loads(to_json(report))
    assert np.asarray(Image.open(tmp_path / "demo" / "room.png")).std() > 5
    poses, truth = (read_trajectory(tmp_path / "demo" / name).poses for name in ("poses.log", "truth.log"))
    np.testing.assert_allclose(poses[0], truth[0], atol=1e-9)
    assert report["drift"]["end_m"] == pytest.approx(np.linalg.norm((poses - truth)[-1, :3, 3]), abs=1e-9)
    errors = surface_errors(read_triangle_mesh(tmp_path / "demo" / "room.ply").vertices)
    assert report["errors"]["median"] == pytest.approx(np.median(errors), rel=1e-4)
    assert report["path_errors"]["absolute"]["m"]["rmse"] < 0.01
    assert report["errors"]["median"] < 0.01


@pytest.mark.slow
def test_the_command_prints_a_table_or_one_json_object(tmp_path):
    words = ["demo", "reconstruct", "-o", tmp_path / "demo", "--voxel", 0.05]
    shown = run(*words)
    assert shown.exit_code == 0, shown.stderr
    for part in ("8 of 8, ", "ATE", "RPE", "drift", "root mean square", "loops", "poses.log"):
        assert part in shown.stdout
    assert "exists already" in refusal(*words)
    assert answer(*words, "--force")["form"] == "reconstruct"


def test_too_few_frames_leave_no_folder(tmp_path):
    assert "frame_count" in refusal("demo", "reconstruct", "-o", tmp_path / "demo", "--frames", 1)
    assert names_in(tmp_path) == []


@pytest.mark.parametrize(("ate", "median", "count"), [(1.0, 1.0, 0), (1.01, 1.0, 1), (1.0, 1.01, 1), (2.0, 2.0, 2)])
def test_a_demo_is_poor_beyond_its_limits_and_not_at_them(ate, median, count):
    errors = SurfaceErrors(median * LARGEST_MEDIAN, 0.0, 0.0, 0.0, 1.0, voxel_size=0.02)
    assert len(_why_poor(ate * LARGEST_ATE, errors)) == count
