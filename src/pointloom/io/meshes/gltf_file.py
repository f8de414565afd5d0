"""glTF 2.0 files: the JSON of a GLB or text file, and the bytes in the GLB, `data:` URIs or neighboring files.

All values are validated before use. Nothing is downloaded. Khronos, "glTF 2.0 Specification", sections 2.8, 3.4, 3.6.1.
"""

from __future__ import annotations

import base64
import binascii
import json
import re
from contextlib import suppress
from pathlib import Path
from typing import Any
from urllib.parse import unquote, unquote_to_bytes

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError, FilePath
from ...core.up_axis import Direction, check_up
from ..images.texture_files import find_beside, why_missing
from ..source import open_source
from .glb_container import GLB_MAGIC, split_chunks

# Limits on elements, so that few bytes cannot declare endless ones: this many in any case, and this many
# per byte. A stored triangle takes at least a byte, a compressed one seldom less than a bit.
FREE_ELEMENTS, ELEMENTS_A_BYTE = 2**23, 16

UP_BEFORE = "pointloom_up"  # in the extras of the asset

_SCHEME = re.compile(r"[A-Za-z][A-Za-z0-9+.-]+:")
_BAD_ESCAPE = re.compile(r"%(?![0-9A-Fa-f]{2})")


class GltfFile:
    """A glTF file with a valid container and JSON (`content`); `size` includes referenced files."""

    def __init__(self, path: FilePath, *, outside_files: bool = False):
        self.path, self.outside_files = Path(path), outside_files
        data = memoryview(open_source(path)[:])
        self.size = len(data)
        text, self.binary = data, None
        if data[:4] == GLB_MAGIC or self.path.suffix.lower() == ".glb":
            text, self.binary = split_chunks(self.path, data)
        try:
            content = json.loads(bytes(text).decode("utf-8-sig"), parse_constant=_refuse_constant)
        except (ValueError, RecursionError) as error:
            raise self.error(f"its JSON is damaged: {error}"[:200]) from error
        if not isinstance(content, dict):
            raise self.error("its JSON is not an object")
        self.content: dict[str, Any] = content
        self._objects: dict[str, list[dict[str, Any]]] = {}  # checked lists by kind
        version = content.get("asset", {}).get("version") if isinstance(content.get("asset"), dict) else None
        if not isinstance(version, str) or not version.startswith("2."):
            raise self.error(f"glTF {version!r}; version 2 is read")

    def error(self, reason: str, where: str = "", remedy: str = "") -> FileError:
        return FileError(self.path, reason, where=where, remedy=remedy)

    def check_count(self, count: int, what: str) -> None:
        """Raise `FileError` if a count is implausible for the file size."""
        limit = max(FREE_ELEMENTS, ELEMENTS_A_BYTE * self.size)
        if count > limit:
            reason = f"{what} are {count:,}, more than {limit:,}, for a file of {self.size:,} bytes"
            raise self.error(reason, remedy="Join or drop some in the program that wrote it")

    @property
    def up_before(self) -> Direction | None:
        """Up direction of the mesh before `write_mesh` rotated it to y, if this library did."""
        extras = self.content["asset"].get("extras")
        up = extras.get(UP_BEFORE) if isinstance(extras, dict) else None
        with suppress(TypeError, ValueError):
            return None if up is None or isinstance(up, str) else check_up(up)
        return None

    def objects(self, kind: str) -> list[dict[str, Any]]:
        """A list of JSON objects, such as "meshes". Empty if missing."""
        if kind not in self._objects:
            entries = self.content.get(kind, [])
            if not isinstance(entries, list) or not all(isinstance(entry, dict) for entry in entries):
                raise self.error(f"{kind}: expected a list of objects")
            self._objects[kind] = entries
        return self._objects[kind]

    def take(self, kind: str, number: Any, what: str) -> dict[str, Any]:
        """A JSON object by its index; `what` describes it in errors."""
        objects = self.objects(kind)
        if not is_integer(number) or not 0 <= number < len(objects):
            raise self.error(f"{what} refers to {kind} {str(number)[:40]}, of {len(objects)}")
        return objects[number]

    def part(self, holder: dict[str, Any], name: str, what: str) -> dict[str, Any]:
        """A nested object. Empty if missing."""
        value = holder.get(name, {})
        if not isinstance(value, dict):
            raise self.error(f"{what}: {name} is not an object")
        return value

    def extension(self, holder: dict[str, Any], name: str, what: str) -> dict[str, Any] | None:
        extensions = self.part(holder, "extensions", what)
        return self.part(extensions, name, what) if name in extensions else None

    def integer(self, holder: dict[str, Any], name: str, what: str, default: int | None = None) -> int:
        value = holder.get(name, default)
        if not is_integer(value) or not 0 <= value < 2**53:
            raise self.error(f"{what}: {name} is {str(value)[:40]}, expected a whole number from 0")
        return value

    def numbers(
        self, holder: dict[str, Any], name: str, what: str, default: list[float], *, limit: float = 1e300
    ) -> NDArray[np.float64]:
        """A list of finite numbers of an object, as long as the default."""
        values = holder.get(name, default)
        is_list = isinstance(values, list) and len(values) == len(default)
        if not is_list or not all(isinstance(x, int | float) and abs(x) < limit for x in values):
            raise self.error(f"{what}: {name} is not {len(default)} numbers")
        return np.array(values, np.float64)

    def node_indices(self, holder: dict[str, Any], name: str, what: str) -> list[int]:
        """A list of integers of an object. Empty if missing."""
        indices = holder.get(name, [])
        if not isinstance(indices, list) or not all(type(index) is int for index in indices):
            raise self.error(f"{what}: {name}: expected a list of node indices")
        return indices

    def uri_file(self, uri: Any, what: str) -> Path | None:
        """The neighboring file of a URI, or None if it does not exist."""
        if not isinstance(uri, str):
            raise self.error(f"{what}: uri is {str(uri)[:40]}, expected a string")
        if _SCHEME.match(uri):
            return None
        for name in dict.fromkeys([unquote(uri, errors="surrogateescape"), uri]):
            path = find_beside(self.path, name, outside_files=self.outside_files)
            if path is not None:
                return path
        return None

    def why_missing(self, uri: str) -> str:
        """Why `uri_file` returned None, as the end of a sentence."""
        if _SCHEME.match(uri):
            return f"{uri[:60]!r}, which is not downloaded"
        name = unquote(uri, errors="surrogateescape")
        return f"{name[:60]!r}, which {why_missing(self.path, name, outside_files=self.outside_files)}"

    def uri_bytes(self, uri: Any, what: str) -> memoryview:
        if isinstance(uri, str) and uri[:5].lower() == "data:":
            return memoryview(self._data_uri(uri, what))
        path = self.uri_file(uri, what)
        if path is None:
            raise self.error(f"{what} is in another file, {self.why_missing(uri)}")
        content = memoryview(open_source(path)[:])
        self.size += len(content)
        return content

    def _data_uri(self, uri: str, what: str) -> bytes:
        head, comma, body = uri[5:].partition(",")
        try:
            if not comma:
                raise ValueError("it has no comma")
            if _BAD_ESCAPE.search(body):
                raise ValueError("a % without two digits after it")
            plain = unquote_to_bytes(body) if "%" in body else body.encode("ascii")
            return base64.b64decode(plain, validate=True) if head.lower().endswith(";base64") else plain
        except (ValueError, binascii.Error) as error:
            raise self.error(f"{what}: its data URI is damaged: {error}"[:200]) from error


def is_integer(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)


def _refuse_constant(name: str) -> None:
    raise ValueError(f"{name} is not a JSON number")
