"""Fit the constants of `assess_registration`, and measure its error rates.

    POINTLOOM_DATA=... python benchmarks/trust/fit_assessment.py [--pairs 12] [--write]

Poses of the pairs of trust/calibration.py: registered from the true pose, displaced, slid along streets, and of clouds
of another place. Seeds from 0 are for the fit, those from surveys.HELD_OUT are held out. Two fits are made:
the log odds of all matches, by a logistic regression on the fraction and the firmness of the evidence, and the limit of
the displacement. Prints the constants in use with their sources, both fits, and the rates. `--write` writes the table
of constants and the rates into docs/assessment.md. The other constants are not fitted again.
"""

from __future__ import annotations

import argparse
import datetime
import sys
import typing
import zlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

FOLDER = Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent)]

import calibration  # noqa: E402
from calibration import FITTED, HELD_OUT, Pair  # noqa: E402
from judged import share_in_words  # noqa: E402
from pages import write_between  # noqa: E402
from real_scans import Rotation  # noqa: E402

from pointloom.registration import assessment_constants as constants  # noqa: E402
from pointloom.registration.assessment import RegistrationAssessment  # noqa: E402

Array = NDArray[np.float64]
PAGE = FOLDER.parent.parent / "docs" / "assessment.md"
PAIRS = 12  # of each kind of scene
DISPLACED = {  # voxels, degrees
    "shifted by 0.5 voxels": (0.5, 0.0),
    "shifted by 2 voxels": (2.0, 0.0),
    "shifted by 6 voxels": (6.0, 0.0),
    "rotated by 2 degrees": (0.0, 2.0),
    "rotated by 10 degrees": (0.0, 10.0),
}
SLIDE = 3.3  # [m] along the street or the tunnel
SLID = 2.0  # [voxels] minimum displacement of a pose that slid, after ICP
ODDS = ("FRACTION_WEIGHT", "FIRMNESS_WEIGHT", "ODDS_BIAS")
SAME_PLACE = ("halves of real scans",)  # most show one kitchen, so that a cloud of another pair may match rightly
WITHIN = ("shifted by 0.5 voxels", "rotated by 2 degrees")  # the score refines these poses
RIDGE = 1e-3  # of the regression, for features that separate the poses


@dataclass(frozen=True)
class Row:
    """One assessed pose. `is_right`: within a voxel of the true pose."""

    kind: str
    what: str
    is_right: bool
    found: RegistrationAssessment


def assessed(first: int, count: int) -> Iterator[Row]:
    """The poses of `count` pairs of each kind of scene, from a first seed."""
    import pointloom as loom

    for kind, make in calibration.KINDS.items():
        before: Array | None = None
        for number, pair in enumerate(make(range(first, first + count)), 1):
            print(f"{kind} {number}", file=sys.stderr, flush=True)
            target = loom.PointCloud(pair.target)
            for what, is_right, source, T in poses(pair, before):
                distance = 1.5 * pair.voxel
                found = loom.registration.assess_registration(loom.PointCloud(source), target, T, distance)
                yield Row(kind, what, is_right, found)
            before = None if kind in SAME_PLACE else pair.source


def poses(pair: Pair, other: Array | None) -> Iterator[tuple[str, bool, Array, Array]]:
    """Poses of a pair and of a cloud of another place, with their source. None if the pair hardly overlaps."""
    middle = np.append(pair.source.mean(axis=0), 1)
    T, fitness = refined(pair.source, pair, pair.T, 1.5)
    if fitness < calibration.MIN_FITNESS:
        return
    yield "registered", bool(np.linalg.norm((T - pair.T)[:3] @ middle) < pair.voxel), pair.source, T
    for what, (voxels, degrees) in DISPLACED.items():
        rng = np.random.default_rng(zlib.crc32(pair.source[:8].tobytes() + what.encode()))
        direction, change = rng.normal(size=3), np.eye(4)
        direction /= np.linalg.norm(direction)
        change[:3, :3] = Rotation.from_rotvec(np.radians(degrees) * direction).as_matrix()
        center = (T @ middle)[:3]
        change[:3, 3] = center - change[:3, :3] @ center + voxels * pair.voxel * direction
        yield what, False, pair.source, change @ T
    if pair.kind in ("streets", "sites"):
        start = T.copy()
        start[0, 3] += SLIDE
        slid, _ = refined(pair.source, pair, start, 1.5)
        if np.linalg.norm((slid - T)[:3] @ middle) > SLID * pair.voxel:
            yield f"slid by {SLIDE} m, then ICP", False, pair.source, slid
    if other is not None:
        yield "another place, then ICP", False, other, refined(other, pair, pair.T, 3.0)[0]


