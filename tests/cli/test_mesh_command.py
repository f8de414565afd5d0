"""mesh: surfaces, estimated normals, and unreliable results."""

import dataclasses
import json

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom import TriangleMesh
from pointloom.meshing.mesh.cloud_surface import _find_fit
from pointloom.meshing.mesh.mesh_summary import describe_surface
from pointloom.meshing.mesh.surface_result import MadeUp, NormalsUsed, PointsOff, SurfaceResult
from pointloom.visualization.render.surface_picture import looks_inwards

from .commands import answer, names_in, refusal, run, unreliable


@pytest.fixture
def ball(tmp_path):
    """A file of 3,001 points of a sphere without normals, with colors and intensities; one is not finite."""
    points = np.random.default_rng(0).normal(size=(3001, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    colors, intensity = np.abs(points), np.arange(3001, dtype=np.float32)
    points[5] = np.nan
    path = tmp_path / "ball.ply"
    loom.write_point_cloud(path, loom.PointCloud(points, colors=colors, intensity=intensity))
    return path


def grid(count: int = 12) -> TriangleMesh:
    x, y = np.meshgrid(np.arange(count), np.arange(count), indexing="ij")
    at = np.arange(count * count).reshape(count, count)
    a, b, c, d = at[:-1, :-1].ravel(), at[1:, :-1].ravel(), at[1:, 1:].ravel(), at[:-1, 1:].ravel()
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    return TriangleMesh(np.stack([x.ravel(), y.ravel(), np.zeros(count * count)], 1), triangles)


def closed(inwards: bool = False) -> TriangleMesh:
    mesh = TriangleMesh.create_tetrahedron()
    return TriangleMesh(mesh.vertices, mesh.triangles[:, ::-1]) if inwards else mesh


def test_the_surface_matches_the_library_with_estimated_normals_and_trimming(ball, tmp_path, device):
    sparsest = ["--density-quantile", 0.01]
    words = ["--depth", 5, *sparsest, "--picture", tmp_path / "out.png", "--device", device]
    report = answer("mesh", ball, tmp_path / "out.ply", *words)
    cloud = loom.read_point_cloud(ball, device=device).remove_non_finite_points()
    cloud = cloud.estimate_normals(max_nn=30).orient_normals_consistent_tangent_plane(30)
    mesh, densities = TriangleMesh.create_from_point_cloud_poisson(cloud, depth=5)
    mesh = mesh.remove_vertices_by_mask(densities < np.quantile(densities, 0.01)).remove_unreferenced_vertices()
    written = loom.read_triangle_mesh(tmp_path / "out.ply")
    np.testing.assert_array_equal(written.vertices, mesh.vertices)
    np.testing.assert_array_equal(written.triangles, mesh.triangles)
    assert written.vertex_colors is not None and written.vertex_normals is not None
    assert (report["method"], report["depth"], report["density_quantile"]) == ("poisson", 5, 0.01)
    assert (report["points_in"], report["points"], report["not_carried"]) == (3001, 3000, ["intensity"])
    assert (report["vertices"], report["triangles"], report["parts"]) == (len(mesh.vertices), len(mesh), 1)
    assert report["normals"].startswith("made of the 30 nearest points of each and oriented: the input has none")
    assert report["disagreement"] == 0 and report["reliable"] and 0.97 < report["area"] / (4 * np.pi) < 1.01
    assert report["files"] == [str(tmp_path / "out.ply"), str(tmp_path / "out.png")]
    picture = np.asarray(Image.open(tmp_path / "out.png"))
    assert picture.shape == (960, 1280, 3) and 0.2 < (picture != picture[0, 0]).any(axis=-1).mean() < 0.8


@pytest.mark.parametrize(("share", "quantile"), [(1.0, 0.0), (0.5, 0.01)])
def test_only_extrapolated_surfaces_are_trimmed(ball, tmp_path, share, quantile):
    points = loom.read_point_cloud(ball).remove_non_finite_points()
    heights = points.points[:, 2]
    rows = np.flatnonzero(heights <= np.quantile(heights, share))
    loom.write_point_cloud(tmp_path / "cap.ply", points.select_by_index(rows))
    report = json.loads(run("mesh", tmp_path / "cap.ply", tmp_path / "out.ply", "--depth", 5, "--json").stdout)
    assert report["density_quantile"] == quantile and report["watertight"] is (quantile == 0)


def test_an_open_scan_is_unreliable_until_trimmed_at_the_proposed_quantile(tmp_path):
    points = np.random.default_rng(2).normal(size=(4000, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    points[:, 2] = -np.abs(points[:, 2])
    loom.write_point_cloud(tmp_path / "bowl.ply", loom.PointCloud(points, normals=points))
    words = ["mesh", tmp_path / "bowl.ply", tmp_path / "out.ply", "--depth", 6, "--density-quantile"]
    report = unreliable(*words, 0.001)
    assert report["made_up"] > 0.1 and report["area"] > 1.1 * 2 * np.pi
    assert report["far"] == pytest.approx(3 * 2 * np.sqrt(10 / 4000 / 2), rel=0.1)  # 10 of them lie in a cap of a 400th
    better = "; ".join(report["warnings"]).split("use density_quantile ")[1].split(";")[0]
    trimmed = answer(*words, better, "--force")
    assert trimmed["made_up"] <= 0.05 and 2 * np.pi < trimmed["area"] < report["area"]
    printed = run(*words, better, "--force").stdout
    assert ("extrapolated" in printed) == (trimmed["made_up"] > 0)


def test_normals_of_the_input_are_used_and_disagreement_is_reported(ball, tmp_path):
    cloud = loom.read_point_cloud(ball).remove_non_finite_points()
    cloud.normals = cloud.points * np.where(np.arange(3000) % 3 == 0, -1, 1)[:, None]
    loom.write_point_cloud(tmp_path / "mixed.ply", cloud)
    words = ["mesh", tmp_path / "mixed.ply", tmp_path / "out.ply", "--depth", 4]
    report = unreliable(*words)
    assert report["normals"] == "of the input" and 0.3 < report["disagreement"] < 0.6
    assert "point to opposite sides; use new_normals" in str(report["warnings"])
    report = answer(*words, "--new-normals", "--force")
    assert report["normals"] == "made of the 30 nearest points of each and oriented" and report["disagreement"] == 0


def test_stl_omits_normals_and_colors_and_reports_it(ball, tmp_path):
    result = run("mesh", ball, tmp_path / "out.stl", "--depth", 4)
    assert result.exit_code == 0, result.stderr
    for words in ("poisson, depth 4, density quantile 0.0", "3,000, 1 non-finite ignored", "normals, colors (the"):
        assert words in result.stdout
    assert "not carried  intensity of the points" in result.stdout
    assert len(loom.read_triangle_mesh(tmp_path / "out.stl")) > 100


def test_a_cloud_far_from_the_origin_keeps_its_position(ball, tmp_path):
    far = np.array([691_000.25, 5_335_000.5, 519.75])
    cloud = loom.read_point_cloud(ball).remove_non_finite_points().translate(far)
    loom.write_point_cloud(tmp_path / "far.ply", cloud)
    answer("mesh", tmp_path / "far.ply", tmp_path / "out.ply", "--depth", 5)
    off = np.linalg.norm(loom.read_triangle_mesh(tmp_path / "out.ply").vertices - far, axis=1) - 1
    assert np.abs(off).max() < 0.05


def replace_method(monkeypatch, method, mesh):
    """Replace a surface method by one that returns `mesh`; return the list of its calls."""
    calls = []

    def make(cloud, *arguments, **named):
        calls.append((cloud, arguments, named))
        return (mesh, np.ones(len(mesh.vertices), np.float32)) if method == "poisson" else mesh

    name = {"ball": "ball_pivoting", "alpha": "alpha_shape"}.get(method, method)
    monkeypatch.setattr(TriangleMesh, f"create_from_point_cloud_{name}", staticmethod(make))
    return calls


def test_radii_and_alpha_are_passed_to_the_library(ball, tmp_path, monkeypatch):
    sphere = TriangleMesh.create_sphere()
    balls, alphas = replace_method(monkeypatch, "ball", sphere), replace_method(monkeypatch, "alpha", sphere)
    report = answer("mesh", ball, tmp_path / "a.ply", "--method", "ball", "--radii", "0.1,0.2")
    assert report["radii"] == [0.1, 0.2]
    assert answer("mesh", ball, tmp_path / "b.ply", "--method", "ball")["radii"] is None
    assert [arguments for _, arguments, _ in balls] == [([0.1, 0.2],), (None,)]
    assert all(cloud.has_normals for cloud, _, _ in balls)
    assert answer("mesh", ball, tmp_path / "c.ply", "--method", "alpha", "--alpha", "0.3")["alpha"] == 0.3
    report = answer("mesh", ball, tmp_path / "d.ply", "--method", "alpha")
    assert (report["alpha"], report["normals"], report["disagreement"]) == ("auto", "not needed", None)
    assert [arguments for _, arguments, _ in alphas] == [(0.3,), ("auto",)]
    assert not any(cloud.has_normals for cloud, _, _ in alphas)
    printed = run("mesh", ball, tmp_path / "a.ply", "--method", "ball", "--force").stdout
    assert "ball, radii derived from the point spacing" in printed


@pytest.mark.parametrize("method", ["poisson", "ball", "alpha"])
def test_an_empty_surface_is_unreliable_and_nothing_is_written(ball, tmp_path, monkeypatch, method):
    replace_method(monkeypatch, method, TriangleMesh())
    report = unreliable("mesh", ball, tmp_path / "out.ply", "--method", method, "--picture", tmp_path / "out.png")
    assert report["warnings"][0].startswith("the mesh is empty")
    assert report["files"] == [] and names_in(tmp_path) == ["ball.ply"]
    loom.write_point_cloud(ball, loom.PointCloud(np.full((4, 3), np.nan)))
    report = unreliable("mesh", ball, tmp_path / "out.ply", "--method", method)
    assert report["warnings"] == ["no point is finite, so there is no surface"]


def test_a_surface_with_holes_is_unreliable_and_written(ball, tmp_path, monkeypatch):
    mesh = grid()
    replace_method(monkeypatch, "ball", mesh.remove_triangles_by_mask(np.arange(len(mesh)) % 5 == 0))
    report = unreliable("mesh", ball, tmp_path / "out.ply", "--method", "ball")
    assert "the mesh has many holes: " in str(report["warnings"]) and "use larger radii" in str(report["warnings"])
    assert report["files"] == [str(tmp_path / "out.ply")]


def test_surface_statistics_describe_edges_and_parts():
    sheet = describe_surface(grid())
    assert (sheet.edges, sheet.boundary_edges, sheet.crowded_edges) == (385, 44, 0)
    assert (sheet.area, sheet.parts, sheet.largest_share, sheet.watertight) == (121.0, 1, 1.0, False)
    assert sheet.bounds == ((0.0, 0.0, 0.0), (11.0, 11.0, 0.0))
    fan = TriangleMesh([[0, 0, 0], [0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, 0, 0]], [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
    assert describe_surface(fan).crowded_edges == 1 and describe_surface(closed()).watertight
    nothing = describe_surface(TriangleMesh())
    assert (nothing.triangles, nothing.largest_share, nothing.bounds) == (0, 0.0, None)


LIMITS = {"triangles": 900, "edges": 1000, "boundary_edges": 100, "crowded_edges": 10, "islands_share": 0.1, "parts": 3}
NEEDLESS = NormalsUsed("not needed", given=False, disagreement=None)


def warnings_of(method, made_up=0.05, **figures):
    """Warnings for a surface at all limits, except for some figures."""
    summary = dataclasses.replace(describe_surface(TriangleMesh()), **LIMITS | figures)
    extrapolated = MadeUp(made_up, far=0.2, better_quantile=0.1)
    result = SurfaceResult(TriangleMesh(), method, {}, NEEDLESS, 5, 5, (), summary, extrapolated)
    return result.warnings


def test_a_surface_is_unreliable_beyond_a_limit_and_not_at_it():
    for figures, word in (
        ({"boundary_edges": 101}, "10.1% of its edges are boundary edges"),
        ({"crowded_edges": 11}, "1.1% of its edges have three or more triangles"),
        ({"islands_share": 0.11}, "11.0% of the area is in small islands"),
        ({"made_up": 0.051}, "5.1% of the area is farther than 0.2 m from all points"),
    ):
        for method, remedy in (("poisson", "density_quantile"), ("ball", "radii")):
            assert not warnings_of(method)
            warnings = str(warnings_of(method, **figures))
            remedies = remedy, "three or more triangles", "density_quantile 0.1"
            assert word in warnings and any(words in warnings for words in remedies)


def test_an_alpha_shape_may_have_non_manifold_edges_and_walls_between_its_two_sides():
    assert not warnings_of("alpha", crowded_edges=900, islands_share=0.9)
    warnings = str(warnings_of("alpha", islands_share=0.91))
    assert "91.0% of the area is in small islands" in warnings and "a larger alpha" in warnings


def test_a_surface_far_from_half_of_its_points_is_unreliable():
    rng = np.random.default_rng(0)
    near = rng.uniform(-1, 1, (800, 3)) * [1, 1, 0]
    sheet = TriangleMesh([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    for far, is_unreliable in ((300, False), (900, True)):
        points = np.vstack([near, rng.uniform(-1, 1, (far, 3)) * [1, 1, 0.1] + [0, 0, 0.5]])
        off, _ = _find_fit(loom.PointCloud(points), sheet)
        assert off.median is not None and (off.problem is not None) == is_unreliable
    assert off.median == pytest.approx(0.4, abs=0.1) and "half of the points are farther than 0.4" in str(off.problem)
    assert PointsOff().problem is None  # a missing surface is reported elsewhere


def test_an_alpha_shape_that_closes_a_cavity_is_unreliable():
    x, y = np.random.default_rng(1).uniform(-1, 1, (2, 1500))
    bowl = loom.PointCloud(np.column_stack([x, y, 0.2 * (x * x + y * y)]))  # a few spacings deep
    spanned, followed = (loom.create_surface(bowl, "alpha", alpha=alpha) for alpha in (10.0, 0.1))
    assert "was extrapolated to close the surface; use a smaller alpha" in str(spanned.warnings)
    assert "extrapolated" not in str(followed.warnings)


def test_normals_are_unreliable_if_more_than_ten_percent_disagree_and_only_a_room_looks_inwards():
    normals = NormalsUsed("made of the 30 nearest points", given=False, disagreement=0.1)
    assert normals.problem is None
    assert "though they were oriented" in str(dataclasses.replace(normals, disagreement=0.2).problem)
    assert looks_inwards(closed(inwards=True)) and not looks_inwards(closed()) and not looks_inwards(grid())


def test_outputs_are_checked_before_the_input_is_read(tmp_path):
    missing = tmp_path / "missing.ply"
    assert "meshes are not written to .pcd" in refusal("mesh", missing, tmp_path / "out.pcd")
    assert "expected .png or .webp" in refusal("mesh", missing, tmp_path / "out.ply", "--picture", "out.jpg")
    (tmp_path / "out.png").write_bytes(b"kept")
    message = refusal("mesh", missing, tmp_path / "out.ply", "--picture", tmp_path / "out.png")
    assert "out.png: exists already" in message and "missing.ply" in refusal("mesh", missing, tmp_path / "out.ply")
