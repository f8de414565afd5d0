"""The names of `open3d.core`."""

from .device import Device as Device
from .dtype import Dtype as Dtype
from .dtype import bool8 as bool8
from .dtype import float32 as float32
from .dtype import float64 as float64
from .dtype import int8 as int8
from .dtype import int16 as int16
from .dtype import int32 as int32
from .dtype import int64 as int64
from .dtype import uint8 as uint8
from .dtype import uint16 as uint16
from .dtype import uint32 as uint32
from .dtype import uint64 as uint64
from .dtype import undefined as undefined
from .tensor import Tensor as Tensor
