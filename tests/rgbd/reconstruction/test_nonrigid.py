"""SLAC as a stage of the system: frames are bent straight on the way into the model, and only where it is asked for."""

import dataclasses
import shutil
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.registration.deformable.control_grid_files import read_control_grid, write_control_grid
from pointloom.rgbd.reconstruction.nonrigid import refine_with_slac
from pointloom.rgbd.reconstruction.volumes import integrate_deformed

from ...interruptions import run_lines
from .test_job import digest_of
from .walks import Walk, config, frame_at

rec = loom.reconstruction
SETTINGS = config(n_frames_per_fragment=2, max_iterations=2)
FILES = tuple(f"rgbd/reconstruction/{name}.py" for name in ("nonrigid", "scene", "job"))


def bent(frame):
    """The depth of a camera that measures 3 % too far at the corners of the picture."""
    camera = Walk([0]).intrinsic
    v, u = np.mgrid[: camera.height, : camera.width]
    spread = ((u - camera.cx) / camera.fx) ** 2 + ((v - camera.cy) / camera.fy) ** 2
    return {"depth": np.rint(frame.depth * (1 + 0.03 * spread / spread.max())).astype(np.uint16)}


def bent_walk(count=6):
    """Frames some 15 degrees apart, as pairs, by a camera that bends depth."""
    steps = [step for first in range(0, 4 * count, 4) for step in (first, first + 1)][:count]
    return Walk(steps, changed={i: bent(frame_at(step)) for i, step in enumerate(steps)})


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """What an uninterrupted run leaves, and its report."""
    folder = tmp_path_factory.mktemp("whole")
    report = rec.run_system(bent_walk(), SETTINGS, folder, slac=True)
    return folder, report, digest_of(folder)


@pytest.fixture
def job(whole, tmp_path):
    """A copy of it that a test may damage."""
    return Path(shutil.copytree(whole[0], tmp_path / "job"))


@pytest.mark.slow
def test_the_stage_brings_fragments_together_and_says_how_far(whole):
    folder, report, _ = whole
    told = report.slac
    assert (report.used, told["method"], told["edges"]) == (6, "slac", report.edges)
    assert 2 <= told["used"] <= told["edges"]
    assert told["rmse"] < 0.95 * told["rmse_before"]
    assert told["anchors"] > 50
    assert 0 < told["bent_m"] < 0.1
    assert report.reliable
    assert sorted(path.name for path in (folder / "slac").iterdir()) == [
        "control_grid.npz",
        "optimized_posegraph_slac.json",
        "output_slac_pointcloud.ply",
    ]


@pytest.mark.slow
def test_the_surface_is_written_as_points_where_that_is_asked(whole, job):
    points = loom.read_point_cloud(job / "slac" / "output_slac_pointcloud.ply")
    mesh = loom.read_triangle_mesh(job / "scene" / "integrated.ply")
    assert len(points) > 1000 and points.has_normals
    assert np.median(points.compute_point_cloud_distance(loom.PointCloud(mesh.vertices))) < 1e-5
    (job / "slac" / "output_slac_pointcloud.ply").unlink()
    settings = dataclasses.replace(SETTINGS, save_output_as="mesh")
    assert rec.integrate_scene(bent_walk(), settings, job, slac=True, resume=True).cloud_path is None
    assert not (job / "slac" / "output_slac_pointcloud.ply").exists()
    again = rec.run_system(bent_walk(), SETTINGS, job, slac=True, resume=True)
    assert str(job / "slac" / "output_slac_pointcloud.ply") in again.files


def test_frames_go_through_the_grid(whole):
    folder, report, _ = whole
    settings, walk = SETTINGS, bent_walk()
    found = refine_with_slac(settings, folder, resume=True)
    scene = rec.integrate_scene(walk, settings, folder, slac=True, resume=True)
    volume = loom.TSDFVolume(voxel_size=settings.volume_voxel_size, truncation=settings.truncation)
    for index, T in zip(scene.indices.tolist(), scene.T_world_camera, strict=True):
        number, frame = index // 2, walk.read(index)
        pose = found.placement.poses[number]
        step, depth = np.linalg.inv(pose) @ T, frame.depth / 1000
        depth = np.where((depth >= 0.3) & (depth <= 4.0), depth, 0).astype(np.float32)
        integrate_deformed(volume, found.grid, depth, walk.intrinsic, pose, step, frame.color, depth_max=4.0)
    mesh = volume.extract_triangle_mesh(scene.figures["weight_threshold"])
    assert len(mesh.vertices) == pytest.approx(report.mesh["vertices"], rel=1e-3)
    cloud, written = (loom.PointCloud(m.vertices) for m in (mesh, loom.read_triangle_mesh(scene.mesh_path)))
    assert np.median(cloud.compute_point_cloud_distance(written)) < 1e-5


