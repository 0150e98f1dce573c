"""Editions: what is installed, which records belong to it, and whether they are fresh."""
