"""Triangle meshes, TSDF volumes, ray casting scenes and color maps."""
