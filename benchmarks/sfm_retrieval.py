"""How many of the pairs that see the same are found by looks, of 60 pictures of a kitchen in a shuffled order.

    POINTLOOM_DATA=<folder> python benchmarks/sfm_retrieval.py WORK

WORK is a new folder. All 1770 pairs are matched first; those of which one motion explains 30 matches or more see the
same. Retrieval proposes each picture's most alike; beside it stands what the order of names would propose.
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
from pointloom.photogrammetry.sfm.matches import OVERLAP, _in_a_row, pairs_that_look_alike

STRIDE, FEATURES, FEWEST = 5, 1000, 30
PAIR = 2147483647  # COLMAP numbers the pair (a, b) as PAIR a + b


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("work", type=Path)
    work = arguments.parse_args().work
    (work / "pictures").mkdir(parents=True)
    found = sorted(real_data("rgbd-7scenes-redkitchen").glob("*.color.jpg"))[:300:STRIDE]
    order = np.random.default_rng(0).permutation(len(found))
    for place, k in enumerate(order):
        shutil.copy(found[k], work / "pictures" / f"{place:03d}.jpg")
    loom.sfm.find_features(work / "pictures", work / "f.db", max_features=FEATURES)
    loom.sfm.match(work / "f.db", work / "m.db", pairs="exhaustive")
    with sqlite3.connect(work / "m.db") as connection:
        rows = connection.execute("SELECT pair_id, rows FROM two_view_geometries").fetchall()
    same = {divmod(pair, PAIR): count for pair, count in rows if count >= FEWEST}
    print(f"{len(same)} of {len(rows)} pairs see the same")
    print("| pairs | proposed | of them see the same | share of all that do | of their matches | pictures in one |")
    tell("in a row", {(i + 1, j + 1) for i, j in _in_a_row(len(found), OVERLAP)}, same, len(found))
    for neighbors in (5, 10, 20):
        before = time.process_time()
        pairs = set(pairs_that_look_alike(work / "f.db", neighbors, seed=0))
        spent = time.process_time() - before
        tell(f"{neighbors} most alike ({spent:.1f} CPU s)", pairs, same, len(found))
    rng = np.random.default_rng(1)
    chance = {tuple(sorted(rng.choice(len(found), 2, replace=False) + 1)) for _ in range(len(pairs))}
    tell("as many by chance", chance, same, len(found))


def tell(name: str, pairs: set, same: dict, count: int) -> None:
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
    shares = len(hit) / len(same), sum(same[pair] for pair in hit) / sum(same.values())
    right = 100 * len(hit) / len(pairs)
    print(
        f"| {name} | {len(pairs)} | {right:.0f} % | {100 * shares[0]:.0f} % | {100 * shares[1]:.0f} % "
        f"| {largest} of {count} |"
    )


if __name__ == "__main__":
    main()
