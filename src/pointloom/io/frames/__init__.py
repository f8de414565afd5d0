"""RGB-D frames from folders, streams and cameras."""
