"""What the neighbourhood of a point looks like: features that describe it, and the shapes of its covariance."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.array_libraries import hand_out
from ..core.checks import check_indices, check_search, is_on_gpu
from ..core.gpu_arrays import take_indices
from ..core.told_arguments import told_arguments
from ..kernels.features.eigen_features import measure_curvature, measure_shapes
from ..kernels.features.fpfh import compute_features, mask_points
from ..kernels.lang import int32
from ..kernels.memory import upload
from ..kernels.search.point_tree import PointTree
from .cloud import PointCloud
from .kept_tree import check_extent
from .length_doubts import warn_of_short
from .point_arrays import check_cloud


@told_arguments
def compute_fpfh_feature(
    cloud: PointCloud, *, radius: float | None = None, max_nn: int | None = 100, indices: ArrayLike | None = None
) -> NDArray[np.float32]:
    """Fast point feature histograms: how the normals around each point turn, in three histograms of 11 bins.

    Features do not change when the cloud moves, so that they match points of two clouds before these are aligned.

    Args:
        cloud: A cloud with normals.
        radius: Search radius [m], the boundary excluded; with `max_nn` the nearest `max_nn` within it. None searches by
            count alone.
        max_nn: Neighbours, the point itself included; None takes all within the radius.
        indices: The points whose features are wanted, shape [m], in any order; None for all. Costs what they and their
            neighbours cost.

    Returns:
        float32 [n, 33], or [m, 33]. Each block of 11 sums to 200; zeros where a point has no neighbour; NaN where its
        position or normal is not finite. Such points are nobody's neighbour.

    Raises:
        ValueError: The cloud has no normals, neither limit given, or one out of range.
        IndexError: An index beyond the cloud.
        TypeError: Indices that are not whole numbers.

    Notes:
        O(n) memory: 132 B a point beside the result. Same bits from run to run. Rusu, Blodow and Beetz 2009, as Open3D
        computes it: neighbours weighted by one over the squared distance, and the point's own histogram added in full.
        Open3D gives one shape [33, n]. It counts a point whose normal is NaN as a neighbour with all angles in bin 0.
        Where neighbours tie for the last place, Open3D's choice is unspecified; here those first on the search tree's
        curve are taken. On the device: `pointloom.kernels.features.fpfh.compute_features`.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> cloud = loom.PointCloud(np.random.default_rng(0).random((500, 3)) * [1, 1, 0.1])
        >>> cloud = cloud.estimate_normals(radius=0.2, max_nn=30)
        >>> features = loom.compute_fpfh_feature(cloud, radius=0.3, max_nn=100)
        >>> features.shape, np.unique(features.reshape(-1, 11).sum(axis=1).round(2)).tolist()
        ((500, 33), [200.0])
    """
    check_cloud("cloud", cloud)
    reach, count = check_search(radius, max_nn)
    if not cloud.has_normals:
        raise ValueError("cloud: FPFH needs normals, and it has none; call cloud = cloud.estimate_normals()")
    rows = None if indices is None else _device_indices(indices, cloud)
    normals = cloud._device_array("normals")
    masked = mask_points(cloud._device_array("points"), normals)
    tree = cloud.search_tree() if masked is None else PointTree(masked)
    check_extent("cloud", tree.low, tree.high, tree.source)
    warn_of_short("radius", tree, radius, cloud.unit, "the features are zeros")
    return hand_out(compute_features(tree, normals, reach, count, rows), cloud.array_library)


@told_arguments
def compute_eigen_features(cloud: PointCloud, *, radius: float | None = None, max_nn: int | None = 30) -> PointCloud:
    """Tell lines, planes and volumes apart by the eigenvalues of each neighbourhood's covariance.

    With eigenvalues l1 >= l2 >= l3 and e = l / (l1 + l2 + l3), the attributes are

    - `eigenvalues`: l1, l2, l3 [m^2], shape [n, 3], of the covariance divided by the number of neighbours;
    - `linearity`: (l1 - l2) / l1; `planarity`: (l2 - l3) / l1; `sphericity` (scattering): l3 / l1; their sum is 1;
    - `omnivariance`: (e1 e2 e3)^(1/3); `anisotropy`: (l1 - l3) / l1; `eigenentropy`: -sum of e ln e;
    - `curvature` (surface variation): e3, 0 on a plane and 1/3 in a ball;
    - `verticality`: `1 - |nz|` of the normal, 0 on the ground and 1 on a wall;
    - `density` [1 / m^3]: neighbours over the volume of their ball, whose radius is that of the search, or the distance
      of the last neighbour where `max_nn` ends it; NaN where all lie at the point.

    Args:
        cloud: Any cloud; normals are not needed.
        radius: Search radius [m], the boundary excluded; with `max_nn` the nearest `max_nn` within it. None searches by
            count alone.
        max_nn: Neighbours, the point itself included; None takes all within the radius.

    Returns:
        The cloud with these attributes, float32; NaN where fewer than 3 neighbours are found, where all lie at one
        place, and for points that are not finite.

    Raises:
        ValueError: Neither limit given, or one out of range.

    Notes:
        O(n) memory. Same bits from run to run. Weinmann et al. 2015, sections 3.2.1 and 3.2.2; Pauly, Gross and Kobbelt
        2002. Eigenvalues below 1e-15 of the largest are zero.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> line = loom.PointCloud(np.linspace(0, 1, 50)[:, None] * [0, 0, 1])
        >>> shapes = loom.compute_eigen_features(line, max_nn=10)
        >>> float(shapes["linearity"].min()), float(shapes["verticality"].max())
        (1.0, 1.0)
    """
    check_cloud("cloud", cloud)
    reach, count = check_search(radius, max_nn)
    shapes = measure_shapes(cloud.search_tree(), reach, count)
    return _with_attributes(cloud, shapes)


@told_arguments
def estimate_curvature(cloud: PointCloud, *, radius: float | None = None, max_nn: int | None = 30) -> PointCloud:
    """The surface variation of each point's neighbourhood: 0 on a plane, more on edges, at most 1/3.

    Args:
        cloud: Any cloud; normals are not needed.
        radius: Search radius [m], the boundary excluded; None searches by count alone.
        max_nn: Neighbours, the point itself included; None takes all within the radius.

    Returns:
        The cloud with the attribute `curvature`, float32; NaN as in `compute_eigen_features`.

    Raises:
        ValueError: Neither limit given, or one out of range.

    Notes:
        O(n) memory. Same bits from run to run. Pauly, Gross and Kobbelt 2002, section 2.2: the smallest eigenvalue over
        the sum of all three.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.meshgrid(np.arange(20), np.arange(20))
        >>> roof = loom.PointCloud(np.column_stack([x.ravel(), y.ravel(), np.minimum(x, 19 - x).ravel()]))
        >>> curvature = loom.estimate_curvature(roof, max_nn=9)["curvature"].reshape(20, 20)
        >>> bool(curvature[10, 5] < 1e-6), bool(curvature[10, 9] > 0.01)
        (True, True)
    """
    check_cloud("cloud", cloud)
    reach, count = check_search(radius, max_nn)
    return _with_attributes(cloud, {"curvature": measure_curvature(cloud.search_tree(), reach, count)})


def _device_indices(indices: ArrayLike, cloud: PointCloud) -> Any:
    """Indices into a cloud, those that count from its end resolved, on its device."""
    if is_on_gpu(indices):
        return take_indices("indices", indices, cloud.device, len(cloud), of=f"cloud of {len(cloud)} points")
    what = {"of": f"cloud of {len(cloud)} points", "hint": "; np.flatnonzero turns a mask into them"}
    return upload(check_indices("indices", indices, len(cloud), **what), int32, cloud.device)


def _with_attributes(cloud: PointCloud, arrays: dict[str, Any]) -> PointCloud:
    return cloud._with_arrays(cloud._device_arrays | arrays, grid=cloud.grid)
