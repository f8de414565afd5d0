"""A JPEG file's scans, prepared so that a decoder which runs out of pixels cannot make any up.

JPEG has no checksum, and where a scan ends before the picture does decoders go on with grey: libjpeg's warning of it
does not reach Pillow. Two things tell such a scan. Where a file has one scan (all that cameras write), the mark behind
it is replaced by as many bits as a decoder looks ahead: a scan that is whole is decoded, for one that is not the
decoder asks for more and gets no more. Where it has several (progressive), the pixels must not depend on what stands
behind a scan. At most the last two blocks of 8 x 8 pixels may be missing unnoticed; other damage cannot be told.

Source: ITU-T T.81, sections B.1 and B.2; F.2.2.3 for the stuffed bytes.
"""

from __future__ import annotations

import itertools
import re
from dataclasses import dataclass, field
from typing import Any

from ...core.errors import FileError

JPEG_MAGIC = b"\xff\xd8\xff"

_EOI, _SOS, _DRI = 0xD9, 0xDA, 0xDD
_PROGRESSIVE = 0xC2
_HUFFMAN_FRAMES = (0xC0, 0xC1, _PROGRESSIVE)
_OTHER_FRAMES = {*range(0xC3, 0xD0)} - {0xC4, 0xC8, 0xCC}  # lossless, hierarchical, arithmetic
_STANDALONE = {0x01, *range(0xD0, 0xD8)}

# A scan ends at the first marker that is neither a stuffed zero nor a restart.
_SCAN_END = re.compile(rb"\xff(?=[^\x00\xd0-\xd7\xff])")
_RESTART = re.compile(rb"\xff[\xd0-\xd7]")

# libjpeg fills a register of 64 bits before each code. A run of ones is no code: a block takes at least 34 of them.
_LOOK_AHEAD = b"\xff\x00" * 8

# Bits that no picture ends with by chance, for the second decoding of a file of several scans.
_NOISE = bytes((k * 167 + 71) % 251 for k in range(96))

_REMEDY = "Fetch or write the file again"


