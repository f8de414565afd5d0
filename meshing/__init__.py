"""TSDF volumes, marching cubes and triangle meshes."""
