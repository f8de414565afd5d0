"""The colours of posed frames onto a mesh of the same place: `texture_folder`."""

from __future__ import annotations

import dataclasses
import os
from pathlib import Path
from typing import Any

import numpy as np

from ..meshing.color_map.optimizers import run_non_rigid_optimizer, run_rigid_optimizer
from ..meshing.color_map.options import NonRigidOptimizerOption, RigidOptimizerOption
from ..meshing.color_map.results import ColorMapResult, NothingSeenError
from ..meshing.mesh import TriangleMesh
from ..meshing.mesh_files import read_triangle_mesh, write_triangle_mesh
from ..pcd.camera import read_pinhole_camera_intrinsic
from ..pcd.checks import check_count, check_positive
from ..pcd.devices import resolve_device
from ..pcd.errors import FileError
from ..pcd.images import RGBDImage
from ..pcd.io.datasets import RGBDDataset, open_dataset
from ..pcd.io.trajectory import Trajectory
from .console import Clock, ReportProgress, format_bytes, format_seconds, format_share, peak_bytes, say_nothing
from .pictures.picture_files import check_picture
from .pictures.scene_view import draw_scene
from .tables import check_output

FilePath = str | os.PathLike[str]

METHODS = ("rigid", "non-rigid", "none")
WITH_ATLAS = (".obj", ".glb")
WRITTEN = (".ply", *WITH_ATLAS)
SIZE = 2048  # texels a side: 3 mm each on the walls of a room
DEPTH_MAX = 4.0  # [m] beyond it the noise of depth cameras passes the 3 cm by which depths may differ
TURNS = 100  # of the search at most; it ends by itself before where little is left to win
BENDING_TURNS = 30  # of the search for bent pictures, which begins where the other ended
GUTTER = 4  # texels between charts of an atlas: two levels of a mipmap
JUMP = 0.4  # [m] Sobel's sum at a step of 5 cm: floors seen at a low angle, and noise, make smaller ones
BESIDE = 2  # pixels beside such a step that show nothing

# What makes a result poor.
FEW_SEEN = 0.3  # share of the vertices that some picture shows
BLIND = 0.5  # share of the frames that show nothing of the mesh
WON = 0.99  # of the residual that is left at most where there was something to win,
AGREED = 0.01  # and below which there was not: what 8-bit colours and their noise leave


