"""Every argument of every public function of odometry refuses what makes no sense, by an error that names it.

The checks are the host's, so the CPU stands for all devices. Records that operations return are left out.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import pointloom as loom

from ...hostile import faults_of, missing_from, public_arguments, read_table

od = loom.odometry

# One line a call: what is called, and a good value of each of its arguments, as expressions over `things()`.
CALLS = """
reg.OdometryOption(iteration_number_per_pyramid_level=[3, 2], depth_diff_max=0.03, depth_min=0.0, depth_max=4.0)
reg.OdometryConvergenceCriteria(max_iteration=3, relative_rmse=1e-6, relative_fitness=1e-6)
reg.OdometryLossParams(depth_outlier_trunc=0.07, depth_huber_delta=0.05, intensity_huber_delta=0.1)
reg.OdometryFrame(depth=depth, intrinsic=camera, color=color, depth_scale=1000.0, depth_max=5.0, device="cpu")
reg.align_frames(source=frame, target=frame, T_target_source=pose, method=hybrid)
reg.compute_rgbd_odometry(source=rgbd, target=rgbd, pinhole_camera_intrinsic=camera, odo_init=pose, jacobian=term, option=option, weights="robust")
reg.rgbd_odometry_multi_scale(source=rgbd, target=rgbd, intrinsics=camera, init_source_to_target=pose, depth_scale=1000.0, depth_max=4.0, criteria_list=[rules], method=hybrid, params=params, weights="robust")
reg.compute_odometry_information_matrix(source_depth=depth, target_depth=depth, intrinsic=camera, source_to_target=pose, dist_threshold=0.07, depth_scale=1000.0, depth_max=3.0)
"""  # noqa: E501
RESULTS = {"OdometryResult", "Method", "RGBDOdometryJacobianFromColorTerm", "RGBDOdometryJacobianFromHybridTerm"}
MAY_BE_INFINITE = {("OdometryOption", "depth_max"), ("OdometryFrame", "depth_max")}
TABLE = read_table(CALLS, {})


@cache
def things() -> dict[str, Any]:
    """What the expressions of the table name."""
    rng = np.random.default_rng(0)
    depth, color = np.full((24, 32), 1500, np.uint16), rng.integers(0, 255, (24, 32, 3), np.uint8)
    camera = loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5)
    return dict(
        reg=od, depth=depth, color=color, camera=camera, pose=np.eye(4), frame=od.OdometryFrame(depth, camera, color),
        rgbd=loom.RGBDImage(color, depth), hybrid=od.Method.Hybrid, term=od.RGBDOdometryJacobianFromHybridTerm(),
        option=od.OdometryOption(), rules=od.OdometryConvergenceCriteria(2), params=od.OdometryLossParams(),
    )  # fmt: skip


def test_the_table_names_every_argument_of_every_public_call():
    assert missing_from(TABLE, public_arguments(od, RESULTS)) == {}


@pytest.mark.parametrize("call", TABLE)
def test_the_good_arguments_are_taken(call):
    function, expressions = TABLE[call]
    values = dict(things())
    eval(function, values)(**{name: eval(expression, values) for name, expression in expressions.items()})


CASES = [(call, name) for call, (_, names) in TABLE.items() for name in names]


@pytest.mark.parametrize(("call", "argument"), CASES)
def test_a_hostile_value_is_refused_by_name(call, argument):
    function, expressions = TABLE[call]
    good = {name: eval(expression, dict(things())) for name, expression in expressions.items()}
    finite = (call, argument) not in MAY_BE_INFINITE
    faults = faults_of(lambda **given: eval(function, dict(things()))(**given), good, argument, finite=finite)
    assert not faults, "\n".join(faults)
