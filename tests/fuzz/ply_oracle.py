"""A slow parser of PLY meshes: faces, strips, vertex and face values; see oracles.py."""

from __future__ import annotations

import re
import struct
from pathlib import Path
from typing import Any

import numpy as np
from oracles import color_scale, differing_faces, integer, real, require, same, unix

from pointloom.io.table import MeshTable

_CODES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d"}
_CODES |= {"int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I"}
_CODES |= {"float32": "f", "float64": "d"}
_DTYPES = {"b": "i1", "B": "u1", "h": "i2", "H": "u2", "i": "i4", "I": "u4", "f": "f4", "d": "f8"}


class _Text:
    """Values of text data, one line per row."""

    def __init__(self, body: bytes):
        self.lines = [line.split() for line in unix(body).split(b"\n")]
        self.lines = [line for line in self.lines if line]
        self.row = self.word = -1

    def begin(self) -> None:
        self.row, self.word = self.row + 1, 0
        require(self.row < len(self.lines), "no more lines")

    def take(self, code: str) -> float:
        require(self.word < len(self.lines[self.row]), "no more values")
        word = self.lines[self.row][self.word]
        self.word += 1
        if code in "fd":
            value = real(word)
            return value if code == "d" else float(np.float64(value).astype(np.float32))
        limits = np.iinfo(_DTYPES[code])
        return integer(word, int(limits.min), int(limits.max))

    def end(self) -> None:
        require(self.word == len(self.lines[self.row]), "more values")

    def finish(self) -> None:
        require(self.row == len(self.lines) - 1, "more lines")


class _Binary:
    def __init__(self, body: bytes, order: str):
        self.body, self.order, self.at = body, order, 0

    def begin(self) -> None:
        pass

    def take(self, code: str) -> float:
        size = struct.calcsize(code)
        require(self.at + size <= len(self.body), "no more bytes")
        (value,) = struct.unpack_from(self.order + code, self.body, self.at)
        self.at += size
        return value

    def end(self) -> None:
        pass

    def finish(self) -> None:
        require(self.at == len(self.body), "more bytes")


def _elements(head: list[str]) -> tuple[str, list[tuple[str, int, list[tuple[str, str, str]]]]]:
    form, elements = "", []
    for line in head:
        words = line.split()
        if words[:1] == ["format"]:
            form = words[1]
        elif words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            count = _CODES[words[2]] if words[1] == "list" else ""
            elements[-1][2].append((words[-1], _CODES[words[-2]], count))
    return form, elements


def ply(path: Path, mesh: MeshTable) -> str | None:
    data = path.read_bytes()
    newline = b"\r" if re.match(rb"ply\r(?!\n)", data) else b"\n"
    end = re.search(rb"(?<=" + newline + rb")[ \t\r\v\f]*end_header[ \t\r\v\f]*(" + newline + rb"|$)", data)
    require(end is not None, "no end of the header")
    assert end is not None
    form, elements = _elements(data[: end.start()].decode().split(newline.decode()))
    body = data[end.end() :]
    source: Any = _Text(body) if form == "ascii" else _Binary(body, "<" if "little" in form else ">")
    read: dict[str, dict[str, list[Any]]] = {}
    for name, count, properties in elements:
        rows: dict[str, list[Any]] = {prop: [] for prop, _, _ in properties}
        for _ in range(count if properties else 0):
            source.begin()
            for prop, code, length in properties:
                size = int(source.take(length)) if length else 1
                require(size >= 0 and size <= len(data), "a length")
                if length and name == "vertex" and form == "ascii":
                    code = "d"  # skipped
                values = [source.take(code) for _ in range(size)]
                rows[prop].append(values if length else values[0])
            source.end()
        read[name] = rows
    source.finish()
    return _differences(mesh, read, {name: {prop: code for prop, code, _ in props} for name, _, props in elements})


def _differences(
    mesh: MeshTable, read: dict[str, dict[str, list[Any]]], codes: dict[str, dict[str, str]]
) -> str | None:
    vertex, face = read["vertex"], read.get("face", {})
    with np.errstate(all="ignore"):
        points = np.array([vertex[axis] for axis in "xyz"], np.float64).T.astype(mesh.vertices.dtype)
    if not same(mesh.vertices, points.reshape(-1, 3)):
        return "the vertices differ"
    for name, values in mesh.attributes.items():
        if not same(values, np.array(vertex[name]).astype(_DTYPES[codes["vertex"][name]])):
            return f"the values {name!r} of vertices differ"
    corners = next((face[name] for name in face if name in ("vertex_indices", "vertex_index")), [])
    faces = [[int(corner) for corner in row] for row in corners]
    lengths = [max(len(row) - 2, 0) for row in faces]
    for name, values in mesh.triangle_attributes.items():
        full = {"u1": 255, "u2": 65535, "i1": 255, "i2": 255, "i4": 255, "u4": 255}
        if name == "colors":
            channels = ["red", "green", "blue", "alpha"][: values.shape[1]]
            given = np.array([face[channel] for channel in channels], np.float64).T
            scale = full.get(_DTYPES[codes["face"]["red"]]) or color_scale(given)
            if not (np.abs(np.repeat(np.clip(given / scale, 0, 1), lengths, axis=0) - values) <= 2e-7).all():
                return "the colors of faces differ"
        elif not same(values, np.repeat(np.array(face[name]).astype(_DTYPES[codes["face"][name]]), lengths)):
            return f"the values {name!r} of faces differ"
    for row in faces:
        require(all(0 <= corner < len(points) for corner in row), f"a face {row}")
    strips = next((values for name, values in read.get("tristrips", {}).items() if "vertex_ind" in name), [])
    return differing_faces(mesh, faces + [t for strip in strips for t in _strip(strip, len(points))])


def _strip(strip: list[int], count: int) -> list[list[int]]:
    require(all(-1 <= corner < count for corner in strip), "a strip")
    triangles, part = [], []
    for corner in strip:
        if corner == -1:
            part = []
            continue
        part.append(corner)
        if len(part) > 2 and len(set(part[-3:])) == 3:
            a, b, c = part[-3:]
            triangles.append([a, b, c] if len(part) % 2 else [b, a, c])
    return triangles
