"""Distances to meshes with gradients, normals of batches of clouds, and transformations.

Distances to a mesh are formulas of torch about the closest triangles, so gradients of every order are right where the
closest part of the mesh does not change. They are computed in float64.
"""

from typing import Any

import torch

from ..core.checks import check_count
from ..core.devices import resolve_device
from ..core.other_geometry import conversion_of
from ..kernels.lang import vec3d
from ..kernels.surface.listed_normals import fit_listed_normals
from ..meshing.mesh.mesh import TriangleMesh
from ..meshing.scene.raycasting_scene import RaycastingScene
from .batches import take_batch
from .losses import nearest_rows, root
from .operators import (
    Operator,
    check_device,
    check_floats,
    check_integers,
    check_tensor,
    checks_values,
    device_array,
    gather_rows,
    refuse_gradients,
    tensor_of,
)

Mesh = TriangleMesh | tuple[torch.Tensor, torch.Tensor]  # the latter: vertices (V, 3) and triangles (F, 3)


def point_to_mesh_distance(mesh: Mesh, points: torch.Tensor) -> torch.Tensor:
    """Compute the distance of each point to a mesh, with gradients with respect to the points and the vertices.

    Args:
        mesh: A pair of tensors, vertices (V, 3) and triangles (F, 3) of integers, or a TriangleMesh, which has no
            gradient.
        points: Shape (..., 3). Batches of clouds have the same mesh.

    Returns:
        Distances (...), in the type of the points. NaN for points that are not finite.

    Raises:
        TypeError, ValueError: Wrong types or shapes, a mesh without triangles, or triangles with unknown vertices.

    Notes:
        The gradient of a distance of 0 is 0. The host waits for a GPU while the search tree of the mesh is built.
        Ericson, "Real-time collision detection", 2005, section 5.1.5.

    Example:
        >>> import torch, pointloom as loom
        >>> vertices = torch.tensor([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])
        >>> points = torch.tensor([[0.2, 0.2, 3.0]], requires_grad=True)
        >>> distance = loom.torch.point_to_mesh_distance((vertices, torch.tensor([[0, 1, 2]])), points)
        >>> distance.sum().backward()
        >>> distance.tolist(), points.grad.tolist()
        ([3.0], [[0.0, 0.0, 1.0]])
    """
    distances, _ = _mesh_distances(mesh, points, is_signed=False)
    return distances


def signed_distance(mesh: Mesh, points: torch.Tensor) -> torch.Tensor:
    """Compute the signed distance of each point to a mesh: negative inside, with gradients as `point_to_mesh_distance`.

    Args:
        mesh, points: As of `point_to_mesh_distance`. The mesh encloses a volume, as of
            `RaycastingScene.compute_signed_distance`, which finds the sides.

    Returns:
        Distances (...), in the type of the points. NaN for points that are not finite.

    Raises:
        TypeError, ValueError: As of `point_to_mesh_distance`.

    Example:
        >>> import torch, pointloom as loom
        >>> box = loom.TriangleMesh.create_box(4, 4, 4)
        >>> loom.torch.signed_distance(box, torch.tensor([[1.0, 2, 2], [6, 2, 2]])).tolist()
        [-1.0, 2.0]
    """
    distances, is_inside = _mesh_distances(mesh, points, is_signed=True)
    return torch.where(is_inside, -distances, distances)


def normals(
    points: torch.Tensor,
    k: int = 30,
    *,
    lengths: torch.Tensor | None = None,
    batch: torch.Tensor | None = None,
    offsets: torch.Tensor | None = None,
    batch_size: int | None = None,
) -> torch.Tensor:
    """Estimate a normal for each point from its k nearest neighbors. Normals have no gradient, and no orientation.

    Args:
        points: Clouds (B, N, 3), (M, 3) or (N, 3).
        k: Number of neighbors, including the point.
        lengths, batch, offsets, batch_size: Layout of the batch, as of `knn`.

    Returns:
        Unit normals in the shape and type of the points, (0, 0, 1) for points with fewer than three neighbors.

    Raises:
        TypeError, ValueError: Wrong types or shapes.
        RuntimeError: In the backward pass, if the points require a gradient and the normals are part of the graph.
            Detach them.

    Example:
        >>> import torch, pointloom as loom
        >>> plane = torch.rand(2, 100, 3) * torch.tensor([1.0, 1.0, 0.0])
        >>> loom.torch.normals(plane, 10).abs().sum((0, 1)).tolist()
        [0.0, 0.0, 200.0]
    """
    cloud = take_batch("points", points, lengths=lengths, batch=batch, offsets=offsets, batch_size=batch_size)
    rows, _ = nearest_rows(cloud, cloud, check_count("k", k))
    return listed_normals(cloud.points, rows).reshape(points.shape).to(points.dtype)


