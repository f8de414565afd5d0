"""`pointloom info` of models of structure from motion."""

from __future__ import annotations

import pytest

import pointloom as loom

from ..files.sfm_models import ring_model
from ..files.test_metashape import camera, document
from .commands import answer, run

MODEL = ring_model()


@pytest.mark.parametrize(("form", "place"), [("bin", "."), ("txt", "sparse/0")])
def test_info_tells_what_a_model_of_colmap_holds(tmp_path, form, place):
    loom.write_colmap_model(tmp_path / place, MODEL, format=form)
    (report,) = answer("info", tmp_path)["files"]
    assert report["kind"] == "COLMAP model"
    assert report["form"] == {"bin": "binary", "txt": "text"}[form]
    assert report["folder"] == (None if place == "." else place)
    assert (report["pictures"], report["points"], report["observations"]) == (6, 40, len(MODEL.observations))
    assert sorted(line.split()[0] for line in report["cameras"]) == ["OPENCV", "SIMPLE_RADIAL"]
    assert report["mean_views"] == pytest.approx(len(MODEL.observations) / 40)
    assert 0 < report["mean_error_px"] < 1
    shown = run("info", tmp_path).stdout
    assert "SIMPLE_RADIAL 640 x 480, 500, 320, 240, -0.05; 4 pictures" in shown
    assert "arbitrary" in shown


def test_info_tells_what_metashape_exported(tmp_path):
    (tmp_path / "cameras.xml").write_text(document(camera() + camera("lost", None)))
    (report,) = answer("info", tmp_path / "cameras.xml")["files"]
    assert report["kind"] == "Metashape cameras"
    assert report["pictures"] == 1
    assert report["left_out"] == ["lost: not aligned"]
    assert report["camera_bounds"] == {"min": [2, 3, 4], "max": [2, 3, 4]}


def test_a_damaged_model_is_an_error_with_its_place(tmp_path):
    loom.write_colmap_model(tmp_path, MODEL)
    data = (tmp_path / "points3D.bin").read_bytes()
    (tmp_path / "points3D.bin").write_bytes(data[:-3])
    result = run("info", tmp_path)
    assert result.exit_code == 1
    assert f"error: {tmp_path / 'points3D.bin'} (byte " in result.stderr


def test_a_model_without_points_is_told(tmp_path):
    loom.write_colmap_model(tmp_path, loom.SfmModel(MODEL.names, MODEL.cameras, MODEL.T_camera_world))
    (report,) = answer("info", tmp_path)["files"]
    assert (report["points"], report["mean_views"], report["bounds"]) == (0, None, None)
    assert run("info", tmp_path).exit_code == 0
