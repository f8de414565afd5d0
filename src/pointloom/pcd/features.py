"""Local features of points: fast point feature histograms, and shape features of the covariance."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.argument_errors import explain_argument_errors
from ..core.array_libraries import hand_out
from ..core.checks import check_indices, check_search, is_on_gpu
from ..core.gpu_arrays import take_indices
from ..kernels.features.eigen_features import measure_curvature, measure_shapes
from ..kernels.features.fpfh import compute_features, mask_points
from ..kernels.lang import int32
from ..kernels.memory import upload
from ..kernels.search.distinct_points import without_copies
from ..kernels.search.point_tree import PointTree
from .cached_tree import check_extent
from .cloud import PointCloud
from .length_checks import warn_of_sparse
from .point_arrays import check_cloud


@explain_argument_errors
def compute_fpfh_feature(
    cloud: PointCloud, *, radius: float | None = None, max_nn: int | None = 100, indices: ArrayLike | None = None
) -> NDArray[np.float32]:
    """Compute fast point feature histograms (FPFH): three histograms of 11 bins of the normal angles around each point.

    The features are invariant to rigid motion, so they match points of clouds before alignment. 132 B per point beside
    the result. Bitwise reproducible. Rusu, Blodow and Beetz, "Fast point feature histograms (FPFH) for 3D
    registration", ICRA 2009, as in Open3D: weights of one over the squared distance.

    Args:
        cloud: A cloud with normals.
        radius: Exclusive search radius [m]. If None: the `max_nn` nearest neighbors.
        max_nn: Maximum neighbors, including the point itself. If None: all within the radius.
        indices: Points to compute features for, shape (m,). If None: all.

    Returns:
        float32 (n, 33) or (m, 33) (Open3D: (33, n)). Each block of 11 sums to 200; zeros without neighbors. NaN if the
        position or normal is not finite. Such points are ignored as neighbors.

    Raises:
        ValueError: If the cloud has no normals, both limits are None, or a limit is out of range.
        IndexError, TypeError: If an index is out of range, or if the indices are not integers.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> cloud = loom.PointCloud(np.random.default_rng(0).random((500, 3)) * [1, 1, 0.1])
        >>> cloud = cloud.estimate_normals(radius=0.2, max_nn=30)
        >>> features = loom.compute_fpfh_feature(cloud, radius=0.3, max_nn=100)
        >>> features.shape, np.unique(features.reshape(-1, 11).sum(axis=1).round(2)).tolist()
        ((500, 33), [200.0])
    """
    check_cloud("cloud", cloud)
    search_radius, count = check_search(radius, max_nn)
    if "normals" not in cloud.arrays:
        raise ValueError("cloud: FPFH needs normals, and it has none; call cloud = cloud.estimate_normals()")
    rows = None if indices is None else _device_indices(indices, cloud)
    normals = cloud.arrays["normals"]
    masked = mask_points(cloud.arrays["points"], normals)
    tree = cloud.search_tree() if masked is None else PointTree(masked)
    check_extent("cloud", tree.low, tree.high, tree.source)
    warn_of_sparse("radius", without_copies(tree), radius, 2, cloud.unit, "their features are zeros")
    return hand_out(compute_features(tree, normals, search_radius, count, rows), cloud.array_library)


@explain_argument_errors
def compute_eigen_features(cloud: PointCloud, *, radius: float | None = None, max_nn: int | None = 30) -> PointCloud:
    """Compute shape features from the eigenvalues of each neighborhood's covariance.

    With eigenvalues l1 >= l2 >= l3 and e = l / (l1 + l2 + l3), the attributes are

    - `eigenvalues`: l1, l2, l3 [m^2], shape (n, 3), of the covariance divided by the number of neighbors;
    - `linearity`: (l1 - l2) / l1; `planarity`: (l2 - l3) / l1; `sphericity` (scattering): l3 / l1. Their sum is 1;
    - `omnivariance`: (e1 e2 e3)^(1/3); `anisotropy`: (l1 - l3) / l1; `eigenentropy`: -sum of e ln e;
    - `curvature` (surface variation): e3, 0 on a plane and 1/3 in a ball;
    - `verticality`: `1 - |nz|` of the normal, 0 on the ground and 1 on a wall;
    - `density` [1 / m^3]: neighbors per volume of the search ball, or of the ball up to the last of `max_nn` neighbors.

    O(n) memory, bitwise reproducible. Weinmann et al., "Semantic point cloud interpretation based on optimal
    neighborhoods", ISPRS 2015, section 3.2. Pauly, Gross and Kobbelt 2002.

    Args:
        cloud: Any cloud. Normals are not needed.
        radius: Exclusive search radius [m]. If None: the `max_nn` nearest neighbors.
        max_nn: Maximum neighbors, including the point itself. If None: all within the radius.

    Returns:
        The cloud with these attributes, float32. NaN with fewer than 3 distinct neighbors and for non-finite points.

    Raises:
        ValueError: If both limits are None, or a limit is out of range.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> line = loom.PointCloud(np.linspace(0, 1, 50)[:, None] * [0, 0, 1])
        >>> shapes = loom.compute_eigen_features(line, max_nn=10)
        >>> float(shapes["linearity"].min()), float(shapes["verticality"].max())
        (1.0, 1.0)
    """
    check_cloud("cloud", cloud)
    search_radius, count = check_search(radius, max_nn)
    shapes = measure_shapes(cloud.search_tree(), search_radius, count)
    return _with_attributes(cloud, shapes)


@explain_argument_errors
def estimate_curvature(cloud: PointCloud, *, radius: float | None = None, max_nn: int | None = 30) -> PointCloud:
    """Compute the surface variation of each neighborhood: 0 on a plane, more on edges, at most 1/3.

    O(n) memory, bitwise reproducible. Pauly, Gross and Kobbelt, VIS 2002, section 2.2.

    Args:
        cloud: Any cloud. Normals are not needed.
        radius: Exclusive search radius [m]. If None: the `max_nn` nearest neighbors.
        max_nn: Maximum neighbors, including the point itself. If None: all within the radius.

    Returns:
        The cloud with `curvature`, float32: the smallest eigenvalue over their sum. NaN as `compute_eigen_features`.

    Raises:
        ValueError: If both limits are None, or a limit is out of range.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.meshgrid(np.arange(20), np.arange(20))
        >>> roof = loom.PointCloud(np.column_stack([x.ravel(), y.ravel(), np.minimum(x, 19 - x).ravel()]))
        >>> curvature = loom.estimate_curvature(roof, max_nn=9)["curvature"].reshape(20, 20)
        >>> bool(curvature[10, 5] < 1e-6), bool(curvature[10, 9] > 0.01)
        (True, True)
    """
    check_cloud("cloud", cloud)
    search_radius, count = check_search(radius, max_nn)
    return _with_attributes(cloud, {"curvature": measure_curvature(cloud.search_tree(), search_radius, count)})


def _device_indices(indices: ArrayLike, cloud: PointCloud) -> Any:
    if is_on_gpu(indices):
        return take_indices("indices", indices, cloud.device, len(cloud), of=f"cloud of {len(cloud)} points")
    what = {"of": f"cloud of {len(cloud)} points", "hint": "; convert a mask with np.flatnonzero"}
    return upload(check_indices("indices", indices, len(cloud), **what), int32, cloud.device)


def _with_attributes(cloud: PointCloud, arrays: dict[str, Any]) -> PointCloud:
    return cloud.with_arrays(cloud.arrays | arrays, grid=cloud.grid)
