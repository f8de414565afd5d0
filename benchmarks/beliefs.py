"""Poses that global registration accepts: of pairs without overlap, and of pairs that overlap.

    POINTLOOM_DATA=... python benchmarks/beliefs.py [--only made --only kitchen] [--cache FOLDER] [--output FILE]

Pairs of different scenes are of one kind (rooms, objects, streets, terrain), at two sizes of voxels each; accepting
one is wrong. Right pairs share at least 15% of the smaller cloud; a pose is correct within 5 degrees and 3 voxels.
Each cloud is turned and shifted at random first. MIN_REST of registration/globally/rating.py was chosen by one half
of the scenes; the table says how pairs within the other half are judged. It prints the table of
docs/registration.md and the pairs that are accepted wrongly.
"""

from __future__ import annotations

import argparse
import itertools
import json
import os
import sys
import zlib
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import belief_scenes
import numpy as np
import real_scans
from belief_scenes import MAY_SHARE, Array, Scan

VOXELS = {"room": (0.05, 0.08), "object": (0.02, 0.03), "street": (0.3, 0.5), "terrain": (2.0, 3.0)}  # [m]
OVERLAP = 0.15  # of the smaller cloud, within a match's distance
MATCH = 1.5  # [voxels]
NEAR = real_scans.NEAR


@dataclass(frozen=True)
class Belief:
    """What was found of a pair.

    Attributes:
        source, target: Names of the clouds.
        scenes: Theirs.
        kind: Of clouds.
        voxel: Edge [m].
        fitted: Whether the constants of the rating were fitted to both scenes, or to neither; None where to one.
        overlap: Share of the smaller cloud that lies on the other; 0 for different scenes.
        score: Of the pose found.
        believed: Accepted: score above 0.5 and converged.
        right: Whether the pose found is the true one; never of different scenes.
        pose: T_target_source that was found.
        warnings: Of the result.
    """

    source: str
    target: str
    scenes: tuple[str, str]
    kind: str
    voxel: float
    fitted: bool | None
    overlap: float
    score: float
    believed: bool
    right: bool
    pose: list[list[float]]
    warnings: tuple[str, ...]


def is_for_fitting(scene: str) -> bool:
    """Whether a scene belongs to the half that constants were fitted to: by its name alone."""
    return not scene.startswith("fresh") and zlib.crc32(scene.encode()) % 2 == 0


def different(scans: Sequence[Scan], most: int) -> Iterator[tuple[Scan, Scan]]:
    """Pairs of clouds of one kind and of scenes that share nothing: of any two scenes so many, chosen at random."""
    by_scene: dict[str, list[Scan]] = {}
    for scan in scans:
        by_scene.setdefault(scan.scene, []).append(scan)
    for a, b in itertools.combinations(by_scene, 2):
        if by_scene[a][0].kind != by_scene[b][0].kind or any({a, b} <= places for places in MAY_SHARE):
            continue
        makers = [scene.split()[0] for scene in (a, b)]
        if set(makers) == {"made", "fresh"}:
            continue  # there are enough of their own
        pairs = list(itertools.product(by_scene[a], by_scene[b]))
        made = "made" in makers or "fresh" in makers
        rng = np.random.default_rng(zlib.crc32(f"{a} {b}".encode()))
        for k in rng.permutation(len(pairs))[: most if made else 3 * most].tolist():
            yield pairs[k]


def overlapping(scans: Sequence[Scan], voxel_size: float) -> Iterator[tuple[Scan, Scan, Array, float]]:
    """Pairs of clouds of one scene that share enough, T_target_source, and the share."""
    from scipy.spatial import cKDTree

    thin: dict[str, Array] = {}
    for a, b in itertools.combinations(scans, 2):
        if a.scene != b.scene or a.pose is None or b.pose is None:
            continue
        T = np.linalg.inv(b.pose) @ a.pose
        for scan in (a, b):
            if scan.name not in thin:
                cells = np.floor(scan.points / voxel_size).astype(np.int64)
                thin[scan.name] = scan.points[np.unique(cells, axis=0, return_index=True)[1]]
        there = thin[a.name] @ T[:3, :3].T + T[:3, 3]
        near = [
            cKDTree(one).query(other, distance_upper_bound=MATCH * voxel_size)[0]
            for one, other in ((thin[b.name], there), (there, thin[b.name]))
        ]
        share = max(float(np.isfinite(distances).mean()) for distances in near)
        if share >= OVERLAP:
            yield a, b, T, share


def start_of(scan: Scan) -> Array:
    """A pose at which a cloud lies anyhow."""
    spread = float(np.ptp(scan.points, axis=0).max())
    return real_scans.random_poses(1, spread, zlib.crc32(scan.name.encode()))[0]


