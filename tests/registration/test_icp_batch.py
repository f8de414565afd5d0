"""Batched registrations: each job matches its individual result, independent of the other jobs."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom

from .icp_clouds import KINDS, wavy
from .poses import as_pose

reg = loom.registration
RULES = reg.ICPConvergenceCriteria(1e-7, 1e-7, 25)
EACH = pytest.mark.parametrize("kind", [kind for kind in KINDS if kind not in ("voxelized", "doppler")])


def cloud_of(points, device, shift=(0, 0, 0)):
    points = np.asarray(points, float).reshape(-1, 3)
    normals = np.tile([0.0, 0, 1], (len(points), 1))
    colors = 0.5 + 0.4 * np.sin(5 * np.nan_to_num(points))
    cloud = loom.PointCloud(points + np.asarray(shift), normals=normals, colors=colors, device=device)
    return cloud.estimate_normals(max_nn=15) if len(points) > 3 else cloud


def offsets(rng, count):
    return [as_pose(0.03 * rng.normal(size=3), 0.02 * rng.normal(size=3)) for _ in range(count)]


def failures(result):
    """The failed checks without the cloud positions, which only a registration of one pair checks."""
    return [warning.split(":")[0] for warning in result.warnings]


def assert_alike(one, other, *, bits=False):
    """Two results: equal within rounding, or bitwise."""
    close = (lambda a, b: a == b) if bits else (lambda a, b: abs(a - b) <= 1e-12)
    if bits:
        np.testing.assert_array_equal(one.transformation, other.transformation)
    np.testing.assert_allclose(one.transformation, other.transformation, atol=1e-12)
    assert close(one.fitness, other.fitness) and close(one.inlier_rmse, other.inlier_rmse)
    facts = [(r.iterations, r.converged, failures(r), len(r.degenerate_directions)) for r in (one, other)]
    assert facts[0] == facts[1]
    np.testing.assert_array_equal(one.correspondence_set, other.correspondence_set)


@EACH
def test_jobs_of_all_sizes_match_individual_results(device, kind, rng):
    """Includes clouds that are empty, have one, two or three points, or only NaN."""
    sizes = [700, 0, 1, 300, 2, 3, 1025, 64, 500, 8]
    targets, sources = [], []
    for i, n in enumerate(sizes):
        points = wavy(rng, max(n, 1))[:n]
        targets.append(cloud_of(wavy(rng, 900 + 31 * i), device))
        sources.append(cloud_of(np.full((n, 3), np.nan) if i == 8 else points, device))
    targets[3] = cloud_of(np.zeros((0, 3)), device)
    inits = offsets(rng, len(sizes))
    together = reg.registration_icp_batch(sources, targets, 0.15, np.array(inits), KINDS[kind], RULES)
    assert len(together) == len(sizes)
    for result, source, target, init in zip(together, sources, targets, inits, strict=True):
        assert_alike(result, reg.registration_icp(source, target, 0.15, init, KINDS[kind], RULES))
    for i in (1, 3, 8):
        assert together[i].warnings == ("no correspondences",) and together[i].fitness == 0
        np.testing.assert_allclose(together[i].transformation, inits[i], atol=1e-14)
    assert together[0].fitness > 0.9 and together[6].fitness > 0.9


@pytest.mark.filterwarnings("ignore::pointloom.UnitWarning")  # a valid warning for such a start
@EACH
def test_many_poses_of_one_pair_match_individual_results_bitwise(device, kind, rng):
    source, target = (cloud_of(wavy(rng, n), device) for n in (800, 1100))
    inits = offsets(rng, 12)
    inits[5] = as_pose(shift=[50, 0, 0])  # no pairs
    together = reg.registration_icp_batch(source, target, 0.15, inits, KINDS[kind], RULES)
    for result, init in zip(together, inits, strict=True):
        assert_alike(result, reg.registration_icp(source, target, 0.15, init, KINDS[kind], RULES), bits=True)
    assert len({r.iterations for r in together}) > 1  # they end at different times
    assert together[5].warnings == ("no correspondences",)


def test_clouds_can_be_shared_between_jobs(device, rng):
    clouds = [cloud_of(wavy(rng, 400 + 50 * i), device) for i in range(4)]
    left, right = [0, 1, 2, 3, 0, 0, 2, 1], [1, 1, 0, 2, 3, 1, 3, 0]
    jobs = ([clouds[i] for i in side] for side in (left, right))
    results = reg.registration_icp_batch(*jobs, 0.2, None, KINDS["plane"])
    for result, s, t in zip(results, left, right, strict=True):
        assert_alike(result, reg.registration_icp(clouds[s], clouds[t], 0.2, None, KINDS["plane"]))
    assert_alike(results[0], results[5], bits=True)


def test_jobs_can_be_at_any_location(device, rng):
    """Each cloud has its own origin, hundreds of kilometers apart."""
    origins = [(0, 0, 0), (5e5, 5.4e6, 100), (-3e6, 2e4, 0), (1e5, 0, 0)]
    points = [(wavy(rng, 500), wavy(rng, 600)) for _ in origins]
    sources = [cloud_of(s, device, origin) for (s, _), origin in zip(points, origins, strict=True)]
    targets = [cloud_of(t, device, origin) for (_, t), origin in zip(points, origins, strict=True)]
    results = reg.registration_icp_batch(sources, targets, 0.2, None, KINDS["plane"], RULES)
    for result, (s, t), origin in zip(results, points, origins, strict=True):
        near = reg.registration_icp(cloud_of(s, device), cloud_of(t, device), 0.2, None, KINDS["plane"], RULES)
        T = result.transformation
        np.testing.assert_allclose(T[:3, :3], near.transformation[:3, :3], atol=1e-6)
        moved = T[:3, :3] @ origin + T[:3, 3] - origin
        np.testing.assert_allclose(moved, near.transformation[:3, 3], atol=1e-6)


@pytest.mark.parametrize("options", [{"overlap": 0.6}, {"max_normal_angle": 0.3}, {"overlap": 0.9, "degeneracy": 0}])
def test_options_apply_to_each_job(device, options, rng):
    sources, targets = ([cloud_of(wavy(rng, n), device) for n in sizes] for sizes in ((300, 650), (800, 500)))
    results = reg.registration_icp_batch(sources, targets, 0.3, None, KINDS["plane"], RULES, **options)
    for result, s, t in zip(results, sources, targets, strict=True):
        assert_alike(result, reg.registration_icp(s, t, 0.3, None, KINDS["plane"], RULES, **options))


@pytest.mark.parametrize("kind", ["voxelized", "doppler"])
def test_voxels_and_speeds_are_batched(device, kind, rng):
    """Voxels are counted from a corner shared by all targets; a single job uses another corner."""
    method = KINDS[kind]
    sources = [loom.PointCloud(wavy(rng, 600), dopplers=np.zeros(600, np.float32), device=device) for _ in range(3)]
    targets = [cloud_of(wavy(rng, 900), device) for _ in range(3)]
    inits = offsets(rng, 3)
    results = reg.registration_icp_batch(sources, targets, 0.2, inits, method, RULES)
    for result, s, t, init in zip(results, sources, targets, inits, strict=True):
        alone = reg.registration_icp(s, t, 0.2, init, method, RULES)
        if kind == "doppler":
            assert_alike(result, alone)
        assert np.abs(result.transformation - alone.transformation).max() < 0.02 and result.fitness > 0.9


@settings(max_examples=20, deadline=None)
@given(
    seed=st.integers(0, 2**16),
    counts=st.lists(st.tuples(st.integers(0, 40), st.integers(0, 40)), min_size=1, max_size=6),
    kind=st.sampled_from(["point", "plane", "symmetric"]),
    overlap=st.sampled_from([1.0, 0.7]),
)
def test_any_batch_matches_its_jobs(seed, counts, kind, overlap):
    rng = np.random.default_rng(seed)
    pairs = [[cloud_of(rng.normal(size=(n, 3)), "cpu") for n in count] for count in counts]
    sources, targets = (list(side) for side in zip(*pairs, strict=True))
    rules = reg.ICPConvergenceCriteria(0, 0, 2)
    results = reg.registration_icp_batch(sources, targets, 2.0, None, KINDS[kind], rules, overlap=overlap)
    for result, s, t in zip(results, sources, targets, strict=True):
        alone = reg.registration_icp(s, t, 2.0, None, KINDS[kind], rules, overlap=overlap)
        assert failures(result) == failures(alone)
        if len(set(alone.correspondence_set[:, 1])) >= 6:  # with fewer, rounding determines rotations
            np.testing.assert_allclose(result.transformation, alone.transformation, atol=1e-8)
            assert result.fitness == alone.fitness
