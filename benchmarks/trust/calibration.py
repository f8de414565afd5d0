"""Coverage of the covariances of pairs, stations and fragments: errors of poses beside their standard deviations.

    POINTLOOM_DATA=... python benchmarks/trust/calibration.py [--fitted] [--pairs 60] [--only drives] [--write]

ICP starts near the true pose. The error is divided by the standard deviations along the six eigenvectors of the
covariance. Of a calibrated covariance 68 % of these components are within 1, and 95 % within 2. The scenes of
`--fitted` are for choosing constants, other seeds and clouds are held out.
"""

from __future__ import annotations

import argparse
import sys
import zlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

FOLDER = Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent)]

import box_rooms  # noqa: E402
import drives  # noqa: E402
import frame_errors  # noqa: E402
import made_rooms  # noqa: E402
import places  # noqa: E402
import recordings  # noqa: E402
import sensor_pairs  # noqa: E402
import street  # noqa: E402
import surveys  # noqa: E402
from judged import share_in_words  # noqa: E402
from pages import text_between, write_between  # noqa: E402
from real_scans import Rotation  # noqa: E402
from run import merged  # noqa: E402
from surveys import HELD_OUT  # noqa: E402

Array = NDArray[np.float64]
PAGE = FOLDER.parent.parent / "docs" / "trust.md"
FITTED = 0  # first seed
PAIRS = 56  # of each kind: 336 components
PAIRS_OF_WALK = 28  # pairs for which one walk through each kind of site is tracked
SURVEYS = {"courtyards": 24, "sites": 18, "parts of real scans": 24}
SITES = ("hall", "forest", "outdoors", "tunnel")
OPERATIONS = ("point-to-plane", "generalized")
MIN_FITNESS = 0.1  # pairs below hardly overlap and are left out
TURN, SHIFT = 0.2, 0.2  # standard deviations of the initial error [degrees], [voxels]


@dataclass(frozen=True)
class Pair:
    """Two scans in their own frames [m], the true T_target_source, and the voxel size of the registration [m]."""

    kind: str
    source: Array
    target: Array
    T: Array
    voxel: float


def rooms(seeds: range) -> Iterator[Pair]:
    """Parts of rooms of boxes by a depth camera with the noise of a Kinect."""
    for seed in seeds:
        (source, a), (target, b) = box_rooms.fragments(seed, (0.0, 40.0))
        yield Pair("rooms", source, target, np.linalg.inv(b) @ a, 0.05)


def sites(seeds: range) -> Iterator[Pair]:
    """Scans of halls, woods, open ground and tunnels by a spinning LiDAR, up to 3 m apart, 1 cm noise."""
    import pointloom as loom

    for seed in seeds:
        site = places.KINDS[SITES[seed % len(SITES)]](seed)
        scene = loom.RaycastingScene()
        scene.add_triangles(site.vertices.astype(np.float32), site.triangles.astype(np.uint32))
        rng, scans, along = np.random.default_rng([seed, 77]), [], np.random.default_rng([seed, 78]).uniform(-8, 4)
        for k in range(2):
            T = np.eye(4)
            T[:3, :3] = Rotation.from_euler("z", rng.uniform(-0.3, 0.3)).as_matrix()
            T[:3, 3] = [along + 3 * k * rng.uniform(0.5, 1), rng.uniform(-0.7, 0.7), 1.5 + rng.uniform(-0.1, 0.2)]
            rays, _ = street.rotating_rays(np.linspace(-0.87, 0.87, 40) + rng.uniform(0, 0.04), 600, rng)
            lines = np.concatenate([np.broadcast_to(T[:3, 3], rays.shape), rays @ T[:3, :3].T], 1)
            distances = np.asarray(scene.cast_rays(lines.astype(np.float32))["t_hit"], float)
            scans.append((_measured(rays, distances, 0.01, 40.0, rng), T))
        (source, a), (target, b) = scans
        yield Pair("sites", source, target, np.linalg.inv(b) @ a, 0.2)


def streets(seeds: range) -> Iterator[Pair]:
    """Scans of synthetic streets by a spinning LiDAR, up to 5 m apart, 2 cm noise."""
    for seed in seeds:
        rng, scans = np.random.default_rng([seed, 79]), []
        made, along = street.make_street(40, seed), rng.uniform(0, 25)
        for k in range(2):
            T = street.sensor_pose(along + k * rng.uniform(1, 5), 0.1)
            rays, _ = street.rotating_rays(np.radians(np.linspace(-22, 4, 32)), 900, rng)
            distances = street.cast_rays(made, np.repeat(T[None, :3, 3], len(rays), 0), rays @ T[:3, :3].T)
            scans.append((_measured(rays, distances, 0.02, street.MAX_RANGE, rng), T))
        (source, a), (target, b) = scans
        yield Pair("streets", source, target, np.linalg.inv(b) @ a, 0.5)


