"""Our features and matches beside COLMAP's: repeatability, verified matches, CPU seconds.

    python benchmarks/keypoints.py warps PICTURE ...       known homographies of pictures
    python benchmarks/keypoints.py folder PICTURES WORK    features and matches of a folder, WORK is a new folder

Warps: a picture is turned by 30 degrees, scaled to 0.5 and 1.5, blurred by 1.5 px and darkened to 0.6. Repeatable is a
feature of which the warped picture has one within 1.5 px and a quarter octave, of those whose place is in both; the
score is the share of them that is matched, to within 3 px. Either finder gets the picture grey and at 1000 px.
A folder: CPU seconds are those of this process and of COLMAP's; matches are those that COLMAP's verification keeps.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

import numpy as np
import pycolmap  # before cv2 and ours: each brings its own copies of some libraries
from PIL import Image, ImageFilter

import pointloom as loom
from pointloom.core.timing import Clock

SIDE = 1000
FEATURES = 2000
NEAR, SCALE, MATCHED = 1.5, 0.25, 3.0


def warps(width: int, height: int) -> dict[str, tuple[np.ndarray, float, float]]:
    """3x3 from the picture to the warped one, blur [px] and brightness of each."""
    middle = np.array([(width - 1) / 2, (height - 1) / 2])

    def about_middle(angle: float, factor: float) -> np.ndarray:
        c, s = factor * np.cos(np.radians(angle)), factor * np.sin(np.radians(angle))
        turn = np.array([[c, -s], [s, c]])
        H = np.eye(3)
        H[:2, :2], H[:2, 2] = turn, middle - turn @ middle
        return H

    still = about_middle(0, 1)
    return {
        "turned 30 deg": (about_middle(30, 1), 0, 1),
        "scaled 0.5": (about_middle(0, 0.5), 0, 1),
        "scaled 1.5": (about_middle(0, 1.5), 0, 1),
        "blurred 1.5 px": (still, 1.5, 1),
        "darkened 0.6": (still, 0, 0.6),
    }


def warped(grey: np.ndarray, H: np.ndarray, blur: float, factor: float) -> np.ndarray:
    """A picture seen through a homography; it is smoothed first where it shrinks."""
    back = np.linalg.inv(H)
    back[:2, 2] += 0.5 - back[:2, :2] @ [0.5, 0.5]  # PIL has the middle of the first pixel at a half
    shrunk = np.sqrt(abs(np.linalg.det(H[:2, :2])))
    image = Image.fromarray(grey)
    if shrunk < 1:
        image = image.filter(ImageFilter.GaussianBlur(float(0.5 * np.sqrt(1 / shrunk**2 - 1))))
    image = image.transform(image.size, Image.Transform.AFFINE, back[:2].ravel().tolist(), Image.Resampling.BICUBIC)
    image = image.filter(ImageFilter.GaussianBlur(blur)) if blur else image
    return (np.asarray(image) * factor + 0.5).astype(np.uint8)


def of_colmap(grey: np.ndarray) -> loom.sfm.Keypoints:
    options = pycolmap.FeatureExtractionOptions()
    options.use_gpu, options.num_threads, options.sift.max_num_features = False, 1, FEATURES
    keypoints, descriptors = pycolmap.Sift(options, device=pycolmap.Device.cpu).extract(grey)
    kinds = np.round(descriptors * 512).clip(0, 255).astype(np.uint8)
    return loom.sfm.Keypoints(keypoints[:, :2] - 0.5, keypoints[:, 2], keypoints[:, 3], kinds)


def score(a: loom.sfm.Keypoints, b: loom.sfm.Keypoints, H: np.ndarray, shape: tuple[int, ...]) -> tuple[float, float]:
    """Share of features that are found again, and that are matched to where they are."""
    at = a.positions @ H[:2, :2].T + H[:2, 2]
    factor = np.sqrt(abs(np.linalg.det(H[:2, :2])))
    inside = ((at >= 10) & (at <= np.array(shape)[::-1] - 11)).all(axis=1) & (
        a.scales * factor >= np.quantile(b.scales, 0.01)
    )
    gaps = np.linalg.norm(at[inside][:, None] - b.positions[None], axis=2)
    octaves = np.abs(np.log2(a.scales[inside, None] * factor / b.scales[None]))
    again = ((gaps < NEAR) & (octaves < SCALE)).any(axis=1).mean()
    pairs = loom.sfm.match_keypoints(a, b)
    pairs = pairs[inside[pairs[:, 0]]]
    right = np.linalg.norm(at[pairs[:, 0]] - b.positions[pairs[:, 1]], axis=1) < MATCHED
    return float(again), float(right.sum() / max(inside.sum(), 1))


def compare_warps(pictures: list[Path]) -> None:
    finders = {"colmap": of_colmap, "pointloom": lambda grey: loom.sfm.detect_keypoints(grey, max_features=FEATURES)}
    finders["pointloom"](np.random.default_rng(0).integers(0, 256, (64, 64)).astype(np.uint8))  # compiled by now
    print("| picture | warp | features | repeatable | matched right | CPU s |\n|---|---|---|---|---|---|")
    for path in pictures:
        image = Image.open(path).convert("L")
        image.thumbnail((SIDE, SIDE))
        grey = np.asarray(image)
        for name, (H, blur, factor) in warps(*image.size).items():
            other, cells = warped(grey, H, blur, factor), []
            for find in finders.values():
                start = time.process_time()
                a, b = find(grey), find(other)
                spent = time.process_time() - start
                cells.append(
                    (f"{len(a)}, {len(b)}", *(f"{share:.3f}" for share in score(a, b, H, grey.shape)), f"{spent:.2f}")
                )
            print(
                f"| {path.stem} | {name} | " + " | ".join(" / ".join(pair) for pair in zip(*cells, strict=True)) + " |"
            )


def compare_folder(pictures: Path, work: Path) -> None:
    work.mkdir(parents=True)
    print("| finder | features | CPU s | matches kept | pairs kept | CPU s |\n|---|---|---|---|---|---|")
    for finder in ("colmap", "pointloom"):
        if finder == "pointloom":
            loom.sfm.detect_keypoints(np.random.default_rng(0).integers(0, 256, (64, 64)).astype(np.uint8))
        clock, found = Clock(), work / f"{finder}.db"
        features = loom.sfm.find_features(pictures, found, finder=finder)
        clock.stop("features")
        matches = loom.sfm.match(found, work / f"{finder}-matches.db", finder=finder)
        clock.stop("matches")
        cpu = clock.cpu_seconds
        print(
            f"| {finder} | {sum(features.counts)} | {cpu['features']:.1f} | {matches.match_count} "
            f"| {matches.verified_count} of {matches.pair_count} | {cpu['matches']:.1f} |"
        )
        sys.stdout.flush()


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("what", choices=["warps", "folder"])
    arguments.add_argument("paths", type=Path, nargs="+")
    given = arguments.parse_args()
    if given.what == "warps":
        compare_warps(given.paths)
    else:
        compare_folder(*given.paths)


if __name__ == "__main__":
    main()
