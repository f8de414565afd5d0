"""Depth maps and color images: PNG, JPEG and .npy, read strictly and written atomically.

PNG is verified before decoding (png_stream.py). For JPEG, which has no checksum, only truncated scans are detected, as
libjpeg fills them with gray: the marker after a single scan is replaced by as many bits as a decoder looks ahead. With
several scans, pixels must not depend on the bytes after a scan. At most two 8 x 8 blocks may be missing undetected.
Color profiles, gamma and EXIF orientation are not applied. ITU-T T.81, sections B.1, B.2 and F.2.2.3.
"""

from __future__ import annotations

import base64
import dataclasses
import io
import itertools
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO

import numpy as np
from numpy.typing import NDArray
from PIL import BmpImagePlugin, Image, ImageFile, JpegImagePlugin, PngImagePlugin, TgaImagePlugin, TiffImagePlugin

from ...core.atomic import atomic_write, check_writable
from ...core.errors import FileError, FilePath
from ...core.paths import input_path
from ..npy_header import read_npy_header
from ..optional_imports import foreign_errors
from .png_stream import PNG_MAGIC, checked_png, parse_png_header

JPEG_MAGIC = b"\xff\xd8\xff"

_JPEG_EOI, _JPEG_SOS, _JPEG_DRI = 0xD9, 0xDA, 0xDD
_JPEG_PROGRESSIVE = 0xC2
_HUFFMAN_FRAMES = (0xC0, 0xC1, _JPEG_PROGRESSIVE)
_OTHER_FRAMES = {*range(0xC3, 0xD0)} - {0xC4, 0xC8, 0xCC}  # lossless, hierarchical, arithmetic
_JPEG_STANDALONE = {0x01, *range(0xD0, 0xD8)}

# A scan ends at the first marker that is neither a stuffed zero nor a restart.
_SCAN_END = re.compile(rb"\xff(?=[^\x00\xd0-\xd7\xff])")
_RESTART = re.compile(rb"\xff[\xd0-\xd7]")

# libjpeg fills a register of 64 bits before each code. A run of ones is no code: a block takes at least 34 of them.
_LOOK_AHEAD = b"\xff\x00" * 8

# Bits that no image ends with by chance, for the second decoding of a file with several scans.
_SEPARATOR_BYTES = bytes((k * 167 + 71) % 251 for k in range(96))

_REMEDY = "Fetch or write the file again"


