"""Color maps: agreement with Open3D, recovery of poses and warped images, frames in memory, bad input."""

import dataclasses
from typing import Any

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.kept_arrays import KeptArrays
from pointloom.meshing.color_map.results import NothingSeenError

from ..hostile import faults_of
from .color_scenes import make_scene, paint, perturb, pose_errors
from .image_scenes import bilinear
from .open3d_meshes import in_open3d

color_map = loom.meshing
FORMS = ("rigid", "non-rigid")
FINE = 81  # vertices per side: enough per anchor cell to warp an image


def open3d_colors_and_poses(o3d, scene, poses, iterations, form="rigid"):
    pipeline, camera, mesh = o3d.pipelines.color_map, scene.camera, in_open3d(o3d, scene.mesh)
    images, parameters = [], []
    for frame, pose in zip(scene.frames, poses, strict=True):
        pair = (o3d.geometry.Image(np.ascontiguousarray(part)) for part in (frame.color, frame.depth))
        settings = {"depth_scale": 1.0, "depth_trunc": 10.0, "convert_rgb_to_intensity": False}
        images.append(o3d.geometry.RGBDImage.create_from_color_and_depth(*pair, **settings))
        parameter = o3d.camera.PinholeCameraParameters()
        numbers = (camera.width, camera.height, camera.fx, camera.fy, camera.cx, camera.cy)
        parameter.intrinsic = o3d.camera.PinholeCameraIntrinsic(*numbers)
        parameter.extrinsic = np.linalg.inv(pose)
        parameters.append(parameter)
    path = o3d.camera.PinholeCameraTrajectory()
    path.parameters = parameters
    run, option = {
        "rigid": (pipeline.run_rigid_optimizer, pipeline.RigidOptimizerOption),
        "non-rigid": (pipeline.run_non_rigid_optimizer, pipeline.NonRigidOptimizerOption),
    }[form]
    mesh, path = run(mesh, images, path, option(maximum_iteration=iterations))
    optimized_poses = np.array([np.linalg.inv(parameter.extrinsic) for parameter in path.parameters])
    return np.asarray(mesh.vertex_colors), optimized_poses


def open3d_colors(*given):
    return open3d_colors_and_poses(*given)[0].astype(np.float32)


def open3d_poses(*given):
    return open3d_colors_and_poses(*given)[1]


def color(scene, poses=None, iterations=0, form="rigid", images=None, **options):
    named = {k: options.pop(k) for k in ("occlusion",) if k in options}
    option = color_map.ColorMapOption(maximum_iteration=iterations, **options)
    images = scene.frames if images is None else images
    path, call = scene.path(poses), color_map.optimize_color_map
    return call(scene.mesh, images, path, option, intrinsic=scene.camera, method=form, **named)


@pytest.mark.parametrize("form", FORMS)
def test_colors_without_iterations_match_open3d_where_images_show_the_vertex(device, oracle, form):
    scene = make_scene(device, rows=21)
    bad = perturb(scene.poses)
    result = color(scene, bad, form=form)
    theirs = oracle(f"meshing/color_map/{form}", open3d_colors, scene, bad, 0, form)
    # float32 against float64
    assert np.abs(result.mesh.vertex_colors - theirs)[result.seen].max() < 1e-6
    assert 0.3 < result.seen.mean() < 0.7 and (result.trajectory.poses == bad).all()


def test_unseen_vertices_take_the_mean_of_the_three_nearest_colored_ones(device):
    scene = make_scene(device)
    result = color(scene)
    vertices, colors, seen = scene.mesh.vertices, result.mesh.vertex_colors, result.seen
    gaps = ((vertices[~seen][:, None] - vertices[seen][None]) ** 2).sum(-1)
    ranks = np.sort(gaps, axis=1)
    clear = ranks[:, 3] - ranks[:, 2] > 1e-6  # no tie for the third place
    nearest = np.argsort(gaps, axis=1)[:, :3]
    expected = colors[seen][nearest].mean(axis=1)
    assert clear.sum() > 100 and np.abs(colors[~seen] - expected)[clear].max() < 1e-6
    black = color(scene, invisible_vertex_color_knn=0).mesh.vertex_colors
    assert (black[~seen] == 0).all() and (black[seen] == colors[seen]).all()


