"""Result of a registration job: the pose graph and each tried pair."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from ...core.errors import FilePath
from ...core.wording import plain
from ...registration.pose_graphs.multiway import FragmentsResult, fragments_result
from ..manifest import NAME, damage_as_file_errors
from .job import Done, done_in
from .run_jobs import finished_job
from .scans import STAGE_WORDS, RegistrationJob, solve_graph


class TriedPair(NamedTuple):
    """A pair of scans that was tried.

    Attributes:
        source, target: Indices of the scans.
        by: Reason: "known", "order", "place", "look", or "loop" (predicted by poses).
        score: As of `FragmentPair`. NaN for loops.
        status: "kept" in the pose graph; "dropped" if contradictory; "apart" if in a smaller group. Else the reason.
    """

    source: int
    target: int
    by: str
    score: float
    status: str


@dataclass(frozen=True, eq=False)
class PlacedScans(FragmentsResult):
    """Poses of the scans of a job: a `FragmentsResult` with the files `scans`, their `points` and `tried` pairs."""

    scans: list[str]
    points: int
    tried: list[TriedPair]

    @property
    def not_placed(self) -> list[str]:
        """Files of the scans outside the largest group."""
        return [path for path, is_registered in zip(self.scans, self.placed, strict=True) if not is_registered]

    def to_dict(self, names: Any = None) -> dict[str, Any]:
        """As of FragmentsResult, with the tried pairs. Scans are named by their files by default."""
        called = self.scans if names is None else names
        tried = [pair._asdict() | {"source": called[pair.source], "target": called[pair.target]} for pair in self.tried]
        return super().to_dict(called) | {"tried": plain(tried)}


def finish_registration(folder: FilePath) -> PlacedScans:
    """Compute the poses of a job's scans in a common frame from the manifest alone.

    Args:
        folder: Folder of `plan_registration`, all tasks done.

    Returns:
        As `register_multiway`, bitwise equal for the same pairs, with scans in planned order. `result.not_placed`
        lists unconnected scans, `result.tried` each pair; `result.trajectory` can be written.

    Raises:
        FileError: If tasks are not done.
    """
    manifest, job = finished_job(folder, RegistrationJob)
    with manifest, damage_as_file_errors(manifest.folder / NAME):
        done = partial(done_in, manifest, job)
        graph, pairs = solve_graph(done, job.size, job.plan["free"])
        result = fragments_result(graph, pairs, job.size, job.plan["free"])
        points = sum(task.result["points"] for task in done(0))
        return PlacedScans(**vars(result), scans=job.plan["scans"], points=points, tried=_tried(job, result, done))


def _tried(job: RegistrationJob, result: FragmentsResult, done: Callable[[int], Iterator[Done]]) -> list[TriedPair]:
    members = np.flatnonzero(result.placed).tolist()
    graph_edges = {(members[edge.source_node_id], members[edge.target_node_id]) for edge in result.pose_graph.edges}
    tried = []
    for stage in (1, 2, 4):
        for task in done(stage):
            source, target, pair = task.inputs["source"], task.inputs["target"], task.result["pair"]
            score = task.result["score"]
            if pair is None:
                status = task.result["doubt"]
            elif not result.placed[source]:
                status = "apart"
            else:
                status = "kept" if (source, target) in graph_edges else "dropped"
            by = "known" if task.inputs["is_known"] else STAGE_WORDS[stage]
            by = "place" if by == "order" and job.plan["places"] is not None else by
            tried.append(TriedPair(source, target, by, np.nan if score is None else score, status))
    return tried
