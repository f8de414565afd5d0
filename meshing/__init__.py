"""Triangle meshes, the volumes and scenes that they come from and go into, and their colours."""
