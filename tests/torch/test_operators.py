"""Operators in torch: opcheck, torch.compile, autocast, vmap, determinism, processes, and imports without torch."""

import decimal
import fractions
import inspect
import os
import subprocess
import sys

import numpy as np
import pytest
import torch

import pointloom as loom
from pointloom.torch.neighbors import batch_neighbors
from pointloom.torch.operators import gather_rows, scatter_sum
from pointloom.torch.sampling import batch_farthest_points


def clouds(*shape, seed=0, dtype=torch.float32):
    return torch.rand(*shape, generator=torch.Generator().manual_seed(seed), dtype=torch.float64).to(dtype)


def tables(count, size):
    return torch.arange(count, dtype=torch.int32) * size, torch.full((count,), size, dtype=torch.int32)


def operators():
    values, index = clouds(20, 2).requires_grad_(), torch.arange(30) % 25 - 2
    query, points = clouds(12, 3).requires_grad_(), clouds(15, 3, seed=1).requires_grad_()
    return {
        "gather_rows": (gather_rows, (values, index)),
        "scatter_sum": (scatter_sum, (values, index[:20], 9)),
        "batch_neighbors": (
            batch_neighbors,
            (query, points, torch.stack([*tables(3, 4), *tables(3, 5)]), 5, 2, float("inf"), True, False),
        ),
        "batch_farthest_points": (batch_farthest_points, (points.detach(), *tables(3, 5), 2)),
    }  # fmt: skip


@pytest.mark.parametrize("name", operators())
def test_operators_pass_the_checks_of_torch(name):
    checks = ["test_schema", "test_autograd_registration", "test_faketensor"]
    if name != "batch_neighbors":  # this check adds up integers and floats. Compiled graphs are tested below
        checks.append("test_aot_dispatch_dynamic")
    operator, given = operators()[name]
    torch.library.opcheck(operator.made, given, test_utils=checks)


@pytest.mark.parametrize("rows", [1, 7, 300])
def test_sums_and_gathers_are_those_of_torch_with_first_and_second_derivatives(rows):
    values, index = clouds(40, 3, dtype=torch.float64).requires_grad_(), torch.arange(40) * 7 % (rows + 1) - 1
    is_row = index >= 0
    expected = torch.zeros(rows, 3, dtype=torch.float64).index_add_(0, index[is_row], values.detach()[is_row])
    torch.testing.assert_close(scatter_sum(values, index, rows).detach(), expected)
    table = clouds(rows, 3, seed=1, dtype=torch.float64).requires_grad_()
    torch.testing.assert_close(gather_rows(table, index)[is_row], table[index[is_row]])
    assert (gather_rows(table, index)[~is_row] == 0).all()
    for run, given in ((lambda v: scatter_sum(v, index, rows), values), (lambda t: gather_rows(t, index), table)):
        assert torch.autograd.gradcheck(run, given)
        assert torch.autograd.gradgradcheck(lambda v, run=run: run(v).square(), given)


def network(points, features, lengths):
    """A use of each function, as of a layer."""
    chosen = loom.torch.farthest_points(points, 8, lengths=lengths)
    centers = torch.gather(points, 1, chosen.clamp(min=0)[..., None].expand(-1, -1, 3))
    near = loom.torch.ball_query(centers, points, 0.5, 4, lengths=(None, lengths))
    pooled = loom.torch.voxel_pool(points, 0.4, features, lengths=lengths, max_voxels=40)
    spread = loom.torch.interpolate(points, centers, centers.sin())
    distances = torch.where(near.indices >= 0, near.sqdists, 0)
    return distances.sum() + pooled.features.square().sum() + pooled.points.sin().sum() + spread.sum()


def gradients(run, points, features, lengths):
    given = points.clone().requires_grad_(), features.clone().requires_grad_()
    loss = run(*given, lengths)
    return (loss.detach(), *torch.autograd.grad(loss, given))


@pytest.mark.parametrize("dynamic", [False, True])
def test_compiled_graphs_have_no_break_and_the_same_result(dynamic):
    torch._dynamo.reset()
    compiled = torch.compile(network, fullgraph=True, backend="aot_eager", dynamic=dynamic)
    for size in (40, 50):
        given = clouds(2, size, 3), clouds(2, size, 5, seed=1), torch.tensor([size, 17])
        torch.testing.assert_close(gradients(compiled, *given), gradients(network, *given))


