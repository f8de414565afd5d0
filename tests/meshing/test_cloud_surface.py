"""Calls for clouds and meshes in memory give the results and reports of the commands for files."""

import json
from dataclasses import replace

import numpy as np
import pytest
import warp as wp

import pointloom as loom
from pointloom import TriangleMesh
from pointloom.cli.jobs.clean_mesh import clean_mesh_file
from pointloom.cli.jobs.compare_meshes import compare_mesh_files
from pointloom.cli.jobs.mesh import mesh_file
from pointloom.cli.jobs.simplify import simplify_file
from pointloom.cli.jobs.smooth_mesh import smooth_mesh_file
from pointloom.core.wording import json_text


def ball(count: int = 1500, **attributes) -> loom.PointCloud:
    points = np.random.default_rng(0).normal(size=(count, 3))
    return loom.PointCloud(points / np.linalg.norm(points, axis=1, keepdims=True), **attributes)


@pytest.mark.parametrize(
    "settings", [{"depth": 4}, {"method": "ball"}, {"method": "alpha", "alpha": 2.0}], ids=["poisson", "ball", "alpha"]
)
def test_a_cloud_in_memory_gives_the_result_and_report_of_its_file(tmp_path, device, settings):
    loom.write_point_cloud(tmp_path / "ball.ply", ball(intensity=np.arange(1500.0, dtype=np.float32)))
    report = mesh_file(tmp_path / "ball.ply", tmp_path / "out.ply", device=device, **settings)
    result = loom.meshing.create_surface(loom.read_point_cloud(tmp_path / "ball.ply", device=device), **settings)
    written = loom.read_triangle_mesh(tmp_path / "out.ply")
    np.testing.assert_array_equal(written.vertices, result.mesh.vertices)
    np.testing.assert_array_equal(written.triangles, result.mesh.triangles)
    shared = json.loads(json_text(result.to_dict()))
    assert shared == {key: json.loads(json_text(report.to_dict()))[key] for key in shared}
    assert shared["not_carried"] == ["intensity"]
    fields = {label: value for label, value in report.fields() if label not in ("seconds", "files")}
    assert [line.split(maxsplit=1)[0] for line in str(result).splitlines()] == [label.split()[0] for label in fields]
    assert all(value in str(result) for value in fields.values())


def test_stages_are_reported_at_their_start():
    stages = []
    loom.meshing.create_surface(ball(), "ball", progress=lambda *stage: stages.append(stage))
    assert stages == [("normals", 0, 0), ("ball", 0, 0), ("check", 0, 0)]


def test_the_remedy_names_the_python_argument(recwarn):
    points = ball().points
    mixed = loom.PointCloud(points, normals=points * np.where(np.arange(1500) % 3 == 0, -1, 1)[:, None])
    result = loom.meshing.create_surface(mixed, depth=4)
    assert str(result).splitlines()[-1].split(maxsplit=1) == ["warning", result.warnings[-1]]
    assert result.normals.given and "new_normals" in str(result.warnings)
    assert not recwarn.list and loom.meshing.create_surface(mixed, depth=4, new_normals=True).reliable


@pytest.mark.parametrize("method", ["poisson", "ball", "alpha"])
def test_without_a_finite_point_there_is_no_surface_and_no_error(method, device):
    for points in (np.full((4, 3), np.nan), np.zeros((0, 3))):
        result = loom.meshing.create_surface(loom.PointCloud(points, device=device), method)
        assert len(result.mesh) == 0 and result.warnings == ("no point is finite, so there is no surface",)
        assert (result.points_in, result.points, result.to_dict()["bounds"]) == (len(points), 0, None)
        assert result.mesh.device == loom.PointCloud(points, device=device).device


@pytest.mark.parametrize("tilt", [0, 0.3])
def test_no_alpha_is_advised_for_a_flat_cloud(tilt, recwarn):
    x, y = np.mgrid[0:1:12j, 0:1:12j].reshape(2, -1)
    result = loom.meshing.create_surface(loom.PointCloud(np.column_stack([x, y, tilt * x])), "alpha")
    assert len(result.mesh) == 0 and not recwarn.list
    text = str(result.warnings)
    assert "one plane" in text and "larger" not in text and "ball" in text


def test_the_mesh_has_the_arrays_of_the_cloud():
    cloud = loom.PointCloud(wp.array(ball().points.astype(np.float32), device="cpu"))
    result = loom.meshing.create_surface(cloud, depth=4)
    assert isinstance(result.mesh.cluster_connected_triangles()[0], wp.array)
    plain = loom.meshing.create_surface(cloud.to("cpu", arrays="numpy"), depth=4)
    np.testing.assert_array_equal(result.mesh.vertices, plain.mesh.vertices)
    assert result.to_dict() == plain.to_dict()


