"""The public names of pointloom.sfm: the one list of them, for type checkers and for `public_names`."""

from .features import FeatureReport as FeatureReport
from .features import find_features as find_features
from .frame_choice import FrameChoice as FrameChoice
from .frames import choose_frames as choose_frames
from .mapping import SfmResult as SfmResult
from .mapping import map_pictures as map_pictures
from .matches import MatchReport as MatchReport
from .matches import match as match
from .model_quality import ModelQuality as ModelQuality
from .model_quality import assess_model as assess_model
from .picture_places import PicturePlace as PicturePlace
from .picture_places import PicturePlaces as PicturePlaces
from .picture_places import read_picture_places as read_picture_places
from .reconstruction import reconstruct as reconstruct
from .training_folder import TrainingFolder as TrainingFolder
from .training_folder import write_training_folder as write_training_folder
from .triangulation import TriangulationResult as TriangulationResult
from .triangulation import triangulate as triangulate
