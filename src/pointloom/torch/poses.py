"""Registration of batches of clouds by ICP, with gradients of the poses.

A pose of ICP minimizes the distances of its correspondences, so the derivative of their sum of squares is zero there.
The implicit function theorem gives the derivatives of the pose from those of that equation: one system of 6 x 6 per
cloud, not a graph of all iterations. Correspondences are constant, as almost everywhere.
"""

from typing import Any, NamedTuple

import torch

from ..core.checks import check_count, check_positive
from ..core.devices import resolve_device
from ..pcd.cloud import PointCloud
from ..registration.icp.estimation import TransformationEstimationPointToPlane, TransformationEstimationPointToPoint
from ..registration.icp.icp import ICPConvergenceCriteria, registration_icp_batch
from .batches import Batch, take_pair
from .losses import ARGUMENT_NAMES, Layout
from .neighbors import batch_neighbors
from .operators import Operator, check_device, check_floats, gather_rows, refuse_gradients, scatter_sum

# Newton steps from the pose of ICP to the minimum. Each squares the error: from 1e-2 to below 1e-16 in four steps.
NEWTON_STEPS = 5
# Smallest eigenvalue of a determined system relative to the largest, about the center and in units of the extent. Exact
# planes, spheres, cylinders and lines of 1,000 points have up to 6e-8, a plane with noise of 1e-4 of its size 1e-7, a
# surface with waves of 1e-3 of its size 2e-6, others more (synthetic surfaces, 29 November 2026).
MIN_DETERMINED = 1e-6


def icp(
    source: torch.Tensor,
    target: torch.Tensor,
    init: torch.Tensor | None = None,
    *,
    max_distance: float,
    normals: torch.Tensor | None = None,
    max_iterations: int = 30,
    lengths: Layout = None,
    offsets: Layout = None,
) -> torch.Tensor:
    """Register each source to its target by iterative closest points, with gradients of the poses.

    The poses have gradients with respect to the source, the target and its normals, by the implicit function theorem.
    The gradient with respect to `init` is 0: nearby initial poses have the same result.

    Args:
        source: Clouds to move (B, N, 3), (M, 3) or (N, 3).
        target: Fixed clouds, as many.
        init: Initial poses T_target_source (B, 4, 4) or (4, 4). None: the identity.
        max_distance: Correspondences are closer than this.
        normals: Unit normals of the target, shaped as it: distances to its planes are minimized. None: distances to its
            points.
        max_iterations: Number of iterations of ICP.
        lengths, offsets: Layout of the batches, as of `knn`.

    Returns:
        Poses T_target_source (B, 4, 4), or (4, 4) for single clouds, in the type of the source. They minimize the
        distances of the correspondences of the last iteration, to the last digits of float64.

    Raises:
        TypeError, ValueError: Wrong types or shapes, or clouds that do not match.
        RuntimeError: In the backward pass, if correspondences do not determine a pose that has a gradient: fewer than
            three, or a surface that can slide along itself. Second derivatives are refused, too.

    Notes:
        All clouds of a batch are registered in the same launches. The host waits for the result. Use
        `registration.registration_icp_batch` for the reliability of each pose, without gradients.

    Example:
        >>> import torch, pointloom as loom
        >>> target = torch.rand(2, 500, 3, generator=torch.Generator().manual_seed(0))
        >>> source = (target - torch.tensor([0.01, 0.0, 0.0])).requires_grad_()
        >>> poses = loom.torch.icp(source, target, max_distance=0.1)
        >>> [round(x, 6) for x in poses[:, 0, 3].tolist()]
        [0.01, 0.01]
        >>> poses[:, 0, 3].sum().backward()
        >>> round(source.grad[..., 0].sum().item(), 4)
        -2.0
    """
    a, b = take_pair(source, target, ARGUMENT_NAMES, lengths=lengths, offsets=offsets)
    max_distance = check_positive("max_distance", max_distance)
    if not a.count:
        raise ValueError(f"source: expected at least one cloud, got shape {list(source.shape)}")
    moving, fixed = a.points.double(), b.points.double()
    planes = fixed.new_empty((0, 3)) if normals is None else _take_normals(normals, target)
    layout = torch.stack([a.starts(), a.sizes(), b.starts(), b.sizes()])
    largest = [a.width or len(moving), b.width or len(fixed)]
    rules = max_distance, check_count("max_iterations", max_iterations)
    poses = icp_poses(moving, fixed, planes, _take_poses(init, a), layout, largest, *rules)[0]
    is_single = len(a.shape) == 1 and a.labels is None
    return (poses[0] if is_single else poses).to(source.dtype)


