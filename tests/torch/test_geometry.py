"""Distances to meshes, normals, transformations and ICP on tensors: results, gradients, layouts, types and errors."""

import numpy as np
import pytest
import torch

import pointloom as loom


def seeded(*shape, seed=0, dtype=torch.float64):
    return torch.rand(*shape, generator=torch.Generator().manual_seed(seed), dtype=torch.float64).to(dtype)


def sphere(resolution=6):
    mesh = loom.TriangleMesh.create_sphere(1.0, resolution)
    return torch.tensor(mesh.vertices), torch.tensor(mesh.triangles), mesh


def hills(count, seed=0, clouds=2):
    """Points of a curved surface, (clouds, count, 3)."""
    xy = seeded(clouds, count, 2, seed=seed)
    return torch.cat([xy, 0.2 * torch.sin(5 * xy[..., :1]) * torch.cos(4 * xy[..., 1:])], -1)


def pair(seed=0):
    """Sources near their targets with noise, and the normals of the targets."""
    target = hills(60, seed)
    noise = torch.randn(2, 40, 3, generator=torch.Generator().manual_seed(seed), dtype=torch.float64)
    source = target[:, :40] + 0.01 * noise + torch.tensor([0.02, -0.01, 0.01])
    return source.requires_grad_(), target.requires_grad_(), loom.torch.normals(target.detach(), 12).requires_grad_()


def sampled_distance(mesh, points):
    """Distances to the nearest of many points of each triangle, float64."""
    vertices, triangles, _ = mesh
    grid = torch.linspace(0, 1, 60, dtype=torch.float64)
    u, v = torch.meshgrid(grid, grid, indexing="ij")
    inside = u + v <= 1 + 1e-12
    weights = torch.stack([1 - u - v, u, v], -1)[inside]
    return torch.cdist(points, (weights @ vertices[triangles]).reshape(-1, 3)).amin(1)


def test_distances_match_those_of_points_on_the_triangles():
    mesh, points = sphere(), seeded(50, 3) * 4 - 2
    distance = loom.torch.point_to_mesh_distance(mesh[:2], points)
    dense = sampled_distance(mesh, points)
    assert (distance <= dense + 1e-12).all() and (dense - distance).max() < 0.01
    scene = loom.RaycastingScene()
    scene.add_triangles(mesh[2])
    signed = loom.torch.signed_distance(mesh[:2], points)
    np.testing.assert_allclose(signed, scene.compute_signed_distance(points.numpy()), atol=1e-6)
    assert (signed < 0).any() and torch.equal(signed.abs(), distance)
    assert torch.equal(loom.torch.signed_distance(mesh[2], points), signed)
    assert torch.equal(loom.torch.signed_distance(mesh[2], points.reshape(5, 10, 3)), signed.reshape(5, 10))
    far = torch.tensor([5e5, 5.4e6, 100.0])
    moved = loom.torch.signed_distance((mesh[0] + far, mesh[1]), points + far)
    torch.testing.assert_close(moved, signed, rtol=0, atol=1e-8)


def test_each_part_of_a_triangle_has_its_distance_and_gradients():
    vertices = torch.tensor([[0.0, 0, 0], [4, 0, 0], [0, 3, 0]], dtype=torch.float64)
    points = torch.tensor([[1, 1, 2], [-3, -4, 0], [7, 0, 4], [0, 8, 12], [2, -3, 4], [-3, 1, 4], [4, 4, 0.0]])
    points = points.double().requires_grad_()
    triangle = torch.tensor([[0, 1, 2]])
    found = loom.torch.point_to_mesh_distance((vertices, triangle), points)
    np.testing.assert_allclose(found.tolist(), [2, 5, 5, 13, 5, 5, 16 / 5], rtol=1e-14)
    given = (vertices.clone().requires_grad_(), points)
    assert torch.autograd.gradcheck(lambda v, p: loom.torch.point_to_mesh_distance((v, triangle), p), given)
    assert torch.autograd.gradgradcheck(lambda v, p: loom.torch.point_to_mesh_distance((v, triangle), p), given)


