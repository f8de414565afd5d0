"""RealSense cameras and recordings, with pyrealsense2."""

from __future__ import annotations

from types import ModuleType
from typing import Any

import numpy as np

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_count, check_name
from ...core.errors import CameraError, FilePath
from .depth_cameras import DepthCamera, import_driver, recording_path

MAX_TIME_DIFFERENCE = 0.017  # [s] maximum difference of depth and color: half the frame time

POLL_SECONDS = 0.1  # [s] between checks for the end of a recording


class RealSenseCamera(DepthCamera):
    """Frames of a RealSense camera, depth registered to color. Requires `pointloom[realsense]`.

    Tested with a driver stub and on a recording of pyrealsense2's software device, not on a camera.

    Args:
        serial: Serial number. None takes the first camera.
        file: A recording (.bag or, since 2.58, .db3) to play back, each frame once, instead of a camera.
        width, height: Image size [px]. A recording has its own.
        rate: Frames per second. A recording has its own.
        color: With color. Else depth alone, in the geometry of the depth camera.
        timeout: Maximum time to wait for a frame [s].

    Raises:
        CameraError: The package, camera or recording is missing; while iterating, a camera that is disconnected or
            sends nothing. Earlier frames stay valid.
        TypeError, ValueError: Sizes or times out of range.

    Notes:
        Images are undistorted with the camera's calibration, depth by nearest pixel.

    Example:
        >>> import pointloom as loom
        >>> with loom.LatestFrames(loom.RealSenseCamera()) as frames:  # doctest: +SKIP
        ...     for frame in frames:
        ...         print(frame.timestamp)
    """

    name = "the RealSense camera"

    def __init__(
        self,
        *,
        serial: str | None = None,
        file: FilePath | None = None,
        width: int = 640,
        height: int = 480,
        rate: int = 30,
        color: bool = True,
        timeout: float = 5.0,
    ):
        super().__init__(timeout)
        serial = None if serial is None else check_name("serial", serial)
        path = recording_path(file)
        size = check_count("width", width), check_count("height", height)
        rate, self._colored, self._playback = check_count("rate", rate), bool(color), None
        rs = self._driver = import_driver("pyrealsense2", "a RealSense camera", "realsense")
        remedy = "Check the cable, that no other program has it, and the size and rate that it offers"
        what = f"the recording {path} cannot be played" if path else "no RealSense camera can be opened"
        with self._opening(what, "Check that the recording is complete and of this driver version" if path else remedy):
            config = rs.config()
            if path is not None:
                config.enable_device_from_file(path, False)
                size, rate = (), 0
            elif serial is not None:
                config.enable_device(serial)
            config.enable_stream(rs.stream.depth, *size, rs.format.z16, rate)
            if self._colored:
                config.enable_stream(rs.stream.color, *size, rs.format.rgb8, rate)
            self._pipeline = rs.pipeline()
            profile = self._pipeline.start(config)
            self._open = True
            if path is not None:
                self._playback = profile.get_device().as_playback()
                self._playback.set_real_time(False)
            self._read_calibration(rs, profile)
        self._align = rs.align(rs.stream.color) if self._colored else None
        self._number: int | None = None
        self._pending: tuple[Any, Any, float, Any] | Exception | None = None

    def _read_calibration(self, rs: ModuleType, profile: Any) -> None:
        stream = profile.get_stream(rs.stream.color if self._colored else rs.stream.depth)
        lens = stream.as_video_stream_profile().get_intrinsics()
        self.intrinsic = PinholeCameraIntrinsic(lens.width, lens.height, lens.fx, lens.fy, lens.ppx, lens.ppy)
        unit = np.float32(profile.get_device().first_depth_sensor().get_depth_scale())
        self.depth_scale = 1.0 / float(str(unit))  # 0.001 m as intended, not the nearest float32
        models = {rs.distortion.brown_conrady: False, rs.distortion.inverse_brown_conrady: True}
        if lens.model in models:
            self._use_lens(lens.coeffs, inverse=models[lens.model])
        elif np.any(lens.coeffs):
            raise CameraError(f"{self.name} has an unknown lens model, {lens.model}; its images would be distorted")

    def _take(self) -> tuple[Any, Any, float] | None:
        while True:
            frame_set, self._pending = self._pending or self._next_set(), None
            if isinstance(frame_set, Exception):
                raise frame_set
            if frame_set is None:
                return None
            depth, color, apart, frames = frame_set
            number = depth.get_frame_number()
            if number == self._number:
                continue  # already delivered with a color closer in time
            if apart > MAX_TIME_DIFFERENCE:  # the driver repeats an image while it waits for the other camera
                self._pending = self._look_ahead()
                ahead = self._pending
                if isinstance(ahead, tuple) and ahead[0].get_frame_number() == number and ahead[2] < apart:
                    continue
            if self._number is not None and number > self._number + 1:
                self.dropped += number - self._number - 1
            self._number = number
            if self._align is not None:
                aligned = self._align.process(frames)
                depth, color = aligned.get_depth_frame(), aligned.get_color_frame()
            image = None if color is None else np.asanyarray(color.get_data())
            return np.asanyarray(depth.get_data()), image, depth.get_timestamp() / 1000

    def _look_ahead(self) -> tuple[Any, Any, float, Any] | Exception | None:
        """The next frame set, or its error, so that the frame before it is delivered first."""
        try:
            return self._next_set()
        except Exception as error:
            return error

    def _next_set(self) -> tuple[Any, Any, float, Any] | None:
        """Depth, color, their time difference [s], and the frame set. None at the end of a recording."""
        waited = 0.0
        while True:
            timeout = min(POLL_SECONDS, self.timeout - waited) if self._playback is not None else self.timeout
            came, frames = self._pipeline.try_wait_for_frames(max(int(1000 * timeout), 1))
            if came:
                waited = 0.0
                depth, color = frames.get_depth_frame(), frames.get_color_frame() if self._colored else None
                if depth and (color or not self._colored):
                    frames.keep()
                    apart = 0.0 if color is None else abs(color.get_timestamp() - depth.get_timestamp()) / 1000
                    return depth, color, apart, frames
                continue  # one of the two is late, as in a camera's first frames
            if self._ended():
                return None
            waited += timeout
            if waited >= self.timeout:
                raise CameraError(f"{self.name} sent nothing for {self.timeout:g} s after {self.count} frames")

    def _ended(self) -> bool:
        return self._playback is not None and self._playback.current_status() == self._driver.playback_status.stopped

    def _stop(self) -> None:
        self._pipeline.stop()
