"""ICP from coarse to fine: larger convergence basin, and one scale equals plain ICP."""

import numpy as np

import pointloom as loom

from .icp_clouds import PLANE, back, on, wavy
from .poses import as_pose

reg = loom.registration


def test_multiple_scales_enlarge_the_convergence_basin(device, rng, angle_between):
    """Open3D's tutorial: three voxel sizes with distances; the finest scale alone fails."""
    T = as_pose([0.2, -0.3, 0.4], [0.3, -0.2, 0.2])
    target = loom.PointCloud(wavy(rng, 12_000), device=device).estimate_normals(max_nn=20)
    source = loom.PointCloud(back(wavy(rng, 12_000), T), device=device)
    rules = [reg.ICPConvergenceCriteria(1e-4, 1e-4, 20), reg.ICPConvergenceCriteria(1e-5, 1e-5, 15)]
    rules += [reg.ICPConvergenceCriteria(1e-6, 1e-6, 10)]
    steps = []
    result = reg.multi_scale_icp(
        source, target, [0.1, 0.05, -1], rules, [0.3, 0.14, 0.07], None, PLANE, callback_after_iteration=steps.append
    )
    alone = reg.registration_icp(source, target, 0.07, None, PLANE, rules[2])
    assert angle_between(result.transformation, T) < 0.02 < 5 < angle_between(alone.transformation, T)
    assert result.fitness > 0.98 and len(result.correspondence_set) > 11_000
    assert [t["scale_index"] for t in steps] == sorted(t["scale_index"] for t in steps)
    assert {t["scale_index"] for t in steps} == {0, 1, 2} and result.iterations == len(steps)


def test_one_scale_equals_plain_icp(device, full_pair):
    source, target = on(device, *full_pair[:2])
    rules = reg.ICPConvergenceCriteria(max_iteration=7)
    one = reg.multi_scale_icp(source, target, [-1], [rules], [0.1], full_pair[2], PLANE)
    plain = reg.registration_icp(source, target, 0.1, full_pair[2], PLANE, rules)
    np.testing.assert_array_equal(one.transformation, plain.transformation)
    result = reg.multi_scale_icp(source, target, [-1], [rules], [0.1], full_pair[2], PLANE, overlap=1.0)
    np.testing.assert_array_equal(result.transformation, plain.transformation)


def test_a_low_overlap_is_estimated(device, rng, angle_between):
    points, others = wavy(rng, 16_000), wavy(rng, 16_000)
    T = as_pose([0.02, -0.01, 0.03], [0.02, 0.01, -0.02])
    target = loom.PointCloud(others[others[:, 0] > -0.25], device=device).estimate_normals(max_nn=20)
    source = loom.PointCloud(back(points[points[:, 0] < 0.25], T), device=device)
    rules = [reg.ICPConvergenceCriteria(1e-6, 1e-6, 40)]
    trimmed, full = (
        reg.multi_scale_icp(source, target, [0.03], rules, [0.4], None, PLANE, overlap=overlap)
        for overlap in (None, 1.0)
    )
    assert angle_between(trimmed.transformation, T) < 0.2 * angle_between(full.transformation, T)
    again = reg.evaluate_registration(
        source.voxel_down_sample(0.03), target.voxel_down_sample(0.03), 0.4, trimmed.transformation
    )
    assert trimmed.fitness == again.fitness and len(trimmed.correspondence_set) == len(again.correspondence_set)
