"""What a robot recorded, by topics: `open_recording`."""

from __future__ import annotations

import os
import struct
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.trajectory import Trajectory
from ...core.atomic import restore_folder
from ...core.checks import check_count, check_positive
from ...core.errors import FileError
from ...core.escaped_text import escaped
from ...core.paths import path_of
from ...kernels.lru_cache import LruCache
from ...pcd.cloud import PointCloud
from ..foreign import foreign_errors, import_for
from ..points.point_cloud import cloud_of
from ..points.scan_files import natural_key
from .bag1 import read_bag1
from .clouds import LIVOX, table_of_livox, table_of_message
from .db3 import read_db3
from .mcap import read_mcap
from .motions import IMU, POSES, ImuReadings, imu_of_messages, trajectory_of_messages
from .pieces import Contents, RecordingWarning, byte_order
from .recorded_frames import RecordedFrames, choose_pictures
from .transforms import TRANSFORMS, RecordedTransforms, transforms_of_messages

CLOUD = "sensor_msgs/msg/PointCloud2"
_READERS = {".bag": read_bag1, ".mcap": read_mcap, ".db3": read_db3}
_MAX_CHUNKS, _MAX_BYTES = 4, 1 << 28  # unpacked chunks that are kept: those of a recording overlap little in time


@dataclass(frozen=True)
class Topic:
    """A topic of a recording.

    Attributes:
        name, type: Its name, and the type of its messages.
        count: How many messages.
        first, last: Times of the first and the last [s]; None without messages.
        frame_id: The frame of the first message, where its type has a header.
    """

    name: str
    type: str
    count: int
    first: float | None
    last: float | None
    frame_id: str | None


@dataclass(frozen=True, eq=False)
class RecordedMessage:
    """A message as it was recorded: its topic, its time [s], and what it holds as an object of `rosbags`.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.files.bags.recording import RecordedMessage
        >>> RecordedMessage("/points", 12.5, None).time
        12.5
    """

    topic: str
    time: float
    content: Any


