"""Depth of rectified image pairs at three sizes, and of a real pair, beside OpenCV's semi-global matching.

`stereo_pair`: pointloom estimates the depth of both images by PatchMatch and keeps consistent pixels, as for any number
of images. `stereo_pair_sgm`: semi-global matching by both, each with a left-right check. OpenCV's StereoSGBM has one
thread and five paths, or eight (MODE_HH). It searches integer disparities from 0 along a row, and refines them. All get
the search range: pointloom from sparse points, OpenCV as a number of disparities. `python benchmarks/bench_mvs.py`
prints completeness, errors and the best time of five calls for each.
"""

from __future__ import annotations

import time
from functools import cache, partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, thread_count, timed
from mvs_scenes import Scene, motorcycle, motorcycle_disparities

BASELINE = 0.2  # [m] of the room's pair: 36 to 78 px at 640 columns
FRACTION = 0.1  # of the room's camera path
DISPARITIES = 0.2  # of the width: the nearest point has 0.12
BLOCK = 5  # [px] of SGBM


@cache
def room_pair(width: int) -> Scene:
    """Two images of the textured room, side by side."""
    import pointloom as loom
    from pointloom.datasets.scenes.room import room_pose, room_views

    focal = 525.0 * width / 640
    height = width * 3 // 4
    lens = loom.PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2)
    left, right = room_pose(FRACTION), room_pose(FRACTION)
    right[:3, 3] += BASELINE * right[:3, 0]
    frames = list(room_views(np.array([left, right]), lens))
    cameras = [loom.photogrammetry.PosedCamera(lens, np.linalg.inv(frame.T_world_camera)) for frame in frames]
    truth = [np.asarray(frame.depth, np.float32) for frame in frames]
    return Scene([frame.color for frame in frames], cameras, [truth[0], None], (focal * BASELINE, 0.0))


@cache
def real_pair() -> Scene:
    return motorcycle()


def prepare_pointloom(scene: Scene, device: str) -> Any:
    import pointloom as loom

    def match() -> Any:
        maps = loom.photogrammetry.estimate_depth_maps(scene.images, scene.cameras, scene.sparse, device=device)
        return scene, loom.photogrammetry.filter_depth_maps(maps, device=device)[0].depth

    return match


def prepare_sgm(scene: Scene, device: str) -> Any:
    import pointloom as loom

    def match() -> Any:
        maps = loom.photogrammetry.estimate_depth_maps(
            scene.images, scene.cameras, scene.sparse, method="sgm", device=device
        )
        return scene, maps[0].depth

    return match


def prepare_opencv(scene: Scene, device: str, mode: str = "SGBM") -> Any:
    import cv2

    cv2.setNumThreads(thread_count())
    width = scene.images[0].shape[1]
    count = motorcycle_disparities() if scene.disparity[1] else round(DISPARITIES * width)
    costs = {"P1": 8 * 3 * BLOCK**2, "P2": 32 * 3 * BLOCK**2}  # as in OpenCV's documentation and sample
    checks = {"disp12MaxDiff": 1, "uniquenessRatio": 10, "speckleWindowSize": 100, "speckleRange": 2}
    checks["mode"] = getattr(cv2, f"STEREO_SGBM_MODE_{mode}")
    matcher = cv2.StereoSGBM_create(0, -(-count // 16) * 16, BLOCK, **costs, **checks)
    left, right = (cv2.cvtColor(image, cv2.COLOR_RGB2BGR) for image in scene.images)

    def match() -> Any:
        disparity = matcher.compute(left, right).astype(np.float32) / 16
        scale, offset = scene.disparity
        return scene, np.where(disparity > 0, scale / np.maximum(disparity + offset, 1e-6), 0)

    return match


def errors_of(result: Any) -> tuple[float, np.ndarray]:
    """Completeness and the errors [px] over the pixels with ground truth."""
    scene, depth = result
    truth, scale = scene.truth[0], scene.disparity[0]
    known, has = truth > 0, (truth > 0) & (depth > 0)
    return float(has.sum() / known.sum()), np.abs(scale / depth[has] - scale / truth[has])


def facts(result: Any) -> tuple[float, float, float]:
    """Completeness, fraction with an error above two pixels, and median [px]."""
    completeness, errors = errors_of(result)
    return completeness, float((errors > 2).mean()), float(np.median(errors))


def check(actual: Any, reference: Any, peer: str) -> None:
    """Check that both cover more than half of the pixels, and are accurate there."""
    for completeness, bad, median in (actual, reference):
        assert completeness > 0.5, (peer, actual, reference)
        assert bad < 0.12, (peer, actual, reference)
        assert median < 0.5, (peer, actual, reference)


SCENES = {
    "room 320x240": partial(room_pair, 320),
    "room 640x480": partial(room_pair, 640),
    "room 960x720": partial(room_pair, 960),
    "motorcycle 741x500": real_pair,
}
QUICK = {"room 320x240": SCENES["room 320x240"]}
STEREO_PAIR = Operation(
    name="stereo_pair",
    scenes=SCENES,
    quick=QUICK,
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("opencv-sgbm", prepare_opencv, facts),
    ),
    check=check,
    reasons=dict.fromkeys(
        ["room 320x240", "room 640x480", "room 960x720", "motorcycle 741x500"],
        (
            "PatchMatch compares 35 slanted patches per pixel of each image, and SGBM codes of one row of "
            'disparities. `method="sgm"` is the fast way for pairs.'
        ),
    ),
)
SEMI_GLOBAL = Operation(
    name="stereo_pair_sgm",
    scenes=SCENES,
    quick=QUICK,
    contestants=(
        Contestant(POINTLOOM, prepare_sgm, facts, ("cpu", "cuda")),
        Contestant("opencv-sgbm", prepare_opencv, facts),
        Contestant("opencv-sgbm-hh", partial(prepare_opencv, mode="HH"), facts),
    ),
    check=check,
    reasons=dict.fromkeys(
        ["room 320x240", "room 640x480", "room 960x720", "motorcycle 741x500"],
        "Eight paths and both depth maps, at a lower error; SGBM sums five paths for one map.",
    ),
)
OPERATIONS = (STEREO_PAIR, SEMI_GLOBAL)


@timed(STEREO_PAIR)
def test_stereo_pair(time_lap) -> None:
    time_lap()


@timed(SEMI_GLOBAL)
def test_stereo_pair_sgm(time_lap) -> None:
    time_lap()


def main() -> None:
    """Print completeness, accuracy and time of all."""
    for size, make in SCENES.items():
        scene = make()
        for operation, contestant in (
            *((STEREO_PAIR, each) for each in STEREO_PAIR.contestants[:1]),
            *((SEMI_GLOBAL, each) for each in SEMI_GLOBAL.contestants),
        ):
            trial, seconds = contestant.trial(scene, "cpu"), []
            completeness, errors = errors_of(trial.once())
            for _ in range(5):
                start = time.perf_counter()
                trial.once()
                seconds.append(time.perf_counter() - start)
            line = f"{size:20} {operation.name:16} {contestant.name:14} kept {100 * completeness:.1f} %"
            bad = ", ".join(f"bad-{limit} {100 * (errors > limit).mean():.2f} %" for limit in (1, 2))
            accuracy = f"median {np.median(errors):.3f} px, mean {errors.mean():.3f} px"
            print(f"{line}, {bad}, {accuracy}, {1000 * min(seconds):.0f} ms", flush=True)


if __name__ == "__main__":
    main()
