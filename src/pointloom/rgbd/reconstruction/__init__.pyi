"""The public names of pointloom.reconstruction: the one list of them, for type checkers and for `public_names`."""

from ...registration.deformable.slac import run_rigid_optimizer_for_fragments as run_rigid_optimizer_for_fragments
from .config import ReconstructionConfig as ReconstructionConfig
from .fragment_model import FragmentOptions as FragmentOptions
from .fragments import make_fragments as make_fragments
from .job import run_system as run_system
from .nonrigid import refine_with_slac as refine_with_slac
from .placement import register_fragments as register_fragments
from .refinement import refine_registration as refine_registration
from .scene import integrate_scene as integrate_scene
from .volumes import ControlGrid as ControlGrid
from .volumes import SLACOptimizerParams as SLACOptimizerParams
from .volumes import run_slac_optimizer_for_fragments as run_slac_optimizer_for_fragments
