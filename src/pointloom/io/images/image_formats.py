"""Formats of images by extension. Nothing expensive is imported here, so that `--help` stays fast."""

from __future__ import annotations

#: Color images of `read_color` and of the folders of frames and photographs.
IMAGES = (".jpg", ".jpeg", ".png")

#: Depth maps of `read_depth`.
DEPTHS = (".png", ".npy")

#: Photographs that are decoded by other packages: name of the format.
PHOTOS = {".heic": "heif", ".heif": "heif", ".tif": "tiff", ".tiff": "tiff", ".webp": "webp", ".dng": "dng"}

#: Images of `write_image`, which store transparency.
PICTURES = (".png", ".webp")
