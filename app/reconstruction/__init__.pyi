"""The public names of pointloom.reconstruction: the one list of them, for type checkers and for `public_names`."""

from .config import ReconstructionConfig as ReconstructionConfig
from .fragments import Fragment as Fragment
from .fragments import FragmentSet as FragmentSet
from .fragments import make_fragments as make_fragments
from .frames import LostFrame as LostFrame
