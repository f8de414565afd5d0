"""Colors or texture of a mesh from RGB-D frames: `texture_mesh`."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.depth_range import DEPTH_MAX
from ...cameras.images import RGBDImage
from ...cameras.trajectory import Trajectory
from ...core.checks import check_count, check_list, check_name, check_positive, check_progress, check_rigid, shown
from ...core.errors import FilePath
from ...core.kept_arrays import Arrays, KeptArrays, digest_of_inputs, kept_arrays
from ...core.progress import ReportProgress
from ...core.wording import format_duration
from ...io.frames.datasets import Frame
from ...io.frames.frames import depth_unit, source_warnings
from ...io.frames.rgbd_sources import RGBDSource
from ...io.points.archives import read_part_of_job
from ...kernels.array_types import Device
from ...kernels.lang import vec2
from ...kernels.linear_algebra import inv
from ...kernels.memory import download, upload
from ..mesh.mesh import TriangleMesh
from ..mesh.mesh_arrays import check_mesh
from ..mesh.texture import MAX_TEXELS, with_albedo
from .optimizers import color_mesh
from .options import ColorMapOption
from .results import ColorMapResult
from .textured_mesh import TexturedMesh, mean_motion

METHODS = ("rigid", "non-rigid", "none")

# CPU time of xatlas 0.0.11 for decimated meshes of an RGB-D kitchen (7-Scenes), 29 November 2026: 0.9 s for 5,000
# triangles, 1.3 s for 10,000, 6.2 s for 20,000 and 15.3 s for 40,000. It reports no progress of its own.
TRIANGLES_OF_ATLAS, SECONDS_OF_ATLAS, ATLAS_EXPONENT = 40_000, 15.3, 1.35
RIGID_ITERATIONS = 100  # maximum iterations
NON_RIGID_ITERATIONS = 30  # maximum iterations for image warps, which start from the rigid result
GUTTER_TEXELS = 4  # texels between charts of an atlas: two mipmap levels
MIN_DEPTH_STEP = 0.4  # [m] Sobel response of a step of 5 cm: floors at grazing angles and noise are below
STEP_MARGIN = 2  # ignored pixels beside such a step


def texture_mesh(
    mesh: TriangleMesh,
    frames: RGBDSource,
    poses: ArrayLike | None = None,
    *,
    method: str = "rigid",
    size: int | None = None,
    depth_max: float = DEPTH_MAX,
    work: FilePath | None = None,
    progress: ReportProgress | None = None,
) -> TexturedMesh:
    """Color or texture a mesh from RGB-D frames with refined poses, and check the result, as `pointloom texture`.

    Runs `optimize_color_map` with settings for depth cameras, optionally also non-rigid, and fills an
    atlas. Bitwise reproducible on one device.

    Args:
        mesh: In the frame of the poses.
        frames: With colors, such as `loom.open_dataset("kitchen")`. All in memory, 7 B per pixel.
        poses: T_world_camera of each frame (n, 4, 4). If None: the frames' own.
        method: "rigid" refines poses, "non-rigid" also warps images, "none" does neither.
        size: Texels per side of a texture, which replaces vertex colors. An atlas is created if necessary
            (`pip install "pointloom[mesh]"`). If None: vertex colors.
        depth_max: Maximum depth of used pixels [m].
        work: Folder for finished steps, about 100 B per vertex and triangle. After an interruption, a call with the
            same inputs continues from it, with bitwise the same result. Delete it after the result is stored. If None,
            an interruption loses all work.
        progress: Called with the stage ("frames", "colors", "atlas", "texture"), its progress and total, 0 if unknown.

    Raises:
        TypeError: If `mesh` is not a TriangleMesh, or `frames` has another type.
        ValueError: If the method is unknown, a number is out of range, frames lack color or pose, or the mesh is empty.
        NothingSeenError: If no frame sees a vertex. It is a ValueError.
        FileError: If an image cannot be read, or the folder `work` contains other files or is in use.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> mesh = loom.TriangleMesh([[-0.1, -0.1, 1], [0.1, -0.1, 1], [0, 0.1, 1]], [[0, 2, 1]])
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> color, depth = np.full((48, 64, 3), (0, 255, 0), np.uint8), np.full((48, 64), 1000, np.uint16)
        >>> found = loom.meshing.texture_mesh(mesh, loom.frames_from([(color, depth)], camera), [np.eye(4)])
        >>> found.mesh.vertex_colors[0].tolist(), found.moved
        ([0.0, 1.0, 0.0], 0.0)
    """
    _check(mesh, frames, method, size)
    farthest, report = check_positive("depth_max", depth_max), check_progress(progress)
    images, path = _read_frames(frames, poses, farthest, mesh.device, report)
    camera = frames.intrinsic
    with kept_arrays(work, lambda: _digest_of(mesh, images, path, camera, [method, size, farthest]), report) as kept:
        report("colors", 0, 0)
        colors = _color(mesh, images, path, camera, method, farthest, kept)
        rotated, moved = mean_motion(path, colors.trajectory)
        result = TexturedMesh(
            colors.mesh, colors, method, farthest, rotated, moved, source_warnings=source_warnings(frames)
        )
        if size is None:
            return result
        textured, fraction = _paint_atlas(colors, camera, size, kept)
        return dataclasses.replace(result, mesh=textured, size=size, texel_fraction=fraction)


def _digest_of(
    mesh: TriangleMesh, images: list[RGBDImage], path: Trajectory, camera: PinholeCameraIntrinsic, settings: list[Any]
) -> str:
    """Digest of everything that determines the result."""
    names = [name for name in ("vertices", "triangles", "triangle_uvs", "vertex_colors") if name in mesh.arrays]
    arrays = [download(mesh.arrays[name]) for name in names] + [mesh.origin, path.poses]
    for image in images:
        arrays += [download(image.color_array), download(image.depth_array)]
    lens = [camera.width, camera.height, camera.fx, camera.fy, camera.cx, camera.cy]
    return digest_of_inputs([settings, names, lens], arrays, mesh.device)


def _check(mesh: TriangleMesh, frames: object, method: object, size: object) -> None:
    check_mesh("mesh", mesh)
    if not isinstance(frames, RGBDSource):
        raise TypeError(
            f"frames: expected frames as returned by loom.open_dataset() or frames_from(), got {shown(frames)}"
        )
    if check_name("method", method) not in METHODS:
        raise ValueError(f"method: expected one of {', '.join(METHODS)}, got {method!r}")
    if size is not None:
        because = "the texture and its intermediate arrays would not fit into memory. Use fewer texels"
        check_count("size", size, maximum=MAX_TEXELS, because=because)
        if not len(mesh):
            raise ValueError("mesh: expected triangles to texture, got none")


def _read_frames(
    frames: RGBDSource, poses: ArrayLike | None, depth_max: float, device: Device, report: ReportProgress
) -> tuple[list[RGBDImage], Trajectory]:
    given = None if poses is None else check_list("poses", getattr(poses, "poses", poses), "poses")
    count = len(frames) if hasattr(frames, "__len__") else 0  # pyright: ignore[reportArgumentType]
    images, path = [], []
    report("frames", 0, count)
    for i, frame in enumerate(frames):
        if frame.color is None:
            raise ValueError(f"frames: {frame.name} has no color to texture the mesh with")
        path.append(_pose_of(frame, i, given))
        scale = {"depth_scale": depth_unit(frames, frame), "depth_trunc": depth_max}
        images.append(RGBDImage(frame.color, frame.depth, **scale, device=device))
        report("frames", i + 1, count)
    if not images:
        raise ValueError("frames: expected at least one frame, got none")
    if given is not None and len(given) != len(images):
        raise ValueError(f"poses: expected {len(images)}, one per frame, got {len(given)}")
    return images, Trajectory(np.array(path))


def _pose_of(frame: Frame, index: int, given: list[Any] | None) -> Any:
    if given is not None:
        if index >= len(given):
            raise ValueError(f"poses: expected one per frame, got {len(given)} for more frames")
        return check_rigid(f"poses[{index}]", given[index])
    if frame.T_world_camera is None:
        raise ValueError(f"frames: {frame.name} has no pose. Pass poses, for example from loom.read_trajectory()")
    return frame.T_world_camera


def _color(
    mesh: TriangleMesh,
    images: list[RGBDImage],
    path: Trajectory,
    camera: PinholeCameraIntrinsic,
    method: str,
    depth_max: float,
    kept: KeptArrays,
) -> ColorMapResult:
    numbers: dict[str, Any] = {
        "maximum_allowable_depth": depth_max,
        "depth_threshold_for_discontinuity_check": MIN_DEPTH_STEP,
        "half_dilation_kernel_size_for_discontinuity_map": STEP_MARGIN,
    }
    iterations = 0 if method == "none" else RIGID_ITERATIONS
    option = ColorMapOption(maximum_iteration=iterations, **numbers)
    rigid = color_mesh(mesh, images, path, option, camera, "rigid", kept=kept)
    if method != "non-rigid":
        return rigid
    option = ColorMapOption(maximum_iteration=NON_RIGID_ITERATIONS, **numbers)
    non_rigid = color_mesh(mesh, images, rigid.trajectory, option, camera, method, kept=kept)
    iterations = rigid.iterations + non_rigid.iterations
    return dataclasses.replace(non_rigid, residual_before=rigid.residual_before, iterations=iterations)


def _paint_atlas(
    colors: ColorMapResult, camera: PinholeCameraIntrinsic, size: int, kept: KeptArrays
) -> tuple[TriangleMesh, float]:
    """Mesh with a texture from the optimized images, and the fraction of it that they see."""
    mesh = colors.mesh
    if mesh.triangle_uvs is None:
        seconds = SECONDS_OF_ATLAS * (len(mesh) / TRIANGLES_OF_ATLAS) ** ATLAS_EXPONENT
        kept.report(f"atlas: {len(mesh):,} triangles, about {format_duration(seconds)}", 0, 0)

        def lay_out() -> Arrays:
            atlas = mesh.compute_uvatlas(size, gutter=GUTTER_TEXELS)
            return {"triangle_uvs": download(atlas.arrays["triangle_uvs"])}

        def read(path: Path) -> Arrays:
            expected = {"triangle_uvs": (np.float32, (3 * len(mesh), 2))}
            return read_part_of_job(path, "the atlas", lambda _: expected, _fault_of_atlas, "It is computed again")

        uvs = kept.get("atlas", lay_out, read)["triangle_uvs"]
        without = mesh.with_arrays(triangle_material_ids=None)
        mesh = without.with_arrays(triangle_uvs=upload(uvs, vec2, mesh.device))
    kept.report("texture", 0, 0)
    images = [colors.unwarped_image(i) for i in range(len(colors.view_counts))]
    extrinsics = [inv(pose) for pose in colors.trajectory.poses]
    textured, fraction = with_albedo(mesh, images, camera, extrinsics, size)
    return textured.with_arrays(vertex_colors=None), fraction  # viewers multiply texture and vertex colors


def _fault_of_atlas(arrays: Arrays) -> str:
    uvs = arrays["triangle_uvs"]
    return "" if ((uvs >= 0) & (uvs <= 1)).all() else "triangle_uvs: expected numbers in 0..1"
