"""Reliability on scenes and faults that no constant was chosen on (places.py, sensors.py).

`registering` and `registering_images` yield a Judged for each case, the others list their cases. Undetermined
quantities, such as the
distance along a bare corridor, count as wrong if accepted with an error, and do not count if rejected.
"""

from __future__ import annotations

import itertools
import math
import tempfile
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import beliefs
import numpy as np
import places
import sensors
from belief_scenes import Scan
from judged import Case, Judged
from places import Site
from sensors import CameraFrame, DepthCamera, Scanner

from pointloom.datasets.scenes.room import look_along

Array = np.ndarray[Any, np.dtype[np.float64]]

OFF = 0.10  # [m] maximum error of a correct camera pose, relative to the first pose
MANY = 0.05  # fraction of the frames that may be wrong, or lost, in a correct path
ASTRAY, STRAY_FRACTION = 0.5, 0.02  # [m] and fraction of the distance: maximum final error of a scanner's path
NEAR_DEGREES, NEAR_VOXELS = 5.0, 3.0  # [degrees, voxels] maximum errors of a correct registration
VOXEL = 0.05  # [m] for registration
SEED = 40  # of the first site
IMAGE_SEEDS = range(44, 49)  # of the sites seen in single depth images
UNRELATED = 640  # pairs of single depth images of two sites, half of them of one kind
OVERLAPS = (0.1, 0.2, 0.5, 1.01)  # ends of the classes of overlap
SCANNED_SITES = 6  # of each kind, for the scanner


def track_frames(frames: Sequence[CameraFrame], intrinsic: Any) -> tuple[Any, Array, Array]:
    """The tracked path, the indices of its poses, and their errors [m]."""
    import pointloom as loom

    stream = loom.frames_from([(f.color, f.depth, f.timestamp) for f in frames], intrinsic)
    path = loom.rgbd.track(stream, voxel_size=0.02)
    numbers = np.array(path.trajectory.ids, int)[:, 0] if len(path.trajectory) else np.zeros(0, int)
    if not len(numbers):
        return path, numbers, np.zeros(0)
    start = frames[int(numbers[0])].pose @ np.linalg.inv(path.trajectory.poses[0])
    errors = [
        np.linalg.norm((start @ T)[:3, 3] - frames[int(k)].pose[:3, 3])
        for k, T in zip(numbers, path.trajectory.poses, strict=True)
    ]
    return path, numbers, np.array(errors)


def judge_path(
    case: str, frames: Sequence[CameraFrame], camera: DepthCamera, known: bool, faulty: Sequence[int] = ()
) -> Iterator[Judged]:
    """Reliability of the frames and of their path.

    `known` is False if the poses cannot be determined. `faulty` frames have depth of another time: they count as
    unreliable if they are rejected, or accepted with a wrong pose.
    """
    path, numbers, errors = track_frames(frames, camera.intrinsic)
    blank = {k for k, f in enumerate(frames) if not f.depth.any()}
    doubted = np.isin(numbers, path.uncertain)
    bad = np.isin(numbers, faulty)
    wrong = (errors > OFF) | (bad & doubted)
    lost = set(path.lost) - blank
    faulty_lost = len(lost & set(faulty))
    others_lost = len(lost) - faulty_lost if known else 0
    refused = int((doubted & ~wrong).sum()) if known else 0
    wrong_count = int(wrong.sum()) + faulty_lost
    count = wrong_count + int((~wrong & (~doubted | known)).sum()) + others_lost
    visible = len(frames) - len(blank)
    worst = (
        f"{1000 * errors.max():.0f} mm at worst, {100 * len(numbers) / max(visible, 1):.0f} % placed"
        if len(errors)
        else "none placed"
    )
    accepted = int((wrong & ~doubted).sum())
    yield Judged("RGB-D frames, held out", case, count, wrong_count, accepted, refused + others_lost, "", worst)
    is_refused = not path.reliable
    is_wrong = accepted > MANY * len(frames) or (is_refused and len(faulty) > MANY * len(frames))
    is_right = known and not is_wrong and others_lost + refused <= MANY * visible
    counted = int(is_wrong or is_right)
    passed, needless = int(is_wrong and not is_refused), int(is_right and is_refused)
    yield Judged(
        "RGB-D path, held out", case, counted, int(is_wrong), passed, needless, "; ".join(path.warnings) or "", worst
    )


