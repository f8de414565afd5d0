"""SLAC as a stage of the system: frames are deformed on integration, only on request."""

import dataclasses
import shutil
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.registration.deformable.control_grid_files import read_control_grid, write_control_grid
from pointloom.rgbd.reconstruction.job import OPTIONAL_STAGES
from pointloom.rgbd.reconstruction.nonrigid import refine_with_slac
from pointloom.rgbd.reconstruction.placement import register_fragments
from pointloom.rgbd.reconstruction.scene import integrate_scene
from pointloom.rgbd.reconstruction.volumes import integrate_deformed

from ...interruptions import run_lines
from .test_job import digest_of
from .walks import ShortSequence, config, frame_at

rec = loom.rgbd
SETTINGS = config(n_frames_per_fragment=2, max_iterations=2)
FILES = tuple(f"rgbd/reconstruction/{name}.py" for name in ("nonrigid", "scene", "job"))


def bent(frame):
    """The depth of a camera that measures 3 % too far at the corners of the image."""
    camera = ShortSequence([0]).intrinsic
    v, u = np.mgrid[: camera.height, : camera.width]
    spread = ((u - camera.cx) / camera.fx) ** 2 + ((v - camera.cy) / camera.fy) ** 2
    return {"depth": np.rint(frame.depth * (1 + 0.03 * spread / spread.max())).astype(np.uint16)}


def deformed_sequence(count=6):
    """Pairs of frames some 15 degrees apart, from a camera that distorts depth."""
    steps = [step for first in range(0, 4 * count, 4) for step in (first, first + 1)][:count]
    return ShortSequence(steps, changed={i: bent(frame_at(step)) for i, step in enumerate(steps)})


@pytest.fixture(scope="module")
def completed_run(tmp_path_factory):
    """The folder, report and files of an uninterrupted run."""
    folder = tmp_path_factory.mktemp("complete")
    report = rec.run_reconstruction_system(deformed_sequence(), SETTINGS, folder, stages=OPTIONAL_STAGES)
    return folder, report, digest_of(folder)


@pytest.fixture
def job(completed_run, tmp_path):
    """A copy of the completed run that a test may damage."""
    return Path(shutil.copytree(completed_run[0], tmp_path / "job"))


@pytest.mark.slow
def test_the_stage_aligns_fragments_and_reports_the_change(completed_run):
    folder, report, _ = completed_run
    figures = report.slac
    assert (report.used, figures["method"], figures["edges"]) == (6, "slac", report.edges)
    assert 2 <= figures["used"] <= figures["edges"] and figures["rmse"] < 0.95 * figures["rmse_before"]
    assert figures["anchors"] > 50 and 0 < figures["bent_m"] < 0.1 and report.reliable
    names = {path.name for path in (folder / "slac").iterdir()}
    assert names == {"control_grid.npz", "optimized_posegraph_slac.json", "output_slac_pointcloud.ply"}


@pytest.mark.slow
def test_the_surface_is_written_as_points_on_request(completed_run, job):
    points = loom.read_point_cloud(job / "slac" / "output_slac_pointcloud.ply")
    mesh = loom.read_triangle_mesh(job / "scene" / "integrated.ply")
    assert len(points) > 1000 and points.has_normals
    assert np.median(points.compute_point_cloud_distance(loom.PointCloud(mesh.vertices))) < 1e-5
    (job / "slac" / "output_slac_pointcloud.ply").unlink()
    settings = dataclasses.replace(SETTINGS, save_output_as="mesh")
    assert integrate_scene(deformed_sequence(), settings, job, slac=True, resume=True).cloud_path is None
    assert not (job / "slac" / "output_slac_pointcloud.ply").exists()
    again = rec.run_reconstruction_system(deformed_sequence(), SETTINGS, job, stages=OPTIONAL_STAGES, resume=True)
    assert str(job / "slac" / "output_slac_pointcloud.ply") in again.files


