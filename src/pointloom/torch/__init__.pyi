"""The public names of pointloom.torch: the one list of them, for type checkers and for `public_names`."""

from .neighbors import Neighbors as Neighbors
from .neighbors import ball_query as ball_query
from .neighbors import knn as knn
from .neighbors import nearest as nearest
from .operators import gather_rows as gather_rows
from .operators import scatter_sum as scatter_sum
