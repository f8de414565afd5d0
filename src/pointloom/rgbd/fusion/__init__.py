"""RGB-D frames whose poses are known, to one surface."""