def _take_normals(normals: torch.Tensor, target: torch.Tensor) -> torch.Tensor:
    check_floats("normals", normals)
    check_device("normals", normals, target)
    if normals.shape != target.shape:
        raise ValueError(f"normals: expected shape {list(target.shape)}, as the target, got {list(normals.shape)}")
    return normals.double().reshape(-1, 3)


def _take_poses(init: torch.Tensor | None, a: Batch) -> torch.Tensor:
    if init is None:
        return torch.eye(4, dtype=torch.float64, device=a.points.device).expand(a.count, 4, 4)
    check_floats("init", init)
    check_device("init", init, a.points)
    if tuple(init.shape) not in ((a.count, 4, 4), (4, 4)):
        raise ValueError(f"init: expected shape [4, 4] or [{a.count}, 4, 4], got {list(init.shape)}")
    return init.detach().double().expand(a.count, 4, 4)


class Matches(NamedTuple):
    """Correspondences at a pose, with everything float64.

    Attributes:
        labels: Cloud of each source row, int64 (M). Rows without correspondence have `count`.
        moved: Positions at the pose about the center of their cloud, (M, 3).
        residuals: Differences to the target, (M, 3).
        forces: Residuals, or their part along the normals, (M, 3).
        normals: Normals of the target rows, (M, 3), or None.
        center: Mean position of each cloud, (B, 3).
        clouds: Number of clouds.
    """

    labels: torch.Tensor
    moved: torch.Tensor
    residuals: torch.Tensor
    forces: torch.Tensor
    normals: torch.Tensor | None
    center: torch.Tensor
    clouds: int


def _matches(
    source: torch.Tensor,
    target: torch.Tensor,
    normals: torch.Tensor,
    poses: torch.Tensor,
    labels: torch.Tensor,
    rows: torch.Tensor,
) -> Matches:
    count = len(poses)
    labels = torch.where(rows < 0, count, labels)
    world = _moved(source, poses, labels)
    sizes = torch.bincount(labels, minlength=count + 1)[:count].clamp(min=1)
    center = scatter_sum(world, labels, count) / sizes[:, None]
    residuals = torch.where(rows[:, None] < 0, 0, world - gather_rows(target, rows))
    near = gather_rows(normals, rows) if len(normals) else None
    forces = residuals if near is None else near * (near * residuals).sum(1, keepdim=True)
    moved = torch.where(rows[:, None] < 0, 0, world - gather_rows(center, labels))
    return Matches(labels, moved, residuals, forces, near, center, count)


def _moved(source: torch.Tensor, poses: torch.Tensor, labels: torch.Tensor) -> torch.Tensor:
    """Source rows at the poses of their clouds, (M, 3)."""
    T = gather_rows(poses.reshape(-1, 16), labels).reshape(-1, 4, 4)
    return (source[:, None, :] * T[:, :3, :3]).sum(-1) + T[:, :3, 3]


def _systems(m: Matches) -> tuple[torch.Tensor, torch.Tensor]:
    """Hessian (B, 6, 6) and gradient (B, 6) of half the sum of squares, for a rotation about the center and a shift."""
    rotated = torch.linalg.cross(m.moved, m.forces)
    gradient = scatter_sum(torch.cat([rotated, m.forces], 1), m.labels, m.clouds)
    identity = torch.eye(3, dtype=torch.float64, device=m.moved.device).expand(len(m.moved), 3, 3)
    jacobian = torch.cat([-skew(m.moved), identity], 2)  # (M, 3, 6)
    if m.normals is not None:
        jacobian = (jacobian * m.normals[:, :, None]).sum(1, keepdim=True)  # (M, 1, 6)
    products = (jacobian[:, :, :, None] * jacobian[:, :, None, :]).sum(1)
    second = m.forces[:, :, None] * m.moved[:, None, :]
    second = (second + second.transpose(1, 2)) / 2 - (m.forces * m.moved).sum(1)[:, None, None] * identity
    products[:, :3, :3] += second
    return scatter_sum(products.reshape(-1, 36), m.labels, m.clouds).reshape(-1, 6, 6), gradient


