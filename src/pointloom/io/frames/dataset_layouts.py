"""Frame listings of 7-Scenes, Redwood and TUM folders, in order of capture, from names and text files only.

An incomplete frame is an error, or is skipped if `Demand` allows it.
"""

from __future__ import annotations

import bisect
import dataclasses
import re
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...cameras.pose_text import LOST, parse_floats, pose_or_gap, read_lines, read_pose_or_gap
from ...cameras.trajectory import read_poses_and_gaps
from ...core.errors import DatasetError
from ...core.wording import format_times
from ..images.image_formats import IMAGES

# Maximum time difference [s] of images and poses in a TUM folder, as in the benchmark's tools.
TUM_TOLERANCE = 0.02

# The list of complete frames of a recording (recordings.py): name and time (or -) per line.
FRAME_TIMES = "frame-times.txt"

_SEVEN_SCENES_NAME = re.compile(r"(frame-(\d+))\.(?:(depth)\.png|(color)\.(?:png|jpg|jpeg)|(pose)\.txt)")


@dataclasses.dataclass(frozen=True, eq=False)
class FrameFiles:
    """The files of a frame, with `T_world_camera` (4, 4) [m] and `timestamp` [s], each None if unknown."""

    name: str
    depth: Path
    color: Path | None
    T_world_camera: NDArray[np.float64] | None
    timestamp: float | None = None


@dataclasses.dataclass(frozen=True)
class Demand:
    """Requirements on frames: `poses` are "needed", "taken" if present, or "ignored".
    `skip_missing` skips incomplete frames instead of rejecting the folder, `keep_lost` keeps frames with a lost pose.
    `left_out` collects skipped frames with reasons, `pairing` the numbers of frames paired by time and of possible
    ones.
    """

    poses: str = "needed"
    skip_missing: bool = False
    keep_lost: bool = False
    left_out: list[str] = dataclasses.field(default_factory=list)
    pairing: list[int] = dataclasses.field(default_factory=list)

    def miss(self, path: Path, reason: str, remedy: str) -> None:
        """Reject the folder for a missing file, or skip the frame."""
        if not self.skip_missing:
            raise DatasetError(path, reason, remedy=remedy)
        self.left_out.append(f"{path.name}: {reason}")

    def loses(self, path: Path, frame: str = "") -> bool:
        """True if a frame with an inf or NaN pose is skipped. Raises `DatasetError` if it may not be."""
        if self.poses != "needed" and (self.keep_lost or not self.skip_missing):
            return False
        if not self.skip_missing:
            raise DatasetError(path, f"the pose{frame and f' of {frame}'} is inf or NaN", remedy=LOST)
        self.left_out.append(f"{frame or path.name}: its pose is inf or NaN")
        return True


def list_seven_scenes(folder: Path, every: int, demand: Demand | None = None) -> list[FrameFiles]:
    """Frames of a 7-Scenes folder. Only the poses of every k-th are read."""
    demand = demand or Demand()
    files, numbers = _gather_seven_scenes(folder)
    times = read_frame_times(folder)
    if times is not None:
        for path in (folder / f"{name}.depth.png" for name in times if name not in files):
            demand.miss(
                path, f"missing, although {FRAME_TIMES} lists it", f"Restore it, or remove it from {FRAME_TIMES}"
            )
    parts = {"depth": "png"}
    if any("color" in there for there in files.values()):
        parts["color"] = "png or .jpg"
    if demand.poses == "needed":
        parts["pose"] = "txt"
    complete = []
    for stem in (numbers[number] for number in sorted(numbers)):
        if times is not None and stem not in times:
            continue  # an interrupted recording: unlisted files are incomplete
        lacking = next((part for part in parts if part not in files[stem]), None)
        if lacking is None:
            complete.append(stem)
            continue
        there = ", ".join(path.name for path in files[stem].values())
        remedy = f"Restore it, or remove {there} to leave the frame out"
        demand.miss(folder / f"{stem}.{lacking}.{parts[lacking]}", "missing", remedy)
    frames = []
    for stem in complete[::every]:
        pose = files[stem].get("pose") if demand.poses != "ignored" else None
        T_world_camera = None if pose is None else read_pose_or_gap(pose)
        if pose is not None and T_world_camera is None and demand.loses(pose):
            continue
        time = None if times is None else times[stem]
        frames.append(FrameFiles(stem, files[stem]["depth"], files[stem].get("color"), T_world_camera, time))
    return frames


