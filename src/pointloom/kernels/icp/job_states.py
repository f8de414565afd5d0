"""State of all jobs between iterations, in one allocation with one sync to read."""

from typing import TYPE_CHECKING, Any

import numpy as np

from ..arrays.side_by_side import SideBySide
from ..lang import float32, float64, int32, mat44d, vec3d, vector

if TYPE_CHECKING:
    from .jobs import Jobs

JOB_RUNNING = 0  # job outcomes
JOB_CONVERGED = 1
OUT_OF_ITERATIONS = 2
NO_PAIRS = 3
NOT_FINITE = 4
FEW_PAIRS = 5

free_directions = vector(36, float64)  # up to six unit vectors, one per row


def match_states(jobs: "Jobs", poses: np.ndarray) -> SideBySide:
    """States of one match under poses float64 (jobs, 4, 4), described by `Matches`."""
    return SideBySide(_match_values(jobs, poses), jobs.device)


def _match_values(jobs: "Jobs", poses: np.ndarray) -> dict[str, tuple[np.ndarray, Any]]:
    return {
        "poses": (poses, mat44d),
        "earlier": (poses, mat44d),
        "live": (np.ones(jobs.count), int32),
        "margins": (np.zeros(jobs.count), float32),
    }


def job_states(jobs: "Jobs", poses: np.ndarray) -> SideBySide:
    """Initial states for first poses float64 (jobs, 4, 4): a SideBySide described by `Matches` and `Progress`."""
    count = jobs.count
    values = _match_values(jobs, poses) | {
        "pivots": (np.zeros((count, 3)), vec3d),
        "sizes": (np.zeros(count), float64),
        "source_counts": (np.maximum(jobs.counts, 1), float64),
        "iterations": (np.zeros(count), int32),
        "outcomes": (np.full(count, JOB_RUNNING), int32),
        "fitness": (np.zeros(count), float64),
        "rmse": (np.zeros(count), float64),
        "free_counts": (np.zeros(count), int32),
        "free": (np.zeros((count, 36)), free_directions),
        "running": (np.array([count]), int32),
    }
    return SideBySide(values, jobs.device)
