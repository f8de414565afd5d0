"""Multi-view stereo: depth maps of posed photographs, and clouds and meshes of these."""
