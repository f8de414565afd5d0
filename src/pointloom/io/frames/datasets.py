"""Folders of RGB-D frames with or without poses: 7-Scenes, Redwood / Open3D, TUM, or pairs such as 1.png, 1_depth.png.

Opening a folder checks pairs, poses and image sizes without decoding an image (about 0.05 ms a file).
"""

from __future__ import annotations

import dataclasses
import os
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic, check_camera, read_pinhole_camera_intrinsic
from ...cameras.frame_check import why_implausible
from ...cameras.pose_text import parse_floats, pose_or_gap, read_lines, read_pose_or_gap, timed_poses
from ...core.atomic import restore_folder
from ...core.checks import check_count, check_name, check_positive, shown
from ...core.errors import DatasetError, FileError, FilePath
from ...core.escaped_text import escaped
from ...core.json_files import read_json_object
from ...core.paths import is_file, path_of, recording_remedy
from ...core.reports import Assessed, failed
from ..images.image_files import (
    ImageHeader,
    check_color_header,
    check_depth_header,
    read_color,
    read_depth,
    read_image_header,
    resize_color,
)
from ..images.image_formats import IMAGES
from .dataset_layouts import Demand, FrameFiles, list_redwood, list_seven_scenes, list_tum
from .frame_times import TimeWatch

_DEPTH_WORD = re.compile(r"(?<![a-z])(?:depth|dep)(?![a-z])", re.I)
_COLOR_WORD = re.compile(r"(?<![a-z])(?:colou?r|rgb|image|img)(?![a-z])", re.I)
_POSE_WORD = re.compile(r"(?<![a-z])pose(?![a-z])", re.I)


def contains_images(folder: Path) -> bool:
    """True if a PNG in the folder has a name of a depth map."""
    names = [path.name for path in folder.iterdir() if path.is_file()]
    return any(n.lower().endswith(".png") and _DEPTH_WORD.search(Path(n).stem) for n in names if n[0] != ".")


def list_images(folder: Path, demand: Demand) -> list[FrameFiles]:
    depths: dict[str, Path] = {}
    colors: dict[str, Path] = {}
    poses: dict[str, Path] = {}
    for path in sorted(folder.iterdir()):
        kind = path.suffix.lower()
        if path.name.startswith(".") or not path.is_file():
            continue
        if kind == ".png" and _DEPTH_WORD.search(path.stem):
            _add(depths, _without(_DEPTH_WORD, path), path)
        elif kind in IMAGES:
            _add(colors, _without(_COLOR_WORD, path), path)
        elif kind == ".txt" and _POSE_WORD.search(path.stem):
            _add(poses, _without(_POSE_WORD, path), path)
    if not depths:
        raise DatasetError(folder, "contains no PNG with depth in its name", remedy="Give the folder of the frames")
    for key, path in colors.items():
        if key not in depths:
            demand.miss(path, "has no depth map of the same name", "Use matching names, such as 1.png and 1_depth.png")
    frames = []
    for key in sorted(depths, key=lambda key: ([int(n) for n in re.findall(r"\d+", key)], key)):
        if colors and key not in colors:
            demand.miss(depths[key], "has no color image of the same name", "Restore it, or remove this")
            continue
        pose = poses.get(key) if demand.poses != "ignored" else None
        if pose is None and demand.poses == "needed":
            demand.miss(depths[key], "has no pose of the same name", "Restore it, or remove this")
            continue
        T_world_camera = None if pose is None else _read_any_pose(pose)
        if pose is not None and T_world_camera is None and demand.loses(pose):
            continue
        frames.append(FrameFiles(key or depths[key].stem, depths[key], colors.get(key), T_world_camera))
    return frames


def _add(there: dict[str, Path], key: str, path: Path) -> None:
    if there.setdefault(key, path) != path:
        raise DatasetError(path, f"belongs to the same frame as {there[key].name}", remedy="Keep one of the two")


def _without(word: re.Pattern[str], path: Path) -> str:
    """The name of the frame: the file name without the word and its separator."""
    return re.sub(r"[-_. ]+", "_", word.sub("", path.stem)).strip("_")