COUNT = 66  # frames of a sequence
SMALL = 0.5  # scale of its images: 160 x 120


def tracking() -> Iterator[Case]:
    """A handheld depth camera: each site without a fault, and with two of the faults."""
    for number, (seed, kind) in enumerate(itertools.product(range(SEED, SEED + 2), places.KINDS)):
        yield Case(f"{kind} {seed}", partial(_site, kind, seed, number))
    for seed in (SEED + 2, SEED + 3):
        yield Case(f"bare sites {seed}", partial(_bare, seed))
        yield Case(f"covered {seed}", partial(_covered, seed))


def _site(kind: str, seed: int, number: int) -> Iterator[Judged]:
    camera = DepthCamera(places.KINDS[kind](seed), seed, scale=SMALL)
    frames = camera.film(_way(kind, COUNT, seed))
    yield from judge_path(f"{kind} {seed}", frames, camera, True)
    for k in (2 * number, 2 * number + 1):
        case, changed, faulty = _fault(frames, k, seed)
        yield from judge_path(f"{kind} {seed}, {case}", changed, camera, True, faulty)


def _bare(seed: int) -> Iterator[Judged]:
    """Sites that do not determine the motion."""
    bare: dict[str, tuple[Site, str]] = {
        "bare white corridor": (places.corridor(seed, contrast=0, niches=False), "corridor"),
        "bare white tunnel": (places.tunnel(seed, contrast=0, rough=0), "tunnel"),
        "white hall": (places.hall(seed, contrast=0), "hall"),
    }
    for case, (site, kind) in bare.items():
        camera = DepthCamera(site, seed, scale=SMALL)
        yield from judge_path(f"{case} {seed}", camera.film(_way(kind, COUNT, seed)), camera, False)


def _fault(frames: Sequence[CameraFrame], number: int, seed: int) -> tuple[str, list[CameraFrame], range]:
    """One of ten faults: its name, the frames, and the numbers of those with depth of another time."""
    middle, end = COUNT // 3, COUNT - COUNT // 6
    frozen, delayed, fixed = sensors.frozen, sensors.delayed, sensors.with_gripper
    kinds: list[tuple[str, Callable[[], list[CameraFrame]], range]] = [
        ("depth frozen for 1 s", lambda: frozen(frames, middle, middle + 30), range(middle + 4, middle + 30)),
        ("10 % fixed to the camera", lambda: fixed(frames, 0.1, seed, side="left"), range(0)),
        ("depth frozen with noise", lambda: frozen(frames, middle, noise=0.001), range(middle + 4, COUNT)),
        ("20 % fixed to the camera", lambda: fixed(frames, 0.2, seed, side="left"), range(0)),
        ("depth 0.07 s late", lambda: delayed(frames, 2), range(COUNT - 2)),
        ("30 % fixed to the camera", lambda: fixed(frames, 0.3, seed), range(0)),
        ("depth 0.7 s late for 1 s", lambda: delayed(frames, 21, middle, end), range(middle, end)),
        ("every fourth frame", lambda: list(frames[::4]), range(0)),
        ("depth 0.7 s late", lambda: delayed(frames, 21), range(COUNT - 21)),
        ("covered for 0.3 s", lambda: sensors.covered(frames, middle, middle + 10), range(0)),
    ]
    case, make, faulty = kinds[number % len(kinds)]
    return case, make(), faulty


