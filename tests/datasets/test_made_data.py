"""Synthetic data: true poses and labels, bitwise identical in every run, and arrays from a cache."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.datasets import array_cache as module
from pointloom.datasets.array_cache import cached
from pointloom.datasets.scenes.room import surface_errors

from ..hostile import public_arguments

ARGUMENTS = [
    (call, name) for call, names in sorted(public_arguments(loom.datasets, {"fetch"}).items()) for name in sorted(names)
]


@pytest.mark.parametrize(("call", "argument"), ARGUMENTS)
def test_every_argument_rejects_values_that_are_no_numbers_of_its_kind(call, argument):
    for wrong in ("much", None, object(), [1], -1, np.nan, 10**400):
        with pytest.raises((TypeError, ValueError), match=f"^{argument}: expected "):
            getattr(loom.datasets, call)(**{argument: wrong})


@pytest.fixture
def without_cache(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "never"))
    monkeypatch.setattr(module, "MIN_SECONDS", np.inf)


def test_exact_frames_match_the_room_surface(without_cache):
    frame = loom.datasets.room_frames(2, width=64, height=48, noise=False)[1]
    assert frame.depth.dtype == np.float32 and frame.color.shape == (48, 64, 3)
    image = loom.RGBDImage(frame.color, frame.depth, depth_trunc=9.0)
    cloud = loom.PointCloud.create_from_rgbd_image(image, frame.intrinsic, np.linalg.inv(frame.T_world_camera))
    assert len(cloud) == 48 * 64 and np.median(surface_errors(cloud.points)) < 1e-5


def test_noisy_frames_have_the_noise_of_a_structured_light_camera(without_cache):
    """Of depth as in Nguyen, Izadi and Lovell, 3DIMPVT 2012, in whole millimeters; of colors 2 of 255."""
    true, noisy = (loom.datasets.room_frames(2, width=128, height=96, noise=noise)[1] for noise in (False, True))
    valid = noisy.depth > 0
    z, errors = true.depth[valid], noisy.depth[valid] - true.depth[valid]
    sigma = np.hypot(0.0012 + 0.0019 * (z - 0.4) ** 2, 0.001 / np.sqrt(12))
    assert 0.7 < valid.mean() < 0.95 and abs(np.mean(errors / sigma)) < 0.035
    for is_near in (z < 2.2, z >= 2.2):
        assert 0.9 < np.std((errors / sigma)[is_near]) < 1.1
    np.testing.assert_allclose(1000 * noisy.depth, np.rint(1000 * noisy.depth), atol=1e-3)
    assert 1.9 < np.std(noisy.color.astype(float) - true.color) < 2.15


def test_frames_are_reproducible_for_any_count(without_cache):
    first, second = loom.datasets.room_frames(1, width=64, height=48), loom.datasets.room_frames(2, width=64, height=48)
    assert np.array_equal(first[0].depth, second[0].depth) and np.array_equal(first[0].color, second[0].color)
    assert not np.array_equal(second[0].color, second[1].color)
    other = loom.datasets.room_frames(1, width=64, height=48, seed=1)[0]
    assert not np.array_equal(other.depth, first[0].depth)


@pytest.mark.slow
def test_room_cloud_and_mesh_match_the_room_with_inward_normals():
    cloud, mesh = loom.datasets.room_cloud(voxel_size=0.1), loom.datasets.room_mesh()
    assert np.median(surface_errors(mesh.vertices)) < 0.002
    outwards = surface_errors(cloud.points + 0.03 * cloud.normals)
    assert np.abs(np.linalg.norm(cloud.normals, axis=1) - 1).max() < 1e-5
    assert np.mean(outwards > surface_errors(cloud.points)) > 0.8  # lower in corners, which have another wall nearby


@pytest.mark.slow
def test_scans_of_the_street_fit_once_they_are_deskewed_and_posed():
    drive = loom.datasets.street_scans(2)
    step = np.linalg.inv(drive.poses[0]) @ drive.poses[1]
    world_clouds = [loom.registration.deskew_point_cloud(scan, step).transform(pose)
              for scan, pose in zip(drive.scans, drive.poses, strict=True)]  # fmt: skip
    road = [cloud.select_by_mask(cloud["label"] == 1) for cloud in world_clouds]
    assert max(np.abs(cloud.points[:, 2]).max() for cloud in road) < 0.05
    buildings = [cloud.select_by_mask(cloud["label"] == 4) for cloud in world_clouds]
    assert np.median(buildings[0].compute_point_cloud_distance(buildings[1])) < 0.12
    times = drive.scans[1]["time"]
    assert times.min() > 0.1 and times.max() <= 0.2 + 1e-12 and drive.scans[1]["ring"].max() == 31


@pytest.mark.slow
def test_figure_is_watertight_and_exact_scans_match_it():
    mesh, scans = loom.datasets.object_mesh(), loom.datasets.object_scans(3, noise=False)
    assert mesh.is_watertight() and mesh.is_edge_manifold() and mesh.is_vertex_manifold()
    assert 20_000 < len(mesh) < 100_000 and len(np.unique(mesh.cluster_connected_triangles()[0])) == 1
    low, high = mesh.get_min_bound(), mesh.get_max_bound()
    assert high[2] - low[2] == pytest.approx(0.3, abs=0.005) and np.abs(low + high).max() < 0.005
    scene = loom.RaycastingScene()
    scene.add_triangles(mesh.vertices.astype(np.float32), mesh.triangles)
    for k in range(3):
        assert scene.compute_distance(scans.in_world(k).points.astype(np.float32)).max() < 1e-5
        assert (scans.scans[k].points[:, 2] > 0).all()


@pytest.mark.slow
def test_photographs_match_the_figure_at_their_poses():
    shots, mesh = loom.datasets.photographs(2), loom.datasets.object_mesh()
    for pose, depth in zip(shots.poses, shots.depths, strict=True):
        cloud = loom.PointCloud.create_from_depth_image(depth, shots.intrinsic, np.linalg.inv(pose))
        figure = cloud.points[cloud.points[:, 2] > mesh.get_min_bound()[2] + 0.003].astype(np.float32)
        scene = loom.RaycastingScene()
        scene.add_triangles(mesh.vertices.astype(np.float32), mesh.triangles)
        assert len(figure) > 10_000 and scene.compute_distance(figure).max() < 1e-4


@pytest.mark.slow
def test_the_airborne_scan_has_its_classes_and_returns():
    cloud = loom.datasets.terrain()
    assert set(np.unique(cloud["classification"])) == {2, 5, 6}
    assert (cloud["return_number"] <= cloud["number_of_returns"]).all()
    second = cloud["return_number"] == 2
    assert 0 < second.sum() < len(cloud) / 10 and not (cloud["classification"][second] == 5).any()
    assert np.allclose(np.ptp(cloud.points[:, :2], axis=0), 200, atol=0.1) and cloud.points[:, 0].min() > 400_000


@pytest.mark.parametrize("make", [loom.datasets.room_frames, loom.datasets.street_scans, loom.datasets.object_scans])
@pytest.mark.parametrize(("count", "error"), [(0, ValueError), (-1, ValueError), (1.5, TypeError), ("2", TypeError)])
def test_counts_that_are_none_are_refused(make, count, error):
    with pytest.raises(error, match="count"):
        make(count)


@pytest.fixture
def cache(tmp_path, monkeypatch):
    """A cache folder that stores every result, however fast it was computed."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(module, "MIN_SECONDS", -1.0)
    return tmp_path / "pointloom" / "datasets"


