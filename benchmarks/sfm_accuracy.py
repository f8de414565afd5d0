"""Camera errors of structure from motion, with time and memory by stage.

    python benchmarks/sfm_accuracy.py room WORK           30 images of the synthetic room
    python benchmarks/sfm_accuracy.py room-video WORK     the same path as a video of 240 frames
    python benchmarks/sfm_accuracy.py fountain WORK $POINTLOOM_DATA/mvs-fountain-p11             with K given
    python benchmarks/sfm_accuracy.py redkitchen WORK $POINTLOOM_DATA/rgbd-7scenes-redkitchen    each 5th frame

WORK is a new folder for the output. Errors are those of camera centers after the best similarity (Umeyama 1991), and of
directions after the best rotation. The ground truth of the kitchen is KinectFusion's and drifts by some
centimeters; that
of the others is exact, or from a laser scanner.
"""

from __future__ import annotations

import argparse
import json
import shutil
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

import pointloom as loom

STRIDE = 5  # of the kitchen's frames
ROOM_FRAMES, VIDEO_FRAMES = 30, 240


def fit_similarity(source: np.ndarray, target: np.ndarray) -> tuple[float, np.ndarray, np.ndarray]:
    """Scale, rotation and translation that align `source` with `target` in the least-squares sense."""
    means = source.mean(0), target.mean(0)
    a, b = source - means[0], target - means[1]
    u, d, vt = np.linalg.svd(b.T @ a)
    flip = np.array([1.0, 1.0, np.sign(np.linalg.det(u @ vt))])
    R = (u * flip) @ vt
    scale = (d * flip).sum() / (a**2).sum()
    return scale, R, means[1] - scale * R @ means[0]


def camera_errors(model: loom.SfmModel, truth: dict[str, np.ndarray]) -> dict[str, float]:
    """Position and direction errors of the cameras, and the extent [unit of the ground truth]."""
    poses = np.array([truth[name] for name in model.names])
    scale, R, t = fit_similarity(model.centers, poses[:, :3, 3])
    distances = np.linalg.norm(scale * model.centers @ R.T + t - poses[:, :3, 3], axis=1)
    rotations = model.T_world_camera[:, :3, :3]
    u, _, vt = np.linalg.svd(
        np.einsum("nij,nkj->ik", poses[:, :3, :3], rotations)
    )  # centers on a line leave the rotation ambiguous
    differences = np.einsum("nji,jk,nkl->nil", poses[:, :3, :3], u @ vt, rotations)
    cosines = (np.trace(differences, axis1=1, axis2=2) - 1) / 2
    extent = np.linalg.norm(np.ptp(poses[:, :3, 3], axis=0))
    rms = float(np.sqrt((distances**2).mean()))
    return {
        "extent": float(extent),
        "rms": rms,
        "fraction_of_extent": rms / float(extent),
        "mean": float(distances.mean()),
        "worst": float(distances.max()),
        "mean_degrees": float(np.degrees(np.arccos(np.clip(cosines, -1, 1))).mean()),
    }


def round_frames(count: int) -> Any:
    """Frames of a circular path through the synthetic room, 640 x 480 pixels."""
    from pointloom.datasets.scenes.room import film_pose, room_views

    camera = loom.PinholeCameraIntrinsic(640, 480, 525.0, 525.0, 319.5, 239.5)
    return room_views(np.array([film_pose(k / count) for k in range(count)]), camera)


def room(work: Path, data: Path | None) -> tuple[Path, dict[str, np.ndarray], dict, dict]:
    """30 images of a circular path, 12 degrees and 10 cm apart."""
    frames, folder = round_frames(ROOM_FRAMES), work / "images"
    folder.mkdir()
    names = [f"{frame.name}.jpg" for frame in frames]
    for name, frame in zip(names, frames, strict=True):
        Image.fromarray(frame.color).save(folder / name, quality=95, subsampling=0)
    return folder, dict(zip(names, frames.poses, strict=True)), {}, {}


def room_video(work: Path, data: Path | None) -> tuple[Path, dict[str, np.ndarray], dict, dict]:
    """The same path as a video of 240 frames, from which frames are selected."""
    from pointloom.visualization.recording.writers import write_mp4

    frames, path = round_frames(VIDEO_FRAMES), work / "room.mp4"
    with path.open("wb") as file:
        write_mp4(file, (frame.color for frame in frames), 20.0, path)
    choice = loom.photogrammetry.choose_frames(path, work / "images")
    poses = frames.poses
    truth = {name: poses[number] for name, number in zip(choice.names, choice.numbers, strict=True)}
    return work / "images", truth, {}, {"frames": choice.to_dict()}


def fountain(work: Path, data: Path | None) -> tuple[Path, dict[str, np.ndarray], dict, dict]:
    assert data is not None
    truth = {}
    for path in sorted((data / "gt_dense_cameras").glob("*.camera")):
        rows = [[float(x) for x in line.split()] for line in path.read_text().splitlines()]
        truth[path.stem] = np.eye(4)
        truth[path.stem][:3, :3], truth[path.stem][:3, 3] = rows[4:7], rows[7]
        K, (width, height) = np.array(rows[:3]), map(int, rows[8])
    shutil.copytree(data / "images", work / "images", ignore=lambda _, names: [n for n in names if n[-4:] != ".jpg"])
    intrinsic = loom.PinholeCameraIntrinsic(width, height, K[0, 0], K[1, 1], K[0, 2], K[1, 2])
    return work / "images", truth, {"intrinsic": intrinsic}, {}


def redkitchen(work: Path, data: Path | None) -> tuple[Path, dict[str, np.ndarray], dict, dict]:
    assert data is not None
    (work / "images").mkdir()
    truth = {}
    for path in sorted(data.glob("*.color.jpg"))[:300:STRIDE]:
        shutil.copy(path, work / "images")
        truth[path.name] = np.loadtxt(data / path.name.replace("color.jpg", "pose.txt"))
    return work / "images", truth, {"pairs": "sequential"}, {}


SETS = {"room": room, "room-video": room_video, "fountain": fountain, "redkitchen": redkitchen}


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("set", choices=SETS)
    arguments.add_argument("work", type=Path)
    arguments.add_argument("data", type=Path, nargs="?")
    given = arguments.parse_args()
    given.work.mkdir(parents=True)
    images, truth, options, report = SETS[given.set](given.work, given.data)
    result = loom.photogrammetry.reconstruct_images(
        images, given.work / "sfm", loom.photogrammetry.SfmSettings(**options)
    )
    report |= {"set": given.set, **result.to_dict()}
    if result.model is not None:
        report |= {"errors": camera_errors(result.model, truth), "camera": list(result.model.cameras[0].params)}
    text = json.dumps(report, indent=1)
    (given.work / "report.json").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
