"""The names of `open3d.t.geometry`."""

from .boxes import AxisAlignedBoundingBox as AxisAlignedBoundingBox
from .boxes import MethodOBBCreate as MethodOBBCreate
from .boxes import OrientedBoundingBox as OrientedBoundingBox
from .geometry import Geometry as Geometry
from .image import Image as Image
from .image import InterpType as InterpType
from .line_set import LineSet as LineSet
from .metrics import ChamferDistance as ChamferDistance
from .metrics import FScore as FScore
from .metrics import HausdorffDistance as HausdorffDistance
from .metrics import Metric as Metric
from .metrics import MetricParameters as MetricParameters
from .metrics import VectorMetric as VectorMetric
from .point_cloud import PointCloud as PointCloud
from .raycasting import RaycastingScene as RaycastingScene
from .rgbd_image import RGBDImage as RGBDImage
from .tensor_map import TensorMap as TensorMap
from .triangle_mesh import TriangleMesh as TriangleMesh
from .voxel_block_grid import VoxelBlockGrid as VoxelBlockGrid
