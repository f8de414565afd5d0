"""Change detection between two epochs of a surface, and its images.

`m3c2` compares two clouds along the surface normal, `compare_cloud_to_mesh` a cloud with a mesh; `paint` and `draw`
show significant changes and draw noise in gray. Names are loaded on first use.
"""
