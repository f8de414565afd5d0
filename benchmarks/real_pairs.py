"""Accuracy of registration on real scans with known poses, beside baselines: the tables of docs/registration.md.

    POINTLOOM_DATA=... python benchmarks/real_pairs.py [--only lidar] [--runs 20] [--write]

Local methods: one run each. Global methods: random starting poses of the source and as many seeds. KISS-Matcher, which
assumes the sensor at the origin, gets rotations only; RANSAC and FGR, whose normals are oriented toward the sensor, get
only the seeds. Errors are the rotation angle between the poses and the distance of the translations.
"""

from __future__ import annotations

import argparse
import itertools
import json
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
import real_methods as methods
import real_scans as scans
from pages import write_between
from real_methods import Method
from real_scans import Array, ScanPair
from run import describe

FOLDER = Path(__file__).parent
PAGE = FOLDER.parent / "docs" / "registration.md"
FROM_TRUTH = ("kitchen", "sparse", "bunny")  # too far apart for ICP from the identity
NO_ICP = ("milk",)  # the ground truth is the identity
STILL = np.eye(4)


@dataclass(frozen=True)
class Errors:
    """Errors of a method's runs on a pair.

    Attributes:
        table: "pose" or "no guess".
        pair, method, library: Names.
        begin: Kind of starting poses.
        degrees, distances: Errors of the runs; distances in the pair's unit.
        unit: That unit.
        right: Number of runs near the ground truth.
    """

    table: str
    pair: str
    method: str
    library: str
    begin: str
    degrees: list[float]
    distances: list[float]
    unit: str
    right: int

    def cell(self) -> str:
        """The text of a table cell: the number of correct runs, if not all, and errors."""
        errors, count = f"{_ends(self.degrees)}°, {_ends(self.distances)} {self.unit}".rstrip(), len(self.degrees)
        return errors if count in (1, self.right) else f"**{self.right} of {count}:** {errors}"


def _ends(values: Sequence[float]) -> str:
    """The median, and the maximum if there are several."""
    shown = (np.median(values), max(values)) if len(values) > 1 else values
    return " / ".join(f"{x:.0f}" if x >= 100 else f"{x:.2g}" for x in shown)


def measure(
    method: Method, table: str, begin: str, runs: Iterable[tuple[ScanPair, Array, Array, int]], name: str = ""
) -> Errors:
    """Run a method: each run is a pair, a pose that moves its source, an initial pose, and a seed."""
    degrees, distances, right, pair = [], [], 0, None
    for pair, start, guess, seed in runs:
        angle, distance, near = pair.error(method.run(pair.moved(start), guess, seed) @ start)
        degrees.append(float(angle))
        distances.append(float(distance * pair.unit[1]))
        right += near
    assert pair is not None
    library = method.library
    return Errors(table, name or pair.name, method.name, library, begin, degrees, distances, pair.unit[0], right)


def score_pair(key: str, runs: int) -> Iterator[Errors]:
    """All methods on one pair."""
    pair = scans.PAIRS[key]()
    if key not in NO_ICP:
        begin, guess = ("truth", pair.T) if key in FROM_TRUTH else ("identity", STILL)
        for method in methods.FROM_POSE:
            yield measure(method, "pose", begin, [(pair, STILL, guess, 0)])
    starts = scans.random_poses(runs, pair.spread)
    rotations = [scans.rotation_of(T) for T in starts]
    for method in (methods.GLOBALLY_REFINED, methods.GLOBALLY):
        yield measure(method, "no guess", "poses", [(pair, T, STILL, k) for k, T in enumerate(starts)])
    yield measure(methods.KISS_MATCHER, "no guess", "turns", [(pair, T, STILL, k) for k, T in enumerate(rotations)])
    for method in methods.BY_LOT:
        yield measure(method, "no guess", "seeds", [(pair, STILL, STILL, k) for k in range(runs)])


