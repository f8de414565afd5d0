"""Points of single pictures that are found again in others: the scale space, its extrema, descriptors, matches."""
