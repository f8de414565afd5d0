"""Rates of accepted poses of global registration, for pairs without overlap and for overlapping pairs.

    POINTLOOM_DATA=... python benchmarks/beliefs.py [--only made --only kitchen] [--cache FOLDER] [--output FILE]

Pairs of different scenes are of one kind (rooms, objects, streets, terrain), at two voxel sizes each; accepting one is
wrong. Overlapping pairs share at least 15% of the smaller cloud; a pose is correct within 5 degrees and 3 voxels. Each
cloud gets a random pose first. MIN_REST of registration/assessment_constants.py was fitted to one half of the scenes;
the table reports the other half separately. Prints the table of docs/registration.md and the wrongly accepted pairs.
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
from belief_scenes import MAY_FRACTION, Array, Scan

VOXELS = {"room": (0.05, 0.08), "object": (0.02, 0.03), "street": (0.3, 0.5), "terrain": (2.0, 3.0)}  # [m]
OVERLAP = 0.15  # of the smaller cloud, within the matching distance
MATCH = 1.5  # [voxels]
NEAR = real_scans.NEAR


@dataclass(frozen=True)
class Belief:
    """The result of one pair.

    Attributes:
        source, target: Names of the clouds.
        scenes: Names of their scenes.
        kind: Kind of the clouds.
        voxel: Voxel size [m].
        fitted: True if the constants of the rating were fitted to both scenes, False if to neither, None if to one.
        overlap: Fraction of the smaller cloud that overlaps the other; 0 for different scenes.
        score: Score of the estimated pose.
        believed: True if the pose was accepted: score above 0.5 and converged.
        right: True if the estimated pose is correct; always False for different scenes.
        pose: The estimated T_target_source.
        warnings: Warnings of the result.
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
    """True if a scene belongs to the half that constants were fitted to, decided by its name."""
    return not scene.startswith("fresh") and zlib.crc32(scene.encode()) % 2 == 0


def different(scans: Sequence[Scan], max_pairs: int) -> Iterator[tuple[Scan, Scan]]:
    """Pairs of clouds of one kind from different scenes, chosen at random, up to `max_pairs` for any two scenes."""
    by_scene: dict[str, list[Scan]] = {}
    for scan in scans:
        by_scene.setdefault(scan.scene, []).append(scan)
    for a, b in itertools.combinations(by_scene, 2):
        if by_scene[a][0].kind != by_scene[b][0].kind or any({a, b} <= scenes for scenes in MAY_FRACTION):
            continue
        makers = [scene.split()[0] for scene in (a, b)]
        if set(makers) == {"made", "fresh"}:
            continue  # there are enough pairs within each set
        pairs = list(itertools.product(by_scene[a], by_scene[b]))
        is_synthetic = "made" in makers or "fresh" in makers
        rng = np.random.default_rng(zlib.crc32(f"{a} {b}".encode()))
        for k in rng.permutation(len(pairs))[: max_pairs if is_synthetic else 3 * max_pairs].tolist():
            yield pairs[k]


def overlapping(
    scans: Sequence[Scan], voxel_size: float, min_overlap: float = OVERLAP
) -> Iterator[tuple[Scan, Scan, Array, float]]:
    """Overlapping pairs of clouds of one scene, with T_target_source and the overlap."""
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
        moved_source = thin[a.name] @ T[:3, :3].T + T[:3, 3]
        near = [
            cKDTree(one).query(other, distance_upper_bound=MATCH * voxel_size)[0]
            for one, other in ((thin[b.name], moved_source), (moved_source, thin[b.name]))
        ]
        fraction = max(float(np.isfinite(distances).mean()) for distances in near)
        if fraction >= min_overlap:
            yield a, b, T, fraction


def start_of(scan: Scan) -> Array:
    """A random initial pose of a cloud."""
    spread = float(np.ptp(scan.points, axis=0).max())
    return real_scans.random_poses(1, spread, zlib.crc32(scan.name.encode()))[0]


class Judge:
    """Registers pairs at one voxel size; each cloud is described once."""

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
        result = register_described(left, right)
        T = np.linalg.inv(from_target) @ result.transformation @ from_source
        assert result.score is not None
        accepted = bool(result.score > 0.5 and result.converged)
        hit = truth is not None and _is_near(T, truth, source, self.voxel_size)
        for_fitting = {is_for_fitting(scan.scene) for scan in (source, target)}
        return Belief(
            source.name,
            target.name,
            (source.scene, target.scene),
            source.kind,
            self.voxel_size,
            for_fitting.pop() if len(for_fitting) == 1 else None,
            overlap,
            result.score,
            accepted,
            hit,
            T.tolist(),
            result.warnings,
        )


def _is_near(T: Array, truth: Array, source: Scan, voxel_size: float) -> bool:
    from pointloom.registration.rigid import pose_error

    middle = np.append(source.points.mean(axis=0), 1)
    shift = np.linalg.norm((T - truth)[:3] @ middle)
    return bool(np.degrees(pose_error(T, truth)[0]) < NEAR[0] and shift < NEAR[1] * voxel_size)


def judge_all(scans: Sequence[Scan], max_pairs: int) -> Iterator[Belief]:
    for kind, sizes in VOXELS.items():
        chosen = [scan for scan in scans if scan.kind == kind]
        for voxel_size in sizes:
            judge = Judge(voxel_size)
            for source, target, T, fraction in overlapping(chosen, voxel_size):
                yield judge.judge(source, target, T, fraction)
            for source, target in different(chosen, max_pairs):
                yield judge.judge(source, target, None, 0.0)


def table(beliefs: Sequence[Belief]) -> list[str]:
    """Rows of Markdown: rates of accepted poses, by kind and by half of the scenes."""
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
        separate = [b for b in chosen if not b.overlap]
        together = [b for b in chosen if b.overlap]
        wrong = sum(b.believed for b in separate)
        right, mistaken = (sum(b.believed and b.right == is_right for b in together) for is_right in (True, False))
        lines.append(f"| {name} | {wrong} of {len(separate)} | {right} of {len(together)} | {mistaken} |")
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "--only", action="append", choices=list(belief_scenes.SOURCES), help="a source of clouds; may be repeated"
    )
    parser.add_argument(
        "--most", type=int, default=1, help="pairs for any two scenes; three times as many for real scenes"
    )
    parser.add_argument("--cache", type=Path, help="folder for cached clouds")
    parser.add_argument("--output", type=Path, help="write the result of each pair as a line of JSON")
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
