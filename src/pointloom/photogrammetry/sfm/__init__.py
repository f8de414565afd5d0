"""Structure from motion: posed images and sparse points from a video or photographs.

COLMAP (pycolmap, `pip install "pointloom[sfm]"`) runs in a separate process with time and memory limits.
"""