def _gather_seven_scenes(folder: Path) -> tuple[dict[str, dict[str, Path]], dict[int, str]]:
    files: dict[str, dict[str, Path]] = {}
    numbers: dict[int, str] = {}
    for entry in sorted(folder.iterdir()):
        match = _SEVEN_SCENES_NAME.fullmatch(entry.name)
        if not match:
            continue
        stem, number, part = match[1], int(match[2]), match[match.lastindex or 0]
        if numbers.setdefault(number, stem) != stem:
            raise DatasetError(entry, f"has the same number as {numbers[number]}", remedy="Keep one of the two")
        if part in files.setdefault(stem, {}):
            raise DatasetError(entry, f"duplicates {files[stem][part].name}", remedy="Keep one of the two")
        files[stem][part] = entry
    if not files:
        raise DatasetError(
            folder, "contains no frame-NNNNNN.depth.png", remedy="Give the folder that contains the frames"
        )
    return files, numbers


def read_frame_times(folder: Path) -> dict[str, float | None] | None:
    """Names and times [s] of the complete frames of a recording, or None.
    An unterminated last line was interrupted and is ignored."""
    path = folder / FRAME_TIMES
    if not path.is_file():
        return None
    times: dict[str, float | None] = {}
    lines = read_lines(path)
    if lines and not path.read_bytes().endswith(b"\n"):
        lines.pop()
    for number, columns in lines:
        where = f"line {number}"
        if len(columns) != 2 or not re.fullmatch(r"frame-\d+", columns[0]):
            raise DatasetError(path, "expected the name of a frame and its time, or -", where=where)
        if columns[0] in times:
            raise DatasetError(path, f"lists {columns[0]} twice", where=where, remedy="Keep one of the two")
        times[columns[0]] = None if columns[1] == "-" else parse_floats(path, (number, columns[1:]), 1)[0]
    return times


def list_redwood(folder: Path, demand: Demand | None = None) -> list[FrameFiles]:
    """Frames of a Redwood folder, color paired by name and poses by the ids of the log."""
    demand = demand or Demand()
    depths = _list_images(folder / "depth", (".png",))
    colors = _find_colors(folder, depths, demand)
    log = folder / "trajectory.log"
    poses: dict[Path, NDArray[np.float64]] = {}
    if log.is_file() and demand.poses != "ignored":
        poses = _pair_poses(folder, log, depths)
    elif demand.poses == "needed":
        remedy = "Each depth map needs a pose, camera to world; open_frames takes frames without"
        raise DatasetError(log, "missing", remedy=remedy)
    color_of: dict[Path, Path | None] = dict.fromkeys(depths) if colors is None else {**colors}
    frames = []
    for path, color in color_of.items():
        pose = poses.get(path)
        known = None if pose is None else pose_or_gap(pose)
        if pose is None or known is not None or not demand.loses(log, path.name):
            frames.append(FrameFiles(path.stem, path, color, known))
    return frames


def _pair_poses(folder: Path, log: Path, depths: list[Path]) -> dict[Path, NDArray[np.float64]]:
    trajectory = read_poses_and_gaps(log)
    assert trajectory.ids is not None
    if len(trajectory) != len(depths):
        raise DatasetError(
            log,
            f"contains {len(trajectory)} poses for {len(depths)} depth maps in {folder / 'depth'}",
            remedy="Remove the depth maps without pose, or complete the log: the pairs are ambiguous",
        )
    ids = trajectory.ids[:, 0].tolist()
    numbers = [_first_number(path) for path in depths]
    if ids == list(range(len(ids))):
        return dict(zip(depths, trajectory.poses, strict=True))
    if len(set(ids)) == len(ids) and sorted(ids) == sorted(-1 if n is None else n for n in numbers):
        by_id = dict(zip(ids, trajectory.poses, strict=True))
        return {path: by_id[n] for path, n in zip(depths, numbers, strict=True) if n is not None}
    odd = next((i for i in ids if i not in numbers), ids[0])
    raise DatasetError(
        log,
        f"its ids are neither 0 to {len(ids) - 1} nor the numbers of the depth maps; the first unexpected one is {odd}",
        remedy="The first number above each pose must name its frame",
    )