def torus(count: int, noise: float = 0.0) -> loom.PointCloud:
    cloud = loom.TriangleMesh.create_torus(0.4, 0.1, 60, 30).sample_points_poisson_disk(count, seed=1)
    return loom.PointCloud(cloud.points + np.random.default_rng(0).normal(0, noise, (count, 3)))


@pytest.mark.parametrize("method", ["poisson", "ball", "alpha"])
def test_points_too_sparse_for_their_shape_are_reported(method, device):
    """A tenth of the points does not show the hole of the torus or the thickness of its tube."""
    enough, few = (loom.meshing.create_surface(torus(count).to(device), method) for count in (3000, 60))
    assert enough.reliable, enough.warnings
    assert not few.reliable and "more points" in str(few.warnings) and "nan" not in str(few.warnings)


@pytest.mark.parametrize("scale", [1e-3, 1e4])
def test_the_checks_depend_neither_on_the_unit_nor_on_the_position(scale):
    def figures(points, size):
        support = loom.meshing.create_surface(loom.PointCloud(points), "ball").support
        return np.array([support.near / size, support.sparse, support.bent, support.turned, support.missed])

    points = torus(300, 0.02).points
    expected = figures(points, 1.0)
    np.testing.assert_allclose(figures(points * scale, scale), expected, atol=0.01)
    np.testing.assert_allclose(figures(points + np.array([691_000.25, 5_335_000.5, 519.75]), 1.0), expected, atol=0.01)


def test_two_objects_are_reliable_and_many_small_pieces_are_not():
    objects = [torus(1500).points + np.array([3.0 * k, 0, 0]) for k in range(2)]
    assert loom.meshing.create_surface(loom.PointCloud(np.vstack(objects)), "ball").reliable
    specks = [objects[0][:300] * 0.01 + [0.2 * k, 3, 0] for k in range(40)]
    cloud = loom.PointCloud(np.vstack([objects[0], *specks]))
    result = loom.meshing.create_surface(cloud, "ball", radii=[0.0005, 0.001, 0.002])
    assert "islands" in str(result.warnings) or "holes" in str(result.warnings)


def test_long_borders_of_ball_pivoting_are_reported():
    """Random points leave many small holes, of which the edges are few."""
    cloud = loom.TriangleMesh.create_sphere(1.0, 60).sample_points_uniformly(4000, seed=2)
    result = loom.meshing.create_surface(loom.PointCloud(cloud.points), "ball", radii=[0.066])
    assert result.summary.boundary_length > 8 * result.off.size and "its boundary is" in str(result.warnings)


def test_an_alpha_shape_of_two_sides_is_reliable():
    """Edges of three triangles occur where the inner and the outer side touch."""
    cloud = loom.TriangleMesh.create_torus(0.4, 0.12).sample_points_uniformly(4000, seed=3)
    result = loom.meshing.create_surface(loom.PointCloud(cloud.points), "alpha")
    assert result.summary.crowded_edges > 0.01 * result.summary.edges and result.reliable, result.warnings


def torn() -> TriangleMesh:
    ball = TriangleMesh.create_sphere(1.0, 12).compute_vertex_normals()
    return ball.remove_triangles_by_mask(ball.vertices[ball.triangles].mean(axis=1)[:, 2] > 0.9)


SHARPEN = {"method": "sharpen", "iterations": 1}
CALLS = {
    "clean": (clean_mesh_file, {"fill": 0.6}, loom.meshing.clean_mesh, {"hole_size": 0.6}),
    "simplify": (simplify_file, {"by": "ratio", "amount": 0.5}, loom.meshing.simplify_mesh, {"ratio": 0.5}),
    "voxels": (simplify_file, {"by": "voxel", "amount": 0.2}, loom.meshing.simplify_mesh, {"voxel_size": 0.2}),
    "smooth": (smooth_mesh_file, {"factors": {"mu": -0.6}}, loom.meshing.smooth_mesh, {"mu": -0.6}),
    "sharpen": (smooth_mesh_file, SHARPEN, loom.meshing.smooth_mesh, SHARPEN),
}


