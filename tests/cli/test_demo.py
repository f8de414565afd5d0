"""`pointloom demo`: its files and the errors of its mesh."""

import json

import numpy as np
import pytest
from PIL import Image

from pointloom.cli.jobs.demo import LARGEST_RMSE, SurfaceErrors, _problem, run_demo
from pointloom.core.errors import DeviceError, FileError
from pointloom.datasets.scenes.room import surface_errors
from pointloom.meshing.mesh.mesh_files import read_triangle_mesh

from .commands import answer, names_in, output_of

OUTPUTS = ["report.json", "room.ply", "room.png"]
SMALL = {"frame_count": 6, "voxel_size": 0.08}


def errors_of(rmse):
    """Errors of a surface with the given root mean square [voxels]."""
    return SurfaceErrors(0.0, rmse, 0.0, 0.0, 1.0, voxel_size=1.0)


@pytest.mark.slow
def test_the_demo_writes_a_mesh_with_its_errors_a_picture_and_a_report(device, tmp_path):
    report = run_demo(tmp_path / "demo", **SMALL, device=device).to_dict()
    assert names_in(tmp_path / "demo") == OUTPUTS
    assert json.loads((tmp_path / "demo" / "report.json").read_text()) == json.loads(json.dumps(report))
    mesh = read_triangle_mesh(tmp_path / "demo" / "room.ply")
    assert len(mesh) == report["triangles"] > 1000 and mesh.vertex_colors is not None
    assert np.asarray(Image.open(tmp_path / "demo" / "room.png")).std() > 20
    assert [*report["seconds"]] == ["build", "render", "integrate", "extract", "check", "measure", "picture"]
    errors = surface_errors(mesh.vertices)
    assert report["errors"]["rmse"] == pytest.approx(np.sqrt(np.mean(errors**2)), rel=1e-6)
    assert report["errors"]["median_voxels"] == pytest.approx(np.median(errors) / 0.08, rel=1e-6)
    assert report["errors"]["within_half_voxel"] == pytest.approx(np.mean(errors <= 0.04), abs=1e-3)


def test_vertices_within_half_a_voxel_are_counted():
    assert SurfaceErrors.of(np.array([0, 0.03, 0.05, np.nan]), 0.08).within_half_voxel == pytest.approx(2 / 3)


@pytest.mark.slow
def test_without_noise_the_error_is_below_three_tenths_of_a_voxel(tmp_path):
    report = run_demo(tmp_path / "demo", frame_count=60, voxel_size=0.03, noise=False).to_dict()
    assert report["errors"]["rmse_voxels"] < 0.3 and report["reliable"] and LARGEST_RMSE["no noise"] == 0.3


@pytest.mark.slow
def test_two_runs_are_bitwise_identical_and_another_seed_differs(tmp_path):
    for name, seed in (("first", 0), ("second", 0), ("third", 1)):
        run_demo(tmp_path / name, **SMALL, seed=seed)
    for output in OUTPUTS[1:]:
        first, second, third = ((tmp_path / name / output).read_bytes() for name in ("first", "second", "third"))
        assert first == second != third


@pytest.mark.slow
def test_an_existing_output_is_not_overwritten_without_force(tmp_path):
    (tmp_path / "room.png").write_bytes(b"kept")
    with pytest.raises(FileError, match=r"room\.png"):
        run_demo(tmp_path, **SMALL)
    assert (tmp_path / "room.png").read_bytes() == b"kept" and names_in(tmp_path) == ["room.png"]
    run_demo(tmp_path, **SMALL, overwrite=True)
    assert names_in(tmp_path) == OUTPUTS


def test_a_wrong_option_leaves_no_folder(tmp_path):
    for name, value in (("frame_count", 0), ("voxel_size", -1.0), ("seed", -1), ("device", "cuda:99")):
        with pytest.raises(DeviceError if name == "device" else ValueError, match=value if name == "device" else name):
            run_demo(tmp_path / "demo", **(SMALL | {name: value}))
    assert names_in(tmp_path) == []


@pytest.mark.slow
def test_an_interruption_leaves_no_folder(tmp_path):
    def interrupt(stage, done, total):
        if done == 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_demo(tmp_path / "demo", **SMALL, progress=interrupt)
    assert names_in(tmp_path) == []


def test_a_folder_that_cannot_be_made_is_named(tmp_path):
    (tmp_path / "file").write_bytes(b"")
    for path in ("file", "file/demo", "no/demo"):
        with pytest.raises(FileError, match=path):
            run_demo(tmp_path / path, **SMALL)


@pytest.mark.slow
def test_the_command_prints_a_table_or_one_json_object(tmp_path):
    words = ["demo", "-o", tmp_path / "demo", "--frames", "6", "--voxel", "0.08"]
    shown = output_of(*words)
    for label in ("frames", "mesh", "seconds", "median", "root mean square", "95 % below", "within half a voxel"):
        assert label in shown
    assert answer(*words, "--force") == json.loads((tmp_path / "demo" / "report.json").read_text())


@pytest.mark.parametrize(("noise", "limit"), [(True, 1.0), (False, 0.3)])
def test_a_demo_is_unreliable_beyond_its_own_limit_and_not_at_it(noise, limit):
    assert _problem(errors_of(limit), noise) is None
    assert "at most 0.3 voxels, got 0.31;" in _problem(errors_of(0.31), False)
    assert f"at most {limit:g} voxels, got {1.01 * limit:.2f}" in _problem(errors_of(1.01 * limit), noise)
    assert "the mesh is empty" in _problem(None, noise)