class Recording:
    """A recording that `open_recording` opened.

    Attributes:
        path: The file or folder.
        damage: What is missing of it, in a sentence, or None.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.files.bags.recording import Recording
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
        """All topics, by name."""
        kinds = {channel.topic: channel.type for part in self._parts for channel in part.channels.values()}
        seen: dict[str, list[tuple[int, int, int, int, int]]] = {name: [] for name in kinds}
        for row in self._rows:
            seen[self._parts[row[1]].channels[row[2]].topic].append(row)
        return [self._topic(name, kinds[name], seen[name]) for name in sorted(kinds)]

    def messages(self, topic: str) -> Iterator[RecordedMessage]:
        """The messages of a topic in the order of their times, each read when its turn comes.

        Raises:
            ValueError: No such topic.
            FileError: A message that is damaged, with how many were read before it; a type that is not known.
        """
        names = [found.name for found in self.topics]
        if topic not in names:
            raise ValueError(escaped(f"topic: {self.path} has no {topic!r}; there are {', '.join(names) or 'none'}"))
        return self._messages(topic)

    def choose_topic(self, topic: str | None, *kinds: str) -> str:
        """The topic that was asked for, or the only one of some types; of clouds where none is named.

        Raises:
            FileError: There is none, of another type, or more than one and none was asked for.
        """
        types = kinds or (CLOUD, *LIVOX)
        kind = types[0]
        fitting = [name for name, found in self.topic_types().items() if found in types]
        if topic is None and len(fitting) == 1:
            return fitting[0]
        if topic in fitting:
            return str(topic)
        every = ", ".join(f"{found.name} ({found.type}, {found.count})" for found in self.topics) or "none"
        if topic is not None:
            raise FileError(self.path, f"has no topic {topic!r} of {kind}", remedy=f"There are {every}")
        what = f"{len(fitting)} topics of {kind}: {', '.join(fitting)}" if fitting else f"no topic of {kind}"
        raise FileError(self.path, f"has {what}", remedy="Name one of them" if fitting else f"There are {every}")

    def scans(self, topic: str | None = None, *, frame: str | None = None, device: Any = None) -> Iterator[PointCloud]:
        """The clouds of a topic of PointCloud2, or of Livox's CustomMsg, in the order of their times.

        Args:
            topic: Which; None takes the only one.
            frame: The frame that they are brought into, by `transforms` at the time in each header; None leaves them in
                that of their sensor.
            device: Where they go.

        Raises:
            FileError: As `choose_topic` and `transforms`; while iterating, a message that is damaged or no cloud, or a
                cloud that `RecordedTransforms.lookup` knows no way for, with its number.

        Notes:
            Points that are not finite are kept. Times per point are the attribute `time` [s] since the first one, which
            odometry straightens by; a cloud that is brought into a frame is moved as one.
        """
        chosen = self.choose_topic(topic)
        kind = self.topic_types()[chosen]
        tree = None if frame is None else self.transforms()

        def read(row: tuple[int, int, int, int, int]) -> PointCloud:
            if kind in LIVOX:
                encoding, data = self.bytes_at(row)
                table = table_of_livox(self.path, data, encoding)
            else:
                table = table_of_message(self.path, self.content_at(row))
            cloud = cloud_of(table, self.path, device=device)
            if tree is None or frame is None:
                return cloud
            time, own = self.header_at(row)
            return cloud.transform(tree.lookup(frame, own, time))

        return (cloud for _, cloud in self._each(chosen, read))

    def transforms(self) -> RecordedTransforms:
        """The frames that the topics of TFMessage tell of, those that end in `tf_static` for all time.

        Raises:
            FileError: No such topic, a message that is damaged, or a transform that is none.
        """
        topics = [name for name, kind in self.topic_types().items() if kind in TRANSFORMS]
        if not topics:
            every = ", ".join(f"{found.name} ({found.type})" for found in self.topics) or "none"
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
        intrinsic: PinholeCameraIntrinsic | None = None,
        tolerance: float = 0.02,
        every: int = 1,
    ) -> RecordedFrames:
        """The RGB-D frames of a recording: pictures of depth and colour with the same time in their headers.

        Args:
            depth: The topic of depth, of Image or CompressedImage; None takes the only one.
            color: The topic of colour, registered to depth; None takes the only one, or none where there is none.
            intrinsic: The camera; None takes what the `camera_info` beside the topic of depth says.
            tolerance: Pictures belong together that were taken less than this apart [s].
            every: Take every k-th frame, beginning with the first.

        Returns:
            A source of frames, as `track` and `fuse` take them; `left_out` lists pictures without a partner.

        Raises:
            FileError: No such topics, more than one and none named, no camera, or pictures that never go together.
            ValueError: A tolerance that is not above 0, or a count below 1.
        """
        apart, step = check_positive("tolerance", tolerance), check_count("every", every)
        if intrinsic is not None and not isinstance(intrinsic, PinholeCameraIntrinsic):
            raise TypeError(f"intrinsic: expected a PinholeCameraIntrinsic, got {type(intrinsic).__name__}")
        found = RecordedFrames(self, *choose_pictures(self, depth, color), intrinsic, apart, step)
        if not len(found):
            reason = f"no pictures of {found.depth} and {found.color} were taken within {apart:g} s"
            raise FileError(self.path, reason, remedy="Give a larger tolerance, or other topics")
        return found

    def imu(self, topic: str | None = None) -> ImuReadings:
        """The readings of an inertial unit: times of the headers, turns, accelerations, and orientations where given.

        Raises:
            FileError: As `choose_topic`, or a message that is damaged.
        """
        chosen = self.choose_topic(topic, IMU)
        return imu_of_messages(message.content for message in self._messages(chosen))

    def trajectory(self, topic: str | None = None) -> Trajectory:
        """The poses of a topic of Odometry, PoseStamped, PoseWithCovarianceStamped or TransformStamped, as recorded.

        Raises:
            FileError: As `choose_topic`; a message that is damaged, or a pose that is none.
        """
        chosen = self.choose_topic(topic, *POSES)
        messages = (message.content for message in self._messages(chosen))
        return trajectory_of_messages(self.path, chosen, self.topic_types()[chosen], messages)

    def topic_types(self) -> dict[str, str]:
        """The types of topics that have messages, by name."""
        return {topic.name: topic.type for topic in self.topics if topic.count}

    def rows_of(self, topic: str) -> list[tuple[int, int, int, int, int]]:
        """Where the messages of a topic stand, in the order of their times, for `content_at`."""
        return [row for row in self._rows if self._parts[row[1]].channels[row[2]].topic == topic]

    def bytes_at(self, row: tuple[int, int, int, int, int]) -> tuple[str, bytes]:
        """The encoding of a message, and its bytes."""
        return self._parts[row[1]].channels[row[2]].encoding, self._payload(row)

    def content_at(self, row: tuple[int, int, int, int, int]) -> Any:
        """A message, decoded.

        Raises:
            FileError: It is damaged, or of a type that is not known.
        """
        channel = self._parts[row[1]].channels[row[2]]
        return self._decode(channel.type, channel.encoding, self._payload(row))

    def header_at(self, row: tuple[int, int, int, int, int]) -> tuple[float | None, str]:
        """The time [s] in the header of a message, None where it tells none, and its frame."""
        encoding, data = self.bytes_at(row)
        try:
            return _header(data, encoding)
        except (struct.error, UnicodeDecodeError) as error:
            raise FileError(self.path, f"a message is cut off in its header: {len(data)} bytes") from error

    def _messages(self, topic: str) -> Iterator[RecordedMessage]:
        return (RecordedMessage(topic, row[0] * 1e-9, content) for row, content in self._each(topic, self.content_at))

    def _each(self, topic: str, read: Callable[[tuple[int, int, int, int, int]], Any]) -> Iterator[tuple[Any, Any]]:
        """Where each message of a topic stands, and what is read there; errors tell how many came before it."""
        for done, row in enumerate(self.rows_of(topic)):
            try:
                content = read(row)
            except FileError as error:
                reason = f"{topic}: message {done} cannot be read after {done} that could: {error.reason}"
                raise FileError(error.path, reason, where=error.where, remedy=error.remedy) from error
            yield row, content

    def _payload(self, row: tuple[int, int, int, int, int]) -> bytes:
        time, number, channel, piece, place = row
        part = self._parts[number]
        chunk = self._chunks.find((number, piece))
        with foreign_errors(part.path, "damaged"):
            if chunk is None:
                chunk = part.pieces[piece]()
                size = len(chunk) if isinstance(chunk, bytes) else 0  # else a mapped file
                self._chunks.put((number, piece), chunk, max(size, _MAX_BYTES // _MAX_CHUNKS))
            return part.payload(chunk, place, channel, time)

    def _decode(self, kind: str, encoding: str, data: bytes) -> Any:
        if encoding not in ("ros1", "cdr"):
            raise FileError(self.path, f"its messages are encoded as {encoding!r}", remedy="Known are ros1 and cdr")
        if encoding not in self._stores:
            typesys = import_for(self.path, "rosbags.typesys", "ros")
            chosen = typesys.Stores.ROS1_NOETIC if encoding == "ros1" else typesys.Stores.ROS2_HUMBLE
            self._stores[encoding] = found = typesys.get_typestore(chosen)
            for name in {*TRANSFORMS} - {*found.fielddefs}:  # in ROS 1 they are of packages of their own
                found.register(typesys.get_types_from_msg("geometry_msgs/TransformStamped[] transforms", name))
        store = self._stores[encoding]
        if kind not in store.fielddefs:
            raise FileError(self.path, f"messages of {kind} are not known", remedy="Known are those of ROS itself")
        with foreign_errors(self.path, f"a message is no {kind}"):
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


def open_recording(path: str | os.PathLike[str]) -> Recording:
    """Open what a robot recorded: a bag of ROS 1 or 2 or an MCAP file, without ROS.

    What is cut off or has no index is read up to the damage. Messages are read when their turn comes; decoding them
    takes the extra `pointloom[ros]`.

    Args:
        path: A .bag, .mcap or .db3 file, or the folder of a bag of ROS 2, whose files are taken together.

    Raises:
        FileError: Nothing that is a recording, or one without any message.

    Warns:
        RecordingWarning: It is cut off or damaged; says where, and how many messages were found.

    Notes:
        Memory goes with the number of messages (some 100 B each), not with their size.

    Example:
        >>> import pointloom as loom
        >>> loom.open_recording("run.mcap")
        Traceback (most recent call last):
        ...
        pointloom.core.errors.FileError: run.mcap: does not exist
    """
    recording = read_recording(path)
    if recording.damage:
        message = escaped(f"{recording.path}: {recording.damage}; {len(recording)} messages are left")
        warnings.warn(message, RecordingWarning, stacklevel=2)
    return recording


def read_recording(path: str | os.PathLike[str]) -> Recording:
    """As `open_recording`, without a warning of damage."""
    place = path_of(path)
    restore_folder(place)
    files = [place]
    if place.is_dir():
        files = sorted((file for file in place.iterdir() if file.suffix in (".db3", ".mcap")), key=natural_key)
        if not files:
            packed = [file.name for file in place.iterdir() if file.name.endswith((".db3.zstd", ".mcap.zstd"))]
            remedy = f"Unpack {packed[0]} with zstd -d" if packed else "Bags of ROS 2 are .db3 or .mcap files"
            raise FileError(place, "holds no recording", remedy=remedy)
    elif not place.exists():
        raise FileError(place, "does not exist")
    elif place.suffix.lower() not in _READERS:
        raise FileError(place, f"is no recording: {place.suffix!r}", remedy=f"Known are {' '.join(_READERS)}")
    recording = Recording(place, [_READERS[file.suffix.lower()](file) for file in files])
    if not len(recording):
        raise FileError(place, f"holds no message{'; ' + recording.damage if recording.damage else ''}")
    return recording


def is_recording(path: Path) -> bool:
    """Whether this is a file or folder that `open_recording` takes."""
    if path.is_dir():
        return any(file.suffix in (".db3", ".mcap") for file in path.iterdir())
    return path.suffix.lower() in _READERS


def _header(data: bytes, encoding: str) -> tuple[float | None, str]:
    """Time and frame of a message that begins with a header: a counter in ROS 1, four bytes of encoding in ROS 2."""
    seconds, nanoseconds, size = struct.unpack_from(byte_order(data, encoding) + "iII", data, 4)
    if 16 + size > len(data):
        raise struct.error("the frame ends behind the message")
    frame = bytes(data[16 : 16 + size]).rstrip(b"\0").decode()
    return (seconds + nanoseconds * 1e-9) if seconds or nanoseconds else None, frame