def _list_images(folder: Path, suffixes: tuple[str, ...]) -> list[Path]:
    """Images of a folder, sorted by number, without duplicate stems or hidden files."""
    if not folder.is_dir():
        raise DatasetError(folder, "missing", remedy="Give the folder above it, or another layout")
    paths = [p for p in folder.iterdir() if p.suffix.lower() in suffixes and not p.name.startswith(".")]
    if not paths:
        raise DatasetError(folder, f"contains no image ({' or '.join(suffixes)})", remedy="Put the frames there")
    paths.sort(key=lambda path: ([int(number) for number in re.findall(r"\d+", path.stem)], path.name))
    stems: dict[str, Path] = {}
    for path in paths:
        if stems.setdefault(path.stem, path) != path:
            raise DatasetError(path, f"duplicates {stems[path.stem].name}", remedy="Keep one of the two")
    return paths


def _find_colors(folder: Path, depths: list[Path], demand: Demand) -> dict[Path, Path] | None:
    """The color image of each depth map. None if the folder has no color."""
    folders = [folder / name for name in ("color", "image", "rgb") if (folder / name).is_dir()]
    if not folders:
        return None
    if len(folders) > 1:
        raise DatasetError(folders[1], f"duplicates {folders[0].name}", remedy="Keep one folder of color")
    colors = _list_images(folders[0], IMAGES)
    depth_keys, color_keys = _pairing_keys(depths, colors)
    by_key = dict(zip(color_keys, colors, strict=True))
    pairs = {}
    for key, path in zip(depth_keys, depths, strict=True):
        if key in by_key:
            pairs[path] = by_key.pop(key)
        else:
            demand.miss(path, f"has no color image in {folders[0]}", "Restore it, or remove this")
    for path in by_key.values():
        demand.miss(path, f"has no depth map in {folder / 'depth'}", "Restore it, or remove this")
    return pairs


def _pairing_keys(depths: list[Path], colors: list[Path]) -> tuple[Sequence[object], Sequence[object]]:
    """Keys of depth and color: the stem if equal, else the first number if unique."""
    stems = [path.stem for path in depths], [path.stem for path in colors]
    if set(stems[0]) == set(stems[1]):
        return stems
    numbers = [_first_number(path) for path in depths], [_first_number(path) for path in colors]
    if all(None not in side and len(set(side)) == len(side) for side in numbers):
        return numbers
    if set(stems[0]) & set(stems[1]):
        return stems
    for side, paths in zip(numbers, (depths, colors), strict=True):
        counts = Counter(side)
        for number, path in zip(side, paths, strict=True):
            if number is None or counts[number] > 1:
                reason = "cannot be paired: depth and color have different names, and its first number is not unique"
                raise DatasetError(path, reason, remedy="Use the same name for both, such as 00000.png and 00000.jpg")
    return stems


def _first_number(path: Path) -> int | None:
    match = re.search(r"\d+", path.stem)
    return int(match[0]) if match else None


