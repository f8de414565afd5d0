"""Streams of frames and drivers of depth cameras, replaced by stubs: checks, dropped frames, calibration, failures."""

import shutil
import sys
import threading
import time
from functools import partial
from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from benchmarks.room_loops import room_loop_sequence
from pointloom.core.errors import CameraError, DatasetError
from pointloom.io.frames import recordings
from pointloom.io.frames.dataset_layouts import FRAME_TIMES
from pointloom.io.frames.datasets import Frame
from pointloom.io.frames.depth_cameras import LensMap, recording_path
from pointloom.io.frames.frame_times import MAX_REMARKS, TimeWatch
from pointloom.io.frames.frames import check_frames
from pointloom.io.frames.recordings import FrameRecorder
from pointloom.io.frames.rgbd_sources import RGBDSource

from .camera_stubs import HEIGHT, WIDTH, K4ATimeoutException, KinectStub, RealSenseStub, color_of, depth_of

CAMERA = loom.PinholeCameraIntrinsic(8, 6, 7.0, 7.0, 3.5, 2.5)
DEPTH = np.full((6, 8), 1500, np.uint16)
COLOR = np.full((6, 8, 3), 40, np.uint8)


def stream(*items, **options):
    return loom.frames_from(iter(items), CAMERA, **options)


def test_pairs_triples_and_frames_are_accepted_and_copied():
    depth = DEPTH.copy()
    frames = list(stream((COLOR, depth), (None, depth.astype(np.float32), 2.5)))
    again = list(loom.frames_from(frames, CAMERA))
    depth[:] = 7
    for first, second in (frames, again):
        assert (first.depth == 1500).all() and first.depth.dtype == np.uint16 and (first.color == 40).all()
        assert (second.depth == 1500).all() and second.depth.dtype == np.float32 and second.color is None
        assert (first.timestamp, second.timestamp, first.T_world_camera) == (None, 2.5, None)
    (frame,) = stream((None, np.full(DEPTH.shape, 1.23456789)))
    np.testing.assert_array_equal(frame.depth, loom.RGBDImage(COLOR, np.full(DEPTH.shape, 1.23456789)).depth)
    assert frame.depth.dtype == np.float32


def test_a_list_has_a_length_and_may_be_read_twice_a_generator_neither():
    listed = loom.frames_from([(COLOR, DEPTH)] * 3, CAMERA)
    assert len(listed) == 3 and len(list(listed)) == len(list(listed)) == 3
    once = stream((COLOR, DEPTH))
    assert not hasattr(once, "__len__") and len(list(once)) == 1
    with pytest.raises(ValueError, match="frames:"):
        list(once)


@pytest.mark.parametrize(
    ("item", "error", "message"),
    [
        ((COLOR, DEPTH, np.eye(4)), TypeError, r"got a pose; give poses as SimpleNamespace\(.*T_world_camera="),
        ((COLOR, None), TypeError, "depth"),
        ((COLOR, DEPTH[:5]), ValueError, r"depth: expected shape \[6, 8\].*got \[5, 8\]"),
        ((DEPTH, COLOR), TypeError, "depth: .*got uint8"),
        ((COLOR[:3], DEPTH), ValueError, "color: is 8 x 3, depth 8 x 6.*resize_color=True"),
        ((COLOR[..., 0], DEPTH), ValueError, r"color: expected RGB of shape \[6, 8, 3\]"),
        ((COLOR.astype(np.float32), DEPTH), TypeError, "color: expected uint8"),
        ((COLOR, DEPTH, float("nan")), ValueError, "timestamp"),
        ((COLOR, DEPTH, "noon"), TypeError, "timestamp"),
        (
            SimpleNamespace(color=None, depth=DEPTH, T_world_camera=np.diag([2.0, 2, 2, 1])),
            ValueError,
            "T_world_camera",
        ),
        ((COLOR,), ValueError, r"expected \(color, depth\)"),
        (DEPTH, TypeError, r"expected \(color, depth\) or an object with color and depth"),
    ],
)
def test_a_frame_that_is_none_is_named_and_the_frames_before_it_are_given(item, error, message):
    taken = []
    with pytest.raises(error, match=f"frame-000001.*{message}"):
        for frame in stream((COLOR, DEPTH), item):
            taken.append(frame.name)
    assert taken == ["frame-000000"]


