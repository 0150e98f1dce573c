"""Finds parameters of a Newton model that ``SolverMuJoCo`` does not use as written."""
