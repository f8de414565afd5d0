"""What a mesh is asked: whether it has triangles, normals, colours, textures."""

from __future__ import annotations

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...core.html_tables import array_type, html_table
from ...core.known_names import KnownNames
from ...core.yes_or_no import YesOrNo


class MeshQuestions(KnownNames):
    """Questions that are answered with and without a call: `mesh.has_textures`, `mesh.has_textures()`."""

    _arrays: dict[str, wp.array]
    _attributes: dict[str, dict[str, wp.array]]
    _textures: tuple[NDArray[np.uint8], ...]

    def __len__(self) -> int:
        return self._arrays["triangles"].size

    def _repr_html_(self) -> str:
        """The mesh in a notebook: what it holds, a row each."""
        arrays = [*self._arrays.items()]
        arrays += [(f"{kind}[{name!r}]", held) for kind, of in self._attributes.items() for name, held in of.items()]
        arrays += [(f"textures[{number}]", picture) for number, picture in enumerate(self._textures)]
        return html_table(repr(self), ((name, array_type(values)) for name, values in arrays))

    @property
    def has_vertices(self) -> YesOrNo:
        """Whether there are vertices; may be called, too."""
        return YesOrNo(self._arrays["vertices"].size)

    @property
    def has_triangles(self) -> YesOrNo:
        """Whether there are triangles; may be called, too."""
        return YesOrNo(len(self))

    @property
    def has_vertex_normals(self) -> YesOrNo:
        """Whether there are normals of vertices; may be called, too."""
        return YesOrNo("vertex_normals" in self._arrays)

    @property
    def has_vertex_colors(self) -> YesOrNo:
        """Whether there are colours of vertices; may be called, too."""
        return YesOrNo("vertex_colors" in self._arrays)

    @property
    def has_triangle_uvs(self) -> YesOrNo:
        """Whether there are texture coordinates; may be called, too."""
        return YesOrNo("triangle_uvs" in self._arrays)

    @property
    def has_textures(self) -> YesOrNo:
        """Whether there are pictures to be drawn on it; may be called, too."""
        return YesOrNo(len(self._textures))

    @property
    def is_empty(self) -> YesOrNo:
        """Whether there is no vertex; may be called, too."""
        return YesOrNo(self._arrays["vertices"].size == 0)
