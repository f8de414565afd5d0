"""Video decoding by external programs: ffmpeg, else OpenCV in a separate process.

Frames are yielded as stored, rotated by the file's tag, none duplicated or dropped at variable rates. Both programs
skip undecodable data and end truncated files without an error, so frames are counted and compared with the header. The
container is detected by its first bytes and passed to the decoder, since a playlist named .mp4 could read other files.
"""

from __future__ import annotations

import dataclasses
import json
import os
import re
import shutil
import subprocess
from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError, FilePath
from ...core.paths import input_path
from .limited_process import LimitedProcess, python_command

_HEADER_BYTES = 4096  # [B] inspected header
_MOV = (b"ftyp", b"moov", b"mdat", b"wide", b"free", b"skip", b"pnot", b"styp", b"uuid")
_STARTS = {
    b"\x1a\x45\xdf\xa3": "matroska",
    b"FLV\x01": "flv",
    b"OggS": "ogg",
    b"\x30\x26\xb2\x75\x8e\x66\xcf\x11": "asf",
    b"\x06\x0e\x2b\x34\x02\x05\x01\x01": "mxf",
    b"\x00\x00\x01\xba": "mpeg",
    b"\x00\x00\x01\xb3": "mpegvideo",
    b"\x1f\x07\x00": "dv",
    b"GIF87a": "gif",
    b"GIF89a": "gif",
    b"YUV4MPEG2 ": "yuv4mpegpipe",
    b"DKIF\x00\x00": "ivf",
    b"nut/multimedia container\x00": "nut",
    b".RMF\x00": "rm",
}
_PACKET_BYTES = (188, 192, 204)  # [B] MPEG transport stream packets: plain, with time stamps, with checksums
_SYNC_BYTE, _SYNC_COUNT = 0x47, 5  # first byte of packets, and required number of packets


def find_container(path: Path) -> str:
    try:
        with path.open("rb") as file:
            return _container_of(file.read(_HEADER_BYTES))
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error


def _container_of(head: bytes) -> str:
    if head[4:8] in _MOV:
        return "mov"
    if head[:4] == b"RIFF" and head[8:12] in (b"AVI ", b"AVIX"):
        return "avi"
    for start, name in _STARTS.items():
        if head.startswith(start):
            return name
    return _stream_of(head)


def _stream_of(head: bytes) -> str:
    """Detect raw streams, which may start anywhere."""
    for step in _PACKET_BYTES:
        for begin in range(step):
            packets = head[begin::step][:_SYNC_COUNT]
            if packets == bytes([_SYNC_BYTE]) * _SYNC_COUNT:
                return "mpegts"
    for start in (b"\x00\x00\x00\x01", b"\x00\x00\x01"):
        if head.startswith(start) and len(head) > len(start):
            first = head[len(start)]
            if first & 0x9F in (7, 9) and first & 0x80 == 0:  # a sequence or a delimiter
                return "h264"
            if first in (0x40, 0x42, 0x46):
                return "hevc"
    return ""


READERS = ("auto", "ffmpeg", "opencv")

_OPENCV = Path(__file__).with_name("opencv_worker.py")
_PROBE_SECONDS = 120.0  # for headers, or complete files without an index on slow disks
_OPENCV_MISSING = 3  # exit code of opencv_worker
_INSTALL = "Install the program ffmpeg (with ffprobe), or pip install opencv-python-headless"
_NO_CONTAINER = "its first bytes match no known video container"
_CONVERT = "Convert it to MP4 or MKV. Playlists are not followed: give the video itself"
_FIRST_FPS_MODE = (5, 1)  # first ffmpeg with -fps_mode
_MAX_PIXELS = 2**28


@dataclasses.dataclass(frozen=True)
class VideoFile:
    """Header of a video: `promised` frame count (None if unknown), exact if `is_counted`. Mean `fps` (0 if unknown)."""

    path: Path
    reader: str
    container: str
    promised: int | None
    is_counted: bool
    fps: float
    pixel_aspect: float = 1.0


