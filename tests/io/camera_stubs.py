"""Stubs of depth camera drivers: modules with the functions that the adapters call, with synthetic frames.

Names, arguments and units are those of pyrealsense2 2.59 and pyk4a 1.5; `calls` records the calls.
"""

import io
from types import SimpleNamespace

import numpy as np
from PIL import Image

WIDTH, HEIGHT = 32, 24
UNIT = np.float32(0.00025)  # [m] of the RealSense


def depth_of(i: int) -> np.ndarray:
    return (1000 + i + np.arange(HEIGHT * WIDTH).reshape(HEIGHT, WIDTH)).astype(np.uint16)


def color_of(i: int) -> np.ndarray:
    v, u = np.mgrid[:HEIGHT, :WIDTH]
    return np.stack([u * 7, v * 9, np.full_like(u, i)], axis=2).astype(np.uint8)


class Stub:
    """A driver that raises `start_error` when it is started, or is stopped once."""

    def _start(self):
        if self.start_error:
            raise self.start_error
        self.running = True

    def _stop(self):
        assert self.running
        self.running = False


class RealSenseStub(Stub):
    """The used part of pyrealsense2.

    Args:
        frames: A number is a frame with that number, a pair has color with another number, "late" is a frame without
            color, "silence" a timeout, and an error is raised.
        coefficients, model: Of the lens.
    """

    def __init__(self, frames, *, coefficients=(0, 0, 0, 0, 0), model="brown_conrady", start_error=None, in_file=False):
        self.stream = SimpleNamespace(depth="depth", color="color")
        self.format = SimpleNamespace(z16="z16", rgb8="rgb8")
        self.playback_status = SimpleNamespace(stopped="stopped", playing="playing")
        names = ("none", "brown_conrady", "inverse_brown_conrady", "ftheta")
        self.distortion = SimpleNamespace(**{name: name for name in names})
        self.frames, self.lens, self.start_error = list(frames), (model, coefficients), start_error
        self.calls, self.running = [], False

    def config(self):
        def note(name):
            return lambda *arguments: self.calls.append((name, *arguments))

        return SimpleNamespace(**{n: note(n) for n in ("enable_stream", "enable_device", "enable_device_from_file")})

    def align(self, stream):
        assert stream == "color"
        return SimpleNamespace(process=lambda frames: frames)

    def pipeline(self):
        return SimpleNamespace(start=self._start_pipeline, stop=self._stop, try_wait_for_frames=self._wait)

    def _start_pipeline(self, config):
        self._start()
        sensor = SimpleNamespace(get_depth_scale=lambda: float(UNIT))
        playback = SimpleNamespace(
            set_real_time=lambda real: self.calls.append(("set_real_time", real)),
            current_status=lambda: "playing" if self.frames else "stopped",
        )
        device = SimpleNamespace(first_depth_sensor=lambda: sensor, as_playback=lambda: playback)
        model, coefficients = self.lens
        numbers = {"fx": 30.0, "fy": 30.0, "ppx": 15.5, "ppy": 11.5, "coeffs": list(coefficients)}
        lens = SimpleNamespace(width=WIDTH, height=HEIGHT, model=model, **numbers)
        stream = SimpleNamespace(as_video_stream_profile=lambda: SimpleNamespace(get_intrinsics=lambda: lens))
        return SimpleNamespace(get_device=lambda: device, get_stream=lambda kind: stream)

    def _wait(self, timeout_ms):
        assert self.running
        self.calls.append(("wait", timeout_ms))
        if not self.frames:
            return False, None
        frame = self.frames.pop(0)
        if isinstance(frame, Exception):
            raise frame
        if frame == "silence":
            return False, None
        number, other = frame if isinstance(frame, tuple) else (0, 0) if frame == "late" else (frame, frame)
        depth = SimpleNamespace(get_data=lambda: depth_of(number), get_timestamp=lambda: 33.0 * number)
        depth.get_frame_number = lambda: number
        color = SimpleNamespace(get_data=lambda: color_of(other), get_timestamp=lambda: 33.0 * other)
        color = None if frame == "late" else color
        return True, SimpleNamespace(get_depth_frame=lambda: depth, get_color_frame=lambda: color, keep=lambda: None)


class K4ATimeoutException(Exception):  # noqa: N818
    """As in pyk4a: raised without a message."""


class KinectStub(Stub):
    """The used part of pyk4a; `frames` as in `RealSenseStub`, with "silence" for a timeout."""

    def __init__(self, frames, *, coefficients=(0,) * 8, start_error=None, jpeg=False):
        self.frames, self.coefficients, self.start_error, self.jpeg = list(frames), coefficients, start_error, jpeg
        self.calls, self.running = [], False
        self.ColorResolution, self.ImageFormat = SimpleNamespace(RES_720P=1), SimpleNamespace(COLOR_BGRA32=3)
        self.DepthMode, self.FPS = SimpleNamespace(NFOV_UNBINNED=2), SimpleNamespace(FPS_30=2)
        self.CalibrationType = SimpleNamespace(COLOR=1, DEPTH=0)
        self.calibration = SimpleNamespace(
            get_camera_matrix=lambda kind: np.array([[30.0, 0, 15.5], [0, 30, 11.5], [0, 0, 1]]),
            get_distortion_coefficients=lambda kind: np.array(self.coefficients, float),
        )

    def Config(self, **options):
        return options

    def PyK4A(self, config, device_id):
        self.calls.append((config, device_id))
        calls = {"start": self._start, "stop": self._stop, "get_capture": self._capture}
        return SimpleNamespace(**calls, calibration=self.calibration)

    def PyK4APlayback(self, path):
        self.calls.append(path)
        calls = {"open": self._start, "close": self._stop, "get_next_capture": self._next}
        return SimpleNamespace(**calls, calibration=self.calibration)

    def _next(self):
        if not self.frames:
            raise EOFError
        return self._capture(timeout=None)

    def _capture(self, timeout):
        if not self.frames:
            raise K4ATimeoutException
        frame = self.frames.pop(0)
        if isinstance(frame, Exception):
            raise frame
        if frame == "silence":
            raise K4ATimeoutException
        number = 0 if frame == "late" else frame
        color = np.dstack([color_of(number)[:, :, ::-1], np.full((HEIGHT, WIDTH), 255, np.uint8)])
        if self.jpeg:
            file = io.BytesIO()
            Image.fromarray(color_of(number)).save(file, "JPEG", quality=95)
            color = np.frombuffer(file.getvalue(), np.uint8)
        depth = {"depth": depth_of(number), "transformed_depth": depth_of(number)}
        return SimpleNamespace(**depth, color=None if frame == "late" else color, depth_timestamp_usec=33_000 * number)
