"""The names of `open3d.core.cuda`."""

from .devices import device_count as device_count
from .devices import is_available as is_available
from .devices import release_cache as release_cache
from .devices import synchronize as synchronize
