"""Steps of a job of tiles."""