def _read_any_pose(path: Path) -> NDArray[np.float64] | None:
    """Four rows of a matrix, or `tx ty tz qx qy qz qw` (a TUM line without time). None if the pose is not finite."""
    lines = read_lines(path)
    if len(lines) != 1:
        return read_pose_or_gap(path)
    return pose_or_gap(timed_poses(path, [(lines[0][0], ["0", *lines[0][1]])], gaps=True)[0][0])


# File names of a camera. Open3D's recorders write the last two.
INTRINSIC_NAMES = ("camera-intrinsics.json", "camera.json", "camera_intrinsic.json", "intrinsic.json")

# A 3x3 matrix in text: 7-Scenes and 3DMatch have the first.
MATRIX_NAMES = ("camera-intrinsics.txt", "intrinsics.K.txt", "intrinsics.txt", "K.txt")

# Patterns of other names that may contain a camera.
_LIKE_A_CAMERA = re.compile(r"(.*intrinsic.*|.*calib.*|.*camera.*|.*\bK)\.(txt|json|ya?ml|xml)", re.I)


@dataclasses.dataclass(frozen=True)
class FoundCamera:
    """A camera, its source, the depth scale stored with it and a reason why it may belong to other images."""

    intrinsic: PinholeCameraIntrinsic
    source: str
    depth_scale: float
    warning: str = ""


def find_camera(folder: Path, layout: str, size: tuple[int, int], depth_scale: float) -> FoundCamera:
    """The camera of a folder: a JSON file, a matrix (also above a folder seq-NN), or the default of the layout."""
    present = [folder / name for name in INTRINSIC_NAMES if (folder / name).is_file()]
    if len(present) > 1:
        raise DatasetError(present[1], f"duplicates {present[0].name}", remedy="Keep one, or give intrinsic=")
    if present:
        scale = _read_depth_scale(present[0], depth_scale)
        return with_warning(FoundCamera(read_pinhole_camera_intrinsic(present[0]), present[0].name, scale))
    for searched in [folder] + ([folder.parent] if re.fullmatch(r"seq-\d+", folder.name) else []):
        matrices = {path: _read_matrix(path) for name in MATRIX_NAMES if (path := searched / name).is_file()}
        if not matrices:
            continue
        path, K = next(iter(matrices.items()))
        other = next((p for p, matrix in matrices.items() if not np.array_equal(matrix, K)), None)
        if other is not None:
            reason = f"contradicts {path.name} beside it"
            raise DatasetError(other, reason, remedy="Keep one, or give intrinsic=")
        try:
            return with_warning(FoundCamera(PinholeCameraIntrinsic.from_matrix(K, *size), str(path), depth_scale))
        except ValueError as error:
            raise FileError(path, str(error)) from error
    if layout == "images":
        remedy = "Give intrinsic=, or put a camera-intrinsics.json beside them"
        raise DatasetError(folder, "the camera of its images is unknown", remedy=remedy)
    intrinsic, source = PinholeCameraIntrinsic.prime_sense_default(), f"the default of {layout}"
    if layout == "7scenes":
        intrinsic, source = PinholeCameraIntrinsic(640, 480, 585.0, 585.0, 320.0, 240.0), "the default of 7-Scenes"
    unread = sorted(path.name for path in folder.iterdir() if _LIKE_A_CAMERA.fullmatch(path.name) and path.is_file())
    warning = "the folder contains no camera file, so it is assumed; pass intrinsic=, or add a camera-intrinsics.json"
    if unread:
        warning = f"it is assumed: {unread[0]} is beside the frames, but was not read; pass it as intrinsic="
    return FoundCamera(intrinsic, source, depth_scale, warning)


def with_warning(source: FoundCamera) -> FoundCamera:
    """Add a warning to the camera if it may not belong to these images."""
    return dataclasses.replace(source, warning=reason) if (reason := why_implausible(source.intrinsic)) else source


def _read_matrix(path: Path) -> NDArray[np.float64]:
    lines = read_lines(path)
    if len(lines) != 3:
        raise FileError(path, f"expected 3 rows of a matrix, got {len(lines)}")
    return np.array([parse_floats(path, line, 3) for line in lines])


