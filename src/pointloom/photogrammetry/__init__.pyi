"""The public names of pointloom.photogrammetry: the one list of them, for type checkers and for `public_names`."""

from .depth.estimation import estimate_depth as estimate_depth
from .depth.evaluation import evaluate_depth as evaluate_depth
from .depth.network import DepthModel as DepthModel
from .mvs.agreement import DepthAgreement as DepthAgreement
from .mvs.depth_bundles import read_depth_bundle as read_depth_bundle
from .mvs.depth_maps import DepthMaps as DepthMaps
from .mvs.estimation import estimate_depth_maps as estimate_depth_maps
from .mvs.filtering import filter_depth_maps as filter_depth_maps
from .mvs.fusion import fuse_depth_maps as fuse_depth_maps
from .mvs.posed_images import PosedCamera as PosedCamera
from .mvs.sources import choose_sources as choose_sources
from .sfm.features import find_features as find_features
from .sfm.frames import VideoSampling as VideoSampling
from .sfm.frames import choose_frames as choose_frames
from .sfm.image_positions import read_image_positions as read_image_positions
from .sfm.mapping import map_images as map_images
from .sfm.matches import match_features as match_features
from .sfm.model_quality import assess_model as assess_model
from .sfm.reconstruction import reconstruct_images as reconstruct_images
from .sfm.settings import SfmSettings as SfmSettings
from .sfm.training_folder import write_training_folder as write_training_folder
from .sfm.triangulation import triangulate as triangulate
from .video.ground_control import ControlMark as ControlMark
from .video.ground_control import GroundControl as GroundControl
from .video.ground_control import ScaleBar as ScaleBar
from .video.job import reconstruct_video as reconstruct_video
from .video.outputs import VideoOutputs as VideoOutputs
from .video.settings import VideoSettings as VideoSettings
from .video.units import VideoUnits as VideoUnits

# Results of functions, for annotations.
# isort: split
from .depth.estimation import DepthEstimate as DepthEstimate
from .depth.evaluation import DepthErrors as DepthErrors
from .mvs.depth_bundles import DepthBundle as DepthBundle
from .mvs.depth_maps import DepthMap as DepthMap
from .sfm.features import FeatureReport as FeatureReport
from .sfm.frame_choice import FrameChoice as FrameChoice
from .sfm.image_positions import ImagePositions as ImagePositions
from .sfm.mapping import SfmResult as SfmResult
from .sfm.matches import MatchReport as MatchReport
from .sfm.model_quality import ModelQuality as ModelQuality
from .sfm.training_folder import TrainingFolder as TrainingFolder
from .sfm.triangulation import TriangulationResult as TriangulationResult
from .video.result import VideoResult as VideoResult
