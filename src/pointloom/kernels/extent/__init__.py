"""Extent of points: boxes, hulls, polygons, masks, visibility."""
