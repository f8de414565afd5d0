"""The public names of pointloom.reconstruction: the one list of them, for type checkers and for `public_names`."""

from .slac import ControlGrid as ControlGrid
from .slac import FragmentOverlap as FragmentOverlap
from .slac import RefinementReport as RefinementReport
from .slac import SLACOptimizerParams as SLACOptimizerParams
from .slac import integrate_deformed as integrate_deformed
from .slac import run_rigid_optimizer_for_fragments as run_rigid_optimizer_for_fragments
from .slac import run_slac_optimizer_for_fragments as run_slac_optimizer_for_fragments
