"""Point clouds: the container, its files, images and cameras, and the operations on it."""
