"""Define facts about the scene and the end of a run, for measuring and for the report.

This package uses only Python and NumPy.
"""