def test_signed_distances_have_gradients_to_points_and_vertices():
    vertices, triangles, _ = sphere()
    points = (seeded(30, 3) * 3 - 1.5).requires_grad_()
    call = lambda v, p: loom.torch.signed_distance((v, triangles), p)  # noqa: E731
    assert torch.autograd.gradcheck(call, (vertices.requires_grad_(), points), fast_mode=True)
    (grad,) = torch.autograd.grad(call(vertices, points).sum(), points)
    torch.testing.assert_close(grad.norm(dim=1), torch.ones(30, dtype=torch.float64))


def test_degenerate_triangles_and_points_on_the_surface_have_finite_gradients():
    vertices = torch.tensor([[0.0, 0, 0], [1, 0, 0], [2, 0, 0], [1, 0, 0]], dtype=torch.float64, requires_grad=True)
    points = torch.tensor([[0.5, 0, 0], [1.5, 1, 0], [9, 0, 0]], dtype=torch.float64, requires_grad=True)
    for triangles in ([[0, 1, 2]], [[1, 3, 1]], [[1, 1, 1]]):
        found = loom.torch.point_to_mesh_distance((vertices, torch.tensor(triangles)), points)
        expected = [0, 1, 7] if triangles == [[0, 1, 2]] else [0.5, 1.25**0.5, 8]
        np.testing.assert_allclose(found.tolist(), expected, rtol=1e-14)
        assert all(torch.isfinite(grad).all() for grad in torch.autograd.grad(found.sum(), (vertices, points)))
    lost = torch.tensor([[torch.nan, 0, 0], [0.5, 1, 0]], dtype=torch.float64)
    found = loom.torch.point_to_mesh_distance((vertices, torch.tensor([[0, 1, 2]])), lost)
    assert found.isnan().tolist() == [True, False] and loom.torch.point_to_mesh_distance(
        sphere()[2], lost[:0]
    ).shape == (0,)


@pytest.mark.parametrize("layout", ["dense", "lengths", "offsets", "single"])
def test_normals_are_those_of_each_cloud(layout):
    points = hills(80, clouds=3)
    given = {"lengths": torch.tensor([80, 40, 2])} if layout == "lengths" else {}
    sizes = given["lengths"].tolist() if given else [80] * 3
    if layout == "offsets":
        given = {"offsets": torch.tensor([0, 80, 160, 240])}
    found = loom.torch.normals(
        points.reshape(-1, 3) if layout == "offsets" else points[0] if layout == "single" else points, 9, **given
    )
    for number, (cloud, size) in enumerate(zip(points, sizes, strict=True)):
        if layout == "single" and number:
            break
        expected = loom.PointCloud(cloud[:size].numpy()).estimate_normals(max_nn=9).normals
        own = found if layout == "single" else found.reshape(3, 80, 3)[number]
        np.testing.assert_allclose(np.abs((own[:size].numpy() * expected).sum(1)), 1, atol=1e-5)


def test_normals_have_no_gradient_and_the_type_of_the_points():
    points = hills(50).requires_grad_()
    with pytest.raises(RuntimeError, match=r"^normals has no derivative\. Detach"):
        loom.torch.normals(points).sum().backward()
    for dtype in (torch.float32, torch.float16, torch.bfloat16):
        assert loom.torch.normals(points.detach().to(dtype), 9).dtype == dtype
    assert loom.torch.normals(points[:, :2].detach()).reshape(-1, 3).tolist() == [[0, 0, 1]] * 4


def test_clouds_are_transformed_with_gradients():
    points, poses = seeded(3, 8, 3).requires_grad_(), seeded(3, 4, 4, seed=1).requires_grad_()
    expected = points @ poses[:, :3, :3].mT + poses[:, None, :3, 3]
    offsets = torch.tensor([0, 8, 16, 24])
    batch = torch.repeat_interleave(torch.arange(3), 8)
    rows = points.reshape(-1, 3)
    torch.testing.assert_close(loom.torch.transform(points, poses), expected, rtol=1e-14, atol=1e-15)
    for layout in ({"offsets": offsets}, {"batch": batch}):
        torch.testing.assert_close(loom.torch.transform(rows, poses, **layout).reshape(3, 8, 3), expected)
        assert torch.autograd.gradcheck(
            lambda p, T, layout=layout: loom.torch.transform(p, T, **layout), (rows, poses), fast_mode=True
        )
    one = loom.torch.transform(points, poses[1])
    torch.testing.assert_close(one[1], expected[1])
    torch.testing.assert_close(loom.torch.transform(points[1], poses[1]), expected[1])
    assert torch.autograd.gradgradcheck(loom.torch.transform, (points, poses), fast_mode=True)
    assert loom.torch.transform(points.half(), poses.float()).dtype == torch.float16


