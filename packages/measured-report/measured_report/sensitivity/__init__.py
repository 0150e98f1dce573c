"""Sensitivity: what the report would say if something else had been measured."""
