"""Define the commands that only this report has, in one module for each command."""
