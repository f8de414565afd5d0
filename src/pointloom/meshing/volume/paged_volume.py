"""PagedTSDFVolume: a TSDFVolume larger than memory, paged to disk."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.depth_range import OPEN3D_DEPTH_MAX
from ...cameras.images import RGBDImage
from ...core.argument_errors import explain_argument_errors
from ...core.attribute_hints import HintedNames
from ...core.checks import check_count, check_positive, check_rigid
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FilePath, values_of_file
from ...core.paths import path_of
from ...core.serialized import Serialized
from ...kernels.arrays.block_keys import CELL_BIAS
from ...kernels.lang import vec3, vec3i
from ...kernels.linear_algebra import inv
from ...kernels.memory import upload
from ...kernels.volumes.tsdf_blocks import BLOCK_SIDE, MAX_BLOCKS, frame_box
from ...pcd.cloud import PointCloud
from ..mesh.mesh import TriangleMesh
from .page_files import LIST, MAX_SIDE, PageFolder
from .paged_blocks import PagedBlocks, blocks_of
from .paged_surface import CubeReader, CubeSurface, joined
from .tsdf import FrameState, TSDFVolume
from .tsdf_views import RayCast, check_view


class PagedTSDFVolume(Serialized, HintedNames):
    """A TSDFVolume larger than memory: cubes of blocks that frames do not touch are stored on disk.

    Results are bitwise identical to a TSDFVolume's. Up to `max_blocks` are on the device. Before a frame is integrated,
    the cubes it touches are loaded and the least recently used ones written, each to an immutable file. Data since the
    last `save` is lost if the process ends; `load` restores the saved state. Frames are integrated atomically. Uses 8 B
    of host memory per block of the complete volume. Blocks are limited to 2^20 from the origin.

    Args:
        folder: Folder of the pages, created if missing. Only one process may use it at a time.
        voxel_size, truncation, color, device: As of TSDFVolume.
        max_blocks: Maximum blocks of 8^3 voxels on the device: 6 KB each with color, 3 KB without. Twice while paging.
        page_blocks: Blocks along a cube.
        overwrite: Remove an existing volume in the folder.

    Raises:
        ValueError: If a size or count is out of range, or the truncation is below one voxel.
        FileError: If the folder contains other data or a volume that may not be replaced, or is in use.

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

    @explain_argument_errors
    def __init__(
        self,
        folder: FilePath,
        voxel_size: float,
        truncation: float | None = None,
        *,
        color: bool = True,
        max_blocks: int = 100_000,
        page_blocks: int = 16,
        device: DeviceLike = None,
        overwrite: bool = False,
    ):
        folder = path_of(folder, "folder")
        limit, side = _check_counts(max_blocks, page_blocks)
        TSDFVolume(voxel_size=voxel_size, truncation=truncation, color=color, device=device)  # validates the arguments
        pages = PageFolder(folder, is_new=True, overwrite=overwrite)
        sizes: dict[str, Any] = {"voxel_size": voxel_size, "truncation": truncation, "color": color, "device": device}
        self._volume = PagedBlocks(pages, side, limit, **sizes)
        self._volume.save_pages()

    @classmethod
    def load(cls, folder: FilePath, *, max_blocks: int = 100_000, device: DeviceLike = None) -> PagedTSDFVolume:
        """Load a volume as last saved. Unsaved leftovers are removed by the next `save`.

        Raises:
            FileError: If there is none, it is damaged, or in use. Damaged pages are reported when needed.
            ValueError: If a count is below 1.
        """
        limit, _ = _check_counts(max_blocks, 1)
        pages = PageFolder(folder, is_new=False)
        saved = pages.saved()
        voxel_size, truncation = saved.header["sizes"].tolist()
        sizes: dict[str, Any] = {"voxel_size": voxel_size, "truncation": truncation, "device": resolve_device(device)}
        paged = cls.__new__(cls)
        with values_of_file(pages.path / LIST):
            volume = PagedBlocks(pages, saved.side, limit, color=bool(saved.header["has_color"][0]), **sizes)
            volume.adopt(saved)
        vars(paged)["_volume"] = volume
        return paged

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Release the folder for other processes. Unsaved data is lost."""
        self._volume.folder.close()

    def __repr__(self) -> str:
        size = f"{self.voxel_size} m voxels, {self.truncation} m truncation"
        blocks = f"{self.block_count:,} blocks, {self.resident_block_count:,} of them on {self.device}"
        return f"PagedTSDFVolume({size}, {blocks}, {self.frame_count} frames, {self.folder})"

    def __reduce__(self) -> Any:
        raise TypeError(
            "PagedTSDFVolume: cannot be copied or pickled, as its data is on disk. Save it and load the folder"
        )

    @property
    def folder(self) -> Path:
        """Folder of the pages."""
        return self._volume.folder.path

    @property
    def device(self) -> Any:
        """Device of the resident blocks."""
        return self._volume.device

    @property
    def voxel_size(self) -> float:
        """Edge of a voxel [m]."""
        return self._volume.voxel_size

    @property
    def truncation(self) -> float:
        """Truncation distance [m]."""
        return self._volume.truncation

    @property
    def max_blocks(self) -> int:
        """Maximum number of blocks on the device."""
        return self._volume.max_blocks

    @property
    def block_count(self) -> int:
        """Number of blocks of 8^3 voxels, on device and disk."""
        return self._volume.total

    @property
    def resident_block_count(self) -> int:
        """Number of blocks on the device."""
        return self._volume.block_count

    @property
    def frame_count(self) -> int:
        """Number of integrated frames."""
        return self._volume.frame_count

    @property
    def origin(self) -> NDArray[np.float64]:
        """Origin of the volume's coordinates [m], as of TSDFVolume."""
        return self._volume.origin

    @property
    def memory_bytes(self) -> int:
        """Device memory of voxels, keys and hash table [B]."""
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
        """Integrate a frame, as `TSDFVolume.integrate`.

        Raises:
            ValueError, TypeError: As `TSDFVolume.integrate`. Also if the touched cubes have more than `max_blocks`.
            FileError: If a page cannot be read or written. The volume stays unchanged.
        """
        return self._volume.integrate(depth, intrinsic, extrinsic, color, depth_scale, depth_max)

    def integrate_frames(
        self,
        depth: ArrayLike,
        intrinsic: PinholeCameraIntrinsic | Sequence[PinholeCameraIntrinsic],
        extrinsic: ArrayLike,
        color: ArrayLike | None = None,
        depth_scale: float | None = None,
        depth_max: float = OPEN3D_DEPTH_MAX,
    ) -> list[int]:
        """Integrate k frames, as `TSDFVolume.integrate_frames`, one after another.

        Raises:
            ValueError, TypeError: As there. Also if the cubes of a frame have more than `max_blocks`: frames before it
                stay.
            FileError: If a page cannot be read or written. Frames before it stay.
        """
        return self._volume.integrate_frames(depth, intrinsic, extrinsic, color, depth_scale, depth_max)

    def integrate_points(
        self,
        points: PointCloud | ArrayLike,
        origin: ArrayLike,
        *,
        carve: bool = True,
        min_range: float = 0.0,
        max_range: float | None = None,
    ) -> int:
        """Integrate a scan, as `TSDFVolume.integrate_points`. With `carve` all cubes along the rays are loaded.

        Raises:
            ValueError, TypeError, DeviceError: As there. Also if the cubes have more than `max_blocks`.
            FileError: If a page cannot be read or written. The volume stays unchanged.
        """
        ranges: dict[str, Any] = {"carve": carve, "min_range": min_range, "max_range": max_range}
        return self._volume.integrate_points(points, origin, **ranges)

    def save(self) -> None:
        """Write unsaved blocks to the folder and commit the state atomically.

        Raises:
            FileError: If a file cannot be written. The folder keeps the last saved state.
        """
        self._volume.save_pages()

    def extract_triangle_mesh(self, weight_threshold: float = 3.0) -> TriangleMesh:
        """As `TSDFVolume.extract_triangle_mesh`, bitwise identical, computed cube by cube.

        Raises:
            ValueError, FileError: If the threshold is negative or not finite, or if a page is damaged.
        """
        return self._mesh_of(joined(self._surfaces(weight_threshold, as_points=False)))

    def extract_parts(self, weight_threshold: float = 3.0) -> Iterator[TriangleMesh]:
        """The mesh in parts, one cube at a time: each triangle once, shared vertices bitwise equal.

        Raises:
            ValueError, FileError: If the threshold is negative or not finite, or if a page is damaged.
        """
        surfaces = self._surfaces(weight_threshold, as_points=False)
        return (self._mesh_of(surface) for surface in surfaces if len(surface.triangles))

    def extract_point_cloud(self, weight_threshold: float = 3.0) -> PointCloud:
        """As `TSDFVolume.extract_point_cloud`, bitwise identical, computed cube by cube.

        Raises:
            ValueError, FileError: If the threshold is negative or not finite, or if a page is damaged.
        """
        surface = joined(self._surfaces(weight_threshold, as_points=True))
        assert surface.normals is not None
        arrays = {"points": self._rows(surface.vertices), "normals": self._rows(surface.normals)}
        if self._volume.has_frame_colors:
            arrays["colors"] = self._rows(surface.colors)
        return PointCloud.from_device_arrays(arrays, self.origin, self._volume.array_library)

    def ray_cast(
        self,
        intrinsic: PinholeCameraIntrinsic,
        extrinsic: ArrayLike,
        *,
        depth_min: float = 0.1,
        depth_max: float = OPEN3D_DEPTH_MAX,
        weight_threshold: float = 3.0,
    ) -> RayCast:
        """As `TSDFVolume.ray_cast`; loads the cubes in view.

        Raises:
            ValueError, TypeError: As there. Also if the cubes have more than `max_blocks`.
            FileError: If a page cannot be read or written.
        """
        volume = self._volume
        _, far, _ = check_view(intrinsic, depth_min, depth_max, weight_threshold)
        far = min(far, 4 * CELL_BIAS * BLOCK_SIDE * volume.voxel_size)  # beyond it blocks have no key
        T = inv(check_rigid("extrinsic", extrinsic))
        T[:3, 3] -= volume.origin
        low, size, _ = frame_box(far, intrinsic, T, volume.truncation, volume.voxel_size)
        volume.bring_box(low, low + size)
        limits: dict[str, Any] = {"depth_min": depth_min, "depth_max": depth_max, "weight_threshold": weight_threshold}
        return volume.ray_cast(intrinsic, extrinsic, **limits)

    def to_volume(self) -> TSDFVolume:
        """Load all blocks into a TSDFVolume in memory.

        Raises:
            FileError, ValueError: If a page is damaged, or if there are too many blocks for 32-bit indices.
        """
        volume = self._volume
        arrays = volume.all_arrays()
        sizes: dict[str, Any] = {"voxel_size": volume.voxel_size, "truncation": volume.truncation}
        complete = TSDFVolume(**sizes, color=volume.has_color, device=volume.device)
        if len(arrays["keys"]) > MAX_BLOCKS:
            raise ValueError(f"{len(arrays['keys']):,} blocks exceed the maximum of one volume, {MAX_BLOCKS:,}")
        blocks = blocks_of(arrays, volume.blocks)
        frames = FrameState(volume.frame_count, volume.origin, volume.has_frame_colors)
        complete.set_content(blocks, frames, volume.array_library)
        return complete

    def _surfaces(self, weight_threshold: float, *, as_points: bool) -> Iterator[CubeSurface]:
        threshold = check_positive("weight_threshold", weight_threshold, allow_zero=True)
        return iter(CubeReader(self._volume, threshold, as_points=as_points))

    def _rows(self, values: ArrayLike | None) -> Any:
        return upload(np.ascontiguousarray(values), vec3, self.device)

    def _mesh_of(self, surface: CubeSurface) -> TriangleMesh:
        arrays = {
            "vertices": self._rows(surface.vertices),
            "triangles": upload(np.ascontiguousarray(surface.triangles), vec3i, self.device),
            "vertex_colors": self._rows(surface.colors) if self._volume.has_frame_colors else None,
        }
        return TriangleMesh.from_device_arrays(arrays, self.origin, self._volume.array_library)


def _check_counts(max_blocks: object, page_blocks: object) -> tuple[int, int]:
    limit, side = check_count("max_blocks", max_blocks), check_count("page_blocks", page_blocks)
    if limit > MAX_BLOCKS:
        raise ValueError(f"max_blocks: expected at most {MAX_BLOCKS:,}, the limit of 32-bit indices, got {limit:,}")
    if side > MAX_SIDE:
        raise ValueError(f"page_blocks: expected at most {MAX_SIDE:,}, got {side:,}")
    return limit, side
