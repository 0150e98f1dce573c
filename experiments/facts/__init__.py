"""Define facts about the scene and the ends of runs, for measuring and reporting.

This package uses only Python and NumPy.
"""