@pytest.mark.slow
def test_a_run_without_slac_takes_nothing_of_an_earlier_one_with_it(whole, job, tmp_path):
    report = rec.run_system(bent_walk(), SETTINGS, job, resume=True)
    assert report.slac is None
    plain = (job / "scene" / "integrated.ply").read_bytes()
    assert plain != whole[2]["scene/integrated.ply"]
    rec.run_system(bent_walk(), SETTINGS, tmp_path / "plain")
    assert (tmp_path / "plain" / "scene" / "integrated.ply").read_bytes() == plain


def test_the_rigid_method_moves_fragments_and_bends_nothing(whole, job):
    report = whole[1]
    found = refine_with_slac(dataclasses.replace(SETTINGS, method="rigid"), job, resume=True)
    assert (found.figures["method"], len(found.grid), found.figures["bent_m"]) == ("rigid", 0, 0)
    assert report.slac["rmse"] < found.figures["rmse"] <= report.slac["rmse_before"] * 1.0001


def test_a_single_fragment_is_left_as_it_is(tmp_path):
    plain = rec.run_system(Walk([0, 1]), config(), tmp_path / "plain")
    report = rec.run_system(Walk([0, 1]), config(), tmp_path / "slac", slac=True)
    assert (report.slac["anchors"], report.slac["edges"]) == (0, 0)
    assert report.mesh == plain.mesh


def test_frames_without_color_are_bent_too(tmp_path, device):
    walk = bent_walk(4)
    changed = {i: change | {"color": None} for i, change in walk.changed.items()}
    report = rec.run_system(Walk(walk.indices, changed=changed), SETTINGS, tmp_path, slac=True, device=device)
    assert report.slac["anchors"] > 50
    assert loom.read_triangle_mesh(tmp_path / "scene" / "integrated.ply").vertex_colors is None


def test_a_run_that_is_done_is_kept_as_it_is(whole, job):
    _, first, content = whole
    times = {path: path.stat().st_mtime_ns for path in job.rglob("*.[np][pl][zy]")}
    again = rec.run_system(bent_walk(), SETTINGS, job, slac=True, resume=True)
    assert {path: path.stat().st_mtime_ns for path in times} == times
    assert (again.slac, again.mesh, again.warnings) == (first.slac, first.mesh, first.warnings)
    assert digest_of(job) == content


@pytest.mark.slow
def test_an_interrupted_stage_resumes_to_the_same_bits(whole, job):
    def act():
        rec.run_system(bent_walk(), SETTINGS, job, slac=True, resume=True)

    def forget():
        for name in ("records/slac.json", "records/integrate.json", "slac/control_grid.npz", "scene/integrated.ply"):
            (job / name).unlink(missing_ok=True)

    forget()
    lines = run_lines(act, FILES)
    assert digest_of(job) == whole[2]
    for stop in np.linspace(1, lines - 1, 6).astype(int).tolist():
        forget()
        assert run_lines(act, FILES, stop) == stop
        act()
        assert digest_of(job) == whole[2], f"interrupted before line {stop} of {lines}"


@pytest.mark.parametrize(
    "name", [pytest.param("control_grid.npz", marks=pytest.mark.slow), "optimized_posegraph_slac.json"]
)
def test_a_damaged_file_is_made_again(whole, job, name):
    content = whole[2]
    path = job / "slac" / name
    path.write_bytes(path.read_bytes()[:-40])
    with pytest.raises(FileError, match=r"/job:.*refine_with_slac"):
        rec.integrate_scene(bent_walk(), SETTINGS, job, slac=True)
    rec.run_system(bent_walk(), SETTINGS, job, slac=True, resume=True)
    assert digest_of(job) == content


