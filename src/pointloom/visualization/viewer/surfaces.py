"""Triangles and lines as finite arrays for pages."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.memory import download
from ..render.parts import Lines, Triangles
from .items import to_bytes


def surface_arrays(part: Triangles) -> dict[str, Any] | None:
    """Arguments of `add_surface` relative to the part's origin. None without finite triangles."""
    positions, faces = finite_surface(part)
    if not len(faces):
        return None
    columns: dict[str, NDArray[Any]] = {"positions": positions}
    if part.normals.size:
        columns["normals"] = np.nan_to_num(download(part.normals).reshape(-1, 3)).astype(np.float32)
    if part.colors.size:
        columns["colors"] = to_bytes(download(part.colors).reshape(-1, 3))
    looks: dict[str, Any] = {"lit": part.is_lit, "cull": part.cull}
    if part.is_textured:
        columns, faces = _with_corners(part, columns, faces)
        looks["texture"] = part.texture
    elif "colors" not in columns:
        looks["plain"] = to_bytes([part.plain])[0]
    return {**columns, "indices": faces, **looks}


def finite_surface(part: Triangles) -> tuple[NDArray[np.float32], NDArray[np.int32]]:
    """Finite positions relative to the part's origin, and the triangles between them."""
    positions = np.asarray(download(part.positions), np.float32).reshape(-1, 3)
    faces = np.asarray(download(part.indices), np.int32).reshape(-1, 3)
    finite = np.isfinite(positions)
    if not finite.all():
        is_finite = finite[faces].all(axis=(1, 2))
        positions, faces = np.where(finite, positions, np.float32(0)), faces[is_finite]
    return positions, faces


def line_arrays(part: Lines) -> dict[str, Any] | None:
    """Arguments of `add_lines` relative to the part's origin. None without segments."""
    positions = np.asarray(download(part.positions), np.float32).reshape(-1, 3)
    ends = positions[download(part.indices).reshape(-1, 2)]
    finite = np.isfinite(ends).all(axis=(1, 2))
    if not finite.any():
        return None
    looks: dict[str, Any] = {"ends": ends[finite], "width": part.width}
    if part.colors.size:
        return {**looks, "colors": to_bytes(download(part.colors).reshape(-1, 3))[finite]}
    return {**looks, "plain": to_bytes([part.plain])[0]}


def _with_corners(
    part: Triangles, columns: dict[str, NDArray[Any]], faces: NDArray[np.int32]
) -> tuple[dict[str, NDArray[Any]], NDArray[np.int32]]:
    """Duplicate vertices per corner with texture coordinates. In the page v runs down."""
    indices = np.asarray(download(part.indices), np.int32).reshape(-1, 3)
    uvs = np.asarray(download(part.uvs), np.float32).reshape(-1, 3, 2)
    if len(faces) != len(indices):
        positions = np.asarray(download(part.positions)).reshape(-1, 3)
        uvs = uvs[np.isfinite(positions)[indices].all(axis=(1, 2))]
    spread = {name: values[faces.ravel()] for name, values in columns.items()}
    flat = np.nan_to_num(uvs.reshape(-1, 2))
    spread["uvs"] = np.stack([flat[:, 0], 1 - flat[:, 1]], axis=1).astype(np.float32)
    return spread, np.arange(len(flat), dtype=np.int32).reshape(-1, 3)
