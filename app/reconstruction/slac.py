"""SLAC: fragments aligned together with the distortion of their camera. The optimiser is registration/slac.py."""

from __future__ import annotations

from ...registration.control_grid import ControlGrid
from ...registration.slac import (
    FragmentOverlap,
    RefinementReport,
    SLACOptimizerParams,
    run_rigid_optimizer_for_fragments,
    run_slac_optimizer_for_fragments,
)

__all__ = [
    "ControlGrid",
    "FragmentOverlap",
    "RefinementReport",
    "SLACOptimizerParams",
    "run_rigid_optimizer_for_fragments",
    "run_slac_optimizer_for_fragments",
]
