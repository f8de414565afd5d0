"""The public names of pointloom.scale."""

from .finish import finish_tiles as finish_tiles
from .plan import plan_tiles as plan_tiles
from .runners import retry_tiles as retry_tiles
from .runners import run_tiles as run_tiles
from .status import TileStatus as TileStatus
from .status import tile_status as tile_status
