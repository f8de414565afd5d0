"""Point clouds: the container and the operations on it."""
