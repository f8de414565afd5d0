"""The public names of pointloom.tiling."""

from .finish import finish_tiles as finish_tiles
from .jobs.fused_mesh import finish_fusion as finish_fusion
from .jobs.fusion import plan_fusion as plan_fusion
from .jobs.placed_scans import finish_registration as finish_registration
from .jobs.run_jobs import job_status as job_status
from .jobs.run_jobs import retry_job as retry_job
from .jobs.run_jobs import run_job as run_job
from .jobs.scans import plan_registration as plan_registration
from .plan import plan_tiles as plan_tiles
from .runners import retry_tiles as retry_tiles
from .runners import run_tiles as run_tiles

# Results of functions, for annotations.
# isort: split
from .jobs.job import JobStatus as JobStatus
from .jobs.placed_scans import PlacedScans as PlacedScans
from .status import TileStatus as TileStatus