class Maker:
    """Counts its calls."""

    def __init__(self):
        self.calls = 0

    def __call__(self):
        self.calls += 1
        return {"values": np.arange(1000.0), "few": np.uint8([1, 2])}


def test_cached_arrays_are_bitwise_identical(cache):
    make = Maker()
    first, second = cached("room", {"count": 1}, make), cached("room", {"count": 1}, make)
    assert make.calls == 1 and len(list(cache.iterdir())) == 1
    for name, values in first.items():
        assert values.dtype == second[name].dtype and np.array_equal(values, second[name])


def test_other_parameters_and_other_sources_are_made_anew(cache, monkeypatch):
    make = Maker()
    cached("room", {"count": 1}, make), cached("room", {"count": 2}, make), cached("street", {"count": 1}, make)
    monkeypatch.setattr(module, "source_digest", lambda: "other")
    cached("room", {"count": 1}, make)
    assert make.calls == 4


@pytest.mark.parametrize("damage", ["flipped", "cut", "empty", "of another key"])
def test_a_damaged_file_is_made_anew(cache, damage):
    make = Maker()
    cached("room", {"count": 1}, make)
    (path,) = cache.iterdir()
    content = bytearray(path.read_bytes())
    if damage == "of another key":
        cached("room", {"count": 2}, make)
        make.calls = 1
        content = next(other for other in cache.iterdir() if other != path).read_bytes()
    elif damage == "flipped":
        content[len(content) // 3] ^= 255
    else:
        content = content[: len(content) // 2 if damage == "cut" else 0]
    path.write_bytes(content)
    again = cached("room", {"count": 1}, make)
    assert make.calls == 2 and np.array_equal(again["values"], np.arange(1000.0))
    cached("room", {"count": 1}, make)
    assert make.calls == 2


def test_fast_results_and_unwritable_folders_are_not_cached(tmp_path, monkeypatch):
    make = Maker()
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    cached("room", {}, make)
    assert list(tmp_path.iterdir()) == []
    monkeypatch.setattr(module, "MIN_SECONDS", -1.0)
    (tmp_path / "pointloom").write_text("a file where the folder would be")
    assert np.array_equal(cached("room", {}, make)["few"], [1, 2])


def test_lru_entry_is_evicted(cache, monkeypatch):
    make = Maker()
    cached("room", {"count": 0}, make)
    size = next(cache.iterdir()).stat().st_size
    monkeypatch.setattr(module, "MAX_BYTES", 2.5 * size)
    for count in range(1, 6):
        cached("room", {"count": count}, make)
    assert len(list(cache.iterdir())) == 2
    make.calls = 0
    cached("room", {"count": 5}, make)
    assert make.calls == 0