def _covered(seed: int) -> Iterator[Judged]:
    """Covered while the camera moves from one position to a similar one."""
    period = 1.2
    camera = DepthCamera(places.corridor(seed, niches=False, doors=period), seed, scale=SMALL)
    frames = camera.film(sensors.walking_path(130, seed, speed=0.7))
    gap = round(period / 0.7 * sensors.RATE)
    yield from judge_path(
        f"identical doors {seed}, covered for a period", sensors.covered(frames, 50, 50 + gap), camera, False
    )
    yield from judge_path(f"identical doors {seed}, not covered", frames, camera, True)
    camera = DepthCamera(places.staircase(seed, contrast=0), seed, scale=SMALL)
    frames = camera.film(sensors.climb(120, seed))
    yield from judge_path(f"white staircase {seed}, covered for a step", sensors.covered(frames, 50, 74), camera, False)


def _way(kind: str, count: int, seed: int) -> list[Array]:
    return {"table": sensors.around, "staircase": sensors.climb}.get(kind, sensors.walking_path)(count, seed)


def judge_scans(case: str, scans: Sequence[Any], truth: Sequence[Array], known: bool) -> Judged:
    """Reliability of a scanner's path."""
    import pointloom as loom

    odometry = loom.registration.LidarOdometry(max_range=40, min_range=0.5)
    for scan in scans:
        odometry.register(loom.PointCloud(scan))
    first = np.linalg.inv(truth[0])
    true = np.array([(first @ T)[:3, 3] for T in truth])
    positions = np.array([(np.linalg.inv(odometry.poses[0]) @ T)[:3, 3] for T in odometry.poses])
    errors = np.linalg.norm(positions - true, axis=1)
    distance = float(np.linalg.norm(np.diff(true, axis=0), axis=1).sum())
    is_wrong = bool(errors[-1] > max(ASTRAY, STRAY_FRACTION * distance))
    warnings = "; ".join(odometry.summary.warnings)
    counted = int(is_wrong or known)
    figure = f"{errors[-1]:.2f} m off after {distance:.0f} m"
    accepted, refused = int(is_wrong and not warnings), int(known and not is_wrong and bool(warnings))
    peer = _kiss(scans, true) if str(SEED) in case else ""
    return Judged("LiDAR path, held out", case, counted, int(is_wrong), accepted, refused, warnings, figure, peer)


def _kiss(scans: Sequence[Any], true: Array) -> str:
    """Final error of KISS-ICP."""
    try:
        from kiss_icp.config import KISSConfig
        from kiss_icp.kiss_icp import KissICP
    except ImportError:
        return ""
    config = KISSConfig()
    config.data.max_range, config.data.min_range, config.data.deskew = 40.0, 0.5, False
    config.mapping.voxel_size = 0.4
    kiss = KissICP(config)
    for scan in scans:
        kiss.register_frame(np.asarray(scan, np.float64), np.zeros(len(scan)))
    return f"KISS-ICP: {np.linalg.norm(kiss.last_pose[:3, 3] - true[-1]):.2f} m"


def scanning() -> Iterator[Case]:
    """A spinning scanner that drives."""
    for seed in range(SEED, SEED + SCANNED_SITES):
        sights: dict[str, tuple[Callable[[], Site], float, bool]] = {
            "bare corridor": (partial(places.corridor, seed, niches=False), 0.9, False),
            "corridor with niches": (partial(places.corridor, seed), 0.9, True),
            "corridor, doors at 1.2 m": (partial(places.corridor, seed, niches=False, doors=1.2), 1.2, False),
            "smooth tunnel": (partial(places.tunnel, seed, rough=0), 0.9, False),
            "rough tunnel": (partial(places.tunnel, seed), 0.9, True),
            "hall with columns": (partial(places.hall, seed), 0.8, True),
            "forest": (partial(places.forest, seed), 0.8, True),
            "outdoors": (partial(places.outdoors, seed), 0.8, True),
            "flat field": (partial(places.outdoors, seed, things=0, height=0.0), 0.8, False),
        }
        for name, (make, step, known) in sights.items():
            yield Case(f"{name} {seed}", partial(_scanned, name, make, step, known, seed))
        yield Case(f"lorries all round {seed}", partial(_lorries, seed))