def test_poses_are_recovered_and_the_residual_decreases(device):
    scene = make_scene(device)
    bad = perturb(scene.poses, 0.5, 0.01)
    result = color(scene, bad, 50)
    rotation_error, moved = pose_errors(bad, scene.poses)
    rotation_error_after, moved_after = pose_errors(result.trajectory.poses, scene.poses)
    assert result.residual < 0.05 * result.residual_before
    assert rotation_error_after < 0.2 * rotation_error and moved_after < 0.2 * moved
    assert result.iterations <= 50
    true, seen = paint(scene.mesh.vertices), result.seen
    errors = [np.abs(r.mesh.vertex_colors - true)[seen].mean() for r in (color(scene, bad), result)]
    assert errors[1] < 0.7 * errors[0]


@pytest.mark.parametrize("iterations", [5, 50])
def test_residual_is_at_most_that_of_open3d_after_equal_iterations(device, oracle, iterations):
    """Open3D's gradients lack Sobel's factor 1/8, so its Gauss-Newton steps are an eighth of the correct ones."""
    scene = make_scene(device, rows=21)
    bad = perturb(scene.poses, seed=3)
    theirs = oracle(f"meshing/color_map/poses_{iterations}", open3d_poses, scene, bad, iterations)
    assert color(scene, bad, iterations).residual <= 1.001 * color(scene, theirs).residual


def test_initial_poses_are_never_replaced_by_worse_ones(device):
    scene = make_scene(device, rows=15, width=64, height=48)
    far = perturb(scene.poses, 3.0, 0.08, seed=1)
    for form in FORMS:
        result = color(scene, far, 15, form)
        assert result.residual <= result.residual_before


def test_warped_images_are_rectified(device):
    scene = make_scene(device, rows=FINE, bend=0.15)
    rigid, bent = color(scene, iterations=20), color(scene, iterations=20, form="non-rigid")
    assert bent.residual < 0.5 * rigid.residual < 0.5 * rigid.residual_before
    true, seen = paint(scene.mesh.vertices), rigid.seen
    assert np.abs(bent.mesh.vertex_colors - true)[seen].mean() < np.abs(rigid.mesh.vertex_colors - true)[seen].mean()
    warp = bent.warp(0)
    assert warp.shape == (16, 21, 2)  # 160 px in steps of 8 px
    assert 0.05 < np.abs(warp).max() < 3.0
    check_unwarped(scene, bent)


def check_unwarped(scene, bent):
    image, flat = scene.frames[1].color.astype(float), bent.unwarped_image(1)
    warp, step = bent.warp(1), 8
    v, u = 61, 83
    shift = bilinear(warp, u / step, v / step)
    expected = bilinear(image, u + shift[0], v + shift[1])
    assert np.abs(flat[v, u] - expected).max() <= 0.5 + 1e-9
    plain = color(scene)
    assert (plain.unwarped_image(0) == scene.frames[0].color).all() and plain.warp(0).size == 0


def test_without_depth_rays_determine_occlusion(device):
    scene = make_scene(device)
    by_rays = color(scene, images=[frame.color for frame in scene.frames])
    by_depth = color(scene)
    assert (by_rays.seen != by_depth.seen).mean() < 0.01  # chords of the ball's triangles
    both = by_rays.seen & by_depth.seen
    true = paint(scene.mesh.vertices)
    # neighboring pixels of this paint differ by less
    assert np.abs(by_rays.mesh.vertex_colors - true)[both].max() < 0.06
    requested = color(scene, occlusion="rays")
    assert (requested.mesh.vertex_colors == by_rays.mesh.vertex_colors).all()


def seen_pixels(device, depth, **options):
    """Pixels whose vertex, 1 m before the camera and 0.1 px beside their center, is seen at this depth [m]."""
    height, width = depth.shape
    v, u = np.mgrid[:height, :width]
    camera = loom.PinholeCameraIntrinsic(width, height, 40.0, 40.0, 0.0, 0.0)
    corners = np.stack([(u + 0.1) / 40, (v + 0.1) / 40, np.ones_like(u)], -1).reshape(-1, 3)
    mesh = loom.TriangleMesh(corners, [[0, 1, 2]], device=device)
    frame = loom.RGBDImage(np.zeros((height, width, 3), np.uint8), depth.astype(np.float32), device=device)
    rules = {"image_boundary_margin": 0, "half_dilation_kernel_size_for_discontinuity_map": 0} | options
    rules = {"depth_threshold_for_discontinuity_check": np.inf} | rules
    option = color_map.ColorMapOption(**rules)
    path = loom.Trajectory([np.eye(4)])
    return color_map.optimize_color_map(mesh, [frame], path, option, intrinsic=camera).seen.reshape(height, width)


