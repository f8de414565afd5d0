"""Triangles as the browser takes them: one glTF scene in memory, its colours such that they come out as they are.

The page maps tones (ACES, as fitted by S. Hill) over all that glTF brings. Colours are therefore sent as what the
mapping makes the wanted colour of; under light, of the colour in the usual light (lights.py).
Source: Khronos, "glTF 2.0 Specification"; three.js, tonemapping_pars_fragment.
"""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...files.meshes.glb_container import BINARY_CHUNK, JSON_CHUNK, MAGIC
from ...files.pictures.image_files import encode_png
from ...kernels.memory import download
from ..render.parts import Triangles
from .lights import USUAL

_FLOAT, _UINT = 5126, 5125

# sRGB to the space in which the curve is applied, and back.
_TO_CURVE = np.array([[0.59719, 0.35458, 0.04823], [0.07600, 0.90834, 0.01566], [0.02840, 0.13383, 0.83777]])
_FROM_CURVE = np.array([[1.60475, -0.53108, -0.07367], [-0.10208, 1.10813, -0.00605], [-0.00327, -0.07276, 1.07602]])
_EXPOSURE = 0.6

# Brighter linear colours are not asked of the curve, which reaches 1 only at 26 times white: between a vertex as bright
# as that and a dark one, all would be white. White comes out as 243 of 255.
_BRIGHTEST = 0.9

# Shares of the brightness that are tried for colours too bright and pure for the curve.
_DARKER = (1.0, 0.9, 0.8, 0.7, 0.6, 0.5)

# Textures have eight bits for what the curve spreads over twice white: they are brightened as a whole instead, so
# that the middle grey comes out as it is.
_TEXTURE_GAIN = 1.25
_LIT_GAIN = 0.75  # ... under light, which is brighter than that


def to_glb(part: Triangles) -> bytes | None:
    """The surface about its origin as the bytes of a GLB file; None where there is no triangle of finite corners."""
    positions, faces = surface_arrays(part)
    if not len(faces):
        return None
    lit, has_texture = part.is_lit, part.is_textured
    columns: dict[str, NDArray[Any]] = {"POSITION": positions}
    material: dict[str, Any] = {"doubleSided": not part.cull}
    look: dict[str, Any] = {"metallicFactor": 0.0, "roughnessFactor": 1.0}
    if part.normals.size:
        columns["NORMAL"] = np.nan_to_num(download(part.normals).reshape(-1, 3)).astype(np.float32)
    if part.colors.size:
        columns["COLOR_0"] = sent_colors(download(part.colors).reshape(-1, 3), lit=lit)
    elif not has_texture:
        look["baseColorFactor"] = [*sent_colors(np.array([part.plain]), lit=lit)[0].tolist(), 1.0]
    if has_texture:
        columns, faces = _with_corners(part, columns, faces)
        look["baseColorTexture"] = {"index": 0}
        look["baseColorFactor"] = [_LIT_GAIN if lit else _TEXTURE_GAIN] * 3 + [1.0]
    # light is scattered alone, as in our pictures: no gloss
    material["extensions"] = {"KHR_materials_specular": {"specularFactor": 0.0}} if lit else {"KHR_materials_unlit": {}}
    material["pbrMetallicRoughness"] = look
    return _assemble(columns, faces, material, part.texture if has_texture else None)


def surface_arrays(part: Triangles) -> tuple[NDArray[np.float32], NDArray[np.int32]]:
    """Positions about the part's origin, all finite, and the triangles between those that were."""
    positions = np.asarray(download(part.positions), np.float32).reshape(-1, 3)
    faces = np.asarray(download(part.indices), np.int32).reshape(-1, 3)
    finite = np.isfinite(positions)
    if not finite.all():
        kept = finite[faces].all(axis=(1, 2))
        positions, faces = np.where(finite, positions, np.float32(0)), faces[kept]
    return positions, faces


def edges_beside(part: Triangles, gap: float) -> tuple[NDArray[np.float32], NDArray[np.int32]]:
    """The surface twice, a little before and a little behind itself, so that its edges are not lost in its faces.

    Args:
        part: The surface.
        gap: How far [share of its diagonal].
    """
    positions, faces = surface_arrays(part)
    if not len(faces):
        return positions, faces
    a, b, c = (positions[faces[:, i]].astype(np.float64) for i in range(3))
    across = np.cross(b - a, c - a)  # as long as twice the area: large faces count more
    normals = np.zeros(positions.shape)
    for axis in range(3):
        weights = np.repeat(across[:, axis], 3)
        normals[:, axis] = np.bincount(faces.ravel(), weights, minlength=len(positions))
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    shift = normals / np.where(lengths > 0, lengths, 1) * gap * np.linalg.norm(np.ptp(positions[faces.ravel()], axis=0))
    both = np.concatenate([positions + shift, positions - shift]).astype(np.float32)
    return both, np.concatenate([faces, faces + len(positions)]).astype(np.int32)


def sent_colors(colors: Any, *, lit: bool) -> NDArray[np.float32]:
    """Colours of the screen (0 to 1) as the linear ones of which the page makes them, under light the usual share."""
    shown = np.asarray(colors, np.float64) * (USUAL if lit else 1.0)
    return before_tone_mapping(linear_colors(shown)).astype(np.float32)


