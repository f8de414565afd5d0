"""Recordings: the content of each frame, arrays stored once, animations, output of cells, and rejected input."""

import base64
import dataclasses
import html
import io
import itertools
import json
import shutil
import subprocess
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.core.observers import report
from pointloom.visualization.recording import cell_output
from pointloom.visualization.recording import recorder as recorder_module
from pointloom.visualization.recording.film import Film, view_frames
from pointloom.visualization.recording.shapes import spread_rows
from pointloom.visualization.recording.timeline import Frame, Placement, Shape, Timeline
from pointloom.visualization.recording.writers import changed_box, make_palette, write_gif

from .reading import Page

CAMERA = loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5)
DEPTH = (1.0 + 0.1 * np.sin(np.mgrid[:24, :32].sum(axis=0) / 4)).astype(np.float32)
SHIFT = np.array([0.03, -0.02, 0.01])
UTM = np.array([500_000.0, 5_400_000.0, 300.0])


def bumps(count: int = 1500) -> np.ndarray:
    x, y = np.random.default_rng(0).uniform(-1, 1, (2, count))
    return np.column_stack([x, y, 0.2 * np.sin(3 * x) * np.cos(4 * y)])


def shifted(x: float) -> np.ndarray:
    T = np.eye(4)
    T[0, 3] = x
    return T


def world_positions(timeline: Timeline, frame: int, name: str) -> np.ndarray:
    """World positions of a name in a frame, float64."""
    shown_shape = timeline.frames[frame].shown[name]
    points = np.concatenate([timeline.shapes[number].positions for number in shown_shape.shapes]).astype(np.float64)
    T = np.eye(4) if shown_shape.pose is None else shown_shape.pose
    return points @ T[:3, :3].T + T[:3, 3] + timeline.origin


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "out.html"


def test_icp_is_recorded_pose_by_pose_and_its_clouds_once(device, path):
    target = loom.PointCloud(bumps(), device=device)
    source = loom.PointCloud(bumps() + SHIFT, device=device)
    events: list[dict[str, Any]] = []
    with loom.record(path) as r:
        result = loom.registration.registration_icp(source, target, 0.2, callback_after_iteration=events.append)
    frames = r.timeline.frames
    assert len(frames) == result.iterations + 1
    assert len(r.timeline.shapes) == 2
    assert frames[0].shown["source"].pose is None  # with its pose
    for frame, state in zip(frames[1:], events, strict=True):
        np.testing.assert_array_equal(frame.shown["source"].pose, state["transformation"])
        assert frame.values == {"fitness": state["fitness"], "inlier rmse [m]": state["inlier_rmse"]}
        assert frame.shown["target"].pose is None
    np.testing.assert_array_equal(events[-1]["transformation"], result.transformation)
    assert frames[3].label == "ICP, iteration 3"
    assert path.stat().st_size > 1000


def test_icp_fusion_and_clusters_have_the_same_bits_recorded_or_not(device, tmp_path):
    target, source = loom.PointCloud(bumps(), device=device), loom.PointCloud(bumps() + SHIFT, device=device)

    def work() -> list[Any]:
        result = loom.registration.registration_icp(source, target, 0.2)
        volume = loom.TSDFVolume(voxel_size=0.05, device=device)
        for _ in range(3):
            volume.integrate(DEPTH, CAMERA, np.eye(4))
        mesh = volume.extract_triangle_mesh(0)
        fit = [result.fitness, result.inlier_rmse, result.iterations]
        return [result.transformation, fit, mesh.vertices, mesh.triangles, target.cluster_dbscan(0.1, 5)]

    alone = work()
    with loom.record(tmp_path / "all.html") as r:
        recorded = work()
    for left, right in zip(alone, recorded, strict=True):
        np.testing.assert_array_equal(left, right)
    assert len(r.timeline.frames) > 10


