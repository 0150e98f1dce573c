"""What the lint says of a Newton model: parameters that `SolverMuJoCo` does not use as they were authored."""
