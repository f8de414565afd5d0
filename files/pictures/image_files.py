"""Depth maps and colour pictures on disk: PNG, JPEG and .npy, read strictly and written whole.

A file is read once and inflated once. A PNG's checksums and the length of its stream of pixels are verified before it
is decoded (png_stream.py): a cut off or damaged depth map is an error and never wrong depth. JPEG has no checksum;
there pixels that are missing are noticed, not those that are damaged. Colour profiles, gamma and EXIF
orientation are not applied.

A JPEG file's scans, prepared so that a decoder which runs out of pixels cannot make any up. JPEG has no checksum, and
where a scan ends before the picture does decoders go on with grey: libjpeg's warning of it does not reach Pillow. Two
things tell such a scan. Where a file has one scan (all that cameras write), the mark behind it is replaced by as many
bits as a decoder looks ahead: a scan that is whole is decoded, for one that is not the decoder asks for more and gets
no more. Where it has several (progressive), the pixels must not depend on what stands behind a scan. At most the last
two blocks of 8 x 8 pixels may be missing unnoticed; other damage cannot be told.

Source: ITU-T T.81, sections B.1 and B.2; F.2.2.3 for the stuffed bytes.
"""

from __future__ import annotations

import dataclasses
import io
import itertools
import os
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray
from PIL import BmpImagePlugin, Image, ImageFile, JpegImagePlugin, PngImagePlugin, TgaImagePlugin, TiffImagePlugin

from ...core.atomic import atomic_write, check_writable
from ...core.errors import FileError
from ...core.paths import path_of
from ..foreign import foreign_errors
from ..npy_header import read_npy_header
from ..source import Source
from .png_stream import PNG_MAGIC, parse_png_header, whole_png

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


# Larger pictures are refused before anything is allocated: 2^28 pixels are 0.75 GiB of colour, and no camera has more.
PIXEL_LIMIT = 2**28

# A 7-Scenes depth map takes 119 KiB and 7 ms at level 1, 90 KiB and 20 ms at level 6, the default.
_PNG_LEVEL = 1

_TEXTURE_MODES = ("1", "L", "LA", "P", "PA", "RGB", "RGBA")

_NPY_MAGIC = b"\x93NUMPY"


@dataclasses.dataclass(frozen=True)
class PictureHeader:
    """What the first bytes of a picture say; `kind` is "png" or "jpeg", `bits` those of a channel."""

    kind: str
    width: int
    height: int
    channels: int
    bits: int


def read_depth(path: str | os.PathLike[str]) -> NDArray[np.uint16] | NDArray[np.float32]:
    """Read a depth map as it is stored; its unit is the data set's.

    A 16-bit grey PNG gives uint16, a .npy file of a 2-D float32 array gives float32. Nothing is scaled or filled in.

    Returns:
        Shape [h, w]; writable.

    Raises:
        FileError: Unreadable, damaged, too large, or a picture that is no depth map (8 bits, colour).

    Example:
        >>> import numpy as np, pointloom as loom
        >>> np.save("depth.npy", np.full((48, 64), 1.5, np.float32))
        >>> loom.read_depth("depth.npy").shape
        (48, 64)
    """
    data = _read_bytes(path)
    return _decode_npy(path, data) if data.startswith(_NPY_MAGIC) else decode_depth(path, data)


def decode_depth(path: str | os.PathLike[str], data: bytes) -> NDArray[np.uint16]:
    """The bytes of a 16-bit grey PNG as a depth map, shape [h, w]; `path` is for errors.

    Raises:
        FileError: Damaged, too large, or no such picture.
    """
    header = _parse_header(path, io.BytesIO(data))
    check_depth_header(path, header)
    return _decode(path, data, header, "I;16")


def read_color(path: str | os.PathLike[str]) -> NDArray[np.uint8]:
    """Read a PNG or JPEG picture as RGB; grey is replicated, transparency is dropped.

    Returns:
        Shape [h, w, 3], uint8, writable.

    Raises:
        FileError: Unreadable, damaged, too large, or 16-bit grey, which is a depth map.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from PIL import Image
        >>> Image.fromarray(np.full((48, 64, 3), 200, np.uint8)).save("color.png")
        >>> loom.read_color("color.png").shape
        (48, 64, 3)
    """
    data = _read_bytes(path)
    header = _parse_header(path, io.BytesIO(data))
    check_color_header(path, header)
    return _decode(path, data, header, "RGB")


