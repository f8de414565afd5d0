"""Detection of small displacements by `assess_registration`, on real and synthetic pairs, beside CorAl.

    POINTLOOM_DATA=... python benchmarks/trust/alignment.py [--write]

The correct poses are those of generalized ICP at three voxel sizes, which differ by millimeters in rooms and by
centimeters in streets. CorAl (Adolfsson et al. 2021) compares the entropies of neighborhoods in the joint and in the
separate clouds. Its threshold is set to 5 % false alarms on the same pairs. The constants of `assess_registration` are
fixed.
"""

from __future__ import annotations

import argparse
import itertools
import sys
import zlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

FOLDER = Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent)]

import belief_scenes  # noqa: E402
import beliefs  # noqa: E402
import real_scans  # noqa: E402
from belief_scenes import Scan  # noqa: E402
from judged import Judged, share_in_words  # noqa: E402
from pages import write_between  # noqa: E402

Array = NDArray[np.float64]
PAGE = FOLDER.parent.parent / "docs" / "trust.md"
VOXELS = {"room": 0.05, "street": 0.5}  # [m]
FINER = (0.5, 0.7, 1.0)  # voxels of the registrations, relative to these
OVERLAP = 0.3
QUERIES = 250  # of CorAl in each cloud
DISPLACEMENTS = (
    ("correct", 0.0),
    ("shifted by 2 cm", 0.02),
    ("shifted by 5 cm", 0.05),
    ("shifted by 10 cm", 0.1),
    ("shifted by 1 m", 1.0),
    ("rotated by 0.5°", 0.5),
    ("rotated by 2°", 2.0),
    ("rotated by 10°", 10.0),
)
WITHOUT_POSE = (("Kinect", 1, 2), ("Kinect", 2, 3), ("Kinect", 3, 4), ("Kinect", 4, 5), ("cilantro", 1, 2))


@dataclass(frozen=True)
class Pair:
    """Two scans with correct poses T_target_source. `is_fitted`: constants were chosen on it."""

    name: str
    kind: str
    source: Array
    target: Array
    poses: tuple[Array, ...]
    is_fitted: bool


def pairs() -> Iterator[Pair]:
    """Overlapping pairs of rooms and streets, registered at three voxel sizes."""
    import pointloom as loom

    scans = [scan for name in ("kitchen", "teaser", "frames", "clouds", "streets", "drives") for scan in _load(name)]
    by_name = {scan.name: scan for scan in scans}
    for kind, voxel in VOXELS.items():
        chosen = [scan for scan in scans if scan.kind == kind and not scan.name.startswith("kitchen frame")]
        found = [(a, b, T) for a, b, T, fraction in beliefs.overlapping(chosen, voxel) if fraction >= OVERLAP]
        for scene, a, b in WITHOUT_POSE if kind == "room" else ():
            source, target = by_name.get(f"{scene} {b}"), by_name.get(f"{scene} {a}")
            if source is not None and target is not None:
                clouds = (loom.PointCloud(scan.points) for scan in (source, target))
                T = loom.registration.register_globally(*clouds, voxel_size=voxel).transformation
                found.append((source, target, T))
        for source, target, T in found:
            name = f"{source.name} on {target.name}"
            poses = tuple(_refined(source, target, T, voxel))
            yield Pair(name, kind, source.points, target.points, poses, zlib.crc32(name.encode()) % 2 == 0)


def _load(name: str) -> Iterator[Scan]:
    from real_data import DataMissingError

    try:
        yield from getattr(belief_scenes, name)()
    except DataMissingError as error:
        print(f"left out {name}: {error}", file=sys.stderr)


def _refined(source: Scan, target: Scan, T: Array, voxel: float) -> Iterator[Array]:
    import pointloom as loom

    reg = loom.registration
    for finer in FINER:
        clouds = [
            loom.PointCloud(scan.points).voxel_down_sample(finer * voxel).estimate_normals(max_nn=20)
            for scan in (source, target)
        ]
        estimation = reg.TransformationEstimationForGeneralizedICP()
        yield reg.registration_icp(*clouds, 1.5 * voxel, T, estimation).transformation


def displaced(pair: Pair, what: str, amount: float) -> list[Array]:
    """The correct poses, or three of them moved in random directions: rotations about the center of the source."""
    if not amount:
        return list(pair.poses)
    rng = np.random.default_rng(zlib.crc32(f"{pair.name} {what}".encode()))
    poses = []
    for pose in pair.poses:
        direction = rng.normal(size=3)
        direction /= np.linalg.norm(direction)
        change = np.eye(4)
        if "turned" in what:
            rotation = real_scans.Rotation.from_rotvec(np.radians(amount) * direction).as_matrix()
            middle = pose[:3, :3] @ pair.source.mean(axis=0) + pose[:3, 3]
            change[:3, :3], change[:3, 3] = rotation, middle - rotation @ middle
        else:
            change[:3, 3] = amount * direction
        poses.append(change @ pose)
    return poses


