"""Collect glTF content that a mesh cannot store, for one warning."""

from __future__ import annotations

import warnings
from collections.abc import Hashable

from ...core.escaped_text import escaped
from .gltf_compression import DRACO, MESHOPT
from .gltf_file import GltfFile

SPECULAR = "KHR_materials_pbrSpecularGlossiness"

# Supported extensions, and those without effect on geometry, which a file may require.
READ = (DRACO, *MESHOPT, "KHR_texture_transform", "KHR_mesh_quantization", SPECULAR)
_LOOKS = ("KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_lights_", "EXT_lights_", "KHR_xmp")

# Unsupported material properties, and their descriptions.
_MAPS = {
    "normalTexture": "normal maps",
    "occlusionTexture": "occlusion maps",
    "emissiveTexture": "emissive maps",
    "emissiveFactor": "emissive colors",
}


class LeftBehind:
    """Dropped content: descriptions, or items to count."""

    def __init__(self, file: GltfFile):
        self._file = file
        self._words: dict[str, set[Hashable]] = {}

    def add(self, words: str, thing: Hashable = None) -> None:
        """Note dropped content. Items of the same description are counted."""
        self._words.setdefault(words, set()).update(() if thing is None else (thing,))

    def add_material(self, number: int) -> None:
        file = self._file
        material, what = file.take("materials", number, "a primitive"), f"materials {number}"
        for name, words in _MAPS.items():
            if material.get(name) not in (None, [0, 0, 0]):
                self.add(words, number)
        look = file.part(material, "pbrMetallicRoughness", what)
        if "metallicRoughnessTexture" in look:
            self.add("metallic-roughness maps", number)
        if (look.get("metallicFactor", 1.0), look.get("roughnessFactor", 1.0)) not in ((1, 1), (0, 1)):
            self.add("metallic and roughness factors", number)

    def add_scene(self, nodes: list[int], materials: list[int]) -> None:
        file, content = self._file, self._file.content
        for kind, numbers in (("nodes", nodes), ("materials", materials)):
            named = [number for number in numbers if file.take(kind, number, kind).get("name")]
            if len(numbers) > 1:  # a mesh of one part needs no names of parts
                for number in named:
                    self.add(f"names of {kind}", number)
        for kind in ("animations", "cameras"):
            if isinstance(content.get(kind), list):
                for number in range(len(content[kind])):
                    self.add(kind, number)
        used = content.get("extensionsUsed")
        for name in used if isinstance(used, list) else ():
            if name not in READ:
                self.add(f"the extension {str(name)[:60]}")

    def warn(self, stacklevel: int) -> None:
        if not self._words:
            return
        ignored = [f"{words} ({len(things)})" if things else words for words, things in self._words.items()]
        message = f"{self._file.path}: parts that a mesh cannot store are dropped: {', '.join(ignored)}"
        warnings.warn(escaped(message), UserWarning, stacklevel=stacklevel + 1)


def check_required(file: GltfFile) -> None:
    """Raise `FileError` if a required extension is not supported and may affect geometry."""
    required = file.content.get("extensionsRequired", [])
    for name in required if isinstance(required, list) else [required]:
        if not isinstance(name, str) or not (name in READ or name.startswith(_LOOKS)):
            raise file.error(
                f"needs the extension {str(name)[:60]}, which is not supported", remedy="Export without it"
            )