def decode_texture(path: str | os.PathLike[str], data: bytes) -> NDArray[np.uint8]:
    """The bytes of a picture as RGB, or RGBA if it has transparency, by a channel or tRNS; gray is replicated.

    Read are PNG and JPEG, and TIFF, BMP and TGA (by the name) of 8 bits a channel.

    Args:
        path: The file, for errors.
        data: Its bytes.

    Returns:
        Shape [h, w, 3 or 4], uint8.

    Raises:
        FileError: Damaged, too large, of another kind, or 16-bit grey.
    """
    if plugin := _plugin_of(path, data):
        return _decode_other(path, data, plugin)
    header = _parse_header(path, io.BytesIO(data))
    check_color_header(path, header)
    has_alpha = header.kind == "png" and (header.channels in (2, 4) or b"tRNS" in data[: data.find(b"IDAT")])
    return _decode(path, data, header, "RGBA" if has_alpha else "RGB")


def encode_png(array: NDArray[np.uint8] | NDArray[np.uint16]) -> bytes:
    """An array that `write_png` takes, or RGBA, as the bytes of a PNG file."""
    file = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(array)).save(file, "PNG", compress_level=_PNG_LEVEL)
    return file.getvalue()


def read_picture_header(path: str | os.PathLike[str]) -> PictureHeader:
    """The size and kind of a PNG or JPEG picture from its first bytes; no pixel is decoded.

    Raises:
        FileError: Unreadable, of another kind, or too large.
    """
    try:
        with path_of(path).open("rb") as file:
            return _parse_header(path, file)
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error


def texture_size(path: str | os.PathLike[str], data: Source | memoryview) -> tuple[int, int]:
    """Width and height of a picture that `decode_texture` takes; no pixel is decoded.

    Raises:
        FileError: Of another kind, damaged or too large.
    """
    plugin = _plugin_of(path, data)
    if plugin is None:
        header = _parse_header(path, io.BytesIO(data))
        return header.width, header.height
    with _open_picture(path, io.BytesIO(data), plugin) as picture:
        width, height = picture.size
    if not 0 < width * height <= PIXEL_LIMIT:
        raise FileError(path, f"expected 1 to {PIXEL_LIMIT} pixels, got {width} x {height}", where="header")
    return width, height


def check_depth_header(path: str | os.PathLike[str], header: PictureHeader) -> None:
    """Refuse a picture that is not a 16-bit grey PNG."""
    if header.kind != "png" or header.channels != 1 or header.bits != 16:
        found = f"{header.kind.upper()} with {header.channels} x {header.bits} bits a pixel"
        remedy = "Store depth as 16-bit grey PNG (or float32 .npy); pictures coloured for viewing hold no depth"
        raise FileError(path, f"expected a depth map, got a {found}", remedy=remedy)


def check_color_header(path: str | os.PathLike[str], header: PictureHeader) -> None:
    """Refuse a picture that is a depth map."""
    if header.channels == 1 and header.bits == 16:
        raise FileError(path, "expected a colour picture, got 16-bit grey", remedy="Read depth maps with read_depth")