def test_coarse_to_fine_shows_the_clouds_that_were_given(path):
    target, source = loom.PointCloud(bumps()), loom.PointCloud(bumps() + SHIFT)
    rules = [loom.registration.ICPConvergenceCriteria(max_iteration=3)] * 2
    with loom.record(path) as r:
        loom.registration.multi_scale_icp(source, target, [0.2, 0.1], rules, [0.4, 0.2])
    assert len(r.timeline.shapes) == 2
    assert len(r.timeline.shapes[0].positions) == 1500
    assert r.timeline.frames[0].label == "ICP, voxels of 0.2 m, iteration 0"
    assert r.timeline.frames[-1].label.startswith("ICP, voxels of 0.1 m")


def test_registration_without_steps_is_a_start_and_a_result(path):
    target, source = loom.PointCloud(bumps()), loom.PointCloud(bumps() + SHIFT)
    pairs = np.column_stack([np.arange(1500)] * 2)
    with loom.record(path) as r:
        result = loom.registration.registration_ransac_based_on_correspondence(source, target, pairs, 0.05)
    assert [frame.label for frame in r.timeline.frames] == ["initial poses", "registered: converged"]
    np.testing.assert_array_equal(r.timeline.frames[1].shown["source"].pose, result.transformation)


def test_fusion_shows_camera_path_and_surface_as_they_grow(device, path):
    volume = loom.TSDFVolume(voxel_size=0.05, device=device)
    with loom.record(path) as r:
        for i in range(7):
            volume.integrate(DEPTH, CAMERA, shifted(-0.05 * i))
    timeline = r.timeline
    labels = [frame.label for frame in timeline.frames]
    assert labels == [*(f"frame {i}" for i in range(1, 8)), "the surface of 7 frames"]
    assert timeline.frames[0].shown["camera"].pose is None
    np.testing.assert_allclose(timeline.frames[6].shown["camera"].pose, shifted(0.3), atol=1e-12)
    assert len({frame.shown["camera"].shapes for frame in timeline.frames}) == 1
    np.testing.assert_allclose(world_positions(timeline, 6, "path")[:, 0], 0.05 * np.arange(7), atol=1e-6)
    surfaces = [frame.shown["surface"].shapes for frame in timeline.frames]
    assert surfaces[0] == surfaces[4] != surfaces[5] == surfaces[6] != surfaces[7]
    vertices = volume.extract_triangle_mesh(0).vertices
    np.testing.assert_allclose(world_positions(timeline, 7, "surface"), vertices, atol=1e-6)


def test_lidar_odometry_shows_scan_after_scan_on_the_map(path):
    wall = np.array([[10, 0.5 * i, 0.5 * j] for i in range(-20, 20) for j in range(20)])
    with loom.record(path) as r:
        track = loom.registration.run_odometry([loom.PointCloud(wall - [0.2 * k, 0, 0]) for k in range(4)])
    labels = [frame.label.split(":")[0] for frame in r.timeline.frames]
    assert labels == ["scan 0", "scan 1", "scan 2", "scan 3", "the map of 4 scans"]
    for k in range(4):
        positions = world_positions(r.timeline, k, "scan")
        moved = (wall - [0.2 * k, 0, 0]) @ track.poses[k][:3, :3].T + track.poses[k][:3, 3]
        np.testing.assert_allclose(positions, moved, atol=1e-5)


def test_rgbd_odometry_chains_the_motions(path):
    camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
    v, u = np.mgrid[:48, :64]
    depths = [1.0 + 0.1 * np.sin((u + k) / 5) * np.cos(v / 7) for k in range(3)]
    images = [loom.RGBDImage(np.zeros((48, 64), np.uint8), depth) for depth in depths]
    with loom.record(path) as r:
        results = [loom.rgbd.compute_rgbd_odometry(b, a, camera) for a, b in itertools.pairwise(images)]
    assert all(result.reliable for result in results)
    first, second = (result.transformation for result in results)
    np.testing.assert_allclose(r.timeline.frames[-1].shown["camera"].pose, first @ second, atol=1e-12)
    assert np.abs(first @ second - np.eye(4)).max() > 1e-3
    assert [frame.label for frame in r.timeline.frames] == ["frame 1: aligned", "frame 2: aligned"]