COLUMNS, ROWS = np.meshgrid(np.arange(32), np.arange(24))
STEP = np.where(COLUMNS < 16, 1.0, 1.02)  # a Sobel response of 4 x 0.02 m in the two columns at the step
DEPTH_RULES = [
    ("maximum_allowable_depth", 1.01, STEP, COLUMNS < 16),
    ("maximum_allowable_depth", 1.03, STEP, COLUMNS >= 0),
    ("depth_threshold_for_visibility_check", 0.0205, 1 + 0.001 * COLUMNS, COLUMNS <= 20),
    ("depth_threshold_for_visibility_check", 0.0105, 1 + 0.001 * COLUMNS, COLUMNS <= 10),
    ("depth_threshold_for_discontinuity_check", 0.075, STEP, (COLUMNS < 15) | (COLUMNS > 16)),
    ("depth_threshold_for_discontinuity_check", 0.085, STEP, COLUMNS >= 0),
    ("image_boundary_margin", 4, np.ones((24, 32)), (COLUMNS >= 4) & (COLUMNS < 28) & (ROWS >= 4) & (ROWS < 20)),
]


@pytest.mark.parametrize(("option", "value", "depth", "expected"), DEPTH_RULES)
def test_each_rule_of_depth_selects_its_pixels(device, option, value, depth, expected):
    np.testing.assert_array_equal(seen_pixels(device, depth, **{option: value}), expected)


@pytest.mark.parametrize("size", [1, 4])
def test_pixels_within_the_kernel_size_of_a_depth_edge_are_ignored(device, size):
    rules = {"depth_threshold_for_discontinuity_check": 0.05, "half_dilation_kernel_size_for_discontinuity_map": size}
    np.testing.assert_array_equal(seen_pixels(device, STEP, **rules), np.abs(COLUMNS - 15.5) > size + 0.5)


def test_the_anchors_of_a_warp_are_as_many_and_as_stiff_as_requested(device):
    scene = make_scene(device, views=3, width=64, height=48, bend=0.15)
    soft, stiff = (color(scene, iterations=5, form="non-rigid", number_of_vertical_anchors=9,
                         non_rigid_anchor_point_weight=weight, image_boundary_margin=2)
                   for weight in (0.316, 1e6))  # fmt: skip
    assert soft.warp(0).shape == stiff.warp(0).shape == (9, 12, 2)  # 64 px in steps of 6 px
    assert np.abs(soft.warp(1)).max() > 0.01 and np.abs(stiff.warp(1)).max() < 1e-4


def test_far_from_zero_works_as_at_zero(device):
    near, far = make_scene(device), make_scene(device, shift=(5e5, 5.4e6, 120.0))
    results = [color(scene, perturb(scene.poses), 10) for scene in (near, far)]
    moved = results[1].trajectory.poses[:, :3, 3] - (5e5, 5.4e6, 120.0)
    # the mesh's vertices are float32 about its origin
    assert np.abs(moved - results[0].trajectory.poses[:, :3, 3]).max() < 1e-6
    assert abs(results[1].residual - results[0].residual) < 1e-6
    seen = results[0].seen & results[1].seen
    close = np.abs(results[1].mesh.vertex_colors - results[0].mesh.vertex_colors).max(axis=1) < 1e-6
    assert close[seen].mean() > 0.99  # except positions halfway between two pixels


@pytest.mark.parametrize("form", FORMS)
def test_an_image_that_sees_nothing_keeps_its_pose(device, form):
    scene = make_scene(device, rows=25)
    poses = perturb(scene.poses)
    poses[2, :3, 3] = 50.0
    result = color(scene, poses, 5, form)
    assert result.view_counts[2] == 0 and (result.trajectory.poses[2] == poses[2]).all()
    assert result.residual < result.residual_before


def test_no_image_that_sees_the_mesh_is_an_error(device):
    scene = make_scene(device, rows=15)
    poses = scene.poses.copy()
    poses[:, 2, 3] += 40
    with pytest.raises(NothingSeenError, match=r"^images_rgbd:"):
        color(scene, poses)


