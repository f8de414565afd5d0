"""The public names of pointloom.data: the one list of them, for type checkers and for `public_names`."""

from .made.results import PosedPictures as PosedPictures
from .made.results import PosedScans as PosedScans
from .made.room import room_cloud as room_cloud
from .made.room import room_frames as room_frames
from .made.room import room_mesh as room_mesh
from .made.street import street_scans as street_scans
from .scenes.room import RoomFrame as RoomFrame
