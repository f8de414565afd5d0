"""An independent checker of .glb files against the glTF 2.0 specification."""

import io
import json
import struct
from pathlib import Path
from typing import Any

import numpy as np

SIZES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
CODES = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
WRAPS, FILTERS = (33071, 33648, 10497), (9728, 9729, 9984, 9985, 9986, 9987)


def faults_of_glb(path: Path) -> list[str]:
    """The faults of a file; empty if it is valid."""
    data = path.read_bytes()
    faults: list[str] = []

    def claim(condition: Any, words: str) -> None:
        if not condition:
            faults.append(words)

    magic, version, length = struct.unpack("<4sII", data[:12])
    claim((magic, version, length) == (b"glTF", 2, len(data)), "header")
    chunks, at = [], 12
    while at + 8 <= len(data):
        size, kind = struct.unpack("<I4s", data[at : at + 8])
        claim(size % 4 == 0 and at + 8 + size <= len(data), f"chunk at {at}: length")
        chunks.append((kind, data[at + 8 : at + 8 + size]))
        at += 8 + size
    claim([kind for kind, _ in chunks] == [b"JSON", b"BIN\0"], "chunks")
    doc, binary = json.loads(chunks[0][1]), chunks[1][1]
    claim(doc["asset"]["version"] == "2.0", "asset.version")
    claim(0 <= len(binary) - doc["buffers"][0]["byteLength"] < 4, "buffers[0].byteLength")
    _check_views(doc, claim)
    arrays = [_check_accessor(doc, k, binary, claim) for k in range(len(doc["accessors"]))]
    for mesh in doc["meshes"]:
        for part in mesh["primitives"]:
            _check_part(doc, part, arrays, claim)
    _check_pictures(doc, binary, claim)
    for node in doc.get("nodes", []):
        claim(node.get("mesh", 0) < len(doc["meshes"]), "node.mesh")
    claim(all(k < len(doc["nodes"]) for scene in doc["scenes"] for k in scene["nodes"]), "scene.nodes")
    return faults


def _check_views(doc: dict[str, Any], claim: Any) -> None:
    for k, view in enumerate(doc["bufferViews"]):
        end = view.get("byteOffset", 0) + view["byteLength"]
        is_inside = view["byteLength"] > 0 and end <= doc["buffers"][view["buffer"]]["byteLength"]
        claim(is_inside, f"bufferViews[{k}]: bounds")


def _check_accessor(doc: dict[str, Any], k: int, binary: bytes, claim: Any) -> Any:
    what = doc["accessors"][k]
    view, size, width = doc["bufferViews"][what["bufferView"]], SIZES[what["componentType"]], WIDTHS[what["type"]]
    offset, begin = what.get("byteOffset", 0), view.get("byteOffset", 0)
    stride = view.get("byteStride", size * width)
    claim(offset % size == 0 and (begin + offset) % size == 0, f"accessors[{k}]: alignment")
    claim(what["count"] > 0, f"accessors[{k}]: count")
    end = offset + stride * (what["count"] - 1) + size * width
    claim(end <= view["byteLength"], f"accessors[{k}]: beyond its view")
    claim(stride % size == 0 and (stride % 4 == 0 or "byteStride" not in view), f"accessors[{k}]: stride")
    rows = [begin + offset + stride * i for i in range(what["count"])]
    values = np.array([np.frombuffer(binary, CODES[what["componentType"]], width, row) for row in rows])
    claim(np.isfinite(values.astype(np.float64)).all(), f"accessors[{k}]: not finite")
    for name, extreme in (("min", values.min(0)), ("max", values.max(0))):
        if name in what:
            claim(np.array_equal(np.array(what[name], values.dtype), extreme), f"accessors[{k}].{name}")
    return values


def _check_part(doc: dict[str, Any], part: dict[str, Any], arrays: list[Any], claim: Any) -> None:
    position_accessor = part["attributes"]["POSITION"]
    claim({"min", "max"} <= set(doc["accessors"][position_accessor]), "POSITION: min and max")
    count = doc["accessors"][position_accessor]["count"]
    for name, k in part["attributes"].items():
        claim(doc["accessors"][k]["count"] == count, f"{name}: count")
        view = doc["bufferViews"][doc["accessors"][k]["bufferView"]]
        claim(view.get("target", 34962) == 34962, f"{name}: target")
        claim(doc["accessors"][k]["componentType"] == 5126 or doc["accessors"][k].get("normalized"), f"{name}: type")
    if "indices" in part:
        indices = arrays[part["indices"]]
        claim(indices.max() < count and len(indices) % 3 == 0, "indices")
        claim(indices.max() < 2 ** (8 * indices.dtype.itemsize) - 1, "indices: primitive restart")
    material = doc["materials"][part["material"]] if "material" in part else {}
    texture = material.get("pbrMetallicRoughness", {}).get("baseColorTexture")
    if texture is not None:
        claim(f"TEXCOORD_{texture.get('texCoord', 0)}" in part["attributes"], "baseColorTexture.texCoord")
        claim(texture["index"] < len(doc["textures"]), "baseColorTexture.index")


def _check_pictures(doc: dict[str, Any], binary: bytes, claim: Any) -> None:
    from PIL import Image

    for texture in doc.get("textures", []):
        claim(texture["source"] < len(doc["images"]), "texture.source")
        claim("sampler" not in texture or texture["sampler"] < len(doc["samplers"]), "texture.sampler")
    for sampler in doc.get("samplers", []):
        claim(all(sampler.get(name, 10497) in WRAPS for name in ("wrapS", "wrapT")), "sampler.wrap")
        is_known = sampler.get("magFilter", 9729) in FILTERS[:2] and sampler.get("minFilter", 9729) in FILTERS
        claim(is_known, "sampler.filter")
    for k, image in enumerate(doc.get("images", [])):
        claim(("uri" in image) != ("bufferView" in image), f"images[{k}]: uri or bufferView")
        if "bufferView" in image:
            view = doc["bufferViews"][image["bufferView"]]
            claim("byteStride" not in view and "target" not in view, f"images[{k}]: its view")
            begin = view.get("byteOffset", 0)
            decoded = Image.open(io.BytesIO(binary[begin : begin + view["byteLength"]]))
            decoded.load()
            claim(f"image/{str(decoded.format).lower()}" == image["mimeType"], f"images[{k}].mimeType")
