"""What an algorithm did, as a page that plays, an animation or a video."""
