"""The public names of pointloom.datasets: the one list of them, for type checkers and for `public_names`."""

from .made.objects import object_mesh as object_mesh
from .made.objects import object_scans as object_scans
from .made.photographs import photographs as photographs
from .made.room import room_cloud as room_cloud
from .made.room import room_frames as room_frames
from .made.room import room_mesh as room_mesh
from .made.street import street_scans as street_scans
from .made.terrain import terrain as terrain
from .public.fetching import fetch as fetch

# Results of functions, for annotations.
# isort: split
from .made.results import PosedImages as PosedImages
from .made.results import PosedScans as PosedScans
from .scenes.room import RoomFrame as RoomFrame
