"""Images, recordings and the live viewer."""

from ..public_names import private

__getattr__ = private(__name__)
