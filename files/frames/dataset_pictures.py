"""Folders of a few pictures without a layout: depth and colour side by side, told apart by a word in their names.

`1_depth.png` belongs to `1.png`, `dep_prev.png` to `img_prev.png` and, where it is there, `pose_prev.txt`: what is left
of a name without its word names the frame. A folder in which that is not one to one is refused.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...cameras.pose_text import pose_or_gap, read_lines, read_pose_or_gap, timed_poses
from ...core.errors import DatasetError
from .dataset_layouts import Demand, FrameFiles

_DEPTH_WORD = re.compile(r"(?<![a-z])(?:depth|dep)(?![a-z])", re.I)
_COLOR_WORD = re.compile(r"(?<![a-z])(?:colou?r|rgb|image|img)(?![a-z])", re.I)
_POSE_WORD = re.compile(r"(?<![a-z])pose(?![a-z])", re.I)


def holds_pictures(folder: Path) -> bool:
    """Whether a PNG lies in the folder whose name says that it is a depth map."""
    names = [path.name for path in folder.iterdir() if path.is_file()]
    return any(n.lower().endswith(".png") and _DEPTH_WORD.search(Path(n).stem) for n in names if n[0] != ".")


def list_pictures(folder: Path, demand: Demand) -> list[FrameFiles]:
    """Frames of a folder of pictures, in the order of the numbers in their names."""
    depths: dict[str, Path] = {}
    colors: dict[str, Path] = {}
    poses: dict[str, Path] = {}
    for path in sorted(folder.iterdir()):
        kind = path.suffix.lower()
        if path.name.startswith(".") or not path.is_file():
            continue
        if kind == ".png" and _DEPTH_WORD.search(path.stem):
            _add(depths, _without(_DEPTH_WORD, path), path)
        elif kind in (".png", ".jpg", ".jpeg"):
            _add(colors, _without(_COLOR_WORD, path), path)
        elif kind == ".txt" and _POSE_WORD.search(path.stem):
            _add(poses, _without(_POSE_WORD, path), path)
    if not depths:
        raise DatasetError(folder, "holds no PNG with depth in its name", remedy="Give the folder of the frames")
    for key, path in colors.items():
        if key not in depths:
            demand.miss(path, "has no depth map of its name", "Name it alike, such as 1.png and 1_depth.png")
    frames = []
    for key in sorted(depths, key=lambda key: ([int(n) for n in re.findall(r"\d+", key)], key)):
        if colors and key not in colors:
            demand.miss(depths[key], "has no colour picture of its name", "Bring it back, or remove this")
            continue
        pose = poses.get(key) if demand.poses != "ignored" else None
        T_world_camera = None if pose is None else _read_any_pose(pose)
        if pose is not None and T_world_camera is None and demand.loses(pose):
            continue
        frames.append(FrameFiles(key or depths[key].stem, depths[key], colors.get(key), T_world_camera))
    return frames


def _add(there: dict[str, Path], key: str, path: Path) -> None:
    if there.setdefault(key, path) != path:
        raise DatasetError(path, f"names the same frame as {there[key].name}", remedy="Keep one of the two")


def _without(word: re.Pattern[str], path: Path) -> str:
    """What names the frame: the name without the word and what joined it."""
    return re.sub(r"[-_. ]+", "_", word.sub("", path.stem)).strip("_")


def _read_any_pose(path: Path) -> NDArray[np.float64] | None:
    """Four rows of a matrix, or `tx ty tz qx qy qz qw` as in a line of TUM's without its time; None if lost."""
    lines = read_lines(path)
    if len(lines) != 1:
        return read_pose_or_gap(path)
    return pose_or_gap(timed_poses(path, [(lines[0][0], ["0", *lines[0][1]])], gaps=True)[0][0])
