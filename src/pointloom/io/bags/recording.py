"""Recordings of ROS 1, ROS 2 and MCAP: `open_recording`."""

from __future__ import annotations

import struct
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic, check_camera, is_one_camera
from ...cameras.imu_readings import ImuReadings
from ...cameras.trajectory import Trajectory
from ...core.array_libraries import library_for
from ...core.atomic import restore_folder
from ...core.checks import check_count, check_name, check_positive
from ...core.devices import DeviceLike
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.paths import IN_FOLDERS, RECORDINGS, path_of
from ...core.units import warn_of_units
from ...kernels.lru_cache import LruCache
from ...pcd.cloud import PointCloud
from ..file_formats import listed
from ..optional_imports import foreign_errors, import_for
from ..points.point_cloud import cloud_of
from ..points.scan_files import natural_key
from .bag1 import read_bag1
from .clouds import LIVOX, table_of_livox, table_of_message
from .db3 import read_db3
from .mcap import read_mcap
from .message_chunks import Contents, RecordingWarning, byte_order
from .motions import IMU, POSES, imu_of_messages, trajectory_of_messages
from .recorded_frames import RecordedFrames, choose_images
from .transforms import TRANSFORMS, RecordedTransforms, transforms_of_messages

CLOUD = "sensor_msgs/msg/PointCloud2"
_READERS: dict[str, Callable[[Path], Any]] = dict(zip(RECORDINGS, (read_bag1, read_mcap, read_db3), strict=True))
_MAX_CHUNKS, _MAX_BYTES = 4, 1 << 28  # cached unpacked chunks: those of a recording overlap little in time


@dataclass(frozen=True)
class Topic:
    """A topic of a recording.

    Attributes:
        name, type: Its name and message type.
        count: Number of messages.
        first, last: Times of the first and last message [s]. None without messages.
        frame_id: Frame of the first message, if its type has a header.
    """

    name: str
    type: str
    count: int
    first: float | None
    last: float | None
    frame_id: str | None


@dataclass(frozen=True, eq=False)
class RecordedMessage:
    """A recorded message: `topic`, `time` [s] and the decoded `content`, an object of `rosbags`.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.io.bags.recording import RecordedMessage
        >>> RecordedMessage("/points", 12.5, None).time
        12.5
    """

    topic: str
    time: float
    content: Any


