"""Convergence basin of ICP: success rates over random starting poses, beside Open3D, as curves and a table.

    POINTLOOM_DATA=... python benchmarks/success.py [--trials 40] [--write]

The source is at its true pose, rotated about its center by a given angle about random axes; ICP starts from there. It
succeeds if it ends within 1 degree and one voxel of the result of the same method started at the true pose. All
trials of
a method run at once in `registration_icp_batch`. Global methods get random poses or seeds as in real_pairs.py, and
succeed
within 5 degrees and 3 voxels of the ground truth.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import real_methods as methods
import real_scans as scans
from contest import POINTLOOM, load_open3d
from numpy.typing import NDArray
from pages import write_between
from real_pairs import PAGE, STILL, keep, measure
from real_scans import Array, ScanPair

IMAGE = PAGE.with_name("success.png")
ANGLES = tuple(range(0, 181, 15))  # [degrees]
MAX_VOXELS = 4.0  # [voxels] maximum correspondence distance of ICP
HOME = 1.0, 1.0  # [degrees] and, at the center of the source, [voxels]
SURE = 0.9  # success rate for the angle in the table
LEVEL_GAP = 2.0  # [%] between lines of methods with 100 % success
LINES = {"register_globally": "black", "RANSAC": "tab:brown", "FGR": "tab:pink"}
CURVES = {
    "symmetric ICP": "tab:green",
    "generalized ICP": "tab:red",
    "point-to-plane ICP": "tab:orange",
    "point-to-point ICP": "tab:blue",
}


@dataclass(frozen=True)
class Curve:
    """Success rates of a method on a pair.

    Attributes:
        pair, method, library: Names.
        fractions: Success rates by angle; one value for a global method.
        trials: Number of trials of each.
    """

    pair: str
    method: str
    library: str
    fractions: list[float]
    trials: int

    def cell(self) -> str:
        """The largest angle with a success rate of 90 %, and the mean rate; or the number of successes."""
        if len(self.fractions) == 1:
            return f"{round(self.fractions[0] * self.trials)} of {self.trials}"
        sure = int(np.argmin([*(fraction >= SURE for fraction in self.fractions), False]))
        limit = f"{ANGLES[sure - 1]}°" if sure else "none"
        return f"{limit}, {np.mean(self.fractions):.0%}"


def rotated(pair: ScanPair, trials: int, seed: int = 0) -> Array:
    """Starting poses [angles, trials, 4, 4]: the ground truth after a rotation about the source's center."""
    rng = np.random.default_rng(seed)
    axes = rng.normal(size=(trials, 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    middle = pair.source.mean(axis=0)
    poses = np.empty((len(ANGLES), trials, 4, 4))
    for i, angle in enumerate(ANGLES):
        for k, axis in enumerate(axes):
            rotation = scans.Rotation.from_rotvec(np.radians(angle) * axis)
            poses[i, k] = pair.T @ scans.pose_of(rotation, middle - rotation.as_matrix() @ middle)
    return poses


def thinned(pair: ScanPair) -> ScanPair:
    """The pair down-sampled, with the matching correspondence distance."""
    import pointloom as loom

    clouds = [
        loom.PointCloud(points).voxel_down_sample(pair.voxel_size).points for points in (pair.source, pair.target)
    ]
    return replace(pair, source=clouds[0], target=clouds[1], fine=0.0, distance=MAX_VOXELS * pair.voxel_size)


def our_poses(pair: ScanPair, name: str, starts: Array) -> Array:
    """Final poses of ICP from each start, all in the same launches."""
    import pointloom as loom

    reg = loom.registration
    rules = reg.ICPConvergenceCriteria(methods.CHANGE, methods.CHANGE, methods.STEPS)
    source, target = methods.our_clouds(pair)
    results = reg.registration_icp_batch(source, target, pair.distance, starts, methods.estimators()[name], rules)
    return np.array([result.transformation for result in results])


def open3d_poses(pair: ScanPair, name: str, starts: Array) -> Array:
    """The same with Open3D, sequentially, with pointloom's normals."""
    o3d = load_open3d()
    registration = o3d.pipelines.registration
    clouds = [cloud.to_open3d() for cloud in methods.our_clouds(pair)]
    rules = registration.ICPConvergenceCriteria(methods.CHANGE, methods.CHANGE, methods.STEPS)
    run, kind = {
        "point-to-point ICP": (registration.registration_icp, registration.TransformationEstimationPointToPoint),
        "point-to-plane ICP": (registration.registration_icp, registration.TransformationEstimationPointToPlane),
        "generalized ICP": (
            registration.registration_generalized_icp,
            registration.TransformationEstimationForGeneralizedICP,
        ),
    }[name]
    method = kind()
    return np.array([run(*clouds, pair.distance, start, method, rules).transformation for start in starts])


def is_home(pair: ScanPair, poses: Array, rest: Array) -> NDArray[np.bool_]:
    """True for poses [n, 4, 4] near another pose."""
    relative = poses[:, :3, :3] @ rest[:3, :3].T
    angles = scans.Rotation.from_matrix(relative).magnitude()
    shifts = np.linalg.norm((poses - rest)[:, :3] @ np.append(pair.source.mean(axis=0), 1), axis=1)
    return (np.degrees(angles) < HOME[0]) & (shifts < HOME[1] * pair.voxel_size)


def score(key: str, trials: int) -> list[Curve]:
    """All methods on one pair."""
    pair = scans.PAIRS[key]()
    few, starts = thinned(pair), rotated(pair, trials)
    jobs = np.concatenate([pair.T[None], starts.reshape(-1, 4, 4)])
    curves = []
    for name in CURVES:
        for library, run in ((POINTLOOM, our_poses), ("Open3D", open3d_poses)):
            if name == "symmetric ICP" and library != POINTLOOM:
                continue
            poses_found = run(few, name, jobs)
            home = is_home(pair, poses_found[1:], poses_found[0]).reshape(len(ANGLES), trials)
            curves.append(Curve(pair.name, name, library, home.mean(axis=1).tolist(), trials))
    for method in (methods.GLOBALLY, *methods.BY_LOT):
        poses = scans.random_poses(trials, pair.spread) if method is methods.GLOBALLY else [STILL] * trials
        counts = measure(method, "no guess", "", [(pair, T, STILL, k) for k, T in enumerate(poses)])
        curves.append(Curve(pair.name, method.name, method.library, [counts.right / trials], trials))
    return curves


def table(curves: Sequence[Curve]) -> str:
    """Markdown: a row for each method and library, a column for each pair."""
    pairs = list(dict.fromkeys(curve.pair for curve in curves))
    cells = {(curve.method, curve.library, curve.pair): curve.cell() for curve in curves}
    lines = [f"| method | library | {' | '.join(pairs)} |", "|---" * (2 + len(pairs)) + "|"]
    before = ""
    for method, library in dict.fromkeys((curve.method, curve.library) for curve in curves):
        shown = [cells[method, library, pair] for pair in pairs]
        lines.append(f"| {' | '.join(['' if method == before else method, library, *shown])} |")
        before = method
    return "\n".join(lines)


def draw(curves: Sequence[Curve], path: Path) -> None:
    """Plot the curves: pointloom solid, Open3D dashed; global methods as horizontal lines, offset if equal."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    pairs = list(dict.fromkeys(curve.pair for curve in curves))
    size = (4.6 * len(pairs), 4.6)
    figure, panels = pyplot.subplots(1, len(pairs), figsize=size, sharey=True, squeeze=False, layout="constrained")
    for panel, name in zip(panels[0], pairs, strict=True):
        levels = 0
        for curve in (c for c in curves if c.pair == name):
            style = "-" if curve.library == POINTLOOM else "--"
            label = f"{curve.method}, {curve.library}"
            if len(curve.fractions) > 1:
                percent = [100 * fraction for fraction in curve.fractions]
                panel.plot(ANGLES, percent, style, color=CURVES[curve.method], label=label, linewidth=1.8)
            else:
                percent = 2 * [100 * curve.fractions[0] + LEVEL_GAP * levels]
                panel.plot([0, 180], percent, style, color=LINES[curve.method], label=label, linewidth=1.4)
                levels += 1
        top = 102 + LEVEL_GAP * levels
        panel.set(title=name, xlabel="rotated by [degrees]", xlim=(0, 180), ylim=(-3, top), xticks=range(0, 181, 30))
        panel.grid(alpha=0.3)
    panels[0, 0].set_ylabel("found home [%]")
    handles, labels = panels[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=4, fontsize=8, frameon=False)
    figure.savefig(path, dpi=110)


def main() -> None:
    """Print the table; plot and save it."""
    parser = argparse.ArgumentParser(description="Success of registration over starting poses.")
    parser.add_argument("--trials", type=int, default=40, help="starting poses per angle")
    parser.add_argument("--only", action="append", choices=list(scans.PAIRS))
    parser.add_argument("--picture", type=Path, help=".png file of the plot")
    parser.add_argument(
        "--write", action="store_true", help="write docs/registration.md, docs/success.png and the JSON file"
    )
    options = parser.parse_args()
    curves = [curve for key in options.only or ("bunny", "lidar", "kitchen") for curve in score(key, options.trials)]
    print(table(curves))
    if options.image:
        draw(curves, options.image)
    if options.write:
        draw(curves, IMAGE)
        keep("success", {"angles": ANGLES, "curves": [vars(curve) for curve in curves]})
        write_between(PAGE, "success", table(curves))


if __name__ == "__main__":
    main()