def parts_of_real(seeds: range) -> Iterator[Pair]:
    """Real clouds, each divided into two random halves, of which parts are removed on opposite sides.

    Every second cloud is held out, but many clouds of both halves show one kitchen. The poses are exact and the noise
    is real, but errors of the sensor common to both halves cancel.
    """
    clouds = surveys.real_clouds()
    clouds = clouds[::2] if seeds.start < HELD_OUT else clouds[1::2]
    for seed in seeds if clouds else ():
        scan, rng = clouds[seed % len(clouds)], np.random.default_rng([seed, 80])
        direction = rng.normal(size=3)
        along = (scan.points - scan.points.mean(axis=0)) @ direction
        low, high = np.quantile(along, [0.25, 0.75])
        half = rng.random(len(scan.points)) < 0.5
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = Rotation.from_rotvec(rng.normal(0, 0.3, 3)).as_matrix(), rng.normal(0, 0.3, 3)
        source, target = scan.points[half & (along < high)], scan.points[~half & (along > low)]
        voxel = 0.05 if scan.kind == "room" else 0.5
        yield Pair("halves of real scans", source, target @ T[:3, :3].T + T[:3, 3], T, voxel)


KINDS: dict[str, Callable[[range], Iterator[Pair]]] = {
    "rooms": rooms,
    "sites": sites,
    "streets": streets,
    "halves of real scans": parts_of_real,
}


def _measured(rays: Array, distances: Array, noise: float, farthest: float, rng: np.random.Generator) -> Array:
    is_hit = np.isfinite(distances) & (distances > 0.3) & (distances < farthest)
    return rays[is_hit] * (distances[is_hit] + rng.normal(0, noise, is_hit.sum()))[:, None]


def components(pair: Pair | sensor_pairs.SensorPair, operation: str) -> Array | None:
    """The error of a registration along the eigenvectors of its covariance, in standard deviations [6]. None for a pair
    that hardly overlaps.
    """
    import pointloom as loom

    reg = loom.registration
    rng = np.random.default_rng(zlib.crc32(pair.source[:8].tobytes()))
    middle, off = pair.T[:3, :3] @ pair.source.mean(axis=0) + pair.T[:3, 3], np.eye(4)
    off[:3, :3] = Rotation.from_rotvec(np.radians(rng.normal(0, TURN, 3))).as_matrix()
    off[:3, 3] = middle - off[:3, :3] @ middle + rng.normal(0, SHIFT * pair.voxel, 3)
    clouds = [
        loom.PointCloud(points).voxel_down_sample(pair.voxel).estimate_normals(max_nn=20)
        for points in (pair.source, pair.target)
    ]
    estimation = (
        reg.TransformationEstimationPointToPlane()
        if operation == "point-to-plane"
        else reg.TransformationEstimationForGeneralizedICP()
    )
    result = reg.registration_icp(*clouds, 1.5 * pair.voxel, off @ pair.T, estimation)
    if result.fitness < MIN_FITNESS:
        return None
    return whitened(pair.T @ np.linalg.inv(result.transformation), result.covariance.matrix, result.covariance.center)


def frame_components(seed: int) -> dict[str, Array]:
    """As `components`, of two frames of a depth camera in a furnished room, for each method with surfaces."""
    import pointloom as loom
    from pointloom.datasets.scenes.room import look_along
    from pointloom.kernels.memory import download
    from pointloom.kernels.scenes.depth_noise import measure_depth
    from pointloom.kernels.scenes.room import Room

    parts, size = made_rooms.furnish(seed)
    rng, (x, y, z) = np.random.default_rng([seed, 81]), size.tolist()
    w, h, f = made_rooms.WIDTH, made_rooms.HEIGHT, made_rooms.FOCAL
    camera = loom.PinholeCameraIntrinsic(w, h, f, f, (w - 1) / 2, (h - 1) / 2)
    looks = np.array(parts.paints), np.array(parts.patterns)
    solids, lamp = parts.solids("cpu"), (x / 2, y / 2, z - 0.3)
    room = Room(solids, *looks, lamp=lamp, low=(-0.3,) * 3, high=(x + 0.3, y + 0.3, z + 0.3))
    eye = np.array([x * rng.uniform(0.35, 0.65), y * rng.uniform(0.35, 0.65), rng.uniform(1.2, 1.7)])
    yaw, pitch, frames, poses = rng.uniform(0, 2 * np.pi), np.radians(rng.uniform(-35, -8)), [], []
    for k in range(2):
        a, b = yaw + k * np.radians(rng.uniform(-4, 4)), pitch + k * np.radians(rng.uniform(-3, 3))
        T = look_along(eye + k * rng.normal(0, 0.03, 3), (np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)))
        depth, incidence, colors = room.render(camera, T)
        measured = download(measure_depth(depth, incidence, w, h, seed=seed, frame=k)).reshape(h, w)
        color = download(colors).reshape(h, w, 3)
        frames.append(loom.rgbd.OdometryFrame(measured, camera, color, depth_scale=1.0, depth_max=6.0))
        poses.append(T)
    found = {}
    for method in ("point-to-plane", "hybrid"):
        result = loom.rgbd.align_frames(*frames, method=method)
        if result.reliable:
            error = np.linalg.inv(poses[1]) @ poses[0] @ np.linalg.inv(result.transformation)
            found[method] = whitened(error, result.covariance, np.zeros(3))
    return found


