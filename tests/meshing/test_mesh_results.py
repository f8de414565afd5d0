"""clean_mesh, simplify_mesh, smooth_mesh and compare_meshes: the commands for meshes in memory."""

import json
from dataclasses import replace

import numpy as np
import pytest

import pointloom as loom
from pointloom import TriangleMesh
from pointloom.cli.jobs.clean_mesh import clean_mesh_file
from pointloom.cli.jobs.compare_meshes import compare_mesh_files
from pointloom.cli.jobs.simplify import simplify_file
from pointloom.cli.jobs.smooth_mesh import smooth_mesh_file


def torn() -> TriangleMesh:
    ball = TriangleMesh.create_sphere(1.0, 12).compute_vertex_normals()
    return ball.remove_triangles_by_mask(ball.vertices[ball.triangles].mean(axis=1)[:, 2] > 0.9)


CALLS = {
    "clean": (clean_mesh_file, {"fill": 0.6}, loom.clean_mesh, {"hole_size": 0.6}),
    "simplify": (simplify_file, {"by": "ratio", "amount": 0.5}, loom.simplify_mesh, {"ratio": 0.5}),
    "voxels": (simplify_file, {"by": "voxel", "amount": 0.2}, loom.simplify_mesh, {"voxel_size": 0.2}),
    "smooth": (smooth_mesh_file, {"factors": {"mu": -0.6}}, loom.smooth_mesh, {"mu": -0.6}),
    "sharpen": (
        *(smooth_mesh_file, {"method": "sharpen", "iterations": 1}),
        *(loom.smooth_mesh, {"method": "sharpen", "iterations": 1}),
    ),
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
    result = loom.compare_meshes(*meshes, **options)
    assert result.to_dict() == {key: report[key] for key in result.to_dict()}
    assert report["fscore"].keys() == {str(0.01 * result.diagonal)} and "more than 0.05 m" in str(result.warnings)
    assert loom.compare_meshes(meshes[0], meshes[0], thresholds=[], samples=100).reliable


def test_a_mesh_without_triangles_is_unreliable_but_no_error():
    for mesh in (TriangleMesh(), TriangleMesh([[0, 0, 0], [np.nan, 1, 2]])):
        assert loom.clean_mesh(mesh).warnings == ("no triangles remain",)
        assert "no triangles remain" in loom.simplify_mesh(mesh, ratio=0.5).warnings[0]
        assert loom.smooth_mesh(mesh).warnings == ("the mesh has no triangles",)
        with pytest.raises(ValueError, match="first:"):
            loom.compare_meshes(mesh, torn())
    assert loom.smooth_mesh(TriangleMesh([[np.nan] * 3])).moved is None


def test_a_destructive_repair_is_unreliable():
    box = TriangleMesh.create_box()
    fin = TriangleMesh(np.vstack([box.vertices, [[5, 5, 5]]]), np.vstack([box.triangles, [[*box.triangles[0][:2], 8]]]))
    lost = loom.clean_mesh(fin)
    assert lost.repair.removed_crowding_triangles == 1 and "% of the area was lost" in str(lost.warnings)
    holed = loom.clean_mesh(TriangleMesh(np.where(np.arange(8)[:, None] == 7, np.nan, box.vertices), box.triangles))
    assert "of the triangles were removed" in str(holed.warnings)
    opened = replace(holed, triangles_in=10**6, was_watertight=True)
    assert opened.warnings == ("the input was closed, the result is not: compare it with the input (compare_meshes)",)


@pytest.mark.parametrize("method", ["taubin", "sharpen"])
def test_saturated_colors_are_clamped_and_written(method, tmp_path):
    mesh = TriangleMesh.create_sphere(1.0, 12)
    mesh.vertex_colors = np.where(mesh.vertices[:, 2:] > 0, [1.0, 1.0, 1.0], 0.0)
    beyond = mesh.filter_smooth_taubin(10) if method == "taubin" else mesh.filter_sharpen(10)
    assert beyond.vertex_colors.max() > 1 and beyond.vertex_colors.min() < 0
    smooth = loom.smooth_mesh(mesh, method, 10).mesh
    np.testing.assert_array_equal(smooth.vertex_colors, beyond.vertex_colors.clip(0, 1))
    loom.write_triangle_mesh(tmp_path / "smooth.ply", smooth)
