"""glTF scenes that tests build array by array, with additional JSON."""

import base64
import copy
import json
import struct

import numpy as np

CODES = {"i1": 5120, "u1": 5121, "i2": 5122, "u2": 5123, "u4": 5125, "f4": 5126}
KINDS = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
TRIANGLE = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], "f4")


class Scene:
    """A glTF scene that grows array by array."""

    def __init__(self):
        self.data, self.views, self.accessors, self.primitives = b"", [], [], []
        self.more: dict = {}

    def bytes(self, content: bytes, **more) -> int:
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(content), **more})
        self.data += content + b"\0" * (-len(content) % 4)
        return len(self.views) - 1

    def array(self, values, **more) -> int:
        rows = values.reshape(len(values), -1)
        code = f"{values.dtype.kind}{values.dtype.itemsize}"
        accessor = {"bufferView": self.bytes(rows.tobytes()), "componentType": CODES[code], "count": len(rows)}
        self.accessors.append(accessor | {"type": KINDS[rows.shape[1]]} | more)
        return len(self.accessors) - 1

    def primitive(self, *, indices=None, extra=None, **attributes):
        names = {name: self.array(np.asarray(values)) for name, values in attributes.items()}
        self.primitives.append({"attributes": names, **(extra or {})})
        if indices is not None:
            self.primitives[-1]["indices"] = self.array(np.asarray(indices))

    def content(self) -> dict:
        return {
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": self.primitives}], "accessors": self.accessors, "bufferViews": self.views,
            "buffers": [{"byteLength": len(self.data)}], **self.more,
        }  # fmt: skip

    def write(self, path, content=None, **buffer):
        """Write a GLB, or a .gltf with its buffer in the file `buffer` or in a data URI."""
        content = self.content() if content is None else content
        if path.suffix == ".gltf":
            inside = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()
            content["buffers"][0] |= buffer or {"uri": inside}
        text = json.dumps(content).encode()
        path.write_bytes(text if path.suffix == ".gltf" else container(text, self.data))
        return path


def container(text: bytes, data: bytes) -> bytes:
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(data), 0x004E4942) + data
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


def one_triangle(**more) -> Scene:
    scene = Scene()
    scene.primitive(POSITION=TRIANGLE, indices=np.arange(3, dtype="u2"), **more)
    return scene


def changed(scene: Scene, *path_and_value) -> dict:
    *path, last, value = path_and_value
    content = holder = copy.deepcopy(scene.content())
    for key in path:
        holder = holder[key]
    holder[last] = value
    return content
