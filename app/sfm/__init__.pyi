"""The public names of pointloom.sfm: the one list of them, for type checkers and for `public_names`."""

from .frames import FrameChoice as FrameChoice
from .frames import choose_frames as choose_frames
