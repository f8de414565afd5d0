"""The container of a video by its first bytes.

Decoders guess the container of a file, also from text: a playlist named .mp4 would make them read any other file of the
machine. So the container is found here, among those that contain their own frames, and the decoder is given its name.
"""

from __future__ import annotations

from pathlib import Path

from ...core.errors import FileError

_HEAD = 4096  # [B] that are looked at
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
_PACKETS = (188, 192, 204)  # [B] of MPEG transport streams: plain, with times, with checksums
_SYNC, _SYNC_COUNT = 0x47, 5  # the first byte of packets, and in how many of them it must be found


def find_container(path: Path) -> str:
    """ffmpeg's name of the container; empty if it is not known.

    Raises:
        FileError: The file cannot be read.
    """
    try:
        with path.open("rb") as file:
            return _container_of(file.read(_HEAD))
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
    """Streams without a head, which a recorder may have cut anywhere."""
    for step in _PACKETS:
        for begin in range(step):
            packets = head[begin::step][:_SYNC_COUNT]
            if packets == bytes([_SYNC]) * _SYNC_COUNT:
                return "mpegts"
    for start in (b"\x00\x00\x00\x01", b"\x00\x00\x01"):
        if head.startswith(start) and len(head) > len(start):
            first = head[len(start)]
            if first & 0x9F in (7, 9) and first & 0x80 == 0:  # a sequence or a delimiter
                return "h264"
            if first in (0x40, 0x42, 0x46):
                return "hevc"
    return ""
