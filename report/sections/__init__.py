"""Derive the values, tables, figures and claims of each section, in one module for each."""
