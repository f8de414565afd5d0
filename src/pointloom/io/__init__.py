"""Strict readers, which never invent data, and atomic writers."""

from ..public_names import private

__getattr__ = private(__name__)
