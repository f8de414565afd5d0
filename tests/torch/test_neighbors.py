"""Neighbors of batches of clouds against float64 brute force and torch.cdist, their gradients, layouts and errors."""

import math

import numpy as np
import pytest
import torch

import pointloom as loom

TYPES = [torch.float32, torch.float64, torch.float16, torch.bfloat16]


def clouds(*shape, seed=0, dtype=torch.float32):
    return torch.rand(*shape, generator=torch.Generator().manual_seed(seed), dtype=torch.float64).to(dtype)


def leaves(*tensors):
    return tuple(each.detach().clone().requires_grad_() for each in tensors)


def brute_force(query, points, k, lengths=None, radius=math.inf):
    """(indices, sqdists) in float64, ties by index: (B, N, k)."""
    d = (query.double()[:, :, None] - points.double()[:, None]).square().sum(-1)
    if lengths is not None:
        rows, columns = (torch.arange(n) for n in d.shape[1:])
        d[(columns >= lengths[1][:, None])[:, None].expand_as(d)] = math.inf
        d[(rows >= lengths[0][:, None])[..., None].expand_as(d)] = math.inf
    d[~(d < radius**2)] = math.inf
    sqdists, indices = d.sort(dim=-1, stable=True)
    return torch.where(sqdists < math.inf, indices, -1)[..., :k], sqdists[..., :k]


@pytest.mark.parametrize("dtype", TYPES)
@pytest.mark.parametrize(("size", "k"), [((1, 1, 1), 1), ((4, 30, 70), 16), ((2, 900, 700), 5), ((40, 9, 65), 3)])
def test_neighbors_are_those_of_brute_force_in_float64(dtype, size, k):
    count, rows, columns = size
    query, points = clouds(count, rows, 3, dtype=dtype), clouds(count, columns, 3, seed=1, dtype=dtype)
    for first in (query, points):
        found, (indices, sqdists) = loom.torch.knn(first, points, k), brute_force(first, points, k)
        assert found.sqdists.dtype == dtype and found.indices.dtype == torch.int64
        torch.testing.assert_close(found.sqdists, sqdists.to(dtype), rtol=4 * torch.finfo(dtype).eps, atol=1e-12)
        if dtype == torch.float64:
            torch.testing.assert_close(found.indices, indices, rtol=0, atol=0)
        else:  # neighbors whose distances float32 cannot tell apart may change places
            exact = first.double()[:, :, None] - points.double()[torch.arange(count)[:, None, None], found.indices]
            torch.testing.assert_close(exact.square().sum(-1), sqdists, rtol=1e-6, atol=1e-12)


def test_distances_are_those_of_cdist():
    query, points = clouds(5, 200, 3), clouds(5, 300, 3, seed=1)
    expected = torch.cdist(query, points, compute_mode="donot_use_mm_for_euclid_dist").topk(8, largest=False)
    found = loom.torch.knn(query, points, 8)
    torch.testing.assert_close(found.sqdists.sqrt(), expected.values)
    assert (found.indices == expected.indices).float().mean() > 0.999


def test_lengths_exclude_padding_of_both_arguments():
    query, points = clouds(4, 20, 3, dtype=torch.float64), clouds(4, 30, 3, seed=1, dtype=torch.float64)
    lengths = torch.tensor([20, 3, 0, 7]), torch.tensor([2, 30, 9, 0])
    found, expected = loom.torch.knn(query, points, 4, lengths=lengths), brute_force(query, points, 4, lengths)
    torch.testing.assert_close(tuple(found), expected)
    whole = loom.torch.knn(query, points, 4, lengths=(None, lengths[1]))
    torch.testing.assert_close(tuple(whole), brute_force(query, points, 4, (torch.full((4,), 20), lengths[1])))


@pytest.mark.parametrize("layout", ["batch", "offsets"])
def test_ragged_layouts_give_the_rows_of_the_dense_one(layout):
    sizes = torch.tensor([0, 7, 40, 0, 1, 90, 0])
    rows = clouds(int(sizes.sum()), 3)
    offsets = torch.cat([torch.zeros(1, dtype=torch.int64), sizes.cumsum(0)])
    labels = torch.repeat_interleave(torch.arange(len(sizes)), sizes)
    given = {"batch": labels, "batch_size": len(sizes)} if layout == "batch" else {"offsets": offsets}
    found = loom.torch.knn(rows, rows, 5, **given)
    for first, size in zip(offsets.tolist(), sizes.tolist(), strict=False):
        part = rows[first : first + size]
        if size:
            alone = loom.torch.knn(part, part, 5)
            torch.testing.assert_close(found.sqdists[first : first + size], alone.sqdists, rtol=0, atol=0)
            indices = torch.where(alone.indices < 0, -1, alone.indices + first)
            torch.testing.assert_close(found.indices[first : first + size], indices, rtol=0, atol=0)
    others = clouds(20, 3, seed=2)
    owners = torch.sort(torch.arange(20) % len(sizes)).values
    if layout == "batch":
        between = loom.torch.nearest(others, rows, batch=(owners, labels))
        assert ((between.indices < 0) == (sizes[owners] == 0)).all()
        is_found = between.indices >= 0
        assert (labels[between.indices[is_found]] == owners[is_found]).all()