def _scanned(name: str, make: Callable[[], Site], step: float, known: bool, seed: int) -> Iterator[Judged]:
    truth = sensors.drive(32, step)
    scanner = Scanner(make(), seed=seed)
    scans = [scanner.scan(T, k) for k, T in enumerate(truth)]
    yield judge_scans(f"{name} {seed}", scans, truth, known)
    if known and name in ("forest", "hall with columns", "corridor with niches"):
        foreign = Scanner(places.outdoors(seed + 7), seed=seed).scan(truth[9], 99)
        yield judge_scans(f"{name} {seed}, one foreign scan", [*scans[:16], foreign, *scans[17:]], truth, False)
        slow = sensors.drive(32, 0.25)
        yield judge_scans(f"{name} {seed}, slowly", [scanner.scan(T, k) for k, T in enumerate(slow)], slow, True)


def _lorries(seed: int) -> Iterator[Judged]:
    """Walls that drive along, ahead, beside and behind: they hide the geometry that determines the motion."""
    truth = sensors.drive(32, 0.9)
    scanner = Scanner(places.outdoors(seed, things=60), seed=seed)
    sides = (
        ((6, -4, 0), (14, 4, 4.2)),
        ((-14, -4, 0), (-6, 4, 4.2)),
        ((-14, 3, 0), (14, 5.5, 4.2)),
        ((-14, -5.5, 0), (14, -3, 4.2)),
    )

    def beside(T: Array) -> list[tuple[Array, Array]]:
        shift = np.array([T[0, 3], 0.0, 0.0])
        return [(np.array(low, float) + shift, np.array(high, float) + shift) for low, high in sides]

    scans = [scanner.scan(T, k, beside(T)) for k, T in enumerate(truth)]
    yield judge_scans(f"lorries all round {seed}", scans, truth, False)


def registering() -> Iterator[Judged]:
    """Registration of partial views: pairs of one site, and of two sites without overlap."""
    import pointloom as loom
    from pointloom.registration.rigid import pose_error

    parts: list[tuple[str, Array, Array]] = []
    for kind, seed in itertools.product(places.KINDS, range(SEED, SEED + 4)):
        camera = DepthCamera(places.KINDS[kind](seed), seed)
        for start in (0, 8):
            poses = _sweep(kind, seed, start)
            parts.append((f"{kind} {seed}", sensors.cloud_of(camera.film(poses), camera.intrinsic), poses[0]))
    rng = np.random.default_rng(SEED)
    pairs = [(a, b) for a, b in itertools.combinations(range(len(parts)), 2)]
    same = [p for p in pairs if parts[p[0]][0] == parts[p[1]][0]]
    disjoint = [p for p in pairs if parts[p[0]][0] != parts[p[1]][0]]
    alike = [p for p in disjoint if parts[p[0]][0].split()[0] == parts[p[1]][0].split()[0]]
    others = [disjoint[k] for k in rng.permutation(len(disjoint))[:200]]
    for a, b in [*same, *alike, *others]:
        (name, points, pose), (other, other_points, target) = parts[a], parts[b]
        start = _anywhere(rng)
        result = loom.registration.register_pair(
            loom.PointCloud(points @ start[:3, :3].T + start[:3, 3]), loom.PointCloud(other_points), voxel_size=VOXEL
        )
        T = result.transformation @ start
        truth = np.linalg.inv(target) @ pose
        shift = np.linalg.norm((T - truth)[:3] @ np.append(points.mean(axis=0), 1))
        right = name == other and np.degrees(pose_error(T, truth)[0]) < NEAR_DEGREES and shift < NEAR_VOXELS * VOXEL
        accepted = result.reliable
        area = (
            "registration, clouds of one place, held out"
            if name == other
            else "registration, clouds that share nothing, held out"
        )
        yield Judged(
            area,
            f"{name} on {other}",
            1,
            int(not right),
            int(accepted and not right),
            int(right and not accepted),
            "; ".join(result.warnings),
            f"score {result.score:.3f}",
        )