def score_submaps(runs: int) -> Iterator[Errors]:
    """Global methods on all ten pairs of the submaps; slower baselines with a quarter of the runs."""
    pairs = list(scans.submaps())
    starts = scans.random_poses(runs, pairs[0].spread)
    few = max(1, runs // 4)
    for label, is_near in (("submaps, consecutive", True), ("submaps, others", False)):
        chosen = [pair for pair in pairs if (scans.gap_of(pair) == 1) == is_near]
        for method in (methods.GLOBALLY_REFINED, methods.GLOBALLY):
            jobs = [(pair, T, STILL, k) for pair in chosen for k, T in enumerate(starts)]
            yield measure(method, "no guess", "poses", jobs, label)
        jobs = [(pair, scans.rotation_of(T), STILL, k) for pair in chosen for k, T in enumerate(starts[:few])]
        yield measure(methods.KISS_MATCHER, "no guess", "turns", jobs, label)
        for method in methods.BY_LOT:
            jobs = [(pair, STILL, STILL, k) for pair in chosen for k in range(few)]
            yield measure(method, "no guess", "seeds", jobs, label)


# ------------------------------------------------------------------------------------------------ without one truth


def score_views() -> str:
    """Loop errors of triples of the five Kinect views, registered globally."""
    views, peer = scans.kinect_views(), methods.open3d_icp(methods.ICP[0])
    poses, baseline_poses = {}, {}
    for i, j in itertools.combinations(range(len(views)), 2):
        pair = ScanPair(f"views {i} and {j}", views[j], views[i], STILL, 0.05, 0.02, 0.05, 3.0)
        start = scans.random_poses(1, pair.spread, seed=10 * i + j)[0]
        poses[i, j] = methods.GLOBALLY_REFINED.run(pair.moved(start), STILL, 0) @ start
        baseline_poses[i, j] = peer.run(pair, poses[i, j], 0)
    return (
        f"Five Kinect views, no truth: all {len(poses)} pairs from no guess and random poses, then generalized ICP. "
        f"Ways round three views close to {_close(poses)}; with Open3D's generalized ICP from these poses to "
        f"{_close(baseline_poses)} (median / worst)."
    )


def _close(poses: dict[tuple[int, int], Array]) -> str:
    """Loop error of three views."""
    from pointloom.registration.rigid import pose_error

    triples = [(i, k, j) for (i, k) in poses for j in range(9) if (k, j) in poses]
    missed = [pose_error(poses[i, k] @ poses[k, j], poses[i, j]) for i, k, j in triples]
    return f"{_ends([np.degrees(a) for a, _ in missed])}° and {_ends([100 * d for _, d in missed])} cm"


def score_bunny() -> str:
    """Acceptance of global registration for pairs of ten range scans with random poses."""
    import pointloom as loom

    pairs = [scans.bunny_pair(a, b) for a, b in itertools.combinations(scans.BUNNY_SCANS, 2)]
    starts = scans.random_poses(len(pairs), pairs[0].spread)
    accepted, wrong, right, missed = [], 0, 0, []
    for pair, start in zip(pairs, starts, strict=True):
        source, target = (loom.PointCloud(points) for points in (pair.moved(start).source, pair.target))
        result = loom.registration.register_globally(source, target, voxel_size=pair.voxel_size)
        angle, _, near = pair.error(result.transformation @ start)
        right += near
        if result.converged:
            accepted.append(angle)
            wrong += not near
        elif near:
            missed.append(pair.name)
    return (
        f"Ten range scans of the bunny, all {len(pairs)} pairs from no guess and random poses, `register_globally` "
        f"alone: {len(accepted)} are accepted, {wrong} of them wrong, {_ends(accepted)}° off (median / worst). Of "
        f"{right} correct poses, {len(missed)} are rejected ({', '.join(missed) or 'none'})."
    )


# ------------------------------------------------------------------------------------------------ what comes of it


def table(rows: Sequence[Errors]) -> str:
    """Markdown: a row for each method and library, a column for each pair; a method's name is in its first row only."""
    pairs = list(dict.fromkeys((row.pair, row.begin if row.table == "pose" else "") for row in rows))
    cells = {(row.method, row.library, row.pair): row.cell() for row in rows}
    head = ["method", "library", *(f"{pair}, from the {begin}" if begin else pair for pair, begin in pairs)]
    lines, before = [f"| {' | '.join(head)} |", "|---" * len(head) + "|"], ""
    for method, library in dict.fromkeys((row.method, row.library) for row in rows):
        shown = [cells.get((method, library, pair), "") for pair, _ in pairs]
        lines.append(f"| {' | '.join(['' if method == before else method, library, *shown])} |")
        before = method
    return "\n".join(lines)


def keep(name: str, content: dict[str, object]) -> None:
    """Write a JSON file of results, replacing that of the previous run."""
    about = describe(argparse.Namespace(device="cpu", quick=False, cold=False))
    path = FOLDER / "results" / f"{name}-cpu.json"
    path.write_text(json.dumps({"about": about, **content}, indent=1) + "\n")


def main() -> None:
    """Print the tables and save them."""
    others = {"views": score_views, "scans": score_bunny}
    names = [*scans.PAIRS, "submaps", *others]
    parser = argparse.ArgumentParser(description="Accuracy of registration on real scans, beside baselines.")
    parser.add_argument("--only", action="append", choices=names)
    parser.add_argument("--runs", type=int, default=20, help="number of starting poses and seeds for global methods")
    parser.add_argument("--write", action="store_true", help="write docs/registration.md and the JSON file")
    options = parser.parse_args()
    rows, lines = [], []
    for key in options.only or names:
        if key in others:
            lines.append(others[key]())
        else:
            rows += score_submaps(options.runs) if key == "submaps" else score_pair(key, options.runs)
    kinds = [[row for row in rows if row.table == kind] for kind in ("pose", "no guess")]
    tables = [table(kind) for kind in kinds if kind]
    print("\n\n".join([*tables, *lines]))
    if options.write:
        keep("real_pairs", {"errors": [asdict(row) for row in rows], "lines": lines})
        for name, text in zip(("icp", "no-guess"), tables, strict=True):
            write_between(PAGE, name, text)
        write_between(PAGE, "no-truth", "\n\n".join(lines))


if __name__ == "__main__":
    main()