class CorAl:
    """Mean difference of the joint and the separate entropies at the points of the overlap."""

    def __init__(self, pair: Pair) -> None:
        import pointloom as loom

        voxel = VOXELS[pair.kind]
        self.radius = 2 * voxel
        clouds = (loom.PointCloud(points).voxel_down_sample(0.5 * voxel) for points in (pair.source, pair.target))
        self.source, self.target = (cloud.points for cloud in clouds)

    def quality(self, pose: Array) -> float:
        """The measure at a pose, larger if displaced. Infinite without an overlap."""
        from scipy.spatial import cKDTree

        moved = self.source @ pose[:3, :3].T + pose[:3, 3]
        parts = moved, self.target
        trees = [cKDTree(points) for points in parts]
        differences = []
        for own, other in ((0, 1), (1, 0)):
            near = np.isfinite(trees[other].query(parts[own], distance_upper_bound=self.radius)[0])
            queries = parts[own][near][:: max(1, near.sum() // QUERIES)]
            for point in queries:
                separate = parts[own][trees[own].query_ball_point(point, self.radius)]
                across = parts[other][trees[other].query_ball_point(point, self.radius)]
                if len(separate) > 5:
                    differences.append(_entropy(np.vstack([separate, across])) - _entropy(separate))
        return float(np.mean(differences)) if differences else np.inf


def _entropy(points: Array) -> float:
    """Differential entropy of a normal distribution with the covariance of points, without constants."""
    return 0.5 * float(np.log(max(np.linalg.det(np.cov(points.T)), 1e-24)))


@dataclass(frozen=True)
class Answer:
    """`assess_registration` and CorAl on one pose."""

    pair: Pair
    what: str
    rejected: bool
    coral: float


def answers(chosen: Sequence[Pair], *, with_coral: bool) -> Iterator[Answer]:
    """All displacements of all pairs."""
    import pointloom as loom

    for number, pair in enumerate(chosen, 1):
        print(f"[{number}/{len(chosen)}] {pair.name}", file=sys.stderr, flush=True)
        source, target = loom.PointCloud(pair.source), loom.PointCloud(pair.target)
        baseline = CorAl(pair) if with_coral else None
        for what, amount in DISPLACEMENTS:
            for pose in displaced(pair, what, amount):
                found = loom.registration.assess_registration(source, target, pose, 1.5 * VOXELS[pair.kind])
                coral = np.nan if baseline is None else baseline.quality(pose)
                yield Answer(pair, what, not found.alignment.aligned, coral)


def judge() -> Iterator[Judged]:
    """Accepted displacements and rejected poses, of the pairs on which no constant was chosen."""
    chosen = [pair for pair in pairs() if not pair.is_fitted]
    rows = list(answers(chosen, with_coral=False))
    for (what, amount), kind in itertools.product(DISPLACEMENTS, VOXELS):
        mine = [row for row in rows if row.what == what and row.pair.kind == kind]
        accepted, rejected = (sum(row.rejected == refused for row in mine) for refused in (False, True))
        wrong = len(mine) if amount else 0
        case = f"{kind}s, {what}"
        area = "small displacement" if amount else "registered pose"
        yield Judged(area, case, len(mine), wrong, accepted if amount else 0, 0 if amount else rejected)


def table(rows: Sequence[Answer]) -> str:
    """Rejected poses of the pairs on which no constant was chosen."""
    lines = ["| pose | pointloom, rooms | streets | CorAl, rooms | streets |", "|---|---|---|---|---|"]
    limit = float(np.quantile([row.coral for row in rows if row.what == "correct"], 0.95))
    for what, _ in DISPLACEMENTS:
        cells = []
        for rejects in (lambda row: row.rejected, lambda row: row.coral > limit):
            for kind in VOXELS:
                mine = [row for row in rows if row.what == what and row.pair.kind == kind]
                cells.append(share_in_words(sum(map(rejects, mine)), len(mine)))
        lines.append(f"| {what} | {' | '.join(cells)} |")
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true", help="write the table into docs/trust.md")
    arguments = parser.parse_args()
    chosen = [pair for pair in pairs() if not pair.is_fitted]
    text = table(list(answers(chosen, with_coral=True)))
    print(text)
    if arguments.write:
        write_between(PAGE, "alignment", text)


if __name__ == "__main__":
    main()
