"""`loom.video.reconstruct`: the command as one call, and its result."""

import json

import numpy as np
import pytest

import pointloom as loom
from pointloom.photogrammetry.video import chain

from ...cli.commands import names_in, run
from .conftest import COUNT


def in_json(result):
    report = json.loads(json.dumps(result.to_dict()))
    return {name: value for name, value in report.items() if name not in ("stages", "peak_bytes")}


def test_a_film_becomes_objects_and_no_files(quick, film, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    result = loom.video.reconstruct(film)
    assert names_in(tmp_path) == ["walk.mp4"]
    assert (len(result.mesh), len(result.cloud), len(result.model)) == (2, 3, COUNT)
    assert (result.files, result.work, result.reliable, result.units) == ((), None, True, "arbitrary")
    figures = result.figures
    assert (figures.frame_count, figures.picture_count, figures.quality.registered_count) == (80, COUNT, COUNT)
    assert (figures.picture_size, figures.confirmed_share, figures.triangle_count) == ((64, 48), 0.6, 2)


def test_mesh_cloud_and_model_share_one_frame_and_unit(quick, film, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    arbitrary = loom.video.reconstruct(film)
    meters = loom.video.reconstruct(film, loom.video.Settings(units=loom.video.Units(scale=3.0)))
    assert (meters.units, meters.fit.scale) == ("meters", 3.0)
    np.testing.assert_allclose(meters.mesh.vertices, 3 * arbitrary.mesh.vertices, atol=1e-6)
    np.testing.assert_allclose(meters.cloud.points, 3 * arbitrary.cloud.points, atol=1e-6)
    np.testing.assert_allclose(meters.model.centers, 3 * arbitrary.model.centers, atol=1e-6)


def test_the_command_prints_the_result_and_writes_its_report(quick, film, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shown = run("video", film, "-o", "room.ply", "--cloud", "cloud.ply", "--work", "work", "--device", "cpu")
    settings = {"work": "work", "resume": True, "overwrite": True, "device": "cpu"}
    result = loom.video.reconstruct(film, outputs=loom.video.Outputs("room.ply", cloud="cloud.ply"), **settings)
    same = [line for line in shown.stdout.splitlines() if not line.startswith(("  seconds", "  memory"))]
    assert same == [line for line in str(result).splitlines() if not line.startswith(("  seconds", "  memory"))]
    assert json.loads((tmp_path / "work" / "report.json").read_text()) == json.loads(json.dumps(result.to_dict()))
    assert all(stage.is_reused for stage in result.stages.values())


def test_a_result_that_is_read_again_from_its_records_is_the_same(quick, film, tmp_path):
    quick.reasons, quick.share = ["only 4 of 8 pictures could be placed: film more slowly"], 0.15
    first = loom.video.reconstruct(film, work=tmp_path / "work")
    quick.ran.clear()
    again = loom.video.reconstruct(film, work=tmp_path / "work", resume=True)
    assert quick.ran == []
    assert again.figures == first.figures
    assert again.warnings == first.warnings and len(first.warnings) == 2
    assert in_json(again) == in_json(first)


def test_a_camera_is_taken_as_a_file_or_as_itself(quick, film, tmp_path):
    camera = loom.PinholeCameraIntrinsic(64, 48, 50.0, 50.0, 31.5, 23.5)
    loom.write_pinhole_camera_intrinsic(tmp_path / "camera.json", camera)
    work = tmp_path / "work"
    loom.video.reconstruct(film, loom.video.Settings(intrinsic=tmp_path / "camera.json"), work=work)
    quick.ran.clear()
    loom.video.reconstruct(film, loom.video.Settings(intrinsic=camera), work=work, resume=True)
    assert quick.ran == []


@pytest.mark.parametrize(
    ("name", "after", "recorded"),
    [
        ("frames", [], {"source", "max_frames", "panorama"}),
        ("features", ["frames"], {"camera", "camera_model", "max_features", "panorama", "seed"}),
        ("matches", ["frames", "features"], {"pairs", "seed"}),
        ("model", ["frames", "matches"], {"fixed", "mapper", "panorama", "seed"}),
        ("undistorted", ["frames", "model"], {"max_size"}),
        ("depth", ["undistorted"], {"seed"}),
        ("fused", ["undistorted", "depth"], set()),
        ("mesh", ["model", "undistorted", "fused"], {"units"}),
    ],
)
def test_a_stage_receives_the_inputs_of_its_signature(tmp_path, name, after, recorded):
    given = chain.settings_of_stages("walk.mp4", "digest", loom.video.Settings(), "cpu")
    names = list(chain.STAGES)
    made = {each: chain.StageResult(each, tmp_path / each, each, {}, {}, False) for each in names[: names.index(name)]}
    stage = chain.stage_of(name, chain.STAGES[name], made, given)
    assert [each.name for each in stage.after] == after
    assert set(stage.settings) == recorded