def test_clusters_take_their_colors_in_the_order_of_their_labels(device, path):
    sheets = [bumps(300) + np.array([0, 0, 5 * k]) for k in range(3)]
    cloud = loom.PointCloud(np.vstack([*sheets, [[90.0, 0, 0]]]), device=device)
    with loom.record(path) as r:
        labels = cloud.cluster_dbscan(0.5, 3)
    assert [frame.label for frame in r.timeline.frames] == ["the cloud", *(f"{k} of 3 clusters" for k in (1, 2, 3))]
    for k, frame in enumerate(r.timeline.frames):
        shapes = [r.timeline.shapes[number] for number in frame.shown["cloud"].shapes]
        painted = [len(shape.positions) for shape in shapes if shape.colors is not None]
        assert painted == [int((labels == label).sum()) for label in range(k)]
        assert sum(len(shape.positions) for shape in shapes) == len(cloud)


def test_planes_are_shown_as_they_are_detected(path):
    x, y = np.random.default_rng(0).random((2, 500))
    floor, wall = np.column_stack([x, y, 0 * x]), np.column_stack([0 * x[:300], x[:300], y[:300] + 0.1])
    with loom.record(path) as r:
        labels, _ = loom.PointCloud(np.vstack([floor, wall])).segment_planes(0.01)
    sizes = [len(r.timeline.shapes[number].positions) for number in r.timeline.frames[-1].shown["cloud"].shapes]
    assert sizes == [int((labels == k).sum()) for k in (-1, 0, 1)]


def test_shapes_of_an_algorithm_are_removed_by_the_next_one_and_the_users_remain(path):
    cloud = loom.PointCloud(bumps())
    with loom.record(path) as r:
        r.add("mine", bumps(10))
        loom.registration.registration_icp(cloud, cloud, 0.2)
        r.remove("source")
        state = {"iteration_index": 9, "transformation": np.eye(4), "fitness": 1.0, "inlier_rmse": 0}
        report("icp", source=cloud, target=cloud, **state)
        assert "source" not in r.timeline.frames[-1].shown  # shapes removed by the user stay removed
        cloud.cluster_dbscan(0.2, 3)
    assert set(r.timeline.frames[0].shown) == {"mine", "target", "source"}
    assert set(r.timeline.frames[-1].shown) == {"mine", "cloud"}


def test_a_view_in_parameters_of_open3d_is_that_of_render_about_all_frames(tmp_path):
    given, cloud = {"front": [1, 0, 0], "up": [0, 0, 1], "zoom": 0.7}, loom.PointCloud(bumps())
    bounds = cloud.get_min_bound(), cloud.get_max_bound()
    for name, view in (("given", given), ("same", loom.View.from_open3d(bounds, **given, width=64, height=48))):
        with loom.record(tmp_path / f"{name}.gif", automatic=False, size=(64, 48), view=view) as recording:
            recording.add("cloud", cloud)
    assert (tmp_path / "given.gif").read_bytes() == (tmp_path / "same.gif").read_bytes()


def test_a_loop_of_updates_makes_the_given_frames_and_no_automatic_ones(path):
    cloud = loom.PointCloud(bumps())
    with loom.record(path, automatic=False, title="steps") as r:
        loom.registration.registration_icp(cloud, cloud, 0.2)
        r.add("cloud", cloud, color=(1, 0, 0))
        r.step("first")
        r.set_pose("cloud", shifted(1.0))
        r.plot("error", 0.5)
        r.step("moved")
        r.update("cloud", bumps(7))
        r.step("other")
        r.remove("cloud")
        r.step("gone")
    first, moved, other, gone = r.timeline.frames
    assert first.shown["cloud"].shapes == moved.shown["cloud"].shapes
    np.testing.assert_array_equal(moved.shown["cloud"].pose, shifted(1.0))
    np.testing.assert_array_equal(other.shown["cloud"].pose, shifted(1.0))  # its pose stays
    assert r.timeline.shapes[other.shown["cloud"].shapes[0]].plain == (255, 0, 0)  # and its style
    assert moved.values == {"error": 0.5}
    assert other.values == {}
    assert gone.shown == {}
    assert r.timeline.title == "steps"