def _read_depth_scale(path: Path, default: float) -> float:
    """The depth scale that Open3D's RealSense recorder stores with the camera, or the default."""
    content = read_json_object(path)
    if "depth_scale" not in content:
        return default
    try:
        return check_positive("depth_scale", content["depth_scale"])
    except (TypeError, ValueError) as error:
        raise FileError(path, str(error), where="key depth_scale") from error


LAYOUTS = ("7scenes", "redwood", "tum")
REQUIRED = "required"  # value of `poses`

# Depth units per meter. TUM stores fifths of a millimeter, the others millimeters.
_DEPTH_SCALES = {"7scenes": 1000.0, "redwood": 1000.0, "tum": 5000.0}

# 7-Scenes marks pixels without measurement with the largest value, 65.5 m.
_SEVEN_SCENES_INVALID = 65535


@dataclasses.dataclass(frozen=True, eq=False)
class Frame:
    """A frame in memory.

    Args:
        depth: Shape (h, w): uint16 meters times the source's `depth_scale`, or float32 [m]. 0 without measurement.
        color: Shape (h, w, 3), uint8 RGB, or None.
        T_world_camera: Ground truth pose, camera to world, shape (4, 4) [m], or None.
        name: Name of the frame within its source.
        timestamp: Time of capture [s], or None.
    """

    depth: NDArray[np.uint16] | NDArray[np.float32]
    color: NDArray[np.uint8] | None
    T_world_camera: NDArray[np.float64] | None
    name: str
    timestamp: float | None = None


@dataclasses.dataclass(frozen=True, eq=False)
class RGBDDataset(Assessed):
    """RGB-D frames in a folder, checked by `open_dataset` or `open_frames` and decoded one at a time.

    Args:
        folder: The folder.
        layout: "7scenes", "redwood", "tum" or "images".
        intrinsic: The camera of depth and color, which are registered to each other.
        depth_scale: Depth units per meter.
        frames: The files, in order of capture.
        left_out: Skipped files with the reason: unpaired TUM files and, with `skip_missing`, incomplete frames.
        intrinsic_source: Source of the camera.
        warnings: Why the camera may be wrong: assumed, since no file contains it, or that of other images. Empty if no
            check failed.
        resize_color: Resize color to the size of depth.
        pairing: Number of frames that were paired by time, and of possible ones. Empty for other layouts.
    """

    folder: Path
    layout: str
    intrinsic: PinholeCameraIntrinsic
    depth_scale: float
    frames: list[FrameFiles]
    left_out: list[str] = dataclasses.field(default_factory=list)
    intrinsic_source: str = ""
    warnings: tuple[str, ...] = ()
    resize_color: bool = False
    pairing: tuple[int, ...] = ()

    def __len__(self) -> int:
        return len(self.frames)

    def __iter__(self) -> Iterator[Frame]:
        return (self.read(i) for i in range(len(self)))

    def __repr__(self) -> str:
        posed = sum(files.T_world_camera is not None for files in self.frames)
        poses = "with poses" if posed == len(self) else f"{posed} of them with poses" if posed else "without poses"
        size = f"{self.intrinsic.width} x {self.intrinsic.height}"
        text = f"RGBDDataset({self.layout}, {len(self)} frames {poses}, {size}, depth_scale {self.depth_scale:g})"
        return escaped(text)

    @property
    def notes(self) -> list[str]:
        """Timestamps that repeat, decrease or jump, each with its frame."""
        watch = TimeWatch()
        for files in self.frames:
            watch.see(files.name, files.timestamp)
        return watch.notes

    def read(self, index: int) -> Frame:
        """Decode a frame. A negative index counts from the end. The 65535 of 7-Scenes (no depth) becomes 0."""
        files = self.frames[index]
        depth = read_depth(files.depth)
        color = None if files.color is None else read_color(files.color)
        size = (self.intrinsic.height, self.intrinsic.width)
        if color is not None and self.resize_color and color.shape[:2] != size:
            color = resize_color(color, size, str(files.color))
        for path, image in ((files.depth, depth), (files.color, color)):
            if image is not None and image.shape[:2] != size:
                raise FileError(str(path), "has changed its size since the folder was opened", remedy="Open it again")
        if depth.dtype != np.uint16:
            raise FileError(files.depth, "is no longer a 16-bit PNG", remedy="Open the folder again")
        if self.layout == "7scenes":
            depth[depth == _SEVEN_SCENES_INVALID] = 0
        return Frame(depth, color, files.T_world_camera, files.name, files.timestamp)


