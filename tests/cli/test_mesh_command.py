"""mesh, clean-mesh, simplify, smooth-mesh, sample-mesh, compare-meshes: results and unreliable results."""

import dataclasses
import json

import click
import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom import TriangleMesh
from pointloom.cli.shell.cli import cli
from pointloom.cli.shell.command_words import in_options
from pointloom.io.images.image_files import read_color
from pointloom.meshing.mesh.cloud_surface import _find_fit
from pointloom.meshing.mesh.mesh_summary import describe_surface
from pointloom.meshing.mesh.surface_result import (
    MAX_STRAY_AREA,
    STRAY_WEIGHTS,
    MadeUp,
    NormalsUsed,
    PointsOff,
    Support,
    SurfaceResult,
)
from pointloom.visualization.render.surface_picture import looks_inwards

from .commands import answer, names_in, output_of, refusal, run, unreliable


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
    words = ["--depth", 5, "--density-quantile", 0.01, "--picture", tmp_path / "out.png", "--device", device]
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


@pytest.mark.parametrize(("fraction", "quantile"), [(1.0, 0.0), (0.5, 0.01)])
def test_only_extrapolated_surfaces_are_trimmed(ball, tmp_path, fraction, quantile):
    points = loom.read_point_cloud(ball).remove_non_finite_points()
    heights = points.points[:, 2]
    rows = np.flatnonzero(heights <= np.quantile(heights, fraction))
    loom.write_point_cloud(tmp_path / "cap.ply", points.select_by_index(rows))
    report = json.loads(run("mesh", tmp_path / "cap.ply", tmp_path / "out.ply", "--depth", 5, "--json").stdout)
    assert report["density_quantile"] == quantile and report["watertight"] is (quantile == 0)


@pytest.mark.slow
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
    assert f"use --density-quantile {better}" in run(*words, 0.001, "--force").stderr  # as an option of the command
    trimmed = answer(*words, better, "--force")
    assert trimmed["made_up"] <= 0.05 and 2 * np.pi < trimmed["area"] < report["area"]
    assert ("extrapolated" in run(*words, better, "--force").stdout) == (trimmed["made_up"] > 0)


