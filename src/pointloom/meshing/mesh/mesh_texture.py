"""Texture of a mesh: texture atlas and albedo from images."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_count, check_list, check_positive
from ...core.dropped_results import returns_new
from ...kernels.arrays.bounds import bound_points
from ...kernels.lang import vec2
from ...kernels.memory import check_room, download, upload
from ...kernels.textures.atlas_colors import draw_vertex_colors
from ...kernels.textures.hidden_vertices import plant_trees
from ...kernels.textures.surface_texels import SurfaceTexels
from .mesh_arrays import MeshArrays
from .posed_images import Names, check_images

MAX_SIZE = 2**14  # per side. File formats allow 2^28 texels
TEXEL_BYTES = 40
MAX_SIZES_TRIED = 3
MAX_EXCESS = 3  # maximum ratio of xatlas's image to the size: beyond, wider gutters only enlarge the image
_GUTTER_FACTOR = 1.5  # xatlas exceeds the requested size by 20% or more, which shrinks the gutter
MAX_TEXELS = 16384  # per side: 2.7e8 texels, about 30 GB temporarily
NAMES = Names("images", "intrinsic_matrices", "extrinsic_matrices")
GUTTER_TEXELS = 8  # texels of padding: three mipmap levels


class MeshTexture(MeshArrays):
    """Methods of TriangleMesh that compute texture coordinates and textures."""

    _internal = ("with_albedo",)

    @returns_new
    def compute_uvatlas(self, size: int = 512, gutter: float = 1.0) -> Self:
        """Compute texture coordinates: cut the surface into charts and pack them, with xatlas on the CPU.

        Needs `pip install "pointloom[mesh]"`. Open3D's function uses Microsoft's UVAtlas and other parameters.

        Args:
            size: Width and height of the texture [texels], 1 to 2^14.
            gutter: Space between charts [texels].

        Returns:
            The mesh with non-overlapping texture coordinates in 0..1, (0, 0) for triangles without area. Earlier
            coordinates, material ids and textures are dropped. Reproducible and independent of the unit.

        Raises:
            ImportError, ValueError, TypeError: If xatlas is not installed, if there are no triangles, a vertex is not
                finite, `size` or `gutter` is out of range, or the charts do not fit, or if an argument is not a number.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh.create_box().compute_uvatlas(256, gutter=2)
            >>> mesh.triangle_uvs.shape, bool((mesh.triangle_uvs >= 0).all() and (mesh.triangle_uvs <= 1).all())
            ((36, 2), True)
        """
        size = check_count("size", size, maximum=MAX_SIZE, because="textures have at most 2^28 texels")
        gutter = check_positive("gutter", gutter, allow_zero=True, maximum=size / 4)
        low, high, finite = bound_points(self.arrays["vertices"])
        if not len(self):
            raise ValueError("compute_uvatlas: the mesh has no triangles")
        if finite < self.arrays["vertices"].size:
            raise ValueError("compute_uvatlas: expected finite vertices, got NaN or infinite ones")
        extent = float((high.astype(np.float64) - low).max())
        corners = (download(self.arrays["vertices"]).reshape(-1, 3).astype(np.float64) - low) / (extent or 1.0)
        uvs = _lay_out(corners.astype(np.float32), self.triangles, size, gutter)
        without = self.with_arrays(triangle_uvs=None, triangle_material_ids=None)
        return without.with_arrays(triangle_uvs=upload(uvs, vec2, self.device))

    @returns_new
    def bake_vertex_colors(self, size: int = 1024, *, gutter: int = 4) -> Self:
        """Bake vertex colors into a texture, for programs without vertex colors.

        Args:
            size: Width and height of the texture [texels], 1 to 2^14.
            gutter: Colored texels around triangles, which hide the background at seams.

        Returns:
            The mesh with this texture instead of vertex colors and other textures. Bitwise identical on every device.

        Raises:
            ValueError, TypeError: If the mesh has no vertex colors, no texture coordinates or some outside 0..1, or an
                argument is out of range, or if an argument is not an integer.
            MemoryError: If the texture does not fit into device memory.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh.create_plane(create_uv_map=True)
            >>> mesh.vertex_colors = [[1, 0, 0], [1, 0, 0], [0, 0, 1], [0, 0, 1]]
            >>> baked = mesh.bake_vertex_colors(4)
            >>> baked.textures[0][:, 0].tolist()
            [[32, 0, 223], [96, 0, 159], [159, 0, 96], [223, 0, 32]]
        """
        size = check_count("size", size, maximum=MAX_SIZE, because="textures have at most 2^28 texels")
        gutter = check_count("gutter", gutter, minimum=0, maximum=size)
        for name, advice in (("vertex_colors", "set them first"), ("triangle_uvs", "call compute_uvatlas() first")):
            if name not in self.arrays:
                raise ValueError(f"bake_vertex_colors: the mesh has no {name}; {advice}")
        uvs = download(self.arrays["triangle_uvs"])
        if not ((uvs >= 0) & (uvs <= 1)).all():
            raise ValueError("triangle_uvs: expected coordinates in 0..1. Call compute_uvatlas() first")
        check_room(self.device, size * size * TEXEL_BYTES, f"size: a texture of {size} x {size} texels")
        arrays = (self.arrays["triangles"], self.arrays["vertex_colors"], self.arrays["triangle_uvs"])
        image = download(draw_vertex_colors(*arrays, size, gutter)).reshape(size, size, 3)
        baked = self.with_arrays(vertex_colors=None, triangle_material_ids=None)
        baked.textures = [image]
        return baked

    def project_images_to_albedo(
        self, images: Any, intrinsic_matrices: Any, extrinsic_matrices: Any, tex_size: int = 1024
    ) -> Any:
        """Fill the texture from posed images.

        A texel is the mean, weighted by (cos / depth)^4, of the images that see it from the front, unoccluded (one ray
        per texel and image) and more than 2 pixels from a mesh edge. Unseen texels take the vertex colors, or black.
        Unlike Open3D's, a new mesh is returned.

        Args:
            images: uint8 images (h, w, 3), or RGBDImages with colors, whose depth is ignored.
            intrinsic_matrices: Matrices (3, 3), one per image, or one PinholeCameraIntrinsic or a list of them.
            extrinsic_matrices: T_camera_world (4, 4), one per image.
            tex_size: Texels per side.

        Returns:
            The mesh with one texture, uint8 (tex_size, tex_size, 3), padded by 8 texels around triangles. Bitwise
            reproducible on one device. About 110 B per texel, 7 B per pixel.

        Raises:
            ValueError, TypeError: If there are no triangles or texture coordinates in 0..1, images, cameras and poses
                disagree, or a pose is not rigid, or if images or cameras have another type.
            DeviceError: If images are on another device than the mesh.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> mesh = loom.TriangleMesh([[-1, -1, 2], [1, -1, 2], [-1, 1, 2]], [[0, 2, 1]])
            >>> mesh.triangle_uvs = [[0, 0], [0, 1], [1, 0]]
            >>> camera = loom.PinholeCameraIntrinsic(64, 48, 30.0, 30.0, 31.5, 23.5)
            >>> red = np.full((48, 64, 3), (200, 0, 0), np.uint8)
            >>> textured = mesh.project_images_to_albedo([red], camera, [np.eye(4)], tex_size=32)
            >>> textured.textures[0][20, 5].tolist()
            [200, 0, 0]
        """
        return self.with_albedo(images, intrinsic_matrices, extrinsic_matrices, tex_size)[0]

    def with_albedo(
        self, images: Sequence[Any], cameras: Any, poses: ArrayLike | None, tex_size: int
    ) -> tuple[Any, float]:
        """(mesh with its texture, fraction of texels seen in an image)."""
        because = "the texture and its intermediate arrays would not fit into memory. Use fewer texels"
        size = check_count("tex_size", tex_size, minimum=1, maximum=MAX_TEXELS, because=because)
        if not len(self):
            raise ValueError("mesh: expected triangles to texture, got none")
        if "triangle_uvs" not in self.arrays:
            raise ValueError("mesh: expected triangle_uvs, got none. Call compute_uvatlas() first")
        listed_images = check_list("images", images, "images")
        extrinsics = check_list("extrinsic_matrices", poses, "matrices")
        checked = check_images(NAMES, listed_images, _cameras(cameras, listed_images), extrinsics, self.device)
        arrays = self.arrays
        texels = SurfaceTexels(arrays["vertices"], arrays["triangles"], arrays["triangle_uvs"], size)
        if not texels.texels.size:
            raise ValueError("mesh: no triangle covers a texel. Scale triangle_uvs into 0..1, or use more texels")
        trees = plant_trees(self.arrays["vertices"], self.arrays["triangles"])
        sums = texels.blend(checked.stacked(self.arrays.origin, 0), trees)
        colors = self.arrays.get("vertex_colors")
        image = download(texels.write(sums, colors, GUTTER_TEXELS)).reshape(size, size, 3)  # sync
        fraction = texels.visible_fraction(sums)  # sync
        textured = self.with_arrays(triangle_material_ids=None)
        textured.textures = (image.copy(),)
        return textured, fraction


def _lay_out(
    vertices: NDArray[np.float32], triangles: NDArray[np.int32], size: int, gutter: float
) -> NDArray[np.float32]:
    """Texture coordinates of corners by xatlas, (3 t, 2)."""
    xatlas = _import_xatlas()
    padding, reason = math.ceil(_GUTTER_FACTOR * gutter), ""
    for _ in range(MAX_SIZES_TRIED):
        options = xatlas.PackOptions()
        options.resolution, options.padding = size, padding
        atlas = xatlas.Atlas()
        atlas.add_mesh(vertices, triangles.astype(np.uint32))
        atlas.generate(pack_options=options)
        rows, corners, uvs = atlas[0]
        edge = max(atlas.width, atlas.height)
        if not np.array_equal(rows[corners], triangles):
            raise RuntimeError("compute_uvatlas: xatlas returned different triangles than it was given")
        if padding * size >= gutter * edge:
            scaled = uvs[corners.reshape(-1)] * (np.array([atlas.width, atlas.height]) / max(edge, 1))
            return np.clip(scaled, 0, 1).astype(np.float32)
        reason = f"its {atlas.chart_count} charts with gutters of {gutter:g} need {edge} x {edge} texels"
        if edge > MAX_EXCESS * size:
            break
        padding = math.ceil(_GUTTER_FACTOR * gutter * edge / size)
    raise ValueError(f"size: {size} x {size} texels are too few for the mesh: {reason}")


def _import_xatlas() -> Any:
    try:
        import xatlas
    except ImportError as error:
        raise ImportError('compute_uvatlas needs the package xatlas: pip install "pointloom[mesh]"') from error
    return xatlas


def _cameras(cameras: Sequence[Any], images: list[Any]) -> Any:
    if isinstance(cameras, PinholeCameraIntrinsic):
        return cameras
    listed = check_list("intrinsic_matrices", cameras, "cameras")
    if len(listed) != len(images):
        raise ValueError(f"intrinsic_matrices: expected {len(images)}, one per image, got {len(listed)}")
    result = []
    for i, (camera, image) in enumerate(zip(listed, images, strict=True)):
        if not isinstance(camera, PinholeCameraIntrinsic):
            height, width = _size(image)
            try:
                camera = PinholeCameraIntrinsic.from_matrix(camera, width, height)
            except (TypeError, ValueError) as error:
                raise type(error)(f"intrinsic_matrices[{i}]: {error}") from error
        result.append(camera)
    return result


def _size(image: Any) -> tuple[int, int]:
    if hasattr(image, "height"):
        return image.height, image.width
    shape: tuple[int, ...] = np.shape(image)
    if len(shape) < 2 or 0 in shape:
        raise ValueError(f"images: expected images of shape [h, w, 3], got shape {list(shape)}")
    return shape[0], shape[1]
