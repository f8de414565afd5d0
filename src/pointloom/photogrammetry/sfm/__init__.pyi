"""The public names of pointloom.sfm: the one list of them, for type checkers and for `public_names`."""

from .features import find_features as find_features
from .frames import choose_frames as choose_frames
from .image_positions import read_picture_places as read_picture_places
from .mapping import map_pictures as map_pictures
from .matches import match as match
from .model_quality import assess_model as assess_model
from .reconstruction import reconstruct as reconstruct
from .training_folder import write_training_folder as write_training_folder
from .triangulation import triangulate as triangulate