@pytest.mark.parametrize(
    ("text", "printed"),
    [
        ("use density_quantile 0.1", "use --density-quantile 0.1"),
        ("pass depth=9 (density_quantile).", "pass --depth 9 (--density-quantile)."),
        ("pass depth_scale=5000, or overwrite=True", "pass --depth-scale 5000 of pointloom track, or --force"),
        ("pass new_normals=True", "pass --new-normals"),
        ("/data/density_quantile.ply: is empty", "/data/density_quantile.ply: is empty"),
        ("density_quantile.ply and density_quantile/a.ply", "density_quantile.ply and density_quantile/a.ply"),
    ],
)
def test_messages_name_options_of_the_command_but_files_keep_their_names(text, printed):
    with click.Context(cli.commands["mesh"]):
        assert in_options(text) == printed


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
    shown = output_of("mesh", ball, tmp_path / "out.stl", "--depth", 4)
    for words in ("poisson, depth 4, density quantile 0.0", "3,000, 1 non-finite ignored", "normals, colors (the"):
        assert words in shown
    assert "not carried  intensity of the points" in shown
    assert len(loom.read_triangle_mesh(tmp_path / "out.stl")) > 100


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
    assert (sheet.area, sheet.parts, sheet.largest_fraction, sheet.watertight) == (121.0, 1, 1.0, False)
    assert sheet.bounds == ((0.0, 0.0, 0.0), (11.0, 11.0, 0.0))
    fan = TriangleMesh([[0, 0, 0], [0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, 0, 0]], [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
    assert describe_surface(fan).crowded_edges == 1 and describe_surface(closed()).watertight
    nothing = describe_surface(TriangleMesh())
    assert (nothing.triangles, nothing.largest_fraction, nothing.bounds) == (0, 0.0, None)


LIMITS = {
    "triangles": 900,
    "edges": 1000,
    "boundary_edges": 100,
    "crowded_edges": 10,
    "islands_fraction": 0.1,
    "parts": 3,
}
NEEDLESS = NormalsUsed("not needed", given=False, disagreement=None)


def warnings_of(method, made_up=0.05, **figures):
    """Warnings for a surface at all limits, except for some figures."""
    summary = dataclasses.replace(describe_surface(TriangleMesh()), **LIMITS | figures)
    extrapolated = MadeUp(made_up, far=0.2, better_quantile=0.1)
    return SurfaceResult(TriangleMesh(), method, {}, NEEDLESS, 5, 5, (), summary, extrapolated).warnings


def test_a_surface_is_unreliable_beyond_a_limit_and_not_at_it():
    for figures, word in (
        ({"boundary_edges": 101}, "10.1% of its edges are boundary edges"),
        ({"crowded_edges": 11}, "1.1% of its edges have three or more triangles"),
        ({"islands_fraction": 0.11}, "11.0% of the area is in small islands"),
        ({"made_up": 0.051}, "5.1% of the area is farther than 0.2 m from all points"),
    ):
        for method, remedy in (("poisson", "density_quantile"), ("ball", "radii")):
            assert not warnings_of(method)
            warnings = str(warnings_of(method, **figures))
            remedies = remedy, "three or more triangles", "density_quantile 0.1"
            assert word in warnings and any(words in warnings for words in remedies)


def test_an_alpha_shape_may_have_non_manifold_edges_and_walls_between_its_two_sides():
    assert not warnings_of("alpha", crowded_edges=900, islands_fraction=1.0)


@pytest.mark.parametrize("method", ["poisson", "ball"])
def test_a_surface_far_from_half_of_its_points_is_unreliable(method):
    rng = np.random.default_rng(0)
    near = rng.uniform(-1, 1, (800, 3)) * [1, 1, 0]
    sheet = TriangleMesh([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    for far, is_unreliable in ((30 if method == "poisson" else 300, False), (900, True)):
        points = np.vstack([near, rng.uniform(-1, 1, (far, 3)) * [1, 1, 0.1] + [0, 0, 0.5]])
        off, _ = _find_fit(loom.PointCloud(points), sheet, method)
        assert off.median is not None and (off.problem(method) is not None) == is_unreliable
    assert off.median == pytest.approx(0.4, abs=0.1)
    part = (
        "a tenth of the points are farther than 0.5"
        if method == "poisson"
        else "half of the points are farther than 0.4"
    )
    assert part in str(off.problem(method))
    assert PointsOff().problem(method) is None  # a missing surface is reported elsewhere


@pytest.mark.parametrize("angle", [0.0, 0.7, 1.5])
def test_a_part_without_a_poisson_surface_counts_by_area_and_outliers_do_not(angle):
    """A sparse part of 2 % of the points and 23 % of the area, along the sheet or inclined to it."""
    rng = np.random.default_rng(0)
    sheet = TriangleMesh([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    x, y = rng.uniform(-1, 1, (2, 3000))
    points = np.column_stack([x, y, 0 * x])
    part = np.column_stack([1.4 + np.cos(angle) * 0.3 * x[:60], y[:60], np.sin(angle) * (0.5 + 0.3 * x[:60])])
    outliers = rng.uniform(-1, 1, (60, 3)) * [1, 1, 0.5] + [0, 0, 0.8]
    for noise in (0, 0.01, 0.028):
        noisy = points + rng.normal(0, [0, 0, noise], points.shape)
        for extra, is_lost in ((part, True), (outliers, False), (part[:0], False)):
            _, support = _find_fit(loom.PointCloud(np.vstack([noisy, extra])), sheet, "poisson")
            assert (support.lost > 0.1) == is_lost == (support.problem("poisson", None, None) is not None)
            assert support.missed < 0.06 and (is_lost or support.lost < 0.02)


@pytest.mark.parametrize("count", [60, 120, 250, 500])
def test_few_points_on_a_poisson_surface_are_not_lost(count):
    """The mean of ten neighbors is inside a curved surface."""
    ball = TriangleMesh.create_sphere(1.0, 60)
    _, support = _find_fit(ball.sample_points_poisson_disk(count, seed=1), ball, "poisson")
    assert support.lost == support.missed == 0


@pytest.mark.parametrize("scale", [1e-3, 1e4])
@pytest.mark.parametrize("shape", [TriangleMesh.create_sphere, TriangleMesh.create_box], ids=["sphere", "box"])
def test_a_poisson_surface_that_follows_the_noise_is_rough(shape, scale):
    """Bumps below the distance that is near: no other check sees them."""
    smooth = shape().subdivide_midpoint(2 if shape == TriangleMesh.create_sphere else 5).scale(scale, (0, 0, 0))
    points = smooth.sample_points_uniformly(4000, seed=1)
    size = np.linalg.norm(np.ptp(smooth.vertices, axis=0))
    bumps = np.random.default_rng(2).uniform(-0.015, 0.015, smooth.vertices.shape) * size
    bumpy = TriangleMesh(smooth.vertices + bumps, smooth.triangles)
    for mesh, is_rough in ((smooth, False), (bumpy, True)):
        _, support = _find_fit(points, mesh, "poisson")
        assert (support.rough > 0.3 if is_rough else support.rough < 0.1) and support.stray("poisson") < MAX_STRAY_AREA
        assert ("follows the noise" in str(support.problem("poisson", None, None))) == is_rough
    few = points.select_by_index(range(1999))
    assert _find_fit(few, bumpy, "poisson")[1].rough == 0


def test_points_far_from_an_alpha_shape_count_by_area_unless_they_are_noise():
    rng = np.random.default_rng(0)
    sheet = TriangleMesh([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    x, y = rng.uniform(-1, 1, (2, 3000))
    beyond = np.column_stack([1.4 + 0.3 * x[:60], y[:60], 0 * x[:60]])  # 2 % of the points, 23 % of the area
    stray = np.column_stack([x[:3], y[:3], [1, 2, 3]])
    for extra, noise, missed in ((beyond, 0, 0.1), (stray, 0, 0), (beyond[:0], 0.028, 0)):
        points = np.vstack([np.column_stack([x, y, rng.normal(0, noise, 3000)]), extra])
        _, support = _find_fit(loom.PointCloud(points), sheet, "alpha")
        assert support.missed > missed if missed else support.missed < 0.05
        assert ("of the points are farther than" in str(support.problem("alpha", None, None))) == bool(missed)
    assert support.noise > 0.2 and (np.abs(points[:, 2]) > 0.05).mean() > 0.05


def test_noise_bends_and_gaps_of_an_alpha_shape_add_up():
    limit = Support(0.02, sparse=0.02, bent=0.04, turned=0.1, noise=0.18)
    assert limit.stray("alpha") == pytest.approx(MAX_STRAY_AREA)
    assert Support(0.02, sparse=0.079).problem("alpha", None, None) is None
    more = dataclasses.replace(limit, noise=0.2).problem("alpha", None, None)
    assert more is not None and more.startswith("2.0% of the area has no point within 0.02 m, and 4.0% is farther")


@pytest.mark.parametrize("name", STRAY_WEIGHTS["poisson"])
def test_borders_bends_and_lost_parts_of_a_poisson_surface_add_up(name):
    """Four quantities are each below the limit. The remedy is that of the largest one."""
    weights = STRAY_WEIGHTS["poisson"]
    limit = Support(0.02, **{other: 0.2 * MAX_STRAY_AREA / weights[other] for other in weights})
    assert limit.stray("poisson") == pytest.approx(0.8 * MAX_STRAY_AREA)
    assert limit.problem("poisson", None, None) is None
    more = dataclasses.replace(limit, **{name: 0.5 * MAX_STRAY_AREA / weights[name]})
    remedy = {"outer": "a larger density_quantile", "lost": "the orientation of the normals"}.get(name, "more points")
    assert more.largest_stray == name and remedy in str(more.problem("poisson", None, None))
    assert str(more.problem("poisson", None, 0.1)).endswith("use density_quantile 0.1")


def shape_of_size_one(shape):
    """A cloud of 6,000 points of a torus or an open sheet, and its normals."""
    if shape == "torus":
        mesh = TriangleMesh.create_torus(0.3, 0.1, 80, 50)
    else:
        mesh = TriangleMesh([[-0.5, -0.4, 0], [0.5, -0.4, 0], [0.5, 0.4, 0], [-0.5, 0.4, 0]], [[0, 1, 2], [0, 2, 3]])
    return mesh.sample_points_uniformly(6000, use_triangle_normal=True, seed=1)


@pytest.mark.parametrize(("noise", "is_reliable"), [(0.0, True), (0.02, True), (0.045, False)])
def test_a_poisson_surface_of_noisy_points_is_reliable_until_it_follows_the_noise(noise, is_reliable):
    cloud = shape_of_size_one("torus")
    noisy = cloud.points + np.random.default_rng(0).normal(0, noise, (6000, 3))
    result = loom.meshing.create_surface(loom.PointCloud(noisy, normals=cloud.normals), "poisson", depth=6)
    assert result.reliable == is_reliable
    assert is_reliable or "a tenth of the points are farther than" in str(result.warnings)


def test_a_poisson_surface_that_continues_beyond_its_points_is_unreliable():
    sheet = shape_of_size_one("sheet")
    result = loom.meshing.create_surface(sheet.select_by_index(range(500)), "poisson", depth=6)
    assert result.support.outer > 0.2 and "use density_quantile" in str(result.warnings)
    narrow = str(Support(0.02, outer=0.081).problem("poisson", None, 0.1))
    assert narrow.startswith("8.1% of the area continues beyond") and narrow.endswith("use density_quantile 0.1")
    assert Support(0.02, outer=0.079).problem("poisson", None, None) is None
    assert loom.meshing.create_surface(sheet, "ball").support.outer < 0.01


def test_an_alpha_shape_that_closes_a_cavity_is_unreliable():
    x, y = np.random.default_rng(1).uniform(-1, 1, (2, 1500))
    bowl = loom.PointCloud(np.column_stack([x, y, 0.2 * (x * x + y * y)]))  # a few spacings deep
    spanned, followed = (loom.meshing.create_surface(bowl, "alpha", alpha=alpha) for alpha in (10.0, 0.1))
    assert "of the area has no point within" in str(spanned.warnings)
    assert "of the area" not in str(followed.warnings)


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


def write(path, mesh: TriangleMesh):
    loom.write_triangle_mesh(path, mesh)
    return path


@pytest.fixture
def sphere(tmp_path):
    """A file of a sphere of 1,520 triangles."""
    return write(tmp_path / "ball.ply", TriangleMesh.create_sphere(1.0, 20))


@pytest.fixture
def torn(tmp_path):
    """A sphere without a cap, with some flipped and duplicate triangles and a separate triangle."""
    ball = TriangleMesh.create_sphere(1.0, 20)
    remaining = ball.triangles[ball.vertices[ball.triangles].mean(axis=1)[:, 2] < 0.97]
    triangles = remaining.copy()
    triangles[::5] = triangles[::5, ::-1]
    corners = len(ball.vertices) + np.arange(3)
    vertices = np.vstack([ball.vertices, [[3, 0, 0], [3.1, 0, 0], [3, 0.1, 0]]])
    return write(tmp_path / "torn.ply", TriangleMesh(vertices, np.vstack([triangles, remaining[1:5], corners[None]])))


def test_a_mesh_is_repaired_as_by_the_library(torn, tmp_path, device):
    options = ("--fill", 0.5, "--min-triangles", 2, "--device", device)
    report = answer("clean-mesh", torn, tmp_path / "out.ply", *options)
    repaired, done = loom.read_triangle_mesh(torn, device=device).repair(hole_size=0.5)
    expected = repaired.remove_small_components(min_triangles=2)
    written = loom.read_triangle_mesh(tmp_path / "out.ply")
    np.testing.assert_array_equal(written.vertices, expected.vertices)
    np.testing.assert_array_equal(written.triangles, expected.triangles)
    assert report["filled_holes"] == done.filled_holes == 1 and report["removed_duplicated_triangles"] == 4
    assert (report["removed_parts"], report["parts"]) == (1, 1)
    assert report["is_watertight"] and report["boundary_edges"] == 0 and report["self_intersections"] == 0
    assert report["reliable"] and report["triangles"] == len(expected)


def test_a_mesh_without_defects_is_unchanged(sphere, tmp_path):
    result = run("clean-mesh", sphere, tmp_path / "out.ply")
    assert result.exit_code == 0 and "nothing to repair" in result.stdout and "no defects" in result.stdout
    assert (tmp_path / "out.ply").read_bytes() == sphere.read_bytes()


def test_a_mesh_that_lost_part_of_its_surface_or_is_not_orientable_is_unreliable(sphere, tmp_path):
    report = unreliable("clean-mesh", sphere, tmp_path / "merged.ply", "--merge", 0.9)
    assert "merge_distance below 0.9 m" in str(report["warnings"])
    box = TriangleMesh.create_box()
    fin = TriangleMesh(np.vstack([box.vertices, [[5, 5, 5]]]), np.vstack([box.triangles, [[*box.triangles[0][:2], 8]]]))
    report = unreliable("clean-mesh", write(tmp_path / "fin.ply", fin), tmp_path / "out.ply")
    assert "of the area was lost" in str(report["warnings"]) and report["is_watertight"] and report["lost_area"] > 1
    strip = write(tmp_path / "strip.ply", TriangleMesh.create_mobius())
    assert "is not orientable" in str(unreliable("clean-mesh", strip, tmp_path / "flat.ply")["warnings"])


def test_an_empty_result_is_not_written(sphere, tmp_path):
    report = unreliable("clean-mesh", sphere, tmp_path / "out.ply", "--min-triangles", 100_000)
    assert "no triangles remain" in str(report["warnings"]) and report["files"] == []
    assert names_in(tmp_path) == ["ball.ply"]


@pytest.mark.parametrize(("option", "target"), [("--triangles 300", 300), ("--ratio 0.25", 380), ("--voxel 0.1", None)])
def test_a_mesh_is_simplified_to_its_target(sphere, tmp_path, device, option, target):
    report = answer("simplify", sphere, tmp_path / "out.ply", *option.split(), "--device", device)
    mesh = loom.read_triangle_mesh(sphere, device=device)
    expected = mesh.simplify_quadric_decimation(target) if target else mesh.simplify_vertex_clustering(0.1, "quadric")
    np.testing.assert_array_equal(loom.read_triangle_mesh(tmp_path / "out.ply").triangles, expected.triangles)
    assert (report["target"], report["triangles"]) == (target, len(expected))
    assert 0 < report["errors"]["rms"] <= report["errors"]["max"] and (target is None or report["errors"]["max"] < 0.03)


def test_a_mesh_is_smoothed_as_by_the_library(sphere, tmp_path):
    for method, options, make in (
        ("taubin", ["--mu", -0.6], lambda mesh: mesh.filter_smooth_taubin(3, 0.5, -0.6)),
        ("laplacian", ["--lambda", 0.3], lambda mesh: mesh.filter_smooth_laplacian(3, 0.3)),
        ("simple", [], lambda mesh: mesh.filter_smooth_simple(3)),
        ("sharpen", ["--strength", 0.1], lambda mesh: mesh.filter_sharpen(3, 0.1)),
    ):
        words = ["--method", method, "--iterations", 3, *options, "--force"]
        report = answer("smooth-mesh", sphere, tmp_path / "out.ply", *words)
        expected = make(loom.read_triangle_mesh(sphere))
        np.testing.assert_array_equal(loom.read_triangle_mesh(tmp_path / "out.ply").vertices, expected.vertices)
        assert report["area"] == expected.get_surface_area() and report["moved"]["max"] > 0


@pytest.mark.parametrize("even", [False, True])
def test_points_are_sampled_as_by_the_library(sphere, tmp_path, even):
    options = ["--even"] if even else []
    report = answer("sample-mesh", sphere, tmp_path / "out.ply", "--points", 400, "--seed", 3, *options)
    mesh = loom.read_triangle_mesh(sphere)
    draw = mesh.sample_points_poisson_disk if even else mesh.sample_points_uniformly
    np.testing.assert_array_equal(loom.read_point_cloud(tmp_path / "out.ply").points, draw(400, seed=3).points)
    assert (report["points"], report["even"], report["seed"]) == (400, even, 3)


@pytest.fixture
def larger(tmp_path):
    """The sphere, 1% larger."""
    return write(tmp_path / "larger.ply", TriangleMesh.create_sphere(1.01, 20))


def test_two_meshes_are_compared_as_by_the_library(sphere, larger, tmp_path, device):
    words = (sphere, larger, "--threshold", "0.005,0.02", "--samples", 5000, "--device", device)
    report = answer("compare-meshes", *words)
    meshes = [loom.read_triangle_mesh(path, device=device) for path in (sphere, larger)]
    expected = meshes[0].compute_metrics(meshes[1], [0.005, 0.02], 5000)
    assert (report["chamfer"], report["hausdorff"]) == (expected.chamfer, expected.hausdorff)
    assert report["fscore"] == {"0.005": expected.fscore[0], "0.02": expected.fscore[1]}
    assert 0.009 < report["hausdorff"] <= report["hausdorff_bound"] < 0.012
    report = answer("compare-meshes", sphere, larger, "--error-map", tmp_path / "map.ply")
    colored, _ = loom.read_triangle_mesh(sphere).compute_error_map(loom.read_triangle_mesh(larger))
    written = loom.read_triangle_mesh(tmp_path / "map.ply")
    assert written.vertex_colors is not None and colored.vertex_colors is not None
    np.testing.assert_allclose(written.vertex_colors, colored.vertex_colors, atol=1 / 510 + 1e-6)  # 8 bits
    assert report["files"] == [str(tmp_path / "map.ply")]


@pytest.mark.slow
def test_a_picture_shows_the_distances_and_their_histogram(sphere, larger, tmp_path, device):
    words = ("--picture", tmp_path / "map.png", "--samples", 1000, "--device", device)
    report = answer("compare-meshes", sphere, larger, *words)
    assert report["files"] == [str(tmp_path / "map.png")] and report["seconds"]["picture"] > 0
    picture = read_color(tmp_path / "map.png").astype(int)
    assert picture.shape == (900, 1600, 3)
    mesh, bars = picture[:, :860], picture[:, 1000:]
    assert (np.ptp(mesh, axis=2) > 40).mean() > 0.3  # the ball in colors, on a gray ground
    assert (np.ptp(bars, axis=2) > 40).sum() > 1000 and (bars[:, -3:] == 255).all()


def test_an_unwritable_picture_is_rejected_before_the_inputs_are_read(sphere, tmp_path):
    missing = tmp_path / "none.ply"  # would be an error too, but later
    assert "expected .png or .webp" in refusal("compare-meshes", missing, sphere, "--picture", tmp_path / "map.jpg")
    (tmp_path / "mine.png").write_text("mine")
    both = ("--picture", tmp_path / "mine.png", "--error-map", tmp_path / "map.ply")
    assert "--force" in refusal("compare-meshes", sphere, sphere, *both)
    assert (tmp_path / "mine.png").read_text() == "mine" and not (tmp_path / "map.ply").exists()
    report = answer("compare-meshes", sphere, sphere, *both, "--force")
    assert report["files"] == [str(tmp_path / "map.ply"), str(tmp_path / "mine.png")]


@pytest.mark.slow
def test_surfaces_beyond_max_distance_or_in_different_units_are_unreliable(sphere, larger, tmp_path):
    assert "more than 0.001 m" in str(unreliable("compare-meshes", sphere, larger, "--max-distance", 0.001)["warnings"])
    assert answer("compare-meshes", sphere, larger, "--max-distance", 0.1)["reliable"]
    other = write(tmp_path / "mm.ply", TriangleMesh.create_sphere(1000.0, 20))
    assert "Check units" in str(unreliable("compare-meshes", sphere, other)["warnings"])


@pytest.mark.parametrize("words", ["clean-mesh", "simplify --ratio 0.5", "smooth-mesh", "sample-mesh --points 5"])
def test_files_without_triangles_are_named(tmp_path, words):
    (tmp_path / "broken.ply").write_bytes(b"ply\nformat ascii 1.0\nelement vertex 3\n")
    loom.write_point_cloud(tmp_path / "cloud.ply", loom.PointCloud([[0, 0, 0]]))
    for name in ("broken.ply", "cloud.ply", "missing.ply"):
        command, *more = words.split()
        assert name in refusal(command, tmp_path / name, tmp_path / "out.ply", *more)
    assert names_in(tmp_path) == ["broken.ply", "cloud.ply"]


def test_a_surface_that_moved_far_shrank_or_has_no_area_is_unreliable(sphere, tmp_path):
    flat = write(tmp_path / "flat.ply", TriangleMesh([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]]))
    report = unreliable("sample-mesh", flat, tmp_path / "out.ply", "--points", 10)
    assert "no area" in str(report["warnings"]) and names_in(tmp_path) == ["ball.ply", "flat.ply"]
    report = unreliable("simplify", sphere, tmp_path / "out.ply", "--triangles", 8)
    assert "the surface moved by" in str(report["warnings"])
    report = unreliable("smooth-mesh", sphere, tmp_path / "small.ply", "--method", "simple", "--iterations", 50)
    assert "of the area was lost" in str(report["warnings"]) and "method='taubin'" in str(report["warnings"])
