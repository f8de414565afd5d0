"""Per-frame parameters on the device (poses, box, number), read by recorded launches."""

import numpy as np

from ..array_types import Device
from ..lang import array, float64, func, int32, mat33d, vec3d
from ..memory import Readback, write, zeros

INTO_VOLUME, INTO_CAMERA = 0, 12  # offsets in a record: a rotation by rows, then a translation
BOX_LOW, BOX_SIZE = 24, 27  # the frame's box in blocks
CHANGE_NUMBER = 30  # number of the frame among the changes of its blocks
RECORD_LENGTH = 31
COUNTED_INDEX, TOUCHED_INDEX, MISSING_INDEX = 0, 1, 2  # indices of counts


class FrameRecord:
    """Record of the current frame: `values` float64, and `counts` int32 [3] of valid, touched and missing blocks."""

    def __init__(self, device: Device, counted: int = 0) -> None:
        self.values, self.counts = zeros(RECORD_LENGTH, float64, device), zeros(3, int32, device)
        self._host = np.zeros(RECORD_LENGTH)  # next record to write. Offsets of both poses
        self._poses = [
            (self._host[at : at + 9].reshape(3, 3), self._host[at + 9 : at + 12]) for at in (INTO_VOLUME, INTO_CAMERA)
        ]
        self.readback = Readback(self.counts)
        if counted:
            self.write_counts(counted, 0, 0)

    def write(
        self, T_volume_camera: np.ndarray, T_camera_volume: np.ndarray, low: np.ndarray, size: np.ndarray, number: int
    ) -> None:
        write(self.values, self.numbers_of(T_volume_camera, T_camera_volume, low, size, number))

    def numbers_of(
        self, T_volume_camera: np.ndarray, T_camera_volume: np.ndarray, low: np.ndarray, size: np.ndarray, number: int
    ) -> np.ndarray:
        """The values of a record, valid until the next call."""
        for (rotation, translation), T in zip(self._poses, (T_volume_camera, T_camera_volume), strict=True):
            rotation[:], translation[:] = T[:3, :3], T[:3, 3]
        host = self._host
        host[BOX_LOW:BOX_SIZE], host[BOX_SIZE:CHANGE_NUMBER], host[CHANGE_NUMBER] = low, size, number
        return host

    def write_counts(self, counted: int, touched: int, missing: int) -> None:
        write(self.counts, np.array([counted, touched, missing], np.int32))


class FrameCounts:
    """Numbers of touched and valid blocks after a frame. Waits for the device on first use."""

    def __init__(self, record: FrameRecord) -> None:
        self._record, self._counts = record, None

    def read_counts(self) -> tuple[int, int]:
        """Read the numbers (sync) before the next frame overwrites them."""
        if self._counts is None:
            counts = self._record.readback.read()
            self._counts = int(counts[COUNTED_INDEX]), int(counts[TOUCHED_INDEX])
        return self._counts

    @property
    def counted(self) -> int:
        return self.read_counts()[0]

    @property
    def touched(self) -> int:
        return self.read_counts()[1]


class FrameTouches:
    """Numbers of touched blocks of frames integrated together. Waits for the device on first use."""

    def __init__(self, readback: Readback) -> None:
        self._readback, self._touched = readback, None

    def read(self) -> list[int]:
        """Read the numbers (sync) before the next frames overwrite them."""
        if self._touched is None:
            self._touched = self._readback.read().tolist()
        return self._touched


class TouchesOfFrame:
    """`touched` of one frame of FrameTouches."""

    def __init__(self, touches: FrameTouches, frame: int) -> None:
        self._touches, self._frame = touches, frame

    @property
    def touched(self) -> int:
        return self._touches.read()[self._frame]


@func
def recorded_rotation(record: array(dtype=float64), at: int) -> mat33d:
    return mat33d(
        record[at],
        record[at + 1],
        record[at + 2],
        record[at + 3],
        record[at + 4],
        record[at + 5],
        record[at + 6],
        record[at + 7],
        record[at + 8],
    )


@func
def recorded_translation(record: array(dtype=float64), at: int) -> vec3d:
    return vec3d(record[at + 9], record[at + 10], record[at + 11])
