"""Defaults of functions that take depth images: the unit of stored depth and the largest depth that is used.

One default for each meaning: images of depth cameras, operations that Open3D has, and depth without sensor noise.
"""

import math

DEPTH_SCALE = 1000.0  # stored depth of one meter, for integers whose scale is not given: millimeters
DEPTH_MAX = 4.0  # [m] beyond it the noise of depth cameras exceeds 2 cm
OPEN3D_DEPTH_MAX = 3.0  # [m] of operations that Open3D has with this default
UNLIMITED_DEPTH = math.inf  # [m] of depth that is rendered, or triangulated from photographs or by a scanner