class Recording:
    """A recording opened by `open_recording`.

    Attributes:
        path: The file or folder.
        damage: A sentence on missing data, or None.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.io.bags.recording import Recording
        >>> def spans(recording: Recording) -> dict[str, float]:
        ...     return {topic.name: topic.last - topic.first for topic in recording.topics if topic.count}
    """

    def __init__(self, path: Path, parts: list[Contents]):
        self.path, self._parts = path, parts
        for part in parts:
            if orphans := sum(entry[1] not in part.channels for entry in part.entries):
                part.note(f"has {orphans} messages of no topic, which were left out")
        self.damage = "; ".join(f"{part.path.name} {part.damage}" for part in parts if part.damage) or None
        rows = [(time, n, c, p, at) for n, part in enumerate(parts) for time, c, p, at in part.entries
                if c in part.channels]  # fmt: skip
        self._rows = sorted(rows, key=lambda row: row[0])
        self._chunks: LruCache[bytes] = LruCache(_MAX_BYTES)
        self._stores: dict[str, Any] = {}

    def __len__(self) -> int:
        return len(self._rows)

    def __repr__(self) -> str:
        return f"Recording({escaped(self.path.name)}, {len(self.topics)} topics, {len(self)} messages)"

    @cached_property
    def topics(self) -> list[Topic]:
        """All topics, sorted by name."""
        kinds = {channel.topic: channel.type for part in self._parts for channel in part.channels.values()}
        seen: dict[str, list[tuple[int, int, int, int, int]]] = {name: [] for name in kinds}
        for row in self._rows:
            seen[self._parts[row[1]].channels[row[2]].topic].append(row)
        return [self._topic(name, kinds[name], seen[name]) for name in sorted(kinds)]

    def messages(self, topic: str) -> Iterator[RecordedMessage]:
        """Iterate over the messages of a topic in time order, read lazily.

        Raises:
            ValueError: No such topic.
            FileError: A damaged message, with the number of messages before it, or an unknown type.
        """
        names = [info.name for info in self.topics]
        if topic not in names:
            raise ValueError(escaped(f"topic: {self.path} has no {topic!r}; there are {', '.join(names) or 'none'}"))
        return self._messages(topic)

    def choose_topic(self, topic: str | None, *kinds: str) -> str:
        """The given topic, or the only topic of these types. Raises `FileError` if none or several match."""
        types = kinds or (CLOUD, *LIVOX)
        kind = types[0]
        fitting = [name for name, info in self.topic_types().items() if info in types]
        if topic is None and len(fitting) == 1:
            return fitting[0]
        if topic in fitting:
            return str(topic)
        every = ", ".join(f"{info.name} ({info.type}, {info.count})" for info in self.topics) or "none"
        if topic is not None:
            raise FileError(self.path, f"has no topic {topic!r} of {kind}", remedy=f"There are {every}")
        what = f"{len(fitting)} topics of {kind}: {', '.join(fitting)}" if fitting else f"no topic of {kind}"
        raise FileError(self.path, f"has {what}", remedy="Name one of them" if fitting else f"There are {every}")

    def scans(
        self,
        topic: str | None = None,
        *,
        frame: str | None = None,
        absolute_times: bool = False,
        device: DeviceLike = None,
        arrays: str | None = None,
    ) -> Iterator[PointCloud]:
        """Iterate over the clouds of a PointCloud2 or Livox CustomMsg topic in time order.

        Args:
            topic: The topic. None selects the only one.
            frame: Target frame, applied with `transforms` at each header's time. None keeps the sensor frame.
            absolute_times: The attribute `time` is on the clock of the headers, for `LidarOdometry.register(imu=)`.
            device: Device of the clouds.
            arrays: Library of returned arrays, as of `PointCloud`. If None: "numpy".

        Raises:
            FileError: No such topic, several topics, a damaged message, or a cloud without a transform to `frame`.

        Notes:
            Non-finite points are kept. Per-point times are the attribute `time` [s] since the first point, for
            deskewing, unless `absolute_times`. A cloud is transformed rigidly with one pose.
        """
        library = library_for(arrays)
        chosen = self.choose_topic(topic)
        kind = self.topic_types()[chosen]
        tree = None if frame is None else self.transforms()

        def read(row: tuple[int, int, int, int, int]) -> PointCloud:
            if kind in LIVOX:
                encoding, data = self.bytes_at(row)
                table = table_of_livox(self.path, data, encoding)
                if absolute_times:
                    table.attributes["time"] += self.header_at(row)[0] or 0.0
            else:
                table = table_of_message(self.path, self.content_at(row), absolute_times=absolute_times)
            cloud = cloud_of(table, self.path, device=device, arrays=library)
            if tree is None or frame is None:
                return cloud
            time, own = self.header_at(row)
            return cloud.transform(tree.lookup(frame, own, time))

        return (cloud for _, cloud in self._each(chosen, read))

    def transforms(self) -> RecordedTransforms:
        """The frames of the TFMessage topics; topics that end in `tf_static` are constant.

        Raises:
            FileError: No such topic, a damaged message or an invalid transform.
        """
        topics = [name for name, kind in self.topic_types().items() if kind in TRANSFORMS]
        if not topics:
            every = ", ".join(f"{info.name} ({info.type})" for info in self.topics) or "none"
            raise FileError(self.path, f"has no topic of {TRANSFORMS[0]}", remedy=f"There are {every}")
        each = (
            (topic, number, message.content) for topic in topics for number, message in enumerate(self._messages(topic))
        )
        return transforms_of_messages(self.path, each)

    def frames(
        self,
        depth: str | None = None,
        color: str | None = None,
        *,
        intrinsic: PinholeCameraIntrinsic | ArrayLike | None = None,
        tolerance: float = 0.02,
        every: int = 1,
    ) -> RecordedFrames:
        """RGB-D frames: depth and color images paired by the times in their headers.

        Args:
            depth: Depth topic, of Image or CompressedImage. None selects the only one.
            color: Color topic, registered to depth. None selects the only one, if any.
            intrinsic: The camera, or its matrix [3, 3]. None reads the `camera_info` topic beside depth.
            tolerance: Maximum time difference of a pair [s].
            every: Take every k-th frame, starting with the first.

        Returns:
            A source for `track` and `fuse`; `left_out` lists unpaired images.

        Raises:
            FileError: No such topics, ambiguous topics, no camera, or no pairs.
            ValueError: A tolerance that is not positive, or a count below 1.
        """
        apart, step = check_positive("tolerance", tolerance), check_count("every", every)
        if intrinsic is not None and not is_one_camera(intrinsic):
            check_camera("intrinsic", intrinsic)  # before messages are read
        recorded = RecordedFrames(self, *choose_images(self, depth, color), intrinsic, apart, step)
        if not len(recorded):
            reason = f"no images of {recorded.depth} and {recorded.color} were taken within {apart:g} s"
            raise FileError(self.path, reason, remedy="Give a larger tolerance, or other topics")
        return recorded

    def imu(self, topic: str | None = None, *, frame: str | None = None) -> ImuReadings:
        """IMU readings: header times, angular velocities, accelerations, and orientations if present.

        Args:
            topic: The topic. None selects the only one.
            frame: Frame of the scanner, such as `Topic.frame_id` of its clouds: `T_sensor_imu` is the static transform
                from the frame of the IMU. None: the identity.

        Raises:
            FileError: No such topic, several topics, a damaged message, values that are not finite, or times that
                decrease.

        Warns:
            RecordingWarning: No static transform to `frame`, so that `T_sensor_imu` is the identity; or accelerations
                in g, which are converted.
        """
        chosen = self.choose_topic(topic, IMU)
        pose = None if frame is None else self._static_pose(frame, chosen)
        return imu_of_messages(self.path, chosen, (message.content for message in self._messages(chosen)), pose)

    def _static_pose(self, frame: str, topic: str) -> NDArray[np.float64] | None:
        """The static transform from the frame of a topic, or None with a warning."""
        own = self.header_at(self.rows_of(topic)[0])[1]
        if own.removeprefix("/") == check_name("frame", frame).removeprefix("/"):
            return None
        try:
            return self.transforms().lookup(frame, own)
        except FileError as error:
            message = f"the frame {own!r} of {topic} is assumed to equal {frame!r}: {error.reason}"
            warn_of_units(f"{self.path}: {message}", RecordingWarning)
            return None

    def trajectory(self, topic: str | None = None) -> Trajectory:
        """The poses of an Odometry, PoseStamped, PoseWithCovarianceStamped or TransformStamped topic.

        Raises:
            FileError: No such topic, several topics, a damaged message or an invalid pose.
        """
        chosen = self.choose_topic(topic, *POSES)
        messages = (message.content for message in self._messages(chosen))
        return trajectory_of_messages(self.path, chosen, self.topic_types()[chosen], messages)

    def topic_types(self) -> dict[str, str]:
        """Message type of each topic."""
        return {topic.name: topic.type for topic in self.topics if topic.count}

    def rows_of(self, topic: str) -> list[tuple[int, int, int, int, int]]:
        """Index rows of a topic's messages in time order, for `content_at`."""
        return [row for row in self._rows if self._parts[row[1]].channels[row[2]].topic == topic]

    def bytes_at(self, row: tuple[int, int, int, int, int]) -> tuple[str, bytes]:
        """Encoding and bytes of a message, by its row of `rows_of`."""
        return self._parts[row[1]].channels[row[2]].encoding, self._payload(row)

    def content_at(self, row: tuple[int, int, int, int, int]) -> Any:
        """Decode a message. Raises `FileError` if it is damaged or of an unknown type."""
        channel = self._parts[row[1]].channels[row[2]]
        return self._decode(channel.type, channel.encoding, self._payload(row))

    def header_at(self, row: tuple[int, int, int, int, int]) -> tuple[float | None, str]:
        """Header time [s], or None, and frame of a message."""
        encoding, data = self.bytes_at(row)
        try:
            return _header(data, encoding)
        except (struct.error, UnicodeDecodeError) as error:
            raise FileError(self.path, f"a message is cut off in its header: {len(data)} bytes") from error

    def _messages(self, topic: str) -> Iterator[RecordedMessage]:
        return (RecordedMessage(topic, row[0] * 1e-9, content) for row, content in self._each(topic, self.content_at))

    def _each(self, topic: str, read: Callable[[tuple[int, int, int, int, int]], Any]) -> Iterator[tuple[Any, Any]]:
        """Apply `read` to each message of a topic. Errors report the number of messages before it."""
        for done, row in enumerate(self.rows_of(topic)):
            try:
                content = read(row)
            except FileError as error:
                reason = f"{topic}: message {done} cannot be read after {done} that could: {error.reason}"
                raise FileError(error.path, reason, where=error.where, remedy=error.remedy) from error
            yield row, content

    def _payload(self, row: tuple[int, int, int, int, int]) -> bytes:
        time, number, channel, piece, offset = row
        part = self._parts[number]
        chunk = self._chunks.find((number, piece))
        with foreign_errors(part.path, "damaged"):
            if chunk is None:
                chunk = part.pieces[piece]()
                size = len(chunk) if isinstance(chunk, bytes) else 0  # otherwise a mapped file
                self._chunks.put((number, piece), chunk, max(size, _MAX_BYTES // _MAX_CHUNKS))
            return part.payload(chunk, offset, channel, time)

    def _decode(self, kind: str, encoding: str, data: bytes) -> Any:
        if encoding not in ("ros1", "cdr"):
            raise FileError(self.path, f"its messages are encoded as {encoding!r}", remedy="Supported are ros1 and cdr")
        if encoding not in self._stores:
            typesys = import_for(self.path, "rosbags.typesys", "ros")
            chosen = typesys.Stores.ROS1_NOETIC if encoding == "ros1" else typesys.Stores.ROS2_HUMBLE
            self._stores[encoding] = typestore = typesys.get_typestore(chosen)
            for name in {*TRANSFORMS} - {*typestore.fielddefs}:  # different packages in ROS 1
                typestore.register(typesys.get_types_from_msg("geometry_msgs/TransformStamped[] transforms", name))
        store = self._stores[encoding]
        if kind not in store.fielddefs:
            raise FileError(
                self.path, f"messages of {kind} are not supported", remedy="Supported are those of ROS itself"
            )
        with foreign_errors(self.path, f"a message is not a valid {kind}"):
            return store.deserialize_ros1(data, kind) if encoding == "ros1" else store.deserialize_cdr(data, kind)

    def _topic(self, name: str, kind: str, rows: list[tuple[int, int, int, int, int]]) -> Topic:
        if not rows:
            return Topic(name, kind, 0, None, None, None)
        frame = None
        if kind.startswith("sensor_msgs/"):
            try:
                encoding = self._parts[rows[0][1]].channels[rows[0][2]].encoding
                frame = _header(self._payload(rows[0]), encoding)[1]
            except (FileError, struct.error, UnicodeDecodeError):
                frame = None
        return Topic(name, kind, len(rows), rows[0][0] * 1e-9, rows[-1][0] * 1e-9, frame)


def open_recording(path: FilePath) -> Recording:
    """Open a ROS 1 or ROS 2 bag or an MCAP file, without ROS.

    Truncated or unindexed files are read up to the damage. Messages are decoded lazily, which requires
    `pointloom[ros]`.

    Args:
        path: The file, or the folder of a ROS 2 bag.

    Raises:
        FileError: No recording, or a recording without messages.

    Warns:
        RecordingWarning: The recording is truncated or damaged, with the position and the number of messages found.

    Notes:
        Memory: about 100 B per message, independent of message size.

    Example:
        >>> import pointloom as loom
        >>> loom.open_recording("run.mcap")
        Traceback (most recent call last):
        ...
        pointloom.core.errors.FileError: run.mcap: does not exist
    """
    recording = read_recording(path)
    if recording.damage:
        message = escaped(f"{recording.path}: {recording.damage}; {len(recording)} messages remain")
        warnings.warn(message, RecordingWarning, stacklevel=2)
    return recording


def read_recording(path: FilePath) -> Recording:
    root = path_of(path)
    restore_folder(root)
    files = [root]
    if root.is_dir():
        files = sorted((file for file in root.iterdir() if file.suffix in IN_FOLDERS), key=natural_key)
        if not files:
            packed = [
                file.name for file in root.iterdir() if file.name.endswith(tuple(f"{each}.zstd" for each in IN_FOLDERS))
            ]
            remedy = f"Unpack {packed[0]} with zstd -d" if packed else f"Bags of ROS 2 are {listed(IN_FOLDERS)} files"
            raise FileError(root, "contains no recording", remedy=remedy)
    elif not root.exists():
        raise FileError(root, "does not exist")
    elif root.suffix.lower() not in _READERS:
        raise FileError(root, f"is not a recording: {root.suffix!r}", remedy=f"Supported are {' '.join(_READERS)}")
    recording = Recording(root, [_READERS[file.suffix.lower()](file) for file in files])
    if not len(recording):
        raise FileError(root, f"contains no message{'; ' + recording.damage if recording.damage else ''}")
    return recording


def _header(data: bytes, encoding: str) -> tuple[float | None, str]:
    """Time and frame of a message header: after a counter in ROS 1, after 4 bytes of encoding in ROS 2."""
    seconds, nanoseconds, size = struct.unpack_from(byte_order(data, encoding) + "iII", data, 4)
    if 16 + size > len(data):
        raise struct.error("the frame ends after the message")
    frame = bytes(data[16 : 16 + size]).rstrip(b"\0").decode()
    return (seconds + nanoseconds * 1e-9) if seconds or nanoseconds else None, frame
