"""Distances of batches of clouds against torch.cdist in float64, their gradients, layouts, types and errors."""

import pytest
import torch

import pointloom as loom

LAYOUT = (torch.tensor([7, 4, 0]), torch.tensor([6, 2, 3]))


def clouds(*shape, seed=0, dtype=torch.float64):
    return torch.rand(*shape, generator=torch.Generator().manual_seed(seed), dtype=torch.float64).to(dtype)


def leaves(*tensors):
    return tuple(each.clone().requires_grad_() for each in tensors)


def chamfer_by_cdist(a, b, norm=2):
    d = torch.cdist(a, b, compute_mode="donot_use_mm_for_euclid_dist") ** norm
    return d.amin(-1).mean(-1) + d.amin(-2).mean(-1)


def hausdorff_by_cdist(a, b):
    d = torch.cdist(a, b, compute_mode="donot_use_mm_for_euclid_dist")
    return torch.maximum(d.amin(-1).amax(-1), d.amin(-2).amax(-1))


def ragged(points, lengths):
    """The points of a dense batch without padding, and the cloud of each."""
    rows = torch.cat([cloud[:size] for cloud, size in zip(points, lengths.tolist(), strict=True)])
    return rows, torch.repeat_interleave(torch.arange(len(points)), lengths)


@pytest.mark.parametrize("norm", [1, 2])
@pytest.mark.parametrize("size", [(5, 1), (300, 200), (1, 5000)])
def test_chamfer_distances_and_gradients_match_those_of_cdist(norm, size):
    a, b = leaves(clouds(3, size[0], 3), clouds(3, size[1], 3, seed=1))
    found, expected = loom.torch.chamfer_distance(a, b, norm=norm), chamfer_by_cdist(a, b, norm)
    torch.testing.assert_close(found, expected, rtol=1e-12, atol=0)
    grads, others = (torch.autograd.grad(each.square().sum(), (a, b)) for each in (found, expected))
    torch.testing.assert_close(grads, others, rtol=1e-9, atol=1e-14)


def test_hausdorff_distances_and_gradients_match_those_of_cdist():
    a, b = leaves(clouds(4, 70, 3), clouds(4, 90, 3, seed=1))
    found, expected = loom.torch.hausdorff_distance(a, b), hausdorff_by_cdist(a, b)
    torch.testing.assert_close(found, expected, rtol=1e-12, atol=0)
    grads, others = (torch.autograd.grad(each.square().sum(), (a, b)) for each in (found, expected))
    torch.testing.assert_close(grads, others, rtol=1e-9, atol=1e-14)


def test_f_scores_are_the_fractions_of_points_that_are_closer():
    a, b = clouds(3, 80, 3), clouds(3, 60, 3, seed=1)
    d = torch.cdist(a, b)
    found = loom.torch.f_score(a, b, 0.1)
    precision, recall = (d.amin(2) < 0.1).double().mean(1), (d.amin(1) < 0.1).double().mean(1)
    torch.testing.assert_close(found.precision, precision)
    torch.testing.assert_close(found.recall, recall)
    torch.testing.assert_close(found.fscore, 2 * precision * recall / (precision + recall))
    assert loom.torch.f_score(a, a + 9, 0.1).fscore.tolist() == [0, 0, 0]
    reference = loom.compute_metrics(loom.PointCloud(a[0].numpy()), loom.PointCloud(b[0].numpy()), fscore_radius=[0.1])
    assert found.fscore[0].item() * 100 == pytest.approx(float(reference.fscore[0]), rel=1e-5)
    a.requires_grad_()
    assert not loom.torch.f_score(a, b, 0.1).fscore.requires_grad


def test_normals_are_compared_without_their_sign_and_length():
    a, b = clouds(2, 5, 3), clouds(2, 6, 3, seed=1)
    m, n = clouds(2, 5, 3, seed=2) - 0.5, clouds(2, 6, 3, seed=3) - 0.5
    d, cos = torch.cdist(a, b), torch.nn.functional.cosine_similarity(m[:, :, None], n[:, None], dim=-1).abs()
    expected = 2 - cos.gather(2, d.argmin(2)[..., None]).mean((1, 2)) - cos.gather(1, d.argmin(1)[:, None]).mean((1, 2))
    for one, other in ((m, n), (-3 * m, 0.5 * n)):
        distance, found = loom.torch.chamfer_distance(a, b, normals=(one, other))
        torch.testing.assert_close(found, expected)
        assert torch.equal(distance, loom.torch.chamfer_distance(a, b))
    assert loom.torch.chamfer_distance(a, b, normals=(0 * m, n))[1].tolist() == [2, 2]


