"""PNG and JPEG pictures, depth images, textures."""