@pytest.mark.parametrize("to_planes", [False, True])
def test_poses_of_icp_have_the_gradients_of_finite_differences(to_planes):
    source, target, normals = pair()
    given = (source, target, normals) if to_planes else (source, target)
    call = lambda s, t, n=None: loom.torch.icp(s, t, max_distance=0.3, normals=n)  # noqa: E731
    assert torch.autograd.gradcheck(call, given, fast_mode=True)
    lengths = torch.tensor([40, 30]), torch.tensor([60, 50])
    some = lambda s, t, n=None: loom.torch.icp(s, t, max_distance=0.05, normals=n, lengths=lengths)  # noqa: E731
    assert torch.autograd.gradcheck(some, given, fast_mode=True)
    grads = torch.autograd.grad(some(*given).square().sum(), given)
    assert not grads[0][1, 30:].any() and not grads[1][1, 50:].any()


def test_poses_of_icp_are_those_of_each_pair():
    source, target, normals = pair(3)
    init = torch.eye(4).repeat(2, 1, 1)
    init[:, 0, 3] = 0.01
    poses = loom.torch.icp(source, target, init, max_distance=0.3, normals=normals)
    method = loom.registration.TransformationEstimationPointToPlane()
    for number in range(2):
        one = loom.torch.icp(source[number], target[number], init[number], max_distance=0.3, normals=normals[number])
        torch.testing.assert_close(one, poses[number], rtol=0, atol=1e-12)
        cloud = loom.PointCloud(target[number].detach().numpy(), normals=normals[number].detach().numpy())
        result = loom.registration.registration_icp(
            loom.PointCloud(source[number].detach().numpy()), cloud, 0.3, init[number].numpy(), method
        )
        np.testing.assert_allclose(poses[number].detach().numpy(), result.transformation, atol=1e-4)
    rows, offsets = source.reshape(-1, 3), torch.tensor([0, 40, 80])
    layout = {"offsets": (offsets, torch.tensor([0, 60, 120])), "normals": normals.reshape(-1, 3)}
    ragged = loom.torch.icp(rows, target.reshape(-1, 3), init, max_distance=0.3, **layout)
    torch.testing.assert_close(ragged, poses, rtol=0, atol=1e-12)
    assert loom.torch.icp(source.half(), target, max_distance=0.3).dtype == torch.float16


def test_poses_that_are_not_determined_have_no_gradient():
    flat = torch.cat([seeded(2, 100, 2), torch.zeros(2, 100, 1)], -1)
    up = torch.tensor([0.0, 0, 1]).expand(2, 100, 3)
    source = (flat + torch.tensor([0, 0, 0.01])).requires_grad_()
    poses = loom.torch.icp(source, flat, max_distance=0.2, normals=up)
    with pytest.raises(
        RuntimeError, match=r"icp: 1 of 2 poses have no gradient, such as that of cloud 1: .*detach these"
    ):
        poses[1].sum().backward()
    far = loom.torch.icp(source, flat + 9, max_distance=0.2)
    with pytest.raises(RuntimeError, match="icp: 2 of 2 poses have no gradient"):
        far.sum().backward()
    poses = loom.torch.icp(*pair()[:2], max_distance=0.3)
    assert torch.equal(poses, loom.torch.icp(*pair()[:2], max_distance=0.3))
    given = pair()[0]
    (grad,) = torch.autograd.grad(loom.torch.icp(given, pair()[1], max_distance=0.3).sum(), given, create_graph=True)
    with pytest.raises(RuntimeError, match="the gradient of icp has no derivative"):
        grad.sum().backward()