def test_non_finite_vertices_are_not_seen_and_stay_black(device):
    scene = make_scene(device, rows=15)
    vertices = scene.mesh.vertices.copy()
    vertices[7] = np.nan
    scene.mesh = loom.TriangleMesh(vertices, scene.mesh.triangles, device=device)
    result = color(scene, iterations=3)
    assert not result.seen[7] and (result.mesh.vertex_colors[7] == 0).all()
    assert np.isfinite(result.mesh.vertex_colors).all()


def test_a_mesh_without_triangles_is_colored_by_depth_and_rejected_by_rays(device):
    scene = make_scene(device, rows=15)
    colors = color(scene).mesh.vertex_colors
    scene.mesh = loom.TriangleMesh(scene.mesh.vertices, device=device)
    assert (color(scene).mesh.vertex_colors == colors).all()
    with pytest.raises(ValueError, match=r"mesh: .*triangles"):
        color(scene, occlusion="rays")
    scene.mesh = loom.TriangleMesh(device=device)
    with pytest.raises(ValueError, match="expected vertices to color"):
        color(scene)


CAMERA = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
POSE = np.eye(4)


def wall(**options: Any) -> loom.TriangleMesh:
    """A wall 1 m in front of the camera, slightly larger than its field of view."""
    x, y = np.meshgrid(np.linspace(-0.42, 0.42, 13), np.linspace(-0.3, 0.3, 11))
    indices = np.arange(143).reshape(11, 13)
    a, b, c, d = indices[:-1, :-1].ravel(), indices[:-1, 1:].ravel(), indices[1:, 1:].ravel(), indices[1:, :-1].ravel()
    vertices = np.stack([x.ravel(), y.ravel(), np.ones(143)], 1)
    return loom.TriangleMesh(vertices, np.concatenate([np.stack([a, c, b], 1), np.stack([a, d, c], 1)]), **options)


def frames(count: int = 2, color: Any = (0, 255, 0)) -> Any:
    image = np.full((48, 64, 3), color, np.uint8)
    return loom.frames_from([(image, np.full((48, 64), 1000, np.uint16))] * count, CAMERA)


def test_frames_in_memory_color_a_mesh(device):
    stages = []
    options = {"method": "none", "progress": lambda *stage: stages.append(stage)}
    result = loom.meshing.texture_mesh(wall(device=device), frames(), [POSE] * 2, **options)
    assert (result.mesh.vertex_colors == (0, 1, 0)).all() and result.reliable
    assert result.frame_count == 2 and result.blind_frames == 0 and 0.3 < result.seen_fraction < 0.9
    assert result.texel_fraction is None and (result.turned, result.moved) == (0.0, 0.0)
    assert stages == [("frames", 0, 2), ("frames", 1, 2), ("frames", 2, 2), ("colors", 0, 0)]


@pytest.mark.parametrize("stop", range(1, 4))
def test_an_interrupted_texture_continues_to_the_same_result(device, tmp_path, monkeypatch, stop):
    pytest.importorskip("xatlas")
    rng, left = np.random.default_rng(3), [stop]
    given = loom.frames_from(
        [(rng.integers(0, 256, (48, 64, 3), np.uint8), np.full((48, 64), 1000, np.uint16)) for _ in range(3)], CAMERA
    )
    moved = np.tile(POSE, (3, 1, 1))
    moved[1:, 0, 3] = 0.004, -0.003
    call = {"poses": moved, "method": "non-rigid", "size": 64}
    expected = loom.meshing.texture_mesh(wall(device=device), given, **call)
    get = KeptArrays.get

    def interrupted(self, name, *given):
        arrays = get(self, name, *given)
        left[0] -= 1
        if not left[0]:
            raise KeyboardInterrupt
        return arrays

    monkeypatch.setattr(KeptArrays, "get", interrupted)
    with pytest.raises(KeyboardInterrupt):
        loom.meshing.texture_mesh(wall(device=device), given, **call, work=tmp_path / "work")
    assert len(list((tmp_path / "work").glob("*.npz"))) == stop
    result = loom.meshing.texture_mesh(wall(device=device), given, **call, work=tmp_path / "work")
    np.testing.assert_array_equal(result.mesh.textures[0], expected.mesh.textures[0])
    np.testing.assert_array_equal(result.mesh.triangle_uvs, expected.mesh.triangle_uvs)
    np.testing.assert_array_equal(result.colors.mesh.vertex_colors, expected.colors.mesh.vertex_colors)
    np.testing.assert_array_equal(result.colors.warp(1), expected.colors.warp(1))
    assert result.to_dict() == expected.to_dict() and expected.colors.iterations > 1
    other = loom.meshing.texture_mesh(wall(device=device), given, **call | {"method": "none"}, work=tmp_path / "work")
    assert other.method == "none" and other.colors.iterations == 0


