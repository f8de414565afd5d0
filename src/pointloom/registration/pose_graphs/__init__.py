"""Many clouds at once: pose graphs and their optimization."""