@pytest.mark.parametrize("layout", ["batch", "offsets"])
def test_compiled_graphs_take_ragged_batches(layout):
    torch._dynamo.reset()
    points, labels = clouds(60, 3), torch.arange(60) // 20

    def run(points):
        given = {"batch": labels, "batch_size": 3} if layout == "batch" else {"offsets": torch.arange(4) * 20}
        return loom.torch.knn(points, points, 5, **given).sqdists.sum()

    torch.testing.assert_close(torch.compile(run, fullgraph=True, backend="aot_eager")(points), run(points))


def test_autocast_computes_distances_of_half_types_in_float32():
    points = clouds(2, 40, 3)
    with torch.autocast("cpu", dtype=torch.bfloat16):
        moved = torch.nn.functional.linear(points, torch.eye(3))  # bfloat16 in autocast
        found = loom.torch.knn(moved, points, 3)
        assert moved.dtype == found.sqdists.dtype == torch.bfloat16
    exact = loom.torch.knn(moved.float(), points, 3)
    torch.testing.assert_close(found.sqdists, exact.sqdists.bfloat16(), rtol=0, atol=0)


def test_deterministic_algorithms_are_all_there_are():
    points, features = clouds(2, 60, 3), clouds(2, 60, 4, seed=1)
    torch.use_deterministic_algorithms(True)
    try:
        first, again = (gradients(network, points, features, torch.tensor([60, 33])) for _ in range(2))
    finally:
        torch.use_deterministic_algorithms(False)
    for a, b in zip(first, again, strict=True):
        assert torch.equal(a, b)


@pytest.mark.parametrize("in_dims", [(0, 0), (0, None), (1, 0)])
def test_vmap_searches_the_clouds_of_an_axis_at_once(in_dims):
    query, points = clouds(4, 4, 3), clouds(4, 9, 3, seed=1)
    given = query, points[0] if in_dims[1] is None else points
    found = torch.vmap(lambda q, p: loom.torch.knn(q, p, 3).sqdists, in_dims=in_dims)(*given)
    rows = query.transpose(0, 1) if in_dims[0] == 1 else query
    alone = [loom.torch.knn(rows[b], given[1] if in_dims[1] is None else points[b], 3).sqdists for b in range(4)]
    torch.testing.assert_close(found, torch.stack(alone), rtol=0, atol=0)


def test_vmap_of_each_function_gives_the_results_and_gradients_of_a_loop():
    points, features, labels = clouds(3, 20, 3), clouds(3, 20, 2, seed=1), torch.arange(20) // 8

    def run(points, features):
        near = loom.torch.knn(points, points, 3, batch=labels, batch_size=3)
        chosen = loom.torch.farthest_points(points, 4)
        spread = loom.torch.interpolate(points, points[chosen], features[chosen])
        return near.indices, chosen, near.sqdists.sum() + (spread * features).sum()

    for index in range(2):
        found = torch.vmap(lambda *given, index=index: run(*given)[index])(points, features)
        assert torch.equal(found, torch.stack([run(*given)[index] for given in zip(points, features, strict=True)]))
    given = points.clone().requires_grad_(), features.clone().requires_grad_()
    found = torch.autograd.grad(torch.vmap(lambda *each: run(*each)[2])(*given).sum(), given)
    alone = torch.autograd.grad(sum(run(*each)[2] for each in zip(*given, strict=True)), given)
    torch.testing.assert_close(found, alone)


class Neighborhoods(torch.utils.data.Dataset):
    def __len__(self):
        return 6

    def __getitem__(self, k):
        points = clouds(50, 3, seed=k)
        return loom.torch.knn(points, points, 4).sqdists


@pytest.mark.parametrize("method", ["fork", "spawn", "forkserver"])
def test_workers_of_a_data_loader_search(method):
    expected = torch.stack([Neighborhoods()[k] for k in range(6)])
    loader = torch.utils.data.DataLoader(Neighborhoods(), batch_size=3, num_workers=2, multiprocessing_context=method)
    torch.testing.assert_close(torch.cat(list(loader)), expected, rtol=0, atol=0)


def test_importing_pointloom_does_not_import_torch():
    code = "import sys, pointloom as loom; loom.torch; assert 'torch' not in sys.modules; loom.torch.knn"
    subprocess.run([sys.executable, "-c", code], check=True, env={**os.environ})