@pytest.mark.slow
def test_frames_go_through_the_grid(completed_run):
    folder, report, _ = completed_run
    settings, sequence = SETTINGS, deformed_sequence()
    result = refine_with_slac(settings, folder, resume=True)
    scene = integrate_scene(sequence, settings, folder, slac=True, resume=True)
    volume = loom.TSDFVolume(voxel_size=settings.volume_voxel_size, truncation=settings.truncation)
    for index, T in zip(scene.indices.tolist(), scene.T_world_camera, strict=True):
        number, frame = index // 2, sequence.read(index)
        pose = result.placement.poses[number]
        step, depth = np.linalg.inv(pose) @ T, frame.depth / 1000
        depth = np.where((depth >= 0.3) & (depth <= 4.0), depth, 0).astype(np.float32)
        integrate_deformed(volume, result.grid, depth, sequence.intrinsic, pose, step, frame.color, depth_max=4.0)
    mesh = volume.extract_triangle_mesh(scene.figures["weight_threshold"])
    assert len(mesh.vertices) == pytest.approx(report.mesh["vertices"], rel=1e-3)
    cloud, written = (loom.PointCloud(m.vertices) for m in (mesh, loom.read_triangle_mesh(scene.mesh_path)))
    assert np.median(cloud.compute_point_cloud_distance(written)) < 1e-5


@pytest.mark.slow
def test_a_run_without_slac_ignores_earlier_slac_results(completed_run, job, tmp_path):
    assert rec.run_reconstruction_system(deformed_sequence(), SETTINGS, job, resume=True).slac is None
    plain = (job / "scene" / "integrated.ply").read_bytes()
    assert plain != completed_run[2]["scene/integrated.ply"]
    rec.run_reconstruction_system(deformed_sequence(), SETTINGS, tmp_path / "plain")
    assert (tmp_path / "plain" / "scene" / "integrated.ply").read_bytes() == plain


def test_the_rigid_method_moves_fragments_without_deformation(completed_run, job):
    report = completed_run[1]
    result = refine_with_slac(dataclasses.replace(SETTINGS, method="rigid"), job, resume=True)
    assert (result.figures["method"], len(result.grid), result.figures["bent_m"]) == ("rigid", 0, 0)
    assert report.slac["rmse"] < result.figures["rmse"] <= report.slac["rmse_before"] * 1.0001


def test_a_softer_grid_deforms_more(completed_run, job):
    softer = dataclasses.replace(SETTINGS, regularizer_weight=0.1)
    assert refine_with_slac(softer, job, resume=True).figures["bent_m"] > completed_run[1].slac["bent_m"]


@pytest.mark.parametrize(("fitness", "used"), [(0.1, 3), (1.0, 2)])
def test_thresholds_of_the_configuration_select_pairs_and_edges(completed_run, job, fitness, used):
    """Two of the three edges join consecutive fragments, which are always used."""
    given = rec.ReconstructionConfig(
        **SETTINGS.to_names() | {"fitness_threshold": fitness, "distance_threshold": 0.005}
    )
    figures = refine_with_slac(given, job, resume=True).figures
    assert figures["used"] == used and figures["rmse_before"] < 0.005 < completed_run[1].slac["rmse_before"]


def test_a_single_fragment_is_unchanged(tmp_path):
    plain = rec.run_reconstruction_system(ShortSequence([0, 1]), config(), tmp_path / "plain")
    report = rec.run_reconstruction_system(ShortSequence([0, 1]), config(), tmp_path / "slac", stages=OPTIONAL_STAGES)
    assert (report.slac["anchors"], report.slac["edges"]) == (0, 0) and report.mesh == plain.mesh


@pytest.mark.slow
def test_frames_without_color_are_deformed_too(tmp_path, device):
    sequence = deformed_sequence(4)
    changed = {i: change | {"color": None} for i, change in sequence.changed.items()}
    gray = ShortSequence(sequence.indices, changed=changed)
    assert (
        rec.run_reconstruction_system(gray, SETTINGS, tmp_path, stages=OPTIONAL_STAGES, device=device).slac["anchors"]
        > 50
    )
    assert loom.read_triangle_mesh(tmp_path / "scene" / "integrated.ply").vertex_colors is None


def test_a_completed_run_is_unchanged(completed_run, job):
    _, first, content = completed_run
    times = {path: path.stat().st_mtime_ns for path in job.rglob("*.[np][pl][zy]")}
    again = rec.run_reconstruction_system(deformed_sequence(), SETTINGS, job, stages=OPTIONAL_STAGES, resume=True)
    assert {path: path.stat().st_mtime_ns for path in times} == times
    assert (again.slac, again.mesh, again.warnings) == (first.slac, first.mesh, first.warnings)
    assert digest_of(job) == content