def refined(source: Array, pair: Pair, start: Array, voxels: float) -> tuple[Array, float]:
    """The pose of point-to-plane ICP, and its fitness."""
    import pointloom as loom

    left, right = (
        loom.PointCloud(points).voxel_down_sample(pair.voxel).estimate_normals(max_nn=20)
        for points in (source, pair.target)
    )
    plane = loom.registration.TransformationEstimationPointToPlane()
    result = loom.registration.registration_icp(left, right, voxels * pair.voxel, start, plane)
    return result.transformation, result.fitness


def fit_odds(rows: Sequence[Row]) -> Array:
    """Weights of ln(share) and ln(firmness), and the offset, of a logistic regression of right and wrong poses."""
    known = [row for row in rows if row.found.evidence.matches and row.what not in WITHIN]
    evidence = [row.found.evidence for row in known]
    fractions = np.log([e.fraction + constants.FRACTION_FLOOR for e in evidence])
    firmness = np.log([e.firmness + constants.FIRMNESS_FLOOR for e in evidence])
    X, y = np.column_stack([fractions, firmness, np.ones(len(known))]), np.array([float(r.is_right) for r in known])
    weights = np.zeros(3)
    for _ in range(50):  # Newton
        p = 1 / (1 + np.exp(-X @ weights))
        hessian = (X.T * (p * (1 - p))) @ X + RIDGE * np.eye(3)
        weights += np.linalg.solve(hessian, X.T @ (y - p) - RIDGE * weights)
    return weights


def fit_displacement(rows: Sequence[Row]) -> tuple[float, float]:
    """Limits of the displacement [voxels]: of 95 % of the right poses, and of all poses shifted by half a voxel."""

    def detected(what: str) -> list[float]:
        return [
            row.found.alignment.displacement * constants.MATCH_VOXELS / row.found.max_correspondence_distance
            for row in rows
            if row.what == what and row.found.alignment.is_supported and not row.found.alignment.aligned
        ]

    return float(np.quantile(detected("registered"), 0.95)), min(detected("shifted by 0.5 voxels"))


def rates(rows: Sequence[Row]) -> list[str]:
    """Rows of Markdown: poses accepted by each part and by the assessment."""
    parts: dict[str, Callable[[RegistrationAssessment], bool]] = {
        "score": lambda found: found.score > constants.MIN_SCORE,
        "no displacement detected": lambda found: found.alignment.aligned,
        "all motions determined": lambda found: found.localizability.reliable,
        "reliable": lambda found: found.reliable,
    }
    lines = [f"| pose | {' | '.join(parts)} |", "|---" * (len(parts) + 1) + "|"]
    for what in dict.fromkeys(row.what for row in rows):
        mine = [row.found for row in rows if row.what == what]
        cells = (share_in_words(sum(map(accepts, mine)), len(mine)) for accepts in parts.values())
        lines.append(f"| {what} | {' | '.join(cells)} |")
    return lines


def constants_table() -> list[str]:
    """Rows of Markdown: the constants in use."""
    lines = ["| constant | value | quantity | unit | source |", "|---|---|---|---|---|"]
    for name, hint in typing.get_type_hints(constants, include_extras=True).items():
        about = hint.__metadata__[0]
        lines.append(f"| `{name}` | {getattr(constants, name):g} | {about.quantity} | {about.unit} | {about.source} |")
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pairs", type=int, default=PAIRS, help="of each kind of scene, fitted and held out")
    parser.add_argument(
        "--write", action="store_true", help="write the constants and the rates into docs/assessment.md"
    )
    arguments = parser.parse_args()
    fitted, held_out = (list(assessed(first, arguments.pairs)) for first in (FITTED, HELD_OUT))
    table, found = constants_table(), rates(held_out)
    print(
        datetime.date.today(),
        "\n".join(["constants", *table, "rates, fitted", *rates(fitted), "held out", *found]),
        sep="\n",
    )
    print(
        "displacement [voxels]: right, 95 %, {:.3f}; shifted by half a voxel, least, {:.3f}".format(
            *fit_displacement(fitted)
        )
    )
    weights = fit_odds(fitted)
    print("log odds refitted:", ", ".join(f"{name} {w:.3g}" for name, w in zip(ODDS, weights, strict=True)))
    for name, weight in zip(ODDS, weights.tolist(), strict=True):
        setattr(constants, name, weight)
    print("\n".join(["rates with these, held out", *rates(held_out)]))
    if arguments.write:
        write_between(PAGE, "constants", "\n".join(table))
        write_between(PAGE, "rates", "\n".join(found))


if __name__ == "__main__":
    main()
