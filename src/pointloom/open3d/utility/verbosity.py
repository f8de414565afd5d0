"""Verbosity levels as module constants, which scripts before Open3D 0.11 use."""

from __future__ import annotations

from ...core.verbosity import VerbosityLevel

Error, Warning, Info, Debug = VerbosityLevel.Error, VerbosityLevel.Warning, VerbosityLevel.Info, VerbosityLevel.Debug


def reset_print_function() -> None:
    """No effect: messages go to the logger "pointloom" of Python."""
