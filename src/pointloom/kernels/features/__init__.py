"""Point descriptors and their matching."""
