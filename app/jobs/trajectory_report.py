"""The error of a path of a camera as the commands tell it."""

from __future__ import annotations

from typing import Any

from ...core.reports import Fields
from ...registration.trajectories.trajectory_error import TrajectoryError
from .evaluate import describe_errors, error_fields

ALIGN = "se3"


def error_to_json(error: TrajectoryError | None) -> dict[str, Any] | None:
    """ATE and RPE in JSON's types as `evaluate_files` has them; None where the truth is not known."""
    return None if error is None else {"align": ALIGN, **describe_errors(error)}


def error_part(error: TrajectoryError | None) -> Fields:
    """ATE and RPE as labels and values, where the truth is known."""
    told = error_to_json(error)
    return [] if told is None else error_fields(told)
