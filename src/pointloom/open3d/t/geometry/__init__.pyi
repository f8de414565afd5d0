"""The names of `open3d.t.geometry`."""

from .boxes import AxisAlignedBoundingBox as AxisAlignedBoundingBox
from .boxes import MethodOBBCreate as MethodOBBCreate
from .boxes import OrientedBoundingBox as OrientedBoundingBox
from .geometry import Geometry as Geometry
from .image import Image as Image
from .image import InterpType as InterpType
from .line_set import LineSet as LineSet
from .point_cloud import PointCloud as PointCloud
from .rgbd_image import RGBDImage as RGBDImage
from .tensor_map import TensorMap as TensorMap
