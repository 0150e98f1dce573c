"""Facts of the scene and of how a run ends: plain Python and NumPy, which both sides read."""
