"""Finds contact parameters that MuJoCo ignores, and predicts how contacts creep."""
