"""COLMAP's incremental and global mapper on the same matches: registered images, errors, CPU time.

    POINTLOOM_DATA=<folder> python benchmarks/sfm_mappers.py WORK [SET ...]

SET is room, fountain, redkitchen or sceaux; default: all. WORK is a new folder. Features are computed in images of
up to
1000 pixels, at most 2048 per image. Errors are those of `sfm_accuracy.py`, of camera centers after the best similarity.
Sceaux has no ground truth, so the cameras of both mappers are compared.
"""

from __future__ import annotations

import argparse
import dataclasses
import resource
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import sfm_accuracy
from real_data import real_data

from pointloom.photogrammetry.sfm.features import find_features
from pointloom.photogrammetry.sfm.mapping import map_images
from pointloom.photogrammetry.sfm.matches import match_features
from pointloom.photogrammetry.sfm.settings import SfmSettings

sfm_accuracy.ROOM_FRAMES, sfm_accuracy.STRIDE = 18, 10


def sceaux(work: Path, data: Path | None) -> tuple[Path, dict[str, np.ndarray], dict[str, Any], dict[str, Any]]:
    assert data is not None
    shutil.copytree(data / "images", work / "images", ignore=lambda _, names: [n for n in names if n[-4:] != ".JPG"])
    return work / "images", {}, {}, {}


SETS = {
    "room": (sfm_accuracy.room, None),
    "fountain": (sfm_accuracy.fountain, "mvs-fountain-p11"),
    "fountain, its lens unknown": (sfm_accuracy.fountain, "mvs-fountain-p11"),
    "redkitchen": (sfm_accuracy.redkitchen, "rgbd-7scenes-redkitchen"),
    "sceaux": (sceaux, "mvs-sceaux"),
}


def cpu_seconds() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("work", type=Path)
    arguments.add_argument("sets", nargs="*")
    given = arguments.parse_args()
    given.work.mkdir(parents=True)
    print("| images | mapper | registered | centers, RMS in % of extent | directions | reprojection | CPU s |")
    for name in given.sets or SETS:
        compare(name, given.work / name.replace(",", "").replace(" ", "-"))


def compare(name: str, work: Path) -> None:
    make, folder = SETS[name]
    work.mkdir()
    data = None if folder is None else real_data(folder)
    images, truth, options, _ = make(work, data)
    intrinsic = None if "unknown" in name else options.get("intrinsic")
    settings = SfmSettings(intrinsic=intrinsic, max_size=1000, max_features=2048)
    find_features(images, work / "f.db", settings)
    match_features(work / "f.db", work / "m.db", settings)
    for mapper in ("incremental", "global"):
        before = cpu_seconds()
        result = map_images(images, work / "m.db", work / mapper, dataclasses.replace(settings, mapper=mapper))
        seconds, model = cpu_seconds() - before, result.model
        if model is None:
            print(f"| {name} | {mapper} | none | | | | {seconds:.0f} |", flush=True)
            continue
        if not truth:
            truth = dict(zip(model.names, model.T_world_camera, strict=True))
        known = [k for k, each in enumerate(model.names) if each in truth]
        errors = sfm_accuracy.camera_errors(model, truth) if len(known) == len(model) else {}
        fraction, angle = (100 * errors.get("fraction_of_extent", np.nan)), errors.get("mean_degrees", np.nan)
        registered, error = f"{len(model)} of {result.quality.image_count}", result.quality.error
        print(
            f"| {name} | {mapper} | {registered} | {fraction:.3f} % | {angle:.3f} | {error:.2f} px | {seconds:.0f} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
