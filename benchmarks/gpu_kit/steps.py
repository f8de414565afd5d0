"""The steps on a GPU, in order: facts, checks, all tests, times, profiles."""

from __future__ import annotations

import shutil
import sys
from dataclasses import dataclass
from pathlib import Path

# Kernels of these calls are analyzed one by one with ncu, and run on small data under compute-sanitizer
NCU_CALLS = ("normals_k30=1000000", "dbscan=1000000", "knn20=1000000", "fpfh=300000", "tsdf_integrate=307200")
NCU_CALLS += ("closest_points=200000", "cast_rays=1000000", "icp_plane=200000")
SANITIZED = ("normals_k30=3000", "dbscan=3000", "icp_plane=3000", "fpfh=3000", "voxel_down_sample=3000")
SANITIZED += ("farthest_points=3000", "tsdf_mesh=307200")
NCU_SECTIONS = ("SpeedOfLight", "Occupancy", "LaunchStats", "MemoryWorkloadAnalysis", "WarpStateStats")


@dataclass(frozen=True)
class Step:
    """A step in a separate process.

    Attributes:
        name: Name in logs and marks.
        module: Module of this package; it gets the folder of the run, its seconds and `arguments`.
        at_least: Minimum seconds to start.
        at_most: Seconds after which it is terminated, so that later steps can run.
        needs: Required archives (only if they arrive one by one: call.sh).
        program: Required program; the step is skipped without it.
        in_dry_run: True if a dry run includes the step.
        part: Part of the run's document that it writes; it is replaced if the step is repeated.
    """

    name: str
    module: str
    at_least: float
    at_most: float
    needs: tuple[str, ...] = ("warp", "kernels")
    program: str = ""
    in_dry_run: bool = True
    arguments: tuple[str, ...] = ()
    part: str = ""

    def command(self, state: Path, seconds: float) -> list[str]:
        """The command of the step."""
        return [sys.executable, "-m", f"gpu_kit.{self.module}", str(state), f"{seconds:.0f}", *self.arguments]

    @property
    def is_possible(self) -> bool:
        return not self.program or shutil.which(self.program) is not None


STEPS = (
    Step("facts", "facts", 5, 60, ()),
    Step("torch", "torch_constants", 15, 60, (), in_dry_run=False),
    Step("questions", "questions", 40, 300, part="questions"),
    Step("constants", "constants", 30, 120, part="constants"),
    Step("digests", "digests", 60, 240, in_dry_run=False, part="digests"),
    Step("tests", "suite", 60, 1200, part="tests"),
    Step("benchmarks", "benches", 60, 900, ("warp", "kernels", "open3d"), part="benchmarks"),
    Step("times", "profile", 30, 250, arguments=("call",), part="operations"),
    Step("profile", "profile", 30, 250, arguments=("device",)),
    Step("registers", "register_trials", 60, 300, part="registers"),
    Step("ncu", "under_tools", 45, 180, program="ncu", in_dry_run=False, arguments=("ncu",)),
    Step("sanitizer", "under_tools", 60, 300, program="compute-sanitizer", in_dry_run=False, arguments=("sanitizer",)),
)
