"""Cameras and points of COLMAP and Metashape."""