def survey_components(survey: surveys.Survey, seed: int) -> dict[str, list[Array]]:
    """As `components`, of the clouds of a survey with a pose, relative to the reference. Four components if level."""
    import pointloom as loom

    reg, rng, rough = loom.registration, np.random.default_rng(seed), survey.poses.copy()
    axes = [0, 0, 1] if survey.level else [1, 1, 1]
    for T in rough[1:]:
        T[:3, :3] = Rotation.from_rotvec(rng.normal(0, 0.01, 3) * axes).as_matrix() @ T[:3, :3]
        T[:3, 3] += rng.normal(0, survey.voxel / 2, 3)
    clouds = [loom.PointCloud(points) for points in survey.scans]
    stations = reg.register_stations(clouds, poses=rough, voxel_size=survey.voxel, level=survey.level)
    steps = [np.linalg.inv(rough[i]) @ rough[i + 1] for i in range(len(rough) - 1)]
    known = [reg.FragmentPair(i + 1, i, step, 1.0, 1.0) for i, step in enumerate(steps)]
    free = ("x", "y", "z", "yaw") if survey.level else None
    fragments = reg.register_multiway(clouds, voxel_size=survey.voxel, known=known, pairs=(), free=free)
    first, found = 2 if survey.level else 0, {}
    for name, result, covariances in (
        ("register_stations", stations, stations.pose_covariances),
        ("register_multiway", fragments, fragments.pose_covariances(clouds)),
    ):
        fixed = result.reference
        truth = result.poses[fixed] @ np.linalg.inv(survey.poses[fixed]) @ survey.poses
        found[name] = [
            whitened(truth[i] @ np.linalg.inv(result.poses[i]), covariances[i].matrix, covariances[i].center, first)
            for i in np.flatnonzero(result.placed)
            if i != fixed and np.isfinite(covariances[i].matrix).all()
        ]
    return found


def whitened(error: Array, matrix: Array, center: Array, first: int = 0) -> Array:
    """Components of an error, a 4x4 motion of the target's world, in standard deviations. `matrix`: covariance of
    rotation and translation of `center`. The motions before `first` are fixed.
    """
    rotation = Rotation.from_matrix(error[:3, :3]).as_rotvec()
    motion = np.concatenate([rotation, error[:3, :3] @ center + error[:3, 3] - center])
    motion, matrix = motion[first:], matrix[first:, first:]
    scale = np.sqrt(np.diag(matrix))  # radians and meters become comparable
    values, vectors = np.linalg.eigh(matrix / np.outer(scale, scale))
    return (vectors.T @ (motion / scale)) / np.sqrt(values)


HEADING = ["| scenes | method | pairs | within 1 sigma | within 2 sigma |", "|---|---|---|---|---|"]


def drive_lines(is_fitted: bool, count: int) -> list[str]:
    """Coverage of LiDAR odometry by kind of scene; each pose counts as a pair with the first scan."""
    first = drives.FITTED if is_fitted else drives.HELD_OUT
    found = drives.components(first, min(count, drives.COUNT), whitened)
    return [_line(kind, "odometry", some) for kind, some in found if some]


def recording_lines(is_fitted: bool, count: int) -> list[str]:
    """Coverage of LiDAR odometry on real recordings, by sensor: at most `count` paths each."""
    rows: dict[tuple[str, str], list[Array]] = {}
    for sensor, method, error in recordings.components(is_fitted, count, whitened):
        rows.setdefault((f"LiDAR recording, {sensor}", method), []).append(error)
    return [_line(*names, some) for names, some in rows.items()]


