"""Types and row counts of a mesh's arrays."""

from __future__ import annotations

from typing import Any

import warp as wp

from ...core.devices import check_same_device
from ...core.escaped_text import escaped
from ...kernels.array_types import Device
from ...kernels.lang import int32, vec2, vec3, vec3i

PER_VERTEX = {"vertices": vec3, "vertex_normals": vec3, "vertex_colors": vec3}
PER_TRIANGLE = {"triangles": vec3i, "triangle_uvs": vec2, "triangle_material_ids": int32}
TEXTURE = ("triangle_uvs", "triangle_material_ids")
CORNERS = ("triangle_uvs",)  # three rows per triangle
ATTRIBUTES = {"vertex_attributes": "vertices", "triangle_attributes": "triangles"}  # and arrays of the same rows


def kind_and_count(name: str, counts: dict[str, int]) -> tuple[Any, int]:
    if name in PER_VERTEX:
        return PER_VERTEX[name], counts["vertices"]
    return PER_TRIANGLE[name], counts["triangles"] * (3 if name in CORNERS else 1)


def check_attributes(attributes: dict[str, wp.array], count: int, device: Device) -> None:
    for name, values in attributes.items():
        check_same_device(name, device, values.device)
        if values.ndim not in (1, 2) or values.shape[0] != count:
            raise ValueError(f"{escaped(name)}: expected scalars [{count}] or [{count}, c], got {values}")


def as_triples(triangles: wp.array) -> wp.array:
    if triangles.dtype == vec3i and triangles.ndim == 1:
        return triangles
    is_table = triangles.ndim == 2 and triangles.shape[1] == 3
    is_flat = triangles.ndim == 1 and triangles.size % 3 == 0
    if triangles.dtype != wp.int32 or not (is_table or is_flat) or not triangles.is_contiguous:
        raise ValueError(f"triangles: expected vec3i [t], or int32 [3 t] or [t, 3] without gaps, got {triangles}")
    count = triangles.size // 3
    view = wp.array(ptr=triangles.ptr, dtype=vec3i, shape=(count,), device=triangles.device, copy=False)
    view._ref = triangles  # keeps the memory alive
    return view