def transform(
    points: torch.Tensor, poses: torch.Tensor, *, batch: torch.Tensor | None = None, offsets: torch.Tensor | None = None
) -> torch.Tensor:
    """Transform each cloud by its pose, with gradients with respect to both.

    Args:
        points: Clouds (B, N, 3), (M, 3) or (N, 3). Padding rows are transformed, too.
        poses: Transformations (B, 4, 4), or one (4, 4) for all. The last row is not used.
        batch, offsets: Layout of a ragged batch, as of `knn`.

    Returns:
        Transformed points in the shape and type of the points.

    Raises:
        TypeError, ValueError: Wrong types or shapes, or numbers of poses and clouds that differ.

    Example:
        >>> import torch, pointloom as loom
        >>> shift = torch.eye(4)
        >>> shift[:3, 3] = torch.tensor([1.0, 2.0, 3.0])
        >>> loom.torch.transform(torch.zeros(1, 3), shift).tolist()
        [[1.0, 2.0, 3.0]]
    """
    check_tensor("points", points)
    check_floats("poses", poses)
    check_device("poses", poses, points)
    count = poses.shape[0] if poses.ndim == 3 else 1
    is_ragged = batch is not None or offsets is not None
    cloud = take_batch("points", points, batch=batch, offsets=offsets, batch_size=count if batch is not None else None)
    if tuple(poses.shape) not in ((cloud.count, 4, 4), (4, 4)):
        raise ValueError(f"poses: expected shape [4, 4] or [{cloud.count}, 4, 4], got {list(poses.shape)}")
    dtype = torch.promote_types(cloud.points.dtype, poses.dtype)
    matrices, rows = poses.to(dtype).reshape(-1, 16), cloud.points.to(dtype)
    if is_ragged and poses.ndim == 3:
        T = gather_rows(matrices, cloud.row_labels()).reshape(-1, 4, 4)
    else:  # sums of broadcast gradients are in a fixed order
        T = matrices.reshape(-1, 1, 4, 4)
        rows = rows.reshape(T.shape[0], -1, 3)
    moved = (rows[..., None, :] * T[..., :3, :3]).sum(-1) + T[..., :3, 3]
    return moved.reshape(points.shape).to(points.dtype)


def _mesh_distances(mesh: Mesh, points: torch.Tensor, *, is_signed: bool) -> tuple[torch.Tensor, torch.Tensor]:
    """Distances to a mesh, and which points are inside. The latter is False if not `is_signed`."""
    check_floats("points", points)
    check_device("points", points)
    if points.ndim < 1 or points.shape[-1] != 3:
        raise ValueError(f"points: expected shape [..., 3], got {list(points.shape)}")
    vertices, triangles = _take_mesh(mesh, points)
    rows = points.reshape(-1, 3).double()
    faces, is_inside = closest_triangles(vertices.detach(), triangles, rows.detach(), is_signed)
    corners = gather_rows(triangles, faces).reshape(-1)
    a, b, c = gather_rows(vertices, corners).reshape(-1, 3, 3).unbind(1)
    gaps = rows - closest_points(rows, a, b, c)
    distances = root((gaps * gaps).sum(1))
    return distances.reshape(points.shape[:-1]).to(points.dtype), is_inside.reshape(points.shape[:-1])


