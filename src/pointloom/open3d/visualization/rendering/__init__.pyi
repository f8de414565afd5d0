"""The names of `open3d.visualization.rendering`."""

from .material import MaterialRecord as MaterialRecord