def registering_images() -> Iterator[Judged]:
    """Registration of single depth images: pairs of one site by their overlap, and of two sites."""
    images = [image for seed in IMAGE_SEEDS for image in single_images(seed)]
    judge = beliefs.Judge(VOXEL)
    yield from judge_overlapping(judge, images, "single images")
    for source, target in apart(images, UNRELATED):
        yield judged(judge.judge(source, target, None, 0.0), "registration, single images of two sites, held out")


def single_images(seed: int) -> Iterator[Scan]:
    """Six depth images of each kind of site."""
    for kind, make in places.KINDS.items():
        camera = DepthCamera(make(seed), seed)
        for start, k in itertools.product((0, 8), (0, 2, 5)):
            pose = _sweep(kind, seed, start)[k]
            points = sensors.cloud_of([camera.take(pose, 10 * start + k)], camera.intrinsic)
            yield Scan(f"{kind} {seed} image {start + k}/{start}", f"{kind} {seed}", "room", points, pose)


def judge_overlapping(judge: beliefs.Judge, images: Sequence[Scan], name: str) -> Iterator[Judged]:
    """Pairs of images of one scene, as rows by their overlap."""
    for source, target, T, fraction in beliefs.overlapping(images, VOXEL, OVERLAPS[0]):
        k = int(np.searchsorted(OVERLAPS, fraction, side="right"))
        low, high = (round(100 * limit) for limit in OVERLAPS[k - 1 : k + 1])
        between = f"more than {low} %" if high > 100 else f"{low} to {high} %"
        yield judged(
            judge.judge(source, target, T, fraction), f"registration, {name} that overlap by {between}, held out"
        )


def judged(belief: beliefs.Belief, area: str) -> Judged:
    refused = belief.right and not belief.believed
    return Judged(
        area,
        f"{belief.source} on {belief.target}",
        1,
        int(not belief.right),
        int(belief.believed and not belief.right),
        int(refused),
        "; ".join(belief.warnings),
        f"score {belief.score:.3f}",
    )


