"""RealSense cameras and their recordings (.bag), through Intel's pyrealsense2."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from ..camera import PinholeCameraIntrinsic
from ..checks import check_count, check_name
from ..errors import CameraError
from .depth_cameras import DepthCamera, import_driver


class RealSenseCamera(DepthCamera):
    """Frames of a RealSense camera, depth registered to colour; needs `pointloom[realsense]`.

    Tested against a stub of the driver, its names against pyrealsense2 2.59; not run on a camera here.

    Args:
        serial: Which camera; None takes the first.
        file: A recording (.bag) to play back, each frame once, instead of a camera.
        width, height: Size of the pictures [px]; a recording has its own.
        rate: Frames a second; a recording has its own.
        color: With colour; else depth alone, in the geometry of the depth camera.
        timeout: How long to wait for a frame [s].

    Raises:
        CameraError: The package is missing, no such camera or recording; while iterating, a camera that is pulled out
            or sends nothing. Frames before that were whole and stay with whoever took them.
        TypeError, ValueError: Sizes or times out of range.

    Notes:
        The distortion that the camera reports is taken out; depth takes the nearest pixel.

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
        file: str | os.PathLike[str] | None = None,
        width: int = 640,
        height: int = 480,
        rate: int = 30,
        color: bool = True,
        timeout: float = 5.0,
    ):
        super().__init__(timeout)
        serial = None if serial is None else check_name("serial", serial)
        path = None if file is None else os.fspath(file)
        size = check_count("width", width), check_count("height", height)
        rate, self._colored, self._playback = check_count("rate", rate), bool(color), None
        rs = self._driver = import_driver("pyrealsense2", "a RealSense camera", "realsense")
        remedy = "Check the cable, that no other program has it, and the size and rate that it offers"
        what = f"the recording {path} cannot be played" if path else "no RealSense camera can be opened"
        with self._opening(what, "Is it a whole .bag?" if path else remedy):
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

    def _read_calibration(self, rs: Any, profile: Any) -> None:
        stream = profile.get_stream(rs.stream.color if self._colored else rs.stream.depth)
        lens = stream.as_video_stream_profile().get_intrinsics()
        self.intrinsic = PinholeCameraIntrinsic(lens.width, lens.height, lens.fx, lens.fy, lens.ppx, lens.ppy)
        unit = np.float32(profile.get_device().first_depth_sensor().get_depth_scale())
        self.depth_scale = 1.0 / float(str(unit))  # 0.001 m as it was meant, not as the nearest float32
        models = {rs.distortion.brown_conrady: False, rs.distortion.inverse_brown_conrady: True}
        if lens.model in models:
            self._use_lens(lens.coeffs, inverse=models[lens.model])
        elif np.any(lens.coeffs):
            raise CameraError(f"{self.name} has a lens of an unknown kind, {lens.model}; its pictures would be bent")

    def _take(self) -> tuple[Any, Any, float] | None:
        while True:
            came, frames = self._pipeline.try_wait_for_frames(int(1000 * self.timeout))
            if not came:
                if self._ended():
                    return None
                raise CameraError(f"{self.name} sent nothing for {self.timeout:g} s after {self.count} frames")
            frames = frames if self._align is None else self._align.process(frames)
            depth, color = frames.get_depth_frame(), frames.get_color_frame() if self._colored else None
            if depth and (color or not self._colored):
                break  # else one of the two is late, as with the first frames of a camera
        number = depth.get_frame_number()
        if self._number is not None and number > self._number + 1:
            self.dropped += number - self._number - 1
        self._number = number
        picture = None if color is None else np.asanyarray(color.get_data())
        return np.asanyarray(depth.get_data()), picture, depth.get_timestamp() / 1000

    def _ended(self) -> bool:
        """Whether a recording has been played to its end."""
        return self._playback is not None and self._playback.current_status() == self._driver.playback_status.stopped

    def _stop(self) -> None:
        self._pipeline.stop()
