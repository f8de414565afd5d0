"""Public names of pointloom.change, for type checkers and for `public_names`."""

from ...meshing.scene.cloud_change import cloud_to_mesh as cloud_to_mesh
from ...pcd.change import m3c2 as m3c2
from .pictures import draw as draw
from .pictures import paint as paint
