"""From pictures alone: motion, depth, and videos to meshes."""
