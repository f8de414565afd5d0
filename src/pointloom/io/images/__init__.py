"""PNG and JPEG images, depth maps, textures."""