@pytest.mark.parametrize("name", CALLS)
def test_a_mesh_in_memory_gives_the_result_and_report_of_its_file(tmp_path, device, name):
    command, options, call, arguments = CALLS[name]
    loom.write_triangle_mesh(tmp_path / "in.ply", torn())
    report = command(tmp_path / "in.ply", tmp_path / "out.ply", device=device, **options)
    mesh = loom.read_triangle_mesh(tmp_path / "in.ply", device=device)
    before = mesh.vertices
    result = call(mesh, **arguments)
    written = loom.read_triangle_mesh(tmp_path / "out.ply")
    for array in ("vertices", "triangles", "vertex_normals"):
        np.testing.assert_array_equal(getattr(written, array), getattr(result.mesh, array))
    np.testing.assert_array_equal(mesh.vertices, before)  # the input is unchanged
    figures, all_figures = json.loads(json.dumps(result.to_dict())), json.loads(json.dumps(report.to_dict()))
    assert figures == {key: all_figures[key] for key in figures}
    assert figures["reliable"] == result.reliable and figures["warnings"] == list(result.warnings)
    assert report.fields()[: len(result.fields())] == result.fields()
    assert [line.split()[0] for line in str(result).splitlines()] == [label for label, _ in result.fields()]


def test_comparison_in_memory_matches_that_of_files(tmp_path, device):
    loom.write_triangle_mesh(tmp_path / "a.ply", torn())
    loom.write_triangle_mesh(tmp_path / "b.ply", TriangleMesh.create_sphere(1.01, 12))
    options = {"samples": 500, "limit": 0.05, "seed": 3}
    report = compare_mesh_files(tmp_path / "a.ply", tmp_path / "b.ply", device=device, **options).to_dict()
    meshes = [loom.read_triangle_mesh(tmp_path / name, device=device) for name in ("a.ply", "b.ply")]
    result = loom.meshing.compare_meshes(*meshes, **options)
    assert result.to_dict() == {key: report[key] for key in result.to_dict()}
    assert report["fscore"].keys() == {str(0.01 * result.diagonal)} and "more than 0.05 m" in str(result.warnings)
    assert loom.meshing.compare_meshes(meshes[0], meshes[0], thresholds=[], samples=100).reliable


def test_a_mesh_without_triangles_is_unreliable_but_no_error():
    for mesh in (TriangleMesh(), TriangleMesh([[0, 0, 0], [np.nan, 1, 2]])):
        assert loom.meshing.clean_mesh(mesh).warnings == ("no triangles remain",)
        assert "no triangles remain" in loom.meshing.simplify_mesh(mesh, ratio=0.5).warnings[0]
        assert loom.meshing.smooth_mesh(mesh).warnings == ("the mesh has no triangles",)
        with pytest.raises(ValueError, match="first:"):
            loom.meshing.compare_meshes(mesh, torn())
    assert loom.meshing.smooth_mesh(TriangleMesh([[np.nan] * 3])).moved is None


def test_vertices_closer_than_the_merge_distance_are_merged_and_parts_below_the_limits_removed():
    """Two halves of a square, 1 mm apart, and a triangle of 0.5 m^2."""
    corners = [
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
        [1.001, 0, 0],
        [1.001, 1, 0],
        [0.001, 1, 0],
        [7, 0, 0],
        [8, 0, 0],
        [7, 1, 0],
    ]
    mesh = TriangleMesh(corners, [[0, 1, 2], [3, 4, 5], [6, 7, 8]])
    for options, triangles, parts in (
        ({}, 3, 3),
        ({"merge_distance": 0.0005}, 3, 3),
        ({"merge_distance": 0.002}, 3, 2),
        ({"merge_distance": 0.002, "min_triangles": 2}, 2, 1),
        ({"merge_distance": 0.002, "min_area": 0.75}, 2, 1),
        ({"merge_distance": 0.002, "min_area": 0.25}, 3, 2),
    ):
        found = loom.meshing.clean_mesh(mesh, **options)
        assert (len(found.mesh), found.parts) == (triangles, parts), options


def test_simplification_ends_at_the_largest_error_and_keeps_borders_by_their_weight():
    ball, simplify = TriangleMesh.create_sphere(1.0, 12), loom.meshing.simplify_mesh
    coarse, fine = (simplify(ball, triangles=4, max_error=error) for error in (1e-4, 1e-6))
    assert 4 < len(coarse.mesh) < 0.6 * len(fine.mesh) < 0.6 * len(ball)
    assert fine.errors.rms < 0.3 * coarse.errors.rms
    corners = np.stack(np.meshgrid(np.arange(17), np.arange(17)), -1).reshape(-1, 2) / 16
    first = (np.arange(16)[:, None] * 17 + np.arange(16)).ravel()
    halves = [first, first + 1, first + 17], [first + 1, first + 18, first + 17]
    wave = np.column_stack([corners, 0.05 * np.sin(9 * corners[:, 0])])
    sheet = TriangleMesh(wave, np.concatenate([np.column_stack(half) for half in halves]))
    loose, tight = (simplify(sheet, triangles=40, boundary_weight=weight).mesh for weight in (0, 1))
    assert tight.get_surface_area() == pytest.approx(sheet.get_surface_area(), rel=0.01)
    assert loose.get_surface_area() < 0.95 * sheet.get_surface_area()


