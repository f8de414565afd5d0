"""The public names of pointloom.rgbd: the one list of them, for type checkers and for `public_names`."""

from ..registration.deformable.slac import run_rigid_optimizer_for_fragments as run_rigid_optimizer_for_fragments
from .fusion.fuse import fuse as fuse
from .odometry.alignment import align_frames as align_frames
from .odometry.frames import OdometryFrame as OdometryFrame
from .odometry.rgbd_odometry import compute_odometry_information_matrix as compute_odometry_information_matrix
from .odometry.rgbd_odometry import compute_rgbd_odometry as compute_rgbd_odometry
from .reconstruction.config import ReconstructionConfig as ReconstructionConfig
from .reconstruction.fragment_model import FragmentOptions as FragmentOptions
from .reconstruction.frames_to_mesh import reconstruct as reconstruct
from .reconstruction.job import run_reconstruction_system as run_reconstruction_system
from .reconstruction.volumes import SLACOptimizerParams as SLACOptimizerParams
from .reconstruction.volumes import run_slac_optimizer_for_fragments as run_slac_optimizer_for_fragments
from .slam.dense_slam import DenseSLAM as DenseSLAM
from .slam.focal_check import check_focal as check_focal
from .slam.loops import close_loops as close_loops
from .slam.loops import corrected_trajectory as corrected_trajectory
from .slam.loops import fuse_submaps as fuse_submaps
from .slam.model import SlamModel as SlamModel
from .slam.submaps import SubmapRecorder as SubmapRecorder
from .slam.tracking import track as track

# Results of functions, for annotations.
# isort: split
from .fusion.results import FusionResult as FusionResult
from .odometry.results import OdometryResult as OdometryResult
from .reconstruction.frames_to_mesh import ReconstructionResult as ReconstructionResult
from .reconstruction.report import SystemReport as SystemReport
from .reconstruction.volumes import ControlGrid as ControlGrid
from .slam.camera_check import FocalCheck as FocalCheck
from .slam.loop_closure import LoopClosure as LoopClosure
from .slam.map_joins import MapJoin as MapJoin
from .slam.results import TrackingResult as TrackingResult
from .slam.submaps import Submap as Submap
from .slam.tracked_path import TrackedPath as TrackedPath
