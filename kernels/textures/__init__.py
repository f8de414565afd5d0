"""Surface colors from images."""
