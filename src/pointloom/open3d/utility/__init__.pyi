"""The names of `open3d.utility`."""

from ...core.verbosity import VerbosityContextManager as VerbosityContextManager
from ...core.verbosity import VerbosityLevel as VerbosityLevel
from ...core.verbosity import get_verbosity_level as get_verbosity_level
from ...core.verbosity import set_verbosity_level as set_verbosity_level
from ..vectors import DoubleVector as DoubleVector
from ..vectors import IntVector as IntVector
from ..vectors import Matrix3dVector as Matrix3dVector
from ..vectors import Matrix4dVector as Matrix4dVector
from ..vectors import Vector2dVector as Vector2dVector
from ..vectors import Vector2iVector as Vector2iVector
from ..vectors import Vector3dVector as Vector3dVector
from ..vectors import Vector3iVector as Vector3iVector
from ..vectors import Vector4iVector as Vector4iVector
from . import random as random
from .threads import get_max_threads as get_max_threads
from .threads import set_max_threads as set_max_threads
from .verbosity import Debug as Debug
from .verbosity import Error as Error
from .verbosity import Info as Info
from .verbosity import Warning as Warning
from .verbosity import reset_print_function as reset_print_function