def write_png(path: str | os.PathLike[str], image: NDArray[np.uint8] | NDArray[np.uint16]) -> None:
    """Write an array as PNG; an existing file is replaced once the new one is complete.

    Args:
        path: Place of the file; ends in .png.
        image: uint8 of shape [h, w] or [h, w, 3] (RGB), or uint16 of shape [h, w].

    Raises:
        TypeError: Another type; nothing is converted silently.
        ValueError: Another shape, or no pixels.
        FileError: Another extension, or the place cannot be written.
    """
    if not isinstance(image, np.ndarray) or image.dtype.newbyteorder("=") not in (np.uint8, np.uint16):
        kind = image.dtype if isinstance(image, np.ndarray) else type(image).__name__
        remedy = "; loom.render(geometry) makes a picture" if hasattr(image, "transform") else ""
        raise TypeError(f"image: expected a NumPy array of uint8 or uint16, got {kind}{remedy}")
    shapes = "[h, w] or [h, w, 3]" if image.dtype == np.uint8 else "[h, w]"
    if not (image.ndim == 2 or (image.ndim == 3 and image.shape[2] == 3 and image.dtype == np.uint8)):
        raise ValueError(f"image: expected shape {shapes} for {image.dtype}, got {list(image.shape)}")
    if image.size == 0 or image.shape[0] * image.shape[1] > PIXEL_LIMIT:
        raise ValueError(f"image: expected 1 to {PIXEL_LIMIT} pixels, got shape {list(image.shape)}")
    if Path(path).suffix.lower() != ".png":
        raise FileError(path, f"expected a name that ends in .png, got {Path(path).suffix!r}")
    check_writable(path)
    pixels = np.ascontiguousarray(image, image.dtype.newbyteorder("="))
    with atomic_write(path) as file:
        Image.fromarray(pixels).save(file, "PNG", compress_level=_PNG_LEVEL)


def _read_bytes(path: str | os.PathLike[str]) -> bytes:
    try:
        return path_of(path).read_bytes()
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error


def _parse_header(path: str | os.PathLike[str], file: IO[bytes]) -> PictureHeader:
    start = file.read(33)  # PNG: magic 8, chunk head 8, IHDR 13, checksum 4
    if start.startswith(PNG_MAGIC):
        png = parse_png_header(path, start)
        header = PictureHeader("png", png.width, png.height, png.channels, png.bits)
    elif start.startswith(JPEG_MAGIC):
        file.seek(0)
        with _open_picture(path, file, JpegImagePlugin.JpegImageFile) as picture:
            header = PictureHeader("jpeg", *picture.size, len(picture.getbands()), 8)
    else:
        reason = "neither PNG nor JPEG" if start else "empty"
        raise FileError(path, reason, where="byte 0", remedy="Convert it to PNG; .npy is for depth alone")
    pixels = header.width * header.height
    if not 0 < pixels <= PIXEL_LIMIT:
        reason = f"expected 1 to {PIXEL_LIMIT} pixels, got {header.width} x {header.height}"
        raise FileError(path, reason, where="header")
    return header


def _decode(path: str | os.PathLike[str], data: bytes, header: PictureHeader, mode: str) -> NDArray:
    if header.kind == "png":
        return _decode_pixels(path, whole_png(path, data), header, mode)
    _check_whole(path)
    pixels, *others = (_decode_pixels(path, part, header, mode) for part in testable_jpegs(path, data))
    if not all(np.array_equal(pixels, other) for other in others):
        reason = "cut off or damaged: one of its scans ends before the picture does"
        raise FileError(path, reason, remedy="Fetch or write the file again")
    return pixels


def _decode_pixels(path: str | os.PathLike[str], data: bytes, header: PictureHeader, mode: str) -> NDArray:
    plugin = PngImagePlugin.PngImageFile if header.kind == "png" else JpegImagePlugin.JpegImageFile
    with _open_picture(path, io.BytesIO(data), plugin) as picture, foreign_errors(path, "damaged picture"):
        picture.load()
        if mode in ("RGB", "RGBA"):
            if mode == "RGB":
                picture.info.pop("transparency", None)  # a color key or palette of alphas, dropped like any alpha
            pixels = np.array(picture if picture.mode == mode else picture.convert(mode))
        else:
            pixels = np.array(picture).astype(np.uint16, copy=False)  # int32 in Pillow 10
    expected = (header.height, header.width, *({"RGB": (3,), "RGBA": (4,)}.get(mode, ())))
    if pixels.shape != expected:
        raise FileError(path, f"damaged picture: decodes to shape {list(pixels.shape)}, expected {list(expected)}")
    return pixels


def _open_picture(
    path: str | os.PathLike[str], file: IO[bytes], plugin: type[ImageFile.ImageFile]
) -> ImageFile.ImageFile:
    """The picture by its own class: `Image.open` would guess the kind and warn of sizes that are allowed here."""
    with foreign_errors(path, "damaged picture"):
        return plugin(file)


