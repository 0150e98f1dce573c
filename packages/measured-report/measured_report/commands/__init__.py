"""Contains a module for each command of make and build.py."""