def open_video(path: FilePath, *, reader: str = "auto") -> VideoFile:
    file = input_path(path)
    if not file.is_file():
        reason = "is not a file" if file.exists() else "does not exist"
        raise FileError(path, reason, remedy="Give a video, or a folder of images")
    if reader == "auto":
        reader = "ffmpeg" if _ffmpeg() else "opencv"
    if reader == "ffmpeg":
        if not _ffmpeg():
            raise FileError(path, "the programs ffmpeg and ffprobe are not on the path", remedy=_INSTALL)
        return _probe_ffmpeg(file, find_container(file))
    return _probe_opencv(file, find_container(file))


def _ffmpeg() -> bool:
    return shutil.which("ffmpeg") is not None and shutil.which("ffprobe") is not None


def _probe_ffmpeg(path: Path, container: str) -> VideoFile:
    if not container:
        raise FileError(path, f"no video can be read: {_NO_CONTAINER}", remedy=_CONVERT)
    stream = "nb_frames,avg_frame_rate,duration,sample_aspect_ratio"
    entries = f"stream={stream}:format=duration"
    command = ["ffprobe", "-v", "error", "-select_streams", "v:0", "-show_entries", entries, "-of", "json"]
    output, words = _answer(path, [*command, *_input(path, container)])
    try:
        content = json.loads(output)
        head = (content.get("streams") or [{}])[0]
    except ValueError:
        content, head = {}, {}
    if not head:
        reason = f"no video can be read: {_without_address(words) or 'it contains no images'}"
        remedy = "A truncated recording may lack its index: repair it, or give a folder of images"
        raise FileError(path, reason, remedy=remedy)
    counted, fps = _number(head.get("nb_frames")), _number(head.get("avg_frame_rate"))
    seconds = _number(head.get("duration")) or _number(content.get("format", {}).get("duration"))
    promised = counted or round(seconds * fps)
    aspect = _number(str(head.get("sample_aspect_ratio", "1")).replace(":", "/")) or 1.0
    return VideoFile(path, "ffmpeg", container, int(promised) or None, bool(counted), fps, aspect)


def _probe_opencv(path: Path, container: str) -> VideoFile:
    command = python_command(_OPENCV)
    output, words = _answer(
        path, command, stdin=json.dumps({"path": os.fspath(path), "container": container, "probe": True})
    )
    try:
        head = json.loads(output)
    except ValueError as error:
        words = (words or "OpenCV gives no reason") if container else _NO_CONTAINER
        raise FileError(path, f"no video can be read: {words}", remedy="" if container else _CONVERT) from error
    promised = head["frames"] if head["frames"] > 0 else None
    return VideoFile(path, "opencv", container, promised, True, _number(head["fps"]))


def _answer(path: Path, command: Sequence[str], *, stdin: str = "") -> tuple[str, str]:
    with LimitedProcess(command, max_seconds=_PROBE_SECONDS, stdin=stdin) as process:
        assert process.stdout is not None
        output = process.stdout.read().decode(errors="replace")
        status = process.wait()
        if status == _OPENCV_MISSING and command[-1] == str(_OPENCV):
            raise FileError(path, "no program for reading videos is installed", remedy=_INSTALL)
        if status < 0:
            raise FileError(path, f"reading the video {process.why_ended()}", remedy="The file may be damaged")
        return output, process.last_words()


def _number(text: Any) -> float:
    """A number as ffprobe writes it ("30000/1001"). 0 for "N/A" and invalid text."""
    try:
        return float(Fraction(str(text)))
    except (ValueError, ZeroDivisionError):
        return 0.0


def _without_address(words: str) -> str:
    return re.sub(r" @ 0x[0-9a-f]+", "", words)