def pair_lines(is_fitted: bool, count: int) -> list[str]:
    """Coverage of registered pairs by kind of scene and operation."""
    first, lines = _first_seed(is_fitted), []
    for kind, make in KINDS.items():
        rows: dict[str, list[Array]] = {operation: [] for operation in OPERATIONS}
        for number, pair in enumerate(make(range(first, first + count)), 1):
            print(f"{kind} {number}", file=sys.stderr, flush=True)
            for operation in OPERATIONS:
                if (found := components(pair, operation)) is not None:
                    rows[operation].append(found)
        lines += [_line(kind, operation, some) for operation, some in rows.items() if some]
    return lines


def sensor_lines(is_fitted: bool, count: int) -> list[str]:
    """Coverage of registered pairs of real scans, by sensor: at most half as many as of other kinds."""
    rows: dict[tuple[str, str], list[Array]] = {}
    for number, pair in enumerate(sensor_pairs.sensor_pairs(is_fitted, count // 2), 1):
        print(f"{pair.kind} {number}", file=sys.stderr, flush=True)
        for operation in OPERATIONS:
            if (found := components(pair, operation)) is not None:
                rows.setdefault((pair.kind, operation), []).append(found)
    return [_line(*names, some) for names, some in rows.items()]


def frame_lines(is_fitted: bool, count: int) -> list[str]:
    """Coverage of pairs of RGB-D frames, synthetic ones and halves of real ones, and of tracked paths."""
    first = _first_seed(is_fitted)
    found: dict[tuple[str, str], list[Array]] = {}
    for seed in range(first, first + count):
        for method, one in frame_components(seed).items():
            found.setdefault(("rooms, RGB-D frames", method), []).append(one)
    paths = frame_errors.path_errors(range(first + 1, first + 1 + max(count // PAIRS_OF_WALK, 1)))
    ends = frame_errors.errors_there_and_back(is_fitted, max(count // 4, 1))
    for error in (*frame_errors.half_errors(count, not is_fitted), *paths, *ends):
        row = found.setdefault((error.scenes, error.method), [])
        row.append(whitened(error.error, error.matrix, error.center))
    return [_line(*names, some) for names, some in found.items()]


def survey_lines(is_fitted: bool, count: int) -> list[str]:
    """Coverage of the poses of many clouds by kind of survey."""
    first, lines = _first_seed(is_fitted), []
    for kind, make in surveys.KINDS.items():
        rows: dict[str, list[Array]] = {}
        for seed, survey in enumerate(make(range(first, first + min(count, SURVEYS[kind]))), first):
            print(f"{kind} {seed}", file=sys.stderr, flush=True)
            for operation, found in survey_components(survey, seed).items():
                rows.setdefault(operation, []).extend(found)
        lines += [_line(f"surveys, {kind}", operation, some) for operation, some in rows.items() if some]
    return lines


def _first_seed(is_fitted: bool) -> int:
    return FITTED if is_fitted else HELD_OUT


def _line(kind: str, operation: str, found: Sequence[Array]) -> str:
    sizes = np.abs(np.concatenate(found))
    within = [share_in_words(int((sizes < limit).sum()), len(sizes)) for limit in (1, 2)]
    line = f"| {kind} | {operation} | {len(found)} | {' | '.join(within)} |"
    print(line, file=sys.stderr, flush=True)
    return line


AREAS = {
    "pairs": pair_lines,
    "sensors": sensor_lines,
    "frames": frame_lines,
    "drives": drive_lines,
    "recordings": recording_lines,
    "surveys": survey_lines,
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fitted", action="store_true", help="the scenes on which constants were chosen")
    parser.add_argument("--pairs", type=int, default=PAIRS, help="of each kind")
    parser.add_argument("--only", nargs="+", choices=AREAS, default=list(AREAS), help="these rows; others are kept")
    parser.add_argument("--write", action="store_true", help="write the table into docs/trust.md")
    arguments = parser.parse_args()
    lines = list(HEADING)
    for area in arguments.only:
        lines += AREAS[area](arguments.fitted, arguments.pairs)
    print("\n".join(lines))
    if arguments.write:
        kinds = list(dict.fromkeys(line.split(" | ")[0].removeprefix("| ") for line in lines[2:]))
        write_between(
            PAGE, "calibration", "\n".join(merged(text_between(PAGE, "calibration").splitlines(), lines, kinds))
        )


if __name__ == "__main__":
    main()
