"""RGB-D frames: the motion between them, tracking, and the reconstruction of scenes."""