class VideoFrames:
    """Frames of a video in a `with` block, for a single iteration; `numbers` (ascending) selects frames."""

    def __init__(
        self,
        video: VideoFile,
        *,
        max_size: int | None,
        gray: bool = False,
        numbers: Sequence[int] | None = None,
        max_seconds: float = float("inf"),
        max_memory: int | None = None,
    ):
        self._video, self.count, self.message = video, 0, ""
        if video.reader == "ffmpeg":
            command, stdin = _ffmpeg_command(video, max_size, gray, numbers), ""
        else:
            command = python_command(_OPENCV)
            job = {"path": os.fspath(video.path), "container": video.container, "max_size": max_size, "gray": gray}
            stdin = json.dumps(job | {"numbers": None if numbers is None else list(numbers)})
        self._process = LimitedProcess(command, max_seconds=max_seconds, max_memory=max_memory, stdin=stdin)

    def __enter__(self) -> VideoFrames:
        self._process.__enter__()
        return self

    def __exit__(self, *error: object) -> None:
        self._process.__exit__(*error)

    @property
    def peak_bytes(self) -> int:
        return self._process.peak_bytes

    def __iter__(self) -> Iterator[NDArray[np.uint8]]:
        """Yield each frame, read-only [h, w] or [h, w, 3]. FileError if the program fails or there is none."""
        stream = self._process.stdout
        assert stream is not None
        while (frame := _read_netpbm(stream)) is not None:
            self.count += 1
            yield frame
        status = self._process.wait()
        self.message = _without_address(self._process.last_words())
        if self._process.killed_for or status < 0:
            reason = f"decoding {self._process.why_ended()} after {self.count} frames"
            raise FileError(self._video.path, reason, remedy="Raise the limit, or give a shorter video")
        if not self.count:
            reason = f"no frame can be decoded: {self.message or f'{self._video.reader} gives no reason'}"
            raise FileError(self._video.path, reason, remedy="The file may be damaged, or of an unknown format")


def _ffmpeg_command(video: VideoFile, max_size: int | None, gray: bool, numbers: Sequence[int] | None) -> list[str]:
    filters = []
    if numbers is not None:
        filters.append(f"select='{_any_of(list(numbers))}'")
    if abs(video.pixel_aspect - 1.0) > 1e-3:
        filters.append("scale='round(iw*max(1,sar))':'round(ih*max(1,1/sar))',setsar=1")
    if max_size is not None:
        limits = f"w='min({max_size},iw)':h='min({max_size},ih)'"
        filters.append(f"scale={limits}:force_original_aspect_ratio=decrease:flags=area")
    # frames as stored: no duplicates, none dropped
    rate = ["-fps_mode" if _ffmpeg_version() >= _FIRST_FPS_MODE else "-vsync", "passthrough"]
    command = ["ffmpeg", "-nostdin", "-hide_banner", "-v", "error"]
    command += [*_input(video.path, video.container), "-map", "0:v:0", *rate]
    if filters:
        command += ["-vf", ",".join(filters)]
    if numbers is not None:
        command += ["-frames:v", str(len(numbers))]
    return [*command, "-f", "image2pipe", "-c:v", "pgm" if gray else "ppm", "pipe:1"]


def _input(path: Path, container: str) -> list[str]:
    return ["-protocol_whitelist", "file", "-format_whitelist", container, "-f", container, "-i", f"file:{path}"]


def _any_of(numbers: list[int]) -> str:
    """ffmpeg's expression for "n is one of these", nested, since sums of more than a hundred terms are rejected."""
    if not numbers:
        return "0"
    if len(numbers) == 1:
        return f"eq(n,{numbers[0]})"
    middle = len(numbers) // 2
    return f"if(lt(n,{numbers[middle]}),{_any_of(numbers[:middle])},{_any_of(numbers[middle:])})"


@cache
def _ffmpeg_version() -> tuple[int, ...]:
    """(5, 1) of "ffmpeg version 5.1.9-0+deb12u1". Builds with only a date count as newest."""
    output = subprocess.run(
        ["ffmpeg", "-version"], capture_output=True, encoding="utf-8", check=False, timeout=60
    ).stdout
    match = re.match(r"ffmpeg version n?(\d+)\.(\d+)", output)
    return (int(match[1]), int(match[2])) if match else (99,)


def _read_netpbm(stream: IO[bytes]) -> NDArray[np.uint8] | None:
    """The next image of a PGM and PPM stream. None at its end or if truncated."""
    kind, size, max_value = (stream.readline(40) for _ in range(3))
    if kind not in (b"P5\n", b"P6\n") or max_value != b"255\n":
        return None
    width, height = (int(text) for text in size.split())
    if not 0 < width * height <= _MAX_PIXELS:
        return None
    shape = (height, width) if kind == b"P5\n" else (height, width, 3)
    length = int(np.prod(shape))
    pixels = stream.read(length)
    return np.frombuffer(pixels, np.uint8).reshape(shape) if len(pixels) == length else None
