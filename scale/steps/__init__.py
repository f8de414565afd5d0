"""The steps of a job of tiles, a file a kind."""