def test_equal_arrays_are_stored_once_and_changed_ones_again(path):
    points = bumps(20)
    with loom.record(path) as r:
        for k in range(4):
            if k == 3:
                points[0] = 9.0  # the same array with another content
            r.add("points", points)
            r.step()
    assert len(r.timeline.shapes) == 2
    assert [frame.shown["points"].shapes for frame in r.timeline.frames] == [(0,), (0,), (0,), (1,)]


def test_large_clouds_are_sampled_and_the_title_reports_it(path):
    with loom.record(path, max_points=100, title="many") as r:
        r.add("cloud", loom.PointCloud(bumps(1500)))
        r.add("mesh", loom.TriangleMesh.create_sphere(1.0, 40))
        r.step()
    cloud, mesh = (r.timeline.shapes[r.timeline.frames[0].shown[name].shapes[0]] for name in ("cloud", "mesh"))
    assert len(cloud.positions) == 100
    assert 20 < len(mesh.positions) <= 100
    assert mesh.indices.max() < len(mesh.positions)
    assert "cloud: 100 of 1,500 points" in r.timeline.title
    assert "mesh: " in r.timeline.title


def test_rows_are_spread_over_all_of_a_cloud_without_stripes():
    rows = spread_rows(1_000_000, 1000)
    assert len(rows) == len(set(rows.tolist())) == 1000
    assert (rows // 1000).tolist() == list(range(1000))
    counts = np.bincount(rows % 64, minlength=64)  # a scanner of 64 rings keeps points of each
    assert counts.min() >= 10
    assert spread_rows(5, 10).tolist() == [0, 1, 2, 3, 4]


def test_many_frames_are_thinned_evenly_and_the_last_one_stays(path):
    with loom.record(path, max_frames=10) as r:
        r.add("cloud", bumps(10))
        for k in range(100):
            r.add("frame", np.full((2, 3), float(k)))
            r.step(str(k))
    numbers = [int(frame.label) for frame in r.timeline.frames]
    assert numbers == [*range(0, 99, 16), 99]
    assert "one of 16 steps" in r.timeline.title
    assert [world_positions(r.timeline, k, "frame")[0, 0] for k in range(len(numbers))] == numbers
    assert len(r.timeline.shapes) <= 12  # shapes of removed frames are removed


def test_memory_is_bounded_by_dropping_frames(path, monkeypatch):
    monkeypatch.setattr(recorder_module, "MAX_BYTES", 50_000)
    with loom.record(path) as r:
        for k in range(40):
            r.add("cloud", bumps(100) + k)  # 1,200 B and more each
            r.step(str(k))
    assert sum(shape.positions.nbytes for shape in r.timeline.shapes) <= 52_000
    assert r.timeline.frames[-1].label == "39"


def test_points_that_are_not_finite_and_empty_clouds_are_left_out(tmp_path):
    points = bumps(10)
    points[3] = np.nan
    with loom.record(tmp_path / "holes.gif", size=(64, 48)) as r:
        r.add("holes", points)
        r.add("nothing", loom.PointCloud())
        r.step()
    assert len(r.timeline.shapes[r.timeline.frames[0].shown["holes"].shapes[0]].positions) == 9
    assert (tmp_path / "holes.gif").exists()


@pytest.mark.parametrize("error", [KeyboardInterrupt, ValueError])
def test_an_error_propagates_and_the_recording_so_far_is_written(path, error):
    r = loom.record(path, title="half")
    with pytest.raises(error, match="mine"), r:
        r.add("cloud", bumps(10))
        r.step("one")
        raise error("mine")
    assert f"half, ended by {error.__name__}" in path.read_text()
    cloud = loom.PointCloud(bumps())
    assert loom.registration.registration_icp(cloud, cloud, 0.1).fitness == 1  # not recorded any more
    assert len(r.timeline.frames) == 1


def test_an_empty_block_warns_and_the_program_continues(path):
    match = r"no file is written: .*nothing was recorded.*step\(\)"
    with pytest.warns(UserWarning, match=match) as warned, loom.record(path) as r:
        pass
    assert not path.exists() and warned[0].filename == __file__
    assert r._repr_mimebundle_() == {"text/plain": repr(r)}
    with pytest.raises(ValueError, match=r"/out\.html:"):
        r.save()
    with pytest.raises(KeyError, match="mine"), loom.record(path) as r:  # and no other warning
        r.add("cloud", bumps(10))
        raise KeyError("mine")
    assert not path.exists()


@pytest.mark.parametrize(
    ("title", "max_points", "tab", "above"),
    [("", 200, "a walk", ""), ("mine", 200, "mine", "mine"), ("", 5, "a walk", "cloud: 5 of 10 points")],
)
def test_the_tab_has_the_title_or_the_name_of_the_file(tmp_path, title, max_points, tab, above):
    path = tmp_path / "a walk.html"
    with loom.record(path, title=title, max_points=max_points) as r:
        r.add("cloud", bumps(10))
        r.step()
    page = Page(path)
    assert (page.title, page.description["title"]) == (tab, above)


def test_unwritable_files_are_rejected_first(tmp_path, monkeypatch):
    with pytest.raises(FileError, match=r"/a\.avi:.*mp4"):
        loom.record(tmp_path / "a.avi")
    with pytest.raises(FileError, match=r"/a\.html:"):
        loom.record(tmp_path / "no" / "a.html")
    for wrong in ({"max_frames": 1}, {"fps": 1e9}, {"view": {"forward": [0, 0, 1]}}, {"background": (1, 1, 2)}):
        with pytest.raises(ValueError, match=next(iter(wrong))):
            loom.record(tmp_path / "a.html", **wrong)
    with pytest.raises(ValueError, match=r"fps.*50"):  # faster than viewers play
        loom.record(tmp_path / "a.gif", fps=60)
    (tmp_path / "b.html").write_text("keep me")
    with pytest.raises(FileError, match="exists already"):
        loom.record(tmp_path / "b.html", overwrite=False)
    monkeypatch.setenv("PATH", "")
    with pytest.raises(FileError, match=r"/c\.mp4:"):
        loom.record(tmp_path / "c.mp4")
    assert (tmp_path / "b.html").read_text() == "keep me"


def test_unsupported_geometries_are_rejected_by_name(path):
    r: Any = loom.record(path)
    r.add("cloud", bumps(3))
    for call, error, name in (
        (lambda: r.add("thing", "a string"), TypeError, "PointCloud"),
        (lambda: r.add(3, bumps(3)), TypeError, "name"),
        (lambda: r.add("cloud", bumps(3), shade=(1, 0, 0)), ValueError, "shade"),
        (lambda: r.update("no", bumps(3)), KeyError, "no"),
        (lambda: r.set_pose("no", np.eye(4)), KeyError, "no"),
        (lambda: r.remove("no"), KeyError, "no"),
        (lambda: r.set_pose("cloud", np.eye(3)), ValueError, "pose"),
        (lambda: r.plot("fitness", "high"), TypeError, "value"),
        (lambda: r.step(3), TypeError, "label"),
    ):
        with pytest.raises(error, match=name):
            call()


def test_closed_loops_move_the_path_and_no_loop_is_no_frame(path):
    frame = SimpleNamespace(depth=DEPTH, color=None)
    slam = loom.rgbd.DenseSLAM(CAMERA, voxel_size=0.05, depth_max=2.0, submap_frames=4)
    with loom.record(path) as r:
        slam.run([frame] * 3)
        report("loops", slam=slam, closure=SimpleNamespace(loops=[]))
        before = len(r.timeline.frames)
        slam.results = [dataclasses.replace(s, pose=shifted(k)) for k, s in enumerate(slam.results)]
        report("loops", slam=slam, closure=SimpleNamespace(loops=[1, 2]))
    assert before == 3
    assert r.timeline.frames[3].label == "2 loops closed"
    np.testing.assert_allclose(world_positions(r.timeline, 3, "path")[:, 0], [0, 1, 2], atol=1e-6)


def test_stages_precede_the_labels_and_fragments_appear_one_by_one(path):
    clouds = [loom.PointCloud(bumps(50)) for _ in range(3)]
    poses = np.array([shifted(k) for k in range(3)])
    with loom.record(path) as r:
        report("stage", name="register")
        report("fragments", clouds=clouds, poses=poses, placed=np.array([True, False, True]))
        report("something new", number=3)  # unknown events are ignored
    labels = [frame.label for frame in r.timeline.frames]
    assert labels == ["register: 1 of 2 clouds placed, 3 in all", "register: 2 of 2 clouds placed, 3 in all"]
    np.testing.assert_allclose(world_positions(r.timeline, 1, "cloud 2"), bumps(50) + np.array([2, 0, 0]), atol=1e-6)


def test_a_texture_becomes_colors_of_vertices(path):
    texture = np.zeros((2, 2, 3), np.uint8)
    texture[0] = 255, 0, 0  # the upper row
    texture[1] = 0, 0, 255
    square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    uvs = [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]]
    mesh = loom.TriangleMesh(square, [[0, 1, 2], [0, 2, 3]], triangle_uvs=uvs, textures=[texture])
    with loom.record(path) as r:
        r.add("mesh", mesh)
    assert r.timeline.shapes[0].colors.tolist() == [[0, 0, 255], [0, 0, 255], [255, 0, 0], [255, 0, 0]]