def test_color_of_another_size_is_resized_on_request():
    large = np.repeat(np.repeat(COLOR, 3, axis=0), 3, axis=1)
    large[:3, :3] = 100
    (frame,) = stream((large, DEPTH), resize_color=True)
    assert frame.color.shape == (6, 8, 3) and (frame.color[0, 0] == 100).all() and (frame.color[1:] == 40).all()
    with pytest.raises(ValueError, match="another shape"):
        list(stream((np.zeros((80, 20, 3), np.uint8), DEPTH), resize_color=True))


def test_repeated_reversed_and_jumping_times_are_reported():
    times = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.6, 3.0, 1.0, 1.1]
    source = stream(*((COLOR, DEPTH, t) for t in times))
    assert len(list(source)) == len(times)
    assert source.notes == [
        "frame-000007: its time stamp is equal to that of the frame before it",
        "frame-000008: comes 2.400 s after the frame before it, instead of the usual 0.100 s",
        "frame-000009: its time stamp is 2.000 s before that of the frame before it",
    ]


def test_a_steady_stream_and_one_without_times_cause_no_remarks_and_an_endless_one_no_heap_of_them():
    for times in ([None] * 9, [0.033 * i for i in range(9)], [0, 0.1, 0.3, 0.4, 0.5, 0.7, 0.8, 1.1]):
        source = stream(*((COLOR, DEPTH, t) for t in times))
        list(source)
        assert source.notes == []
    watch = TimeWatch()
    for i in range(3 * MAX_REMARKS):
        watch.see(str(i), 1.0)
    assert (len(watch.notes), watch.count) == (MAX_REMARKS, 3 * MAX_REMARKS - 1)


def test_sources_of_all_kinds_are_rgbd_sources(tmp_path):
    loom.record_frames(stream((COLOR, DEPTH)), tmp_path / "set")
    sequence = room_loop_sequence(2, width=8, height=6)
    for source in (stream((COLOR, DEPTH)), loom.open_frames(tmp_path / "set"), sequence, loom.LatestFrames(sequence)):
        assert isinstance(source, RGBDSource)
    assert not isinstance([(COLOR, DEPTH)], RGBDSource)


def paced(count, gate=None, started=None):
    """Frames whose depth is their number; each waits for the gate."""
    for i in range(count):
        if gate is not None:
            gate.acquire()
        yield None, np.full((6, 8), i, np.uint16), float(i)
    if started is not None:
        started.set()


def test_a_slow_job_gets_the_newest_frame_and_the_others_are_counted():
    gate, done = threading.Semaphore(1), threading.Event()
    latest = loom.LatestFrames(loom.frames_from(paced(10, gate, done), CAMERA))
    frames = iter(latest)
    assert next(frames).timestamp == 0
    gate.release(9)
    assert done.wait(60) and [frame.timestamp for frame in frames] == [9] and latest.dropped == 8
    assert latest.notes == ["8 frames dropped: newer ones came before they were taken"]


def test_a_fast_job_gets_all_frames_once():
    gate = threading.Semaphore(1)
    latest, taken = loom.LatestFrames(loom.frames_from(paced(6, gate), CAMERA)), []
    for frame in latest:
        taken.append(frame.timestamp)
        gate.release()
    assert taken == [0, 1, 2, 3, 4, 5] and (latest.dropped, latest.notes) == (0, [])
    with pytest.raises(ValueError, match="read only once"):
        iter(latest)


def test_source_error_is_raised_after_the_preceding_frames():
    latest, taken = loom.LatestFrames(stream((COLOR, DEPTH), (COLOR, None))), []
    with pytest.raises(TypeError, match="frame-000001: depth"):
        for frame in latest:
            taken.append(frame.name)
    assert taken == ["frame-000000"]


class Live:
    """An endless camera that records whether it was closed."""

    intrinsic, depth_scale, dropped = CAMERA, 1000.0, 3

    def __init__(self):
        self.closed = False

    def __iter__(self):
        while True:
            time.sleep(0.001)
            yield Frame(DEPTH, None, None, "frame")

    def close(self):
        self.closed = True


@pytest.mark.parametrize("ending", [KeyboardInterrupt, ValueError, None])
def test_leaving_the_loop_ends_the_thread_and_closes_the_camera(ending):
    before, camera = threading.active_count(), Live()
    with pytest.raises(ending or StopIteration), loom.LatestFrames(camera) as latest:
        for i, _ in enumerate(latest):
            if i == 3:
                raise ending or StopIteration
    assert camera.closed and threading.active_count() == before
    assert latest.dropped >= 3  # the camera's own


