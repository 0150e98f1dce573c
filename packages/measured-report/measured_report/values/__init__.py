"""Values: numbers that know their unit, their source and their noise."""