def test_a_pose_rotates_a_shape_about_the_origin_of_its_cloud(path):
    points, T = bumps(50), np.array([[0.0, -1, 0, 5], [1, 0, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1]])
    with loom.record(path) as r:
        r.add("here", loom.PointCloud(points))
        r.add("far", loom.PointCloud(points + UTM), pose=T)
        r.step()
    assert all(np.abs(shape.positions).max() < 1e5 for shape in r.timeline.shapes)
    expected = (points + UTM) @ T[:3, :3].T + T[:3, 3]
    np.testing.assert_allclose(world_positions(r.timeline, 0, "far"), expected, atol=1e-3)


RED, GROUND = (255, 0, 0), (0, 0, 1.0)
has_ffmpeg = pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="needs the program ffmpeg")


def recorded(path, **options):
    with loom.record(path, size=(160, 120), background=GROUND, **options) as r:
        r.add("shown", np.random.default_rng(0).random((500, 3)), color=(0, 1, 0))
        r.step("first")
        r.add("shown", loom.TriangleMesh.create_box(), color=(1, 0, 0), shaded=False)
        r.step("last")
    return r


def still_of(shown):
    return np.asarray(Image.open(io.BytesIO(base64.b64decode(shown["image/jpeg"]))).convert("RGB")).astype(int)