def test_ball_queries_and_nearest_are_parts_of_the_nearest():
    query, points = clouds(3, 50, 3), clouds(3, 80, 3, seed=1)
    all_of_them = loom.torch.knn(query, points, 9)
    ball = loom.torch.ball_query(query, points, 0.2, 9)
    is_near = all_of_them.sqdists < 0.04
    torch.testing.assert_close(ball.indices, torch.where(is_near, all_of_them.indices, -1), rtol=0, atol=0)
    torch.testing.assert_close(ball.sqdists, torch.where(is_near, all_of_them.sqdists, math.inf), rtol=0, atol=0)
    nearest = loom.torch.nearest(query, points)
    torch.testing.assert_close(nearest.sqdists, all_of_them.sqdists[..., 0], rtol=0, atol=0)
    torch.testing.assert_close(nearest.indices, all_of_them.indices[..., 0], rtol=0, atol=0)


@pytest.mark.parametrize("axes", [1, 2])
def test_fewer_coordinates_are_those_of_a_line_or_a_plane(axes):
    query, points = clouds(3, 40, axes, dtype=torch.float64), clouds(3, 50, axes, seed=1, dtype=torch.float64)
    torch.testing.assert_close(tuple(loom.torch.knn(query, points, 4)), brute_force(query, points, 4))
    few = leaves(query[:, :6], points[:, :7])  # of many, two would be closer than the steps of the differences
    assert torch.autograd.gradcheck(lambda *given: loom.torch.knn(*given, 3).sqdists, few)


