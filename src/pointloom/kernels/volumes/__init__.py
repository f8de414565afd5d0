"""Volumes: TSDF blocks, integration, ray casting, marching cubes."""
