"""The pose under which most of a source cloud lies on a target, from correspondences of which few are right.

Rounds of hypotheses (pose_hypotheses.py); of each round those that most correspondences agree with are fitted again to
these (pair_fits.py), and scored by the whole cloud (pose_fitness.py). A round is some 20 launches and five
looks of the host at a few numbers, however many hypotheses it has.
"""

import math

import numpy as np

from ..lang import array, int32, kernel, launch, mat44d, tid
from ..memory import download, empty, upload
from ..segmentation.plane_fit import samples_needed
from .pair_fits import PairCoordinates
from .pose_hypotheses import REFUSED, Samples, score_poses

FIRST_ROUND, LEAST_ROUND, MOST_ROUND = 4096, 1024, 16384  # hypotheses between two looks at the best
SCORED = 4096  # correspondences that rank the hypotheses of a round; with 1 % right 40 of them agree with a right one
RANKED = 2048  # hypotheses of a round among which those are chosen that are fitted again
KEPT = 16  # of these, each unlike the others; they are then scored by the whole cloud
APART = 2.0  # distances of a match by which some point of the source's box lies elsewhere under an unlike pose
CONTENDER = 0.25  # of the correspondences that agree with the best must agree with a pose that the whole cloud scores
FITS = 4  # to the correspondences of each of these
LAST_FITS = 8  # of the winner to the clouds themselves, while that helps


@kernel
def gather_poses_kernel(poses: array(dtype=mat44d), rows: array(dtype=int32), out: array(dtype=mat44d)):
    """The poses at some rows."""
    i = tid()
    out[i] = poses[rows[i]]


class FoundPose:
    """The best pose of a search.

    Attributes:
        pose: float64 [4, 4] about the middles of the clouds, None where no hypothesis passed.
        count, squares: Source points that have a match, and the sum of their squared distances [m^2].
        inliers: Correspondences that agree.
        drawn: Hypotheses drawn.
        confident: Whether the search ended because a better pose was unlikely.
    """

    def __init__(self):
        self.pose, self.count, self.squares, self.inliers, self.drawn, self.confident = None, -1, None, 0, 0, False


class PoseSearch:
    """The search for the pose under which most source points have a target point near them."""

    def __init__(self, fitness, source, target, pairs):
        """Prepare a search.

        Args:
            fitness: A PoseFitness of the two clouds.
            source, target: Device arrays of vec3.
            pairs: Correspondences, int32 device array [m, 2].
        """
        self.fitness, self.device = fitness, source.device
        self.pairs = PairCoordinates(source, target, pairs, *fitness.middles)
        self.ranking = self.pairs
        if self.pairs.count > SCORED:
            rows = np.arange(SCORED, dtype=np.int64) * self.pairs.count // SCORED
            self.ranking = self.pairs.select(upload(rows, int32, self.device))

    def find(self, distance, sample_size, checks, normals, most, confidence, with_scaling, seed):
        """The best of `most` hypotheses at most; of equal counts the one with the smaller distances.

        Args:
            distance: Of a match [m], excluded.
            sample_size: Correspondences a hypothesis.
            checks: A Checks.
            normals: Source and target normals, device arrays of vec3; empty where they are not checked.
            confidence: Wanted of having drawn a sample of right correspondences alone: ends the search early.

        Returns:
            A FoundPose.
        """
        found = FoundPose()
        needed, size = float(most), FIRST_ROUND
        while found.drawn < min(most, needed):
            size = min(size, most - found.drawn, max(math.ceil(needed) - found.drawn, LEAST_ROUND))
            self._round(found, size, distance, sample_size, checks, normals, with_scaling, seed)
            found.drawn += size
            if confidence < 1.0:
                needed = samples_needed(found.inliers / self.pairs.count, sample_size, confidence, most)
            size = min(2 * size, MOST_ROUND)
        found.confident = found.pose is not None and confidence < 1.0 and needed <= found.drawn
        if found.pose is not None:
            pose = upload(found.pose[None], mat44d, self.device)
            found.pose, found.count, found.squares = self.fitness.refine(pose, distance, LAST_FITS, with_scaling)
        return found

    def _round(self, found, size, distance, sample_size, checks, normals, with_scaling, seed):
        samples = Samples(self.pairs, sample_size, size, checks, seed, found.drawn)
        if samples.similar.size == 0:
            return
        poses, scores = samples.fit(checks, normals, with_scaling)
        score_poses(self.ranking, poses, distance, scores)
        ranked = download(scores)  # sync
        order = np.argsort(-ranked, kind="stable")[:RANKED]
        order = order[ranked[order] > REFUSED]
        if order.size == 0:
            return
        chosen = self._gather(poses, order)
        apart = poses_apart(download(chosen), self.fitness.size, APART * distance)  # sync
        best, inliers = self.pairs.refine(self._gather(chosen, apart), distance, FITS, with_scaling)
        self._contest(found, download(best).copy(), download(inliers)[:, 0].astype(int), distance)  # sync

    def _gather(self, poses, rows):
        chosen = empty(rows.size, mat44d, self.device)
        launch(gather_poses_kernel, rows.size, [poses, upload(rows, int32, self.device), chosen])
        return chosen

    def _contest(self, found, poses, inliers, distance):
        """Take the best of some poses where it beats the best so far."""
        _, rows = np.unique(poses.reshape(len(poses), -1), axis=0, return_index=True)
        rows = np.sort(rows)  # many fits end at the same correspondences; in order of their rank
        rows = rows[inliers[rows] >= CONTENDER * max(int(inliers.max()), found.inliers)]
        if rows.size == 0:
            return
        poses, inliers = poses[rows], inliers[rows]
        counts = self.fitness.count(upload(poses, mat44d, self.device), distance)
        top = int(counts.max())
        if top < found.count:
            return
        for row in np.flatnonzero(counts == top):
            squares = None
            if top == found.count:
                if found.squares is None:
                    found.squares = self._squares(found.pose, distance)
                squares = self._squares(poses[row], distance)
                if squares >= found.squares:
                    continue
            found.pose, found.count, found.squares, found.inliers = poses[row], top, squares, int(inliers[row])

    def _squares(self, pose, distance):
        sums = self.fitness.match(upload(pose[None], mat44d, self.device), distance)
        return float(download(sums)[0][-1])  # sync: only where poses have as many matches as another


def poses_apart(poses, size, distance):
    """The rows of the first KEPT poses [k, 4, 4] of which each moves some point farther than `distance` [m] from where
    those before it do: else all would be that of the largest group of correspondences, right or wrong.

    Args:
        poses: About the middle of the source, the most promising first.
        size: Half of the source's diagonal [m]; points that far from the middle along the axes are compared.
    """
    probes = np.concatenate([poses[:, :3, 3:], poses[:, :3, :3] * size + poses[:, :3, 3:]], axis=2)
    left, kept = np.ones(len(poses), bool), []
    while left.any() and len(kept) < KEPT:
        first = int(np.argmax(left))
        kept.append(first)
        left &= ((probes - probes[first]) ** 2).sum(axis=1).max(axis=1) > distance * distance
        left[first] = False
    return np.array(kept, np.int32)