def reds(picture):
    return (np.abs(picture - RED) < 40).all(axis=-1).sum()


def test_a_page_is_embedded_in_the_notebook_over_its_last_frame(tmp_path):
    r = recorded(tmp_path / "a.html")
    shown = r._repr_mimebundle_()
    page = shown["text/html"].partition('srcdoc="')[2].partition('"')[0]
    assert html.unescape(page) == (tmp_path / "a.html").read_text()
    assert "a.html, " in shown["text/html"] and shown["text/plain"] == repr(r)
    assert reds(still_of(shown)) > 1000


@pytest.mark.parametrize(
    ("suffix", "start"),
    [
        (".gif", '<img alt="" src="data:image/gif;base64,'),
        pytest.param(".mp4", '<video controls loop src="data:video/mp4;base64,', marks=has_ffmpeg),
    ],
)
def test_animations_and_videos_play_below_the_cell(tmp_path, suffix, start):
    shown = recorded(tmp_path / f"a{suffix}")._repr_mimebundle_()
    assert shown["text/html"].startswith(start)
    data = base64.b64decode(shown["text/html"][len(start) :].partition('"')[0])
    assert data == (tmp_path / f"a{suffix}").read_bytes() and reds(still_of(shown)) > 1000


def test_large_files_are_shown_by_their_last_frame_and_path(tmp_path, monkeypatch):
    monkeypatch.setattr(cell_output, "MAX_PAGE_BYTES", 10_000)
    shown = recorded(tmp_path / "large.html")._repr_mimebundle_()
    assert "<iframe" not in shown["text/html"] and "large.html" in shown["text/html"] and reds(still_of(shown)) > 1000
    assert "9.8 KiB in notebooks: open it in a browser" in shown["text/html"] and len(shown["text/html"]) < 300_000


