"""The tree of boxes over points, and every search in it."""
