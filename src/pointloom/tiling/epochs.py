"""Other epochs that steps compare a survey with.

Their files are in the plan, numbered after the survey's, so buckets are made in the same pass.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from ..core.errors import FileError
from ..core.progress import ReportProgress
from ..io.points.point_cloud import cloud_of
from ..pcd.cloud import PointCloud
from .buckets import Window
from .plan_check import TilePlan
from .sources import check_compatible, describe_all, list_files, original_path, read_window
from .steps.step import Step


def describe_epochs(
    steps: list[Step], sources: list[dict[str, Any]], folder: Path, report: ReportProgress
) -> list[dict[str, Any]]:
    """Plan entries of compared epochs, unique and in step order. FileError if one does not match the survey."""
    epochs: list[dict[str, Any]] = []
    for step in steps:
        if not step.epoch or any(epoch["paths"] == step.epoch for epoch in epochs):
            continue
        described = describe_all(list_files(step.epoch), folder, report, len(epochs))
        check_compatible(described)
        _check_epoch(described, sources, step)
        epochs.append({"paths": step.epoch, "sources": described})
    return epochs


def _check_epoch(epoch: list[dict[str, Any]], sources: list[dict[str, Any]], step: Step) -> None:
    first, other = sources[0], epoch[0]
    for key, what in (("crs", "coordinate system"), ("unit", "unit")):
        if other[key] != first[key]:
            values = [source[key] or "unknown" for source in (other, first)]
            reason = f"expected the {what} {values[1]} as in {original_path(first)}, got {values[0]}"
            raise FileError(
                original_path(other),
                reason,
                remedy=f"Convert both epochs to the same {what} first, it is not converted automatically",
            )
    filled = [[source for source in side if source["points"]] for side in (epoch, sources)]
    if not filled[0]:
        raise FileError(original_path(other), f"contains no points, but {step.name} compares the survey with it")
    if not filled[1]:
        return  # reported elsewhere
    (low, high), (first_low, first_high) = (
        (np.min([source["low"] for source in side], axis=0), np.max([source["high"] for source in side], axis=0))
        for side in filled
    )
    if ((low - step.radius > first_high) | (high + step.radius < first_low)).any():
        there, here = (f"{low.tolist()}..{high.tolist()}" for low, high in ((low, high), (first_low, first_high)))
        reason = f"the epoch for {step.name} does not overlap the survey: {there}, the survey {here}"
        raise FileError(original_path(other), reason)


def read_epoch(plan: TilePlan, folder: Path, fulls: dict[int, int], step: Step, window: Window) -> PointCloud:
    """Points of a step's epoch in a window, in file order, about the plan's origin. FileError if damaged or changed."""
    number = [epoch["paths"] for epoch in plan.epochs].index(step.epoch)
    table = read_window(plan, folder, fulls, window, epoch=number)
    table.attributes, table.normals, table.colors = {}, None, None
    return cloud_of(table, plan.epochs[number]["sources"][0]["path"], device="cpu", origin=plan.origin)
