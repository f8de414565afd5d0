"""Pictures to clouds: `depth_of_pictures`, for one picture or all of a folder, with one session of the network."""

from __future__ import annotations

import math
import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...pcd.camera import PinholeCameraIntrinsic, read_pinhole_camera_intrinsic
from ...pcd.devices import resolve_device
from ...pcd.errors import FileError
from ...pcd.io.atomic import atomic_write, check_writable
from ...pcd.io.colmap import read_colmap_model
from ...pcd.io.formats import WRITTEN
from ...pcd.io.ply import write_ply
from ...pcd.io.point_cloud import table_of, write_point_cloud
from ..console import Clock, ReportProgress, peak_bytes, say_nothing
from ..pictures.picture_files import check_picture, save_picture
from ..pictures.render import render
from ..pictures.view import View
from ..tables import check_output
from .alignment import AlignmentError
from .estimation import ARBITRARY, DepthEstimate, estimate_depth
from .network import DepthModel
from .photos import SUFFIXES
from .presets import DEFAULT, PRESETS

FilePath = str | os.PathLike[str]

REFERENCES = (".npy", ".png", ".txt", ".csv")  # of a picture of the same name
FEW_INLIERS = 0.3  # share of the references below which the map, or the references, are not to be believed
FEW_POINTS = 0.2  # share of the pixels
SHOWN_SIDE = 1280  # [px] of the longer side of the picture of a cloud
ASIDE = math.radians(14), math.radians(9)  # from where the cloud is drawn: to the right of the camera, and above it