def test_a_deleted_file_is_shown_by_its_last_frame(tmp_path):
    r = recorded(tmp_path / "a.html")
    (tmp_path / "a.html").unlink()
    shown = r._repr_mimebundle_()
    assert "cannot be read" in shown["text/html"] and reds(still_of(shown)) > 1000


def test_an_unwritten_recording_is_shown_as_text(tmp_path):
    r = loom.record(tmp_path / "a.html")
    with r:
        r.add("square", np.eye(3))
        r.step()
        assert r._repr_mimebundle_() == {"text/plain": repr(r)}
        r.discard()
    assert not (tmp_path / "a.html").exists() and r._repr_mimebundle_() == {"text/plain": repr(r)}


WHITE = (255, 255, 255)
ORANGE, BLUE = (255, 180, 0), (0, 166, 237)


def images(count: int = 12, height: int = 41, width: int = 61) -> list[np.ndarray]:
    """A square that moves to the right and stops at the eighth image."""
    made = []
    for k in range(count):
        picture = np.full((height, width, 3), 255, np.uint8)
        left = 3 * min(k, 8)
        picture[10:20, left : left + 12] = 200, 30 * min(k, 8), 40
        made.append(picture)
    return made


def read_back(data: bytes) -> tuple[list[np.ndarray], list[int]]:
    """The frames of an animation as an image reader decodes them, and their durations [ms]."""
    image = Image.open(io.BytesIO(data))
    frames, durations = [], []
    for k in range(getattr(image, "n_frames", 1)):
        image.seek(k)
        image.load()
        frames.append(np.array(image.convert("RGB")))
        durations.append(image.info["duration"])
    return frames, durations


def two_cloud_timeline(frames: int = 4) -> Timeline:
    """A blue cloud, and an orange one with a value that moves onto it."""
    square = np.random.default_rng(0).uniform(-1, 1, (400, 3)).astype(np.float32)
    shapes = [Shape("points", square, size=5.0, plain=color) for color in (BLUE, ORANGE)]
    timeline = Timeline(np.array([5e5, 5e6, 0.0]), shapes, fps=10.0)
    for k in range(frames):
        pose = np.eye(4)
        pose[0, 3] = 4.0 - k
        shown = {"target": Placement((0,)), "source": Placement((1,), pose)}
        timeline.frames.append(Frame(shown, f"step {k}", {"rmse": 1.0 / (k + 1)}))
    return timeline


def film_of(timeline: Timeline, size: tuple[int, int] = (160, 120), device: str = "cpu") -> Film:
    return Film(timeline, view_frames(timeline, None, *size), *size, (1.0, 1.0, 1.0), device)


def near(picture: np.ndarray, color: tuple[int, int, int]) -> np.ndarray:
    return (np.abs(picture.astype(int) - color) < 40).all(axis=2)


@pytest.mark.parametrize(("fps", "total"), [(30, 400), (7, 1714)])
def test_a_gif_has_all_frames_and_the_right_duration(fps, total):
    drawn, file = images(), io.BytesIO()
    palette = make_palette(drawn, WHITE)
    assert write_gif(file, drawn, palette, fps) == 12
    assert file.getvalue()[13 : 13 + 768] == palette.tobytes() and tuple(palette[0]) == WHITE  # one for all frames
    frames, durations = read_back(file.getvalue())
    assert len(frames) == 12
    assert abs(sum(durations) - total) <= 5
    for frame, picture in zip(frames, drawn, strict=True):
        assert np.abs(frame.astype(int) - picture).max() < 8
        assert (frame == 255).all(axis=2).sum() == (picture == 255).all(axis=2).sum()


def test_the_changed_box_is_exact_to_the_pixel():
    before = np.zeros((20, 30, 3), np.uint8)
    after = before.copy()
    after[4:9, 7:11, 1] = 1
    assert changed_box(after, before) == (7, 4, 11, 9)
    assert changed_box(before, before) == (0, 0, 1, 1)
    assert changed_box(before, None) == (0, 0, 30, 20)


