"""Curves of wrong results accepted against correct results rejected, for each decision about a registration.

    POINTLOOM_DATA=... python benchmarks/trust/run.py --only held-out-images --output images.jsonl
    POINTLOOM_DATA=... python benchmarks/trust/curves.py --scores images.jsonl --poses poses.jsonl [--write]

Three decisions: the score of a global search, the displacement of `assess_registration`, and `reliable` of ICP. The
scores are read from files that run.py wrote, of any area with registrations. The other two are computed on pairs of
trust/calibration.py from the seeds of surveys.HELD_OUT and stored in `--poses`, which is read if it exists. No constant
was chosen on any of these. `--write` draws docs/trust_curves.png, and writes its table into docs/trust.md.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

FOLDER = Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent)]

import calibration  # noqa: E402
import fit_assessment  # noqa: E402
from calibration import HELD_OUT, Pair  # noqa: E402
from judged import Judged, share_in_words  # noqa: E402
from pages import write_between  # noqa: E402

from pointloom.registration.evidence import compare_surfaces, witnesses_of  # noqa: E402
from pointloom.registration.rigid import to_local  # noqa: E402

Array = NDArray[np.float64]
DOCS = FOLDER.parent.parent / "docs"
PAIRS = 12  # of each kind of scene
SCORE, DISPLACEMENT, ICP = "score of a global search", "displacement of a pose", "reliability of ICP"
QUANTITIES = {SCORE: "limit of the score", DISPLACEMENT: "limit of the displacement", ICP: "limit of the agreement"}
UNSUPPORTED = 1e3  # [voxels] displacement of a pose without enough matches
SMALL = ("shifted by 0.5 voxels", "shifted by 2 voxels", "rotated by 2 degrees")  # wrong poses of the displacement


@dataclass(frozen=True)
class Case:
    """A decision about one pose. `value`: the quantity with a limit, larger for better poses."""

    decision: str
    is_right: bool
    value: float
    accepted: bool


def scored(paths: Sequence[Path]) -> Iterator[Case]:
    """The searches in files of run.py."""
    for path in paths:
        for line in path.read_text().splitlines():
            found = Judged(**json.loads(line))
            if found.area.startswith("registration") and found.error.startswith("score "):
                accepted = not found.right_refused if not found.wrong else bool(found.wrong_believed)
                yield Case(SCORE, not found.wrong, float(found.error.removeprefix("score ")), accepted)


def posed(count: int) -> Iterator[Case]:
    """Displacements and ICP results of `count` held-out pairs of each kind of scene."""
    import pointloom as loom

    for kind, make in calibration.KINDS.items():
        before: Array | None = None
        for number, pair in enumerate(make(range(HELD_OUT, HELD_OUT + count)), 1):
            print(f"{kind} {number}", file=sys.stderr, flush=True)
            target = loom.PointCloud(pair.target)
            for what, is_right, points, T in fit_assessment.poses(pair, before):
                source = loom.PointCloud(points)
                if what in ("registered", *SMALL):
                    found = loom.registration.assess_registration(source, target, T, 1.5 * pair.voxel)
                    alignment, is_small = found.alignment, bool(found.notes)
                    value = alignment.displacement / pair.voxel if alignment.is_supported else UNSUPPORTED
                    yield Case(DISPLACEMENT, is_right, -value, alignment.aligned or is_small)
                if not what.endswith("then ICP") or "another" in what:
                    yield _refined(source, target, T, pair, is_other_place="another" in what)
            before = None if kind in fit_assessment.SAME_PLACE else pair.source


def _refined(source: object, target: object, start: Array, pair: Pair, *, is_other_place: bool) -> Case:
    """Reliability of ICP from a start, with the agreement of all matches, the main part of the check."""
    import pointloom as loom

    plane = loom.registration.TransformationEstimationPointToPlane()
    left, right = (cloud.voxel_down_sample(pair.voxel).estimate_normals(max_nn=20) for cloud in (source, target))  # type: ignore[attr-defined]
    result = loom.registration.registration_icp(left, right, 1.5 * pair.voxel, start, plane)
    middle = np.append(pair.source.mean(axis=0), 1)
    is_right = not is_other_place and bool(np.linalg.norm((result.transformation - pair.T)[:3] @ middle) < pair.voxel)
    a, b = (witness.surface for witness in witnesses_of((left, right), 1.5 * pair.voxel))
    pose = to_local(result.transformation, left.origin, right.origin)
    return Case(ICP, is_right, compare_surfaces(a, b, pose, 1.5 * pair.voxel).score_with_planes, result.reliable)


def curve(cases: Sequence[Case]) -> tuple[Array, Array]:
    """Rates of correct cases rejected and of wrong ones accepted, for each limit of the value."""
    right = np.sort([case.value for case in cases if case.is_right])
    wrong = np.sort([case.value for case in cases if not case.is_right])
    limits = np.concatenate([[-np.inf], np.unique(np.concatenate([right, wrong])), [np.inf]])
    rejected = np.searchsorted(right, limits, side="right") / max(len(right), 1)
    accepted = 1 - np.searchsorted(wrong, limits, side="right") / max(len(wrong), 1)
    return rejected, accepted


def draw(cases: Sequence[Case], path: Path) -> None:
    """One panel for each decision."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(12, 4), layout="constrained")
    for axes, decision in zip(figure.subplots(1, len(QUANTITIES)), QUANTITIES, strict=True):
        mine = [case for case in cases if case.decision == decision]
        rejected, accepted = curve(mine)
        axes.step(
            100 * rejected, 100 * accepted, where="post", color="tab:blue", label=f"for each {QUANTITIES[decision]}"
        )
        x, y = (100 * np.mean(rates) if rates else 0.0 for rates in _errors(mine))
        axes.plot([x], [y], "o", color="tab:red", label=f"in use: {x:.1f} % and {y:.1f} %")
        right = sum(case.is_right for case in mine)
        axes.set_title(f"{decision}\n{right:,} correct and {len(mine) - right:,} wrong results")
        axes.set(xlabel="correct results rejected [%]", ylabel="wrong results accepted [%]", xlim=(-1, 60))
        axes.set_yscale("symlog", linthresh=1)
        axes.set_ylim(-0.05, 100)
        axes.set_yticks([0, 1, 10, 100], ["0", "1", "10", "100"])
        axes.grid(alpha=0.3)
        axes.legend(loc="upper right", fontsize=8)
    figure.savefig(path, dpi=100)


