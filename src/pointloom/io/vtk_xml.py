"""VTK's XML files of polygonal data (.vtp): ASCII, base64 and raw, without compression or with zlib or LZMA.

Kitware, "VTK File Formats" (2022). Files are written with raw numbers after the XML part, without compression.
"""

from __future__ import annotations

import base64
import lzma
import re
import xml.etree.ElementTree as ET
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import IO, Any, Literal
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import NDArray

from ..core.errors import FileError
from ..core.other_geometry import CRS, UNIT
from ..core.to_other_libraries import NORMALS, UVS
from .source import open_source
from .vtk_data import KINDS, Cells, VtkData, check_data, parse_numbers
from .xml_elements import LimitedBuilder

_XML_TYPES = {
    f"{name}{8 * size}": f"{code}{size}"
    for name, code, sizes in (("Int", "i", (1, 2, 4, 8)), ("UInt", "u", (1, 2, 4, 8)), ("Float", "f", (4, 8)))
    for size in sizes
}
_COMPRESSORS: dict[str, Callable[..., Any]] = {
    "vtkZLibDataCompressor": zlib.decompressobj,
    "vtkLZMADataCompressor": lzma.LZMADecompressor,
}
_CELLS = dict(zip(("Verts", "Lines", "Polys", "Strips"), KINDS, strict=True))
_VISIBLE = re.compile(rb"\S")
_MAX_TEXT = 1 << 20  # [B] of a unit or a coordinate system: the longest WKT texts have some 10,000
_APPENDED = re.compile(rb"<AppendedData\s+encoding\s*=\s*[\"'](raw|base64)[\"']\s*>\s*_")


def read_xml(path: Path) -> VtkData:
    """Read the points, cells and arrays of a .vtp file with one piece."""
    return _Reader(path).read()


