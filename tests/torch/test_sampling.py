"""Farthest points, voxels and interpolation of batches of clouds against NumPy, torch and finite differences."""

import math

import numpy as np
import pytest
import torch

import pointloom as loom


def clouds(*shape, seed=0, dtype=torch.float32):
    return torch.rand(*shape, generator=torch.Generator().manual_seed(seed), dtype=torch.float64).to(dtype)


def leaves(*tensors):
    return tuple(each.detach().clone().requires_grad_() for each in tensors)


def farthest_by_hand(points, count):
    d, chosen = np.full(len(points), np.inf), []
    for _ in range(min(count, len(points))):
        chosen.append(0 if not chosen else int(d.argmax()))
        d = np.minimum(d, np.square(points - points[chosen[-1]]).sum(1))
        d[chosen] = -1
    return chosen + [-1] * (count - len(chosen))


@pytest.mark.parametrize("dtype", [torch.float32, torch.float64])
@pytest.mark.parametrize("shift", [0.0, 1000.0])
def test_farthest_points_are_those_of_the_plain_algorithm(dtype, shift):
    points, lengths = clouds(4, 90, 3, dtype=dtype) + shift, torch.tensor([90, 5, 0, 40])
    chosen = loom.torch.farthest_points(points, 9, lengths=lengths)
    for cloud, size, row in zip(points.double().numpy(), lengths.tolist(), chosen.tolist(), strict=True):
        assert row == farthest_by_hand(cloud[:size], 9)
    single = loom.torch.farthest_points(points[0], 9)
    torch.testing.assert_close(single, chosen[0])


def test_farthest_points_of_ragged_clouds_are_rows_of_all_points():
    points, offsets = clouds(100, 3), torch.tensor([0, 30, 30, 100])
    chosen = loom.torch.farthest_points(points, 5, offsets=offsets)
    labels = torch.repeat_interleave(torch.arange(3), offsets.diff())
    torch.testing.assert_close(chosen, loom.torch.farthest_points(points, 5, batch=labels))
    assert chosen[0].tolist() == farthest_by_hand(points[:30].numpy(), 5)
    assert chosen[1].tolist() == [-1] * 5
    assert (chosen[2] - 30).tolist() == farthest_by_hand(points[30:].numpy(), 5)


def test_farthest_points_have_no_gradient():
    points = clouds(20, 3).requires_grad_()
    assert not loom.torch.farthest_points(points, 4).requires_grad


@pytest.mark.parametrize("dtype", [torch.float32, torch.float64, torch.bfloat16])
def test_voxels_are_those_of_unique_cells(dtype):
    points = (clouds(3, 200, 3, dtype=torch.float64) * 4 - 2).to(dtype)
    lengths = torch.tensor([200, 0, 77])
    indices = loom.torch.voxel_indices(points, 0.7, lengths=lengths)
    is_point = torch.arange(200) < lengths[:, None]
    assert (indices[~is_point] == -1).all()
    cells = torch.floor(points.double() / 0.7).long()
    keys = torch.cat([torch.arange(3)[:, None, None].expand(3, 200, 1), cells], -1)[is_point]
    torch.testing.assert_close(indices[is_point], torch.unique(keys, dim=0, return_inverse=True)[1])
    packed = loom.torch.voxel_indices(points[is_point], 0.7, batch=keys[:, 0], batch_size=3)
    torch.testing.assert_close(packed, indices[is_point])


def test_points_that_are_not_finite_are_in_no_voxel():
    points = clouds(9, 3)
    points[3, 1], points[5, 0] = math.nan, math.inf
    indices = loom.torch.voxel_indices(points, 0.5)
    assert indices[[3, 5]].tolist() == [-1, -1] and indices.max() + 1 == len(indices[indices >= 0].unique())


def test_pooled_points_and_features_are_means_with_gradients():
    points, features = clouds(60, 3, dtype=torch.float64), clouds(60, 4, seed=1, dtype=torch.float64)
    labels = torch.arange(60) // 20
    pooled = loom.torch.voxel_pool(points, 0.5, features, batch=labels)
    for row in range(len(pooled.counts)):
        own = pooled.indices == row
        assert own.sum() == pooled.counts[row] and (labels[own] == pooled.batch[row]).all()
        torch.testing.assert_close(pooled.points[row], points[own].mean(0))
        torch.testing.assert_close(pooled.features[row], features[own].mean(0))

    def means(*given):
        return loom.torch.voxel_pool(given[0], 0.5, given[1], batch=labels[::6])[:2]

    given = leaves(points[::6], features[::6])
    assert torch.autograd.gradcheck(means, given) and torch.autograd.gradgradcheck(means, given)


