"""Fast global registration (Zhou, Park and Koltun 2016): a robust cost over correspondences with a shrinking scale."""

from __future__ import annotations

from functools import partial

import numpy as np
import warp as wp
from numpy.typing import ArrayLike

from ...core.argument_errors import explain_argument_errors
from ...core.checks import check_count, check_positive, check_seed
from ...core.observers import report
from ...kernels.arrays.bounds import bound_each
from ...kernels.arrays.concatenation import concatenate_rows
from ...kernels.lang import mat44d
from ...kernels.memory import download, upload
from ...kernels.poses.pair_fits import PairCoordinates
from ...kernels.poses.pose_fitness import half_diagonal, middle_of
from ...kernels.poses.similar_tuples import similar_tuples
from ...pcd.cloud import PointCloud
from ..correspondence_input import check_clouds, pairs_on_device, world_middles
from ..icp.evaluation import evaluate_registration
from ..result import RegistrationResult
from ..rigid import to_world
from .ransac import no_pose
from .rating import score_registration

MIN_CORRESPONDENCES = 10  # minimum correspondences, as in Open3D
RATED_WITHIN = 3.0  # half a voxel is given here, rating uses one and a half
TRIALS_PER_PAIR = 100  # tested triples per correspondence
STEPS_PER_DIVISION = 2  # steps per scale division (the paper: four Gauss-Newton steps)
CONVERGED_STEP = 1e-3  # [rad, and of the half diagonal] convergence of the last step
MAX_STEPS = 10_000
MAX_TUPLES = 10_000_000


class FastGlobalRegistrationOption:
    """Options of fast global registration.

    Args:
        division_factor: Divisor of the scale mu at every second step.
        use_absolute_scale: Start with mu = 1 m^2, for clouds about a meter apart. Otherwise with the squared half
            diagonal of the larger bounding box, which reaches any pose.
        decrease_mu: Divide mu until it is below the squared `maximum_correspondence_distance`. Without it outliers keep
            almost full weight.
        maximum_correspondence_distance: Inlier distance [m], also for fitness and error.
        iteration_number: Number of steps.
        tuple_scale: Minimum ratio of two sides in the triple test, 0..1.
        maximum_tuple_count: Number of triples.
        tuple_test: Keep only correspondences of triples whose triangles have similar sides.

    Raises:
        ValueError: A number is out of range.

    Notes:
        Open3D's default of `decrease_mu` differs between C++ (true, as here) and Python (false).

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
            maximum=MAX_STEPS,
            because="64 suffice for most clouds, and the cost is proportional",
        )
        self.tuple_scale = check_positive("tuple_scale", tuple_scale)
        if self.tuple_scale > 1:
            raise ValueError(f"tuple_scale: expected a number in 0..1, got {tuple_scale!r}")
        self.maximum_tuple_count = check_count(
            "maximum_tuple_count", maximum_tuple_count, maximum=MAX_TUPLES, because="each gives three correspondences"
        )
        self.tuple_test = bool(tuple_test)

    def __repr__(self) -> str:
        return f"FastGlobalRegistrationOption({', '.join(f'{name}={value}' for name, value in vars(self).items())})"


@explain_argument_errors
def registration_fgr_based_on_correspondence(
    source: PointCloud,
    target: PointCloud,
    corres: ArrayLike,
    option: FastGlobalRegistrationOption | None = None,
    *,
    seed: int = 0,
) -> RegistrationResult:
    """Register two clouds without a starting pose, from correspondences with many outliers.

    Args:
        source, target, corres: As of `registration_ransac_based_on_correspondence`.
        option: None: FastGlobalRegistrationOption().
        seed: Seed of the triples.

    Returns:
        The pose with the least cost, with fitness and error of the complete clouds. `converged` is True if the last
        step hardly moved; `score` is that of `assess_registration` at three times the distance. With fewer than 10
        correspondences (given, or after the triple test): the identity, fitness 0 and a warning.

    Raises:
        ValueError, IndexError: A wrong shape, or an index out of range.
        TypeError, DeviceError: An argument has another type, or the clouds are on different devices.

    Notes:
        Zhou, Park and Koltun, "Fast global registration", ECCV 2016. Steps use Horn's closed form instead of
        Gauss-Newton, so mu is divided at every second step, not every fourth. mu is a squared length, as in the paper.
        Open3D's result depends on the unit of length. Memory O(n + m). Bitwise reproducible for any number of threads.

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


def _check_option(option: object) -> FastGlobalRegistrationOption:
    option = FastGlobalRegistrationOption() if option is None else option
    if not isinstance(option, FastGlobalRegistrationOption):
        raise TypeError(f"option: expected FastGlobalRegistrationOption, got {type(option).__name__}")
    return option


def _register(
    source: PointCloud, target: PointCloud, given: wp.array, option: FastGlobalRegistrationOption, seed: int
) -> RegistrationResult:
    points = source.arrays["points"], target.arrays["points"]
    boxes = [box[:2] for box in bound_each(points)]  # sync
    middles = middle_of(*boxes[0]), middle_of(*boxes[1])
    pairs = PairCoordinates(*points, given, *middles)
    if pairs.count < MIN_CORRESPONDENCES:
        return no_pose(f"{MIN_CORRESPONDENCES} correspondences of finite points needed, {pairs.count} given", source)
    if option.tuple_test:
        max_tuples = option.maximum_tuple_count
        pairs = pairs.select(similar_tuples(pairs, seed, TRIALS_PER_PAIR * pairs.count, option.tuple_scale, max_tuples))
        if pairs.count < MIN_CORRESPONDENCES:
            return no_pose(
                f"{MIN_CORRESPONDENCES} correspondences needed, {pairs.count} left after the tuple test", source
            )
    radius = max(half_diagonal(*box) for box in boxes)
    pose = upload(np.eye(4)[None], mat44d, source.device)
    mu = 1.0 if option.use_absolute_scale else radius * radius
    min_mu = option.maximum_correspondence_distance**2 if option.decrease_mu else np.inf
    before = pairs.anneal(pose, mu, min_mu, option.division_factor, STEPS_PER_DIVISION, option.iteration_number)
    local, previous = download(concatenate_rows([pose, before])).astype(np.float64)  # sync
    T = to_world(local, *world_middles(source, target, middles))
    result = evaluate_registration(source, target, option.maximum_correspondence_distance, T)
    change = np.abs(local - previous)
    result.iterations = option.iteration_number
    result.converged = bool(change[:3, :3].max() < CONVERGED_STEP and change[:3, 3].max() < CONVERGED_STEP * radius)
    moving = f"the pose still changed after {option.iteration_number} iterations"
    result.warnings = () if result.converged else (moving,)
    max_distance = RATED_WITHIN * option.maximum_correspondence_distance
    result.score = partial(score_registration, source.copy(), target.copy(), max_distance, T)
    report("registration", source=source, target=target, result=result)
    return result