class _Reader:
    """The XML part of a file, and the numbers after it."""

    def __init__(self, path: Path):
        self.path, body = path, bytes(open_source(path)[:])
        found = _APPENDED.search(body)
        self.appended, self.is_raw = b"", False
        if found is not None:
            self.is_raw, self.appended = found[1] == b"raw", body[found.end() :]
            end = self.appended.rfind(b"</AppendedData>")
            if end < 0:
                raise FileError(path, "is truncated: the appended data have no end")
            body, self.appended = body[: found.start()] + b"</VTKFile>", self.appended[:end]
        try:
            self.root = ET.fromstring(body, ET.XMLParser(target=LimitedBuilder()))
        except (ET.ParseError, ValueError, LookupError) as error:  # also of the builder, or an unknown encoding
            raise FileError(path, f"is not intact XML: {error}") from error
        if self.root.tag != "VTKFile" or self.root.get("type") != "PolyData":
            raise FileError(path, f"expected VTK polygonal data, got {self.root.tag[:40]} {self.root.get('type')}")
        self.order: Literal["<", ">"] = ">" if self.root.get("byte_order") == "BigEndian" else "<"
        self.header = np.dtype({"UInt32": "u4", "UInt64": "u8"}.get(self.root.get("header_type", "UInt32"), "V"))
        compressor = self.root.get("compressor")
        if self.header.kind == "V" or (compressor and compressor not in _COMPRESSORS):
            what = compressor or self.root.get("header_type")
            raise FileError(path, f"{what} is not supported", remedy="Write it with zlib, or without compression")
        self.decompressor = _COMPRESSORS[compressor] if compressor else None
        self.unread = len(self.appended)  # bytes of the appended data that no array has used

    def read(self) -> VtkData:
        pieces = self.root.findall("./PolyData/Piece")
        if len(pieces) != 1:
            raise FileError(self.path, f"expected one piece, got {len(pieces)}", remedy="Merge the pieces first")
        piece = pieces[0]
        points = piece.find("./Points/DataArray")
        count = self._count(piece, "NumberOfPoints")
        if points is None:
            raise FileError(self.path, "contains no points")
        values = self._array(points, count, 3)
        data = VtkData(values if values.dtype.kind == "f" else values.astype(np.float64))
        for tag, kind in _CELLS.items():
            data.cells[kind] = self._cells(piece, tag, self._count(piece, f"NumberOf{tag}", optional=True))
        cell_count = sum(len(cells.lengths) for cells in data.cells.values())
        for target, tag, rows in ((data.point_data, "PointData", count), (data.cell_data, "CellData", cell_count)):
            part = piece.find(tag)
            for element in () if part is None else part.findall("DataArray"):
                name = element.get("Name", "")
                name = NORMALS if part is not None and name == part.get("Normals") else name
                name = UVS if part is not None and name == part.get("TCoords") else name
                if name in target:
                    raise FileError(self.path, f"the array {name[:60]!r} is duplicated")
                width = self._count(element, "NumberOfComponents", optional=True) or 1
                array = self._array(element, rows, width)
                target[name] = array[:, 0] if width == 1 else array
        for element in self.root.iterfind("./PolyData/FieldData/*"):
            data.field_data[element.get("Name", "")] = self._field(element)
        check_data(self.path, data)
        return data

    def _count(self, element: ET.Element, name: str, *, optional: bool = False) -> int:
        text = element.get(name, "0" if optional else "")
        if not re.fullmatch(r"\s*[0-9]{1,19}\s*", text):
            raise FileError(self.path, f"{name}: expected a count, got {text[:40]!r}")
        return int(text)

    def _cells(self, piece: ET.Element, tag: str, count: int) -> Cells:
        arrays = {element.get("Name"): element for element in piece.findall(f"./{tag}/DataArray")}
        if not count:
            return Cells()
        if not {"connectivity", "offsets"} <= arrays.keys():
            raise FileError(self.path, f"{tag}: connectivity or offsets are missing")
        ends = self._array(arrays["offsets"], count, 1)[:, 0].astype(np.int64)
        lengths = np.diff(ends, prepend=0)
        if lengths.min() < 0:
            raise FileError(self.path, f"{tag}: the offsets are damaged")
        return Cells(lengths, self._array(arrays["connectivity"], int(ends[-1]), 1)[:, 0].astype(np.int64))

    def _field(self, element: ET.Element) -> Any:
        """A unit or a coordinate system, or None for other values, which pointloom does not store."""
        if element.get("type") != "String" or element.get("Name") not in (UNIT, CRS):
            return None
        codes = self._values(element, np.dtype("u1"), _MAX_TEXT).tobytes()
        return codes.rstrip(b"\0").decode("utf-8", "replace")

    def _array(self, element: ET.Element, rows: int, width: int) -> NDArray[Any]:
        kind = element.get("type", "")
        if kind not in _XML_TYPES:
            raise FileError(self.path, f"the type {kind[:40]!r} is not supported")
        dtype = np.dtype(_XML_TYPES[kind])
        values = self._values(element, dtype, rows * width * dtype.itemsize)
        if len(values) != rows * width:
            name = element.get("Name", "")[:60]
            raise FileError(self.path, f"{name!r}: expected {rows} x {width} numbers, got {len(values)}")
        return values.reshape(rows, width)

    def _values(self, element: ET.Element, dtype: np.dtype[Any], max_bytes: int) -> NDArray[Any]:
        """The numbers of an array, which is not decompressed if it declares more than `max_bytes`."""
        format, name = element.get("format"), element.get("Name", "")[:60]
        try:
            if format == "ascii":
                return parse_numbers((element.text or "").encode().split(), dtype)
            if format == "appended":
                begin = self._count(element, "offset")
                data = _Stream(self.appended if self.is_raw else _Base64(self.appended, begin), begin * self.is_raw)
            elif format == "binary":
                data = _Stream(_Base64((element.text or "").encode(), 0), 0)
            else:
                raise ValueError(f"the format {format!r} is not supported")
            body = self._decompressed(data, max_bytes) if self.decompressor else data.take(self._header(data, 1)[0])
            self.unread -= data.count if format == "appended" else 0
            if self.unread < 0:
                raise ValueError("it overlaps other arrays")
        except (ValueError, OverflowError, zlib.error, lzma.LZMAError, EOFError) as error:
            raise FileError(self.path, f"the array {name!r} is damaged: {error}") from error
        if len(body) % dtype.itemsize:
            raise FileError(self.path, f"the array {name!r} has {len(body)} bytes, which are no numbers of {dtype}")
        return np.frombuffer(body, dtype.newbyteorder(self.order)).astype(dtype)

    def _header(self, data: _Stream, count: int) -> list[int]:
        raw = data.take(count * self.header.itemsize)
        return [int(value) for value in np.frombuffer(raw, self.header.newbyteorder(self.order))]

    def _decompressed(self, data: _Stream, max_bytes: int) -> bytes:
        """The joined blocks. Their number, size, last size and compressed sizes come first and are checked first."""
        (blocks,) = self._header(data, 1)
        if blocks == 0:
            return b""
        size, last = self._header(data, 2)
        stored = self._header(data, blocks)
        if (declared := (blocks - bool(last)) * size + last) > max_bytes:
            raise ValueError(f"its blocks have {declared} bytes, expected {max_bytes}")
        data.end_header()
        parts = []
        for number, length in enumerate(stored):
            expected = last if last and number == blocks - 1 else size
            assert self.decompressor is not None
            decompressor = self.decompressor()
            part = decompressor.decompress(data.take(length), expected + 1)
            if len(part) != expected:
                size_text = f"more than {expected}" if len(part) > expected else str(len(part))
                raise ValueError(f"block {number} has {size_text} bytes, not {expected}")
            if not decompressor.eof:
                raise ValueError(f"block {number} is truncated")
            parts.append(part)
        return b"".join(parts)