@pytest.mark.parametrize("axes", [1, 2, 3])
def test_gradients_of_both_orders_match_finite_differences(axes):
    sizes = (7, 6, 7, 6)
    a, b, m, n = leaves(*(clouds(3, size, axes, seed=seed) for seed, size in enumerate(sizes)))
    calls = {
        "squared": (lambda a, b: loom.torch.chamfer_distance(a, b, lengths=LAYOUT), (a, b)),
        "norm": (lambda a, b: loom.torch.chamfer_distance(a, b, norm=1), (a, b)),
        "normals": (lambda a, b, m, n: loom.torch.chamfer_distance(a, b, normals=(m, n)), (a, b, m, n)),
        "hausdorff": (lambda a, b: loom.torch.hausdorff_distance(a, b, lengths=LAYOUT), (a, b)),
    }
    for call, given in calls.values():

        def finite(*given, call=call):
            return [each[:2] for each in _tuple(call(*given))]  # the third is infinite or 0

        assert torch.autograd.gradcheck(finite, given, fast_mode=True)
        assert torch.autograd.gradgradcheck(finite, given, fast_mode=True)


def _tuple(values):
    return values if isinstance(values, tuple) else (values,)


def test_layouts_of_the_same_clouds_have_the_same_distances_and_gradients():
    a, b = clouds(3, 7, 3), clouds(3, 6, 3, seed=1)
    (rows, batch), (other_rows, other_batch) = ragged(a, LAYOUT[0]), ragged(b, LAYOUT[1])
    offsets = tuple(torch.cat([torch.zeros(1, dtype=torch.int64), sizes.cumsum(0)]) for sizes in LAYOUT)
    for name, call in {
        "chamfer": loom.torch.chamfer_distance,
        "hausdorff": loom.torch.hausdorff_distance,
        "fscore": lambda a, b, **layout: loom.torch.f_score(a, b, 0.3, **layout).fscore,
    }.items():
        a, b, rows, other_rows = leaves(a, b, rows, other_rows)
        found = call(a, b, lengths=LAYOUT)
        for layout in ({"batch": (batch, other_batch), "batch_size": 3}, {"offsets": offsets}):
            torch.testing.assert_close(call(rows, other_rows, **layout), found, rtol=1e-14, atol=0)
        single = call(a[0], b[0, :6])
        assert single.shape == () and torch.equal(single, call(a[:1], b[:1, :6])[0])
        if name == "fscore":
            assert found[2] == 0
            continue
        assert found[2] == torch.inf
        grads = torch.autograd.grad(found[:2].sum(), (a, b))
        others = torch.autograd.grad(call(rows, other_rows, offsets=offsets)[:2].sum(), (rows, other_rows))
        for grad, other, sizes in zip(grads, others, LAYOUT, strict=True):
            torch.testing.assert_close(ragged(grad, sizes)[0], other, rtol=1e-12, atol=1e-15)


def test_clouds_without_points_have_distance_0_or_infinity():
    none, some = torch.zeros(2, 0, 3), torch.rand(2, 4, 3)
    for call in (loom.torch.chamfer_distance, loom.torch.hausdorff_distance):
        assert call(none, none).tolist() == [0, 0]
        assert call(none, some).tolist() == call(some, none).tolist() == [torch.inf] * 2
        assert call(torch.zeros(0, 5, 3), torch.zeros(0, 4, 3)).shape == (0,)
    assert loom.torch.f_score(none, some, 1.0).fscore.tolist() == [0, 0]


def test_equal_points_have_gradient_0():
    a, b = leaves(clouds(2, 9, 3), clouds(2, 9, 3))
    for call in (loom.torch.hausdorff_distance, lambda a, b: loom.torch.chamfer_distance(a, b, norm=1)):
        (grad,) = torch.autograd.grad(call(a, b).sum(), a)
        assert not grad.any()


