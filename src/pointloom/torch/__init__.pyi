"""The public names of pointloom.torch: the one list of them, for type checkers and for `public_names`."""

from .geometry import normals as normals
from .geometry import point_to_mesh_distance as point_to_mesh_distance
from .geometry import signed_distance as signed_distance
from .geometry import transform as transform
from .losses import chamfer_distance as chamfer_distance
from .losses import f_score as f_score
from .losses import hausdorff_distance as hausdorff_distance
from .neighbors import ball_query as ball_query
from .neighbors import knn as knn
from .neighbors import nearest as nearest
from .poses import icp as icp
from .sampling import farthest_points as farthest_points
from .sampling import interpolate as interpolate
from .sampling import voxel_indices as voxel_indices
from .sampling import voxel_pool as voxel_pool

# Results of functions, for annotations.
# isort: split
from .losses import FScore as FScore
from .neighbors import Neighbors as Neighbors
from .sampling import VoxelPool as VoxelPool