class _Stream:
    """Bytes that are taken in order, from `at`. In base64, the header of compressed blocks is encoded separately."""

    def __init__(self, body: bytes | _Base64, at: int):
        self.body, self.at, self.count = body, at, 0

    def take(self, count: int) -> bytes:
        part = self.body[self.at : self.at + count]
        if len(part) < count:
            raise ValueError(f"{count - len(part)} bytes are missing")
        self.at += count
        self.count += count
        return part

    def end_header(self) -> None:
        if isinstance(self.body, _Base64):
            self.body, self.at = self.body.after(self.at), 0


class _Base64:
    """Base64 text from a position, whose bytes are decoded when they are taken."""

    def __init__(self, text: bytes, begin: int):
        found = _VISIBLE.search(text, begin)
        self.text, self.begin = text, len(text) if found is None else found.start()

    def __getitem__(self, part: slice) -> bytes:
        first = part.start // 3
        encoded = self.text[self.begin + 4 * first : self.begin + 4 * (-(-part.stop // 3))].rstrip()
        end = encoded.find(b"=")
        encoded = encoded if end < 0 else encoded[: 4 * (end // 4 + 1)]
        return base64.b64decode(encoded, validate=True)[part.start - 3 * first : part.stop - 3 * first]

    def after(self, count: int) -> _Base64:
        """The text after `count` bytes, which were encoded separately."""
        return _Base64(self.text, self.begin + 4 * (-(-count // 3)))


def write_xml(file: IO[bytes], data: VtkData) -> None:
    """Write polygonal data with raw numbers after the XML part."""
    body: list[bytes] = []
    size = 0

    def array(name: str, values: NDArray[Any]) -> str:
        nonlocal size
        raw = np.ascontiguousarray(values, values.dtype.newbyteorder("<")).tobytes()
        kind = next(kind for kind, code in _XML_TYPES.items() if values.dtype == np.dtype(code))
        width = values.shape[1] if values.ndim == 2 else 1
        text = f'<DataArray type="{kind}" Name={quoteattr(name)} NumberOfComponents="{width}" '
        text += f'format="appended" offset="{size}"/>\n'
        body.append(len(raw).to_bytes(8, "little") + raw)
        size += 8 + len(raw)
        return text

    def arrays(tag: str, rows: dict[str, NDArray[Any]], roles: str = "") -> str:
        return f"<{tag}{roles}>\n{''.join(array(name, values) for name, values in rows.items())}</{tag}>\n"

    counts = "".join(f' NumberOf{tag}="{len(data.cells[kind].lengths)}"' for tag, kind in _CELLS.items())
    roles = f' Normals="{NORMALS}"' if NORMALS in data.point_data else ""
    roles += f' TCoords="{UVS}"' if UVS in data.point_data else ""
    texts = ['<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" ']
    texts.append('header_type="UInt64">\n<PolyData>\n')
    if data.field_data:
        texts.append("<FieldData>\n")
        for name, text in data.field_data.items():
            codes = " ".join(str(code) for code in (*text.encode(), 0))
            texts.append(
                f'<Array type="String" Name={quoteattr(name)} NumberOfTuples="1" format="ascii">{codes}</Array>\n'
            )
        texts.append("</FieldData>\n")
    texts.append(f'<Piece NumberOfPoints="{len(data.points)}"{counts}>\n')
    texts += [arrays("PointData", data.point_data, roles), arrays("CellData", data.cell_data)]
    texts.append(arrays("Points", {"Points": data.points}))
    for tag, kind in _CELLS.items():
        cells = data.cells[kind]
        if len(cells.lengths):
            texts.append(arrays(tag, {"connectivity": cells.points, "offsets": np.cumsum(cells.lengths)}))
    texts.append('</Piece>\n</PolyData>\n<AppendedData encoding="raw">\n_')
    file.write("".join(texts).encode())
    for part in body:
        file.write(part)
    file.write(b"\n</AppendedData>\n</VTKFile>\n")
