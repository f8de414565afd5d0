"""Point clouds of many scenes with known poses, for testing which registrations are accepted.

Sources: synthetic rooms and the data sets in the folder `POINTLOOM_DATA`. Missing data sets are skipped.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import made_rooms
import numpy as np
import real_scans
from numpy.typing import NDArray
from real_data import DataMissingError, real_data

Array = NDArray[np.float64]

MADE = 20  # synthetic rooms, and the same number of fresh ones that were not used for fitting
FRAMES = 30  # frames of the kitchen per fragment
FAR = 3.5  # [m] maximum depth


@dataclass(frozen=True)
class Scan:
    """A point cloud of a scene.

    Attributes:
        name, scene: Names of the cloud and of its scene; clouds of one scene may overlap.
        kind: "room", "object", "street" or "terrain"; clouds of one kind are compared with the same voxel sizes.
        points: float64 [n, 3] [m]; objects are scaled to size one, so all use the same voxel sizes.
        pose: T_scene_scan, if known.
    """

    name: str
    scene: str
    kind: str
    points: Array
    pose: Array | None = None


Source = Callable[[], Iterator[Scan]]


def _backproject(depth: Array, focal: float, cx: float, cy: float) -> Array:
    """Points of a depth image [m], float64 [n, 3]."""
    rows, columns = np.nonzero((depth > 0) & (depth < FAR))
    z = depth[rows, columns]
    return np.column_stack([(columns - cx) * z / focal, (rows - cy) * z / focal, z])


def made() -> Iterator[Scan]:
    yield from _synthetic_rooms("made", range(MADE))


def fresh() -> Iterator[Scan]:
    yield from _synthetic_rooms("fresh", range(MADE, 2 * MADE))


def _synthetic_rooms(name: str, seeds: range) -> Iterator[Scan]:
    for seed in seeds:
        for k, (points, pose) in enumerate(made_rooms.fragments(seed, (0.0, 60.0, 190.0))):
            yield Scan(f"{name} room {seed} part {k}", f"{name} room {seed}", "room", points, pose)


def demo_room() -> Iterator[Scan]:
    """The room of the demo in six parts."""
    import pointloom as loom
    from pointloom.datasets.scenes.room import room_sequence

    sequence = room_sequence(60, width=320, height=240)
    for part in range(6):
        volume, first = loom.TSDFVolume(voxel_size=0.02, color=False), sequence.read(10 * part).T_world_camera
        for k in range(10 * part, 10 * part + 10):
            frame = sequence.read(k)
            volume.integrate(frame.depth, frame.intrinsic, np.linalg.inv(frame.T_world_camera), depth_max=FAR)
        points = volume.extract_point_cloud(weight_threshold=0.0).points
        yield Scan(f"demo part {part}", "demo", "room", (points - first[:3, 3]) @ first[:3, :3], first)


def kitchen() -> Iterator[Scan]:
    """Fragments of 30 frames of the kitchen, single frames, and the two fragments of 3DMatch."""
    import pointloom as loom

    at = real_data("rgbd-7scenes-redkitchen")
    camera = loom.PinholeCameraIntrinsic(640, 480, 585.0, 585.0, 320.0, 240.0)
    for start in range(0, 300, FRAMES):
        volume = loom.TSDFVolume(voxel_size=0.02, color=False)
        poses = []
        for k in range(start, start + FRAMES, 2):
            T = _rigid(np.loadtxt(at / f"frame-{k:06d}.pose.txt"))
            depth = loom.read_depth(at / f"frame-{k:06d}.depth.png").copy()
            depth[depth == 65535] = 0
            volume.integrate(depth, camera, np.linalg.inv(T), depth_max=FAR)
            poses.append(T)
        points = volume.extract_point_cloud(weight_threshold=1.0).points
        T = poses[0]
        yield Scan(f"kitchen {start}-{start + FRAMES - 1}", "kitchen", "room", (points - T[:3, 3]) @ T[:3, :3], T)
    yield from kitchen_images(range(0, 300, 60))


def kitchen_images(numbers: range) -> Iterator[Scan]:
    """Single depth images of the kitchen."""
    import pointloom as loom

    at = real_data("rgbd-7scenes-redkitchen")
    for k in numbers:
        depth = np.asarray(loom.read_depth(at / f"frame-{k:06d}.depth.png"), float)
        depth[depth == 65535] = 0
        T = _rigid(np.loadtxt(at / f"frame-{k:06d}.pose.txt"))
        yield Scan(f"kitchen frame {k}", "kitchen", "room", _backproject(depth / 1000, 585, 320, 240), T)


def teaser() -> Iterator[Scan]:
    """Two fragments of the kitchen in a separate frame: a scene that is not compared with other kitchens."""
    pair = real_scans.kitchen()
    yield Scan("3DMatch kitchen 0", "kitchen teaser", "room", pair.target[::4], np.eye(4))
    yield Scan("3DMatch kitchen 4", "kitchen teaser", "room", pair.source[::4], pair.T)


def _rigid(T: Array) -> Array:
    """Project a matrix onto the nearest rigid transformation."""
    u, _, v = np.linalg.svd(T[:3, :3])
    return np.vstack([np.column_stack([u @ v, T[:3, 3]]), [0, 0, 0, 1]])


def frames() -> Iterator[Scan]:
    """Single depth images of other rooms, and fused clouds of them."""
    import pointloom as loom

    def image(path: str, scale: float, focal: float, cx: float, cy: float) -> Array:
        return _backproject(np.asarray(loom.read_depth(real_data(path)), float) / scale, focal, cx, cy)

    for k in (0, 4):
        yield Scan(
            f"redwood frame {k}",
            "redwood",
            "room",
            image(f"rgbd-cupoch-redwood5/depth/{k:05d}.png", 1000, 525, 319.5, 239.5),
            _trajectory(real_data("rgbd-cupoch-redwood5/trajectory.log"))[k],
        )
    for k in (0, 116, 422):
        points = image(f"rgbd-nvblox-3dmatch/seq-01/frame-{k:06d}.depth.png", 1000, 570.34, 320, 240)
        yield Scan(f"SUN3D frame {k}", "SUN3D", "room", points)
    for case, when in itertools.product((1, 2), ("prev", "curr")):
        numbers = np.loadtxt(real_data(f"rgbd-tum-pairs/case_{case}/pose_{when}.txt"))
        points = image(f"rgbd-tum-pairs/case_{case}/dep_{when}.png", 5000, 525, 319.5, 239.5)
        T = real_scans.pose_of(real_scans.Rotation.from_quat(numbers[3:]), numbers[:3])
        yield Scan(f"TUM desk {case} {when}", f"TUM desk {case}", "room", points, T)
    yield Scan("TUM frame", "TUM frame", "room", image(f"{OTHERS}/TUM_depth.png", 5000, 525, 319.5, 239.5))
    raw = np.asarray(loom.read_depth(real_data(f"{OTHERS}/SUN_depth.png")))
    shifted = ((raw >> 3) | (raw << 13)).astype(float) / 1000
    yield Scan("SUN frame", "SUN frame", "room", _backproject(shifted, 525, 319.5, 239.5))
    for k in (1, 2):
        points = image(f"rgbd-slambook-ch7/{k}_depth.png", 5000, 525, 319.5, 239.5)
        yield Scan(f"slambook desk {k}", "slambook desk", "room", points)
    at = real_data("stereo-skimage-motorcycle/motorcycle_disp.npz")
    disparity = np.load(at)["arr_0"].astype(float)
    depth = np.where(np.isfinite(disparity), 0.193001 * 994.978 / (disparity + 31.086), 0)
    yield Scan("motorcycle", "motorcycle", "room", _backproject(depth, 994.978, 311.193, 254.877))


OTHERS = "rgbd-cupoch-redwood5/other_formats"
MAY_FRACTION = (  # scenes that may show the same location: no pair of different scenes
    {"kitchen", "kitchen teaser"},
    {"redwood", "cupoch fragment"},
    {"TUM desk 1", "TUM desk 2", "TUM frame", "slambook desk"},
    {"KITTI 07", "KITTI pair"},
)


def _trajectory(path: Path) -> list[Array]:
    lines = path.read_text().splitlines()
    return [np.array([line.split() for line in lines[k + 1 : k + 5]], float) for k in range(0, len(lines) - 4, 5)]


def clouds() -> Iterator[Scan]:
    """Clouds of rooms from data sets of clouds."""
    yield Scan("cupoch fragment", "cupoch fragment", "room", _points("cloud-cupoch/fragment.pcd")[::2])
    for k in (1, 2):
        yield Scan(f"cilantro {k}", "cilantro", "room", _points(f"reg-cilantro/frame_{k}.ply")[::2])
    for k in range(1, 6):
        yield Scan(f"Kinect {k}", "Kinect", "room", _points(f"pcl-data-tutorials/pairwise/capture000{k}.pcd")[::2])
    scene = _points("pcl-tests/test/milk_cartoon_all_small_clorox.pcd")[::2]
    yield Scan("cartons", "cartons", "room", scene[scene[:, 2] < FAR])


def _points(name: str) -> Array:
    return real_scans.points_of(real_data(name))


def streets() -> Iterator[Scan]:
    for i, pair in enumerate(itertools.islice(real_scans.submaps(), 4)):  # 0 with 1 to 4: the source is the later one
        if i == 0:
            yield Scan("submap 0", "KITTI 07", "street", pair.target, np.eye(4))
        yield Scan(f"submap {i + 1}", "KITTI 07", "street", pair.source, pair.T)
    pair = real_scans.lidar()
    yield Scan("LiDAR target", "KITTI pair", "street", pair.target[::2], np.eye(4))
    yield Scan("LiDAR source", "KITTI pair", "street", pair.source[::2], pair.T)
    scan = np.fromfile(real_data("lidar-kitti-frame/kitti/000008.bin"), np.float32).reshape(-1, 4)[:, :3]
    yield Scan("KITTI frame", "KITTI frame", "street", scan.astype(float))


def drives() -> Iterator[Scan]:
    """Two scans of each of some synthetic streets, 6 m apart."""
    import street

    for seed in range(4):
        drive = street.drive(31, speed=2.0, beams=40, azimuths=720, seed=seed)
        for k in (0, 30):
            yield Scan(f"made street {seed} scan {k}", f"made street {seed}", "street", drive.scans[k], drive.poses[k])


def terrain() -> Iterator[Scan]:
    for site in ("samp12", "samp21", "samp24", "samp31", "samp41", "samp42"):
        points = _points(f"lidar-pcl-terrain/{site}-utm.pcd")
        yield Scan(site, "site " + site[4], "terrain", points - points.mean(axis=0))


def objects() -> Iterator[Scan]:
    """Objects of size one: range scans, and two overlapping parts of the surface of each mesh."""
    poses = real_scans.bunny_poses()
    for name in real_scans.BUNNY_SCANS:
        T = poses[name].copy()
        T[:3, 3] /= 0.2
        yield Scan(name, "bunny", "object", real_scans.bunny_scan(name)[::2] / 0.2, T)
    pair = real_scans.dragon()
    yield from _parts("dragon", pair.target / 20.0)
    cad = "00011084_fddd53ce45f640f3ab922328_trimesh_019"
    scan = np.loadtxt(real_data(f"mesh-points2surf-abc/04_pts_vis/{cad}.xyz"))
    yield from _parts("CAD part", scan / np.ptp(scan, axis=0).max())
    for name in ("fandisk", "cheburashka", "nefertiti"):
        points = _sampled(real_data(f"mesh-common3d/{name}.obj"), 60000)
        yield from _parts(name, points / np.ptp(points, axis=0).max())
    milk = _points("pcl-tests/test/milk_color.pcd")
    yield Scan("carton", "carton", "object", milk / np.ptp(milk, axis=0).max())


def _sampled(path: Path, count: int) -> Array:
    """Sample points on the triangles of an .obj file with uniform density."""
    lines = [line.split() for line in path.read_text().splitlines()]
    vertices = np.array([words[1:4] for words in lines if words[:1] == ["v"]], float)
    faces = [[int(word.split("/")[0]) - 1 for word in words[1:]] for words in lines if words[:1] == ["f"]]
    a, b, c = vertices[np.array([(f[0], f[k], f[k + 1]) for f in faces for k in range(1, len(f) - 1)])].swapaxes(0, 1)
    rng = np.random.default_rng(0)
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    rows = rng.choice(len(a), count, p=areas / areas.sum())
    u, v = rng.random((2, count, 1))
    u, v = np.where(u + v > 1, 1 - u, u), np.where(u + v > 1, 1 - v, v)
    return a[rows] + u * (b - a)[rows] + v * (c - a)[rows]


def _parts(name: str, points: Array) -> Iterator[Scan]:
    """Two parts of a cloud that overlap by about 40 %, with different points."""
    rng = np.random.default_rng(7)
    axis = rng.normal(size=3)
    height = (points - points.mean(axis=0)) @ (axis / np.linalg.norm(axis))
    low, high = np.quantile(height, (0.35, 0.65))
    half = rng.random(len(points)) < 0.5
    yield Scan(f"{name} below", name, "object", points[half & (height < high)], np.eye(4))
    yield Scan(f"{name} above", name, "object", points[~half & (height > low)], np.eye(4))


SOURCES: dict[str, Source] = {
    "made": made,
    "fresh": fresh,
    "demo": demo_room,
    "kitchen": kitchen,
    "teaser": teaser,
    "frames": frames,
    "clouds": clouds,
    "streets": streets,
    "drives": drives,
    "terrain": terrain,
    "objects": objects,
}


def load(names: list[str], cache: Path | None) -> tuple[list[Scan], list[str]]:
    """Load the clouds of the given sources, cached in a folder if given; also returns messages about missing data."""
    scans, missing = [], []
    for name in names:
        path = cache / f"{name}.npz" if cache else None
        if path is not None and path.exists():
            scans += _read(path)
            continue
        try:
            source_scans = list(SOURCES[name]())
        except DataMissingError as error:
            missing.append(f"{name}: {error}")
            continue
        if path is not None:
            _write(path, source_scans)
        scans += source_scans
    return scans, missing


def _write(path: Path, scans: list[Scan]) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    arrays = {f"points{k}": scan.points.astype(np.float32) for k, scan in enumerate(scans)}
    poses = np.array([np.full((4, 4), np.nan) if scan.pose is None else scan.pose for scan in scans])
    names = np.array([(scan.name, scan.scene, scan.kind) for scan in scans])
    np.savez(path, names=names, poses=poses, **arrays)  # type: ignore[arg-type]


def _read(path: Path) -> list[Scan]:
    with np.load(path) as file:
        names, poses = file["names"].tolist(), file["poses"]
        points = [file[f"points{k}"].astype(np.float64) for k in range(len(names))]
    return [
        Scan(*name, points=rows, pose=None if np.isnan(pose).any() else pose)
        for name, rows, pose in zip(names, points, poses, strict=True)
    ]