def test_closing_from_another_thread_ends_a_loop_that_waits():
    gate = threading.Semaphore(1)
    latest = loom.LatestFrames(loom.frames_from(paced(10, gate), CAMERA))
    frames = iter(latest)
    next(frames)

    def close():
        latest.close(timeout=0)
        gate.release()

    threading.Timer(0.05, close).start()
    assert list(frames) == []


def test_a_recording_is_the_stream_again(tmp_path):
    room = room_loop_sequence(3, width=32, height=24)
    assert loom.record_frames(room, tmp_path / "set") == 3
    recorded = loom.open_frames(tmp_path / "set")
    assert (recorded.layout, recorded.intrinsic, recorded.depth_scale) == ("7scenes", room.intrinsic, 1000)
    for first, second in zip(room, recorded, strict=True):
        assert np.array_equal(first.depth, second.depth) and np.array_equal(first.color, second.color)
        assert np.array_equal(first.T_world_camera, second.T_world_camera)
        assert (first.name, first.timestamp) == (second.name, second.timestamp)
    assert len(loom.open_dataset(tmp_path / "set")) == 3  # it has poses


def test_recording_keeps_the_depth_unit_and_missing_values_and_rounds_to_millimeters(tmp_path):
    loom.record_frames(stream((None, DEPTH), depth_scale=5000), tmp_path / "set")
    source = loom.open_frames(tmp_path / "set")
    (frame,) = source
    assert source.depth_scale == 5000 and np.array_equal(frame.depth, DEPTH)
    assert (frame.color, frame.T_world_camera, frame.timestamp) == (None, None, None)
    meters = np.full((6, 8), 1.2345, np.float32)
    meters[0, :4] = np.nan, -1, 0, 65.0
    loom.record_frames(stream((None, meters)), tmp_path / "meters")
    (frame,) = loom.open_frames(tmp_path / "meters")
    assert frame.depth[0, :4].tolist() == [0, 0, 0, 65000] and np.abs(frame.depth[1:] / 1000 - 1.2345).max() < 0.000501
    meters[2, 2] = np.inf
    with pytest.raises(ValueError, match=r"frame frame-000000:.*16.*65\.53"):
        loom.record_frames(stream((None, meters)), tmp_path / "too far")


def test_a_recording_can_be_read_after_each_step_of_writing_it(tmp_path, monkeypatch):
    """Regardless of the progress of the second frame, the first is complete."""
    recorder = FrameRecorder(tmp_path / "set", CAMERA)
    frames = list(stream((COLOR, DEPTH, 0.5), (COLOR, DEPTH, 0.6)))
    recorder.write(frames[0])
    steps = []

    def look(write):
        def written(path, array):
            write(path, array)
            steps.append([frame.timestamp for frame in loom.open_frames(tmp_path / "set")])

        return written

    monkeypatch.setattr(recordings, "write_png", look(recordings.write_png))
    recorder.write(frames[1])
    assert steps == [[0.5], [0.5]] and [frame.timestamp for frame in loom.open_frames(tmp_path / "set")] == [0.5, 0.6]
    listing = tmp_path / "set" / FRAME_TIMES
    listing.write_bytes(listing.read_bytes()[:-2])  # the power failed while the line was written
    assert [frame.timestamp for frame in loom.open_frames(tmp_path / "set")] == [0.5]


def test_a_disk_that_fills_up_leaves_the_frames_before_it(tmp_path, monkeypatch):
    recorder = FrameRecorder(tmp_path / "set", CAMERA)
    frames = list(stream((COLOR, DEPTH), (COLOR, DEPTH)))
    recorder.write(frames[0])

    def full(path, array):
        raise loom.FileError(path, "cannot be written: No space left on device")

    write = recordings.write_png
    monkeypatch.setattr(recordings, "write_png", lambda p, a: full(p, a) if "depth" in p.name else write(p, a))
    with pytest.raises(loom.FileError, match=r"/frame-000001\.depth\.png:"):
        recorder.write(frames[1])
    assert recorder.count == 1 and len(loom.open_frames(tmp_path / "set")) == 1
    monkeypatch.setattr(recordings, "write_png", write)
    recorder.write(frames[1])  # space is available again
    assert len(loom.open_frames(tmp_path / "set")) == 2


def test_failed_stream_leaves_a_recording_of_the_received_frames(tmp_path):
    with pytest.raises(TypeError, match="frame-000002"):
        loom.record_frames(stream((COLOR, DEPTH), (COLOR, DEPTH), (COLOR, None)), tmp_path / "set")
    assert len(loom.open_frames(tmp_path / "set")) == 2
    with pytest.raises(ValueError, match="frame frame-000001:"):
        loom.record_frames(stream((COLOR, DEPTH), (None, DEPTH)), tmp_path / "mixed")