@pytest.mark.slow
def test_another_stiffness_is_another_stage(whole, job):
    _, report, content = whole
    softer = dataclasses.replace(SETTINGS, regularizer_weight=0.1)
    found = refine_with_slac(softer, job, resume=True)
    assert found.figures["bent_m"] > report.slac["bent_m"]
    assert refine_with_slac(SETTINGS, job, resume=True).figures == report.slac
    SETTINGS.write(job / "config.json")
    assert digest_of(job) == content


def test_fragments_placed_again_are_aligned_again(job):
    rec.register_fragments(dataclasses.replace(SETTINGS, seed=1), job)
    with pytest.raises(FileError, match=r"/job:.*refine_with_slac"):
        rec.integrate_scene(bent_walk(), SETTINGS, job, slac=True)


def test_the_stage_wants_the_ones_before(tmp_path):
    with pytest.raises(FileError, match="make_fragments"):
        refine_with_slac(SETTINGS, tmp_path)
    rec.make_fragments(Walk([0, 1]), SETTINGS, tmp_path)
    with pytest.raises(FileError, match="register_fragments"):
        refine_with_slac(SETTINGS, tmp_path)
    rec.register_fragments(SETTINGS, tmp_path)
    with pytest.raises(FileError, match="refine_with_slac"):
        rec.integrate_scene(Walk([0, 1]), SETTINGS, tmp_path, slac=True)


def test_what_slac_does_not_take_is_told_before_the_work(tmp_path):
    with pytest.raises(ValueError, match="fitness_threshold"):
        rec.run_system(Walk([0, 1]), config(fitness_threshold=2.0), tmp_path, slac=True)
    assert not list(tmp_path.rglob("*.ply"))


def a_grid(device="cpu"):
    grid = rec.ControlGrid(0.5, device=device)
    grid.touch(loom.PointCloud(np.random.default_rng(0).random((50, 3)) * 3 + 1000, device=device))
    grid.set_positions(grid.get_init_positions() + 0.01 * np.random.default_rng(1).random((len(grid), 3)))
    return grid


@pytest.mark.parametrize("empty", [False, True], ids=["a grid", "one without anchors"])
def test_a_grid_comes_back_bit_for_bit(tmp_path, device, empty):
    grid = rec.ControlGrid(0.5, device=device) if empty else a_grid(device)
    write_control_grid(tmp_path / "grid.npz", grid)
    again = read_control_grid(tmp_path / "grid.npz", device=device)
    assert (again.grid_size, len(again)) == (grid.grid_size, len(grid))
    assert np.array_equal(again.origin, grid.origin)
    assert np.array_equal(again.get_curr_positions(), grid.get_curr_positions())
    cloud = loom.PointCloud(np.random.default_rng(2).random((40, 3)) * 3 + 1000, device=device)
    assert np.array_equal(again.deform(cloud).points, grid.deform(cloud).points)


def test_a_file_that_is_no_grid_is_refused(tmp_path):
    path = tmp_path / "grid.npz"
    with pytest.raises(FileError, match=r"/grid\.npz:"):
        read_control_grid(path)
    write_control_grid(path, a_grid())
    whole = path.read_bytes()
    for broken in (b"", b"no archive", whole[: len(whole) // 2], whole[:-30]):
        path.write_bytes(broken)
        with pytest.raises(FileError, match="grid"):
            read_control_grid(path)
    names = {"sizes": np.ones(1), "origin": np.zeros(3), "cells": np.arange(2), "shifts": np.zeros((3, 3))}
    for wrong, said in (
        ({"format": np.zeros(3, np.uint8)}, "is not a control grid"),
        ({"cells": np.arange(2)[::-1]}, "do not belong to a control grid"),
        ({"shifts": np.full((3, 3), np.nan)}, "do not belong to a control grid"),
        ({}, "for [0-9]+ anchors"),
    ):
        sound = {"format": np.frombuffer(b"pointloom control grid 1", np.uint8)} | names
        np.savez_compressed(path, **(sound | wrong))
        with pytest.raises(FileError, match=said):
            read_control_grid(path)
