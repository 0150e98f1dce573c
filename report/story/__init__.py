"""Derive the claims, tables and figures that combine several sections, for the front page."""
