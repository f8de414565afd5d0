"""File layout of a job: Open3D's names below the job's folder, and a record for each stage."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from ...core.errors import FileError, FilePath
from ...core.json_files import read_json_object
from ...core.paths import job_file, path_of, refuse_links
from ...core.records import record_file
from ...core.work_folder import RunFolder
from .config import ReconstructionConfig

CONFIG_FILE = "config.json"


@dataclass(frozen=True)
class JobFiles:
    root: Path
    config: ReconstructionConfig

    @classmethod
    def make(cls, folder: FilePath, config: ReconstructionConfig) -> JobFiles:
        if not isinstance(config, ReconstructionConfig):
            raise TypeError(f"config: expected a ReconstructionConfig, got {type(config).__name__}")
        job = cls(path_of(folder, "folder"), config)
        fragment = job.fragment_cloud(0), job.fragment_graph(0), job.fragment_graph_optimized(0)
        scene = job.scene_graph, job.refined_graph, job.refined_graph_optimized, job.scene_mesh, job.trajectory
        for path in (*fragment, *scene, job.record("fragment", 0)):
            refuse_links(job_file(path, job.root).parent)
            if not os.access(path.parent, os.W_OK | os.X_OK):
                raise FileError(path.parent, "is not writable", remedy="Choose another folder")
        return job

    def fragment_graph(self, number: int) -> Path:
        return self.root / (self.config.template_fragment_posegraph % number)

    def fragment_graph_optimized(self, number: int) -> Path:
        return self.root / (self.config.template_fragment_posegraph_optimized % number)

    def fragment_cloud(self, number: int) -> Path:
        return self.root / (self.config.template_fragment_pointcloud % number)

    @property
    def scene_graph(self) -> Path:
        return self.root / self.config.template_global_posegraph_optimized

    @property
    def refined_graph(self) -> Path:
        """Pose graph of the refined edges before optimization."""
        return self.root / self.config.template_refined_posegraph

    @property
    def refined_graph_optimized(self) -> Path:
        return self.root / self.config.template_refined_posegraph_optimized

    @property
    def slac_graph(self) -> Path:
        return self.root / self.config.folder_slac / self.config.template_optimized_posegraph_slac

    @property
    def slac_cloud(self) -> Path:
        return self.slac_graph.with_name("output_slac_pointcloud.ply")

    @property
    def scene_mesh(self) -> Path:
        return self.root / self.config.template_global_mesh

    @property
    def trajectory(self) -> Path:
        """The poses as a Trajectory."""
        return self.root / self.config.template_global_traj

    def record(self, stage: str, number: int | None = None) -> Path:
        return record_file(self.root, stage, number)


def run_folder(folder: FilePath) -> RunFolder:
    """The folder of the reconstruction system, with its complete configuration."""
    return RunFolder(folder, CONFIG_FILE, _is_config)


def _is_config(path: Path) -> bool:
    return read_json_object(path).keys() == ReconstructionConfig.read(path).to_names().keys()
