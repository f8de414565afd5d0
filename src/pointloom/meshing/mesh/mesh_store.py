"""Device arrays of a mesh with their origin, attributes and textures, for the modules of this package."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...core.array_libraries import NUMPY
from ...core.up_axis import Direction
from ...kernels.arrays.select import gather_rows
from ...kernels.meshes.mesh_edits import gather_corners
from ...pcd.point_store import ArrayStore
from .mesh_attributes import Arrays, rows_of
from .mesh_rows import ATTRIBUTES, PER_VERTEX

Textures = tuple[NDArray[np.uint8], ...]


class MeshStore(ArrayStore):
    """Arrays of a mesh: those of `mesh.array`. `mesh.arrays` is one.

    Attributes:
        attributes: Arrays of `vertex_attributes` and `triangle_attributes` by name.
        textures: Images, uint8 (height, width, 3 or 4), on the host.
        up: Up direction. None if unknown.
    """

    __slots__ = ("attributes", "textures", "up")

    def __init__(
        self, arrays: Mapping[str, Any], origin: NDArray[np.float64], library: str = NUMPY, *, textures: Textures = ()
    ):
        super().__init__({name: rows for name, rows in arrays.items() if rows is not None and name not in ATTRIBUTES})
        self.origin, self.library, self.textures = np.array(origin, np.float64), library, tuple(textures)
        self.attributes = {kind: dict(arrays.get(kind) or {}) for kind in ATTRIBUTES}
        self.up: Direction | None = None

    @property
    def vertex_count(self) -> int:
        return self["vertices"].size

    def per_vertex(self) -> Arrays:
        return {name: values for name, values in self.items() if name in PER_VERTEX}

    def triangles_at(self, rows: wp.array) -> dict[str, Any]:
        """Triangle data at rows, an int32 device array with repeats allowed. Arguments of `with_arrays`."""
        selected: dict[str, Any] = {"triangles": gather_rows(self["triangles"], rows)}
        if "triangle_uvs" in self:
            selected["triangle_uvs"] = gather_corners(self["triangle_uvs"], rows)
        if "triangle_material_ids" in self:
            selected["triangle_material_ids"] = gather_rows(self["triangle_material_ids"], rows)
        return selected | self.attributes_at("triangle_attributes", rows)

    def vertices_at(self, rows: wp.array) -> dict[str, Any]:
        """Vertex data at rows, an int32 device array with repeats allowed. Arguments of `with_arrays`."""
        selected = {name: gather_rows(values, rows) for name, values in self.per_vertex().items()}
        return selected | self.attributes_at("vertex_attributes", rows)

    def attributes_at(self, kind: str, rows: wp.array) -> dict[str, Arrays]:
        """Attributes of vertices or triangles at rows. Arguments of `with_arrays`."""
        return {kind: rows_of(self.attributes[kind], rows)}
