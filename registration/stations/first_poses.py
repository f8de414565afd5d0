"""First poses of stations: a tree of the pairs that others bear out, then all of it onto what the survey knows."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul, norm
from ..pose_graphs.connected_parts import connected_parts
from ..pose_graphs.spanning_tree import chain, spanning_tree
from ..rigid import about_up, fit_pose, invert_pose, make_pose, rotation_vector
from .observations import Array, ControlPoint, StationPair, TargetObservation

BY_TARGETS = 0.25  # the support of a link by targets alone: below that of an accepted pair of clouds


class Link(NamedTuple):
    """A pose between two stations, and its support."""

    source: int
    target: int
    transformation: Array
    support: float


def links_of(
    pairs: Sequence[StationPair], targets: Sequence[TargetObservation], level: bool, tolerance: float
) -> list[Link]:
    """Links between stations: targets, and pairs, with more support the more loops of three stations they close."""
    known = {(p.source, p.target): p.transformation for p in pairs}
    known |= {(b, a): invert_pose(T) for (a, b), T in known.items()}
    links = []
    for pair in pairs:
        a, b = pair.source, pair.target
        support = pair.score
        for c in {c for a_, c in known if a_ == a and (c, b) in known}:
            T = matmul(invert_pose(pair.transformation), known[c, b], known[a, c])
            shift = float(norm(T[:3, 3]))
            support += pair.score * (shift < tolerance and float(norm(rotation_vector(T[:3, :3]))) < 0.1)
        links.append(Link(a, b, pair.transformation, support))
    return links + _links_by_targets(targets, level)


def _links_by_targets(targets: Sequence[TargetObservation], level: bool) -> list[Link]:
    seen: dict[int, dict[str, Array]] = {}
    for one in targets:
        seen.setdefault(one.station, {})[one.name] = np.asarray(one.position)
    stations, links = sorted(seen), []
    for k, b in enumerate(stations):
        for a in stations[k + 1 :]:
            names = [name for name in seen[a] if name in seen[b]]
            left, right = (np.array([seen[i][name] for name in names]).reshape(-1, 3) for i in (a, b))
            if is_enough(left, level):
                links.append(Link(a, b, fit(left, right, level), BY_TARGETS))
    return links


def is_enough(points: Array, level: bool) -> bool:
    """Whether points fix a pose: two apart in plan of level stations, else three that lie on no line."""
    if len(points) < (2 if level else 3):
        return False
    centred = points - points.mean(axis=0)
    spread = np.linalg.svd(centred[:, :2] if level else centred, compute_uv=False)
    return bool(spread[0] > 1e-3 if level else spread[1] > 1e-2 * spread[0] > 0)


def fit(source: Array, target: Array, level: bool) -> Array:
    """The pose that takes points nearest to others; level ones turn about z alone."""
    if not level:
        return fit_pose(source, target)
    a, b = source - source.mean(axis=0), target - target.mean(axis=0)
    yaw = math.atan2((a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum(), (a[:, :2] * b[:, :2]).sum())
    R = about_up(float(yaw))
    return make_pose(R, target.mean(axis=0) - matmul(R, source.mean(axis=0)))


def parts_by(links: Sequence[Link], count: int) -> NDArray[np.int32]:
    """The part that each station belongs to."""
    ends = np.array([[link.source, link.target] for link in links], np.int64).reshape(-1, 2)
    return connected_parts(ends[:, 0], ends[:, 1], count)


def chain_links(links: Sequence[Link], first: Array) -> Array:
    """Poses along the tree of most support, from the first station of each part, which stays where it is."""
    tree, groups = spanning_tree(links, [link.support for link in links], len(first))
    return chain(first, np.unique(groups).tolist(), links, tree)


def onto_control(
    poses: Array,
    parts: NDArray[np.int32],
    targets: Sequence[TargetObservation],
    control: Sequence[ControlPoint],
    positions: Array | None,
    level: bool,
) -> tuple[Array, NDArray[np.bool_]]:
    """The poses with each part moved onto the control and the positions that fix it, and which parts these are."""
    places = {point.name: np.asarray(point.position) for point in control}
    moved, fixed = poses.copy(), np.zeros(int(parts.max(initial=-1)) + 1, bool)
    for part in range(len(fixed)):
        seen = [one for one in targets if parts[one.station] == part and one.name in places]
        here = [
            matmul(poses[one.station][:3, :3], np.asarray(one.position)) + poses[one.station][:3, 3] for one in seen
        ]
        there = [places[one.name] for one in seen]
        members = np.flatnonzero(parts == part)
        if positions is not None:
            known = [i for i in members if np.isfinite(positions[i]).all()]
            here += [poses[i][:3, 3] for i in known]
            there += [positions[i] for i in known]
        if is_enough(np.array(there).reshape(-1, 3), level):
            fixed[part] = True
            moved[members] = matmul(fit(np.array(here), np.array(there), level), poses[members])
    return moved, fixed
