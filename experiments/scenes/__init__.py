"""Scenes that others have published, written anew in MJCF: a module each."""
