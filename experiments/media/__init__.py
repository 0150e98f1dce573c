"""Render kept runs: clips, posters and the replay in the viewer."""