def linear_colors(colors: Any) -> NDArray[np.float64]:
    """Colours of the screen (0 to 1) as shares of light."""
    shown = np.clip(np.nan_to_num(np.asarray(colors, np.float64)), 0, 1)
    return np.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)


def before_tone_mapping(linear: NDArray[np.float64]) -> NDArray[np.float64]:
    """What the page's tone mapping turns into these linear colours, shape [n, 3], or as nearly as it can.

    It makes bright and pure colours paler: those come darker rather than white, whichever is nearer.
    """
    sent, is_exact = _before_curve(linear)
    hard = np.flatnonzero(~is_exact)
    if len(hard):
        wanted = as_seen(linear[hard])
        tries = np.stack([_before_curve(linear[hard] * share)[0] for share in _DARKER])
        gaps = [np.square(as_seen(tone_mapped(one)) - wanted).sum(axis=1) for one in tries]
        sent[hard] = tries[np.argmin(gaps, axis=0), np.arange(len(hard))]
    return sent


def tone_mapped(linear: NDArray[np.float64]) -> NDArray[np.float64]:
    """What the page makes of linear colours, shape [n, 3]."""
    v = linear / _EXPOSURE @ _TO_CURVE.T
    v = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081)
    return np.clip(v @ _FROM_CURVE.T, 0, 1)


def _before_curve(linear: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """The inverse of `tone_mapped`, nothing below zero, and whether nothing had to be cut."""
    curve = np.linalg.solve(_FROM_CURVE, np.minimum(linear, _BRIGHTEST).T).T
    curve = np.clip(curve, 0, _BRIGHTEST)
    # (v (v + 0.0245786) - 0.000090537) / (v (0.983729 v + 0.4329510) + 0.238081) = curve, solved for v
    a, b, c = 1 - 0.983729 * curve, 0.0245786 - 0.4329510 * curve, -0.000090537 - 0.238081 * curve
    value = (-b + np.sqrt(b * b - 4 * a * c)) / (2 * a)
    found = np.linalg.solve(_TO_CURVE, value.T).T * _EXPOSURE
    return np.maximum(found, 0), found.min(axis=1) > -1e-3


def as_seen(linear: NDArray[np.float64]) -> NDArray[np.float64]:
    """Shares of light as colours of the screen, sRGB, whose steps look equal."""
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * np.maximum(linear, 0.0031308) ** (1 / 2.4) - 0.055)


def _with_corners(
    part: Triangles, columns: dict[str, NDArray[Any]], faces: NDArray[np.int32]
) -> tuple[dict[str, NDArray[Any]], NDArray[np.int32]]:
    """Every corner a vertex of its own, with its place in the texture; glTF's v runs down."""
    indices = np.asarray(download(part.indices), np.int32).reshape(-1, 3)
    uvs = np.asarray(download(part.uvs), np.float32).reshape(-1, 3, 2)
    if len(faces) != len(indices):
        positions = np.asarray(download(part.positions)).reshape(-1, 3)
        uvs = uvs[np.isfinite(positions)[indices].all(axis=(1, 2))]
    spread = {name: values[faces.ravel()] for name, values in columns.items()}
    flat = np.nan_to_num(uvs.reshape(-1, 2))
    spread["TEXCOORD_0"] = np.stack([flat[:, 0], 1 - flat[:, 1]], axis=1).astype(np.float32)
    return spread, np.arange(len(flat), dtype=np.int32).reshape(-1, 3)


def _assemble(
    columns: dict[str, NDArray[Any]], faces: NDArray[np.int32], material: dict[str, Any], texture: Any
) -> bytes:
    body, views, accessors = bytearray(), [], []

    def add_view(content: bytes) -> int:
        views.append({"buffer": 0, "byteOffset": len(body), "byteLength": len(content)})
        body.extend(content + b"\0" * (-len(content) % 4))
        return len(views) - 1

    def add_array(values: NDArray[Any], kind: int, shape: str) -> int:
        little = np.ascontiguousarray(values, "<f4" if kind == _FLOAT else "<u4")
        accessor = {
            "bufferView": add_view(little.tobytes()),
            "componentType": kind,
            "count": len(values),
            "type": shape,
        }
        if shape == "VEC3":
            accessor |= {"min": little.min(axis=0).tolist(), "max": little.max(axis=0).tolist()}
        accessors.append(accessor)
        return len(accessors) - 1

    attributes = {name: add_array(values, _FLOAT, f"VEC{values.shape[1]}") for name, values in columns.items()}
    primitive = {"attributes": attributes, "indices": add_array(faces.ravel(), _UINT, "SCALAR"), "material": 0}
    content: dict[str, Any] = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [primitive]}],
        "materials": [material],
    }
    content["extensionsUsed"] = list(material["extensions"])
    if texture is not None:
        content["images"] = [{"bufferView": add_view(encode_png(texture)), "mimeType": "image/png"}]
        content["textures"] = [{"source": 0}]
    content |= {"accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": len(body)}]}
    text = json.dumps(content, separators=(",", ":")).encode("ascii")
    text += b" " * (-len(text) % 4)
    head = MAGIC + struct.pack("<II", 2, 12 + 8 + len(text) + 8 + len(body))
    chunks = struct.pack("<II", len(text), JSON_CHUNK), text, struct.pack("<II", len(body), BINARY_CHUNK), bytes(body)
    return b"".join([head, *chunks])
