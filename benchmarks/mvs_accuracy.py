"""How complete and how exact depth from pictures is: the made-up room, Motorcycle, the fountain, the temple.

    POINTLOOM_DATA=<folder> python benchmarks/mvs_accuracy.py [--only room] [--pictures FOLDER] [--output FILE]

One line a set, before and after `filter_depth_maps`: the share of the pixels with known depth that are kept, the median
of the relative error, the share of those kept that are within 1 %, the share of all that are kept and within 1 %; for
Motorcycle the share that is off by more than two pixels (bad-2); seconds and seconds of the CPU a picture. Sets without
truth say what share is kept, and are to be looked at: --pictures writes the fused cloud of each as a PNG and a PLY.
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
    """What is known of some depth maps, over the pixels with truth of all pictures together."""
    if all(truth is None for truth in scene.truth):
        return {"kept": float(np.mean([each.share for each in maps]))}
    known = [(each.depth, truth) for each, truth in zip(maps, scene.truth, strict=True) if truth is not None]
    depth = np.concatenate([a[b > 0] for a, b in known]).astype(np.float64)
    truth = np.concatenate([b[b > 0] for _, b in known]).astype(np.float64)
    has = depth > 0
    if not has.any():
        return {"kept": 0.0}
    relative = np.abs(depth[has] / truth[has] - 1)
    found = {
        "kept": float(has.mean()),
        "median": float(np.median(relative)),
        "within_1_percent": float((relative < 0.01).mean()),
        "complete": float((relative < 0.01).sum() / has.size),
    }
    if scene.disparity:
        scale = scene.disparity[0]
        off = np.abs(scale / depth[has] - scale / truth[has])
        found |= {"bad_2": float((off > 2).mean()), "median_px": float(np.median(off))}
    return found


def told(name: str, found: dict[str, float]) -> str:
    """One line of a set."""
    names = {"within_1_percent": "within 1 %", "bad_2": "bad-2", "median_px": "median [px]", "complete": "complete"}
    parts = []
    for key, value in found.items():
        shown = f"{value:.3f}" if key == "median_px" else f"{100 * value:.{3 if key == 'median' else 1}f} %"
        parts.append(f"{names.get(key, key)} {shown}")
    return f"{name:28} " + ", ".join(parts)


def run(name: str, scene: mvs_scenes.Scene, given: Any) -> dict[str, Any]:
    """Estimate, filter and fuse one set; prints what came of it."""
    import pointloom as loom

    seen = np.bincount(scene.sparse.observations[:, 0], minlength=len(scene.pictures))
    print(
        f"{name}: {len(scene.pictures)} pictures, {len(scene.sparse.points)} sparse points, at least {seen.min()} each"
    )
    sources = choose_sources(scene.cameras, scene.sparse)
    begun, cpu = time.perf_counter(), time.process_time()
    maps = loom.mvs.estimate_depth_maps(
        scene.pictures, scene.cameras, scene.sparse, sources=sources, device=given.device
    )
    seconds = (time.perf_counter() - begun) / len(maps)
    cpu_seconds = (time.process_time() - cpu) / len(maps)
    raw = errors_of(scene, maps)
    print(told("  as estimated", raw), flush=True)
    begun = time.perf_counter()
    kept = loom.mvs.filter_depth_maps(maps, device=given.device)
    filtering = (time.perf_counter() - begun) / len(maps)
    found = errors_of(scene, kept)
    print(told("  filtered", found), flush=True)
    begun = time.perf_counter()
    cloud = loom.mvs.fuse(kept, scene.pictures, device=given.device)
    fusing = (time.perf_counter() - begun) / len(maps)
    line = f"  {seconds:.2f} s a picture ({cpu_seconds:.2f} s of the CPU), filter {filtering:.3f}, fuse {fusing:.3f} s;"
    print(line, f"{len(cloud):,} points", flush=True)
    record = {"raw": raw, "filtered": found, "points": len(cloud), "pictures": len(maps)}
    record |= {"seconds": seconds, "cpu_seconds": cpu_seconds, "filter_seconds": filtering, "fuse_seconds": fusing}
    if scene.box is not None and len(cloud):
        inside = ((cloud.points >= scene.box[0]) & (cloud.points <= scene.box[1])).all(axis=1)
        print(f"  in the box {100 * inside.mean():.1f} % of the points", flush=True)
        record["in_box"] = float(inside.mean())
        cloud = cloud.select_by_mask(inside)
    if given.pictures and len(cloud):
        look(Path(given.pictures) / name.replace(", ", "-").replace(" ", "-"), scene, cloud)
    return record


def look(path: Path, scene: mvs_scenes.Scene, cloud: Any) -> None:
    """Write a cloud, and beside the middle picture what its camera would see of it."""
    import pointloom as loom
    from pointloom.io.pictures.image_files import write_png

    path.parent.mkdir(parents=True, exist_ok=True)
    loom.write_point_cloud(path.with_suffix(".ply"), cloud)
    k = len(scene.cameras) // 2
    lens = scene.cameras[k].intrinsic
    image = cloud.project_to_rgbd_image(
        lens.width, lens.height, lens, scene.cameras[k].T_camera_world, depth_max=float("inf")
    )
    write_png(path.with_suffix(".png"), np.concatenate([scene.pictures[k], np.asarray(image.color, np.uint8)], axis=1))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", help="sets whose names begin so")
    parser.add_argument("--width", type=int, default=320, help="of the room's pictures; the fountain's have twice that")
    parser.add_argument("--device", default="cpu")
    parser.add_argument("--pictures", help="folder for clouds and pictures of them")
    parser.add_argument("--output", help="JSON of all figures")
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
