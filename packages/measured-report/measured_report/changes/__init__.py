"""Differences between editions, and the search for their causes."""
