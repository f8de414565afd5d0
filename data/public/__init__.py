"""Public sets by name: where they lie, what they are, and how they come here whole."""