def open_frames(
    folder: FilePath,
    *,
    layout: str = "auto",
    intrinsic: PinholeCameraIntrinsic | ArrayLike | None = None,
    every: int = 1,
    depth_scale: float | None = None,
    poses: bool | str = True,
    skip_missing: bool | str = False,
    resize_color: bool = False,
) -> RGBDDataset:
    """Open a folder of RGB-D frames with or without poses.

    - `7scenes`: `frame-NNNNNN.depth.png`, `.pose.txt` and, for all frames or none, `.color.png` or `.color.jpg`.
      Millimeters; f 585, c (320, 240).
    - `redwood`: `depth/`, `trajectory.log` and optionally one of `color/`, `image/`, `rgb/`. Depth and color are paired
      by equal names, else by the first number in them. The number of poses must equal that of depth maps. Pose ids are
      0..n-1 or the numbers in the names. Millimeters. PrimeSense intrinsic.
    - `tum`: `depth.txt`, `groundtruth.txt` and optionally `rgb.txt`. Depth, color and poses are paired by the closest
      time, less than 0.02 s apart. Poses are not interpolated. Unpaired depth maps are listed in `left_out`. Depth
      times 5,000; f 525, c (319.5, 239.5).
    - `images`: depth and color side by side whose names differ by one word, such as `1.png` and `1_depth.png`, or
      `img_prev.png`, `dep_prev.png` and `pose_prev.txt` (a matrix, or tx ty tz qx qy qz qw). Requires `intrinsic` and
      `depth_scale`.

    The camera is, in this order: `intrinsic`. Camera-intrinsics.json, camera.json, camera_intrinsic.json or
    intrinsic.json in the folder (with `depth_scale`, if any). A 3x3 matrix in camera-intrinsics.txt, intrinsics.K.txt,
    intrinsics.txt or K.txt, in the folder or above a folder `seq-NN`. The default of the layout. `intrinsic_source`
    names the source. `warnings` reports an implausible principal point or field of view, or another camera file.

    Args:
        folder: The folder.
        layout: "7scenes", "redwood", "tum", "images", or "auto" to detect it.
        intrinsic: The camera, or its matrix [3, 3]; overrides that of the folder.
        every: Take every k-th frame, starting with the first.
        depth_scale: Depth units per meter; overrides that of the folder.
        poses: True reads the poses in the folder, if any (`T_world_camera` is None without). "required" raises if a
            frame has none. False ignores them.
        skip_missing: Skip frames that lack an image, or (except in "images") whose pose is inf or NaN, and list them
            in `left_out`.
        resize_color: Resize color to the size of depth. Both must show the same view.

    Raises:
        ValueError: An unknown layout or value of `poses`. A depth scale that is not positive.
        DatasetError: An unknown, ambiguous, empty or incomplete folder. Sizes that differ; `every` below 1.
        FileError: A file that cannot be read, or a pose that is not rigid.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pathlib import Path
        >>> from PIL import Image
        >>> Path("walk").mkdir()
        >>> Image.fromarray(np.full((480, 640), 1000, np.uint16)).save("walk/frame-000000.depth.png")
        >>> frames = loom.open_frames("walk")
        >>> [(frame.name, frame.T_world_camera) for frame in frames]
        [('frame-000000', None)]
    """
    if check_name("layout", layout) not in ("auto", *LAYOUTS, "images"):
        raise ValueError(f"layout: expected 'auto' or one of {(*LAYOUTS, 'images')}, got {layout!r}")
    if isinstance(poses, str) and poses != REQUIRED:
        raise ValueError(f"poses: expected True, False or {REQUIRED!r}, got {shown(poses)}")
    scale = None if depth_scale is None else check_positive("depth_scale", depth_scale)
    folder, every = _check_folder(folder), _check_every(folder, every)
    is_required = poses == REQUIRED
    chosen = layout
    if layout == "auto":
        chosen = _detect_layout(folder, _layout_marks(folder)) if is_required else _detect_loosely(folder)
    kind = "needed" if is_required else "taken" if poses else "ignored"
    demand = Demand(kind, bool(skip_missing), not is_required and skip_missing == "images")
    return _open(folder, chosen, intrinsic, scale, every, demand, bool(resize_color))


