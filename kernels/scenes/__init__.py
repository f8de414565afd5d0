"""Made-up scenes and pictures, for the demo."""
