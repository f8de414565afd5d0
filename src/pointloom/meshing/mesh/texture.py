"""Texture of a mesh: texture atlas, baked colors, albedo from images."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_count, check_list, check_positive
from ...kernels.arrays.bounds import bound_points
from ...kernels.lang import vec2
from ...kernels.memory import check_room, download, upload
from ...kernels.textures.atlas_colors import draw_vertex_colors
from ...kernels.textures.hidden_vertices import plant_trees
from ...kernels.textures.surface_texels import SurfaceTexels
from .mesh_arrays import Mesh, MeshArrays
from .posed_images import Names, check_images

MAX_SIZE = 2**14  # per side. File formats allow 2^28 texels
TEXEL_BYTES = 40
MAX_SIZES_TRIED = 3
MAX_EXCESS = 3  # maximum ratio of xatlas's image to the size: beyond, wider gutters only enlarge the image
_GUTTER_FACTOR = 1.5  # xatlas exceeds the requested size by 20% or more, which shrinks the gutter
MAX_TEXELS = 16384  # per side: 2.7e8 texels, about 30 GB temporarily
NAMES = Names("images", "intrinsic_matrices", "extrinsic_matrices")
GUTTER_TEXELS = 8  # texels of padding: three mipmap levels


def compute_uvatlas(mesh: Mesh, size: int, gutter: float) -> Mesh:
    """As `TriangleMesh.compute_uvatlas`."""
    size = check_count("size", size, maximum=MAX_SIZE, because="textures have at most 2^28 texels")
    gutter = check_positive("gutter", gutter, allow_zero=True, maximum=size / 4)
    low, high, finite = bound_points(mesh.arrays["vertices"])
    if not len(mesh):
        raise ValueError("compute_uvatlas: the mesh has no triangles")
    if finite < mesh.arrays["vertices"].size:
        raise ValueError("compute_uvatlas: expected finite vertices, got NaN or infinite ones")
    extent = float((high.astype(np.float64) - low).max())
    corners = (download(mesh.arrays["vertices"]).reshape(-1, 3).astype(np.float64) - low) / (extent or 1.0)
    uvs = _lay_out(corners.astype(np.float32), mesh.triangles, size, gutter)
    without = mesh.with_arrays(triangle_uvs=None, triangle_material_ids=None)
    return without.with_arrays(triangle_uvs=upload(uvs, vec2, mesh.device))


def bake_vertex_colors(mesh: Mesh, size: int, *, gutter: int) -> Mesh:
    """As `TriangleMesh.bake_vertex_colors`."""
    size = check_count("size", size, maximum=MAX_SIZE, because="textures have at most 2^28 texels")
    gutter = check_count("gutter", gutter, minimum=0, maximum=size)
    for name, advice in (("vertex_colors", "set them first"), ("triangle_uvs", "call compute_uvatlas() first")):
        if name not in mesh.arrays:
            raise ValueError(f"bake_vertex_colors: the mesh has no {name}; {advice}")
    uvs = download(mesh.arrays["triangle_uvs"])
    if not ((uvs >= 0) & (uvs <= 1)).all():
        raise ValueError("triangle_uvs: expected coordinates in 0..1. Call compute_uvatlas() first")
    check_room(mesh.device, size * size * TEXEL_BYTES, f"size: a texture of {size} x {size} texels")
    arrays = (mesh.arrays["triangles"], mesh.arrays["vertex_colors"], mesh.arrays["triangle_uvs"])
    image = download(draw_vertex_colors(*arrays, size, gutter)).reshape(size, size, 3)
    baked = mesh.with_arrays(vertex_colors=None, triangle_material_ids=None)
    baked.textures = [image]
    return baked


def with_albedo(
    mesh: MeshArrays, images: Sequence[Any], cameras: Any, poses: ArrayLike | None, tex_size: int
) -> tuple[Any, float]:
    """(mesh with its texture, fraction of texels seen in an image)."""
    because = "the texture and its intermediate arrays would not fit into memory. Use fewer texels"
    size = check_count("tex_size", tex_size, minimum=1, maximum=MAX_TEXELS, because=because)
    if not len(mesh):
        raise ValueError("mesh: expected triangles to texture, got none")
    if "triangle_uvs" not in mesh.arrays:
        raise ValueError("mesh: expected triangle_uvs, got none. Call compute_uvatlas() first")
    listed_images = check_list("images", images, "images")
    extrinsics = check_list("extrinsic_matrices", poses, "matrices")
    checked = check_images(NAMES, listed_images, _cameras(cameras, listed_images), extrinsics, mesh.device)
    arrays = mesh.arrays
    texels = SurfaceTexels(arrays["vertices"], arrays["triangles"], arrays["triangle_uvs"], size)
    if not texels.texels.size:
        raise ValueError("mesh: no triangle covers a texel. Scale triangle_uvs into 0..1, or use more texels")
    trees = plant_trees(mesh.arrays["vertices"], mesh.arrays["triangles"])
    sums = texels.blend(checked.stacked(mesh.arrays.origin, 0), trees)
    colors = mesh.arrays.get("vertex_colors")
    image = download(texels.write(sums, colors, GUTTER_TEXELS)).reshape(size, size, 3)  # sync
    fraction = texels.visible_fraction(sums)  # sync
    textured = mesh.with_arrays(triangle_material_ids=None)
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
