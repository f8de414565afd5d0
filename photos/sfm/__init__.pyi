"""The public names of pointloom.sfm: the one list of them, for type checkers and for `public_names`."""

from .frames import choose_frames as choose_frames
from .picture_places import read_picture_places as read_picture_places
from .reconstruction import reconstruct as reconstruct
from .training_folder import write_training_folder as write_training_folder
from .triangulation import triangulate as triangulate
