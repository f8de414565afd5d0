"""The public names of pointloom.color_map: the one list of them, for type checkers and for `public_names`."""

from .optimizers import run_non_rigid_optimizer as run_non_rigid_optimizer
from .optimizers import run_rigid_optimizer as run_rigid_optimizer
from .options import NonRigidOptimizerOption as NonRigidOptimizerOption
from .options import RigidOptimizerOption as RigidOptimizerOption
from .picture_texturing import texture_from_pictures as texture_from_pictures
from .texturing import texture_mesh as texture_mesh
