"""RGB-D frames of folders, streams and cameras."""
