"""PagedTSDFVolume: a TSDFVolume larger than memory, whose blocks come from disk and go there."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from types import TracebackType
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.images import RGBDImage
from ...core.checks import check_count, check_positive, check_rigid
from ...core.devices import resolve_device
from ...core.errors import FilePath, values_of_file
from ...core.known_names import ToldNames
from ...core.paths import path_of
from ...core.told_arguments import told_arguments
from ...kernels.arrays.block_keys import BIAS
from ...kernels.lang import vec3, vec3i
from ...kernels.linear_algebra import inv
from ...kernels.memory import upload
from ...kernels.volumes.tsdf_blocks import MAX_BLOCKS, SIDE, frame_box
from ...pcd.cloud import PointCloud
from ..mesh.mesh import TriangleMesh
from .page_files import LIST, MOST_SIDE, PageFolder
from .paged_blocks import PagedBlocks, blocks_of
from .paged_surface import CubeReader, CubeSurface, joined
from .tsdf import TSDFVolume
from .tsdf_views import RayCast, check_view


class PagedTSDFVolume(ToldNames):
    """A TSDFVolume larger than memory: cubes of blocks that frames do not touch lie on disk.

    Takes what a TSDFVolume takes and gives the same bits: `extract_triangle_mesh` makes the same mesh, in the same
    order. Up to `max_blocks` are on the device. Before a frame is folded in, the cubes of all blocks that it touches
    are brought; those that were touched longest ago go, each into a file that is not written to again.

    What was integrated since the last `save` is lost with the process. Whatever ends it, `load` finds the volume as
    `save` left it. A frame that is refused or interrupted is in the volume whole or not at all.

    Args:
        folder: Where pages lie; made where it is missing. One process works in it at a time.
        voxel_size, truncation, color, device: As of TSDFVolume.
        max_blocks: Blocks of 8^3 voxels on the device at most: 6 KB each with colour, 3 KB without. While cubes come
            and go they are there twice.
        page_blocks: Blocks along a cube.
        overwrite: Whether a volume that lies in the folder is removed.

    Raises:
        ValueError: Sizes that are not positive, a truncation below one voxel, counts below 1 or too large.
        FileError: The folder holds something else, a volume that may not be replaced, or another process works in it.

    Notes:
        Host memory holds 8 B a block of the whole volume. No block beyond 2^20 from the origin. On a GPU frames are
        folded in from the host, which waits for the device twice a frame.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> with loom.PagedTSDFVolume("pages", voxel_size=0.02, color=False, max_blocks=300) as volume:
        ...     for k in range(4):
        ...         pose = np.eye(4)
        ...         pose[0, 3] = -1.5 * k
        ...         touched = volume.integrate(np.full((48, 64), 1000, np.uint16), camera, pose)
        ...     volume.save()
        ...     volume.block_count > 300 >= volume.resident_block_count
        True
        >>> len(loom.PagedTSDFVolume.load("pages", max_blocks=300).extract_triangle_mesh(weight_threshold=0)) > 0
        True
    """

    @told_arguments
    def __init__(
        self,
        folder: FilePath,
        *,
        voxel_size: float,
        truncation: float | None = None,
        color: bool = True,
        max_blocks: int = 100_000,
        page_blocks: int = 16,
        device: Any = None,
        overwrite: bool = False,
    ):
        folder = path_of(folder, "folder")
        most, side = _check_counts(max_blocks, page_blocks)
        TSDFVolume(voxel_size=voxel_size, truncation=truncation, color=color, device=device)  # checks these
        pages = PageFolder(folder, is_new=True, overwrite=overwrite)
        sizes: dict[str, Any] = {"voxel_size": voxel_size, "truncation": truncation, "color": color, "device": device}
        self._volume = PagedBlocks(pages, side, most, **sizes)
        self._volume.save_pages()

    @classmethod
    def load(cls, folder: FilePath, *, max_blocks: int = 100_000, device: Any = None) -> PagedTSDFVolume:
        """Go on with a volume as it was last saved; what was left of frames after that is removed by the next `save`.

        Raises:
            FileError: There is none, it is damaged, or another process works in it. A damaged page is told of when it
                is needed.
            ValueError: A count below 1.
        """
        most, _ = _check_counts(max_blocks, 1)
        pages = PageFolder(folder, is_new=False)
        saved = pages.saved()
        voxel_size, truncation = saved.told["sizes"].tolist()
        sizes: dict[str, Any] = {"voxel_size": voxel_size, "truncation": truncation, "device": resolve_device(device)}
        paged = cls.__new__(cls)
        with values_of_file(pages.path / LIST):
            paged._volume = PagedBlocks(pages, saved.side, most, color=bool(saved.told["has_color"][0]), **sizes)
            paged._volume.adopt(saved)
        return paged

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Let other processes work in the folder; what was not saved is lost."""
        self._volume.folder.close()

    def __repr__(self) -> str:
        size = f"{self.voxel_size} m voxels, {self.truncation} m truncation"
        blocks = f"{self.block_count:,} blocks, {self.resident_block_count:,} of them on {self.device}"
        return f"PagedTSDFVolume({size}, {blocks}, {self.frame_count} frames, {self.folder})"

    def __reduce__(self) -> Any:
        raise TypeError("PagedTSDFVolume: is its folder, and cannot be copied or pickled; save it and load the folder")

    @property
    def folder(self) -> Path:
        """Where pages lie."""
        return self._volume.folder.path

    @property
    def device(self) -> Any:
        """Where blocks are that are not on disk."""
        return self._volume.device

    @property
    def voxel_size(self) -> float:
        """Edge of a voxel [m]."""
        return self._volume.voxel_size

    @property
    def truncation(self) -> float:
        """Distance at which signed distances are cut [m]."""
        return self._volume.truncation

    @property
    def max_blocks(self) -> int:
        """Blocks on the device at most."""
        return self._volume.max_blocks

    @property
    def block_count(self) -> int:
        """Blocks of 8^3 voxels, wherever they are."""
        return self._volume.total

    @property
    def resident_block_count(self) -> int:
        """Blocks on the device."""
        return self._volume.block_count

    @property
    def frame_count(self) -> int:
        """Frames folded in."""
        return self._volume.frame_count

    @property
    def origin(self) -> NDArray[np.float64]:
        """Where the volume's coordinates start [m], as of TSDFVolume."""
        return self._volume.origin

    @property
    def memory_bytes(self) -> int:
        """Bytes of device memory held by voxels, keys and the hash table."""
        return self._volume.memory_bytes

    def integrate(
        self,
        depth: ArrayLike | RGBDImage,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike,
        color: ArrayLike | None = None,
        depth_scale: float | None = None,
        depth_max: float | None = None,
    ) -> int:
        """Fold in one frame, as `TSDFVolume.integrate`.

        Raises:
            ValueError: As there; or the cubes that the frame touches have more than `max_blocks`.
            TypeError: As there.
            FileError: A page cannot be read or written. The volume stays as it was.
        """
        return self._volume.integrate(depth, intrinsic, extrinsic, color, depth_scale, depth_max)

    def integrate_points(
        self,
        points: PointCloud | ArrayLike,
        origin: ArrayLike,
        *,
        carve: bool = True,
        min_range: float = 0.0,
        max_range: float | None = None,
    ) -> int:
        """Fold in one scan, as `TSDFVolume.integrate_points`; with `carve` all cubes are brought that rays pass.

        Raises:
            ValueError, TypeError, DeviceError: As there; or these cubes have more than `max_blocks`.
            FileError: A page cannot be read or written. The volume stays as it was.
        """
        ranges: dict[str, Any] = {"carve": carve, "min_range": min_range, "max_range": max_range}
        return self._volume.integrate_points(points, origin, **ranges)

    def save(self) -> None:
        """Write to the folder what is on the device alone, and then in one step that the volume is what it is now.

        Raises:
            FileError: A file cannot be written; the folder holds what was saved before.
        """
        self._volume.save_pages()

    def extract_triangle_mesh(self, weight_threshold: float = 3.0) -> TriangleMesh:
        """The mesh of `TSDFVolume.extract_triangle_mesh`, the same bits in the same order, found cube by cube.

        Raises:
            ValueError: A threshold that is negative or not finite.
            FileError: A page is damaged.
        """
        return self._mesh_of(joined(self._surfaces(weight_threshold, as_points=False)))

    def extract_parts(self, weight_threshold: float = 3.0) -> Iterator[TriangleMesh]:
        """The same mesh in parts, a cube at a time: each triangle once, the same bits in vertices that parts share.

        Raises:
            ValueError: A threshold that is negative or not finite.
            FileError: A page is damaged.
        """
        surfaces = self._surfaces(weight_threshold, as_points=False)
        return (self._mesh_of(surface) for surface in surfaces if len(surface.triangles))

    def extract_point_cloud(self, weight_threshold: float = 3.0) -> PointCloud:
        """The cloud of `TSDFVolume.extract_point_cloud`, the same bits in the same order, found cube by cube.

        Raises:
            ValueError: A threshold that is negative or not finite.
            FileError: A page is damaged.
        """
        surface = joined(self._surfaces(weight_threshold, as_points=True))
        assert surface.normals is not None
        arrays = {"points": self._rows(surface.vertices), "normals": self._rows(surface.normals)}
        if self._volume.has_frame_colors:
            arrays["colors"] = self._rows(surface.colors)
        return PointCloud._from_device_arrays(arrays, self.origin, self._volume.array_library)

    def ray_cast(
        self,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike,
        *,
        depth_min: float = 0.1,
        depth_max: float = 3.0,
        weight_threshold: float = 3.0,
    ) -> RayCast:
        """What a camera would see, as `TSDFVolume.ray_cast`; the cubes before it are brought.

        Raises:
            ValueError, TypeError: As there; or these cubes have more than `max_blocks`.
            FileError: A page cannot be read or written.
        """
        volume = self._volume
        _, far, _ = check_view(intrinsic, depth_min, depth_max, weight_threshold)
        far = min(far, 4 * BIAS * SIDE * volume.voxel_size)  # beyond which no block has a key
        T = inv(check_rigid("extrinsic", extrinsic))
        T[:3, 3] -= volume.origin
        low, size, _ = frame_box(far, intrinsic, T, volume.truncation, volume.voxel_size)
        volume.bring_box(low, low + size)
        limits: dict[str, Any] = {"depth_min": depth_min, "depth_max": depth_max, "weight_threshold": weight_threshold}
        return volume.ray_cast(intrinsic, extrinsic, **limits)

    def to_volume(self) -> TSDFVolume:
        """A TSDFVolume of all blocks, in memory.

        Raises:
            FileError: A page is damaged.
            ValueError: More blocks than 32 bits can index.
        """
        volume = self._volume
        arrays = volume.all_arrays()
        sizes: dict[str, Any] = {"voxel_size": volume.voxel_size, "truncation": volume.truncation}
        whole = TSDFVolume(**sizes, color=volume.has_color, device=volume.device)
        if len(arrays["keys"]) > MAX_BLOCKS:
            raise ValueError(f"{len(arrays['keys']):,} blocks are more than one volume has, {MAX_BLOCKS:,}")
        blocks = blocks_of(arrays, volume._blocks)
        whole._adopt(blocks, volume.frame_count, volume.origin, volume._settled.colored, volume.array_library)
        return whole

    def _surfaces(self, weight_threshold: float, *, as_points: bool) -> Iterator[CubeSurface]:
        threshold = check_positive("weight_threshold", weight_threshold, allow_zero=True)
        return iter(CubeReader(self._volume, threshold, as_points=as_points))

    def _rows(self, values: Any) -> Any:
        return upload(np.ascontiguousarray(values), vec3, self.device)

    def _mesh_of(self, surface: CubeSurface) -> TriangleMesh:
        colors = self._rows(surface.colors) if self._volume.has_frame_colors else None
        triangles = upload(np.ascontiguousarray(surface.triangles), vec3i, self.device)
        told: dict[str, Any] = {"origin": self.origin, "library": self._volume.array_library}
        return TriangleMesh._from_device_arrays(self._rows(surface.vertices), triangles, vertex_colors=colors, **told)


def _check_counts(max_blocks: Any, page_blocks: Any) -> tuple[int, int]:
    most, side = check_count("max_blocks", max_blocks), check_count("page_blocks", page_blocks)
    if most > MAX_BLOCKS:
        raise ValueError(f"max_blocks: {most:,} are more than 32 bits index, {MAX_BLOCKS:,}")
    if side > MOST_SIDE:
        raise ValueError(f"page_blocks: {side:,} are more than {MOST_SIDE:,}")
    return most, side
