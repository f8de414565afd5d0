"""Fast global registration: one robust cost over all correspondences, whose scale shrinks while it is minimised."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike

from ...core.checks import check_count, check_positive, check_seed
from ...core.told_arguments import told_arguments
from ...core.watching import report
from ...kernels.arrays.bounds import bound_each
from ...kernels.arrays.concatenation import concatenate_rows
from ...kernels.lang import mat44d
from ...kernels.memory import download, upload
from ...kernels.poses.pair_fits import PairCoordinates
from ...kernels.poses.pose_fitness import half_diagonal, middle_of
from ...kernels.poses.similar_tuples import similar_tuples
from ...pcd.cloud import PointCloud
from ..given_pairs import check_clouds, match_clouds, pairs_on_device, world_middles
from ..icp.evaluation import evaluate_registration
from ..result import RegistrationResult
from ..rigid import to_world
from .ransac import no_pose
from .rating import rate_registration

FEWEST = 10  # correspondences, as Open3D has it
RATED_WITHIN = 3.0  # distances: half a voxel is given here, one and a half are what a pose is rated by
TRIALS = 100  # triples tested a correspondence
EVERY = 2  # steps between two divisions of the scale: exact ones, where the paper takes four Gauss-Newton steps
STILL = 1e-3  # [rad, and of the half diagonal] a last step below this has converged
MOST_STEPS = 10_000
MOST_TUPLES = 10_000_000


class FastGlobalRegistrationOption:
    """How the cost is minimised.

    Args:
        division_factor: What the scale mu is divided by at every second step.
        use_absolute_scale: mu begins at 1 m^2, for clouds that are about a metre apart; else at the squared half
            diagonal of the larger cloud's box, from where any pose can be reached.
        decrease_mu: Divide mu until it is below the squared `maximum_correspondence_distance`. Without it all
            correspondences weigh almost alike to the end, and wrong ones pull the pose.
        maximum_correspondence_distance: [m] of right correspondences; also what fitness and error are measured with.
        iteration_number: Steps.
        tuple_scale: The least ratio of two sides in the test of triples, 0..1.
        maximum_tuple_count: Triples to find.
        tuple_test: Keep only the correspondences of triples whose triangles have similar sides.

    Raises:
        ValueError: A number out of its range.

    Notes:
        Open3D has two defaults of `decrease_mu`: true where no option is given, false in an option made in Python; the
        same pair of scans then ends at fitness 0.35 or 0.24. Here it is always true, as in the paper.

    Example:
        >>> import pointloom as loom
        >>> loom.registration.FastGlobalRegistrationOption(maximum_correspondence_distance=0.05).decrease_mu
        True
    """

    def __init__(
        self,
        division_factor: float = 1.4,
        use_absolute_scale: bool = False,
        decrease_mu: bool = True,
        maximum_correspondence_distance: float = 0.025,
        iteration_number: int = 64,
        tuple_scale: float = 0.95,
        maximum_tuple_count: int = 1000,
        tuple_test: bool = True,
    ):
        self.division_factor = check_positive("division_factor", division_factor)
        if self.division_factor <= 1:
            raise ValueError(f"division_factor: expected a number above 1, got {division_factor!r}")
        self.use_absolute_scale, self.decrease_mu = bool(use_absolute_scale), bool(decrease_mu)
        self.maximum_correspondence_distance = check_positive(
            "maximum_correspondence_distance", maximum_correspondence_distance
        )
        self.iteration_number = check_count(
            "iteration_number",
            iteration_number,
            maximum=MOST_STEPS,
            because="64 do for most clouds, and each costs the same",
        )
        self.tuple_scale = check_positive("tuple_scale", tuple_scale)
        if self.tuple_scale > 1:
            raise ValueError(f"tuple_scale: expected a number in 0..1, got {tuple_scale!r}")
        self.maximum_tuple_count = check_count(
            "maximum_tuple_count", maximum_tuple_count, maximum=MOST_TUPLES, because="each makes three correspondences"
        )
        self.tuple_test = bool(tuple_test)

    def __repr__(self) -> str:
        return f"FastGlobalRegistrationOption({', '.join(f'{name}={value}' for name, value in vars(self).items())})"


@told_arguments
def registration_fgr_based_on_feature_matching(
    source: PointCloud,
    target: PointCloud,
    source_feature: Any,
    target_feature: Any,
    option: FastGlobalRegistrationOption | None = None,
    *,
    seed: int = 0,
) -> RegistrationResult:
    """Register two clouds without a starting pose, from points whose features are each other's nearest.

    Args:
        source: The cloud to move.
        target: The cloud that stays, on the same device.
        source_feature: One row a point, [n, d], as `compute_fpfh_feature` gives them; NumPy or a device array.
        target_feature: Likewise [m, d].
        option: How; None for FastGlobalRegistrationOption().
        seed: Of the triples; the same seed gives the same bits.

    Returns:
        As `registration_fgr_based_on_correspondence`.

    Raises:
        ValueError: Features that are not one row a point.
        TypeError: An argument of another kind.
        DeviceError: The clouds are on different devices.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.random.default_rng(0).uniform(-1, 1, (2, 2000))
        >>> surface = np.column_stack([x, y, 0.2 * np.sin(3 * x) * np.cos(4 * y) + 0.1 * np.sin(7 * y + x)])
        >>> target = loom.PointCloud(surface).estimate_normals(radius=0.1, max_nn=30)
        >>> target = target.orient_normals_to_align_with_direction()
        >>> T = np.array([[0, -1.0, 0, 5], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
        >>> source = target.transform(np.linalg.inv(T))
        >>> features = [loom.compute_fpfh_feature(cloud, radius=0.25, max_nn=100) for cloud in (source, target)]
        >>> result = loom.registration.registration_fgr_based_on_feature_matching(source, target, *features)
        >>> bool(np.allclose(result.transformation, T, atol=1e-3)), round(result.fitness, 3)
        (True, 1.0)
    """
    check_clouds(source, target)
    option, number = _check_option(option), check_seed(seed)
    pairs = match_clouds(source, target, source_feature, target_feature, True, 0.0)
    return _register(source, target, pairs, option, number)


def registration_fgr_based_on_correspondence(
    source: PointCloud,
    target: PointCloud,
    corres: ArrayLike,
    option: FastGlobalRegistrationOption | None = None,
    *,
    seed: int = 0,
) -> RegistrationResult:
    """Register two clouds without a starting pose, from correspondences of which many may be wrong.

    Args:
        source: The cloud to move.
        target: The cloud that stays, on the same device.
        corres: Indices (source, target), shape [m, 2]. Those of points that are not finite do not count.
        option: How; None for FastGlobalRegistrationOption().
        seed: Of the triples; the same seed gives the same bits.

    Returns:
        The pose with the least cost; fitness and error of the whole clouds within the option's distance. `converged`
        says whether the last step moved next to nothing, `score` rates the pose (`rate_registration` at
        three times that distance). With fewer than 10 correspondences, given or left by the test of triples: the
        identity, fitness and score 0, not converged, and a reason.

    Raises:
        ValueError: Another shape.
        IndexError: An index beyond its cloud.
        TypeError: An argument of another kind.
        DeviceError: The clouds are on different devices.

    Notes:
        Zhou, Park and Koltun, "Fast global registration", ECCV 2016. Each step solves its weighted least squares by
        Horn's closed form, where the paper takes a Gauss-Newton step: so mu is divided at every second step instead of
        every fourth. mu is a squared length, as in the paper, from the squared half diagonal down to the squared
        distance; Open3D begins at the cloud's radius in metres and ends at the distance in metres, so that its result
        depends on the unit of length.

        Memory O(n + m). The same bits from run to run whatever the number of threads.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.registration.globally.fast_global import registration_fgr_based_on_correspondence
        >>> rng = np.random.default_rng(0)
        >>> target = loom.PointCloud(rng.random((500, 3)))
        >>> T = np.array([[0, -1.0, 0, 5], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
        >>> source = target.transform(np.linalg.inv(T))
        >>> pairs = np.column_stack([np.arange(500), np.arange(500)])
        >>> pairs[250:, 1] = rng.integers(0, 500, 250)  # half of them are wrong
        >>> result = registration_fgr_based_on_correspondence(source, target, pairs)
        >>> bool(np.allclose(result.transformation, T, atol=1e-2)), result.fitness > 0.9
        (True, True)
    """
    check_clouds(source, target)
    return _register(source, target, pairs_on_device(corres, source, target), _check_option(option), check_seed(seed))


def _check_option(option: Any) -> FastGlobalRegistrationOption:
    option = FastGlobalRegistrationOption() if option is None else option
    if not isinstance(option, FastGlobalRegistrationOption):
        raise TypeError(f"option: expected FastGlobalRegistrationOption, got {type(option).__name__}")
    return option


def _register(
    source: PointCloud, target: PointCloud, given: wp.array, option: FastGlobalRegistrationOption, seed: int
) -> RegistrationResult:
    points = source._device_array("points"), target._device_array("points")
    boxes = [box[:2] for box in bound_each(points)]  # sync
    middles = middle_of(*boxes[0]), middle_of(*boxes[1])
    pairs = PairCoordinates(*points, given, *middles)
    if pairs.count < FEWEST:
        return no_pose(f"{FEWEST} correspondences of finite points needed, {pairs.count} given", source)
    if option.tuple_test:
        most = option.maximum_tuple_count
        pairs = pairs.select(similar_tuples(pairs, seed, TRIALS * pairs.count, option.tuple_scale, most))
        if pairs.count < FEWEST:
            return no_pose(f"{FEWEST} correspondences needed, {pairs.count} left by the test of triples", source)
    radius = max(half_diagonal(*box) for box in boxes)
    pose = upload(np.eye(4)[None], mat44d, source.device)
    mu = 1.0 if option.use_absolute_scale else radius * radius
    least = option.maximum_correspondence_distance**2 if option.decrease_mu else np.inf
    before = pairs.anneal(pose, mu, least, option.division_factor, EVERY, option.iteration_number)
    local, previous = download(concatenate_rows([pose, before])).astype(np.float64)  # sync
    T = to_world(local, *world_middles(source, target, middles))
    result = evaluate_registration(source, target, option.maximum_correspondence_distance, T)
    change = np.abs(local - previous)
    result.iterations = option.iteration_number
    result.converged = bool(change[:3, :3].max() < STILL and change[:3, 3].max() < STILL * radius)
    result.reason = "converged" if result.converged else "max_iteration"
    reach = RATED_WITHIN * option.maximum_correspondence_distance
    result.score = partial(rate_registration, source.copy(), target.copy(), T, reach)
    report("registration", source=source, target=target, result=result)
    return result
