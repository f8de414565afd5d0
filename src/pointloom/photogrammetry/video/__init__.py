"""Reconstruction of a mesh from a video or a folder of images.

`reconstruct_video` runs all stages.
"""
