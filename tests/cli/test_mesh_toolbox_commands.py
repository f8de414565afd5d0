"""clean-mesh, simplify, smooth-mesh, sample-mesh, compare-meshes: results and unreliable results."""

import numpy as np
import pytest

import pointloom as loom
from pointloom import TriangleMesh
from pointloom.io.pictures.image_files import read_color

from .commands import answer, names_in, refusal, run, unreliable


def write(path, mesh: TriangleMesh):
    loom.write_triangle_mesh(path, mesh)
    return path


@pytest.fixture
def ball(tmp_path):
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


def test_a_mesh_without_defects_is_unchanged(ball, tmp_path):
    result = run("clean-mesh", ball, tmp_path / "out.ply")
    assert result.exit_code == 0 and "nothing to repair" in result.stdout and "no defects" in result.stdout
    assert (tmp_path / "out.ply").read_bytes() == ball.read_bytes()


def test_a_mesh_that_lost_part_of_its_surface_or_is_not_orientable_is_unreliable(ball, tmp_path):
    report = unreliable("clean-mesh", ball, tmp_path / "merged.ply", "--merge", 0.9)
    assert "merge_distance below 0.9 m" in str(report["warnings"])
    box = TriangleMesh.create_box()
    fin = TriangleMesh(np.vstack([box.vertices, [[5, 5, 5]]]), np.vstack([box.triangles, [[*box.triangles[0][:2], 8]]]))
    report = unreliable("clean-mesh", write(tmp_path / "fin.ply", fin), tmp_path / "out.ply")
    assert "of the area was lost" in str(report["warnings"]) and report["is_watertight"] and report["lost_area"] > 1
    strip = write(tmp_path / "strip.ply", TriangleMesh.create_moebius())
    assert "is not orientable" in str(unreliable("clean-mesh", strip, tmp_path / "flat.ply")["warnings"])


def test_an_empty_result_is_not_written(ball, tmp_path):
    report = unreliable("clean-mesh", ball, tmp_path / "out.ply", "--min-triangles", 100_000)
    assert "no triangles remain" in str(report["warnings"]) and report["files"] == []
    assert names_in(tmp_path) == ["ball.ply"]


@pytest.mark.parametrize(("option", "target"), [("--triangles 300", 300), ("--ratio 0.25", 380), ("--voxel 0.1", None)])
def test_a_mesh_is_simplified_to_its_target(ball, tmp_path, device, option, target):
    report = answer("simplify", ball, tmp_path / "out.ply", *option.split(), "--device", device)
    mesh = loom.read_triangle_mesh(ball, device=device)
    expected = mesh.simplify_quadric_decimation(target) if target else mesh.simplify_vertex_clustering(0.1, "quadric")
    written = loom.read_triangle_mesh(tmp_path / "out.ply")
    np.testing.assert_array_equal(written.triangles, expected.triangles)
    assert (report["target"], report["triangles"]) == (target, len(expected))
    assert 0 < report["errors"]["rms"] <= report["errors"]["max"] and (target is None or report["errors"]["max"] < 0.03)


def test_a_surface_that_moved_far_is_unreliable(ball, tmp_path):
    report = unreliable("simplify", ball, tmp_path / "out.ply", "--triangles", 8)
    assert "the surface moved by" in str(report["warnings"])


def test_a_mesh_is_smoothed_as_by_the_library(ball, tmp_path):
    for method, options, make in (
        ("taubin", ["--mu", -0.6], lambda mesh: mesh.filter_smooth_taubin(3, 0.5, -0.6)),
        ("laplacian", ["--lambda", 0.3], lambda mesh: mesh.filter_smooth_laplacian(3, 0.3)),
        ("simple", [], lambda mesh: mesh.filter_smooth_simple(3)),
        ("sharpen", ["--strength", 0.1], lambda mesh: mesh.filter_sharpen(3, 0.1)),
    ):
        words = ["--method", method, "--iterations", 3, *options, "--force"]
        report = answer("smooth-mesh", ball, tmp_path / "out.ply", *words)
        expected = make(loom.read_triangle_mesh(ball))
        np.testing.assert_array_equal(loom.read_triangle_mesh(tmp_path / "out.ply").vertices, expected.vertices)
        assert report["area"] == expected.get_surface_area() and report["moved"]["max"] > 0


def test_a_mesh_that_shrank_is_unreliable(ball, tmp_path):
    report = unreliable("smooth-mesh", ball, tmp_path / "out.ply", "--method", "simple", "--iterations", 50)
    assert "of the area was lost" in str(report["warnings"]) and "method='taubin'" in str(report["warnings"])


@pytest.mark.parametrize("even", [False, True])
def test_points_are_sampled_as_by_the_library(ball, tmp_path, even):
    options = ["--even"] if even else []
    report = answer("sample-mesh", ball, tmp_path / "out.ply", "--points", 400, "--seed", 3, *options)
    mesh = loom.read_triangle_mesh(ball)
    draw = mesh.sample_points_poisson_disk if even else mesh.sample_points_uniformly
    np.testing.assert_array_equal(loom.read_point_cloud(tmp_path / "out.ply").points, draw(400, seed=3).points)
    assert (report["points"], report["even"], report["seed"]) == (400, even, 3)


