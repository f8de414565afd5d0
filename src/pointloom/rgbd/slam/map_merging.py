"""Registration and merging of maps."""

from __future__ import annotations

import dataclasses
import itertools

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import inv, matmul
from ...meshing.volume.volume_fusion import fuse_volumes
from ...registration.rigid import adjoint_of, invert_pose, make_pose
from .frames import SensorFrame
from .loop_pairs import Candidate, Loop, SubmapSurface, refine, verify_far
from .map_joins import MIN_VOXEL, VOXEL_RATIO, MapJoin, Proposal, apart, judge_join
from .maps import Maps, SlamMap, map_sizes
from .results import TrackingResult, with_pose
from .submaps import Submap
from .tracker import MAX_SHAPE_DIFFERENCE, clean_pose, join_covariance

Pose = NDArray[np.float64]

MAX_VERIFIED_POSES = 3  # verified poses, by descending score


def find_join(target: SlamMap, source: SlamMap, results: list[TrackingResult], seed: int) -> MapJoin | None:
    """Relative pose of two maps by registration: verified, or the best rejected one. None if there is none."""
    pieces = [_pieces(known, results) for known in (target, source)]
    if not all(pieces):
        return None
    size = max(VOXEL_RATIO * target.model.volume.voxel_size, MIN_VOXEL)
    surfaces = [SubmapSurface(piece, size) for part in pieces for piece in part]
    count = len(pieces[0])
    pairs = [
        Candidate(s, t, np.eye(4), np.inf)
        for t in range(count)
        for s in range(count, len(surfaces))
        if len(surfaces[t].box) and len(surfaces[s].box)
    ]
    loops = [loop for loop in verify_far(surfaces, pairs, seed) if not loop.refused]
    submap_poses = [piece.T_world_submap for part in pieces for piece in part]
    judged: list[MapJoin] = []
    for T in _distinct(refine(surfaces, loops), submap_poses)[:MAX_VERIFIED_POSES]:
        judged.append(judge_join(target, source, T))
        if not judged[-1].refused:
            return judged[-1]
    return judged[0] if judged else None


def _pieces(known: SlamMap, results: list[TrackingResult]) -> list[Submap]:
    if known.recorder is not None:
        return known.recorder.finish()
    fused = [result for result in results if result.map == known.number and result.fused]
    if not fused:
        return []
    frames, poses = [result.index for result in fused], [result.pose for result in fused]
    return [Submap(known.model.surface_volume, np.eye(4), np.array(frames), np.array(poses), follows=False)]


def _distinct(loops: list[Loop], submap_poses: list[Pose]) -> list[Pose]:
    """Distinct relative poses of the maps, those with most agreeing loops first."""
    poses = [clean_pose(matmul(submap_poses[p.target], p.T_target_source, inv(submap_poses[p.source]))) for p in loops]
    near = [[apart(matmul(inv(a), b)) < MAX_SHAPE_DIFFERENCE for b in poses] for a in poses]
    order = sorted(range(len(poses)), key=lambda k: (-sum(near[k]), -loops[k].score, k))
    selected: list[int] = []
    for k in order:
        if not any(near[k][other] for other in selected):
            selected.append(k)
    return [poses[k] for k in selected]


def merge_maps(target: SlamMap, source: SlamMap, T_target_source: Pose, results: list[TrackingResult]) -> None:
    T = T_target_source
    deviation = target.model.volume.voxel_size
    join = join_covariance(T, deviation)
    for i, result in enumerate(results):
        if result.map == source.number:
            if result.pose is not None:
                pose = clean_pose(matmul(T, result.pose))
                about = adjoint_of(make_pose(np.eye(3), -pose[:3, 3]))
                result = with_pose(result, pose, matmul(about, join, about.T))
            results[i] = dataclasses.replace(result, map=target.number)
    target.keyframes.extend(source.keyframes, T)
    target.tracker.drift.take_over(source.tracker.drift, T, deviation)
    if target.recorder is not None and source.recorder is not None:
        moved = [
            dataclasses.replace(submap, T_world_submap=matmul(T, submap.T_world_submap), follows=True)
            for submap in source.recorder.finish()
        ]
        target.recorder.take_over(moved)
    model, other, poses = target.model, source.model, np.array([np.eye(4), T])
    complete = model.surface_volume is model.volume and other.surface_volume is other.volume
    surface = None if complete else fuse_volumes([model.surface_volume, other.surface_volume], poses)
    model._replace_volume(fuse_volumes([model.volume, other.volume], poses), surface)


def hand_over(target: SlamMap, source: SlamMap, T_target_source: Pose) -> None:
    T, motion = T_target_source, source.tracker.motion
    assert motion.pose is not None
    motion.pose = clean_pose(matmul(T, motion.pose))
    target.tracker.motion = motion
    target.model.current_frame_pose = clean_pose(matmul(T, source.model.current_frame_pose))


class Joining:
    """Finds relative poses of the maps of a run, and joins them; `judged` lists all attempts."""

    def __init__(self, maps: Maps, results: list[TrackingResult], seed: int):
        self._maps, self._results, self._seed = maps, results, seed
        self.judged: list[MapJoin] = []
        self._proposal: Proposal | None = None
        self._tried: set[tuple[int, int, int, int]] = set()  # two maps and their numbers of frames

    def look(self, frame: SensorFrame, pose: Pose, is_new_view: bool) -> None:
        """Test whether recent fused frames locate another map relative to the current one."""
        proposal = self._proposal
        if proposal is None or proposal.here is not self._maps.here or proposal.other not in self._maps.searchable:
            self._proposal = self._propose(frame, pose, is_new_view)
            return
        if proposal.check(frame, pose):
            self._proposal = None
            low, high = sorted((proposal.other, proposal.here), key=_number)
            T = proposal.T_other_here
            join = judge_join(low, high, T if low is proposal.other else invert_pose(T))
            self.judged.append(join)
            if not join.refused:
                self._join(join)
        elif proposal.is_refuted:
            self._proposal = None

    def _propose(self, frame: SensorFrame, pose: Pose, is_new_view: bool) -> Proposal | None:
        for other in self._maps.others:
            if is_new_view or other.tracker.awaits_confirmation:
                attempt, _ = other.tracker.locate(frame)
                if attempt.status == "tracked":
                    return Proposal(other, self._maps.here, clean_pose(matmul(attempt.pose, invert_pose(pose))), pose)
        return None

    def search(self) -> list[MapJoin]:
        """Register all maps, and join accepted ones. Returns the attempts."""
        first = len(self.judged)
        while (join := self._next()) is not None:
            self._join(join)
        return self.judged[first:]

    def _next(self) -> MapJoin | None:
        sizes = map_sizes(self._results)
        maps = sorted(self._maps.searchable, key=lambda known: (-sizes.get(known.number, 0), known.number))
        for pair in itertools.combinations(maps, 2):
            low, high = sorted(pair, key=_number)
            state = (low.number, high.number, low.model.frame_count, high.model.frame_count)
            if state in self._tried or not (low.model.frame_count and high.model.frame_count):
                continue
            self._tried.add(state)
            join = find_join(low, high, self._results, self._seed)
            if join is not None:
                self.judged.append(join)
                if not join.refused:
                    return join
        return None

    def _join(self, join: MapJoin) -> None:
        by_number = {known.number: known for known in self._maps.searchable}
        target, source = by_number[join.target], by_number[join.source]
        merge_maps(target, source, join.T_target_source, self._results)
        if source is self._maps.here:
            hand_over(target, source, join.T_target_source)
        self._maps.drop(source, instead=target)
        self._proposal = None


def _number(known: SlamMap) -> int:
    return known.number