def test_a_frame_shows_the_shapes_at_their_current_poses(device):
    film = film_of(two_cloud_timeline(), (320, 240), device)
    columns = []
    for k in range(4):
        picture = film.draw(k)
        assert picture.shape == (240, 320, 3)
        orange, blue = near(picture, ORANGE), near(picture[:187], BLUE)
        assert blue.sum() > 100
        columns.append(np.flatnonzero(orange.any(axis=0)).mean())
        assert orange.sum() > 100
        assert (np.concatenate([picture[186], picture[:187, 0], picture[:187, -1]]) == 255).all()  # no change beyond
    assert np.diff(columns).max() < -10 or np.diff(columns).min() > 10  # it moves in one direction


def test_values_are_plotted_beneath_up_to_the_frame():
    film = film_of(two_cloud_timeline(), (320, 240))
    strips = [film.draw(k)[190:].astype(int) for k in range(4)]
    past = [int(((strip[..., 2] - strip[..., 0]) > 100).sum()) for strip in strips]
    assert past == sorted(past)
    assert past[0] < past[3]
    timeline = two_cloud_timeline()
    timeline.frames = [Frame(frame.shown, frame.label) for frame in timeline.frames]
    assert (film_of(timeline, (320, 240))._picture_height, film._picture_height) == (240, 188)


def test_two_known_values_are_joined_by_a_line():
    def ink(*values):  # dark pixels between the second and the third of four frames
        frames = [Frame({}, "", {"a": value}) for value in values]
        return int((film_of(Timeline(np.zeros(3), [], frames), (320, 240)).draw(3)[200:, 150:170] < 240).any(-1).sum())

    none = float("nan")
    assert ink(none, 1.0, 2.0, none) > ink(none, 1.0, none, 2.0)


def test_frames_without_anything_and_values_that_are_not_finite_are_drawn():
    frames = [Frame({}, "", {"a": float("nan")}), Frame({}, "x", {"a": float("inf"), "b": 2})]
    for size in ((320, 240), (160, 120), (16, 16)):
        film = film_of(Timeline(np.zeros(3), [], frames), size)
        assert [film.draw(k).shape for k in range(2)] == [(size[1], size[0], 3)] * 2


def test_a_recording_has_as_many_frames_as_steps(tmp_path):
    path = tmp_path / "walk.gif"
    reported: list[tuple[str, int, int]] = []
    with loom.record(path, size=(160, 120), fps=20, progress=lambda *step: reported.append(step)) as r:
        r.add("cloud", np.random.default_rng(0).random((100, 3)))
        for k in range(6):
            r.plot("k", k)
            r.step("the same label")
    frames, durations = read_back(path.read_bytes())
    assert (len(frames), sum(durations)) == (6, 300)
    assert frames[0].shape == (120, 160, 3)
    assert reported[-1] == ("drawing", 6, 6)


@has_ffmpeg
def test_a_video_has_as_many_frames_as_steps_and_even_sides(tmp_path):
    path = tmp_path / "walk.mp4"
    with loom.record(path, size=(161, 121), fps=25) as r:
        r.add("cloud", np.random.default_rng(0).random((100, 3)))
        for k in range(6):
            r.step(str(k))
    entries = "stream=width,height,nb_read_frames,r_frame_rate,pix_fmt"
    line = ["ffprobe", "-v", "error", "-count_frames", "-show_entries", entries, "-of", "json", str(path)]
    stream = json.loads(subprocess.run(line, capture_output=True, check=True).stdout)["streams"][0]
    assert (stream["width"], stream["height"], stream["nb_read_frames"]) == (162, 122, "6")
    assert (stream["r_frame_rate"], stream["pix_fmt"]) == ("25/1", "yuv420p")
    assert [entry.name for entry in tmp_path.iterdir()] == ["walk.mp4"]


def test_an_ffmpeg_that_fails_is_quoted_and_leaves_nothing(tmp_path, monkeypatch):
    folder = tmp_path / "bin"
    folder.mkdir()
    program = folder / "ffmpeg"
    program.write_text("#!/bin/sh\necho 'no such codec' >&2\nexit 1\n")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", str(folder))
    with pytest.raises(FileError, match=r"/a\.mp4:"), loom.record(tmp_path / "a.mp4", size=(64, 48)) as r:
        r.add("cloud", np.zeros((1, 3)))
    assert [entry.name for entry in tmp_path.iterdir()] == ["bin"]