def test_a_mesh_without_area_gives_no_points(tmp_path):
    flat = write(tmp_path / "flat.ply", TriangleMesh([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]]))
    report = unreliable("sample-mesh", flat, tmp_path / "out.ply", "--points", 10)
    assert "no area" in str(report["warnings"]) and names_in(tmp_path) == ["flat.ply"]


@pytest.fixture
def larger(tmp_path):
    """The sphere, 1% larger."""
    return write(tmp_path / "larger.ply", TriangleMesh.create_sphere(1.01, 20))


def test_two_meshes_are_compared_as_by_the_library(ball, larger, tmp_path, device):
    words = (ball, larger, "--threshold", "0.005,0.02", "--samples", 5000, "--device", device)
    report = answer("compare-meshes", *words)
    meshes = [loom.read_triangle_mesh(path, device=device) for path in (ball, larger)]
    expected = meshes[0].compute_metrics(meshes[1], [0.005, 0.02], 5000)
    assert (report["chamfer"], report["hausdorff"]) == (expected.chamfer, expected.hausdorff)
    assert report["fscore"] == {"0.005": expected.fscore[0], "0.02": expected.fscore[1]}
    assert 0.009 < report["hausdorff"] <= report["hausdorff_bound"] < 0.012
    report = answer("compare-meshes", ball, larger, "--error-map", tmp_path / "map.ply")
    colored, _ = loom.read_triangle_mesh(ball).compute_error_map(loom.read_triangle_mesh(larger))
    written = loom.read_triangle_mesh(tmp_path / "map.ply")
    assert written.vertex_colors is not None and colored.vertex_colors is not None
    np.testing.assert_allclose(written.vertex_colors, colored.vertex_colors, atol=1 / 510 + 1e-6)  # 8 bits
    assert report["files"] == [str(tmp_path / "map.ply")]


def test_a_picture_shows_the_distances_and_their_histogram(ball, larger, tmp_path, device):
    words = ("--picture", tmp_path / "map.png", "--samples", 1000, "--device", device)
    report = answer("compare-meshes", ball, larger, *words)
    assert report["files"] == [str(tmp_path / "map.png")] and report["seconds"]["picture"] > 0
    picture = read_color(tmp_path / "map.png").astype(int)
    assert picture.shape == (900, 1600, 3)
    mesh, bars = picture[:, :860], picture[:, 1000:]
    assert (np.ptp(mesh, axis=2) > 40).mean() > 0.3  # the ball in colors, on a gray ground
    assert (np.ptp(bars, axis=2) > 40).sum() > 1000 and (bars[:, -3:] == 255).all()


def test_an_unwritable_picture_is_rejected_before_the_inputs_are_read(ball, tmp_path):
    missing = tmp_path / "none.ply"  # would be an error too, but later
    assert "expected .png or .webp" in refusal("compare-meshes", missing, ball, "--picture", tmp_path / "map.jpg")
    (tmp_path / "mine.png").write_text("mine")
    both = ("--picture", tmp_path / "mine.png", "--error-map", tmp_path / "map.ply")
    assert "--force" in refusal("compare-meshes", ball, ball, *both)
    assert (tmp_path / "mine.png").read_text() == "mine" and not (tmp_path / "map.ply").exists()
    report = answer("compare-meshes", ball, ball, *both, "--force")
    assert report["files"] == [str(tmp_path / "map.ply"), str(tmp_path / "mine.png")]


@pytest.mark.slow
def test_surfaces_beyond_max_distance_or_in_different_units_are_unreliable(ball, larger, tmp_path):
    assert "more than 0.001 m" in str(unreliable("compare-meshes", ball, larger, "--max-distance", 0.001)["warnings"])
    assert answer("compare-meshes", ball, larger, "--max-distance", 0.1)["reliable"]
    other = write(tmp_path / "mm.ply", TriangleMesh.create_sphere(1000.0, 20))
    assert "Check units" in str(unreliable("compare-meshes", ball, other)["warnings"])


@pytest.mark.parametrize("words", ["clean-mesh", "simplify --ratio 0.5", "smooth-mesh", "sample-mesh --points 5"])
def test_files_without_triangles_are_named(tmp_path, words):
    (tmp_path / "broken.ply").write_bytes(b"ply\nformat ascii 1.0\nelement vertex 3\n")
    loom.write_point_cloud(tmp_path / "cloud.ply", loom.PointCloud([[0, 0, 0]]))
    for name in ("broken.ply", "cloud.ply", "missing.ply"):
        command, *more = words.split()
        assert name in refusal(command, tmp_path / name, tmp_path / "out.ply", *more)
    assert names_in(tmp_path) == ["broken.ply", "cloud.ply"]
