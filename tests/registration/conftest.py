"""What the tests of registration share: pairs of real scans with their true poses, and made-up pairs without noise."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from .poses import as_pose


def bumpy_surface(rng: np.random.Generator, count: int) -> np.ndarray:
    """Points on a 2 x 2 m surface whose bumps fix all six directions of motion."""
    xy = rng.uniform(-1, 1, (count, 2))
    z = 0.2 * np.sin(3 * xy[:, 0]) * np.cos(4 * xy[:, 1]) + 0.1 * np.sin(7 * xy[:, 1] + xy[:, 0])
    return np.column_stack([xy, z])


@pytest.fixture(scope="session")
def angle_between():
    """A function: the angle [degrees] between two poses' rotations, by the logarithm."""
    from scipy.spatial.transform import Rotation

    return lambda A, B: float(np.degrees(Rotation.from_matrix(A[:3, :3] @ B[:3, :3].T).magnitude()))


@pytest.fixture(scope="session")
def surface_pair():
    """A surface sampled twice, 4,000 points each, `T` from source to target: 4 degrees and 5 cm."""
    rng = np.random.default_rng(5)
    T = as_pose([0.03, -0.05, 0.04], [0.03, -0.03, 0.02])
    target, source = bumpy_surface(rng, 4000), bumpy_surface(rng, 4000)
    return SimpleNamespace(source=(source - T[:3, 3]) @ T[:3, :3], target=target, T=T)


@pytest.fixture(scope="session")
def kitti_pair(data):
    """Two LiDAR scans of 69,000 points and `T`, which takes the source's coordinates to the target's."""
    import pointloom as loom

    folder = data / "reg-small-gicp"
    read = loom.read_point_cloud
    return SimpleNamespace(
        source=read(folder / "source.ply").points,
        target=read(folder / "target.ply").points,
        T=np.loadtxt(folder / "T_target_source.txt"),
    )


@pytest.fixture(scope="session")
def kitchen_pair(data):
    """Fragments 4 (source) and 0 (target) of a kitchen, 55 % overlap, and `T`: 12.7 degrees and 0.69 m."""
    import pointloom as loom

    folder = data / "reg-teaser-3dmatch" / "data"
    read = loom.read_point_cloud
    return SimpleNamespace(
        source=read(folder / "cloud_bin_4.ply").points,
        target=read(folder / "cloud_bin_0.ply").points,
        T=np.loadtxt(folder / "T_0_from_4.txt"),
    )
