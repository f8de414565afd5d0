"""Reconstruction of a mesh from a video or a folder of images.

`reconstruct` runs all stages; `loom.photogrammetry` and `loom.photogrammetry` contain them.
"""
