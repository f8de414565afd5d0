"""Completeness and accuracy of multi-view stereo: the synthetic room, Motorcycle, the fountain, the temple.

    POINTLOOM_DATA=<folder> python benchmarks/mvs_accuracy.py [--only room] [--pictures FOLDER] [--output FILE]

One line per set, before and after `filter_depth_maps`: the fraction of pixels with ground truth that have an estimate,
the median relative error, the fraction of estimates within 1 %, the fraction of all pixels within 1 %; for
Motorcycle the
fraction with an error above two pixels (bad-2); wall and CPU seconds per image. For sets without ground truth, only the
fraction of estimated pixels is printed; --pictures writes the fused cloud of each as a PNG and a PLY for inspection.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mvs_scenes
import numpy as np
from real_data import DataMissingError

from pointloom.photogrammetry.mvs.sources import choose_sources

SETS: dict[str, Callable[[Any], mvs_scenes.Scene]] = {
    "room, 12 frames": lambda given: mvs_scenes.room(12, given.width),
    "plain room, 12 frames": lambda given: mvs_scenes.room(12, given.width, texture=False),
    "room, 30 frames": lambda given: mvs_scenes.room(30, given.width),
    "motorcycle": lambda given: mvs_scenes.motorcycle(),
    "fountain": lambda given: mvs_scenes.fountain(2 * given.width),
    "temple": lambda given: mvs_scenes.temple(),
}


def errors_of(scene: mvs_scenes.Scene, maps: Any) -> dict[str, float]:
    """Errors of depth maps over the pixels with ground truth of all images."""
    if all(truth is None for truth in scene.truth):
        return {"kept": float(np.mean([each.fraction for each in maps]))}
    known = [(each.depth, truth) for each, truth in zip(maps, scene.truth, strict=True) if truth is not None]
    depth = np.concatenate([a[b > 0] for a, b in known]).astype(np.float64)
    truth = np.concatenate([b[b > 0] for _, b in known]).astype(np.float64)
    has = depth > 0
    if not has.any():
        return {"kept": 0.0}
    relative = np.abs(depth[has] / truth[has] - 1)
    errors = {
        "kept": float(has.mean()),
        "median": float(np.median(relative)),
        "within_1_percent": float((relative < 0.01).mean()),
        "complete": float((relative < 0.01).sum() / has.size),
    }
    if scene.disparity:
        scale = scene.disparity[0]
        disparity_errors = np.abs(scale / depth[has] - scale / truth[has])
        errors |= {"bad_2": float((disparity_errors > 2).mean()), "median_px": float(np.median(disparity_errors))}
    return errors


def line_of(name: str, errors: dict[str, float]) -> str:
    """One line for a set."""
    names = {"within_1_percent": "within 1 %", "bad_2": "bad-2", "median_px": "median [px]", "complete": "complete"}
    parts = []
    for key, value in errors.items():
        shown = f"{value:.3f}" if key == "median_px" else f"{100 * value:.{3 if key == 'median' else 1}f} %"
        parts.append(f"{names.get(key, key)} {shown}")
    return f"{name:28} " + ", ".join(parts)


def run(name: str, scene: mvs_scenes.Scene, given: Any) -> dict[str, Any]:
    """Estimate, filter and fuse one set; prints the results."""
    import pointloom as loom

    counts = np.bincount(scene.sparse.observations[:, 0], minlength=len(scene.images))
    print(
        f"{name}: {len(scene.images)} images, {len(scene.sparse.points)} sparse points, "
        f"at least {counts.min()} per image"
    )
    sources = choose_sources(scene.cameras, scene.sparse)
    start, cpu = time.perf_counter(), time.process_time()
    maps = loom.photogrammetry.estimate_depth_maps(
        scene.images, scene.cameras, scene.sparse, sources=sources, device=given.device
    )
    seconds = (time.perf_counter() - start) / len(maps)
    cpu_seconds = (time.process_time() - cpu) / len(maps)
    raw = errors_of(scene, maps)
    print(line_of("  as estimated", raw), flush=True)
    start = time.perf_counter()
    filtered = loom.photogrammetry.filter_depth_maps(maps, device=given.device)
    filtering = (time.perf_counter() - start) / len(maps)
    errors = errors_of(scene, filtered)
    print(line_of("  filtered", errors), flush=True)
    start = time.perf_counter()
    cloud = loom.photogrammetry.fuse_depth_maps(filtered, scene.images, device=given.device)
    fusing = (time.perf_counter() - start) / len(maps)
    line = f"  {seconds:.2f} s per image ({cpu_seconds:.2f} s CPU), filter {filtering:.3f}, fuse {fusing:.3f} s;"
    print(line, f"{len(cloud):,} points", flush=True)
    record = {"raw": raw, "filtered": errors, "points": len(cloud), "images": len(maps)}
    record |= {"seconds": seconds, "cpu_seconds": cpu_seconds, "filter_seconds": filtering, "fuse_seconds": fusing}
    if scene.box is not None and len(cloud):
        inside = ((cloud.points >= scene.box[0]) & (cloud.points <= scene.box[1])).all(axis=1)
        print(f"  in the box {100 * inside.mean():.1f} % of the points", flush=True)
        record["in_box"] = float(inside.mean())
        cloud = cloud.select_by_mask(inside)
    if given.images and len(cloud):
        look(Path(given.images) / name.replace(", ", "-").replace(" ", "-"), scene, cloud)
    return record


def look(path: Path, scene: mvs_scenes.Scene, cloud: Any) -> None:
    """Write a cloud, and the middle image beside a rendering of the cloud from the same camera."""
    import pointloom as loom
    from pointloom.io.images.image_files import write_png

    path.parent.mkdir(parents=True, exist_ok=True)
    loom.write_point_cloud(path.with_suffix(".ply"), cloud)
    k = len(scene.cameras) // 2
    lens = scene.cameras[k].intrinsic
    image = cloud.project_to_rgbd_image(
        lens.width, lens.height, lens, scene.cameras[k].T_camera_world, depth_max=float("inf")
    )
    write_png(path.with_suffix(".png"), np.concatenate([scene.images[k], np.asarray(image.color, np.uint8)], axis=1))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", help="sets whose names start with this")
    parser.add_argument("--width", type=int, default=320, help="image width of the room; the fountain's is twice that")
    parser.add_argument("--device", default="cpu")
    parser.add_argument("--pictures", help="folder for clouds and images of them")
    parser.add_argument("--output", help="write all results as JSON")
    given = parser.parse_args()
    records = {}
    for name, make in SETS.items():
        if name.startswith(given.only):
            try:
                records[name] = run(name, make(given), given)
            except DataMissingError as error:
                print(f"{name}: left out, {error}", flush=True)
    if given.output:
        Path(given.output).write_text(json.dumps(records, indent=1) + "\n")
    return 0 if records else 1


if __name__ == "__main__":
    sys.exit(main())
