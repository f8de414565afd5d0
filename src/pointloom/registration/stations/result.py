"""Result of a station adjustment, for surveyors and programs: `StationsResult`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.reports import Assessed, Fields, Report, quality
from ...core.units import LengthUnit
from ...core.wording import plain
from ...kernels.linear_algebra import norm
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud, list_clouds
from ..pose_errors import PoseCovariance
from .adjustment import LEVEL_ROWS, Group
from .loops import Loop
from .observations import Array, ControlPoint, StationPair, TargetObservation
from .snooping import Outlier

MM_PER_METER = 1000.0
MAX_LISTED = 6  # names per line


@dataclass(frozen=True, eq=False)
class StationsResult(Report, Assessed):
    """Station poses with their uncertainty, and rejected observations.

    Attributes:
        names: Station names.
        poses: T_survey_station, float64 [n, 4, 4]. As given if not placed.
        placed: Mask of the placed stations, bool [n].
        undetermined: Mask of the placed stations with a motion that neither surfaces nor other observations determine,
            bool [n]. Its standard deviation is the size of the overlap.
        pose_covariances: Covariance of the error of each pose along the survey's axes, about the station, relative to
            the reference if that defines the frame. Zero for fixed motions, infinite if not placed.
        pairs: The used pairs.
        rejected: The rejected pairs, each with its warnings.
        targets: Target positions [m], by name.
        target_sigmas: Their standard deviations [m], [3] each.
        groups: All observations, with residuals and tests.
        outliers: The removed observations.
        loops: Loop closure errors of the pairs.
        sigma0: Root of the sum of squares over the redundancy. 1 if the given standard deviations are right.
        limits: 99% interval of sigma0.
        redundancy: Number of redundant observations.
        scaled: True if standard deviations were multiplied by sigma0 > 1.
        pair_factor: Additional factor of the pairs' standard deviations.
        reference: The station that defines the frame. None with control or positions.
        level: True for four degrees of freedom.
        converged: True if the adjustment converged.
        unit: Unit of the clouds, or None.
    """

    names: tuple[str, ...]
    poses: Array
    placed: NDArray[np.bool_]
    undetermined: NDArray[np.bool_]
    pose_covariances: tuple[PoseCovariance, ...]
    pairs: list[StationPair]
    rejected: list[StationPair]
    targets: dict[str, Array]
    target_sigmas: dict[str, Array]
    groups: list[Group]
    outliers: list[Outlier]
    loops: list[Loop]
    sigma0: float
    limits: tuple[float, float]
    redundancy: int
    scaled: bool
    pair_factor: float
    reference: int | None
    level: bool
    converged: bool
    unit: LengthUnit | None = None

    @property
    def sigmas(self) -> Array:
        """Standard deviations of position [m] and rotations about x, y, z [rad], by `pose_covariances`, [n, 6]. 0 if
        fixed, NaN if not placed.
        """
        sigmas = np.array([covariance.sigmas[[3, 4, 5, 0, 1, 2]] for covariance in self.pose_covariances])
        return np.where(self.placed[:, None], sigmas, np.nan)

    @property
    def covariances(self) -> Array:
        """The free part of `pose_covariances`: of yaw, x, y, z if level (d = 4), else of rotation and translation
        (d = 6), [n, d, d].
        """
        free = LEVEL_ROWS if self.level else list(range(6))
        return np.array([covariance.matrix[np.ix_(free, free)] for covariance in self.pose_covariances])

    @property
    def warnings(self) -> tuple[str, ...]:
        reasons = []
        lost = [name for name, is_placed in zip(self.names, self.placed, strict=True) if not is_placed]
        if lost:
            verb = "is" if len(lost) == 1 else "are"
            reasons.append(
                f"{_listed(lost)} {verb} not connected: no pair, target or control links it to the other stations"
            )
        loose = [name for name, is_open in zip(self.names, self.undetermined, strict=True) if is_open]
        if loose:
            reasons.append(
                f"the surfaces do not determine the pose of {_listed(loose)} (pose_covariances): "
                "add targets, or stations between"
            )
        if self.outliers:
            descriptions = [self._outlier_in_words(one) for one in self.outliers[:MAX_LISTED]]
            reasons.append(f"{len(self.outliers)} observations contradict the rest: {'; '.join(descriptions)}")
        if self.redundancy and self.sigma0 > self.limits[1]:
            reasons.append(
                f"sigma0 is {self.sigma0:.2f}, above {self.limits[1]:.2f}: observations are less accurate than given"
            )
        if not self.converged:
            reasons.append(
                "the adjustment did not converge: check that scans, targets, control and positions are in meters, and "
                "the rough poses"
            )
        if not self.redundancy and len(self.names) > 1:
            reasons.append("the observations cannot be checked: the redundancy is 0")
        return tuple(reasons)

    def merge(self, stations: Sequence[PointCloud]) -> PointCloud:
        """The clouds at their poses as one cloud."""
        clouds = list_clouds("stations", stations)
        for i, cloud in enumerate(clouds):
            check_cloud(f"stations[{i}]", cloud)
        if len(clouds) != len(self.placed):
            raise ValueError(f"stations: expected {len(self.placed)}, as many as were registered, got {len(clouds)}")
        if not self.placed.any():
            raise ValueError("stations: expected at least one placed station, got none")
        return PointCloud.concatenate([clouds[i].transform(self.poses[i]) for i in np.flatnonzero(self.placed)])

    def fields(self) -> Fields:
        is_adjusted = self.placed & np.isfinite(self.sigmas[:, 0])
        worst = float(self.sigmas[is_adjusted, :3].max(initial=0.0)) * MM_PER_METER
        target_count = sum(group.kind == "target" for group in self.groups)
        control_count = sum(group.kind == "control" for group in self.groups)
        frame = "control" if self.reference is None else f"station {self.names[self.reference]}"
        freedom = "4 degrees of freedom each, level" if self.level else "6 degrees of freedom each"
        return [
            ("stations", f"{int(self.placed.sum())} of {len(self.names)} placed; {freedom}; frame of {frame}"),
            ("observed", f"{len(self.pairs)} pairs, {target_count} targets, {control_count} control points"),
            ("sigma0", f"{self.sigma0:.2f} (99 %: {self.limits[0]:.2f} to {self.limits[1]:.2f}), "
                       f"redundancy {self.redundancy}"),
            ("positions", f"to {worst:.1f} mm (one standard deviation, the worst axis)"),
        ]  # fmt: skip

    def report(self) -> str:
        """The complete report: stations, pairs, targets, control, loops, and outliers ([m], [mm] and [arcsec])."""
        parts = [str(self), self._stations(), self._pairs(), self._points(), self._loops(), self._taken_out()]
        conclusion = "; ".join(self.warnings) or "all quality checks passed"
        return "\n\n".join([part for part in parts if part] + [conclusion]) + "\n"

    def to_dict(self) -> dict[str, Any]:
        names = self.names
        return plain(
            {
                "stations": [
                    {"name": names[i], "placed": bool(self.placed[i]), "pose": self.poses[i],
                     "sigma_position": self.sigmas[i, :3], "sigma_rotation": self.sigmas[i, 3:]}
                    for i in range(len(names))
                ],
                "pairs": [self._pair_as_json(g) for g in self.groups if g.kind == "pair"],
                "rejected": [
                    {"source": names[p.source], "target": names[p.target], "warnings": [*p.warnings]}
                    for p in self.rejected
                ],
                "targets": {
                    name: {"position": position, "sigma": self.target_sigmas[name]}
                    for name, position in self.targets.items()
                },
                "residuals": [
                    {"kind": g.kind, "name": self._name_of(g), "residual": g.residual, "statistic": g.statistic,
                     "redundancy": g.redundancy}
                    for g in self.groups if g.kind != "pair"
                ],
                "outliers": [
                    {"kind": one.group.kind, "name": self._name_of(one.group), "residual": one.group.residual,
                     "statistic": one.group.statistic, "critical": one.critical, "exchanged": one.exchanged or None}
                    for one in self.outliers
                ],
                "loops": [
                    {"stations": [names[i] for i in loop.stations], "rotation": loop.rotation,
                     "translation": loop.translation}
                    for loop in self.loops
                ],
                "sigma0": self.sigma0, "limits": self.limits, "redundancy": self.redundancy, "scaled": self.scaled,
                "pair_factor": self.pair_factor, "level": self.level, "converged": self.converged,
                "reference": None if self.reference is None else names[self.reference], **quality(self),
            }
        )  # fmt: skip

    def _pair_as_json(self, group: Group) -> dict[str, Any]:
        pair = group.observation
        return {
            "source": self.names[pair.source], "target": self.names[pair.target], "overlap": pair.fitness,
            "rms": pair.rms, "score": pair.score, "residual": group.residual, "statistic": group.statistic,
            "redundancy": group.redundancy,
        }  # fmt: skip

    def _name_of(self, group: Group) -> str:
        one = group.observation
        if isinstance(one, StationPair):
            return f"{self.names[one.source]} - {self.names[one.target]}"
        if isinstance(one, TargetObservation):
            return f"{one.name} from {self.names[one.station]}"
        return one.name if isinstance(one, ControlPoint) else self.names[one]

    def _outlier_in_words(self, one: Outlier) -> str:
        size = float(norm(one.group.residual[-3:])) * MM_PER_METER
        description = f"{one.group.kind} {self._name_of(one.group)}, {size:.0f} mm off"
        if one.exchanged:
            return f"{description} (its name and {one.exchanged} look exchanged)"
        rivals = ", ".join(self._name_of(rival) for rival in one.rivals[:3])
        return f"{description} (or {rivals})" if rivals else description

    def _stations(self) -> str:
        rows = [["station", "x [m]", "y [m]", "z [m]", "yaw [deg]", "sx [mm]", "sy [mm]", "sz [mm]", 'syaw ["]']]
        for name, T, sigma, is_placed in zip(self.names, self.poses, self.sigmas, self.placed, strict=True):
            yaw = np.degrees(np.arctan2(T[1, 0], T[0, 0]))
            pose = [f"{v:.4f}" for v in T[:3, 3]] + [f"{yaw:.5f}"]
            spread = [f"{v * MM_PER_METER:.2f}" for v in sigma[:3]] + [f"{np.degrees(sigma[5]) * 3600:.1f}"]
            rows.append([name, *(pose + spread if is_placed else ["not placed"] + [""] * 7)])
        return "STATIONS\n" + _table(rows)

    def _pairs(self) -> str:
        groups = [g for g in self.groups if g.kind == "pair"]
        rows = [["pair", "overlap", "rms [mm]", "off [mm]", 'turn ["]', "test", "redundancy"]]
        for g in groups:
            angle = float(norm(g.residual[:-3]))
            rows.append(
                [self._name_of(g), f"{g.observation.fitness:.0%}", f"{g.observation.rms * MM_PER_METER:.1f}",
                 f"{norm(g.residual[-3:]) * MM_PER_METER:.2f}", f"{np.degrees(angle) * 3600:.1f}",
                 _test(g), f"{g.redundancy:.2f}"]
            )  # fmt: skip
        table = "PAIRS\n" + _table(rows) if groups else ""
        others = [p for p in self.rejected if p.warnings != ("no overlap",)]
        lines = [f"  {self.names[p.source]} - {self.names[p.target]}: {'; '.join(p.warnings)}" for p in others]
        return "\n".join([table, *(["  not used:", *lines] if lines else [])]).strip("\n")

    def _points(self) -> str:
        groups = [g for g in self.groups if g.kind in ("target", "control", "position", "level")]
        rows = [["residual of", "", "dx [mm]", "dy [mm]", "dz [mm]", "test", "redundancy"]]
        for g in groups:
            if g.kind == "level":
                angles = [f'{np.degrees(v) * 3600:.1f}"' for v in g.residual]
                rows.append([g.kind, self._name_of(g), *angles, "", _test(g), f"{g.redundancy:.2f}"])
            else:
                off = [f"{v * MM_PER_METER:.2f}" for v in g.residual]
                rows.append([g.kind, self._name_of(g), *off, _test(g), f"{g.redundancy:.2f}"])
        return "TARGETS AND CONTROL\n" + _table(rows) if groups else ""

    def _loops(self) -> str:
        rows = [["loop", "closure [mm]", 'closure ["]']]
        for loop in self.loops:
            way = " - ".join(self.names[i] for i in (*loop.stations, loop.stations[0]))
            rows.append([way, f"{loop.translation * MM_PER_METER:.2f}", f"{np.degrees(loop.rotation) * 3600:.1f}"])
        return "LOOPS OF PAIRS\n" + _table(rows) if self.loops else ""

    def _taken_out(self) -> str:
        lines = [f"  {self._outlier_in_words(one)}: test {one.group.statistic:.1f}, limit {one.critical:.1f}"
                 for one in self.outliers]  # fmt: skip
        return "\n".join(["TAKEN OUT", *lines]) if lines else ""


def _test(group: Group) -> str:
    return "unchecked" if not group.freedom else f"{group.statistic:.1f}/{group.freedom}"


def _listed(names: Sequence[str]) -> str:
    return ", ".join(names[:MAX_LISTED]) + (f" and {len(names) - MAX_LISTED} more" if len(names) > MAX_LISTED else "")


def _table(rows: Sequence[Sequence[str]]) -> str:
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    words = [k == 0 or rows[0][k] == "" for k in range(len(widths))]
    lines = [
        "  " + "  ".join(c.ljust(w) if left else c.rjust(w) for c, w, left in zip(row, widths, words, strict=True))
        for row in rows
    ]
    return "\n".join(line.rstrip() for line in lines)
