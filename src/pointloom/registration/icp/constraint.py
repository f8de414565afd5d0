"""Constraints of ICP: free motions and prior poses."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.attribute_hints import nearest_name
from ...core.checks import check_finite, check_list, check_numeric, check_positive, check_rigid, check_shape, shown
from ...kernels.algebra.rigid_solve import square
from ...kernels.icp.freedom import NO_MOTION, STILL_TURNING, Freedom, motion_state
from ...kernels.icp.loop import RegistrationLoop
from ...kernels.lang import int32, mat33d, mat44d, vec3d
from ...kernels.linear_algebra import cube_root, det, eigh, eigvalsh, matmul, norm
from ...kernels.memory import download
from ..rigid import nearest_rotation, rotation_vector, to_local

MOTIONS = ("roll", "pitch", "yaw", "x", "y", "z")  # in the order of the unknowns
MAX_FRAME_DEVIATION = 1e-6  # tolerance of F^T F - I
MAX_ASYMMETRY = 1e-9  # relative to the largest entry
MAX_NEGATIVE_EIGENVALUE = 1e-9  # relative to the largest eigenvalue
MIN_SIGMA, MAX_SIGMA = 1e-12, 1e12  # [m], [rad] valid range of sigmas
MAX_SIGMAS = 5.0  # maximum distance of a prior from reachable poses, in sigmas
PRIOR_ITERATIONS = 20  # Gauss-Newton iterations of that check
Matrix = NDArray[np.float64]


@dataclasses.dataclass(frozen=True, eq=False)
class Prior:
    """A known pose with its uncertainty, from odometry, GNSS or an earlier survey.

    ICP minimizes sum w r^2 / noise^2 + xi^T information xi with xi = (rotation vector of R R_p^T [rad], displacement of
    the pivot's image from the prior [m]), along the target's axes.

    Args:
        transformation: The pose T_target_source, 4x4.
        information: Inverse covariance of xi, 6x6, rotation first, about the registration's pivot. Positive
            semidefinite: directions without information are free.
        sigma_translation: Instead: standard deviation of the translation [m], one or [3]; None: unknown.
        sigma_rotation: Likewise of the rotation [rad], about x, y, z.

    Raises:
        ValueError: The pose is not rigid, the information is not symmetric, finite and semidefinite, deviations are not
            positive, or the uncertainty is missing or given twice.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> prior = loom.registration.Prior(np.eye(4), sigma_translation=[0.1, 0.1, 0.5])
        >>> np.diag(prior.information).round(3).tolist()
        [0.0, 0.0, 0.0, 100.0, 100.0, 4.0]
    """

    transformation: ArrayLike
    information: ArrayLike | None = None
    sigma_translation: ArrayLike | None = None
    sigma_rotation: ArrayLike | None = None

    def __post_init__(self) -> None:
        T = np.array(check_rigid("transformation", self.transformation))
        T[:3, :3] = nearest_rotation(T[:3, :3])
        sigmas = {"sigma_rotation": self.sigma_rotation, "sigma_translation": self.sigma_translation}
        given = [name for name, value in sigmas.items() if value is not None]
        if self.information is not None and given:
            raise ValueError(f"information, {given[0]}: expected one of them, got both")
        if self.information is None and not given:
            raise ValueError(
                "information: expected the uncertainty of the prior, got None. Pass it, or sigma_translation="
            )
        if self.information is None:
            parts = [_weights_of(name, value) for name, value in sigmas.items()]
            information = np.diag(np.concatenate(parts))
        else:
            information = check_information("information", self.information)
        object.__setattr__(self, "transformation", T)
        object.__setattr__(self, "information", information)


def check_information(name: str, matrix: object) -> Matrix:
    M = check_finite(name, check_shape(name, matrix, (6, 6)))
    largest = float(np.abs(M).max())
    if np.abs(M - M.T).max() > MAX_ASYMMETRY * largest:
        raise ValueError(f"{name}: expected a symmetric matrix, got entries that differ by {np.abs(M - M.T).max():.3g}")
    values = eigvalsh((M + M.T) / 2)
    if values[0] < -MAX_NEGATIVE_EIGENVALUE * max(values[-1], -values[0]):
        raise ValueError(f"{name}: expected no negative eigenvalue, got {values[0]:.3g}; invert a covariance first")
    return (M + M.T) / 2


def _weights_of(name: str, sigma: ArrayLike | None) -> NDArray[np.float64]:
    """1 / sigma^2 of three axes, or zeros if unknown."""
    if sigma is None:
        return np.zeros(3)
    values = check_finite(name, check_numeric(name, sigma))
    if values.ndim == 0:
        values = np.array(check_positive(name, sigma))
    if values.shape not in ((), (3,)):
        raise ValueError(f"{name}: expected one standard deviation or [3], got shape {list(values.shape)}")
    if not ((values >= MIN_SIGMA) & (values <= MAX_SIGMA)).all():
        limits = f"from {MIN_SIGMA:g} to {MAX_SIGMA:g}"
        raise ValueError(f"{name}: expected standard deviations {limits}, got {shown(values.tolist())}")
    return np.broadcast_to(1 / values.astype(np.float64) ** 2, (3,))


@dataclasses.dataclass(frozen=True, eq=False)
class JobConstraints:
    """The checked constraint of one or more jobs.

    `pivots`: [1 or jobs, 3] in the target's world, None: source center; `noise`: 0 means that of the pairs; `anchors`:
    [jobs, 4, 4] poses of fixed motions if not the initial ones, with `motion_state`s `states` [jobs, 8].
    """

    free: tuple[str, ...]
    frame: Matrix
    pivots: Matrix | None
    priors: tuple[Prior, ...]
    noise: float
    anchors: Matrix | None = None
    states: Matrix | None = None

    def about(self, pivot: NDArray[np.float64]) -> JobConstraints:
        return dataclasses.replace(self, pivots=pivot[None]) if self.pivots is None else self

    def begun(self, anchor: Matrix, state: Matrix | None) -> JobConstraints:
        """The constraint with one job's fixed motions at an earlier pose, continued from a state."""
        if state is None:
            return self
        return dataclasses.replace(self, anchors=anchor[None], states=state[None])


@dataclasses.dataclass(frozen=True, eq=False)
class Constraint:
    """Restriction of the motions that ICP estimates: fixed motions, a prior pose, or both.

    Args:
        free: Free motions of "x", "y", "z", "roll", "pitch" and "yaw"; None: all. The others keep `init` exactly: ("x",
            "y", "z", "yaw") keeps a leveled scan level (`leveled`), ("x",) is a rail. Rotations are Rz(yaw) Ry(pitch)
            Rx(roll) from `init`. Not for the symmetric and the Doppler estimator.
        frame: Axes of those motions as columns in target coordinates, 3x3; None: the target's axes.
        pivot: Center of rotation [3] in target coordinates, whose image moves along x, y and z, or one per job of a
            batch [jobs, 3]; None: the center of the source under `init`.
        prior: A known pose with its uncertainty, or one per job of a batch. It determines the motions that the pairs do
            not, reported in `prior_directions`.
        noise: Standard deviation of the residuals ([m]; for generalized ICP in units of the covariances) to weigh pairs
            against the prior; None: that of each iteration's pairs, each an independent measurement.

    Raises:
        ValueError: Unknown motions, axes that are not orthonormal, an invalid number, or `frame`, `pivot` or `noise`
            without the argument that they refer to.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> points = np.random.default_rng(0).random((500, 3))
        >>> rail = loom.registration.Constraint(free=("x",))
        >>> target, source = loom.PointCloud(points), loom.PointCloud(points + [0.01, 0.02, 0])
        >>> result = loom.registration.registration_icp(source, target, 0.1, constraint=rail)
        >>> result.transformation[:3, 3].round(3).tolist()
        [-0.01, 0.0, 0.0]
    """

    free: Sequence[str] | None = None
    frame: ArrayLike | None = None
    pivot: ArrayLike | None = None
    prior: Prior | Sequence[Prior] | None = None
    noise: float | None = None
    _jobs: JobConstraints = dataclasses.field(init=False, repr=False)

    def __post_init__(self) -> None:
        names = MOTIONS if self.free is None else check_free(self.free)
        priors = () if self.prior is None else _check_priors(self.prior)
        if not priors and self.noise is not None:
            raise ValueError("noise: requires prior=, which weights the pairs. Pass prior=, or leave noise out")
        if self.frame is not None and self.free is None:
            raise ValueError("frame: requires free=, and all motions are free. Pass free=, or leave frame out")
        if self.pivot is not None and self.free is None and not priors:
            raise ValueError("pivot: requires free= or prior=, got neither. Leave pivot out")
        axes = np.eye(3) if self.frame is None else _check_frame(self.frame)
        pivots = None if self.pivot is None else _check_pivots(self.pivot)
        noise = 0.0 if self.noise is None else check_positive("noise", self.noise)
        object.__setattr__(self, "free", names)
        object.__setattr__(self, "_jobs", JobConstraints(names, axes, pivots, priors, noise))


def constraints_of(constraint: Constraint | None, count: int = 1) -> JobConstraints | None:
    """The constraint of `count` jobs. None if it restricts nothing."""
    if constraint is None:
        return None
    if not isinstance(constraint, Constraint):
        raise TypeError(f"constraint: expected Constraint(free=..., prior=...), got {shown(constraint)}")
    jobs = constraint._jobs
    for name, values in (("pivot", jobs.pivots), ("prior", jobs.priors)):
        if values is not None and len(values) not in (0, 1, count):
            raise ValueError(f"constraint: expected one {name}, or one per job ({count}), got {len(values)}")
    return jobs if len(jobs.free) < len(MOTIONS) or jobs.priors else None


def check_free(free: object) -> tuple[str, ...]:
    names = check_list("free", free, f"motions among {', '.join(MOTIONS)}")
    if not names:
        raise ValueError(
            f"free: expected at least one of {', '.join(MOTIONS)}; to rate a pose, use evaluate_registration()"
        )
    for name in names:
        if not isinstance(name, str):
            raise TypeError(f"free: expected names such as 'x', got {shown(name)}")
        if name not in MOTIONS:
            hint = nearest_name(name.lower(), MOTIONS)
            raise ValueError(f"free: expected names among {', '.join(MOTIONS)}, got {shown(name)}{hint}")
        if names.count(name) > 1:
            raise ValueError(f"free: {name!r} is duplicated")
    return tuple(name for name in MOTIONS if name in names)


def _check_frame(frame: object) -> Matrix:
    F = check_finite("frame", check_shape("frame", frame, (3, 3)))
    error = float(np.abs(matmul(F.T, F) - np.eye(3)).max())
    if error > MAX_FRAME_DEVIATION:
        raise ValueError(f"frame: expected orthonormal columns, the axes, got F^T F - I up to {error:.3g}")
    if det(F) < 0:
        raise ValueError("frame: expected right-handed axes, got left-handed ones; negate one of the columns")
    return F if error == 0 else nearest_rotation(F)


def _check_pivots(pivot: object) -> Matrix:
    values = check_finite("pivot", check_numeric("pivot", pivot).astype(np.float64))
    if values.shape != (3,) and (values.ndim != 2 or values.shape[1] != 3 or not len(values)):
        raise ValueError(f"pivot: expected shape [3] or [jobs, 3], got {list(values.shape)}")
    return values.reshape(-1, 3)


def _check_priors(prior: object) -> tuple[Prior, ...]:
    priors = [prior] if isinstance(prior, Prior) else check_list("prior", prior, "Prior, one per job")
    for one in priors:
        if not isinstance(one, Prior):
            raise TypeError(f"prior: expected Prior(transformation, sigma_translation=...), got {shown(one)}")
    return tuple(priors)


def make_freedom(
    constraint: JobConstraints,
    loop: RegistrationLoop,
    poses: Matrix,
    origins: Sequence[tuple[NDArray[np.float64], NDArray[np.float64]]],
    residual_count: int,
) -> Freedom:
    """The constraint on the device. ValueError if a prior is unreachable under the free motions."""
    count, priors, pivots = len(poses), constraint.priors, constraint.pivots
    free = np.array([name in constraint.free for name in MOTIONS])
    if pivots is not None:
        pivots = pivots - np.array([target for _, target in origins]).reshape(-1, 3)
    elif priors:
        pivots = download(loop.progress.pivots).copy()  # sync
    rotations, shifted = np.tile(np.eye(3), (count, 1, 1)), np.zeros((count, 3))
    information = np.zeros((count, 36))
    for job in range(count if priors else 0):
        assert pivots is not None
        prior = priors[job % len(priors)]
        rotations[job], shifted[job] = _from_prior(
            poses[job], to_local(np.array(prior.transformation), *origins[job]), pivots[job]
        )
        if not free.all():
            _check_prior(prior, rotations[job], shifted[job], constraint, free)
        information[job] = np.asarray(prior.information).reshape(36)
    still = STILL_TURNING if free[:3].all() else NO_MOTION
    values: dict[str, tuple[np.ndarray, Any]] = {
        "firsts": (poses, mat44d),
        "pivots": (np.zeros((count, 3)) if pivots is None else pivots, vec3d),
        "states": (np.tile(still, (count, 1)) if constraint.states is None else constraint.states, motion_state),
        "prior_rotations": (rotations, mat33d),
        "shifted": (shifted, vec3d),
        "information": (information, square),
        "prior_counts": (np.zeros(count), int32),
    }
    freedom = Freedom(
        values,
        constraint.frame,
        free,
        noise=constraint.noise,
        informed=bool(priors),
        residual_count=residual_count,
        device=loop.jobs.device,
    )
    if pivots is None:
        freedom.pivots = loop.progress.pivots
    return freedom


def _from_prior(T: Matrix, T_prior: Matrix, pivot: NDArray[np.float64]) -> tuple[Matrix, NDArray[np.float64]]:
    """R R_p^T, the displacement of the pivot's image from the prior, and the pivot."""
    scale = cube_root(float(det(T[:3, :3])))
    R = T[:3, :3] / scale
    point = matmul(R.T, pivot - T[:3, 3]) / scale
    rotation = nearest_rotation(matmul(R, T_prior[:3, :3].T))
    return rotation, pivot - (matmul(T_prior[:3, :3], point) + T_prior[:3, 3])


def _check_prior(
    prior: Prior, rotation: Matrix, shifted: NDArray[np.float64], constraint: JobConstraints, free: NDArray[np.bool_]
) -> None:
    """Raise `ValueError` if the prior is unreachable under the free degrees of freedom."""
    values, vectors = eigh(np.asarray(prior.information))
    root = np.sqrt(np.maximum(values, 0))[:, None] * vectors.T
    x = np.zeros(6)

    def away(x: NDArray[np.float64]) -> NDArray[np.float64]:
        D = matmul(constraint.frame, euler_rotation(x[:3]), constraint.frame.T)
        return np.concatenate([rotation_vector(matmul(D, rotation)), shifted + matmul(constraint.frame, x[3:])])

    steps = 1e-6 * np.eye(6)[free]
    for _ in range(PRIOR_ITERATIONS):
        J = np.stack([(away(x + s) - away(x - s)) / 2e-6 for s in steps], axis=1)
        x[free] -= np.linalg.lstsq(matmul(root, J), matmul(root, away(x)), rcond=1e-9)[0]
    xi = away(x)
    sigmas = float(norm(matmul(root, xi)))
    if sigmas > MAX_SIGMAS:
        fixed = ", ".join(name for name in MOTIONS if name not in constraint.free)
        raise ValueError(
            f"constraint: prior {norm(xi[:3]):.3g} rad and {norm(xi[3:]):.3g} m from all poses reachable from init "
            f"with free, {sigmas:.3g} standard deviations. Start at the prior (init), free {fixed}, or lower its weight"
        )


def euler_rotation(angles: NDArray[np.float64]) -> Matrix:
    (ca, cb, cc), (sa, sb, sc) = np.cos(angles), np.sin(angles)
    return np.array(
        [
            [cc * cb, cc * sb * sa - sc * ca, cc * sb * ca + sc * sa],
            [sc * cb, sc * sb * sa + cc * ca, sc * sb * ca - cc * sa],
            [-sb, cb * sa, cb * ca],
        ]
    )