@pytest.mark.parametrize("dtype", [torch.float32, torch.float16, torch.bfloat16])
def test_results_have_the_type_of_the_clouds(dtype):
    a, b = leaves(clouds(2, 50, 3, dtype=dtype), clouds(2, 60, 3, seed=1, dtype=dtype))
    for found in (
        loom.torch.chamfer_distance(a, b),
        loom.torch.chamfer_distance(a, b, norm=1),
        loom.torch.hausdorff_distance(a, b),
    ):
        assert found.dtype == dtype
        assert torch.autograd.grad(found.sum(), a)[0].dtype == dtype
    wide = loom.torch.chamfer_distance(a.double(), b.double())
    torch.testing.assert_close(loom.torch.chamfer_distance(a, b).double(), wide, rtol=1e-2, atol=0)
    with torch.autocast("cpu", torch.bfloat16):
        assert torch.equal(loom.torch.chamfer_distance(a, b), loom.torch.chamfer_distance(a, b))
        assert loom.torch.chamfer_distance(a.float(), b.float()).dtype == torch.float32


def test_graphs_are_compiled_without_breaks_and_runs_are_identical():
    a, b = clouds(4, 200, 3, dtype=torch.float32), clouds(4, 150, 3, seed=1, dtype=torch.float32)

    def loss(a, b):
        return loom.torch.chamfer_distance(a, b, norm=1).sum() + loom.torch.hausdorff_distance(a, b).sum()

    results = []
    for call in (loss, loss, torch.compile(loss, fullgraph=True, backend="aot_eager")):
        one, other = leaves(a, b)
        value = call(one, other)
        value.backward()
        results.append((value.detach(), one.grad, other.grad))
    for result in results[1:]:
        assert all(torch.equal(x, y) for x, y in zip(results[0], result, strict=True))


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda a: loom.torch.chamfer_distance(a, a[:1]), ValueError, r"source and target: .*\[2, 5, 3\].*\[1, 5, 3\]"),
        (lambda a: loom.torch.chamfer_distance(a, a[..., :2]), ValueError, r"coordinates, got \[2, 5, 3\] and \[2, 5, 2\]"),  # noqa: E501
        (lambda a: loom.torch.chamfer_distance(a, a, norm=3), ValueError, "^norm: expected 1 or 2, got 3"),
        (lambda a: loom.torch.chamfer_distance(a, a, norm=True), ValueError, "^norm: expected 1 or 2, got True"),
        (lambda a: loom.torch.chamfer_distance(a.int(), a), TypeError, "^source: expected float32.* got torch.int32"),
        (lambda a: loom.torch.chamfer_distance(a.numpy(), a), TypeError, "^source: expected a torch tensor, got ndarray"),  # noqa: E501
        (lambda a: loom.torch.chamfer_distance(a, a, normals=a), TypeError, "^normals: expected a pair"),
        (lambda a: loom.torch.chamfer_distance(a, a, normals=(a, a[:, :2])), ValueError, r"target: .*\[2, 2, 3\], points \[2, 5"),  # noqa: E501
        (lambda a: loom.torch.chamfer_distance(torch.rand(2, 5, 4), torch.rand(2, 5, 4)), ValueError, "at most 3 coordinates"),  # noqa: E501
        (lambda a: loom.torch.f_score(a, a, 0.0), ValueError, "^threshold: expected a number > 0, got 0.0"),
        (lambda a: loom.torch.f_score(a, a, float("nan")), ValueError, "^threshold: expected a number > 0, got nan"),
        (lambda a: loom.torch.f_score(a, a, "1"), TypeError, "^threshold: expected a number, got "),
        (lambda a: loom.torch.hausdorff_distance(a, a, length=1), TypeError, "has no argument 'length'; did you mean 'lengths'"),  # noqa: E501
    ],
)  # fmt: skip  # one case per line
def test_errors_name_the_argument_and_the_shapes(call, error, message):
    with pytest.raises(error, match=message):
        call(torch.rand(2, 5, 3))
