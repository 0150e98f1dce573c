"""What several sections share when they derive values, tables and figures from their results."""
