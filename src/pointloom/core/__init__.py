"""Foundations: checks, errors, devices, other array libraries, progress, resumable stages."""

from ..public_names import private

__getattr__ = private(__name__)
