"""The public names of pointloom.torch: the one list of them, for type checkers and for `public_names`."""

from .operators import gather_rows as gather_rows
from .operators import scatter_sum as scatter_sum