@pytest.mark.parametrize("shape", ["cone", "box"])
def test_a_cone_turns_about_its_axis_and_a_box_does_not(shape):
    """Surfaces that MIN_DETERMINED was not chosen on."""
    height, angle = seeded(1, 600) + 0.2, 2 * torch.pi * seeded(1, 600, seed=1)
    axes = angle.cos(), angle.sin()
    points, normals = (
        torch.stack([height * axes[0], height * axes[1], height], -1),
        torch.stack([*axes, -(axes[0] ** 0)], -1),
    )
    if shape == "box":
        normals = torch.eye(3, dtype=torch.float64)[torch.arange(600) % 3][None]
        points = torch.where(normals > 0, 1, seeded(1, 600, 3))
    normals = normals / normals.norm(dim=-1, keepdim=True)
    source = (points[:, :300] + 0.005).requires_grad_()
    poses = loom.torch.icp(source, points, max_distance=0.2, normals=normals)
    if shape == "cone":
        with pytest.raises(RuntimeError, match="icp: 1 of 1 poses have no gradient"):
            poses.sum().backward()
    else:
        poses.sum().backward()
        assert source.grad.abs().max() < 1


def test_graphs_are_compiled_without_breaks_and_runs_are_identical():
    source, target, _ = (each.detach().float() for each in pair())
    vertices, triangles, _ = sphere()

    def loss(source, target, vertices):
        poses = loom.torch.icp(source, target, max_distance=0.3, normals=loom.torch.normals(target, 12).detach())
        moved = loom.torch.transform(source, poses)
        return loom.torch.signed_distance((vertices, triangles), moved).square().sum()

    results = []
    for call in (loss, loss, torch.compile(loss, fullgraph=True, backend="aot_eager")):
        given = [each.clone().requires_grad_() for each in (source, target, vertices.float())]
        value = call(*given)
        results.append([value.detach(), *torch.autograd.grad(value, given)])
    for result in results[1:]:
        assert all(torch.equal(x, y) for x, y in zip(results[0], result, strict=True))


P, F, V = torch.rand(2, 5, 3), torch.tensor([[0, 1, 2]]), torch.rand(3, 3)


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda: loom.torch.signed_distance((V, F), P[..., :2]), ValueError, r"^points: expected shape \[..., 3\], got \[2, 5, 2\]"),  # noqa: E501
        (lambda: loom.torch.signed_distance((V, F.float()), P), TypeError, "^triangles: expected integers, got torch.float32"),  # noqa: E501
        (lambda: loom.torch.signed_distance((V[:2], F), P), ValueError, r"^triangles: expected vertices 0..1, got 0..2"),  # noqa: E501
        (lambda: loom.torch.signed_distance((V, F[:0]), P), ValueError, r"^triangles: expected shape .* got \[0, 3\]"),
        (lambda: loom.torch.signed_distance(V, P), TypeError, "^mesh: expected a pair of vertices and triangles"),
        (lambda: loom.torch.signed_distance((V, F), P.numpy()), TypeError, "^points: expected a torch tensor, got ndarray"),  # noqa: E501
        (lambda: loom.torch.normals(P, 0), ValueError, "^k: expected an integer >= 1, got 0"),
        (lambda: loom.torch.transform(P, torch.eye(3)), ValueError, r"^poses: expected shape \[4, 4\] or \[2, 4, 4\], got \[3, 3\]"),  # noqa: E501
        (lambda: loom.torch.icp(P, P, max_distance=0.0), ValueError, "^max_distance: expected a finite number > 0, got 0.0"),  # noqa: E501
        (lambda: loom.torch.icp(P, P, max_distance=None), TypeError, "^max_distance: expected a number, got None"),
        (lambda: loom.torch.icp(P, P, torch.eye(3), max_distance=1.0), ValueError, r"^init: expected shape .* got \[3, 3\]"),  # noqa: E501
        (lambda: loom.torch.icp(P, P, max_distance=1.0, normals=P[0]), ValueError, r"^normals: expected shape \[2, 5, 3\]"),  # noqa: E501
        (lambda: loom.torch.icp(P, P, max_distance=1.0, max_iterations=0), ValueError, "^max_iterations: expected an integer >= 1"),  # noqa: E501
        (lambda: loom.torch.icp(P[:0], P[:0], max_distance=1.0), ValueError, r"^source: expected at least one cloud, got shape \[0, 5, 3\]"),  # noqa: E501
    ],
)  # fmt: skip  # one case per line
def test_errors_name_the_argument_and_the_shapes(call, error, message):
    with pytest.raises(error, match=message):
        call()
