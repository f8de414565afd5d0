"""The texture of a mesh from posed pictures."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_count, check_list
from ...kernels.memory import download
from ...kernels.textures.hidden_vertices import plant_trees
from ...kernels.textures.surface_texels import SurfaceTexels
from .mesh_arrays import MeshArrays
from .posed_images import Names, check_images

MOST_TEXELS = 16384  # a side: 2.7e8 texels, some 30 GB on the way
NAMES = Names("images", "intrinsic_matrices", "extrinsic_matrices")
GUTTER = 8  # rings of texels: three levels of a mipmap


class MeshAlbedo(MeshArrays):
    """The part of TriangleMesh that fills a texture from pictures."""

    def project_images_to_albedo(
        self, images: Any, intrinsic_matrices: Any, extrinsic_matrices: Any, tex_size: int = 1024
    ) -> Any:
        """Fill the mesh's texture with what posed pictures show of it.

        Each texel is looked up in every picture that shows it from before, nothing of the mesh in between (one ray a
        texel and picture) and no edge of it within 2 pixels, and takes their mean by angle of view and distance:
        (cos / depth)^4. What no picture shows takes the vertices' colours where there are any, else black. Open3D
        returns the picture and puts it into the mesh's material; here a new mesh has it.

        Args:
            images: uint8 pictures [h, w, 3], or RGBDImages with colours, whose depth is not looked at.
            intrinsic_matrices: Calibration matrices [3, 3], one a picture, or one PinholeCameraIntrinsic for all, or a
                list of those.
            extrinsic_matrices: T_camera_world [4, 4], world to camera, one a picture.
            tex_size: Texels a side.

        Returns:
            The mesh with this one texture, uint8 [tex_size, tex_size, 3], and without material numbers. Texels beside
            the triangles' places (8 rings) repeat them, so seams do not show when texels are blended.

        Raises:
            ValueError: No triangles, no texture coordinates or none in 0..1, pictures, cameras and poses of different
                number or size, or a pose that is no rigid motion.
            TypeError: Not pictures, or not cameras.
            DeviceError: Images on another device than the mesh.

        Notes:
            The same bits from run to run on one device. Some 110 B of memory a texel, 7 B a pixel. A triangle that
            covers much of the texture is the work of one thread.

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
        return self._with_albedo(images, intrinsic_matrices, extrinsic_matrices, tex_size)[0]

    def _with_albedo(self, images: Any, cameras: Any, poses: Any, tex_size: int) -> tuple[Any, float]:
        """The mesh with its texture, and the share of its texels that a picture shows."""
        because = "the texture and what it is made from would not fit; take fewer texels"
        size = check_count("tex_size", tex_size, minimum=1, maximum=MOST_TEXELS, because=because)
        if not len(self):
            raise ValueError("mesh: it has no triangles, so there is no surface to paint")
        if "triangle_uvs" not in self._arrays:
            raise ValueError("mesh: it has no triangle_uvs; make an atlas first")
        pictures = check_list("images", images, "pictures")
        extrinsics = check_list("extrinsic_matrices", poses, "matrices")
        checked = check_images(NAMES, pictures, _cameras(cameras, pictures), extrinsics, self._device)
        arrays = self._arrays
        texels = SurfaceTexels(arrays["vertices"], arrays["triangles"], arrays["triangle_uvs"], size)
        if not texels.texels.size:
            raise ValueError("mesh: no triangle covers a texel; bring triangle_uvs into 0..1, or take more texels")
        trees = plant_trees(self._arrays["vertices"], self._arrays["triangles"])
        sums = texels.blend(checked.pictures(self._origin, 0), trees)
        colors = self._arrays.get("vertex_colors")
        picture = download(texels.write(sums, colors, GUTTER)).reshape(size, size, 3)  # sync
        share = texels.share_shown(sums)  # sync
        textured = self._with_arrays(triangle_material_ids=None)
        textured.textures = (picture.copy(),)
        return textured, share


def _cameras(cameras: Any, pictures: list[Any]) -> Any:
    """Cameras of matrices, whose sizes are the pictures'."""
    if isinstance(cameras, PinholeCameraIntrinsic):
        return cameras
    listed = check_list("intrinsic_matrices", cameras, "cameras")
    if len(listed) != len(pictures):
        raise ValueError(f"intrinsic_matrices: {len(listed)} cameras, but {len(pictures)} images; give one an image")
    result = []
    for i, (camera, image) in enumerate(zip(listed, pictures, strict=True)):
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
        raise ValueError(f"images: expected pictures [h, w, 3], got shape {list(shape)}")
    return shape[0], shape[1]