def texture_folder(
    mesh: FilePath,
    folder: FilePath,
    output: FilePath,
    *,
    method: str = "rigid",
    size: int = SIZE,
    layout: str = "auto",
    intrinsic: FilePath | None = None,
    every: int = 1,
    depth_max: float = DEPTH_MAX,
    device: Any = "auto",
    picture: FilePath | None = None,
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> dict[str, Any]:
    """Write a mesh with the colours of posed frames; outputs are checked before the work.

    Args:
        mesh: A mesh, in the frame of the poses.
        folder: As `open_dataset` takes it, with `layout` and `every`.
        output: A .ply for a colour at each vertex, an .obj or .glb for a texture.
        method: "rigid" moves the poses so that the pictures agree, "non-rigid" bends the pictures too after that,
            "none" takes them as they are.
        size: Texels a side of the texture.
        layout, every: As `open_dataset`.
        intrinsic: A camera as Open3D's JSON, if it is another than the folder says.
        depth_max: Farther pixels show nothing [m].
        device: Where to compute.
        picture: A .png file for a picture of the mesh, with the colours at its vertices.
        overwrite: Replace outputs that exist.
        progress: Called with the stage, how many of its steps are done, and how many there are.

    Returns:
        What was done, in JSON's types; "poor" says why the result is poor, or is None. Where no frame shows anything of
        the mesh nothing is written.

    Raises:
        FileError: A file that cannot be read, or an output that cannot be written.
        ValueError: An unknown method, frames without colour, a mesh without vertices, or for a texture triangles.
        DeviceError: No such device.
    """
    if method not in METHODS:
        raise ValueError(f"method: expected one of {', '.join(METHODS)}, got {method!r}")
    texels, farthest = check_count("size", size), check_positive("depth_max", depth_max)
    check_output(output, WRITTEN, what="coloured meshes", overwrite=overwrite)
    if picture is not None:
        check_picture(picture, overwrite=overwrite)
    where, clock, say = resolve_device(device), Clock(), progress or say_nothing
    camera = None if intrinsic is None else read_pinhole_camera_intrinsic(intrinsic)
    shape = read_triangle_mesh(mesh, device=where)
    if Path(output).suffix.lower() in WITH_ATLAS and not len(shape):
        raise FileError(mesh, "has no triangles, which a texture needs", remedy="Write a .ply for colours at vertices")
    dataset = open_dataset(folder, layout=layout, intrinsic=camera, every=every)
    images, path = _read_frames(dataset, farthest, where, say)
    clock.stop("read")
    say("colours", 0, 0)
    report = {"command": "texture", "mesh": os.fspath(mesh), "dataset": os.fspath(folder), "layout": dataset.layout}
    report |= {"device": str(where), "method": method, "frames": len(path), "depth_max": farthest}
    report |= {"vertices": len(shape.array("vertices")), "triangles": len(shape)}
    try:
        result = _color(shape, images, path, dataset, method, farthest)
    except NothingSeenError:
        poor = "no frame shows anything of the mesh, and nothing was written; are both in one frame of coordinates?"
        clock.stop("colours")
        return report | {"seconds": clock.seconds, "peak_bytes": peak_bytes(), "files": [], "poor": poor}
    clock.stop("colours")
    report |= describe_colors(result, path)
    colored, share = result.mesh, None
    if Path(output).suffix.lower() in WITH_ATLAS:
        say("texture", 0, 0)
        colored, share = _paint_atlas(result, dataset, texels)
        clock.stop("texture")
    report |= {"size": texels if share is not None else None, "texel_share": share}
    files = [os.fspath(output)]
    write_triangle_mesh(output, colored, overwrite=overwrite)
    if picture is not None:
        draw_scene(picture, result.mesh, result.trajectory.poses, overwrite=overwrite)
        files.append(os.fspath(picture))
    clock.stop("write")
    report |= {"seconds": clock.seconds, "peak_bytes": peak_bytes(), "files": files}
    return report | {"poor": _why_poor(report, method)}


def describe_colors(result: ColorMapResult, given: Trajectory) -> dict[str, Any]:
    """The figures of a colour map, in JSON's types."""
    T = np.linalg.inv(given.poses) @ result.trajectory.poses
    cosines = (np.trace(T[:, :3, :3], axis1=1, axis2=2) - 1) / 2
    return {
        "seen_share": float(result.seen.mean()),
        "blind_frames": int((result.view_counts == 0).sum()),
        "residual_before": result.residual_before,
        "residual": result.residual,
        "turns": result.iterations,
        "turned": float(np.degrees(np.arccos(np.clip(cosines, -1, 1))).mean()),
        "moved": float(np.linalg.norm(T[:, :3, 3], axis=1).mean()),
    }


def texture_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    fields = [
        ("mesh", f"{report['vertices']:,} vertices, {report['triangles']:,} triangles"),
        ("frames", f"{report['frames']} up to {report['depth_max']:g} m, on {report['device']}"),
    ]
    if "seen_share" in report:
        blind = report["blind_frames"]
        fields += [
            (
                "seen",
                f"{format_share(report['seen_share'])} of the vertices" + (f"; {blind} frames blind" * bool(blind)),
            ),
            ("method", f"{report['method']}, {report['turns']} turns"),
            ("residual", f"{report['residual_before']:.4f} to {report['residual']:.4f} of full brightness"),
            ("poses", f"turned {report['turned']:.3f} deg, moved {report['moved'] * 1000:.1f} mm in the mean"),
        ]
        if report["size"] is not None:
            fields.append(
                ("texture", f"{report['size']} x {report['size']}, {format_share(report['texel_share'])} seen")
            )
    return [
        *fields,
        ("seconds", format_seconds(report["seconds"])),
        ("memory", f"{format_bytes(report['peak_bytes'])} at most"),
        ("files", ", ".join(report["files"]) or "none"),
    ]


# ------------------------------------------------------------------------------------------------ internals


def _read_frames(
    dataset: RGBDDataset, depth_max: float, device: Any, say: ReportProgress
) -> tuple[list[RGBDImage], Trajectory]:
    images, poses, count = [], [], len(dataset)
    say("frames", 0, count)
    for i in range(count):
        frame = dataset.read(i)
        if frame.color is None:
            raise FileError(dataset.folder, "its frames have no colour, which is what a mesh would take from them")
        scale = {"depth_scale": dataset.depth_scale, "depth_trunc": depth_max}
        images.append(RGBDImage(frame.color, frame.depth, **scale, device=device))
        poses.append(frame.T_world_camera)
        say("frames", i + 1, count)
    return images, Trajectory(np.array(poses).reshape(-1, 4, 4))


def _color(
    mesh: TriangleMesh, images: list[RGBDImage], path: Trajectory, dataset: RGBDDataset, method: str, depth_max: float
) -> ColorMapResult:
    numbers: dict[str, Any] = {
        "maximum_allowable_depth": depth_max,
        "depth_threshold_for_discontinuity_check": JUMP,
        "half_dilation_kernel_size_for_discontinuity_map": BESIDE,
    }
    turns, camera = 0 if method == "none" else TURNS, dataset.intrinsic
    rigid = run_rigid_optimizer(
        mesh, images, path, RigidOptimizerOption(maximum_iteration=turns, **numbers), intrinsic=camera
    )
    if method != "non-rigid":
        return rigid
    option = NonRigidOptimizerOption(maximum_iteration=BENDING_TURNS, **numbers)
    bent = run_non_rigid_optimizer(mesh, images, rigid.trajectory, option, intrinsic=camera)
    turns = rigid.iterations + bent.iterations
    return dataclasses.replace(bent, residual_before=rigid.residual_before, iterations=turns)


def _paint_atlas(result: ColorMapResult, dataset: RGBDDataset, size: int) -> tuple[TriangleMesh, float]:
    """The mesh with a texture of the pictures as the colour map has them, and the share of it that they show."""
    mesh = result.mesh
    if mesh.triangle_uvs is None:
        mesh = mesh.compute_uvatlas(size, gutter=GUTTER)
    pictures = [result.unwarped_image(i) for i in range(len(result.view_counts))]
    extrinsics = [np.linalg.inv(pose) for pose in result.trajectory.poses]
    textured, share = mesh._with_albedo(pictures, dataset.intrinsic, extrinsics, size)
    return textured._with(vertex_colors=None), share  # viewers multiply them with the texture


def _why_poor(report: dict[str, Any], method: str) -> str | None:
    reasons = []
    if report["seen_share"] < FEW_SEEN:
        reasons.append(
            f"the frames show only {format_share(report['seen_share'])} of the vertices: take more of them (a smaller "
            "--every), raise --depth-max, or check that mesh and poses belong together"
        )
    if report["blind_frames"] > BLIND * report["frames"]:
        reasons.append(f"{report['blind_frames']} of {report['frames']} frames show nothing of the mesh")
    before, after = report["residual_before"], report["residual"]
    if method != "none" and before > AGREED and after > WON * before:
        reasons.append(
            f"the pictures agree no better than before (residual {before:.4f} to {after:.4f}): the poses are too far "
            "off, or the colours change with the light; compare with --method none"
        )
    return "; ".join(reasons) or None