def _factors(hessian: torch.Tensor, m: Matches) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
    """Cholesky factors in units of the extent, the unit of each of the six motions (B, 6), and which are determined."""
    spread = scatter_sum((m.moved * m.moved).sum(1, keepdim=True), m.labels, m.clouds)
    sizes = torch.bincount(m.labels, minlength=m.clouds + 1)[: m.clouds, None].clamp(min=1)
    extent = (spread / sizes).sqrt().clamp(min=torch.finfo(torch.float64).tiny)
    units = torch.cat([(1 / extent).expand(-1, 3), torch.ones_like(extent).expand(-1, 3)], 1) / sizes.sqrt()
    scaled = hessian * units[:, :, None] * units[:, None, :]
    values = torch.linalg.eigvalsh(scaled)
    determined = values[:, 0] > MIN_DETERMINED * values[:, -1]
    identity = torch.eye(6, dtype=torch.float64, device=hessian.device)
    return torch.linalg.cholesky_ex(torch.where(determined[:, None, None], scaled, identity))[0], units, determined


def _solved(hessian: torch.Tensor, right: torch.Tensor, m: Matches) -> tuple[torch.Tensor, torch.Tensor]:
    """Solutions (B, 6), 0 where the system does not determine them, and where it does."""
    factors, units, determined = _factors(hessian, m)
    solution = torch.cholesky_solve((right * units)[:, :, None], factors)[:, :, 0] * units
    return torch.where(determined[:, None], solution, 0), determined


def skew(v: torch.Tensor) -> torch.Tensor:
    """Matrices of cross products (n, 3, 3): skew(v) @ w = v x w."""
    x, y, z = v.unbind(1)
    zero = torch.zeros_like(x)
    return torch.stack([zero, -z, y, z, zero, -x, -y, x, zero], 1).reshape(-1, 3, 3)


@Operator
def icp_poses(
    source: torch.Tensor,
    target: torch.Tensor,
    normals: torch.Tensor,
    init: torch.Tensor,
    layout: torch.Tensor,
    largest: list[int],
    max_distance: float,
    max_iterations: int,
) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
    """Poses (B, 4, 4), the cloud of each source row, B for padding, and its target row, -1 if there is none, int64 (M).

    Positions, normals, none of which has rows if unused, and poses are float64. `layout`: first rows and sizes of the
    sources and of the targets, int32 (4, B). `largest`: bounds of the sizes of both.
    """
    sources = _clouds(source, None, *layout[:2].tolist())
    targets = _clouds(target, normals if len(normals) else None, *layout[2:].tolist())
    method = TransformationEstimationPointToPlane() if len(normals) else TransformationEstimationPointToPoint()
    rules = ICPConvergenceCriteria(max_iteration=max_iterations)
    found = registration_icp_batch(sources, targets, max_distance, init.cpu().numpy(), method, rules)
    poses = torch.tensor([result.transformation.tolist() for result in found], dtype=torch.float64).to(source.device)
    labels = _labels(len(source), layout[0].long(), layout[1])
    moved = _moved(source, poses, labels)
    rows = batch_neighbors(moved, target, layout, largest[1], 1, max_distance, False, False)[0][:, 0]
    for _ in range(NEWTON_STEPS):
        m = _matches(source, target, normals, poses, labels, rows)
        hessian, gradient = _systems(m)
        step, _ = _solved(hessian, -gradient, m)
        turn = torch.linalg.matrix_exp(skew(step[:, :3]))
        poses = poses.clone()
        poses[:, :3, 3] = (turn * (poses[:, :3, 3] - m.center)[:, None, :]).sum(-1) + m.center + step[:, 3:]
        poses[:, :3, :3] = (turn[:, :, :, None] * poses[:, None, :3, :3]).sum(2)
    return poses, labels, rows


