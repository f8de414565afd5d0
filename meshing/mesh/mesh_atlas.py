"""A mesh spread out on a picture, and the colours of its vertices drawn there."""

from __future__ import annotations

import math
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count, check_positive
from ...core.dropped_results import returns_new
from ...kernels.arrays.bounds import bound_points
from ...kernels.lang import vec2
from ...kernels.memory import check_room, download, upload
from ...kernels.textures.atlas_colors import draw_vertex_colors
from .mesh_arrays import MeshArrays

MOST_SIZE = 2**14  # of a picture; 2^28 texels are what files hold
TEXEL_BYTES = 40
TRIES = 3
MOST_EXCESS = 3  # of xatlas's picture over the size: beyond, wider gutters chase a picture that grows with them
_WIDER = 1.5  # xatlas exceeds the size that it is given, by a fifth and more, and the gutter shrinks with it


class MeshAtlas(MeshArrays):
    """The part of TriangleMesh that has to do with one picture for all of it."""

    @returns_new
    def compute_uvatlas(self, size: int = 512, gutter: float = 1.0) -> Self:
        """Cut the surface into charts and lay them side by side on a square picture.

        This runs on the host, in the library xatlas: `pip install "pointloom[mesh]"`. Open3D's function of this name
        (of its tensor meshes) uses Microsoft's UVAtlas and changes the mesh; max_stretch, parallel_partitions and
        nthreads are settings of that.

        Args:
            size: Width and height of the picture that the coordinates are for [texels], 1 to 2^14.
            gutter: Room between charts [texels].

        Returns:
            The mesh with texture coordinates in 0..1 that no two triangles share, but for such as lie at the same
            place; a triangle without area has (0, 0) at its corners. Earlier coordinates, material numbers and textures
            are left behind. Vertices, triangles and what else they have stay as they are.

        Raises:
            ImportError: xatlas is not there.
            ValueError: No triangles, a vertex that is not finite, a size or gutter out of range, or a size that has no
                room for all charts with such a gutter.
            TypeError: No numbers.

        Notes:
            Same coordinates from run to run. Does not depend on the mesh's units.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh.create_box().compute_uvatlas(256, gutter=2)
            >>> mesh.triangle_uvs.shape, bool((mesh.triangle_uvs >= 0).all() and (mesh.triangle_uvs <= 1).all())
            ((36, 2), True)
        """
        size = check_count("size", size, maximum=MOST_SIZE, because="pictures have up to 2^28 texels")
        gutter = check_positive("gutter", gutter, allow_zero=True, maximum=size / 4)
        low, high, finite = bound_points(self._arrays["vertices"])
        if not len(self):
            raise ValueError("compute_uvatlas: the mesh has no triangles")
        if finite < self._arrays["vertices"].size:
            raise ValueError("compute_uvatlas: expected finite vertices, and some are not")
        extent = float((high.astype(np.float64) - low).max())
        corners = (download(self._arrays["vertices"]).reshape(-1, 3).astype(np.float64) - low) / (extent or 1.0)
        uvs = _lay_out(corners.astype(np.float32), self.triangles, size, gutter)
        without = self._with_arrays(triangle_uvs=None, triangle_material_ids=None)
        return without._with_arrays(triangle_uvs=upload(uvs, vec2, self._device))

    @returns_new
    def bake_vertex_colors(self, size: int = 1024, *, gutter: int = 4) -> Self:
        """Draw the colours of the vertices into a texture, as for programs that know no vertex colours.

        Args:
            size: Width and height of the picture [texels], 1 to 2^14.
            gutter: How many texels around triangles are coloured as well, so that no background shows at their edges.

        Returns:
            The mesh with that texture in place of vertex colours, earlier textures and material numbers.

        Raises:
            ValueError: The mesh has no vertex colours, no texture coordinates, or some beyond 0..1; or a size or gutter
                out of range.
            TypeError: No whole numbers.
            MemoryError: The device has no room for the picture.

        Notes:
            40 B of memory a texel, 8 B a row of texels over each triangle. Same bits from run to run and on every
            device.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh.create_plane(create_uv_map=True)
            >>> mesh.vertex_colors = [[1, 0, 0], [1, 0, 0], [0, 0, 1], [0, 0, 1]]
            >>> baked = mesh.bake_vertex_colors(4)
            >>> baked.textures[0][:, 0].tolist()
            [[32, 0, 223], [96, 0, 159], [159, 0, 96], [223, 0, 32]]
        """
        size = check_count("size", size, maximum=MOST_SIZE, because="pictures have up to 2^28 texels")
        gutter = check_count("gutter", gutter, minimum=0, maximum=size)
        for name, advice in (("vertex_colors", "there is nothing to draw"), ("triangle_uvs", "compute_uvatlas()")):
            if name not in self._arrays:
                raise ValueError(f"bake_vertex_colors: the mesh has no {name}; {advice}")
        uvs = download(self._arrays["triangle_uvs"])
        if not ((uvs >= 0) & (uvs <= 1)).all():
            raise ValueError("triangle_uvs: expected coordinates in 0..1; compute_uvatlas() makes such")
        check_room(self._device, size * size * TEXEL_BYTES, f"size: a picture of {size} x {size} texels")
        arrays = (self._arrays["triangles"], self._arrays["vertex_colors"], self._arrays["triangle_uvs"])
        picture = download(draw_vertex_colors(*arrays, size, gutter)).reshape(size, size, 3)
        baked = self._with_arrays(vertex_colors=None, triangle_material_ids=None)
        baked.textures = [picture]
        return baked


def _lay_out(
    vertices: NDArray[np.float32], triangles: NDArray[np.int32], size: int, gutter: float
) -> NDArray[np.float32]:
    """Texture coordinates of corners by xatlas, [3 t, 2]."""
    xatlas = _import_xatlas()
    padding, reason = math.ceil(_WIDER * gutter), ""
    for _ in range(TRIES):
        options = xatlas.PackOptions()
        options.resolution, options.padding = size, padding
        atlas = xatlas.Atlas()
        atlas.add_mesh(vertices, triangles.astype(np.uint32))
        atlas.generate(pack_options=options)
        rows, corners, uvs = atlas[0]
        edge = max(atlas.width, atlas.height)
        if not np.array_equal(rows[corners], triangles):
            raise RuntimeError("compute_uvatlas: xatlas gave back other triangles than it was given")
        if padding * size >= gutter * edge:
            placed = uvs[corners.reshape(-1)] * (np.array([atlas.width, atlas.height]) / max(edge, 1))
            return np.clip(placed, 0, 1).astype(np.float32)
        reason = f"its {atlas.chart_count} charts and gutters of {gutter:g} take {edge} x {edge} texels"
        if edge > MOST_EXCESS * size:
            break
        padding = math.ceil(_WIDER * gutter * edge / size)
    raise ValueError(f"size: {size} x {size} texels are too few for the mesh: {reason}")


def _import_xatlas() -> Any:
    try:
        import xatlas
    except ImportError as error:
        raise ImportError('compute_uvatlas needs the package xatlas: pip install "pointloom[mesh]"') from error
    return xatlas