@dataclass
class _Layout:
    width: int = 0
    height: int = 0
    is_progressive: bool = False
    restart_interval: int = 0
    sampling: dict[int, tuple[int, int]] = field(default_factory=dict)  # across and down, by component
    bits_left: dict[int, list[int]] = field(default_factory=dict)  # of each coefficient, by component
    scans: list[tuple[int, int]] = field(default_factory=list)  # first byte and end of the coded pixels

    def unit_count(self, components: list[int]) -> int:
        """The units that a scan of these components codes: blocks of 8 x 8 of one, groups of such of several."""
        most = [max(values) for values in zip(*self.sampling.values(), strict=True)]
        own = self.sampling[components[0]] if len(components) == 1 else (1, 1)
        sides = zip((self.width, self.height), own, most, strict=True)
        across, down = (-(-size * part // (8 * whole)) for size, part, whole in sides)
        return across * down


def testable_jpegs(path: Any, data: bytes) -> list[bytes]:
    """The file as it is to be decoded: once, or twice and then to the same pixels.

    Raises:
        FileError: It is cut off, lacks its end, a scan of a component, or codes pixels in a way that cannot be checked.
    """
    layout = _walk(path, data)
    if not layout.scans or any(bits for left in layout.bits_left.values() for bits in left):
        raise FileError(path, "cut off: it ends before the scans of all its channels", remedy=_REMEDY)
    if len(layout.scans) == 1:
        return [data[: layout.scans[0][1]] + _LOOK_AHEAD]
    places = [0, *(end for _, end in layout.scans), len(data)]
    parts = [data[begin:end] for begin, end in itertools.pairwise(places)]
    return [data, _NOISE.join(parts)]


def _walk(path: Any, data: bytes) -> _Layout:
    """The segments up to the end mark; what follows it (some cameras write further pictures there) is not read."""
    layout, place = _Layout(), 2
    while True:
        marker, place = _marker(path, data, place)
        if marker == _EOI:
            return layout
        if marker in _STANDALONE:
            continue
        length = int.from_bytes(data[place : place + 2], "big")
        segment, begin = data[place + 2 : place + length], place
        place += length
        if length < 2 or place > len(data):
            reason = f"cut off or damaged: a segment of {length} bytes, {len(data) - begin} are left"
            raise FileError(path, reason, where=f"byte {begin}", remedy=_REMEDY)
        if marker in _OTHER_FRAMES:
            reason = f"its pixels are coded in a way (SOF{marker - 0xC0}) of which it cannot be told that all are there"
            raise FileError(path, reason, where=f"byte {begin}", remedy="Store it as PNG, or as baseline JPEG")
        if marker in _HUFFMAN_FRAMES:
            _read_frame(path, segment, begin, layout)
            layout.is_progressive = marker == _PROGRESSIVE
        elif marker == _DRI:
            layout.restart_interval = int.from_bytes(segment[:2], "big")
        elif marker == _SOS:
            components = _read_scan(path, segment, begin, layout)
            found = _SCAN_END.search(data, place)
            if found is None:
                reason = "cut off: the end of the JPEG is missing"
                raise FileError(path, reason, where=f"byte {len(data)}", remedy=_REMEDY)
            coded = data[place : found.start()].rstrip(b"\xff")  # a marker may have several bytes of 0xff before it
            _check_scan(path, coded, place, layout, layout.unit_count(components))
            layout.scans.append((place, place + len(coded)))
            place += len(coded)


def _check_scan(path: Any, coded: bytes, begin: int, layout: _Layout, units: int) -> None:
    """Hold a scan's bytes and restart marks against what it should code, before memory is taken for the picture."""
    if not layout.scans and units > 8 * len(coded):  # in a first scan each takes one bit at least
        reason = f"{layout.width} x {layout.height} pixels cannot lie in {len(coded)} bytes"
        raise FileError(path, f"cut off or damaged: {reason}", where=f"byte {begin}", remedy=_REMEDY)
    if layout.restart_interval:
        expected, found = (units - 1) // layout.restart_interval, len(_RESTART.findall(coded))
        if found < expected:
            reason = f"cut off or damaged: a scan has {found} of {expected} restart marks"
            raise FileError(path, reason, where=f"byte {begin}", remedy=_REMEDY)


def _marker(path: Any, data: bytes, place: int) -> tuple[int, int]:
    """The marker at a byte, behind any filling, and the byte behind it."""
    if place >= len(data):
        raise FileError(path, "cut off: the end of the JPEG is missing", where=f"byte {place}", remedy=_REMEDY)
    start = place
    while data[place : place + 1] == b"\xff":
        place += 1
    if place == start or place >= len(data) or not data[place]:
        raise FileError(path, "damaged picture: no JPEG marker", where=f"byte {start}", remedy=_REMEDY)
    return data[place], place + 1


def _read_frame(path: Any, segment: bytes, begin: int, layout: _Layout) -> None:
    count = segment[5] if len(segment) > 5 else 0
    if layout.sampling or not count or len(segment) < 6 + 3 * count:
        raise FileError(path, "damaged: its frame", where=f"byte {begin}", remedy=_REMEDY)
    layout.height, layout.width = (int.from_bytes(segment[k : k + 2], "big") for k in (1, 3))
    for k in range(6, 6 + 3 * count, 3):
        layout.sampling[segment[k]] = max(1, segment[k + 1] >> 4), max(1, segment[k + 1] & 15)
        layout.bits_left[segment[k]] = [1] * 64


def _read_scan(path: Any, segment: bytes, begin: int, layout: _Layout) -> list[int]:
    """The components of a scan, of whose coefficients it is noted how many bits later scans have to bring."""
    count = segment[0] if segment else 0
    components = [*segment[1 : 1 + 2 * count : 2]]
    if not count or len(segment) < 4 + 2 * count or not layout.sampling.keys() >= {*components}:
        raise FileError(path, "damaged: the head of a scan", where=f"byte {begin}", remedy=_REMEDY)
    first, last, bits = segment[1 + 2 * count : 4 + 2 * count]
    if not layout.is_progressive:
        first, last, bits = 0, 63, 0
    for component in components:
        for k in range(first, min(last, 63) + 1):
            layout.bits_left[component][k] = bits & 15
    return components
