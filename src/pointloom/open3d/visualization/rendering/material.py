"""MaterialRecord: a holder of the fields of Open3D's materials, of which pages use three."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ....core.attribute_hints import KnownNames
from ....core.checks import check_color, check_positive
from ....pcd.cloud import PointCloud


@dataclass(eq=False)
class MaterialRecord(KnownNames):
    """Fields of a material. Pages use `base_color`, `point_size` and `line_width`; the others have no effect."""

    shader: str = "defaultUnlit"
    base_color: Any = field(default_factory=lambda: np.ones(4, np.float32))
    point_size: float = 3.0
    line_width: float = 1.0
    has_alpha: bool = False
    sRGB_color: bool = False  # noqa: N815  Open3D's name
    base_metallic: float = 0.0
    base_roughness: float = 1.0
    base_reflectance: float = 0.5
    base_clearcoat: float = 0.0
    base_clearcoat_roughness: float = 0.0
    base_anisotropy: float = 0.0
    emissive_color: Any = field(default_factory=lambda: np.array([0, 0, 0, 1], np.float32))
    absorption_color: Any = field(default_factory=lambda: np.ones(3, np.float32))
    absorption_distance: float = 1.0
    thickness: float = 1.0
    transmission: float = 1.0
    scalar_min: float = 0.0
    scalar_max: float = 1.0
    aspect_ratio: float = 0.0
    ground_plane_axis: float = 0.0
    gradient: Any = None
    albedo_img: Any = None
    normal_img: Any = None
    ao_img: Any = None
    metallic_img: Any = None
    roughness_img: Any = None
    reflectance_img: Any = None
    clearcoat_img: Any = None
    clearcoat_roughness_img: Any = None
    anisotropy_img: Any = None
    ao_rough_metal_img: Any = None
    generic_imgs: dict[str, Any] = field(default_factory=dict)
    generic_params: dict[str, Any] = field(default_factory=dict)
    gaussian_splat_antialias: bool = False
    gaussian_splat_avg_tiles_per_splat: int = 32
    gaussian_splat_max_tile_entries_total: int = 1 << 25
    gaussian_splat_max_tiles_per_splat: int = 256
    gaussian_splat_min_alpha: float = 1 / 255
    gaussian_splat_sh_degree: int = 2

    def __repr__(self) -> str:
        return f"MaterialRecord({self.shader!r})"


def style_of(material: object, shape: object) -> dict[str, Any]:
    """Style keys of a geometry for a material or None. `base_color` applies to geometries without colors.

    Raises TypeError if it is not a MaterialRecord.
    """
    if material is None:
        return {}
    if not isinstance(material, MaterialRecord):
        given = type(material).__name__
        raise TypeError(f"material: expected a rendering.MaterialRecord or None, got {given}")
    style: dict[str, Any] = {
        "point_size": check_positive("material.point_size", material.point_size),
        "line_width": check_positive("material.line_width", material.line_width),
    }
    color = np.asarray(material.base_color, np.float64)[:3]
    if not (color == 1).all() and not _has_colors(shape):
        style["color"] = tuple(check_color("material.base_color", color).tolist())
    return style


def _has_colors(shape: object) -> bool:
    if isinstance(shape, PointCloud):
        return bool(shape.has_colors)
    colors = (getattr(shape, name, None) for name in ("colors", "vertex_colors", "textures"))
    return any(values is not None and len(values) for values in colors)
