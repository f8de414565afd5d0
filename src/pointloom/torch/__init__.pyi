"""The public names of pointloom.torch: the one list of them, for type checkers and for `public_names`."""

from .neighbors import ball_query as ball_query
from .neighbors import knn as knn
from .neighbors import nearest as nearest
from .sampling import farthest_points as farthest_points
from .sampling import interpolate as interpolate
from .sampling import voxel_indices as voxel_indices
from .sampling import voxel_pool as voxel_pool

# Results of functions, for annotations.
# isort: split
from .neighbors import Neighbors as Neighbors
from .sampling import VoxelPool as VoxelPool
