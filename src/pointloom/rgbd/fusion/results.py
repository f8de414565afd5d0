"""Result of the fusion of posed frames."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.reports import Assessed, Fields, failed, in_columns, quality, with_warnings
from ...core.wording import format_bounds, format_bytes, format_fraction, plain
from ...io.frames.frames import why_out_of_range
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.mesh_summary import describe_mesh
from ...meshing.volume.tsdf import BLOCK_VOXELS, TSDFVolume
from ..slam.camera_check import FocalCheck
from .pose_check import MAX_DISPLACED, MAX_OFF_FRAMES, MAX_OFF_OF_FRAME, MAX_OFF_SURFACE, MAX_OFF_UNREFINED
from .refine import PoseRefinement

MAX_VOXEL_FRACTION = 0.05  # of the seen extent: larger voxels show no shape


@dataclasses.dataclass(frozen=True, eq=False)
class FusionResult(Assessed):
    """Result of `fuse`.

    Attributes:
        mesh: The surface; may be empty.
        volume: The volume it was extracted from.
        T_world_camera: Camera poses, float64 [n, 4, 4] [m].
        depth_max: Maximum depth [m].
        depth_fraction: Fraction of all pixels with depth.
        used_fraction: Fraction of all pixels with depth up to `depth_max`.
        weight_threshold: Minimum weight (exclusive) of surface voxels.
        refinement: Result of the pose refinement, if any.
        fractions_off: Fraction of the depth of sampled frames that is off the surface. Empty if unknown.
        seen_extent: Longest side of the observed scene [m]. None if not measured.
        source_warnings: Failed checks of the frames: an assumed or implausible camera, or mostly unpaired images.
        camera: Whether sampled frames fit the given poses better with another camera. None if they do not determine it.
        depth_factor: Factor of the depth that fits the poses better. 1 without a better one.
        depth_deviation: Standard deviation of `depth_factor`. 0 if unknown.
        fraction_displaced: Fraction of the pairs of sampled frames whose poses displace the surface by more than 3 cm
            and a voxel. 0 if unknown.
        notes: Remarks that do not concern reliability: colors that are not exactly registered to depth, and values of
            the camera and the depth unit that the frames do not determine.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from types import SimpleNamespace
        >>> camera = loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5)
        >>> wall = SimpleNamespace(depth=np.full((24, 32), 1000, np.uint16), color=None, T_world_camera=np.eye(4))
        >>> print(loom.rgbd.fuse(loom.frames_from([wall], camera), voxel_size=0.05))
          frames  1 on cpu; 100.0% of the pixels within 4 m
          voxels  8,192 of 50 mm, truncation 200 mm, in 16 blocks
          mesh    315 vertices, 560 triangles
          bounds  [-0.5000, -0.3500, 1.0000] to [0.5000, 0.3500, 1.0000]
          memory  782.0 KiB of volume
          note    the camera and the depth unit are not checked: too few sampled frames overlap at the given poses
    """

    mesh: TriangleMesh
    volume: TSDFVolume
    T_world_camera: NDArray[np.float64]
    depth_max: float
    depth_fraction: float
    used_fraction: float
    weight_threshold: float
    refinement: PoseRefinement | None = None
    fractions_off: tuple[float, ...] = ()
    seen_extent: float | None = None
    source_warnings: tuple[str, ...] = ()
    camera: FocalCheck | None = None
    depth_factor: float = 1.0
    notes: tuple[str, ...] = ()
    depth_deviation: float = 0.0
    fraction_displaced: float = 0.0

    def __str__(self) -> str:
        return in_columns(with_warnings(self.fields(), self))

    @property
    def frame_count(self) -> int:
        """Number of fused frames."""
        return len(self.T_world_camera)

    @property
    def _why_no_surface(self) -> str | None:
        if reason := why_out_of_range(self.depth_fraction, self.used_fraction, self.depth_max):
            return reason
        if self.seen_extent and self.volume.voxel_size > MAX_VOXEL_FRACTION * self.seen_extent:
            return self._why_coarse(self.seen_extent)
        if not len(self.mesh):
            return (
                f"the mesh is empty: no voxel was seen more than {self.weight_threshold:g} times; use more frames, or "
                "check poses and camera"
            )
        return None

    def _why_coarse(self, extent: float) -> str:
        size = self.volume.voxel_size
        is_than = "is larger than" if size > extent else "is more than a twentieth of"
        usual = f"{0.005 * extent:.1g}"
        return f"voxel_size: {size:g} m {is_than} the scene ({extent:.2g} m); pass it in meters, for example {usual}"

    @property
    def warnings(self) -> tuple[str, ...]:
        is_matched = max(self.fractions_off, default=1.0) <= MAX_OFF_UNREFINED
        refinement = () if self.refinement is None or is_matched else self.refinement.warnings
        camera = () if self.camera is None else self.camera.warnings
        poses = self._why_contradicted, self._why_scaled
        return failed(self._why_no_surface, *refinement, *poses, *camera, *self.source_warnings)

    @property
    def fraction_off(self) -> float | None:
        """Median of `fractions_off`. None if unknown."""
        return float(np.median(self.fractions_off)) if self.fractions_off else None

    @property
    def _why_contradicted(self) -> str | None:
        count, off_count = len(self.fractions_off), sum(each > MAX_OFF_OF_FRAME for each in self.fractions_off)
        if self.fraction_off is not None and self.fraction_off > MAX_OFF_SURFACE:
            return (
                f"{format_fraction(self.fraction_off)} of the measured depth is off the fused surface: the poses are "
                "wrong, belong to other frames, or are camera to world instead of world to camera, or the depth is in "
                "another unit"
            )
        if off_count > max(1, MAX_OFF_FRAMES * count):
            return f"{off_count} of {count} sampled frames are off the fused surface: their poses are wrong"
        is_camera_right = self.depth_factor == 1.0 and (self.camera is None or self.camera.reliable)
        if self.fraction_displaced > MAX_DISPLACED and is_camera_right:
            return (
                f"{format_fraction(self.fraction_displaced)} of the pairs of sampled frames contradict each other by "
                "more than 3 cm: some of their poses are wrong; check that each pose belongs to its frame, or pass "
                "refine=True"
            )
        return None

    @property
    def _why_scaled(self) -> str | None:
        if self.depth_factor == 1.0:
            return None
        sigma = f" (sigma {self.depth_deviation:.2g})" if self.depth_deviation else ""
        return (
            f"the poses fit better if the depth is multiplied by about {self.depth_factor:.3g}{sigma}; check "
            "depth_scale, and that the poses are in meters"
        )

    def to_dict(self) -> dict[str, Any]:
        volume, size = self.volume, describe_mesh(self.mesh).to_dict()
        return {
            "device": str(volume.device),
            "frames": self.frame_count,
            "voxel_size": volume.voxel_size,
            "truncation": volume.truncation,
            "depth_max": self.depth_max,
            "weight_threshold": self.weight_threshold,
            "depth_fraction": self.depth_fraction,
            "used_fraction": self.used_fraction,
            "fraction_off": self.fraction_off,
            "fraction_displaced": self.fraction_displaced,
            "seen_extent": self.seen_extent,
            "camera_check": plain(self.camera),
            "depth_factor": self.depth_factor,
            "depth_deviation": self.depth_deviation,
            "notes": list(self.notes),
            "blocks": volume.block_count,
            "voxels": volume.block_count * BLOCK_VOXELS,
            "volume_bytes": volume.memory_bytes,
            **size,
            "refinement": None if self.refinement is None else self.refinement.to_dict(),
            **quality(self),
        }

    def fields(self) -> Fields:
        volume, mesh = self.volume, self.mesh
        seen = f"{format_fraction(self.used_fraction)} of the pixels within {self.depth_max:g} m"
        size = f"{volume.voxel_size * 1000:g} mm, truncation {volume.truncation * 1000:g} mm"
        blocks = volume.block_count
        return [
            ("frames", f"{self.frame_count} on {volume.device}; {seen}"),
            *([("poses", str(self.refinement))] if self.refinement else []),
            ("voxels", f"{blocks * BLOCK_VOXELS:,} of {size}, in {blocks:,} blocks"),
            ("mesh", f"{len(mesh.vertices):,} vertices, {len(mesh):,} triangles"),
            ("bounds", format_bounds(describe_mesh(mesh).to_dict()["bounds"])),
            ("memory", f"{format_bytes(volume.memory_bytes)} of volume"),
            *(("note", note) for note in self.notes),
        ]