def list_tum(folder: Path, demand: Demand | None = None) -> tuple[list[FrameFiles], list[str]]:
    """Frames of a TUM folder, and unpaired files with the reason."""
    demand = demand or Demand()
    depth_times, depth_names = _read_listing(folder, "depth.txt")
    truth = folder / "groundtruth.txt"
    pose_times, poses = [], np.zeros((0, 4, 4))
    if truth.is_file() and demand.poses != "ignored":
        pose_times, poses = _read_timed_poses(truth)
    elif demand.poses == "needed":
        remedy = "Each depth map needs a pose, camera to world; open_frames takes frames without"
        raise DatasetError(truth, "missing", remedy=remedy)
    color_of: dict[int, int] | None = None
    color_times = np.zeros(0)
    color_names: list[str] = []
    if (folder / "rgb.txt").is_file():
        color_times, color_names = _read_listing(folder, "rgb.txt")
        color_of = associate(depth_times, color_times, TUM_TOLERANCE)
    elif (folder / "rgb").is_dir():
        raise DatasetError(
            folder / "rgb.txt", "missing, although there is rgb/", remedy="It contains the times of color"
        )
    frames, left_out = [], demand.left_out
    sides = [len(depth_times)] + [len(color_names)] * (color_of is not None) + [len(poses)] * (demand.poses == "needed")
    for i, (time, name) in enumerate(zip(depth_times.tolist(), depth_names, strict=True)):
        T_world_camera, color = _pose_at(pose_times, poses, time), None
        if T_world_camera is None and demand.poses == "needed":
            left_out.append(f"{name}: no pose within {TUM_TOLERANCE} s")
            continue
        if T_world_camera is not None:
            T_world_camera = pose_or_gap(T_world_camera)
            if T_world_camera is None and demand.loses(truth, name):
                continue
        if color_of is not None:
            if i not in color_of:
                left_out.append(f"{name}: no color within {TUM_TOLERANCE} s")
                continue
            color = folder / color_names[color_of[i]]
        frames.append(FrameFiles(Path(name).stem, folder / name, color, T_world_camera, time))
    if not frames:
        listed = {"depth.txt": depth_times, "rgb.txt": color_times, "groundtruth.txt": pose_times}
        spans = [f"{name} {format_times(times[0], times[-1])}" for name, times in listed.items() if len(times)]
        reason = f"no depth map has a pose and color within {TUM_TOLERANCE} s; the first: {left_out[0]}"
        raise DatasetError(folder, reason, remedy=f"The clocks must agree: {', '.join(spans)}")
    demand.pairing.extend((len(frames), min(sides)))
    return frames, left_out


def _read_timed_poses(truth: Path) -> tuple[list[float], NDArray[np.float64]]:
    trajectory = read_poses_and_gaps(truth)
    if trajectory.timestamps is None:
        raise DatasetError(truth, "has no times", remedy="Expected timestamp tx ty tz qx qy qz qw")
    order = np.argsort(trajectory.timestamps, kind="stable")
    return trajectory.timestamps[order].tolist(), trajectory.poses[order]


def _pose_at(times: list[float], poses: NDArray[np.float64], time: float) -> NDArray[np.float64] | None:
    if not times:
        return None
    nearest = _nearest(times, time)
    return poses[nearest] if abs(times[nearest] - time) < TUM_TOLERANCE else None


def associate(first: NDArray[np.float64], second: NDArray[np.float64], tolerance: float) -> dict[int, int]:
    """Pair two increasing time series one to one, closest first, as in the TUM benchmark's associate.py.
    Pairs are less than `tolerance` apart [s]. Returns {index in `first`: index in `second`}."""
    starts = np.searchsorted(second, first - tolerance, "left")
    ends = np.searchsorted(second, first + tolerance, "right")
    candidates = sorted(
        (abs(float(first[i] - second[j])), i, j) for i in range(len(first)) for j in range(starts[i], ends[i])
    )
    pairs: dict[int, int] = {}
    used: set[int] = set()
    for distance, i, j in candidates:
        if distance < tolerance and i not in pairs and j not in used:
            pairs[i] = j
            used.add(j)
    return pairs


def _read_listing(folder: Path, name: str) -> tuple[NDArray[np.float64], list[str]]:
    """Sorted times and file names of a TUM list."""
    path = folder / name
    if not path.is_file():
        raise DatasetError(path, "missing", remedy="It lists the times and names of the images")
    rows = []
    for number, columns in read_lines(path):
        (time,) = parse_floats(path, (number, columns[:1]), 1)
        entry = " ".join(columns[1:])
        if not entry or Path(entry).is_absolute() or ".." in Path(entry).parts or "\0" in entry:
            reason = f"expected a time and the name of an image in the folder, got {' '.join(columns)[:80]!r}"
            raise DatasetError(path, reason, where=f"line {number}")
        if rows and time <= rows[-1][0]:
            raise DatasetError(path, "expected increasing times", where=f"line {number}", remedy="Sort the list")
        rows.append((time, entry))
    if not rows:
        raise DatasetError(path, "lists no image", remedy="Fetch the data set again")
    return np.array([time for time, _ in rows]), [entry for _, entry in rows]


def _nearest(times: list[float], time: float) -> int:
    after = bisect.bisect_left(times, time)
    if after == len(times) or (after and time - times[after - 1] <= times[after] - time):
        return after - 1
    return after
