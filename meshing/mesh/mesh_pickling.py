"""Meshes to and from Python's pickle."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...core.array_libraries import check_library
from ...core.checks import check_finite, check_shape, check_textures
from ...core.pickled_arrays import device_like, pickled, unpickled, unpickling
from ...files.table import MeshTable
from .mesh_arrays import MeshArrays
from .mesh_rows import ATTRIBUTES


class MeshPickling(MeshArrays):
    """The part of TriangleMesh that pickles it."""

    def __getstate__(self) -> dict[str, Any]:
        """The mesh as NumPy arrays and the name of its device, for pickle."""
        state = {"arrays": pickled(self._arrays), "origin": self._origin, "device": str(self._device)}
        attributes = {kind: pickled(held) for kind, held in self._attributes.items()}
        state |= {"textures": self._textures, "library": self._library, "attributes": attributes}
        return state | {"unit": self._unit, "up": self._up}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """The mesh on the device that it was on; on the first GPU where there is another number of them.

        Raises:
            ValueError: The state is damaged: arrays of wrong types or lengths, or triangles beyond the vertices.
            DeviceError: It was on a GPU, and here is none.
        """
        with unpickling("mesh"):
            device, given = device_like("mesh", state["device"]), state["arrays"]
            vertices, triangles = (np.asarray(given[name][0]).reshape(-1, 3) for name in ("vertices", "triangles"))
            ids = given["triangle_material_ids"][0] if "triangle_material_ids" in given else None
            MeshTable(vertices, triangles, triangle_material_ids=ids).checked()
            arrays: dict[str, Any] = unpickled(given, device)
            arrays |= {kind: unpickled(state["attributes"][kind], device) for kind in ATTRIBUTES}
            mesh = self._from_device_arrays(
                **arrays,
                textures=check_textures("textures", state["textures"]),
                origin=check_finite("origin", check_shape("origin", state["origin"], (3,))),
                library=check_library("library", state["library"]),
            )
            mesh.unit, mesh.up = state.get("unit"), state.get("up")
        vars(self).update(vars(mesh))