def depth_of_pictures(
    source: FilePath,
    model: FilePath,
    output: FilePath,
    *,
    preset: str = DEFAULT,
    intrinsic: FilePath | None = None,
    align: FilePath | None = None,
    depth_scale: float = 1000.0,
    tiles: int = 1,
    keep_edges: bool = False,
    depth_map: FilePath | None = None,
    picture: FilePath | None = None,
    device: Any = "auto",
    seed: int = 0,
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> dict[str, Any]:
    """Estimate the depth of a picture, or of all in a folder, and write clouds; outputs are checked before the work.

    Args:
        source: A PNG or JPEG file, or a folder of such.
        model: The .onnx file.
        output: A cloud; of a folder, a folder for clouds NAME.ply, which is made.
        preset, depth_scale, tiles, seed, device: As `estimate_depth`.
        intrinsic: A camera as Open3D's JSON, of all pictures.
        align: As `estimate_depth`, by path; of a folder also a folder of such files with the pictures' names.
        keep_edges: As `to_point_cloud`.
        depth_map: A .npy file for the depth, float32 [h, w]; not of a folder.
        picture: A .png file for a picture of the cloud; not of a folder.
        overwrite: Replace outputs that exist.
        progress: Called with the stage, how many of its steps are done, and how many there are.

    Returns:
        What was done, in JSON's types; "poor" says why the result is poor, or is None. Where the references and the map
        do not agree nothing is written for that picture.

    Raises:
        FileError: A file that cannot be read, an output that cannot be written, a model that is none.
        ValueError, DeviceError: As `estimate_depth`.
    """
    say, clock = progress or say_nothing, Clock()
    folder = Path(source) if Path(source).is_dir() else None
    jobs = _jobs(Path(source), Path(output), folder, overwrite)
    extras = _check_extras(folder, depth_map, picture, overwrite)
    where = resolve_device(device)
    camera = None if intrinsic is None else read_pinhole_camera_intrinsic(intrinsic)
    network = DepthModel(model, preset, device=device)
    clock.stop("open")
    options = {"intrinsic": camera, "depth_scale": depth_scale, "tiles": tiles, "seed": seed}
    references = _AlignTo(align, jobs, is_folder=folder is not None)
    pictures, failures = [], []
    first: Exception | None = None
    for done, (path, target) in enumerate(jobs):
        if folder is not None:
            say("pictures", done, len(jobs))
        try:
            found = estimate_depth(path, network, align=references(path), progress=say, **options)
            clock.stop("depth")
            written = _write(found, target, extras, where, keep_edges, overwrite, clock)
            pictures.append(_describe(found) | written | {"picture": os.fspath(path)})
        except AlignmentError as error:
            clock.stop("depth")
            failures.append({"picture": os.fspath(path), "reason": str(error), "refused": True})
        except (FileError, ValueError) as error:
            if folder is None:
                raise
            failures.append({"picture": os.fspath(path), "reason": str(error), "refused": False})
            first = first or error
    if first is not None and len(pictures) == 0 and not any(failure["refused"] for failure in failures):
        raise first
    if folder is not None:
        say("pictures", len(jobs), len(jobs))
    report = {"command": "depth", "source": os.fspath(source), "model": network.path, "preset": network.preset}
    report |= {"licence": PRESETS[network.preset].licence, "provider": network.provider, "device": str(where)}
    report |= {"pictures": pictures, "failures": failures, "seconds": clock.seconds, "peak_bytes": peak_bytes()}
    report |= {"files": [file for each in pictures for file in each["files"]]}
    return report | {"poor": why_poor(pictures, failures, is_folder=folder is not None)}


def _jobs(source: Path, output: Path, folder: Path | None, overwrite: bool) -> list[tuple[Path, Path]]:
    """Each picture and the cloud that it becomes, once all can be written."""
    if folder is None:
        check_output(output, WRITTEN, what="clouds", overwrite=overwrite)
        return [(source, output)]
    pictures = sorted(path for path in folder.iterdir() if path.suffix.lower() in SUFFIXES and path.is_file())
    if not pictures:
        raise FileError(folder, f"holds no pictures ({' '.join(SUFFIXES)})", remedy="Give another folder")
    if output.suffix.lower() in WRITTEN:
        raise FileError(output, "is one cloud, for a folder of pictures", remedy="Give the name of a folder")
    jobs = [(path, output / f"{path.stem}.ply") for path in pictures]
    names = [target.name for _, target in jobs]
    for (path, target), name in zip(jobs, names, strict=True):
        if names.count(name) > 1:
            raise FileError(path, f"another picture would become {target.name} too", remedy="Rename one of them")
    try:
        output.mkdir(exist_ok=True)
    except OSError as error:
        raise FileError(output, f"cannot be made: {error.strerror or error}", remedy="Make its parent first") from error
    for _, target in jobs:
        check_writable(target, overwrite=overwrite)
    return jobs


def _check_extras(
    folder: Path | None, depth_map: FilePath | None, picture: FilePath | None, overwrite: bool
) -> dict[str, FilePath | None]:
    for name, path in (("--depth-map", depth_map), ("--picture", picture)):
        if folder is not None and path is not None:
            raise FileError(path, f"{name} is for one picture", remedy="Give one picture in place of the folder")
    if picture is not None:
        check_picture(picture, overwrite=overwrite)
    if depth_map is not None:
        if Path(depth_map).suffix.lower() != ".npy":
            raise FileError(depth_map, "depth maps are written as .npy", remedy="Give a name that ends in .npy")
        check_writable(depth_map, overwrite=overwrite)
    return {"depth_map": depth_map, "picture": picture}


class _AlignTo:
    """What each picture is aligned to.

    For one picture that is what the user named. Of a folder of pictures it may be a folder too: of files by the
    pictures' names, or else a COLMAP model, which is read once.
    """

    def __init__(self, align: FilePath | None, jobs: list[tuple[Path, Path]], *, is_folder: bool):
        self._same: Any = align
        self._folder = Path(align) if align is not None and is_folder and Path(align).is_dir() else None
        if self._folder is not None and not any(self._own(picture) for picture, _ in jobs):
            self._same, self._folder = read_colmap_model(self._folder), None

    def __call__(self, picture: Path) -> Any:
        """The references of a picture.

        Raises:
            FileError: Others have a file of their own, this one has none.
        """
        if self._folder is None:
            return self._same
        if own := self._own(picture):
            return own
        names = " or ".join(picture.stem + suffix for suffix in REFERENCES)
        raise FileError(self._folder, f"holds no {names}", remedy="Each picture wants its own")

    def _own(self, picture: Path) -> Path | None:
        assert self._folder is not None
        paths = (self._folder / f"{picture.stem}{suffix}" for suffix in REFERENCES)
        return next((path for path in paths if path.exists()), None)


def _write(
    found: DepthEstimate,
    target: Path,
    extras: dict[str, FilePath | None],
    device: Any,
    keep_edges: bool,
    overwrite: bool,
    clock: Clock,
) -> dict[str, Any]:
    """Write what a picture becomes; gives the counts and the files."""
    cloud = found.to_point_cloud(keep_edges=keep_edges, device=device)
    clock.stop("cloud")
    files = []
    if len(cloud):
        if target.suffix.lower() == ".ply":
            write_ply(target, table_of(cloud), overwrite=overwrite, comments=[_unit_comment(found)])
        else:
            write_point_cloud(target, cloud, overwrite=overwrite)
        files.append(os.fspath(target))
    if (path := extras["depth_map"]) is not None:
        with atomic_write(path, overwrite=overwrite) as file:
            np.save(file, found.depth)
        files.append(os.fspath(path))
    clock.stop("write")
    if (path := extras["picture"]) is not None and len(cloud):
        image = render(cloud, view_aside(found.intrinsic, float(np.median(found.depth[found.depth > 0]))))
        save_picture(path, image, overwrite=overwrite)
        files.append(os.fspath(path))
        clock.stop("picture")
    pixels = found.depth.size
    seen = int((found.depth > 0).sum())
    return {"points": len(cloud), "depth_share": seen / pixels, "kept_share": len(cloud) / pixels, "files": files}


def _unit_comment(found: DepthEstimate) -> str:
    """The line of a PLY file that says what its numbers mean."""
    if found.unit == ARBITRARY:
        return "pointloom depth: units arbitrary, the nearest point at depth 1; align to get metres"
    if found.unit == "m":
        return "pointloom depth: metres"
    return "pointloom depth: in the unit of the sparse model"


def view_aside(intrinsic: PinholeCameraIntrinsic, distance: float) -> View:
    """The picture's own view from a little to the right and above, turned about what lies at this distance."""
    camera = intrinsic.scaled(min(1.0, SHOWN_SIDE / max(intrinsic.width, intrinsic.height)))
    yaw, pitch = ASIDE
    back = _turn(1, -yaw) @ _turn(0, -pitch)
    T_world_camera = np.eye(4)
    T_world_camera[:3, :3] = back
    T_world_camera[:3, 3] = np.array([0, 0, distance]) - back @ np.array([0, 0, 1.1 * distance])
    return View(camera, T_world_camera)


def _turn(axis: int, angle: float) -> NDArray[np.float64]:
    """The rotation about x (0) or y (1)."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]] if axis == 0 else [[c, 0, s], [0, 1, 0], [-s, 0, c]])


def _describe(found: DepthEstimate) -> dict[str, Any]:
    """The figures of an estimate, in JSON's types."""
    height, width = found.depth.shape
    rows, columns = found.input_size
    camera = found.intrinsic
    seen = found.depth[found.depth > 0]
    return {
        "width": width,
        "height": height,
        "input": {"width": columns, "height": rows},
        "unit": found.unit,
        "is_metric": found.is_metric,
        "scale": found.scale,
        "shift": found.shift,
        "references": found.references,
        "inlier_share": found.inlier_share,
        "tiles": None if found.tiles is None else {"used": found.tiles[0], "count": found.tiles[1]},
        "nearest": float(seen.min()) if len(seen) else None,
        "farthest": float(seen.max()) if len(seen) else None,
        "camera": {
            "fx": camera.fx,
            "fy": camera.fy,
            "cx": camera.cx,
            "cy": camera.cy,
            "width": camera.width,
            "height": camera.height,
            "source": found.intrinsic_source,
        },
    }


def why_poor(pictures: list[dict[str, Any]], failures: list[dict[str, Any]], *, is_folder: bool) -> str | None:
    """What is wrong with the result, or None."""
    reasons = []
    if failures:
        first = failures[0]["reason"]
        many = f"{len(failures)} of {len(failures) + len(pictures)} pictures became nothing: "
        reasons.append(f"{many if is_folder else ''}{first}; nothing was written{' for them' if is_folder else ''}")
    for each in pictures:
        name = f"{Path(each['picture']).name}: " if is_folder else ""
        share = each["inlier_share"]
        if share is not None and share < FEW_INLIERS:
            reasons.append(
                f"{name}only {share:.0%} of the {each['references']} references agree with the map within 10 %: check "
                "that they are of this picture, and that the preset is the model's"
            )
        if each["kept_share"] < FEW_POINTS:
            reasons.append(f"{name}only {each['kept_share']:.1%} of the pixels became points; keep edges, or align")
    return "; ".join(reasons) or None