@pytest.mark.slow
def test_an_interrupted_stage_resumes_to_the_same_bits(completed_run, job):
    def act():
        rec.run_reconstruction_system(deformed_sequence(), SETTINGS, job, stages=OPTIONAL_STAGES, resume=True)

    def forget():
        for name in ("records/slac.json", "records/integrate.json", "slac/control_grid.npz", "scene/integrated.ply"):
            (job / name).unlink(missing_ok=True)

    forget()
    lines = run_lines(act, FILES)
    assert digest_of(job) == completed_run[2]
    for stop in np.linspace(1, lines - 1, 6).astype(int).tolist():
        forget()
        assert run_lines(act, FILES, stop) == stop
        act()
        assert digest_of(job) == completed_run[2], f"interrupted before line {stop} of {lines}"


@pytest.mark.parametrize(
    "name", [pytest.param("control_grid.npz", marks=pytest.mark.slow), "optimized_posegraph_slac.json"]
)
def test_a_damaged_file_is_recomputed(completed_run, job, name):
    content = completed_run[2]
    path = job / "slac" / name
    path.write_bytes(path.read_bytes()[:-40])
    with pytest.raises(FileError, match=r"/job:.*refine_with_slac"):
        integrate_scene(deformed_sequence(), SETTINGS, job, slac=True)
    rec.run_reconstruction_system(deformed_sequence(), SETTINGS, job, stages=OPTIONAL_STAGES, resume=True)
    assert digest_of(job) == content


def test_newly_registered_fragments_are_aligned_again(job):
    register_fragments(dataclasses.replace(SETTINGS, seed=1), job)
    with pytest.raises(FileError, match=r"/job:.*refine_with_slac"):
        integrate_scene(deformed_sequence(), SETTINGS, job, slac=True)


def test_unsupported_slac_options_are_reported_first(tmp_path):
    with pytest.raises(ValueError, match="fitness_threshold"):
        rec.run_reconstruction_system(
            ShortSequence([0, 1]), config(fitness_threshold=2.0), tmp_path, stages=OPTIONAL_STAGES
        )
    assert not list(tmp_path.rglob("*.ply"))


def a_grid(device="cpu"):
    grid = rec.ControlGrid(0.5, device=device)
    grid.touch(loom.PointCloud(np.random.default_rng(0).random((50, 3)) * 3 + 1000, device=device))
    grid.set_positions(grid.get_init_positions() + 0.01 * np.random.default_rng(1).random((len(grid), 3)))
    return grid


@pytest.mark.parametrize("empty", [False, True], ids=["a grid", "one without anchors"])
def test_a_saved_grid_is_read_bitwise_identical(tmp_path, device, empty):
    grid = rec.ControlGrid(0.5, device=device) if empty else a_grid(device)
    write_control_grid(tmp_path / "grid.npz", grid)
    again = read_control_grid(tmp_path / "grid.npz", device=device)
    assert (again.grid_size, len(again)) == (grid.grid_size, len(grid))
    assert np.array_equal(again.origin, grid.origin)
    assert np.array_equal(again.get_curr_positions(), grid.get_curr_positions())
    cloud = loom.PointCloud(np.random.default_rng(2).random((40, 3)) * 3 + 1000, device=device)
    assert np.array_equal(again.deform(cloud).points, grid.deform(cloud).points)


def test_an_invalid_grid_file_is_rejected(tmp_path):
    path = tmp_path / "grid.npz"
    with pytest.raises(FileError, match=r"/grid\.npz:"):
        read_control_grid(path)
    write_control_grid(path, a_grid())
    archive = path.read_bytes()
    for broken in (b"", b"no archive", archive[: len(archive) // 2], archive[:-30]):
        path.write_bytes(broken)
        with pytest.raises(FileError, match="grid"):
            read_control_grid(path)
    names = {"sizes": np.ones(1), "origin": np.zeros(3), "cells": np.arange(2), "shifts": np.zeros((3, 3))}
    for wrong, message in (
        ({"format": np.zeros(3, np.uint8)}, "is not a control grid"),
        ({"cells": np.arange(2)[::-1]}, "do not belong to a control grid"),
        ({"shifts": np.full((3, 3), np.nan)}, "do not belong to a control grid"),
        ({}, "for [0-9]+ anchors"),
    ):
        sound = {"format": np.frombuffer(b"pointloom control grid 1", np.uint8)} | names
        np.savez_compressed(path, **(sound | wrong))
        with pytest.raises(FileError, match=message):
            read_control_grid(path)