def test_stages_of_cleaning_are_reported():
    events = []
    loom.meshing.clean_mesh(TriangleMesh.create_box(), progress=lambda *event: events.append(event))
    assert events == [("repair", 0, 0), ("parts", 0, 0), ("check", 0, 0)]


def test_factors_of_smoothing_are_those_of_its_filter():
    ball = TriangleMesh.create_sphere(1.0, 8)
    smooth = loom.meshing.smooth_mesh
    for found, expected in (
        (smooth(ball, "laplacian", 3, lambda_filter=0.2), ball.filter_smooth_laplacian(3, 0.2)),
        (smooth(ball, "taubin", 3, lambda_filter=0.2, mu=-0.3), ball.filter_smooth_taubin(3, 0.2, -0.3)),
        (smooth(ball, "sharpen", 1, strength=0.25), ball.filter_sharpen(1, 0.25)),
    ):
        np.testing.assert_array_equal(found.mesh.vertices, expected.vertices)
    moved = [smooth(ball, "laplacian", 1, lambda_filter=factor).moved.mean for factor in (0.2, 0.4)]
    assert moved[1] == pytest.approx(2 * moved[0], rel=1e-4)


def test_smoothing_that_moves_the_surface_is_unreliable_though_the_area_is_kept(device):
    drum = TriangleMesh.create_cylinder(0.4, 1.0, 32, 18).to(device)
    for method, is_same in (("taubin", True), ("simple", False)):
        smooth = loom.meshing.smooth_mesh(drum, method, 1)
        assert smooth.area > 0.9 * smooth.area_in and smooth.reliable == is_same == (smooth.changed < 0.05)
    assert "of the surface moved by more than 2% of its size" in smooth.warnings[0]
    far = loom.meshing.smooth_mesh(drum.translate([5e5, 5.4e6, 120]).scale(1000, [5e5, 5.4e6, 120]), "simple", 1)
    assert far.changed == pytest.approx(smooth.changed, abs=0.005), "in any unit and place"
    holed = TriangleMesh(np.r_[drum.vertices, [[np.nan] * 3]], np.r_[drum.triangles, [[0, 1, len(drum.vertices)]]])
    assert loom.meshing.smooth_mesh(holed).changed is None


def test_merged_vertices_that_leave_the_surface_in_place_are_reliable(device):
    ring = TriangleMesh.create_torus(0.5, 0.2, 60, 40).to(device)
    for distance, is_same in ((0.05, True), (0.2, False)):
        clean = loom.meshing.clean_mesh(ring, merge_distance=distance)
        assert clean.repair.merged_vertices > 0.5 * clean.vertices_in
        assert clean.reliable == is_same == (clean.gone < 0.01)
    assert "merge_distance below 0.2 m" in clean.warnings[0]


def test_a_destructive_repair_is_unreliable():
    box = TriangleMesh.create_box()
    fin = TriangleMesh(np.vstack([box.vertices, [[5, 5, 5]]]), np.vstack([box.triangles, [[*box.triangles[0][:2], 8]]]))
    lost = loom.meshing.clean_mesh(fin)
    assert lost.repair.removed_crowding_triangles == 1 and "% of the area was lost" in str(lost.warnings)
    holed = loom.meshing.clean_mesh(
        TriangleMesh(np.where(np.arange(8)[:, None] == 7, np.nan, box.vertices), box.triangles)
    )
    assert "of the triangles were removed" in str(holed.warnings)
    opened = replace(holed, triangles_in=10**6, was_watertight=True)
    assert opened.warnings == ("the input was closed, the result is not: compare it with the input (compare_meshes)",)


@pytest.mark.parametrize("method", ["taubin", "sharpen"])
def test_saturated_colors_are_clamped_and_written(method, tmp_path):
    mesh = TriangleMesh.create_sphere(1.0, 12)
    mesh.vertex_colors = np.where(mesh.vertices[:, 2:] > 0, [1.0, 1.0, 1.0], 0.0)
    beyond = mesh.filter_smooth_taubin(10) if method == "taubin" else mesh.filter_sharpen(10)
    assert beyond.vertex_colors.max() > 1 and beyond.vertex_colors.min() < 0
    smooth = loom.meshing.smooth_mesh(mesh, method, 10).mesh
    np.testing.assert_array_equal(smooth.vertex_colors, beyond.vertex_colors.clip(0, 1))
    loom.write_triangle_mesh(tmp_path / "smooth.ply", smooth)
