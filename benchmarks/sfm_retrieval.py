"""Recall of image retrieval: overlapping pairs found among 60 images of a kitchen in shuffled order.

    POINTLOOM_DATA=<folder> python benchmarks/sfm_retrieval.py WORK

WORK is a new folder. All 1770 pairs are matched first; pairs with at least 30 geometrically consistent matches overlap.
Retrieval proposes the most similar images of each; the baseline is the order of names.
"""

from __future__ import annotations

import argparse
import shutil
import sqlite3
import time
from pathlib import Path

import numpy as np
from real_data import real_data

import pointloom as loom
from pointloom.photogrammetry.sfm.matches import pairs_of, pairs_that_look_alike
from pointloom.photogrammetry.sfm.settings import SEQUENCE_OVERLAP, SfmSettings

STRIDE, FEATURES, MIN_MATCHES = 5, 1000, 30
PAIR = 2147483647  # COLMAP's id of the pair (a, b) is PAIR a + b


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("work", type=Path)
    work = arguments.parse_args().work
    (work / "images").mkdir(parents=True)
    files = sorted(real_data("rgbd-7scenes-redkitchen").glob("*.color.jpg"))[:300:STRIDE]
    order = np.random.default_rng(0).permutation(len(files))
    for number, k in enumerate(order):
        shutil.copy(files[k], work / "images" / f"{number:03d}.jpg")
    settings = SfmSettings(max_features=FEATURES, pairs="exhaustive")
    loom.photogrammetry.find_features(work / "images", work / "f.db", settings)
    loom.photogrammetry.match_features(work / "f.db", work / "m.db", settings)
    with sqlite3.connect(work / "m.db") as connection:
        rows = connection.execute("SELECT pair_id, rows FROM two_view_geometries").fetchall()
    same = {divmod(pair, PAIR): count for pair, count in rows if count >= MIN_MATCHES}
    print(f"{len(same)} of {len(rows)} pairs overlap")
    print("| pairs | proposed | overlapping | recall | recall of matches | images in one component |")
    in_order = {(int(a), int(b)) for a, b in pairs_of(work / "f.db", "sequential", SEQUENCE_OVERLAP)}
    print_pairs("order of names", in_order, same, len(files))
    for neighbors in (5, 10, 20):
        before = time.process_time()
        pairs = set(pairs_that_look_alike(work / "f.db", neighbors, seed=0))
        seconds = time.process_time() - before
        print_pairs(f"{neighbors} most similar ({seconds:.1f} CPU s)", pairs, same, len(files))
    rng = np.random.default_rng(1)
    chance = {tuple(sorted(rng.choice(len(files), 2, replace=False) + 1)) for _ in range(len(pairs))}
    print_pairs("the same number at random", chance, same, len(files))


def print_pairs(name: str, pairs: set, same: dict, count: int) -> None:
    hit = [pair for pair in same if pair in pairs]
    parts = {k: k for k in range(1, count + 1)}

    def root(k: int) -> int:
        while parts[k] != k:
            k = parts[k]
        return k

    for a, b in hit:
        parts[root(a)] = root(b)
    roots = [root(k) for k in parts]
    largest = max(roots.count(k) for k in set(roots))
    fractions = len(hit) / len(same), sum(same[pair] for pair in hit) / sum(same.values())
    right = 100 * len(hit) / len(pairs)
    print(
        f"| {name} | {len(pairs)} | {right:.0f} % | {100 * fractions[0]:.0f} % | {100 * fractions[1]:.0f} % "
        f"| {largest} of {count} |"
    )


if __name__ == "__main__":
    main()
