"""Simulate the shake test: the scene, its batched runs and their recording."""