class Judge:
    """Registers pairs with voxels of one size; a cloud is described once."""

    def __init__(self, voxel_size: float):
        self.voxel_size = voxel_size
        self._described: dict[str, Any] = {}

    def describe(self, scan: Scan) -> tuple[Any, Array]:
        import pointloom as loom
        from pointloom.registration.globally.global_registration import describe

        start = start_of(scan)
        if scan.name not in self._described:
            points = scan.points @ start[:3, :3].T + start[:3, 3]
            self._described[scan.name] = describe(loom.PointCloud(points), self.voxel_size)
        return self._described[scan.name], start

    def judge(self, source: Scan, target: Scan, truth: Array | None, overlap: float) -> Belief:
        from pointloom.registration.globally.global_registration import register_described

        (left, from_source), (right, from_target) = self.describe(source), self.describe(target)
        found = register_described(left, right)
        T = np.linalg.inv(from_target) @ found.transformation @ from_source
        assert found.score is not None
        believed = bool(found.score > 0.5 and found.converged)
        hit = truth is not None and _is_near(T, truth, source, self.voxel_size)
        halves = {is_for_fitting(scan.scene) for scan in (source, target)}
        return Belief(
            source.name,
            target.name,
            (source.scene, target.scene),
            source.kind,
            self.voxel_size,
            halves.pop() if len(halves) == 1 else None,
            overlap,
            found.score,
            believed,
            hit,
            T.tolist(),
            found.warnings,
        )


def _is_near(T: Array, truth: Array, source: Scan, voxel_size: float) -> bool:
    from pointloom.registration.rigid import pose_error

    middle = np.append(source.points.mean(axis=0), 1)
    shift = np.linalg.norm((T - truth)[:3] @ middle)
    return bool(np.degrees(pose_error(T, truth)[0]) < NEAR[0] and shift < NEAR[1] * voxel_size)


def judge_all(scans: Sequence[Scan], most: int) -> Iterator[Belief]:
    for kind, sizes in VOXELS.items():
        chosen = [scan for scan in scans if scan.kind == kind]
        for voxel_size in sizes:
            judge = Judge(voxel_size)
            for source, target, T, share in overlapping(chosen, voxel_size):
                yield judge.judge(source, target, T, share)
            for source, target in different(chosen, most):
                yield judge.judge(source, target, None, 0.0)


def table(beliefs: Sequence[Belief]) -> list[str]:
    """Rows of Markdown: fractions that are accepted, by kind and by halves of the scenes."""
    lines = [
        "| pairs | different scenes, accepted | overlapping, correct and accepted | wrong and accepted |",
        "|---|---|---|---|",
    ]
    kinds = list(dict.fromkeys(b.kind for b in beliefs))
    rows: list[tuple[str, Iterable[Belief]]] = [(f"{kind}s", [b for b in beliefs if b.kind == kind]) for kind in kinds]
    rows += [
        ("scenes fitted to", [b for b in beliefs if b.fitted]),
        ("scenes not fitted to", [b for b in beliefs if b.fitted is False]),
    ]
    rows.append(("all", beliefs))
    for name, chosen in rows:
        apart = [b for b in chosen if not b.overlap]
        together = [b for b in chosen if b.overlap]
        wrong = sum(b.believed for b in apart)
        right, mistaken = (sum(b.believed and b.right == way for b in together) for way in (True, False))
        lines.append(f"| {name} | {wrong} of {len(apart)} | {right} of {len(together)} | {mistaken} |")
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", action="append", choices=list(belief_scenes.SOURCES), help="a source of clouds")
    parser.add_argument("--most", type=int, default=1, help="pairs of any two scenes; three times as many of real ones")
    parser.add_argument("--cache", type=Path, help="folder where clouds are kept from run to run")
    parser.add_argument("--output", type=Path, help="what was found of each pair, a line of JSON each")
    arguments = parser.parse_args()
    scans, missing = belief_scenes.load(arguments.only or list(belief_scenes.SOURCES), arguments.cache)
    beliefs = []
    with Path(arguments.output or os.devnull).open("w") as lines:
        for belief in judge_all(scans, arguments.most):
            beliefs.append(belief)
            lines.write(json.dumps(asdict(belief)) + "\n")
            lines.flush()
            print(f"\r{len(beliefs)} pairs", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    print("\n".join(table(beliefs)))
    for b in beliefs:
        if b.believed and not b.right:
            print(f"wrong but accepted: {b.source} on {b.target}, voxels of {b.voxel:g} m, score {b.score:.2f}")
    for line in missing:
        print(f"left out: {line}")


if __name__ == "__main__":
    main()