def test_a_texture_replaces_vertex_colors():
    mesh = wall()
    mesh.triangle_uvs = (mesh.vertices[mesh.triangles][..., :2] + 0.42).reshape(-1, 2) / 0.84
    result = loom.meshing.texture_mesh(mesh, frames(), loom.Trajectory([POSE] * 2), size=32)
    assert result.mesh.vertex_colors is None and result.mesh.textures[0].shape == (32, 32, 3)
    assert result.size == 32 and 0.3 < result.texel_fraction < 0.9
    assert "32 x 32, " in str(result).splitlines()[-1]
    assert (result.colors.mesh.vertex_colors == (0, 1, 0)).all()


def test_images_without_improved_agreement_are_unreliable():
    good = loom.meshing.texture_mesh(wall(), frames(10), [POSE] * 10, method="none")

    def warnings(method: str, before: float, after: float, blind: int = 0) -> tuple[str, ...]:
        views = np.where(np.arange(10) < blind, 0, 9)
        colors = dataclasses.replace(good.colors, residual_before=before, residual=after, view_counts=views)
        return dataclasses.replace(good, method=method, colors=colors).warnings

    worse = str(warnings("rigid", 0.05, 0.0499))
    assert "do not agree better" in worse and "Compare with method='none'" in worse
    for given in (("none", 0.05, 0.0499), ("rigid", 0.05, 0.03), ("rigid", 0.005, 0.005)):
        assert not warnings(*given)
    assert "6 of 10 frames" in str(warnings("rigid", 0.05, 0.0, blind=6))


def test_color_maps_report_what_the_images_contradict():
    images, path = [np.full((48, 64, 3), 200, np.uint8)] * 2, loom.Trajectory([POSE] * 2)
    good = loom.meshing.optimize_color_map(wall(), images, path, intrinsic=CAMERA)
    assert good.reliable and good.to_dict()["warnings"] == []
    for text, values in {
        "frames show only 0.0% of the vertices": {"seen": np.arange(143) < 0},
        "2 of 2 frames show nothing": {"view_counts": np.zeros(2, np.int64)},
        "Compare with maximum_iteration=0": {"residual_before": 0.05, "residual": 0.0499, "iterations": 5},
    }.items():
        result = dataclasses.replace(good, **values)
        assert not result.reliable and text in str(result.warnings)
        assert result.to_dict()["warnings"] == list(result.warnings)


def test_invalid_frames_are_rejected_by_name():
    gray = loom.frames_from([(None, np.full((48, 64), 1000, np.uint16))], CAMERA)
    for given, poses, message in (
        (gray, [POSE], "frames: frame-000000 has no color"),
        (frames(1), None, "frames: frame-000000 has no pose. Pass poses"),
        (frames(0), [], "frames: expected at least one frame"),
        (frames(2), [POSE], "poses: expected one per frame, got 1 for more frames"),
        (frames(1), [POSE] * 2, "poses: expected 1, one per frame, got 2"),
        (frames(1), [2 * POSE], r"poses\[0\]"),
    ):
        with pytest.raises(ValueError, match=message):
            loom.meshing.texture_mesh(wall(), given, poses)
    for size in ({}, {"size": 8}):
        with pytest.raises(ValueError, match="mesh:"):
            loom.meshing.texture_mesh(loom.TriangleMesh(), frames(1), [POSE], **size)
    with pytest.raises(NothingSeenError):
        loom.meshing.texture_mesh(wall().translate([0, 0, 100]), frames(1), [POSE])


ARGUMENTS = {"method": "none", "size": 8, "depth_max": 4.0, "work": None, "progress": None}


@pytest.mark.parametrize("argument", ["mesh", "frames", "poses", *ARGUMENTS])
def test_a_hostile_value_is_rejected_by_name(argument):
    mesh = wall()
    mesh.triangle_uvs = (mesh.vertices[mesh.triangles][..., :2] + 0.42).reshape(-1, 2) / 0.84
    good = {"mesh": mesh, "frames": frames(1), "poses": [POSE], **ARGUMENTS}
    faults = faults_of(loom.meshing.texture_mesh, good, argument)
    assert not faults, "\n".join(faults)
