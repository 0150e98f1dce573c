"""What make and build.py can be asked for, a function each."""
