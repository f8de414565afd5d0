"""From how far ICP finds home: success over random starting poses, ours beside Open3D's, as curves and a table.

    POINTLOOM_DATA=... python benchmarks/success.py [--trials 40] [--write]

The source stands where it belongs, turned about its middle by a given angle about random axes; ICP begins at the
identity of that. It succeeds where it ends within 1 degree and one voxel of where the same method ends that begins at
the true pose. All of a method's trials run at once in `registration_icp_batch`. Methods that need no starting pose get
random poses or seeds as in real_pairs.py, and succeed within 5 degrees and 3 voxels of the truth.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import real_methods as methods
import real_scans as scans
from contest import OURS, load_open3d
from numpy.typing import NDArray
from pages import write_between
from real_pairs import PAGE, STILL, keep, measure
from real_scans import Array, ScanPair

PICTURE = PAGE.with_name("success.png")
ANGLES = tuple(range(0, 181, 15))  # [degrees]
REACH = 4.0  # [voxels] of a correspondence of ICP
HOME = 1.0, 1.0  # [degrees] and, at the middle of the source, [voxels]
SURE = 0.9  # share of successes that is asked for where one number is wanted
LEVEL_GAP = 2.0  # [%] between lines of methods that all succeed
LINES = {"register_globally": "black", "RANSAC": "tab:brown", "FGR": "tab:pink"}
CURVES = {
    "symmetric ICP": "tab:green",
    "generalized ICP": "tab:red",
    "point-to-plane ICP": "tab:orange",
    "point-to-point ICP": "tab:blue",
}


@dataclass(frozen=True)
class Curve:
    """A method's success on a pair.

    Attributes:
        pair, method, library: Which.
        shares: Of successes, by angle; of a method from no guess one.
        trials: Of each.
    """

    pair: str
    method: str
    library: str
    shares: list[float]
    trials: int

    def cell(self) -> str:
        """The widest angle up to which nine in ten succeed and the share of all; or how many succeed."""
        if len(self.shares) == 1:
            return f"{round(self.shares[0] * self.trials)} of {self.trials}"
        sure = int(np.argmin([*(share >= SURE for share in self.shares), False]))
        reach = f"{ANGLES[sure - 1]}°" if sure else "none"
        return f"{reach}, {np.mean(self.shares):.0%}"


def turned(pair: ScanPair, trials: int, seed: int = 0) -> Array:
    """Poses to begin from, [angles, trials, 4, 4]: the truth after a turn about the source's middle."""
    rng = np.random.default_rng(seed)
    axes = rng.normal(size=(trials, 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    middle = pair.source.mean(axis=0)
    poses = np.empty((len(ANGLES), trials, 4, 4))
    for i, angle in enumerate(ANGLES):
        for k, axis in enumerate(axes):
            turn = scans.Rotation.from_rotvec(np.radians(angle) * axis)
            poses[i, k] = pair.T @ scans.pose_of(turn, middle - turn.as_matrix() @ middle)
    return poses


def thinned(pair: ScanPair) -> ScanPair:
    """The pair's voxels, and the distance of correspondences that goes with them."""
    import pointloom as loom

    clouds = [
        loom.PointCloud(points).voxel_down_sample(pair.voxel_size).points for points in (pair.source, pair.target)
    ]
    return replace(pair, source=clouds[0], target=clouds[1], fine=0.0, distance=REACH * pair.voxel_size)


def our_poses(pair: ScanPair, name: str, starts: Array) -> Array:
    """Where ICP ends from each start, all in the same launches."""
    import pointloom as loom

    reg = loom.registration
    rules = reg.ICPConvergenceCriteria(methods.CHANGE, methods.CHANGE, methods.STEPS)
    source, target = methods.our_clouds(pair)
    found = reg.registration_icp_batch(source, target, pair.distance, starts, methods.estimators()[name], rules)
    return np.array([result.transformation for result in found])


def open3d_poses(pair: ScanPair, name: str, starts: Array) -> Array:
    """The same of Open3D, one after the other, with our normals."""
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


def is_home(pair: ScanPair, found: Array, rest: Array) -> NDArray[np.bool_]:
    """Which poses [n, 4, 4] are near another."""
    relative = found[:, :3, :3] @ rest[:3, :3].T
    angles = scans.Rotation.from_matrix(relative).magnitude()
    shifts = np.linalg.norm((found - rest)[:, :3] @ np.append(pair.source.mean(axis=0), 1), axis=1)
    return (np.degrees(angles) < HOME[0]) & (shifts < HOME[1] * pair.voxel_size)


def score(key: str, trials: int) -> list[Curve]:
    """All methods on one pair."""
    pair = scans.PAIRS[key]()
    few, starts = thinned(pair), turned(pair, trials)
    jobs = np.concatenate([pair.T[None], starts.reshape(-1, 4, 4)])
    curves = []
    for name in CURVES:
        for library, run in ((OURS, our_poses), ("Open3D", open3d_poses)):
            if name == "symmetric ICP" and library != OURS:
                continue
            ends = run(few, name, jobs)
            home = is_home(pair, ends[1:], ends[0]).reshape(len(ANGLES), trials)
            curves.append(Curve(pair.name, name, library, home.mean(axis=1).tolist(), trials))
    for method in (methods.GLOBALLY, *methods.BY_LOT):
        poses = scans.random_poses(trials, pair.spread) if method is methods.GLOBALLY else [STILL] * trials
        found = measure(method, "no guess", "", [(pair, T, STILL, k) for k, T in enumerate(poses)])
        curves.append(Curve(pair.name, method.name, method.library, [found.right / trials], trials))
    return curves


def table(curves: Sequence[Curve]) -> str:
    """Markdown: a row a method and library, a column a pair."""
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
    """The curves: ours solid, Open3D's dashed; methods without a starting pose level, side by side where alike."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    pairs = list(dict.fromkeys(curve.pair for curve in curves))
    size = (4.6 * len(pairs), 4.6)
    figure, panels = pyplot.subplots(1, len(pairs), figsize=size, sharey=True, squeeze=False, layout="constrained")
    for panel, name in zip(panels[0], pairs, strict=True):
        levels = 0
        for curve in (c for c in curves if c.pair == name):
            style = "-" if curve.library == OURS else "--"
            label = f"{curve.method}, {curve.library}"
            if len(curve.shares) > 1:
                percent = [100 * share for share in curve.shares]
                panel.plot(ANGLES, percent, style, color=CURVES[curve.method], label=label, linewidth=1.8)
            else:
                percent = 2 * [100 * curve.shares[0] + LEVEL_GAP * levels]
                panel.plot([0, 180], percent, style, color=LINES[curve.method], label=label, linewidth=1.4)
                levels += 1
        top = 102 + LEVEL_GAP * levels
        panel.set(title=name, xlabel="turned by [degrees]", xlim=(0, 180), ylim=(-3, top), xticks=range(0, 181, 30))
        panel.grid(alpha=0.3)
    panels[0, 0].set_ylabel("found home [%]")
    handles, labels = panels[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=4, fontsize=8, frameon=False)
    figure.savefig(path, dpi=110)


def main() -> None:
    """Print the table; draw and keep it."""
    parser = argparse.ArgumentParser(description="Success of registration over starting poses.")
    parser.add_argument("--trials", type=int, default=40, help="starting poses an angle")
    parser.add_argument("--only", action="append", choices=list(scans.PAIRS))
    parser.add_argument("--picture", type=Path, help="a .png file to draw")
    parser.add_argument("--write", action="store_true", help="write docs/registration.md, docs/success.png, the JSON")
    options = parser.parse_args()
    curves = [curve for key in options.only or ("bunny", "lidar", "kitchen") for curve in score(key, options.trials)]
    print(table(curves))
    if options.picture:
        draw(curves, options.picture)
    if options.write:
        draw(curves, PICTURE)
        keep("success", {"angles": ANGLES, "curves": [vars(curve) for curve in curves]})
        write_between(PAGE, "success", table(curves))


if __name__ == "__main__":
    main()
