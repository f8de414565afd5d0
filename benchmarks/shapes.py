"""Precision, recall and size errors of `detect_shapes` on synthetic halls.

    python benchmarks/shapes.py [--seeds 4]

A hall has two planes, two pipes, a sphere, a cone and a ring (tests/pcd/made_shapes.py). A part is found if a shape of
its kind has at least half of its points, and at least half of the shape's points are of the part. The threshold is 2.5
times the noise, and 5 mm without noise. The table is in docs/shapes.md.
"""

from __future__ import annotations

import argparse
import itertools
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.pcd.made_shapes import factory

NOISES = (0.0, 0.002, 0.004, 0.008)  # [m]
OUTLIERS = (0.2, 0.5, 0.7)  # of the points
NEIGHBORS = 30


def sizes_of(shape) -> tuple[float, ...]:
    """Parameters of a shape, in the order of the synthetic parts."""
    return {
        "plane": (),
        "sphere": (shape.radius,),
        "cylinder": (shape.radius,),
        "cone": (shape.half_angle,),
        "torus": (shape.radius, shape.minor_radius),
    }[shape.kind]


def trial(noise: float, outliers: float, seed: int) -> tuple[list, list, list]:
    """For one hall: found parts, correctness and reliability of shapes, radius errors [m]."""
    import pointloom as loom

    points, truth, parts = factory(np.random.default_rng(seed), noise, outliers)
    cloud = loom.PointCloud(points).estimate_normals(max_nn=NEIGHBORS)
    result = loom.detect_shapes(cloud, max(2.5 * noise, 0.005), 25, min_support=600, seed=seed)
    has = np.zeros(len(parts), bool)
    shapes, errors = [], []
    for number, shape in enumerate(result.shapes):
        of = truth[result.labels == number]
        part = int(np.bincount(of[of >= 0], minlength=len(parts)).argmax()) if (of >= 0).any() else -1
        right = part >= 0 and shape.kind == parts[part][0]
        right = right and (of == part).mean() >= 0.5 and (of == part).sum() >= 0.5 * (truth == part).sum()
        shapes.append((right, shape.reliable))
        if right and not has[part]:
            has[part] = True
            if shape.kind != "cone":
                errors += [abs(a - b) for a, b in zip(sizes_of(shape), parts[part][1], strict=True)]
    return has.tolist(), shapes, errors


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=4)
    seeds = parser.parse_args().seeds
    print("| noise | outliers | parts found | shapes correct | reliable ones correct | radius error, median, largest |")
    print("|---|---|---|---|---|---|")
    for noise in NOISES:
        for outliers in OUTLIERS:
            halls = [trial(noise, outliers, seed) for seed in range(seeds)]
            has, shapes, errors = (list(itertools.chain.from_iterable(lists)) for lists in zip(*halls, strict=True))
            sure = [right for right, is_sure in shapes if is_sure]
            counts = f"{sum(has)} of {len(has)} | {sum(right for right, _ in shapes)} of {len(shapes)}"
            radii = f"{1000 * np.median(errors):.2f} mm, {1000 * max(errors):.2f} mm" if errors else ""
            line = f"| {1000 * noise:g} mm | {100 * outliers:.0f} % | {counts} | {sum(sure)} of {len(sure)} | {radii} |"
            print(line, flush=True)


if __name__ == "__main__":
    main()
