"""registration_icp_batch: a thousand small pairs point to plane, beside a loop of Open3D calls on prepared clouds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, load_open3d, timed, waiting
from reasons import CALL

DISTANCE = 0.15  # [m]
EDGE = 1.0  # [m] of a patch


@dataclass(frozen=True)
class Patches:
    """Lists of sources [n, 3], targets [n, 3] and target normals, all exact in float32."""

    sources: list[np.ndarray]
    targets: list[np.ndarray]
    normals: list[np.ndarray]


def patches(count: int) -> Any:
    """Pairs of 500 to 1,000 points of patches of a bumpy surface, sampled twice, about 2 degrees and 2 cm apart."""

    def make() -> Patches:
        from scipy.spatial.transform import Rotation

        rng = np.random.default_rng(0)
        sources, targets, normals = [], [], []
        for _ in range(count):
            corner = rng.uniform(-2, 2, 2)
            R = Rotation.from_rotvec(np.radians(2) * rng.normal(size=3) / 3**0.5).as_matrix()
            shift = 0.02 * rng.normal(size=3) / 3**0.5
            source, target = (sample(rng, corner, rng.integers(500, 1001)) for _ in range(2))
            sources.append(exact((source[0] - shift) @ R))
            targets.append(exact(target[0]))
            normals.append(exact(target[1]))
        return Patches(sources, targets, normals)

    return make


def sample(rng: np.random.Generator, corner: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Points of a patch around its center, and their normals."""
    u, v = rng.uniform(-EDGE / 2, EDGE / 2, (2, count))
    x, y = u + corner[0], v + corner[1]
    z = 0.15 * np.sin(3 * x) * np.cos(2 * y) + 0.03 * np.sin(11 * x + 5 * y)
    slope_x = 0.45 * np.cos(3 * x) * np.cos(2 * y) + 0.33 * np.cos(11 * x + 5 * y)
    slope_y = -0.3 * np.sin(3 * x) * np.sin(2 * y) + 0.15 * np.cos(11 * x + 5 * y)
    n = np.stack([-slope_x, -slope_y, np.ones(count)], axis=1)
    return np.stack([u, v, z], axis=1), n / np.linalg.norm(n, axis=1)[:, None]


def exact(values: np.ndarray) -> np.ndarray:
    return values.astype(np.float32).astype(np.float64)


def prepare_pointloom(scene: Patches, device: str) -> Any:
    import pointloom as loom

    reg = loom.registration
    sources = [loom.PointCloud(p, device=device) for p in scene.sources]
    pairs = zip(scene.targets, scene.normals, strict=True)
    targets = [loom.PointCloud(p, normals=n, device=device) for p, n in pairs]
    method = reg.TransformationEstimationPointToPlane()
    options = {"degeneracy": 0}  # some patches are nearly flat: pointloom would fix a motion, Open3D would not
    batch = reg.registration_icp_batch
    rules = reg.ICPConvergenceCriteria(
        relative_rmse=1e-6
    )  # [m] as in Open3D; pointloom's default depends on the patch size
    return waiting(lambda: batch(sources, targets, DISTANCE, None, method, rules, **options), device, "warp")


def prepare_open3d(scene: Patches, device: str) -> Any:
    o3d = load_open3d()
    reg, vectors = o3d.pipelines.registration, o3d.utility.Vector3dVector
    sources, targets = ([o3d.geometry.PointCloud(vectors(p)) for p in side] for side in (scene.sources, scene.targets))
    for cloud, normals in zip(targets, scene.normals, strict=True):
        cloud.normals = vectors(normals)
    method = reg.TransformationEstimationPointToPlane()
    identity = np.eye(4)
    return lambda: [
        reg.registration_icp(s, t, DISTANCE, identity, method) for s, t in zip(sources, targets, strict=True)
    ]


def poses_of(results: Any) -> np.ndarray:
    return np.array([np.asarray(r.transformation) for r in results])


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same poses; steps about the pair's center instead of the origin may converge one step earlier or
    later.
    """
    differences = np.abs(actual - reference).max(axis=(1, 2))
    assert (differences < 1e-6).mean() > 0.9, f"{(differences >= 1e-6).mean():.1%} of the poses are not {peer}'s"
    assert differences.max() < 5e-3, f"a pose differs by {differences.max():.2e} from {peer}'s"


PARTS_OF_TIME = (
    "Two fifths of the time are searches, a fifth sums of the rows, the rest sorts, copies and work per pair."
)
BATCH = Operation(
    name="icp_batch",
    scenes={"1000 pairs": patches(1000), "50 pairs": patches(50), "1 pair": patches(1)},
    quick={"50 pairs": patches(50)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, poses_of, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, poses_of),
    ),
    check=check,
    memory_size="1000 pairs",
    unit_count=lambda scene: len(scene.sources),
    targets={"1000 pairs": 4, "50 pairs": 4},
    reasons={"1 pair": CALL, "1000 pairs": PARTS_OF_TIME, "50 pairs": PARTS_OF_TIME},
)
OPERATIONS = (BATCH,)


@timed(BATCH)
def test_icp_batch(time_lap) -> None:
    time_lap()
