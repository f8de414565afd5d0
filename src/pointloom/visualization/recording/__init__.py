"""Recordings of algorithms as a page with a player, an animation or a video."""