LAYOUTS = {
    "dense": {},
    "lengths": {"lengths": (torch.tensor([6, 2, 0]), torch.tensor([5, 3, 4]))},
    "batch": {"batch": (torch.arange(18) // 6, torch.arange(21) // 7)},
    "offsets": {"offsets": (torch.tensor([0, 1, 9, 18]), torch.tensor([0, 11, 11, 21]))},
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_first_and_second_derivatives_are_those_of_finite_differences(layout):
    query, points = clouds(3, 6, 3, dtype=torch.float64), clouds(3, 7, 3, seed=1, dtype=torch.float64)
    if layout in ("batch", "offsets"):
        query, points = query.reshape(-1, 3), points.reshape(-1, 3)

    def sqdists(*given):
        found = loom.torch.knn(*given, 4, **LAYOUTS[layout]).sqdists
        return torch.where(found < math.inf, found, 0)

    assert torch.autograd.gradcheck(sqdists, leaves(query, points))
    assert torch.autograd.gradgradcheck(sqdists, leaves(query, points))


def test_a_point_that_is_query_and_point_has_both_gradients():
    (points,) = leaves(clouds(2, 12, 3, dtype=torch.float64))
    assert torch.autograd.gradcheck(lambda p: loom.torch.knn(p, p, 4).sqdists, points)


def test_gradients_of_missing_neighbors_are_zero_and_never_nan():
    query, points = leaves(clouds(2, 5, 3), clouds(2, 3, 3, seed=1))
    found = loom.torch.knn(query, points, 6).sqdists
    found[found < math.inf].sum().backward()
    assert query.grad.isfinite().all() and points.grad.isfinite().all() and (query.grad != 0).any()


def test_gradients_are_bitwise_equal_in_each_run():
    query, points = clouds(1, 30_000, 3), clouds(1, 500, 3, seed=1)

    def gradients():
        given = leaves(query, points)
        loom.torch.knn(*given, 8).sqdists.sin().sum().backward()
        return [each.grad.numpy().tobytes() for each in given]

    first = gradients()
    loom.set_num_threads(1)
    try:
        assert gradients() == first
    finally:
        loom.set_num_threads(None)
    assert gradients() == first


def test_points_that_are_not_finite_have_no_neighbors():
    points = clouds(1, 30, 3)
    points[0, 4] = math.nan
    found = loom.torch.knn(points, points, 29)
    assert (found.indices[0, 4] == -1).all() and not (found.indices == 4).any()
    assert (found.indices[0, [0, 1]] >= 0).all()


def test_no_clouds_and_no_points_have_no_neighbors():
    for shape in ((0, 5, 3), (3, 0, 3), (0, 3)):
        empty = torch.empty(shape)
        found = loom.torch.knn(empty, empty, 2)
        assert found.indices.shape == found.sqdists.shape == (*shape[:-1], 2)
    found = loom.torch.knn(clouds(2, 4, 3), torch.empty(2, 0, 3), 3)
    assert (found.indices == -1).all() and (found.sqdists == math.inf).all()


def test_tensors_that_are_not_contiguous_are_searched():
    points = clouds(3, 40, 4)[..., 1:]
    torch.testing.assert_close(loom.torch.knn(points, points, 3), loom.torch.knn(points.clone(), points.clone(), 3))
    turned = clouds(2, 3, 40).transpose(1, 2)
    torch.testing.assert_close(
        loom.torch.knn(turned, turned, 3), loom.torch.knn(turned.contiguous(), turned.contiguous(), 3)
    )


ERRORS = {
    "query: expected shape .*got \\[20\\]": (torch.rand(20), torch.rand(20, 3), 1, {}),
    "expected the same number of coordinates.*\\[5, 2\\] and \\[5, 3\\]": (torch.rand(5, 2), torch.rand(5, 3), 1, {}),
    "at most 3 coordinates, got shape \\[5, 4\\]": (torch.rand(5, 4), torch.rand(5, 4), 1, {}),
    "\\[2, 5, 3\\] \\(2 clouds\\) and \\[3, 5, 3\\] \\(3 clouds\\)": (torch.rand(2, 5, 3), torch.rand(3, 5, 3), 1, {}),
    "same number of clouds and layout": (torch.rand(1, 5, 3), torch.rand(5, 3), 1, {}),
    "query: expected a torch tensor, got ndarray": (np.zeros((5, 3)), torch.rand(5, 3), 1, {}),
    "expected float32, float64, float16 or bfloat16, got torch.int64": (torch.ones(5, 3).long(),) * 2 + (1, {}),
    "k: expected an integer >= 1, got 0": (torch.rand(5, 3), torch.rand(5, 3), 0, {}),
    "k: expected an integer, got ": (torch.rand(5, 3), torch.rand(5, 3), 2.5, {}),
    "lengths: expected shape \\[2\\], got \\[3\\] for query of shape \\[2, 5, 3\\]": (
        torch.rand(2, 5, 3), torch.rand(2, 5, 3), 1, {"lengths": torch.ones(3).long()},
    ),
    "lengths: expected 0..5, .*got 1..6": (
        torch.rand(2, 5, 3), torch.rand(2, 5, 3), 1, {"lengths": torch.tensor([1, 6])},
    ),
    "lengths: expected integers, got torch.float32": (
        torch.rand(2, 5, 3), torch.rand(2, 5, 3), 1, {"lengths": torch.ones(2)},
    ),
    "query: expected shape \\[B, N, D\\], got \\[5, 3\\]": (
        torch.rand(5, 3), torch.rand(5, 3), 1, {"lengths": torch.ones(1).long()},
    ),
    "batch: expected ascending clouds": (
        torch.rand(3, 3), torch.rand(3, 3), 1, {"batch": torch.tensor([1, 0, 1])},
    ),
    "batch: expected clouds 0..1, got 0..2": (
        torch.rand(3, 3), torch.rand(3, 3), 1, {"batch": torch.tensor([0, 1, 2]), "batch_size": 2},
    ),
    "offsets: expected 0 .. 3 in ascending order.*got 0 .. 4": (
        torch.rand(3, 3), torch.rand(3, 3), 1, {"offsets": torch.tensor([0, 4])},
    ),
    "got lengths and batch": (
        torch.rand(3, 3), torch.rand(3, 3), 1, {"batch": torch.zeros(3).long(), "lengths": torch.ones(1).long()},
    ),
    "offsets: expected a tensor for both arguments or a pair": (
        torch.rand(3, 3), torch.rand(3, 3), 1, {"offsets": (torch.tensor([0, 3]),) * 3},
    ),
    "query: expected a tensor on the CPU or on a CUDA device, got meta": (
        torch.rand(3, 3, device="meta"), torch.rand(3, 3, device="meta"), 1, {},
    ),
}  # fmt: skip


@pytest.mark.parametrize("message", ERRORS)
def test_errors_state_the_shapes(message):
    query, points, k, layout = ERRORS[message]
    with pytest.raises((TypeError, ValueError), match=message):
        loom.torch.knn(query, points, k, **layout)


@pytest.mark.parametrize("radius", [0.0, -1.0, math.nan])
def test_a_radius_that_is_not_positive_is_rejected(radius):
    with pytest.raises(ValueError, match="radius: expected a number > 0"):
        loom.torch.ball_query(torch.rand(4, 3), torch.rand(4, 3), radius, 2)