def _errors(cases: Sequence[Case]) -> tuple[list[bool], list[bool]]:
    """For each correct case whether it was rejected, and for each wrong one whether it was accepted."""
    return [not c.accepted for c in cases if c.is_right], [c.accepted for c in cases if not c.is_right]


def table(cases: Sequence[Case]) -> list[str]:
    """Rows of Markdown: the operating points, and the limits that reject 5% of the correct results."""
    lines = ["| decision | wrong accepted | correct rejected | wrong accepted if 5% of the correct were rejected |"]
    lines.append("|---|---|---|---|")
    for decision in QUANTITIES:
        mine = [case for case in cases if case.decision == decision]
        refused, passed = _errors(mine)
        rejected, accepted = curve(mine)
        at_five = accepted[max(int(np.searchsorted(rejected, 0.05, side="right")) - 1, 0)]
        cells = share_in_words(sum(passed), len(passed)), share_in_words(sum(refused), len(refused))
        lines.append(f"| {decision} | {' | '.join(cells)} | {100 * at_five:.1f} % |")
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scores", type=Path, action="append", default=[], help="a file of run.py --output")
    parser.add_argument("--poses", type=Path, required=True, help="displacements and ICP results, computed if missing")
    parser.add_argument("--pairs", type=int, default=PAIRS, help="of each kind of scene")
    parser.add_argument("--write", action="store_true", help="write docs/trust_curves.png and its table")
    arguments = parser.parse_args()
    if not arguments.poses.exists():
        with arguments.poses.open("w") as lines:
            for case in posed(arguments.pairs):
                lines.write(json.dumps(asdict(case)) + "\n")
                lines.flush()
    cases = [Case(**json.loads(line)) for line in arguments.poses.read_text().splitlines()]
    cases += scored(arguments.scores)
    print("\n".join(table(cases)))
    if arguments.write:
        draw(cases, DOCS / "trust_curves.png")
        write_between(DOCS / "trust.md", "curves", "\n".join(table(cases)))


if __name__ == "__main__":
    main()
