"""The names of `open3d.pipelines.integration`."""

from .volumes import ScalableTSDFVolume as ScalableTSDFVolume
from .volumes import TSDFVolume as TSDFVolume
from .volumes import TSDFVolumeColorType as TSDFVolumeColorType
from .volumes import UniformTSDFVolume as UniformTSDFVolume