@dataclass
class _Layout:
    width: int = 0
    height: int = 0
    is_progressive: bool = False
    restart_interval: int = 0
    sampling: dict[int, tuple[int, int]] = field(default_factory=dict)  # horizontal and vertical, by component
    bits_left: dict[int, list[int]] = field(default_factory=dict)  # of each coefficient, by component
    scans: list[tuple[int, int]] = field(default_factory=list)  # first byte and end of the coded pixels

    def unit_count(self, components: list[int]) -> int:
        """Number of coded units of a scan: 8 x 8 blocks for one component, else groups of blocks."""
        max_sampling = [max(values) for values in zip(*self.sampling.values(), strict=True)]
        sampling = self.sampling[components[0]] if len(components) == 1 else (1, 1)
        sides = zip((self.width, self.height), sampling, max_sampling, strict=True)
        across, down = (-(-size * part // (8 * max_factor)) for size, part, max_factor in sides)
        return across * down


def testable_jpegs(path: FilePath, data: bytes) -> list[bytes]:
    """The JPEG to decode, or two variants that must decode to the same pixels. Raises `FileError` if truncated."""
    layout = _parse_segments(path, data)
    if not layout.scans or any(bits for left in layout.bits_left.values() for bits in left):
        raise FileError(path, "cut off: it ends before the scans of all its channels", remedy=_REMEDY)
    if len(layout.scans) == 1:
        return [data[: layout.scans[0][1]] + _LOOK_AHEAD]
    offsets = [0, *(end for _, end in layout.scans), len(data)]
    parts = [data[begin:end] for begin, end in itertools.pairwise(offsets)]
    return [data, _SEPARATOR_BYTES.join(parts)]


def _parse_segments(path: FilePath, data: bytes) -> _Layout:
    """Parse the segments up to the end marker. Data after it is ignored."""
    layout, offset = _Layout(), 2
    while True:
        marker, offset = _marker(path, data, offset)
        if marker == _JPEG_EOI:
            return layout
        if marker in _JPEG_STANDALONE:
            continue
        length = int.from_bytes(data[offset : offset + 2], "big")
        segment, begin = data[offset + 2 : offset + length], offset
        offset += length
        if length < 2 or offset > len(data):
            reason = f"cut off or damaged: a segment of {length} bytes, {len(data) - begin} are left"
            raise FileError(path, reason, where=f"byte {begin}", remedy=_REMEDY)
        if marker in _OTHER_FRAMES:
            reason = f"its pixels are coded in a way (SOF{marker - 0xC0}) that cannot be checked for completeness"
            raise FileError(path, reason, where=f"byte {begin}", remedy="Store it as PNG, or as baseline JPEG")
        if marker in _HUFFMAN_FRAMES:
            _read_frame(path, segment, begin, layout)
            layout.is_progressive = marker == _JPEG_PROGRESSIVE
        elif marker == _JPEG_DRI:
            layout.restart_interval = int.from_bytes(segment[:2], "big")
        elif marker == _JPEG_SOS:
            components = _read_scan(path, segment, begin, layout)
            scan_end = _SCAN_END.search(data, offset)
            if scan_end is None:
                reason = "cut off: the end of the JPEG is missing"
                raise FileError(path, reason, where=f"byte {len(data)}", remedy=_REMEDY)
            coded = data[offset : scan_end.start()].rstrip(b"\xff")  # a marker may have several bytes of 0xff before it
            _check_scan(path, coded, offset, layout, layout.unit_count(components))
            layout.scans.append((offset, offset + len(coded)))
            offset += len(coded)


def _check_scan(path: FilePath, coded: bytes, begin: int, layout: _Layout, units: int) -> None:
    if not layout.scans and units > 8 * len(coded):  # each takes at least one bit in a first scan
        reason = f"{layout.width} x {layout.height} pixels cannot fit into {len(coded)} bytes"
        raise FileError(path, f"cut off or damaged: {reason}", where=f"byte {begin}", remedy=_REMEDY)
    if layout.restart_interval:
        expected, marker_count = (units - 1) // layout.restart_interval, len(_RESTART.findall(coded))
        if marker_count < expected:
            reason = f"cut off or damaged: a scan has {marker_count} of {expected} restart marks"
            raise FileError(path, reason, where=f"byte {begin}", remedy=_REMEDY)


def _marker(path: FilePath, data: bytes, offset: int) -> tuple[int, int]:
    """The marker at a byte, after fill bytes, and the position after it."""
    if offset >= len(data):
        raise FileError(path, "cut off: the end of the JPEG is missing", where=f"byte {offset}", remedy=_REMEDY)
    start = offset
    while data[offset : offset + 1] == b"\xff":
        offset += 1
    if offset == start or offset >= len(data) or not data[offset]:
        raise FileError(path, "damaged image: no JPEG marker", where=f"byte {start}", remedy=_REMEDY)
    return data[offset], offset + 1


def _read_frame(path: FilePath, segment: bytes, begin: int, layout: _Layout) -> None:
    count = segment[5] if len(segment) > 5 else 0
    if layout.sampling or not count or len(segment) < 6 + 3 * count:
        raise FileError(path, "damaged: its frame", where=f"byte {begin}", remedy=_REMEDY)
    layout.height, layout.width = (int.from_bytes(segment[k : k + 2], "big") for k in (1, 3))
    for k in range(6, 6 + 3 * count, 3):
        layout.sampling[segment[k]] = max(1, segment[k + 1] >> 4), max(1, segment[k + 1] & 15)
        layout.bits_left[segment[k]] = [1] * 64


def _read_scan(path: FilePath, segment: bytes, begin: int, layout: _Layout) -> list[int]:
    """The components of a scan. Records how many coefficient bits later scans must add."""
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


# Larger images are rejected before allocation: 2^28 pixels are 0.75 GiB of color, more than any camera has.
PIXEL_LIMIT = 2**28

# A 7-Scenes depth map takes 119 KiB and 7 ms at level 1, 90 KiB and 20 ms at level 6, the default.
_PNG_LEVEL = 1

_TEXTURE_MODES = ("1", "L", "LA", "P", "PA", "RGB", "RGBA")

_NPY_MAGIC = b"\x93NUMPY"


@dataclasses.dataclass(frozen=True)
class ImageHeader:
    """Size and type of an image; `kind` is "png" or "jpeg", `bits` is per channel."""

    kind: str
    width: int
    height: int
    channels: int
    bits: int


def read_depth(path: FilePath) -> NDArray[np.uint16] | NDArray[np.float32]:
    """Read a depth map as stored, without scaling.

    A 16-bit gray PNG gives uint16, a .npy file of a 2-D float32 array gives float32.

    Returns:
        Shape (h, w); writable.

    Raises:
        FileError: Unreadable, damaged, too large, or no depth map (8 bits, color).

    Example:
        >>> import numpy as np, pointloom as loom
        >>> np.save("depth.npy", np.full((48, 64), 1.5, np.float32))
        >>> loom.read_depth("depth.npy").shape
        (48, 64)
    """
    data = _read_bytes(path)
    return _decode_npy(path, data) if data.startswith(_NPY_MAGIC) else decode_depth(path, data)


def decode_depth(path: FilePath, data: bytes) -> NDArray[np.uint16]:
    """Decode a 16-bit gray PNG to a depth map, shape (h, w); `path` is for errors."""
    header = _parse_header(path, io.BytesIO(data))
    check_depth_header(path, header)
    return _decode(path, data, header, "I;16")


def read_color(path: FilePath) -> NDArray[np.uint8]:
    """Read a PNG or JPEG image as RGB. Gray is replicated, transparency is dropped.

    Returns:
        Shape (h, w, 3), uint8, writable.

    Raises:
        FileError: Unreadable, damaged, too large, or 16-bit gray, which is a depth map.

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


def decode_texture(path: FilePath, data: bytes) -> NDArray[np.uint8]:
    """Decode a PNG, JPEG, TIFF, BMP or TGA image (8 bits per channel) to uint8 (h, w, 3 or 4); `path` is for errors."""
    if plugin := _plugin_of(path, data):
        return _decode_other(path, data, plugin)
    header = _parse_header(path, io.BytesIO(data))
    check_color_header(path, header)
    has_alpha = header.kind == "png" and (header.channels in (2, 4) or b"tRNS" in data[: data.find(b"IDAT")])
    return _decode(path, data, header, "RGBA" if has_alpha else "RGB")


def encode_png(array: NDArray[np.uint8] | NDArray[np.uint16]) -> bytes:
    file = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(array)).save(file, "PNG", compress_level=_PNG_LEVEL)
    return file.getvalue()


def png_url(array: NDArray[np.uint8]) -> str:
    """An image as the address of its own data, for pages without other files."""
    return f"data:image/png;base64,{base64.b64encode(encode_png(array)).decode()}"


def read_image_header(path: FilePath) -> ImageHeader:
    try:
        with input_path(path).open("rb") as file:
            return _parse_header(path, file)
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error


def texture_size(path: FilePath, data: bytes | memoryview) -> tuple[int, int]:
    """Width and height of an image that `decode_texture` accepts, without decoding it."""
    plugin = _plugin_of(path, data)
    if plugin is None:
        header = _parse_header(path, io.BytesIO(data))
        return header.width, header.height
    with _open_image(path, io.BytesIO(data), plugin) as image:
        width, height = image.size
    if not 0 < width * height <= PIXEL_LIMIT:
        raise FileError(path, f"expected 1 to {PIXEL_LIMIT} pixels, got {width} x {height}", where="header")
    return width, height


def check_depth_header(path: FilePath, header: ImageHeader) -> None:
    if header.kind != "png" or header.channels != 1 or header.bits != 16:
        given = f"{header.kind.upper()} with {header.channels} x {header.bits} bits a pixel"
        remedy = "Store depth as 16-bit gray PNG (or float32 .npy); images colored for viewing contain no depth"
        raise FileError(path, f"expected a depth map, got a {given}", remedy=remedy)


def check_color_header(path: FilePath, header: ImageHeader) -> None:
    if header.channels == 1 and header.bits == 16:
        raise FileError(path, "expected a color image, got 16-bit gray", remedy="Read depth maps with read_depth")


def write_png(path: FilePath, image: NDArray[np.uint8] | NDArray[np.uint16]) -> None:
    """Write uint8 (h, w) or (h, w, 3), or uint16 (h, w), as PNG atomically. No type is converted silently."""
    if not isinstance(image, np.ndarray) or image.dtype.newbyteorder("=") not in (np.uint8, np.uint16):
        kind = image.dtype if isinstance(image, np.ndarray) else type(image).__name__
        remedy = "; loom.render(geometry) creates an image" if hasattr(image, "transform") else ""
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


def _read_bytes(path: FilePath) -> bytes:
    try:
        return input_path(path).read_bytes()
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error


def _parse_header(path: FilePath, file: IO[bytes]) -> ImageHeader:
    start = file.read(33)  # PNG: magic 8, chunk head 8, IHDR 13, checksum 4
    if start.startswith(PNG_MAGIC):
        png = parse_png_header(path, start)
        header = ImageHeader("png", png.width, png.height, png.channels, png.bits)
    elif start.startswith(JPEG_MAGIC):
        file.seek(0)
        with _open_image(path, file, JpegImagePlugin.JpegImageFile) as image:
            header = ImageHeader("jpeg", *image.size, len(image.getbands()), 8)
    else:
        reason = "neither PNG nor JPEG" if start else "empty"
        raise FileError(path, reason, where="byte 0", remedy="Convert it to PNG; .npy is only for depth")
    pixels = header.width * header.height
    if not 0 < pixels <= PIXEL_LIMIT:
        reason = f"expected 1 to {PIXEL_LIMIT} pixels, got {header.width} x {header.height}"
        raise FileError(path, reason, where="header")
    return header


def _decode(path: FilePath, data: bytes, header: ImageHeader, mode: str) -> NDArray:
    if header.kind == "png":
        return _decode_pixels(path, checked_png(path, data), header, mode)
    _check_truncation_setting(path)
    pixels, *others = (_decode_pixels(path, part, header, mode) for part in testable_jpegs(path, data))
    if not all(np.array_equal(pixels, other) for other in others):
        reason = "cut off or damaged: one of its scans ends before the image does"
        raise FileError(path, reason, remedy="Fetch or write the file again")
    return pixels


def _decode_pixels(path: FilePath, data: bytes, header: ImageHeader, mode: str) -> NDArray:
    plugin = PngImagePlugin.PngImageFile if header.kind == "png" else JpegImagePlugin.JpegImageFile
    with _open_image(path, io.BytesIO(data), plugin) as image, foreign_errors(path, "damaged image"):
        image.load()
        if mode in ("RGB", "RGBA"):
            if mode == "RGB":
                image.info.pop("transparency", None)  # a color key or palette of alphas, dropped like any alpha
            pixels = np.array(image if image.mode == mode else image.convert(mode))
        else:
            pixels = np.array(image).astype(np.uint16, copy=False)  # int32 in Pillow 10
    expected = (header.height, header.width, *({"RGB": (3,), "RGBA": (4,)}.get(mode, ())))
    if pixels.shape != expected:
        raise FileError(path, f"damaged image: decodes to shape {list(pixels.shape)}, expected {list(expected)}")
    return pixels


def _open_image(path: FilePath, file: IO[bytes], plugin: type[ImageFile.ImageFile]) -> ImageFile.ImageFile:
    """Open an image by its format class: `Image.open` would guess and warn of sizes that are allowed here."""
    with foreign_errors(path, "damaged image"):
        return plugin(file)


def _plugin_of(path: FilePath, data: bytes | memoryview) -> type[ImageFile.ImageFile] | None:
    """Pillow's class for a TIFF, BMP or TGA file (TGA by its extension only). None for other formats."""
    start = bytes(data[:4])
    if start in (b"II*\0", b"MM\0*"):
        return TiffImagePlugin.TiffImageFile
    if start.startswith(b"BM"):
        return BmpImagePlugin.BmpImageFile
    is_targa = Path(path).suffix.lower() == ".tga" and not start.startswith((PNG_MAGIC[:4], JPEG_MAGIC))
    return TgaImagePlugin.TgaImageFile if is_targa else None


def _decode_other(path: FilePath, data: bytes, plugin: type[ImageFile.ImageFile]) -> NDArray[np.uint8]:
    texture_size(path, data)  # which bounds the memory
    _check_truncation_setting(path)
    with _open_image(path, io.BytesIO(data), plugin) as image, foreign_errors(path, "damaged image"):
        if image.mode not in _TEXTURE_MODES:
            raise FileError(path, f"expected 8 bits of gray or color a channel, got {image.mode}")
        image.load()
        has_alpha = image.mode in ("LA", "PA", "RGBA") or "transparency" in image.info
        return np.array(image.convert("RGBA" if has_alpha else "RGB"))


def _check_truncation_setting(path: FilePath) -> None:
    """Raise an error if Pillow fills in missing pixels."""
    if ImageFile.LOAD_TRUNCATED_IMAGES:
        remedy = "Set PIL.ImageFile.LOAD_TRUNCATED_IMAGES = False before reading images"
        raise FileError(path, "Pillow is configured to fill in missing pixels", remedy=remedy)


def _decode_npy(path: FilePath, data: bytes) -> NDArray[np.float32]:
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
    expected, byte_count = 4 * height * width, len(data) - file.tell()
    if byte_count != expected:
        raise FileError(path, f"cut off or too long: {byte_count} bytes of data, {expected} declared")
    pixels = np.frombuffer(data, dtype, offset=file.tell())
    pixels = pixels.reshape(shape, order="F" if fortran_order else "C")
    return np.array(pixels, np.float32, order="C")


def resize_color(color: NDArray[np.uint8], size: tuple[int, int], name: str) -> NDArray[np.uint8]:
    """Resize a color image by area averaging. Raises `ValueError` if the aspect ratio changes by more than a pixel."""
    height, width = color.shape[:2]
    if abs(width * size[0] - height * size[1]) > max(width, height, *size):
        raise ValueError(f"{name}: is {width} x {height}, which has another shape than {size[1]} x {size[0]}")
    image = Image.fromarray(np.ascontiguousarray(color))
    kind = Image.Resampling.BOX if height > size[0] else Image.Resampling.BILINEAR
    return np.array(image.resize((size[1], size[0]), kind))