def _take_mesh(mesh: object, points: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
    """Vertices, float64 (V, 3), and triangles, int64 (F, 3), on the device of the points."""
    if isinstance(mesh, TriangleMesh):
        corners = torch.tensor(mesh.triangles, dtype=torch.int64, device=points.device)
        mesh = torch.tensor(mesh.vertices, dtype=torch.float64, device=points.device), corners
    if not isinstance(mesh, (tuple, list)) or len(mesh) != 2:
        given = f"{type(mesh).__name__}{conversion_of(mesh, expected='mesh')}"
        raise TypeError(f"mesh: expected a pair of vertices and triangles or a TriangleMesh, got {given}")
    vertices, triangles = mesh
    check_floats("vertices", vertices)
    check_integers("triangles", triangles)
    for name, each in (("vertices", vertices), ("triangles", triangles)):
        check_device(name, each, points)
        if each.ndim != 2 or each.shape[1] != 3 or not each.shape[0]:
            raise ValueError(f"{name}: expected shape [n, 3] with n >= 1, got {list(each.shape)}")
    if checks_values(triangles) and (int(triangles.min()) < 0 or int(triangles.max()) >= vertices.shape[0]):
        given = f"{int(triangles.min())}..{int(triangles.max())}"
        raise ValueError(f"triangles: expected vertices 0..{vertices.shape[0] - 1}, got {given}")
    return vertices.double(), triangles.long()


def closest_points(p: torch.Tensor, a: torch.Tensor, b: torch.Tensor, c: torch.Tensor) -> torch.Tensor:
    """The closest point of each triangle to a point, all (n, 3): on its plane if that is inside, else on an edge."""
    ab, ac, ap = b - a, c - a, p - a
    d00, d01, d11 = _dot(ab, ab), _dot(ab, ac), _dot(ac, ac)
    d20, d21 = _dot(ap, ab), _dot(ap, ac)
    area = d00 * d11 - d01 * d01
    is_face = area > 0
    area = torch.where(is_face, area, 1)
    v, w = (d11 * d20 - d01 * d21) / area, (d00 * d21 - d01 * d20) / area
    is_face = is_face & (v >= 0) & (w >= 0) & (v + w <= 1)
    closest, sqdist = _on_edge(p, a, b)
    for start, end in ((b, c), (c, a)):
        other, square = _on_edge(p, start, end)
        is_closer = square < sqdist
        closest, sqdist = torch.where(is_closer, other, closest), torch.where(is_closer, square, sqdist)
    return torch.where(is_face, a + v * ab + w * ac, closest)


def _on_edge(p: torch.Tensor, a: torch.Tensor, b: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
    """The closest point of each edge, and its squared distance (n, 1), without gradient."""
    ab = b - a
    square = _dot(ab, ab)
    t = torch.where(square > 0, _dot(p - a, ab) / torch.where(square > 0, square, 1), 0).clamp(0, 1)
    closest = a + t * ab
    gap = (p - closest).detach()
    return closest, _dot(gap, gap)


def _dot(a: torch.Tensor, b: torch.Tensor) -> torch.Tensor:
    return (a * b).sum(-1, keepdim=True)


@Operator
def closest_triangles(
    vertices: torch.Tensor, triangles: torch.Tensor, points: torch.Tensor, is_signed: bool
) -> tuple[torch.Tensor, torch.Tensor]:
    """The closest triangle of each point, int64 (n), -1 if there is none, and which points are inside the mesh."""
    scene = RaycastingScene(device=resolve_device(points.device))
    scene.add_triangles(vertices, triangles.int())
    found: Any = scene.compute_closest_points(points)["primitive_ids"]  # a tensor, as the points
    faces = found.view(torch.int32).long()
    if not is_signed:
        return faces, torch.zeros(len(points), dtype=torch.bool, device=points.device)
    return faces, scene.compute_signed_distance(points) < 0


@closest_triangles.register_fake
def _(vertices: torch.Tensor, triangles: torch.Tensor, points: torch.Tensor, is_signed: bool) -> Any:
    return points.new_empty(len(points), dtype=torch.int64), points.new_empty(len(points), dtype=torch.bool)


@Operator
def listed_normals(points: torch.Tensor, rows: torch.Tensor) -> torch.Tensor:
    """Unit normals (m, 3), float64, of points from the rows (m, k) of their neighbors."""
    return tensor_of(fit_listed_normals(device_array(points.double(), vec3d), device_array(rows)))


@listed_normals.register_fake
def _(points: torch.Tensor, rows: torch.Tensor) -> Any:
    return points.new_empty((len(points), 3), dtype=torch.float64)


refuse_gradients(listed_normals, "normals")