@pytest.mark.parametrize("max_voxels", [3, 500])
def test_a_given_number_of_voxels_needs_no_wait_and_pads_or_cuts(max_voxels):
    points = clouds(2, 50, 3)
    whole, padded = loom.torch.voxel_pool(points, 0.4), loom.torch.voxel_pool(points, 0.4, max_voxels=max_voxels)
    count = min(max_voxels, len(whole.counts))
    assert padded.points.shape == (max_voxels, 3)
    for name in ("points", "batch", "counts"):
        torch.testing.assert_close(getattr(padded, name)[:count], getattr(whole, name)[:count])
    assert (padded.batch[count:] == -1).all() and (padded.counts[count:] == 0).all()


def test_interpolated_features_are_weighted_means_with_gradients():
    query, points = clouds(2, 5, 3, dtype=torch.float64), clouds(2, 8, 3, seed=1, dtype=torch.float64)
    features = clouds(2, 8, 2, seed=2, dtype=torch.float64)
    d = torch.cdist(query, points).square().topk(3, largest=False)
    weights = (1 / d.values) / (1 / d.values).sum(-1, keepdim=True)
    rows = features[torch.arange(2)[:, None, None], d.indices]
    torch.testing.assert_close(loom.torch.interpolate(query, points, features), (weights[..., None] * rows).sum(2))
    near = loom.torch.interpolate(query, points, features, k=1)
    torch.testing.assert_close(near, rows[:, :, 0])
    given = leaves(query, points, features)
    assert torch.autograd.gradcheck(loom.torch.interpolate, given)
    assert torch.autograd.gradgradcheck(loom.torch.interpolate, given)


def test_interpolation_at_a_point_is_its_feature_and_zero_without_neighbors():
    points, features = clouds(3, 9, 3), clouds(3, 9, 4, seed=1)
    torch.testing.assert_close(loom.torch.interpolate(points, points, features), features)
    lengths = torch.tensor([9, 9, 9]), torch.tensor([9, 0, 1])
    found = loom.torch.interpolate(points, points, features, lengths=lengths)
    assert (found[1] == 0).all()
    torch.testing.assert_close(found[2], features[2, :1].expand(9, 4))


@pytest.mark.parametrize("dtype", [torch.float16, torch.bfloat16])
def test_half_types_are_computed_in_float32_and_returned_as_given(dtype):
    points, features = clouds(2, 30, 3, dtype=dtype), clouds(2, 30, 4, seed=1, dtype=dtype)
    pooled = loom.torch.voxel_pool(points, 0.5, features)
    assert pooled.points.dtype == pooled.features.dtype == dtype
    exact = loom.torch.voxel_pool(points.float(), 0.5, features.float())
    torch.testing.assert_close(pooled.features, exact.features.to(dtype), rtol=0, atol=0)
    assert loom.torch.interpolate(points, points, features).dtype == dtype


def test_errors_state_the_shapes():
    points = clouds(2, 30, 3)
    for run, message in (
        (
            lambda: loom.torch.farthest_points(points[..., :2], 3),
            r"points: expected shape \[B, N, 3\].*got \[2, 30, 2\]",
        ),
        (lambda: loom.torch.farthest_points(points, 0), "num_samples: expected an integer >= 1, got 0"),
        (lambda: loom.torch.voxel_indices(points, 0.0), "voxel_size: expected a finite number > 0, got 0.0"),
        (lambda: loom.torch.voxel_indices(points, 1e-9), r"voxel_size: 1e-09 makes a grid of .* cells"),
        (
            lambda: loom.torch.voxel_pool(points, 0.1, clouds(2, 29, 4)),
            r"\[2, 30, C\], as the points, got \[2, 29, 4\]",
        ),
        (lambda: loom.torch.interpolate(points, points, clouds(30, 4)), r"\[2, 30, C\], as the points, got \[30, 4\]"),
    ):
        with pytest.raises(ValueError, match=message):
            run()
