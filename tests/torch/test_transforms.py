"""Which transforms of torch apply to which function, compared with the table of docs/torch.md.

A transform applies if its result is that of plain torch: derivatives are compared with finite differences or with
`torch.autograd.functional`, graphs and batches with the call and the loop.
"""

import re
from pathlib import Path

import pytest
import torch

import pointloom as loom
from pointloom import torch as functions

pytestmark = pytest.mark.filterwarnings("ignore:.torch.jit.script.:DeprecationWarning")  # forward mode of torch itself
PAGE = Path(__file__).resolve().parents[2] / "docs" / "torch.md"
POINTS, OTHERS, FEATURES = (
    torch.rand(rows, columns, generator=torch.Generator().manual_seed(rows), dtype=torch.float64)
    for rows, columns in ((12, 3), (15, 3), (15, 2))
)
CORNERS = torch.tensor([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=torch.float64)
FACES = torch.tensor([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
TURN = torch.tensor([[0.0, -1, 0, 2], [1, 0, 0, 1], [0, 0, 1, 0], [0, 0, 0, 1]], dtype=torch.float64)
CALLS = {
    "knn": lambda x: functions.knn(x, OTHERS, 3).sqdists,
    "ball_query": lambda x: functions.ball_query(x, OTHERS, 0.4, 1).sqdists.nan_to_num(posinf=0.0),
    "nearest": lambda x: functions.nearest(x, OTHERS).sqdists,
    "interpolate": lambda x: functions.interpolate(x, OTHERS, FEATURES),
    "voxel_pool": lambda x: functions.voxel_pool(x, 0.5).points,
    "chamfer_distance": lambda x: functions.chamfer_distance(x, OTHERS),
    "hausdorff_distance": lambda x: functions.hausdorff_distance(x, OTHERS),
    "point_to_mesh_distance": lambda x: functions.point_to_mesh_distance((CORNERS, FACES), x),
    "signed_distance": lambda x: functions.signed_distance((CORNERS, FACES), x),
    "transform": lambda x: functions.transform(x, TURN),
    "icp": lambda x: functions.icp(x, OTHERS[:12], max_distance=1.0),
    "normals": lambda x: functions.normals(x, 6),
}


def scalar(run):
    """A weighted sum of a function's result, so that derivatives of all its entries are distinguished."""

    def weighted(x):
        result = run(x)
        weights = torch.linspace(0.5, 1.5, result.numel(), dtype=torch.float64).reshape(result.shape)
        return (result * weights).sum()

    return weighted


def differences(run, at, step=1e-6):
    rows = torch.eye(at.numel(), dtype=at.dtype).reshape(-1, *at.shape) * step
    return torch.stack([(run(at + row) - run(at - row)) / (2 * step) for row in rows]).reshape(at.shape)


def gradient(run, at, **options):
    given = at.clone().requires_grad_() if not at.requires_grad else at
    return torch.autograd.grad(run(given), given, **options)[0]


def _second(run):
    weights = torch.linspace(-1, 1, POINTS.numel(), dtype=torch.float64).reshape(POINTS.shape)

    def along(x):
        return (gradient(scalar(run), x, create_graph=True) * weights).sum()

    if run is CALLS["transform"] or run is CALLS["voxel_pool"]:  # linear in the points: the second derivative is 0
        return torch.func.hessian(scalar(run))(POINTS).sum(), torch.tensor(0.0, dtype=torch.float64)
    return gradient(along, POINTS), differences(lambda x: along(x).detach(), POINTS)


def _exported(run):
    class Module(torch.nn.Module):
        def forward(self, x):
            return run(x)

    return torch.export.export(Module(), (POINTS,)).module()(POINTS)


def _compiled(run):
    torch._dynamo.reset()
    return torch.compile(run, fullgraph=True, backend="aot_eager")(POINTS)


def _batched(run):
    batch = torch.stack([POINTS, POINTS.flip(0)])
    return torch.func.vmap(run)(batch), torch.stack([run(each) for each in batch])


def _half(run):
    with torch.autocast("cpu", dtype=torch.bfloat16):
        found = run(POINTS.bfloat16())
    return found.double(), run(POINTS.bfloat16().double()).to(found.dtype).double()


def _jacobian(run):
    return torch.autograd.functional.jacobian(run, POINTS)


TRANSFORMS = {
    "`backward`": lambda run: (gradient(scalar(run), POINTS), differences(scalar(run), POINTS)),
    "second derivative": _second,
    "`func.grad`": lambda run: (torch.func.grad(scalar(run))(POINTS), gradient(scalar(run), POINTS)),
    "`func.jacrev`": lambda run: (torch.func.jacrev(run)(POINTS), _jacobian(run)),
    "`func.jacfwd`, `forward_ad`": lambda run: (torch.func.jacfwd(run)(POINTS), _jacobian(run)),
    "`func.vmap`": _batched,
    "`compile`": lambda run: (_compiled(run), run(POINTS)),
    "`export`": lambda run: (_exported(run), run(POINTS)),
    "`autocast`": _half,
}
ERRORS = RuntimeError, NotImplementedError, torch._dynamo.exc.UserError


def stated():
    """The table of the page: for each function the cells of its row, by transform."""
    text = PAGE.read_text().split("<!-- transforms -->\n")[1].split("\n<!-- /transforms -->")[0]
    header, _, *rows = text.splitlines()
    columns = [cell.strip() for cell in header.strip("|").split("|")[1:]]
    table = {}
    for row in rows:
        names, *cells = (cell.strip() for cell in row.strip("|").split("|"))
        for name in re.findall(r"`(\w+)`", names):
            table[name] = dict(zip(columns, cells, strict=True))
    return table


def test_the_table_names_each_function_and_transform():
    assert stated().keys() == CALLS.keys() and all(list(row) == list(TRANSFORMS) for row in stated().values())


@pytest.mark.parametrize("transform", TRANSFORMS)
@pytest.mark.parametrize("name", CALLS)
def test_a_transform_applies_as_the_page_states(name, transform):
    cell = stated()[name][transform]
    if cell == "yes":
        found, expected = TRANSFORMS[transform](CALLS[name])
        torch.testing.assert_close(found, expected, rtol=1e-5, atol=1e-6)
    else:
        assert cell == "error"
        with pytest.raises(ERRORS):
            TRANSFORMS[transform](CALLS[name])


def test_an_argument_with_a_tangent_raises_without_a_forward_formula():
    for name in ("icp", "normals"):
        with pytest.raises(NotImplementedError, match=r"has no forward-mode derivative\. Use reverse mode"):
            torch.func.jacfwd(CALLS[name])(POINTS)


def test_indices_have_no_tangents_and_lose_none():
    def chosen(x):
        return x[loom.torch.farthest_points(x, 4)] * loom.torch.voxel_indices(x, 0.5).max()

    way = torch.ones_like(POINTS)
    _, found = torch.func.jvp(chosen, (POINTS,), (way,))
    torch.testing.assert_close(
        found, torch.ones(4, 3, dtype=torch.float64) * loom.torch.voxel_indices(POINTS, 0.5).max()
    )