def test_without_torch_the_error_names_the_remedy(monkeypatch):
    code = "import sys; sys.modules['torch'] = None\nimport pointloom as loom\nloom.torch.knn"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert "ImportError: pointloom.torch needs torch 2.4 or later: pip install pointloom[torch]" in run.stderr


# One good call of each function: its scalar arguments are replaced one at a time.
SCALARS = {
    "knn": {"k": 2, "batch_size": 1},
    "ball_query": {"radius": 0.5, "k": 2, "batch_size": 1},
    "nearest": {"batch_size": 1},
    "farthest_points": {"num_samples": 2, "batch_size": 1},
    "voxel_indices": {"voxel_size": 0.5, "batch_size": 1},
    "voxel_pool": {"voxel_size": 0.5, "max_voxels": 2, "batch_size": 1},
    "interpolate": {"k": 2, "batch_size": 1},
    "chamfer_distance": {"norm": 2, "batch_size": 1},
    "hausdorff_distance": {"batch_size": 1},
    "f_score": {"threshold": 0.5, "batch_size": 1},
    "normals": {"k": 5, "batch_size": 1},
    "icp": {"max_distance": 0.5, "max_iterations": 2},
}
HOSTILE = [
    -1, 0, 2**31, 2**32, 2**63, 2**64, 10**400, -(2**63), 0.5, 5e-324, 1e308, float("inf"), float("nan"),
    decimal.Decimal("nan"), fractions.Fraction(1, 3), np.float32(2), np.int64(2), np.array([1, 2]), "2", b"2", True,
    1j, [2], {}, object(), torch.tensor(2.5), torch.tensor([1, 2]), torch.empty((), device="meta"),
]  # fmt: skip
TENSORS = [None, [[0.0, 0, 0]], np.zeros((4, 3)), "points", 3, torch.zeros(4, 3, device="meta")]


def good_arguments(name):
    cloud, labels = clouds(12, 3), torch.zeros(12, dtype=torch.long)
    pairs = ("knn", "ball_query", "nearest", "interpolate", "chamfer_distance", "hausdorff_distance", "f_score", "icp")
    tensors = [cloud, cloud + 0.01] if name in pairs else [cloud]
    if name == "interpolate":
        tensors.append(clouds(12, 1))
    return tensors, SCALARS[name] | ({"batch": labels} if "batch_size" in SCALARS[name] else {})


@pytest.mark.parametrize(("name", "argument"), [(name, each) for name in SCALARS for each in SCALARS[name]])
def test_a_number_of_any_kind_gives_a_result_or_an_error_that_names_it(name, argument):
    tensors, named = good_arguments(name)
    call = getattr(loom.torch, name)
    call(*tensors, **named)
    for value in HOSTILE:
        try:
            call(*tensors, **named | {argument: value})
        except (TypeError, ValueError) as error:
            assert argument in str(error).split(":")[0] or "batch" in str(error).split(":")[0], (value, error)


@pytest.mark.parametrize("name", [*SCALARS, "transform"])
def test_what_is_no_tensor_is_named(name):
    tensors, named = ([clouds(4, 3), torch.eye(4)], {}) if name == "transform" else good_arguments(name)
    for row in range(len(tensors)):
        for value in TENSORS:
            with pytest.raises((TypeError, ValueError), match=r"^\w+( and \w+)?: expected"):
                getattr(loom.torch, name)(*[value if k == row else each for k, each in enumerate(tensors)], **named)


def test_the_table_of_numbers_has_all_functions():
    taken = {name for name in dir(loom.torch) if inspect.isfunction(getattr(loom.torch, name)) and name[0] != "_"}
    assert taken - {"transform", "point_to_mesh_distance", "signed_distance"} == set(SCALARS)


@pytest.mark.parametrize("points", [[[-1.0, 0, 0], [1, 0, 0]], [[1.0, 0, 0], [2, 0, 0]], [[-1.0, -1, -1]]])
def test_a_grid_beyond_float64_is_refused(points):
    with pytest.raises(ValueError, match=r"^voxel_size: 5e-324 makes a grid of .*inf.* cells"):
        loom.torch.voxel_indices(torch.tensor(points), 5e-324)