def test_a_listed_frame_that_is_gone_is_named_or_skipped(tmp_path):
    loom.record_frames(stream(*[(COLOR, DEPTH)] * 3), tmp_path / "set")
    for path in (tmp_path / "set").glob("frame-000001.*"):
        path.unlink()
    with pytest.raises(DatasetError, match=rf"frame-000001\.depth\.png: missing, although {FRAME_TIMES} lists it"):
        loom.open_frames(tmp_path / "set")
    source = loom.open_frames(tmp_path / "set", skip_missing=True)
    assert len(source) == 2 and len(source.left_out) == 1


@pytest.mark.parametrize("line", ["frame-000000 1", "frame-000001", "image-1 2", "frame-000001 x", "frame-000001 nan"])
def test_a_damaged_list_of_times_is_refused_by_line(tmp_path, line):
    loom.record_frames(stream((COLOR, DEPTH, 0.1)), tmp_path / "set")
    with (tmp_path / "set" / FRAME_TIMES).open("a") as file:
        file.write(line + "\n")
    with pytest.raises(loom.FileError, match=rf"{FRAME_TIMES} \(line 3\)"):
        loom.open_frames(tmp_path / "set")


def test_nonempty_folder_is_not_overwritten(tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(loom.FileError, match=r"notes\.txt"):
        FrameRecorder(tmp_path, CAMERA)
    with pytest.raises(loom.FileError, match="/b:"):
        FrameRecorder(tmp_path / "a" / "b", CAMERA)
    with pytest.raises(loom.FileError, match=r"/notes\.txt: cannot be created: File exists"):
        FrameRecorder(tmp_path / "notes.txt", CAMERA)
    assert [path.name for path in tmp_path.iterdir()] == ["notes.txt"]


def test_objects_that_are_no_frames_or_sources_are_named(tmp_path):
    recorder = FrameRecorder(tmp_path / "set", CAMERA)
    for call, reason in (
        (lambda: recorder.write(DEPTH), "frame: expected a frame of an RGBDSource, got ndarray"),
        (lambda: loom.record_frames([DEPTH], tmp_path / "a"), "source: expected an RGBDSource .*, got list"),
        (lambda: loom.LatestFrames([DEPTH]), "source: expected an RGBDSource .*, got list"),
        (lambda: loom.frames_from("folder", CAMERA), "frames: expected pairs of color and depth to iterate over, got"),
        (lambda: loom.frames_from({"a": DEPTH}, CAMERA), "frames: expected pairs of color and depth to iterate over"),
        (lambda: loom.frames_from(3, CAMERA), "frames: expected pairs of color and depth to iterate over, got 3"),
        (
            lambda: check_frames("frames", [DEPTH]),
            "frames: expected RGB-D frames of one camera, got list; loom.frames_from",
        ),
        (lambda: recording_path(3), "file: expected the path of a recording, got 3"),
    ):
        with pytest.raises(TypeError, match=reason):
            call()
    assert recording_path(None) is None and recording_path(tmp_path) == str(tmp_path)
    shutil.rmtree(tmp_path / "set")
    (tmp_path / "set").mkdir()
    (tmp_path / "set" / FRAME_TIMES).mkdir()
    with pytest.raises(loom.FileError, match=rf"/set/{FRAME_TIMES}: cannot be written: Is a directory"):
        recorder.write(next(iter(stream((COLOR, DEPTH)))))


DRIVEN = loom.PinholeCameraIntrinsic(WIDTH, HEIGHT, 30.0, 30.0, 15.5, 11.5)


def plug_in(monkeypatch, module, make, *arguments, **options):
    stub = make(*arguments, **options)
    monkeypatch.setitem(sys.modules, module, stub)
    return stub


@pytest.fixture
def realsense(monkeypatch):
    return partial(plug_in, monkeypatch, "pyrealsense2", RealSenseStub)


@pytest.fixture
def kinect(monkeypatch):
    return partial(plug_in, monkeypatch, "pyk4a", KinectStub)


def test_missing_driver_is_named_with_its_installation(monkeypatch):
    for module, camera, extra in (
        ("pyrealsense2", loom.RealSenseCamera, "realsense"),
        ("pyk4a", loom.AzureKinectCamera, "azure-kinect"),
    ):
        monkeypatch.setitem(sys.modules, module, None)
        with pytest.raises(CameraError, match=rf"{module}.*pip install \"pointloom\[{extra}\]\""):
            camera()


def take(camera, count):
    return [frame for _, frame in zip(range(count), camera, strict=False)]


def test_realsense_frames_have_calibration_and_time(realsense):
    stub = realsense([1, 2, 3])
    with loom.RealSenseCamera(serial="0123", width=WIDTH, height=HEIGHT, rate=15) as camera:
        assert isinstance(camera, RGBDSource)
        assert (camera.intrinsic, camera.depth_scale) == (DRIVEN, pytest.approx(4000, rel=1e-12))
        frames = take(camera, 3)
    assert not stub.running
    assert stub.calls[:3] == [
        ("enable_device", "0123"),
        ("enable_stream", "depth", WIDTH, HEIGHT, "z16", 15),
        ("enable_stream", "color", WIDTH, HEIGHT, "rgb8", 15),
    ]
    for i, frame in enumerate(frames, 1):
        assert np.array_equal(frame.depth, depth_of(i)) and np.array_equal(frame.color, color_of(i))
        assert frame.timestamp == pytest.approx(0.033 * i) and frame.T_world_camera is None
    assert [frame.name for frame in frames] == ["frame-000000", "frame-000001", "frame-000002"]


def test_frames_without_color_yet_are_passed_over(realsense):
    realsense(["late", 1])
    assert np.array_equal(take(loom.RealSenseCamera(), 1)[0].color, color_of(1))
    realsense(["late"])
    frame = take(loom.RealSenseCamera(color=False), 1)[0]
    assert frame.color is None and np.array_equal(frame.depth, depth_of(0))


def test_each_depth_map_is_paired_once_with_the_closest_color(realsense):
    """As from the driver: an image is repeated while it waits for the other camera."""
    realsense([(1, 1), (2, 1), (2, 2), (3, 2), (4, 3), (4, 4), (5, 5)])
    camera = loom.RealSenseCamera()
    pairs = [(frame.depth[0, 0] - 1000, frame.color[0, 0, 2]) for frame in take(camera, 5)]
    assert pairs == [(1, 1), (2, 2), (3, 2), (4, 4), (5, 5)] and (camera.dropped, camera.notes) == (0, [])


def test_a_frame_that_waits_for_its_color_is_not_lost_and_those_lost_by_the_driver_are_counted(realsense):
    realsense([1, (2, 1), RuntimeError("Device disconnected")])
    times = []
    with pytest.raises(CameraError, match="stopped after 2 frames: Device disconnected"):
        times.extend(frame.timestamp for frame in loom.RealSenseCamera())
    realsense([1, (2, 1)])
    assert len(list(loom.RealSenseCamera(file="walk.bag"))) == 2
    realsense([1, 2, 7, 8])
    camera = loom.RealSenseCamera()
    take(camera, 4)
    assert (camera.count, camera.dropped) == (4, 4)
    assert camera.notes == ["4 frames were lost before they reached the program"]


@pytest.mark.parametrize("last", ["silence", RuntimeError("Device disconnected")])
def test_realsense_failure_is_reported_after_the_last_complete_frame(realsense, last):
    stub = realsense([1, 2, last])
    camera, frames = loom.RealSenseCamera(timeout=0.5), []
    with pytest.raises(CameraError, match=r"nothing for 0.5 s after 2 frames|after 2 frames: Device disconn"), camera:
        for frame in camera:
            frames.append(frame)
    assert len(frames) == 2 and np.array_equal(frames[0].depth, depth_of(1))
    assert ("wait", 500) in stub.calls and not stub.running


def test_a_missing_realsense_and_a_lens_of_an_unknown_kind_are_refused(realsense):
    realsense([], start_error=RuntimeError("No device connected"))
    with pytest.raises(CameraError, match=r"No device connected\. Check the cable"):
        loom.RealSenseCamera()
    stub = realsense([1], model="ftheta", coefficients=(0.1, 0, 0, 0, 0))
    with pytest.raises(CameraError, match="ftheta"):
        loom.RealSenseCamera()
    assert not stub.running


@pytest.mark.parametrize("jpeg", [False, True])
def test_frames_of_a_kinect_recording_have_calibration_and_time(kinect, jpeg):
    stub = kinect(["late", 1, 2], jpeg=jpeg)
    with loom.AzureKinectCamera(file="walk.mkv") as camera:
        assert (camera.intrinsic, camera.depth_scale) == (DRIVEN, 1000.0)
        frames = list(camera)
    assert stub.calls == ["walk.mkv"] and not stub.running
    assert [frame.timestamp for frame in frames] == pytest.approx([0.033, 0.066])
    for i, frame in enumerate(frames, 1):
        assert np.array_equal(frame.depth, depth_of(i))
        assert np.abs(frame.color.astype(int) - color_of(i)).max() <= (12 if jpeg else 0)


def test_kinect_failure_is_reported_after_the_last_complete_frame(kinect):
    stub = kinect([1, 2, "silence"])
    camera, frames = loom.AzureKinectCamera(number=1), []
    assert stub.calls[0][1] == 1 and stub.calls[0][0]["synchronized_images_only"]
    with pytest.raises(CameraError, match="stopped after 2 frames: K4ATimeoutException"), camera:
        for frame in camera:
            frames.append(frame)
    assert len(frames) == 2 and not stub.running


def test_a_kinect_that_is_not_there_is_an_error(kinect):
    kinect([], start_error=K4ATimeoutException())
    with pytest.raises(CameraError, match="no Azure Kinect 0 can be opened"):
        loom.AzureKinectCamera()
    kinect([])
    with pytest.raises(CameraError, match="contains no frame"):
        loom.AzureKinectCamera(file="empty.mkv")


def lens_of(k) -> loom.CameraModel:
    """The camera of `bent_scene` with OpenCV's coefficients."""
    return loom.CameraModel("FULL_OPENCV", 160, 120, [140.0, 140.0, 80.5, 59.5, *k, *[0.0] * (8 - len(k))])


def bent_scene(lens_coefficients):
    """Depth and color of a plane through a lens, and through a pinhole, at 160 x 120."""
    camera = loom.PinholeCameraIntrinsic(160, 120, 140.0, 140.0, 80.0, 59.0)
    v, u = np.mgrid[:120, :160].astype(float)
    x, y = (u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy
    pixels = np.stack([u.ravel(), v.ravel()], axis=1)
    ideal = lens_of(lens_coefficients).unproject(pixels)[:, :2].T.reshape(2, 120, 160)

    def scene(a, b):
        return (2000 + 400 * a + 300 * b).astype(np.uint16), (127 + 80 * np.sin(6 * a) * np.cos(5 * b)).astype(np.uint8)

    return camera, scene(*ideal), scene(x, y)


@pytest.mark.parametrize("lens", [(0.12, -0.2, 0.001, -0.002, 0.05), (0.5, -2.5, 3e-4, 1e-4, 1.5, 0.4, -2.3, 1.4)])
def test_depth_and_color_are_undistorted(lens):
    camera, (depth, gray), (straight_depth, straight_gray) = bent_scene(lens)
    lens = LensMap(camera, lens)
    assert lens.shift > 0.3
    got, color = lens.straighten_depth(depth), lens.straighten_color(np.dstack([gray] * 3))
    valid = got > 0
    assert valid.mean() > 0.9
    assert np.abs(got.astype(int) - straight_depth)[valid].max() <= 3  # half a pixel of slope
    assert np.abs(color[..., 1].astype(int) - straight_gray)[valid].max() <= 3


def test_inverse_distortion_inverts_the_model():
    camera = loom.PinholeCameraIntrinsic(160, 120, 140.0, 140.0, 80.0, 59.0)
    k = (0.1, -0.1, 0.001, 0.001, 0.02)
    lens = LensMap(camera, k, inverse=True)
    rays = (np.stack(lens.positions, axis=2) - [camera.cx, camera.cy]) / 140.0
    back = lens_of(k).project(np.insert(rays.reshape(-1, 2), 2, 1.0, axis=1))
    assert np.abs(back - np.stack(np.mgrid[:120, :160][::-1], axis=2).reshape(-1, 2)).max() < 1e-6


def test_frames_of_a_distorting_camera_are_undistorted(kinect):
    kinect([1], coefficients=(0.3, -0.1, 0, 0, 0, 0, 0, 0))
    camera = loom.AzureKinectCamera(file="walk.mkv")
    frame = next(iter(camera))
    expected = LensMap(DRIVEN, (0.3, -0.1, 0, 0, 0, 0, 0, 0))
    assert np.array_equal(frame.depth, expected.straighten_depth(depth_of(1)))
    assert np.array_equal(frame.color, expected.straighten_color(color_of(1)))
    assert not np.array_equal(frame.depth, depth_of(1))