def _plugin_of(path: str | os.PathLike[str], data: Source | bytes | memoryview) -> type[ImageFile.ImageFile] | None:
    """Pillow's class for a TIFF, BMP or TGA file, of which the last has no mark but its name; None for other kinds."""
    start = bytes(data[:4])
    if start in (b"II*\0", b"MM\0*"):
        return TiffImagePlugin.TiffImageFile
    if start.startswith(b"BM"):
        return BmpImagePlugin.BmpImageFile
    is_targa = Path(path).suffix.lower() == ".tga" and not start.startswith((PNG_MAGIC[:4], JPEG_MAGIC))
    return TgaImagePlugin.TgaImageFile if is_targa else None


def _decode_other(path: str | os.PathLike[str], data: bytes, plugin: type[ImageFile.ImageFile]) -> NDArray[np.uint8]:
    texture_size(path, data)  # which bounds the memory
    _check_whole(path)
    with _open_picture(path, io.BytesIO(data), plugin) as picture, foreign_errors(path, "damaged picture"):
        if picture.mode not in _TEXTURE_MODES:
            raise FileError(path, f"expected 8 bits of gray or color a channel, got {picture.mode}")
        picture.load()
        has_alpha = picture.mode in ("LA", "PA", "RGBA") or "transparency" in picture.info
        return np.array(picture.convert("RGBA" if has_alpha else "RGB"))


def _check_whole(path: str | os.PathLike[str]) -> None:
    """Raise an error if Pillow fills in the pixels that a file lacks."""
    if ImageFile.LOAD_TRUNCATED_IMAGES:
        remedy = "Set PIL.ImageFile.LOAD_TRUNCATED_IMAGES = False before pictures are read"
        raise FileError(path, "somebody told Pillow to make up the pixels that a picture lacks", remedy=remedy)


def _decode_npy(path: str | os.PathLike[str], data: bytes) -> NDArray[np.float32]:
    file = io.BytesIO(data)
    with foreign_errors(path, "damaged .npy header", remedy="Save the array again"):
        shape, fortran_order, dtype = read_npy_header(file)
    if any(isinstance(extent, bool) for extent in shape):  # Python takes True for 1
        raise FileError(path, f"damaged .npy header: its shape is {shape}", remedy="Save the array again")
    if len(shape) != 2 or dtype.kind != "f" or dtype.itemsize != 4:
        reason = f"expected a float32 array of shape [h, w], got {dtype} {list(shape)}"
        raise FileError(path, reason, remedy="Save depth.astype(np.float32), one 2-D array a file")
    height, width = shape
    if height < 1 or width < 1 or height * width > PIXEL_LIMIT:
        raise FileError(path, f"expected 1 to {PIXEL_LIMIT} pixels, got {width} x {height}", where="header")
    expected, found = 4 * height * width, len(data) - file.tell()
    if found != expected:
        raise FileError(path, f"cut off or too long: {found} bytes of data, {expected} announced")
    pixels = np.frombuffer(data, dtype, offset=file.tell())
    pixels = pixels.reshape(shape, order="F" if fortran_order else "C")
    return np.array(pixels, np.float32, order="C")


def resize_color(color: NDArray[np.uint8], size: tuple[int, int], name: str) -> NDArray[np.uint8]:
    """A colour picture in another size, each pixel the mean of those that it covers.

    Args:
        color: Shape [h, w, 3].
        size: Rows and columns wanted; of the same shape, up to a pixel.
        name: What it is, for errors.

    Raises:
        ValueError: The sizes are not of the same shape, so that the two pictures cannot show the same view.
    """
    height, width = color.shape[:2]
    if abs(width * size[0] - height * size[1]) > max(width, height, *size):
        raise ValueError(f"{name}: is {width} x {height}, which is of another shape than {size[1]} x {size[0]}")
    picture = Image.fromarray(np.ascontiguousarray(color))
    kind = Image.Resampling.BOX if height > size[0] else Image.Resampling.BILINEAR
    return np.array(picture.resize((size[1], size[0]), kind))