def apart(images: Sequence[Scan], count: int) -> list[tuple[Scan, Scan]]:
    """Random pairs of images of two scenes, half of them of one kind of scene."""
    rng = np.random.default_rng(SEED)
    pairs = [(a, b) for a, b in itertools.combinations(images, 2) if a.scene != b.scene]
    alike = [(a, b) for a, b in pairs if a.scene.split()[0] == b.scene.split()[0]]
    others = [(a, b) for a, b in pairs if a.scene.split()[0] != b.scene.split()[0]]
    chosen = [(group, k) for group in (alike, others) for k in rng.permutation(len(group))[: count // 2].tolist()]
    return [group[k] for group, k in chosen]


def _sweep(kind: str, seed: int, start: int) -> list[Array]:
    """Twelve views over a rotation of 120 degrees; the second sequence starts 80 degrees later."""
    if kind == "table":
        return sensors.around(36, seed)[start : start + 12]
    x, height, rise = (1.5, 2.3, 0.0) if kind == "staircase" else (-6.0, 1.4, 0.0)
    poses = []
    for k in range(start, start + 12):
        yaw, pitch = math.radians(-60 + 6 * k + 5 * seed), math.radians(-20 + 12 * math.sin(2.1 * k))
        eye = np.array([x + 0.12 * k, 0.2 * math.sin(k), height + rise])
        direction = np.array([math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch)])
        poses.append(look_along(eye, direction))
    return poses


def _anywhere(rng: np.random.Generator) -> Array:
    q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = q * np.sign(np.linalg.det(q)), rng.uniform(-5, 5, 3)
    return T


Shot = tuple[str, list[tuple[Array, float]], float | None, bool]


def picturing() -> Iterator[Case]:
    """Images alone: the model is wrong if a camera center is off by 2 % of the extent, or f by 5 %."""
    for case, kind, *rest in _albums():
        yield Case(case, lambda case=case, kind=kind, rest=rest: [_judge_album(case, kind, *rest)])


def _albums() -> Iterator[tuple[str, str, list[tuple[Array, float]], float | None, bool]]:
    """Cases: pose and zoom of each image, the given focal length as a factor, whether f can be determined."""
    table = sensors.around(16, 1, radius=1.1, angle=3.6)
    hall = _orbit(16)
    yield "table", "table", [(T, 1.0) for T in table], None, True
    yield "hall", "hall", [(T, 1.0) for T in hall], None, True
    yield "hall, intrinsic given rightly", "hall", [(T, 1.0) for T in hall], 1.0, True
    yield "hall, intrinsic 13 % short", "hall", [(T, 1.0) for T in hall], 0.87, True
    yield "table, intrinsic 20 % long", "table", [(T, 1.0) for T in table], 1.2, True
    yield "hall, two lenses", "hall", [(T, 1.0 if k % 2 else 1.6) for k, T in enumerate(hall)], None, True
    dolly = [look_along(np.array([-6 + 0.25 * k, 0, 1.4]), np.array([1, 0, -0.15])) for k in range(16)]
    yield "corridor, straight dolly", "corridor", [(T, 1.0) for T in dolly], None, False
    nadir = [
        np.array([[1, 0, 0, -6 + 1.2 * (k % 5)], [0, -1, 0, -2 + 1.2 * (k // 5)], [0, 0, -1, 7], [0, 0, 0, 1.0]])
        for k in range(20)
    ]
    yield "outdoors from above", "outdoors", [(T, 1.0) for T in nadir], None, False


def _orbit(count: int) -> list[Array]:
    poses = []
    for k in range(count):
        a = 2.2 * k / count
        eye = np.array([2.2 * math.cos(a), 2.2 * math.sin(a) - 2, 1.5 + 0.2 * math.sin(4 * a)])
        poses.append(look_along(eye, np.array([-3.0, 3.5, 0.6]) - eye))
    return poses


def _judge_album(case: str, kind: str, shots: list[tuple[Array, float]], given: float | None, known: bool) -> Judged:
    from PIL import Image
    from sfm_accuracy import camera_errors

    import pointloom as loom

    site = places.KINDS[kind](SEED + 5)
    cameras = {zoom: DepthCamera(site, 1, scale=2, zoom=zoom) for _, zoom in shots}
    with tempfile.TemporaryDirectory() as folder:
        images = Path(folder, "images")
        images.mkdir()
        truth, focal = {}, {}
        for k, (pose, zoom) in enumerate(shots):
            name = f"{k:03d}.png"
            Image.fromarray(cameras[zoom].image(pose, k)).save(images / name)
            truth[name], focal[name] = pose, cameras[zoom].focal
        options: dict[str, Any] = {}
        if given is not None:
            camera = cameras[1.0]
            f, K = given * camera.focal, camera.intrinsic
            options["intrinsic"] = loom.PinholeCameraIntrinsic(K.width, K.height, f, f, K.cx, K.cy)
        settings = loom.photogrammetry.SfmSettings(max_features=2000, seed=0, **options)
        result = loom.photogrammetry.reconstruct_images(images, Path(folder, "work"), settings)
    if result.model is None:
        return Judged(
            "images, held out", case, int(known), 0, 0, int(known), "; ".join(result.warnings) or "", "no model"
        )
    errors = camera_errors(result.model, truth)
    ratio = [c.params[0] / focal[n] for n, c in zip(result.model.names, result.model.cameras, strict=True)]
    off_focal = max(abs(r - 1) for r in ratio)
    is_wrong = errors["fraction_of_extent"] > 0.02 or off_focal > 0.05
    warnings = "; ".join(result.warnings)
    centers, count = 100 * errors["fraction_of_extent"], len(result.model.names)
    figure = f"centers {centers:.2f} %, f {100 * off_focal:.1f} % off, {count} placed"
    return Judged(
        "images, held out",
        case,
        int(known or is_wrong),
        int(is_wrong),
        int(is_wrong and not warnings),
        int(known and not is_wrong and bool(warnings)),
        warnings,
        figure,
    )


AREAS: dict[str, Callable[[], Iterator[Judged | Case]]] = {
    "tracking": tracking,
    "scanning": scanning,
    "registering": registering,
    "images": registering_images,
    "picturing": picturing,
}