@icp_poses.register_fake
def _(source: torch.Tensor, target: torch.Tensor, normals: torch.Tensor, init: torch.Tensor, *rest: object) -> Any:
    rows = source.new_empty(source.shape[0], dtype=torch.int64)
    return init.new_empty((init.shape[0], 4, 4)), rows, torch.empty_like(rows)


def _labels(rows: int, starts: torch.Tensor, sizes: torch.Tensor) -> torch.Tensor:
    """The cloud of each row, int64 (rows), and their number for padding."""
    row = torch.arange(rows, device=starts.device)
    clouds = torch.searchsorted(starts, row, right=True) - 1
    return torch.where(row - starts[clouds] < sizes[clouds], clouds, len(starts))


def _clouds(
    points: torch.Tensor, normals: torch.Tensor | None, starts: list[int], sizes: list[int]
) -> list[PointCloud]:
    """A cloud of each part of the rows."""
    parts = [slice(first, first + size) for first, size in zip(starts, sizes, strict=True)]
    device = resolve_device(points.device)
    return [
        PointCloud(points[part], normals=None if normals is None else normals[part], device=device, frozen=True)
        for part in parts
    ]


@Operator
def icp_gradients(
    source: torch.Tensor,
    target: torch.Tensor,
    normals: torch.Tensor,
    poses: torch.Tensor,
    labels: torch.Tensor,
    rows: torch.Tensor,
    grad: torch.Tensor,
) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
    """Gradients with respect to the source, the target and its normals. The host waits for the check of the systems."""
    m = _matches(source, target, normals, poses, labels, rows)
    hessian, _ = _systems(m)
    R, t = poses[:, :3, :3], poses[:, :3, 3]
    turned = (grad[:, :3, None, :3] * R[:, None, :, :]).sum(-1)  # grad_R @ R^T
    axis = (turned - turned.transpose(1, 2))[:, (2, 0, 1), (1, 2, 0)]
    about = axis + torch.linalg.cross(t - m.center, grad[:, :3, 3])
    factors, determined = _solved(hessian, -torch.cat([about, grad[:, :3, 3]], 1), m)
    if lost := (~determined & (grad != 0).flatten(1).any(1)).nonzero()[:, 0].tolist():
        raise RuntimeError(
            f"icp: {len(lost)} of {len(poses)} poses have no gradient, such as that of cloud {lost[0]}: their "
            "correspondences do not determine the pose. Increase max_distance, use surfaces that cannot slide along "
            "themselves, or detach these poses"
        )
    turns, shifts = gather_rows(factors, m.labels).split(3, 1)
    a = torch.linalg.cross(turns, m.moved) + shifts
    along = a if m.normals is None else m.normals * (m.normals * a).sum(1, keepdim=True)
    world = along + torch.linalg.cross(m.forces, turns)
    back = gather_rows(R.reshape(-1, 9), m.labels).reshape(-1, 3, 3)
    grad_source = (world[:, :, None] * back).sum(1)
    grad_target = scatter_sum(-along, rows, len(target))
    if m.normals is None:
        return grad_source, grad_target, torch.zeros_like(normals)
    steep = m.residuals * (m.normals * a).sum(1, keepdim=True) + a * (m.normals * m.residuals).sum(1, keepdim=True)
    return grad_source, grad_target, scatter_sum(steep, rows, len(target))


@icp_gradients.register_fake
def _(source: torch.Tensor, target: torch.Tensor, normals: torch.Tensor, *rest: object) -> Any:
    return torch.empty_like(source), torch.empty_like(target), torch.empty_like(normals)


refuse_gradients(icp_gradients, "the gradient of icp")


def _save(ctx, inputs, output) -> None:
    ctx.mark_non_differentiable(*output[1:])
    ctx.save_for_backward(*inputs[:3], *output)


def _backward(ctx, grad: torch.Tensor, *_) -> tuple[Any, ...]:
    return (*icp_gradients(*ctx.saved_tensors, grad), *[None] * 5)


icp_poses.register_autograd(_backward, setup_context=_save)
