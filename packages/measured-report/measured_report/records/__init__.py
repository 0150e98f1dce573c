"""Records: what was measured, by which code, and how it is read."""