def open_dataset(
    folder: FilePath,
    *,
    layout: str = "auto",
    intrinsic: PinholeCameraIntrinsic | ArrayLike | None = None,
    every: int = 1,
    skip_missing: bool = False,
) -> RGBDDataset:
    """Open a folder of posed RGB-D frames: another name of `open_frames` with `poses="required"`.

    Args:
        folder, layout, intrinsic, every: As of `open_frames`.
        skip_missing: Skip frames that lack an image or whose pose is inf or NaN, and list them in `left_out`.

    Raises:
        ValueError, DatasetError, FileError: As of `open_frames`.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pathlib import Path
        >>> from PIL import Image
        >>> Path("scans").mkdir()
        >>> Image.fromarray(np.full((480, 640), 1000, np.uint16)).save("scans/frame-000000.depth.png")
        >>> np.savetxt("scans/frame-000000.pose.txt", np.eye(4))
        >>> frames = loom.open_dataset("scans")
        >>> len(frames), frames.layout, frames.read(0).depth.shape
        (1, '7scenes', (480, 640))
    """
    options = {"layout": layout, "intrinsic": intrinsic, "every": every, "skip_missing": bool(skip_missing)}
    return open_frames(folder, **options, poses=REQUIRED)


def _check_folder(folder: FilePath) -> Path:
    folder = path_of(folder, "folder")
    restore_folder(folder)
    if not folder.is_dir():
        reason = "is not a folder" if folder.exists() else "does not exist"
        remedy = recording_remedy(folder, "frames()") or "Give the folder that contains the frames"
        raise DatasetError(folder, reason, remedy=remedy)
    if not os.access(folder, os.R_OK | os.X_OK):
        raise DatasetError(folder, "may not be read", remedy="Change its permissions")
    return folder


def _check_every(folder: FilePath, every: int) -> int:
    try:
        return check_count("every", every)
    except (TypeError, ValueError) as error:
        raise DatasetError(folder, str(error), remedy="1 takes all frames, 5 every fifth") from error


def _open(
    folder: Path,
    layout: str,
    intrinsic: PinholeCameraIntrinsic | ArrayLike | None,
    depth_scale: float | None,
    every: int,
    demand: Demand,
    resize: bool,
) -> RGBDDataset:
    if layout == "7scenes":
        frames = list_seven_scenes(folder, every, demand)
    elif layout == "redwood":
        frames = list_redwood(folder, demand)[::every]
    elif layout == "tum":
        frames = list_tum(folder, demand)[0][::every]
    else:
        frames = list_images(folder, demand)[::every]
    frames = [frame for frame in frames if _is_complete(frame, demand)]
    size = _check_headers(folder, frames, resize)
    if intrinsic is None:
        camera_source = find_camera(folder, layout, size, _DEPTH_SCALES.get(layout, 0.0))
    else:
        given = check_camera("intrinsic", intrinsic, size)
        camera_source = with_warning(FoundCamera(given, "the intrinsic given", _DEPTH_SCALES.get(layout, 0.0)))
    camera, scale = camera_source.intrinsic, depth_scale or camera_source.depth_scale
    if not scale:
        remedy = "Give depth_scale=: 1000 for millimeters, 5000 for images of the TUM benchmark"
        raise DatasetError(folder, "the unit of its depth maps is unknown", remedy=remedy)
    if (camera.width, camera.height) != size:
        raise DatasetError(
            frames[0].depth,
            f"is {size[0]} x {size[1]}, but {camera_source.source} is for {camera.width} x {camera.height}",
            remedy="Give intrinsic= of these images; intrinsic.scaled(factor) adapts one to resized images",
        )
    warnings = failed(camera_source.warning)
    found = demand.left_out, camera_source.source, warnings, resize, tuple(demand.pairing)
    return RGBDDataset(folder, layout, camera, scale, frames, *found)


def _is_complete(frame: FrameFiles, demand: Demand) -> bool:
    """True if all image files of a frame exist, which a list of names does not guarantee."""
    for path in (frame.depth, frame.color):
        if path is not None and not is_file(path):
            demand.miss(path, "missing", "Restore it, or remove it from the list")
            return False
    return True


