"""Material of a mesh of tensors."""

from __future__ import annotations

from typing import Any

from ....core.attribute_hints import KnownNames
from ....core.escaped_text import escaped

SCALAR_DEFAULTS = {
    "line_width": 1.0,
    "point_size": 3.0,
    "metallic": 0.0,
    "roughness": 1.0,
    "reflectance": 0.5,
    "clear_coat": 0.0,
    "clear_coat_roughness": 0.0,
    "anisotropy": 0.0,
    "thickness": 1.0,
    "transmission": 1.0,
    "absorption_distance": 1.0,
}
VECTOR_DEFAULTS = {
    "base_color": (1.0, 1.0, 1.0, 1.0),
    "emissive_color": (0.0, 0.0, 0.0, 1.0),
    "absorption_color": (1.0, 1.0, 1.0, 1.0),
}


class Material(KnownNames):
    """Name, properties and texture maps of a surface. Pointloom uses the texture map "albedo", an Image."""

    material_name: str
    scalar_properties: dict[str, float]
    vector_properties: dict[str, Any]
    texture_maps: dict[str, Any]

    def __init__(self, material_name: object = ""):
        other = material_name if isinstance(material_name, Material) else None
        self.material_name = str(material_name) if other is None else other.material_name
        self.scalar_properties = {} if other is None else dict(other.scalar_properties)
        self.vector_properties = {} if other is None else dict(other.vector_properties)
        self.texture_maps = {} if other is None else dict(other.texture_maps)

    def is_valid(self) -> bool:
        """True if the material has a name."""
        return bool(self.material_name)

    def set_default_properties(self) -> None:
        self.material_name = "defaultUnlit"
        self.scalar_properties, self.vector_properties, self.texture_maps = (
            dict(SCALAR_DEFAULTS),
            dict(VECTOR_DEFAULTS),
            {},
        )

    def __copy__(self) -> Material:
        return Material(self)

    def __deepcopy__(self, memo: dict[int, Any]) -> Material:
        return Material(self)

    def __repr__(self) -> str:
        return f"Material {escaped(self.material_name)}" if self.is_valid() else "Invalid Material"
