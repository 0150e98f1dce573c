"""Pictures of kept runs: clips, posters and the replay in the viewer."""
