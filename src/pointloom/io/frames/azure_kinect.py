"""Azure Kinect cameras and recordings (.mkv), with pyk4a."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_count
from ...core.errors import CameraError, FilePath
from ..images.image_files import decode_texture
from .depth_cameras import DepthCamera, import_driver, recording_path


class AzureKinectCamera(DepthCamera):
    """Frames of an Azure Kinect, depth registered to color. Requires `pointloom[azure-kinect]` and Microsoft's SDK.

    Color 1280 x 720, depth in narrow unbinned mode, 30 frames per second. Tested with a driver stub, not on a camera.

    Args:
        number: Index of the camera, from 0.
        file: A recording (.mkv) to play back instead, with BGRA or MJPG color.
        timeout: Maximum time to wait for a frame [s].

    Raises:
        CameraError: The package, camera or recording is missing; while iterating, a camera that is disconnected or
            sends nothing. Earlier frames stay valid.
        TypeError, ValueError: A number or time out of range.

    Notes:
        Depth is in millimeters. Images are undistorted with the camera's calibration, depth by nearest pixel.

    Example:
        >>> import pointloom as loom
        >>> with loom.LatestFrames(loom.AzureKinectCamera()) as frames:  # doctest: +SKIP
        ...     for frame in frames:
        ...         print(frame.timestamp)
    """

    name = "the Azure Kinect"
    depth_scale = 1000.0

    def __init__(self, *, number: int = 0, file: FilePath | None = None, timeout: float = 5.0):
        super().__init__(timeout)
        number, path = check_count("number", number, minimum=0), recording_path(file)
        k4a = self._driver = import_driver("pyk4a", "an Azure Kinect", "azure-kinect")
        what = f"the recording {path} cannot be played" if path else f"no Azure Kinect {number} can be opened"
        remedy = "Check that it is a complete .mkv" if path else "Check both cables and that no other program has it"
        self._playing = path is not None
        with self._opening(what, remedy):
            if path is not None:
                self._device = k4a.PyK4APlayback(path)
                self._device.open()
            else:
                config = k4a.Config(
                    color_resolution=k4a.ColorResolution.RES_720P,
                    color_format=k4a.ImageFormat.COLOR_BGRA32,
                    depth_mode=k4a.DepthMode.NFOV_UNBINNED,
                    camera_fps=k4a.FPS.FPS_30,
                    synchronized_images_only=True,
                )
                self._device = k4a.PyK4A(config, device_id=number)
                self._device.start()
            self._open = True
            self._first = self._next_complete()
            if self._first is None:
                raise CameraError(f"{what}: it contains no frame with depth and color")
            height, width = self._color_of(self._first).shape[:2]
            kind = k4a.CalibrationType.COLOR
            self.intrinsic = PinholeCameraIntrinsic.from_matrix(
                np.asarray(self._device.calibration.get_camera_matrix(kind), np.float64), width, height
            )
            self._use_lens(np.ravel(self._device.calibration.get_distortion_coefficients(kind)))

    def _next_complete(self) -> Any:
        """The next capture with depth and color. None at the end of a recording."""
        while True:
            if self._playing:
                try:
                    capture = self._device.get_next_capture()
                except EOFError:
                    return None
            else:
                capture = self._device.get_capture(timeout=int(1000 * self.timeout))
            if capture.depth is not None and capture.color is not None:
                return capture

    def _take(self) -> tuple[Any, Any, float] | None:
        capture, self._first = self._first or self._next_complete(), None
        if capture is None:
            return None
        return capture.transformed_depth, self._color_of(capture), capture.depth_timestamp_usec * 1e-6

    def _color_of(self, capture: Any) -> NDArray[np.uint8]:
        """RGB of a capture. Its color is BGRA or, in most recordings, JPEG bytes."""
        color = np.asarray(capture.color)
        if color.ndim == 1 and color.dtype == np.uint8:
            return decode_texture(f"color of frame {self.count}", color.tobytes())
        if color.ndim != 3 or color.shape[2] != 4:
            raise CameraError(f"its color is neither BGRA nor MJPG but of shape {list(color.shape)}")
        return color[:, :, 2::-1]

    def _stop(self) -> None:
        self._device.close() if self._playing else self._device.stop()
