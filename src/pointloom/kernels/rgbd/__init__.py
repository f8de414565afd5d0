"""RGB-D frames: pyramids and alignment."""
