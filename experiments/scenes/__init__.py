"""Scenes that others have published, written anew in MJCF: a module each, and ``engines`` to run any of them."""