def _detect_loosely(folder: Path) -> str:
    """Detect the layout of a folder whose poses are optional."""
    marks = _layout_marks(folder)
    if any(all(layout_marks.values()) for layout_marks in marks.values()):
        return _detect_layout(folder, marks)
    layout = _layout_without_poses(folder, marks)
    if layout is not None:
        return layout
    marks["redwood"].pop("trajectory.log")
    marks["tum"].pop("groundtruth.txt")
    return _detect_layout(folder, {**marks, "images": {"a PNG with depth in its name": False}})


def _layout_without_poses(folder: Path, marks: dict[str, dict[str, bool]]) -> str | None:
    if marks["tum"]["depth.txt"]:
        return "tum"
    if marks["redwood"]["depth/"]:
        return "redwood"
    return "images" if contains_images(folder) else None


def _detect_layout(folder: Path, layout_marks: dict[str, dict[str, bool]]) -> str:
    layouts = [layout for layout, marks in layout_marks.items() if all(marks.values())]
    if len(layouts) == 1:
        return layouts[0]
    if layouts:
        remedy = f"Set layout=, one of {', '.join(layouts)}"
        raise DatasetError(folder, f"ambiguous: contains the files of {' and '.join(layouts)}", remedy=remedy)
    state = {True: "found", False: "missing"}
    sought = "; ".join(
        f"{layout}: {', '.join(f'{mark} ({state[there]})' for mark, there in marks.items())}"
        for layout, marks in layout_marks.items()
    )
    known = contains_frames if "images" in layout_marks else is_dataset
    if remedy := recording_remedy(folder, "frames()"):
        raise DatasetError(folder, "is a recording, not a folder of images", remedy=remedy)
    inner = next((d for d in sorted(folder.iterdir()) if d.is_dir() and known(d)), None)
    remedy = (
        f"Did you mean {inner}?" if inner else "Give the folder that contains these files, or convert to one of them"
    )
    raise DatasetError(folder, f"no known layout. Looked for {sought}", remedy=remedy)


def _layout_marks(folder: Path) -> dict[str, dict[str, bool]]:
    depth_maps = any(re.fullmatch(r"frame-\d+\.depth\.png", entry.name) for entry in folder.iterdir())
    names = ("depth.txt", "groundtruth.txt")
    return {
        "7scenes": {"frame-NNNNNN.depth.png": depth_maps},
        "redwood": {"depth/": (folder / "depth").is_dir(), "trajectory.log": (folder / "trajectory.log").is_file()},
        "tum": {name: (folder / name).is_file() for name in names},
    }


def is_dataset(folder: Path) -> bool:
    try:
        return any(all(marks.values()) for marks in _layout_marks(folder).values())
    except OSError:
        return False


def contains_frames(folder: Path) -> bool:
    """True if the folder contains the files of a known layout, poses optional."""
    try:
        return is_dataset(folder) or _layout_without_poses(folder, _layout_marks(folder)) is not None
    except OSError:
        return False


def _check_headers(folder: Path, frames: list[FrameFiles], resize: bool) -> tuple[int, int]:
    """Width and height of all images, which must agree. Color need only agree with itself if it is resized."""
    sizes: dict[str, tuple[Path, ImageHeader]] = {}
    for frame in frames:
        for kind, path, check in (
            ("depth", frame.depth, check_depth_header),
            ("color" if resize else "depth", frame.color, check_color_header),
        ):
            if path is None:
                continue
            header = read_image_header(path)
            check(path, header)
            first_path, first = sizes.setdefault(kind, (path, header))
            if (header.width, header.height) != (first.width, first.height):
                first_size = f"{first_path} is {first.width} x {first.height}"
                remedy = "Depth and color must be registered, pixel for pixel"
                if path == frame.color and not resize:
                    remedy += "; open_frames takes color of another size with resize_color=True"
                raise DatasetError(path, f"is {header.width} x {header.height}, but {first_size}", remedy=remedy)
    if not sizes:
        raise DatasetError(folder, "contains no frame", remedy="Give the folder that contains the frames")
    return sizes["depth"][1].width, sizes["depth"][1].height
