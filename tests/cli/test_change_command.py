"""change: M3C2 and cloud-to-mesh distances, outputs, and unreliable results."""

import numpy as np
import pytest

import pointloom as loom

from .commands import answer, refusal, unreliable

UTM = np.array([447_000.0, 5_411_000.0, 300.0])


def survey(lift=0.0, pit=0.0, seed=0, count=6000):
    """A slope of 20 x 20 m with 1 cm of noise and a lowered corner of 6 x 6 m."""
    rng = np.random.default_rng(seed)
    x, y = rng.random((2, count)) * 20
    z = 0.2 * x + 0.01 * rng.normal(size=count) + lift - np.where((x < 6) & (y < 6), pit, 0)
    return loom.PointCloud(np.column_stack([x, y, z]) + UTM, intensity=np.arange(count, dtype=np.uint16))


@pytest.fixture
def files(tmp_path):
    clouds = {"before": survey(), "after": survey(pit=0.3, seed=1), "lifted": survey(lift=0.5, seed=2)}
    for name, cloud in clouds.items():
        loom.write_point_cloud(tmp_path / f"{name}.npz", cloud)
    return tmp_path


def test_two_clouds_are_compared_by_m3c2(files, device):
    sizes = {"normal_radii": [1, 2], "cylinder_radius": 0.8, "max_distance": 2, "registration_error": 0.005}
    words = ["--normals", "1,2", "--cylinder", 0.8, "--max-distance", 2, "--registration-error", 0.005]
    words += ["-o", files / "out.npz", "--device", device]
    report = answer("change", files / "before.npz", files / "after.npz", *words)
    before, after = (loom.read_point_cloud(files / f"{name}.npz") for name in ("before", "after"))
    expected = loom.change.m3c2(before, after, **sizes)
    cloud = loom.read_point_cloud(files / "out.npz")
    np.testing.assert_array_equal(cloud["distance"], expected.distances.astype(np.float32))
    np.testing.assert_array_equal(cloud["significant"] != 0, expected.is_significant)
    np.testing.assert_array_equal(cloud["intensity"], before["intensity"])
    np.testing.assert_array_equal(cloud["points_after"], expected.counts[:, 1])
    known = np.isfinite(expected.distances).sum()
    assert (report["method"], report["cores"], report["known"]) == ("m3c2", 6000, known)
    assert report["significant"] == expected.is_significant.sum() and report["reliable"]
    assert -0.31 < report["median"] < -0.2
    sunk = (cloud.points[:, 0] - UTM[0] < 5) & (cloud.points[:, 1] - UTM[1] < 5)
    assert (cloud["significant"] != 0)[sunk].all() and (cloud["significant"] != 0)[~sunk].mean() < 0.2


def test_default_lengths_are_derived_from_the_points(files):
    words = ["--cores", "1", "--painted", files / "p.ply", "--picture", files / "c.png"]
    report = answer("change", files / "before.npz", files / "after.npz", *words)
    radius = report["lengths"]["cylinder_radius"]
    within = survey().compute_nearest_neighbor_distance()
    assert 2 * np.median(within) < radius < 1
    assert report["lengths"]["normal_radii"] == pytest.approx([radius, 2 * radius, 4 * radius])
    painted = loom.read_point_cloud(files / "p.ply")
    assert len(painted) == report["cores"] and 400 <= len(painted) < 500
    colors = painted.colors.astype(float)
    gray = np.ptp(colors, axis=1) < 0.05
    assert 0.7 < gray.mean() < 0.95 and (colors[~gray, 2] > colors[~gray, 0]).mean() > 0.8  # blue: below
    assert loom.read_color(files / "c.png").shape == (960, 1280, 3)


def test_a_cloud_is_compared_with_a_mesh(files):
    corners = np.array([[0, 0, 0], [20, 0, 4], [20, 20, 4], [0, 20, 0.0]]) + UTM
    loom.write_triangle_mesh(files / "design.ply", loom.TriangleMesh(corners, [[0, 1, 2], [0, 2, 3]]))
    words = ["--cylinder", "0.8", "-o", files / "out.npz"]
    report = answer("change", files / "design.ply", files / "after.npz", *words)
    assert report["method"] == "cloud to mesh" and report["lengths"] == {"radius": 0.8}
    cloud = loom.read_point_cloud(files / "out.npz")
    sunk = (cloud.points[:, 0] - UTM[0] < 5) & (cloud.points[:, 1] - UTM[1] < 5)
    np.testing.assert_allclose(cloud["distance"][sunk], -0.3 / np.sqrt(1.04), atol=0.01)
    assert (cloud["significant"] != 0)[sunk].mean() > 0.95
    assert "Pass the mesh first" in refusal("change", files / "after.npz", files / "design.ply")


def test_unregistered_or_separate_epochs_are_unreliable(files):
    report = unreliable("change", files / "before.npz", files / "lifted.npz")
    assert "moved up, by 0.49" in str(report["warnings"]) and "register the epochs first" in str(report["warnings"])
    assert answer("change", files / "before.npz", files / "lifted.npz", "--registration-error", "0.4")["reliable"]
    loom.write_point_cloud(files / "far.npz", survey().translate([0, 0, 50.0]))
    report = unreliable("change", files / "before.npz", files / "far.npz", "-o", files / "out.npz")
    assert report["known"] == 0 and "barely overlap" in str(report["warnings"]) and report["median"] is None
    assert np.isnan(loom.read_point_cloud(files / "out.npz")["distance"]).all()


def test_clouds_that_cannot_be_compared_are_an_error(files, tmp_path):
    loom.write_point_cloud(files / "one.npz", loom.PointCloud(np.tile(UTM, (30, 1))))
    assert "Pass --cylinder" in refusal("change", files / "one.npz", files / "after.npz")
    loom.write_point_cloud(files / "none.npz", loom.PointCloud(np.full((3, 3), np.nan)))
    assert "no finite point" in refusal("change", files / "before.npz", files / "none.npz")
    assert "out.xyz" in refusal("change", files / "before.npz", files / "after.npz", "-o", files / "out.xyz")
    laspy, pyproj = pytest.importorskip("laspy"), pytest.importorskip("pyproj")
    paths = []
    for number, code in enumerate((25832, 25833)):
        paths.append(tmp_path / f"{number}.laz")
        loom.write_point_cloud(paths[-1], survey(count=500))
        content = laspy.read(paths[-1])
        content.header.add_crs(pyproj.CRS.from_epsg(code))
        content.write(paths[-1])
    assert "got ETRS89 / UTM zone 33N" in refusal("change", *paths)
