"""Types of arguments, for annotations. `argument_types.pyi` has the exact ones, which need the classes."""

from __future__ import annotations

from typing import Any

BoxLike = CameraLike = CloudLike = DeviceArray = DeviceLike = FrameLike = ImageLike = Any
IndicesLike = MeshLike = ShapeLike = TensorCloud = TensorFrame = TensorImage = TensorLike = VectorLike = Any
