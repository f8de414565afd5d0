"""The public names of pointloom.scale."""

from .estimate import Estimate as Estimate
from .estimate import TileEstimate as TileEstimate
from .estimate import estimate_tiles as estimate_tiles
from .finish import finish_tiles as finish_tiles
from .plan import plan_tiles as plan_tiles
from .runners import retry_tiles as retry_tiles
from .runners import run_tiles as run_tiles
from .status import TileStatus as TileStatus
from .status import tile_status as tile_status
