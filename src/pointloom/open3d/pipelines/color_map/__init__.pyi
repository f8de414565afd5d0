"""The names of `open3d.pipelines.color_map`."""

from .optimizers import NonRigidOptimizerOption as NonRigidOptimizerOption
from .optimizers import RigidOptimizerOption as RigidOptimizerOption
from .optimizers import run_non_rigid_optimizer as run_non_rigid_optimizer
from .optimizers import run_rigid_optimizer as run_rigid_optimizer
